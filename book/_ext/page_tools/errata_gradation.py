"""What proves the errata that concern gradation."""

from __future__ import annotations

import sympy as sp

from derivations.symbols import latex
from granular.checks.length_rule import second_moment
from granular.generated.gradation import printed_lognormal_moment
from granular.gradation.fitted_lengths import neglected
from granular.gradation.lognormal_branches import INNER_STEP, OUTER_STEP
from granular.gradation.readings import literal
from page_tools.errata_record import proved
from page_tools.gradation import assemblies
from page_tools.markup import Markup, table

STEP = 1e-3
"""How far beside the mode its density is compared [-]."""


def centre_table(data: str) -> Markup:
    """Compare mode, median and mean of the sizes of Table I, as radii."""
    rows, apart = [], []
    for case, sizes in assemblies(data):
        mean, = printed_lognormal_moment(sizes.median / 2, sizes.log_spread**2, 1)
        mode = sizes.median / 2
        heights = [sizes.density_by_volume(2 * mode * factor) for factor in (1 - STEP, 1.0, 1 + STEP)]
        apart.append(heights[0] < heights[1] > heights[2] and mean > sizes.median_by_volume / 2 > mode)
        rows.append([case["curve"], case["r50_mm"], *(f"{1e3 * radius:.3f}" for radius in (
            sizes.median / 2, sizes.median_by_volume / 2, mean))])
    return proved(all(apart), "equation (18) is largest at $r_{50}$, and its median and mean lie above it, for each of "
                  "the six curves", table(
                      ["curve", "printed $r_{50}$", "mode", "median", "mean"], rows, label="tab-centres",
                      align="lrrrr",
                      caption="Mode, median and mean of the radii by volume, in mm, for equation (18) with the values "
                              "of Table I."))


def neglected_check(data: str) -> Markup:
    """Show what the lognormal form makes of the mean square branch length."""
    found = {spread: neglected(spread) for spread in _spreads(data)}
    rows = [[f"{spread:g}", _percent(one.third_of_all - 1), _percent(one.mean_square - 1)]
            for spread, one in found.items()]
    return proved(all(one.third_of_all < 1 > one.mean_square for one in found.values()),
                  "the third moment of all branches, and the mean square along a direction, are too small for every "
                  "spread", table(
                      ["$s_r$", "error of $\\langle\\ell^3\\rangle_{\\mathrm{total}}$",
                       "error of $\\langle\\ell^2\\rangle$"], rows, label="tab-eq-19", align="rrr",
                      caption="Moments of the branch lengths by a lognormal density against equations (16) and (17)."))


def uniformity_check(data: str) -> Markup:
    """Evaluate the number of gradation for the spreads of Table I by two independent programs."""
    rows, agree, away = [], [], []
    for spread in _spreads(data):
        again, _, _ = second_moment(spread, inner=INNER_STEP, outer=OUTER_STEP)
        numbers = literal(spread)
        agree.append(abs(4 * again / numbers.kinematic - 1))
        away.append(numbers.kinematic - 4)
        rows.append([f"{spread:g}", f"{numbers.kinematic:.6f}", f"{4 * again:.6f}", f"{4 / numbers.static:.6f}"])
    # 1e-10: two rules that share no line, each good to more than ten digits
    return proved(max(agree) < 1e-10 and 0 < min(away) < max(away), "two programs agree, and the number is above 4 and "
                  "not the same for all spreads", table(
                      ["$s_r$", "kinematic", "the same, written twice", "static"], rows, label="tab-number",
                      align="rrrr",
                      caption="$\\langle\\ell^2\\rangle/\\langle r^3\\rangle_p^{2/3}$ and "
                              "$1/(\\langle\\ell^{-2}\\rangle\\langle r^3\\rangle_p^{2/3})$ for the spreads of "
                              "Table I."))


def limits_check() -> Markup:
    """Compute equation (16) for sizes from 1 to 2 of one density, with the limits as printed and as they must be.

    For a length between 2 and 3 the other radius sets the lower bound of the integrand, beyond 3 the upper one.
    """
    r, length = sp.symbols("r ell", positive=True)
    printed, meant = [], []
    for first, last in ((2, 3), (3, 4)):
        # where both radii are between 1 and 2 the integrand is 1; beyond that part of the limits it is 0
        low, high = (1, length - 1) if last == 3 else (length - 2, 2)
        meant.append((sp.integrate(1, (r, low, high)), first, last))
        printed.append((sp.integrate(1, (r, high, low)), first, last))
    wholes = [sum(sp.integrate(inner, (length, first, last)) for inner, first, last in parts)
              for parts in (printed, meant)]
    quotients = [[sp.expand(inner / whole) for inner, _, _ in parts]
                 for parts, whole in zip((printed, meant), wholes, strict=True)]
    rows = [[name, *(f"${latex(part)}$" for part in (parts[0][0], whole, quotient[0]))] for name, parts, whole, quotient
            in zip(("as printed", "as it must be"), (printed, meant), wholes, quotients, strict=True)]
    return proved(quotients[0] == quotients[1] and wholes[0] == -wholes[1] == -1,
                  "the printed limits give the negative of both integrals, and the same quotient", table(
                      ["limits", "numerator", "denominator", "quotient"], rows, label="tab-limits", align="lrrr",
                      caption="Equation (16) for radii spread evenly from 1 to 2, and lengths from 2 to 3."))


def _spreads(data: str) -> list[float]:
    return sorted({sizes.spread for _, sizes in assemblies(data)})


def _percent(change: float) -> str:
    return f"{100 * change:+.2f} %".replace("-", "−")
