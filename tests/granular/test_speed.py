"""The speed study: what it compares gives the same numbers, its file is whole, and times are shown, never judged."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from granular.array_stiffness import axial_stiffness
from granular.errors import OutputUnwritable, UnknownChoice
from granular.hertz_mindlin import moduli
from granular.speed.command import run_speed
from granular.speed.comparisons import catalogue, stiffness
from granular.speed.errors_met import FEW, certified, worst_error
from granular.speed.interleaved import Way, measure
from granular.speed.peers.orientation import by_sums
from granular.speed.peers.rock_physics import COORDINATION, SHEAR, VOID_RATIO, isotropic
from granular.speed.sample import POISSON, sample

PEERS = ("moduli", "stress-induced", "orientations-11", "orientations-41", "orientations-131")


def test_ratio_of_the_first_way_is_one_and_errors_are_carried() -> None:
    """A base that is divided by something else than itself breaks this."""
    measured = measure([Way(name="a", elements=1, call=lambda: None, error=lambda: 0.25),
                        Way(name="b", elements=5, call=lambda: None)], rounds=4)
    assert [(one.name, one.elements, one.error) for one in measured] == [("a", 1, 0.25), ("b", 5, None)]
    assert measured[0].ratio == measured[0].least == 1.0
    assert measured[0].spread == 0.0


@pytest.mark.parametrize("what", ["constant", "kinetic", "slip", "slip, any friction"])
def test_what_is_timed_is_right(what: str) -> None:
    """A fast and wrong kernel, or few that are not the first of many; 1e-12 is asked of slip, 2e-15 are a few ulps."""
    assert worst_error(what, stiffness(sample(2 * FEW), what)) < (1e-12 if what.startswith("slip") else 2e-15)
    assert len(certified(what)) == FEW


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


def test_every_comparison_runs_or_says_what_is_missing(tmp_path: Path) -> None:
    """A way that fails, or a file that does not hold what was measured, breaks this."""
    out, said = tmp_path / "speed.json", list[str]()
    assert run_speed(out=out, rounds=2, largest=FEW, advanced=said.append) == 0
    content = json.loads(out.read_text(encoding="utf-8"))
    assert {row["name"] for row in content["rows"]} == {comparison.name for comparison in catalogue()}
    for row in content["rows"]:
        missing = row["failure"] is not None
        assert missing == (not row["ways"])
        assert not missing or (row["name"] in PEERS and row["failure"].endswith("is not installed"))
        assert all(way["ratio"] > 0 and way["rounds"] == 2 for way in row["ways"])
    assert content["command"] == f"granular speed --rounds 2 --largest {FEW}"
    assert content["machine"]["numpy"] == np.__version__
    assert said[0].startswith("constant, 1")


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
