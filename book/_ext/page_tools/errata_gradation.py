"""What proves the errata that concern gradation."""

from __future__ import annotations

from granular.checks.length_rule import second_moment
from granular.generated.gradation import printed_lognormal_moment
from granular.gradation.fitted_lengths import neglected
from granular.gradation.lognormal_branches import INNER_STEP, OUTER_STEP
from granular.gradation.readings import literal
from page_tools.gradation import assemblies
from page_tools.markup import Markup, table


def centre_table(data: str) -> Markup:
    """Compare mode, median and mean of the sizes of Table I, as radii."""
    rows = []
    for case, sizes in assemblies(data):
        mean, = printed_lognormal_moment(sizes.median / 2, sizes.log_spread**2, 1)
        rows.append([case["curve"], case["r50_mm"], *(f"{1e3 * radius:.3f}" for radius in (
            sizes.median / 2, sizes.median_by_volume / 2, mean))])
    return table(["curve", "printed $r_{50}$", "mode", "median", "mean"], rows, label="tab-centres", align="lrrrr",
                 caption="Mode, median and mean of the radii by volume, in mm, for equation (18) with the values of "
                         "Table I.")


def neglected_check(data: str) -> Markup:
    """Show what the lognormal form makes of the mean square branch length."""
    rows = [[f"{spread:g}", _percent(neglected(spread).mean_square - 1)] for spread in _spreads(data)]
    return table(["$s_r$", "error of $\\langle\\ell^2\\rangle$"], rows, label="tab-eq-19", align="rr",
                 caption="Mean square branch length by equation (19) against equation (17).")


def uniformity_check(data: str) -> Markup:
    """Evaluate the number of gradation for the spreads of Table I by two independent programs."""
    rows = []
    for spread in _spreads(data):
        again, _, _ = second_moment(spread, inner=INNER_STEP, outer=OUTER_STEP)
        numbers = literal(spread)
        rows.append([f"{spread:g}", f"{numbers.kinematic:.6f}", f"{4 * again:.6f}", f"{4 / numbers.static:.6f}"])
    return table(["$s_r$", "kinematic", "the same, written twice", "static"], rows, label="tab-number", align="rrrr",
                 caption="$\\langle\\ell^2\\rangle/\\langle r^3\\rangle_p^{2/3}$ and "
                         "$1/(\\langle\\ell^{-2}\\rangle\\langle r^3\\rangle_p^{2/3})$ for the spreads of Table I.")


def _spreads(data: str) -> list[float]:
    return sorted({sizes.spread for _, sizes in assemblies(data)})


def _percent(change: float) -> str:
    return f"{100 * change:+.2f} %".replace("-", "−")
