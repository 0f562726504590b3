"""Contact lists: the sum of eq. (1) against reading its arrays, and a streamed file against its size."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import tracemalloc
import weakref
from collections.abc import Callable, Iterator
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

from granular.speed.interleaved import Way

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

CHUNK = 1 << 20
"""Contacts that are drawn at a time."""

BUFFER, BATCH = 1 << 18, 1 << 15
"""Bytes and rows that are decoded at a time."""

FLOATS = ("l1", "l2", "l3", "n1", "n2", "n3", "kn", "ks", "R1", "R2", "fn", "fs1", "fs2", "fs3")
GRAINS = ("id1", "id2")

SUMMARY = """
import sys
import pyarrow.parquet
from granular.contacts.example import example_path
from granular.contacts.summary import summarise
summarise(example_path(), volume=1.0)
def memory(name):
    return next(1024 * int(line.split()[1]) for line in open("/proc/self/status") if line.startswith(name))
before = memory("VmRSS")
summarise(sys.argv[1], volume=1.0)
print(memory("VmHWM") - before)
"""
"""A process of its own, which has loaded everything before it looks at its memory."""


def drawn(size: int, seed: int = 1) -> Array:
    """Random contacts: branch, normal, kn, ks.

    Parameters
    ----------
    size : int
        How many [-].
    seed : int
        Start of NumPy's default generator.

    Returns
    -------
    (8, n) array
        l [m], n [-], kn and ks [N/m].

    Examples
    --------
    >>> drawn(5).shape
    (8, 5)
    """
    import numpy as np

    rows, rng = np.empty((8, size)), np.random.default_rng(seed)
    for start in range(0, size, CHUNK):
        part = rows[:, start:start + CHUNK]
        normal = rng.normal(size=(3, part.shape[1]))
        normal /= np.sqrt(np.sum(normal**2, axis=0))
        part[:3] = 2e-3 * normal + 1e-4 * rng.normal(size=normal.shape)
        part[3:6] = normal
        part[6] = rng.uniform(1e5, 2e5, part.shape[1])
        part[7] = rng.uniform(0.6, 1.0, part.shape[1]) * part[6]
    return rows


def sums(size: int) -> list[Way]:
    """The sum of eq. (1) over contacts that are in memory, by each engine; the error is the distance of the two.

    Parameters
    ----------
    size : int
        Contacts [-].

    Returns
    -------
    list of Way
        Reading the eight arrays, then summing.

    Raises
    ------
    ModuleNotFoundError
        numba is not installed.
    """
    from granular.contacts.kernels import stiffness_sum

    rows = drawn(size)
    compiled, plain = (partial(stiffness_sum, rows[:3], rows[3:6], rows[6], rows[7], compiled=choice)
                       for choice in (True, False))

    @lru_cache(maxsize=1)
    def apart() -> float:
        found, other = compiled(), plain()
        return float(abs(found - other).max() / abs(other).max())

    return [Way(name="reading their eight arrays", elements=size, call=_reading(rows)),
            Way(name="sum of eq. (1), compiled", elements=size, call=compiled, wanted=1.3, error=apart,
                memory=partial(_beside, compiled, rows.nbytes), memory_wanted=0.02),
            Way(name="sum of eq. (1), numpy", elements=size, call=plain, error=apart,
                memory=partial(_beside, plain, rows.nbytes), memory_wanted=0.02)]


def _reading(rows: Array) -> Callable[[], object]:
    import numba

    loop = numba.njit(nogil=True, fastmath={"reassoc", "contract", "nsz"})(_read)
    return lambda: loop(*rows)


def _read(a: Array, b: Array, c: Array, d: Array, e: Array, f: Array, g: Array, h: Array) -> float:
    total = 0.0
    for k in range(a.size):
        total += a[k] + b[k] + c[k] + d[k] + e[k] + f[k] + g[k] + h[k]
    return total


def _beside(call: Callable[[], object], size: int) -> float:
    """Most memory that Python and NumPy take during a call, over the size of the arrays."""
    tracemalloc.start()
    try:
        call()
        return tracemalloc.get_traced_memory()[1] / size
    finally:
        tracemalloc.stop()


def streamed(size: int) -> list[Way]:
    """The whole summary of a Parquet file, with the peak of memory beyond program and libraries.

    Parameters
    ----------
    size : int
        Contacts [-].

    Returns
    -------
    list of Way
        Decoding the file, then its summary.

    Raises
    ------
    ModuleNotFoundError
        pyarrow is not installed.
    """
    from pyarrow import parquet

    from granular.contacts.summary import summarise

    folder = tempfile.TemporaryDirectory(prefix="granular-speed-")
    path = Path(folder.name) / "contacts.parquet"
    _write(path, size)

    def decode() -> None:
        for _ in parquet.ParquetFile(path, pre_buffer=False, buffer_size=BUFFER).iter_batches(batch_size=BATCH):
            pass

    def peak() -> float:
        done = subprocess.run([sys.executable, "-c", SUMMARY, str(path)], capture_output=True, text=True, check=True)
        return int(done.stdout) / path.stat().st_size

    def summary() -> object:
        return summarise(path, volume=1.0)

    weakref.finalize(summary, folder.cleanup)
    memory = peak if Path("/proc/self/status").exists() else None
    return [Way(name="decoding the Parquet file", elements=size, call=decode),
            Way(name="summary of the file", elements=size, call=summary, memory=memory, memory_wanted=0.2)]


def _write(path: Path, size: int) -> None:
    import pyarrow
    from pyarrow import parquet

    schema = pyarrow.schema([*((name, pyarrow.float64()) for name in FLOATS),
                             *((name, pyarrow.int64()) for name in GRAINS)])
    with parquet.ParquetWriter(path, schema) as writer:
        for columns in _columns(size):
            writer.write_table(pyarrow.table(dict(zip(FLOATS + GRAINS, columns, strict=True)), schema=schema))


def _columns(size: int) -> Iterator[list[NDArray[np.float64]]]:
    """A chunk of contacts after the other, as columns; every pair of grains touches once."""
    import numpy as np

    rng, grains = np.random.default_rng(2), max(size // 3, 2)
    for start in range(0, size, CHUNK):
        rows = drawn(min(CHUNK, size - start), seed=start)
        numbers = np.arange(start, start + rows.shape[1])
        first = numbers % grains
        yield [*rows, *(1.5e-3 + 1e-6 * rng.random((2, numbers.size))), *rng.random((4, numbers.size)), first,
               (first + 1 + numbers // grains) % grains]
