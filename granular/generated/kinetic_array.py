"""Moments of the kinetic fabric without slip: functions of arrays.

Emitted by ``derivations write`` from the derivation ``kinetic``; do not edit.
Source: (7), (20), (25), (26) of Pan & Dong (1999).
Domain: a, c > 0; E nowhere negative; -1 < Dr33 < 2; static: Dr33 = 0; the emitted series: 1/9 <= c/a <= 9.
Operations: 1054 (580 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from numpy import cbrt, sqrt

from .kinetic import SERIES_0, SERIES_1, SERIES_2, SERIES_3, SERIES_4, SERIES_5, SERIES_6, INVERSE_0, INVERSE_1, INVERSE_2, INVERSE_3, INVERSE_4

Array: TypeAlias = npt.NDArray[np.float64]


def polynomial(coefficients: tuple[float, ...], v: Array) -> Array:
    """Evaluate a polynomial by Horner's rule for every element at once, coefficients in rising order."""
    total = np.zeros_like(v)
    for coefficient in reversed(coefficients):
        total *= v
        total += coefficient
    return total


def kinetic_moments(
    D33: Array, D3333: Array, Dr33: Array, a: Array, c: Array, d: Array,
) -> tuple[Array, Array, Array]:
    """Moments <E W^2 k_n s^2>, <E W^2 k_n s x^2>, <E W^2 k_n x^4> over k_n,ref, no contact slipping.

    The series hold for 1/9 <= c/a <= 9. The difference d = c - a is an argument of its own, so that nothing
    is lost when a and c are close.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
    a : (...) array [-]
        Normal contact force at the equator, 1 when all is isotropic.
    c : (...) array [-]
        Normal contact force at the pole, 1 when all is isotropic.
    d : (...) array [-]
        Normal contact force at the pole less that at the equator.

    Returns
    -------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 583.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    w0 = (2 - Dr33)/2
    w1 = Dr33 + 1
    omega0 = e0*w0*w0
    omega1 = w0*(2*e0*w1 + e1*w0)
    omega2 = e0*w1*w1 + 2*e1*w0*w1 + e2*w0*w0
    omega3 = w1*(e1*w1 + 2*e2*w0)
    omega4 = e2*w1*w1
    sum0 = 15360*omega0 + 1280*omega1 + 384*omega2 + 240*omega3 + 280*omega4
    sum1 = 1280*omega0 + 384*omega1 + 240*omega2 + 280*omega3 + 630*omega4
    sum2 = 384*omega0 + 240*omega1 + 280*omega2 + 630*omega3 + 3465*omega4
    constant0 = sum0/45045
    constant1 = sum1/45045
    constant2 = sum2/45045
    both = a*c
    square = a + 2*sqrt(both) + c
    eta = d/square
    mean_square = square/4
    first = cbrt(mean_square)
    correction = -first + mean_square/(first*first)
    root = correction/3 + first
    f0 = polynomial(SERIES_0, eta)
    f1 = polynomial(SERIES_1, eta)
    f2 = polynomial(SERIES_2, eta)
    f3 = polynomial(SERIES_3, eta)
    f4 = polynomial(SERIES_4, eta)
    f5 = polynomial(SERIES_5, eta)
    f6 = polynomial(SERIES_6, eta)
    p0 = root*(constant0 + eta*(f0*omega0 + f1*omega1 + f2*omega2 + f3*omega3 + f4*omega4))
    p1 = root*(constant1 + eta*(f1*omega0 + f2*omega1 + f3*omega2 + f4*omega3 + f5*omega4))
    p2 = root*(constant2 + eta*(f2*omega0 + f3*omega1 + f4*omega2 + f5*omega3 + f6*omega4))
    return p0, p1, p2


def kinetic_static_moments(
    D33: Array, D3333: Array, a: Array, c: Array, d: Array,
) -> tuple[Array, Array, Array]:
    """Moments <E s^2/k_n>, <E s x^2/k_n>, <E x^4/k_n> times k_n,ref, no contact slipping, Dr33 = 0.

    The series hold for 1/9 <= c/a <= 9. The difference d = c - a is an argument of its own, so that nothing
    is lost when a and c are close.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    a : (...) array [-]
        Normal contact force at the equator, 1 when all is isotropic.
    c : (...) array [-]
        Normal contact force at the pole, 1 when all is isotropic.
    d : (...) array [-]
        Normal contact force at the pole less that at the equator.

    Returns
    -------
    u0 : (...) array [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : (...) array [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : (...) array [-]
        Moment of the normal flexibility with the fourth power of the cosine.

    Operations: 471.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    constant0 = (128*e0 + 16*e1 + 8*e2)/315
    constant1 = (16*e0 + 8*e1 + 10*e2)/315
    constant2 = (8*e0 + 10*e1 + 35*e2)/315
    both = a*c
    square = a + 2*sqrt(both) + c
    eta = d/square
    mean_square = square/4
    first = cbrt(mean_square)
    correction = -first + mean_square/(first*first)
    root = correction/3 + first
    f0 = polynomial(INVERSE_0, eta)
    f1 = polynomial(INVERSE_1, eta)
    f2 = polynomial(INVERSE_2, eta)
    f3 = polynomial(INVERSE_3, eta)
    f4 = polynomial(INVERSE_4, eta)
    u0 = (constant0 + eta*(e0*f0 + e1*f1 + e2*f2))/root
    u1 = (constant1 + eta*(e0*f1 + e1*f2 + e2*f3))/root
    u2 = (constant2 + eta*(e0*f2 + e1*f3 + e2*f4))/root
    return u0, u1, u2
