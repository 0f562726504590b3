"""Run a kernel over all elements of broadcast arguments: blocks, threads, and what was left unserved."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from granular.batch.blocks import block_reader, is_view
from granular.batch.engines import Engine, block_function, choose_engine
from granular.batch.kernel import Kernel

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

BLOCK = {Engine.NUMPY: 4096, Engine.COMPILED: 1 << 15, Engine.FUSED: 1 << 15}
"""Elements at a time: as many as stay in cache with what is computed from them, or with their arguments alone."""

LONG_BLOCK = 1 << 17
"""Elements at a time of a compiled loop whose arguments are single values or read where they are: blocks cost little
then, and partial slip sorts many elements together."""

SHARE = 1 << 18
"""Elements that are worth a thread of their own."""

STREAMED = 1 << 23
"""Bytes of a result from which on compiled loops write it past the caches: little of it would still be there when it is
read, and what is written through them is read from memory first."""


def evaluate_batch(kernel: Kernel, inputs: Sequence[NDArray[Any]], out: Array, *, engine: Engine | str | None = None,
                   threads: int | None = None) -> Index:
    """Fill an array with the components of every element that a kernel serves.

    Parameters
    ----------
    kernel : Kernel
        What is computed.
    inputs : sequence of (...) array
        ``kernel.inputs`` in order, real numbers of any type, broadcastable to the shape of ``out`` without its last
        axis [units of the kernel].
    out : (..., 6) array
        Contiguous float64, not overlapping the inputs; filled, with NaN in rows that are not served [-].
    engine : Engine or str, optional
        See :func:`granular.batch.engines.choose_engine`.
    threads : int, optional
        How many threads share the work, >= 1 [-]; by default as many as there are processors to use, but none that
        would have less than 2^18 elements.

    Returns
    -------
    (k,) array of int
        Elements that were not served, rising, counted in C order [-].

    Raises
    ------
    UnknownChoice
        The engine.

    Notes
    -----
    Accuracy: ``kernel.relative_error``; the same bits whatever the number of threads, and by the engines ``numpy`` and
    ``compiled``. Source: the kernel.

    Examples
    --------
    >>> import numpy as np
    >>> from granular.batch.constant import KINEMATIC
    >>> out = np.empty((3, 6))
    >>> evaluate_batch(KINEMATIC, [np.array([0.0, 0.3, 3.0]), np.zeros(1), np.full(1, 0.21)], out).tolist()
    [2]
    """
    import numpy as np

    shape = out.shape[:-1]
    flat, width = out.reshape(-1), out.shape[-1]
    size = flat.size // width
    chosen = choose_engine(kernel, size, engine)
    in_place = chosen is not Engine.NUMPY and all(argument.size == 1 or is_view(argument, shape) for argument in inputs)
    function, block = block_function(kernel, chosen), min(LONG_BLOCK if in_place else BLOCK[chosen], max(1, size))
    streamed = chosen is not Engine.NUMPY and out.nbytes >= STREAMED and out.ctypes.data % 16 == 0
    lead = int(streamed and out.ctypes.data % 32 > 0 and width % 4 > 0)  # all other rows begin where stores are fastest
    how = () if chosen is Engine.NUMPY else (streamed,)

    def work(first: int, last: int) -> list[Index]:
        readers = [block_reader(argument, shape, block) for argument in inputs]
        unserved = []
        start = first
        while start < last:
            stop = lead if start < lead else min(start + block, last)
            here = flat[width * start:width * stop]
            if function(*(read(start, stop) for read in readers), *kernel.tables, here, *how):
                unserved.append(start + np.flatnonzero(np.isnan(here[::width])))
            start = stop
        return unserved

    bounds = [(lead + first if first else 0, lead + last) for first, last in shares(size - lead, block, threads)]
    if len(bounds) == 1:
        parts = work(*bounds[0])
    else:
        from concurrent.futures import ThreadPoolExecutor

        with ThreadPoolExecutor(len(bounds)) as pool:
            parts = [part for found in pool.map(lambda pair: work(*pair), bounds) for part in found]
    return np.concatenate(parts) if parts else np.empty(0, dtype=np.intp)


def shares(size: int, block: int, threads: int | None = None) -> list[tuple[int, int]]:
    """Cut elements into one range a thread, each but the last a whole number of blocks.

    Parameters
    ----------
    size, block : int
        Number of elements, and of those evaluated at a time [-].
    threads : int, optional
        How many ranges at the most; by default one for each processor that this process may use, as long as each has
        2^18 elements [-].

    Returns
    -------
    list of tuple of 2 int
        Start and stop of each range.

    Notes
    -----
    Source: the system's list of processors.

    Examples
    --------
    >>> shares(10, 4, 2)
    [(0, 8), (8, 10)]
    """
    if threads is None:
        threads = max(1, min(processors(), size // SHARE))
    blocks = -(-size // block)
    step = max(1, -(-blocks // threads)) * block
    return [(start, min(start + step, size)) for start in range(0, max(size, 1), step)]


def processors() -> int:
    """How many processors this process may use.

    Returns
    -------
    int
        At least 1 [-].

    Notes
    -----
    Source: the operating system.
    """
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1
