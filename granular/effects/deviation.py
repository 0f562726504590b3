"""Effect ``deviation``: branch vectors that do not follow the contact normals."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.shape is None:
        return Called(False, "branches follow the contact normals (no shape is given)")
    if scene.shape.aspect_ratio != 1.0:
        return Called(True, f"aligned spheroids with aspect_ratio = {scene.shape.aspect_ratio!r}")
    if scene.shape.spin == "relaxed":
        return Called(True, "spheres that are free to spin")
    return Called(False, "the grains are spheres (aspect_ratio = 1)")


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    return replace(fabric, aspect_ratio=scene.fabric.aspect_ratio, free_spin=scene.fabric.free_spin)


EFFECT = Effect(
    name="deviation", title="angle between branch vector and contact normal", source="eqs (5) and (6)",
    without="the grains are then taken as spheres", called_for=_called_for, add_to_fabric=_add_to_fabric)
