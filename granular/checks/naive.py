"""The obvious ways of computing, each with the flaw that makes it fail on some admissible input.

They are kept for showing what goes wrong, and how far: nothing else in this package calls them. Each is what a careful
reader of eqs (7) and (20)-(23) might write first, and each is right on ordinary inputs to many digits unless its
docstring says otherwise.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

from granular.checks import naive_spheroids
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.result import Six

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Naive = Callable[[AxialFabric, Loading | None, float, Hypothesis], Six]
"""Six components over (M/V) l_e^2 k_n,ref [-] from fabric, loading, Poisson's ratio and hypothesis."""


def gauss_64(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """Gauss-Legendre rule with 64 nodes in beta, not split where contacts begin to slide."""
    return _by_rule(fabric, loading, nu, hypothesis, *_gauss(64))


def midpoint_24(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """Midpoint rule with 24 panels in beta over [0, pi], as behind the printed tables: three digits at best."""
    import numpy as np

    beta = (np.arange(12) + 0.5) * math.pi / 24
    return _by_rule(fabric, loading, nu, hypothesis, beta, np.full(12, math.pi / 24))


def unguarded_cube_root(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """A real cube root that follows h below zero: contacts that slide get a negative shear stiffness."""
    import numpy as np

    return _by_rule(fabric, loading, nu, hypothesis, *_gauss(500), root=np.cbrt)


def power_one_third(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """``h ** (1/3)``, which is not a number where contacts slide or have opened."""
    import numpy as np

    with np.errstate(invalid="ignore"):
        return _by_rule(fabric, loading, nu, hypothesis, *_gauss(500), root=lambda h: np.power(h, 1 / 3))


def adaptive_without_breaks(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """``scipy.integrate.quad`` in beta as it comes: the kink where contacts begin to slide is not told to it."""
    import warnings

    import numpy as np
    from scipy.integrate import IntegrationWarning, quad

    def average(index: int, shear: bool) -> float:
        def integrand(beta: float) -> float:
            _, _, moments, normal, tangential = _contacts(fabric, loading, nu, hypothesis, np.array([beta]))
            return float((moments[index] * (tangential if shear else normal))[0])

        return float(quad(integrand, 0.0, math.pi / 2, epsabs=0.0, epsrel=1e-13)[0])

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", IntegrationWarning)
        normal, shear = ([average(i, tangential) for i in range(3)] for tangential in (False, True))
    return _assembled(fabric, hypothesis, normal, shear)


def one_minus_ratio(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """1 - lambda with lambda = k_r/k_n formed first, as eq. (7) is printed: nothing is left of it where lambda is 1."""
    beta, weights = _gauss(64)
    _, _, moments, normal, tangential = _contacts(fabric, loading, nu, hypothesis, beta)
    lam = tangential / normal
    one_less = [float((weights * moment * normal * (1 - lam)).sum()) for moment in moments]
    shear = [float((weights * moment * normal * lam).sum()) for moment in moments]
    return _from_parts(one_less, shear)


def difference_of_forces(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis) -> Six:
    """The force difference c - a from the rounded forces at pole and equator, in an otherwise careful formula.

    1 - (1 - q)^(1/3) is formed without cancellation, so that only c - a is left to blame.
    """
    import numpy as np

    if loading is None or loading.friction is None:
        return one_minus_ratio(fabric, loading, nu, hypothesis)
    beta, weights = _gauss(64)
    a, c = _rounded_forces(fabric, loading)
    sine, cosine = np.sin(beta), np.cos(beta)
    force = a * sine**2 + c * cosine**2
    used = abs(c - a) * sine * cosine / (loading.friction * force)
    kept = np.cbrt(np.maximum(1 - used, 0.0))
    lost = np.where(used < 1, used / (1 + kept + kept**2), 1.0)
    lam0 = 2 * (1 - nu) / (2 - nu)
    moments, normal = _contacts(fabric, loading, nu, hypothesis, beta)[2:4]
    one_less = [float((weights * moment * normal * (nu / (2 - nu) + lam0 * lost)).sum()) for moment in moments]
    return _from_parts(one_less, [float((weights * moment * normal * lam0 * kept).sum()) for moment in moments])


def powers_of_x(fabric: AxialFabric, loading: Loading | None, nu: float, _hypothesis: Hypothesis) -> Six:
    """Moments of 1, x^2, x^4, ... multiplied out, with s = 1 - x^2 by subtraction: terms cancel where E or W vanish.

    Kinematic, without slip; the moments of the cube root by Gauss's hypergeometric function.
    """
    from scipy.special import hyp2f1

    a, t = _scale_and_slope(fabric, loading)
    moments = [a ** (1 / 3) * float(hyp2f1(-1 / 3, k + 0.5, k + 1.5, -t)) / (2 * k + 1) for k in range(7)]
    return _from_monomials(fabric, moments, nu)


def forward_recurrence(fabric: AxialFabric, loading: Loading | None, nu: float, _hypothesis: Hypothesis) -> Six:
    """I_k = Int x^(2k) (1 + t x^2)^(1/3) dx upwards from I_0: each step divides by t, so that a small t spoils it.

    Kinematic, without slip.
    """
    from scipy.special import hyp2f1

    a, t = _scale_and_slope(fabric, loading)
    integrals = [float(hyp2f1(-1 / 3, 0.5, 1.5, -t))]
    for k in range(1, 7):
        step = (1 + t) ** (4 / 3) - (2 * k - 1) * integrals[-1]
        integrals.append(step / ((2 * k + 5 / 3) * t) if t else math.nan)
    return _from_monomials(fabric, [a ** (1 / 3) * integral for integral in integrals], nu)


def backward_recurrence(fabric: AxialFabric, loading: Loading | None, nu: float, _hypothesis: Hypothesis) -> Six:
    """The same recurrence downwards from I_6: each step multiplies by t, so that a large t spoils it."""
    from scipy.special import hyp2f1

    a, t = _scale_and_slope(fabric, loading)
    integrals = [float(hyp2f1(-1 / 3, 6.5, 7.5, -t)) / 13]
    for k in range(6, 0, -1):
        integrals.append(((1 + t) ** (4 / 3) - (2 * k + 5 / 3) * t * integrals[-1]) / (2 * k - 1))
    return _from_monomials(fabric, [a ** (1 / 3) * integral for integral in integrals[::-1]], nu)


def scale_in_the_printed_order(shear_modulus: float, poisson_ratio: float, mean_stress: float,
                               contacts_per_volume: float, branch_length: float) -> float:
    """(M/V) l_e^2 k_n,ref with G_s squared and p divided before the cube root is taken: they overflow or vanish.

    Parameters
    ----------
    shear_modulus : float
        G_s [Pa].
    poisson_ratio : float
        nu [-].
    mean_stress : float
        p [Pa].
    contacts_per_volume : float
        M/V [1/m^3].
    branch_length : float
        l_e [m].

    Returns
    -------
    float
        The unit of stiffness [Pa]; infinite or 0 where an intermediate product leaves the range of doubles.
    """
    try:
        cube = 3 * (shear_modulus / (1 - poisson_ratio)) ** 2 * (3 * mean_stress / (2 * contacts_per_volume))
        return float(contacts_per_volume * branch_length**2 * cube ** (1 / 3))
    except OverflowError:
        return math.inf


NAIVE: dict[str, Naive] = {
    "64 Gauss nodes, not split": gauss_64,
    "midpoint rule, 24 panels": midpoint_24,
    "cube root of a negative number": unguarded_cube_root,
    "power 1/3 of a negative number": power_one_third,
    "adaptive quadrature without break points": adaptive_without_breaks,
    "1 - k_r/k_n by subtraction": one_minus_ratio,
    "c - a by subtraction": difference_of_forces,
    "powers of x multiplied out": powers_of_x,
    "recurrence upwards": forward_recurrence,
    "recurrence downwards": backward_recurrence,
    "arc tangent and recurrence": naive_spheroids.arc_tangent,
    "24 Gauss nodes in x": naive_spheroids.gauss_24,
}
"""Each naive way by what is naive about it."""


@lru_cache(maxsize=4)
def _gauss(nodes: int) -> tuple[Array, Array]:
    import numpy as np

    points, weights = np.polynomial.legendre.leggauss(nodes)
    return (points + 1) * math.pi / 4, weights * math.pi / 4


def _guarded(h: Array) -> Array:
    import numpy as np

    result: Array = np.cbrt(np.maximum(h, 0.0))
    return result


def _rounded_forces(fabric: AxialFabric, loading: Loading) -> tuple[float, float]:
    ratio = float(loading.sigma33 / loading.sigma11) if loading.sigma11 else math.inf
    mean = (2 + ratio) / 3
    return 1 / (mean * 3 * (1 / 3 - fabric.D33 / 15)), ratio / (mean * 3 * (1 / 3 + 2 * fabric.D33 / 15))


def _scale_and_slope(fabric: AxialFabric, loading: Loading | None) -> tuple[float, float]:
    if loading is None:
        return 1.0, 0.0
    a, c = _rounded_forces(fabric, loading)
    return a, c / a - 1


def _contacts(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis, beta: Array,
              root: Callable[[Array], Array] = _guarded) -> tuple[Array, Array, list[Array], Array, Array]:
    """Cosine, sine, three weights without stiffness, and the stiffnesses (kinematic) or their inverses (static)."""
    import numpy as np

    x, sine = np.cos(beta), np.sin(beta)
    x2, s = x * x, 1 - x * x
    second, fourth = (3 * x2 - 1) / 2, (35 * x2**2 - 30 * x2 + 3) / 8
    density, length = 1 + fabric.D33 * second + fabric.D3333 * fourth, 1 + fabric.Dr33 * second
    lam0 = 2 * (1 - nu) / (2 - nu)
    normal, tangential = np.ones_like(x), np.full_like(x, lam0)
    if loading is not None:
        a, c = _rounded_forces(fabric, loading)
        force = a * s + c * x2
        normal = root(force)
        if loading.friction is None:
            tangential = lam0 * normal
        else:
            with np.errstate(divide="ignore", invalid="ignore"):
                tangential = lam0 * root(force - abs(c - a) * x * sine / np.float64(loading.friction))
    branch = density * sine * (length**2 if hypothesis is Hypothesis.KINEMATIC else 1 / length**2)
    if hypothesis is Hypothesis.STATIC:
        with np.errstate(divide="ignore"):
            normal, tangential = 1 / normal, 1 / tangential
    return x, sine, [branch * s * s, branch * s * x2, branch * x2 * x2], normal, tangential


def _by_rule(fabric: AxialFabric, loading: Loading | None, nu: float, hypothesis: Hypothesis, beta: Array,
             weights: Array, root: Callable[[Array], Array] = _guarded) -> Six:
    _, _, moments, normal, tangential = _contacts(fabric, loading, nu, hypothesis, beta, root)
    return _assembled(fabric, hypothesis, [float((weights * moment * normal).sum()) for moment in moments],
                      [float((weights * moment * tangential).sum()) for moment in moments])


def _assembled(fabric: AxialFabric, hypothesis: Hypothesis, normal: list[float], shear: list[float]) -> Six:
    one_less = [n - r for n, r in zip(normal, shear, strict=True)]
    if hypothesis is Hypothesis.KINEMATIC:
        return _from_parts(one_less, shear)
    import numpy as np

    a1, a3 = 1 / (1 / 3 - fabric.D33 / 15), 1 / (1 / 3 + 2 * fabric.D33 / 15)
    n2, x2 = shear[0] + shear[1], shear[1] + shear[2]
    s11, s33 = a1**2 * (3 * one_less[0] / 8 + n2 / 2), a3**2 * (one_less[2] + x2)
    s12, s13 = a1**2 * one_less[0] / 8, a1 * a3 * one_less[1] / 2
    s2323 = (a1**2 * (one_less[1] + n2) / 2 + a1 * a3 * one_less[1] + a3**2 * (one_less[1] / 2 + x2)) / 4
    stiff = np.linalg.inv(np.array([[s11, s12, s13], [s12, s11, s13], [s13, s13, s33]]))
    return (float(stiff[0, 0]), float(stiff[2, 2]), float(stiff[0, 1]), float(stiff[0, 2]),
            1 / (4 * s2323), 1 / (2 * (s11 - s12)))


def _from_parts(one_less: list[float], shear: list[float]) -> Six:
    """Eq. (7) from <E W^2 (k_n - k_r)> and <E W^2 k_r> with s^2, s x^2 and x^4."""
    n4, mixed, x4 = one_less
    n2, x2 = shear[0] + shear[1], shear[1] + shear[2]
    return (3 * n4 / 8 + n2 / 2, x4 + x2, n4 / 8, mixed / 2, mixed / 2 + (x2 + n2 / 2) / 4, n4 / 8 + n2 / 4)


def _from_monomials(fabric: AxialFabric, moments: list[float], nu: float) -> Six:
    """Eq. (7) with E and W in powers of x, and moments of k_n with x^(2k), k = 0, ..., 6."""
    import numpy as np

    d, q, dr = fabric.D33, fabric.D3333, fabric.Dr33
    density = np.array([1 - d / 2 + 3 * q / 8, 3 * d / 2 - 30 * q / 8, 35 * q / 8])
    length = np.array([1 - dr / 2, 3 * dr / 2])
    product = np.convolve(density, np.convolve(length, length))
    m0, m1, m2 = (float(product @ np.array(moments[k:k + 5])) for k in range(3))
    lam = 2 * (1 - nu) / (2 - nu)
    weights = (m0 - 2 * m1 + m2, m1 - m2, m2)
    return _from_parts([(1 - lam) * weight for weight in weights], [lam * weight for weight in weights])
