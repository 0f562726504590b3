"""What ``granular cost`` measures: errors are right, counts are counts, failures are words and never gaps."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from granular.cost import NAMES, ROUTE_NAMES, SCENES, Cost, CostScene, measure_scene, outside, settings_of, timing
from granular.cost.records import OUTSIDE, PRODUCT, Outcome, RouteFailed, Setting, worst_error
from granular.cost.reference import reference
from granular.cost.timing import time_ratios
from granular.hypothesis import Hypothesis
from granular.routes.catalogue import ROUTES


def scene_of(name: str, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> CostScene:
    return next(scene for scene in SCENES if (scene.name, scene.hypothesis) == (name, hypothesis))


def measured(name: str, *routes: str, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> dict[tuple[str, str], Cost]:
    """Costs by route and setting."""
    scene = scene_of(name, hypothesis)
    return {(cost.route, cost.setting): cost
            for cost in measure_scene(scene, settings_of(scene, routes), rounds=2).costs}


@pytest.fixture(autouse=True)
def brief(monkeypatch: pytest.MonkeyPatch) -> None:
    """No repetition: what is measured is not the point here."""
    monkeypatch.setattr(timing, "SHORTEST", 1e-7)


def test_scenes() -> None:
    """A scene is missing, has no second hypothesis though its compliance is finite, or has one though it is not."""
    assert len(NAMES) == 11
    for scene in SCENES:
        slides = scene.loading is not None and scene.loading.slides(scene.fabric.D33)
        both = {other.hypothesis for other in SCENES if other.name == scene.name} == set(Hypothesis)
        assert both is not slides, scene.label
    tilt = scene_of("near-tangency").loading.tilt(0.0)
    assert tilt is not None
    assert float(1 - tilt) == pytest.approx(2e-9, rel=1e-6)  # kappa = 1 - 1e-9, and kappa squared is the tilt


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.label)
def test_every_route_is_there(scene: CostScene) -> None:
    """A route is left out of a scene, in silence."""
    settings = settings_of(scene)
    assert tuple(dict.fromkeys(setting.route for setting in settings)) == ROUTE_NAMES
    kinds = {setting.route: setting.kind for setting in settings}
    assert kinds == {name: PRODUCT if name in ROUTES else OUTSIDE for name in ROUTE_NAMES}
    names = [(setting.route, setting.name) for setting in settings]
    assert len(set(names)) == len(names)
    assert [setting.name for setting in settings if setting.paper] == ["24 panels"]


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.label)
def test_routes_keep_their_promise(scene: CostScene) -> None:
    """The reference is wrong, a promise is broken, or the promise shown is not the one of that setting."""
    known = reference(scene)
    for setting in settings_of(scene, ("axial",)):
        if setting.name == "default":
            outcome = setting.call()
            assert outcome.promised is not None
            assert worst_error(outcome.components, known) <= outcome.promised < 1e-12


def test_closed_forms() -> None:
    """Errors are taken against something that is wrong in the last digits; a closed form evaluates an integrand."""
    costs = measured("equal-contacts", "closed_form", "exact", "certified")
    # floats round a dozen times, fractions once; balls are as good as asked for
    assert 0 < costs["closed_form", "floats"].error < 2e-15
    assert costs["exact", "default"].error <= 2.0**-53
    assert costs["certified", "50 digits"].error < 1e-50
    assert all(cost.evaluations == 0 and cost.failure is None for cost in costs.values())


def test_rules_by_their_setting() -> None:
    """A setting does not reach its rule: counts do not grow with it, or errors do not fall."""
    costs = measured("equal-contacts", "axial", "sphere", "midpoint", "gauss_x", "lebedev_scipy", "lebedev_quadpy",
                     "tanh_sinh", hypothesis=Hypothesis.STATIC)
    for route in ("sphere", "midpoint", "gauss_x", "lebedev_scipy", "lebedev_quadpy", "tanh_sinh"):
        rows = [cost for (name, setting), cost in costs.items() if name == route and setting != "default"]
        counts = [cost.evaluations for cost in sorted(rows, key=lambda cost: int(cost.setting.strip("adeglnopsvr ")))]
        assert counts == sorted(set(counts)), route
    assert costs["midpoint", "24 panels"].paper
    # second order: doubling the panels divides the error by four, to the next order in 1/24^2
    assert costs["midpoint", "24 panels"].error / costs["midpoint", "48 panels"].error == pytest.approx(
        4, rel=0.02)
    assert costs["gauss_x", "32 nodes"].error < 1e-13 < costs["gauss_x", "4 nodes"].error
    assert costs["sphere", "degree 23"].error == pytest.approx(  # two codes, one rule, up to rounding of a few units
        _lebedev(23), rel=1e-4)
    assert costs["axial", "rtol 1e-03"].evaluations <= costs["axial", "rtol 1e-14"].evaluations


def _lebedev(degree: int) -> float:
    scene = scene_of("equal-contacts", Hypothesis.STATIC)
    route = next(route for route in outside.CATALOGUE if route.name == "lebedev_scipy")
    return worst_error(route.run(scene, degree).components, reference(scene))


def test_failures_are_words() -> None:
    """A route that refuses, warns, or is stopped leaves a gap, or passes for a result."""
    costs = measured("sliding", "closed_form", "exact", "sphere", "sympy_evalf", "quad_points")
    for route, setting, part in (("closed_form", "default", "slip"), ("exact", "default", "equal stiffness"),
                                 ("sphere", "default", "without slip"), ("sympy_evalf", "any", "no closed form")):
        cost = costs[route, setting]
        assert cost.failure is not None
        assert part in cost.failure
        assert (cost.error, cost.time_ratio, cost.evaluations, cost.count) == (None, None, None, 0)
    assert costs["sphere", "degree 131"].error is not None  # a rule without a promise is still a rule
    assert costs["quad_points", "rtol 1e-12"].failure is None
    assert ("closed_form", "rtol 1e-03") not in costs  # a route that serves nothing is one row


def test_whatever_a_library_raises() -> None:
    """An exception, a warning or a value that is no number ends the study or is taken for a result."""
    def broken() -> Outcome:
        raise RuntimeError("it broke. And more")

    def stopped() -> Outcome:
        raise RouteFailed("stopped")

    scene = scene_of("isotropic")
    known = [float(value) for value in reference(scene)]
    settings = [Setting(route="quad", kind=OUTSIDE, name=name, call=call) for name, call in (
        ("broken", broken), ("stopped", stopped), ("nan", lambda: Outcome([*known[:5], float("nan")])),
        ("warned", lambda: Outcome(known, failure="not reached")), ("fine", lambda: Outcome(known)))]
    costs = measure_scene(scene, settings, rounds=2).costs
    assert [cost.failure for cost in costs] == [
        "RuntimeError: it broke", "stopped", "the result is not a finite number", "not reached", None]
    assert [cost.count for cost in costs] == [0, 0, 0, 2, 2]
    assert costs[3].error == costs[4].error < 1e-16


def test_a_library_that_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine without the comparison's libraries gets a traceback in place of a row that says so."""
    import importlib

    def without(name: str) -> object:
        raise ImportError(name)

    monkeypatch.setattr(importlib, "import_module", without)
    costs = measured("isotropic", "sympy_evalf")
    assert costs["sympy_evalf", "any"].failure == "sympy is not installed"


def test_slow_calls_are_timed_less_often(monkeypatch: pytest.MonkeyPatch) -> None:
    """A call that takes long is timed in every round, or never, or a quick one is left out of a round."""
    monkeypatch.setattr(timing, "LONGEST", 1.0)
    calls = [0, 0]

    def count(place: int) -> None:
        calls[place] += 1

    rounds: list[None] = []
    timings = time_ratios([lambda: count(0), lambda: count(1)], [0.4, 0.2], 9, lambda: rounds.append(None))
    assert [len(ratios) for ratios in timings.ratios] == [3, 5]
    assert calls == [3, 5]
    assert len(rounds) == 9
    assert len(timings.unit_seconds) == 8


def test_worst_error() -> None:
    """The worst component is not the one that counts, or a float is not taken as the number that it is."""
    assert worst_error([Fraction(3, 2), 1.0], [Fraction(1), Fraction(1)]) == 0.5
    assert worst_error([0.1], [Fraction(1, 10)]) == pytest.approx(5.55e-17, rel=1e-2)
    with pytest.raises(RouteFailed):
        worst_error([float("inf")], [Fraction(1)])


def test_graded_grains_differ_by_the_factor() -> None:
    """The moments of branch length are left out of the reference, or are put in the wrong place."""
    for hypothesis in Hypothesis:
        graded = scene_of("graded", hypothesis)
        plain = replace(graded, spread=None)
        ratios = {one / other for one, other in zip(reference(graded), reference(plain), strict=True)}
        assert len(ratios) == 1
        # stored moments: <l^2> = 1.6377, and 1/<l^-2> = 1/1.7720
        assert float(ratios.pop()) == pytest.approx(1.637717 if hypothesis is Hypothesis.KINEMATIC else 1 / 1.772005,
                                                    rel=1e-6)
