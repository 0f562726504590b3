"""Other ways of computing the same numbers, each with a setting that ranges over its accuracy."""

from __future__ import annotations

from granular.cost.outside import ball_integral, cubature, gauss, lebedev, mpmath_quad, quad, sympy_forms, tanh_sinh
from granular.cost.outside.route import OutsideRoute

CATALOGUE: tuple[OutsideRoute, ...] = (
    sympy_forms.EVALF, sympy_forms.LAMBDIFY,
    gauss.IN_X, gauss.IN_BETA, tanh_sinh.TANH_SINH,
    quad.QUAD, quad.QUAD_POINTS, quad.QUAD_VEC,
    cubature.CUBATURE, cubature.NQUAD, lebedev.SCIPY, lebedev.QUADPY,
    mpmath_quad.MPMATH, ball_integral.BALLS,
)
"""Every outside route."""
