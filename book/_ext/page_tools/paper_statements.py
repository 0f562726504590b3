"""Statements of the paper on Figures 3 to 9, each computed; and what each figure shows, in a box."""

from __future__ import annotations

import numpy as np

from granular.figures.paper_figure_7_9 import CASES, FRICTION, data
from granular.figures.paper_figures_3_4 import table_i
from granular.gradation import branch_lengths
from granular.gradation.fitted_lengths import neglected
from page_tools.markup import Markup, boxed
from page_tools.paper import RATIOS, typeset
from page_tools.paper_figures import NOT_QUITE, components, densities, ruled, said, weights
from page_tools.paper_tables import printed_ratios

ROUNDING = 1e-12
"""Values this close are equal."""


def figure_3_shows() -> Markup:
    """Box what the gradation curves show."""
    one, wide, narrow = (table_i()[place] for place in (4, 3, 5))
    return boxed("What Figure 3 shows", Markup(
        "Curves 1, 2, 3 and 5 are one curve, moved along the axis of sizes; curves 4, 5 and 6 have one $r_{50}$ and "
        f"differ in slope. Their medians are not the same: {1e3 * narrow.D50:.1f}, {1e3 * one.D50:.1f} and "
        f"{1e3 * wide.D50:.1f} mm for curves 6, 5 and 4."))


def figure_3_said() -> Markup:
    """Statements on Figure 3."""
    rows = table_i()
    same = max(row.uniformity for row in rows[:3]) - min(row.uniformity for row in rows[:3])
    medians = [1e3 * row.D50 for row in rows[3:]]
    return said(3, [
        ("curves 1 to 3 have one coefficient of uniformity", f"their $C_u$ differ by {_power(same)}",
         ruled(same < ROUNDING)),
        ("curves 4 to 6 have different ones, and one mean size",
         f"$r_{{50}}$ is the same, $D_{{50}}$ is {medians[0]:.1f}, {medians[1]:.1f} and {medians[2]:.1f} mm",
         ruled(max(medians) - min(medians) < ROUNDING, NOT_QUITE))])


def figure_4_shows() -> Markup:
    """Box what the densities show."""
    wide = table_i()[3]
    columns = densities()
    by_number, along = (_peak(columns, f"{name}_4") for name in ("r_fp", "l_g"))
    return boxed("What Figure 4 shows", Markup(
        "By number the grains are far finer than by volume, and the cube root of equation (17) spreads the branch "
        f"lengths out again. For curve 4, whose $r_{{50}}$ is {1e3 * wide.r_50:g} mm, the first density is largest "
        f"near {by_number:.2g} mm and the last near {along:.2g} mm."))


def figure_4_said() -> Markup:
    """Statements on Figure 4."""
    columns = densities()
    logarithm = np.log(columns["size_mm"])
    areas = [float(np.trapezoid(column, logarithm)) for name, column in columns.items() if name != "size_mm"]
    row, other = table_i()[0], table_i()[2]
    shifted = abs(float(0.03 * branch_lengths(row.sizes).density(0.03)
                      / (0.003 * branch_lengths(other.sizes).density(0.003))) - 1)
    least, most = (100 * neglected(spread).largest_difference for spread in (1.2, 2.0))
    assert all(abs(area - 1) < 2e-3 for area in areas), "a density has not the area 1"
    return said(4, [
        ("the densities follow from the gradation curve alone", "curves 1 and 3 are one curve, moved: they differ by "
         f"{_power(shifted)}", ruled(shifted < ROUNDING)),
        ("$g(\\ell)$ remains lognormal, equation (19)",
         f"it is off by {least:.2g} % of its maximum for $s_r = 1.2$, and by {most:.2g} % for $s_r = 2$", NOT_QUITE)])


def figure_5_shows() -> Markup:
    """Box what the surfaces show."""
    columns = weights()
    flattest = columns["W Dr33=-0.9"]
    return boxed("What Figure 5 shows", Markup(
        "A surface whose distance from the centre is the branch length of that direction, over the mean one. From a "
        f"ball it flattens until, at $D^{{r}}_{{33}} = -0.9$, a vertical branch has {flattest[0]:.2f} of the mean "
        f"length and a horizontal one {flattest[-1]:.2f}. The last surface is the density of contact normals for "
        f"$D_{{33}} = 0.3$: {columns['4 pi E D33=0.3'][0]:.2f} at the pole, {columns['4 pi E D33=0.3'][-1]:.2f} at "
        "the equator."))


def figure_5_said() -> Markup:
    """Statements on Figure 5."""
    columns = weights()
    curves = [columns[f"W Dr33={value}"] for value in ("0", "-0.3", "-0.6", "-0.9")]
    ratios = [float(curve[-1] / curve[0]) for curve in curves]
    normals = columns["4 pi E D33=0.3"]
    return said(5, [
        ("(a) is uniform", f"longest over shortest branch: {float(curves[0].max() / curves[0].min()):g}",
         ruled(float(np.ptp(curves[0])) < ROUNDING)),
        ("(b) to (d): horizontal branches are longer", "horizontal over vertical: "
         + ", ".join(f"{ratio:.3g}" for ratio in ratios[1:]), ruled(all(ratio > 1 for ratio in ratios[1:]))),
        ("$\\bar\\ell_e$ is the averaged branch length", "over all directions the mean of $W$ is 1; over the contacts "
         "of (e) with branches of (b) it is " + f"{_mean(curves[1] * normals):.3f}", NOT_QUITE),
        ("(e) has more contacts in the vertical", f"pole over equator: {float(normals[0] / normals[-1]):.3f}",
         ruled(bool(normals[0] > normals[-1])))])


def figure_6_shows() -> Markup:
    """Box what the stiffness components do."""
    columns = components()
    change = {name: float(columns[f"{name}_MPa"][-1] / columns[f"{name}_MPa"][0] - 1)
              for name in ("C1111", "C3333", "C1212")}
    assert change["C1111"] > 0 > change["C3333"] and change["C1212"] > 0, "the text no longer holds"
    steady = float(np.max(np.abs(columns["C2323_MPa"] / columns["C2323_MPa"][0] - 1)))
    return boxed("What Figure 6 shows", Markup(
        f"Longer horizontal branches raise {typeset('C1111')} by {100 * change['C1111']:.0f} % and lower "
        f"{typeset('C3333')} by {100 * -change['C3333']:.0f} % from one end of the figure to the other. "
        f"{typeset('C1212')} rises by {100 * change['C1212']:.0f} %, while {typeset('C2323')} stays within "
        f"{100 * steady:.0f} % of where it begins."))


def figure_6_said() -> Markup:
    """Statements on Figure 6, and the one point of it that the paper prints."""
    columns = components()
    axial = columns["C1111_MPa"] / columns["C3333_MPa"]
    shear = columns["C2323_MPa"] / columns["C1212_MPa"]
    place = int(np.argmin(np.abs(columns["Dr33"] + 0.3)))
    printed = {ratio.name: ratio for ratio in printed_ratios("II")[:2]}
    return said(6, [
        ("anisotropic although packing and stress are isotropic", f"{typeset(RATIOS[0][0])} is {axial[0]:g} at 0 and "
         f"{axial[-1]:.2f} at the end", ruled(bool(axial[-1] > 1))),
        ("the anisotropy of the stiffness correlates with that of the branches", f"{typeset(RATIOS[0][0])} rises and "
         f"{typeset(RATIOS[1][0])} falls all the way",
         ruled(bool((np.diff(axial) > 0).all() and (np.diff(shear) < 0).all()))),
        *((f"Table II, case 1, is the point $D^{{r}}_{{33}} = -0.3$: {typeset(name)} = {printed[name].printed}",
           f"the figure has {curve[place]:.4f} there", f"[{printed[name].ruling}](table_ii.md)")
          for (name, _), curve in zip(RATIOS, (axial, shear), strict=True))])


def figure_7_shows() -> Markup:
    """Box what four microstructures do."""
    columns = data(7)
    normal = columns["f_n D33=0 Dr33=-0.3"]
    return boxed("What Figure 7 shows", Markup(
        "Under the same stress on all sides contacts carry unequal forces as soon as the fabric is anisotropic. Short "
        f"branches carry more: {normal[0]:.3f} times the force of the isotropic assembly at the pole, {normal[-1]:.3f} "
        "times at the equator, for $D^{r}_{33} = -0.3$ in an isotropic packing. The stiffness of the contacts does not "
        "notice the branches at all."))


def figure_7_said() -> Markup:
    """Statements on Figure 7."""
    columns = data(7)
    apart = max(float(np.max(np.abs(columns[f"{name} D33={D33} Dr33=-0.3"] / columns[f"{name} D33={D33} Dr33=0"] - 1)))
                for name in ("k_n", "k_r") for D33 in ("0", "0.3"))
    still = max(float(columns[f"f_r D33=0 Dr33={Dr33}"].max()) for Dr33 in ("0", "-0.3"))
    slip, without = columns["k_r D33=0.3 Dr33=0"], columns["k_r D33=0.3 without slip"]
    least = float((slip / without).min())
    normal = columns["f_n D33=0.3 Dr33=0"]
    return said(7, [
        ("contact forces are anisotropic although the stress is isotropic",
         f"$f_n$ from {float(normal.min()):.3f} to {float(normal.max()):.3f} for $D_{{33}} = 0.3$",
         ruled(float(np.ptp(normal)) > ROUNDING)),
        ("no shear force for an isotropic packing", f"largest $f_r$: {_power(still)}", ruled(still < ROUNDING)),
        ("$k_n$ is hardly influenced by $D^{r}_{33}$",
         f"largest relative difference of $k_n$ or $k_r$: {_power(apart)}",
         "{ref}`not at all <sec-erratum-normal-stiffness>`" if apart < ROUNDING else ruled(False)),
        ("slip reduces the shear stiffness", f"by up to {100 * (1 - least):.0f} %, and nowhere raises it",
         ruled(least < 1 and bool((slip <= without * (1 + ROUNDING)).all())))])


def figure_8_shows() -> Markup:
    """Box what growing anisotropy of the packing does."""
    columns = data(8)
    poles = [float(columns[f"f_n D33={value}"][0]) for value in ("0", "0.3", "0.5")]
    place = int(np.argmin(columns["k_r D33=0.5"]))
    return boxed("What Figure 8 shows", Markup(
        f"The more contacts face the vertical, the less each of them carries: {poles[0]:g}, {poles[1]:.3f} and "
        f"{poles[2]:.3f} of the mean force at the pole. The shear forces that the fabric causes lower the shear "
        f"stiffness, which is least {columns['beta'][place]:.0f}° from axis 3."))


def figure_8_said() -> Markup:
    """Statements on Figure 8."""
    columns = data(8)
    poles = [float(columns[f"f_n D33={value}"][0]) for value in ("0", "0.3", "0.5")]
    shears = [float(columns[f"f_r D33={value}"].max()) for value in ("0", "0.3", "0.5")]
    place = int(np.argmin(columns["k_r D33=0.5"]))
    expected = 45 - np.degrees(np.arctan(FRICTION)) / 2
    assert abs(columns["beta"][place] - expected) <= 0.5, "the text on the page no longer holds"
    return said(8, [
        ("the normal force is not isotropic under isotropic stress",
         f"$f_n$ for $D_{{33}} = 0.5$: {poles[2]:.3f} at the pole, {float(columns['f_n D33=0.5'][-1]):.3f} at the "
         "equator", ruled(abs(poles[2] - float(columns["f_n D33=0.5"][-1])) > ROUNDING)),
        ("more vertical contacts, less force on each", "at the pole " + ", ".join(f"{value:.3f}" for value in poles),
         ruled(poles == sorted(poles, reverse=True))),
        ("the shear force grows with the anisotropy", "at most " + ", ".join(f"{value:.3f}" for value in shears),
         ruled(shears == sorted(shears)))])


def figure_9_shows() -> Markup:
    """Box what the stress ratio does."""
    columns = data(9)
    slides = columns["beta"][columns["k_r SR=2"] == 0]
    return boxed("What Figure 9 shows", Markup(
        "Contacts along the larger stress gain force and those across lose it: under the ratio 2 the normal force is "
        f"{columns['f_n SR=2'][0]:.3f} of the mean at the pole and {columns['f_n SR=2'][-1]:.3f} at the equator. "
        f"Contacts between {slides.min():.1f}° and {slides.max():.1f}° from axis 3 then slide, and have no shear "
        "stiffness left."))


def figure_9_said() -> Markup:
    """Statements on Figure 9."""
    columns = data(9)
    names = [case.key for case in CASES[9]]
    poles = [float(columns[f"f_n {name}"][0]) for name in names]
    sine = np.sin(np.radians(columns["beta"]))
    means = [float(np.trapezoid(columns[f"f_n {name}"] * sine, np.radians(columns["beta"]))) for name in names]
    normal = columns["k_n SR=2"]
    shears = [float(columns[f"f_r {name}"].max()) for name in names]
    return said(9, [
        ("anisotropic stress makes normal and shear forces anisotropic",
         "largest $f_r$ " + ", ".join(f"{value:.3f}" for value in shears), ruled(shears == sorted(shears))),
        ("the higher the ratio, the more normal force along the larger stress",
         "at the pole " + ", ".join(f"{value:.3f}" for value in poles), ruled(poles == sorted(poles))),
        ("the mean stress remains constant", "mean of $f_n$ over the directions "
         + ", ".join(f"{value:.4f}" for value in means), ruled(all(abs(value - 1) < 1e-4 for value in means))),
        ("the contact stiffness is anisotropic", f"$k_n$ for the ratio 2: {normal[0]:.3f} at the pole, "
         f"{normal[-1]:.3f} at the equator", ruled(bool(normal[0] > normal[-1])))])


def _mean(values: np.ndarray) -> float:
    """Average over the sphere of a function of the angle, given at every degree from 0 to 90."""
    degrees = np.linspace(0.0, 90.0, len(values))
    sine = np.sin(np.radians(degrees))
    return float(np.trapezoid(values * sine, np.radians(degrees)) / np.trapezoid(sine, np.radians(degrees)))


def _peak(columns: dict[str, np.ndarray], name: str) -> float:
    """The size at which a density over the logarithm of size is largest."""
    return float(columns["size_mm"][int(np.argmax(columns[name]))])


def _power(value: float) -> str:
    digit, exponent = f"{value:.0e}".split("e")
    return f"${digit}\\times10^{{{int(exponent)}}}$" if value else "0"

