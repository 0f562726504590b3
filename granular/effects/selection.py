"""Which effects a scene gets: those it calls for, or those it lists, and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects import CATALOGUE, Called, Effect
from granular.errors import ConflictingKeys
from granular.fabric import AxialFabric

if TYPE_CHECKING:
    from granular.gradation import SizeDistribution
    from granular.loading import Loading
    from granular.scene import Scene

LEFT_OUT = "left out by the scene's list of effects"
"""Reason for an effect that the scene calls for and its own list leaves out."""


@dataclass(frozen=True, slots=True)
class Selection:
    """The effects of one scene.

    Attributes
    ----------
    simulated : dict
        Effect -> why it is simulated.
    not_called_for : dict
        Effect -> why it is not.
    fabric : AxialFabric
        What the simulated effects leave of the scene's fabric [-].
    loading : Loading or None
        What the stress does to the contacts; None when all contacts are taken as equally stiff.
    sizes : SizeDistribution or None
        Sizes of the grains; None when all are taken as equally large.
    """

    simulated: dict[str, str]
    not_called_for: dict[str, str]
    fabric: AxialFabric
    loading: Loading | None
    sizes: SizeDistribution | None


def select(scene: Scene) -> Selection:
    """Decide which effects are simulated.

    Parameters
    ----------
    scene : Scene
        Its ``model.effects`` is "auto", for what the scene calls for and nothing else, or a list.

    Returns
    -------
    Selection
        Effects with reasons, and the fabric and loading that they leave.

    Raises
    ------
    ConflictingKeys
        An effect is listed without one that it needs, or contacts would carry tension.
    MissingKey
        Slip or gradation is listed, and the scene gives no friction or no grain sizes.

    Notes
    -----
    Source: each effect's own.

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"},
    ...               branches={"anisotropy": {"D33": -0.3}})
    >>> list(select(scene).simulated)
    ['branches']
    """
    listed = scene.model.effects
    called = {effect.name: effect.called_for(scene) for effect in CATALOGUE}
    wanted = [effect for effect in CATALOGUE
              if (called[effect.name].wanted if listed == "auto" else effect.name in listed)]
    names = {effect.name for effect in wanted}
    needed = {name: effect.name for effect in wanted for name in effect.requires if name not in names}
    if listed == "auto":
        wanted = [effect for effect in CATALOGUE if effect.name in names or effect.name in needed]
        called |= {name: Called(True, f"{by} needs it") for name, by in needed.items()}
        names |= set(needed)
    else:
        _require_companions(scene, names, needed)
    fabric, loading, sizes = AxialFabric(), None, None
    for effect in wanted:
        if effect.sizes is not None:
            sizes = effect.sizes(scene)
        if effect.add_to_fabric is not None:
            fabric = effect.add_to_fabric(scene, fabric)
        if effect.add_to_loading is not None:
            loading = effect.add_to_loading(scene, loading)
    return Selection(
        simulated={name: call.reason for name, call in called.items() if name in names},
        not_called_for={effect.name: _left_out(effect, called[effect.name]) for effect in CATALOGUE
                        if effect.name not in names},
        fabric=fabric, loading=loading, sizes=sizes)


def _left_out(effect: Effect, call: Called) -> str:
    return f"{LEFT_OUT}: {effect.without} ({call.reason})" if call.wanted else call.reason


def _require_companions(scene: Scene, names: set[str], needed: dict[str, str]) -> None:
    """Refuse a list that contradicts itself."""
    for name, by in needed.items():
        raise ConflictingKeys(f"model.effects lists {by} without {name}",
                              allowed=f"allowed {by} only together with {name}",
                              remedy=f"Add {name} to the list, or take {by} off.")
    if "kinetic" in names and "opening" not in names and scene.stress.loading(None).opens():
        raise ConflictingKeys("model.effects lists kinetic without opening under a stress with a tension",
                              allowed="allowed only contacts that carry no tension",
                              remedy="Add opening to the list, or take kinetic off.")
