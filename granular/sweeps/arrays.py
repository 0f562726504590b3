"""The engine for whole arrays: axial fabrics under axial stresses, evaluated by ``axial_stiffness``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from granular.error_budget import SCALING_ERROR
from granular.errors import BadOption, GranularError, ResultOutOfRange
from granular.ratios import PAIRS
from granular.routes.result import COMPONENTS
from granular.scene import Scene
from granular.sweeps.points import MISTAKES, Points, SceneBuilder, at_point
from granular.units import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FIELDS = ("grains.shear_modulus", "grains.poisson_ratio", "grains.friction_angle", "grains.friction_coefficient",
          "packing.void_ratio", "packing.coordination_number", "packing.contact_normals.D33",
          "branches.anisotropy.D33", "branches.length_ratio", "stress.mean", "stress.ratio", "model.hypothesis")
"""What may vary."""

OUTPUTS = ("stiffness", "ratios", "reference_stiffness", "relative_error")
"""What can be kept."""

QUANTITIES: dict[str, tuple[str, Callable[[Any], object]]] = {
    "D33": ("packing", lambda packing: packing.contact_normals.coefficients[0] if packing.contact_normals else 0.0),
    "Dr33": ("branches", lambda branches: branches.anisotropy.coefficient if branches and branches.anisotropy else 0.0),
    "stress_ratio": ("stress", lambda stress: 1.0 if stress.ratio is None else stress.ratio),
    "friction_coefficient": ("grains", lambda grains: grains.friction),
    "poisson_ratio": ("grains", lambda grains: grains.poisson_ratio),
    "shear_modulus": ("grains", lambda grains: grains.shear_modulus),
    "mean_stress": ("stress", lambda stress: stress.mean_stress),
    "void_ratio": ("packing", lambda packing: packing.void_ratio),
    "coordination_number": ("packing", lambda packing: packing.coordination),
    "length_ratio": ("branches", lambda branches: branches.length_ratio if branches else 1.0),
    "hypothesis": ("model", lambda model: model.hypothesis.value),
}
"""What enters: the table that it stands in, and how it is read there."""

_NORMALISED = ("D33", "Dr33", "stress_ratio", "friction_coefficient", "poisson_ratio")
_REFERENCE = ("shear_modulus", "poisson_ratio", "mean_stress", "void_ratio", "coordination_number", "length_ratio")


def require_array_options(fields: Sequence[str], outputs: Sequence[str]) -> None:
    """Refuse a sweep over fields that ``axial_stiffness`` does not take, or for what it does not tell.

    Parameters
    ----------
    fields, outputs : sequence of str
        What varies, and what is kept.

    Raises
    ------
    BadOption
        A field or an output is not covered.

    Notes
    -----
    Source: the arguments of ``granular.axial_stiffness``.
    """
    for field in fields:
        if field not in FIELDS:
            raise _refusal(f"the field {field}", f"fields out of {', '.join(FIELDS)}")
    for output in outputs:
        if output not in OUTPUTS:
            raise _refusal(f"the output {output}", f"outputs out of {', '.join(OUTPUTS)}")


def require_array_scene(scene: Scene) -> None:
    """Refuse a scene of which ``axial_stiffness`` would ignore a part.

    Parameters
    ----------
    scene : Scene
        A point of a sweep; all have the same tables and keys.

    Raises
    ------
    BadOption
        A part of it is not covered.

    Notes
    -----
    Source: the arguments of ``granular.axial_stiffness``.
    """
    normals, branches = scene.packing.contact_normals, scene.branches
    anisotropy = None if branches is None else branches.anisotropy
    for found, there in (
            ("a gradation", scene.gradation), ("a shape", scene.shape), ("a stress tensor", scene.stress.tensor),
            ("contact normals beyond D33", normals is not None and (normals.D33 is None or normals.D3333)),
            ("a tensor of branch lengths", anisotropy is not None and anisotropy.D33 is None),
            (f"effects = {shown(list(scene.model.effects))}", scene.model.effects != "auto")):
        if there:
            raise _refusal(found, "D33 of contact normals and branches, mean and ratio of the stress, all effects")


def _refusal(found: str, allowed: str) -> BadOption:
    return BadOption(f'engine = "axial_stiffness" with {found}', allowed=f"allowed with {allowed}",
                     remedy='Say engine = "evaluate", which computes scene by scene.')


def evaluate_arrays(points: Points, outputs: Sequence[str], *, keep_going: bool) -> dict[str, list[object]]:
    """Compute a chunk at once.

    Parameters
    ----------
    points : Points
        Its points.
    outputs : sequence of str
        What is kept.
    keep_going : bool
        Whether a refused point becomes a gap with its code, in place of an error.

    Returns
    -------
    dict
        Variable -> its values, the last dimension running fastest; ``refusal`` holds the codes.

    Raises
    ------
    GranularError
        The first point that is refused, unless ``keep_going``.

    Notes
    -----
    Accuracy: ``granular.axial_stiffness``, and the step to pascals. Source: eqs (1)-(23).
    """
    import numpy as np

    quantities = _quantities(points)
    codes = [""] * points.count
    try:
        normalised, reference = _stiffness(quantities)
    except GranularError:
        normalised, reference = _one_by_one(points, quantities, codes, keep_going=keep_going)
    components = normalised * reference[:, None]
    for place in np.flatnonzero(_lost(components, quantities["poisson_ratio"])).tolist():
        if not codes[place]:
            _refuse_or_note(points, place, codes, _lost_digits(components[place], reference[place]),
                            keep_going=keep_going)
            components[place] = reference[place] = np.nan
    return _kept(components, reference, codes, outputs)


def _kept(components: Array, reference: Array, codes: list[str], outputs: Sequence[str]) -> dict[str, list[object]]:
    import numpy as np

    from granular.array_stiffness import RELATIVE_ERROR

    columns = {name: components[:, place] for place, name in enumerate(COMPONENTS)}
    kept: dict[str, Array] = {}
    if "stiffness" in outputs:
        kept |= columns
    if "ratios" in outputs:
        kept |= {f"{over}_over_{under}": columns[over] / columns[under] for over, under in PAIRS}
    if "reference_stiffness" in outputs:
        kept["reference_stiffness"] = reference
    if "relative_error" in outputs:
        kept["relative_error"] = np.where(np.isnan(reference), np.nan, RELATIVE_ERROR + SCALING_ERROR)
    return {name: list(values) for name, values in kept.items()} | {"refusal": list[object](codes)}


def _quantities(points: Points) -> dict[str, NDArray[Any]]:
    """Everything that enters, point by point; each table is built once wherever it stands."""
    import numpy as np

    builder = SceneBuilder(points.base)
    quantities: dict[str, NDArray[Any]] = {}
    for name, (table, read) in QUANTITIES.items():
        shape, along = points.along(table)
        content = np.array([read(builder.table(table, values)) for values in along])
        quantities[name] = np.broadcast_to(content.reshape(shape), points.shape).ravel()
    return quantities


def _stiffness(quantities: dict[str, NDArray[Any]]) -> tuple[Array, Array]:
    """Normalised components and their unit [Pa], for all points of one hypothesis at a time."""
    import numpy as np

    from granular.array_stiffness import axial_stiffness
    from granular.contact_law import reference_stiffness

    given = {name: quantities[name] for name in _NORMALISED}
    frictionless = given["friction_coefficient"].dtype == object  # None: contacts that never slip
    normalised = np.empty((given["D33"].size, len(COMPONENTS)))
    for hypothesis in np.unique(quantities["hypothesis"]).tolist():
        here = quantities["hypothesis"] == hypothesis
        D33, Dr33, stress_ratio, friction, poisson_ratio = (given[name][here] for name in _NORMALISED)
        normalised[here] = axial_stiffness(D33, Dr33, stress_ratio, None if frictionless else friction, poisson_ratio,
                                           hypothesis=hypothesis)
    scales, place = np.unique(np.stack([quantities[name] for name in _REFERENCE]), axis=1, return_inverse=True)
    units = [reference_stiffness(shear_modulus, poisson_ratio, mean_stress=mean_stress, void_ratio=void_ratio,
                                 coordination_number=coordination_number, length_ratio=length_ratio)
             for shear_modulus, poisson_ratio, mean_stress, void_ratio, coordination_number, length_ratio
             in scales.T.tolist()]
    return normalised, np.array(units)[place.ravel()]


def _one_by_one(points: Points, quantities: dict[str, NDArray[Any]], codes: list[str], *,
                keep_going: bool) -> tuple[Array, Array]:
    """The same where a point is refused, which is found by taking them singly."""
    import numpy as np

    normalised, reference = np.full((points.count, len(COMPONENTS)), np.nan), np.full(points.count, np.nan)
    for place in range(points.count):
        try:
            one, unit = _stiffness({name: values[place:place + 1] for name, values in quantities.items()})
        except GranularError as refusal:
            _refuse_or_note(points, place, codes, refusal, keep_going=keep_going)
        else:
            normalised[place], reference[place] = one[0], unit[0]
    return normalised, reference


def _refuse_or_note(points: Points, place: int, codes: list[str], refusal: GranularError, *, keep_going: bool) -> None:
    if not keep_going or isinstance(refusal, MISTAKES):
        with at_point(points.at(place)):
            raise refusal
    codes[place] = refusal.code


def _lost(components: Array, poisson_ratio: Array) -> NDArray[np.bool_]:
    """Points with a component that double precision does not hold with all its digits."""
    import numpy as np

    held = (components >= sys.float_info.min) & (components <= sys.float_info.max)
    crossed = np.isin(COMPONENTS, ("C1122", "C1133"))
    sound: NDArray[np.bool_] = (held | (crossed & (poisson_ratio == 0.0)[:, None])).all(axis=1)  # nu = 0: they vanish
    return ~sound


def _lost_digits(components: Array, reference: float) -> ResultOutOfRange:
    return ResultOutOfRange(f"components = {shown(components.tolist())} Pa, over {reference!r} Pa",
                            allowed=f"allowed {sys.float_info.min:.3g} to {sys.float_info.max:.3g} Pa",
                            remedy="Check the units of shear_modulus and mean stress.")
