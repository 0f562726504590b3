"""Times of several ways to do the same work, measured side by side: each way once in every round, in random order."""

from __future__ import annotations

import math
import random
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

SHORTEST = 2e-3
"""A timing repeats its call until it takes about this long [s], far above the resolution of the clock."""

LONGEST = 20.0
"""What the rounds of one comparison may take in all [s], as long as there are ``FEWEST`` of them."""

FEWEST = 3
"""Rounds of a comparison that takes long [-]."""

LONG = 1.0
"""A call whose first time was longer [s] is not tried once more before it is timed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Way:
    """One way to do the work.

    Attributes
    ----------
    name : str
        What it is, for a table.
    elements : int
        How many elements one call does [-]; a slow way does fewer.
    call : callable
        Does them.
    error : callable or None
        Worst relative error of what it gives [-]; None where there is nothing to compare with.
    wanted : float or None
        Bound that is aimed at for the time of an element over that of the first way [-].
    memory : callable or None
        Most memory beside what is given to it, over the size of that [-].
    memory_wanted : float or None
        Bound that is aimed at for it [-].
    """

    name: str
    elements: int
    call: Callable[[], object]
    error: Callable[[], float] | None = None
    wanted: float | None = None
    memory: Callable[[], float] | None = None
    memory_wanted: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """What one way took.

    Attributes
    ----------
    name : str
        The way.
    elements : int
        Elements of one call [-].
    ratio : float
        Time of an element over that of the first way in the same round, median of the rounds [-].
    least : float
        Least time of an element over the least one of the first way [-]; what load on the machine disturbs least.
    spread : float
        Half the distance of the quartiles of the ratio, over the ratio [-].
    nanoseconds : float
        Median time of an element [ns].
    rounds : int
        How often it was timed [-].
    error : float or None
        Worst relative error [-], where it was looked for.
    wanted, memory, memory_wanted : float or None
        As in :class:`Way` [-].
    """

    name: str
    elements: int
    ratio: float
    least: float
    spread: float
    nanoseconds: float
    rounds: int
    error: float | None = None
    wanted: float | None = None
    memory: float | None = None
    memory_wanted: float | None = None

    @property
    def verdicts(self) -> tuple[bool, ...]:
        """For each bound that is aimed at, of time and of memory, whether it is met."""
        judged = ((self.ratio, self.wanted), (self.memory, self.memory_wanted))
        return tuple(value <= bound for value, bound in judged if value is not None and bound is not None)


def measure(ways: Sequence[Way], *, rounds: int) -> list[Measured]:
    """Time ways side by side; the first one is what the others are compared with.

    Parameters
    ----------
    ways : sequence of Way
        At least one.
    rounds : int
        How often each is timed [-], > 0; less often where that would take more than ``LONGEST``, but ``FEWEST``
        times at least.

    Returns
    -------
    list of Measured
        One for each way.

    Notes
    -----
    Accuracy: that of the clock; other load acts on all ways of a round. Every call is made once beforehand, so that
    nothing is compiled or loaded within a timing. Source: this machine.

    Examples
    --------
    >>> same, twice = measure([Way(name="a", elements=1, call=lambda: sum(range(100_000))),
    ...                        Way(name="b", elements=2, call=lambda: sum(range(100_000)))], rounds=3)
    >>> same.ratio, twice.ratio < 1
    (1.0, True)
    """
    repeats, round_takes = [], 0.0
    for way in ways:
        first = _time(way.call, 1)
        once = first if first > LONG else _time(way.call, 1)
        repeats.append(max(1, math.ceil(SHORTEST / once)))
        round_takes += once * repeats[-1]
    rounds = min(rounds, max(FEWEST, int(LONGEST / round_takes)))
    times: list[list[float]] = [[] for _ in ways]
    rng = random.Random(1999)
    order = list(range(len(ways)))
    for _ in range(rounds):
        rng.shuffle(order)
        for place in order:
            times[place].append(_time(ways[place].call, repeats[place]) / ways[place].elements)
    return [_measured(way, own, times[0]) for way, own in zip(ways, times, strict=True)]


def _measured(way: Way, own: Sequence[float], base: Sequence[float]) -> Measured:
    ratios = [one / other for one, other in zip(own, base, strict=True)]
    ratio = statistics.median(ratios)
    quartiles = statistics.quantiles(ratios, n=4) if len(ratios) > 1 else [ratio] * 3
    return Measured(name=way.name, elements=way.elements, ratio=ratio, least=min(own) / min(base),
                    spread=(quartiles[2] - quartiles[0]) / 2 / ratio, nanoseconds=statistics.median(own) * 1e9,
                    rounds=len(own), error=None if way.error is None else way.error(), wanted=way.wanted,
                    memory=None if way.memory is None else way.memory(), memory_wanted=way.memory_wanted)


def _time(call: Callable[[], object], repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return max(time.perf_counter() - start, 1e-9) / repeats
