"""Effect ``packing``: contact normals that are denser in some directions than in others."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    D33, D3333 = scene.fabric.D33, scene.fabric.D3333
    if D33 == 0.0 == D3333:
        return Called(False, "contact normals are isotropic")
    return Called(True, f"contact normals with D33 = {D33!r}" + (f", D3333 = {D3333!r}" if D3333 else ""))


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    return replace(fabric, D33=scene.fabric.D33, D3333=scene.fabric.D3333)


EFFECT = Effect(
    name="packing", title="anisotropic density of contact normals", source="eqs (4) and (7)",
    without="contact normals are then isotropic", called_for=_called_for, add_to_fabric=_add_to_fabric)
