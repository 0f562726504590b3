"""Which effects a scene gets: those it calls for, or those it lists, and nothing that is not built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects import CATALOGUE, Called, Effect
from granular.errors import EffectNotBuilt
from granular.fabric import AxialFabric

if TYPE_CHECKING:
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
    """

    simulated: dict[str, str]
    not_called_for: dict[str, str]
    fabric: AxialFabric


def select(scene: Scene) -> Selection:
    """Decide which effects are simulated.

    Parameters
    ----------
    scene : Scene
        Its ``model.effects`` is "auto", for what the scene calls for and nothing else, or a list.

    Returns
    -------
    Selection
        Effects with reasons, and the fabric that they leave.

    Raises
    ------
    EffectNotBuilt
        An effect that is called for, or listed, is not built; it is never left out silently.

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
    _require_built(wanted, called, by_list=listed != "auto")
    fabric = AxialFabric()
    for effect in wanted:
        if effect.add_to_fabric is not None:
            fabric = effect.add_to_fabric(scene, fabric)
    names = {effect.name for effect in wanted}
    return Selection(
        simulated={name: call.reason for name, call in called.items() if name in names},
        not_called_for={name: f"{LEFT_OUT} ({call.reason})" if call.wanted else call.reason
                        for name, call in called.items() if name not in names},
        fabric=fabric)


def _require_built(wanted: list[Effect], called: dict[str, Called], *, by_list: bool) -> None:
    missing = [effect for effect in wanted if not effect.built]
    if not missing:
        return
    built = [effect.name for effect in CATALOGUE if effect.built]
    allowed = f"built so far are {_joined(built)}"
    names = _joined([effect.name for effect in missing])
    them = "it" if len(missing) == 1 else "them"
    without = "; ".join(effect.without for effect in missing)
    if by_list:
        raise EffectNotBuilt(f"model.effects lists {names}", allowed=allowed, remedy=f"Take {them} off: {without}.")
    why = "; ".join(f"{effect.name}: {called[effect.name].reason}" for effect in missing)
    keep = ", ".join(f'"{name}"' for name in built)
    raise EffectNotBuilt(f"the scene calls for {names} ({why})", allowed=allowed,
                         remedy=f"Write effects = [{keep}] under [model] to leave {them} out: {without}.")


def _joined(names: list[str]) -> str:
    return " and ".join((", ".join(names[:-1]), names[-1]) if len(names) > 1 else names)
