"""Which numbers vanish by symmetry, as linear functions of the moments, in axes that are given or fitted."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.fabric_tensors.components import PAIRS, QUADRUPLES, different_4, full_4, rotation_matrix, third_kind

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Row = dict[str, float]

OFF_AXIS_2: tuple[Row, ...] = ({"13": 1.0}, {"23": 1.0})
ACROSS_2: tuple[Row, ...] = ({"11": 1.0, "22": -1.0}, {"12": 1.0})
TILTED_4: tuple[Row, ...] = ({"1333": 1.0}, {"2333": 1.0})
OTHER_4: tuple[Row, ...] = ({"1133": 1.0, "2233": -1.0}, {"1233": 1.0}, {"1113": 1.0, "1223": -3.0},
                            {"2223": 1.0, "1123": -3.0}, {"1111": 1.0, "1122": -6.0, "2222": 1.0},
                            {"1112": 1.0, "1222": -1.0})
"""What vanishes about an axial axis 3: by rank, and by how often it turns round in one turn about the axis: in rank two
once and twice, in rank four once, and twice to four times."""

ALL_4: tuple[Row, ...] = ({"3333": 1.0}, *TILTED_4, *OTHER_4)
"""Nine numbers that determine rank four of the third kind."""

ORTHOTROPIC_4: tuple[Row, ...] = ({"1112": 1.0}, {"1222": 1.0}, {"1113": 1.0}, {"1333": 1.0}, {"2223": 1.0},
                                  {"2333": 1.0})
"""What vanishes when axes 1, 2 and 3 are two-fold; the traces tie the others to these."""


def third_matrix() -> tuple[Array, Array]:
    """D_ij and D_ijkl as linear functions of the moments N_ijkl.

    Returns
    -------
    second : (6, 15) array
        D_ij without its constant [-].
    fourth : (15, 15) array
        D_ijkl without its constant [-].

    Notes
    -----
    Accuracy: exact. Source: the emitted functions at zero and at the unit vectors.
    """
    import numpy as np

    second, fourth = third_kind(np.eye(15))
    second_0, fourth_0 = third_kind(np.zeros(15))
    return (second - second_0).T, (fourth - fourth_0).T


def rows_2(rows: tuple[Row, ...]) -> Array:
    """Matrix of numbers made of the components of D_ij.

    Parameters
    ----------
    rows : tuple of dict
        Coefficient of each component by its indices [-].

    Returns
    -------
    (m, 6) array
        Columns in the order of ``PAIRS`` [-].

    Notes
    -----
    Source: definition.
    """
    return _matrix(rows, PAIRS)


def rows_4(rows: tuple[Row, ...]) -> Array:
    """Matrix of numbers made of the components of D_ijkl.

    Parameters
    ----------
    rows : tuple of dict
        Coefficient of each component by its indices [-].

    Returns
    -------
    (m, 15) array
        Columns in the order of ``QUADRUPLES`` [-].

    Notes
    -----
    Source: definition.
    """
    return _matrix(rows, QUADRUPLES)


def _matrix(rows: tuple[Row, ...], indices: tuple[tuple[int, ...], ...]) -> Array:
    import numpy as np

    matrix = np.zeros((len(rows), len(indices)))
    for place, row in enumerate(rows):
        for name, coefficient in row.items():
            matrix[place, indices.index(tuple(int(axis) - 1 for axis in name))] = coefficient
    return matrix


def frame_about(axis: Array) -> Array:
    """Axes with a given third one.

    Parameters
    ----------
    axis : (3,) array
        Unit vector [-].

    Returns
    -------
    (3, 3) array
        One axis a row, right-handed [-]; the unit matrix for axis 3 itself.

    Notes
    -----
    Accuracy: to rounding. Source: the first axis lies across the base vector that is farthest from the given one.
    """
    import numpy as np

    base = np.eye(3)[int(np.argmin(np.abs(axis)))]
    first = base - (base @ axis) * axis
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(axis, first), axis])


def in_frame(moments: Array, covariance: Array, frame: Array) -> tuple[Array, Array, Array, Array]:
    """Third kind in other axes, as numbers and as linear functions of the moments in those axes.

    Parameters
    ----------
    moments : (15,) array
        N_ijkl in the old axes [-].
    covariance : (15, 15) array
        Of the moments [-].
    frame : (3, 3) array
        One new axis a row [-].

    Returns
    -------
    D2 : (6,) array
        D_ij [-].
    D4 : (15,) array
        D_ijkl [-].
    both : (21, 15) array
        The matrix that gives changes of D_ij and D_ijkl from changes of the moments in the new axes [-].
    covariance : (15, 15) array
        Of the moments in the new axes [-].

    Notes
    -----
    Accuracy: to rounding. Source: the law of transformation.
    """
    import numpy as np

    turn = rotation_matrix(frame)
    D2, D4 = third_kind(turn @ moments)
    return D2, D4, np.concatenate(third_matrix()), turn @ covariance @ turn.T


def turning(D4: Array, first: int, second: int) -> Array:
    """How D_ijkl changes when the fabric turns from one axis towards another.

    Parameters
    ----------
    D4 : (15,) array
        Different components [-].
    first, second : int
        Numbers of the axes, 0 to 2; the fabric's direction ``first`` moves towards ``second``.

    Returns
    -------
    (15,) array
        Change per radian [-].

    Notes
    -----
    Accuracy: to rounding. Source: derivative of the law of transformation.
    """
    import numpy as np

    spin = np.zeros((3, 3))
    spin[second, first], spin[first, second] = 1.0, -1.0
    tensor = full_4(D4)
    terms = ("ap,pbcd->abcd", "bp,apcd->abcd", "cp,abpd->abcd", "dp,abcp->abcd")
    change: Array = sum((np.einsum(term, spin, tensor) for term in terms), np.zeros((3,) * 4))
    return different_4(change)
