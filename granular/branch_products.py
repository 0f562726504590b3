"""Branch vectors as any function of direction: the mean of l_i l_k over the contacts with one normal.

Each function of this module makes a function of direction, for ``granular.branch_stiffness.stiffness_by_direction``.
Directions are contact normals n, (3, q) [-]; what comes back is <l_i l_k>/l_e^2, (3, 3, q) [-], or a length, (q,) [-].
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from granular.errors import BranchesUnusable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]
    ByDirection = Callable[[Array], ArrayLike]

TRACE = 1e-9
"""How far the branch direction that a deviation tensor makes may be from a unit vector, squared [-]."""


def along_normals(mean_square: float | ByDirection = 1.0) -> Callable[[Array], Array]:
    """Branches along the contact normals, as eq. (7) has them.

    Parameters
    ----------
    mean_square : float or callable
        <l^2>/l_e^2 [-], > 0: one number, or a function from normals (3, q) to (q,).

    Returns
    -------
    callable
        From normals (3, q) to <l_i l_k>/l_e^2, (3, 3, q) [-].

    Raises
    ------
    BranchesUnusable
        When called: a mean square that is not positive or not finite.

    Notes
    -----
    Source: eq. (7).

    Examples
    --------
    >>> import numpy as np
    >>> along_normals(4.0)(np.eye(3))[2, 2].tolist()
    [0.0, 0.0, 4.0]
    """
    def products(n: Array) -> Array:
        return _positive(mean_square, n, "mean square branch length") * n[:, None] * n[None, :]

    return products


def lognormal_lengths(median: float | ByDirection, spread: float | ByDirection, *,
                      form: str = "paper") -> Callable[[Array], Array]:
    """Mean square of branch lengths whose lognormal density has a median and a spread for each direction.

    Parameters
    ----------
    median : float or callable
        l_50/l_e [-], > 0: one number, or a function from normals (3, q) to (q,).
    spread : float or callable
        s_l [-], >= 1, in the same two ways; 1 is the Dirac delta of one length in each direction.
    form : str
        "paper" for the density of eq. (19), which has no 1/l, or "classical" with it.

    Returns
    -------
    callable
        From normals (3, q) to <l^2>/l_e^2, (q,) [-].

    Raises
    ------
    BranchesUnusable
        A form that does not exist, or when called: a median that is not positive, or a spread below 1.

    Notes
    -----
    Accuracy: a few units in the last place. Source: eq. (19) with l_50 and s_l of each direction; <l^2> = l_50^2
    exp(4 ln^2 s_l) in the form of the paper, l_50^2 exp(2 ln^2 s_l) in the classical one (``derivations.gradation``).

    Examples
    --------
    >>> import math
    >>> import numpy as np
    >>> mean_square = lognormal_lengths(2.0, math.e, form="classical")(np.eye(3))
    >>> bool(np.allclose(mean_square, 4 * math.exp(2)))
    True
    """
    exponents = {"paper": 4.0, "classical": 2.0}
    if form not in exponents:
        raise BranchesUnusable(f"form = {form!r}", allowed=f"allowed {' and '.join(exponents)}",
                               remedy="Write one of these words.")

    def mean_square(n: Array) -> Array:
        import numpy as np

        centre = _positive(median, n, "median branch length")
        width = _positive(spread, n, "spread of branch lengths")
        if np.any(width < 1):
            raise BranchesUnusable(f"spread of branch lengths = {float(width.min())!r} in one direction",
                                   allowed="allowed 1 or more (a geometric standard deviation)",
                                   remedy="Give 1 for branches of one length in each direction.")
        found: Array = centre**2 * np.exp(exponents[form] * np.log(width) ** 2)
        return found

    return mean_square


def deviating(deviation: ArrayLike | ByDirection, mean_square: float | ByDirection = 1.0) -> Callable[[Array], Array]:
    """Branches that deviate from the contact normals: n^l_i n^l_k = r_pqik n_p n_q.

    Parameters
    ----------
    deviation : (3, 3, 3, 3) array or callable
        r_pqik [-]: one tensor, or a function from normals (3, q) to (3, 3, 3, 3, q).
    mean_square : float or callable
        <l^2>/l_e^2 [-], > 0: one number, or a function from normals (3, q) to (q,).

    Returns
    -------
    callable
        From normals (3, q) to <l_i l_k>/l_e^2, (3, 3, q) [-].

    Raises
    ------
    BranchesUnusable
        A tensor of another shape, or when called: one that does not turn a unit normal into a unit branch, or whose
        product is not symmetric.

    Notes
    -----
    Source: eqs (5) and (6).

    Examples
    --------
    >>> import numpy as np
    >>> collinear = np.einsum("pi,qk->pqik", np.eye(3), np.eye(3))
    >>> bool(np.allclose(deviating(collinear)(np.eye(3)), along_normals()(np.eye(3))))
    True
    """
    constant = None if callable(deviation) else _tensor(deviation)

    def products(n: Array) -> Array:
        import numpy as np

        if constant is not None:
            unit = np.einsum("pqik,pn,qn->ikn", constant, n, n)
        else:
            assert callable(deviation)  # or it would be constant
            unit = np.einsum("pqikn,pn,qn->ikn", _tensor(deviation(n), n.shape[1]), n, n)
        trace = np.einsum("iin->n", unit)
        worst = int(np.argmax(np.abs(trace - 1)))
        if not abs(trace[worst] - 1) <= TRACE:
            raise BranchesUnusable(
                f"r_pqii n_p n_q = {float(trace[worst]):.9g} for n = {_shown(n[:, worst])}",
                allowed=f"allowed 1 within {TRACE:g}, for the branch direction is a unit vector",
                remedy="Give lengths as mean_square, and a deviation that leaves unit vectors unit vectors.")
        if not np.allclose(unit, unit.transpose(1, 0, 2), rtol=0, atol=TRACE):
            raise BranchesUnusable("r_pqik n_p n_q is not symmetric in i and k", allowed="allowed n^l_i n^l_k only",
                                   remedy="Symmetrise the deviation tensor.")
        found: Array = _positive(mean_square, n, "mean square branch length") * unit
        return found

    return products


def spheroid_deviation(aspect_ratio: float) -> Callable[[Array], Array]:
    """Deviation tensor of aligned spheroids in each direction.

    Parameters
    ----------
    aspect_ratio : float
        b/a, with b along axis 3 [-], > 0.

    Returns
    -------
    callable
        From normals (3, q) to r_pqik = T_ip T_kq/\\|T n\\|^2 with T = diag(1, 1, (b/a)^2), (3, 3, 3, 3, q) [-].

    Notes
    -----
    Accuracy: a few units in the last place. Source: ``derivations.spheroid``.

    Examples
    --------
    >>> import numpy as np
    >>> spheroid_deviation(2.0)(np.eye(3))[:, :, 2, 2, 2].diagonal().tolist()
    [0.0, 0.0, 1.0]
    """
    import numpy as np

    stretch = np.diag([1.0, 1.0, aspect_ratio**2])

    def deviation(n: Array) -> Array:
        found: Array = np.einsum("ip,kq,n->pqikn", stretch, stretch, 1 / np.sum((stretch @ n) ** 2, axis=0))
        return found

    return deviation


def spheroid_branches(aspect_ratio: float) -> Callable[[Array], Array]:
    """Branches between aligned spheroids, with l_e twice the equal-volume radius.

    Parameters
    ----------
    aspect_ratio : float
        b/a, with b along axis 3 [-], > 0.

    Returns
    -------
    callable
        From normals (3, q) to l_i l_k/l_e^2, (3, 3, q) [-].

    Notes
    -----
    Accuracy: a few units in the last place. Source: :func:`granular.spheroid.branch_vectors`.

    Examples
    --------
    >>> import numpy as np
    >>> spheroid_branches(8.0)(np.eye(3))[2, 2].tolist()
    [0.0, 0.0, 16.0]
    """
    from granular.spheroid import branch_vectors

    def products(n: Array) -> Array:
        branch = branch_vectors(aspect_ratio, n)
        return branch[:, None] * branch[None, :]

    return products


def _positive(value: float | ByDirection, n: Array, name: str) -> Array:
    """A number or a function of direction as an array, which must be positive."""
    import numpy as np

    found = np.asarray(value(n) if callable(value) else value, dtype=float)
    if found.shape not in {(), (n.shape[1],)}:
        raise BranchesUnusable(f"{name} has the shape {found.shape}",
                               allowed=f"allowed ({n.shape[1]},), one number for each direction",
                               remedy="Return an array of that shape.")
    found = np.broadcast_to(found, (n.shape[1],))
    bad = ~((found > 0) & np.isfinite(found))
    if np.any(bad):
        first = int(np.argmax(bad))
        raise BranchesUnusable(f"{name} = {float(found[first])!r} for n = {_shown(n[:, first])}",
                               allowed="allowed positive finite numbers", remedy="Give a length in every direction.")
    return found


def _tensor(value: ArrayLike, directions: int | None = None) -> Array:
    import numpy as np

    found: Array = np.asarray(value, dtype=float)
    wanted = (3, 3, 3, 3) if directions is None else (3, 3, 3, 3, directions)
    if found.shape != wanted or not np.all(np.isfinite(found)):
        raise BranchesUnusable(f"deviation with the shape {found.shape}", allowed=f"allowed finite numbers {wanted}",
                               remedy="Give r_pqik with the indices in this order.")
    return found


def _shown(n: Array) -> str:
    return "(" + ", ".join(f"{component:.4g}" for component in n) + ")"
