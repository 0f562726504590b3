"""Branch lengths of graded spheres, eqs (15)-(17): what every distribution of them answers.

Two grains in contact are taken for two independent draws from the grains by number, so that the density of all branch
lengths is the self-convolution of the density of radii, eq. (16). Along one direction it is the cube root of that,
eq. (17). Without a preferred orientation the branches of every direction are distributed in the same way, eq. (15).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.errors import WrongType
from granular.fields import Number
from granular.gradation.lognormal import Lognormal
from granular.gradation.measured_curve import MeasuredCurve
from granular.gradation.size_distribution import SIZE, SizeDistribution, each
from granular.units import shown

if TYPE_CHECKING:
    from granular.gradation.size_distribution import Sizes

_POWER = Number(at_least=-4.0, at_most=4.0, why="no stiffness or volume needs more",
                remedy="Give a power inside the interval.")


@dataclass(frozen=True, slots=True)
class Moment:
    """A mean power of the branch length along a direction.

    Attributes
    ----------
    value : float
        <l^k>_g [m^k].
    relative_error : float
        Bound of its relative error [-].
    """

    value: float
    relative_error: float


class BranchLengths(ABC):
    """Densities of branch lengths.

    Methods that take a length also take an array of them, and return a float for a number and an array of the same
    shape for an array.
    """

    @property
    @abstractmethod
    def relative_error(self) -> float:
        """Bound of the relative error of both densities where they are not negligibly small [-]."""

    def total_density(self, length: Sizes) -> Any:
        """Density of all branch lengths, g_total of eq. (16) [1/m]; ``length`` [m], > 0."""
        return each(self._total_density, length, "length", SIZE)

    def density(self, length: Sizes) -> Any:
        """Density of branch lengths along any one direction, g of eq. (17) [1/m]; ``length`` [m], > 0."""
        return each(self._density, length, "length", SIZE)

    def moment(self, power: float) -> Moment:
        """Mean power of the branch length along a direction, <l^power>_g; ``power`` [-], -4 to 4."""
        return self._moment(_POWER.read(power, "power"))

    @abstractmethod
    def _total_density(self, length: float) -> float: ...

    @abstractmethod
    def _density(self, length: float) -> float: ...

    @abstractmethod
    def _moment(self, power: float) -> Moment: ...


def branch_lengths(sizes: SizeDistribution) -> BranchLengths:
    """Branch lengths of spheres of a size distribution.

    Parameters
    ----------
    sizes : SizeDistribution
        Grain sizes.

    Returns
    -------
    BranchLengths
        Densities (16) and (17) and moments of (17), each with its error.

    Raises
    ------
    WrongType
        It is no size distribution of this package.

    Notes
    -----
    Source: eqs (12), (16), (17).

    Examples
    --------
    >>> from granular.gradation import Lognormal
    >>> length = branch_lengths(Lognormal("5 mm", 1.5)).moment(1)
    >>> round(length.value, 5), length.relative_error < 1e-13
    (0.00513, True)
    """
    from granular.gradation.curve_branches import CurveBranches
    from granular.gradation.lognormal_branches import LognormalBranches

    known = require_known(sizes)
    return LognormalBranches(known) if isinstance(known, Lognormal) else CurveBranches(known)


def require_known(sizes: SizeDistribution) -> Lognormal | MeasuredCurve:
    """Refuse what is no size distribution of this package.

    Parameters
    ----------
    sizes : SizeDistribution
        Grain sizes.

    Returns
    -------
    Lognormal or MeasuredCurve
        The same.

    Raises
    ------
    WrongType
        It is neither.

    Notes
    -----
    Source: the two that have branch lengths.
    """
    if isinstance(sizes, Lognormal | MeasuredCurve):
        return sizes
    raise WrongType(f"sizes = {shown(sizes)}", allowed="allowed Lognormal or MeasuredCurve",
                    remedy="Build one of them.")
