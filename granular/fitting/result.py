"""``fit``: fabric from wave speeds or stiffness, with what the data say about it and what they do not."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from granular.fitting.data import Data
from granular.fitting.problem import Problem
from granular.fitting.profiles import Interval, Profile, interval, profile
from granular.fitting.solver import Minimum, minima

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

LEVELS = (0.6827, 0.95)
"""Confidence of the stated intervals [-]; the first is one standard deviation of a normal distribution."""

NEARLY = 9.0
"""A further minimum is told when its chi-square exceeds the lowest by less than this [-], three standard deviations."""

AT_BOUND = 1e-6
"""An unknown closer than this to its bound has hit it [-]."""

RISE = 6.0
"""How much chi-square rises along a profile at least [-]; 95 % need 3.84."""

SMALL = 0.05
"""A combination is written over its first unknown unless that has a smaller part in it [-]."""

UNDETERMINED = 1e-9
"""Singular values smaller than this part of the largest say nothing [-]."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """What the data say about one unknown.

    Attributes
    ----------
    name : str
        The unknown.
    value : float
        Where chi-square is least [-].
    standard_error : float
        From the slopes there [-]; infinite where they say nothing.
    intervals : tuple of Interval
        By the profile of chi-square, at ``LEVELS``; empty for factors.
    at_bound : bool
        Whether the search ended at its bound: the data ask for more than the model allows.
    """

    name: str
    value: float
    standard_error: float
    intervals: tuple[Interval, ...]
    at_bound: bool


@dataclass(frozen=True, slots=True)
class Combination:
    """A combination of unknowns that the data see as one number.

    Attributes
    ----------
    coefficients : tuple of float
        Of the unknowns [-]; 1 for the first, or for the largest where the first has almost no part.
    value, standard_error : float
        Of the combination [-].
    singular_value : float
        Change of all measurements, in standard deviations, for a change of 1 along the direction [-].
    """

    coefficients: tuple[float, ...]
    value: float
    standard_error: float
    singular_value: float


@dataclass(frozen=True, slots=True)
class Residual:
    """One measurement beside the fitted model.

    Attributes
    ----------
    name, state : str
        What was measured, and in which state.
    measured, fitted, uncertainty : float
        Numbers [SI].
    sigmas : float
        Measured less fitted over the uncertainty [-].
    """

    name: str
    state: str
    measured: float
    fitted: float
    uncertainty: float
    sigmas: float


@dataclass(frozen=True)
class Fit:
    """A fitted fabric and the evidence for it.

    Attributes
    ----------
    estimates : tuple of Estimate
        One for each unknown.
    factors : tuple of Estimate
        Factors between model and sample, with standard errors.
    covariance, correlation : (size, size) array
        Of unknowns, then of logarithms of the factors [-].
    chi_square : float
        Sum of squared residuals in units of the uncertainty [-].
    degrees_of_freedom : int
        Measurements less unknowns and factors.
    p_value : float or None
        Share of repeated experiments with a larger chi-square, if the model is right [-]; None without a degree of
        freedom.
    residuals : tuple of Residual
        One for each measurement.
    combinations : tuple of Combination
        Directions among the unknowns, the best known first.
    others : tuple of dict
        Further minima nearly as low: unknowns and chi-square.
    profiles : tuple of Profile
        How chi-square rises along each unknown.
    minimum : Minimum
        Where the search ended.
    problem : Problem
        What was solved.
    """

    estimates: tuple[Estimate, ...]
    factors: tuple[Estimate, ...]
    covariance: Array
    correlation: Array
    chi_square: float
    degrees_of_freedom: int
    p_value: float | None
    residuals: tuple[Residual, ...]
    combinations: tuple[Combination, ...]
    others: tuple[dict[str, float], ...]
    profiles: tuple[Profile, ...]
    minimum: Minimum
    problem: Problem

    def __getitem__(self, name: str) -> Estimate:
        """Estimate of that name."""
        for estimate in (*self.estimates, *self.factors):
            if estimate.name == name:
                return estimate
        raise KeyError(f"no estimate {name!r}; there are "
                       f"{', '.join(one.name for one in (*self.estimates, *self.factors))}")


def fit(source: str | os.PathLike[str] | Mapping[str, Any] | Data) -> Fit:
    """Find contact fabric and branch anisotropy from measured wave speeds or stiffness components.

    Parameters
    ----------
    source : path, mapping or Data
        A data file: the tables of a scene without the unknowns, ``[measured]`` (or ``[[measured]]``, one for each
        state of stress), and ``[fit]``; or its tables; or data already read.

    Returns
    -------
    Fit
        Estimates, intervals, combinations and residuals.

    Raises
    ------
    MeasurementsTooFew
        Fewer measurements than unknowns and factors.
    GranularError
        What else is wrong with the data; one sentence each.

    Notes
    -----
    Least squares with the exact slopes, from several starts. By default one factor of compression and one of shear
    stand between model and sample in each state (``fit.scale = "modes"``), because uniform strain overrates the
    stiffness, and that of shear more than that of compression: the fabric then follows from the anisotropy of the
    speeds alone. Accuracy: minima to 1e-8 of each unknown for data without noise; ends of intervals to 1e-5 of their
    distance. Source: eqs (4), (7), (20)-(23); profiles of chi-square.

    Examples
    --------
    >>> found = fit({
    ...     "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.6},
    ...     "stress": {"mean": "100 kPa", "ratio": 2.0}, "fit": {"unknowns": ["D33"]},
    ...     "measured": {"C1111/C3333": "0.70 +- 0.01", "C2323/C1212": "1.10 +- 0.02"}})
    >>> [estimate.name for estimate in found.estimates], found.degrees_of_freedom
    (['D33'], 1)
    """
    data = source if isinstance(source, Data) else (
        Data.of_tables(source) if isinstance(source, Mapping) else Data.from_toml(source))
    problem = Problem.of(data)
    found = minima(problem)
    return _described(problem, found)


def _described(problem: Problem, found: tuple[Minimum, ...]) -> Fit:
    from scipy.stats import chi2

    best = found[0]
    residuals, slopes = problem.residuals(best.unknowns)
    covariance = _covariance(slopes)
    errors = np.sqrt(np.diag(covariance))
    count, freedom = len(problem.unknowns), len(problem.data.measurements) - problem.size
    low, high = problem.bounds
    at_bound = (best.unknowns - low < AT_BOUND) | (high - best.unknowns < AT_BOUND)
    steps = np.where(np.isfinite(errors) & (errors > 0), errors, 0.1)
    profiles = tuple(profile(problem, found, k, float(steps[k]), RISE) for k in range(count))
    estimates = tuple(
        Estimate(name, float(best.unknowns[k]), float(errors[k]),
                 tuple(interval(problem, found, profiles[k], level) for level in LEVELS),
                 bool(at_bound[k])) for k, name in enumerate(problem.unknowns))
    factors = tuple(
        Estimate(factor.name, float(np.exp(best.unknowns[k])), float(np.exp(best.unknowns[k]) * errors[k]), (),
                 bool(at_bound[k])) for k, factor in enumerate(problem.factors, start=count))
    with np.errstate(invalid="ignore"):
        correlation = covariance / np.outer(errors, errors)
    return Fit(
        estimates=estimates, factors=factors, covariance=covariance, correlation=correlation,
        chi_square=best.chi_square, degrees_of_freedom=freedom,
        p_value=float(chi2.sf(best.chi_square, freedom)) if freedom else None,
        residuals=_residuals(problem, residuals), combinations=combinations_at(problem, best.unknowns),
        others=tuple({**dict(zip(problem.unknowns, other.unknowns[:count].tolist(), strict=True)),
                      "chi_square": other.chi_square}
                     for other in found[1:] if other.chi_square - best.chi_square < NEARLY),
        profiles=profiles, minimum=best, problem=problem)


def _covariance(slopes: Array) -> Array:
    """Inverse of the normal matrix; infinite variance along what the slopes do not tell."""
    _, singular, right = np.linalg.svd(slopes, full_matrices=False)
    known = singular > UNDETERMINED * singular[0]
    covariance: Array = (right[known].T / singular[known] ** 2) @ right[known]
    lost = (right[~known] ** 2).sum(axis=0) > UNDETERMINED
    covariance[lost, :] = covariance[:, lost] = np.nan
    covariance[lost, lost] = np.inf
    return covariance


def _residuals(problem: Problem, residuals: Array) -> tuple[Residual, ...]:
    return tuple(
        Residual(one.kind.name, problem.data.labels[one.state], one.value,
                 float(one.value + left * one.uncertainty), one.uncertainty, float(-left))
        for one, left in zip(problem.data.measurements, residuals, strict=True))


def combinations_at(problem: Problem, unknowns: Array) -> tuple[Combination, ...]:
    """What the data of a problem would see of its unknowns at given values: an experiment can be judged beforehand.

    Parameters
    ----------
    problem : Problem
        Measurements with their uncertainties.
    unknowns : (size,) array
        Unknowns, then logarithms of the factors [-].

    Returns
    -------
    tuple of Combination
        Singular directions of the slopes by the unknowns, what the factors can do taken out; the best known first.

    Notes
    -----
    Source: singular values of the scaled slopes.
    """
    _, slopes = problem.residuals(unknowns)
    values = unknowns[:len(problem.unknowns)]
    count = len(problem.unknowns)
    of_unknowns, of_factors = slopes[:, :count], slopes[:, count:]
    if of_factors.size:
        of_unknowns = of_unknowns - of_factors @ (np.linalg.pinv(of_factors) @ of_unknowns)
    scales = np.array([1.0 if name in ("D33", "Dr33") else value
                       for name, value in zip(problem.unknowns, values, strict=True)])
    _, singular, right = np.linalg.svd(of_unknowns * scales, full_matrices=True)
    singular = np.concatenate([singular, np.zeros(count - singular.size)])
    combinations = []
    for size, direction in zip(singular, right, strict=True):
        coefficients = direction / scales
        largest = coefficients[0] if abs(direction[0]) > SMALL else coefficients[np.argmax(abs(direction))]
        error = np.inf if size <= UNDETERMINED * singular[0] else 1 / (size * abs(largest))
        combinations.append(Combination(tuple((coefficients / largest).tolist()),
                                        float(coefficients @ values / largest), float(error), float(size)))
    return tuple(combinations)
