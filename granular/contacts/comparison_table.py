"""The comparison of packings as text: one block a packing, one row a way of getting the stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.contacts.comparison import AGREEMENT
from granular.contacts.layout import columns, facts, title
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import RenderableType

    from granular.contacts.comparison import ComparedPacking, Components

SHORT = {"model, mean kn, ": "mean kn, ", "fabric of ": ""}
"""What is said shorter in a table."""


def comparison_as_text(packings: Sequence[ComparedPacking]) -> list[RenderableType]:
    """Blocks for a console of any width.

    Parameters
    ----------
    packings : sequence of ComparedPacking
        Compared packings.

    Returns
    -------
    list of renderable
        For ``rich.console.Console.print``, in order; stiffness in MPa.

    Notes
    -----
    Source: the records.
    """
    return [block for packing in packings for block in _blocks(packing)]


def _blocks(packing: ComparedPacking) -> Iterator[RenderableType]:
    yield title(packing.name)
    yield facts({
        "packing": [f"M {packing.contacts}", f"Z {packing.coordination_number:.3f}", f"e {packing.void_ratio:.4f}",
                    f"p {packing.mean_stress / 1e3:.5g} kPa", f"s33/s11 {packing.stress_ratio:.4f}"],
        "fabric": [f"D33 {packing.D33:+.4f} +/- {packing.D33_error:.4f}", f"Dr33 {packing.Dr33:+.4f}",
                   *([] if packing.collinear else [f"D33 of branches {packing.D33_of_branches:+.4f}"])],
        "sizes": [f"l_e/2r {packing.length_ratio:.4f}", f"<l^2 kn>/<l^2><kn> {packing.stiffer_where_longer:.4f}"],
        "eq. (1)": f"within {100 * packing.affine_miss:.2g} % of C3333 of the affine probe in all 36 components "
                   f"({'' if packing.agrees else 'MISSED, '}{100 * AGREEMENT:g} % allowed)"})
    yield columns([["MPa", *COMPONENTS],
                   *([_short(name), *_row(six)] for name, six in packing.stiffness.items()),
                   ["(1) over relaxed", *_row(packing.bound, 1.0, ".3f")],
                   ["of that, (5) recovers", *_row(packing.recovered, 0.01, ".0f", " %")]])
    yield ""


def _short(name: str) -> str:
    for long, short in SHORT.items():
        name = name.replace(long, short)
    return name


def _row(six: Components, unit: float = 1e6, form: str = ".1f", after: str = "") -> list[str]:
    return ["-" if value is None else format(value / unit, form) + after for value in six.values()]
