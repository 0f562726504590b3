"""How symmetric a stiffness is: its distance to isotropy, transverse isotropy and orthotropy, in the best frame."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from granular.mandel import Matrix, symmetric_rows
from granular.notation import MANDEL_PAIRS, NORMAL_PAIRS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

SymmetryClass = Literal["isotropic", "transversely isotropic", "orthotropic", "general"]
"""From the most to the least symmetric."""

AXES = 400
"""Axes over the half sphere from which the search starts [-]."""


@dataclass(frozen=True, slots=True)
class Symmetry:
    """What a stiffness is to a tolerance, and how far it is from every class.

    Attributes
    ----------
    name : str
        The most symmetric class within the tolerance.
    isotropic, transversely_isotropic, orthotropic : float
        Distance to the nearest tensor of the class over the norm of the tensor [-], 0 to 1.
    axis : tuple of 3 float
        Axis of the nearest transversely isotropic tensor [-], a unit vector of either sign.
    frame : (3, 3) tuple of float
        Axes of the nearest orthotropic tensor, one a row [-], right-handed.
    """

    name: SymmetryClass
    isotropic: float
    transversely_isotropic: float
    orthotropic: float
    axis: tuple[float, float, float]
    frame: tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]


def classify(mandel: Matrix, *, tolerance: float = 1e-9) -> Symmetry:
    """Classify a stiffness or compliance by its distance to each class.

    Parameters
    ----------
    mandel : (6, 6) numbers
        Mandel matrix, order 11, 22, 33, 23, 13, 12 [any unit].
    tolerance : float
        Distance over the norm that still counts as belonging to a class [-]; the accuracy of the tensor, say.

    Returns
    -------
    Symmetry
        The class, the three distances, axis and frame.

    Raises
    ------
    TensorNotElastic
        No symmetric 6 x 6 matrix of finite numbers.

    Notes
    -----
    Accuracy: distances are found to about 1e-14 when they vanish, otherwise to 1e-9. The search starts from many axes
    and frames; a least distance that all of them miss is conceivable, not known. Where a class is met in many frames
    (isotropic: in all), one of them is returned. Source: orthogonal projection in the norm of Mandel's notation, which
    is that of the tensor; least squares over axes and frames.

    Examples
    --------
    >>> from granular.mandel import axial_rows
    >>> found = classify(axial_rows((9.0, 7.0, 3.0, 2.0, 2.5, 3.0)))
    >>> found.name, [round(abs(value), 9) for value in found.axis]
    ('transversely isotropic', [0.0, 0.0, 1.0])
    """
    import numpy as np

    rows = symmetric_rows(mandel, "stiffness")
    size = float(np.linalg.norm(rows))
    if size == 0.0:
        size = 1.0
    matrix = np.array(rows) / size
    isotropic = float(np.linalg.norm(matrix - isotropic_part(matrix)))
    axis, axial = _nearest_axis(matrix)
    frame, orthotropic = _nearest_frame(matrix, axis)
    orthotropic = min(orthotropic, axial)
    axial, orthotropic = min(axial, isotropic), min(orthotropic, isotropic)
    names: tuple[tuple[SymmetryClass, float], ...] = (
        ("isotropic", isotropic), ("transversely isotropic", axial), ("orthotropic", orthotropic))
    name: SymmetryClass = next((name for name, distance in names if distance <= tolerance), "general")
    one, two, three = ((float(a), float(b), float(c)) for a, b, c in frame)
    return Symmetry(name, isotropic, axial, orthotropic, (float(axis[0]), float(axis[1]), float(axis[2])),
                    (one, two, three))


def isotropic_part(matrix: Array) -> Array:
    """The nearest isotropic tensor: the mean over all rotations.

    Parameters
    ----------
    matrix : (6, 6) array
        Mandel matrix [any unit].

    Returns
    -------
    (6, 6) array
        The projection [same unit].

    Notes
    -----
    Source: bulk and shear projectors J and K are an orthogonal basis.

    Examples
    --------
    >>> import numpy as np
    >>> isotropic_part(np.diag([3.0, 3.0, 3.0, 3.0, 3.0, 3.0])).round(12).tolist()[0]
    [3.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    """
    import numpy as np

    bulk = np.zeros((6, 6))
    bulk[:3, :3] = 1 / 3
    shear = np.eye(6) - bulk
    found: Array = (matrix * bulk).sum() * bulk + (matrix * shear).sum() / 5 * shear
    return found


def axial_part(matrix: Array) -> Array:
    """The nearest tensor that is transversely isotropic about axis 3: the mean over all rotations about it.

    Parameters
    ----------
    matrix : (6, 6) array
        Mandel matrix [any unit].

    Returns
    -------
    (6, 6) array
        The projection [same unit].

    Notes
    -----
    Source: five mutually orthogonal tensors span the class.

    Examples
    --------
    >>> import numpy as np
    >>> axial_part(np.diag([4.0, 2.0, 1.0, 1.0, 3.0, 0.0])).diagonal().tolist()
    [2.25, 2.25, 1.0, 2.0, 2.0, 1.5]
    """
    import numpy as np

    plane = np.zeros((6, 6))
    plane[:2, :2] = 0.5
    horizontal = np.zeros((6, 6))
    horizontal[:2, :2] = [[0.5, -0.5], [-0.5, 0.5]]
    horizontal[5, 5] = 1
    vertical = np.diag([0.0, 0, 0, 1, 1, 0])
    along = np.diag([0.0, 0, 1, 0, 0, 0])
    mixed = np.zeros((6, 6))
    mixed[:2, 2] = mixed[2, :2] = 0.5
    found: Array = np.zeros((6, 6))
    for basis in (plane, horizontal, vertical, along, mixed):
        found = found + (matrix * basis).sum() / (basis * basis).sum() * basis
    return found


def orthotropic_part(matrix: Array) -> Array:
    """The nearest tensor whose planes of symmetry are the coordinate planes: what mirrors leave unchanged.

    Parameters
    ----------
    matrix : (6, 6) array
        Mandel matrix [any unit].

    Returns
    -------
    (6, 6) array
        The projection [same unit].

    Notes
    -----
    Source: components with an index an odd number of times change their sign in a mirror.

    Examples
    --------
    >>> import numpy as np
    >>> orthotropic_part(np.ones((6, 6)))[3].tolist()
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]
    """
    import numpy as np

    kept = np.eye(6)
    kept[:3, :3] = 1
    found: Array = matrix * kept
    return found


def _six_by_six(turns: Array) -> Array:
    """Mandel matrices of rotations, (..., 6, 6) of (..., 3, 3)."""
    import numpy as np

    first = np.array([i - 1 for i, _ in MANDEL_PAIRS])
    second = np.array([j - 1 for _, j in MANDEL_PAIRS])

    def taken(rows: NDArray[np.int64], columns: NDArray[np.int64]) -> Array:
        entries: Array = turns[..., rows[:, None], columns[None, :]]
        return entries

    weight = np.where(np.arange(6) < NORMAL_PAIRS, 1.0, math.sqrt(2.0))
    found: Array = (taken(first, first) * taken(second, second) + taken(first, second) * taken(second, first)) / 2
    found *= np.outer(weight, weight)
    return found


def _in_frames(matrix: Array, frames: Array) -> Array:
    """The tensor in frames whose axes are rows, (..., 6, 6)."""
    import numpy as np

    six = _six_by_six(frames)
    found: Array = six @ matrix @ np.swapaxes(six, -1, -2)
    return found


def _frames_of_axes(axes: Array) -> Array:
    """Frames (q, 3, 3) whose third axes are the columns given, (3, q)."""
    import numpy as np

    third = axes.T
    least = np.eye(3)[np.argmin(np.abs(third), axis=1)]
    first = np.cross(third, least)
    first /= np.linalg.norm(first, axis=1)[:, None]
    frames: Array = np.stack([first, np.cross(third, first), third], axis=1)
    return frames


def _improved(matrix: Array, part: Callable[[Array], Array], starts: Array, free: int) -> tuple[Array, float]:
    """The best frame by least squares from several ones, and the distance there."""
    import numpy as np
    from scipy.optimize import least_squares
    from scipy.spatial.transform import Rotation

    best, least = starts[0], math.inf
    for start in starts:
        def frame_of(turn: Array, start: Array = start) -> Array:
            vector = np.concatenate([turn, np.zeros(3 - free)])
            frame: Array = Rotation.from_rotvec(vector).as_matrix() @ start
            return frame

        def rest(turn: Array, frame_of: Callable[[Array], Array] = frame_of) -> Array:
            seen = _in_frames(matrix, frame_of(turn))
            left: Array = (seen - part(seen)).ravel()
            return left

        found = least_squares(rest, np.zeros(free), method="lm", ftol=1e-15, xtol=1e-15, gtol=1e-15)
        distance = float(np.linalg.norm(found.fun))
        if distance < least:
            best, least = frame_of(found.x), distance
    return best, least


def _nearest_axis(matrix: Array) -> tuple[Array, float]:
    import numpy as np

    from granular.general.fabric import spread_directions

    frames = _frames_of_axes(np.concatenate([np.eye(3), spread_directions(AXES)], axis=1))
    frame, distance = _improved(matrix, axial_part, _closest(matrix, axial_part, frames, 3), 2)
    axis: Array = frame[2] if frame[2][np.abs(frame[2]).argmax()] > 0 else -frame[2]
    return axis, distance


def _nearest_frame(matrix: Array, axis: Array) -> tuple[Array, float]:
    import numpy as np
    from scipy.spatial.transform import Rotation

    from granular.general.fabric import spread_directions

    angles = np.linspace(0, np.pi / 2, 9)[:-1]
    turns = Rotation.from_rotvec(np.outer(angles, [0.0, 0.0, 1.0])).as_matrix()
    axes = np.concatenate([axis[:, None], spread_directions(AXES // 4)], axis=1)
    frames = (turns[None] @ _frames_of_axes(axes)[:, None]).reshape(-1, 3, 3)
    frames = np.concatenate([np.eye(3)[None], _principal_frames(matrix), frames])
    return _improved(matrix, orthotropic_part, _closest(matrix, orthotropic_part, frames, 5), 3)


def _closest(matrix: Array, part: Callable[[Array], Array], frames: Array, count: int) -> Array:
    """The frames in which least is left over."""
    import numpy as np

    seen = _in_frames(matrix, frames)
    left = [float(np.linalg.norm(one - part(one))) for one in seen]
    chosen: Array = frames[np.argsort(left, kind="stable")[:count]]
    return chosen


def _principal_frames(matrix: Array) -> Array:
    """Principal axes of C_ijkk and C_ikjk, which planes of symmetry share."""
    import numpy as np

    from granular.elasticity import Stiffness

    tensor = Stiffness.from_mandel(matrix).tensor()
    frames = []
    for subscripts in ("ijkk->ij", "ikjk->ij"):
        vectors = np.linalg.eigh(np.einsum(subscripts, tensor))[1]
        frames.append((vectors * np.sign(np.linalg.det(vectors))).T)
    return np.array(frames)
