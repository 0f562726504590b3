"""``granular contacts``: what the options mean, progress on standard error, and who does the work."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.columns import NATIVE
from granular.contacts.material import Material
from granular.errors import BadOption, GranularError
from granular.units import PRESSURE, in_si, shown

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.contacts.summary import ContactSummary

PATIENCE = 2.0
"""Seconds before anything is said about progress, and between two lines."""


def summary_of(file: str | None, *, volume: float | None, grains: int | None, columns: Sequence[str],
               step: int | None, spheres_only: bool, drop_bad: bool, cell: Sequence[float] | None,
               shear_modulus: str | None, poisson_ratio: float | None, friction: float | None) -> ContactSummary:
    """Read a list as the command line asks for it.

    Parameters
    ----------
    file : str or None
        The contact list.
    volume : float or None
        Of the sample [m^3].
    grains : int or None
        All grains in it [-].
    columns : sequence of str
        ``NAME=COLUMN`` each.
    step : int or None
        Time step of a dump [-].
    spheres_only, drop_bad : bool
        As for ``granular.contacts.summary.summarise``.
    cell : sequence of 3 float, optional
        Edges of a periodic cell [m].
    shear_modulus : str or None
        Number in Pa, or text with a unit.
    poisson_ratio, friction : float or None
        Of the grains [-].

    Returns
    -------
    ContactSummary
        What the list tells.

    Raises
    ------
    BadOption
        The file, the volume or a part of an option is missing.
    GranularError
        As ``granular.contacts.summary.summarise``.

    Notes
    -----
    Source: the command line's interface.
    """
    from granular.contacts.summary import summarise

    if file is None:
        raise BadOption("no contact list is named", allowed="needed: a file, or --compare with a folder of packings",
                        remedy="Write it like granular contacts contacts.csv.gz --volume 1.3e-5.")
    if volume is None:
        raise BadOption("--volume is not given", allowed="needed: the volume of the sample in m^3, for every sum is "
                        "divided by it", remedy="Write it like --volume 1.3e-5, grains and voids together.")
    material = Material(shear_modulus=_modulus(shear_modulus), poisson_ratio=poisson_ratio, friction=friction)
    progress = _Progress()
    try:
        return summarise(file, volume=volume, grains=grains, columns=_mapping(columns), step=step,
                         spheres_only=spheres_only, drop_bad=drop_bad, cell=cell, material=material,
                         progress=progress)
    finally:
        progress.end()


def compare_to(folder: Path, out: Path | None, *, as_json: bool = False) -> tuple[str | list[RenderableType], bool]:
    """Compare every packing of a folder, and write the table as data where that is asked for.

    Parameters
    ----------
    folder : Path
        With NAME_contacts.csv.gz and NAME_meta.json for every packing.
    out : Path or None
        JSON file to write.
    as_json : bool
        Whether the object is wanted in place of the table.

    Returns
    -------
    str or list of renderable
        The object as text, or blocks for a console.
    bool
        Whether every sum agrees with the affine probe.

    Raises
    ------
    GranularError
        As ``granular.contacts.comparison.compare_folder``.

    Notes
    -----
    Source: the command line's interface.
    """
    from granular.contacts.comparison import as_data, compare_folder, write_comparison
    from granular.contacts.comparison_table import comparison_as_text

    packings = compare_folder(folder)
    if out is not None:
        write_comparison(packings, out)
    return as_data(packings) if as_json else comparison_as_text(packings), all(packing.agrees for packing in packings)


def _mapping(columns: Sequence[str]) -> dict[str, str]:
    mapping: dict[str, str] = {}
    for text in columns:
        native, equals, column = text.partition("=")
        if not (equals and native and column):
            raise BadOption(f"--column {shown(text)}", allowed="allowed NAME=COLUMN with NAME out of "
                            f"{' '.join(NATIVE)}", remedy="Write it like --column n1=nx.")
        if native in mapping:
            raise BadOption(f"--column {native} is given twice", allowed="allowed once for each name",
                            remedy="Leave one of them out.")
        mapping[native] = column
    return mapping


def _modulus(text: str | None) -> float | None:
    if text is None:
        return None
    try:
        return float(text)
    except ValueError:
        pass
    try:
        return in_si(text, PRESSURE, name="--shear-modulus")
    except GranularError as refusal:
        raise BadOption(refusal.found, allowed=refusal.allowed, remedy=refusal.remedy) from None


class _Progress:
    """Say now and then how far the reading is, where it takes long."""

    def __init__(self) -> None:
        self._next, self._said = time.monotonic() + PATIENCE, False

    def __call__(self, contacts: int) -> None:
        if time.monotonic() < self._next or sys.stderr is None:
            return
        self._next, self._said = time.monotonic() + PATIENCE, True
        before, after = ("\r", "") if sys.stderr.isatty() else ("", "\n")
        print(f"{before}Read {contacts:,} contacts", end=after, file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._said and sys.stderr is not None and sys.stderr.isatty():
            print(file=sys.stderr)
