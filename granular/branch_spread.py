"""The kinematic stiffness of lognormal branch lengths whose spread has a fabric of its own: Kummer functions.

With ln^2 s_l = L_e (1 + D_s P2) in eq. (19) the mean square of the lengths along a direction is l_50^2 exp(f L_e (1 +
D_s P2)), f = 4 in the form of the paper and 2 in the classical one. The spread is no factor any more: it enters the
averages over the directions, as exp(zeta x^2), and those are closed all the same.
"""

from __future__ import annotations

import math

from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio
from granular.errors import BranchesUnusable
from granular.fabric import AxialFabric
from granular.fields import Number, chosen
from granular.generated.kinetic_components import stiffness_from_weights
from granular.gradation.lognormal import SPREAD
from granular.routes.result import Six

EXPONENTS = {"paper": 4.0, "classical": 2.0}
"""How the log variance enters the mean square, f, by the form of the density [-]."""

NEGLIGIBLE = 2.0**-56
"""Share of a sum below which its terms are left out once they fall [-]."""

_ANISOTROPY = Number(at_least=-1.0, at_most=2.0, why="the log variance must not be negative in any direction",
                     remedy="Give a coefficient inside the interval.")
_POISSON = Number(at_least=0.0, at_most=0.5)


def exponential_moments(zeta: float, count_of: int) -> tuple[float, ...]:
    """Moments of exp(zeta x^2) over the directions, by Kummer functions.

    Parameters
    ----------
    zeta : float
        Exponent at the pole [-], any sign.
    count_of : int
        How many [-].

    Returns
    -------
    tuple of float
        J_k = Int_0^1 x^(2k) exp(zeta x^2) dx = M(k + 1/2, k + 3/2, zeta)/(2k + 1) for k = 0, 1, ... [-].

    Notes
    -----
    Accuracy: a few units of the last place; all terms are positive, for either sign. Source: ``derivations.gradation``.

    Examples
    --------
    >>> [round(moment, 6) for moment in exponential_moments(0.0, 3)]
    [1.0, 0.333333, 0.2]
    >>> round(exponential_moments(-1.0, 1)[0], 12) == round(math.sqrt(math.pi)/2*math.erf(1.0), 12)
    True
    """
    return tuple(_rising(zeta, k) if zeta >= 0.0 else math.exp(zeta) * _falling(-zeta, k) for k in range(count_of))


def stiffness_with_spread(spread: float, anisotropy: float, *, poisson_ratio: float, fabric: AxialFabric | None = None,
                          form: str = "paper") -> Six:
    """Stiffness of contacts of equal stiffness with branch lengths whose median and spread change with direction.

    Parameters
    ----------
    spread : float
        s_l where P2 = 0 [-], 1 < spread <= 10; L_e = ln^2 s_l there.
    anisotropy : float
        D_s of the log variance L_e (1 + D_s P2) [-], -1 to 2.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    fabric : AxialFabric, optional
        Contact normals, and the median branch length as W = 1 + Dr33 P2; all isotropic by default.
    form : str
        "paper" for the density of eq. (19), which has no 1/l, or "classical" with it.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_50^2 k_n [-], with the median l_50 where P2 = 0.

    Raises
    ------
    ValueOutOfRange, UnknownChoice
        A number outside its interval, or another form.
    BranchesUnusable
        A fabric of spheroids, whose branches have lengths of their own.

    Notes
    -----
    Accuracy: 1e-14 for contact normals of rank two and branches of one median; where W or the density of normals come
    near zero, as much more as their polynomials cancel. Source: eqs (7), (14), (19), ``derivations.gradation``.

    Examples
    --------
    >>> six = stiffness_with_spread(1.5, 0.5, poisson_ratio=0.21)
    >>> round(six[1] / six[0], 4)
    1.2287
    """
    log_variance = math.log(SPREAD.read(spread, "spread")) ** 2
    kappa = EXPONENTS[chosen(form, tuple(EXPONENTS), name="form")] * log_variance
    axial = AxialFabric() if fabric is None else fabric
    if axial.aspect_ratio != 1.0:
        raise BranchesUnusable(f"spread of lengths with aspect_ratio = {axial.aspect_ratio!r}",
                               allowed="allowed only spheres, or grains that W describes",
                               remedy="Leave the aspect ratio out and give Dr33.")
    weight = _weight(axial)
    kappa_s = kappa * _ANISOTROPY.read(anisotropy, "anisotropy")
    nu = _POISSON.read(poisson_ratio, "poisson_ratio")
    scale = math.exp(kappa - kappa_s / 2.0)
    moments = exponential_moments(1.5 * kappa_s, len(weight) + 2)
    # <w>, <w x^2>, <w x^4>, and from them those with the squared sine
    m = [scale * math.fsum(c * moments[j + k] for j, c in enumerate(weight)) for k in range(3)]
    p0, p1, p2 = m[0] - 2.0 * m[1] + m[2], m[1] - m[2], m[2]
    shear, apart = stiffness_ratio(nu), one_minus_stiffness_ratio(nu)
    return stiffness_from_weights(p0, p1, p2, shear * p0, shear * p1, shear * p2, apart * p0, apart * p1)


def _rising(zeta: float, k: int) -> float:
    """Sum zeta^j/(j! (2k + 1 + 2j)), for zeta >= 0."""
    j, power, term, total = 0, 1.0, 1.0 / (2 * k + 1), 0.0
    while j <= zeta or term > NEGLIGIBLE * total:
        total += term
        j += 1
        power *= zeta / j
        term = power / (2 * k + 1 + 2 * j)
    return total


def _falling(zeta: float, k: int) -> float:
    """Sum (2 zeta)^j/((2k + 1) (2k + 3) ... (2k + 1 + 2j)), for zeta >= 0."""
    j, term, total = 0, 1.0 / (2 * k + 1), 0.0
    while j <= zeta or term > NEGLIGIBLE * total:
        total += term
        j += 1
        term *= 2.0 * zeta / (2 * k + 1 + 2 * j)
    return total


def _weight(fabric: AxialFabric) -> list[float]:
    """4 pi E W^2 as a polynomial in x^2, lowest power first."""
    P2, P4 = (-0.5, 1.5, 0.0), (0.375, -3.75, 4.375)
    density = [float(i == 0) + fabric.D33 * a + fabric.D3333 * b for i, (a, b) in enumerate(zip(P2, P4, strict=True))]
    median = [float(i == 0) + fabric.Dr33 * a for i, a in enumerate(P2[:2])]
    return _product(density, _product(median, median))


def _product(first: list[float], second: list[float]) -> list[float]:
    found = [0.0] * (len(first) + len(second) - 1)
    for i, a in enumerate(first):
        for j, b in enumerate(second):
            found[i + j] += a * b
    return found
