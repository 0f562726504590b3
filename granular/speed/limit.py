"""The limits of the machine: moving the same arrays without arithmetic, and as much arithmetic without memory."""

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
    out : (n, 6) or (n, 36) array
        What is written, one element after another: components, or also their slopes [-].

    Returns
    -------
    callable
        Does it once; compiled where numba is installed, else six copies by NumPy.

    Notes
    -----
    Source: the kernels of ``granular.batch``, without their arithmetic.
    """
    from granular.batch.engines import compiler_installed

    width = out.shape[-1]
    if compiler_installed():
        loop, flat = _compiled()[len(inputs) if width == COMPONENTS else 0], out.reshape(-1)
        return lambda: loop(*inputs, flat) if width == COMPONENTS else loop(inputs, width, flat)

    def copies() -> None:
        for column in range(width):
            out[:, column] = inputs[column % len(inputs)]

    return copies


def moved_past(inputs: tuple[Array, ...], out: Array) -> Callable[[], object]:
    """The same, but results go past the caches, straight to memory: they are not read before they are written.

    Parameters
    ----------
    inputs : tuple of 2 to 4 (n,) arrays
        What is read [-].
    out : (n, 6) or (n, 36) array
        What is written [-], as fresh memory begins, at a multiple of 16 bytes.

    Returns
    -------
    callable
        Does it once; needs numba.

    Raises
    ------
    ModuleNotFoundError
        numba is not installed.

    Notes
    -----
    Source: ``granular.batch.compiled_rows``.
    """
    width, flat = out.shape[-1], out.reshape(-1)
    loop, columns = _past(width), flat[:width * SPACING].copy()
    return lambda: loop(inputs, columns, flat)


@lru_cache(maxsize=2)
def _past(width: int) -> Callable[..., None]:
    import numba

    from granular.batch.compiled_rows import row_functions

    write_rows = row_functions()["write_rows"]

    def loop(inputs: tuple[Array, ...], columns: Array, out: Array) -> None:
        for start in range(0, inputs[0].size, ROWS):
            stop = min(start + ROWS, inputs[0].size)
            for i in range(stop - start):
                total = 0.0
                for given in inputs:
                    total += given[start:stop][i]
                columns[i] = total
            write_rows(columns, width, SPACING, out[width * start:width * stop], True)

    made: Callable[..., None] = numba.njit(nogil=True)(loop)
    return made


ROWS, SPACING = 32, 40
"""Rows that are written together, and numbers from one of their columns to the next [-]."""


def _wide(inputs: tuple[Array, ...], width: int, out: Array) -> None:
    for i in range(inputs[0].size):
        total = 0.0
        for given in inputs:
            total += given[i]
        row = out[width * i:width * (i + 1)]
        for k in range(width):
            row[k] = total


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
    for count, loop in ((0, _wide), (2, _two), (3, _three), (4, _four)):
        made[count] = numba.njit(nogil=True)(loop)
    return made


COMPONENTS = 6
"""Numbers that are written for each element [-]."""

CHAIN, LANES = 54, 512
"""Operations on a number in one pass, and numbers that stay in the nearest cache [-]."""


def computed(elements: int, operations: int, *, fused: bool) -> Callable[[], object]:
    """As many additions and multiplications as a kernel has, on numbers that never leave the nearest cache.

    Parameters
    ----------
    elements : int
        How many elements the kernel does [-].
    operations : int
        Additions and multiplications of each [-].
    fused : bool
        Whether a multiplication and an addition may be one operation.

    Returns
    -------
    callable
        Does them once; needs numba.

    Raises
    ------
    ModuleNotFoundError
        numba is not installed.

    Notes
    -----
    Six polynomials of two numbers side by side, none waiting for another, as in the kernels: as many as a processor has
    registers for. Accuracy: whole passes of 54 operations on 512 numbers. Source: this machine.
    """
    import numpy as np

    passes = max(1, round(elements * operations / (CHAIN * LANES)))
    loop = _busy(fused=fused)
    numbers, sums = np.linspace(0.1, 0.9, LANES), np.zeros(LANES)
    return lambda: loop(numbers, sums, passes)


def _chains(numbers: Array, sums: Array, passes: int) -> None:
    half = numbers.size // 2
    for _ in range(passes):
        for i in range(half):
            x, y = numbers[i], numbers[i + half]
            a, b, c, d, e, f = 0.1 * x + 1.1, 0.2 * x + 1.2, 0.3 * x + 1.3, 0.4 * x + 1.4, 0.5 * x + 1.5, 0.6 * x + 1.6
            p, q, r, s, t, u = 0.1 * y + 1.1, 0.2 * y + 1.2, 0.3 * y + 1.3, 0.4 * y + 1.4, 0.5 * y + 1.5, 0.6 * y + 1.6
            a, b, c, d, e, f = a * x + 2.1, b * x + 2.2, c * x + 2.3, d * x + 2.4, e * x + 2.5, f * x + 2.6
            p, q, r, s, t, u = p * y + 2.1, q * y + 2.2, r * y + 2.3, s * y + 2.4, t * y + 2.5, u * y + 2.6
            a, b, c, d, e, f = a * x + 3.1, b * x + 3.2, c * x + 3.3, d * x + 3.4, e * x + 3.5, f * x + 3.6
            p, q, r, s, t, u = p * y + 3.1, q * y + 3.2, r * y + 3.3, s * y + 3.4, t * y + 3.5, u * y + 3.6
            a, b, c, d, e, f = a * x + 4.1, b * x + 4.2, c * x + 4.3, d * x + 4.4, e * x + 4.5, f * x + 4.6
            p, q, r, s, t, u = p * y + 4.1, q * y + 4.2, r * y + 4.3, s * y + 4.4, t * y + 4.5, u * y + 4.6
            sums[i] += (a + b) + (c + d) + (e + f)
            sums[i + half] += (p + q) + (r + s) + (t + u)


@lru_cache(maxsize=2)
def _busy(*, fused: bool) -> Callable[..., None]:
    import numba

    made: Callable[..., None] = numba.njit(nogil=True, fastmath={"contract"} if fused else False)(_chains)
    return made
