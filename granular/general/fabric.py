"""The fabric of an assembly without an axis: contact normals and branch lengths by traceless tensors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from granular.errors import FabricOutOfRange, TensorUnusable
from granular.tensors import ZERO, SymmetricTensor, Tensor, Tensor4, shown_direction

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

NEAR = 1e-12
"""Traces, differences between permuted entries and negative densities below this count as rounding [-]."""


@dataclass(frozen=True, slots=True)
class GeneralFabric:
    """Contact-normal density and branch lengths as functions of direction, without any symmetry but that of n and -n.

    ``4 pi E(n) = 1 + D_ij n_i n_j + D_ijkl n_i n_j n_k n_l`` and ``W(n) = 1 + Dr_ij n_i n_j`` over l_e. For an axial
    fabric D = D33 diag(-1/2, -1/2, 1), and D4 is D3333 times the traceless tensor of P4.

    Parameters
    ----------
    D : (3, 3) array
        Traceless symmetric tensor of the contact normals, third kind [-].
    D4 : (3, 3, 3, 3) array, optional
        The same of rank four [-], unchanged by every permutation of its indices, every trace zero.
    Dr : (3, 3) array, optional
        Traceless symmetric tensor of the branch lengths [-]; branches of one length by default.

    Raises
    ------
    TensorUnusable
        A tensor that is not symmetric or not traceless, to 1e-12 of its largest entry.
    FabricOutOfRange
        E is negative or W not positive in some direction, which the message names.

    Notes
    -----
    Accuracy: without D4 the least density and the least branch length are eigenvalues. With D4 the least density is
    searched from 4000 directions on, which a form of degree four cannot hide from; it is no proof. Source: eq. (14).

    Examples
    --------
    >>> GeneralFabric(D=[[0.2, 0.1, 0], [0.1, 0.1, 0], [0, 0, -0.3]]).D[0]
    (0.2, 0.1, 0.0)
    """

    D: Tensor = ZERO
    D4: Tensor4 | None = None
    Dr: Tensor | None = None

    def __post_init__(self) -> None:
        """Read the tensors and look for directions without contacts or branches."""
        object.__setattr__(self, "D", _symmetric(self.D, "D"))
        if self.Dr is not None:
            object.__setattr__(self, "Dr", _symmetric(self.Dr, "Dr"))
            _require_branches(self.Dr)
        if self.D4 is not None:
            object.__setattr__(self, "D4", _harmonic(self.D4))
        _require_density(self)

    def relative_density(self, directions: Array) -> Array:
        """Density of contact normals over that of an isotropic packing, 4 pi E(n).

        Parameters
        ----------
        directions : (3, q) array
            Unit vectors [-].

        Returns
        -------
        (q,) array
            4 pi E [-].

        Notes
        -----
        Source: eq. (14) with a term of rank four.
        """
        import numpy as np

        n = directions
        density: Array = 1.0 + ((np.array(self.D) @ n) * n).sum(axis=0)
        if self.D4 is not None:
            pairs = (n[:, None] * n[None, :]).reshape(9, -1)
            density += ((np.array(self.D4).reshape(9, 9) @ pairs) * pairs).sum(axis=0)
        return density

    def branch_weight(self, directions: Array) -> Array:
        """Branch length over l_e, W(n).

        Parameters
        ----------
        directions : (3, q) array
            Unit vectors [-].

        Returns
        -------
        (q,) array
            W [-].

        Notes
        -----
        Source: the weighting function of Figure 5, with a tensor for the axial coefficient.
        """
        import numpy as np

        if self.Dr is None:
            return np.ones(directions.shape[1])
        weight: Array = 1.0 + ((np.array(self.Dr) @ directions) * directions).sum(axis=0)
        return weight

    def tensor(self) -> Array:
        """N_ij, the mean of n_i n_j over the contacts.

        Returns
        -------
        (3, 3) array
            N [-], with trace one.

        Notes
        -----
        Source: N_ij = delta_ij/3 + 2 D_ij/15; D_ijkl does not enter.
        """
        import numpy as np

        found: Array = np.eye(3) / 3 + 2 * np.array(self.D) / 15
        return found


def _symmetric(value: ArrayLike | Tensor, name: str) -> Tensor:
    (a, b, c), (d, e, f), (g, h, i) = SymmetricTensor(traceless=True).read(value, name)
    b, c, f = (b + d) / 2, (c + g) / 2, (f + h) / 2
    return (a, b, c), (b, e, f), (c, f, i)


def _harmonic(value: ArrayLike | Tensor4) -> Tensor4:
    from itertools import permutations

    import numpy as np

    try:
        given = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        given = np.zeros(0)
    if given.shape != (3, 3, 3, 3) or not np.all(np.isfinite(given)):
        raise TensorUnusable(f"D4 with the shape {given.shape}", allowed="allowed finite numbers (3, 3, 3, 3)",
                             remedy="Give all 81 components D[i, j, k, l].")
    mean: Array = np.mean([given.transpose(order) for order in permutations(range(4))], axis=0)
    slack = NEAR * float(np.abs(given).max())
    if float(np.abs(given - mean).max()) > slack:
        raise TensorUnusable("D4 changes when indices are swapped", allowed="allowed only fully symmetric tensors",
                             remedy="Take the mean over all permutations of the indices.")
    trace = np.einsum("ijkk->ij", mean)
    if float(np.abs(trace).max()) > 3 * slack:
        raise TensorUnusable(f"D4 has a trace with entries up to {float(np.abs(trace).max())!r}",
                             allowed="allowed only tensors all of whose traces vanish",
                             remedy="Move the trace into D, or give the tensor of the third kind.")
    first, second, third = (tuple(tuple(tuple(row) for row in block) for block in part) for part in mean.tolist())
    return cast("Tensor4", (first, second, third))


def _require_branches(Dr: Tensor) -> None:
    import numpy as np

    values, vectors = np.linalg.eigh(np.array(Dr))
    if not 1 + values[0] > 0:
        raise FabricOutOfRange(f"Dr gives W = {1 + values[0]:.6g} along n = {shown_direction(vectors[:, 0].tolist())}",
                               allowed="allowed only 1 + Dr_ij n_i n_j > 0 (branches have a length)",
                               remedy="Bring Dr closer to zero.")


def _require_density(fabric: GeneralFabric) -> None:
    least, direction = least_density(fabric)
    if not least >= -NEAR:
        where = shown_direction(direction.tolist())
        raise FabricOutOfRange(
            f"D{'' if fabric.D4 is None else ' with D4'} gives 4 pi E = {least:.6g} along n = {where}",
            allowed="allowed only densities that are nowhere negative",
            remedy="Bring the tensors closer to zero.")


def least_density(fabric: GeneralFabric) -> tuple[float, Array]:
    """Find the direction with the fewest contacts.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals [-].

    Returns
    -------
    least : float
        4 pi E there [-].
    direction : (3,) array
        The direction [-].

    Notes
    -----
    Accuracy: rounding without D4, an eigenvalue; with D4 that of Newton steps on the sphere from the lowest of 4000
    directions. Source: eq. (14).

    Examples
    --------
    >>> float(least_density(GeneralFabric(D=[[0.5, 0, 0], [0, -0.25, 0], [0, 0, -0.25]]))[0])
    0.75
    """
    import numpy as np

    D = np.array(fabric.D)
    if fabric.D4 is None:
        values, vectors = np.linalg.eigh(D)
        return float(1 + values[0]), vectors[:, 0]
    D4 = np.array(fabric.D4)
    n = spread_directions(4000)
    starts = n[:, np.argsort(fabric.relative_density(n))[:24]]
    found = np.array([_descended(D, D4, start) for start in starts.T]).T
    values = fabric.relative_density(found)
    return float(values.min()), found[:, values.argmin()]


def density_range(fabric: GeneralFabric) -> tuple[float, float]:
    """Enclose the density of contact normals.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals [-].

    Returns
    -------
    tuple of 2 float
        No more than the least and no less than the greatest 4 pi E [-].

    Notes
    -----
    Accuracy: next to the extremes without D4, which are eigenvalues. With it those of the part of rank four as a form
    on symmetric tensors are added, which encloses safely and not tightly. Source: n n is a symmetric tensor of norm
    one without a part of the identity but 1/sqrt(3), and a traceless D4 takes none of that.

    Examples
    --------
    >>> [round(value, 12) for value in density_range(GeneralFabric(D=[[0.5, 0, 0], [0, -0.25, 0], [0, 0, -0.25]]))]
    [0.75, 1.5]
    """
    import numpy as np

    values = np.linalg.eigvalsh(np.array(fabric.D))
    low, high = float(values[0]), float(values[2])
    if fabric.D4 is not None:
        fourth = np.linalg.eigvalsh(np.array(fabric.D4).reshape(9, 9)) * (2 / 3)
        low, high = low + float(fourth[0]), high + float(fourth[-1])
    slack = NEAR / 100 * max(abs(low), abs(high))
    return 1 + low - slack, 1 + high + slack


def spread_directions(count: int) -> Array:
    """Directions spread evenly over the half sphere along a spiral.

    Parameters
    ----------
    count : int
        How many [-].

    Returns
    -------
    (3, count) array
        Unit vectors [-].

    Notes
    -----
    Source: the golden-angle spiral.

    Examples
    --------
    >>> spread_directions(10).shape
    (3, 10)
    """
    import numpy as np

    place = np.arange(count) + 0.5
    height = place / count
    angle = np.pi * (1 + 5**0.5) * place
    radius = np.sqrt((1 - height) * (1 + height))
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), height])


def _descended(D: Array, D4: Array, start: Array) -> Array:
    """A few Newton steps on the sphere, each halved until the density falls."""
    import numpy as np

    def density(n: Array) -> float:
        return float(n @ D @ n + np.einsum("ijkl,i,j,k,l", D4, n, n, n, n))

    n = start
    for _ in range(12):
        bent = np.einsum("ijkl,k,l->ij", D4, n, n)
        slope = 2 * D @ n + 4 * bent @ n
        flat = np.linalg.svd(n[None, :])[2][1:]
        curvature = flat @ (2 * D + 12 * bent) @ flat.T - (n @ slope) * np.eye(2)
        values, vectors = np.linalg.eigh(curvature)
        step = -flat.T @ (vectors @ ((vectors.T @ (flat @ slope)) / np.maximum(np.abs(values), 1e-3)))
        size = 1.0
        while size > 1e-6:
            tried = n + size * step
            tried /= np.linalg.norm(tried)
            if density(tried) < density(n):
                n = tried
                break
            size /= 4
        else:
            break
    return n
