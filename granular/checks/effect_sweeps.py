"""The bound of each effect along its own parameter, from hardly there to strong, beside what it really changes."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from granular.checks.effect_examples import change_without, scene_with
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.scene import Scene

WEAKEST = 1e-5
"""Where every sweep begins [-]: changes are far above the rounding of two evaluations."""

POINTS = 13
"""Along each sweep [-]."""

STRESS_RATIO = 1.5
"""Under which contacts carry the shear forces that friction is held against [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sweep:
    """A parameter that makes an effect as weak or as strong as one likes.

    Attributes
    ----------
    name : str
        The effect.
    parameter : str
        What is varied, as TeX.
    change : callable
        From the parameter [-] to what is added to the plain scene.
    strongest : float
        Where the sweep ends [-].
    """

    name: str
    parameter: str
    change: Callable[[float], str]
    strongest: float

    def scene(self, strength: float, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Scene:
        """The scene at one value of the parameter [-]."""
        return scene_with(self.change(strength), hypothesis=hypothesis)


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """One scene of a sweep.

    Attributes
    ----------
    strength : float
        The parameter [-].
    bound : float
        For the relative change of any component without the effect [-]; infinite where nothing is proved.
    change : float
        The true one, of the worst component [-].
    """

    strength: float
    bound: float
    change: float


def _friction_used_up(share: float) -> str:
    """Friction that contacts use up to some share where they are nearest to sliding, eq. (21)."""
    tilt = (STRESS_RATIO - 1) / (2 * math.sqrt(STRESS_RATIO))
    return f"[grains]\nfriction_coefficient = {tilt / share!r}\n[stress]\nratio = {STRESS_RATIO!r}"


SWEEPS: tuple[Sweep, ...] = (
    Sweep(name="packing", parameter="$D_{33}$", strongest=1.0,
          change=lambda d: f"[packing]\ncontact_normals = {{ D33 = {d!r} }}"),
    Sweep(name="branches", parameter="$D^{r}_{33}$", strongest=0.9,
          change=lambda d: f"[branches]\nanisotropy = {{ D33 = {d!r} }}"),
    Sweep(name="gradation", parameter="$s_r - 1$", strongest=1.0,
          change=lambda d: f'[gradation]\ndistribution = "lognormal"\nmedian = "5 mm"\nspread = {1 + d!r}'),
    Sweep(name="deviation", parameter="$1 - b/a$", strongest=0.66,
          change=lambda d: f"[shape]\naspect_ratio = {1 - d!r}"),
    Sweep(name="kinetic", parameter=r"$\sigma_{33}/\sigma_{11} - 1$", strongest=9.0,
          change=lambda d: f"[stress]\nratio = {1 + d!r}"),
    Sweep(name="slip", parameter=r"$\kappa$, friction used up", strongest=0.999, change=_friction_used_up),
)
"""One for each effect that can be weak; contacts open or do not."""


def strengths(sweep: Sweep) -> tuple[float, ...]:
    """Values of the parameter of a sweep.

    Parameters
    ----------
    sweep : Sweep
        Which one.

    Returns
    -------
    tuple of float
        ``POINTS`` of them [-], evenly spaced on a logarithmic axis.

    Notes
    -----
    Source: the definition.
    """
    step = math.log(sweep.strongest / WEAKEST) / (POINTS - 1)
    return (*(WEAKEST * math.exp(step * k) for k in range(POINTS - 1)), sweep.strongest)


@lru_cache(maxsize=16)
def points(sweep: Sweep, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> tuple[Point, ...]:
    """Bound and true change along a sweep.

    Parameters
    ----------
    sweep : Sweep
        Which one.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    tuple of Point
        From weak to strong.

    Notes
    -----
    Accuracy: bounds are rigorous, changes good to 1e-14. Source: :mod:`granular.effects`, ``granular.evaluate``.

    Examples
    --------
    >>> all(0 < point.change <= point.bound for point in points(SWEEPS[1]))
    True
    """
    found = []
    for strength in strengths(sweep):
        scene = sweep.scene(strength, hypothesis)
        found.append(Point(strength=strength, bound=_bound(scene, sweep.name),
                           change=change_without(scene, sweep.name) or 0.0))
    return tuple(found)


def _bound(scene: Scene, name: str) -> float:
    from granular.effects.selection import select

    return select(scene).bounds[name]


def closest(sweep: Sweep, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> float:
    """How many times the true change the bound is at least, along a sweep.

    Parameters
    ----------
    sweep : Sweep
        Which one.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    float
        Least ratio of bound to true change [-], at least 1.

    Notes
    -----
    Source: :func:`points`.
    """
    return min(point.bound / point.change for point in points(sweep, hypothesis))


def as_columns(sweep: Sweep) -> dict[str, Any]:
    """Numbers of a sweep for a file to take away.

    Parameters
    ----------
    sweep : Sweep
        Which one.

    Returns
    -------
    dict
        Name of a column -> its numbers [-].

    Notes
    -----
    Source: :func:`points`.
    """
    columns: dict[str, list[float]] = {"parameter": list(strengths(sweep))}
    for hypothesis in Hypothesis:
        found = points(sweep, hypothesis)
        columns |= {f"bound, {hypothesis}": [point.bound for point in found],
                    f"change, {hypothesis}": [point.change for point in found]}
    return columns
