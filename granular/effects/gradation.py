"""Effect ``gradation``: grains of many sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect
from granular.errors import MissingKey

if TYPE_CHECKING:
    from granular.gradation import SizeDistribution
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    if scene.gradation is None:
        return Called(False, "all grains have one size")
    return Called(True, f'grain sizes with distribution = "{scene.gradation.distribution}"')


def _sizes(scene: Scene) -> SizeDistribution:
    if scene.gradation is None:
        raise MissingKey("model.effects lists gradation, and the scene has no grain sizes",
                         allowed="allowed only with [gradation]",
                         remedy="Add [gradation], or take gradation off the list.")
    return scene.gradation.sizes


EFFECT = Effect(
    name="gradation", title="grains of many sizes", source="eqs (10)-(13) and (15)-(19)",
    without="all grains then have one size", called_for=_called_for, sizes=_sizes)
