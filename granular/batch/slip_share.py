"""The share of its friction that a contact uses up, and what is left of it, where plain arithmetic would lose digits.

Written for numbers and for arrays alike: nothing but + - * / and square roots, so that both give the same bits.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import numpy as np

Value = TypeVar("Value", float, "np.typing.NDArray[np.float64]")

SPLITTER = 2.0**27 + 1
"""Cuts a double into two halves of 26 digits, whose products are exact."""


def exact_sum(left: Value, right: Value) -> tuple[Value, Value]:
    """Add two numbers exactly.

    Parameters
    ----------
    left, right : float or (n,) array
        Any numbers far from overflow [any unit].

    Returns
    -------
    tuple of 2 float or (n,) array
        The rounded sum, and what rounding took from it.

    Notes
    -----
    Accuracy: exact. Source: Knuth's two-sum.

    Examples
    --------
    >>> exact_sum(1.0, 2.0**-60) == (1.0, 2.0**-60)
    True
    """
    total = left + right
    part = total - left
    return total, (left - (total - part)) + (right - part)


def exact_product(left: Value, right: Value) -> tuple[Value, Value]:
    """Multiply two numbers exactly.

    Parameters
    ----------
    left, right : float or (n,) array
        Any numbers far from overflow and underflow [any unit].

    Returns
    -------
    tuple of 2 float or (n,) array
        The rounded product, and what rounding took from it.

    Notes
    -----
    Accuracy: exact. Source: Dekker's product.

    Examples
    --------
    >>> exact_product(1 + 2.0**-30, 1 + 2.0**-30)[1] == 2.0**-60
    True
    """
    product = left * right
    wide, broad = SPLITTER * left, SPLITTER * right
    upper, top = wide - (wide - left), broad - (broad - right)
    lower, bottom = left - upper, right - top
    return product, lower * bottom - (((product - upper * top) - lower * top) - upper * bottom)


def friction_used(D33: Value, stress_ratio: Value, friction: Value) -> tuple[Value, Value]:
    """Largest share of the friction that a contact uses up, and the margin to sliding, without loss.

    Parameters
    ----------
    D33, stress_ratio, friction : float or (n,) array
        P2 coefficient of the contact-normal density, sigma33/sigma11 > 0, and mu > 0 [-].

    Returns
    -------
    tuple of 2 float or (n,) array
        kappa and 1 - kappa [-]; NaN where the square of the friction overflows or vanishes.

    Notes
    -----
    Accuracy: a few units in the last place of either, kappa near zero and 1 - kappa near zero included, down to
    1e-16 of the numbers that they are differences of. Source: the onset of sliding 4 a c mu^2 = (c - a)^2.

    Examples
    --------
    >>> [float(value) for value in friction_used(0.0, 4.0, 0.75)]
    [1.0, 0.0]
    """
    along, along_rest = exact_sum(5.0 + 0.0 * D33, -D33)
    across, across_rest = exact_sum(5.0 + 0.0 * D33, 2.0 * D33)
    pole, pole_rest = exact_product(stress_ratio, along)
    pole_rest = pole_rest + stress_ratio * along_rest
    apart, apart_rest = exact_sum(pole, -across)
    apart, apart_rest = exact_sum(apart, apart_rest + (pole_rest - across_rest))
    both, both_rest = exact_product(pole, across)
    both_rest = both_rest + (pole * across_rest + pole_rest * across)
    square, square_rest = exact_product(friction, friction)
    left, left_rest = exact_product(4.0 * both, square)
    left_rest = left_rest + 4.0 * (both * square_rest + both_rest * square)
    right, right_rest = exact_product(apart, apart)
    right_rest = right_rest + 2.0 * (apart * apart_rest)
    more, more_rest = exact_sum(left, -right)
    kappa = abs(apart) / np.sqrt(left)
    return kappa, (more + (more_rest + (left_rest - right_rest))) / (left * (1.0 + kappa))


HELPERS: tuple[Callable[..., object], ...] = (exact_sum, exact_product, friction_used)
"""What a compiler has to know to compile a loop that calls the last of them."""
