"""Bounds of effects: never exceeded by what leaving an effect out really changes, nor far above it where it is small.

"Really" is the route along the meridian with and without the effect; it errs by less than ``ROUNDING`` each time.
"""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from granular.effects import CATALOGUE
from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.packing import STEEPEST
from granular.effects.ranges import LEAST, UNCHANGED, UNKNOWN, Range, log
from granular.effects.selection import model_of, rounded_up, select
from granular.errors import GranularError
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial
from granular.scene import Scene

BY_NAME = {effect.name: effect for effect in CATALOGUE}
ROUNDING = 2 * axial.KINETIC_ERROR
"""Two evaluations, each within its own bound."""


def scene(D33=0.0, ratio=1.0, *, D3333=0.0, Dr33=None, shape=None, spin="fixed", friction=None, nu=0.21,
          hypothesis="kinematic"):
    content = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": nu},
               "packing": {"void_ratio": 0.5744, "contact_normals": {"D33": D33, "D3333": D3333}},
               "stress": {"tensor": [[1.0, 0, 0], [0, 1.0, 0], [0, 0, ratio]]}, "model": {"hypothesis": hypothesis}}
    if friction is not None:
        content["grains"]["friction_coefficient"] = friction
    if Dr33 is not None:
        content["branches"] = {"anisotropy": {"D33": Dr33}}
    if shape is not None:
        content["shape"] = {"aspect_ratio": shape, "spin": spin if hypothesis == "kinematic" else "fixed"}
    return Scene.model_validate(content)


def components(model):
    return axial.evaluate(model.fabric, poisson_ratio=model.poisson_ratio, hypothesis=model.hypothesis,
                          loading=model.loading).components


def changed(given, name, names):
    """What leaving an effect out changes: the bound, and the truth for the worst component."""
    with_it, without_it = model_of(given, names), model_of(given, set(names) - {name})
    pairs = zip(components(without_it), components(with_it), strict=True)
    true = max(abs(less - full) / full if full else (math.inf if less else 0.0) for less, full in pairs)
    return BY_NAME[name].bound(with_it).value, true


def small(largest):
    """Numbers of either sign, of every size up to the largest."""
    return st.builds(lambda sign, power: sign * largest * 10.0**power, st.sampled_from([-1, 1]), st.floats(-8, 0))


SCENES = st.builds(
    lambda D33, ratio, D3333, branches, friction, nu, hypothesis: scene(
        D33, ratio, D3333=D3333, friction=friction, nu=nu, hypothesis=hypothesis, **branches),
    st.one_of(small(1.0), st.floats(-1, 2)),
    st.one_of(small(0.9).map(lambda shift: 1 + shift), st.sampled_from([0.0, 1.0, -0.5])),
    st.one_of(st.just(0.0), small(0.2)),
    st.one_of(st.builds(lambda Dr33: {"Dr33": Dr33}, small(0.95)),
              st.builds(lambda power, spin: {"shape": math.exp(power), "spin": spin}, small(1.5),
                        st.sampled_from(["fixed", "fixed", "relaxed"]))),
    st.sampled_from([0.1, 0.3, 1.0, 10.0]), st.sampled_from([0.0, 0.05, 0.21, 0.5]),
    st.sampled_from(["kinematic", "static"]))


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_no_bound_is_exceeded(data):
    # Breaks when a bound is no bound: for any effect, beside any others, under both hypotheses.
    try:
        drawn = data.draw(SCENES)
    except GranularError:
        assume(False)
    names = set(select(drawn).simulated)
    assume(names)
    name = data.draw(st.sampled_from(sorted(names)))
    kept = {other for other in names - {name} if data.draw(st.booleans())} | {name}
    kept |= {needed for other in kept for needed in BY_NAME[other].requires}
    assume(not any(name in BY_NAME[other].requires for other in kept))
    assume(name == "opening" or "opening" not in names - kept or "kinetic" not in kept)
    try:
        bound, true = changed(drawn, name, kept)
    except GranularError:  # contacts slide under the static hypothesis
        assume(False)
    assert true <= bound + (1 + bound) * ROUNDING


@pytest.mark.parametrize("hypothesis", list(Hypothesis))
@pytest.mark.parametrize(("name", "beside", "given_by", "kinematic", "static"), [
    # the static factor carries the five powers of a matrix and its inverse, for C1122 and C1133
    ("packing", [], {"D33": 1e-4}, 6, 20),
    ("packing", ["kinetic"], {"D33": 1e-4, "ratio": 1.2}, 6, 20),
    ("packing", ["kinetic", "slip"], {"D33": 1e-4, "ratio": 1.2, "friction": 0.5}, 20, 60),
    ("branches", [], {"Dr33": 1e-4}, 3, 12),
    ("deviation", [], {"shape": 1.0001}, 2, 12),
    ("kinetic", [], {"ratio": 1.0001}, 3, 12),
    ("slip", ["kinetic"], {"ratio": 1.0001, "friction": 0.3}, 2, 8)])
def test_bounds_are_near_the_truth_where_effects_are_small(hypothesis, name, beside, given_by, kinematic, static):
    # Breaks when a bound grows careless: an effect that could go within an accuracy would be simulated.
    bound, true = changed(scene(**given_by, hypothesis=hypothesis), name, {name, *beside})
    assert true < bound < (static if hypothesis is Hypothesis.STATIC else kinematic) * true


@pytest.mark.parametrize("hypothesis", list(Hypothesis))
@pytest.mark.parametrize("spread", [1.001, 1.5])
def test_gradation_has_the_bound_that_it_changes(hypothesis, spread):
    # Breaks when the moment of the other hypothesis is taken, or its inverse.
    from granular import evaluate

    content = scene(hypothesis=hypothesis).model_dump(exclude={"branches", "shape", "gradation"}, exclude_none=True)
    content["gradation"] = {"distribution": "lognormal", "median": 1.0, "spread": spread}
    graded = Scene.model_validate(content)
    content["model"]["effects"] = []
    full, less = (evaluate(each).stiffness.C1111 for each in (graded, Scene.model_validate(content)))
    bound = select(graded).bounds["gradation"]
    # both are products of the same moments: what is left between them is their own error
    assert abs(less / full - 1) == pytest.approx(bound, rel=1e-9)


def test_what_cannot_be_bounded_says_why():
    # Breaks when sliding, opening, spinning or missing contacts get a number that nothing proves.
    assert_unknown(select(scene(0.3, 3.0, friction=0.2)), "slip", "slide")
    assert_unknown(select(scene(-1.0)), "packing", "missing")
    for name in ("opening", "kinetic"):
        assert_unknown(select(scene(ratio=-0.1)), name, "tension")
    assert_unknown(select(scene(shape=0.8, spin="relaxed")), "deviation", "spin")


def assert_unknown(selection, name, word):
    bound = selection.reasoned_bounds[name]
    assert bound.value == math.inf
    assert word in bound.reason


@given(st.floats(0.2, 5.0), st.floats(0.2, 5.0), st.floats(0.0, 1.5707))
def test_the_tilt_changes_no_faster_than_claimed(r, r0, angle):
    # Breaks when the slope of the tilt of a force by log(r), on which the bound of packing with slip rests, is larger.
    t = math.tan(angle)
    tilt, other = ((ratio - 1) * t / (t * t + ratio) for ratio in (r, r0))
    steepest = STEEPEST * 2 * max(math.cosh(math.log(ratio) / 2) for ratio in (r, r0))
    assert abs(tilt - other) <= steepest * abs(math.log(r / r0)) * (1 + 1e-9) + 1e-15  # rounding of the tilts


# ---- the static hypothesis: matrices


def normal_block(rows, elements):
    """The inverse of an M-matrix from its row sums and the elements off the diagonal without their sign."""
    matrix = np.diag(np.asarray(rows, dtype=float))
    for (i, j), element in zip(itertools.combinations(range(3), 2), elements, strict=True):
        matrix[i, j] = matrix[j, i] = -element
        matrix[i, i] += element
        matrix[j, j] += element
    return np.linalg.inv(matrix)


POSITIVE = st.floats(-3, 3).map(lambda power: 10.0**power)


@given(st.lists(POSITIVE, min_size=6, max_size=6), st.lists(st.floats(-1, 1), min_size=6, max_size=6),
       st.floats(1e-3, 1.0))
def test_inverses_of_m_matrices_change_by_five_powers_at_the_most(entries, shifts, width):
    # Breaks when the theorem that bounds C1122 and C1133 is used in a form that does not hold.
    moved = [entry * math.exp(width * shift) for entry, shift in zip(entries, shifts, strict=True)]
    ratio = normal_block(moved[:3], moved[3:]) / normal_block(entries[:3], entries[3:])
    # row sums and elements span six powers of ten, and so does the condition of the matrix
    assert np.all(np.abs(np.log(ratio)) <= 5 * width + 1e-6)


@given(st.lists(st.tuples(st.floats(0, 1), st.floats(0, 1), POSITIVE), min_size=1, max_size=6), st.floats(-0.69, 0.69))
def test_neither_part_of_the_vertical_shear_is_longer_than_their_sum_allows(contacts, h):
    # Breaks when the square of the cosine between the two parts of the force field exceeds 1/2, for any contacts.
    y, t, weight = (np.array(column) for column in zip(*contacts, strict=True))
    s = 1 - y
    first, second, cross = (float(np.sum(weight * term)) for term in (
        s / 2 * (1 - t * y), y - t * s * y / 2, -t * s * y / 2))
    together = first + second + 2 * cross
    assert max(first, second) <= 2 * together * (1 + 1e-12)
    turned = math.exp(h) * first + math.exp(-h) * second + 2 * cross
    assert 2 * math.exp(-abs(h)) - 1 - 1e-12 <= turned / together <= 2 * math.exp(abs(h)) - 1 + 1e-12


# ---- ranges


def test_ranges_keep_every_digit_next_to_one():
    # Breaks when a ratio of 1 + 1e-30 is formed in floats.
    tiny = Range.of(1 + Fraction(1, 10**30)) ** (1 / 3)
    assert tiny.change == pytest.approx(1e-30 / 3, rel=1e-11)
    assert log(Fraction(10) ** -400) == pytest.approx(-400 * math.log(10), rel=1e-15)
    assert (Range.of(1 + Fraction(5e-324)) ** 0.01).change > 5e-324  # no effect vanishes by underflow
    assert log(1 - Fraction(5e-324)) == -LEAST


def test_ranges_know_nothing_of_zero_over_zero():
    # Breaks when a ratio that may vanish, over one that may, is taken for a number.
    vanishing = Range(-math.inf, -math.inf)
    assert vanishing / vanishing == UNKNOWN
    assert UNKNOWN.change == math.inf
    assert (UNKNOWN**0.0, UNCHANGED.change) == (UNCHANGED, 0.0)
    assert Range(-math.inf, 0.0).change == pytest.approx(1.0)


@given(st.floats(0.5, 2.0), st.floats(0.5, 2.0))
def test_ranges_follow_ratios(one, other):
    # Breaks when a product, a quotient, a power or a union loses an end.
    first, second = Range.of(one), Range.of(other)
    for result, value in ((first * second, one * other), (first / second, one / other), (first**-2.0, one**-2.0)):
        assert result.low == pytest.approx(math.log(value), abs=1e-14)
    assert (first | second).high == max(first.high, second.high)
    assert (first | UNCHANGED) & UNCHANGED == UNCHANGED


def test_zero_over_zero_is_no_change():
    # Breaks when C1122 = C1133 = 0, for Poisson's ratio 0 without slip, spoils the bound of the other components.
    plain = Simulated(fabric=AxialFabric(), loading=None, sizes=None, poisson_ratio=0.0, hypothesis=Hypothesis.STATIC)
    assert largest_change(Change(apart=UNKNOWN, normal=Range.of(0.5)), plain) == pytest.approx(0.5)


@given(st.floats(1e-300, 1e3))
def test_bounds_are_written_rounded_up(bound):
    # Breaks when a bound is shown as less than it is, or as much more.
    assert bound <= float(rounded_up(bound)) <= 1.11 * bound


def test_an_effect_without_a_bound_is_never_negligible():
    # Breaks when a new effect is left out because nothing is known of it.
    from granular.effects.effect import Effect

    new = Effect(name="n", title="t", equations="e", without="w", called_for=BY_NAME["packing"].called_for)
    assert new.bound(model_of(scene(), set())) == Bound(math.inf, "nothing is proved")
