"""What gradation does to the stiffness: the moments of branch length that multiply it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from granular.gradation.branch_lengths import branch_lengths, require_known
from granular.gradation.size_distribution import SizeDistribution


@dataclass(frozen=True, slots=True)
class LengthMoments:
    """Moments of the branch length that multiply the stiffness of equal spheres of the same packing.

    Both are 1 for grains of one size. Neither depends on the unit of length: the sizes of all grains times a factor
    leave them as they are.

    Attributes
    ----------
    equal_volume_diameter : float
        Diameter of the equal grains that are as many in as much solid, 2 <r^3>^(1/3) by number [m].
    second : float
        <l^2>_g/(4 <r^3>^(2/3)) [-]; the factor of the kinematic stiffness.
    inverse_second : float
        4 <r^3>^(2/3) <l^-2>_g [-]; the factor of the static compliance.
    relative_error : float
        Bound of the relative error of either moment [-].
    """

    equal_volume_diameter: float
    second: float
    inverse_second: float
    relative_error: float


def length_moments(sizes: SizeDistribution) -> LengthMoments:
    """Moments of branch length that multiply the stiffness of graded spheres.

    Parameters
    ----------
    sizes : SizeDistribution
        Grain sizes.

    Returns
    -------
    LengthMoments
        Equal-volume diameter and the two moments, with their error.

    Raises
    ------
    WrongType
        It is no size distribution of this package.

    Notes
    -----
    Accuracy: stated by the result. Source: eqs (7), (11), (12), (16), (17).

    Examples
    --------
    >>> from granular.gradation import Lognormal
    >>> [round(4.0 * length_moments(Lognormal("5 mm", spread)).second, 3) for spread in (1.2, 1.5, 2.0)]
    [4.356, 6.551, 33.155]
    """
    return _moments(require_known(sizes))


@lru_cache(maxsize=64)
def _moments(sizes: SizeDistribution) -> LengthMoments:
    """Compute once what many scenes of one gradation share."""
    lengths, diameter = branch_lengths(sizes), sizes.equal_volume_diameter
    second, inverse = lengths.moment(2.0), lengths.moment(-2.0)
    return LengthMoments(
        equal_volume_diameter=diameter, second=second.value / diameter**2, inverse_second=inverse.value * diameter**2,
        relative_error=max(second.relative_error, inverse.relative_error))
