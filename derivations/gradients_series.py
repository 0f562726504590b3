"""The seven integrals behind the kinetic slopes as series in the contrast of the forces, with exact coefficients.

The normal force to the power -2/3 is the generating function of the Gegenbauer polynomials C_n^(2/3) in s - y, as in
``derivations.kinetic_series``. Each series is economised: its exact Taylor polynomial is written in Chebyshev
polynomials of the contrast, in fractions, and cut there, which saves a third of the terms.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.gradients_kinematic import FORCE_MOMENTS
from derivations.record import Function
from derivations.series import TruncatedSeries, gegenbauer_forms
from derivations.sphere import axial_moment
from derivations.symbols import a, c, d, eta

POWER = sp.Rational(2, 3)
DEGREE = 6
LENGTH = 72
"""Taylor terms to start from: what is beyond is below 2^-72 of the first at the largest contrast."""

LIMIT = sp.Rational(1, 2)
"""Largest contrast, 1/9 <= c/a <= 9."""

PRECISION = sp.Rational(1, 2**57)
"""What a series may leave out, relative to its smallest value: an eighth of the rounding of a double."""

both, square, mean_square, first, correction, root, scale = sp.symbols(
    "both square mean_square first correction root scale", positive=True)


@cache
def coefficients(m: int) -> tuple[sp.Rational, ...]:
    """Exact coefficients in eta of L_m times g^(4/3), g = (sqrt(a) + sqrt(c))/2."""
    return tuple(sum(factor * axial_moment(DEGREE - m + n - j, m + j) for j, factor in enumerate(form))
                 for n, form in enumerate(gegenbauer_forms(LENGTH, POWER)))


@cache
def _powers_in_chebyshev(length: int) -> tuple[tuple[sp.Rational, ...], ...]:
    """Powers of eta on [-LIMIT, LIMIT] in Chebyshev polynomials of t = eta/LIMIT: t T_k = (T_(k+1) + T_|k-1|)/2."""
    rows = [[sp.Integer(1)]]
    for _ in range(1, length):
        before = rows[-1]
        row = [sp.Integer(0)] * (len(before) + 1)
        for k, value in enumerate(before):
            for neighbour in (k + 1, abs(k - 1)):
                row[neighbour] += value / 2
        rows.append([LIMIT * value for value in row])
    return tuple(tuple(row) for row in rows)


def _in_powers(chebyshev: list[sp.Rational]) -> tuple[sp.Rational, ...]:
    """A sum of Chebyshev polynomials of t in powers of eta again."""
    t = sp.Symbol("t")
    total = sum((factor * sp.chebyshevt_poly(k, t) for k, factor in enumerate(chebyshev)), sp.Integer(0))
    powers = reversed(sp.Poly(sp.expand(total), t).all_coeffs())
    return tuple(value / LIMIT**n for n, value in enumerate(powers))


@cache
def economised(m: int) -> TruncatedSeries:
    """The series of L_m, cut in its Chebyshev form where what is left out stays below ``PRECISION`` of it."""
    taylor = coefficients(m)
    rows = _powers_in_chebyshev(len(taylor))
    chebyshev = [sum((value * rows[n][k] for n, value in enumerate(taylor) if k < len(rows[n])), sp.Integer(0))
                 for k in range(len(taylor))]
    ends = (sum((value * (sign * LIMIT) ** n for n, value in enumerate(taylor)), sp.Integer(0)) for sign in (-1, 1))
    smallest = min(ends)  # the integrals change steadily with the contrast
    keep, rest = len(taylor), sp.Integer(0)
    while keep > 1 and (rest + abs(chebyshev[keep - 1])) / smallest < PRECISION:
        keep -= 1
        rest += abs(chebyshev[keep])
    return TruncatedSeries(f"FORCE_{m}", _in_powers(chebyshev[:keep]), LIMIT, rest / smallest, eta.name)


def force_moments() -> Function:
    """Emit the seven integrals from the forces."""
    polynomial = sp.Function("polynomial")
    return Function(
        "force_moments", "Integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1, m = 0 ... 6.",
        (a, c, d),
        ((both, a * c), (square, a + c + 2 * sp.sqrt(both)), (eta, d / square), (mean_square, square / 4),
         (first, mean_square ** sp.Rational(1, 3)), (correction, mean_square / first**2 - first),
         (root, first + correction / 3), (scale, 1 / root**2),
         *((L, scale * polynomial(sp.Symbol(economised(m).name), eta)) for m, L in enumerate(FORCE_MOMENTS))),
        FORCE_MOMENTS, series=tuple(economised(m) for m in range(DEGREE + 1)),
        notes="The series hold for 1/9 <= c/a <= 9. The difference d = c - a is an argument of its own.")
