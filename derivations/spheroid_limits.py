"""Aligned spheroids close to spheres, as flat as plates, as long as needles; what the collinear branch leaves out."""

from __future__ import annotations

import sympy as sp

from derivations import kinematic
from derivations.fabric import density_form, fabric_tensor
from derivations.record import Claim, Step
from derivations.sphere import axial_mean
from derivations.spheroid_components import constant_components, positive_relaxed
from derivations.spheroid_moments import ELEMENTARY, FABRIC, by_recurrence, elementary_moments, excess
from derivations.symbols import (
    D33,
    D3333,
    N11,
    N33,
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    Dr33,
    aspect_ratio,
    d0,
    d1,
    e0,
    e1,
    e2,
    lam,
    latex,
    one_minus_lam,
    p0,
    p1,
    p2,
    relaxed_C2323,
    s,
    varrho,
    y,
)

chi = aspect_ratio
HERTZ = {one_minus_lam: 1 - lam}
WITH_RELAXED = (*STIFFNESS, relaxed_C2323)
"""Components for which limits are given."""


def seven_components() -> tuple[sp.Expr, ...]:
    """Six components over k_n for k_r = lambda k_n and the vertical shear of grains free to spin."""
    constant = dict(zip((*TANGENTIAL_MOMENTS, d0, d1),
                        (lam * p0, lam * p1, lam * p2, one_minus_lam * p0, one_minus_lam * p1), strict=True))
    return (*constant_components(), positive_relaxed().xreplace(constant))


def moments_near_sphere(sign: int) -> dict[sp.Symbol, sp.Expr]:
    """Moments of E/Q (sign -1) or of E Q (sign +1) to first order in e."""
    return {p: axial_mean((density_form() * s ** (2 - k) * y**k * (1 + sign * excess * y)).subs(FABRIC))
            for k, p in enumerate(POSITIVE_MOMENTS)}


def near_sphere() -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """Value and slope in e of the six components at e = 0."""
    in_excess = [c.subs(HERTZ).subs(moments_near_sphere(-1)).subs(varrho, 1 + excess) for c in constant_components()]
    return tuple((sp.expand(c.subs(excess, 0)), sp.expand(sp.diff(c, excess).subs(excess, 0))) for c in in_excess)


def collinear_near_sphere() -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """The same for branch vectors 2|Mn| along the contact normals."""
    in_excess = [c.subs(HERTZ).subs(moments_near_sphere(+1)) for c in kinematic.positive_components()]
    return tuple((sp.expand(c.subs(excess, 0)), sp.expand(sp.diff(c, excess).subs(excess, 0))) for c in in_excess)


def log_slope(expansion: tuple[tuple[sp.Expr, sp.Expr], ...]) -> sp.Expr:
    """Rate d ln(C1111/C3333)/de at e = 0 without fabric."""
    (first, slope_first), (third, slope_third) = (
        tuple(part.subs({D33: 0, D3333: 0}) for part in pair) for pair in expansion[:2])
    return sp.cancel(slope_first / first - slope_third / third)


def plate_moment() -> sp.Expr:
    """<E y^2/Q> as chi tends to zero, but for terms that vanish with it."""
    return e2 * sp.log(2 / chi) + 2 * e0 / 35 + e1 / 7 - 176 * e2 / 105


PLATE = (
    3 * N11 / 4 + lam * (N11 / 4 + N33 / 2),
    chi**4 * (p2 + lam * N33),
    (1 - lam) * N11 / 4,
    chi**2 * (1 - lam) * N33 / 2,
    (N33 + 2 * lam * N11) / 8,
    ((1 - lam) * N11 + lam) / 4,
    chi**4 * lam * (p2 + N33 + (1 - lam) * N33 / (2 * ((1 - lam) * N33 + lam))),
)
"""Leading terms of the components as chi tends to zero; N11 and N33 are those of the contact normals."""

NEEDLE = (
    (3 + lam) * sp.pi * e0 / (16 * chi),
    chi**2 * (N33 + 2 * lam * N11),
    (1 - lam) * sp.pi * e0 / (16 * chi),
    (1 - lam) * N11,
    chi**2 * ((1 - lam) * N11 + lam) / 4,
    (1 + lam) * sp.pi * e0 / (16 * chi),
    lam * sp.pi * e0 / (4 * chi),
)
"""Leading terms as chi tends to infinity."""


def sphere_steps() -> tuple[Step, ...]:
    """Show what is left at chi = 1 and how fast it changes there, with the true and with the collinear branch."""
    expansion = near_sphere()
    isotropic = {p: m.subs(Dr33, 0) for p, m in zip(POSITIVE_MOMENTS, kinematic.closed_moments(), strict=True)}
    spheres = [c.subs(HERTZ).subs(isotropic) for c in kinematic.positive_components()]
    plain = {D3333: 0}
    exact, collinear = log_slope(expansion), log_slope(collinear_near_sphere())
    slopes = {exact: -(30 + 26 * lam) / (21 + 14 * lam), collinear: -(12 + 2 * lam) / (21 + 14 * lam)}
    shown = [(value.subs(plain), slope.subs(plain)) for value, slope in expansion]
    known = {0: (21 + 14 * lam - 6 * D33 - lam * D33, -(3 + 4 * lam + lam * D33)),
             1: (21 + 14 * lam + 12 * D33 + 2 * lam * D33, 27 + 22 * lam + 14 * D33 + 2 * lam * D33)}
    return (
        Step("Removable singularity at the sphere",
             r"Expanding $1/Q$ in $e = \varrho - 1$ leaves nothing singular. At $e = 0$ the components are those of "
             r"spheres with the same contacts; to first order and for $D_{3333} = 0$",
             tuple(rf"{latex(c)} = {latex(sp.factor(value))} {_signed(sp.factor(slope))}\,e + O(e^2)"
                   for c, (value, slope) in zip(STIFFNESS, shown, strict=True)),
             (*(Claim(value, sphere) for (value, _), sphere in zip(expansion, spheres, strict=True)),
              *(Claim(105 * shown[number][part], known[number][part]) for number in known for part in (0, 1))),
             result=True),
        Step("What the collinear branch leaves out",
             r"A branch vector $2|\mathbf Mn|\,n$ has the true component along the normal but none across it. Its "
             "weight is $EQ$ where the true one has $E/Q$, and the axes are not stretched. Without fabric the "
             "anisotropy of spheroids close to spheres grows at the rates below; the collinear branch keeps about a "
             "quarter.",
             (rf"\left.\frac{{\mathrm d}}{{\mathrm de}}\ln\frac{{C_{{1111}}}}{{C_{{3333}}}}\right|_{{e=0}} = "
              rf"{latex(slopes[exact])}\ \text{{(exact)}},\qquad {latex(slopes[collinear])}\ \text{{(collinear)}}",),
             (*(Claim(found, stated) for found, stated in slopes.items()),
              *(Claim(value, sphere) for (value, _), sphere in zip(collinear_near_sphere(), spheres, strict=True)),
              Claim(sp.cancel(collinear / exact), (6 + lam) / (15 + 13 * lam))), result=True),
    )


def _signed(factored: sp.Expr) -> str:
    typeset = latex(factored)
    return typeset if typeset.startswith("-") else f"+ {typeset}"


def limit_steps() -> tuple[Step, ...]:
    """Show the leading terms for plates and for needles."""
    return _plate_step(), _needle_step()


def _plate_step() -> Step:
    n11, n33 = fabric_tensor()
    first = ELEMENTARY[0]
    at_plate = dict(zip(ELEMENTARY, by_recurrence(first, sp.Integer(-1)), strict=True))
    moments = [sp.expand(m.subs(at_plate)) for m in elementary_moments()]
    limits = {p0: 2 * N11, p1: N33}
    sum_rule = {N11: (1 - N33) / 2}
    ratios = [sp.limit(sp.cancel((found.subs(HERTZ).subs(limits).subs(varrho, chi**2) / stated).subs(sum_rule)), chi, 0)
              for found, stated in zip(seven_components(), PLATE, strict=True)]
    share = sp.sqrt(1 - chi**2)
    logarithm = sp.log((1 + share) / chi)
    return Step(
        "Plates",
        r"As $\chi$ tends to zero $L_0$ grows like $\ln(2/\chi)$ and the recurrence becomes "
        r"$L_{k+1} = L_k - 1/(2k+1)$. The first two moments tend to those of the fabric tensor, $2N_{11}$ and "
        r"$N_{33}$; the third is held up by contacts at the pole, where $E$ is $e_2/4\pi$. What is left out vanishes "
        r"like $\varrho\ln\varrho$.",
        (rf"p_2 \simeq {latex(plate_moment())}".replace(r"\log", r"\ln"),
         *(rf"{latex(c)} \simeq {latex(e)}" for c, e in zip(WITH_RELAXED, PLATE, strict=True))),
        (Claim(sp.diff(logarithm, chi), sp.diff(sp.atanh(share), chi)),
         Claim((logarithm - sp.log(2 / chi)).rewrite(sp.log).subs(sp.sqrt(1 - chi**2), 1), sp.Integer(0)),
         Claim(moments[0].subs(FABRIC), 2 * n11), Claim(moments[1].subs(FABRIC), n33),
         Claim(moments[2], plate_moment().subs(sp.log(2 / chi), first)),
         *(Claim(ratio, sp.Integer(1)) for ratio in ratios)), result=True)


def _needle_step() -> Step:
    n11, n33 = fabric_tensor()
    angle, root = sp.symbols("z k", positive=True)
    elementary = dict(zip(ELEMENTARY, by_recurrence(angle / root, root**2), strict=True))
    moments = [sp.limit(sp.together(m.subs(elementary) * root**power), root, sp.oo)
               for m, power in zip(elementary_moments(), (1, 2, 2), strict=True)]
    limits = {p0: sp.pi * e0 / (2 * chi), p1: 2 * N11 / chi**2, p2: N33 / chi**2}
    sum_rule = {N33: 1 - 2 * N11}
    ratios = [sp.limit(sp.cancel(c.subs(HERTZ).subs(limits).subs(varrho, chi**2).subs(sum_rule)
                                 / e.subs(sum_rule)), chi, sp.oo)
              for c, e in zip(seven_components(), NEEDLE, strict=True)]
    return Step(
        "Needles",
        r"As $\chi$ tends to infinity $L_0$ falls like $\pi/(2\chi)$. The first moment is held up by contacts at the "
        r"equator, where $E$ is $e_0/4\pi$ and taken to be positive; the other two tend to $2N_{11}/\varrho$ and "
        r"$N_{33}/\varrho$. The stiffness across the needles falls, that along them grows. The vertical shear does the "
        "one or the other, as grains are free to spin or not.",
        (rf"p_0 \simeq {latex(limits[p0])},\qquad p_1 \simeq {latex(limits[p1])},\qquad p_2 \simeq {latex(limits[p2])}",
         *(rf"{latex(c)} \simeq {latex(e)}" for c, e in zip(WITH_RELAXED, NEEDLE, strict=True))),
        (Claim(sp.limit(sp.atan(root), root, sp.oo), sp.pi / 2),
         Claim(moments[0], e0 * angle),
         Claim(moments[1].subs(FABRIC), 2 * n11), Claim(moments[2].subs(FABRIC), n33),
         *(Claim(ratio, sp.Integer(1)) for ratio in ratios)), result=True)
