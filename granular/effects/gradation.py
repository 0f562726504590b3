"""Effect ``gradation``: grains of many sizes."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Common
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.ranges import Range
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


def _bound(simulated: Common) -> Bound:
    """The branch lengths multiply all components by one number."""
    from granular.gradation import length_moments

    if simulated.sizes is None:
        return Bound(0.0, "all grains have one size")
    lengths = length_moments(simulated.sizes)
    factor = Range.of(lengths.inverse_second) if simulated.static else Range.of(lengths.second) ** -1.0
    known = Range.of(1 - Fraction(lengths.relative_error), 1 + Fraction(lengths.relative_error))
    return Bound((factor / known).change, "the factor that the branch lengths make of all components")


EFFECT = Effect(
    name="gradation", title="grains of many sizes", equations="eqs (10)-(13) and (15)-(19)",
    without="all grains then have one size", called_for=_called_for, bound=_bound, sizes=_sizes,
    modules=("granular.gradation.lognormal_branches", "granular.gradation.curve_branches"),
    without_axis=WithoutAxis(called_for=_called_for, bound=_bound))
