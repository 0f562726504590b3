"""The worst error of many elements, found on a few of them by ball arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from granular.speed.questions import Friction, Question
from granular.speed.sample import sample

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.routes.certified import Enclosure

    Array = NDArray[np.float64]

FEW = 24
"""Elements of a sample that are held against ball arithmetic [-]: its first ones."""

FEW_SLOPES = 6
"""Elements whose slopes are held against differences of it [-]."""

STEP = Fraction(1, 2**90)
"""Half the distance of the two states of a difference, which errs by its square times a third derivative [-]."""

DIGITS = 60
"""Digits of the enclosures whose difference is taken [-]."""

FRICTION, POISSON = 3, 4
"""Places among the arguments."""

Six = tuple[float, ...]


def certified(question: Question) -> tuple[Six, ...]:
    """Components of the first elements of the sample, every digit proved.

    Parameters
    ----------
    question : Question
        What is asked of them, however exactly.

    Returns
    -------
    tuple of tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: half a unit in the last place. Source: the route ``certified``.
    """
    return _certified(replace(question, rtol=None))  # the true value is the same whatever accuracy is asked for


@lru_cache(maxsize=16)
def _certified(question: Question) -> tuple[Six, ...]:
    from granular.fabric import AxialFabric
    from granular.loading import Loading
    from granular.routes.catalogue import ROUTES

    found = []
    for D33, Dr33, ratio, friction, poisson in _states(question, FEW):
        loading = Loading.of_ratio(ratio, friction=friction) if question.kinetic else None
        found.append(ROUTES["certified"].evaluate(AxialFabric(D33=D33, Dr33=Dr33), poisson_ratio=poisson,
                                                  hypothesis=question.hypothesis, loading=loading).components)
    return tuple(found)


def _states(question: Question, count: int) -> list[tuple[Any, ...]]:
    """Arguments of the first elements, one element a tuple."""
    columns = question.arguments(sample(count))
    return list(zip(*(column.tolist() if hasattr(column, "tolist") else [column] * count for column in columns),
                    strict=True))


def worst_error(question: Question, call: Callable[[], object]) -> float:
    """Worst relative error of any component of the first elements.

    Parameters
    ----------
    question : Question
        What is asked of them.
    call : callable
        Gives the components of the sample, (n, 6) [-], n at least ``FEW``.

    Returns
    -------
    float
        The error [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Source: :func:`certified`.
    """
    import numpy as np

    known = np.array(certified(question))
    found = np.asarray(call())[:FEW]
    return float(np.abs(found / known - 1).max())


def worst_slope_error(question: Question, call: Callable[[], tuple[Array, Array]]) -> float:
    """Worst error of any slope of the first elements, over the larger of the slope and the largest component.

    Parameters
    ----------
    question : Question
        What is asked of them.
    call : callable
        Gives the components, (n, 6), and the slopes, (n, 6, 5) [-], n at least ``FEW_SLOPES``.

    Returns
    -------
    float
        The error [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: the differences are right to 1e-30. Source: :func:`certified_slopes`.
    """
    import numpy as np

    known = np.array(certified_slopes(replace(question, rtol=None)))
    value, slopes = (array[:FEW_SLOPES] for array in call())
    scale = np.maximum(abs(known), value.max(axis=1)[:, None, None])
    return float((abs(slopes - known) / scale).max())


@lru_cache(maxsize=8)
def certified_slopes(question: Question) -> tuple[tuple[Six, ...], ...]:
    """Slopes of the first elements by central differences of ball arithmetic in many digits.

    Parameters
    ----------
    question : Question
        What is asked of them.

    Returns
    -------
    tuple
        For each element and component the slopes by D33, Dr33, stress ratio, friction and Poisson's ratio [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: 1e-30. Source: the route ``certified``.
    """
    found = []
    for state in _states(question, FEW_SLOPES):
        columns = [_difference(question, state, place) for place in range(len(state))]
        found.append(tuple(zip(*columns, strict=True)))
    return tuple(found)


def _difference(question: Question, state: tuple[Any, ...], place: int) -> Six:
    if place == FRICTION and question.friction is Friction.NONE:
        return (0.0,) * 6
    above, below = ([one.midpoint for one in _enclosed(question, state, place, sign * STEP)] for sign in (1, -1))
    return tuple(float((high - low) / (2 * STEP)) for high, low in zip(above, below, strict=True))


def _enclosed(question: Question, state: tuple[Any, ...], place: int, step: Fraction) -> tuple[Enclosure, ...]:
    from granular.fabric import AxialFabric
    from granular.loading import Loading
    from granular.routes import certified as route

    exact: list[Any] = [None if number is None else Fraction(number) for number in state]
    exact[place] += step
    loading = Loading.of_ratio(exact[2], friction=exact[FRICTION]) if question.kinetic else None
    return route.enclose(AxialFabric(D33=exact[0], Dr33=exact[1]), poisson_ratio=exact[POISSON],
                         hypothesis=question.hypothesis, loading=loading, digits=DIGITS)
