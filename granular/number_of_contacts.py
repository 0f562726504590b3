"""How many contacts a volume holds: eqs (8)-(9), and the coordination number from the void ratio."""

from __future__ import annotations

import math
from dataclasses import dataclass

from granular.errors import ValueOutOfRange
from granular.units import finite_number


@dataclass(frozen=True, slots=True)
class CoordinationRelation:
    """A straight line between void ratio and mean coordination number, ``e = intercept - slope N``.

    Attributes
    ----------
    intercept : float
        Void ratio at which the line gives no contacts [-], finite.
    slope : float
        Fall of the void ratio for one more contact per grain [-], > 0.
    source : str
        Where the line comes from.
    """

    intercept: float
    slope: float
    source: str

    def __post_init__(self) -> None:
        """Refuse a line that is not finite or does not fall."""
        finite_number(self.intercept, name="intercept")
        if finite_number(self.slope, name="slope") <= 0.0:
            raise ValueOutOfRange(f"slope = {self.slope!r}", allowed="allowed slope > 0 (a denser packing has more "
                                  "contacts)", remedy="Write the line as e = intercept - slope N.")

    def coordination_number(self, void_ratio: float) -> float:
        """Mean number of contacts per grain at a void ratio; not positive where the line has left its range.

        Parameters
        ----------
        void_ratio : float
            Volume of voids over volume of solids, e [-], > 0.

        Returns
        -------
        float
            N = (intercept - e) / slope [-].

        Notes
        -----
        Source: stated by the record. Accuracy: 3 roundings, the first of them of the difference.

        Examples
        --------
        >>> round(DEFAULT_RELATION.coordination_number(0.5744), 12)
        8.6848
        """
        return (self.intercept - void_ratio) / self.slope


DEFAULT_RELATION = CoordinationRelation(
    intercept=1.66, slope=0.125,
    source="the empirical line quoted by Pan & Dong (1999) for their parametric study")
"""The relation used when a scene gives no coordination number."""

PER_DIAMETER_CUBED = "1/(2 r_e)^3"
"""Unit of the number of contacts per volume while no grain size is given: per cube of one grain diameter."""

PER_CUBIC_METRE = "1/m^3"
"""The same where the sizes of the grains are known."""


def contacts_per_volume(void_ratio: float, coordination_number: float, *,
                        grain_diameter: float = 1.0) -> float:
    """Contacts per volume of an assembly, M/V; graded grains count by the sphere of their mean volume.

    Without a grain diameter the unit of length is the diameter 2 r_e itself, and the number is per (2 r_e)^3.
    The stiffness needs no more than that, for it does not depend on the grain size.

    Parameters
    ----------
    void_ratio : float
        Volume of voids over volume of solids, e [-], > 0.
    coordination_number : float
        Mean number of contacts per grain, N [-], > 0.
    grain_diameter : float
        Diameter of a grain [m], > 0; 1.0 for lengths in grain diameters.

    Returns
    -------
    float
        M/V = 3 N / (pi (1 + e) (2 r)^3) [1/m^3, or per cube of a diameter].

    Notes
    -----
    Accuracy: 4 units of the last place. Source: eqs (8) and (9) with grains of one size; two share a contact.

    Examples
    --------
    >>> round(contacts_per_volume(0.5744, 8.6848), 4)
    5.2676
    """
    return 3.0 / math.pi * (coordination_number / (1.0 + void_ratio)) / grain_diameter**3
