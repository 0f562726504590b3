"""Results of scenes that are not symmetric about axis 3, as blocks of text and as JSON: 21 constants in their frame."""

from __future__ import annotations

import math
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

from granular.layout import facts, grid, lines, title, unit_for
from granular.notation import MANDEL_PAIRS
from granular.tensors import shown_direction

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.evaluation import Evaluation
    from granular.general.engineering import GeneralEngineering
    from granular.general.extremes import Extreme
    from granular.general.symmetry import Symmetry
    from granular.general.waves import GeneralWaves, ThreeWaves

OF_LARGEST = "the largest entry of the Mandel matrix"
"""What errors are relative to."""

NAMES = tuple(f"C{i}{j}{k}{m}" for (i, j), (k, m) in combinations_with_replacement(MANDEL_PAIRS, 2))
"""Names of the 21 constants, row by row of the upper triangle."""

NO_DISTANCE = 1e-12
"""Distances to a class of symmetry below this are shown as zero [-]."""

DIGITS = 6
"""Digits of the largest constant in the table [-]."""


def constants(result: Evaluation) -> dict[str, float]:
    """All 21 constants by name.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.

    Returns
    -------
    dict
        C1111 to C1212 -> its value [Pa].

    Notes
    -----
    Source: minor and major symmetry.
    """
    return {name: result.stiffness.component(name) for name in NAMES}


def stiffness_blocks(result: Evaluation) -> list[RenderableType]:
    """The matrix of the constants, the class of symmetry, and moduli.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.

    Returns
    -------
    list of renderable
        Blocks for a console of 80 columns.

    Notes
    -----
    Source: the command line's interface.
    """
    size, unit = unit_for(max(constants(result).values()))
    return [lines(f"C_ijkl in {unit}, rows ij and columns kl; the matrix is symmetric"),
            lines(*_matrix(result, size)), "",
            title("Symmetry"), facts(_symmetry(result)), "",
            title("Engineering constants along the coordinate axes"), _engineering(result.general_engineering), ""]


def wave_blocks(waves: GeneralWaves) -> list[RenderableType]:
    """Speeds along the coordinate axes and their extremes.

    Parameters
    ----------
    waves : GeneralWaves
        Of the dry assembly.

    Returns
    -------
    list of renderable
        Blocks for a console.

    Notes
    -----
    Source: the command line's interface.
    """
    def row(name: str, of: ThreeWaves) -> tuple[str, ...]:
        return name, f"qP {of.qP:.5g}", f"qS1 {of.qS1:.5g}", f"qS2 {of.qS2:.5g}", "m/s"

    split = waves.largest_splitting
    return [title(f"Waves in the dry assembly, {waves.density:.6g} kg/m^3"),
            grid(row(f"along axis {place}", of)
                 for place, of in enumerate((waves.along_1, waves.along_2, waves.along_3), start=1)),
            lines("qP from " + _extreme(waves.slowest_qP, 1.0, "m/s"), "to " + _extreme(waves.fastest_qP, 1.0, "m/s"),
                  f"shear waves split by up to {100 * split.value:.3g} %"
                  + (f", {_where(split)}" if split.value > 0 else "")), ""]


def as_json(result: Evaluation) -> dict[str, Any]:
    """What the JSON object of such a scene holds besides what every object holds.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.

    Returns
    -------
    dict
        What errors are relative to, the rule, the class of symmetry, and six components about the axis [Pa].

    Notes
    -----
    Source: the command line's interface.
    """
    seen = result.symmetry
    content: dict[str, Any] = {
        "relative_error_of": OF_LARGEST, "rule": result.rule,
        "symmetry": {"class": seen.name, "axis": list(seen.axis), "frame": [list(axis) for axis in seen.frame],
                     "distances": {"isotropic": seen.isotropic, "transversely isotropic": seen.transversely_isotropic,
                                   "orthotropic": seen.orthotropic}}}
    if result.about_axis is not None:
        content["about_axis"] = result.about_axis.components
    return content


def waves_as_json(waves: GeneralWaves) -> dict[str, Any]:
    """Speeds along the coordinate axes and their extremes.

    Parameters
    ----------
    waves : GeneralWaves
        Of the dry assembly.

    Returns
    -------
    dict
        Speeds [m/s], directions [-], and the largest splitting [-].

    Notes
    -----
    Source: the command line's interface.
    """
    def three(of: ThreeWaves) -> dict[str, float]:
        return {"qP": of.qP, "qS1": of.qS1, "qS2": of.qS2}

    def extreme(of: Extreme) -> dict[str, Any]:
        return {"value": of.value, "direction": list(of.direction)}

    return {"density": waves.density, "along_1": three(waves.along_1), "along_2": three(waves.along_2),
            "along_3": three(waves.along_3), "fastest_qP": extreme(waves.fastest_qP),
            "slowest_qP": extreme(waves.slowest_qP), "largest_splitting": extreme(waves.largest_splitting)}


def _matrix(result: Evaluation, size: float) -> list[str]:
    """The upper triangle, in one number of decimals; what is within the error of zero is 0."""
    values = constants(result)
    largest = max(values.values())
    decimals = max(0, DIGITS - 1 - math.floor(math.log10(largest / size)))
    noise = max(result.relative_error, 2.0**-50) * largest
    cells = {name: "0" if abs(value) <= noise else f"{value / size:.{decimals}f}" for name, value in values.items()}
    width = max(map(len, cells.values())) + 2
    pairs = [f"{i}{j}" for i, j in MANDEL_PAIRS]
    head = "  " + "".join(f"{pair:>{width}}" for pair in pairs)
    return [head, *(pair + " " * (width * place) + "".join(f"{cells[f'C{pair}{other}']:>{width}}"
                                                           for other in pairs[place:])
                    for place, pair in enumerate(pairs))]


def _symmetry(result: Evaluation) -> dict[str, str]:
    seen = result.symmetry
    known = max(result.relative_error, NO_DISTANCE)
    distances = {"isotropic": seen.isotropic, "transversely isotropic": seen.transversely_isotropic,
                 "orthotropic": seen.orthotropic}
    found = {"class": _class(seen), "distances": "; ".join(
        f"{name} {value:.3g}" if value > known else f"{name} 0" for name, value in distances.items())
        + " (to the nearest tensor of each class, over the norm)"}
    if seen.name == "general":
        found["nearest axis"] = shown_direction(seen.axis)
    if result.about_axis is not None:
        size, unit = unit_for(max(result.about_axis.components.values()))
        found["about it"] = "  ".join(f"{name} {value / size:.7g}"
                                      for name, value in result.about_axis.components.items()) + f"  {unit}"
        found["ratios"] = "  ".join(f"{ratio.name} {ratio.value:.7g}" for ratio in result.ratios)
    return found


def _class(seen: Symmetry) -> str:
    if seen.name == "transversely isotropic":
        return f"{seen.name}, axis n = {shown_direction(seen.axis)}"
    if seen.name == "orthotropic":
        return f"{seen.name}, axes " + ", ".join(shown_direction(axis) for axis in seen.frame)
    return "general, not orthotropic" if seen.name == "general" else seen.name


def _engineering(found: GeneralEngineering) -> RenderableType:
    size, unit = unit_for(max(found.stiffest.value, found.K))
    moduli = {"E1": found.E1, "E2": found.E2, "E3": found.E3, "K": found.K}
    shear = {"G23": found.G23, "G13": found.G13, "G12": found.G12}
    ratios = {"nu12": found.nu12, "nu13": found.nu13, "nu23": found.nu23, "nu21": found.nu21, "nu31": found.nu31,
              "nu32": found.nu32}
    return lines(*("  ".join(f"{name} {value / size:.5g}" for name, value in line.items()) + f"  {unit}"
                   for line in (moduli, shear)),
                 "  ".join(f"{name} {value:.3g}" for name, value in ratios.items()),
                 "Young's modulus from " + _extreme(found.softest, size, unit),
                 "to " + _extreme(found.stiffest, size, unit))


def _extreme(of: Extreme, size: float, unit: str) -> str:
    return f"{of.value / size:.5g} {unit} {_where(of)}"


def _where(of: Extreme) -> str:
    return f"along {shown_direction(of.direction)}{' and elsewhere' if of.ties else ''}"
