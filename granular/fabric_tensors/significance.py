"""Is the anisotropy there, is it more than rank two, is it axial: tests from the moments alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import UnknownChoice
from granular.fabric_tensors.axial_fit import along, symmetry_axis
from granular.fabric_tensors.components import PAIRS, full_2
from granular.fabric_tensors.frames import (
    ACROSS_2,
    ALL_4,
    OFF_AXIS_2,
    ORTHOTROPIC_4,
    OTHER_4,
    TILTED_4,
    frame_about,
    in_frame,
    rows_2,
    rows_4,
    turning,
)
from granular.fabric_tensors.reading import read_axis
from granular.fabric_tensors.symmetry_test import SymmetryTest, chi_squared, squared_distance

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]

FOR_RANK_FOUR = 100
"""Effective number of directions from which tests of rank four are made: there a level of 5 % is 9 % in truth, 6 % from
400 on. Below, the scatter of so many numbers is known too badly."""


def uniformity(tensors: FabricTensors, axis: ArrayLike | None = None, *, rank: int = 2) -> SymmetryTest:
    """Test whether the directions could come from an isotropic fabric.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    axis : (3,) array, optional
        An axis known beforehand [-]. Then only D33, or D33 and D3333, about it are looked at: a sharper question, and
        blind to all other anisotropy.
    rank : 2 or 4
        Departures that are looked for: of rank two, or of rank two and four together.

    Returns
    -------
    SymmetryTest
        Score test of a uniform density, chi-squared with 5 or 14 degrees of freedom; with an axis, 1 or 2.

    Raises
    ------
    TooFewDirections
        The effective number is below 16.
    UnknownChoice
        Another rank.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: the chance is that of many directions; at 50 of them the level of 5 % is kept within a percent. With
    unequal weights the effective number stands for the number, as if weights knew nothing of directions.
    Source: ``derivations.fabric_kinds``; rank two is Bingham's test, and Kanatani's likelihood test near isotropy.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import isotropic
    >>> uniformity(fabric_of(directions_of(isotropic(), 500))).significant()
    False
    """
    import numpy as np

    tensors.require()
    if rank not in (2, 4):
        raise UnknownChoice(f"rank = {rank!r}", allowed="allowed 2, 4", remedy="Give one of these ranks.")
    if axis is None:
        squares, freedom = (2 / 15 * float(np.sum(tensors.D2**2)), 8 / 315 * float(np.sum(tensors.D4**2))), (5, 9)
    else:
        D33, D3333 = along(tensors.D2, tensors.D4, read_axis(axis))
        squares, freedom = (float(D33) ** 2 / 5, float(D3333) ** 2 / 9), (1, 1)
    statistic = tensors.effective_number * sum(squares[:rank // 2])
    dof = sum(freedom[:rank // 2])
    upto = f"{'of rank two' if rank == 2 else 'up to rank four'}{'' if axis is None else ' about the given axis'}"
    return SymmetryTest(f"anisotropy {upto}", f"no anisotropy {upto} is seen", f"there is anisotropy {upto}",
                        statistic, dof, chi_squared(statistic, dof))


def rank_four(tensors: FabricTensors) -> SymmetryTest:
    """Test whether there is anisotropy of rank four, whatever there is of rank two.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.

    Returns
    -------
    SymmetryTest
        Nine numbers against their own scatter.

    Raises
    ------
    TooFewDirections
        The effective number is below 100.

    Notes
    -----
    Accuracy: exact for normal scatter of the moments. Source: D_ijkl = 0 of the third kind, whose covariance comes
    from moments of rank eight.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import axial_tensors
    >>> rank_four(fabric_of(directions_of(axial_tensors(0.5), 500))).significant()
    False
    """
    import numpy as np

    tensors.require(FOR_RANK_FOUR)
    _, D4, linear, covariance = in_frame(tensors.moments, tensors.covariance, np.eye(3))
    rows = rows_4(ALL_4)
    return _tested("anisotropy of rank four", "no anisotropy of rank four is seen", "there is anisotropy of rank four",
                   rows @ D4, rows @ linear[6:], covariance, tensors.effective_number)


def axial_symmetry(tensors: FabricTensors, axis: ArrayLike | None = None, *, rank: int = 4) -> SymmetryTest:
    """Test whether the fabric is axially symmetric, against one without symmetry.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    axis : (3,) array, optional
        The axis [-]; fitted when left out.
    rank : 2 or 4
        Highest rank that is looked at. A tensor of rank two is orthotropic at least, so that with rank two and a
        fitted axis the question is axial or orthotropic.

    Returns
    -------
    SymmetryTest
        Of 12 numbers about a given axis, 10 about a fitted one (4 and 2 for rank two).

    Raises
    ------
    TooFewDirections
        The effective number is below 16 for rank two or 100 for rank four.
    UnknownChoice
        Another rank.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: to first order in the scatter; a fitted axis needs an anisotropy of rank two that is significant, or
    there is no axis to speak of. Source: components that vanish about the axis, with the scatter of the axis in them.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import axial_tensors
    >>> tensors = fabric_of(directions_of(axial_tensors(0.8), 500))
    >>> axial_symmetry(tensors).significant(), axial_symmetry(tensors, [1.0, 0.0, 0.0]).significant()
    (False, True)
    """
    import numpy as np

    if rank not in (2, 4):
        raise UnknownChoice(f"rank = {rank!r}", allowed="allowed 2, 4", remedy="Give one of these ranks.")
    tensors.require(*((FOR_RANK_FOUR,) if rank == 4 else ()))
    fitted = axis is None
    frame = frame_about(symmetry_axis(tensors) if axis is None else read_axis(axis))
    D2, D4, linear, covariance = in_frame(tensors.moments, tensors.covariance, frame)
    parts_2 = rows_2(ACROSS_2) if fitted else rows_2((*OFF_AXIS_2, *ACROSS_2))
    values, gradient = [parts_2 @ D2], [parts_2 @ linear[:6]]
    if rank == 4:
        parts_4 = rows_4((*TILTED_4, *OTHER_4))
        change = linear[6:] - _tilted_along(D2, D4, linear) if fitted else linear[6:]
        values.append(parts_4 @ D4)
        gradient.append(parts_4 @ change)
    where = "" if fitted else " about the given axis"
    return _tested(f"axial symmetry{where}, rank {'two' if rank == 2 else 'two and four'}",
                   f"the fabric can be axially symmetric{where}", f"the fabric is not axially symmetric{where}",
                   np.concatenate(values), np.concatenate(gradient), covariance, tensors.effective_number)


def orthotropy(tensors: FabricTensors) -> SymmetryTest:
    """Test whether the part of rank four is orthotropic in the principal axes of rank two.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.

    Returns
    -------
    SymmetryTest
        Of six numbers.

    Raises
    ------
    TooFewDirections
        The effective number is below 100.

    Notes
    -----
    Accuracy: to first order in the scatter; needs three principal values that are apart, so it says something only
    where axial symmetry of rank two falls. Source: components odd in an axis, with the scatter of the axes in them.

    Examples
    --------
    >>> import numpy as np
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import tensors_of
    >>> orthotropy(fabric_of(directions_of(tensors_of(np.diag([-0.7, 0.0, 0.7])), 500))).significant()
    False
    """
    import numpy as np

    tensors.require(FOR_RANK_FOUR)
    _, vectors = np.linalg.eigh(tensors.D2)
    D2, D4, linear, covariance = in_frame(tensors.moments, tensors.covariance, vectors.T)
    rows = rows_4(ORTHOTROPIC_4)
    change = linear[6:] - _turned_along(D2, D4, linear)
    return _tested("orthotropy of rank four", "the fabric can be orthotropic", "the fabric is not orthotropic",
                   rows @ D4, rows @ change, covariance, tensors.effective_number)


@dataclass(frozen=True, slots=True)
class Significance:
    """All tests of one list of directions, from the coarse question to the fine one.

    Attributes
    ----------
    tests : tuple of SymmetryTest
        In the order in which they are asked.
    """

    tests: tuple[SymmetryTest, ...]

    def __iter__(self) -> Iterator[SymmetryTest]:
        """Go through the tests."""
        return iter(self.tests)

    @property
    def words(self) -> str:
        """Verdicts at the level of 5 %, as one sentence."""
        return "; ".join(test.words for test in self.tests) + "."


def significance(tensors: FabricTensors, axis: ArrayLike | None = None) -> Significance:
    """Ask everything that makes sense: anisotropy, rank four, then the symmetry where there is something to have one.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    axis : (3,) array, optional
        An axis that is known beforehand, such as the vertical [-].

    Returns
    -------
    Significance
        Anisotropy of rank two, about the given axis too when there is one, and of rank four. Where any is seen, axial
        symmetry about the given axis; where that of rank two is seen, axial symmetry about the fitted axis, and
        orthotropy where axial symmetry of rank two falls.

    Raises
    ------
    TooFewDirections
        The effective number is below 100.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: as each test; p-values are those of single tests, and nobody has corrected them for being several.
    Source: the tests of this module.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import isotropic
    >>> len(significance(fabric_of(directions_of(isotropic(), 500))).tests)
    2
    """
    tests = [uniformity(tensors), *([] if axis is None else [uniformity(tensors, axis)]), rank_four(tensors)]
    if axis is not None and any(test.significant() for test in tests):
        tests.append(axial_symmetry(tensors, axis))
    if tests[0].significant():
        tests.append(axial_symmetry(tensors))
        if axial_symmetry(tensors, rank=2).significant():
            tests.append(orthotropy(tensors))
    return Significance(tuple(tests))


def _tested(name: str, holds: str, fails: str, values: Array, gradient: Array, covariance: Array,
            number: float) -> SymmetryTest:
    statistic, p = squared_distance(values, gradient @ covariance @ gradient.T, number)
    return SymmetryTest(name, holds, fails, statistic, len(values), p)


def _tilted_along(D2: Array, D4: Array, linear: Array) -> Array:
    """Change of D_ijkl that only follows the fitted axis, axis 3, as a linear function of the moments.

    To first order the axis moves across by (D_33 - D)^-1 dD_i3 with the part D of D_ij that is across.
    """
    import numpy as np

    principal = full_2(D2)
    apart = principal[2, 2] * np.eye(2) - principal[:2, :2]
    moves = np.linalg.pinv(apart) @ linear[[PAIRS.index((0, 2)), PAIRS.index((1, 2))]]
    tilts: Array = sum((np.outer(turning(D4, 2, i), moves[i]) for i in (0, 1)), np.zeros((15, 15)))
    return tilts


def _turned_along(D2: Array, D4: Array, linear: Array) -> Array:
    """Change of D_ijkl that only follows the principal axes of D_ij, as a linear function of the moments.

    A change of D_ij off the diagonal turns its axes: by dD_ij/(D_j - D_i), from axis j towards axis i.
    """
    import numpy as np

    principal = full_2(D2)
    total = np.zeros((15, 15))
    for i, j in ((0, 1), (0, 2), (1, 2)):
        apart = principal[j, j] - principal[i, i]
        if apart != 0:
            total += np.outer(turning(D4, j, i), linear[PAIRS.index((i, j))]) / apart
    return total
