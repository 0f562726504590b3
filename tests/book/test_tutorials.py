"""What the first page and the tutorials show: commands run as they stand, words hold, data are what made them."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from page_tools import start, tutorial_derivation, tutorial_lab, tutorial_measured, tutorial_shell, tutorial_simulation
from page_tools.provenance import DATA_FILES
from page_tools.tutorial_derivation import FABRICS, emitted_function

from granular import axial_stiffness
from granular.contacts import summarise
from granular.contacts.example import example_facts, example_path
from granular.fitting.data import Data

PAGES = ("index", "first_use", "from_the_lab", "from_simulations", "a_new_closed_form")
CONSOLE = re.compile(r"^```console\n(.*?)^```", flags=re.MULTILINE | re.DOTALL)


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder with the files that the tutorials start from."""
    tutorial_shell.fill(tmp_path)
    return tmp_path


def text_of(book: Path, page: str) -> str:
    return (book / f"{page}.md").read_text(encoding="utf-8")


def commands_shown(book: Path) -> list[str]:
    """Commands that stand in the text of a page and are not run by its cells, without their remarks."""
    lines = [line for page in PAGES for block in CONSOLE.findall(text_of(book, page)) for line in block.splitlines()]
    return [line.removeprefix("$ ").partition("  #")[0].strip() for line in lines if line.startswith("$ ")]


def test_commands_in_the_text_exist(book: Path, root: Path) -> None:
    """A command in the text of a page that is no target of the Makefile and no command of the programs breaks this."""
    targets = set(re.findall(r"^(\w+):", (root / "Makefile").read_text(encoding="utf-8"), flags=re.M))
    shown = commands_shown(book)
    assert len(shown) >= 6
    for command in shown:
        program, *words = command.split()
        if program == "make":
            assert words[0] in targets, command
        elif program in ("granular", "derivations"):
            asked = [sys.executable, "-m", program, words[0], "--help"]
            assert subprocess.run(asked, capture_output=True, check=False).returncode == 0, command
        else:
            assert command == ". .venv/bin/activate"


def test_a_derivation_is_shown_as_the_page_says(book: Path, place: Path) -> None:
    """Breaks when the commands that show a derivation are misspelt on the page."""
    shown = [command for command in commands_shown(book) if command.startswith("derivations show")]
    assert len(shown) == 2
    text = tutorial_shell.run(shown[1], place)
    assert "def phase_velocities(" in text


def test_package_and_versions(book: Path, root: Path) -> None:
    """Breaks when the page on the first five minutes names another package or another Python."""
    project = (root / "pyproject.toml").read_text(encoding="utf-8")
    text = text_of(book, "first_use")
    assert 'name = "granular"' in project and "The package is called `granular`" in text
    assert 'requires-python = ">=3.11,<3.14"' in project and re.search(r"Python 3\.11\s+to 3\.13", text)


def test_files_to_start_from_are_offered(book: Path) -> None:
    """Breaks when a tutorial starts from a file that no page gives away, or that the list of data does not know."""
    texts = "".join(text_of(book, page) for page in PAGES)
    for name in tutorial_shell.FILES:
        assert f"<_data/{name}>" in texts, name
        assert f"_data/{name}" in DATA_FILES, name


def test_shell_runs_what_it_shows(place: Path) -> None:
    """Breaks when an exit code is passed over, a part of an answer is left out silently, or lines run over."""
    with pytest.raises(AssertionError, match="exit code 2, not 0"):
        tutorial_shell.run("granular run missing.toml", place)
    with pytest.raises(AssertionError, match="has not all"):
        tutorial_shell.shell("granular run soil.toml", "Stiffness", "Colour")
    shown = tutorial_shell.shell("granular run soil.toml", "Waves").text
    assert shown.startswith("```console\n$ granular run soil.toml\n  ...\n\nWaves")
    assert max(map(len, shown.splitlines())) <= tutorial_shell.WIDTH


def test_the_slip_that_reads_as_a_sieve_in_metres(place: Path) -> None:
    """Breaks when sizes without a unit are no longer metres, which the page for the laboratory says."""
    text = tutorial_shell.run("""sed 's/ .mm.//' lab_sieve.csv > bare.csv
sed 's/lab_sieve/bare/' lab_sand.toml > bare.toml
granular run bare.toml | grep D50""", place)
    size = re.search(r"D50 ([\d.]+)", text)
    assert size is not None
    assert float(size[1]) == pytest.approx(418.1, abs=0.1)  # mm, as D50 of the curve is 0.4181 mm


def test_measured_speeds_are_those_of_the_rule() -> None:
    """Breaks when the data are edited by hand, or the rule behind them is changed and the data are not."""
    for name, text in tutorial_measured.DATA_FILES.items():
        assert (tutorial_shell.DATA / name).read_text(encoding="utf-8") == text


def test_the_rule_behind_the_speeds() -> None:
    """A wrong power of the stress or a speed from the wrong modulus breaks this; the numbers are worked by hand."""
    middle = tutorial_measured.EQUAL[1]
    assert tutorial_measured.shear_modulus(100, 100) == pytest.approx(6908e3 * 2.3104 / 1.65 * 10)
    speeds = tutorial_measured.speeds(middle)
    assert (speeds["Vs_hh"] / speeds["Vs_vh"]) ** 2 == pytest.approx(1.06)
    assert (speeds["Vp_horizontal"] / speeds["Vp_vertical"]) ** 2 == pytest.approx(1.12)
    assert (speeds["Vp_vertical"] / speeds["Vs_vh"]) ** 2 == pytest.approx(8 / 3)  # of a Poisson's ratio of 0.2
    unequal = tutorial_measured.speeds(tutorial_measured.UNEQUAL)
    assert (unequal["Vp_vertical"] / speeds["Vp_vertical"]) ** 2 == pytest.approx(2**0.5)
    assert (unequal["Vs_hv"] / speeds["Vs_hv"]) ** 2 == pytest.approx(2**0.25)


def test_words_of_the_tutorial_for_the_laboratory() -> None:
    """Breaks when the model, the fit or the data change so that a sentence of the page is no longer true."""
    assert tutorial_lab.factor("C2323") > tutorial_lab.factor("C3333") > 2  # far too stiff, shear more so
    kinematic, static = (tutorial_lab.modelled(1e5, hypothesis=one).stiffness for one in ("kinematic", "static"))
    assert static.C2323 == pytest.approx(kinematic.C2323, rel=0.01)  # "nearly the same"
    found = tutorial_lab.fitted("_data/lab_speeds.toml")
    assert found.p_value is not None and found.p_value > 0.05  # the model describes the equal states
    best = found.combinations[0]
    assert best.value + 4 * best.standard_error < 0  # the isotropic fabric is excluded
    low, high = found["D33"].intervals[1].low, found["D33"].intervals[1].high
    assert low is not None and high is not None and low < 0 < high  # and D33 alone is not known
    ratios = tutorial_lab.ratio_table().text
    measured, predicted = (float(one) for one in re.findall(r"C_\{3333\}\$ \| ([\d.]+) \| ([\d.]+)", ratios)[0])
    assert measured < predicted  # the specimen is stiffer upwards than the model allows for


def test_speeds_are_read_with_their_weights() -> None:
    """Breaks when two readings of one component are not averaged by their uncertainties."""
    value, doubt = tutorial_lab.readings("C2323", 0)
    both = [one for one in Data.from_toml(tutorial_shell.DATA / "lab_speeds.toml").measurements
            if one.state == 0 and one.kind.name in ("Vs_vh", "Vs_hv")]
    speed = sum(one.value for one in both) / 2  # with the same uncertainty
    assert value == pytest.approx(2650 / 1.65 * speed**2)
    assert doubt == pytest.approx(2 * value / speed * both[0].uncertainty / 2**0.5)


def test_figures_show_what_was_computed() -> None:
    """Breaks when measured points and model lines are exchanged, or a section is not that of the soil."""
    drawn = tutorial_lab.compared_drawn().figure.axes[0]
    heights = [list(line.get_ydata()) for line in drawn.lines if len(line.get_ydata()) == 3]
    measured, _ = tutorial_lab.readings("C3333", 1)
    assert any(height[1] == pytest.approx(measured / 1e6) for height in heights)
    model = tutorial_lab.modelled(1e5).stiffness
    assert any(height[1] == pytest.approx(model.C2323 / 1e6) for height in heights)
    contacts, stiffness = start.picture().figure.axes[1:]
    upright = {round(float(max(line.get_ydata())), 6) for line in stiffness.lines}
    assert round(start.soil().stiffness.C3333 / 1e6, 6) in upright
    pressed, sheared = contacts.lines[:2]
    assert max(pressed.get_ydata()) > max(sheared.get_ydata()) > 0


def test_answers_of_the_first_page() -> None:
    """Breaks when a question has no link to go on with, or the answers leave out their evidence."""
    rows = [line for line in start.questions().text.splitlines() if line.startswith("| **")]
    assert len(rows) == 6
    assert all(re.search(r"\]\(\w+\.md\)", row) for row in rows)
    assert "rounds" in rows[4] and "directions" in rows[4]  # a time is shown with its count and machine
    low, high = start.overrated("C2323", "C1212")
    assert 1 < start.bulk_overrated()[0] < start.bulk_overrated()[1] < low < high


def test_words_of_the_tutorial_on_simulations() -> None:
    """Breaks when the packing's tests no longer say what the page says of them."""
    seen = [test.significant() for test in tutorial_simulation.packing().tests]
    assert seen == [False, True, False, False]  # any at all, about axis 3, of rank four, none about axis 3
    checks = tutorial_simulation.checks_table().text
    for row in [line.split(" | ") for line in checks.splitlines() if line.startswith("| ") and ":" not in line][1:]:
        assert row[1] == row[2].removesuffix(" |")  # the list gives back what the simulation knows


def test_many_lists(place: Path) -> None:
    """Breaks when the script stops at a list that is refused, or reads another number than the library does."""
    tutorial_shell.run(f"mkdir lists; cp {example_path()} lists/a.csv.gz; echo id1,id2 > lists/b.csv", place)
    rows = tutorial_shell.run(f"python many_lists.py lists {example_facts()['V']}", place).splitlines()
    kinematic = summarise(example_path(), volume=example_facts()["V"]).kinematic
    assert kinematic is not None
    values = next(row for row in rows if row.startswith("a.csv.gz,")).split(",")
    assert float(values[4]) == pytest.approx(kinematic.component("C3333"), rel=1e-4)  # five digits are printed
    assert any(row.startswith("b.csv: ") and "[G-CON-" in row for row in rows)


def test_the_new_closed_form() -> None:
    """A wrong coefficient, or one that is left out, breaks this."""
    for D33, D3333, Dr33 in FABRICS:
        if D3333 == 0:
            six = axial_stiffness(D33, Dr33, kinetic=False)
            even = (2 * six[0] + six[1] + 2 * six[2] + 4 * six[3]) / 9
            found, = emitted_function()(D33, D3333, Dr33)
            assert found == pytest.approx(even, rel=1e-14)  # roundings


def test_voices_of_the_new_closed_form() -> None:
    """Breaks when a fabric of rank four goes wrong, or friction enters what it must not enter."""
    assert all(max(off) < 1e-14 for _, _, *off in tutorial_derivation.voices())  # some roundings
    moduli = [tutorial_derivation.by_components(tutorial_derivation.under_friction(friction))
              for friction in tutorial_derivation.FRICTIONS]
    assert moduli == pytest.approx([moduli[0]] * len(moduli), rel=1e-13)  # by five different rules
    assert "FAILS" in tutorial_derivation.wrong_step().text


def test_places_of_a_derivation_exist() -> None:
    """Breaks when a file in the table of places has moved."""
    assert len(tutorial_derivation.places()) == 7
    assert "waves.md" in tutorial_derivation.places_table().text
