"""Directions along the meridian with their weights, and what the fabric is in each of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from math import sqrt
from operator import mul, truediv
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.decimals import DIGITS, decimal
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric


LINEAR = Work(operations=7)
"""Of a factor p s + q y at one node, with what rounding took from p and q."""


@dataclass(frozen=True, slots=True)
class Directions:
    """Nodes of a rule for averages over 0 <= x <= 1.

    Attributes
    ----------
    sine_squared, cosine_squared : tuple of float, (n,)
        s = 1 - x^2 and x^2 at the nodes [-], each with full relative accuracy.
    measure : tuple of float, (n,)
        Weights [-].
    """

    sine_squared: tuple[float, ...]
    cosine_squared: tuple[float, ...]
    measure: tuple[float, ...]

    def __len__(self) -> int:
        """Count the nodes."""
        return len(self.measure)

    @classmethod
    def of_tangents(cls, nodes: Iterable[tuple[float, float]]) -> Directions:
        """Turn pairs of tan(beta) and d(log tan(beta)) into directions: dx = s sqrt(y) d(log tan(beta))."""
        rows = []
        for t, measure in nodes:
            if t <= 1:
                squared = t * t
                y = 1 / (1 + squared)
                s = squared * y
                root = sqrt(y)
            else:
                inverse = 1 / t
                squared = inverse * inverse
                s = 1 / (1 + squared)
                y = squared * s
                root = inverse * sqrt(s)
            rows.append((s, y, measure * s * root))
        sines, cosines, measures = zip(*rows, strict=True)
        return cls(sines, cosines, measures)

    def work_of_tangents(self) -> Work:
        """What :meth:`of_tangents` took; tan(beta) > 1 where s > y, and such a node takes two operations more."""
        far = sum(s > y for s, y in zip(self.sine_squared, self.cosine_squared, strict=True))
        return Work(operations=6, functions=1) * len(self) + Work(operations=2) * far

    def density(self, fabric: AxialFabric) -> list[float]:
        """4 pi E at the nodes [-], as a sum of positive terms whatever the fabric.

        Where a rank-four part makes the middle coefficient negative, the density is written as
        (sqrt(e0) s - sqrt(e2) y)^2 + (e1 + 2 sqrt(e0 e2)) s y: what rounding does to the difference is felt only as
        much as the difference is.
        """
        e0, e1, e2 = fabric.density_coefficients()
        if fabric.D3333 == 0:
            return _linear(e0, e2, self)
        if e1 >= 0:
            first = _linear(e0, e1, self)
            last = _linear(Fraction(0), e2, self)
            return [s * one + y * other for s, y, one, other in zip(
                self.sine_squared, self.cosine_squared, first, last, strict=True)]
        with localcontext(DIGITS):
            root0, root2 = decimal(e0).sqrt(), decimal(e2).sqrt()
            left = float(max(decimal(e1) + 2 * root0 * root2, Decimal(0)))
            apart = _linear(Fraction(root0), -Fraction(root2), self)
        return [part * part + left * s * y for part, s, y in zip(
            apart, self.sine_squared, self.cosine_squared, strict=True)]

    def weight(self, fabric: AxialFabric, hypothesis: Hypothesis) -> list[float]:
        """Density times the share of the branches, times the measure, at the nodes [-].

        The share is W^2 (kinematic) or W^-2 (static) for branches along the contact normals. For spheroids, with
        Q = s + r^2 y: 1/Q, which leaves the branch vector (n1, n2, r^2 n3), or Q/(s + r^4 y), the inverse square of
        its length; both over (2a)^2.
        """
        density = map(mul, self.density(fabric), self.measure)
        if not fabric.collinear:
            return self._spheroid_weight(fabric, hypothesis, density)
        branch = _linear(1 - Fraction(fabric.Dr33) / 2, 1 + Fraction(fabric.Dr33), self)
        squares = map(mul, branch, branch)
        combine = mul if hypothesis is Hypothesis.KINEMATIC else truediv
        return list(map(combine, density, squares))

    def _spheroid_weight(self, fabric: AxialFabric, hypothesis: Hypothesis, density: Iterable[float]) -> list[float]:
        squared = Fraction(fabric.aspect_ratio) ** 2
        height = _linear(Fraction(1), squared, self)
        if hypothesis is Hypothesis.KINEMATIC:
            return list(map(truediv, density, height))
        length = _linear(Fraction(1), squared**2, self)
        return [e * q / t for e, q, t in zip(density, height, length, strict=True)]

    def work_of_weight(self, fabric: AxialFabric, hypothesis: Hypothesis) -> Work:
        """What :meth:`weight` takes."""
        if fabric.collinear:
            share = LINEAR + Work(2)
        else:
            share = LINEAR + Work(1) if hypothesis is Hypothesis.KINEMATIC else LINEAR * 2 + Work(2)
        return (self._work_of_density(fabric) + Work(1) + share) * len(self)

    def _work_of_density(self, fabric: AxialFabric) -> Work:
        if fabric.D3333 == 0:
            return LINEAR
        return LINEAR * 2 + Work(3) if fabric.density_coefficients()[1] >= 0 else LINEAR + Work(4)

    def work_of_balance(self, fabric: AxialFabric) -> Work:
        """What :meth:`balance` takes."""
        return (self._work_of_density(fabric) + LINEAR + Work(2, 1)) * len(self)

    def balance(self, fabric: AxialFabric) -> list[float]:
        """Density over sqrt(s + r^4 y), times the measure, at the nodes [-].

        Its moments with s and y make up the mean of n^l_i n_k over the contacts, n^l along the branch of a spheroid.
        """
        length = _linear(Fraction(1), Fraction(fabric.aspect_ratio) ** 4, self)
        return [e * m / sqrt(t) for e, m, t in zip(self.density(fabric), self.measure, length, strict=True)]


def _linear(equator: Fraction, pole: Fraction, nodes: Directions) -> list[float]:
    """Equator s + pole y; what rounding takes from the two, which would shift all nodes alike, is put back."""
    first, second = float(equator), float(pole)
    rest, other = float(equator - Fraction(first)), float(pole - Fraction(second))
    return [first * s + (second * y + (rest * s + other * y))
            for s, y in zip(nodes.sine_squared, nodes.cosine_squared, strict=True)]
