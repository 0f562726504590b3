"""A plain scene, the smallest change to it that calls for each effect, and what leaving the effect out really does."""

from __future__ import annotations

import tomllib
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.effects import CATALOGUE
from granular.errors import ComplianceInfinite, ConflictingKeys, ResultOutOfRange, RouteOutOfDomain
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.effects.bound import Bound
    from granular.evaluation import Evaluation
    from granular.planning import Plan
    from granular.scene import Scene

Tables = dict[str, dict[str, Any]]

PLAIN = """\
[grains]
shear_modulus = "31 GPa"
poisson_ratio = 0.21

[packing]
void_ratio = 0.5744

[stress]
mean = "28 kPa"
"""
"""Equal spheres, isotropic contact normals, isotropic stress: no effect is called for."""

FORCES = '[stress]\nratio = 1.5'
FRICTION = '[grains]\nfriction_angle = "30 deg"'

EXAMPLES = {
    "packing": "[packing]\ncontact_normals = { D33 = 0.3 }",
    "branches": "[branches]\nanisotropy = { D33 = -0.3 }",
    "gradation": '[gradation]\ndistribution = "lognormal"\nmedian = "5 mm"\nspread = 1.5',
    "deviation": "[shape]\naspect_ratio = 0.8",
    "kinetic": FORCES,
    "slip": f"{FRICTION}\n{FORCES}",
    "opening": "[stress]\ntensor = [[43e3, 0, 0],\n[0, 43e3, 0],\n[0, 0, -2e3]]",
}
"""Effect -> what is added to the plain scene, as in a scene file. A tensor takes the place of mean and ratio."""

GROWING = "\n".join((EXAMPLES["branches"], EXAMPLES["gradation"], EXAMPLES["packing"], EXAMPLES["slip"]))
"""Everything that one scene can hold at once while its contacts are compressed."""

ADDED = ("branches", "gradation", "packing", "kinetic", "slip", "opening")
"""Order in which the effects of that scene are added; no contact of it is pulled, so that the last one is absent."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """What an effect does to a scene.

    Attributes
    ----------
    name : str
        The effect.
    simulated : tuple of str
        What the scene calls for.
    reason : str
        Why it calls for the effect.
    bound : Bound
        For the relative change of any component without the effect.
    change : float or None
        The true one, of the worst component [-]; None where the scene has no stiffness without the effect.
    with_it, without_it : Plan or None
        What an evaluation would do with the effect and without it.
    """

    name: str
    simulated: tuple[str, ...]
    reason: str
    bound: Bound
    change: float | None
    with_it: Plan
    without_it: Plan | None


def scene_with(*changes: str, effects: Collection[str] | None = None,
               hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Scene:
    """Change the plain scene.

    Parameters
    ----------
    changes : str
        Tables of a scene file, each added to those that are there.
    effects : collection of str, optional
        List of effects; by default what the scene calls for.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    Scene
        Validated.

    Notes
    -----
    Source: the scene file.

    Examples
    --------
    >>> scene_with(EXAMPLES["branches"]).fabric.Dr33
    -0.3
    """
    tables: Tables = tomllib.loads(PLAIN)
    for change in changes:
        for name, table in tomllib.loads(change).items():
            tables[name] = {**tables.get(name, {}), **table}
    return scene_of(tables, effects=effects, hypothesis=hypothesis)


def scene_of(tables: Tables, *, effects: Collection[str] | None = None,
             hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Scene:
    """Make a scene of tables.

    Parameters
    ----------
    tables : dict
        As a scene file holds them; where the stress is a tensor, its mean and ratio are dropped.
    effects : collection of str, optional
        List of effects; by default what the scene calls for.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    Scene
        Validated.

    Notes
    -----
    Source: the scene file.
    """
    from granular.scene import Scene

    stress = tables["stress"]
    if "tensor" in stress:
        stress = {"tensor": stress["tensor"]}
    listed = "auto" if effects is None else [effect.name for effect in CATALOGUE if effect.name in effects]
    return Scene.model_validate({**tables, "stress": stress, "model": {"hypothesis": hypothesis, "effects": listed}})


def listing(scene: Scene, effects: Collection[str]) -> Scene:
    """Give a scene a list of effects, and leave everything else.

    Parameters
    ----------
    scene : Scene
        Any.
    effects : collection of str
        Their names.

    Returns
    -------
    Scene
        The same assembly under the same stress.

    Notes
    -----
    Source: ``model.effects``.
    """
    names = tuple(effect.name for effect in CATALOGUE if effect.name in effects)
    return scene.model_copy(update={"model": scene.model.model_copy(update={"effects": names})})


def measured(name: str, *changes: str, hypothesis: Hypothesis = Hypothesis.KINEMATIC,
             rtol: float | None = None) -> Measured:
    """Say what an effect does to its example, or to another scene.

    Parameters
    ----------
    name : str
        The effect.
    changes : str
        What is added to the plain scene; by default the example of the effect.
    hypothesis : Hypothesis
        Kinematic or static.
    rtol : float, optional
        Wanted accuracy that the plans have to keep [-]; the change is computed to rounding.

    Returns
    -------
    Measured
        Bound, true change and cost.

    Notes
    -----
    Accuracy: the change to 1e-14 of the stiffness. Source: ``granular.evaluate`` with and without the effect.

    Examples
    --------
    >>> found = measured("branches")
    >>> 0 < found.change <= found.bound.value
    True
    """
    from granular.effects.selection import select
    from granular.planning import plan

    scene = scene_with(*(changes or (EXAMPLES[name],)), hypothesis=hypothesis)
    selection = select(scene)
    less = listing(scene, selection.without_effect(name))
    try:
        without = plan(less, rtol=rtol)
    except (ConflictingKeys, RouteOutOfDomain, ComplianceInfinite, ResultOutOfRange):
        without = None
    return Measured(name=name, simulated=tuple(selection.simulated), reason=selection.simulated[name],
                    bound=selection.reasoned_bounds[name], change=change_without(scene, name),
                    with_it=plan(listing(scene, selection.simulated), rtol=rtol), without_it=without)


def change_without(scene: Scene, name: str) -> float | None:
    """Compute what leaving an effect out changes, all else the same.

    Parameters
    ----------
    scene : Scene
        It calls for the effect.
    name : str
        The effect; what needs it is left out with it.

    Returns
    -------
    float or None
        Relative change of the worst component [-]; None where there is no stiffness without the effect.

    Notes
    -----
    Accuracy: 1e-14. Source: ``granular.evaluate``.

    Examples
    --------
    >>> change_without(scene_with(EXAMPLES["opening"]), "opening") is None
    True
    """
    from granular.effects.selection import select
    from granular.evaluation import evaluate

    selection = select(scene)
    try:
        less = evaluate(listing(scene, selection.without_effect(name)))
    except (ConflictingKeys, RouteOutOfDomain, ComplianceInfinite, ResultOutOfRange):
        return None
    return relative_change(less, evaluate(listing(scene, selection.simulated)))


def relative_change(result: Evaluation, reference: Evaluation) -> float:
    """Compare two results component by component.

    Parameters
    ----------
    result, reference : Evaluation
        Two stiffnesses [Pa].

    Returns
    -------
    float
        Relative difference of the worst component [-]; one that vanishes in both does not differ.

    Notes
    -----
    Source: the definition.
    """
    pairs = zip(_six(result), _six(reference), strict=True)
    return max(abs(one - other) / other if other else (float("inf") if one else 0.0) for one, other in pairs)


def _six(result: Evaluation) -> tuple[float, ...]:
    stiffness = result.stiffness
    return (stiffness.C1111, stiffness.C3333, stiffness.C1122, stiffness.C1133, stiffness.C2323, stiffness.C1212)
