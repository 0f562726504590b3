"""Axial symmetry in any frame: find the axis that all tensors share, and turn a scene to axis 3 and back."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, cast

from granular.axial_scene import AxialScene
from granular.errors import FabricOutOfRange
from granular.fabric import AxialFabric
from granular.loading import Loading

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general.fabric import GeneralFabric
    from granular.general.loading import GeneralLoading
    from granular.tensors import Tensor4

    Array = NDArray[np.float64]

NEAR = 2.0**-44
"""A tensor is axial when it differs from its axial part by less than this [-], relative to the isotropic part of the
density, of W or of the stress: some hundred roundings."""


def axial_scene(fabric: GeneralFabric, loading: GeneralLoading | None) -> AxialScene | None:
    """Recognise a scene that has an axis of symmetry.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    loading : GeneralLoading or None
        Stress and friction.

    Returns
    -------
    AxialScene or None
        None when the tensors share no axis, to rounding.

    Notes
    -----
    Accuracy: a difference below ``NEAR`` is left out, and changes the stiffness by about as much. Source: a tensor of
    rank two is axial when two of its principal values are equal; for one of rank four D_iklm D_jklm is.

    Examples
    --------
    >>> from granular.general.fabric import GeneralFabric
    >>> axial_scene(GeneralFabric(D=[[0.5, 0, 0], [0, -0.25, 0], [0, 0, -0.25]]), None).axis
    (1.0, 0.0, 0.0)
    """
    import numpy as np

    second = [np.array(fabric.D), *([] if fabric.Dr is None else [np.array(fabric.Dr)])]
    if loading is not None:
        stress = np.array(loading.stress) / loading.mean
        second.append(stress - np.eye(3) * np.trace(stress) / 3)
    fourth = None if fabric.D4 is None else np.array(fabric.D4)
    axis = _candidate(second, fourth)
    if axis is None:
        return None
    of_rank_four = 0.0 if fourth is None else float(np.einsum("ijkl,i,j,k,l", fourth, axis, axis, axis, axis))
    left = [_left_over(tensor, axis) for tensor in second]
    if fourth is not None:
        left.append(float(np.abs(fourth - of_rank_four * _fourth_about(axis)).max()))
    if not max(left) <= NEAR:
        return None
    try:
        axial = AxialFabric(D33=_inside(float(axis @ second[0] @ axis)), D3333=of_rank_four,
                            Dr33=0.0 if fabric.Dr is None else float(axis @ second[1] @ axis))
    except FabricOutOfRange:  # admissible to rounding only: the route without an axis takes it
        return None
    one, two, three = (0.0 + value for value in axis.tolist())  # no zero with a sign
    return AxialScene(axial, _about(loading, axis), (one, two, three), deviation=max(left))


def _inside(D33: float) -> float:
    """The end of the admissible interval where rounding has passed it; with a rank-four part another bound holds."""
    for end in (-1.0, 2.0):
        if abs(D33 - end) < NEAR:
            return end
    return D33


def _about(loading: GeneralLoading | None, axis: Array) -> Loading | None:
    import numpy as np

    if loading is None:
        return None
    stress = np.array(loading.stress) / loading.mean
    along = float(axis @ stress @ axis)
    across = float((np.trace(stress) - along) / 2)
    if abs(along - across) <= NEAR:
        across = along = 1.0
    return Loading(sigma11=Fraction(across), sigma33=Fraction(along), friction=loading.friction)


def _candidate(second: list[Array], fourth: Array | None) -> Array | None:
    """The axis of the most anisotropic tensor; axis 3 when there is none; None when that tensor has no axis."""
    import numpy as np

    largest = max(second, key=lambda tensor: float(np.abs(tensor).max()))
    if float(np.abs(largest).max()) <= NEAR:
        if fourth is None or float(np.abs(fourth).max()) <= NEAR:
            return np.array([0.0, 0.0, 1.0])
        largest = np.einsum("iklm,jklm->ij", fourth, fourth)
    values, vectors = np.linalg.eigh(largest)
    place = 2 if values[2] - values[1] > values[1] - values[0] else 0
    axis: Array = vectors[:, place]
    if axis[abs(axis).argmax()] < 0:
        axis = -axis
    near = np.abs(axis) < NEAR
    if near.sum() == 2:
        axis = np.where(near, 0.0, 1.0)  # a coordinate axis exactly
    return axis


def _left_over(tensor: Array, axis: Array) -> float:
    """How far a traceless tensor of rank two is from its axial part."""
    import numpy as np

    along = float(axis @ tensor @ axis)
    part = along * (3 * np.outer(axis, axis) - np.eye(3)) / 2
    return float(np.abs(tensor - part).max())


def fourth_about_axis_3(D3333: float) -> Tensor4:
    """The tensor of rank four of a P4 coefficient about axis 3.

    Parameters
    ----------
    D3333 : float
        The coefficient [-].

    Returns
    -------
    (3, 3, 3, 3) tuple of float
        D_ijkl [-] with D_ijkl n_i n_j n_k n_l = D3333 P4(n_3).

    Notes
    -----
    Source: eq. (14) with a term of rank four.

    Examples
    --------
    >>> fourth_about_axis_3(1.0)[2][2][2][2], fourth_about_axis_3(1.0)[0][0][0][0]
    (1.0, 0.375)
    """
    import numpy as np

    first, second, third = (tuple(tuple(tuple(row) for row in block) for block in part)
                            for part in (D3333 * _fourth_about(np.array([0.0, 0.0, 1.0]))).tolist())
    return cast("Tensor4", (first, second, third))


def _fourth_about(axis: Array) -> Array:
    """The traceless tensor of rank four whose form is P4."""
    import numpy as np

    one, two = np.eye(3), np.outer(axis, axis)

    def paired(a: Array, b: Array) -> Array:
        total: Array = sum(np.einsum(f"{pairs}->ijkl", a, b) for pairs in ("ij,kl", "ik,jl", "il,jk"))
        return total / 3

    mixed = (paired(one, two) + paired(two, one)) / 2
    found: Array = (35 * np.einsum("ij,kl->ijkl", two, two) - 30 * mixed + 3 * paired(one, one)) / 8
    return found


def rotation_to(axis: tuple[float, float, float]) -> Array:
    """The rotation that takes axis 3 to a direction, the shortest one.

    Parameters
    ----------
    axis : tuple of 3 float
        Unit vector [-].

    Returns
    -------
    (3, 3) array
        Orthogonal matrix R with R e3 = axis [-]; the identity for axis 3.

    Notes
    -----
    Accuracy: 1e-16. Source: a product of two reflections.

    Examples
    --------
    >>> rotation_to((0.0, 0.0, 1.0)).tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    import numpy as np

    a = np.array(axis)
    if a[2] < 0:  # the axis has no sign, and this keeps away from the half turn
        a = -a
    sum_ = a + np.array([0.0, 0.0, 1.0])
    found: Array = np.eye(3) - np.outer(sum_, sum_) / (1 + a[2]) + 2 * np.outer(a, [0.0, 0.0, 1.0])
    return found
