"""Minima of chi-square: many starts go down together, and each minimum that they find is polished.

The components of a hundred trials cost little more than those of one, so that starts, and points of a profile, are
searched as one array by damped Gauss-Newton steps inside the bounds.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from granular.fitting.problem import Problem

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

STARTS = {"D33": (-0.7, -0.2, 0.3, 1.0), "Dr33": (-0.6, -0.15, 0.25, 0.9), "coordination_number": (4.0, 8.0),
          "friction_coefficient": (0.2, 0.8)}
"""Values from which each unknown is sought, in all combinations [-]."""

SAME = 1e-4
"""Minima closer than this in every unknown are one [-]."""

TOLERANCE = 1e-15
"""Relative change of unknowns or chi-square at which the last search stops [-]."""

EQUAL = 1e-9
"""Minima whose chi-squares differ by less than this are equally low: nothing but rounding tells them apart [-]."""

MOST_STEPS = 120
"""Steps after which a search that has not settled is left where it is."""


@dataclass(frozen=True, slots=True)
class Minimum:
    """A minimum of chi-square.

    Attributes
    ----------
    unknowns : (size,) array
        Unknowns, then logarithms of the factors [-].
    chi_square : float
        Sum of squared residuals [-].
    found_from : int
        Number of starts that led there [-].
    """

    unknowns: Array
    chi_square: float
    found_from: int = 1


def minima(problem: Problem) -> tuple[Minimum, ...]:
    """Find the minima of chi-square from a grid of starts, the lowest first.

    Parameters
    ----------
    problem : Problem
        Residuals and slopes.

    Returns
    -------
    tuple of Minimum
        Different ones; at least one. Of minima that are equally low the one nearest to an isotropic fabric comes first.

    Notes
    -----
    Source: damped Gauss-Newton steps, then trust-region reflective least squares (Branch, Coleman and Li 1999).
    """
    fabric = np.array(list(product(*(STARTS[name] for name in problem.unknowns))))
    factors, _ = problem.best_factors(fabric)
    ends, heights = descend(problem, np.hstack([fabric, factors]))
    found: list[Minimum] = []
    for place in np.argsort(heights, kind="stable"):
        for number, known in enumerate(found):
            if abs(known.unknowns - ends[place]).max() < SAME:
                found[number] = Minimum(known.unknowns, known.chi_square, known.found_from + 1)
                break
        else:
            found.append(Minimum(ends[place], float(heights[place])))
    lowest = [one for one in found if one.chi_square - found[0].chi_square < EQUAL]
    lowest.sort(key=lambda one: _anisotropy(problem, one))
    return (_polished(problem, lowest[0]), *lowest[1:], *found[len(lowest):])


def _anisotropy(problem: Problem, minimum: Minimum) -> float:
    """How far the fabric of a minimum is from an isotropic one."""
    return sum(float(value) ** 2 for name, value in zip(problem.unknowns, minimum.unknowns, strict=False)
               if name in ("D33", "Dr33"))


def _polished(problem: Problem, minimum: Minimum) -> Minimum:
    """The last digits."""
    from scipy.optimize import least_squares

    low, high = problem.bounds
    width = 1e-12 * (high - low)
    solved = least_squares(
        lambda unknowns: problem.residuals(unknowns)[0], np.clip(minimum.unknowns, low + width, high - width),
        jac=lambda unknowns: problem.residuals(unknowns)[1], bounds=(low, high), x_scale="jac",
        xtol=TOLERANCE, ftol=TOLERANCE, gtol=TOLERANCE, max_nfev=60)
    if 2 * solved.cost >= minimum.chi_square:
        return minimum
    return Minimum(solved.x, float(2 * solved.cost), minimum.found_from)


def descend(problem: Problem, starts: Array, *, held: int | None = None,
            settled_at: float = 0.0) -> tuple[Array, Array]:
    """Go down from many starts at once.

    Parameters
    ----------
    problem : Problem
        Residuals and slopes.
    starts : (k, size) array
        Unknowns, then logarithms of the factors [-].
    held : int, optional
        Place of an unknown that keeps its value [-].
    settled_at : float
        Fall of chi-square below which a search stops [-].

    Returns
    -------
    tuple of 2 array
        (k, size) ends and (k,) chi-squares [-].

    Notes
    -----
    Source: Levenberg (1944) and Marquardt (1963), steps cut at the bounds.
    """
    low, high = problem.bounds
    places = np.clip(starts, low, high)
    residuals, slopes = problem.residuals(places)
    heights = np.einsum("kn,kn->k", residuals, residuals)
    damping = np.full(len(places), 1e-3)
    moving = np.arange(len(places))
    for _ in range(MOST_STEPS):
        if not moving.size:
            break
        step = _step(places[moving], residuals[moving], slopes[moving], damping[moving], (low, high), held)
        tried = np.clip(places[moving] + step, low, high)
        new_residuals, new_slopes = problem.residuals(tried)
        new_heights = np.einsum("kn,kn->k", new_residuals, new_residuals)
        better = new_heights < heights[moving]
        gain = heights[moving] - new_heights
        settled = (abs(tried - places[moving]).max(axis=-1) < 1e-13) | (
            better & (gain < settled_at + 1e-15 * heights[moving]))
        settled |= damping[moving] > 1e12
        taken = moving[better]
        places[taken], residuals[taken], slopes[taken] = tried[better], new_residuals[better], new_slopes[better]
        heights[taken] = new_heights[better]
        damping[moving] = np.where(better, np.maximum(damping[moving] / 8, 1e-14), damping[moving] * 6)
        moving = moving[~settled]
    return places, heights


def _step(places: Array, residuals: Array, slopes: Array, damping: Array, bounds: tuple[Array, Array],
          held: int | None) -> Array:
    """Damped Gauss-Newton steps; an unknown that is held, or pressed against its bound, stays."""
    normal = np.einsum("kna,knb->kab", slopes, slopes)
    downhill = -np.einsum("kna,kn->ka", slopes, residuals)
    fixed = ((places <= bounds[0]) & (downhill < 0)) | ((places >= bounds[1]) & (downhill > 0))
    if held is not None:
        fixed[:, held] = True
    diagonal = np.einsum("kaa->ka", normal)
    lift = damping[:, None] * np.maximum(diagonal, 1e-12 * diagonal.max(axis=-1, keepdims=True)) + 1e-300
    size = places.shape[-1]
    normal = normal + lift[:, :, None] * np.eye(size)
    both = fixed[:, :, None] | fixed[:, None, :]
    normal = np.where(both, np.eye(size), normal)
    result: Array = np.linalg.solve(normal, np.where(fixed, 0.0, downhill)[..., None])[..., 0]
    return result
