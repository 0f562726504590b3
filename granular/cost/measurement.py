"""Measure one scene: the error of every setting first, then all times in interleaved rounds."""

from __future__ import annotations

import statistics
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from granular.cost import outside
from granular.cost.outside.route import OutsideRoute
from granular.cost.product import DEFAULT, product_settings
from granular.cost.records import OUTSIDE, Cost, NotServed, Outcome, RouteFailed, Setting, worst_error
from granular.cost.reference import reference
from granular.cost.scenes import CostScene
from granular.cost.timing import time_ratios
from granular.errors import CertifiedArithmeticMissing, GranularError
from granular.routes.catalogue import ROUTES

ROUTE_NAMES = (*ROUTES, *(route.name for route in outside.CATALOGUE))
"""Names of all routes, those of this package first."""

NO_SETTING = "any"
"""Setting of a route that serves a scene in none."""


@dataclass(frozen=True, slots=True)
class Measured:
    """What came of one scene.

    Attributes
    ----------
    costs : list of Cost
        One for each setting.
    unit_seconds : list of float
        Times of the unit [s].
    """

    costs: list[Cost]
    unit_seconds: list[float]


def settings_of(scene: CostScene, routes: Sequence[str] = ROUTE_NAMES) -> list[Setting]:
    """List the settings of some routes on a scene.

    Parameters
    ----------
    scene : CostScene
        What is computed.
    routes : sequence of str
        Names of routes.

    Returns
    -------
    list of Setting
        Those of this package first.
    """
    every = (*product_settings(scene), *_outside_settings(scene))
    return [setting for setting in every if setting.route in routes]


def measure_scene(scene: CostScene, settings: Sequence[Setting], *, rounds: int,
                  advanced: Callable[[], None] = lambda: None) -> Measured:
    """Measure the error and the time of some settings.

    Parameters
    ----------
    scene : CostScene
        What is computed.
    settings : sequence of Setting
        How.
    rounds : int
        How often everything is timed [-], >= 2; calls that take long are timed less often.
    advanced : callable
        Told after each setting and after each round, to show progress.

    Returns
    -------
    Measured
        A cost for each setting, or one for a route that does not serve the scene.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed: there would be nothing to take errors against.

    Notes
    -----
    Accuracy: errors are right to all the digits shown, down to the digits of the reference. Times are ratios within
    one process and one round; the spread says how well they repeat. Source: this machine.
    """
    known = reference(scene)
    tried: list[_Tried] = []
    refused: set[str] = set()
    for setting in settings:
        if setting.route not in refused:
            one = _try(setting, known)
            tried.append(one)
            if one.refused:
                refused.add(setting.route)
        advanced()
    timed = [one for one in tried if one.error is not None]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        timings = time_ratios([one.setting.call for one in timed], [one.seconds for one in timed], rounds, advanced)
    observed = {id(one): ratios for one, ratios in zip(timed, timings.ratios, strict=True)}
    return Measured([_cost(scene, one, observed.get(id(one), [])) for one in tried], timings.unit_seconds)


@dataclass(slots=True)
class _Tried:
    """A setting and what its first call gave."""

    setting: Setting
    outcome: Outcome | None = None
    seconds: float = 0.0
    error: float | None = None
    failure: str | None = None
    refused: bool = False


def _outside_settings(scene: CostScene) -> Iterator[Setting]:
    def run(route: OutsideRoute, value: object) -> Outcome:
        return route.run(scene, value)

    for route in outside.CATALOGUE:
        for name, value in route.settings.items():
            yield Setting(route=route.name, kind=OUTSIDE, name=name, call=partial(run, route, value))


def _try(setting: Setting, known: Sequence[Fraction]) -> _Tried:
    """Call once; whatever goes wrong is put into words."""
    tried = _Tried(setting)
    start = time.perf_counter()
    try:
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            outcome = setting.call()
        tried.seconds = time.perf_counter() - start
        tried.error = worst_error(outcome.components, known)
        tried.outcome = outcome
        tried.failure = outcome.failure or next((_sentence(str(warning.message)) for warning in heard), None)
    except CertifiedArithmeticMissing:
        raise
    except NotServed as reason:
        tried.failure, tried.refused = str(reason), True
    except RouteFailed as reason:
        tried.failure = str(reason)
    except GranularError as refusal:
        tried.failure = f"{refusal.found}, {refusal.allowed}"
        # a route that takes degrees or panels may still be measured at those
        tried.refused = setting.name == DEFAULT and setting.route in ("closed_form", "axial", "exact", "certified")
    except Exception as error:  # an outside library may fail in any way; that is a result, too
        tried.failure = f"{type(error).__name__}: {_sentence(str(error))}"
    return tried


def _sentence(message: str) -> str:
    return " ".join(message.split()).partition(". ")[0].rstrip(".")


def _cost(scene: CostScene, tried: _Tried, ratios: Sequence[float]) -> Cost:
    setting, outcome = tried.setting, tried.outcome
    ratio = statistics.median(ratios) if ratios else None
    spread = None
    if ratio is not None and len(ratios) > 1:
        lower, _, upper = statistics.quantiles(ratios, n=4, method="inclusive")
        spread = (upper - lower) / (2 * ratio)
    return Cost(
        scene=scene.name, hypothesis=scene.hypothesis, route=setting.route, kind=setting.kind,
        setting=NO_SETTING if tried.refused and outcome is None and setting.kind == OUTSIDE else setting.name,
        paper=setting.paper, error=tried.error, promised=None if outcome is None else outcome.promised,
        evaluations=None if outcome is None else outcome.evaluations, time_ratio=ratio, spread=spread,
        count=len(ratios), failure=tried.failure)
