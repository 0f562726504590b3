"""Harmonic parts of polynomials on the sphere, and products of harmonic tensors by contraction."""

from __future__ import annotations

from functools import cache
from itertools import product

import sympy as sp

N = sp.symbols("n1:4", real=True)
"""Components of a direction, of length one where it matters."""


def radius_squared() -> sp.Poly:
    """Squared length of the direction."""
    return sp.Poly(sum(c**2 for c in N), *N)


def laplacian(form: sp.Poly) -> sp.Poly:
    """Sum of the second derivatives."""
    return sum((form.diff((c, 2)) for c in N), sp.Poly(0, *N))


def harmonic(form: sp.Poly, degree: int) -> sp.Poly:
    """The part of a form of this degree that a Laplacian makes vanish: its traceless part."""
    total, traced, factor = form, form, sp.Integer(1)
    radius = radius_squared()
    for j in range(1, degree // 2 + 1):
        traced = laplacian(traced)
        factor *= sp.Rational(-1, 2 * j * (2 * degree - 2 * j + 1))
        total += factor * radius**j * traced
    return total


def harmonic_part(form: sp.Poly, degree: int, order: int) -> sp.Poly:
    """The harmonic of one order in a form: on the sphere the form is the sum of these."""
    traced = form
    for j in range(1, (degree - order) // 2 + 1):
        traced = laplacian(traced) * sp.Rational(1, 2 * j * (2 * order + 2 * j + 1))
    return harmonic(traced, order)


def of_direction(direction: tuple[sp.Expr, sp.Expr, sp.Expr], degree: int) -> sp.Poly:
    """Traceless part of (direction . n)^degree; such forms span all harmonics of the degree."""
    return harmonic(sp.Poly(sum(d * c for d, c in zip(direction, N, strict=True)), *N) ** degree, degree)


def contracted(first: sp.Poly, second: sp.Poly, times: int) -> sp.Poly:
    """Form of the tensor A_..ab.. B_..ab.. with this number of common indices, made symmetric.

    The tensor of a form of degree d is its d-th derivative over d!.
    """
    total = sp.Poly(0, *N)
    for indices in product(N, repeat=times):
        left, right = first, second
        for c in indices:
            left, right = left.diff(c), right.diff(c)
        total += left * right
    ratio = sp.Integer(1)
    for form in (first, second):
        degree = form.total_degree()
        ratio *= sp.Rational(sp.factorial(degree - times), sp.factorial(degree))
    return total * ratio


PRODUCT = {
    (2, 2, 0): sp.Rational(2, 15), (2, 2, 2): sp.Rational(4, 7), (2, 2, 4): sp.Integer(1),
    (2, 4, 2): sp.Rational(4, 21), (2, 4, 4): sp.Rational(8, 11),
    (4, 4, 0): sp.Rational(8, 315), (4, 4, 2): sp.Rational(32, 231), (4, 4, 4): sp.Rational(72, 143),
}
"""For two harmonics of orders l and m, the factor of their contraction in the part of order k of their product."""


@cache
def product_parts(first: int, second: int, order: int) -> tuple[sp.Expr, sp.Expr]:
    """Part of one order of a product of two harmonics, and the contraction that it is said to be.

    Both sides are bilinear and turn with the axes, and powers of directions span all harmonics, so that two
    directions in one plane stand for any two tensors.
    """
    u, v = sp.symbols("u v", real=True)
    one, other = of_direction((sp.S.Zero, sp.S.Zero, sp.S.One), first), of_direction((u, sp.S.Zero, v), second)
    part = harmonic_part(one * other, first + second, order)
    tensor = contracted(one, other, (first + second - order) // 2)
    return part.as_expr(), (PRODUCT[first, second, order] * harmonic(tensor, order)).as_expr()
