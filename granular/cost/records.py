"""What is measured: one setting of one route on one scene, and what came of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from granular.hypothesis import Hypothesis

PRODUCT, OUTSIDE = "product", "outside"
"""Routes of this package, and other ways of computing the same numbers."""

Components = Sequence[Fraction] | Sequence[float]
"""C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-], exact as they stand."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cost:
    """What one setting of one route gives and takes.

    Attributes
    ----------
    scene : str
        Name of the scene.
    hypothesis : Hypothesis
        Kinematic or static.
    route : str
        Which way of computing.
    kind : str
        "product" or "outside".
    setting : str
        Its tolerance, arithmetic, nodes, degree, panels or digits.
    paper : bool
        The rule that the printed tables carry.
    error : float or None
        Relative error of the worst component [-]; None when there are no components.
    promised : float or None
        What the route declares for it beforehand [-]; None where it declares nothing.
    evaluations : int or None
        Directions in which the integrand was evaluated [-], sizes of grains not counted; 0 for a closed form, None
        without a result.
    time_ratio : float or None
        Time of one call over that of the unit in the same round, median of the rounds [-].
    spread : float or None
        Half the distance of the quartiles of that ratio, over the ratio [-].
    count : int
        How often it was timed [-].
    failure : str or None
        What went wrong, in words.
    """

    scene: str
    hypothesis: Hypothesis
    route: str
    kind: str
    setting: str
    paper: bool = False
    error: float | None
    promised: float | None
    evaluations: int | None
    time_ratio: float | None
    spread: float | None
    count: int
    failure: str | None


@dataclass(frozen=True, slots=True)
class Outcome:
    """What one call gave.

    Attributes
    ----------
    components : sequence of 6 Fraction or float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].
    promised : float or None
        Declared error [-].
    evaluations : int or None
        Directions in which the integrand was evaluated [-].
    failure : str or None
        What the route warned of, in words.
    """

    components: Components
    promised: float | None = None
    evaluations: int | None = 0
    failure: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Setting:
    """One setting of one route, ready to be called on one scene."""

    route: str
    kind: str
    name: str
    call: Callable[[], Outcome]
    paper: bool = False


class RouteFailed(Exception):
    """A route gives no components here; the message is the reason in words."""


class NotServed(RouteFailed):
    """A route serves the scene in none of its settings; the message is the reason in words."""


def worst_error(components: Components, known: Sequence[Fraction]) -> float:
    """Relative error of the worst component; floats and fractions are both exact numbers here.

    Parameters
    ----------
    components : sequence of 6 Fraction or float
        Components to be judged [-].
    known : sequence of 6 Fraction
        Reference values [-].

    Returns
    -------
    float
        The error [-].

    Raises
    ------
    RouteFailed
        A component is not a finite number.

    Examples
    --------
    >>> worst_error([1.0, 0.75], [Fraction(1), Fraction(1)])
    0.25
    """
    if not all(math.isfinite(component) for component in components):
        raise RouteFailed("the result is not a finite number")
    exact = [Fraction(components[place]) for place in range(len(components))]
    return max(float(abs(one - other) / other) for one, other in zip(exact, known, strict=True))
