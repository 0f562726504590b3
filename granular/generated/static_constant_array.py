"""Stiffness with constant contact stiffness, static hypothesis: functions of arrays.

Emitted by ``derivations write`` from the derivation ``static_constant``; do not edit.
Source: (2), (23), (24), Figure 1(b) of Pan & Dong (1999).
Domain: E nowhere negative; -1 < Dr33 < 2; the emitted series: 1/9 <= w1/w0 <= 9; 0 <= nu <= 1/2.
Operations: 596 (340 in the outputs as derived, moments counted apart).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from numpy import sqrt

from .static_constant import SERIES_0, SERIES_1, SERIES_2, SERIES_3, SERIES_4

Array: TypeAlias = npt.NDArray[np.float64]


def polynomial(coefficients: tuple[float, ...], v: Array) -> Array:
    """Evaluate a polynomial by Horner's rule for every element at once, coefficients in rising order."""
    total = np.zeros_like(v)
    for coefficient in reversed(coefficients):
        total *= v
        total += coefficient
    return total


def static_moments(D33: Array, D3333: Array, Dr33: Array) -> tuple[Array, Array, Array]:
    """Moments <E W^-2 s^2>, <E W^-2 s x^2>, <E W^-2 x^4> of the static weight.

    The series hold for 1/9 <= w1/w0 <= 9, that is -16/19 <= Dr33 <= 16/11.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.

    Returns
    -------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 459.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    w0 = (2 - Dr33)/2
    w1 = Dr33 + 1
    geometric_mean = sqrt(w0)*sqrt(w1)
    square = Dr33/2 + 2*geometric_mean + 2
    v = 3*Dr33/(2*square)
    h0 = 2*polynomial(SERIES_0, v)/(w0*(geometric_mean + w0))
    h1 = 4*polynomial(SERIES_1, v)/(square*w0)
    h2 = 16*polynomial(SERIES_2, v)/(square*square)
    h3 = 8*polynomial(SERIES_3, v)/(square*(geometric_mean + w1))
    h4 = 4*polynomial(SERIES_4, v)/(square*w1)
    p0 = e0*h0 + e1*h1 + e2*h2
    p1 = e0*h1 + e1*h2 + e2*h3
    p2 = e0*h2 + e1*h3 + e2*h4
    return p0, p1, p2


def stiffness_from_moments(
    p0: Array, p1: Array, p2: Array, D33: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six stiffness components over (M/V) l_e^2 k_n from the positive moments of E/W^2.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
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

    Operations: 73.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    delta = lam*p0*p2 + one_minus_lam*p1*p1 + p1*(p0 + p1 + p2)
    shear_sum = p0*(lam + 1) + 2*p1
    eight_S2323 = (lam*p1 + p1 + 2*p2)/(fifteen_N33*fifteen_N33) - 2*one_minus_lam*p1/(fifteen_N11*fifteen_N33) + (lam*p1 + p0)/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11*lam/(225*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*one_minus_lam*(lam*p0*(p1 + p2) + one_minus_lam*p1*(p0 + 2*p1))/(225*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C3333 = fifteen_N33*fifteen_N33*(lam*p0 + p1)/(225*delta)
    C1133 = fifteen_N11*fifteen_N33*one_minus_lam*p1/(225*delta)
    C2323 = 2*lam/(225*eight_S2323)
    return C1111, C3333, C1122, C1133, C2323, C1212


def compliance_from_moments(
    p0: Array, p1: Array, p2: Array, D33: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six compliance components times (M/V) l_e^2 k_n from the positive moments of E/W^2.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    S1111 : (...) array [-]
        Compliance component 1111.
    S3333 : (...) array [-]
        Compliance component 3333.
    S1122 : (...) array [-]
        Compliance component 1122.
    S1133 : (...) array [-]
        Compliance component 1133.
    S2323 : (...) array [-]
        Compliance component 2323.
    S1212 : (...) array [-]
        Compliance component 1212.

    Operations: 64.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    A11 = 15/fifteen_N11
    A33 = 15/fifteen_N33
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    S1111 = A11*A11*(3*p0/8 + (p0/8 + p1/2)/lam)
    S3333 = A33*A33*(p2 + p1/lam)
    S1122 = -A11*A11*one_minus_lam*p0/(8*lam)
    S1133 = -A11*A33*one_minus_lam*p1/(2*lam)
    S2323 = A11*A11*(p1 + p0/lam)/8 - A11*A33*one_minus_lam*p1/(4*lam) + A33*A33*(p1 + (p1 + 2*p2)/lam)/8
    S1212 = A11*A11*(p0/4 + (p0/4 + p1/2)/lam)/2
    return S1111, S3333, S1122, S1133, S2323, S1212


def static_constant(
    D33: Array, D3333: Array, Dr33: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Stiffness with constant contact stiffness, static hypothesis, from the fabric to the components.

    The series hold for 1/9 <= w1/w0 <= 9, that is -16/19 <= Dr33 <= 16/11.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
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

    Operations: 532.
    """
    p0, p1, p2 = static_moments(D33, D3333, Dr33)
    return stiffness_from_moments(p0, p1, p2, D33, nu)
