"""Random admissible fabrics, with much weight on the boundary."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator

from granular.errors import FabricOutOfRange
from granular.fabric import AxialFabric

SHRINK = 1 - 2.0**-50
"""A fabric on the edge of its region leaves it by rounding; this factor on D33 and D3333 brings it back, because the
region is convex and holds the isotropic fabric."""


def admissible_sample(count: int, *, seed: int) -> Iterator[tuple[AxialFabric, float]]:
    """Draw fabrics and Poisson's ratios.

    Parameters
    ----------
    count : int
        How many [-].
    seed : int
        Start of the random numbers; the same seed gives the same sample.

    Returns
    -------
    iterator of (AxialFabric, float)
        Fabric [-] and Poisson's ratio [-]. Half of the fabrics have a density of rank two, half of rank four. D33 and
        Dr33 come to within one rounding of the ends of their intervals, E of rank four touches zero between pole and
        equator, and Poisson's ratio is 0, 1/2, or tiny in half of the draws.

    Notes
    -----
    Accuracy: every fabric is admissible exactly. Source: the admissible region of eq. (14).

    Examples
    --------
    >>> sum(1 for _ in admissible_sample(5, seed=1))
    5
    """
    rng = random.Random(seed)
    for _ in range(count):
        d33, d3333 = (_near_an_end(rng, -1.0, 2.0), 0.0) if rng.random() < 0.5 else _rank_four(rng)
        dr33 = min(max(_near_an_end(rng, -1.0, 2.0), math.nextafter(-1.0, 0.0)), math.nextafter(2.0, 0.0))
        nu = rng.choice((0.0, 0.5, math.exp2(rng.uniform(-60, -2)), *(rng.uniform(0, 0.5) for _ in range(3))))
        yield _inside(d33, d3333, dr33), nu


def _near_an_end(rng: random.Random, low: float, high: float) -> float:
    """Half of the time uniform, otherwise at an end or at any scale of distance from it."""
    kind = rng.random()
    distance = (high - low) * math.exp2(rng.uniform(-55, -1))
    if kind < 0.5:
        return rng.uniform(low, high)
    if kind < 0.6:
        return rng.choice((low, high))
    return low + distance if kind < 0.8 else high - distance


def _rank_four(rng: random.Random) -> tuple[float, float]:
    """A density (a s - b x^2)^2 + g s x^2 of mean 1, which touches zero where g = 0."""
    root = math.exp2(rng.uniform(-30, 30)) if rng.random() < 0.5 else rng.random()
    lift = 0.0 if rng.random() < 0.6 else 4 * rng.random()
    equator, between, pole = root**2, lift - 2 * root, 1.0
    mean = (8 * equator + 2 * between + 3 * pole) / 15
    equator, pole = equator / mean, pole / mean
    d3333 = (equator + pole / 2 - 1.5) * 8 / 7
    return pole - 1 - d3333, d3333


def _inside(d33: float, d3333: float, dr33: float) -> AxialFabric:
    while True:
        try:
            return AxialFabric(D33=d33, D3333=d3333, Dr33=dr33)
        except FabricOutOfRange:
            d33, d3333 = d33 * SHRINK, d3333 * SHRINK
