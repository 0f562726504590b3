"""``axial_gradient``: the components and all their slopes for whole arrays of assemblies at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from granular.batch.arguments import (
    common_shape,
    hypothesis_named,
    is_inside,
    real_array,
    require_range,
    require_sticking,
)
from granular.errors import ArrayNotUsable, SlopeInfinite, ValueOutOfRange
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.batch.kernel import Kernel

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

PARAMETERS = ("D33", "Dr33", "stress_ratio", "friction_coefficient", "poisson_ratio")
"""What the last axis of a jacobian counts, in this order."""


class AxialGradient(NamedTuple):
    """Components of arrays of assemblies and their slopes.

    Attributes
    ----------
    value : (..., 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].
    jacobian : (..., 6, 5) array
        Slope of each component by D33, Dr33, stress ratio, friction coefficient and Poisson's ratio, in the order of
        :data:`PARAMETERS` [-].
    """

    value: NDArray[np.float64]
    jacobian: NDArray[np.float64]


def axial_gradient(
    D33: ArrayLike,
    Dr33: ArrayLike,
    stress_ratio: ArrayLike = 1.0,
    friction_coefficient: ArrayLike | None = None,
    poisson_ratio: ArrayLike = 0.21,
    *,
    kinetic: bool = True,
    hypothesis: Hypothesis | str = Hypothesis.KINEMATIC,
    out: AxialGradient | None = None,
    engine: str | None = None,
    threads: int | None = None,
) -> AxialGradient:
    """Stiffness of axially symmetric assemblies and its exact slopes, for arrays of fabrics.

    Arguments and normalisation are those of :func:`granular.axial_stiffness`.

    Parameters
    ----------
    D33 : float or (...) array
        P2 coefficient of the contact-normal density [-], -1 <= D33 <= 2.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2.
    stress_ratio : float or (...) array
        sigma33/sigma11 [-], > 0.
    friction_coefficient : float or (...) array, optional
        Friction between grains [-], > 0; leave it out for contacts that never slip.
    poisson_ratio : float or (...) array
        Poisson's ratio of the grain material [-], 0 to 1/2.
    kinetic : bool
        Whether the stiffness of a contact follows the force that it carries. False: slopes by stress ratio and
        friction are zero.
    hypothesis : "kinematic" or "static"
        Upper bound or lower estimate.
    engine, threads : optional
        How many assemblies without slip are run, as in :func:`granular.axial_stiffness`.
    out : AxialGradient, optional
        Result of an earlier call of the same shape, whose memory takes this one: fresh memory for 36 numbers of each
        assembly takes longer than the numbers do. After a refusal its contents mean nothing.

    Returns
    -------
    AxialGradient
        ``value``, (..., 6) [-], and ``jacobian``, (..., 6, 5) [-]; ``out`` itself where it is given. Without friction
        its column is zero.

    Raises
    ------
    FabricOutOfRange
        A D33 or Dr33 outside its interval or not finite; the first such element is named.
    ValueOutOfRange
        The same for stress ratio, friction coefficient or Poisson's ratio; a friction of zero has no slope to both
        sides.
    SlopeInfinite
        Contacts are exactly at the onset of sliding; the first such element is named.
    ComplianceInfinite
        The static hypothesis where contacts slide.
    ArrayNotUsable
        Arguments that are not real numbers, or whose shapes do not broadcast; an ``out`` that is no result of this
        function, has another shape or shares its memory with an argument.
    UnknownChoice
        Another hypothesis or engine.

    Notes
    -----
    Where friction is given and all contacts carry the same force, the stiffness has a corner, because shear forces
    grow with the size of c - a: the mean of the two one-sided slopes by D33 and by the stress ratio is returned there.
    Near the onset of sliding, 1 - kappa = delta, slopes by D33, stress ratio and friction grow like \\|delta\\|^(-1/6)
    (static: delta^(-5/6)). Accuracy: 1e-13 of the larger of the slope and the largest component, as long as stress
    ratio, branch lengths and onset are not closer than 1e-3 to where a slope becomes infinite; beside that, of the
    largest slope of the element. Cost over that of the stiffness, values included: 1 to 3 with contact forces, 2 with
    slip, 2.5 for static compliances; 3 to 4 for equal contacts, where next to nothing is computed and 36 numbers are
    written in place of 6.
    Source: eqs (4), (7), and Figure 1(b) with (20)-(23), differentiated in ``derivations.gradients``.

    Examples
    --------
    >>> value, jacobian = axial_gradient(0.0, [-0.3, 0.0], kinetic=False)
    >>> value.shape, jacobian.shape
    ((2, 6), (2, 6, 5))
    >>> [round(float(slope), 12) for slope in jacobian[1, 0, :2] / jacobian[1, 0, 0]]
    [1.0, 2.0]
    """
    import numpy as np

    from granular.batch.evaluation import evaluate_batch
    from granular.derivatives.rows import COLUMNS

    chosen = hypothesis_named(hypothesis)
    given = {"D33": real_array(D33, "D33"), "Dr33": real_array(Dr33, "Dr33"),
             "stress_ratio": real_array(stress_ratio, "stress_ratio"),
             "poisson_ratio": real_array(poisson_ratio, "poisson_ratio")}
    if friction_coefficient is not None:
        given["friction_coefficient"] = real_array(friction_coefficient, "friction_coefficient")
    shape = common_shape(given)
    rows = np.empty((*shape, COLUMNS)) if out is None else _memory(out, shape, given)
    kernel = _kernel(given, chosen, kinetic=kinetic)
    if kernel is None:
        rest = np.arange(rows.size // COLUMNS)
    else:
        rest = evaluate_batch(kernel, [given[name] for name in kernel.inputs], rows, engine=engine, threads=threads)
    served = kernel.inputs if kernel else ()
    if rest.size or not all(is_inside(name, array) for name, array in given.items() if name not in served):
        require_range(given)  # a kernel serves nothing that is outside
    if rest.size:
        _fill(rows.reshape(-1, COLUMNS), rest, given, shape, chosen, kinetic=kinetic)
    if out is not None:
        return out
    by_slope = rows.reshape(*shape, COLUMNS // 6, 6)
    return AxialGradient(by_slope[..., 0, :], np.moveaxis(by_slope[..., 1:, :], -1, -2))


def _memory(out: AxialGradient, shape: tuple[int, ...], given: dict[str, NDArray[Any]]) -> Array:
    """The rows behind an earlier result."""
    import numpy as np

    from granular.derivatives.rows import COLUMNS

    def refuse(found: str, allowed: str) -> ArrayNotUsable:
        return ArrayNotUsable(f"out {found}", allowed=f"needed: {allowed}",
                              remedy="Hand over what axial_gradient returned for the same shape, or leave out away.")

    if not isinstance(out, AxialGradient):
        raise refuse(f"is a {type(out).__name__}", "a result of axial_gradient")
    rows = out.value.base
    if rows is None or rows is not out.jacobian.base or rows.shape != (*out.value.shape[:-1], COLUMNS):
        raise refuse("holds arrays that are not its own", "a result of axial_gradient as it was returned")
    if out.value.shape != (*shape, 6):
        raise refuse(f"holds results of shape {out.value.shape[:-1]}", f"shape {shape}")
    if any(np.may_share_memory(rows, array) for array in given.values()):
        raise refuse("shares its memory with an argument", "memory of its own")
    return rows


def _kernel(given: dict[str, NDArray[Any]], hypothesis: Hypothesis, *, kinetic: bool) -> Kernel | None:
    """The kernel that is asked first, where there is one."""
    from granular.derivatives import kernels

    if hypothesis is Hypothesis.STATIC or (kinetic and "friction_coefficient" in given):
        return None
    return kernels.KINETIC if kinetic else kernels.CONSTANT


def _fill(rows: Array, index: Index, given: dict[str, NDArray[Any]], shape: tuple[int, ...], hypothesis: Hypothesis, *,
          kinetic: bool) -> None:
    """Compute elements that no kernel serves, a block at a time."""
    import numpy as np

    from granular.derivatives.rows import BLOCK, constant_rows, kinetic_rows, slip_rows

    where = () if index.size == len(rows) else np.unravel_index(index, shape)
    values = {name: np.broadcast_to(array, shape)[where].astype(np.float64).ravel() for name, array in given.items()}
    d, dr, ratio, nu = (values[name] for name in ("D33", "Dr33", "stress_ratio", "poisson_ratio"))
    friction = values.get("friction_coefficient")
    slips = np.zeros(d.shape, dtype=bool)
    if kinetic and friction is not None:
        _require_friction(friction)
        if hypothesis is Hypothesis.STATIC:
            require_sticking(d, ratio, friction, index, len(rows))
        slips = _with_shear(d, ratio, friction)
    for start in range(0, d.size, BLOCK):
        here = np.arange(start, min(start + BLOCK, d.size))
        plain, slipping = here[~slips[here]], here[slips[here]]
        if not kinetic:
            rows[index[here]] = constant_rows(d[here], dr[here], nu[here], hypothesis)
            continue
        if plain.size:
            rows[index[plain]] = kinetic_rows(d[plain], dr[plain], ratio[plain], nu[plain], hypothesis)
        if slipping.size and friction is not None:
            rows[index[slipping]] = slip_rows(d[slipping], dr[slipping], ratio[slipping], friction[slipping],
                                              nu[slipping], hypothesis)


def _with_shear(D33: Array, stress_ratio: Array, friction: Array) -> NDArray[np.bool_]:
    """Elements whose contacts carry shear forces; one at the onset of sliding is refused."""
    import numpy as np

    from granular.routes.slip_geometry_array import slip_geometry

    geometry = slip_geometry(D33, stress_ratio, friction)
    sheared: NDArray[np.bool_] = geometry.kappa > 0
    onset = sheared & (geometry.left == 0)
    if onset.any():
        first = int(np.argmax(onset))
        raise SlopeInfinite(
            f"contacts at the onset of sliding in element {first} of {onset.size} (D33 = {D33[first].item()!r}, "
            f"stress_ratio = {stress_ratio[first].item()!r}, friction_coefficient = {friction[first].item()!r})",
            allowed="allowed on either side of it: exactly there the slopes of the shear stiffness are infinite",
            remedy="Move one of the three by a little, or take differences of values.")
    return sheared


def _require_friction(friction: Array) -> None:
    import numpy as np

    if not (friction > 0).all():
        first = int(np.argmin(friction > 0))
        raise ValueOutOfRange(
            f"friction_coefficient = {friction[first].item()!r} in element {first} of {friction.size}",
            allowed="allowed friction_coefficient > 0 where slopes are wanted",
            remedy="Leave the friction out for contacts that never slip, or give a coefficient above 0.")
