"""What other lists of as many directions would have given: the bootstrap, and normal scatter of the moments."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import ValueOutOfRange
from granular.fabric_tensors.components import full_2, full_4, lower_rank, quadruple_products, second_kind, third_kind
from granular.fabric_tensors.reading import read_directions, read_weights
from granular.fabric_tensors.tensors import FabricTensors, fabric_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

AT_ONCE = 2**21
"""Numbers of repeats held at a time [-]: 16 MB, whatever the list and the number of resamples."""


@dataclass(frozen=True, slots=True, eq=False)
class Resamples:
    """Moments of many resampled lists.

    Attributes
    ----------
    fabric : FabricTensors
        Of the list itself.
    moments : (resamples, 15) array
        N_ijkl of each [-].
    """

    fabric: FabricTensors
    moments: Array

    @property
    def D2(self) -> Array:
        """D_ij of each, (resamples, 3, 3) [-]."""
        return full_2(third_kind(self.moments)[0])

    @property
    def D4(self) -> Array:
        """D_ijkl of each, (resamples, 3, 3, 3, 3) [-]."""
        return full_4(third_kind(self.moments)[1])

    def components(self) -> dict[str, tuple[Array, Array]]:
        """Tensors of the list and of each resample, by name.

        Returns
        -------
        dict
            N2, N4, F2, F4, D2, D4: the tensor of the list, and those of the resamples along a first axis [-].
        """
        (D2, D4), (F2, F4) = third_kind(self.moments), second_kind(self.moments)
        each = {"N2": full_2(lower_rank(self.moments)), "N4": full_4(self.moments), "F2": full_2(F2),
                "F4": full_4(F4), "D2": full_2(D2), "D4": full_4(D4)}
        return {name: (getattr(self.fabric, name), values) for name, values in each.items()}


def bootstrap(directions: ArrayLike, weights: ArrayLike | None = None, *, resamples: int = 999, seed: int = 0,
              normalise: bool = False) -> Resamples:
    """Moments of lists drawn from a list with replacement.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors, one a row [-].
    weights : (n,) array, optional
        How much each counts, not negative [any unit]; a direction keeps its weight.
    resamples : int
        Number of lists [-], 99 or more.
    seed : int
        Of the random numbers [-]; the same seed gives the same resamples.
    normalise : bool
        Whether lengths may be other than 1.

    Returns
    -------
    Resamples
        One row of moments each; the memory beyond the list does not grow with it.

    Raises
    ------
    TooFewDirections
        The effective number is below 16.
    ValueOutOfRange
        Fewer than 99 resamples, or as for ``fabric_of``.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        As for ``fabric_of``.

    Notes
    -----
    Accuracy: the scatter of resamples falls short of the true one by a share 1/(2n), and quantiles carry the noise of
    a finite number of them. Contacts are drawn one by one, as if they were independent; neighbours in a packing are
    not quite. Source: Efron's bootstrap.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of
    >>> from granular.fabric_tensors.sampling import isotropic
    >>> bootstrap(directions_of(isotropic(), 100), resamples=99).moments.shape
    (99, 15)
    """
    import numpy as np

    unit = read_directions(directions, normalise=normalise)
    weight = read_weights(weights, len(unit))
    fabric = fabric_of(unit, weight)
    fabric.require()
    _require_resamples(resamples)
    generator, count = np.random.default_rng(seed), len(unit)
    table = np.concatenate([weight[:, None] * quadruple_products(unit), weight[:, None]], axis=1)
    sums = np.empty((resamples, 16))
    lists = max(1, AT_ONCE // count)
    for start in range(0, resamples, lists):
        stop = min(start + lists, resamples)
        sums[start:stop] = _drawn(generator, count, stop - start) @ table
    # A resample in which every direction has the weight zero says nothing; with an effective number of 16 it needs
    # luck that nobody has.
    return Resamples(fabric, sums[:, :15] / sums[:, 15:])


def _drawn(generator: np.random.Generator, count: int, lists: int) -> Array:
    """How often each direction is in each list."""
    import numpy as np

    times = np.empty((lists, count))
    for row in range(lists):
        times[row] = np.bincount(generator.integers(count, size=count), minlength=count)
    return times


def normal_resamples(tensors: FabricTensors, *, resamples: int = 999, seed: int = 0) -> Resamples:
    """Moments that scatter normally with the covariance of the moments, for lists that are no longer in memory.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    resamples : int
        Number of draws [-], 99 or more.
    seed : int
        Of the random numbers [-]; the same seed gives the same draws.

    Returns
    -------
    Resamples
        One row of moments each.

    Raises
    ------
    TooFewDirections
        The effective number is below 16.
    ValueOutOfRange
        Fewer than 99 resamples.

    Notes
    -----
    Accuracy: that of the central limit theorem; from some hundred directions on hardly to be told from the bootstrap.
    Source: moments of rank eight.

    Examples
    --------
    >>> from granular.fabric_tensors import directions_of, fabric_of
    >>> from granular.fabric_tensors.sampling import isotropic
    >>> normal_resamples(fabric_of(directions_of(isotropic(), 100)), resamples=99).moments.shape
    (99, 15)
    """
    import numpy as np

    tensors.require()
    _require_resamples(resamples)
    spread, frame = np.linalg.eigh(tensors.covariance)
    root = frame * np.sqrt(np.maximum(spread, 0.0))
    draws = np.random.default_rng(seed).standard_normal((resamples, 15))
    return Resamples(tensors, tensors.moments + draws @ root.T)


def _require_resamples(resamples: int) -> None:
    if not resamples >= 99:
        raise ValueOutOfRange(f"resamples = {resamples}", allowed="allowed resamples >= 99",
                              remedy="Take 999 for intervals of 95 %.")
