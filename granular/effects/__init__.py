"""The effects, one file each; a new one is a file here and a line in the catalogue."""

from __future__ import annotations

from granular.effects import branches, deviation, gradation, kinetic, opening, packing, slip
from granular.effects.effect import Called, Effect

__all__ = ["CATALOGUE", "Called", "Effect"]

CATALOGUE: tuple[Effect, ...] = (
    packing.EFFECT,
    branches.EFFECT,
    gradation.EFFECT,
    deviation.EFFECT,
    kinetic.EFFECT,
    slip.EFFECT,
    opening.EFFECT,
)
"""Every effect, in the order in which a scene file lists them."""
