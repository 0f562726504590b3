"""From a fourth-rank sum over contacts to six components, each linear in three moments of the weight."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from derivations.sphere import azimuth_mean, homogeneous, meridian_form
from derivations.symbols import POSITIVE_MOMENTS

INDICES = ((1, 1, 1, 1), (3, 3, 3, 3), (1, 1, 2, 2), (1, 1, 3, 3), (2, 3, 2, 3), (1, 2, 1, 2))
"""The six components of a transversely isotropic tensor, in the order used everywhere."""

Entry = Callable[[int, int, int, int], sp.Expr]


def minor_symmetrised(entry: Entry, i: int, j: int, k: int, m: int) -> sp.Expr:
    """Mean over the exchange of indices inside each pair: what a symmetric strain (or stress) meets."""
    return (entry(i, j, k, m) + entry(j, i, k, m) + entry(i, j, m, k) + entry(j, i, m, k)) / 4


def six_components(entry: Entry) -> tuple[sp.Expr, ...]:
    """Average a tensor over the azimuth and write each of its six components in the positive moments.

    Parameters
    ----------
    entry : callable
        ``entry(i, j, k, l)`` with indices 0, 1, 2: the tensor of one contact direction, a quadratic form in s and y
        once the azimuth is gone; the weight of the direction is left out.

    Returns
    -------
    tuple of 6 sympy.Expr
        In the order of :data:`INDICES`, linear in p0 = <rho s^2>, p1 = <rho s y>, p2 = <rho y^2>.
    """
    components = []
    for i, j, k, m in INDICES:
        form = meridian_form(azimuth_mean(minor_symmetrised(entry, i - 1, j - 1, k - 1, m - 1)))
        weights = homogeneous(form, 2)
        components.append(sp.expand(sum(a * p for a, p in zip(weights, POSITIVE_MOMENTS, strict=True))))
    return tuple(components)
