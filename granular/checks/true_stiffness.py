"""The true stiffness of a scene in pascals, with all that the scene says and nothing that a plan decided.

Ball arithmetic gives the six components over the unit of stiffness, that unit is built up contact by contact from eqs
(8)-(11) and (20) in ball arithmetic too, and a gradation enters by moments in multiple precision. What a scene says is
read here again, for the choice of effects is one of the things that are checked.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from granular.checks.comparison import worst_relative
from granular.errors import MissingKey
from granular.fabric import AxialFabric
from granular.routes import certified
from granular.routes.balls import arithmetic, ball, fraction

if TYPE_CHECKING:
    from granular.evaluation import Evaluation
    from granular.loading import Loading
    from granular.scene import Scene

DIGITS = 20
"""Of every component: errors of 1e-16 are then known to 1e-4 of themselves."""

CERTIFIED, AXIAL = "ball arithmetic", "axial route"
"""Where the values come from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TrueStiffness:
    """Six components that are known.

    Attributes
    ----------
    components : tuple of 6 Fraction
        C1111, C3333, C1122, C1133, C2323, C1212 [Pa].
    doubt : float
        Relative error that they may have themselves [-].
    source : str
        Ball arithmetic; or the axial route at its full accuracy, for spheroids with contact forces.
    """

    components: tuple[Fraction, ...]
    doubt: float
    source: str


def true_stiffness(scene: Scene) -> TrueStiffness:
    """Compute what a scene's stiffness is.

    Parameters
    ----------
    scene : Scene
        Its list of effects is followed; "auto" means all that the scene holds. Its numbers are taken as exact, and a
        friction angle by the double nearest to its tangent. A gradation must be lognormal.

    Returns
    -------
    TrueStiffness
        Six components [Pa].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    ComplianceInfinite
        Static hypothesis, and contacts slide or have opened in some directions.
    MissingKey
        A gradation without a spread.

    Notes
    -----
    Accuracy: 1e-19 of each component; for spheroids with contact forces, which have no certified value, what the axial
    route states. Source: eqs (1)-(23).

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> f"{float(true_stiffness(scene).components[0]) / 1e6:.4f} MPa"
    '556.7951 MPa'
    """
    fabric, loading = _contacts(scene)
    factor = unit_of_stiffness(scene)
    if scene.gradation is not None and _simulated(scene, "gradation"):
        from granular.checks.true_gradation import length_factor

        if scene.gradation.spread is None:
            raise MissingKey("gradation.spread is not given", allowed="a known stiffness needs a lognormal gradation",
                             remedy="Give median and spread.")
        factor *= length_factor(scene.gradation.spread, scene.model.hypothesis)
    if not fabric.collinear and loading is not None:
        normalised, doubt = _by_the_axial_route(scene)
        return TrueStiffness(components=tuple(factor * value for value in normalised), doubt=doubt, source=AXIAL)
    enclosures = certified.enclose(fabric, poisson_ratio=scene.grains.poisson_ratio,
                                   hypothesis=scene.model.hypothesis, loading=loading, digits=DIGITS)
    return TrueStiffness(components=tuple(factor * enclosure.midpoint for enclosure in enclosures), doubt=1e-19,
                         source=CERTIFIED)


def true_error(evaluation: Evaluation, truth: TrueStiffness) -> tuple[str, float]:
    """Find the component of an evaluation that is worst relative to itself.

    Parameters
    ----------
    evaluation : Evaluation
        What is checked.
    truth : TrueStiffness
        What is known of the same scene.

    Returns
    -------
    name : str
        Which component.
    error : float
        Its relative error in pascals [-]; infinite for a wrong zero and for what is not finite.

    Notes
    -----
    Accuracy: ``truth.doubt``. Source: the definition.
    """
    stiffness = evaluation.stiffness
    name, error, _ = worst_relative(
        [stiffness.C1111, stiffness.C3333, stiffness.C1122, stiffness.C1133, stiffness.C2323, stiffness.C1212],
        list(truth.components))
    return name, error


def unit_of_stiffness(scene: Scene) -> Fraction:
    """(M/V) l_e^2 k_n,ref of the equal grains of a scene, step by step, with a radius of one metre.

    Parameters
    ----------
    scene : Scene
        Solid, packing, length ratio and mean stress; its numbers are taken as exact.

    Returns
    -------
    Fraction
        The unit [Pa].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: 1e-40. Source: eqs (8)-(11), (20), (22) and (23) for the ideal assembly under the mean stress.

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> round(unit_of_stiffness(scene))
    1752631710
    """
    flint = arithmetic()
    with flint.ctx.workprec(160):
        def number(value: float | Fraction) -> Any:
            return ball(flint, Fraction(value))

        grains_per_volume = 1 / ((1 + number(scene.packing.void_ratio)) * 4 / 3 * flint.arb.pi())
        contacts = grains_per_volume * number(_coordination(scene)) / 2
        length = 2 * number(scene.length_ratio)
        force = 3 * number(_mean_stress(scene)) / (contacts * length)
        relative_radius = length / 4
        modulus = number(scene.grains.shear_modulus) / (1 - number(scene.grains.poisson_ratio))
        spring = (3 * modulus * modulus * 2 * relative_radius * force).root(3)
        return fraction((contacts * length * length * spring).mid())


def _coordination(scene: Scene) -> Fraction:
    """Mean number of contacts per grain, without the roundings of the line."""
    packing = scene.packing
    if packing.coordination_number is not None:
        return Fraction(packing.coordination_number)
    line = packing.relation
    return (Fraction(line.intercept) - Fraction(packing.void_ratio)) / Fraction(line.slope)


def _mean_stress(scene: Scene) -> Fraction:
    """Mean stress [Pa], of a tensor without rounding."""
    stress = scene.stress
    if stress.tensor is None:
        return Fraction(stress.mean_stress)
    return sum((Fraction(stress.tensor[i][i]) for i in range(3)), Fraction(0)) / 3


def _simulated(scene: Scene, effect: str) -> bool:
    return scene.model.effects == "auto" or effect in scene.model.effects


def _contacts(scene: Scene) -> tuple[AxialFabric, Loading | None]:
    """Everything that the scene says of its contacts, as far as its list of effects goes."""
    fabric = scene.fabric
    if not _simulated(scene, "packing"):
        fabric = replace(fabric, D33=0.0, D3333=0.0)
    if not _simulated(scene, "branches"):
        fabric = replace(fabric, Dr33=0.0)
    if not _simulated(scene, "deviation"):
        fabric = replace(fabric, aspect_ratio=1.0, free_spin=False)
    if not any(_simulated(scene, effect) for effect in ("kinetic", "slip", "opening")):
        return fabric, None
    loading = scene.stress.loading(scene.grains.friction if _simulated(scene, "slip") else None)
    equator, pole = loading.coefficients(fabric.D33)
    if equator == pole and not loading.slips(fabric.D33):
        return fabric, None  # every contact carries the same force, and none a shear force
    return fabric, loading


def _by_the_axial_route(scene: Scene) -> tuple[list[Fraction], float]:
    """Six components over the unit of stiffness without a gradation, and their error."""
    from granular.evaluation import evaluate

    effects = scene.model.effects
    if effects != "auto":
        effects = tuple(name for name in effects if name != "gradation")
    model = scene.model.model_copy(update={"rtol": None, "effects": effects})
    result = evaluate(scene.model_copy(update={"gradation": None, "model": model}), route="axial")
    return [Fraction(value) for value in result.normalised], result.relative_error
