"""Every route against ball arithmetic at random admissible inputs, certified on the fly."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from granular.checks.comparison import Comparison, worst_component, worst_relative
from granular.checks.loads import loaded_sample
from granular.checks.sample import admissible_sample
from granular.checks.voices import MOST_ERROR, Voice, allowed_error, allowed_units, attempt, voices
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified


def sample_comparisons(count: int = 60, *, seed: int = 1999) -> Iterator[Comparison]:
    """Compare every route with ball arithmetic at random fabrics whose contacts all have the same stiffness.

    Parameters
    ----------
    count : int
        How many fabrics [-].
    seed : int
        Start of the random numbers.

    Returns
    -------
    iterator of Comparison
        One for each fabric, hypothesis and route that serves it; none where python-flint is not installed.

    Notes
    -----
    Accuracy: see :func:`granular.checks.voices.allowed_units`. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> all(comparison.agrees for comparison in sample_comparisons(3))
    True
    """
    if not certified.available():
        return
    for number, (fabric, nu) in enumerate(admissible_sample(count, seed=seed), start=1):
        for hypothesis in Hypothesis:
            known = certified_components(fabric, nu, hypothesis, None)
            for voice in _others():
                result = attempt(voice, fabric, nu, hypothesis)
                if result is not None:
                    component, error = worst_component(result.components, known)
                    yield Comparison(group=f"random, rank {2 if fabric.D3333 == 0 else 4}", case=f"number {number}",
                                     hypothesis=hypothesis, route=voice.NAME, component=component, error=error,
                                     allowed=allowed_units(voice, result))


def loaded_comparisons(count: int = 60, *, seed: int = 1999) -> Iterator[Comparison]:
    """Compare every route with ball arithmetic at random inputs with contact forces.

    Parameters
    ----------
    count : int
        How many inputs [-].
    seed : int
        Start of the random numbers.

    Returns
    -------
    iterator of Comparison
        One for each input, hypothesis and route that serves it; none where python-flint is not installed.

    Notes
    -----
    Accuracy: see :func:`granular.checks.voices.allowed_error`. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> all(comparison.agrees for comparison in loaded_comparisons(2))
    True
    """
    if not certified.available():
        return
    for number, case in enumerate(loaded_sample(count, seed=seed), start=1):
        for hypothesis in Hypothesis:
            if hypothesis is Hypothesis.STATIC and case.kind != "stick":
                continue
            known = certified_components(case.fabric, case.poisson_ratio, hypothesis, case.loading)
            for voice in _others():
                result = attempt(voice, case.fabric, case.poisson_ratio, hypothesis, case.loading)
                if result is not None:
                    component, error, units = worst_relative(result.components, known)
                    allowed = allowed_error(voice, result, aim=MOST_ERROR[hypothesis])
                    yield Comparison(group=f"random, contacts {case.kind}", case=f"number {number}",
                                     hypothesis=hypothesis, route=voice.NAME, component=component,
                                     error=error * units, allowed=allowed * units)


@lru_cache(maxsize=4096)
def certified_components(fabric: AxialFabric, poisson_ratio: float, hypothesis: Hypothesis,
                         loading: Loading | None) -> tuple[Fraction, ...]:
    """Middles of the six enclosures, kept for the next comparison with the same inputs.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction; None for contacts that all have the same stiffness.

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: 1e-30 of each. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> certified_components(AxialFabric(), 0.0, Hypothesis.KINEMATIC, None)[2]
    Fraction(0, 1)
    """
    found = certified.enclose(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    return tuple(enclosure.midpoint for enclosure in found)


def _others() -> list[Voice]:
    return [voice for voice in voices() if voice is not certified]
