"""Effect ``branches``: branch lengths that change with direction."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.ranges import Range
from granular.tensors import ZERO, span

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.fabric import AxialFabric
    from granular.general import GeneralFabric
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    Dr33 = scene.fabric_about_axis.Dr33
    if Dr33 == 0.0:
        return Called(False, "branch lengths are the same in every direction")
    return Called(True, f"branch lengths with anisotropy D33 = {scene.about_axis.written(Dr33)}")


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    return replace(fabric, Dr33=scene.fabric_about_axis.Dr33)


def _bound(simulated: Simulated) -> Bound:
    """W reaches neither the forces, which fall with it as radii grow with it, nor N."""
    Dr33 = Fraction(simulated.fabric.Dr33)
    squared = Range.of(1 - Dr33 / 2, 1 + Dr33) ** 2.0
    share = squared if simulated.static else squared ** -1.0
    return Bound(largest_change(Change(share=share), simulated), LARGEST)


def _called_for_by_tensor(scene: Scene) -> Called:
    Dr = scene.general_fabric.Dr
    if Dr is None or Dr == ZERO:
        return Called(False, "branch lengths are the same in every direction")
    return Called(True, "branch lengths by a tensor, " + span("W", Dr))


def _add_tensor(scene: Scene, fabric: GeneralFabric) -> GeneralFabric:
    return replace(fabric, Dr=scene.general_fabric.Dr)


def _bound_of_tensor(simulated: GeneralSimulated) -> Bound:
    import numpy as np

    from granular.effects.forms import eigenvalue_range, largest_change_of_form

    if simulated.fabric.Dr in (None, ZERO):
        return Bound(0.0, "branch lengths are the same in every direction")
    squared = eigenvalue_range(np.eye(3) + np.array(simulated.fabric.Dr)) ** 2.0
    share = squared if simulated.static else squared ** -1.0
    return Bound(largest_change_of_form(Change(share=share), simulated), LARGEST)


LARGEST = "the largest change of W^2 in any direction"
"""Where the bound comes from."""

EFFECT = Effect(
    name="branches", title="branch length that changes with direction", equations="eqs (7) and (14)",
    without="branches then have the same length in every direction", called_for=_called_for, bound=_bound,
    add_to_fabric=_add_to_fabric, excludes=("deviation",),
    without_axis=WithoutAxis(called_for=_called_for_by_tensor, bound=_bound_of_tensor, add_to_fabric=_add_tensor))
