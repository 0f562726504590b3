"""What every distribution of grain sizes answers: fraction finer, densities by volume and by number, a few sizes.

Sizes are grain diameters, as sieves measure them; radii are half of that, and densities in radius twice as high.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from granular.fields import Number
from granular.units import LENGTH

if TYPE_CHECKING:
    import numpy.typing as npt

    Sizes = float | npt.ArrayLike
    """One size or fraction, or an array of them."""

SIZE = Number(dimension=LENGTH, at_least=1e-30, at_most=1e30, why="its powers must fit into double precision",
              remedy="Give the diameter of a grain, a positive length.")
"""Interval of the size of a grain [m]."""

_FRACTION = Number(at_least=0.0, at_most=1.0)
ANY_SIZE = Number(dimension=LENGTH, at_least=0.0)
"""Interval of the argument of a density [m]."""

_VOID_RATIO = Number(above=0.0)


class SizeDistribution(ABC):
    """Grain sizes of an assembly, by volume and by number.

    Sizes are diameters in metres. Methods that take a size or a fraction also take an array of them, and return
    a float for a number and an array of the same shape for an array.
    """

    def fraction_finer(self, size: Sizes) -> Any:
        """Volume fraction of grains finer than a size, F of eq. (13) [-]; ``size`` [m], >= 0."""
        return each(self._fraction_finer, size, "size", ANY_SIZE)

    def density_by_volume(self, size: Sizes) -> Any:
        """Density of sizes by volume, f^v of eq. (13) [1/m]; ``size`` [m], >= 0."""
        return each(self._density_by_volume, size, "size", ANY_SIZE)

    def density_by_number(self, size: Sizes) -> Any:
        """Density of sizes by number of grains, f^p of eq. (12) [1/m]; ``size`` [m], >= 0."""
        return each(self._density_by_number, size, "size", ANY_SIZE)

    def size_at(self, fraction: Sizes) -> Any:
        """Size [m] than which a volume fraction is finer, the smallest of them on a gap; ``fraction`` [-], 0 to 1."""
        return each(self._size_at, fraction, "fraction", _FRACTION)

    @property
    def D10(self) -> float:
        """Size than which a tenth of the volume is finer [m]."""
        return self._size_at(0.1)

    @property
    def D30(self) -> float:
        """Size than which three tenths of the volume are finer [m]."""
        return self._size_at(0.3)

    @property
    def D50(self) -> float:
        """Median size by volume [m]."""
        return self._size_at(0.5)

    @property
    def D60(self) -> float:
        """Size than which six tenths of the volume are finer [m]."""
        return self._size_at(0.6)

    @property
    def uniformity(self) -> float:
        """Coefficient of uniformity C_u = D60/D10 [-]."""
        return self.D60 / self.D10

    @property
    def curvature(self) -> float:
        """Coefficient of curvature C_c = D30^2/(D10 D60) [-]."""
        return (self.D30 / self.D10) * (self.D30 / self.D60)

    def grains_per_volume(self, void_ratio: float) -> float:
        """Number of grains per volume of the assembly, delta^v of eq. (11) [1/m^3]; ``void_ratio`` [-], > 0."""
        void_ratio = _VOID_RATIO.read(void_ratio, "void_ratio")
        return 6.0 / math.pi / (1.0 + void_ratio) / self.equal_volume_diameter**3

    @property
    @abstractmethod
    def equal_volume_diameter(self) -> float:
        """Diameter of the equal grains that are as many in as much solid, <d^3>^(1/3) by number [m]."""

    @abstractmethod
    def _fraction_finer(self, size: float) -> float: ...

    @abstractmethod
    def _density_by_volume(self, size: float) -> float: ...

    @abstractmethod
    def _density_by_number(self, size: float) -> float: ...

    @abstractmethod
    def _size_at(self, fraction: float) -> float: ...


def each(function: Callable[[float], float], values: Sizes, name: str, kind: Number) -> Any:
    """Apply a function to a number, or to every element of an array.

    Parameters
    ----------
    function : callable
        Function of one float.
    values : float or array
        The arguments [as ``kind`` says].
    name : str
        Their name for messages.
    kind : Number
        Their interval.

    Returns
    -------
    float or array
        Values of the function [its own unit], in the shape of the arguments.

    Raises
    ------
    ValueOutOfRange, NotFinite, WrongType
        An argument is outside its interval, or no number.

    Notes
    -----
    Source: none; elementwise application.
    """
    if isinstance(values, int | float):
        return function(kind.read(values, name))
    import numpy as np

    array = np.asarray(values)
    found = [function(kind.read(value, name)) for value in array.ravel().tolist()]
    return np.array(found, dtype=float).reshape(array.shape)
