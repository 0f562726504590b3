"""Effect ``kinetic``: contact stiffness that follows the estimated contact force in each direction."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect
from granular.effects.ranges import Range

if TYPE_CHECKING:
    from granular.loading import Loading
    from granular.scene import Scene


def force_coefficients(scene: Scene) -> tuple[Fraction, Fraction]:
    """Estimated contact force at the equator and at the pole, over that of the isotropic assembly, exactly.

    Parameters
    ----------
    scene : Scene
        Gives the principal stresses and D33; D3333 does not enter the fabric tensor N of rank two.

    Returns
    -------
    tuple of Fraction
        a and c [-], see :meth:`granular.loading.Loading.coefficients`.

    Notes
    -----
    Exact for the doubles given. Source: eq. (23).
    """
    return scene.stress.loading(None).coefficients(scene.fabric.D33)


def _called_for(scene: Scene) -> Called:
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, "the estimated contact force is the same in every direction")
    if equator <= 0:
        return Called(True, "the estimated contact force varies with direction: "
                            + ("it vanishes at the equator" if equator == 0 else "it is a tension at the equator"))
    if pole < 0:
        return Called(True, "the estimated contact force varies with direction: it is a tension at the pole")
    return Called(True, "the estimated contact force varies with direction: at the pole it is "
                        f"{_decimal(pole / equator)} times that at the equator")


def _decimal(ratio: Fraction) -> str:
    try:
        return f"{float(ratio):.6g}"
    except OverflowError:
        return "more than 1e308"


def _add_to_loading(scene: Scene, loading: Loading | None) -> Loading:
    return loading or scene.stress.loading(None)


def _bound(simulated: Simulated) -> Bound:
    loading = simulated.loading
    if loading is None:
        return Bound(0.0, "every contact has one stiffness")
    if loading.friction is not None or loading.opens():
        return Bound(math.inf, "slip and opening need it")
    stiffness = Range.of(*loading.coefficients(simulated.fabric.D33)) ** (1 / 3)
    return Bound(largest_change(Change(normal=stiffness ** -1.0), simulated),
                 "the cube root of the contact force in any direction")


EFFECT = Effect(
    name="kinetic", title="contact stiffness that follows the contact force", equations="eqs (20) and (22)-(23)",
    without="every contact then has the stiffness of the ideal assembly under the mean stress, as in the paper's "
            "Table II",
    called_for=_called_for, bound=_bound, add_to_loading=_add_to_loading)
