"""Directions drawn from a density of rank two and four: data with a known answer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import FabricOutOfRange
from granular.fabric_tensors.components import PAIRS, different_4, full_2, full_4, moments_of
from granular.fabric_tensors.density import homogeneous, least_density, values

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]


def tensors_of(D2: ArrayLike, D4: ArrayLike | None = None) -> FabricTensors:
    """Fabric tensors of a density that is known, without any scatter.

    Parameters
    ----------
    D2 : (3, 3) array
        D_ij, symmetric and traceless [-].
    D4 : (3, 3, 3, 3) array, optional
        D_ijkl, symmetric and traceless [-].

    Returns
    -------
    FabricTensors
        With an infinite number of directions and no covariance.

    Notes
    -----
    Accuracy: to rounding. Source: ``derivations.fabric_kinds``.

    Examples
    --------
    >>> import numpy as np
    >>> tensors_of(np.diag([-0.15, -0.15, 0.3])).N2[2, 2].round(12).item()
    0.373333333333
    """
    import numpy as np

    from granular.fabric_tensors.tensors import FabricTensors

    second, fourth = np.asarray(D2, dtype=float), np.zeros((3,) * 4) if D4 is None else np.asarray(D4, dtype=float)
    rows, columns = ([pair[k] for pair in PAIRS] for k in (0, 1))
    moments = moments_of(second[rows, columns], different_4(fourth))
    return FabricTensors.of_moments(moments, covariance=np.zeros((15, 15)), count=0,
                                    effective_number=float("inf"))


def axial_tensors(D33: float, D3333: float = 0.0, axis: ArrayLike = (0.0, 0.0, 1.0)) -> FabricTensors:
    """Fabric tensors of the density 1 + D33 P2 + D3333 P4 about an axis.

    Parameters
    ----------
    D33, D3333 : float
        Coefficients [-].
    axis : (3,) array
        Of any length but zero [-].

    Returns
    -------
    FabricTensors
        With an infinite number of directions and no covariance.

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: to rounding. Source: contacts of one direction have D33 = 5 and D3333 = 9 about it.

    Examples
    --------
    >>> axial_tensors(0.3, 0.1).D4[2, 2, 2, 2].round(12).item()
    0.1
    """
    from granular.fabric_tensors.components import quadruple_products, third_kind
    from granular.fabric_tensors.reading import read_axis

    second, fourth = third_kind(quadruple_products(read_axis(axis)))
    return tensors_of(D33 / 5 * full_2(second), D3333 / 9 * full_4(fourth))


def directions_of(tensors: FabricTensors, count: int, *, rank: int = 4, seed: int = 0) -> Array:
    """Draw independent directions from the density that fabric tensors imply.

    Parameters
    ----------
    tensors : FabricTensors
        Of any list of directions, or of a density that is known.
    count : int
        How many [-].
    rank : 0, 2 or 4
        Highest rank that is taken.
    seed : int
        Of the random numbers [-]; the same seed gives the same directions.

    Returns
    -------
    (count, 3) array
        Unit vectors [-].

    Raises
    ------
    FabricOutOfRange
        The density would be negative somewhere.

    Notes
    -----
    Accuracy: exact, by rejection. Source: uniform directions, each kept with a chance proportional to the density.

    Examples
    --------
    >>> directions_of(axial_tensors(0.3), 2).shape
    (2, 3)
    """
    import numpy as np

    least = least_density(tensors, rank=rank)
    if least.value < -1e-12:
        raise FabricOutOfRange(f"4 pi E = {least.value:.6g} along {np.round(least.direction, 6).tolist()}",
                               allowed="allowed only where 4 pi E >= 0", remedy="Take a lower rank.")
    form = homogeneous(tensors, rank)
    greatest = -least_density(_negative(tensors), rank=rank).value + 2 + 1e-9
    generator, drawn, missing = np.random.default_rng(seed), [], count
    while missing > 0:
        tried = uniform(generator, int(1.1 * greatest * missing) + 32)
        kept = tried[generator.random(len(tried)) * greatest < values(form, tried)][:missing]
        drawn.append(kept)
        missing -= len(kept)
    return np.concatenate(drawn) if drawn else np.empty((0, 3))


def _negative(tensors: FabricTensors) -> FabricTensors:
    """The density 2 - f, whose least value tells the greatest one of f."""
    return tensors_of(-tensors.D2, -tensors.D4)


def uniform(generator: np.random.Generator, *shape: int) -> Array:
    """Directions without any preference.

    Parameters
    ----------
    generator : numpy.random.Generator
        Source of random numbers.
    *shape : int
        How many [-].

    Returns
    -------
    (..., 3) array
        Unit vectors [-].

    Notes
    -----
    Source: three normal numbers have no preferred direction.
    """
    import numpy as np

    given = generator.standard_normal((*shape, 3))
    unit: Array = given / np.linalg.norm(given, axis=-1, keepdims=True)
    return unit


def isotropic() -> FabricTensors:
    """Fabric tensors of a density that is the same in all directions.

    Returns
    -------
    FabricTensors
        With D = 0.

    Notes
    -----
    Source: definition.

    Examples
    --------
    >>> abs(isotropic().D2).max().round(12).item()
    0.0
    """
    import numpy as np

    return tensors_of(np.zeros((3, 3)))

