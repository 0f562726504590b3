"""Effect ``slip``: shear stiffness that falls as a contact comes near to sliding."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect
from granular.effects.kinetic import force_coefficients
from granular.errors import MissingKey

if TYPE_CHECKING:
    from fractions import Fraction

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


EFFECT = Effect(
    name="slip", title="partial slip and sliding of contacts", source="eq. (21)",
    without="contacts then keep their full shear stiffness", called_for=_called_for,
    add_to_loading=_add_to_loading, requires=("kinetic",))
