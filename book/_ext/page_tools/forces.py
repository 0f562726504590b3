"""What contacts carry: the two numbers of rank two for the paper's assemblies, and rank four beside rank two."""

from __future__ import annotations

import math
from fractions import Fraction
from importlib.resources import as_file, files

import sympy as sp

from derivations.forces_rank_four import AXIAL_1, AXIAL_3, closed_means
from derivations.symbols import D33, D3333, s, x
from granular import Scene
from granular.fabric import AxialFabric
from granular.figures.by_direction import limits
from granular.figures.contacts import contacts_of
from granular.figures.contacts import forces_figure as draw
from granular.figures.page import Static
from granular.figures.paper_figure_7_9 import FRICTION, data
from granular.loading import Loading
from page_tools.markup import Markup, numbers_to_take_away, table

ASSEMBLIES = ((0.0, 1.0), (0.3, 1.0), (0.5, 1.0), (0.0, 1.5), (0.0, 2.0), (0.5, 2.0), (1.0, 1.75))
"""D33 and stress ratio: those of the paper, and two in which fabric and stress work against each other."""

ANGLES = (0, 30, 45, 60, 90)
RANK_FOUR_FABRIC = Fraction(3, 10)


def force_table() -> Markup:
    """List a, c, the largest shear force and the sliding contacts of some assemblies."""
    rows = []
    for fabric, ratio in ASSEMBLIES:
        loading = Loading.of_ratio(ratio, friction=FRICTION)
        a, c = loading.coefficients(Fraction(str(fabric)))
        sliding = limits(Fraction(str(fabric)), loading).sliding
        rows.append([f"{fabric:g}", f"{ratio:g}", f"${_fraction(a)}$", f"${_fraction(c)}$",
                     f"{float(abs(c - a)) / 2:.4f}",
                     f"{sliding[0]:.1f}° to {sliding[1]:.1f}°" if sliding else "none"])
    return table(["$D_{33}$", r"$\sigma_{33}/\sigma_{11}$", "$a$", "$c$", "largest $f_r$", "sliding at 12°"], rows,
                 label="tab-forces", align="rrrrrl", take_away="contact_forces.csv",
                 caption="Normal force at the equator (a) and at the pole (c), the largest shear force, all over that "
                         "of the isotropic assembly, branches of one length; and the directions in which contacts "
                         "slide when their friction angle is 12°.")


def rank_four_table() -> Markup:
    """Compare the force estimates of rank two and of rank four by direction, under isotropic stress."""
    fabric = sp.Rational(RANK_FOUR_FABRIC.numerator, RANK_FOUR_FABRIC.denominator)
    moments = {p: mean.subs({D33: fabric, D3333: 0}) for p, mean in closed_means().items()}
    a, c = (float(value) for value in Loading.of_ratio(1).coefficients(RANK_FOUR_FABRIC))
    rows = []
    for degrees in ANGLES:
        cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        along, across = (float(form.subs(moments).subs({s: sine**2, x: cosine})) / 3 for form in (AXIAL_3, AXIAL_1))
        rows.append([f"{degrees}°", *(f"{value:.4f}" for value in (
            a * sine**2 + c * cosine**2, across * sine**2 + along * cosine**2,
            abs(c - a) * sine * cosine, abs(along - across) * sine * cosine))])
    return table([r"$\beta$", "$f_n$, rank 2", "$f_n$, rank 4", "$f_r$, rank 2", "$f_r$, rank 4"], rows,
                 label="tab-rank-four", align="rrrrr", take_away="rank_four.csv",
                 caption=f"Forces of both ranks under isotropic stress for $D_{{33}} = {float(RANK_FOUR_FABRIC):g}$, "
                         "over that of the isotropic assembly.")


def forces_figure(name: str) -> Static:
    """Draw normal and shear force of one of the library's scenes against the angle."""
    with as_file(files("granular").joinpath("data", "scenes", f"{name}.toml")) as scene:
        return Static(draw(contacts_of(Scene.from_toml(scene))))


def figure_numbers(number: int) -> Markup:
    """Offer the columns behind Figure 7, 8 or 9."""
    return numbers_to_take_away(f"figure_{number}.csv", data(number))


def branch_length_table() -> Markup:
    """Evaluate the normal stiffness of contacts for branches of one length and of different lengths."""
    from granular.contact_distribution import normal_force, normal_stiffness

    loading = Loading.of_ratio(1)
    fabrics = AxialFabric(D33=0.3), AxialFabric(D33=0.3, Dr33=-0.3)
    rows = []
    for degrees in ANGLES:
        cosine = math.cos(math.radians(degrees))
        forces = [float(normal_force(fabric, loading, cosine)) for fabric in fabrics]
        stiffnesses = [float(normal_stiffness(fabric, loading, cosine)) for fabric in fabrics]
        rows.append([f"{degrees}°", *(f"{value:.4f}" for value in forces), *(f"{value:.4f}" for value in stiffnesses)])
    heads = [f"${name}$, $D^{{r}}_{{33}} = {fabric.Dr33:g}$" for name in ("f_n", "k_n") for fabric in fabrics]
    return table([r"$\beta$", *heads], rows, label="tab-branch-length", align="rrrrr",
                 caption="Normal force and normal stiffness of contacts under isotropic stress, $D_{33} = 0.3$.")


def _fraction(value: Fraction) -> str:
    return str(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"
