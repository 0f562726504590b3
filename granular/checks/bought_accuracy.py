"""What a wanted accuracy buys: directions of the rule along the meridian, its promise, and its true error."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from granular.checks.comparison import worst_relative
from granular.cost.scenes import SCENES, CostScene
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified

ACCURACIES = tuple(10.0**-k for k in range(3, 14))
"""Wanted relative accuracies [-]; below the last one rules are as fine as doubles are."""

DIGITS = 20
"""Of the known values: errors of 1e-16 are then known to 1e-4 of themselves."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bought:
    """One scene at one wanted accuracy, by the rule along the meridian.

    Attributes
    ----------
    rtol : float
        Wanted relative accuracy of every component [-].
    promised : float
        Relative error that the route promises [-].
    error : float
        True relative error of the worst component [-].
    evaluations : int
        Directions in which the integrand is evaluated [-].
    operations : int
        Operations, and functions as one each [-].
    """

    rtol: float
    promised: float
    error: float
    evaluations: int
    operations: int


def scene(name: str, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> CostScene:
    """Find a scene of the cost study.

    Parameters
    ----------
    name : str
        Its name.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    CostScene
        The scene.

    Notes
    -----
    Source: ``granular.cost.scenes``.
    """
    return next(one for one in SCENES if one.name == name and one.hypothesis is hypothesis)


@lru_cache(maxsize=32)
def bought(name: str, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> tuple[Bought, ...]:
    """Evaluate a scene at every accuracy and hold each result against certified values.

    Parameters
    ----------
    name : str
        Scene of the cost study, without spheroids that carry forces.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    tuple of Bought
        From loose to tight.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: errors against values of 20 certified digits. Source: :mod:`granular.routes.axial`,
    :mod:`granular.routes.certified`.

    Examples
    --------
    >>> loose, *_, tight = bought("kinetic")
    >>> loose.evaluations < tight.evaluations, loose.error <= loose.promised <= loose.rtol
    (True, True)
    """
    given = scene(name, hypothesis)
    known = [enclosure.midpoint for enclosure in certified.enclose(
        given.fabric, poisson_ratio=given.poisson_ratio, hypothesis=hypothesis, loading=given.loading, digits=DIGITS)]
    found = []
    for rtol in ACCURACIES:
        result = axial.evaluate(given.fabric, poisson_ratio=given.poisson_ratio, hypothesis=hypothesis,
                                loading=given.loading, rtol=rtol)
        work = result.work
        found.append(Bought(rtol=rtol, promised=result.relative_error,
                            error=worst_relative(result.components, known)[1], evaluations=result.evaluations,
                            operations=0 if work is None else work.operations + work.functions))
    return tuple(found)
