"""What a measurement says to someone who wants an accuracy: the cheapest way, with a promise and in hindsight."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from granular.cost.records import OUTSIDE, PRODUCT

if TYPE_CHECKING:
    from granular.cost.records import Cost
    from granular.figures.cost_data import MeasuredScene

WANTED = (1e-3, 1e-6, 1e-9, 1e-12)
"""Accuracies in tables and sentences [-]; outside routes that take a tolerance were asked for these."""


def cheapest(costs: Iterable[Cost]) -> Cost | None:
    """Find the cheapest of some measurements.

    Parameters
    ----------
    costs : iterable of Cost
        Measurements with a time.

    Returns
    -------
    Cost or None
        The first one of least time; None when there are none.

    Notes
    -----
    Source: the median times.
    """
    return min(costs, key=time_of, default=None)


def time_of(cost: Cost) -> float:
    """Time of a measurement that has one.

    Parameters
    ----------
    cost : Cost
        A measurement.

    Returns
    -------
    float
        Time over that of the unit [-].

    Raises
    ------
    ValueError
        It was not timed.

    Notes
    -----
    Source: the record.
    """
    if cost.time_ratio is None:
        raise ValueError(f"{cost.route}, {cost.setting} was not timed")
    return cost.time_ratio


def error_of(cost: Cost) -> float:
    """Error of a measurement that has one.

    Parameters
    ----------
    cost : Cost
        A measurement.

    Returns
    -------
    float
        Relative error of the worst component [-].

    Raises
    ------
    ValueError
        It gave no components.

    Notes
    -----
    Source: the record.
    """
    if cost.error is None:
        raise ValueError(f"{cost.route}, {cost.setting} gave nothing")
    return cost.error


def promised_for(scene: MeasuredScene, wanted: float) -> Cost | None:
    """Find the cheapest way of this package that states beforehand an error small enough.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.
    wanted : float
        Relative error of the worst component [-].

    Returns
    -------
    Cost or None
        Of each route the setting that is asked for just this error or, where there is none, its cheapest one that
        states less; of these the cheapest.

    Notes
    -----
    Source: the errors that the routes declare, not the measured ones.
    """
    name = f"rtol {wanted:.0e}"
    good = [cost for cost in scene.sound if cost.kind == PRODUCT and cost.promised is not None
            and cost.promised <= wanted]
    asked = [cost for cost in good if cost.setting == name]
    served = {cost.route for cost in asked}
    return cheapest([*asked, *(cost for cost in good if cost.route not in served)])


def in_hindsight(scene: MeasuredScene, wanted: float, kind: str = OUTSIDE) -> Cost | None:
    """Find the cheapest way of a kind whose error turned out small enough.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.
    wanted : float
        Relative error of the worst component [-].
    kind : str
        "outside" or "product".

    Returns
    -------
    Cost or None
        None when nothing was accurate enough.

    Notes
    -----
    Source: errors against certified values, which nobody has who needs the number.
    """
    return cheapest(cost for cost in scene.sound if cost.kind == kind and error_of(cost) <= wanted)


def outside_asked_for(scene: MeasuredScene, wanted: float) -> Cost | None:
    """Find the cheapest outside way that was asked for an error and kept to it.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.
    wanted : float
        Relative error of the worst component [-].

    Returns
    -------
    Cost or None
        None when none was asked for it, or none of them reached it.

    Notes
    -----
    Source: settings that are tolerances.
    """
    name = f"rtol {wanted:.0e}"
    return cheapest(cost for cost in scene.sound
                    if cost.kind == OUTSIDE and cost.setting == name and error_of(cost) <= wanted)


def as_good_as_paper(scene: MeasuredScene) -> Cost | None:
    """Find the cheapest way of this package that is at least as accurate as the rule of the printed tables.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.

    Returns
    -------
    Cost or None
        None when the rule was not measured or nothing else is as accurate.

    Notes
    -----
    Source: errors against certified values. Other numbers of panels of the same rule do not count.
    """
    paper = scene.paper
    if paper is None:
        return None
    return cheapest(cost for cost in scene.sound if cost.kind == PRODUCT and cost.route != paper.route
                    and error_of(cost) <= error_of(paper))


def front(scene: MeasuredScene) -> list[Cost]:
    """Find the measurements that nothing beats in both time and error.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.

    Returns
    -------
    list of Cost
        In rising time and falling error.

    Notes
    -----
    Source: Pareto's order of (time, error).
    """
    best: list[Cost] = []
    for cost in sorted(scene.sound, key=lambda one: (time_of(one), error_of(one))):
        if not best or error_of(cost) < error_of(best[-1]):
            best.append(cost)
    return best
