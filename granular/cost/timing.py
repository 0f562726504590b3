"""Times as ratios: every call against one unit that is timed right before it, all calls in random order."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

UNIT = "the emitted closed form of Table II, case 3, kinematic, in floats"
"""What one time ratio of 1 is."""

SHORTEST = 5e-4
"""A timing repeats its call until it takes about this long [s], far above the resolution of the clock."""

LONGEST = 0.4
"""What one setting may take in all [s], as long as it is timed ``FEWEST`` times."""

LONG = 0.1
"""A call whose first time was longer [s] is not tried once more before it is timed."""

FEWEST = 3
"""Timings of a call that takes long [-]."""


@dataclass(frozen=True, slots=True)
class Timings:
    """Ratios of each call to the unit, and the unit itself.

    Attributes
    ----------
    ratios : list of list of float
        For each call its time over that of the unit [-].
    unit_seconds : list of float
        Times of the unit [s].
    """

    ratios: list[list[float]]
    unit_seconds: list[float]


def unit() -> object:
    """Evaluate the emitted closed form of Table II, case 3, in floats."""
    from granular.generated.kinematic_constant import kinematic_constant

    return kinematic_constant(0.3, 0.0, -0.3, 0.21)


def time_ratios(calls: Sequence[Callable[[], object]], first: Sequence[float], rounds: int,
                advanced: Callable[[], None]) -> Timings:
    """Time every call in every round; those that take long in fewer.

    Parameters
    ----------
    calls : sequence of callable
        What is timed.
    first : sequence of float
        What the first call of each took [s]; it may have built tables that later ones share.
    rounds : int
        How many rounds [-].
    advanced : callable
        Told after each round.

    Returns
    -------
    Timings
        A ratio for each call and round in which it took part.

    Notes
    -----
    Accuracy: that of the clock; other load on the machine acts on both sides of a ratio. Source: this machine.
    """
    seconds = [one if one > LONG else _time(call, 1) for call, one in zip(calls, first, strict=True)]
    repeats = [max(1, math.ceil(SHORTEST / one)) for one in seconds]
    counts = [max(min(FEWEST, rounds), min(rounds, int(LONGEST / (one * times))))
              for one, times in zip(seconds, repeats, strict=True)]
    for_unit = max(1, math.ceil(SHORTEST / _time(unit, 20)))
    ratios: list[list[float]] = [[] for _ in calls]
    units: list[float] = []
    rng = random.Random(1999)
    for place in range(rounds):
        # calls that take long are spread over the rounds
        order = [index for index, count in enumerate(counts) if (place + 1) * count // rounds > place * count // rounds]
        rng.shuffle(order)
        for index in order:
            units.append(_time(unit, for_unit))
            ratios[index].append(_time(calls[index], repeats[index]) / units[-1])
        advanced()
    return Timings(ratios, units)


def _time(call: Callable[[], object], repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return max(time.perf_counter() - start, 1e-9) / repeats
