"""Arguments and options that several commands have, and how they are read."""

from __future__ import annotations

from typing import Annotated

import typer

from granular.errors import BadOption
from granular.routes.catalogue import ROUTES, WITHOUT_AXIS
from granular.units import shown

DONE = 0
"""Exit code of a command that did what it was asked."""

MISSED = 1
"""Exit code of a check that failed."""

SceneFile = Annotated[str, typer.Argument(metavar="SCENE", help="A scene file (TOML).")]
Accuracy = Annotated[str | None, typer.Option(
    "--rtol", metavar="R", help="Wanted relative accuracy of every component, such as 1e-12.")]
RouteName = Annotated[str, typer.Option(
    "--route", metavar="NAME", help=f"auto, {', '.join(ROUTES)}; {', '.join(WITHOUT_AXIS)} without an axis.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


def accuracy_of(text: str | None) -> float | None:
    """The number behind --rtol; whether it can be promised is for the plan to say.

    Parameters
    ----------
    text : str or None
        What was typed.

    Returns
    -------
    float or None
        Wanted relative accuracy [-].

    Raises
    ------
    BadOption
        It is no number.

    Notes
    -----
    Source: the command line's interface.
    """
    if text is None:
        return None
    try:
        return float(text)
    except ValueError:
        raise BadOption(f"--rtol = {shown(text)}", allowed="allowed a number inside (0, 1)",
                        remedy="Write it like --rtol 1e-12.") from None


def require_one(options: dict[str, int | None]) -> None:
    """Refuse two checks at once.

    Parameters
    ----------
    options : dict
        Name of an option -> its value, None where it was not given.

    Raises
    ------
    BadOption
        Two were given.

    Notes
    -----
    Source: the command line's interface.
    """
    given = [name for name, value in options.items() if value is not None]
    if len(given) > 1:
        raise BadOption(f"{given[0]} and {given[1]} are both given", allowed="allowed one of the two",
                        remedy="Run one after the other.")


def rounds_of(text: str) -> int:
    """The number behind --rounds; one round has no spread.

    Parameters
    ----------
    text : str
        What was typed.

    Returns
    -------
    int
        From 2 to 999999 [-].

    Raises
    ------
    BadOption
        It is something else.

    Notes
    -----
    Source: the command line's interface.
    """
    if not (text.isascii() and text.isdigit() and 2 <= int(text[:6]) and len(text) <= 6):
        raise BadOption(f"--rounds = {shown(text)}", allowed="allowed whole numbers from 2 to 999999",
                        remedy="Write it like --rounds 15.")
    return int(text)
