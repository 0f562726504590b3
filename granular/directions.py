"""What a fabric looks like along one direction, and how far a fabric can go before contacts run out somewhere."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric import AxialFabric


def relative_density(fabric: AxialFabric, cosine: ArrayLike) -> NDArray[np.float64]:
    """Density of contact normals over that of an isotropic packing, 4 pi E(n).

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals about axis 3.
    cosine : float or (...) array
        Cosine of the angle from axis 3 [-], -1 to 1.

    Returns
    -------
    (...) array
        4 pi E(n) [-]; 1 in every direction of an isotropic packing.

    Notes
    -----
    Accuracy: a few units in the last place of the largest of its three terms.
    Source: assumption (a) of the parametric study, with the rank-4 term, as a form in sin^2 and cos^2.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> relative_density(AxialFabric(D33=2.0), [0.0, 1.0]).tolist()
    [0.0, 3.0]
    """
    import numpy as np

    along = np.asarray(cosine, dtype=float) ** 2
    across = 1 - along
    equator = 1 - fabric.D33 / 2 + 3 * fabric.D3333 / 8
    between = 2 + fabric.D33 / 2 - 3 * fabric.D3333
    pole = 1 + fabric.D33 + fabric.D3333
    density: NDArray[np.float64] = equator * across**2 + between * across * along + pole * along**2
    return density


def branch_weight(fabric: AxialFabric, cosine: ArrayLike) -> NDArray[np.float64]:
    """Mean branch length along a direction over the equivalent branch length, W(n).

    Parameters
    ----------
    fabric : AxialFabric
        Branches about axis 3.
    cosine : float or (...) array
        Cosine of the angle from axis 3 [-], -1 to 1.

    Returns
    -------
    (...) array
        W(n), or \\|l\\|/(2 r_e) between spheroids [-]; 1 in every direction when branches are equally long.

    Notes
    -----
    Accuracy: a few units in the last place.
    Source: the weighting function of Figure 5, as a form in sin^2 and cos^2; the branch vector of spheroids.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> branch_weight(AxialFabric(Dr33=-0.5), [0.0, 1.0]).tolist()
    [1.25, 0.5]
    """
    import numpy as np

    if fabric.aspect_ratio != 1.0:
        from granular.spheroid import branch_length

        return branch_length(fabric.aspect_ratio, cosine)
    x = np.asarray(cosine, dtype=float)
    weight: NDArray[np.float64] = (1 - fabric.Dr33 / 2) * ((1 - x) * (1 + x)) + (1 + fabric.Dr33) * (x * x)
    return weight


def admissible_boundary(angles: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coefficients at which the density of contact normals first touches zero.

    Parameters
    ----------
    angles : float or (...) array
        Directions in the plane of (D33, D3333), counted from the D33 axis [rad].

    Returns
    -------
    D33, D3333 : (...) array
        The last admissible pair in each direction [-]; the region is convex and contains the origin.

    Notes
    -----
    Accuracy: a few units in the last place of the larger coefficient.
    Source: along a ray the density is 1 + radius f(y) with y = cos^2 and f quadratic, so the radius is -1 over the
    least f, which lies at an end or at the turning point.

    Examples
    --------
    >>> import math
    >>> D33, _ = admissible_boundary([0.0, math.pi])
    >>> D33.round(12).tolist()
    [2.0, -1.0]
    """
    import numpy as np

    towards = np.asarray(angles, dtype=float)
    rank2, rank4 = np.cos(towards), np.sin(towards)
    # f(y) = rank2 (3y - 1)/2 + rank4 (35 y^2 - 30 y + 3)/8
    constant = -rank2 / 2 + 3 * rank4 / 8
    slope = 3 * rank2 / 2 - 15 * rank4 / 4
    curve = 35 * rank4 / 8
    least = np.minimum(constant, constant + slope + curve)
    turns_inside = (slope < 0) & (-slope < 2 * curve)
    turn = np.divide(-slope, 2 * curve, out=np.zeros_like(curve), where=turns_inside)
    least = np.where(turns_inside, constant + slope * turn / 2, least)
    return -rank2 / least, -rank4 / least
