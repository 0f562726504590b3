"""Aligned spheroids: every route against ball arithmetic at random shapes, and against the limits of the shape."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from granular.checks.comparison import Comparison, worst_component
from granular.checks.limits import Known
from granular.checks.on_the_fly import certified_components
from granular.checks.spheroid_cases import spheroid_sample
from granular.checks.spheroid_limits import near_the_sphere, needles, plates
from granular.checks.voices import MOST_UNITS, UNIT, Voice, allowed_units, attempt, voices
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import certified

NORMALS = (AxialFabric(), AxialFabric(D33=0.3), AxialFabric(D33=-1.0), AxialFabric(D33=-0.5, D3333=0.4))
"""Contact normals of the limits; contacts at the equator, without which needles have another limit."""

NEAR, SLENDER = 2.0**-30, 2.0**39
"""The square of r^2 - 1, of r of plates and of 1/r of needles are then below rounding; the sizes are powers of 2."""

LIMITS: tuple[tuple[str, Known, tuple[float, ...], float], ...] = (
    ("spheroids: r to 1", near_the_sphere, (1 - NEAR, 1.0, 1 + NEAR), 16 * NEAR**2),
    ("spheroids: r to 0", plates, (1 / SLENDER,), 0.0),
    ("spheroids: r to inf", needles, (SLENDER,), 0.0))
"""Group, limit, aspect ratios, and how far the limit itself may be off [-]."""


def spheroid_comparisons(count: int = 60, *, seed: int = 1999) -> Iterator[Comparison]:
    """Compare every route with ball arithmetic at random spheroids, with both spins and under both hypotheses.

    Parameters
    ----------
    count : int
        How many shapes [-].
    seed : int
        Start of the random numbers.

    Returns
    -------
    iterator of Comparison
        One for each shape, hypothesis, spin and route that serves it; none where python-flint is not installed.

    Notes
    -----
    Accuracy: see :func:`granular.checks.voices.allowed_units`. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> all(comparison.agrees for comparison in spheroid_comparisons(3))
    True
    """
    if not certified.available():
        return
    others = [voice for voice in voices() if voice is not certified]
    for number, case in enumerate(spheroid_sample(count, seed=seed), start=1):
        for hypothesis, spin in ((Hypothesis.KINEMATIC, False), (Hypothesis.KINEMATIC, True),
                                 (Hypothesis.STATIC, False)):
            fabric = replace(case.fabric, free_spin=spin)
            known = certified_components(fabric, case.poisson_ratio, hypothesis, None)
            rank = 2 if fabric.D3333 == 0 else 4
            yield from _compared(others, fabric, case.poisson_ratio, hypothesis, known,
                                 f"{'free spin' if spin else 'spheroids'}, rank {rank}", f"number {number}")


def spheroid_limit_comparisons() -> Iterator[Comparison]:
    """Compare every route with the limits of the aspect ratio.

    Returns
    -------
    iterator of Comparison
        One for each limit, fabric, spin, Poisson's ratio and route that serves them.

    Notes
    -----
    Accuracy: see :func:`granular.checks.voices.allowed_units`, and what the limit leaves out besides. Source:
    ``derivations.spheroid_limits``.

    Examples
    --------
    >>> all(comparison.agrees for comparison in spheroid_limit_comparisons())
    True
    """
    for group, limit, shapes, left_out in LIMITS:
        for normals, shape, spin, nu in product(NORMALS, shapes, (False, True), (0.0, 0.21, 0.5)):
            fabric = replace(normals, aspect_ratio=shape, free_spin=spin)
            case = f"D33 = {fabric.D33:g}, D3333 = {fabric.D3333:g}, r = {shape!r}, spin {spin}, nu = {nu:g}"
            yield from _compared(voices(), fabric, nu, Hypothesis.KINEMATIC, limit(fabric, nu), group, case,
                                 left_out=left_out)


def _compared(usable: Sequence[Voice], fabric: AxialFabric, nu: float, hypothesis: Hypothesis,
              known: tuple[Fraction, ...], group: str, case: str, *, left_out: float = 0.0) -> Iterator[Comparison]:
    for voice in usable:
        result = attempt(voice, fabric, nu, hypothesis)
        if result is not None:
            component, error = worst_component(result.components, known)
            yield Comparison(group=group, case=case, hypothesis=hypothesis, route=voice.NAME, component=component,
                             error=error,
                             allowed=allowed_units(voice, result, aim=MOST_UNITS) + left_out / UNIT)
