"""The kinetic fabric without slip as it is evaluated for very many assemblies.

With the cubic contrast v = (c^(1/3) - a^(1/3))/(c^(1/3) + a^(1/3)) the normal force is a factor times
(1-v)^3 s + (1+v)^3 y. The six integrals that a density of rank two needs are then functions of v that polynomials of
moderate degree give to the last digit for all stress ratios from 1/3 to 3, whatever the fabric. Both cube roots come
from a polynomial start, a binomial series and one step of Newton's rule, without any division.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import sympy as sp

from derivations.batch_constant import (
    DENOMINATOR,
    DENSITY,
    SCALE,
    SUMS,
    Assignments,
    complement,
    component_assignments,
    density_assignments,
    domain,
    level,
    over_complement,
    square_assignments,
    sum_assignments,
)
from derivations.economised import economise, rationals
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.series import TruncatedSeries
from derivations.sphere import axial_mean, axial_moment
from derivations.symbols import D33, SR, STIFFNESS, Dr33, a, c, lam, latex, nu, one_minus_lam, s, v, y

THIRD = sp.Rational(1, 3)

LOW, HIGH = Fraction(-351, 1000), Fraction(291, 1000)
"""Range of v that the polynomials serve: a little more than the range of c/a below."""

RATIOS = (sp.Rational(1, 9), sp.Integer(6))
"""Range of c/a that is served: stress ratios from 1/3 to 3 with any fabric lie inside."""

PRECISION_BITS = 52
PRECISION = Fraction(1, 2**PRECISION_BITS)
"""What a polynomial may leave out, relative to its value: twice the rounding of a double. What it does leave out is far
less, for the bound counts every Chebyshev coefficient that is cut as if all of them met in one point."""

LENGTH = 56
"""Taylor terms to start from: what is beyond is below 2^-80."""

ROOT_RANGE = (sp.Rational(134, 1000), sp.Rational(3003, 1000))
"""A little more than the range of a and c where c/a is served: from 5/37 to 3."""

START = tuple(sp.Rational(number, 4096) for number in (4096, -976, 763, -1878, 1588, -400))
"""Start of the inverse cube root of x in powers of x - 1; it is exact at x = 1."""

START_ERROR = sp.Rational(7, 100)
"""Bound of 1 - x z^3 for this start z on the whole range."""

BINOMIAL_TERMS = 12
"""Terms of ((1 - r)^(-1/3) - 1)/r to start from."""

ROOT_PRECISION = Fraction(1, 2**25)
"""What may be left out of it: r makes that an error of 2^-28 of the root, and Newton's rule squares it."""

FORCE_INTEGRALS = sp.symbols("f0:6", positive=True)
"""DENOMINATOR times the integrals of s^(5-m) y^m ((1-v)^3 s + (1+v)^3 y)^(1/3)."""

third, pole_part, equator_part, forces = sp.symbols("third pole_part equator_part forces", positive=True)
root_a, root_c, roots, reciprocal = sp.symbols("root_a root_c roots reciprocal", positive=True)
over_roots, unit = sp.symbols("over_roots unit", positive=True)


@cache
def force_series(power: Fraction = Fraction(1, 3)) -> tuple[tuple[Fraction, ...], ...]:
    """A power of B = 1 + 3 z v + 3 v^2 + z v^3 in powers of v, each a polynomial in z = y - s; from B f' = q B' f."""
    rows: list[tuple[Fraction, ...]] = [(Fraction(1),)]
    for n in range(1, LENGTH):
        row = [Fraction(0)] * (n + 1)
        for back, shift, factor_ in ((1, 1, 3 * power - 3 * (n - 1)), (2, 0, 6 * power - 3 * (n - 2)),
                                     (3, 1, 3 * power - (n - 3))):
            if back <= n:
                for q, value in enumerate(rows[n - back]):
                    row[q + shift] += factor_ / n * value
        rows.append(tuple(row))
    return tuple(rows)


@cache
def taylor(m: int) -> tuple[Fraction, ...]:
    """Exact coefficients in v of DENOMINATOR times the m-th integral."""
    return tuple(DENOMINATOR * sum((value * contrast_moment(m, q) for q, value in enumerate(row) if value),
                                     Fraction(0)) for row in force_series())


@cache
def contrast_moment(m: int, q: int, degree: int = 5) -> Fraction:
    """Integral of s^(degree-m) y^m (y - s)^q over x from 0 to 1."""
    total = sum(((-1) ** (q - j) * sp.binomial(q, j) * axial_moment(degree - m + q - j, m + j) for j in range(q + 1)),
                sp.Integer(0))
    return Fraction(int(total.p), int(total.q))


@cache
def series(m: int) -> TruncatedSeries:
    """The m-th integral as a polynomial whose value at v = 0 is the integer of constant stiffness.

    The integrand is nowhere below 1 - |v| times that at v = 0, which bounds the value from below.
    """
    first, *others = taylor(m)
    reach = max(-LOW, HIGH)
    smallest = first * (1 - reach)
    coefficients, rest = economise(others, LOW, HIGH, PRECISION * smallest / reach)
    left_out = rest * reach / smallest
    return TruncatedSeries(f"CUBIC_{m}", rationals((first, *coefficients)), sp.Rational(351, 1000),
                           sp.Rational(left_out.numerator, left_out.denominator), v.name)


def binomial_terms() -> tuple[sp.Expr, ...]:
    """Exact coefficients of ((1 - r)^(-1/3) - 1)/r in powers of r."""
    return tuple((-1) ** k * sp.binomial(-THIRD, k) for k in range(1, BINOMIAL_TERMS + 1))


@cache
def root_series() -> tuple[TruncatedSeries, TruncatedSeries]:
    """The start of the inverse cube root, and the economised binomial series that improves it."""
    reach = Fraction(int(START_ERROR.p), int(START_ERROR.q))
    exact = [Fraction(int(term.p), int(term.q)) for term in binomial_terms()]
    kept, rest = economise(exact, -reach, reach, ROOT_PRECISION)
    beyond = abs(sp.binomial(-THIRD, BINOMIAL_TERMS + 1)) * START_ERROR**BINOMIAL_TERMS / (1 - START_ERROR)
    return (TruncatedSeries("START", START, sp.Rational(2), START_ERROR / 3, "x - 1"),
            TruncatedSeries("BINOMIAL", rationals(kept), START_ERROR, rationals([rest])[0] + beyond, "r"))


def root_assignments(of: sp.Symbol, root: sp.Symbol) -> Assignments:
    """Cube root of a number in ``ROOT_RANGE``, exact at 1; every name ends with the letter of the number."""
    polynomial = sp.Function("polynomial")
    less, start, squared, rest, gain, inverse, square, near = sp.symbols(
        " ".join(f"{name}_{of.name}" for name in ("less", "start", "squared", "rest", "gain", "inverse", "square",
                                                  "near")), real=True)
    first, binomial = root_series()
    return (
        (less, of - 1), (start, polynomial(sp.Symbol(first.name), less)), (squared, start * start),
        (rest, 1 - of * sp.Mul(start, squared, evaluate=False)),
        (gain, polynomial(sp.Symbol(binomial.name), rest)),
        (inverse, start + start * rest * gain), (square, inverse * inverse), (near, of * square),
        (root, near + third * square * sp.Add(of, -near**3)),
    )


def sums_of_forces() -> Assignments:
    """From the assembly to the sums of the normal stiffness, and to the ratio of the stiffnesses on the way."""
    polynomial = sp.Function("polynomial")
    return (
        (third, THIRD), (unit, sp.Rational(1, 2 * SCALE)),
        (equator_part, 5 + 2 * D33), (pole_part, SR * sp.Add(5, -D33)),
        (forces, 15 / (sp.Add(2, SR) * sp.Add(5, -D33) * equator_part)),
        (a, forces * equator_part), (c, forces * pole_part),
        *(one for pair in zip(root_assignments(a, root_a), root_assignments(c, root_c), strict=True) for one in pair),
        (complement, 2 - nu), (roots, root_a + root_c), (reciprocal, 1 / (roots * complement)),
        (over_roots, complement * reciprocal), (over_complement, roots * reciprocal),
        (one_minus_lam, nu * over_complement), (lam, 1 - one_minus_lam), (level, unit * roots),
        (v, (root_c - root_a) * over_roots),
        *((f, polynomial(sp.Symbol(series(m).name), v)) for m, f in enumerate(FORCE_INTEGRALS)),
        *density_assignments(FORCE_INTEGRALS, DENSITY), *square_assignments(level), *sum_assignments(SUMS, DENSITY),
    )


def kinetic_function() -> Function:
    """Emit the six components of one assembly."""
    return Function(
        "kinematic_kinetic",
        "Six components over (M/V) l_e^2 k_n,ref when the stiffness of a contact follows its force, without slip.",
        (D33, Dr33, SR, nu), (*sums_of_forces(), *component_assignments()), STIFFNESS, unit="-",
        series=(*root_series(), *(series(m) for m in range(6))),
        notes="Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.")


def served() -> tuple[sp.Rel, ...]:
    """Where the polynomials serve."""
    least, most = RATIOS
    return (*domain(), sp.Le(a, 1 / least * c), sp.Le(c, most * a))


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    return (BatchFunction(kinetic_function(), served(), level, (c, root_c, v, FORCE_INTEGRALS[-1])),)


def _crossings(bound: sp.Rational) -> int:
    """How often 1 - x z^3 reaches a bound on the range, for the start z: counted exactly."""
    x = sp.Symbol("x")
    start = sum(number * (x - 1) ** k for k, number in enumerate(START))
    return int(sp.Poly(sp.expand(1 - x * start**3 - bound), x).count_roots(*ROOT_RANGE))


def _direct_series(m: int, order: int) -> sp.Expr:
    """The first terms of an integral again, by the binomial series of (1 + w)^(1/3) with w = O(v)."""
    w = sp.expand(((1 - v) ** 3 * s + (1 + v) ** 3 * y).subs(s, 1 - y) - 1)
    power = sp.expand(sum(sp.binomial(THIRD, n) * w**n for n in range(order)))
    kept = sum(power.coeff(v, n) * v**n for n in range(order))
    return sp.expand(DENOMINATOR * axial_mean(sp.expand(kept) * s ** (5 - m) * y**m))


def steps() -> tuple[Step, ...]:
    """Show the cubic contrast, its polynomials and the cube roots."""
    contrast, order = (root_c - root_a) / (root_c + root_a), 4
    r, near, x = sp.symbols("r near x", positive=True)
    counts = ", ".join(str(len(series(m).coefficients) - 1) for m in range(6))
    return (
        Step("Cubic contrast, for very many assemblies",
             r"With $\bar g = \tfrac12(\sqrt[3]a + \sqrt[3]c)$ and the cubic contrast $\bar v$ the cube root of the "
             r"normal force is $\bar g$ times a function of $\bar v$ alone. Its integrals have no singularity that is "
             r"near: not at $\bar v = 1$, only a weak one at $\bar v = -1$.",
             (r"\bar v = \frac{\sqrt[3]c - \sqrt[3]a}{\sqrt[3]c + \sqrt[3]a},\qquad "
              r"a s + c y = \bar g^3\left[(1-\bar v)^3 s + (1+\bar v)^3 y\right]",),
             (Claim(sp.simplify(((root_a + root_c) / 2 * (1 - contrast)) ** 3), root_a**3),
              Claim(sp.simplify(((root_a + root_c) / 2 * (1 + contrast)) ** 3), root_c**3))),
        Step("Economised polynomials",
             "A density of rank two needs six integrals. Their exact Taylor polynomials are written in Chebyshev "
             r"polynomials of the range $1/9 \le c/a \le 6$ and cut where the rest is below "
             rf"$2^{{-{PRECISION_BITS}}}$ of the value, with the integers of constant stiffness kept at $\bar v = 0$. "
             rf"They have degree {counts}.",
             (r"F_m(\bar v) = " + f"{DENOMINATOR}" + r"\int_0^1 s^{5-m}x^{2m}"
              r"\left[(1-\bar v)^3 s + (1+\bar v)^3 x^2\right]^{1/3}\mathrm{d}x,\qquad F_m(0) = "
              + ",\\ ".join(str(series(m).coefficients[0]) for m in range(6)),),
             tuple(Claim(sum(sp.Rational(t.numerator, t.denominator) * v**n for n, t in enumerate(taylor(m)[:order])),
                         _direct_series(m, order)) for m in range(6))),
        Step("Cube roots without division",
             r"A polynomial $z$ in $x - 1$ approximates $x^{-1/3}$ so that $r = 1 - xz^3$ stays within "
             rf"${latex(START_ERROR)}$ on the range of the forces: exact counting finds no crossing of either bound. "
             r"The binomial series in $r$, economised on that range, then leaves an error below $2^{-28}$, and "
             r"Newton's rule for $x z^2$ squares it.",
             (r"x^{-1/3} = z\,(1-r)^{-1/3} = z\left(1 + \tfrac13 r + \tfrac29 r^2 + \dots\right)",),
             (Claim(sp.Integer(_crossings(START_ERROR)), sp.Integer(0)),
              Claim(sp.Integer(_crossings(-START_ERROR)), sp.Integer(0)),
              Claim(sp.series((1 - r) ** -THIRD, r, 0, 4).removeO(),
                    1 + r * sum(k * r**n for n, k in enumerate(binomial_terms()[:3]))),
              Claim(sp.simplify(near - (near**3 - x) / (3 * near**2) - (near + (x - near**3) / (3 * near**2))),
                    sp.Integer(0)))),
    )
