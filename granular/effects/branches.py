"""Effect ``branches``: branch lengths that change with direction."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect
from granular.effects.ranges import Range

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.fabric.Dr33 == 0.0:
        return Called(False, "branch lengths are the same in every direction")
    return Called(True, f"branch lengths with anisotropy D33 = {scene.fabric.Dr33!r}")


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    return replace(fabric, Dr33=scene.fabric.Dr33)


def _bound(simulated: Simulated) -> Bound:
    """W reaches neither the forces, which fall with it as radii grow with it, nor N."""
    Dr33 = Fraction(simulated.fabric.Dr33)
    squared = Range.of(1 - Dr33 / 2, 1 + Dr33) ** 2.0
    share = squared if simulated.static else squared ** -1.0
    return Bound(largest_change(Change(share=share), simulated), "the largest change of W^2 in any direction")


EFFECT = Effect(
    name="branches", title="branch length that changes with direction", equations="eqs (7) and (14)",
    without="branches then have the same length in every direction", called_for=_called_for, bound=_bound,
    add_to_fabric=_add_to_fabric, excludes=("deviation",))
