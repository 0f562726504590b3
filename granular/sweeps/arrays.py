"""The engine for whole arrays: axial fabrics under axial stresses, evaluated by ``axial_stiffness``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from granular.error_budget import SCALING_ERROR
from granular.errors import BadOption, ComplianceInfinite, GranularError, ResultOutOfRange
from granular.hypothesis import Hypothesis
from granular.ratios import PAIRS
from granular.routes.result import COMPONENTS
from granular.scene import Scene
from granular.sweeps.points import MISTAKES, Points, SceneBuilder, at_point
from granular.table import Table
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
_SLIDING = ("D33", "stress_ratio", "friction_coefficient")
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

    from granular.routes.slip_geometry_array import slides

    quantities, codes = _quantities(points, keep_going=keep_going)
    normalised, reference = np.full((points.count, len(COMPONENTS)), np.nan), np.full(points.count, np.nan)

    def refused(place: int, refusal: GranularError) -> None:
        if not keep_going or isinstance(refusal, MISTAKES):
            with at_point(points.at(place)):
                raise refusal
        codes[place] = refusal.code

    left = [np.flatnonzero((codes == "") & (quantities["hypothesis"] == name)) for name in Hypothesis]
    while left:
        here = left.pop()
        try:
            normalised[here], reference[here] = _stiffness(quantities, here)
        except GranularError as refusal:
            if here.size == 1:
                refused(int(here[0]), refusal)
            elif not isinstance(refusal, ComplianceInfinite):
                left += np.array_split(here, 2)[::-1]  # the first half comes next, so that the first point is told
            elif keep_going:
                sliding = slides(*(quantities[name][here] for name in _SLIDING))
                codes[here[sliding]] = refusal.code
                left.append(here[~sliding])
            else:
                left.append(here[slides(*(quantities[name][here] for name in _SLIDING))][:1])
    components = normalised * reference[:, None]
    for place in np.flatnonzero((codes == "") & _lost(components, quantities["poisson_ratio"])).tolist():
        refused(place, _lost_digits(components[place], reference[place]))
        components[place] = reference[place] = np.nan
    return _kept(components, reference, codes.tolist(), outputs)


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


def _quantities(points: Points, *, keep_going: bool) -> tuple[dict[str, NDArray[Any]], NDArray[np.object_]]:
    """Everything that enters, point by point, and the codes of tables that are refused; each table is built once."""
    import numpy as np

    builder = SceneBuilder(points.base)
    quantities: dict[str, NDArray[Any]] = {}
    codes = np.full(points.count, "", dtype=object)
    for table in dict.fromkeys(table for table, _ in QUANTITIES.values()):
        shape, along = points.along(table)
        built: list[tuple[Table | None, str]] = []
        for values in along:
            try:
                with at_point(values):
                    built.append((builder.table(table, values), ""))
            except GranularError as refusal:
                if not keep_going or isinstance(refusal, MISTAKES):
                    raise
                built.append((None, refusal.code))
        sound = np.array([not code for _, code in built])

        def spread(content: list[Any], shape: tuple[int, ...] = shape) -> NDArray[Any]:
            return np.broadcast_to(np.array(content).reshape(shape), points.shape).ravel()

        for name, (home, read) in QUANTITIES.items():
            if home == table:
                known = [None if code else read(content) for content, code in built]
                filling = next((value for value in known if value is not None), None)
                quantities[name] = spread([filling if code else value
                                           for value, (_, code) in zip(known, built, strict=True)])
        codes = np.where(spread(sound.tolist()), codes, spread([code for _, code in built]))
    return quantities, codes


def _stiffness(quantities: dict[str, NDArray[Any]], here: NDArray[np.intp]) -> tuple[Array, Array]:
    """Normalised components and their unit [Pa] at some points of one hypothesis."""
    import numpy as np

    from granular.array_stiffness import axial_stiffness
    from granular.contact_law import reference_stiffness

    if not here.size:
        return np.empty((0, len(COMPONENTS))), np.empty(0)
    D33, Dr33, stress_ratio, friction, poisson_ratio = (quantities[name][here] for name in _NORMALISED)
    never_slips = friction.dtype == object  # None: a scene without friction
    normalised = axial_stiffness(D33, Dr33, stress_ratio, None if never_slips else friction, poisson_ratio,
                                 hypothesis=quantities["hypothesis"][here[0]].item())
    scales, place = np.unique(np.stack([quantities[name][here] for name in _REFERENCE]), axis=1, return_inverse=True)
    units = [reference_stiffness(shear_modulus, poisson_ratio, mean_stress=mean_stress, void_ratio=void_ratio,
                                 coordination_number=coordination_number, length_ratio=length_ratio)
             for shear_modulus, poisson_ratio, mean_stress, void_ratio, coordination_number, length_ratio
             in scales.T.tolist()]
    return normalised, np.array(units)[place.ravel()]


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
