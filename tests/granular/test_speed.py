"""The speed study: what it compares gives the same numbers, its file is whole, and times are shown, never judged."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from granular.array_stiffness import axial_stiffness
from granular.errors import OutputUnwritable, UnknownChoice
from granular.hertz_mindlin import moduli
from granular.speed import contact_lists, effects, questions
from granular.speed.command import run_speed
from granular.speed.comparisons import LARGE, catalogue
from granular.speed.errors_met import FEW, FEW_SLOPES, certified, certified_slopes, worst_error, worst_slope_error
from granular.speed.interleaved import Measured, Way, measure
from granular.speed.peers.agreement import Agreement
from granular.speed.peers.orientation import by_sums
from granular.speed.peers.rock_physics import (
    COORDINATION,
    SHEAR,
    VOID_RATIO,
    as_written,
    first_integral,
    integrals,
    isotropic,
    misplaced_bracket,
    sphere_pack,
)
from granular.speed.sample import POISSON, sample
from granular.speed.shown import show
from granular.speed.store import Row, Study, read, write

PEERS = ("moduli", "stress-induced", "orientations-11", "orientations-41", "orientations-131")


def test_ratio_of_the_first_way_is_one_and_errors_are_carried() -> None:
    """A base that is divided by something else than itself breaks this."""
    measured = measure([Way(name="a", elements=1, call=lambda: None, error=lambda: 0.25),
                        Way(name="b", elements=5, call=lambda: None)], rounds=4)
    assert [(one.name, one.elements, one.error) for one in measured] == [("a", 1, 0.25), ("b", 5, None)]
    assert measured[0].ratio == measured[0].least == 1.0
    assert measured[0].spread == 0.0


QUESTIONS = {"packing": questions.PACKING, "constant": questions.CONSTANT, "kinetic": questions.KINETIC,
             "slip": questions.SLIP, "friction each": questions.SLIP_EACH, "static": questions.STATIC,
             "static kinetic": questions.STATIC_KINETIC, "static slip": questions.STATIC_SLIP}


@pytest.mark.parametrize("name", QUESTIONS)
def test_what_is_timed_is_right(name: str) -> None:
    """A fast and wrong kernel, or few that are not the first of many; asked for 1e-12, or a few ulps."""
    question = QUESTIONS[name]
    assert worst_error(question, question.call(sample(2 * FEW))) < (question.rtol or 2e-15)
    assert len(certified(question)) == FEW


@pytest.mark.parametrize("name", ["constant", "kinetic", "slip"])
def test_slopes_that_are_timed_are_right(name: str) -> None:
    """A column in another order, or the slope of another question; 1e-13 is what ``axial_gradient`` states."""
    question = QUESTIONS[name]
    assert worst_slope_error(question, question.slopes(sample(FEW_SLOPES))) < 1e-13


def test_an_error_of_a_slope_is_seen() -> None:
    """An error that is taken of other elements, or scaled away, breaks this."""
    value, slopes = questions.CONSTANT.slopes(sample(FEW_SLOPES))()
    moved = slopes.copy()
    moved[2, 1, 0] *= 1 + 1e-6
    scale = max(abs(slopes[2, 1, 0]), value[2].max())
    expected = 1e-6 * abs(slopes[2, 1, 0]) / scale
    found = worst_slope_error(questions.CONSTANT, lambda: (value, moved))
    assert found == pytest.approx(expected, rel=1e-6)
    assert {column[3] for element in certified_slopes(questions.CONSTANT) for column in element} == {0.0}


def test_isotropic_moduli_are_those_of_the_rock_physics_formula() -> None:
    """Another power of the pressure breaks this; twenty roundings on either side."""
    bulk, shear = isotropic(np.array([1.0, 28e3, 2e7]))
    for place, pressure in enumerate((1.0, 28e3, 2e7)):
        known = moduli(SHEAR, POISSON, mean_stress=pressure, void_ratio=VOID_RATIO, coordination_number=COORDINATION)
        assert (bulk[place], shear[place]) == pytest.approx(known, rel=1e-14)


def test_sums_over_directions_are_the_closed_form() -> None:
    """A wrong weight or factor of the Mandel matrix breaks this; the rule of degree 11 is exact to rounding here."""
    from scipy.integrate import lebedev_rule

    n, weight = lebedev_rule(11)
    matrix = by_sums(n, weight * (1 + 0.3 * (3 * n[2] ** 2 - 1) / 2) / (4 * np.pi))
    c1111, c3333, c1122, c1133, c2323, c1212 = axial_stiffness(0.3, 0.0, poisson_ratio=POISSON, kinetic=False).tolist()
    assert np.diag(matrix) == pytest.approx([c1111, c1111, c3333, 2 * c2323, 2 * c2323, 2 * c1212], rel=1e-13)
    assert (matrix[0, 1], matrix[0, 2]) == pytest.approx((c1122, c1133), rel=1e-13)


def test_bounds_are_those_that_are_aimed_at() -> None:
    """A comparison that is lost, or a bound that is another, breaks this."""
    small = {one.name: one for one in catalogue()}
    found = {(name, way.name): way.wanted for name, one in small.items()
             if name not in (*PEERS, "parquet", "constant", "kinetic") for way in one.ways(2) if way.wanted}
    assert found == {
        **{(f"slip-{engine}", f"slip, {kind}"): bound for engine in ("fused", "compiled")
           for kind, bound in (("one friction", 2.5), ("a friction each", 6.0))},
        **{(f"threads-{name}", "2 threads"): 0.6 for name in ("constant", "kinetic", "slip")},
        **{(f"slopes-{name}-{engine}", "values and slopes"): 4.0 for name in ("constant", "kinetic")
           for engine in ("fused", "compiled", "numpy")},
        ("slopes-slip", "values and slopes"): 4.0, ("contacts", "sum of eq. (1), compiled"): 1.3}
    for name, bound in (("constant", 1.15), ("kinetic", 4.5)):
        assert [way.wanted for way in small[name].ways(LARGE)] == [None, None, None, None, bound, bound, None]


def test_a_bound_is_met_or_not() -> None:
    """A memory that is left out of the verdicts, or a verdict without a bound, breaks this."""
    def verdicts(ratio: float, wanted: float | None, memory: float | None = None,
                 most: float | None = None) -> tuple[bool, ...]:
        return Measured(name="a", elements=1, ratio=ratio, least=1, spread=0, nanoseconds=1, rounds=1, wanted=wanted,
                        memory=memory, memory_wanted=most).verdicts

    assert [verdicts(1.0, 1.15), verdicts(1.2, 1.15), verdicts(1.0, None)] == [(True,), (False,), ()]
    assert [verdicts(9.0, None, 0.1, 0.2), verdicts(1.0, 1.15, 0.3, 0.2)] == [(True,), (True, False)]
    assert verdicts(1.0, None, None, 0.2) == ()


def test_sums_over_contacts_are_one() -> None:
    """A sum that reads another array, or an error that compares a sum with itself, breaks this."""
    reading, *sums = contact_lists.sums(1000)
    assert reading.call() == pytest.approx(contact_lists.drawn(1000).sum(), rel=1e-12)  # a thousand roundings
    assert all(way.error is not None and way.error() < 1e-13 for way in sums)
    assert np.abs(np.asarray(sums[0].call()) - np.asarray(sums[1].call())).max() > 0 or sums[0].error() == 0


def test_scenes_simulate_what_they_are_named_for() -> None:
    """A scene that loses an effect and is timed under its name breaks this."""
    from granular import evaluate

    found = {name: set(evaluate(effects.scene_of(tables)).effects_simulated) for name, tables in effects.SCENES.items()}
    assert found["packing"] == {"packing"}
    assert found["+ branches, kinetic, slip"] == {"packing", "branches", "kinetic", "slip"}
    assert "opening" in found["kinetic, some slide, some opened"]
    assert "gradation" in found["+ branches, gradation"]
    assert all(("slip" in what) == ("sli" in name) for name, what in found.items())


def test_the_misplaced_bracket_is_not_the_integral() -> None:
    """A right formula taken for a wrong one: quadrature is the third voice."""
    from scipy.integrate import quad

    for quotient in (0.1, 2.0, 5.0):
        known = quad(lambda x, q=quotient: np.sqrt(q + x * x), 0, 1, epsabs=0, epsrel=1e-13)[0]
        assert first_integral(quotient) == pytest.approx(known, rel=1e-13)
        assert abs(misplaced_bracket(quotient) / known - 1) > 0.01
        assert integrals(quotient, known) == pytest.approx(
            [quad(lambda x, q=quotient, k=k: x ** k * np.sqrt(q + x * x), 0, 1, epsabs=0, epsrel=1e-13)[0]
             for k in (0, 2, 4)], rel=1e-12)  # ten digits of the last would be lost for a quotient of a hundred


def test_a_pack_that_is_pressed_from_all_sides_has_no_axis() -> None:
    """A constant with a wrong share of the directions breaks this; an axial strain of a thousandth moves them by less.

    As that package writes C11, it grows without bound there.
    """
    c11, c33, c13, c44, c66 = sphere_pack(1e3)
    assert (c11, c44) == pytest.approx((c33, c66), rel=1e-3)
    assert c11 - c13 == pytest.approx(2 * c44, rel=1e-3)
    assert as_written(1e3)[0] > 2 * c11


def test_every_comparison_runs_or_says_what_is_missing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A way that fails, or a file that does not hold what was measured, breaks this."""
    out, said = tmp_path / "speed.json", list[str]()
    assert run_speed(out=out, rounds=2, largest=1, advanced=said.append) == 0
    study = read(out)
    assert {row.name for row in study.rows} == {comparison.name for comparison in catalogue()}
    for row in study.rows:
        missing = row.failure is not None
        assert missing == (not row.ways)
        assert not missing or (row.name in PEERS and row.failure.endswith("is not installed"))
        assert all(way.ratio > 0 and way.rounds <= 2 and way.wanted is None for way in row.ways)
    assert study.command == "granular speed --rounds 2 --largest 1"
    assert study.machine["numpy"] == np.__version__
    assert said[0] == "constant, 1"
    assert "summary of the file" in capsys.readouterr().out


def test_a_study_is_read_as_it_was_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A field that is lost or rounded on the way, or a bound that is not shown, breaks this."""
    way = Measured(name="fast", elements=3, ratio=1.25, least=1.5, spread=0.25, nanoseconds=2.5, rounds=3, error=1e-16,
                   wanted=1.15, memory=0.5, memory_wanted=0.75)
    row = Row(name="a", title="b", each="assembly", errors="", size=3, ways=(way,), failure=None)
    other = Agreement(package="p 1", quantity="q", theirs=1.1, meant=1.0, unit="GPa")
    study = Study(command="c", rounds=3, machine={"processor": "p"}, rows=[row], agreements=[other])
    write(tmp_path / "speed.json", study)
    assert read(tmp_path / "speed.json") == study
    assert other.distance == pytest.approx(0.1)
    show(study)
    shown = capsys.readouterr().out
    assert "b, 3 assemblies" in shown
    assert "1.25" in shown
    assert "1.15" in shown
    assert "1 of 2 bounds that are aimed at are met" in shown


def test_refusals(tmp_path: Path) -> None:
    """A name that is not known, or a file that cannot be written, must be told before anything is measured."""
    with pytest.raises(UnknownChoice, match="--only"):
        run_speed(only=["fast"], rounds=2)
    with pytest.raises(OutputUnwritable):
        run_speed(out=tmp_path / "missing" / "speed.json", rounds=2)


def test_finished_comparisons_survive_ctrl_c(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What was measured before Ctrl-C must be in the file."""
    out = tmp_path / "speed.json"

    def stop(label: str) -> None:
        if label.startswith("constant, 10"):
            raise KeyboardInterrupt

    assert run_speed(out=out, rounds=2, only=["constant"], largest=10, advanced=stop) == 130
    assert len(json.loads(out.read_text(encoding="utf-8"))["rows"]) == 1
    assert "Stopped: 1 of 2 comparisons are made" in capsys.readouterr().err
