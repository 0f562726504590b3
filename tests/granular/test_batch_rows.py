"""Results on their way from columns to rows: woven by a compiler, in plain Python, and past the caches."""

from functools import lru_cache

import numpy as np
import pytest

from granular.batch import evaluation
from granular.batch.compiled_rows import row_functions
from granular.batch.constant import KINEMATIC
from granular.batch.evaluation import evaluate_batch
from granular.batch.kinetic import KINEMATIC as KINETIC
from granular.generated import rows

numba = pytest.importorskip("numba")
GUARD = -7.25


@lru_cache
def woven(width, spacing):
    """The compiled form for one kind of row; its numbers have to stand in the code that calls it."""
    known = {**row_functions()}
    exec(f"def write(columns, out, streamed):\n    write_rows(columns, {width}, {spacing}, out, streamed)\n", known)
    return numba.njit(known["write"])


def place(size, bytes_off_line):
    """An array of guards that begins so many bytes after a multiple of 64."""
    whole = np.full(size + 16, GUARD)
    first = (bytes_off_line - whole.ctypes.data) % 64 // 8
    return whole[first:first + size]


@pytest.mark.parametrize(("width", "spacing"), [(6, 72), (36, 40)])
@pytest.mark.parametrize("streamed", [False, True])
def test_woven_rows_are_the_plain_ones(width, spacing, streamed):
    # an element lost at either end, columns exchanged, a store past the end, or one that faults where it is not aligned
    columns = np.arange(float(width * spacing))
    for count in range(spacing - 7):
        for off_line in (0, 16, 32, 48) if streamed else (0, 8, 16, 24, 56):
            found, expected = place(width * count + 4, off_line), place(width * count + 4, off_line)
            woven(width, spacing)(columns, found[:width * count], streamed)
            rows.write_rows(columns, width, spacing, expected[:width * count], streamed)
            np.testing.assert_array_equal(found, expected)
            assert (found[width * count:] == GUARD).all()


def test_rows_are_read_back_as_plain_ones():
    # an element lost at the end, columns exchanged, or the factor of a neighbour
    known = {**row_functions()}
    exec("def read(lines, where, factor, columns):\n    read_rows(lines, 6, where, factor, columns, 72)\n", known)
    read, rng = numba.njit(known["read"]), np.random.default_rng(4)
    lines = rng.uniform(1, 2, 6 * 50)
    for count in range(65):
        where, factor = rng.integers(0, 50, count, dtype=np.uint32), rng.uniform(1, 2, count)
        found, expected = np.full(6 * 72, GUARD), np.full(6 * 72, GUARD)
        read(lines, where, factor, found)
        rows.read_rows(lines, 6, where, factor, expected, 72)
        np.testing.assert_array_equal(found, expected)


def test_a_part_is_a_view():
    # a copy, a view that begins elsewhere, or one that counts its elements in bytes
    known = {**row_functions()}
    exec("def use(whole, first, last):\n    part = part_of(whole, first, last)\n    part[:] = 7\n"
         "    return part.size\n", known)
    use = numba.njit(known["use"])
    for kind in (np.float64, np.uint16, np.int64):
        whole, expected = np.arange(9, dtype=kind), np.arange(9, dtype=kind)
        rows.part_of(expected, 2, 5)[:] = 7
        assert use(whole, 2, 5) == 3
        np.testing.assert_array_equal(whole, expected)


def test_scratch_holds_what_is_put_there():
    # scratch of another size or type, or that two places of a loop share
    known = {**row_functions()}
    exec("def use(x):\n    one, other = scratch_of(40), scratch_of(24)\n    one[:], other[:] = x, 1.0\n"
         "    return one.sum(), other.sum(), one.size\n", known)
    assert numba.njit(known["use"])(3.0) == (120.0, 24.0, 40)
    assert rows.scratch_of(5).shape == (5,)


@pytest.mark.parametrize("kernel", [KINEMATIC, KINETIC], ids=lambda kernel: kernel.name)
@pytest.mark.parametrize("off_line", [0, 8, 16, 48])
def test_results_past_the_caches_have_the_same_bits(kernel, off_line, monkeypatch):
    # a row that stays where it was, in blocks and passes that are not full, or a store where memory is not aligned
    size = 2 * evaluation.BLOCK["compiled"] + 77
    rng = np.random.default_rng(8)
    drawn = {"D33": rng.uniform(-1, 2, size), "Dr33": rng.uniform(-0.9, 1.9, size),
             "stress_ratio": rng.uniform(0.4, 2.5, size), "poisson_ratio": rng.uniform(0, 0.5, size)}
    inputs = [drawn[name] for name in kernel.inputs]
    inputs[0][[0, 5, size - 1]] = [np.nan, 3.0, -2.0]
    out, expected = place(6 * size, off_line).reshape(size, 6), np.empty((size, 6))
    unserved = evaluate_batch(kernel, inputs, expected, engine="numpy")
    monkeypatch.setattr(evaluation, "STREAMED", 0)
    for threads in (1, 2):
        out[:] = GUARD
        left = evaluate_batch(kernel, inputs, out, engine="compiled", threads=threads)
        np.testing.assert_array_equal(left, unserved)
        np.testing.assert_array_equal(out, expected)
