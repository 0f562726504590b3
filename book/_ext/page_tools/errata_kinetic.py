"""What proves the errata that concern contact forces: the paper's tables with what is printed in its text."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np

from granular.fabric import AxialFabric
from granular.figures.paper_figure_7_9 import POISSON_RATIO
from granular.loading import Loading
from page_tools.averages import Array, components, gauss
from page_tools.errata import PRINTED_TENSOR
from page_tools.markup import Markup, table
from page_tools.paper import PANELS, RATIOS, by_midpoint, cases, typeset
from page_tools.paper_kinetic import TABLES, Printed, evaluated, printed_ratios

Six = tuple[float, ...]
DIRECTIONS, MEASURE = gauss(400)
"""Enough nodes for three decimals of an integrand with edges."""


def printed_tensor_table() -> Markup:
    """Evaluate Table III, case 2, with the fabric tensor as it is printed and as it must be."""
    case = cases(TABLES["III"])[1]
    rows = [["printed", *_ratios(_evaluate(case, _with_printed_tensor))],
            ["corrected", *_ratios(_evaluate(case, _as_it_must_be))],
            ["Table III, case 2", *(case[column] for _, column in RATIOS)]]
    return table(["fabric tensor", *_heads()], rows, label="tab-printed-tensor", align="lrr",
                 caption="Table III, case 2, with the fabric tensor as printed and as corrected, and as tabulated.")


def printed_slip_table() -> Markup:
    """Evaluate the cases with slip by equation (21) as it is printed and as it must be."""
    rows = []
    for name in ("III", "IV", "V"):
        for ratios in _in_pairs(name):
            case = ratios[0].case
            if "slip" not in case["effects"] or ratios[0].isotropic:
                continue
            rows += [[name, case["case"].rpartition(" = ")[2], typeset(ratio.name), wrong, f"{ratio.exact:.3f}",
                      ratio.meant]
                     for ratio, wrong in zip(ratios, _ratios(_evaluate(case, _with_printed_slip)), strict=True)]
    return table(["table", "case", "ratio", "(21) as printed", "(21) corrected", "in the table"], rows,
                 label="tab-printed-slip", align="lllrrr",
                 take_away="equation_21.csv",
                 caption="The cases with partial slip by equation (21) as printed and as corrected, beside the tables, "
                         "whose two misprints are corrected.")


def caption_table() -> Markup:
    """Evaluate Table III, case 1, with the coefficient of its caption and with that of Table II, case 3."""
    case = cases(TABLES["III"])[0]
    rows = [[f"$D_{{33}} = {value:g}$", *_ratios_of({**case, "D33": str(value)})] for value in (0.0, 0.3)]
    rows.append(["Table III, case 1", *(case[column] for _, column in RATIOS)])
    return table(["", *_heads()], rows, label="tab-caption", align="lrr",
                 caption="Table III, case 1, by the paper's quadrature, with the coefficient of the caption and with "
                         "that of Table II, case 3.")


def table_iv_misprints() -> Markup:
    """Show the two misprints of Table IV beside what must stand there."""
    rows = [[f"$D_{{33}} = {ratio.case['D33']}$", typeset(ratio.name), ratio.printed, f"{ratio.panels:.4f}",
             f"{ratio.exact:.4f}"] for ratio in printed_ratios("IV") if not ratio.isotropic]
    return table(["case", "ratio", "printed", f"{PANELS} panels", "exact"], rows, label="tab-misprints", align="llrrr",
                 caption="Table IV: what is printed, what the paper's quadrature gives, and the exact values.")


def _as_it_must_be(fabric: AxialFabric, loading: Loading) -> Six:
    """Forces and stiffnesses as derived."""
    return _averaged(fabric, *_forces(*loading.coefficients(fabric.D33)), lambda share: np.cbrt(1 - share),
                     loading.friction)


def _with_printed_tensor(fabric: AxialFabric, loading: Loading) -> Six:
    """The fabric tensor with its two factors exchanged."""
    of_delta, of_fabric = (float(factor) for factor in PRINTED_TENSOR)
    mean = float(loading.mean)
    a = float(loading.sigma11) / (3 * mean * (of_delta - of_fabric * fabric.D33 / 2))
    c = float(loading.sigma33) / (3 * mean * (of_delta + of_fabric * fabric.D33))
    return _averaged(fabric, *_forces(a, c), lambda share: np.cbrt(1 - share), loading.friction)


def _with_printed_slip(fabric: AxialFabric, loading: Loading) -> Six:
    """The square root of the share of friction that is used up, in place of the cube root of what is left."""
    return _averaged(fabric, *_forces(*loading.coefficients(fabric.D33)), np.sqrt, loading.friction)


def _forces(a: float | Fraction, c: float | Fraction) -> tuple[Array, Array]:
    """Normal and shear force at the nodes."""
    s, y = DIRECTIONS.T
    return float(a) * s + float(c) * y, abs(float(c - a)) * np.sqrt(s * y)


def _averaged(fabric: AxialFabric, normal: Array, shear: Array, law: Callable[[Array], Array],
              friction: float | None) -> Six:
    share = np.minimum(shear / (friction * normal), 1.0) if friction else np.zeros_like(normal)
    chi = law(share) if friction else np.ones_like(normal)
    return components(fabric, POISSON_RATIO, directions=DIRECTIONS, measure=MEASURE, normal=np.cbrt(normal),
                      chi=chi, gamma=1 - chi)


def _evaluate(case: dict[str, str], law: Callable[[AxialFabric, Loading], Six]) -> Six:
    plan = evaluated(case).plan
    assert plan.loading is not None, "the case has contact forces"
    return law(plan.fabric, plan.loading)


def _ratios(six: Six) -> list[str]:
    c1111, c3333, _, _, c2323, c1212 = six
    return [f"{c1111 / c3333:.3f}", f"{c2323 / c1212:.3f}"]


def _ratios_of(case: dict[str, str]) -> list[str]:
    found = by_midpoint(evaluated(case), PANELS)
    return [f"{found[name]:.3f}" for name, _ in RATIOS]


def _heads() -> list[str]:
    return [typeset(name) for name, _ in RATIOS]


def _in_pairs(name: str) -> list[tuple[Printed, Printed]]:
    found = printed_ratios(name)
    return list(zip(found[::2], found[1::2], strict=True))
