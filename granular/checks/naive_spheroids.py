"""The obvious ways of computing aligned spheroids, each with the flaw that makes it fail.

Contacts of equal stiffness, kinematic hypothesis; see ``granular.checks.naive``.
"""

from __future__ import annotations

import math

from granular.checks.spheroid_digits import by_arc_tangent
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.result import Six
from granular.spheroid import squared_equator


def arc_tangent(fabric: AxialFabric, _loading: Loading | None, nu: float, _hypothesis: Hypothesis) -> Six:
    """The elementary form as it stands: each step of its recurrence divides by r^2 - 1; no number at r = 1."""
    try:
        return by_arc_tangent(fabric.aspect_ratio, D33=fabric.D33, poisson_ratio=nu)
    except ZeroDivisionError:
        return (math.nan,) * 6


def gauss_24(fabric: AxialFabric, _loading: Loading | None, nu: float, _hypothesis: Hypothesis) -> Six:
    """Gauss-Legendre rule with 24 nodes in x, which does not see where 1/(s + r^2 x^2) turns over."""
    import numpy as np

    from granular.directions import relative_density

    points, weights = np.polynomial.legendre.leggauss(24)
    x2, r2 = ((points + 1) / 2) ** 2, fabric.aspect_ratio**2
    s = 1 - x2
    weight = weights / 2 * relative_density(fabric, np.sqrt(x2)) / (s + r2 * x2)
    across, between, along = (float((weight * form).sum()) for form in (s * s, s * x2, x2 * x2))
    lam = 2 * (1 - nu) / (2 - nu)
    apart = 1 - lam
    c2323, c2332 = (apart * between + lam * (across + between)) / 2, r2 * apart * between / 2
    c3232 = r2**2 * (apart * between / 2 + lam * (between + along))
    shear = (c2323 + 2 * c2332 + c3232) / 4
    if fabric.free_spin:
        shear = (c2323 * c3232 - c2332**2) / (c2323 + c3232 - 2 * c2332)
    size = float(squared_equator(fabric.aspect_ratio))
    return (size * (3 * apart * across / 8 + lam * (across + between) / 2),
            size * r2**2 * (apart * along + lam * (between + along)), size * apart * across / 8, size * c2332,
            size * shear, size * (apart * across / 8 + lam * (across + between) / 4))
