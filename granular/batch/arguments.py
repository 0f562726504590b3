"""What functions of arrays are given: real numbers that broadcast, inside their intervals, a place for the result."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from operator import and_
from typing import TYPE_CHECKING, Any

from granular.errors import ArrayNotUsable, ComplianceInfinite, FabricOutOfRange, UnknownChoice, ValueOutOfRange
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]
    Mask = NDArray[np.bool_]


def real_array(argument: ArrayLike, name: str) -> NDArray[Any]:
    """An argument as an array of integers or floats.

    Parameters
    ----------
    argument : array_like
        What was given [any unit].
    name : str
        How it is called, for the refusal.

    Returns
    -------
    (...) array
        The same numbers, in their own type [same unit].

    Raises
    ------
    ArrayNotUsable
        Text, truth values, complex numbers, objects, rows of different lengths, or an array with a mask.

    Notes
    -----
    Source: NumPy.

    Examples
    --------
    >>> real_array([1, 2], "D33").dtype.kind
    'i'
    """
    import numpy as np

    remedy = f"Give {name} as a number or an array of real numbers."
    if isinstance(argument, np.ma.MaskedArray):
        raise ArrayNotUsable(f"{name} is a masked array", allowed="needed: an array without mask",
                             remedy="Select the valid elements first, for example with .compressed().")
    try:
        array = np.asarray(argument)
    except ValueError:
        raise ArrayNotUsable(f"{name} has rows of different lengths", allowed="needed: one shape",
                             remedy=remedy) from None
    if array.dtype.kind not in "iuf":
        raise ArrayNotUsable(f"{name} holds {array.dtype.name}", allowed="needed: integers or floats",
                             remedy=remedy)
    return array


def hypothesis_named(name: Hypothesis | str) -> Hypothesis:
    """The hypothesis of a name.

    Parameters
    ----------
    name : Hypothesis or str
        What was given.

    Returns
    -------
    Hypothesis
        Kinematic or static.

    Raises
    ------
    UnknownChoice
        Another name.

    Examples
    --------
    >>> hypothesis_named("static").name
    'STATIC'
    """
    try:
        return Hypothesis(name)
    except ValueError:
        known = ", ".join(repr(choice.value) for choice in Hypothesis)
        raise UnknownChoice(f"hypothesis = {name!r}", allowed=f"allowed: {known}",
                            remedy="Name one of the two hypotheses.") from None


def common_shape(given: dict[str, NDArray[Any]]) -> tuple[int, ...]:
    """Shape that all arguments broadcast to.

    Parameters
    ----------
    given : dict
        Arrays by name [any unit].

    Returns
    -------
    tuple of int
        Their common shape.

    Raises
    ------
    ArrayNotUsable
        There is none.

    Notes
    -----
    Source: NumPy's rules.
    """
    shapes = {array.shape for array in given.values() if array.shape}
    if len(shapes) < 2:
        return shapes.pop() if shapes else ()
    import numpy as np

    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        found = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.shape)
        raise ArrayNotUsable(f"shapes {found}", allowed="needed: shapes that broadcast together",
                             remedy="Insert axes of length 1, for example D33[:, None] with Dr33.") from None


def require_place(out: object, shape: tuple[int, ...]) -> Array:
    """Check an array that is to take the result.

    Parameters
    ----------
    out : object
        What was given.
    shape : tuple of int
        Shape of the result.

    Returns
    -------
    (...) array
        The same object [-].

    Raises
    ------
    ArrayNotUsable
        Not a writable float64 array of that shape.

    Notes
    -----
    Source: the contract of a ufunc, without its casting: six digits kept of sixteen would be a wrong number.
    """
    import numpy as np

    def refuse(found: str, allowed: str) -> ArrayNotUsable:
        return ArrayNotUsable(f"out {found}", allowed=f"needed: {allowed}",
                              remedy=f"Make it with np.empty({shape}), or leave out away.")

    if not isinstance(out, np.ndarray) or isinstance(out, np.ma.MaskedArray):
        raise refuse(f"is a {type(out).__name__}", "a NumPy array")
    if out.dtype != np.float64 or not out.dtype.isnative:
        raise refuse(f"holds {out.dtype.str}", "float64 in the byte order of this machine")
    if out.shape != shape:
        raise refuse(f"has shape {out.shape}", f"shape {shape}")
    if not out.flags.writeable:
        raise refuse("is read only", "an array that may be written to")
    return out


@dataclass(frozen=True, slots=True)
class _Interval:
    """What an argument may be, and how another value is refused; a comparison with NaN is false."""

    holds: Callable[[Any], Mask]
    refusal: type[FabricOutOfRange | ValueOutOfRange]
    allowed: str


INTERVALS = {
    "D33": _Interval(lambda d: (d >= -1) & (d <= 2), FabricOutOfRange, "-1 <= D33 <= 2 (E(n) would be negative)"),
    "Dr33": _Interval(lambda dr: (dr > -1) & (dr < 2), FabricOutOfRange,
                      "-1 < Dr33 < 2 (the branch length would not be positive)"),
    "poisson_ratio": _Interval(lambda nu: (nu >= 0) & (nu <= 0.5), ValueOutOfRange, "0 <= poisson_ratio <= 0.5"),
    "stress_ratio": _Interval(lambda ratio: (ratio > 0) & (ratio < math.inf), ValueOutOfRange,
                              "0 < stress_ratio < inf"),
    "friction_coefficient": _Interval(lambda mu: (mu >= 0) & (mu < math.inf), ValueOutOfRange,
                                      "0 <= friction_coefficient < inf"),
}
"""By the name of the argument, in the order in which they are looked at."""


def require_range(given: dict[str, NDArray[Any]]) -> None:
    """Refuse the first element outside its interval.

    Parameters
    ----------
    given : dict
        Some of D33, Dr33, poisson_ratio, stress_ratio, friction_coefficient, (...) arrays [-].

    Returns
    -------
    None

    Raises
    ------
    FabricOutOfRange
        Of D33 or Dr33.
    ValueOutOfRange
        Of another argument.

    Notes
    -----
    Source: E and W positive; the law of the contacts.
    """
    import numpy as np

    for name, interval in INTERVALS.items():
        if name not in given or (admissible := interval.holds(given[name])).all():
            continue
        index = tuple(int(i) for i in np.unravel_index(int(np.argmin(admissible)), admissible.shape))
        where = f"[{', '.join(map(str, index))}]" if index else ""
        raise interval.refusal(f"{name}{where} = {given[name][index].item()!r}", allowed=f"allowed {interval.allowed}",
                               remedy=f"Give every {name} inside the interval.")


def in_range(given: dict[str, NDArray[Any]]) -> Mask:
    """Which elements have every argument inside its interval.

    Parameters
    ----------
    given : dict
        As for :func:`require_range`, (...) arrays [-].

    Returns
    -------
    (...) array of bool
        One entry an element [-].

    Notes
    -----
    Source: :func:`require_range`.
    """
    inside: Mask = reduce(and_, (INTERVALS[name].holds(array) for name, array in given.items()))
    return inside


def is_inside(name: str, argument: NDArray[Any]) -> bool:
    """Whether all of an argument is inside its interval; quick for a single value.

    Parameters
    ----------
    name : str
        As for :func:`require_range`.
    argument : (...) array
        Real numbers [-].

    Returns
    -------
    bool
        False for NaN.

    Notes
    -----
    Source: :func:`require_range`.

    Examples
    --------
    >>> import numpy as np
    >>> is_inside("stress_ratio", np.array(2.0)), is_inside("stress_ratio", np.array([2.0, 0.0]))
    (True, False)
    """
    holds = INTERVALS[name].holds
    return bool(holds(argument).all() if argument.ndim else holds(argument.item()))


def require_sticking(D33: Array, stress_ratio: Array, friction: Array, index: Index, size: int) -> None:
    """Refuse the first element whose contacts slide somewhere; exact tangency is no sliding.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        P2 coefficient of the contact normals, sigma33/sigma11 and friction of some elements [-].
    index : (n,) array of int
        Which elements these are, and ``size`` of how many [-].
    size : int
        Number of all elements [-].

    Returns
    -------
    None

    Raises
    ------
    ComplianceInfinite
        Some contacts slide, so that they do not resist.

    Notes
    -----
    Source: Figure 1(b) with k_r = 0 over a range of directions.
    """
    import numpy as np

    from granular.loading import Loading
    from granular.routes.slip_geometry_array import slides

    sliding = slides(D33, stress_ratio, friction)
    if not sliding.any():
        return
    first = int(np.argmax(sliding))
    try:
        Loading.of_ratio(stress_ratio[first].item(), friction=friction[first].item()).require_finite_compliance(
            D33[first].item())
    except ComplianceInfinite as refusal:
        raise ComplianceInfinite(f"{refusal.found}, element {index[first]} of {size}", allowed=refusal.allowed,
                                 remedy='Say kinetic=False or leave friction_coefficient out there, or use '
                                 'hypothesis="kinematic".') from None
