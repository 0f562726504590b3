"""What a scene with an axis of symmetry says about directions, in the frame in which that axis is axis 3."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

Axis = tuple[float, float, float]
"""A unit vector [-]; either sign means the same axis."""

AXIS_3: Axis = (0.0, 0.0, 1.0)
"""The axis that needs no turning."""


@dataclass(frozen=True, slots=True)
class AxialScene:
    """A scene turned so that its axis is axis 3.

    Attributes
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    loading : Loading or None
        Stress and friction about axis 3.
    axis : tuple of 3 float
        The axis in the frame of the scene [-], a unit vector.
    recognised : bool
        Whether the axis was found from tensors in any frame, to rounding, rather than given as axis 3.
    deviation : float
        What of the tensors has been left out by that, over the isotropic part of each [-].
    """

    fabric: AxialFabric
    loading: Loading | None
    axis: Axis
    recognised: bool = True
    deviation: float = 0.0

    @property
    def axis_name(self) -> str:
        """What angles are counted from, in words."""
        return "axis 3" if self.axis == AXIS_3 else "the axis"

    def written(self, coefficient: float) -> str:
        """A coefficient of the fabric [-] with the digits it was given with, or has after turning."""
        return f"{coefficient:.12g}" if self.recognised else repr(coefficient)

    def under(self, friction: float | None) -> Loading:
        """The stress with this friction [-], None for contacts that never slip."""
        assert self.loading is not None  # every scene has a stress
        return replace(self.loading, friction=friction)
