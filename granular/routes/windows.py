"""How far along log(tan(beta)) directions matter, and where the integrand has its singularities there."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.fabric import AxialFabric

POLE, EQUATOR = -21.0, 41.0
"""log(tan(beta)) beyond which 2^-60 of a moment is left: contacts thin out like tan(beta)^2 towards the pole and like
1/tan(beta) towards the equator."""

POLE_INVERSE, EQUATOR_INVERSE = -32.0, 123.0
"""The same where the inverse of a vanishing normal force lets moments grow by tan(beta)^(2/3) on the way."""

POLE_SLIP, EQUATOR_SLIP = -26.0, 62.0
"""The same for what slip takes from the shear stiffness, which may grow by tan(beta) where the force vanishes like
tan(beta)^(2/3), on the way to a direction of vanishing force."""


def window(branches: list[float], a: Fraction, c: Fraction, hypothesis: Hypothesis, *, slips: bool,
           share: float = 1.0) -> tuple[float, float]:
    """Range of log(tan(beta)) that matters, in whole units.

    Parameters
    ----------
    branches : list of float
        log(tan(beta)) of the singularities of directions and branches [-].
    a, c : Fraction
        Normal force at the equator and at the pole up to a common factor [-].
    hypothesis : Hypothesis
        Kinematic or static.
    slips : bool
        Whether friction takes anything from the shear stiffness.
    share : float
        Length of the window over that which leaves 2^-60 of a moment outside [-].

    Returns
    -------
    tuple of 2 float
        Towards the pole and towards the equator.
    """
    first, last = min(branches), max(branches)
    if hypothesis is Hypothesis.KINEMATIC:
        low, high = (POLE_SLIP, EQUATOR_SLIP) if slips else (POLE, EQUATOR)
        return math.floor(share * low + first), math.ceil(share * high + last)
    forces = place_of_forces(a, c)
    if slips:
        return math.floor(share * POLE + min(forces, first)), math.ceil(share * EQUATOR + max(forces, last))
    low = max(share * POLE_INVERSE, share * POLE + min(0.0, forces))
    high = min(share * EQUATOR_INVERSE, share * EQUATOR + max(0.0, forces))
    return math.floor(low + first), math.ceil(high + last)


def place_of_forces(a: Fraction, c: Fraction) -> float:
    """log(tan(beta)) at which the normal force has its singularity."""
    if a > 0 and c > 0:
        return (math.log(c) - math.log(a)) / 2
    return math.inf if c > a else -math.inf


def places_of_branches(fabric: AxialFabric, hypothesis: Hypothesis) -> list[float]:
    """log(tan(beta)) at which the directions and the branches have their singularities, where they have any."""
    if not fabric.collinear:  # s + r^2 y in a denominator; s + r^4 y there and under a root
        shape = math.log(fabric.aspect_ratio)
        return [0.0, shape] if hypothesis is Hypothesis.KINEMATIC else [0.0, 2 * shape]
    if hypothesis is Hypothesis.KINEMATIC:
        return [0.0]
    return [0.0, (math.log(1 + fabric.Dr33) - math.log(1 - fabric.Dr33 / 2)) / 2]
