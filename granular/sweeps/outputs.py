"""What a sweep can keep of every point; a new output is one entry of the catalogue."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from granular.axial_scene import AXIS_3
from granular.effects import CATALOGUE as EFFECTS
from granular.errors import AxisNeeded, MissingKey
from granular.ratios import PAIRS
from granular.report import MEANING
from granular.routes.result import COMPONENTS
from granular.sweeps.scene_fields import DIMENSIONLESS

if TYPE_CHECKING:
    from granular.evaluation import Evaluation

Form = Literal["number", "count", "text", "flags", "matrix"]
"""A double, a whole number, a text, one truth value for each effect, or six times six doubles."""

EXTRA_DIMENSIONS: dict[Form, tuple[tuple[str, tuple[str, ...]], ...]] = {
    "number": (), "count": (), "text": (),
    "flags": (("effect", tuple(effect.name for effect in EFFECTS)),),
    "matrix": (("row", ("11", "22", "33", "23", "13", "12")), ("column", ("11", "22", "33", "23", "13", "12"))),
}
"""Dimensions that a variable has beside those of the sweep, with their coordinates."""

EXTENTS = {form: tuple(len(labels) for _, labels in dimensions) for form, dimensions in EXTRA_DIMENSIONS.items()}
"""Their sizes [-]."""

FILL: dict[Form, float | int | str | bool] = {"number": math.nan, "count": -1, "text": "", "flags": False,
                                              "matrix": math.nan}
"""What stands where a point was refused, or not computed yet."""

REFUSAL = "refusal"
"""Variable with the code of what was refused at a point, empty where nothing was."""


@dataclass(frozen=True, slots=True)
class Variable:
    """One variable of the dataset.

    Attributes
    ----------
    name : str
        Its name.
    unit : str or None
        Its SI unit; None for what has no unit.
    meaning : str
        What it is.
    form : str
        What one point has of it.
    """

    name: str
    unit: str | None
    meaning: str
    form: Form = "number"


@dataclass(frozen=True, slots=True)
class Output:
    """Something that can be kept of every point.

    Attributes
    ----------
    name : str
        Name in the sweep file.
    variables : tuple of Variable
        What it adds to the dataset.
    read : callable
        Gives the values of the variables, in their order, from an evaluated point.
    """

    name: str
    variables: tuple[Variable, ...]
    read: Callable[[Evaluation], Sequence[object]]


def _six(result: Evaluation) -> Sequence[object]:
    if result.axis != AXIS_3:
        raise AxisNeeded("outputs = stiffness for a scene that is not symmetric about axis 3",
                         allowed="allowed its six components only there", remedy='Write outputs = ["mandel"].')
    return [result.stiffness.component(name) for name in COMPONENTS]


def _engineering(result: Evaluation) -> Sequence[object]:
    constants = result.engineering
    return [getattr(constants, name) for name in MODULI]


def _waves(result: Evaluation) -> Sequence[object]:
    waves = result.waves
    if waves is None:
        raise MissingKey("grains.density is not given", allowed="the output waves needs it",
                         remedy="Add it to the scene, or leave waves out.")
    thomsen = waves.thomsen
    return [waves.vertical.P, waves.vertical.SH, waves.horizontal.P, waves.horizontal.SV, waves.horizontal.SH,
            thomsen.epsilon, thomsen.gamma, math.nan if thomsen.delta is None else thomsen.delta]


def _effects(result: Evaluation) -> Sequence[object]:
    return [[effect.name in result.effects_simulated for effect in EFFECTS]]


MODULI = {"E1": "horizontal Young's modulus", "E3": "vertical Young's modulus",
          "nu12": "Poisson's ratio, horizontal under horizontal", "nu13": "Poisson's ratio, vertical under horizontal",
          "nu31": "Poisson's ratio, horizontal under vertical", "G23": "vertical shear modulus",
          "G12": "horizontal shear modulus", "K": "bulk modulus"}
"""The engineering constants, in the order of their record."""

STIFFNESS = Output("stiffness", tuple(Variable(name, "Pa", f"stiffness, {MEANING[name]}") for name in COMPONENTS), _six)
MANDEL = Output("mandel", (Variable("mandel", "Pa", "stiffness as a matrix in Mandel notation", "matrix"),),
                lambda result: [[list(row) for row in result.stiffness.rows]])
RELATIVE_ERROR = Output(
    "relative_error", (Variable("relative_error", DIMENSIONLESS, "bound for the worst component"),),
    lambda result: [result.relative_error])
REFERENCE = Output(
    "reference_stiffness", (Variable("reference_stiffness", "Pa", "(M/V) l_e^2 k_n of the isotropic assembly"),),
    lambda result: [result.reference_stiffness])
RATIOS = Output(
    "ratios", tuple(Variable(f"{over}_over_{under}", DIMENSIONLESS, f"{MEANING[over]} over {MEANING[under]}")
                    for over, under in PAIRS), lambda result: [ratio.value for ratio in result.ratios])
ROUTE = Output("route", (Variable("route", None, "way of computing", "text"),), lambda result: [result.route])
EFFECTS_OUTPUT = Output("effects", (Variable("simulated", None, "whether an effect is simulated", "flags"),), _effects)
EVALUATIONS = Output(
    "evaluations", (Variable("evaluations", DIMENSIONLESS, "directions with an evaluated integrand", "count"),),
    lambda result: [result.evaluations])
ENGINEERING = Output(
    "engineering", tuple(Variable(name, DIMENSIONLESS if name.startswith("nu") else "Pa", meaning)
                         for name, meaning in MODULI.items()), _engineering)
WAVES = Output("waves", (
    Variable("P_vertical", "m/s", "speed of P along axis 3"), Variable("S_vertical", "m/s", "speed of S along axis 3"),
    Variable("P_horizontal", "m/s", "speed of P across axis 3"),
    Variable("SV_horizontal", "m/s", "speed of SV across axis 3"),
    Variable("SH_horizontal", "m/s", "speed of SH across axis 3"),
    Variable("epsilon", DIMENSIONLESS, "Thomsen's epsilon"), Variable("gamma", DIMENSIONLESS, "Thomsen's gamma"),
    Variable("delta", DIMENSIONLESS, "Thomsen's delta")), _waves)

OUTPUTS = {output.name: output for output in (
    STIFFNESS, MANDEL, RATIOS, REFERENCE, ENGINEERING, WAVES, RELATIVE_ERROR, ROUTE, EFFECTS_OUTPUT, EVALUATIONS)}
"""Every output by its name in the sweep file."""

REFUSALS = Variable(REFUSAL, None, "code of what was refused, empty where nothing was", "text")
"""The variable that every dataset has."""


def variables_of(outputs: Sequence[str]) -> tuple[Variable, ...]:
    """The variables of some outputs, and that of the refusals.

    Parameters
    ----------
    outputs : sequence of str
        Names of outputs.

    Returns
    -------
    tuple of Variable
        In their order.

    Notes
    -----
    Source: the catalogue of outputs.

    Examples
    --------
    >>> [variable.name for variable in variables_of(["ratios"])]
    ['C1111_over_C3333', 'C2323_over_C1212', 'refusal']
    """
    return (*(variable for name in outputs for variable in OUTPUTS[name].variables), REFUSALS)
