"""Forces and stiffness of the contacts by direction, for figures and for cubature over the sphere."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.directions import branch_weight

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]


def normal_force(fabric: AxialFabric, loading: Loading, cosine: ArrayLike) -> Array:
    """Estimated normal force of the contacts of a direction, over that of the isotropic assembly.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading
        Stress and friction.
    cosine : float or (...) array
        x = cos(beta) [-], -1 to 1.

    Returns
    -------
    (...) array
        (a s + c x^2)/W [-], over 3 p V/(M l_e); negative where the estimate asks for tension.

    Notes
    -----
    Accuracy: about three units in the last place of the larger term. Source: eq. (23).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> normal_force(AxialFabric(), Loading.of_ratio(2.0), [0.0, 1.0]).tolist()
    [0.75, 1.5]
    """
    x2, s, weight = _direction(fabric, cosine)
    a, c = (float(value) for value in loading.coefficients(fabric.D33))
    return (a * s + c * x2) / weight


def shear_force(fabric: AxialFabric, loading: Loading, cosine: ArrayLike) -> Array:
    """Estimated shear force of the contacts of a direction, over the same unit.

    Parameters
    ----------
    fabric, loading, cosine
        As for :func:`normal_force`.

    Returns
    -------
    (...) array
        \\|c - a\\| x sqrt(s)/W [-], never negative. It may exceed mu times the normal force: the estimate does not
        know of sliding, it only says which contacts would slide.

    Notes
    -----
    Accuracy: about four units in the last place. Source: eq. (23).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> shear_force(AxialFabric(), Loading.of_ratio(1.0), 0.5).tolist()
    0.0
    """
    import numpy as np

    x2, s, weight = _direction(fabric, cosine)
    a, c = loading.coefficients(fabric.D33)
    return np.sqrt(x2 * s) * abs(float(c - a)) / weight


def normal_stiffness(fabric: AxialFabric, loading: Loading, cosine: ArrayLike) -> Array:
    """Normal stiffness of the contacts of a direction, over k_n,ref.

    Parameters
    ----------
    fabric, loading, cosine
        As for :func:`normal_force`.

    Returns
    -------
    (...) array
        (a s + c x^2)^(1/3) [-], zero where the contact has opened. The branch length does not enter: the force falls
        with it as the radius of the contact grows with it.

    Notes
    -----
    Accuracy: about two units in the last place. Source: eq. (20) with R_e = l/4.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> normal_stiffness(AxialFabric(), Loading.of_ratio(1.0), 0.3).tolist()
    1.0
    """
    import numpy as np

    force = normal_force(fabric, loading, cosine) * _direction(fabric, cosine)[2]
    result: Array = np.cbrt(np.maximum(force, 0.0))
    return result


def shear_stiffness(fabric: AxialFabric, loading: Loading, cosine: ArrayLike, *, poisson_ratio: float) -> Array:
    """Shear stiffness of the contacts of a direction, over k_n,ref.

    Parameters
    ----------
    fabric, loading, cosine
        As for :func:`normal_force`.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.

    Returns
    -------
    (...) array
        lambda_0 (1 - f_r/(mu f_n))^(1/3) k_n [-]; zero where the contact slides or has opened.

    Notes
    -----
    Accuracy: a few units in the last place of lambda_0 k_n. Source: eq. (21), corrected.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> shear_stiffness(AxialFabric(), Loading.of_ratio(1.0), 0.3, poisson_ratio=0.0).tolist()
    1.0
    """
    import numpy as np

    from granular.contact_law import stiffness_ratio

    normal = normal_force(fabric, loading, cosine)
    compressed = np.maximum(normal, 0.0)
    ratio = stiffness_ratio(poisson_ratio)
    if loading.friction is None:
        return ratio * normal_stiffness(fabric, loading, cosine)
    if loading.friction == 0:
        return np.zeros_like(normal)
    left = np.maximum(compressed - shear_force(fabric, loading, cosine) / loading.friction, 0.0)
    return ratio * np.cbrt(left * _direction(fabric, cosine)[2])


def _direction(fabric: AxialFabric, cosine: ArrayLike) -> tuple[Array, Array, Array]:
    """x^2, 1 - x^2 and the branch length W."""
    import numpy as np

    x = np.asarray(cosine, dtype=np.float64)
    x2, s = x * x, (1 - x) * (1 + x)
    return x2, s, branch_weight(fabric, x)
