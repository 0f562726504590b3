"""Effect ``deviation``: branch vectors that do not follow the contact normals."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.ranges import UNCHANGED, Range

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
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
    shape = scene.fabric_about_axis
    return replace(fabric, aspect_ratio=shape.aspect_ratio, free_spin=shape.free_spin)


def _bound(simulated: Simulated) -> Bound:
    """Branches are 2 a (n_1, n_2, r^2 n_3)/sqrt(Q) with Q = s + r^2 y between 1 and r^2, and a^2 = r^(-2/3) r_e^2."""
    if simulated.fabric.free_spin:
        return Bound(math.inf, "grains that spin yield to vertical shear as no average of their contacts does")
    square = Range.of(simulated.fabric.aspect_ratio) ** 2.0
    between = UNCHANGED | square
    if simulated.static:  # 1/l^2 = Q/((2 a)^2 (s + r^4 y)), and the mean of n^l_i n_k in place of N_ik
        change = Change(share=between / square ** (1 / 3), across=between, along=between / square)
    else:  # components take l_1^2, l_1 l_3, or l_3^2
        change = Change(share=square ** (1 / 3) * between / (UNCHANGED | square ** 2.0))
    return Bound(largest_change(change, simulated), "the largest change of a product of branch components")


def _bound_by_tensors(simulated: GeneralSimulated) -> Bound:
    del simulated  # no scene has a shape without axis 3
    return Bound(0.0, "branches follow the contact normals")


EFFECT = Effect(
    name="deviation", title="angle between branch vector and contact normal", equations="eqs (5) and (6)",
    without="the grains are then taken as spheres", called_for=_called_for, bound=_bound,
    add_to_fabric=_add_to_fabric, excludes=("branches",),
    modules=("granular.spheroid", "granular.generated.spheroid",),
    without_axis=WithoutAxis(called_for=_called_for, bound=_bound_by_tensors))
