"""Effect ``slip``: shear stiffness that falls as a contact comes near to sliding."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.kinetic import force_coefficients, forces_are_equal
from granular.effects.ranges import Range, log
from granular.errors import MissingKey
from granular.tensors import shown_direction

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.general import GeneralLoading
    from granular.loading import Loading
    from granular.scene import Scene


def _without_forces(scene: Scene) -> Called | None:
    """What friction alone decides."""
    if scene.grains.friction is None:
        return Called(False, "no friction is given, so contacts never slip")
    if scene.grains.friction == 0.0:
        return Called(True, "friction is zero, so every contact slides")
    return None


def _called_for(scene: Scene) -> Called:
    if (decided := _without_forces(scene)) is not None:
        return decided
    assert scene.grains.friction is not None
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, NO_SHEAR)
    where = _sliding_range(scene, equator, pole, scene.grains.friction)
    return Called(True, f"friction is given and contacts carry shear forces{where}")


def _sliding_range(scene: Scene, equator: Fraction, pole: Fraction, friction: float) -> str:
    """Say between which angles from axis 3 contacts slide."""
    from granular.routes.slip_geometry import Sticking, slip_geometry

    if scene.loading_about_axis(friction).opens():
        return NEXT_TO_OPENED
    geometry = slip_geometry(equator, pole, friction)
    if isinstance(geometry, Sticking):
        return _sticking(geometry.kappa)
    low, high = (math.degrees(math.atan(edge)) if edge is not None else end
                 for edge, end in ((geometry.pole, 0.0), (geometry.equator, 90.0)))
    return f"; from {low:.4g} to {high:.4g} deg from {scene.about_axis.axis_name} they slide"


def _sticking(used: float) -> str:
    return f", though none slides: they use up to {100 * used:.4g} % of their friction"


def _called_for_by_tensors(scene: Scene) -> Called:
    from granular.effects.forms import least_force
    from granular.general.loading import most_mobilised

    if (decided := _without_forces(scene)) is not None:
        return decided
    assert scene.grains.friction is not None
    if forces_are_equal(scene):
        return Called(False, NO_SHEAR)
    forces = scene.general_loading(None).force_tensor(scene.general_fabric)
    if least_force(forces) <= 0:
        return Called(True, f"friction is given and contacts carry shear forces{NEXT_TO_OPENED}")
    used, direction = most_mobilised(forces)
    where = (_sticking(used / scene.grains.friction) if used <= scene.grains.friction else
             f"; around n = {shown_direction(direction.tolist())} and elsewhere they slide")
    return Called(True, f"friction is given and contacts carry shear forces{where}")


def _friction(scene: Scene) -> float:
    if scene.grains.friction is None:
        raise MissingKey("grains.friction_angle is not given", allowed="the effect slip needs it",
                         remedy="Add friction_angle or friction_coefficient under [grains], or take slip off the list.")
    return scene.grains.friction


def _add_to_loading(scene: Scene, loading: Loading | None) -> Loading:
    del loading  # the same stress, and friction with it
    return scene.loading_about_axis(_friction(scene))


def _add_to_general(scene: Scene, loading: GeneralLoading | None) -> GeneralLoading:
    del loading  # the same stress, and friction with it
    return scene.general_loading(_friction(scene))


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
        return Bound(math.inf, SLIDING)
    chi = Range(least_chi(tilt), 0.0)
    nu = Fraction(simulated.poisson_ratio)
    rest, lam0 = nu / (2 - nu), (2 - 2 * nu) / (2 - nu)
    apart = Range.of(rest / (rest + lam0 * Fraction(-math.expm1(chi.low))), 1) if rest else Range(-math.inf, 0.0)
    return Bound(largest_change(Change(chi=chi ** -1.0, apart=apart), simulated), LARGEST)


def _bound_of_tensors(simulated: GeneralSimulated) -> Bound:
    from granular.effects.forms import SEARCHED, SLACK, largest_change_of_form, least_force
    from granular.general.loading import most_mobilised

    if simulated.loading is None or simulated.loading.friction is None:
        return Bound(0.0, "contacts never slip")
    friction = simulated.loading.friction
    if friction == 0.0 or least_force(simulated.forces) <= 0:
        return Bound(math.inf, SLIDING)
    used = (most_mobilised(simulated.forces)[0] * (1 + SEARCHED) + SLACK) / friction
    if used >= 1:
        return Bound(math.inf, SLIDING)
    return Bound(largest_change_of_form(Change(chi=Range(0.0, -math.log1p(-used) / 3)), simulated), LARGEST)


NO_SHEAR = "no contact carries a shear force"
NEXT_TO_OPENED = "; they slide next to those that have opened"
SLIDING = "contacts that slide would get a shear stiffness back"
LARGEST = "what the contact nearest to sliding has lost of its shear stiffness"
"""Why it is called for or not, and why there is a bound or none."""

EFFECT = Effect(
    name="slip", title="partial slip and sliding of contacts", equations="eq. (21)",
    without="contacts then keep their full shear stiffness", called_for=_called_for, bound=_bound,
    add_to_loading=_add_to_loading, requires=("kinetic",),
    modules=("granular.routes.slip_geometry", "granular.routes.slip_rule"),
    without_axis=WithoutAxis(called_for=_called_for_by_tensors, bound=_bound_of_tensors,
                             add_to_loading=_add_to_general))
