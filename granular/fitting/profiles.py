"""How chi-square rises along one unknown when all others are fitted anew: profiles, and the intervals they give."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from granular.fitting.problem import Problem
from granular.fitting.solver import Minimum, descend

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

POINTS = 8
"""Points of a profile on either side of the minimum, and of each closer look at an end."""

LOOKS = 2
"""Closer looks at an end: each divides the distance between two points by ``POINTS`` + 1."""

SETTLED = 1e-7
"""Fall of chi-square at which a search along a profile stops [-]; intervals begin at a rise of 1."""

RIVALS = 25.0
"""Further minima serve as starts when they are higher than the lowest by less than this [-]."""


@dataclass(frozen=True, slots=True)
class Interval:
    """A range of one unknown that the data do not exclude.

    Attributes
    ----------
    level : float
        Share of repeated experiments whose range would hold the true value [-].
    low, high : float
        Its ends [-].
    low_open, high_open : bool
        Whether the range goes on to the bound of the search there: the data do not end it.
    """

    level: float
    low: float
    high: float
    low_open: bool
    high_open: bool


@dataclass(frozen=True, slots=True)
class Profile:
    """Least chi-square at given values of one unknown.

    Attributes
    ----------
    place : int
        Place of the unknown.
    values : (k,) array
        Its values, rising [-].
    rises : (k,) array
        Least chi-square there above the minimum [-].
    others : (k, size) array
        All unknowns there [-].
    """

    place: int
    values: Array
    rises: Array
    others: Array


def profile(problem: Problem, found: tuple[Minimum, ...], place: int, step: float, rise: float) -> Profile:
    """Follow the least chi-square along one unknown, from its minimum to where it has risen enough.

    Parameters
    ----------
    problem : Problem
        Residuals and slopes.
    found : tuple of Minimum
        The minima, the lowest first; all that are not much higher are starts of the search at each point.
    place : int
        Place of the unknown [-].
    step : float
        Its standard error, > 0 [-].
    rise : float
        How much chi-square must rise at least, as far as the bounds allow [-].

    Returns
    -------
    Profile
        ``POINTS`` on either side where chi-square is nearly a parabola; as many again where it is not.

    Notes
    -----
    Source: the profile of the likelihood.
    """
    center = float(found[0].unknowns[place])
    reach = 1.4 * step * np.sqrt(rise)
    ends = [float(bounds[place]) for bounds in problem.bounds]
    near = [sign * min(reach, abs(end - center)) for sign, end in zip((-1, 1), ends, strict=True)]
    shares = np.linspace(0, 1, POINTS + 1)
    values = np.unique(center + np.concatenate([near[0] * shares, near[1] * shares]))
    others, rises = lowest(problem, found, place, values)
    # a valley that is longer than its parabola is followed to the bound
    more = [np.geomspace(abs(near[side]), abs(end - center), POINTS + 1)[1:] * (-1, 1)[side]
            for side, end in enumerate(ends) if rises[-side] < rise and 0 < abs(near[side]) < abs(end - center)]
    if more:
        further = center + np.concatenate(more)
        beyond, higher = lowest(problem, found, place, further)
        values, others, rises = (np.concatenate(pair) for pair in (
            (values, further), (others, beyond), (rises, higher)))
        order = np.argsort(values)
        values, others, rises = values[order], others[order], rises[order]
    return Profile(place, values, rises, others)


def lowest(problem: Problem, found: tuple[Minimum, ...], place: int, values: Array) -> tuple[Array, Array]:
    """Least chi-square above the minimum at given values of one unknown.

    Parameters
    ----------
    problem, found, place
        As for :func:`profile`.
    values : (k,) array
        Values of the unknown [-].

    Returns
    -------
    tuple of 2 array
        (k, size) all unknowns and (k,) rises [-].
    """
    _, slopes = problem.residuals(found[0].unknowns)
    rest = [k for k in range(problem.size) if k != place]
    follow = np.zeros(problem.size)
    follow[place] = 1.0
    if rest:  # how the others follow where everything is linear
        follow[rest] = -np.linalg.lstsq(slopes[:, rest], slopes[:, place], rcond=None)[0]
    starts = []
    for minimum in found:
        if minimum.chi_square - found[0].chi_square < RIVALS:
            start = minimum.unknowns + (values - minimum.unknowns[place])[:, None] * follow
            start[:, place] = values
            starts.append(start)
    ends, heights = descend(problem, np.concatenate(starts), held=place, settled_at=SETTLED)
    heights = heights.reshape(len(starts), values.size)
    best = heights.argmin(axis=0)
    columns = np.arange(values.size)
    return (ends.reshape(len(starts), values.size, -1)[best, columns],
            heights[best, columns] - found[0].chi_square)


def interval(problem: Problem, found: tuple[Minimum, ...], along: Profile, level: float) -> Interval:
    """Range of one unknown in which the profile stays below the quantile of chi-square.

    Parameters
    ----------
    problem, found
        As for :func:`profile`.
    along : Profile
        The profile of the unknown.
    level : float
        Confidence, 0 to 1 [-].

    Returns
    -------
    Interval
        Its ends to 1e-5 of their distance from the minimum.

    Notes
    -----
    Source: likelihood ratio with one degree of freedom (Wilks 1938).
    """
    from scipy.stats import chi2

    rise = float(chi2.ppf(level, 1))
    center = float(found[0].unknowns[along.place])
    ends = []
    for sign in (-1, 1):
        side = np.flatnonzero(sign * (along.values - center) >= 0)[::sign]
        values, rises = along.values[side], along.rises[side]
        ends.append(_end(problem, found, along.place, values, rises, rise))
    (low, low_open), (high, high_open) = ends
    return Interval(level, low, high, low_open, high_open)


def _end(problem: Problem, found: tuple[Minimum, ...], place: int, values: Array, rises: Array,
         rise: float) -> tuple[float, bool]:
    """Where a profile, followed from the minimum outwards, rises above a height for good."""
    above = np.flatnonzero(rises <= rise)
    last = int(above[-1]) if above.size else 0
    if last == values.size - 1:
        bound = problem.bounds[0 if values[-1] < values[0] else 1][place]
        return float(bound), True
    inner, outer = values[last], values[last + 1]
    heights = rises[last:last + 2]
    for _ in range(LOOKS):
        points = np.linspace(inner, outer, POINTS + 2)[1:-1]
        _, between = lowest(problem, found, place, points)
        points = np.concatenate([[inner], points, [outer]])
        heights = np.concatenate([heights[:1], between, heights[1:]])
        last = int(np.flatnonzero(heights <= rise)[-1]) if (heights <= rise).any() else 0
        last = min(last, points.size - 2)
        inner, outer, heights = points[last], points[last + 1], heights[last:last + 2]
    share = (rise - heights[0]) / (heights[1] - heights[0]) if heights[1] > heights[0] else 0.5
    return float(inner + min(max(share, 0.0), 1.0) * (outer - inner)), False
