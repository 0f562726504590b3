"""Every route that could serve a scene, timed side by side through ``granular.evaluate``."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from granular.errors import GranularError
from granular.routes.catalogue import ROUTES

if TYPE_CHECKING:
    from granular.evaluation import Evaluation
    from granular.scene import Scene

ROUNDS = 7
"""How often each route is timed at least; the best time counts, for load can only add to it."""

MOST_ROUNDS, LONG_ENOUGH = 40, 0.05
"""Short evaluations are timed more often: up to so many times, until all of them together took so long [s]."""

HOPELESS = 5.0
"""A route that took so many times the plan's own in one round is not timed again: it is not the cheapest."""

AUTO = "auto"
"""Name of an evaluation whose route is left to the plan."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """One way of evaluating a scene.

    Attributes
    ----------
    name : str
        The route, or "auto".
    call : callable
        Does it.
    result : Evaluation
        What it gave.
    """

    name: str
    call: Callable[[], Evaluation]
    result: Evaluation


def candidates(scene: Scene, rtol: float) -> tuple[Candidate, list[Candidate]] | None:
    """Evaluate a scene by every route that serves it.

    Parameters
    ----------
    scene : Scene
        What to evaluate.
    rtol : float
        Wanted relative accuracy of every component [-]. A route that refuses it is asked again without it, as a
        reader of its refusal would do.

    Returns
    -------
    tuple of (Candidate, list of Candidate), or None
        The evaluation whose route is left to the plan, and one by each route that serves the scene, the plan's own
        among them; None where the plan refuses.

    Notes
    -----
    Every call has run once, so that imports and tables that are made once are not timed. Source:
    :func:`granular.evaluate`.
    """
    planned = _candidate(scene, AUTO, rtol)
    if planned is None:
        return None
    found = (_candidate(scene, name, rtol) or _candidate(scene, name, None) for name in ROUTES)
    return planned, [candidate for candidate in found if candidate is not None]


def _candidate(scene: Scene, name: str, rtol: float | None) -> Candidate | None:
    from granular.evaluation import evaluate

    call = partial(evaluate, scene, rtol=rtol, route=name)
    try:
        return Candidate(name=name, call=call, result=call())
    except GranularError:
        return None


def best_times(timed: list[Candidate], *, against: str, rounds: int = ROUNDS) -> dict[str, float]:
    """Time evaluations in turn, each once a round and in a random order.

    Parameters
    ----------
    timed : list of Candidate
        What to time, among it the route ``against``.
    against : str
        The route beside which another one may be hopeless.
    rounds : int
        How many rounds at least [-], >= 1.

    Returns
    -------
    dict
        Name -> best time of the processor [s].

    Notes
    -----
    Accuracy: the best of several times repeats to some per cent, also on a machine that does other work, for only the
    time that this process got is counted. Source: the clock of this process.
    """
    best: dict[str, float] = {}
    left, rng, spent = list(timed), random.Random(1999), 0.0
    for number in range(max(rounds, MOST_ROUNDS)):
        if number >= rounds and spent >= LONG_ENOUGH:
            break
        rng.shuffle(left)
        for candidate in left:
            start = time.process_time()
            candidate.call()
            seconds = time.process_time() - start
            spent += seconds
            best[candidate.name] = min(seconds, best.get(candidate.name, seconds))
        left = [candidate for candidate in left if best[candidate.name] <= HOPELESS * best[against]]
    return best
