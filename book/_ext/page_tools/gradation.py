"""Grain sizes on a page: both lognormal forms, a sieve curve and what decides its number of grains."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from granular import Scene, evaluate
from granular.errors import GranularError
from granular.gradation import Lognormal, MeasuredCurve, SizeDistribution, length_moments
from granular.number_of_contacts import DEFAULT_RELATION, PER_CUBIC_METRE
from page_tools.markup import Markup, plain, table
from page_tools.paper import cases
from page_tools.refusals import SOUND_SCENE, curve_with

SPREAD, MEDIAN = 1.5, "10 mm"
"""Lognormal sizes of the examples; twice r_50 = 5 mm of the paper."""

LEAST_SIZES = (0.125e-3, 0.063e-3, 0.03e-3, 0.01e-3)
"""Sizes of the finest grains with which a curve is closed in turn [m]."""

OTHER_LINE = {"intercept": 1.5, "slope": 0.11, "source": "made up for this page"}

HEAD = "size [mm], fraction finer"
UNSOUND = (
    ("one row", (HEAD, "2, 1")),
    ("three columns", (HEAD, "0.5, 0, 12", "2, 1, 0")),
    ("percentages", (HEAD, "0.5, 0", "1, 40", "2, 100")),
    ("a fraction that falls", (HEAD, "0.5, 0", "1, 0.6", "2, 0.4", "4, 1")),
    ("one size twice", (HEAD, "0.5, 0", "1, 0.4", "1, 0.5", "2, 1")),
    ("no finest size", (HEAD, "0.5, 0.08", "1, 0.6", "2, 1")),
    ("a fraction above 1", (HEAD, "0.5, 0", "1, 1.2")),
    ("a size that is not positive", (HEAD, "0, 0", "1, 1")),
    ("an unknown unit", ("size [mmm], fraction finer", "0.5, 0", "1, 1")),
    ("a unit of another dimension", ("size [kg], fraction finer", "0.5, 0", "1, 1")),
    ("text in place of a number", (HEAD, "fine, 0", "1, 1")),
)
"""What is wrong with a file, and its rows."""


def lognormal_scene(median: str, spread: float, *, hypothesis: str = "kinematic", **gradation: Any) -> Scene:
    """Take the paper's isotropic assembly with lognormal sizes; ``median`` is a diameter."""
    return Scene.model_validate({
        **SOUND_SCENE, "model": {"hypothesis": hypothesis},
        "gradation": {"distribution": "lognormal", "median": median, "spread": spread, **gradation}})


def assemblies(data: str) -> list[tuple[dict[str, str], Lognormal]]:
    """Read Table I: what is printed, and the sizes; r_50 is a radius, and sizes are diameters."""
    return [(case, Lognormal(f"{2 * float(case['r50_mm']):g} mm", float(case["spread"]))) for case in cases(data)]


def two_forms() -> Markup:
    """Show what the same two keys mean in either form, and that the stiffness is the same."""
    rows = []
    for form in ("paper", "classical"):
        scene = lognormal_scene(MEDIAN, SPREAD, form=form)
        result, sizes = evaluate(scene), Lognormal(MEDIAN, SPREAD, form=form)
        rows.append([f"`{form}`", *_millimetres(sizes.D10, sizes.D50, sizes.equal_volume_diameter),
                     count(result.contacts_per_volume, 4), f"{result.stiffness.C3333 / 1e6:.6g}"])
    return table(["form", "$D_{10}$", "$D_{50}$", "mean volume", "contacts per m³", "$C_{3333}$ in MPa"], rows,
                 label="tab-forms", align="lrrrrr",
                 caption=f"The same keys, `median = \"{MEDIAN}\"` and `spread = {SPREAD}`, in both forms; sizes in mm. "
                         "The last but one size is the diameter of the grain of mean volume.")


def sieve_curve(scene: str) -> Markup:
    """State the sizes and coefficients read from a scene's curve."""
    sizes = _sizes(scene)
    found = ", ".join(f"$D_{{{percent}}} = {1e3 * size:.3f}$ mm" for percent, size in (
        (10, sizes.D10), (30, sizes.D30), (50, sizes.D50), (60, sizes.D60)))
    return Markup(f"Its sizes are {found}; $C_u = {sizes.uniformity:.3f}$, $C_c = {sizes.curvature:.3f}$.\n")


def finest_grains(scene: str) -> Markup:
    """Close the curve of a scene at other sizes of the finest grains, and show what that does."""
    sizes = _sizes(scene)
    assert isinstance(sizes, MeasuredCurve), "the scene names a curve"
    void_ratio = Scene.from_toml(scene).packing.void_ratio
    kept = [(size, fraction) for size, fraction in zip(sizes.sizes, sizes.fractions, strict=True) if fraction > 0]
    rows = []
    for least in LEAST_SIZES:
        points = [(size, fraction) for size, fraction in kept if size > least]
        curve = MeasuredCurve([least, *(size for size, _ in points)], [0.0, *(fraction for _, fraction in points)])
        moments = length_moments(curve)
        rows.append([f"{1e3 * least:g}", *_millimetres(curve.D10, curve.D50, curve.equal_volume_diameter),
                     count(curve.grains_per_volume(void_ratio), 3), f"{4 * moments.second:.3f}",
                     f"{4 / moments.inverse_second:.3f}"])
    return table(["finest", "$D_{10}$", "$D_{50}$", "mean volume", "grains per m³", "kinematic", "static"], rows,
                 label="tab-finest", align="rrrrrrr", take_away="finest_grains.csv",
                 caption="The curve of the example, closed at other sizes of the finest grains; sizes in mm, with the "
                         "diameter of the grain of mean volume. The last two columns are the numbers by which "
                         "gradation enters the stiffness, 4 for equal spheres.")


def contacts_of_scene(scene: str) -> Markup:
    """Show the number of grains and of contacts of a scene, by the default line and by another one."""
    rows = []
    for relation in (None, OTHER_LINE):
        content = Scene.from_toml(scene).model_dump(exclude_none=True)
        if relation is not None:
            content["packing"]["coordination_relation"] = relation
        changed = Scene.model_validate(content)
        result, line = evaluate(changed), changed.packing.relation
        assert result.contacts_per_volume_unit == PER_CUBIC_METRE, "sizes are simulated"
        assert changed.gradation is not None, "the scene has sizes"
        grains = changed.gradation.sizes.grains_per_volume(changed.packing.void_ratio)
        rows.append([f"$e = {line.intercept:g} - {line.slope:g}\\,\\bar N$", plain(line.source),
                     f"{changed.packing.coordination:.3f}", count(grains, 4), count(result.contacts_per_volume, 4)])
    return table(["line", "source", "$\\bar N$", "grains per m³", "contacts per m³"], rows, label="tab-coordination",
                 align="llrrr", caption=f"Numbers of the example at its void ratio of "
                 f"{Scene.from_toml(scene).packing.void_ratio:g}, by two lines.")


def default_line() -> Markup:
    """State the line between void ratio and coordination number with its source, from its record."""
    line = DEFAULT_RELATION
    return Markup(f"$$\ne = {line.intercept:g} - {line.slope:g}\\,\\bar N\n$$ (eq-line)\n\nis {plain(line.source)}.\n")


def curve_refusals() -> Markup:
    """Provoke the refusal of each unsound curve."""
    rows = []
    for what, lines in UNSOUND:
        refusal = _refusal(lines)
        rows.append([f"{what}, {{ref}}`{refusal.code} <error-{refusal.code.lower()}>`",
                     f"{_sentence(plain(refusal.found))} {plain(refusal.remedy)}"])
    return table(["the file holds", "what is said, beginning and remedy"], rows, label="tab-curve-refusals",
                 align="ll", look="words-first", caption="Curves that are refused, by provoking each refusal.")


def _refusal(lines: Iterable[str]) -> GranularError:
    try:
        curve_with(*lines)()
    except GranularError as refusal:
        return refusal
    raise AssertionError(f"nothing was refused in {lines}")


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + "."


def _sizes(scene: str) -> SizeDistribution:
    gradation = Scene.from_toml(Path(scene)).gradation
    assert gradation is not None, "the scene has sizes"
    return gradation.sizes


def count(number: float, digits: int) -> str:
    """Write a large number with its power of ten, as files to take away can hold it."""
    return f"{number:.{digits}g}".replace("e+0", "e").replace("e+", "e")


def _millimetres(*sizes: float) -> list[str]:
    return [f"{1e3 * size:.4g}" for size in sizes]
