"""Gradation and branch lengths: scalar functions.

Emitted by ``derivations write`` from the derivation ``gradation``; do not edit.
Source: (8), (9), (10), (11), (12), (13), (14), (15), (16), (17), (18), (19) of Pan & Dong (1999).
Domain: L = ln^2 s_r >= 0; sizes > 0.
Operations: 36 (90 in the outputs as derived).
"""

from __future__ import annotations

from math import exp, expm1, log1p


def printed_lognormal_moment(r50: float, log_variance: float, order: float) -> tuple[float]:
    """Mean of a size to a power under the density of eq. (18), without 1/r.

    Parameters
    ----------
    r50 : float [m]
        Size at which the density of eq. (18) is largest, its mode.
    log_variance : float [-]
        Variance of the logarithm of the grain size, the squared log of s_r.
    order : float [-]
        Order of a moment.

    Returns
    -------
    printed_moment : float [m^order]

    Operations: 7.
    """
    printed_moment = r50**order*exp(log_variance*order*(order + 2)/2)
    return printed_moment,


def classical_lognormal_moment(median: float, log_variance: float, order: float) -> tuple[float]:
    """Mean of a size to a power under the classical lognormal density.

    Parameters
    ----------
    median : float [m]
        Median of a lognormal density in its classical form.
    log_variance : float [-]
        Variance of the logarithm of the grain size, the squared log of s_r.
    order : float [-]
        Order of a moment.

    Returns
    -------
    classical_moment : float [m^order]

    Operations: 6.
    """
    classical_moment = median**order*exp(log_variance*order*order/2)
    return classical_moment,


def branch_parameters(log_variance: float) -> tuple[float, float]:
    """Parameters of eq. (19) from the log variance of the grain sizes.

    The mode of the branch length is mode_ratio times the mode of the radius in eq. (18).

    Parameters
    ----------
    log_variance : float [-]
        Variance of the logarithm of the grain size, the squared log of s_r.

    Returns
    -------
    branch_log_variance : float [-]
        Variance of the logarithm of the branch length, eq. (19).
    mode_ratio : float [-]
        Modes of branch length and grain radius, eqs (19) and (18).

    Operations: 11.
    """
    total_log_variance = log1p(expm1(log_variance)/2)
    branch_log_variance = 3*total_log_variance
    mode_ratio = 2*exp(-3*log_variance/2 - 3*total_log_variance/2)
    return branch_log_variance, mode_ratio


def gradation_factor(log_variance: float) -> tuple[float, float]:
    """Factors of the stiffness by gradation with eq. (19), 1 for equal spheres.

    Void ratio, coordination number and mean stress are those of the equal spheres.

    Parameters
    ----------
    log_variance : float [-]
        Variance of the logarithm of the grain size, the squared log of s_r.

    Returns
    -------
    kinematic_factor : float [-]
        Gradation in the kinematic stiffness by eq. (19), 1 for equal spheres.
    static_factor : float [-]
        Gradation in the static stiffness by eq. (19), 1 for equal spheres.

    Operations: 12.
    """
    total_log_variance = log1p(expm1(log_variance)/2)
    kinematic_factor = exp(-2*log_variance + 9*total_log_variance)
    static_factor = exp(-2*log_variance - 3*total_log_variance)
    return kinematic_factor, static_factor
