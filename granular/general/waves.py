"""Plane waves in an assembly without an axis: three speeds, polarisations and rays in every direction.

In each direction travel three waves, named here by their speed: qP is the fastest, qS1 the faster and qS2 the slower of
the other two. The letters are the usual ones because the fastest wave is nearly longitudinal in all but the most
anisotropic solids; the polarisations say what it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from granular.elasticity import Stiffness
from granular.engineering import require_positive
from granular.errors import DirectionNotValid
from granular.general.extremes import Direction, Extreme, greatest, signed
from granular.mandel import size_of
from granular.waves import require_density

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

NO_SPEED = 1e-300
"""Two speeds whose sum is below this, over that of the largest component, count as equal [-]."""


@dataclass(frozen=True, slots=True)
class PlaneWaves:
    """The three plane waves in each of several directions; the second index counts qP, qS1, qS2.

    Attributes
    ----------
    directions : (q, 3) array
        Unit vectors of propagation [-].
    speeds : (q, 3) array
        Phase velocities [m/s], falling.
    polarisations : (q, 3, 3) array
        Unit vectors along which the grains move [-]; ``polarisations[q, w]`` is that of wave w, of either sign. Where
        two speeds are equal, any two perpendicular vectors of their plane.
    rays : (q, 3, 3) array
        Group velocities [m/s]: the direction and the speed of the energy. Where two speeds are equal, one of many.
    """

    directions: Array
    speeds: Array
    polarisations: Array
    rays: Array


@dataclass(frozen=True, slots=True)
class ThreeWaves:
    """The three plane waves in one direction.

    Attributes
    ----------
    qP, qS1, qS2 : float
        Phase velocities [m/s], falling.
    polarisations : tuple of 3 tuples of 3 float
        Unit vectors along which the grains move [-], in the same order; where two speeds are equal, any two
        perpendicular ones of their plane.
    """

    qP: float
    qS1: float
    qS2: float
    polarisations: tuple[Direction, Direction, Direction]


@dataclass(frozen=True, slots=True)
class GeneralWaves:
    """Plane waves in a solid of any symmetry.

    Attributes
    ----------
    stiffness : Stiffness
        The solid [Pa].
    density : float
        Bulk density [kg/m^3].
    along_1, along_2, along_3 : ThreeWaves
        Waves that travel along the coordinate axes [m/s].
    fastest_qP, slowest_qP : Extreme
        Greatest and least speed of the fastest wave over all directions [m/s], and where.
    largest_splitting : Extreme
        Greatest 2 (qS1 - qS2)/(qS1 + qS2) over all directions [-], and where.
    """

    stiffness: Stiffness
    density: float
    along_1: ThreeWaves
    along_2: ThreeWaves
    along_3: ThreeWaves
    fastest_qP: Extreme
    slowest_qP: Extreme
    largest_splitting: Extreme

    def at(self, directions: ArrayLike) -> PlaneWaves:
        """Waves in more directions.

        Parameters
        ----------
        directions : (q, 3) or (3,) array
            Vectors of any length but zero [-].

        Returns
        -------
        PlaneWaves
            Speeds [m/s], polarisations and rays.

        Raises
        ------
        DirectionNotValid
            A wrong shape, a vector of no length, or a value that is not finite.

        Notes
        -----
        Source: ``plane_waves``.
        """
        return plane_waves(self.stiffness, directions, density=self.density)


def plane_waves(stiffness: Stiffness, directions: ArrayLike, *, density: float) -> PlaneWaves:
    """Speeds, polarisations and rays of the three plane waves in given directions.

    Parameters
    ----------
    stiffness : Stiffness
        Positive definite, of any symmetry [Pa].
    directions : (q, 3) or (3,) array
        Vectors of any length but zero [-].
    density : float
        Bulk density [kg/m^3], > 0; see ``granular.waves.bulk_density``.

    Returns
    -------
    PlaneWaves
        Of q directions; q = 1 for a single one.

    Raises
    ------
    TensorNotPositive
        The stiffness stores no energy in some strain, so that a wave would have no speed.
    DensityOutOfRange
        The density is not positive and finite.
    DirectionNotValid
        A wrong shape, a vector of no length, or a value that is not finite.

    Notes
    -----
    Accuracy: density times speed squared to a few units in the last place of the largest component.
    Source: the Christoffel equation, C_ijkl n_j n_l a_k = density v^2 a_i; the group velocity is
    C_ijkl a_i a_k n_l/(density v).

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 2e8, 1e8, 3e8)
    >>> plane_waves(sand, [0, 0, 2], density=1600.0).speeds.tolist()
    [[500.0, 250.0, 250.0]]
    """
    import numpy as np

    unit, shape = _unit(stiffness, density)
    n = unit_vectors(directions)
    squares, vectors = np.linalg.eigh(christoffel(shape, n.T))
    speeds = np.sqrt(np.maximum(squares[:, ::-1], 0.0))
    polarisations = np.swapaxes(vectors, 1, 2)[:, ::-1]
    flux = np.einsum("ijkl,qwi,qwk,ql->qwj", shape, polarisations, polarisations, n)
    return PlaneWaves(n, speeds * unit, polarisations, flux / np.maximum(speeds, NO_SPEED)[..., None] * unit)


def axis_speeds(stiffness: Stiffness, *, density: float) -> tuple[ThreeWaves, ThreeWaves, ThreeWaves]:
    """Waves that travel along axis 1, 2 and 3.

    Parameters
    ----------
    stiffness : Stiffness
        Positive definite, of any symmetry [Pa].
    density : float
        Bulk density [kg/m^3], > 0.

    Returns
    -------
    tuple of 3 ThreeWaves
        Speeds of qP, qS1, qS2 and their polarisations, axis by axis.

    Raises
    ------
    TensorNotPositive
        The stiffness stores no energy in some strain.
    DensityOutOfRange
        The density is not positive and finite.

    Notes
    -----
    Accuracy: that of ``plane_waves``. Source: the Christoffel equation.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 2e8, 1e8, 3e8)
    >>> one, _, three = axis_speeds(sand, density=1600.0)
    >>> one.qP, three.qP, three.qS1
    (750.0, 500.0, 250.0)
    >>> one.polarisations[0]
    (1.0, 0.0, 0.0)
    """
    import numpy as np

    found = plane_waves(stiffness, np.eye(3), density=density)
    one, two, three = (
        ThreeWaves(float(qP), float(qS1), float(qS2), (signed(first), signed(second), signed(third)))
        for (qP, qS1, qS2), (first, second, third) in zip(found.speeds, found.polarisations, strict=True))
    return one, two, three


def general_waves(stiffness: Stiffness, *, density: float) -> GeneralWaves:
    """Wave speeds of a solid of any symmetry along the axes, and their extremes over the sphere.

    Parameters
    ----------
    stiffness : Stiffness
        Positive definite, of any symmetry [Pa].
    density : float
        Bulk density [kg/m^3], > 0; see ``granular.waves.bulk_density``.

    Returns
    -------
    GeneralWaves
        Speeds along the axes, the fastest and slowest qP, and the largest splitting of shear waves.

    Raises
    ------
    TensorNotPositive
        The stiffness stores no energy in some strain, so that a wave would have no speed.
    DensityOutOfRange
        The density is not positive and finite.

    Notes
    -----
    Accuracy: speeds to rounding of the largest component, directions of extremes to about 1e-7; see
    ``granular.general.extremes``. Source: the Christoffel equation.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 1e8, 1e8, 3e8)
    >>> found = general_waves(sand, density=1600.0)
    >>> found.fastest_qP, found.slowest_qP.value <= 500.0
    (Extreme(value=750.0, direction=(1.0, 0.0, 0.0)), True)
    """
    import numpy as np

    unit, shape = _unit(stiffness, density)

    def speeds(n: Array) -> Array:
        found: Array = np.sqrt(np.maximum(np.linalg.eigvalsh(christoffel(shape, n)), 0.0))
        return found

    def split(n: Array) -> Array:
        slow, fast, _ = speeds(n).T
        apart: Array = 1 + 2 * (fast - slow) / np.maximum(fast + slow, NO_SPEED)
        return apart

    fastest = greatest(lambda n: speeds(n)[:, 2])
    slowest = greatest(lambda n: -speeds(n)[:, 2])
    splitting = greatest(split)
    return GeneralWaves(stiffness, density, *axis_speeds(stiffness, density=density),
                        fastest_qP=replace(fastest, value=fastest.value * unit),
                        slowest_qP=replace(slowest, value=-slowest.value * unit),
                        largest_splitting=replace(splitting, value=max(splitting.value - 1, 0.0)))


def christoffel(tensor: Array, directions: Array) -> Array:
    """Christoffel matrices C_ijkl n_j n_l.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        Stiffness [any unit].
    directions : (3, q) array
        Unit vectors [-].

    Returns
    -------
    (q, 3, 3) array
        Symmetric [same unit]; eigenvalues are density times speed squared.

    Notes
    -----
    Accuracy: a few units in the last place of the largest component. Source: balance of momentum of a plane wave.

    Examples
    --------
    >>> import numpy as np
    >>> sand = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)
    >>> christoffel(sand.tensor(), np.eye(3))[2].diagonal().tolist()
    [2.5, 2.5, 7.0]
    """
    import numpy as np

    by_pairs = tensor.transpose(0, 2, 1, 3).reshape(9, 9)
    pairs = (directions[:, None] * directions[None]).reshape(9, -1)
    found: Array = np.ascontiguousarray((by_pairs @ pairs).T).reshape(-1, 3, 3)
    return found


def unit_vectors(directions: ArrayLike) -> Array:
    """Read directions given as vectors of any length.

    Parameters
    ----------
    directions : (q, 3) or (3,) array
        Vectors of any length but zero [-].

    Returns
    -------
    (q, 3) array
        Unit vectors [-].

    Raises
    ------
    DirectionNotValid
        A wrong shape, a vector of no length, or a value that is not finite.

    Notes
    -----
    Accuracy: a few units in the last place, for vectors of any size. Source: n/\\|n\\|.

    Examples
    --------
    >>> unit_vectors([[0.0, 0.0, 1e-200], [3.0, 0.0, -4.0]]).tolist()
    [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]]
    """
    import numpy as np

    try:
        given = np.atleast_2d(np.asarray(directions, dtype=float))
    except (TypeError, ValueError):
        given = np.zeros((0, 0))
    if given.ndim != 2 or given.shape[1] != 3:
        raise DirectionNotValid(f"directions of the shape {np.shape(given)}", allowed="needed: numbers (q, 3)",
                                remedy="Give one vector a row.")
    size = np.abs(given).max(axis=1, initial=0.0)
    if not bool(np.all((size > 0) & np.isfinite(size))):
        place = int(np.flatnonzero(~((size > 0) & np.isfinite(size)))[0])
        raise DirectionNotValid(f"direction {place + 1} = {given[place].tolist()}",
                                allowed="needed: finite numbers, not all of them zero",
                                remedy="Give a vector along which the wave travels.")
    scaled = given / size[:, None]
    found: Array = scaled / np.linalg.norm(scaled, axis=1)[:, None]
    return found


def _unit(stiffness: Stiffness, density: float) -> tuple[float, Array]:
    """Unit of the speeds [m/s], and the tensor over a power of two that makes its largest entry about one."""
    require_density("density", density)
    size = size_of(value for row in require_positive(stiffness).rows for value in row)
    return math.sqrt(size) / math.sqrt(density), stiffness.tensor() / size
