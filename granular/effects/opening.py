"""Effect ``opening``: contacts without a compressive force carry nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect
from granular.effects.kinetic import force_coefficients

if TYPE_CHECKING:
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    equator, pole = force_coefficients(scene)
    if equator > 0 and pole > 0:
        return Called(False, "every contact is compressed")
    where = "at the pole" if pole <= 0 else "at the equator"
    return Called(True, f"the estimated normal force is not positive {where}")


EFFECT = Effect(
    name="opening", title="contacts that have opened", source="the local yield condition that goes with eq. (20)",
    without="contacts then never open", called_for=_called_for)
