"""Tests for lists of any length: turn directions at random as the symmetry allows, and see how rare the list is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import ValueOutOfRange
from granular.fabric_tensors.axial_fit import along
from granular.fabric_tensors.components import full_2, full_4, quadruple_products, third_kind
from granular.fabric_tensors.frames import frame_about
from granular.fabric_tensors.reading import read_axis, read_directions, read_weights
from granular.fabric_tensors.sampling import uniform
from granular.fabric_tensors.symmetry_test import SymmetryTest
from granular.fabric_tensors.tensors import fabric_of

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]


def randomised_uniformity(directions: ArrayLike, weights: ArrayLike | None = None, *, trials: int = 999,
                          seed: int = 0, normalise: bool = False) -> SymmetryTest:
    """Test an isotropic fabric of rank two against lists of random directions with the same weights.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors [-].
    weights : (n,) array, optional
        Not negative [any unit].
    trials : int
        Number of random lists [-], 99 or more.
    seed : int
        Of the random numbers [-].
    normalise : bool
        Whether lengths may be other than 1.

    Returns
    -------
    SymmetryTest
        Its chance is at least 1/(trials + 1).

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange, TooFewDirections
        As for ``fabric_of``; fewer than 99 trials.

    Notes
    -----
    Accuracy: the level is exact for any number of directions and any weights. Source: Monte-Carlo test.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of
    >>> from granular.fabric_tensors.sampling import isotropic
    >>> randomised_uniformity(directions_of(isotropic(), 50), trials=99).p > 0.05
    True
    """
    def statistic(moments: Array) -> Array:
        import numpy as np

        squares: Array = 2 / 15 * np.sum(full_2(third_kind(moments)[0]) ** 2, axis=(-2, -1))
        return squares

    def turned(generator: np.random.Generator, unit: Array) -> Array:
        return uniform(generator, len(unit))

    return _randomised("anisotropy of rank two, by random lists", "no anisotropy of rank two is seen",
                       "there is anisotropy of rank two", 5, statistic, turned, directions, weights, trials, seed,
                       normalise)


def randomised_axial_symmetry(directions: ArrayLike, weights: ArrayLike | None = None, *,
                              axis: ArrayLike = (0.0, 0.0, 1.0), trials: int = 999, seed: int = 0,
                              normalise: bool = False) -> SymmetryTest:
    """Test axial symmetry about a given axis against lists whose directions are turned about it at random.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors [-].
    weights : (n,) array, optional
        Not negative [any unit].
    axis : (3,) array
        The axis [-].
    trials : int
        Number of random lists [-], 99 or more.
    seed : int
        Of the random numbers [-].
    normalise : bool
        Whether lengths may be other than 1.

    Returns
    -------
    SymmetryTest
        Of ranks two and four; its chance is at least 1/(trials + 1).

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange, TooFewDirections
        As for ``fabric_of``; no axis; fewer than 99 trials.

    Notes
    -----
    Accuracy: the level is exact for any number of directions and any weights. Source: given the angles from the axis,
    the azimuths of an axially symmetric fabric are uniform and independent.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of
    >>> from granular.fabric_tensors.sampling import axial_tensors
    >>> randomised_axial_symmetry(directions_of(axial_tensors(1.0), 50), trials=99).p > 0.05
    True
    """
    about = read_axis(axis)
    frame = frame_about(about)

    def statistic(moments: Array) -> Array:
        import numpy as np

        D2, D4 = (full(part) for full, part in zip((full_2, full_4), third_kind(moments), strict=True))
        D33, D3333 = along(D2, D4, about)
        left: Array = (2 / 15 * np.sum(D2**2, axis=(-2, -1)) - D33**2 / 5
                       + 8 / 315 * np.sum(D4**2, axis=(-4, -3, -2, -1)) - D3333**2 / 9)
        return left

    def turned(generator: np.random.Generator, unit: Array) -> Array:
        import numpy as np

        height = unit @ about
        across = np.sqrt(np.maximum(1 - height**2, 0.0))
        angle = generator.uniform(0, 2 * np.pi, len(unit))
        result: Array = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=1) @ frame
        return result

    return _randomised("axial symmetry about the given axis, by random turns",
                       "the fabric can be axially symmetric about the given axis",
                       "the fabric is not axially symmetric about the given axis", 12, statistic, turned, directions,
                       weights, trials, seed, normalise)


def _randomised(name: str, holds: str, fails: str, dof: int, statistic: Callable[[Array], Array],
                turned: Callable[[np.random.Generator, Array], Array], directions: ArrayLike,
                weights: ArrayLike | None, trials: int, seed: int, normalise: bool) -> SymmetryTest:
    import numpy as np

    if not trials >= 99:
        raise ValueOutOfRange(f"trials = {trials}", allowed="allowed trials >= 99", remedy="Take 999.")
    unit = read_directions(directions, normalise=normalise)
    weight = read_weights(weights, len(unit))
    fabric = fabric_of(unit, weight)
    found = float(statistic(fabric.moments))
    generator, share = np.random.default_rng(seed), weight / weight.sum()
    moments = np.stack([share @ quadruple_products(turned(generator, unit)) for _ in range(trials)])
    as_large = int(np.sum(statistic(moments) >= found * (1 - 1e-12)))
    return SymmetryTest(name, holds, fails, fabric.effective_number * found, dof, (as_large + 1) / (trials + 1))
