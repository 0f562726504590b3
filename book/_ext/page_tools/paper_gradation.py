"""Table I of the paper: six gradations as printed, and the coefficients and sizes that follow from equation (18)."""

from __future__ import annotations

from page_tools.gradation import assemblies
from page_tools.markup import Markup, boxed, table


def table_one(data: str) -> Markup:
    """Compare the printed C_u of Table I with the computed one, and add what else the curves have."""
    rows = [[case["curve"], case["r50_mm"], case["spread"], case["uniformity"], f"{sizes.uniformity:.4f}",
             f"{float(case['uniformity']) - sizes.uniformity:+.3f}".replace("-", "−"),
             _verdict(case["uniformity"], sizes.uniformity), f"{sizes.curvature:.3f}",
             *(f"{1e3 * size:.4g}" for size in (sizes.D10, sizes.D50, sizes.D60))]
            for case, sizes in assemblies(data)]
    return table(["curve", "$r_{50}$", "$s_r$", "$C_u$ printed", "$C_u$ exact", "printed − exact", "verdict", "$C_c$",
                  "$D_{10}$", "$D_{50}$", "$D_{60}$"], rows, label="tab-table-i", align="lrrrrrlrrrr",
                 take_away="table_i_compared.csv",
                 caption="Table I of the paper with the exact coefficient of uniformity, and what else follows from "
                         "the same two numbers. $r_{50}$ is a radius, $D$ are diameters, all in mm.")


def uniformity_finding(data: str) -> Markup:
    """Box whether the printed coefficients follow; one that does not stops the build."""
    found = assemblies(data)
    wrong = [case["curve"] for case, sizes in found if _verdict(case["uniformity"], sizes.uniformity) != "confirmed"]
    assert not wrong, f"Table I: C_u of curves {', '.join(wrong)} does not follow"
    largest = max(sizes.D50 / (2e-3 * float(case["r50_mm"])) for case, sizes in found)
    smallest = min(sizes.D50 / (2e-3 * float(case["r50_mm"])) for case, sizes in found)
    return boxed("What Table I holds", Markup(
        f"All {len(found)} printed coefficients of uniformity are the exact ones, rounded to one decimal. What the "
        f"table calls the mean size is not a mean: half of the volume is finer than {smallest:.2f} to {largest:.2f} "
        "times $r_{50}$, the more the wider the gradation."))


def _verdict(printed: str, exact: float) -> str:
    digits = len(printed.partition(".")[2])
    return "confirmed" if f"{exact:.{digits}f}" == printed else "does not follow"
