"""How the stiffness comes near its limits with contact forces: the distance left against the distance to go."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.figures.look import BLUE, GREEN, ORANGE, VERMILION, blank, house_style, readable, spread
from granular.loading import Loading
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from fractions import Fraction

    from matplotlib.figure import Figure

COMPONENT = "C2323"
"""The component shown: it feels the normal and the shear stiffness of all contacts."""

STEPS = tuple(2.0**-k for k in range(3, 28, 3))
"""Distances from the limit [-], from an eighth down to 1e-8; powers of two, which a stress ratio takes up exactly."""

ONSET = (4.0, 0.75)
"""Stress ratio and friction coefficient exactly at the onset of sliding: 4 a c mu^2 = (c - a)^2 [-]."""


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit, and the way to it.

    Attributes
    ----------
    name : str
        What goes where.
    at : Loading
        Stress and friction in the limit.
    near : callable
        From a distance [-] to stress and friction.
    power : float
        The difference falls like this power of the distance [-].
    """

    name: str
    at: Loading
    near: Callable[[float], Loading]
    power: float


LIMITS = (
    Limit("isotropic stress", Loading.of_ratio(1.0), lambda step: Loading.of_ratio(1.0 + step), 1.0),
    Limit("no slip, $1/\\mu\\to0$", Loading.of_ratio(2.0),
          lambda step: Loading.of_ratio(2.0, friction=1.0 / step), 1.0),
    Limit("no friction, $\\mu\\to0$", Loading.of_ratio(2.0, friction=0.0),
          lambda step: Loading.of_ratio(2.0, friction=step), 1.0),
    Limit("onset of sliding", Loading.of_ratio(ONSET[0], friction=ONSET[1]),
          lambda step: Loading.of_ratio(ONSET[0], friction=ONSET[1] * (1.0 + step)), 5.0 / 6.0),
)
COLOURS = (BLUE, GREEN, ORANGE, VERMILION)


def distances(limit: Limit, steps: Sequence[float] = STEPS, *, poisson_ratio: float = 0.21) -> list[float]:
    """Relative difference of C2323 from its limit at some distances.

    Parameters
    ----------
    limit : Limit
        One of ``LIMITS``.
    steps : sequence of float
        Distances [-].
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    list of float
        Positive [-].

    Notes
    -----
    Accuracy: differences of certified values, 1e-25 and better. Source: ball arithmetic, isotropic packing.

    Examples
    --------
    >>> found = distances(LIMITS[1])
    >>> 7 < found[-2] / found[-1] < 9
    True
    """
    from granular.checks.on_the_fly import certified_components
    from granular.fabric import AxialFabric
    from granular.hypothesis import Hypothesis

    def value(loading: Loading) -> Fraction:
        six = certified_components(AxialFabric(), poisson_ratio, Hypothesis.KINEMATIC, loading)
        return six[COMPONENTS.index(COMPONENT)]

    end = value(limit.at)
    return [abs(float((value(limit.near(step)) - end) / end)) for step in steps]


@house_style
def approach_to_limits() -> Figure:
    """Draw the distance of the stiffness from four limits, with the power that the derivation gives.

    Returns
    -------
    matplotlib.figure.Figure
        Dots are certified differences, lines the power laws through the last dot of each.

    Notes
    -----
    Source: the limits of ``derivations.kinetic_limits``.
    """
    import numpy as np

    figure = blank(height=3.6)
    axes = figure.add_subplot()
    steps = np.array(STEPS)
    curves = sorted(((distances(limit), limit, colour) for limit, colour in zip(LIMITS, COLOURS, strict=True)),
                    key=lambda curve: curve[0][-1])
    places = spread([math.log10(found[-1]) for found, _, _ in curves], gap=0.6)
    for (found, limit, colour), place in zip(curves, places, strict=True):
        axes.loglog(steps, found[-1] * (steps / steps[-1]) ** limit.power, color=colour, linewidth=1.2)
        axes.loglog(steps, found, color=colour, marker="o", markersize=4.5, linestyle="none")
        axes.text(steps[-1] * 0.7, 10.0**place, limit.name, color=readable(colour), ha="right", va="center")
    axes.set(xlim=(1e-11, 0.3), xlabel="distance from the limit [–]", ylabel="change of $C_{2323}$ [–]")
    axes.set_xticks([1e-8, 1e-6, 1e-4, 1e-2])
    axes.minorticks_off()
    return figure
