"""What the collinear assumption costs: aligned spheroids with their branches laid along the contact normals.

Eq. (7) follows from eq. (6) where branch and normal have one direction. For aligned spheroids both are known, so that
the two can be compared. A branch that is laid along its normal must be given a length; three choices are usual.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from granular.errors import UnknownChoice
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.routes.result import Six

ASSUMPTIONS = {
    "length": "the true length |l|",
    "weight": "the weight W of Figure 5 with the true ratio of pole to equator",
    "projection": "the part 2|M n| of the branch that lies along the normal",
}
"""What is taken for the length of a branch along its normal."""


class Ratios(NamedTuple):
    """The two measures of anisotropy, or something of each of them."""

    compression: float
    """Of C1111/C3333 [-]."""
    shear: float
    """Of C2323/C1212 [-]."""


def true_ratios(aspect_ratio: float, *, D33: float = 0.0, poisson_ratio: float = 0.21, free_spin: bool = False,
                hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Ratios:
    """Anisotropy of aligned spheroids with their own branch vectors.

    Parameters
    ----------
    aspect_ratio : float
        b/a with b along axis 3 [-], inside (1e-12, 1e12).
    D33 : float
        P2 coefficient of the contact-normal density [-], -1 to 2.
    poisson_ratio : float
        Of the grain material [-], 0 to 0.5.
    free_spin : bool
        Each grain spins until it carries no net couple; otherwise grains turn with the mean deformation.
    hypothesis : Hypothesis
        Kinematic or static; under the static one no spin enters.

    Returns
    -------
    Ratios
        C1111/C3333 and C2323/C1212 for contacts of one stiffness [-].

    Raises
    ------
    FabricOutOfRange
        No such shape or density.

    Notes
    -----
    Accuracy: 1e-14. Source: eq. (6), and Figure 1(b), with l = 2 M^2 n/\\|M n\\|.

    Examples
    --------
    >>> [round(ratio, 4) for ratio in true_ratios(0.9)]
    [1.3983, 0.8572]
    """
    from granular.routes import axial

    fabric = AxialFabric(D33=D33, aspect_ratio=aspect_ratio,
                         free_spin=free_spin and hypothesis is Hypothesis.KINEMATIC)
    return _ratios(axial.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis).components)


def collinear_ratios(assumption: str, aspect_ratio: float, *, D33: float = 0.0, poisson_ratio: float = 0.21) -> Ratios:
    """Anisotropy of the same spheroids with their branches laid along the contact normals.

    Parameters
    ----------
    assumption : str
        "length", "weight" or "projection": what is taken for the length of a branch.
    aspect_ratio : float
        b/a with b along axis 3 [-], inside (1e-12, 1e12).
    D33 : float
        P2 coefficient of the contact-normal density [-], -1 to 2.
    poisson_ratio : float
        Of the grain material [-], 0 to 0.5.

    Returns
    -------
    Ratios
        C1111/C3333 and C2323/C1212 for contacts of one stiffness, kinematic [-].

    Raises
    ------
    UnknownChoice
        Another assumption.
    FabricOutOfRange
        No such shape or density.

    Notes
    -----
    Accuracy: 1e-14. Source: eq. (7), averaged by the rule that serves the spheroids.

    Examples
    --------
    >>> [round(ratio, 4) for ratio in collinear_ratios("weight", 0.9)]
    [1.0895, 0.9593]
    """
    if assumption not in ASSUMPTIONS:
        raise UnknownChoice(f"assumption = {assumption!r}", allowed=f"allowed {', '.join(ASSUMPTIONS)}",
                            remedy="Write one of these words.")
    from granular.generated.kinematic_constant import stiffness_from_moments

    moments = _moments(assumption, AxialFabric(D33=D33, aspect_ratio=aspect_ratio))
    return _ratios(stiffness_from_moments(*moments, poisson_ratio))


def collinear_error(assumption: str, aspect_ratio: float, *, D33: float = 0.0, poisson_ratio: float = 0.21) -> Ratios:
    """Error that the collinear assumption makes in the anisotropy of aligned spheroids.

    Parameters
    ----------
    assumption, aspect_ratio, D33, poisson_ratio
        As for :func:`collinear_ratios`.

    Returns
    -------
    Ratios
        Of C1111/C3333 and of C2323/C1212, relative to the true ratio [%].

    Raises
    ------
    UnknownChoice, FabricOutOfRange
        As there.

    Notes
    -----
    Accuracy: 1e-12 %, or 1e-14 of the error where that is larger. Source: eq. (7) against eq. (6).

    Examples
    --------
    >>> [round(percent, 1) for percent in collinear_error("weight", 0.9)]
    [-22.1, 11.9]
    """
    assumed = collinear_ratios(assumption, aspect_ratio, D33=D33, poisson_ratio=poisson_ratio)
    true = true_ratios(aspect_ratio, D33=D33, poisson_ratio=poisson_ratio)
    return Ratios(*(100.0 * (value / right - 1.0) for value, right in zip(assumed, true, strict=True)))


def slopes_at_the_sphere(poisson_ratio: float = 0.21) -> tuple[Ratios, Ratios]:
    """Rate at which anisotropy sets in with the shape, for isotropic contact normals.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-], 0 to 0.5.

    Returns
    -------
    true, collinear : Ratios
        Logarithmic derivatives of C1111/C3333 and C2323/C1212 with respect to b/a at b/a = 1 [-]. All three
        assumptions have the same ones: their lengths differ in the second order.

    Notes
    -----
    Accuracy: two units in the last place. Source: the first terms of the series about the sphere
    (``derivations.spheroid_limits``).

    Examples
    --------
    >>> true, collinear = slopes_at_the_sphere()
    >>> [round(part / whole, 3) for part, whole in zip(collinear, true)]
    [0.26, 0.257]
    """
    from granular.contact_law import stiffness_ratio

    lam = stiffness_ratio(poisson_ratio)
    normal, shear = 7.0 * (3.0 + 2.0 * lam), 7.0 * (2.0 + 3.0 * lam)
    return (Ratios(-4.0 * (15.0 + 13.0 * lam) / normal, 4.0 * (5.0 + 9.0 * lam) / shear),
            Ratios(-4.0 * (6.0 + lam) / normal, 2.0 * (4.0 + 3.0 * lam) / shear))


def weight_of_shape(aspect_ratio: float) -> float:
    """Coefficient Dr33 of the weight whose lengths at pole and equator are as those of a spheroid.

    Parameters
    ----------
    aspect_ratio : float
        b/a [-], > 0.

    Returns
    -------
    float
        Dr33 with (1 + Dr33)/(1 - Dr33/2) = b/a [-].

    Notes
    -----
    Accuracy: two units in the last place. Source: W = 1 + Dr33 P2 of Figure 5.

    Examples
    --------
    >>> weight_of_shape(0.7 / 1.15)
    -0.3
    """
    return 2.0 * (aspect_ratio - 1.0) / (aspect_ratio + 2.0)


def shape_of_weight(Dr33: float) -> float:
    """Aspect ratio of the spheroid whose branches at pole and equator are as those of a weight.

    Parameters
    ----------
    Dr33 : float
        Coefficient of the branch-length weight [-], -1 < Dr33 < 2.

    Returns
    -------
    float
        b/a [-].

    Notes
    -----
    Accuracy: two units in the last place. Source: W = 1 + Dr33 P2 of Figure 5.

    Examples
    --------
    >>> [round(shape_of_weight(Dr33), 3) for Dr33 in (0.0, -0.3, -0.6, -0.9)]
    [1.0, 0.609, 0.308, 0.069]
    """
    return (1.0 + Dr33) / (1.0 - 0.5 * Dr33)


def deviation_angle(aspect_ratio: float, cosine: ArrayLike) -> NDArray[np.float64]:
    """Angle between the branch vector and the contact normal of aligned spheroids.

    Parameters
    ----------
    aspect_ratio : float
        b/a with b along axis 3 [-], > 0.
    cosine : float or (...) array
        Cosine of the angle between the normal and axis 3 [-], -1 to 1.

    Returns
    -------
    (...) array
        The angle, >= 0 [degrees]; largest, atan(\\|r - 1/r\\|/2), where tan(beta) = r = b/a.

    Notes
    -----
    Accuracy: a few units in the last place. Source: l is along (sin(beta), r^2 cos(beta)).

    Examples
    --------
    >>> [round(float(angle), 2) for angle in deviation_angle(0.5, [0.0, 0.8 ** 0.5, 1.0])]
    [0.0, 36.87, 0.0]
    """
    import numpy as np

    x = np.asarray(cosine, dtype=float)
    s = (1 - x) * (1 + x)
    apart = abs((aspect_ratio - 1) * (aspect_ratio + 1)) * np.sqrt(s) * np.abs(x)
    angle: NDArray[np.float64] = np.degrees(np.arctan2(apart, s + (aspect_ratio * x) ** 2))
    return angle


def _ratios(components: Six) -> Ratios:
    C1111, C3333, _, _, C2323, C1212 = components
    return Ratios(C1111 / C3333, C2323 / C1212)


def _moments(assumption: str, fabric: AxialFabric) -> tuple[float, float, float]:
    """Moments of E l^2 with s^2, s x^2 and x^4; the unit of length is as the assumption has it."""
    from math import fsum

    from granular.routes.contact_rule import suitable_contacts

    nodes = suitable_contacts(fabric, None, Hypothesis.STATIC).directions  # it serves s + r^4 x^2, the steepest here
    r2, Dr33 = fabric.aspect_ratio**2, weight_of_shape(fabric.aspect_ratio)
    lengths = {"length": lambda s, y: (s + r2 * r2 * y) / (s + r2 * y), "projection": lambda s, y: s + r2 * y,
               "weight": lambda s, y: ((1 - Dr33 / 2) * s + (1 + Dr33) * y) ** 2}
    directions = zip(nodes.sine_squared, nodes.cosine_squared, nodes.density(fabric), nodes.measure, strict=True)
    terms = [(s, y, density * measure * lengths[assumption](s, y)) for s, y, density, measure in directions]
    return (fsum(w * s * s for s, y, w in terms), fsum(w * s * y for s, y, w in terms),
            fsum(w * y * y for s, y, w in terms))
