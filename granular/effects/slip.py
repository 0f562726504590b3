"""Effect ``slip``: shear stiffness that falls as a contact comes near to sliding."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect
from granular.effects.kinetic import force_coefficients
from granular.effects.ranges import Range, log
from granular.errors import MissingKey

if TYPE_CHECKING:
    from granular.loading import Loading
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.grains.friction is None:
        return Called(False, "no friction is given, so contacts never slip")
    if scene.grains.friction == 0.0:
        return Called(True, "friction is zero, so every contact slides")
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, "no contact carries a shear force")
    where = _sliding_range(scene, equator, pole, scene.grains.friction)
    return Called(True, f"friction is given and contacts carry shear forces{where}")


def _sliding_range(scene: Scene, equator: Fraction, pole: Fraction, friction: float) -> str:
    """Say between which angles from axis 3 contacts slide."""
    from granular.routes.slip_geometry import Sticking, slip_geometry

    if scene.stress.loading(friction).opens():
        return "; they slide next to those that have opened"
    geometry = slip_geometry(equator, pole, friction)
    if isinstance(geometry, Sticking):
        return f", though none slides: they use up to {100 * geometry.kappa:.4g} % of their friction"
    low, high = (math.degrees(math.atan(edge)) if edge is not None else end
                 for edge, end in ((geometry.pole, 0.0), (geometry.equator, 90.0)))
    return f"; from {low:.4g} to {high:.4g} deg from axis 3 they slide"


def _add_to_loading(scene: Scene, loading: Loading | None) -> Loading:
    if scene.grains.friction is None:
        raise MissingKey("grains.friction_angle is not given", allowed="the effect slip needs it",
                         remedy="Add friction_angle or friction_coefficient under [grains], or take slip off the list.")
    del loading  # the same stress, and friction with it
    return scene.stress.loading(scene.grains.friction)


def least_chi(tilt: Fraction) -> float:
    """Logarithm of the smallest share of its shear stiffness that a sticking contact keeps.

    Parameters
    ----------
    tilt : Fraction
        Square of the share kappa of the friction that is used up where most of it is [-], 0 to 1.

    Returns
    -------
    float
        log(1 - kappa)/3 [-]; -inf where a contact is about to slide.

    Notes
    -----
    Accuracy: a few units in the last place. Source: eq. (21), with 1 - kappa = (1 - kappa^2)/(1 + kappa).

    Examples
    --------
    >>> round(math.exp(least_chi(Fraction(49, 64))), 12)
    0.5
    """
    kappa = math.sqrt(tilt)
    return (math.log1p(-kappa) if kappa < 0.5 else log(1 - tilt) - math.log1p(kappa)) / 3


def _bound(simulated: Simulated) -> Bound:
    loading, D33 = simulated.loading, simulated.fabric.D33
    if loading is None or loading.friction is None:
        return Bound(0.0, "contacts never slip")
    tilt = loading.tilt(D33)
    if loading.friction == 0.0 or loading.opens() or tilt is None or tilt > 1:
        return Bound(math.inf, "contacts that slide would get a shear stiffness back")
    chi = Range(least_chi(tilt), 0.0)
    nu = Fraction(simulated.poisson_ratio)
    rest, lam0 = nu / (2 - nu), (2 - 2 * nu) / (2 - nu)
    apart = Range.of(rest / (rest + lam0 * Fraction(-math.expm1(chi.low))), 1) if rest else Range(-math.inf, 0.0)
    return Bound(largest_change(Change(chi=chi ** -1.0, apart=apart), simulated),
                 "what the contact nearest to sliding has lost of its shear stiffness")


EFFECT = Effect(
    name="slip", title="partial slip and sliding of contacts", equations="eq. (21)",
    without="contacts then keep their full shear stiffness", called_for=_called_for, bound=_bound,
    add_to_loading=_add_to_loading, requires=("kinetic",),
    modules=("granular.routes.slip_geometry", "granular.routes.slip_rule"))
