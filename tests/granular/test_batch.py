"""Batches: both engines to the bit, values against exact and certified ones, blocks of any layout, threads."""

import math
import sys
from fractions import Fraction

import numpy as np
import pytest

import granular
from granular.batch import constant, engines, kinetic
from granular.batch.blocks import block_reader
from granular.batch.engines import Engine, block_function, choose_engine
from granular.batch.evaluation import BLOCK, evaluate_batch, shares
from granular.derivatives import kernels as slopes
from granular.errors import UnknownChoice
from granular.fabric import AxialFabric
from granular.generated.kinematic_constant import kinematic_constant
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified
from granular.routes.axial_kinetic_array import components

KERNELS = [constant.KINEMATIC, constant.STATIC, kinetic.KINEMATIC]
ROUNDING = Fraction(1, 2**49)
"""What all kernels declare, 16 roundings; the worst of some thousand fabrics is 6.5 (kinematic) and 12 (static)."""

CORNERS = {
    "D33": [-1.0, math.nextafter(-1, 0), 0.0, 1e-300, 0.3, math.nextafter(2, 0), 2.0],
    "Dr33": [math.nextafter(-1, 0), -1 + 1e-9, -0.3, 0.0, 2 - 1e-9, math.nextafter(2, 0)],
    "stress_ratio": [1 / 3, math.nextafter(1 / 3, 1), 0.5, 1.0, math.nextafter(1, 2), 3.0],
    "poisson_ratio": [0.0, 1e-300, 0.21, 0.5],
}


STATIC_BRANCHES = [-16 / 19, -0.3, 0.0, 1e-300, 0.9, math.nextafter(16 / 11, 0)]
"""The static kernel serves branch lengths at pole and equator within a factor 9."""


def sample(kernel, size, seed=1):
    """Every corner with every other, and as many random elements that the kernel serves."""
    rng = np.random.default_rng(seed)
    static = kernel is constant.STATIC
    edges = {**CORNERS, "Dr33": STATIC_BRANCHES} if static else CORNERS
    corners = np.array(np.meshgrid(*(edges[name] for name in kernel.inputs))).reshape(len(kernel.inputs), -1)
    branches = rng.uniform(-0.84, 1.45, size) if static else rng.uniform(-0.999, 1.999, size)
    within = {"D33": rng.uniform(-1, 2, size), "Dr33": branches,
              "stress_ratio": 3 ** rng.uniform(-0.999, 0.999, size), "poisson_ratio": rng.uniform(0, 0.5, size)}
    return [np.concatenate([edge, within[name]]) for edge, name in zip(corners, kernel.inputs, strict=True)]


def run(kernel, inputs, engine="numpy", threads=None):
    out = np.full((*np.broadcast_shapes(*(x.shape for x in inputs)), 6), 7.0)
    unserved = evaluate_batch(kernel, inputs, out, engine=engine, threads=threads)
    return out, unserved


@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)
def test_engines_give_the_same_bits(kernel):
    # a contraction to fused multiply-adds, another order of sums, or a pass of the loop that loses an element
    inputs = sample(kernel, 3000)
    by_numpy, unserved = run(kernel, inputs)
    compiled, left = run(kernel, inputs, "compiled")
    np.testing.assert_array_equal(by_numpy, compiled)
    assert unserved.size == left.size == 0
    plain = np.empty(6 * 300)
    assert kernel.loop()(*(x[-300:] for x in inputs), plain, False) == 0
    np.testing.assert_array_equal(plain.reshape(-1, 6), by_numpy[-300:])


ENDS = {"D33": (-1.0, 2.0), "Dr33": (-1.0, 2.0), "poisson_ratio": (0.0, 0.5)}


@pytest.mark.parametrize("engine", list(Engine))
def test_the_domain_ends_where_it_is_said_to(engine):
    # a product that tells the domain and is rounded to zero, overflows to the other sign, or has two negative factors
    good = {"D33": 0.3, "Dr33": -0.3, "poisson_ratio": 0.21}
    for kernel in (constant.KINEMATIC, slopes.CONSTANT):
        for name, ends in ENDS.items():
            open_ended = name == "Dr33"
            values = [value for end in ends for away in (-math.inf, math.inf)
                      for value in (math.nextafter(end, away), end)]
            values += [sign * value for sign in (1.0, -1.0) for value in (5e-324, 1e-20, 3.0, 1e100, 1e200, 1.7e308)]
            columns = {key: np.full(len(values), value) for key, value in good.items()} | {name: np.array(values)}
            out = np.empty((len(values), 6 if kernel is constant.KINEMATIC else 36))
            unserved = evaluate_batch(kernel, [columns[key] for key in kernel.inputs], out, engine=engine)
            inside = [ends[0] < value < ends[1] if open_ended else ends[0] <= value <= ends[1] for value in values]
            np.testing.assert_array_equal(unserved, np.flatnonzero(~np.array(inside)), err_msg=name)
            assert np.isfinite(out[inside]).all()


@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)
def test_what_is_not_served_is_marked(kernel):
    # an element outside the model answered, its row left half finished, or its neighbour's row lost
    good = {"D33": 0.3, "Dr33": -0.3, "stress_ratio": 1.5, "poisson_ratio": 0.21}
    outside = {"D33": [-1.1, 2.1, math.nan, math.inf], "Dr33": [-1.0, 2.0, math.nan, -math.inf],
               "stress_ratio": [0.0, -1.0, math.nan, math.inf, 1e-300, 1e300],
               "poisson_ratio": [-1e-300, 0.6, math.nan]}
    rows = [{**good, name: value} for name in kernel.inputs for value in outside[name]]
    everything = [row for bad in rows for row in (bad, good)]
    inputs = [np.array([row[name] for row in everything]) for name in kernel.inputs]
    for engine in Engine:
        out, unserved = run(kernel, inputs, engine)
        np.testing.assert_array_equal(unserved, np.arange(0, len(everything), 2))
        assert np.isnan(out[::2]).all()
        alone = np.broadcast_to(run(kernel, [x[1:2] for x in inputs])[0], out[1::2].shape)
        # fused, the two may differ by what each may be off
        np.testing.assert_allclose(out[1::2], alone, rtol=float(2 * ROUNDING) if engine is Engine.FUSED else 0)


@pytest.mark.parametrize("engine", [Engine.NUMPY, Engine.FUSED])
def test_constant_stiffness_against_exact_fractions(engine):
    # a wrong weight, digits lost where E or W vanish at an end, or by a product that is not rounded
    inputs = sample(constant.KINEMATIC, 400)
    out, _ = run(constant.KINEMATIC, inputs, engine)
    for row, (d, dr, nu) in zip(out.tolist(), zip(*(x.tolist() for x in inputs), strict=True), strict=True):
        exactly = kinematic_constant(Fraction(d), Fraction(0), Fraction(dr), Fraction(nu))
        assert all(abs(Fraction(ours) - theirs) <= ROUNDING * theirs for ours, theirs in zip(row, exactly, strict=True))


def test_kinetic_stiffness_against_certified_values():
    # a polynomial cut too early, a cube root that has not converged at an end of its range, a contrast of wrong sign,
    # or a cube root whose correction is lost where products are not rounded
    inputs = [np.concatenate([x[:-150][::11], x[-150:]]) for x in sample(kinetic.KINEMATIC, 150)]
    both = np.hstack([run(kinetic.KINEMATIC, inputs)[0], run(kinetic.KINEMATIC, inputs, Engine.FUSED)[0]])
    for row, (d, dr, ratio, nu) in zip(both.tolist(), zip(*(x.tolist() for x in inputs), strict=True), strict=True):
        balls = certified.enclose(AxialFabric(D33=d, Dr33=dr), poisson_ratio=nu, hypothesis=Hypothesis.KINEMATIC,
                                  loading=Loading.of_ratio(ratio))
        assert all(abs(Fraction(ours) - ball.midpoint) <= ROUNDING * abs(ball.midpoint)
                   for ours, ball in zip(row, [*balls, *balls], strict=True))


def test_static_stiffness_against_certified_values():
    # a factor taken out of an integral and not put back, or a component that cancels
    inputs = [np.concatenate([x[:-100][::3], x[-100:]]) for x in sample(constant.STATIC, 100)]
    out, _ = run(constant.STATIC, inputs)
    for row, (d, dr, nu) in zip(out.tolist(), zip(*(x.tolist() for x in inputs), strict=True), strict=True):
        balls = certified.enclose(AxialFabric(D33=d, Dr33=dr), poisson_ratio=nu, hypothesis=Hypothesis.STATIC)
        assert all(abs(Fraction(ours) - ball.midpoint) <= ROUNDING * abs(ball.midpoint)
                   for ours, ball in zip(row, balls, strict=True))


def test_polynomials_hold_up_to_their_ends():
    # the range of the forces, or of the polynomials, narrower than what is served: whole ranges against the sums
    d = np.linspace(-1, 2, 61)
    for ratio in (1 / 9, math.nextafter(1 / 9, 1), 6.0, math.nextafter(6, 0)):
        stress_ratio = ratio * (5 + 2 * d) / (5 - d)
        out, unserved = run(kinetic.KINEMATIC, [d, np.array(0.4), stress_ratio, np.array(0.21)])
        served = np.setdiff1d(np.arange(d.size), unserved)
        assert served.size > 20
        known = components(d, np.full(d.shape, 0.4), stress_ratio, None, np.full(d.shape, 0.21),
                           hypothesis=Hypothesis.KINEMATIC)
        np.testing.assert_allclose(out[served], known[served], rtol=2.0**-48)  # both declare 2^-49


def test_equal_forces_give_the_bits_of_constant_stiffness():
    # a cube root of 1 that is not 1, or a polynomial whose first coefficient is not the integer
    d, ratio, dr, nu = (np.array(x) for x in ([0.0, -1.0, 2.0], [1.0, 0.5, 3.0], [0.7, -0.9, 1.9], [0.0, 0.3, 0.5]))
    with_forces, without = run(kinetic.KINEMATIC, [d, dr, ratio, nu]), run(constant.KINEMATIC, [d, dr, nu])
    np.testing.assert_array_equal(with_forces[0], without[0])


@pytest.mark.parametrize("engine", list(Engine))
def test_blocks_and_threads_change_no_bit(engine):
    # an element lost at a seam, or a block that one thread reads while another overwrites it
    size = BLOCK[engine] * 3 + 5
    d, dr, ratio, nu = (x[-size:] for x in sample(kinetic.KINEMATIC, size))
    d[::1000] = 5.0
    layouts = [d, dr.astype(np.float32), np.broadcast_to(ratio[:1], d.shape), nu[::-1]]
    alone = [run(kinetic.KINEMATIC, layouts, engine, threads) for threads in (1, 2, 3, 7)]
    for out, unserved in alone[1:]:
        np.testing.assert_array_equal(out, alone[0][0])
        np.testing.assert_array_equal(unserved, alone[0][1])
    np.testing.assert_array_equal(alone[0][1], np.arange(0, size, 1000))
    few = slice(BLOCK[engine] - 2, BLOCK[engine] + 2)
    np.testing.assert_allclose(alone[0][0][few], run(kinetic.KINEMATIC, [x[few] for x in layouts])[0],
                               rtol=float(2 * ROUNDING) if engine is Engine.FUSED else 0)


@pytest.mark.parametrize(("size", "block", "threads", "expected"), [
    (0, 4, 3, [(0, 0)]), (1, 4, 3, [(0, 1)]), (9, 4, 2, [(0, 8), (8, 9)]), (8, 4, 9, [(0, 4), (4, 8)]),
    (100, 1, 1, [(0, 100)]), (1 << 17, 4, None, [(0, 1 << 17)]),
])  # fmt: skip
def test_shares_cover_everything_once(size, block, threads, expected):
    # a thread without work, or an element that two threads write
    assert shares(size, block, threads) == expected


def layouts():
    whole = np.arange(24.0).reshape(2, 3, 4)
    unaligned = np.empty(24 * 8 + 1, np.uint8)[1:].view(np.float64).reshape(2, 3, 4)
    unaligned[...] = whole
    return {"plain": whole, "reversed": whole[::-1, :, ::-1], "Fortran": np.asfortranarray(whole),
            "integers": whole.astype(np.int8), "single": whole.astype(np.float32), "other bytes": whole.astype(">f8"),
            "unaligned": unaligned, "row": whole[1, 1], "column": whole[:, :1, :1], "one": whole[:1, :1, 2:3],
            "scalar": np.array(3), "every second": np.repeat(whole, 2, axis=1)[:, ::2],
            "long": whole.astype("longdouble")}


@pytest.mark.parametrize("name", layouts())
def test_readers_give_the_elements_in_order(name):
    # an axis taken for another, a stride that ends early, a block that still holds what the one before left
    argument = layouts()[name]
    expected = np.broadcast_to(argument, (2, 3, 4)).astype(float).ravel()
    read = block_reader(argument, (2, 3, 4), 5)
    for start, stop in ((0, 5), (5, 10), (20, 24), (3, 7), (23, 24)):
        block = read(start, stop)
        assert block.flags.c_contiguous and block.flags.aligned and block.dtype == np.float64
        np.testing.assert_array_equal(block, expected[start:stop])


def test_the_compiler_is_taken_for_many_elements_and_then_kept(monkeypatch):
    # numba loaded for a handful of elements, or never for many small calls, or the choice forgotten
    monkeypatch.setattr(engines, "_compiled", {})
    monkeypatch.setattr(engines, "_evaluated", {})
    kernel = constant.KINEMATIC
    assert choose_engine(kinetic.KINEMATIC, engines.COMPILE_FROM) is Engine.COMPILED
    assert choose_engine(kernel, engines.COMPILE_FROM - 5) is Engine.NUMPY
    assert [choose_engine(kernel, 2) for _ in range(4)] == [Engine.NUMPY] * 2 + [Engine.COMPILED] * 2
    block_function(kernel, Engine.COMPILED)
    assert choose_engine(kernel, 1) is Engine.COMPILED
    assert choose_engine(kernel, 1, "numpy") is Engine.NUMPY
    with pytest.raises(UnknownChoice, match=r"engine = 'fortran'.*'numpy', 'compiled', 'fused'"):
        choose_engine(kernel, 1, "fortran")


def test_without_the_compiler(monkeypatch):
    # an import error instead of the way that is always there
    monkeypatch.setattr(engines, "_compiled", {})
    monkeypatch.setattr(engines, "_evaluated", {})
    monkeypatch.setitem(sys.modules, "numba", None)
    assert choose_engine(constant.KINEMATIC, 1 << 30) is Engine.NUMPY
    with pytest.raises(UnknownChoice, match=r"without numba.*'numpy'.*granular\[fast\]"):
        granular.axial_stiffness(0.0, 0.0, engine="compiled")
    with pytest.raises(UnknownChoice, match=r"engine = 'fused' without numba"):
        granular.axial_stiffness(0.0, 0.0, engine="fused")


def test_nowhere_to_keep_what_was_compiled(monkeypatch):
    # a package folder that may not be written to taken for a failure
    import numba

    real = numba.njit

    def fussy(*signature, cache=False, **options):
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return real(*signature, **options)

    monkeypatch.setattr(engines, "_compiled", {})
    monkeypatch.setattr(numba, "njit", fussy)
    inputs = sample(constant.KINEMATIC, 10)
    np.testing.assert_array_equal(run(constant.KINEMATIC, inputs, "compiled")[0], run(constant.KINEMATIC, inputs)[0])
