"""The stiffness and the compliance of one contact in global axes, eq. (2)."""

from __future__ import annotations

import sympy as sp

from derivations.symbols import cos_alpha, kn, kr, ks, kt, sin_alpha, sin_beta, x

NORMAL = sp.Matrix([sin_beta * cos_alpha, sin_beta * sin_alpha, x])
"""Contact normal n."""

MERIDIAN = sp.Matrix([x * cos_alpha, x * sin_alpha, -sin_beta])
"""Tangent s, along the meridian."""

PARALLEL = sp.Matrix([-sin_alpha, cos_alpha, sp.Integer(0)])
"""Tangent t, along the parallel."""

TO_EQUAL_TANGENTS = {ks: kr, kt: kr}
"""The case used for Hertz-Mindlin contacts: the same tangential stiffness in all directions."""


def stiffness() -> sp.Matrix:
    """k_jl = k_n n_j n_l + k_s s_j s_l + k_t t_j t_l, eq. (2)."""
    return kn * NORMAL * NORMAL.T + ks * MERIDIAN * MERIDIAN.T + kt * PARALLEL * PARALLEL.T


def compliance() -> sp.Matrix:
    """Inverse of the contact stiffness: the same dyads with reciprocal coefficients, as n, s, t are orthonormal."""
    return NORMAL * NORMAL.T / kn + MERIDIAN * MERIDIAN.T / ks + PARALLEL * PARALLEL.T / kt

