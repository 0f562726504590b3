"""The comparison of packings as text: one block a packing, one row a way of getting the stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from granular.contacts.comparison import ComparedPacking, Components


def comparison_as_text(packings: Sequence[ComparedPacking]) -> str:
    """Write the tables.

    Parameters
    ----------
    packings : sequence of ComparedPacking
        Compared packings.

    Returns
    -------
    str
        Lines with their ends; stiffness in MPa.

    Notes
    -----
    Source: the records.

    Examples
    --------
    >>> from granular.contacts.comparison import compare_folder
    >>> from granular.contacts.example import example_folder
    >>> print(comparison_as_text(compare_folder(example_folder())).splitlines()[2])
      eq. (1) within 0.019 % of C3333 of the affine probe in all 36 components (0.5 % allowed)
    """
    return "\n".join(line for packing in packings for line in _lines(packing)) + "\n"


def _lines(packing: ComparedPacking) -> list[str]:
    width = max(len(name) for name in packing.stiffness)
    allowed = "0.5 % allowed" if packing.agrees else "MISSED, 0.5 % allowed"
    return [
        f"{packing.name}: M = {packing.contacts}, Z = {packing.coordination_number:.3f}, e = {packing.void_ratio:.4f}, "
        f"p = {packing.mean_stress / 1e3:.5g} kPa",
        f"  s33/s11 = {packing.stress_ratio:.4f}, D33 = {packing.D33:+.4f} +/- {packing.D33_error:.4f}, "
        f"Dr33 = {packing.Dr33:+.4f}"
        + ("" if packing.collinear else f", D33 of branches {packing.D33_of_branches:+.4f}"),
        f"  eq. (1) within {100 * packing.affine_miss:.2g} % of C3333 of the affine probe in all 36 components "
        f"({allowed})",
        f"  {'MPa':<{width}}  " + "  ".join(f"{name:>7}" for name in COMPONENTS),
        *(f"  {name:<{width}}  {_row(six)}" for name, six in packing.stiffness.items()),
        f"  {'eq. (1) over relaxed':<{width}}  {_row(packing.bound, 1.0, '.3f')}",
        f"  {'of that, eq. (5) recovers':<{width}}  {_row(packing.recovered, 0.01, '.0f', ' %')}", ""]


def _row(six: Components, unit: float = 1e6, form: str = ".1f", after: str = "") -> str:
    return "  ".join("      -" if value is None else f"{format(value / unit, form) + after:>7}"
                     for value in six.values())
