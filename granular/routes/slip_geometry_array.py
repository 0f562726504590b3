"""Which contacts stick and which slide, for whole arrays: the twin of ``slip_geometry`` in exact float arithmetic."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from granular.routes.expansions import folded_sum, products, two_product, two_sum

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

NEARLY = 2.0**-40
"""Where 1 - kappa^2 is smaller, it is summed once more from its exact terms."""

FOLDS = 8
"""Precision of that sum: 2^-424 of its terms, so that exact tangency is recognised for what it is."""

WIDE = 2.0**60
"""Beyond this kappa the two edges of the sliding range no longer feel each other: 2^-120 of their place."""


@dataclass(frozen=True, slots=True)
class Geometry:
    """Forces and slip of each element.

    Attributes
    ----------
    a, c : (n,) array
        Normal force at equator and pole over that of the isotropic assembly [-].
    kappa, left : (n,) array
        Share of the friction used up where contacts are nearest to sliding, and 1 minus that [-].
    center : (n,) array
        tan(beta) there [-].
    pole, equator : (n,) array
        tan(beta) at the edges of the sliding range [-]; meaningless where kappa <= 1.
    """

    a: Array
    c: Array
    kappa: Array
    left: Array
    center: Array
    pole: Array
    equator: Array

    def of(self, index: NDArray[np.intp]) -> Geometry:
        """Take some of the elements."""
        return Geometry(*(getattr(self, name)[index] for name in self.__slots__))


def forces(D33: Array, stress_ratio: Array) -> tuple[Array, Array]:
    """Normal force at the equator and at the pole over that of the isotropic assembly.

    Parameters
    ----------
    D33, stress_ratio : (n,) array
        P2 coefficient of the contact-normal density, and sigma33/sigma11 > 0 [-].

    Returns
    -------
    tuple of 2 array, (n,)
        a and c [-], to four roundings.

    Notes
    -----
    Source: eq. (23).

    Examples
    --------
    >>> [part.tolist() for part in forces(np.array([0.0]), np.array([1.0]))]
    [[1.0], [1.0]]
    """
    share = 15 / (2 + stress_ratio)
    return share / (5 - D33), share * stress_ratio / (5 + 2 * D33)


def force_difference(D33: Array, stress_ratio: Array) -> Array:
    """Normal force at the pole less that at the equator, with no digit lost where they are close.

    Parameters
    ----------
    D33, stress_ratio : (n,) array
        P2 coefficient of the contact-normal density, and sigma33/sigma11 > 0 [-].

    Returns
    -------
    (n,) array
        c - a over the normal force of the isotropic assembly [-], to a few roundings of itself.

    Notes
    -----
    Source: eq. (23).

    Examples
    --------
    >>> force_difference(np.array([0.0]), np.array([4.0])).tolist()
    [1.5]
    """
    ratio, one = _scaled(stress_ratio)
    apart: Array = folded_sum(_difference(D33, ratio, one), 3)
    return 15 * apart / ((2 * one + ratio) * (5 - D33) * (5 + 2 * D33))


def slip_geometry(D33: Array, stress_ratio: Array, friction: Array) -> Geometry:
    """Find where contacts stick and slide.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        P2 coefficient of the contact-normal density, sigma33/sigma11 > 0, and mu > 0 [-].

    Returns
    -------
    Geometry
        One entry an element.

    Notes
    -----
    Accuracy: 1 - kappa to a few units in the last place however near to zero, and zero where it is. Source: the
    onset of sliding 4 a c mu^2 = (c - a)^2 with a and c freed of common factors and written in the given doubles.
    """
    ratio, one = _scaled(stress_ratio)
    mantissa, exponent = np.frexp(friction)
    across = two_sum(np.full_like(D33, 5.0), 2 * D33)  # 1/c up to factors
    along = two_sum(np.full_like(D33, 5.0), -D33)  # 1/a
    pole = [part for factor in along for part in two_product(ratio, factor)]  # c
    apart = _difference(D33, ratio, one)  # c - a, exactly
    d = np.abs(folded_sum(apart, 3))
    equator, tail = across[0] * one, folded_sum(pole, 2)
    geometric = np.sqrt(equator) * np.sqrt(tail)
    with np.errstate(over="ignore"):
        half = np.ldexp(d / (2 * mantissa), -exponent)
        kappa = half / geometric
    left = np.where(kappa < 0.5, 1 - kappa * kappa, 0.0)
    close = np.flatnonzero((kappa >= 0.5) & (kappa < WIDE))
    if close.size:
        terms = _onset([part[close] for part in across], [part[close] for part in pole],
                       [part[close] for part in apart], one[close], mantissa[close], exponent[close])
        left[close] = folded_sum(terms, 3) / (4 * (geometric * mantissa)[close] ** 2)
        near = np.flatnonzero(np.abs(left[close]) < NEARLY)
        if near.size:
            left[close[near]] = (folded_sum([term[near] for term in terms], FOLDS)
                                 / (4 * (geometric * mantissa)[close[near]] ** 2))
    left = np.where(kappa < WIDE, left / (1 + kappa), -kappa)
    center = np.sqrt(tail / equator)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        spread = kappa + np.sqrt(np.maximum(-left * (1 + kappa), 0.0))
        far = kappa >= WIDE
        towards_pole = np.where(far, tail / (2 * half), center / spread)
        towards_equator = np.where(far, 2 * half / equator, center * spread)
    return Geometry(*forces(D33, stress_ratio), kappa, left, center, towards_pole, towards_equator)


def equal_forces(D33: Array, stress_ratio: Array) -> NDArray[np.bool_]:
    """Whether contacts carry the same force in all directions, decided without rounding.

    Parameters
    ----------
    D33, stress_ratio : (n,) array
        P2 coefficient of the contact-normal density, and sigma33/sigma11 > 0 [-].

    Returns
    -------
    (n,) array of bool
        Where 5 (SR - 1) = D33 (SR + 2) [-].

    Notes
    -----
    Source: a = c in eq. (23).

    Examples
    --------
    >>> equal_forces(np.array([0.0, -1.0, 0.3]), np.array([1.0, 0.5, 1.0])).tolist()
    [True, True, False]
    """
    ratio, one = _scaled(stress_ratio)
    result: NDArray[np.bool_] = folded_sum(_difference(D33, ratio, one), FOLDS) == 0
    return result


def slides(D33: Array, stress_ratio: Array, friction: Array) -> NDArray[np.bool_]:
    """Whether contacts slide over a range of directions.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        As for :func:`slip_geometry`, with friction = 0 allowed [-].

    Returns
    -------
    (n,) array of bool
        False at exact tangency; True without friction [-].

    Notes
    -----
    Source: :func:`slip_geometry`.

    Examples
    --------
    >>> slides(np.zeros(2), np.array([4.0, 4.0]), np.array([0.75, 0.7499999999999999])).tolist()
    [False, True]
    """
    result: NDArray[np.bool_] = friction == 0
    rubbing = np.flatnonzero(friction > 0)
    result[rubbing] = slip_geometry(D33[rubbing], stress_ratio[rubbing], friction[rubbing]).left < 0
    return result


def _scaled(stress_ratio: Array) -> tuple[Array, Array]:
    """Take a power of two out of stress ratio and 1, so that no product of doubles overflows."""
    power = np.floor(np.log2(np.maximum(stress_ratio, 1.0))).astype(np.int64)
    return np.ldexp(stress_ratio, -power), np.ldexp(1.0, -power)


def _difference(D33: Array, ratio: Array, one: Array) -> list[Array]:
    """Terms of 5 (SR - 1) - D33 (SR + 2), scaled by a power of two: their sum is exact."""
    less, more = two_sum(ratio, -one), two_sum(ratio, 2 * one)
    return [*(part for factor in less for part in two_product(np.full_like(D33, 5.0), factor)),
            *(part for factor in more for part in two_product(-D33, factor))]


def _onset(across: list[Array], pole: list[Array], apart: list[Array], one: Array, mantissa: Array,
           exponent: NDArray[np.int64]) -> list[Array]:
    """Terms of 4 a c mu^2 - (c - a)^2, freed of the common factor and of the power of two in mu: their sum is exact."""
    square = products(products([term * one * 4 for term in across], pole), two_product(mantissa, mantissa))
    return [*square, *(np.ldexp(-term, -2 * exponent) for term in products(apart, apart))]
