"""Components and their slopes for very many assemblies: the arithmetic of the batch kernels, with slopes carried along.

With equal contacts the slopes are those of the closed form of ``derivations.batch_constant``. With contact forces the
seven integrals with the power -2/3 of the force take the place of the six with the power 1/3 of
``derivations.batch_kinetic``: they are polynomials of the same cubic contrast, and give values and slopes.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache

import sympy as sp

from derivations.batch_constant import (
    DENOMINATOR,
    DENSITY,
    SCALE,
    SUMS,
    complement,
    component_assignments,
    density_assignments,
    domain,
    domain_of_fabric,
    fabric_assignments,
    level,
    over_complement,
    square_assignments,
    sum_assignments,
)
from derivations.batch_kinetic import (
    HIGH,
    LOW,
    PRECISION,
    contrast_moment,
    equator_part,
    force_series,
    forces,
    over_roots,
    pole_part,
    reciprocal,
    root_a,
    root_assignments,
    root_c,
    root_series,
    roots,
    served,
    third,
    unit,
)
from derivations.economised import economise, rationals
from derivations.forward import Assignments, Partials, slope_symbol, with_slopes
from derivations.gradients_kinematic import WEIGHTED
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.series import TruncatedSeries
from derivations.sphere import axial_mean
from derivations.symbols import D33, SR, STIFFNESS, Dr33, a, c, lam, mu, nu, one_minus_lam, s, v, y

POWER = Fraction(-2, 3)
DEGREE = 6

PARAMETERS = (D33, Dr33, SR, mu, nu)
"""What the slopes are by, in the order in which they are returned."""

INTEGRALS = sp.symbols("g0:7", positive=True)
"""DENOMINATOR times the integrals of s^(6-m) y^m ((1-v)^3 s + (1+v)^3 y)^(-2/3)."""

DENSITY_OF_FORCES = (*DENSITY, sp.Symbol("density5", nonnegative=True))
"""Integrals of 2 E with the power -2/3 of the force: one more than without forces."""

fifteenth, over_pole = sp.symbols("fifteenth over_pole", positive=True)


RATIO = ((one_minus_lam, nu * over_complement), (lam, 1 - one_minus_lam))
SLOPE_OF_RATIO = {nu: 2 * over_complement**2}
"""One minus the ratio of the stiffnesses, nu/(2 - nu), and how it goes with nu."""


def taylor(m: int) -> tuple[Fraction, ...]:
    """Exact coefficients in v of DENOMINATOR times the m-th integral."""
    return tuple(DENOMINATOR * sum((value * contrast_moment(m, q, DEGREE) for q, value in enumerate(row) if value),
                                   Fraction(0)) for row in force_series(POWER))


@cache
def series(m: int) -> TruncatedSeries:
    """The m-th integral as a polynomial; the integrand is nowhere below (1 + |v|)^-2 times that at v = 0."""
    exact, reach = taylor(m), max(-LOW, HIGH)
    smallest = exact[0] / (1 + reach) ** 2
    coefficients, rest = economise(exact, LOW, HIGH, PRECISION * smallest)
    left_out = rest / smallest
    return TruncatedSeries(f"SOFT_{m}", rationals(coefficients), sp.Rational(reach.numerator, reach.denominator),
                           sp.Rational(left_out.numerator, left_out.denominator), v.name)


def _closing(assignments: Assignments, arguments: tuple[sp.Symbol, ...],
             partials: Mapping[sp.Symbol, Partials]) -> tuple[Assignments, tuple[sp.Symbol, ...]]:
    """Carry the slopes along; those by what is no argument are zero."""
    carried = with_slopes(assignments, arguments, partials=partials)
    zeros = tuple((slope_symbol(component, variable), sp.Integer(0)) for variable in PARAMETERS
                  if variable not in arguments for component in STIFFNESS)
    returns = (*STIFFNESS, *(slope_symbol(component, variable) for variable in PARAMETERS for component in STIFFNESS))
    return (*carried, *zeros), returns


def constant_function() -> Function:
    """Emit components and slopes of one fabric whose contacts are all equally stiff."""
    assignments, returns = _closing(
        (*fabric_assignments(), *RATIO, *component_assignments()), (D33, Dr33, nu), {one_minus_lam: SLOPE_OF_RATIO})
    return Function(
        "constant_rows", "Six components over (M/V) l_e^2 k_n and their slopes, for contacts that are equally stiff.",
        (D33, Dr33, nu), ((complement, 2 - nu), (over_complement, 1 / complement), *assignments), returns, unit="-",
        notes="Slopes by D33, Dr33, SR, mu and nu, six each; those by SR and mu are zero.")


def kinetic_function() -> Function:
    """Emit components and slopes of one assembly whose contacts follow their force."""
    polynomial = sp.Function("polynomial")
    roots_of = (one for pair in zip(root_assignments(a, root_a), root_assignments(c, root_c), strict=True)
                for one in pair)
    before = (
        (third, sp.Rational(1, 3)), (fifteenth, sp.Rational(1, 15)), (unit, sp.Rational(4, SCALE)),
        (equator_part, 5 + 2 * D33), (pole_part, SR * sp.Add(5, -D33)),
        (forces, 15 / (sp.Add(2, SR) * sp.Add(5, -D33) * equator_part)),
        (a, forces * equator_part), (c, forces * pole_part), *roots_of,
        (complement, 2 - nu), (roots, root_a + root_c), (reciprocal, 1 / (roots * complement)),
        (over_roots, complement * reciprocal), (over_complement, roots * reciprocal),
        (level, unit * over_roots * over_roots), (v, (root_c - root_a) * over_roots),
        *((g, polynomial(sp.Symbol(series(m).name), v)) for m, g in enumerate(INTEGRALS)),
        (over_pole, forces * sp.Add(5, -D33)))
    moments = tuple((total, a * WEIGHTED[k] + c * WEIGHTED[k + 1]) for k, total in enumerate(SUMS))
    carried, returns = _closing(
        (*density_assignments(INTEGRALS, DENSITY_OF_FORCES), *square_assignments(level),
         *sum_assignments(WEIGHTED, DENSITY_OF_FORCES), *moments, *RATIO, *component_assignments()),
        (D33, Dr33, SR, nu), _partials())
    slopes_of_forces = tuple((slope_symbol(force, variable), value) for force, by in _force_slopes().items()
                             for variable, value in by.items())
    return Function(
        "kinetic_rows",
        "Six components over (M/V) l_e^2 k_n,ref and their slopes, when contacts follow their force without slip.",
        (D33, Dr33, SR, nu), (*before, *slopes_of_forces, *carried), returns, unit="-",
        series=(*root_series(), *(series(m) for m in range(DEGREE + 1))),
        notes="Slopes by D33, Dr33, SR, mu and nu, six each; those by mu are zero. Served for 1/9 <= c/a <= 6 with a "
              "and c the normal forces at equator and pole.")


def _force_slopes() -> dict[sp.Symbol, Partials]:
    """Slopes of the forces without a division: over_pole is c/SR."""
    across = fifteenth * sp.Add(2, SR)
    return {a: {D33: a * a * across, SR: -a * over_pole * (equator_part * fifteenth)},
            c: {D33: -2 * c * over_pole * across, SR: 2 * over_pole * over_pole * (equator_part * fifteenth)}}


def _partials() -> dict[sp.Symbol, Partials]:
    """How the moments follow forces and fabric, as in ``derivations.gradients_kinematic``, by slopes of the forces."""
    partials: dict[sp.Symbol, Partials] = {one_minus_lam: SLOPE_OF_RATIO}
    for k, total in enumerate(SUMS):
        S, following = WEIGHTED[k], WEIGHTED[k + 1]
        by_forces = {variable: third * (S * slope_symbol(a, variable) + following * slope_symbol(c, variable))
                     for variable in (D33, SR)}
        partials[total] = {S: a, following: c, **by_forces}
    return partials


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    return (BatchFunction(constant_function(), domain(), one_minus_lam, tested=domain_of_fabric()),
            BatchFunction(kinetic_function(), served(), level,
                          (c, root_c, v, INTEGRALS[-1], slope_symbol(c, SR), WEIGHTED[-1])))


def _direct_series(m: int, order: int) -> sp.Expr:
    """The first terms of an integral again, by the binomial series of (1 + w)^(-2/3) with w = O(v)."""
    w = sp.expand(((1 - v) ** 3 * s + (1 + v) ** 3 * y).subs(s, 1 - y) - 1)
    power = sp.expand(sum(sp.binomial(sp.Rational(-2, 3), n) * w**n for n in range(order)))
    kept = sum(power.coeff(v, n) * v**n for n in range(order))
    return sp.expand(DENOMINATOR * axial_mean(sp.expand(kept) * s ** (DEGREE - m) * y**m))


def step() -> Step:
    """Show the polynomials behind the slopes of very many assemblies."""
    counts = ", ".join(str(len(series(m).coefficients) - 1) for m in range(DEGREE + 1))
    forces_in = {forces: 15 / ((2 + SR) * (5 - D33) * (5 + 2 * D33)), equator_part: 5 + 2 * D33}
    whole = {a: forces_in[forces] * (5 + 2 * D33), c: forces_in[forces] * SR * (5 - D33),
             over_pole: forces_in[forces] * (5 - D33), fifteenth: sp.Rational(1, 15)}
    return Step(
        "Slopes of very many assemblies",
        r"In the cubic contrast $\bar v$ the seven integrals with the power $-\tfrac23$ are polynomials like those "
        rf"with the power $\tfrac13$, here of degree {counts}. The slopes of the forces need no division of their own.",
        (r"L_m = \bar g^{-2}\int_0^1 s^{6-m}x^{2m}\left[(1-\bar v)^3 s + (1+\bar v)^3 x^2\right]^{-2/3}\mathrm{d}x",),
        (*(Claim(sum(sp.Rational(t.numerator, t.denominator) * v**n for n, t in enumerate(taylor(m)[:4])),
                 _direct_series(m, 4)) for m in range(DEGREE + 1)),
         *(Claim(sp.cancel(value.subs(whole).subs(forces_in) - sp.diff(whole[force], variable)), sp.Integer(0))
           for force, by in _force_slopes().items() for variable, value in by.items())))
