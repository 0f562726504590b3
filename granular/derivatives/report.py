"""Sensitivities as text for people and as JSON for programs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.derivatives.sensitivity import Sensitivity, Slope

STEP = 0.01
"""Step of the table: so much for a coefficient of the fabric, and so much of itself for everything else [-]."""

FABRIC = ("D33", "Dr33")
"""Numbers that may be zero, so that one per cent of them says nothing."""


def sensitivity_as_json(result: Sensitivity) -> dict[str, Any]:
    """The object that ``granular sensitivity --json`` prints.

    Parameters
    ----------
    result : Sensitivity
        Stiffness of a scene and its slopes.

    Returns
    -------
    dict
        ``stiffness`` [Pa] and, for each number of the scene, its value, its unit, the slopes [Pa per unit], the same
        over each component [per unit], and the logarithmic slopes [-].

    Notes
    -----
    Source: the command line's interface.
    """
    def named(values: tuple[float | None, ...]) -> dict[str, float | None]:
        return dict(zip(COMPONENTS, values, strict=True))

    return {"stiffness": dict(result.stiffness.components),
            "by": {slope.name: {"value": slope.value, "unit": slope.unit, "note": slope.note,
                                "slope": named(slope.slopes), "relative": named(result.relative(slope.name)),
                                "logarithmic": named(result.logarithmic(slope.name))} for slope in result.by}}


def sensitivity_as_text(result: Sensitivity) -> list[RenderableType]:
    """What ``granular sensitivity`` shows, for a console of any width.

    Parameters
    ----------
    result : Sensitivity
        Stiffness of a scene and its slopes.

    Returns
    -------
    list of renderable
        Blocks for ``rich.console.Console.print``, in order.

    Notes
    -----
    Source: the command line's interface.
    """
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("number", overflow="fold")
    table.add_column("step", justify="right")
    for name in COMPONENTS:
        table.add_column(name, justify="right")
    for slope in result.by:
        table.add_row(slope.name, _step(slope), *(_percent(share) for share in _shares(result, slope)))
    notes = [f"{slope.name}: {slope.note}." for slope in result.by if slope.note]
    return [Text("Change of each component in per cent, to first order", style="bold"), table, "",
            *(Text(f"  {note}") for note in notes)]


def _step(slope: Slope) -> str:
    return f"+{STEP:g}" if slope.name in FABRIC else f"+{100 * STEP:g} %"


def _shares(result: Sensitivity, slope: Slope) -> tuple[float | None, ...]:
    return result.relative(slope.name) if slope.name in FABRIC else result.logarithmic(slope.name)


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100 * STEP * share:+.3f}"
