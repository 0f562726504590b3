"""Effect ``slip``: shear stiffness that falls as a contact comes near to sliding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect
from granular.effects.kinetic import force_coefficients

if TYPE_CHECKING:
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.grains.friction_angle is None and scene.grains.friction_coefficient is None:
        return Called(False, "no friction is given, so contacts never slip")
    if 0.0 in (scene.grains.friction_angle, scene.grains.friction_coefficient):
        return Called(True, "friction is zero, so every contact slides")
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, "no contact carries a shear force")
    return Called(True, "friction is given and contacts carry shear forces")


EFFECT = Effect(
    name="slip", title="partial slip and sliding of contacts", source="eq. (21)",
    without="contacts then keep their full shear stiffness", called_for=_called_for)
