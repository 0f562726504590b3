"""What an effect is: a feature of the scene that the stiffness may have to carry."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Common, Simulated

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.fabric import AxialFabric
    from granular.general import GeneralFabric, GeneralLoading
    from granular.gradation import SizeDistribution
    from granular.loading import Loading
    from granular.scene import Scene


@dataclass(frozen=True, slots=True)
class Called:
    """Whether a scene calls for an effect, and why.

    Attributes
    ----------
    wanted : bool
        True when the stiffness would differ without the effect.
    reason : str
        The feature of the scene that decides it.
    """

    wanted: bool
    reason: str


def _nothing_proved(simulated: Common) -> Bound:
    del simulated  # whatever it is
    return Bound(math.inf, "nothing is proved")


@dataclass(frozen=True, slots=True, kw_only=True)
class WithoutAxis:
    """How an effect enters a scene whose tensors share no axis; the fields mean what they mean in :class:`Effect`.

    Attributes
    ----------
    called_for : callable
        Decides from a scene.
    bound : callable
        How much any entry of the Mandel matrix changes over the largest one, when the effect is left out.
    add_to_fabric, add_to_loading : callable or None
        Put the scene's share of the effect into the tensors that are computed with.
    """

    called_for: Callable[[Scene], Called]
    bound: Callable[[GeneralSimulated], Bound] = _nothing_proved
    add_to_fabric: Callable[[Scene, GeneralFabric], GeneralFabric] | None = None
    add_to_loading: Callable[[Scene, GeneralLoading | None], GeneralLoading] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Effect:
    """One effect; the catalogue of the package holds all of them.

    Attributes
    ----------
    name : str
        Name in the scene file.
    title : str
        What it is, in the field's words.
    equations : str
        Equations that it comes from.
    without : str
        What leaving it out means.
    called_for : callable
        Decides from a scene; from one with an axis where ``without_axis`` is given.
    bound : callable
        How much any of the six components changes when it is left out of a model that has it, and all else stays.
    add_to_fabric : callable or None
        Puts the scene's share of the effect into the fabric that is computed; None where it has no share.
    add_to_loading : callable or None
        The same for what the stress does to the contacts.
    sizes : callable or None
        The grain sizes of a scene, for the effect that carries them.
    requires : tuple of str
        Effects without which this one means nothing.
    excludes : tuple of str
        Effects that no scene has beside this one.
    modules : tuple of str
        Modules that compute the effect and nothing else: a scene without it never imports them.
    without_axis : WithoutAxis or None
        The same for scenes whose tensors share no axis; None where nothing of it has a direction.
    """

    name: str
    title: str
    equations: str
    without: str
    called_for: Callable[[Scene], Called]
    bound: Callable[[Simulated], Bound] = _nothing_proved
    add_to_fabric: Callable[[Scene, AxialFabric], AxialFabric] | None = None
    add_to_loading: Callable[[Scene, Loading | None], Loading] | None = None
    sizes: Callable[[Scene], SizeDistribution] | None = None
    requires: tuple[str, ...] = ()
    excludes: tuple[str, ...] = ()
    modules: tuple[str, ...] = ()
    without_axis: WithoutAxis | None = None

    def asked_by(self, scene: Scene) -> Called:
        """Decide from any scene whether it calls for the effect."""
        if self.without_axis is None or scene.axis is not None:
            return self.called_for(scene)
        return self.without_axis.called_for(scene)

    def bound_in(self, model: Simulated | GeneralSimulated) -> Bound:
        """How much leaving the effect out of a model that has it changes the stiffness, when all else stays."""
        if isinstance(model, Simulated):
            return self.bound(model)
        return _nothing_proved(model) if self.without_axis is None else self.without_axis.bound(model)
