"""The static hypothesis with constant contact stiffness as it is evaluated for very many fabrics.

With the quartic contrast v = (u - 1)/(u + 1), u = (w1/w0)^(1/4), the branch-length weight is a factor times
(1-v)^4 s + (1+v)^4 y. A density of rank two needs four integrals of 1/W^2. Powers of 1 - v and 1 + v taken out of them
leave functions that polynomials of moderate degree give to the last digit as long as branch lengths at pole and equator
are within a factor 9. Three divisions are left in the components.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import sympy as sp

from derivations.batch_constant import domain
from derivations.economised import economise, rationals
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.series import TruncatedSeries, power_of_one_plus, product
from derivations.sphere import axial_mean, axial_moment
from derivations.symbols import D33, STIFFNESS, Dr33, e0, e1, nu, p0, p1, p2, s, v, w0, w1, y

LOW, HIGH = Fraction(-268, 1000), Fraction(268, 1000)
"""Range of v that the polynomials serve: a little more than 1/9 <= w1/w0 <= 9."""

LARGEST_RATIO = 9
PRECISION = Fraction(1, 2**55)
"""What a polynomial may leave out, relative to its value: a quarter of the rounding of a double."""

LENGTH = 48
"""Taylor terms to start from: what is beyond is below 2^-80."""

DENOMINATOR = 105
"""Common denominator of the integrals of s^(3-m) y^m."""

CLEARED = ((6, 0), (2, 0), (0, 0), (0, 4))
"""Powers of 1 - v and 1 + v that are taken out of the four integrals."""

BRANCH_INTEGRALS = sp.symbols("h0:4", positive=True)

whole_ratio, square_root, root, plus = sp.symbols("ratio square_root root plus", positive=True)
spread, inverse_spread, inverse_ratio, mean_length = sp.symbols(
    "spread inverse_spread inverse_ratio mean_length", positive=True)
lower, upper = sp.symbols("fifteen_N11 fifteen_N33", positive=True)
bulk, shear, vertical, sums = sp.symbols("bulk shear vertical sums", positive=True)
mixed, over_bulk, over_shear, gate = sp.symbols("mixed over_bulk over_shear gate", nonnegative=True)
complement, share = sp.symbols("complement share", positive=True)


@cache
def _weight_series() -> tuple[tuple[Fraction, ...], ...]:
    """1/B^2, B = 1 + 4 z v + 6 v^2 + 4 z v^3 + v^4, in powers of v and of z = y - s; from B f' = -2 B' f."""
    rows: list[tuple[Fraction, ...]] = [(Fraction(1),)]
    for n in range(1, LENGTH):
        row = [Fraction(0)] * (n + 1)
        for back in range(1, min(n, 4) + 1):
            for q, value in enumerate(rows[n - back]):
                row[q + back % 2] += Fraction(-(n + back) * int(sp.binomial(4, back)), n) * value
        rows.append(tuple(row))
    return tuple(rows)


@cache
def taylor(m: int) -> tuple[Fraction, ...]:
    """Exact coefficients in v of DENOMINATOR times the m-th integral of s^(3-m) y^m/B^2, its powers taken out."""
    def moment(q: int) -> sp.Rational:
        return sum(((-1) ** (q - j) * sp.binomial(q, j) * axial_moment(3 - m + q - j, m + j) for j in range(q + 1)),
                   sp.Integer(0))

    moments = [moment(q) for q in range(LENGTH)]
    plain = [DENOMINATOR * sum((sp.Rational(value.numerator, value.denominator) * moments[q]
                                for q, value in enumerate(row) if value), sp.Integer(0)) for row in _weight_series()]
    minus_power, plus_power = CLEARED[m]
    cleared = product(product(plain, power_of_one_plus(minus_power, -1, LENGTH)),
                      power_of_one_plus(plus_power, 1, LENGTH))
    return tuple(Fraction(int(c.p), int(c.q)) for c in cleared)


@cache
def series(m: int) -> TruncatedSeries:
    """The m-th integral as a polynomial whose value at v = 0 is an integer, half its least value as the measure."""
    first, *others = taylor(m)
    points = [LOW + (HIGH - LOW) * Fraction(k, 20) for k in range(21)]
    smallest = min(sum((c * point**n for n, c in enumerate(taylor(m))), Fraction(0)) for point in points) / 2
    coefficients, rest = economise(others, LOW, HIGH, PRECISION * smallest / HIGH)
    left_out = rest * HIGH / smallest
    return TruncatedSeries(f"QUARTIC_{m}", rationals((first, *coefficients)), sp.Rational(268, 1000),
                           sp.Rational(left_out.numerator, left_out.denominator), v.name)


def component_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """From the three moments to the components: the positive form with lambda = share/complement cleared."""
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    m, k = complement, share
    return (
        (sums, p1 + p2), (mixed, nu * p1),
        (bulk, k * p0 * p2 + mixed * p1 + m * p1 * sp.Add(p0, sums)),
        (shear, p0 * sp.Add(k, m) + 2 * m * p1),
        (vertical, lower**2 * sp.Add(k * p1, m * sp.Add(sums, p2)) + upper**2 * sp.Add(k * p1, m * p0)
         - 2 * mixed * lower * upper),
        (over_bulk, gate / bulk), (over_shear, 1 / shear),
        (c1212, 2 * lower**2 * k * gate * over_shear),
        (c1122, lower**2 * over_bulk * over_shear * sp.Mul(nu, sp.Add(k * p0 * sums, mixed * sp.Add(p0, 2 * p1)))),
        (c1111, c1122 + 2 * c1212),
        (c3333, upper**2 * over_bulk * sp.Add(k * p0, m * p1)),
        (c1133, lower * upper * mixed * over_bulk),
        (c2323, 2 * lower**2 * upper**2 * k * gate / vertical),
    )


def static_function() -> Function:
    """Emit the six components of one fabric."""
    polynomial = sp.Function("polynomial")
    tables = tuple(series(m) for m in range(4))
    h0, h1, h2, h3 = BRANCH_INTEGRALS
    moments = sp.symbols("moment0:4", positive=True)
    return Function(
        "static_constant", "Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.",
        (D33, Dr33, nu),
        ((w0, 2 - Dr33), (w1, 2 + 2 * Dr33), (whole_ratio, w1 / w0), (square_root, sp.sqrt(whole_ratio)),
         (root, sp.sqrt(square_root)),
         (plus, 1 + root), (v, (root - 1) / plus),
         (spread, sp.Add(plus + root, square_root) / 4), (inverse_spread, 1 / spread), (inverse_ratio, w0 / w1),
         (mean_length, w0 * spread),
         *((h, polynomial(sp.Symbol(table.name), v)) for h, table in zip(BRANCH_INTEGRALS, tables, strict=True)),
         (e0, 2 - D33), (e1, 2 + 2 * D33), (complement, 2 - nu), (share, 2 - 2 * nu),
         (lower, 5 - D33), (upper, 5 + 2 * D33),
         (moments[0], h0 * spread), (moments[1], h1 * inverse_spread),
         (moments[2], h2 * inverse_spread * inverse_spread), (moments[3], h3 * inverse_ratio),
         (p0, e0 * moments[0] + e1 * moments[1]), (p1, e0 * moments[1] + e1 * moments[2]),
         (p2, e0 * moments[2] + e1 * moments[3]),
         (gate, 7 * mean_length * mean_length / 30), *component_assignments()),
        STIFFNESS, unit="-", series=tables, notes="Served for branch lengths at pole and equator within a factor 9.")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    near = (sp.Le(w1, LARGEST_RATIO * w0), sp.Le(w0, LARGEST_RATIO * w1))
    return (BatchFunction(static_function(), (*domain(), *near), gate, (mean_length, BRANCH_INTEGRALS[-1])),)


def _direct_series(m: int, order: int) -> sp.Expr:
    """The first terms of an integral again, by the binomial series of (1 + w)^(-2) with w = O(v)."""
    w = sp.expand(((1 - v) ** 4 * s + (1 + v) ** 4 * y).subs(s, 1 - y) - 1)
    minus_power, plus_power = CLEARED[m]
    power = sp.expand(sum(sp.binomial(-2, n) * w**n for n in range(order)) * (1 - v) ** minus_power
                      * (1 + v) ** plus_power)
    kept = sum(power.coeff(v, n) * v**n for n in range(order))
    return sp.expand(DENOMINATOR * axial_mean(sp.expand(kept) * s ** (3 - m) * y**m))


def steps(components: tuple[sp.Expr, ...]) -> tuple[Step, ...]:
    """Show the quartic contrast, its polynomials and the components; these are given in moments, D33 and nu."""
    contrast, order = (root - 1) / (root + 1), 4
    counts = ", ".join(str(len(series(m).coefficients) - 1) for m in range(4))
    known: dict[sp.Symbol, sp.Expr] = {complement: 2 - nu, share: 2 - 2 * nu, lower: 5 - D33, upper: 5 + 2 * D33,
                                       gate: sp.Rational(1, 225)}
    for symbol, expression in component_assignments():
        known[symbol] = expression.xreplace(known)
    return (
        Step("Quartic contrast, for very many fabrics",
             r"With $u = (w_1/w_0)^{1/4}$ and the contrast $\bar v = (u-1)/(u+1)$ the ends of a branch-length weight "
             r"are fourth powers, and the integrals have no singularity that is near once powers of $1 - \bar v$ and "
             r"$1 + \bar v$ are taken out of them.",
             (r"w_0 = \bar g\,(1-\bar v)^4,\quad w_1 = \bar g\,(1+\bar v)^4,\qquad "
              r"\bar g = w_0\left(\frac{1+u}{2}\right)^4",),
             (Claim(sp.simplify(((1 + root) / 2 * (1 - contrast)) ** 4), sp.Integer(1)),
              Claim(sp.simplify(((1 + root) / 2 * (1 + contrast)) ** 4), root**4),
              Claim(sp.simplify(1 / (1 + contrast)), (1 + root) / (2 * root)))),
        Step("Economised polynomials",
             "A density of rank two needs four integrals. They are economised on $1/9 \\le w_1/w_0 \\le 9$ and cut "
             rf"where the rest is below $2^{{-55}}$ of the value; they have degree {counts}.",
             (r"H_m = \frac{1}{\bar g^2}\int_0^1\frac{s^{3-m}x^{2m}}"
              r"{\left[(1-\bar v)^4 s + (1+\bar v)^4 x^2\right]^2}\,\mathrm{d}x",),
             tuple(Claim(sum(sp.Rational(t.numerator, t.denominator) * v**n for n, t in enumerate(taylor(m)[:order])),
                         _direct_series(m, order)) for m in range(4))),
        Step("Components with three divisions",
             r"$\lambda$ and $\bar\lambda$ have the divisor $2 - \nu$, which cancels; the three sums below are divided "
             "by.",
             (r"(2-\nu)\,\Delta,\qquad (2-\nu)\,\Sigma,\qquad 8\,(2-\nu)\,(15 N_{11})^2(15 N_{33})^2 S_{2323}/225",),
             tuple(Claim(sp.cancel(sp.together(known[symbol] - expression)), sp.Integer(0))
                   for symbol, expression in zip(STIFFNESS, components, strict=True))),
    )
