"""Plane waves in a transversely isotropic solid: Christoffel closed forms and Thomsen parameters."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.symbols import (
    C1111,
    C1122,
    C1133,
    C1212,
    C2323,
    C3333,
    cos_squared,
    delta,
    density,
    epsilon,
    gamma,
    latex,
    s,
    sin_squared,
    v_P,
    v_SH,
    v_SV,
    y,
)

half_sum, half_difference, coupling, root = sp.symbols("half_sum half_difference coupling root", real=True)
fast, slow, bracket = sp.symbols("fast slow bracket", positive=True)

_DIAGONAL = {0: C1111, 1: C1111, 2: C3333}


def tensor(i: int, j: int, k: int, m: int) -> sp.Expr:
    """Component of a transversely isotropic stiffness, indices 0, 1, 2, from the six independent names."""
    first, second = tuple(sorted((i, j))), tuple(sorted((k, m)))
    if first[0] == first[1] and second[0] == second[1]:
        if first == second:
            return _DIAGONAL[i]
        return C1133 if 2 in (first[0], second[0]) else C1122
    if first == second:
        return C1212 if first == (0, 1) else C2323
    return sp.Integer(0)


def christoffel() -> sp.Matrix:
    """Gamma_jk = C_ijkl n_i n_l for propagation in the plane of axes 1 and 3, with s and y for sin^2 and cos^2."""
    n = (sp.sqrt(s), sp.Integer(0), sp.sqrt(y))
    return sp.Matrix(3, 3, lambda j, k: sp.expand(sum(tensor(i, j, k, m) * n[i] * n[m]
                                                      for i in range(3) for m in range(3))))


def squared_speeds() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Density times v_P^2, v_SV^2, v_SH^2."""
    half_total = (C1111 * s + C3333 * y + C2323 * (s + y)) / 2
    half_gap = ((C1111 - C2323) * s - (C3333 - C2323) * y) / 2
    off_diagonal = (C1133 + C2323) * sp.sqrt(s * y)
    radical = sp.sqrt(half_gap**2 + off_diagonal**2)
    return half_total + radical, half_total - radical, C1212 * s + C2323 * y


def thomsen() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Thomsen's epsilon, gamma and delta."""
    return ((C1111 - C3333) / (2 * C3333), (C1212 - C2323) / (2 * C2323),
            ((C1133 + C2323) ** 2 - (C3333 - C2323) ** 2) / (2 * C3333 * (C3333 - C2323)))


def velocity_function() -> Function:
    """Emit the three phase speeds; the slower in-plane wave by the product of both roots, so that nothing cancels."""
    return Function(
        "phase_velocities", "Phase speeds of the P, SV and SH waves in m/s.",
        (C1111, C3333, C1133, C2323, C1212, density, sin_squared, cos_squared),
        ((half_sum, (C1111 * sin_squared + C3333 * cos_squared + C2323) / 2),
         (half_difference, ((C1111 - C2323) * sin_squared - (C3333 - C2323) * cos_squared) / 2),
         (coupling, (C1133 + C2323) ** 2 * sin_squared * cos_squared),
         (root, sp.sqrt(half_difference**2 + coupling)),
         (fast, half_sum + root),
         (bracket, sin_squared * cos_squared
          * ((C1111 * C3333 - C1133**2) - 2 * C2323 * C1133)
          + C2323 * (C1111 * sin_squared * sin_squared + C3333 * cos_squared * cos_squared)),
         (slow, bracket / fast),
         (v_P, sp.sqrt(fast / density)), (v_SV, sp.sqrt(slow / density)),
         (v_SH, sp.sqrt((C1212 * sin_squared + C2323 * cos_squared) / density))),
        (v_P, v_SV, v_SH),
        notes="v_P is the faster of the two waves polarised in the plane of axis 3, v_SV the slower. Sine and cosine "
              "are both asked for, so that no digit is lost near either axis.")


def thomsen_function() -> Function:
    """Emit Thomsen's parameters with differences of squares factorised."""
    return Function(
        "thomsen", "Thomsen's epsilon, gamma and delta.", (C1111, C3333, C1133, C2323, C1212),
        ((epsilon, (C1111 - C3333) / (2 * C3333)), (gamma, (C1212 - C2323) / (2 * C2323)),
         (delta, (C1133 + C3333) * (C1133 + 2 * C2323 - C3333) / (2 * C3333 * (C3333 - C2323)))),
        (epsilon, gamma, delta))


def fastest_shear_waves() -> tuple[tuple[str, sp.Expr], ...]:
    """Density times the squared speed of the shear waves along and across axis 3."""
    p_axis, sv_axis, sh_axis = (e.subs({s: 0, y: 1}) for e in squared_speeds())
    _, sv_across, sh_across = (e.subs({s: 1, y: 0}) for e in squared_speeds())
    del p_axis
    return (("vertical", sh_axis), ("vertical, in plane", sv_axis),
            ("horizontal, vertical polarisation", sv_across), ("horizontal, horizontal polarisation", sh_across))


@cache
def waves() -> Derivation:
    """Derive phase speeds at any angle and Thomsen's parameters."""
    fast_, slow_, horizontal = squared_speeds()
    matrix = christoffel()
    in_plane = matrix.extract([0, 2], [0, 2])
    trace, determinant = in_plane.trace(), in_plane.det()
    positive_gap = {C3333: C2323 + sp.Symbol("g3", positive=True), C1111: C2323 + sp.Symbol("g1", positive=True)}
    p, q, r, u = sp.symbols("p q r u", positive=True)
    characteristic = (p * (1 - y) - u) * (q * y - u) - r**2 * y * (1 - y)
    turning = {y: (p + r) / (p + q + 2 * r), u: (p * q - r**2) / (p + q + 2 * r)}
    steps = (
        Step("Christoffel matrix",
             "A plane wave along $n$ moves the solid along an eigenvector of $C_{ijkl}n_in_l$; the eigenvalue is the "
             "density times the squared phase speed. For $n$ in the plane of axes 1 and 3 the matrix splits.",
             (rf"\Gamma_{{11}} = {latex(matrix[0, 0])}", rf"\Gamma_{{33}} = {latex(matrix[2, 2])}",
              rf"\Gamma_{{13}} = {latex(sp.factor(matrix[0, 2]))}", rf"\Gamma_{{22}} = {latex(matrix[1, 1])}"),
             (Claim(matrix[0, 1], sp.Integer(0)), Claim(matrix[1, 2], sp.Integer(0)),
              Claim(matrix[1, 1], horizontal))),
        Step("In-plane waves",
             "The 2 x 2 block has two eigenvalues; their sum is its trace and their product its determinant.",
             (rf"\rho v_P^2 = {latex(fast_.subs(s + y, 1))}",
              rf"\rho v_{{SV}}^2 = {latex(slow_.subs(s + y, 1))}"),
             (Claim(sp.expand((fast_ + slow_).subs(s, 1 - y)), sp.expand(trace.subs(s, 1 - y))),
              Claim(sp.expand((fast_ * slow_).subs(s, 1 - y)), sp.expand(determinant.subs(s, 1 - y)))), result=True),
        Step("No cancellation in the slower wave",
             "The slower speed follows from the determinant over the faster one instead of from a difference.",
             (r"\rho v_{SV}^2 = \frac{\Gamma_{11}\Gamma_{33}-\Gamma_{13}^2}{\rho v_P^2}",),
             (Claim(sp.expand(determinant.subs(s, 1 - y)),
                    sp.expand((s * y * (C1111 * C3333 - C1133**2 - 2 * C2323 * C1133)
                               + C2323 * (C1111 * s**2 + C3333 * y**2)).subs(s, 1 - y))),)),
        Step("Along and across the axis",
             "Along axis 3 both shear waves are carried by $C_{2323}$. Across it the horizontally polarised "
             "one is carried by $C_{1212}$, the vertically polarised one by $C_{2323}$ again.",
             (r"\rho v_{SH}^2(0) = \rho v_{SV}^2(0) = \rho v_{SV}^2(90^\circ) = C_{2323},\quad "
              r"\rho v_{SH}^2(90^\circ) = C_{1212}",),
             (Claim(sp.simplify(slow_.subs(positive_gap).subs({s: 0, y: 1})), C2323),
              Claim(sp.simplify(slow_.subs(positive_gap).subs({s: 1, y: 0})), C2323),
              Claim(horizontal.subs({s: 1, y: 0}), C1212)), result=True),
        Step("Fastest shear wave",
             "Between the axis and the horizontal the in-plane shear wave has one extremum. With "
             "$p = C_{1111} - C_{2323}$ and $q = C_{3333} - C_{2323}$, both positive, and "
             "$r = |C_{1133} + C_{2323}|$ it is a maximum where $pq > r^2$. The fastest shear wave of all is "
             "therefore carried by the largest of three numbers.",
             (r"\rho v^2_{\max} = \max\Bigl(C_{1212},\ C_{2323},\ C_{2323} + \frac{pq-r^2}{p+q+2r}\Bigr),\qquad "
              r"\cos^2\theta = \frac{p+r}{p+q+2r}",),
             (Claim(sp.cancel(sp.together(characteristic.subs(turning))), sp.Integer(0)),
              Claim(sp.cancel(sp.together(sp.diff(characteristic, y).subs(turning))), sp.Integer(0))), result=True),
        Step("Thomsen's parameters",
             "Three ratios that vanish for an isotropic solid; in $\\delta$ the difference of squares is factorised.",
             tuple(f"{latex(n)} = {latex(e)}" for n, e in zip((epsilon, gamma, delta), thomsen(), strict=True)),
             (Claim(thomsen()[2] * (2 * C3333 * (C3333 - C2323)),
                    (C1133 + C3333) * (C1133 + 2 * C2323 - C3333)),), result=True),
    )
    exact = {s: sin_squared, y: cos_squared}
    return Derivation(
        name="waves",
        title="Wave speeds of a transversely isotropic assembly",
        sources=("text below Table II",),
        assumptions=("Plane waves long against the grains, in a dry assembly.",),
        domain=("positive definite stiffness", "C3333 > C2323 for delta", "0 <= cos^2 <= 1"),
        inputs=(C1111, C3333, C1133, C2323, C1212, density, sin_squared, cos_squared),
        outputs=(*(Output(n, sp.sqrt(e.subs(exact) / density), "m/s")
                   for n, e in zip((v_P, v_SV, v_SH), squared_speeds(), strict=True)),
                 *(Output(n, e) for n, e in zip((epsilon, gamma, delta), thomsen(), strict=True))),
        steps=steps,
        functions=(velocity_function(), thomsen_function()),
    )
