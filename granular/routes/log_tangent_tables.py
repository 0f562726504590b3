"""Nodes of the trapezoidal rule on a whole line, tabulated: they hurry off once no singularity is near any more.

Along the mapped line v the integrands die off like exp(-2 v), so that a uniform rule spends most of its nodes on
tails. Beyond the last singularity, at ``start``, the nodes run away from each other: v = w + 2 exp(-start) sinh(w)
for nodes w = (j + 1/2) step. The map is analytic and nearly the identity as far as singularities reach, and doubles
exponentially beyond. Exponentials are products of tabulated ones, so that long tables are as good as short ones.
"""

from __future__ import annotations

import math
from functools import lru_cache

from granular.routes.fineness import FULL, Fineness

STEPS = FULL.steps
"""Nodes for each unit of w when nothing but rounding may be left."""

STEP = 1 / STEPS

LONGEST = 256
"""Length of the longest table in units of w; no scene of doubles comes near it."""

STEADY = LONGEST
"""A start that no node reaches: the nodes stay equally spaced."""

ROOM = 3.0
"""Distance that nodes keep to the last singularity before they hurry: the strip is narrowed by a twentieth there."""

EDGE = 2.0
"""Where nodes begin to hurry towards the edge of a sliding range, on the logarithmic scale that magnifies it."""

NEAREST = 25.0
"""How near nodes come to the edge of a sliding range, -v, when nothing but rounding may be left: exp(2 v) is left."""

FARTHEST = {"hyperbolic": 210.0, "one_sided": 150.0}
"""How far nodes may run ahead before a table ends: beyond every range, and short of an overflow in any map."""


@lru_cache(maxsize=32)
def exponentials(steps: int = STEPS) -> tuple[float, ...]:
    """Exponentials exp((j + 1/2) step), j = 0, 1, ..., each to three units in the last place.

    Parameters
    ----------
    steps : int
        Nodes for each unit of w [-].

    Returns
    -------
    tuple of float
        The table [-]; whole and fractional part are raised separately, so that a long table stays as good.
    """
    fractions = [math.exp((j + 0.5) / steps) for j in range(steps)]
    return tuple(math.exp(whole) * fraction for whole in range(LONGEST) for fraction in fractions)


def exponential(j: int, steps: int = STEPS) -> float:
    """Return exp((j + 1/2) step) [-] for a node number of either sign."""
    table = exponentials(steps)
    return table[j] if j >= 0 else 1 / table[-1 - j]


def start_after(singular: float) -> int:
    """Where nodes may begin to hurry [units of w], for a last singularity at ``singular`` [units of v]."""
    return STEADY if singular > STEADY - ROOM else max(math.ceil(singular + ROOM), 2)


def reached(v: float, start: int) -> float:
    """Value of w at which the nodes have passed v, or a little more; of either sign [-]."""
    return math.copysign(min(abs(v), start + math.log1p(abs(v))), v)


@lru_cache(maxsize=512)
def hyperbolic(start: int, steps: int = STEPS) -> tuple[tuple[float, float], ...]:
    """sinh(v) and cosh(v) dv/dw at the nodes with j = 0, 1, ...; the other half is its mirror image.

    Parameters
    ----------
    start : int
        Where nodes begin to hurry [units of w].
    steps : int
        Nodes for each unit of w [-].

    Returns
    -------
    tuple of (float, float)
        The two numbers at each node [-].
    """
    small, rows = math.exp(-start), []
    for j, grown in enumerate(exponentials(steps)):
        extra = small * (grown - 1 / grown)
        if extra > FARTHEST["hyperbolic"]:
            break
        v, whole = (j + 0.5) / steps + extra, grown * math.exp(extra)
        rows.append((math.sinh(v) if v < 1 else (whole - 1 / whole) / 2,
                     (whole + 1 / whole) / 2 * (1 + small * (grown + 1 / grown))))
    return tuple(rows)


@lru_cache(maxsize=64)
def first_node(fineness: Fineness = FULL, nearest: float = NEAREST) -> int:
    """Number of the first node towards the edge of a sliding range, where w - exp(-w - EDGE) = -nearest [-]."""
    reach = nearest * fineness.share
    w = -math.log(reach + 1)
    for _ in range(20):
        w = -EDGE - math.log(max(w + reach, 0.1))
    return math.floor(w * fineness.steps)


@lru_cache(maxsize=512)
def one_sided(start: int, fineness: Fineness = FULL, nearest: float = NEAREST) -> tuple[tuple[float, float], ...]:
    """exp(v) and dv/dw at the nodes from the first on, for v = w + exp(w - start) - exp(-w - EDGE).

    Parameters
    ----------
    start : int
        Where nodes begin to hurry outwards [units of w].
    fineness : Fineness
        Nodes for each unit of w, and the share of ``nearest`` that is used.
    nearest : float
        How near to the edge nodes come, -v [-].

    Returns
    -------
    tuple of (float, float)
        The two numbers at each node, the first of them number ``first_node(fineness, nearest)`` [-].
    """
    small, rows = math.exp(-start), []
    for j in range(first_node(fineness, nearest), LONGEST * fineness.steps):
        grown = exponential(j, fineness.steps)
        outwards, inwards = small * grown, math.exp(-EDGE) / grown
        if outwards > FARTHEST["one_sided"]:
            break
        rows.append((grown * math.exp(outwards - inwards), 1 + outwards + inwards))
    return tuple(rows)
