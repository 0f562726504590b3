"""What a batch kernel is: a block function in two forms, what it reads, and how accurate it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

BlockFunction: TypeAlias = Callable[..., int]
"""As the package describes: (n,) inputs, tables, (6 n,) out, and for a loop whether results go past the caches; returns
the number of elements left as NaN."""


@dataclass(frozen=True, slots=True, eq=False)
class Kernel:
    """One question that is answered for blocks of elements.

    Attributes
    ----------
    name : str
        What it computes, for messages and tables.
    inputs : tuple of str
        Arguments of ``axial_stiffness`` that a block reads, in order.
    relative_error : float
        Bound for every component of every element that is served [-].
    array : callable
        Loads the block function that works on whole arrays.
    loop : callable
        Loads the block function as a loop that numba can compile; it runs uncompiled too.
    tables : tuple of array
        Contiguous float64 arrays that every call takes after the inputs [-].
    helpers : callable
        Loads the functions that the loop calls and that a compiler has to know, each after those that it calls.
    exact_helpers : callable
        Loads those of them whose roundings must stay as they are written, because they find what rounding took.
    """

    name: str
    inputs: tuple[str, ...]
    relative_error: float
    array: Callable[[], BlockFunction]
    loop: Callable[[], BlockFunction]
    tables: tuple[NDArray[np.float64], ...] = ()
    helpers: Callable[[], tuple[Callable[..., object], ...]] = tuple
    exact_helpers: Callable[[], tuple[Callable[..., object], ...]] = tuple
