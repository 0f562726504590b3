"""Contacts drawn at random as a voice of their own: graded grains and spheroids, eq. (1) against what is evaluated."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from granular.checks.comparison import STANDARD_ERRORS, Comparison

if TYPE_CHECKING:
    from granular.scene import Scene

NAME = "monte_carlo"

ALLOWED = 5.0
"""Standard errors that count as agreement. With the distribution of Student for 400 parts, one component in 1.1 million
is further off by chance: one in 20,000 for all that are compared here."""

LARGEST_ERROR = 5e-3
"""A standard error beyond this share of the component would prove too little, and counts as a miss [-]."""

SOLID = {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}

SCENES: dict[str, dict[str, Any]] = {
    "gradation, s_r = 1.5": {
        "gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}},
    "gradation, s_r = 2, slip": {
        "gradation": {"distribution": "lognormal", "median": "0.2 mm", "spread": 2.0, "form": "classical"},
        "normals": 0.3, "ratio": 1.5, "friction": 0.3},
    "gradation, s_r = 1.5, static": {
        "gradation": {"distribution": "lognormal", "median": "1 m", "spread": 1.5},
        "normals": -0.3, "ratio": 1.2, "hypothesis": "static"},
    "spheroids, r = 0.5": {"shape": {"aspect_ratio": 0.5}},
    "spheroids, r = 2, slip": {"shape": {"aspect_ratio": 2.0}, "normals": 0.3, "ratio": 2.0, "friction": 0.2},
    "spheroids, r = 3, spin": {"shape": {"aspect_ratio": 3.0, "spin": "relaxed"}, "normals": -0.4, "ratio": 1.3},
    "spheroids, r = 0.7, static": {"shape": {"aspect_ratio": 0.7}, "normals": 0.5, "hypothesis": "static"},
    "graded spheroids, r = 0.6, spin": {
        "gradation": {"distribution": "lognormal", "median": "1 mm", "spread": 1.3},
        "shape": {"aspect_ratio": 0.6, "spin": "relaxed"}, "normals": 0.2, "ratio": 1.5, "friction": 0.4},
}
"""What is drawn, in few words."""


def scene_of(*, normals: float = 0.0, ratio: float = 1.0, friction: float | None = None,
             hypothesis: str = "kinematic", **tables: dict[str, Any]) -> Scene:
    """Build the scene of a case.

    Parameters
    ----------
    normals : float
        D33 of the contact normals [-].
    ratio : float
        Stress ratio sigma33/sigma11 [-].
    friction : float or None
        Friction coefficient [-].
    hypothesis : str
        "kinematic" or "static".
    **tables : dict
        [gradation] and [shape].

    Returns
    -------
    Scene
        The scene, under a mean stress of 28 kPa.

    Examples
    --------
    >>> scene_of(ratio=2.0).stress.mean_stress
    28000.0
    """
    from granular.scene import Scene

    solid = SOLID if friction is None else {**SOLID, "friction_coefficient": friction}
    return Scene.model_validate({
        "grains": solid, "packing": {"void_ratio": 0.5744, "contact_normals": {"D33": normals}},
        "stress": {"mean": "28 kPa", "ratio": ratio}, "model": {"hypothesis": hypothesis}, **tables})


def monte_carlo_comparisons(*, seed: int = 1999) -> Iterator[Comparison]:
    """Compare sampled contacts with the evaluation of the same scene.

    Parameters
    ----------
    seed : int
        Start of the random numbers.

    Returns
    -------
    iterator of Comparison
        One for each scene, in standard errors.

    Notes
    -----
    Accuracy: a million contacts for each scene. Source: eq. (1).

    Examples
    --------
    >>> len(SCENES)
    8
    """
    from granular.checks.sampled_scenes import sampled_stiffness
    from granular.evaluation import evaluate
    from granular.routes.result import COMPONENTS

    for number, (case, words) in enumerate(SCENES.items()):
        scene = scene_of(**words)
        known = evaluate(scene)
        found = sampled_stiffness(scene, seed=seed + number)
        off = {}
        for name, value, error in zip(COMPONENTS, found.components, found.standard_errors, strict=True):
            true = getattr(known.stiffness, name)
            off[name] = abs(value - true) / error if error <= LARGEST_ERROR * true else float("inf")
        worst = max(off, key=lambda name: off[name])
        yield Comparison(group=f"sampled: {'graded' if 'gradation' in words else 'spheroids'}", case=case,
                         hypothesis=known.hypothesis, route=NAME, component=worst, error=off[worst],
                         allowed=ALLOWED, unit=STANDARD_ERRORS)
