"""Directions and weights as they are given: read, checked, made unit vectors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import ArrayNotUsable, DirectionNotUnit, NotFinite, ValueOutOfRange

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

TOLERANCE = 1e-6
"""Lengths up to this far from 1 are those of unit vectors written with seven digits [-]."""


def read_directions(directions: ArrayLike, *, normalise: bool = False, first: int = 0) -> Array:
    """Read directions, and divide each by its length.

    Parameters
    ----------
    directions : (n, 3) array
        One direction a row [-]; n and -n are the same.
    normalise : bool
        Whether lengths may be other than 1.
    first : int
        Number of the first row, for messages [-].

    Returns
    -------
    (n, 3) array
        Unit vectors [-].

    Raises
    ------
    ArrayNotUsable
        No real numbers, or another shape.
    NotFinite
        A component is NaN or infinite.
    DirectionNotUnit
        A zero vector, or a length off 1 by more than 1e-6 and ``normalise`` not given.

    Notes
    -----
    Accuracy: to rounding. Source: the format of contact lists.

    Examples
    --------
    >>> read_directions([[0.0, 3.0, 4.0]], normalise=True).tolist()
    [[0.0, 0.6, 0.8]]
    """
    import numpy as np

    given = real_array(directions, "directions")
    if given.ndim != 2 or given.shape[1] != 3:
        raise ArrayNotUsable(f"directions of shape {given.shape}", allowed="allowed (n, 3)",
                             remedy="Give one direction a row, with its three components.")
    sound = np.isfinite(given).all(axis=1)
    if not sound.all():
        row = int(np.argmin(sound))
        raise NotFinite(f"direction {first + row} = {given[row].tolist()}", allowed="allowed finite components",
                        remedy="Leave the row out, or mend it.", more=int(np.sum(~sound)) - 1)
    largest = np.abs(given).max(axis=1, initial=0.0)
    scaled = given / np.where(largest > 0, largest, 1.0)[:, None]  # squares of what is given may overflow
    length = np.sqrt(np.einsum("ij,ij->i", scaled, scaled))
    with np.errstate(over="ignore"):
        whole = length * largest
    off = largest == 0 if normalise else ~(np.abs(whole - 1) <= TOLERANCE)
    if off.any():
        row = int(np.argmax(off))
        raise DirectionNotUnit(
            f"direction {first + row} = {given[row].tolist()} has the length {whole[row]:.9g}",
            allowed="allowed any length but 0" if normalise else f"allowed 1 within {TOLERANCE:g}",
            remedy="Leave the row out." if largest[row] == 0 else "Divide by the length, or give normalise=True.",
            more=int(np.sum(off)) - 1)
    unit: Array = scaled / length[:, None]
    return unit


def read_weights(weights: ArrayLike | None, count: int, *, first: int = 0) -> Array:
    """Read weights, one for each direction.

    Parameters
    ----------
    weights : (n,) array or None
        Not negative [any unit]; 1 for each when left out.
    count : int
        Number of directions [-].
    first : int
        Number of the first one, for messages [-].

    Returns
    -------
    (n,) array
        As floats [same unit].

    Raises
    ------
    ArrayNotUsable
        No real numbers, or another number of them.
    NotFinite
        One is NaN or infinite.
    ValueOutOfRange
        One is negative.

    Notes
    -----
    Source: a weight says how often a direction counts.

    Examples
    --------
    >>> read_weights(None, 2).tolist()
    [1.0, 1.0]
    """
    import numpy as np

    if weights is None:
        return np.ones(count)
    given = real_array(weights, "weights")
    if given.shape != (count,):
        raise ArrayNotUsable(f"weights of shape {given.shape} with {count} directions", allowed=f"allowed ({count},)",
                             remedy="Give one weight for each direction.")
    if not (sound := np.isfinite(given)).all():
        place = int(np.argmin(sound))
        raise NotFinite(f"weight {first + place} = {given[place]}", allowed="allowed finite weights",
                        remedy="Leave the direction out, or mend its weight.", more=int(np.sum(~sound)) - 1)
    if (given < 0).any():
        place = int(np.argmax(given < 0))
        raise ValueOutOfRange(f"weight {first + place} = {given[place]:g}", allowed="allowed weights >= 0",
                              remedy="Leave the direction out, or mend its weight.", more=int(np.sum(given < 0)) - 1)
    return given


def real_array(values: ArrayLike, name: str) -> Array:
    """Read real numbers as an array of floats.

    Parameters
    ----------
    values : array_like
        Integers or floats [any unit].
    name : str
        For messages.

    Returns
    -------
    (...) array
        Floats [same unit].

    Raises
    ------
    ArrayNotUsable
        Text, complex numbers, truth values, or rows of different length.

    Notes
    -----
    Source: arrays as NumPy reads them.

    Examples
    --------
    >>> real_array([1, 2], "weights").tolist()
    [1.0, 2.0]
    """
    import numpy as np

    try:
        given = np.asarray(values)
    except ValueError:
        given = np.empty(0, dtype=object)
    if given.dtype.kind not in "iuf":
        raise ArrayNotUsable(f"{name} that are no array of real numbers", allowed="allowed integers and floats",
                             remedy="Give numbers, in rows of equal length.")
    return given.astype(float)


def read_axis(axis: ArrayLike) -> Array:
    """Read one direction of any length.

    Parameters
    ----------
    axis : (3,) array
        The direction [any unit].

    Returns
    -------
    (3,) array
        Unit vector [-].

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit
        As for directions; a zero vector is refused.

    Notes
    -----
    Source: an axis has no length.

    Examples
    --------
    >>> read_axis([0, 0, 2]).tolist()
    [0.0, 0.0, 1.0]
    """
    given = real_array(axis, "axis")
    if given.shape != (3,):
        raise ArrayNotUsable(f"axis of shape {given.shape}", allowed="allowed (3,)", remedy="Give three components.")
    unit: Array = read_directions(given[None, :], normalise=True)[0]
    return unit
