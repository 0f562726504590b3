"""How fast the two trapezoidal rules for branch lengths converge, and how long the library takes with them.

The rules are written here a second time, with their steps as arguments, and taken against the certified moments.
"""

from __future__ import annotations

import json
import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from granular.gradation.lognormal_branches import INNER_STEP, NEGLIGIBLE, OUTER_STEP

if TYPE_CHECKING:
    from pathlib import Path

SPREADS = (1.2, 2.0, 3.0)
"""Geometric standard deviations of grain sizes s_r, all of them certified [-]."""

STRETCHES = (4.0, 3.0, 2.5, 2.0, 1.5, 1.25, 1.0)
"""Steps over those of the library [-]."""


@dataclass(frozen=True, slots=True)
class RuleError:
    """What both rules give with some step.

    Attributes
    ----------
    stretch : float
        Steps over those of the library [-].
    lengths : int
        Nodes of the rule over the length [-].
    nodes : int
        Pairs of nodes of both rules, each an exponential [-].
    error : float
        Relative error of <l^2> [-].
    """

    stretch: float
    lengths: int
    nodes: int
    error: float


@lru_cache
def rule_errors(spread: float) -> tuple[RuleError, ...]:
    """Errors of the mean square branch length by eq. (17) for every step.

    Parameters
    ----------
    spread : float
        One of ``SPREADS`` [-].

    Returns
    -------
    tuple of RuleError
        One for each of ``STRETCHES``.

    Notes
    -----
    Accuracy: certified values are rounded to double. Source: eqs (16) and (17), with the steps of
    ``granular.gradation.lognormal_branches`` stretched.

    Examples
    --------
    >>> rule_errors(2.0)[-1].error < 1e-14
    True
    """
    certified = _certified(spread)
    found = []
    for stretch in STRETCHES:
        value, lengths, nodes = second_moment(spread, inner=stretch * INNER_STEP, outer=stretch * OUTER_STEP)
        found.append(RuleError(stretch=stretch, lengths=lengths, nodes=nodes, error=abs(value / certified - 1.0)))
    return tuple(found)


def second_moment(spread: float, *, inner: float, outer: float) -> tuple[float, int, int]:
    """Mean square branch length by eq. (17) over that of equal spheres, by two trapezoidal rules.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], > 1.
    inner, outer : float
        Steps along the logarithm of the ratio of two radii and along that of the length, in spreads [-].

    Returns
    -------
    tuple
        <l^2>/(4 <r^3>^(2/3)) [-], nodes along the length, and pairs of nodes that are not negligible [-].

    Notes
    -----
    Source: eqs (12), (16), (17).

    Examples
    --------
    >>> round(4 * second_moment(2.0, inner=0.16, outer=0.375)[0], 3)
    33.155
    """
    import numpy as np

    L = math.log(spread)
    # the density falls like exp(-z^2/3) towards short lengths and like exp(-z^2/6) beyond its peak at z = 8 L
    z = outer * np.arange(math.floor(-12.0 / outer), math.ceil((8.0 * L + 17.0) / outer))
    t = inner * np.arange(math.ceil(2.0 * (z[-1] + 7.0) / inner))
    exponents = -((z[:, None] - np.log(np.cosh(0.5 * L * t)) / L) ** 2) - 0.25 * t * t
    peaks = exponents.max(axis=1)
    weights = np.where(t == 0.0, 0.5, 1.0)  # even in t
    log_h = peaks + np.log(np.exp(exponents - peaks[:, None]) @ weights)
    plain, square = (log_h / 3.0 + (2.0 / 3.0 + power) * L * z for power in (0.0, 2.0))
    value = math.exp(square.max() - plain.max() - 3.0 * L * L)
    value *= float(np.exp(square - square.max()).sum() / np.exp(plain - plain.max()).sum())
    needed = (square > square.max() - NEGLIGIBLE) | (plain > plain.max() - NEGLIGIBLE)
    pairs = exponents[needed] > peaks[needed, None] - NEGLIGIBLE
    return value, int(needed.sum()), int(pairs.sum())


def measure_times(curve: Path, *, rounds: int = 51) -> dict[str, Any]:
    """Time both moments that a stiffness needs, for lognormal sizes and for a measured curve.

    Parameters
    ----------
    curve : Path
        A gradation curve to read.
    rounds : int
        How often each is timed [-], >= 1; the median counts.

    Returns
    -------
    dict
        Machine and versions, rounds, and "seconds": the case -> its time [s].

    Notes
    -----
    Accuracy: that of the machine's clock; other load on it shows. Source: this machine.
    """
    from granular.cost import machine
    from granular.gradation import Lognormal, SizeDistribution, branch_lengths, read_curve

    def both(sizes: Callable[[], SizeDistribution]) -> float:
        observed = []
        for _ in range(rounds):
            fresh = sizes()
            start = time.perf_counter()
            lengths = branch_lengths(fresh)
            lengths.moment(2.0)
            lengths.moment(-2.0)
            observed.append(time.perf_counter() - start)
        return statistics.median(observed)

    seconds = {f"lognormal, s_r = {spread:g}": both(partial(Lognormal, 1.0, spread)) for spread in SPREADS}
    seconds[f"curve of {len(read_curve(curve).sizes)} points"] = both(lambda: read_curve(curve))
    return {"machine": machine(), "rounds": rounds, "seconds": seconds}


def _certified(spread: float) -> float:
    stored = json.loads(files("granular").joinpath("data", "certified_gradation.json").read_text(encoding="utf-8"))
    return next(float(case["second"]) for case in stored["cases"] if float(case["spread"]) == spread)
