"""Effect ``slip``: shear stiffness that falls as a contact comes near to sliding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect
from granular.effects.kinetic import force_coefficients
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
    if scene.stress.loading(scene.grains.friction).slides(scene.fabric.D33):
        return Called(True, "friction is given, and in some directions contacts slide")
    return Called(True, "friction is given and contacts carry shear forces, though none slides")


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
