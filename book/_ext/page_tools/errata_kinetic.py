"""What proves the errata that concern contact forces: the paper's tables with what is printed in its text."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from granular.fabric import AxialFabric
from granular.figures.paper_figure_7_9 import data
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.axial_kinetic import components_by_contacts
from granular.routes.contact_rule import ContactRule, suitable_contacts
from granular.routes.result import Six
from page_tools.errata import PRINTED_TENSOR
from page_tools.errata_record import proved
from page_tools.markup import Markup, table
from page_tools.paper import PANELS, RATIOS, ROUNDING, by_midpoint, cases, typeset
from page_tools.paper_panels import independent
from page_tools.paper_tables import TABLES, Printed, evaluated, printed_ratios

NEAR = 0.1
"""A corrected formula misses the tables by less than this share of what the printed one does; the rest is their
quadrature."""

Contacts = Callable[[AxialFabric, Loading], ContactRule]


def printed_tensor_table() -> Markup:
    """Evaluate Table III, case 2, with the fabric tensor as it is printed and as it must be."""
    case = cases(TABLES["III"])[1]
    printed, corrected = (_ratios(_evaluate(case, contacts)) for contacts in (_with_printed_tensor, _as_it_must_be))
    tabled = [case[column] for _, column in RATIOS]
    rows = [["printed", *printed], ["corrected", *corrected], ["Table III, case 2", *tabled]]
    return proved(all(_distance(right, value) < NEAR * _distance(wrong, value)
                      for wrong, right, value in zip(printed, corrected, tabled, strict=True)),
                  f"the corrected tensor is nearer to the table by more than {1 / NEAR:.0f} times", table(
                      ["fabric tensor", *_heads()], rows, label="tab-printed-tensor", align="lrr",
                      caption="Table III, case 2, with the fabric tensor as printed and as corrected, and as "
                              "tabulated."))


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
    return proved(all(_distance(row[4], row[5]) < _distance(row[3], row[5]) for row in rows),
                  f"in all {len(rows)} ratios the corrected form is nearer to the table", table(
                      ["table", "case", "ratio", "(21) as printed", "(21) corrected", "in the table"], rows,
                      label="tab-printed-slip", align="lllrrr", take_away="equation_21.csv",
                      caption="The cases with partial slip by equation (21) as printed and as corrected, beside the "
                              "tables, whose two misprints are corrected."))


def caption_table() -> Markup:
    """Evaluate Table III, case 1, with the coefficient of its caption and with that of Table II, case 3."""
    case = cases(TABLES["III"])[0]
    rows = [[f"$D_{{33}} = {value:g}$", *_ratios_of({**case, "D33": str(value)})] for value in (0.0, 0.3)]
    rows.append(["Table III, case 1", *(case[column] for _, column in RATIOS)])
    return proved(rows[1][1:] == rows[2][1:] != rows[0][1:], "with $D_{33} = 0.3$ the paper's quadrature gives the "
                  "printed ratios to the last digit, with the caption's value it does not", table(
                      ["", *_heads()], rows, label="tab-caption", align="lrr",
                      caption="Table III, case 1, by the paper's quadrature, with the coefficient of the caption and "
                              "with that of Table II, case 3."))


def table_iv_misprints() -> Markup:
    """Show the two misprints of Table IV beside what must stand there."""
    rows = [[f"$D_{{33}} = {ratio.case['D33']}$", typeset(ratio.name), ratio.printed, f"{ratio.panels:.4f}",
             f"{ratio.exact:.4f}"] for ratio in printed_ratios("IV") if not ratio.isotropic]
    found = [ratio for ratio in printed_ratios("IV") if not ratio.isotropic]
    axial = [ratio for ratio in found if ratio.name == RATIOS[0][0]]
    return proved(all(ratio.misprint and ratio.exact < 1 for ratio in axial)
                  and all(ratio.kind == "rounded" for ratio in found if ratio not in axial),
                  "the exact ratios of the first column are below 1, and the second column is what the paper's "
                  "quadrature gives", table(
                      ["case", "ratio", "printed", f"{PANELS} panels", "exact"], rows, label="tab-misprints",
                      align="llrrr",
                      caption="Table IV: what is printed, what the paper's quadrature gives, and the exact values."))


def normal_stiffness_check() -> Markup:
    """Compare the normal stiffness of contacts with and without anisotropic branches over all directions."""
    columns = data(7)
    apart = max(float(abs(columns[f"k_n D33={D33} Dr33=-0.3"] / columns[f"k_n D33={D33} Dr33=0"] - 1).max())
                for D33 in ("0", "0.3"))
    return proved(apart < ROUNDING, f"in the {len(columns['beta'])} directions of Figure 7 the normal stiffness with "
                  "and without anisotropic branches differs by nothing but rounding")


def decimals_check() -> Markup:
    """Count the printed ratios that are the exact ones rounded."""
    found = [ratio for ratio in independent() if not ratio.misprint]
    sound = sum(f"{ratio.exact:.3f}" == ratio.printed for ratio in found)
    return proved(sound < len(found) / 2 and all(ratio.kind in ("rounded", "cut") for ratio in found),
                  f"{sound} of {len(found)} printed ratios are the exact ones rounded, and all {len(found)} are those "
                  f"of {PANELS} panels")


def _distance(value: str, from_: str) -> float:
    return abs(float(value) - float(from_))


def _as_it_must_be(fabric: AxialFabric, loading: Loading) -> ContactRule:
    return suitable_contacts(fabric, loading, Hypothesis.KINEMATIC)


def _with_printed_tensor(fabric: AxialFabric, loading: Loading) -> ContactRule:
    """The fabric tensor with its two factors exchanged."""
    of_delta, of_fabric = (float(factor) for factor in PRINTED_TENSOR)
    mean = float(loading.mean)
    a = float(loading.sigma11) / (3 * mean * (of_delta - of_fabric * fabric.D33 / 2))
    c = float(loading.sigma33) / (3 * mean * (of_delta + of_fabric * fabric.D33))
    contacts = _as_it_must_be(fabric, loading)
    rule = contacts.directions
    force = [a * s + c * y for s, y in zip(rule.sine_squared, rule.cosine_squared, strict=True)]
    return replace(contacts, normal=tuple(map(math.cbrt, force)))


def _with_printed_slip(fabric: AxialFabric, loading: Loading) -> ContactRule:
    """The square root of the share of friction that is used up, in place of the cube root of what is left."""
    contacts = _as_it_must_be(fabric, loading)
    assert contacts.chi is not None, "the case has slip"
    shares = tuple(math.sqrt(max(1 - chi**3, 0.0)) for chi in contacts.chi)
    return replace(contacts, chi=shares, gamma=tuple(1 - share for share in shares))


def _evaluate(case: dict[str, str], contacts: Contacts) -> Six:
    plan = evaluated(case).plan
    assert plan.loading is not None, "the case has contact forces"
    return components_by_contacts(plan.fabric, poisson_ratio=plan.poisson_ratio, hypothesis=plan.hypothesis,
                                  contacts=contacts(plan.fabric, plan.loading))


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
