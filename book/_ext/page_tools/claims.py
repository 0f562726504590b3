"""What the paper claims of gradation and of its isotropic assemblies, beside what the equations give."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from granular import Evaluation, Hypothesis, Scene, evaluate
from granular.gradation import Lognormal
from granular.gradation.cut_sizes import cut, cut_by_volume
from granular.gradation.readings import (
    READINGS,
    all_branches,
    literal,
    lognormal_lengths,
    lognormal_of_power,
    of_power,
    power_that_gives,
)
from page_tools.gradation import assemblies, count, lognormal_scene
from page_tools.markup import Markup, table
from page_tools.paper import cases

SPREADS = (1.2, 1.5, 2.0)
"""Those of Table I."""

OF_ONE_SHAPE = ("1", "2", "3")
"""Curves of Table I that differ in their mean size alone."""

EARLIER_CUT = 6.0
"""Distance of the smallest and the largest size from r_50 in an earlier count, in spreads [-]."""

CUTS = (2, 3, 4, 5, 6, 8, 10)
SHARES = (1e-2, 1e-3, 1e-6)
"""Shares of the volume that are left out at either end [-]."""

CONSTANT_TO_FIRST_ORDER = 4.0 / 7.0
"""Exponent in eq. (17) with which the number does not change to first order [-]."""

TESTED_UNIFORMITIES = (1.31, 1.80)
"""C_u of the sands that the paper refers to [-]."""

STANDARD_GRAVITY = 9.80665
"""Newtons in a kilogram-force."""


def mean_size_table(data: str) -> Markup:
    """Evaluate the assemblies of Table I that differ in their mean size alone, by both hypotheses."""
    rows = []
    values: dict[Hypothesis, list[float]] = {hypothesis: [] for hypothesis in Hypothesis}
    for case, sizes in assemblies(data):
        if case["curve"] not in OF_ONE_SHAPE:
            continue
        results = {hypothesis: _evaluated(sizes, hypothesis) for hypothesis in Hypothesis}
        for hypothesis, result in results.items():
            values[hypothesis].append(result.stiffness.C3333)
        rows.append([case["curve"], case["r50_mm"], count(results[Hypothesis.KINEMATIC].contacts_per_volume, 5),
                     *(f"{result.stiffness.C3333 / 1e6:.11g}" for result in results.values())])
    apart = max(max(found) / min(found) - 1 for found in values.values())
    grid = table(["curve", "$r_{50}$ in mm", "contacts per m³", "$C_{3333}$ kinematic", "$C_{3333}$ static"], rows,
                 label="tab-mean-size", align="lrrrr", take_away="mean_size.csv",
                 caption="Curves 1 to 3 of Table I, which differ in their mean size alone, under 28 kPa; stiffness in "
                         "MPa.")
    return Markup(f"{grid.text}\nThe largest relative difference between two of them is "
                  f"{_power(apart)}, which is rounding.\n")


def assemblies_table(data: str) -> Markup:
    """List the stiffness of all six assemblies by both hypotheses, and without the effect of gradation."""
    rows = []
    for case, sizes in assemblies(data):
        kinematic, static = (_evaluated(sizes, hypothesis) for hypothesis in Hypothesis)
        rows.append([case["curve"], case["r50_mm"], case["spread"], f"{sizes.uniformity:.2f}",
                     *(f"{value / 1e6:.4g}" for value in (
                         kinematic.stiffness.C3333, kinematic.stiffness.C2323, kinematic.stiffness.C1133,
                         static.stiffness.C3333, static.stiffness.C2323))])
    plain = [_without_gradation(hypothesis).stiffness for hypothesis in Hypothesis]
    rows.append(["none", "–", "–", "–", *(f"{value / 1e6:.4g}" for value in (
        plain[0].C3333, plain[0].C2323, plain[0].C1133, plain[1].C3333, plain[1].C2323))])
    return table(["curve", "$r_{50}$", "$s_r$", "$C_u$", "$C_{3333}$ kin.", "$C_{2323}$ kin.", "$C_{1133}$ kin.",
                  "$C_{3333}$ sta.", "$C_{2323}$ sta."], rows, label="tab-assemblies", align="lrrrrrrrr",
                 take_away="assemblies.csv",
                 caption="The six assemblies under 28 kPa by eq. (17) and both hypotheses, in MPa, $r_{50}$ in mm; "
                         "last the same packing without the effect of gradation.")


def uniformity_table() -> Markup:
    """List the number that carries gradation for the spreads of Table I."""
    rows = []
    for spread in SPREADS:
        whole, cut_off = literal(spread), cut(spread, EARLIER_CUT, about="printed")
        rows.append([f"{spread:g}", f"{Lognormal(1.0, spread).uniformity:.2f}", f"{whole.kinematic:.5g}",
                     f"{cut_off.kinematic:.4f}", f"{lognormal_lengths(spread).kinematic:.4f}",
                     f"{4 / whole.static:.4f}"])
    return table(["$s_r$", "$C_u$", "all sizes", f"cut at $r_{{50}}s_r^{{\\pm{EARLIER_CUT:g}}}$", "by eq. (19)",
                  "static, all sizes"], rows, label="tab-uniformity", align="rrrrrr", take_away="uniformity.csv",
                 caption="$\\langle\\ell^2\\rangle/\\langle r^3\\rangle_p^{2/3}$ for the spreads of Table I, and last "
                         "$1/(\\langle\\ell^{-2}\\rangle\\langle r^3\\rangle_p^{2/3})$. Equal spheres have 4 in every "
                         "column.")


def cut_table() -> Markup:
    """List how the number depends on where the sizes end."""
    rows = []
    widest = Lognormal(1.0, SPREADS[-1])
    for deviations in CUTS:
        largest = widest.median * widest.spread**deviations
        # as much is coarser than a size as is finer than its mirror image about the median
        coarser = widest.fraction_finer(widest.median_by_volume**2 / largest)
        rows.append([f"$r_{{50}}s_r^{{\\pm{deviations}}}$", _share(coarser),
                     *(f"{cut(spread, deviations, about='printed').kinematic:.4f}" for spread in SPREADS)])
    rows += [[f"{100 * share:g} % at either end", _share(share),
              *(f"{cut_by_volume(spread, share).kinematic:.4f}" for spread in SPREADS)] for share in SHARES]
    rows.append(["none", "0", *(f"{literal(spread).kinematic:.4f}" for spread in SPREADS)])
    return table(["cut", f"coarser, $s_r = {SPREADS[-1]:g}$", *(f"$s_r = {spread:g}$" for spread in SPREADS)], rows,
                 label="tab-cut", align="lrrrr", take_away="cut.csv",
                 caption="The kinematic number when sizes end somewhere, at sizes or at a share of the volume, and the "
                         "share of the volume beyond the largest one for the widest gradation.")


def cut_words() -> Markup:
    """Say what the cuts leave out of the widest gradation: little of the volume and much of the number."""
    widest = Lognormal(1.0, SPREADS[-1])
    largest = widest.median * widest.spread**EARLIER_CUT
    coarser = widest.fraction_finer(widest.median_by_volume**2 / largest)
    whole = literal(widest.spread).kinematic
    by_size, by_volume = (1 - one.kinematic / whole for one in (
        cut(widest.spread, EARLIER_CUT, about="printed"), cut_by_volume(widest.spread, SHARES[1])))
    return Markup(
        f"For $s_r = {widest.spread:g}$ the number depends on grains that no sieve will ever find. The cut at "
        f"{EARLIER_CUT:g} spreads leaves out {_share(coarser)} of the volume and {100 * by_size:.0f} % of the number. "
        f"A share of {_share(SHARES[1])} of the volume, cut off at either end, takes {100 * by_volume:.0f} % of it.\n")


def readings_table() -> Markup:
    """List the kinematic and the static number of every reading."""
    rows = []
    for reading in READINGS:
        numbers = [reading.numbers(spread) for spread in SPREADS]
        rows.append([reading.name.replace("g_total", "$g^{\\mathrm{total}}$"),
                     *(f"{one.kinematic:.3f}" for one in numbers), *(f"{4 / one.static:.3f}" for one in numbers)])
    heads = [f"{hypothesis}., {spread:g}" for hypothesis in ("kin", "sta") for spread in SPREADS]
    return table(["lengths", *heads], rows, label="tab-readings", align="lrrrrrr", take_away="readings.csv",
                 look="words-first",
                 caption="Both numbers for $s_r = 1.2$, 1.5 and 2, under each reading of what the lengths of the "
                         "branches are; 4 for equal spheres.")


def exponent_table() -> Markup:
    """List the exponent with which the number is that of equal spheres, and what 4/7 gives."""
    rows = [[f"{spread:g}", f"{power_that_gives(spread):.4f}",
             f"{of_power(spread, CONSTANT_TO_FIRST_ORDER).kinematic:.4f}",
             f"{lognormal_of_power(spread, CONSTANT_TO_FIRST_ORDER):.4f}", f"{all_branches(spread).kinematic:.4f}"]
            for spread in SPREADS]
    return table(["$s_r$", "exponent that gives 4", "number for 4/7", "$4\\cosh^4\\tfrac L2$", "number for 1"], rows,
                 label="tab-exponent", align="rrrrr",
                 caption="The exponent in eq. (17) with which the kinematic number is 4, and the number for two "
                         "exponents.")


def tests_table() -> Markup:
    """Say what both hypotheses predict over the range of the tests that the paper refers to."""
    spreads = [Lognormal.of_uniformity("1 mm", uniformity).spread for uniformity in TESTED_UNIFORMITIES]
    numbers = [literal(spread) for spread in spreads]
    rows = [[f"{uniformity:.2f}", f"{spread:.3f}", f"{one.kinematic:.3f}", f"{4 / one.static:.3f}"]
            for uniformity, spread, one in zip(TESTED_UNIFORMITIES, spreads, numbers, strict=True)]
    rows.append(["change", "", _percent(numbers[1].kinematic / numbers[0].kinematic - 1),
                 _percent(numbers[0].static / numbers[1].static - 1)])
    return table(["$C_u$", "$s_r$", "kinematic number", "static number"], rows, label="tab-tests", align="rrrr",
                 caption="The ends of the range of uniformity in the tests that the paper refers to, taken for "
                         "lognormal curves, and the change of the shear stiffness that eq. (17) predicts between them.")


def printed_number_table(data: str) -> Markup:
    """Turn the printed stiffnesses into the number of gradation that they imply, as printed and over g."""
    computed = _without_gradation(Hypothesis.KINEMATIC).stiffness.components
    rows = []
    for row in cases(data):
        share = float(row["printed_MPa"]) / (computed[row["component"]] / 1e6)
        rows.append([f"$C_{{{row['component'][1:]}}}$", row["printed_MPa"], f"{4 * share:.2f}",
                     f"{float(row['printed_MPa']) / STANDARD_GRAVITY:.2f}", f"{4 * share / STANDARD_GRAVITY:.3f}"])
    return table(["component", "printed", "number it implies", f"printed / {STANDARD_GRAVITY}", "number then"], rows,
                 label="tab-implied", align="lrrrr",
                 caption="The printed stiffness in MPa, and the number "
                         "$\\langle\\ell^2\\rangle/\\langle r^3\\rangle_p^{2/3}$ that it stands for, as printed and "
                         "divided by the standard acceleration of gravity.")


def advice_table(data: str) -> Markup:
    """Show for the narrowest and the widest assembly what the three ways open to an engineer give."""
    chosen = [(case, sizes) for case, sizes in assemblies(data) if case["curve"] in ("4", "6")]
    ways: Sequence[tuple[str, Callable[[Lognormal], Evaluation]]] = (
        ("kinematic, with gradation", lambda sizes: _evaluated(sizes, Hypothesis.KINEMATIC)),
        ("kinematic, without gradation", lambda _: _without_gradation(Hypothesis.KINEMATIC)),
        ("static, without gradation", lambda _: _without_gradation(Hypothesis.STATIC)),
        ("static, with gradation", lambda sizes: _evaluated(sizes, Hypothesis.STATIC)))
    rows = [[name, *(f"{way(sizes).stiffness.C2323 / 1e6:.4g}" for _, sizes in reversed(chosen))]
            for name, way in ways]
    heads = [f"curve {case['curve']}, $C_u = {case['uniformity']}$" for case, _ in reversed(chosen)]
    return table(["computed with", *heads], rows, label="tab-advice", align="lrr",
                 caption="Shear stiffness $C_{2323}$ in MPa of two assemblies of Table I under 28 kPa.")


def _evaluated(sizes: Lognormal, hypothesis: Hypothesis) -> Evaluation:
    return evaluate(lognormal_scene(f"{sizes.median!r} m", sizes.spread, hypothesis=hypothesis))


def _without_gradation(hypothesis: Hypothesis) -> Evaluation:
    """The same packing with gradation left out of the effects."""
    content = lognormal_scene("1 mm", SPREADS[0], hypothesis=hypothesis).model_dump(exclude_none=True)
    content["model"]["effects"] = []
    return evaluate(Scene.model_validate(content))


def _share(share: float) -> str:
    return f"{share:.2g}" if share >= 1e-4 else f"{share:.0e}"


def _percent(change: float) -> str:
    return f"{100 * change:+.1f} %".replace("-", "−")


def _power(error: float) -> str:
    return f"{error:.1e}".replace("-", "−") if error else "0"
