"""The reference explains every public name, key, command and option, and every text that it shows is whole."""

from __future__ import annotations

import importlib
import inspect
import re
import tempfile
from collections import Counter
from pathlib import Path

import pytest
from page_tools import (
    notation,
    reference_commands,
    reference_entries,
    reference_files,
    reference_names,
    reference_scene,
    reference_text,
)

import granular
from granular.errors import CATALOGUE, UnknownKey
from granular.fitting.data import OWN, FitTable
from granular.fitting.quantities import SPEEDS
from granular.routes.result import COMPONENTS
from granular.sweeps import Sweep
from granular.sweeps.axes import RANGE_KEYS
from granular.sweeps.scene_fields import scene_fields, table_types

CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```", flags=re.MULTILINE | re.DOTALL)


def cells(book: Path, page: str) -> str:
    """Source of all cells of a page."""
    return "\n".join(CELL.findall((book / f"{page}.md").read_text(encoding="utf-8")))


def names_below(module_name: str) -> list[str]:
    """Public functions and classes of a module: those of ``__all__``, or those that it defines."""
    module = importlib.import_module(module_name)
    listed = getattr(module, "__all__", None) or [
        name for name, thing in vars(module).items()
        if not name.startswith("_") and getattr(thing, "__module__", None) == module_name]
    return [name for name in listed
            if inspect.isfunction(getattr(module, name)) or inspect.isclass(getattr(module, name))]


def test_every_name_that_import_granular_promises_is_explained() -> None:
    """Breaks when a name is added to ``granular`` without an entry, or an entry names what is not there any more."""
    assert {f"granular.{name}" for name in granular.__all__} <= set(reference_names.explained())


@pytest.mark.parametrize("package", reference_names.PACKAGES)
def test_every_name_of_the_packages_is_explained(package: str) -> None:
    """Breaks when a package that the reference covers gets a function or class that it does not explain."""
    known = {id(thing) for thing in reference_names.explained().values()}
    module = importlib.import_module(package)
    missing = [name for name in names_below(package) if id(getattr(module, name)) not in known]
    assert not missing


def test_names_have_one_entry_and_every_group_a_page(book: Path) -> None:
    """Breaks when a name is explained twice, which Sphinx refuses, or a page forgets one of its groups."""
    counted = Counter(id(thing) for thing in reference_names.explained().values())
    assert max(counted.values()) == 1
    for key, group in reference_names.GROUPS.items():
        assert f'entries("{key}")' in cells(book, group.page), key


@pytest.mark.parametrize("name", sorted(reference_names.explained()))
def test_entries_hold_all_that_the_docstring_says(name: str) -> None:
    """Breaks when an argument, a refusal, the accuracy, the source or the example of a name is lost on the way."""
    thing = reference_names.explained()[name]
    doc = inspect.getdoc(thing) or ""
    shown = reference_entries.entry(name)
    sections = reference_text.sections(doc)
    assert sections[""], f"{name} has no docstring"
    for title in ("Parameters", "Attributes"):
        for head, _ in reference_text.items(sections.get(title, "")):
            assert all(f"`{one}`" in shown for one in head.partition(" : ")[0].split(", ")), head
    for refusal in CATALOGUE:
        if refusal.__name__ in sections.get("Raises", ""):
            assert f"<error-{refusal.code.lower()}>" in shown
    assert ("**Accuracy:**" in shown) >= ("Accuracy" in sections)
    assert ("**Source:**" in shown) >= ("Source" in sections)
    assert (">>>" in shown) >= (">>>" in doc)
    if isinstance(thing, type):
        for member in reference_entries.members(thing):
            assert re.search(rf"\}} {member}\b|`{member}`", shown), f"{name}.{member}"


@pytest.mark.parametrize("style", ["Notes\n-----\nFirst. Accuracy: to 1e-9. Source: eq. (7).",
                                   "Accuracy\n--------\nto 1e-9.\n\nNotes\n-----\nFirst. Source: eq. (7)."])
def test_both_styles_of_docstrings_read_alike(style: str) -> None:
    """Breaks when accuracy and source are found only where a section, or only where a sentence, is named for them."""
    found = reference_text.sections(f"Do it.\n\n{style}")
    assert found == {"": "Do it.", "Notes": "First.", "Accuracy": "to 1e-9.", "Source": "eq. (7)."}


def test_prose_links_names_and_equations(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a role, an equation or a power of a docstring reaches the page as it is typed."""
    monkeypatch.chdir(book)
    shown = reference_text.prose("As :func:`granular.planning.plan`, eqs (1)-(7), l_e^2 to 2^-49, ``x`` or \"auto\".")
    assert "{py:func}`granular.planning.plan <granular.plan>`" in shown
    assert "[(7)](kinematic.md)" in shown
    assert "l{sub}`e`²" in shown
    assert "2{sup}`−49`" in shown
    assert '`x` or `"auto"`' in shown
    assert reference_text.refusals("GranularError, NotToml").endswith("{ref}`NotToml <error-g-inp-02>`")


def test_signatures_are_those_of_the_code() -> None:
    """Breaks when an argument, a default or the mark of arguments by name is lost."""
    assert reference_entries.signature(granular.evaluate) == "(scene, *, rtol=None, route='auto')"
    assert reference_entries.signature(granular.GeneralFabric) == "(D=..., D4=None, Dr=None)"


# The scene file.


def test_every_key_of_a_scene_has_an_entry(book: Path) -> None:
    """Breaks when a table is added to scenes and the page goes without it, or an entry lacks a fact."""
    for table in table_types():
        assert f'keys_of("{table}")' in cells(book, "scene_file")
        shown = reference_scene.keys_of(table).text
        for name in (field.name for field in scene_fields().values() if field.table == table):
            entry = shown.partition(f"{{confval}} {name}\n")[2].partition("::::")[0]
            assert all(f"- {fact}: " in entry for fact in ("Takes", "Default", "Example")), name


def test_example_scenes_use_every_key_and_are_sound() -> None:
    """Breaks when a key is added that no example shows, or an example no longer is a scene."""
    for name in scene_fields():
        assert reference_scene.example(name)
    for path in reference_scene.files():
        assert granular.plan(granular.Scene.from_toml(path)).route


@pytest.mark.parametrize(("name", "effects"), [
    ("packing.contact_normals.D3333", {"packing"}), ("stress.ratio", {"kinetic", "slip"}), ("stress.mean", set()),
    ("grains.friction_angle", {"slip"}), ("branches.length_ratio", set()), ("shape.aspect_ratio", {"deviation"}),
    ("stress.tensor", {"kinetic", "slip", "opening"}), ("gradation.spread", {"gradation"}),
    ("branches.anisotropy.tensor", {"branches"}), ("model.rtol", set()),
])
def test_effects_that_a_key_feeds(name: str, effects: set[str]) -> None:
    """Breaks when what else stands in an example is taken for what the key does."""
    assert set(reference_scene.feeds(name)) == effects


def test_bounds_and_defaults_are_those_of_the_models() -> None:
    """Breaks when a bound or a choice is lost, or a default that is false or zero is taken for none."""
    kinds = {name: reference_scene.bare(field.kind) for name, field in scene_fields().items()}
    assert kinds["grains.poisson_ratio"] == ["pure number", ">= 0 and <= 0.5"]
    assert kinds["stress.mean"] == ["pressure [Pa]", "> 0 (compression is positive)"]
    assert kinds["shape.spin"] == ["a word", 'out of "fixed", "relaxed"']
    assert reference_scene.default("packing.void_ratio") == "needed"
    assert reference_scene.default("branches.length_ratio") == "1.0"
    assert reference_scene.default("grains.density") == "none"
    assert not [name for name, kind in kinds.items() if kind[0].startswith("{")], "a kind that has no words yet"


def test_keys_of_a_sweep_file_are_all_there() -> None:
    """Breaks when a key of a sweep file is added, told apart by what an unknown one is refused with."""
    shown = reference_files.sweep_keys().text
    for place in ("sweep", "sweep.run"):
        remedy = refused_key(place)
        keys = remedy.removeprefix("The keys here are ").rstrip(".").split(", ")
        assert all(f"`{place}.{key}" in shown for key in keys), keys
    assert all(f"`{key}" in reference_files.range_keys().text for key in RANGE_KEYS)


def refused_key(place: str) -> str:
    """The remedy of an unknown key in a table of a sweep file, which lists those that exist."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "sweep.toml"
        file.write_text(f"[{place}]\nno_such_key = 1\n", encoding="utf-8")
        with pytest.raises(UnknownKey) as refusal:
            Sweep.from_toml(file)
    return refusal.value.remedy


def test_keys_of_a_data_file_are_all_there(book: Path) -> None:
    """Breaks when a key or a quantity of the data file of a fit is added."""
    keys, quantities = reference_files.fit_keys().text, reference_files.measured_quantities().text
    assert all(f"{{confval}} fit.{name}\n" in keys for name in FitTable.model_fields)
    assert all(f"`{name}`" in quantities for name in (*SPEEDS, *COMPONENTS))
    section = (book / "scene_file.md").read_text(encoding="utf-8").partition("(sec-data-file)=")[2]
    assert all(f"`{name}`" in section for name in OWN)


# The command line.


@pytest.mark.parametrize("program", reference_commands.PROGRAMS)
def test_every_command_has_a_section_and_every_option_a_row(program: str, book: Path) -> None:
    """Breaks when a command or an option is added without the page, or a section outlives its command."""
    page = (book / "command_line.md").read_text(encoding="utf-8")
    sections = re.findall(rf"^\(command-[\w-]+\)=\n## `{program} (\w+)`$", page, flags=re.MULTILINE)
    assert sections == list(reference_commands.commands(program))
    for name, command in reference_commands.commands(program).items():
        shown = reference_commands.usage(name, program).text
        assert f"({reference_commands.label_of(program, name)})=" in page
        for one in command.params:
            if one.name != "help":
                assert f"`{reference_commands.called(one)}`" in shown


def test_exit_codes_are_those_of_the_program() -> None:
    """Breaks when a code of the command line has no row, or the docstring tells another one."""
    from granular.__main__ import INTERRUPTED, REFUSED
    from granular.commands.options import DONE, MISSED

    shown = reference_commands.exit_codes().text
    assert re.findall(r"^\| (\d+) \|", shown, flags=re.MULTILINE) == [
        str(code) for code in (DONE, MISSED, REFUSED, INTERRUPTED)]


def test_runs_show_what_a_shell_does() -> None:
    """Breaks when a run is shown whose exit code is not the expected one, or lines are cut without a mark."""
    shown = reference_commands.run("granular schema", first=3).text
    assert shown.startswith("```console\n$ granular schema\n{\n")
    assert shown.endswith("\n...\n```\n")
    with pytest.raises(AssertionError, match="left with 2"):
        reference_commands.run("granular run no_such_scene.toml")


# Conventions and bibliography.


def test_factors_of_the_matrices() -> None:
    """Breaks when a factor of a Voigt or Mandel matrix changes, or a block of the matrix is confused with another."""
    rows = [line.strip("| ").split(" | ") for line in notation.factors().text.splitlines() if line.startswith("| n")
            or line.startswith("| s")]
    assert rows == [["normal, normal", "1", "1", "1"], ["normal, shear", "1", "2", r"$\sqrt2$"],
                    ["shear, shear", "1", "4", "2"]]


def test_every_entry_of_the_bibliography_is_cited(book: Path) -> None:
    """Breaks when an entry is left that no page cites, which no build tells, or a DOI is given as an address."""
    text = (book / "references.bib").read_text(encoding="utf-8")
    keys = re.findall(r"^@\w+\{(\w+),", text, flags=re.MULTILINE)
    cited = {key for page in [*book.glob("*.md"), *book.glob("_ext/page_tools/*.py")]
             for group in re.findall(r"\{cite:[pt]\}`([\w,]+)`", page.read_text(encoding="utf-8"))
             for key in group.split(",")}
    assert sorted(cited) == sorted(keys)
    assert all(doi.startswith("10.") for doi in re.findall(r"doi\s*=\s*\{([^}]*)\}", text))
