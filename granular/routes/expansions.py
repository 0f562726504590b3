"""Sums and products of doubles without loss: what rounding takes away is kept as a double of its own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

SPLIT = 134217729.0
"""2^27 + 1, which splits a double into two halves (Dekker, 1971)."""


def two_sum(a: Array, b: Array) -> tuple[Array, Array]:
    """Add two arrays.

    Parameters
    ----------
    a, b : (...) array
        Numbers of any unit [-].

    Returns
    -------
    tuple of 2 array, (...)
        a + b and what rounding took from it [-], both exact.

    Notes
    -----
    Source: Knuth's error-free sum.

    Examples
    --------
    >>> [part.item() for part in two_sum(np.array(1.0), np.array(2.0**-60))]
    [1.0, 8.673617379884035e-19]
    """
    total = a + b
    shadow = total - a
    return total, (a - (total - shadow)) + (b - shadow)


def two_product(a: Array, b: Array) -> tuple[Array, Array]:
    """Multiply two arrays.

    Parameters
    ----------
    a, b : (...) array
        Numbers of any unit between about 2^-450 and 2^450 in size, or zero [-].

    Returns
    -------
    tuple of 2 array, (...)
        a b and what rounding took from it [-], both exact.

    Notes
    -----
    Source: Dekker's error-free product.

    Examples
    --------
    >>> [part.item() for part in two_product(np.array(1 + 2.0**-30), np.array(1 + 2.0**-30))]
    [1.0000000018626451, 8.673617379884035e-19]
    """
    product = a * b
    shifted = SPLIT * a
    a_high = shifted - (shifted - a)
    a_low = a - a_high
    shifted = SPLIT * b
    b_high = shifted - (shifted - b)
    b_low = b - b_high
    return product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def accurate_sum(first: Array, *terms: Array) -> Array:
    """Add as if in twice the precision, and round once.

    Parameters
    ----------
    first, *terms : (...) array
        Numbers of any unit [-].

    Returns
    -------
    (...) array
        Their sum [-].

    Notes
    -----
    Source: compensated summation.

    Examples
    --------
    >>> accurate_sum(np.array(1e16), np.array(1.0), np.array(-1e16)).item()
    1.0
    """
    total, rest = first, np.zeros_like(first)
    for term in terms:
        total, lost = two_sum(total, term)
        rest = rest + lost
    return total + rest


def products(left: Sequence[Array], right: Sequence[Array]) -> list[Array]:
    """Multiply two unevaluated sums without loss.

    Parameters
    ----------
    left, right : sequence of (...) array
        Terms of the two sums [-].

    Returns
    -------
    list of (...) array
        Terms of the product [-], two for each pair.

    Notes
    -----
    Source: :func:`two_product`.

    Examples
    --------
    >>> len(products([np.array(1.0), np.array(2.0)], [np.array(3.0)]))
    4
    """
    return [part for a in left for b in right for part in two_product(a, b)]


def folded_sum(terms: Sequence[Array], folds: int) -> Array:
    """Add as if in ``folds`` times the precision, and round once.

    Parameters
    ----------
    terms : sequence of (...) array
        Numbers of any unit [-].
    folds : int
        Precision over that of a double [-], >= 2.

    Returns
    -------
    (...) array
        Their sum [-], to 2^-53 of itself plus 2^(-53 folds) of the sum of the sizes.

    Notes
    -----
    Source: Ogita, Rump and Oishi, SIAM J. Sci. Comput. 26 (2005), SumK.

    Examples
    --------
    >>> folded_sum([np.array(v) for v in (1e30, 1.0, -1e30, 1e-30)], 3).item()
    1.0
    """
    rest = list(terms)
    for _ in range(folds - 1):
        for index in range(1, len(rest)):
            rest[index], rest[index - 1] = two_sum(rest[index], rest[index - 1])
    total = rest[0]
    for term in rest[1:]:
        total = total + term
    return total
