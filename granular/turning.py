"""What it costs in accuracy to turn a scene to axis 3 and its stiffness back.

About the axis every component is known to a share e of itself. None of them is negative, so that the change stays
within e times the tensor in the norm that no turn changes, and that norm is no more than the trace of the Mandel
matrix, which is at most six times its largest entry in any frame. Relative to the largest entry the error is therefore
at most 6 e, plus the rounding of the turns.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.axial_scene import AXIS_3

if TYPE_CHECKING:
    from granular.axial_scene import AxialScene

SPREAD = 6.0
"""Error of the turned stiffness over its largest entry, per unit of the error of a component about the axis [-]."""

TURNED = 2e-13
"""What turning a scene to axis 3 and back may add to the error of a component, over the largest [-]: rounding of the
tensors and of the result, and what is left out of tensors that are axial to 2^-44."""

AT_ONSET, ROUNDING = 20.0, 2.0**-51
"""At the onset of sliding, and where no contact across the axis is pressed, the stiffness moves like the power 5/6 of a
change in stress: by this factor times the power of what is left out of the tensors, and of their rounding [-]. Over a
few dozen rotations no more than a third of it was seen."""

ONSET = 1e-6
"""An onset is near when kappa^2 is this close to 1, or the force across the axis this small beside that along [-]."""


@dataclass(frozen=True, slots=True)
class Turning:
    """How errors about the axis of a scene become errors in its own frame.

    Attributes
    ----------
    spread, added : float
        The error in the scene's frame is ``spread`` times that about the axis, plus ``added`` [-].
    """

    spread: float = 1.0
    added: float = 0.0

    def outside(self, error: float) -> float:
        """Error in the frame of the scene [-]; the same bits where nothing is turned."""
        return self.spread * error + self.added

    def inside(self, rtol: float | None) -> float | None:
        """What is left of a wanted accuracy about the axis [-]; not positive where nothing is left."""
        return None if rtol is None else (rtol - self.added) / self.spread


NOT_TURNED = Turning()
"""A scene about axis 3, or one without an axis."""


def turning_of(scene: AxialScene) -> Turning:
    """What a scene loses by being turned.

    Parameters
    ----------
    scene : AxialScene
        The scene about its axis, with its friction.

    Returns
    -------
    Turning
        Nothing for a scene that was given about axis 3.

    Notes
    -----
    Accuracy: bounds; see the head of this file. Source: the same.
    """
    if not scene.recognised:
        return NOT_TURNED
    added = TURNED + (AT_ONSET * max(scene.deviation, ROUNDING) ** (5 / 6) if _near_onset(scene) else 0.0)
    return Turning(1.0 if scene.axis == AXIS_3 else SPREAD, added)


def _near_onset(scene: AxialScene) -> bool:
    """Whether one direction is just about to slide, or all those across the axis to open."""
    if scene.loading is None:
        return False
    across, along = scene.loading.coefficients(scene.fabric.D33)
    tilt = scene.loading.tilt(scene.fabric.D33)
    return abs(across) < ONSET * abs(along) or (tilt is not None and abs(tilt - 1) < ONSET)
