"""Contact lists: the sum of eq. (1) against reading its arrays, and memory of a streamed file; printed as ratios."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from granular.contacts.kernels import stiffness_sum

pytestmark = pytest.mark.benchmark

CONTACTS = 10_000_000
CHUNK = 1 << 20
ROUNDS = 31
AGREEMENT = 1e-12
"""Of two orders of ten million terms of one sign, each rounded to 1e-16."""


def contacts(size: int, rng: np.random.Generator) -> np.ndarray:
    """Eight arrays: branch, normal, kn, ks."""
    rows = np.empty((8, size))
    for start in range(0, size, CHUNK):
        part = rows[:, start:start + CHUNK]
        normal = rng.normal(size=(3, part.shape[1]))
        normal /= np.sqrt(np.sum(normal**2, axis=0))
        part[:3] = 2e-3 * normal + 1e-4 * rng.normal(size=normal.shape)
        part[3:6] = normal
        part[6] = rng.uniform(1e5, 2e5, part.shape[1])
        part[7] = rng.uniform(0.6, 1.0, part.shape[1]) * part[6]
    return rows


def seconds(call: Callable[[], object]) -> float:
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def test_sum_against_reading_its_arrays() -> None:
    """Interleaved rounds on one thread; fails only when the two ways of summing differ."""
    numba = pytest.importorskip("numba")
    rows = contacts(CONTACTS, np.random.default_rng(1))

    @numba.njit(fastmath={"reassoc", "contract", "nsz"})
    def read(a, b, c, d, e, f, g, h):
        total = 0.0
        for k in range(a.size):
            total += a[k] + b[k] + c[k] + d[k] + e[k] + f[k] + g[k] + h[k]
        return total

    calls = {"read": lambda: read(*rows),
             "compiled": lambda: stiffness_sum(rows[:3], rows[3:6], rows[6], rows[7], compiled=True)}
    for call in calls.values():
        call()
    times = [{name: seconds(call) for name, call in calls.items()} for _ in range(ROUNDS)]
    ratios = sorted(one["compiled"] / one["read"] for one in times)

    def plain() -> object:
        return stiffness_sum(rows[:3], rows[3:6], rows[6], rows[7], compiled=False)

    tracemalloc.start()
    sums = [calls["compiled"](), plain()]
    extra = tracemalloc.get_traced_memory()[1] / rows.nbytes
    tracemalloc.stop()
    least = {name: min(one[name] for one in times) for name in calls}
    print(f"\nsum of {CONTACTS:.0e} contacts over reading their 8 arrays, one thread: median "
          f"{statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f}), "
          f"least over least {least['compiled'] / least['read']:.2f}; "
          f"NumPy {seconds(plain) / least['read']:.1f}; extra memory {extra:.2%} of the arrays")
    assert np.abs(sums[0] - sums[1]).max() < AGREEMENT * np.abs(sums[0]).max()


MEASURE = """
import sys
import pyarrow.parquet
from granular.contacts.example import example_path
from granular.contacts.summary import summarise
summarise(example_path(), volume=1.0)
def memory(name):
    return next(1024 * int(line.split()[1]) for line in open("/proc/self/status") if line.startswith(name))
before = memory("VmRSS")
found = summarise(sys.argv[1], volume=1.0)
print(found.contacts, memory("VmHWM") - before, memory("VmHWM"))
"""


def test_memory_of_a_streamed_parquet_file(tmp_path: Path) -> None:
    """Peak memory beyond program and libraries, over the size of the file; fails only when contacts are lost."""
    pyarrow, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    names = ["l1", "l2", "l3", "n1", "n2", "n3", "kn", "ks", "R1", "R2", "fn", "fs1", "fs2", "fs3", "id1", "id2"]
    kinds = [pyarrow.int64() if name.startswith("id") else pyarrow.float64() for name in names]
    schema, path = pyarrow.schema(list(zip(names, kinds, strict=True))), tmp_path / "contacts.parquet"
    rng, grains = np.random.default_rng(2), CONTACTS // 3
    with parquet.ParquetWriter(path, schema) as writer:
        for start in range(0, CONTACTS, CHUNK):
            rows = contacts(min(CHUNK, CONTACTS - start), rng)
            numbers = np.arange(start, start + rows.shape[1])
            first = numbers % grains
            columns = [*rows, *(1.5e-3 + 1e-6 * rng.random((2, numbers.size))), *rng.random((4, numbers.size)), first,
                       (first + 1 + numbers // grains) % grains]
            writer.write_table(pyarrow.table(dict(zip(names, columns, strict=True)), schema=schema))
    start = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", MEASURE, str(path)], capture_output=True, text=True, check=True)
    took = time.perf_counter() - start

    def decode() -> None:
        for _ in parquet.ParquetFile(path, pre_buffer=False, buffer_size=1 << 18).iter_batches(batch_size=1 << 15):
            pass

    found, peak, whole = map(int, done.stdout.split())
    print(f"\nParquet file of {CONTACTS:.0e} contacts, {path.stat().st_size / 2**20:.0f} MiB: peak memory "
          f"{peak / path.stat().st_size:.3f} of the file, {whole / path.stat().st_size:.3f} with program and "
          f"libraries; whole summary {took / seconds(decode):.1f} times decoding")
    assert found == CONTACTS
