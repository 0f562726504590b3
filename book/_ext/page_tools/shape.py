"""Aligned spheroids on a page: how far branches deviate, what digits formulas keep, and what spin decides."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import numpy as np

from granular import AxialFabric, Evaluation, Hypothesis, Scene, Stiffness, evaluate
from granular.checks.spheroid_digits import by_arc_tangent, worst_error
from granular.collinear import deviation_angle, shape_of_weight
from granular.routes import axial, closed_form
from granular.routes.result import Six
from page_tools.markup import Markup, table

SCENE = Path("_data/spheroids.toml")
POISSON = 0.21
"""Poisson's ratio of the paper's tables."""

ASPECT_RATIOS = (0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1.0, 1.1, 1.5, 2.0, 3.0)
FIGURE_5 = (0.0, -0.3, -0.6, -0.9)
DISTANCES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 0.0)
ROUNDING = 1e-12
"""Eigenvalues this much smaller than the largest are zero to rounding."""

ROUTES: tuple[tuple[float, str, Hypothesis], ...] = (
    (0.9, "fixed", Hypothesis.KINEMATIC), (0.9, "relaxed", Hypothesis.KINEMATIC),
    (1 / 3, "fixed", Hypothesis.KINEMATIC), (0.2, "fixed", Hypothesis.KINEMATIC),
    (1e-9, "fixed", Hypothesis.KINEMATIC), (1e9, "relaxed", Hypothesis.KINEMATIC), (0.9, "fixed", Hypothesis.STATIC),
    (1e9, "fixed", Hypothesis.STATIC))
"""Aspect ratio, spin and hypothesis of scenes that are otherwise alike."""

SPHERES = (-1.0, -0.5, 0.3, 1.0, 2.0)
"""D33 of packings of spheres."""


def six_of(fabric: AxialFabric, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Six:
    """Normalised components for contacts of one stiffness."""
    return axial.evaluate(fabric, poisson_ratio=POISSON, hypothesis=hypothesis).components


def surfaces_table() -> Markup:
    """Give the spheroid beside each weight of Figure 5, and how far its branches deviate."""
    rows = []
    for Dr33 in FIGURE_5:
        shape = shape_of_weight(Dr33)
        steepest = float(deviation_angle(shape, 1 / math.hypot(1, shape)))
        where = f"{math.degrees(math.atan(shape)):.1f}°" if shape != 1 else "–"
        rows.append([signed(f"{Dr33:g}"), f"{shape:.4f}", f"{steepest:.1f}°", where])
    return table(["$D^{r}_{33}$", "$b/a$", "largest deviation", "at the angle $\\beta$"], rows, label="tab-deviation",
                 align="rrrr", take_away="deviation.csv",
                 caption="The weights of Figure 5, the spheroid with the same branches at pole and equator, and the "
                         "largest angle between its branches and the contact normals.")


def near_sphere_table() -> Markup:
    """Compare the elementary form in doubles with the library, on the way to the sphere."""
    rows = []
    for distance in DISTANCES:
        naive = [_elementary_error(1 - distance, D33) for D33 in (0.0, 0.3)]
        fabric = AxialFabric(D33=0.3, aspect_ratio=1 - distance)
        here = worst_error(closed_form.evaluate(fabric, poisson_ratio=POISSON,
                                                hypothesis=Hypothesis.KINEMATIC).components, fabric)
        rows.append([f"$10^{{{round(math.log10(distance))}}}$" if distance else "0", *naive, power(here)])
    return table(["$1 - b/a$", "$D_{33} = 0$", "$D_{33} = 0.3$", "series, $D_{33} = 0.3$"], rows,
                 label="tab-near-sphere", align="rrrr", take_away="near_the_sphere.csv",
                 caption="Relative error of the worst component against ball arithmetic: the elementary form in double "
                         "precision for two densities, and the series of the library for the second.")


def shape_routes() -> Markup:
    """List the route that a plan chooses for a shape, its cost, its promise and its error."""
    rows = []
    for shape, spin, hypothesis in ROUTES:
        chosen, known = (_evaluate(shape, spin, hypothesis, route) for route in ("auto", "certified"))
        error = max(abs(value / true - 1) for value, true in zip(chosen.normalised, known.normalised, strict=True))
        rows.append([f"{shape:.4g}".replace("e-09", "e−9").replace("e+09", "e9"), f"`{spin}`", str(hypothesis),
                     f"`{chosen.route}`", str(chosen.evaluations or "–"), power(chosen.relative_error),
                     power(error)])
    return table(["$b/a$", "spin", "hypothesis", "route", "directions", "promised error", "error"], rows,
                 label="tab-shape-routes", align="rlllrrr", take_away="shape_routes.csv",
                 caption="Route, number of directions, promised relative error and the error of the worst component "
                         "against ball arithmetic; $D_{33} = 0.3$. Under the static hypothesis no spin enters.")


def spin_table() -> Markup:
    """Compare the vertical shear of both spins with that of the static hypothesis."""
    rows = [[f"{shape:g}", *_shears(AxialFabric(aspect_ratio=shape))] for shape in ASPECT_RATIOS]
    return _spin_table("$b/a$", rows, label="tab-spin", take_away="spin.csv",
                       what="aligned spheroids with isotropic contact normals")


def sphere_spin_table() -> Markup:
    """Compare them for spheres, whose vertical and horizontal contacts are not equally many."""
    rows = [[signed(f"{D33:g}"), *_shears(AxialFabric(D33=D33))] for D33 in SPHERES]
    return _spin_table("$D_{33}$", rows, label="tab-sphere-spin", take_away="sphere_spin.csv",
                       what="spheres with anisotropic contact normals")


def _spin_table(first: str, rows: list[list[str]], *, label: str, take_away: str, what: str) -> Markup:
    return table([first, "fixed", "free", "static", "free/fixed − 1", "static/free − 1", "least eigenvalue"], rows,
                 label=label, align="rrrrrrr", take_away=take_away,
                 caption=f"Vertical shear stiffness $C_{{2323}}$ over $(M/V)\\,\\ell_e^2 k_n$ of {what}: fixed spin, "
                         "free spin, and the static hypothesis. The last column is the least eigenvalue of free minus "
                         "static stiffness in Mandel notation; none is negative.")


def _shears(fabric: AxialFabric) -> list[str]:
    fixed, free = (six_of(AxialFabric(D33=fabric.D33, aspect_ratio=fabric.aspect_ratio, free_spin=spin))
                   for spin in (False, True))
    static = six_of(fabric, Hypothesis.STATIC)
    gap = Stiffness.transversely_isotropic(*free).mandel() - Stiffness.transversely_isotropic(*static).mandel()
    eigenvalues = np.linalg.eigvalsh(gap)
    least = float(eigenvalues[0]) if abs(eigenvalues[0]) > ROUNDING * eigenvalues[-1] else 0.0
    if least < 0:
        raise AssertionError(f"{fabric}: static above free spin")
    return [*(f"{six[4]:.4f}" for six in (fixed, free, static)), percent(free[4] / fixed[4] - 1),
            percent(static[4] / free[4] - 1), power(least)]


def _elementary_error(shape: float, D33: float) -> str:
    try:
        return power(worst_error(by_arc_tangent(shape, D33=D33), AxialFabric(D33=D33, aspect_ratio=shape)))
    except ZeroDivisionError:
        return "no number"


def _evaluate(shape: float, spin: str, hypothesis: Hypothesis, route: str) -> Evaluation:
    content = tomllib.loads(SCENE.read_text(encoding="utf-8"))
    content["shape"] = {"aspect_ratio": shape, "spin": spin}
    content["model"]["hypothesis"] = str(hypothesis)
    return evaluate(Scene.model_validate(content), route=route)


def signed(number: str) -> str:
    """Set a number with the sign of print."""
    return number.replace("-", "−")


def percent(change: float) -> str:
    """Set a relative change as a percentage with its sign and three figures, or one decimal below ten."""
    size = abs(100 * change)
    return "0" if size < 1e-9 else signed(f"{100 * change:+.{1 if size < 99.95 else 0}f} %")


def power(error: float) -> str:
    """Set an error in powers of ten."""
    return signed(f"{error:.1e}") if error else "0"
