"""Effect ``deviation``: branch vectors that do not follow the contact normals."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect

if TYPE_CHECKING:
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.shape is None:
        return Called(False, "branches follow the contact normals (no shape is given)")
    if scene.shape.aspect_ratio == 1.0:
        return Called(False, "the grains are spheres (aspect_ratio = 1)")
    return Called(True, f"aligned spheroids with aspect_ratio = {scene.shape.aspect_ratio!r}")


EFFECT = Effect(
    name="deviation", title="angle between branch vector and contact normal", source="eqs (5) and (6)",
    without="the grains are then taken as spheres", called_for=_called_for)
