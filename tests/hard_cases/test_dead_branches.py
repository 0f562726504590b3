"""A piecewise formula printed for arrays evaluates every branch: why the emitted code has no Piecewise in it."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

T, H = sympy.symbols("t h", real=True)

FIRST_MOMENT = sympy.Piecewise(
    (sympy.atan(sympy.sqrt(T)) / sympy.sqrt(T), T > 0), (sympy.atanh(sympy.sqrt(-T)) / sympy.sqrt(-T), T < 0),
    (1, True))
"""Int_0^1 dx/(1 + t x^2), which is 1 at t = 0."""

SHEAR = sympy.Piecewise((H ** sympy.Rational(1, 3), H > 0), (0, True))
"""Cube root of what is left before a contact slides."""


def test_a_branch_that_is_not_taken_divides_by_zero() -> None:
    """The library no longer evaluates branches that are not taken; then the emitted code could be simpler."""
    compiled = sympy.lambdify(T, FIRST_MOMENT, "numpy")
    with pytest.raises((ZeroDivisionError, RuntimeWarning)):
        compiled(0.0)
    with np.errstate(all="ignore"):
        assert float(compiled(np.float64(0.0))) == 1.0
    with pytest.raises(RuntimeWarning):
        compiled(np.array([-0.5, 0.5]))


def test_the_cube_root_of_a_dead_branch() -> None:
    """A sliding contact no longer raises a warning although its branch is zero: then a guard is superfluous."""
    compiled = sympy.lambdify(H, SHEAR, "numpy")
    with pytest.raises(RuntimeWarning, match="invalid value"):
        compiled(np.array([-1.0, 8.0]))
    with np.errstate(all="ignore"):
        assert compiled(np.array([-1.0, 8.0])).tolist() == [0.0, 2.0]
