"""Kinds of numbers in which the integrand is evaluated, and the libraries that only a comparison needs."""

from __future__ import annotations

import importlib
import math
from fractions import Fraction
from typing import Any

from granular.cost.records import NotServed, RouteFailed


def library(name: str) -> Any:
    """Load a library that nothing but the comparison uses.

    Parameters
    ----------
    name : str
        Name of the module.

    Returns
    -------
    module
        The module.

    Raises
    ------
    NotServed
        It is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError:
        raise NotServed(f"{name} is not installed") from None


class Floats:
    """Doubles, one at a time."""

    number = staticmethod(float)
    sqrt = staticmethod(math.sqrt)
    cbrt = staticmethod(math.cbrt)

    @staticmethod
    def pressed(force: float) -> float:
        """The force where it presses [-]."""
        return max(force, 0.0)

    @staticmethod
    def left(shear: float, limit: float) -> float:
        """What is left of friction, 1 - shear/limit or 0 [-]."""
        return 1 - shear / limit if limit > shear else 0.0


class Arrays:
    """Doubles, many at a time."""

    number = staticmethod(float)

    @staticmethod
    def sqrt(value: Any) -> Any:
        """Square root."""
        import numpy as np

        return np.sqrt(value)

    @staticmethod
    def cbrt(value: Any) -> Any:
        """Cube root."""
        import numpy as np

        return np.cbrt(value)

    @staticmethod
    def pressed(force: Any) -> Any:
        """The force where it presses."""
        import numpy as np

        return np.maximum(force, 0.0)

    @staticmethod
    def left(shear: Any, limit: Any) -> Any:
        """What is left of friction, 1 - shear/limit or 0."""
        import numpy as np

        used = np.divide(shear, limit, out=np.ones_like(limit), where=limit > shear)
        return 1 - used


class Multiple:
    """Floating point of many digits by mpmath, in its current working precision."""

    def __init__(self) -> None:
        """Load mpmath."""
        self.mp = library("mpmath")

    def number(self, value: Fraction) -> Any:
        """A rational number, rounded once."""
        return self.mp.mpf(value.numerator) / value.denominator

    def sqrt(self, value: Any) -> Any:
        """Square root."""
        return self.mp.sqrt(value)

    def cbrt(self, value: Any) -> Any:
        """Cube root."""
        return self.mp.cbrt(value)

    def pressed(self, force: Any) -> Any:
        """The force where it presses."""
        return force if force > 0 else self.mp.mpf(0)

    def left(self, shear: Any, limit: Any) -> Any:
        """What is left of friction, 1 - shear/limit or 0."""
        return 1 - shear / limit if limit > shear else self.mp.mpf(0)


def rational(value: Any) -> Fraction:
    """A number of mpmath or SymPy as the rational number that it is.

    Raises
    ------
    RouteFailed
        It is not a finite real number.
    """
    sign, mantissa, exponent, _ = getattr(value, "_mpf_", (0, 0, 1, 0))
    if not mantissa and (exponent or not hasattr(value, "_mpf_")):
        raise RouteFailed("the result is not a finite real number")
    exact = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -exact if sign else exact
