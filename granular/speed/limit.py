"""The limit of the machine: a loop that reads the same arrays and writes as many numbers, without arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def moved(inputs: tuple[Array, ...], out: Array) -> Callable[[], object]:
    """What a kernel does to memory, and nothing else.

    Parameters
    ----------
    inputs : tuple of 2 to 4 (n,) arrays
        What is read [-].
    out : (n, 6) array
        What is written, one element after another [-].

    Returns
    -------
    callable
        Does it once; compiled where numba is installed, else six copies by NumPy.

    Notes
    -----
    Source: the kernels of ``granular.batch``, without their arithmetic.
    """
    from granular.batch.engines import compiler_installed

    if compiler_installed():
        loop, flat = _compiled()[len(inputs)], out.reshape(-1)
        return lambda: loop(*inputs, flat)

    def copies() -> None:
        for column in range(6):
            out[:, column] = inputs[column % len(inputs)]

    return copies


def _two(a: Array, b: Array, out: Array) -> None:
    for i in range(a.size):
        x, y = a[i], b[i]
        out[6 * i], out[6 * i + 1], out[6 * i + 2] = x, y, x
        out[6 * i + 3], out[6 * i + 4], out[6 * i + 5] = y, x, y


def _three(a: Array, b: Array, c: Array, out: Array) -> None:
    for i in range(a.size):
        x, y, z = a[i], b[i], c[i]
        out[6 * i], out[6 * i + 1], out[6 * i + 2] = x, y, z
        out[6 * i + 3], out[6 * i + 4], out[6 * i + 5] = x, y, z


def _four(a: Array, b: Array, c: Array, d: Array, out: Array) -> None:
    for i in range(a.size):
        x, y, z, w = a[i], b[i], c[i], d[i]
        out[6 * i], out[6 * i + 1], out[6 * i + 2] = x, y, z
        out[6 * i + 3], out[6 * i + 4], out[6 * i + 5] = w, x, y


@lru_cache(maxsize=1)
def _compiled() -> dict[int, Callable[..., None]]:
    import numba

    made: dict[int, Callable[..., None]] = {}
    for count, loop in ((2, _two), (3, _three), (4, _four)):
        made[count] = numba.njit(nogil=True)(loop)
    return made
