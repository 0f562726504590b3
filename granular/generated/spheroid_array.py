"""Stiffness of aligned spheroids: functions of arrays.

Emitted by ``derivations write`` from the derivation ``spheroid``; do not edit.
Source: (5), (6), (24), (28), Figure 1(b) of Pan & Dong (1999).
Domain: aspect_ratio > 0; the emitted series: 1/3 <= aspect_ratio <= 3; E nowhere negative; 0 <= nu <= 1/2; free spin: k_r > 0 in some directions; flexibilities: k_r > 0 in every direction.
Operations: 548 (100 in the outputs as derived, moments counted apart).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from .spheroid import SERIES_0, SERIES_1, SERIES_2, SERIES_3, SERIES_4

Array: TypeAlias = npt.NDArray[np.float64]


def polynomial(coefficients: tuple[float, ...], v: Array) -> Array:
    """Evaluate a polynomial by Horner's rule for every element at once, coefficients in rising order."""
    total = np.zeros_like(v)
    for coefficient in reversed(coefficients):
        total *= v
        total += coefficient
    return total


def stiffness_from_moments(
    p0: Array, p1: Array, p2: Array, varrho: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six components over (M/V) (2a)^2 k_n from the moments of E/Q for contacts of equal stiffness.

    Grains turn with the mean deformation.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    varrho : (...) array [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 49.
    """
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    C1111 = lam*p0/8 + lam*p1/2 + 3*p0/8
    C3333 = varrho*varrho*(lam*p1 + p2)
    C1122 = one_minus_lam*p0/8
    C1133 = one_minus_lam*p1*varrho/2
    C2323 = lam*p0/8 + lam*p1/8 + one_minus_lam*p1*(varrho + 1)**2/8 + varrho*varrho*(lam*p1 + lam*p2)/4
    C1212 = lam*p0/4 + lam*p1/4 + one_minus_lam*p0/8
    return C1111, C3333, C1122, C1133, C2323, C1212


def stiffness_from_weights(
    p0: Array, p1: Array, p2: Array, q0: Array, q1: Array, q2: Array, d0: Array, d1: Array, varrho: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six components over (M/V) (2a)^2 k_n,ref from moments of E k_n/Q, E k_r/Q and E (k_n - k_r)/Q.

    All contact stiffnesses over k_n,ref. Grains turn with the mean deformation.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    q0 : (...) array [-]
        Moment of the tangential stiffness with the fourth power of the sine.
    q1 : (...) array [-]
        Moment of the tangential stiffness with squared sine and squared cosine.
    q2 : (...) array [-]
        Moment of the tangential stiffness with the fourth power of the cosine.
    d0 : (...) array [-]
        Normal less tangential stiffness, moment with the fourth power of the sine.
    d1 : (...) array [-]
        Normal less tangential stiffness, moment with squared sine and squared cosine.
    varrho : (...) array [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 30.
    """
    C1111 = 3*p0/8 + q0/8 + q1/2
    C3333 = varrho*varrho*(p2 + q1)
    C1122 = d0/8
    C1133 = d1*varrho/2
    C2323 = d1*(varrho + 1)**2/8 + q0/8 + q1/8 + varrho*varrho*(q1 + q2)/4
    C1212 = d0/8 + q0/4 + q1/4
    return C1111, C3333, C1122, C1133, C2323, C1212


def relaxed_shear(q0: Array, q1: Array, q2: Array, d1: Array, varrho: Array) -> tuple[Array]:
    """Vertical shear component over (M/V) (2a)^2 k_n,ref when grains are free to spin.

    The other five components are those of grains that do not spin. Some contacts must have k_r > 0.

    Parameters
    ----------
    q0 : (...) array [-]
        Moment of the tangential stiffness with the fourth power of the sine.
    q1 : (...) array [-]
        Moment of the tangential stiffness with squared sine and squared cosine.
    q2 : (...) array [-]
        Moment of the tangential stiffness with the fourth power of the cosine.
    d1 : (...) array [-]
        Normal less tangential stiffness, moment with squared sine and squared cosine.
    varrho : (...) array [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.

    Returns
    -------
    relaxed_C2323 : (...) array [-]
        Stiffness component 2323 when grains are free to spin.

    Operations: 19.
    """
    difference = 1 - varrho
    equator = q0/2 + q1/2
    pole = q1 + q2
    half = d1/2
    relaxed_C2323 = varrho*varrho*(equator*pole + half*(equator + pole))/((difference*difference*half + equator + pole*varrho*varrho))
    return relaxed_C2323,


def stiffness_from_flexibilities(
    u0: Array, u1: Array, u2: Array, v0: Array, v1: Array, v2: Array, g0: Array, g1: Array, N11: Array, N33: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six components over (M/V) (2a)^2 k_n,ref by the static hypothesis, with l in units of 2a.

    Moments of E l^-2/k_n, E l^-2/k_r and their difference, all contact flexibilities times k_n,ref; N11 and
    N33 are means of the branch direction times the contact normal.

    Parameters
    ----------
    u0 : (...) array [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : (...) array [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : (...) array [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    v0 : (...) array [-]
        Moment of the tangential flexibility with the fourth power of the sine.
    v1 : (...) array [-]
        Moment of the tangential flexibility with squared sine and squared cosine.
    v2 : (...) array [-]
        Moment of the tangential flexibility with the fourth power of the cosine.
    g0 : (...) array [-]
        Tangential less normal flexibility, moment with the fourth power of the sine.
    g1 : (...) array [-]
        Tangential less normal flexibility, moment with squared sine and cosine.
    N11 : (...) array [-]
        Horizontal component of the fabric tensor.
    N33 : (...) array [-]
        Vertical component of the fabric tensor.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 46.
    """
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    C1212 = 2*N11*N11/shear_sum
    C1122 = N11*N11*(g0*(u2 + v1) + 2*g1*g1)/(delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C3333 = N33*N33*(u0 + v1)/delta
    C1133 = N11*N33*g1/delta
    C2323 = 1/((u1 + v1 + 2*v2)/(2*N33*N33) - g1/(N11*N33) + (u1 + v0)/(2*N11*N11))
    return C1111, C3333, C1122, C1133, C2323, C1212


def spheroid_moments(D33: Array, D3333: Array, aspect_ratio: Array) -> tuple[Array, Array, Array]:
    """Moments <E s^2/Q>, <E s x^2/Q>, <E x^4/Q> with Q = s + r^2 x^2, r the aspect ratio.

    The series hold for 1/3 <= aspect_ratio <= 3.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    aspect_ratio : (...) array [-]
        Semi-axis of a spheroid along axis 3 over the one across.

    Returns
    -------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 404.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    mean_axis = (aspect_ratio + 1)/2
    v = (aspect_ratio - 1)/(aspect_ratio + 1)
    h0 = polynomial(SERIES_0, v)/mean_axis
    h1 = polynomial(SERIES_1, v)/mean_axis
    h2 = polynomial(SERIES_2, v)/(mean_axis*mean_axis)
    h3 = polynomial(SERIES_3, v)/(mean_axis*mean_axis)
    h4 = polynomial(SERIES_4, v)/(aspect_ratio*mean_axis)
    p0 = e0*h0 + e1*h1 + e2*h2
    p1 = e0*h1 + e1*h2 + e2*h3
    p2 = e0*h2 + e1*h3 + e2*h4
    return p0, p1, p2
