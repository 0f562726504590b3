"""``axial_stiffness``: six components for whole arrays of fabrics at once, with the manners of a NumPy ufunc."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.batch import constant, slip
from granular.batch import kinetic as with_force
from granular.batch.arguments import (
    common_shape,
    hypothesis_named,
    in_range,
    is_inside,
    real_array,
    require_place,
    require_range,
    require_sticking,
)
from granular.batch.engines import engine_named
from granular.batch.evaluation import evaluate_batch
from granular.batch.full_precision import with_equal_contacts, with_forces
from granular.errors import UnknownChoice, ValueOutOfRange
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.batch.kernel import Kernel

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

RELATIVE_ERROR = 2.0**-49
"""Declared bound of every component [-], 8 units in the last place; the worst met in the tests is about half."""

INVALID = ("raise", "nan")


def axial_stiffness(
    D33: ArrayLike,
    Dr33: ArrayLike,
    stress_ratio: ArrayLike = 1.0,
    friction_coefficient: ArrayLike | None = None,
    poisson_ratio: ArrayLike = 0.21,
    *,
    kinetic: bool = True,
    hypothesis: Hypothesis | str = Hypothesis.KINEMATIC,
    rtol: float | None = None,
    out: NDArray[np.float64] | None = None,
    invalid: str = "raise",
    engine: str | None = None,
    threads: int | None = None,
) -> NDArray[np.float64]:
    """Stiffness of axially symmetric assemblies, over (M/V) l_e^2 k_n,ref, for arrays of fabrics.

    k_n,ref is the normal contact stiffness of the isotropic assembly under the same mean stress.

    Parameters
    ----------
    D33 : float or (...) array
        P2 coefficient of the contact-normal density [-], -1 <= D33 <= 2.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2.
    stress_ratio : float or (...) array
        sigma33/sigma11 [-], > 0.
    friction_coefficient : float or (...) array, optional
        Friction between grains [-], >= 0; leave it out for contacts that never slip.
    poisson_ratio : float or (...) array
        Poisson's ratio of the grain material [-], 0 to 1/2.
    kinetic : bool
        Whether the stiffness of a contact follows the force that it carries, with partial slip and sliding where
        friction is given. False: every contact has the stiffness of the ideal assembly under the mean stress,
        whatever the stress ratio and the friction.
    hypothesis : "kinematic" or "static"
        Upper bound or lower estimate.
    rtol : float, optional
        Wanted relative accuracy of every component [-]; refused below the accuracy stated here.
    out : (..., 6) array, optional
        Where the result is put [-]: float64, of exactly the shape of the result, in any layout; it may overlap the
        arguments. After a refusal its contents mean nothing.
    invalid : "raise" or "nan"
        What happens to elements that have no answer: outside their intervals, or without a finite compliance. The
        first is refused by name, place and value; or all of them are NaN in every component, so that
        ``np.isnan(result[..., 0])`` is their mask, and no other element is NaN.
    engine : "numpy", "compiled" or "fused", optional
        How elements are evaluated; by default compiled where numba is installed and this process has had some two
        million of them, so that the start of the compiler pays. The result has the same bits. ``"fused"`` is compiled
        so that a product is not rounded before something is added to it: faster, within the same bounds, but the last
        bits are then those of the processor.
    threads : int, optional
        How many threads share the work [-], >= 1; by default one for each processor that this process may use, if it
        has 2^18 elements to do. The result has the same bits.

    Returns
    -------
    (..., 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 [-] of each element of the broadcast arguments; ``out`` itself where
        it is given. Integers and single precision are converted to float64 before anything is computed.

    Raises
    ------
    FabricOutOfRange
        A D33 or Dr33 outside its interval or not finite; the first such element is named.
    ValueOutOfRange
        The same for stress ratio, friction coefficient or Poisson's ratio; or a number of threads below 1.
    ComplianceInfinite
        The static hypothesis where contacts slide; the first such element is named.
    ArrayNotUsable
        Arguments that are not real numbers, or whose shapes do not broadcast; an ``out`` of another shape or type.
    UnknownChoice
        Another hypothesis, engine or way with invalid elements.
    RouteOutOfDomain
        ``rtol`` below the accuracy stated here.

    Notes
    -----
    Accuracy: every component to 2^-49, about 1.8e-15 of itself, unless it is below 2.3e-308; to 1e-12 where friction
    is given, ``rtol`` is 1e-12 or more, and there are 2^13 elements with one friction or 2^18 with several: these are
    read from tables, in a small part of the time.
    Cost of an element: a closed form where all contacts are equally stiff (static: four polynomials where branch
    lengths at pole and equator are within a factor 9). With forces and without friction (kinematic) six polynomials
    where the forces at pole and equator have a ratio from 1/9 to 6, as stress ratios from 1/3 to 3 give
    with any fabric; elsewhere sums over 28 to 500 directions, and over 150 to 900 with friction, the more the nearer
    the onset of sliding.
    Source: eqs (4), (7), and Figure 1(b) with (20)-(23).

    Examples
    --------
    >>> axial_stiffness(0.0, [-0.3, 0.0], kinetic=False).shape
    (2, 6)
    >>> isotropic = axial_stiffness(0, 0, poisson_ratio=0)
    >>> [round(float(value), 12) for value in isotropic]
    [0.333333333333, 0.333333333333, 0.0, 0.0, 0.166666666667, 0.166666666667]
    >>> axial_stiffness([0.0, 2.5], 0.0, invalid="nan")[:, 0] > 0
    array([ True, False])
    """
    import numpy as np

    chosen = hypothesis_named(hypothesis)
    require_accuracy("axial_stiffness", RELATIVE_ERROR, rtol)
    _require_options(invalid, engine, threads)
    given = {"D33": real_array(D33, "D33"), "Dr33": real_array(Dr33, "Dr33"),
             "stress_ratio": real_array(stress_ratio, "stress_ratio"),
             "poisson_ratio": real_array(poisson_ratio, "poisson_ratio")}
    if friction_coefficient is not None:
        given["friction_coefficient"] = real_array(friction_coefficient, "friction_coefficient")
    shape = (*common_shape(given), len(COMPONENTS))
    place = None if out is None else require_place(out, shape)
    direct = place is not None and place.flags.c_contiguous and place.flags.aligned and not any(
        np.may_share_memory(place, array) for array in given.values())
    result = place if place is not None and direct else np.empty(shape)
    kernel = _kernel(kinetic=kinetic, hypothesis=chosen, friction=given.get("friction_coefficient"),
                     size=result.size // len(COMPONENTS), rtol=rtol)
    unserved = _by_kernel(kernel, given, result, engine, threads)
    if unserved.size:
        _fill(result, unserved, given, kinetic, chosen, invalid)
    if place is None or direct:
        return result
    place[...] = result
    return place


def _kernel(*, kinetic: bool, hypothesis: Hypothesis, friction: NDArray[Any] | None, size: int,
            rtol: float | None) -> Kernel | None:
    """The kernel that is asked first, where there is one."""
    if not kinetic:
        return constant.STATIC if hypothesis is Hypothesis.STATIC else constant.KINEMATIC
    if hypothesis is Hypothesis.STATIC:
        return None
    return with_force.KINEMATIC if friction is None else slip.kernel_for(friction, size, rtol)


def _by_kernel(kernel: Kernel | None, given: dict[str, NDArray[Any]], result: Array, engine: str | None,
               threads: int | None) -> Index:
    """Let a kernel fill in what it serves; what is left is every element that it does not, and every invalid one."""
    import numpy as np

    if kernel is None:
        return np.arange(result.size // result.shape[-1])
    unserved = evaluate_batch(kernel, [given[name] for name in kernel.inputs], result, engine=engine, threads=threads)
    for name, array in given.items():
        if name not in kernel.inputs and not is_inside(name, array):
            outside = ~np.broadcast_to(in_range({name: array}), result.shape[:-1])
            unserved = np.union1d(unserved, np.flatnonzero(outside))
    return unserved


def _fill(result: Array, index: Index, given: dict[str, NDArray[Any]], kinetic: bool, hypothesis: Hypothesis,
          invalid: str) -> None:
    """Compute elements that no kernel serves, and refuse or mark those that have no answer."""
    import numpy as np

    from granular.routes.slip_geometry_array import slides

    shape, rows = result.shape[:-1], result.reshape(-1, result.shape[-1])
    where = () if index.size == len(rows) else np.unravel_index(index, shape)
    values: dict[str, Array] = {name: np.broadcast_to(array, shape)[where].astype(np.float64).ravel()
                                for name, array in given.items()}
    valid = in_range(values)
    if not valid.all():
        if invalid == "raise":
            require_range({name: array.astype(np.float64) for name, array in given.items()})
        rows[index[~valid]] = np.nan
        index, values = index[valid], {name: array[valid] for name, array in values.items()}
    d, dr, nu = values["D33"], values["Dr33"], values["poisson_ratio"]
    if not kinetic:
        rows[index] = with_equal_contacts(d, dr, nu, hypothesis)
        return
    ratio, friction = values["stress_ratio"], values.get("friction_coefficient")
    if hypothesis is Hypothesis.STATIC and friction is not None:
        if invalid == "raise":
            require_sticking(d, ratio, friction, index, len(rows))
        else:
            sliding = slides(d, ratio, friction)
            rows[index[sliding]] = np.nan
            index = index[~sliding]
            d, dr, nu, ratio, friction = (array[~sliding] for array in (d, dr, nu, ratio, friction))
    rows[index] = with_forces(d, dr, ratio, friction, nu, hypothesis)


def _require_options(invalid: str, engine: str | None, threads: int | None) -> None:
    engine_named(engine)
    if invalid not in INVALID:
        raise UnknownChoice(f"invalid = {invalid!r}", allowed=f"allowed: {', '.join(map(repr, INVALID))}",
                            remedy="Say whether elements without an answer are refused or become NaN.")
    if threads is not None and (isinstance(threads, bool) or not isinstance(threads, int) or threads < 1):
        raise ValueOutOfRange(f"threads = {threads!r}", allowed="allowed: whole numbers >= 1",
                              remedy="Give a number of threads, or leave threads out.")
