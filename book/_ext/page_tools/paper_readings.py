"""What Tables II to V teach, in sentences whose numbers are computed; one that no longer holds stops the build."""

from __future__ import annotations

import math
from fractions import Fraction

from granular.figures.by_direction import limits
from granular.loading import Loading
from page_tools.markup import Markup, table
from page_tools.paper import RATIOS, cases, typeset
from page_tools.paper_tables import TABLES, Printed, evaluated, printed_ratios

AXIAL, SHEAR = (name for name, _ in RATIOS)


def felt_to_first_order() -> Markup:
    """Compare D33 + 2 Dr33 with the ratio of each case of Table II."""
    rows = []
    for ratio in _of("II", AXIAL):
        felt = float(ratio.case["D33"]) + 2 * float(ratio.case["Dr33"])
        rows.append((felt, [ratio.label, *(f"{value:+.1f}".replace("-", "−") for value in (
            float(ratio.case["D33"]), float(ratio.case["Dr33"]), felt)), f"{ratio.exact:.4f}"]))
    assert [row for _, row in sorted(rows)] == [row for _, row in sorted(rows, key=lambda row: -float(row[1][-1]))], \
        "the combination does not order the cases"
    return table(["case", "$D_{33}$", "$D^{r}_{33}$", "$D_{33} + 2D^{r}_{33}$", typeset(AXIAL)],
                 [row for _, row in rows], label="tab-first-order", align="lrrrr", take_away="first_order.csv",
                 caption="The combination that the stiffness feels to first order puts the three cases in the right "
                         "order: the larger it is, the stiffer the vertical.")


def stages() -> Markup:
    """Say what forces and slip add to each ratio of Table III."""
    axial, shear = ([ratio.exact for ratio in _of("III", name)] for name in (AXIAL, SHEAR))
    assert axial[0] < axial[1] < axial[2] and shear[1] < shear[2] < shear[0] < 1, "the text no longer holds"
    return Markup(f"Contact forces raise {typeset(AXIAL)} by {_percent(axial[1] / axial[0] - 1)}, slip by another "
                  f"{_percent(axial[2] / axial[1] - 1)}. Forces lower {typeset(SHEAR)} by "
                  f"{_percent(1 - shear[1] / shear[0])}; slip gives {_percent(shear[2] / shear[1] - 1)} back.")


def growing(name: str) -> Markup:
    """Say that the anisotropy grows from row to row of Table IV or V."""
    axial, shear = ([ratio.exact for ratio in _of(name, ratio_name)] for ratio_name in (AXIAL, SHEAR))
    assert axial == sorted(axial, reverse=True) and shear == sorted(shear), "the anisotropy does not grow"
    what = {"IV": "With more vertical contacts", "V": "With a larger vertical stress"}[name]
    return Markup(f"{what} the assembly becomes stiffer vertically: from row to row {typeset(AXIAL)} falls, from 1 to "
                  f"{axial[-1]:.4f}, and {typeset(SHEAR)} rises, from 1 to {shear[-1]:.4f}.")


def forces_take_back(name: str) -> Markup:
    """Compare the ratios of the last case of a table with those of contacts of one stiffness."""
    case = cases(TABLES[name])[-1]
    equal = {ratio.name: ratio.value for ratio in evaluated({**case, "effects": "packing branches"}).ratios}
    found = {ratio.name: ratio.exact for ratio in printed_ratios(name)[-2:]}
    assert all(abs(equal[ratio] - 1) > abs(found[ratio] - 1) for ratio in found), "forces add to the anisotropy"
    return Markup(f"For ${case['case'].replace('D33', 'D_{33}')}$ they would be {equal[AXIAL]:.4f} and "
                  f"{equal[SHEAR]:.4f}, and are {found[AXIAL]:.4f} and {found[SHEAR]:.4f}.\n")


def what_slides() -> Markup:
    """Say in which directions contacts slide under the larger stress ratio of Table V."""
    case = cases(TABLES["V"])[-1]
    friction = math.tan(math.radians(float(case["friction_angle"].removesuffix(" deg"))))
    sliding = limits(Fraction(0), Loading.of_ratio(float(case["stress_ratio"]), friction=friction)).sliding
    assert sliding is not None, "no contact slides"
    low, high = sliding
    share = math.cos(math.radians(low)) - math.cos(math.radians(high))
    return Markup(f"At the ratio {case['stress_ratio'].removesuffix('.0')} all contacts between {low:.1f}° and "
                  f"{high:.1f}° from axis 3 slide, {100 * share:.0f} % of all contacts.\n")


def _of(name: str, ratio_name: str) -> list[Printed]:
    return [ratio for ratio in printed_ratios(name) if ratio.name == ratio_name]


def _percent(change: float) -> str:
    return f"{100 * change:.1f} %"
