"""The values that errors are taken against: ball arithmetic, and stored quadrature of many digits where it ends."""

from __future__ import annotations

import json
from fractions import Fraction
from importlib.resources import files

from granular.cost.scenes import CostScene
from granular.hypothesis import Hypothesis
from granular.routes import certified

DIGITS = 120
"""Digits of values from ball arithmetic [-]."""

STORED_DIGITS = 33
"""Digits of stored values of spheroids with contact forces [-]."""

GRADED_DIGITS = 29
"""Digits of stored moments of branch length [-]."""


def reference_digits(scene: CostScene) -> int:
    """How many digits of the reference values are right [-]."""
    if scene.spread is not None:
        return GRADED_DIGITS
    return DIGITS if scene.fabric.collinear or scene.loading is None else STORED_DIGITS


def reference(scene: CostScene) -> tuple[Fraction, ...]:
    """Six components to :func:`reference_digits`.

    Parameters
    ----------
    scene : CostScene
        What is computed.

    Returns
    -------
    tuple of 6 Fraction
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-]; for graded grains l_e is twice the
        radius of the sphere of mean volume.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: :func:`reference_digits`. Source: ``granular.routes.certified``; ``granular/data``.
    """
    if not scene.fabric.collinear and scene.loading is not None:
        return _stored(scene)
    six = tuple(enclosure.midpoint for enclosure in certified.enclose(
        scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis, loading=scene.loading,
        digits=DIGITS))
    if scene.spread is None:
        return six
    factor = _length_factor(scene.spread, scene.hypothesis)
    return tuple(component * factor for component in six)


def _stored(scene: CostScene) -> tuple[Fraction, ...]:
    from granular.checks.stored import spheroid_cases

    return next(case.known[scene.hypothesis] for case in spheroid_cases()
                if (case.fabric, case.loading, case.poisson_ratio) ==
                (scene.fabric, scene.loading, scene.poisson_ratio))


def _length_factor(spread: float, hypothesis: Hypothesis) -> Fraction:
    """<l^2>, or 1/<l^-2> under the static hypothesis, over the square of twice the radius of mean volume."""
    stored = json.loads(files("granular").joinpath("data", "certified_gradation.json").read_text(encoding="utf-8"))
    case = next(case for case in stored["cases"] if Fraction(case["spread"]) == Fraction(spread))
    if hypothesis is Hypothesis.KINEMATIC:
        return Fraction(case["second"])
    return 1 / Fraction(case["inverse_second"])
