"""What a wanted accuracy buys along the meridian: errors as stated, fewer nodes for less, all as predicted."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import pytest

from granular.checks.loads import loaded_sample
from granular.checks.sample import SHRINK, admissible_sample
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified
from granular.routes.arithmetic import FLOAT_ERROR, QUICK
from granular.routes.fineness import FULL, amplification, fineness_for

RTOL = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)

KINDS = ("equal", "frictionless", "sticking", "sliding", "next to sliding", "opened", "friction at its ends",
         "cancelling density")

EACH = 18
"""Scenes of a kind [-]."""


@dataclass(frozen=True)
class Drawn:
    """A scene: numbers for one evaluation."""

    fabric: AxialFabric
    loading: Loading | None
    poisson_ratio: float
    hypothesis: Hypothesis


def of_kind(kind: str, fabric: AxialFabric, loading: Loading, rng: random.Random) -> Loading | None:
    """The loading, made over into one of that kind; the others of a sample are passed on as they were drawn."""
    if kind == "equal":
        return None
    if kind == "cancelling density":
        return rng.choice((None, loading))
    ratio = math.exp2(rng.uniform(-3, 3)) if kind != "opened" else -10 ** rng.uniform(-12, 0)
    if kind == "frictionless":
        return Loading.of_ratio(ratio, friction=rng.choice((None, 0.0)))
    a, c = Loading.of_ratio(ratio).coefficients(fabric.D33)
    onset = math.sqrt((c - a) ** 2 / (4 * abs(a * c))) or 1.0
    friction = {"sticking": onset * (1 + 10 ** rng.uniform(-1, 2)), "sliding": onset * rng.uniform(0.01, 0.9),
                "next to sliding": onset * (1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-15, -2)),
                "friction at its ends": rng.choice((1e-10, 1e-4, 1e4, 1e6, onset)),
                "opened": rng.choice((None, 0.0, rng.uniform(0.05, 1.0), 1e-6, 1e6))}[kind]
    return Loading.of_ratio(ratio, friction=friction)


def scenes_of(kind: str) -> Iterator[Drawn]:
    """Scenes of a kind, under every hypothesis that gives a finite answer."""
    rng, found = random.Random(f"fineness {kind}"), 0
    for case in loaded_sample(1000, seed=KINDS.index(kind)):
        if kind == "cancelling density" and not case.fabric.density_coefficients()[1] < 0:
            continue
        loading = of_kind(kind, case.fabric, case.loading, rng)
        for hypothesis in Hypothesis:
            if hypothesis is Hypothesis.STATIC and loading is not None and (
                    loading.opens() or loading.slides(case.fabric.D33) or loading.friction == 0):
                continue
            yield Drawn(case.fabric, loading, case.poisson_ratio, hypothesis)
            found += 1
        if found >= EACH:
            return


def evaluated(scene: Drawn, rtol: float) -> axial.RouteResult:
    return axial.evaluate(scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis,
                          loading=scene.loading, rtol=rtol)


@cache
def known(scene: Drawn) -> tuple[Fraction, ...]:
    """Middles of enclosures whose radius, 1e-20 of the value, is beyond what any test here looks at."""
    return tuple(one.midpoint for one in certified.enclose(
        scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis, loading=scene.loading, digits=20))


def true_error(components: tuple[float, ...], scene: Drawn) -> float:
    """Of the worst component, relative to it."""
    return max(0.0 if value == one else float(abs(Fraction(value) - one) / abs(one)) if one else math.inf
               for value, one in zip(components, known(scene), strict=True))


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_wanted_is_kept_and_predicted(kind: str) -> None:
    """More error than is stated, more stated than was wanted, another prediction, or more nodes for less breaks it."""
    count = spared = 0
    for scene in scenes_of(kind):
        results = [evaluated(scene, rtol) for rtol in RTOL]
        for result, rtol in zip(results, RTOL, strict=True):
            error = true_error(result.components, scene)
            assert error <= result.relative_error <= rtol, (scene, rtol, error, result)
            promised = axial.promise(scene.fabric, scene.hypothesis, scene.loading, rtol=rtol)
            assert promised.kept(result.components) == result
        evaluations = [result.evaluations for result in results]
        assert evaluations == sorted(evaluations), scene
        count += 1
        spared += evaluations[0] < evaluations[-1]
    assert count >= EACH
    # polynomials take the same nodes whatever is wanted; under the kinematic hypothesis equal contacts are such
    assert spared >= (count / 4 if kind == "equal" else count / 2)


POLAR = AxialFabric(D33=20 / 7 * SHRINK, D3333=8 / 7 * SHRINK, Dr33=1.9999)
"""Contacts and long branches about the pole alone: a density next to 5 x^4."""


@pytest.mark.parametrize(("fabric", "ratio", "rtol"), [
    (AxialFabric(D33=2.0, Dr33=1.9999), 3 * (1 + 1e-9), 1e-4),
    (POLAR, 8.5e-15, 5e-13),
    (POLAR, 6.6e-15, 4.8e-10),
    (POLAR, 3.7e-13, 1.9e-13),
    (POLAR, 2e-11, 9.4e-12),
])
def test_averages_that_are_small_beside_the_integrand(fabric: AxialFabric, ratio: float, rtol: float) -> None:
    """Where contacts and branches are all about the pole, C1122 is a hundredth of what its integrand reaches.

    A bound that forgets it breaks this, and so does one that forgets how the map of the nodes grows off the line.
    """
    scene = Drawn(fabric, Loading.of_ratio(ratio), 0.21, Hypothesis.KINEMATIC)
    result = evaluated(scene, rtol)
    assert true_error(result.components, scene) <= result.relative_error <= rtol


@pytest.mark.parametrize(("branches", "ratio", "friction", "rtol"), [
    (1.9999999, 1.5038756154257413, 0.0003551480018119701, 4.305991024357746e-07),
    (-0.9999, 8230.206481439509, 1.714545855731472e-05, 4.307840025670267e-07),
])
def test_averages_that_are_small_beside_what_slips(branches: float, ratio: float, friction: float,
                                                   rtol: float) -> None:
    """Hardly any friction and contacts about the pole alone: the worst of 3,000 draws and as many steps from there."""
    scene = Drawn(AxialFabric(D33=POLAR.D33, D3333=POLAR.D3333, Dr33=branches),
                  Loading.of_ratio(ratio, friction=friction), 0.21, Hypothesis.KINEMATIC)
    result = evaluated(scene, rtol)
    assert true_error(result.components, scene) <= result.relative_error <= rtol


@pytest.mark.parametrize("hypothesis", Hypothesis)
def test_settings_follow_what_is_wanted(hypothesis: Hypothesis) -> None:
    """Nodes are closer, or windows longer, for a looser accuracy; or the budget leaves nothing to rounding."""
    for fabric, _ in admissible_sample(40, seed=8):
        found = [fineness_for(rtol, fabric, hypothesis) for rtol in RTOL]
        assert [one.steps for one in found] == sorted(one.steps for one in found)
        assert [one.error for one in found] == sorted((one.error for one in found), reverse=True)
        for one, rtol in zip(found, RTOL, strict=True):
            assert 0 < amplification(fabric, hypothesis) * one.error + FLOAT_ERROR <= rtol
            assert one.share > 0


def test_the_finest_is_what_doubles_hold() -> None:
    """An accuracy that is not stated, or one that floats do not keep, is served by anything but the full rule."""
    for rtol in (None, math.nextafter(QUICK, 0.0), 1e-15):
        assert fineness_for(rtol, AxialFabric(), Hypothesis.KINEMATIC) is FULL


def test_no_accuracy_is_looser_than_the_models_of_errors_hold() -> None:
    """An accuracy of 1 or more asks for no nodes at all, or is answered with an error that is no error any more."""
    for rtol in (0.5, 1.0, 1e6, math.inf):
        scene = Drawn(AxialFabric(D33=0.3), Loading.of_ratio(2.0, friction=0.2), 0.21, Hypothesis.KINEMATIC)
        result = evaluated(scene, rtol)
        assert true_error(result.components, scene) <= result.relative_error <= 0.1
