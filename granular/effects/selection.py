"""Which effects a scene gets: those it calls for, as far as a wanted accuracy can tell them, or those it lists."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects import CATALOGUE, Called, Effect
from granular.effects.bound import Bound, Simulated
from granular.errors import AxisNeeded, ConflictingKeys
from granular.fabric import AxialFabric

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.gradation import SizeDistribution
    from granular.loading import Loading
    from granular.scene import Scene

LEFT_OUT = "left out by the scene's list of effects"
"""Reason for an effect that the scene calls for and its own list leaves out."""

SHARE = 0.5
"""Share of a wanted accuracy that effects may spend by being left out; the route gets what is left of it [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Selection:
    """The effects of one scene.

    Attributes
    ----------
    simulated : dict
        Effect -> why it is simulated.
    not_called_for : dict
        Effect -> why it is not.
    model : Simulated or GeneralSimulated
        What the simulated effects leave of the scene: about its axis, or by tensors where it has none.
    left_out_error : float
        Bound for the relative change of any component by what was left out for a wanted accuracy [-].
    scene : Scene
        What was selected from.
    spent : dict
        Effect that was left out for a wanted accuracy -> its bound.
    """

    simulated: dict[str, str]
    not_called_for: dict[str, str]
    model: Simulated | GeneralSimulated
    left_out_error: float
    scene: Scene
    spent: dict[str, Bound]

    @property
    def axial(self) -> Simulated:
        """The model about the axis of the scene; refused where it has none."""
        if not isinstance(self.model, Simulated):
            raise AxisNeeded("a scene whose fabric and stress share no axis",
                             allowed="allowed only tensors with one axis of symmetry in common there",
                             remedy="Use model, which holds the tensors.")
        return self.model

    @property
    def fabric(self) -> AxialFabric:
        """Contact normals and branches that are simulated, about the axis of the scene [-]."""
        return self.axial.fabric

    @property
    def loading(self) -> Loading | None:
        """What the stress does to the contacts; None when all contacts are taken as equally stiff."""
        return self.axial.loading

    @property
    def sizes(self) -> SizeDistribution | None:
        """Sizes of the grains; None when all are taken as equally large."""
        return self.model.sizes

    @property
    def reasoned_bounds(self) -> dict[str, Bound]:
        """Effect that the scene calls for -> how much leaving it out changes the components, and why.

        The model is the one that is simulated, with the effect and what it needs. What needs the effect is left out
        with it.
        """
        return {name: self.spent.get(name) or _bound_without(self.scene, self.with_effect(name), name)
                for name in self.considered}

    @property
    def considered(self) -> tuple[str, ...]:
        """Names of the effects that are simulated, or that the scene calls for."""
        return tuple(effect.name for effect in CATALOGUE
                     if effect.name in self.simulated or effect.asked_by(self.scene).wanted)

    @property
    def bounds(self) -> dict[str, float]:
        """Effect that the scene calls for -> how much leaving it out changes any component, at most [-]."""
        return {name: bound.value for name, bound in self.reasoned_bounds.items()}

    def with_effect(self, name: str) -> set[str]:
        """Names of the simulated effects, of one more, and of what that one needs."""
        return {*self.simulated, name, *_by_name()[name].requires}

    def without_effect(self, name: str) -> set[str]:
        """Names of the simulated effects but one, and but those that need it."""
        return {kept for kept in self.simulated if kept != name and name not in _by_name()[kept].requires}


def select(scene: Scene, *, rtol: float | None = None) -> Selection:
    """Decide which effects are simulated.

    Parameters
    ----------
    scene : Scene
        Its ``model.effects`` is "auto", for what the scene calls for and nothing else, or a list.
    rtol : float, optional
        Wanted relative accuracy of every component [-]; by default every effect that is called for is simulated.

    Returns
    -------
    Selection
        Effects with reasons, and what they leave of the scene.

    Raises
    ------
    ConflictingKeys
        An effect is listed without one that it needs, or contacts would carry tension.
    MissingKey
        Slip or gradation is listed, and the scene gives no friction or no grain sizes.

    Notes
    -----
    A list of effects is never cut. Otherwise, under an ``rtol``, effects are left out from the last of the catalogue
    to the first, which saves most first, as long as ``SHARE`` of it covers what each of them may change of what is
    left, one upon the other. Source: each effect's own.

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744, "contact_normals": {"D33": 1e-9}}, stress={"mean": "28 kPa"},
    ...               branches={"anisotropy": {"D33": -0.3}})
    >>> list(select(scene).simulated), list(select(scene, rtol=1e-6).simulated)
    (['packing', 'branches', 'kinetic'], ['branches'])
    """
    listed = scene.model.effects
    called = {effect.name: effect.asked_by(scene) for effect in CATALOGUE}
    names = {effect.name for effect in CATALOGUE
             if (called[effect.name].wanted if listed == "auto" else effect.name in listed)}
    needed = {name: effect.name for effect in CATALOGUE if effect.name in names
              for name in effect.requires if name not in names}
    spent: dict[str, Bound] = {}
    if listed == "auto":
        called |= {name: Called(True, f"{by} needs it") for name, by in needed.items()}
        names |= set(needed)
        spent = {} if rtol is None else _negligible(scene, names, SHARE * rtol)
        names -= set(spent)
    else:
        _require_companions(scene, names, needed)
    return Selection(
        simulated={name: call.reason for name, call in called.items() if name in names},
        not_called_for={effect.name: _within(spent[effect.name], rtol) if effect.name in spent
                        else _left_out(effect, called[effect.name])
                        for effect in CATALOGUE if effect.name not in names},
        model=model_of(scene, names), left_out_error=_together(spent.values()), scene=scene, spent=spent)


def model_of(scene: Scene, names: Collection[str]) -> Simulated | GeneralSimulated:
    """Put the effects of some names together.

    Parameters
    ----------
    scene : Scene
        What they take their shares from.
    names : collection of str
        Effects; none without what it needs.

    Returns
    -------
    Simulated or GeneralSimulated
        What they leave of the scene: about its axis, or by tensors where it has none.

    Raises
    ------
    MissingKey
        The scene lacks what an effect needs.

    Notes
    -----
    Source: each effect's own.
    """
    effects = [effect for effect in CATALOGUE if effect.name in names]
    sizes = next((effect.sizes(scene) for effect in effects if effect.sizes is not None), None)
    if scene.axis is None:
        return _by_tensors(scene, effects, sizes)
    fabric, loading = AxialFabric(), None
    for effect in effects:
        if effect.add_to_fabric is not None:
            fabric = effect.add_to_fabric(scene, fabric)
        if effect.add_to_loading is not None:
            loading = effect.add_to_loading(scene, loading)
    return Simulated(fabric=fabric, loading=loading, sizes=sizes, poisson_ratio=scene.grains.poisson_ratio,
                     hypothesis=scene.model.hypothesis)


def _by_tensors(scene: Scene, effects: Collection[Effect], sizes: SizeDistribution | None) -> GeneralSimulated:
    from granular.effects.forms import GeneralSimulated
    from granular.general import GeneralFabric

    fabric, loading = GeneralFabric(), None
    for ways in (effect.without_axis for effect in effects if effect.without_axis is not None):
        if ways.add_to_fabric is not None:
            fabric = ways.add_to_fabric(scene, fabric)
        if ways.add_to_loading is not None:
            loading = ways.add_to_loading(scene, loading)
    return GeneralSimulated(fabric=fabric, loading=loading, sizes=sizes, poisson_ratio=scene.grains.poisson_ratio,
                            hypothesis=scene.model.hypothesis)


def _by_name() -> dict[str, Effect]:
    return {effect.name: effect for effect in CATALOGUE}


def _negligible(scene: Scene, names: Collection[str], budget: float) -> dict[str, Bound]:
    """Effects that can go within a budget, each with its bound for the model that is left when it goes."""
    kept, spent = set(names), dict[str, Bound]()
    model = model_of(scene, kept)
    for effect in reversed(CATALOGUE):
        if effect.name not in kept or any(effect.name in other.requires for other in CATALOGUE if other.name in kept):
            continue
        bound = effect.bound_in(model)
        if _together([*spent.values(), bound]) <= budget:
            kept.remove(effect.name)
            spent[effect.name] = bound
            model = model_of(scene, kept)
    return spent


def _together(bounds: Collection[Bound]) -> float:
    """Bound of several changes, one upon the other."""
    total = 0.0
    for bound in bounds:
        total = (total + bound.value * (1 + total)) * (1 + 2.0**-50)  # rounded up
    return total


def _bound_without(scene: Scene, names: set[str], name: str) -> Bound:
    """Bound for leaving out an effect and, before it, what needs it."""
    kept, passed = set(names), list[Bound]()
    for effect in reversed(CATALOGUE):
        if effect.name in kept and (effect.name == name or name in effect.requires):
            passed.append(effect.bound_in(model_of(scene, kept)))
            kept.remove(effect.name)
    unknown = [bound for bound in passed if math.isinf(bound.value)]  # one without a bound leaves none for all
    return Bound(_together(passed), "; ".join(dict.fromkeys(bound.reason for bound in unknown[:1] or passed)))


def _within(bound: Bound, rtol: float | None) -> str:
    return f"would change no component by more than {rounded_up(bound.value)}, within its share of rtol = {rtol!r}"


def rounded_up(bound: float) -> str:
    """Write a bound with two digits, never as less than it is.

    Parameters
    ----------
    bound : float
        The bound [-], >= 0.

    Returns
    -------
    str
        Two digits.

    Notes
    -----
    Source: rounding of the last digit upwards.

    Examples
    --------
    >>> rounded_up(2.01e-7), rounded_up(0.0)
    ('2.1e-07', '0')
    """
    text = f"{bound:.2g}"
    return text if float(text) >= bound else f"{bound + 0.5 * 10.0 ** (math.floor(math.log10(bound)) - 1):.2g}"


def _left_out(effect: Effect, call: Called) -> str:
    return f"{LEFT_OUT}: {effect.without} ({call.reason})" if call.wanted else call.reason


def _require_companions(scene: Scene, names: set[str], needed: dict[str, str]) -> None:
    """Refuse a list that contradicts itself."""
    for name, by in needed.items():
        raise ConflictingKeys(f"model.effects lists {by} without {name}",
                              allowed=f"allowed {by} only together with {name}",
                              remedy=f"Add {name} to the list, or take {by} off.")
    if "kinetic" in names and "opening" not in names and model_of(scene, {"kinetic"}).opens:
        raise ConflictingKeys("model.effects lists kinetic without opening under a stress with a tension",
                              allowed="allowed only contacts that carry no tension",
                              remedy="Add opening to the list, or take kinetic off.")
