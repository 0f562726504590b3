"""The choice of effects step by step: what is asked of each effect, in which order, and what is left to spend."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from granular.effects import CATALOGUE
from granular.effects.selection import SHARE, model_of, select

if TYPE_CHECKING:
    from granular.scene import Scene


class Outcome(StrEnum):
    """What becomes of an effect."""

    ABSENT = "absent"
    LEFT_OUT = "left out"
    SIMULATED = "simulated"


@dataclass(frozen=True, slots=True, kw_only=True)
class Decision:
    """What is decided about one effect.

    Attributes
    ----------
    name : str
        The effect.
    called_for : bool
        Whether the scene calls for it.
    needed_by : tuple of str
        Effects that stay and need it; it then stays, too.
    bound : float or None
        How much any component changes without it, of what is left so far [-]; None where that is not asked.
    rest : float
        What its bound may be at most [-].
    outcome : Outcome
        What follows.
    """

    name: str
    called_for: bool
    needed_by: tuple[str, ...]
    bound: float | None
    rest: float
    outcome: Outcome


def decisions(scene: Scene, rtol: float) -> tuple[Decision, ...]:
    """Follow the choice of effects for a wanted accuracy.

    Parameters
    ----------
    scene : Scene
        Its ``model.effects`` is "auto".
    rtol : float
        Wanted relative accuracy of every component [-].

    Returns
    -------
    tuple of Decision
        In the order in which effects are asked: from the last of the catalogue, which saves most, to the first.

    Notes
    -----
    Accuracy: to rounding of the sums. Source: :func:`granular.effects.selection.select`, with which every outcome is
    compared in the tests.
    """
    kept, total, found = set(select(scene).simulated), 0.0, list[Decision]()
    for effect in reversed(CATALOGUE):
        rest = (SHARE * rtol - total) / (1 + total)
        if effect.name not in kept:
            found.append(Decision(name=effect.name, called_for=False, needed_by=(), bound=None, rest=rest,
                                  outcome=Outcome.ABSENT))
            continue
        needed_by = tuple(other.name for other in CATALOGUE if other.name in kept and effect.name in other.requires)
        bound = None if needed_by else effect.bound_in(model_of(scene, kept)).value
        goes = bound is not None and bound <= rest
        found.append(Decision(name=effect.name, called_for=True, needed_by=needed_by, bound=bound, rest=rest,
                              outcome=Outcome.LEFT_OUT if goes else Outcome.SIMULATED))
        if bound is not None and goes:
            kept.remove(effect.name)
            total += bound * (1 + total)
    return tuple(found)
