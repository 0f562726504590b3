"""What branches laid along the normals cost, on a page: errors of the anisotropy, and where they come from."""

from __future__ import annotations

from collections.abc import Callable

from granular import AxialFabric, Hypothesis
from granular.branch_products import deviating, spheroid_branches, spheroid_deviation
from granular.branch_stiffness import stiffness_by_direction
from granular.checks.spheroid_digits import worst_error
from granular.collinear import ASSUMPTIONS, collinear_error, collinear_ratios, slopes_at_the_sphere, true_ratios
from granular.routes import sphere
from page_tools.markup import Markup, table
from page_tools.shape import ASPECT_RATIOS, POISSON, percent, power

ORDER = ("length", "projection", "weight")
HEADS = {"length": "$\\lvert\\boldsymbol\\ell\\rvert$", "projection": "$2\\lvert\\mathbf M\\mathbf n\\rvert$",
         "weight": "$W$"}
DEGREES = (5, 11, 17, 23, 29, 41, 65, 95, 131)
"""Degrees of Lebedev rules."""

GRAINS = (0.9, 0.5, 0.2, 3.0)
APART = (0.5, 0.8, 0.9, 0.95, 1.1, 1.5)


def headline(shape: float) -> Markup:
    """Say what the shape does to C1111/C3333, and what of it the collinear assumption finds."""
    true = true_ratios(shape).compression
    found = [collinear_ratios(name, shape).compression for name in ORDER]
    low, high = min(found), max(found)
    return Markup(f"The costs are not small. Grains with $b/a = {shape:g}$ have $C_{{1111}}/C_{{3333}} = {true:.3f}$ "
                  f"where spheres have 1; with branches along the normals one finds {low:.3f} to {high:.3f}.")


def compression_table() -> Markup:
    """List C1111/C3333 of spheroids, and the error of each collinear choice."""
    return _error_table(0, "$C_{1111}/C_{3333}$", label="tab-collinear-compression", take_away="collinear_1.csv")


def shear_table() -> Markup:
    """List C2323/C1212 of spheroids, and the error of each collinear choice."""
    return _error_table(1, "$C_{2323}/C_{1212}$", label="tab-collinear-shear", take_away="collinear_2.csv")


def _error_table(place: int, ratio: str, *, label: str, take_away: str) -> Markup:
    assert set(ORDER) == set(ASSUMPTIONS), "every choice has its column"
    rows = [[f"{shape:g}", f"{true_ratios(shape)[place]:#.5g}",
             *(percent(collinear_error(name, shape)[place] / 100) for name in ORDER)] for shape in ASPECT_RATIOS]
    in_file = ["b/a", ("C1111/C3333", "C2323/C1212")[place], *(f"error with the {name}" for name in ORDER)]
    return table(["$b/a$", f"true {ratio}", *(f"error with {HEADS[name]}" for name in ORDER)], rows, label=label,
                 align="rrrrr", take_away=take_away,
                 taken=[in_file, *([cell.replace("−", "-") for cell in row] for row in rows)],
                 caption=f"{ratio} of aligned spheroids under the kinematic hypothesis, and its error when branches "
                         "are laid along the normals with three choices of length; isotropic contact normals, "
                         f"contacts of one stiffness, Poisson's ratio {POISSON:g}.")


def kept_slopes() -> Markup:
    """Say how much of the anisotropy near the sphere the collinear assumption keeps."""
    true, collinear = slopes_at_the_sphere(POISSON)
    kept = [100 * part / whole for part, whole in zip(collinear, true, strict=True)]
    return Markup(
        f"Near the sphere, for each percent in $b/a$ the ratio $C_{{1111}}/C_{{3333}}$ changes by "
        f"{_number(true.compression)} % and not by {_number(collinear.compression)} %, and "
        f"$C_{{2323}}/C_{{1212}}$ by {_number(true.shear)} % and not by {_number(collinear.shear)} %: "
        f"the assumption keeps {kept[0]:.1f} % of the one slope and {kept[1]:.1f} % of the other.")


def angle_or_length() -> Markup:
    """Take length and angle of the branches apart: either alone, and both."""
    rows = []
    for shape in APART:
        both = _compression(spheroid_branches(shape))
        angle = _compression(deviating(spheroid_deviation(shape)))
        length = collinear_ratios("length", shape).compression
        rows.append([f"{shape:g}", *(f"{value:.4f}" for value in (length, angle, both))])
    return table(["$b/a$", "length alone", "angle alone", "both"], rows, label="tab-angle", align="rrrr",
                 take_away="angle_or_length.csv",
                 caption="$C_{1111}/C_{3333}$ with branches of the true length along the normals, with branches of one "
                         "length in the true directions, and with the true branches.")


def degree_table() -> Markup:
    """List the error of rules over the sphere for some spheroids, by degree."""
    rows = []
    for degree in DEGREES:
        errors = [_rule_error(shape, degree) for shape in GRAINS]
        rows.append([str(degree), str(sphere.directions_of(degree)), *map(power, errors)])
    return table(["degree", "directions", *(f"$b/a = {shape:g}$" for shape in GRAINS)], rows, label="tab-degrees",
                 align="rrrrrr", take_away="degrees.csv",
                 caption="Relative error of the worst component by a Lebedev rule over the sphere, against ball "
                         "arithmetic; isotropic contact normals, kinematic hypothesis.")


def _rule_error(shape: float, degree: int) -> float:
    fabric = AxialFabric(aspect_ratio=shape)
    return worst_error(sphere.components_by_degree(fabric, poisson_ratio=POISSON, hypothesis=Hypothesis.KINEMATIC,
                                                   degree=degree), fabric)


def _compression(branches: Callable[..., object]) -> float:
    found = stiffness_by_direction(branches, poisson_ratio=POISSON).mandel
    return float(found[0, 0] / found[2, 2])


def _number(value: float) -> str:
    return f"{value:+.2f}".replace("-", "−")
