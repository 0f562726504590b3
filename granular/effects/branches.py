"""Effect ``branches``: branch lengths that change with direction."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.fabric.Dr33 == 0.0:
        return Called(False, "branch lengths are the same in every direction")
    return Called(True, f"branch lengths with anisotropy D33 = {scene.fabric.Dr33!r}")


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    return replace(fabric, Dr33=scene.fabric.Dr33)


EFFECT = Effect(
    name="branches", title="branch length that changes with direction", source="eqs (7) and (14)",
    without="branches then have the same length in every direction", called_for=_called_for,
    add_to_fabric=_add_to_fabric)
