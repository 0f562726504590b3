"""What the pages on contact lists and on measured packings say in words holds in the numbers that they show."""

from __future__ import annotations

import base64
import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from page_tools import contact_lists, dem
from page_tools.commands import WIDTH
from page_tools.markup import Markup

from granular.contacts import ContactList, Material, summarise
from granular.contacts.columns import GROUPS, NATIVE
from granular.contacts.comparison import FROM_LIST, FROM_SCENE
from granular.contacts.example import NAME, example_facts, example_path
from granular.hypothesis import Hypothesis


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def rows(shown: Markup) -> list[list[str]]:
    """Rows of the CSV file of a table, with their header."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", shown.text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))


def number(text: str) -> float:
    return float(text.replace("−", "-").removesuffix(" %"))


def dumped(folder: Path, columns: dict[str, str], values: dict[str, np.ndarray]) -> Path:
    """The packing that ships as a dump whose columns are those that a page names; what is not mapped is zero."""
    compute = sorted({re.sub(r"\[\d+\]", "", column) for column in columns.values()})
    every = [f"{name}[{k}]" for name in compute for k in range(1, 13)]
    native = {column: name for name, column in columns.items()}
    size = next(iter(values.values())).size
    table = np.array([values[native[name]] if name in native else np.zeros(size) for name in every]).T
    path = folder / "contacts.dump"
    head = f"ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n{size}\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
    lines = "\n".join(" ".join(f"{value:.17g}" for value in row) for row in table)
    path.write_text(f"{head}ITEM: ENTRIES {' '.join(every)}\n{lines}\n", encoding="utf-8")
    return path


def test_the_report_is_that_of_the_command() -> None:
    """Breaks when the page shows another packing, a path of some machine, or lines that do not fit."""
    text = contact_lists.report().text
    assert text.startswith(f"```console\n$ granular contacts {NAME}_contacts.csv.gz --volume ")
    assert f'"{NAME}_contacts.csv.gz"' in text
    assert "/" not in text.split("list  ")[1].split("\n")[0]
    assert max(map(len, text.splitlines())) <= WIDTH
    for hypothesis in ("kinematic", "static"):
        assert re.search(rf"^  {hypothesis} +normals +normals$", text, flags=re.MULTILINE)


def test_every_column_is_described() -> None:
    """Breaks when a column is added and the page does not know it."""
    text = contact_lists.columns_table().text
    assert set(contact_lists.MEANINGS) == set(GROUPS)
    assert all(f"`{name}`" in text for name in NATIVE)


def test_the_table_has_both_sums_and_their_distances() -> None:
    """Breaks when a prediction stands under another hypothesis than its sum."""
    head, *body = rows(contact_lists.stiffness_table())
    assert head == ["MPa", "eq. (1)", "mean k_n", "forces", "eq. (5)", "mean k_n", "forces"]
    values = np.array([[number(cell) for cell in row[1:]] for row in body[:-1]])
    weights = np.array([1, 1, 1, 2, 2, 2, 4, 4, 4])  # each stands for so many of the 81 components
    for sums, columns in ((0, (1, 2)), (3, (4, 5))):
        for column in columns:
            apart = np.sqrt(weights @ (values[:, column] - values[:, sums]) ** 2 / (weights @ values[:, sums] ** 2))
            # without the twelve small components, and from rounded numbers
            assert 100 * apart == pytest.approx(number(body[-1][1 + column]), abs=0.15)


def test_forces_are_as_the_page_says() -> None:
    """Breaks when forces are no longer above their estimate near axis 3 and below it near the horizontal."""
    _, *body = rows(contact_lists.force_table())
    ratios = [number(row[5]) for row in body]
    assert min(ratios[:4]) > 1 > max(ratios[-3:])
    assert all(number(row[6]) < number(row[7]) for row in body)  # less shear than estimated
    assert "7 % above the estimate" in contact_lists.force_words().text


def test_stress_is_that_of_the_simulation() -> None:
    """Breaks when eq. (24) and the program's own stress part, by more than nine digits of the list leave."""
    apart = re.search(r"within (\S+) Pa", contact_lists.stress_words().text)
    assert apart is not None
    assert float(apart[1]) < 1e-7 * 1e5


def test_equal_contacts_bring_the_two_sums_together() -> None:
    """Breaks when something else than the scatter of the stiffness parts the sums, which the page says it does not."""
    parts = re.findall(r"([\d.]+) %", contact_lists.soft_words().text)
    assert float(parts[0]) > 10
    assert float(parts[1]) < 1


def test_every_fault_is_refused_with_a_code_of_the_book(book: Path) -> None:
    """Breaks when a faulty list is read, or a code has no section to link to."""
    text = contact_lists.refusals_table().text
    codes = re.findall(r"<(error-[a-z]+-[a-z]+-\d\d)>`", text)
    sections = (book / "errors.md").read_text(encoding="utf-8")
    assert len(codes) == len(contact_lists._faults())
    assert all(f"({code})=" in sections for code in codes)
    assert "/tmp" not in text


def test_wrapped_commands_are_whole() -> None:
    """Breaks when wrapping a command loses an option or parts it from its value."""
    text = contact_lists.mapped(contact_lists.LIGGGHTS, "a.dump").text
    line = " ".join(text.replace("\\\n", " ").split())
    assert all(f"--column {name}={column}" in line for name, column in contact_lists.LIGGGHTS.items())
    assert max(map(len, text.splitlines())) <= WIDTH


@pytest.mark.parametrize("which", ["LAMMPS", "LIGGGHTS"])
def test_what_the_page_has_a_program_write_is_read_right(which: str, tmp_path: Path) -> None:
    """Breaks when a mapping exchanges grains or misses a column, so that forces pull or the stress is another one."""
    block = next(ContactList(example_path()).blocks())
    assert block.spheres is not None
    assert block.normal_force is not None
    assert block.shear_force is not None
    force = block.normal_force * block.normal + block.shear_force
    first = np.zeros((3, block.size))  # centre of grain 1; only differences matter
    values = {"id1": block.spheres[0], "id2": block.spheres[1], "fn": block.normal_force}
    for k in range(3):
        values |= {f"l{k + 1}": block.branch[k], f"fs{k + 1}": block.shear_force[k], f"f{k + 1}": force[k],
                   f"{'xyz'[k]}1": first[k], f"{'xyz'[k]}2": block.branch[k]}
    columns = getattr(contact_lists, which)
    known = example_facts()
    path = dumped(tmp_path, columns, {name: values[name] for name in columns})
    found = summarise(path, volume=known["V"], grains=known["N_grains"], columns=columns, spheres_only=True,
                      material=Material(shear_modulus=known["Gs"], poisson_ratio=known["nu"]))
    expected = contact_lists.packing()
    # normals of the sheared cell are up to 4e-4 rad off the branches, and the radii are not in the dump
    assert found.stress == pytest.approx(expected.stress, abs=1e-3 * 1e5)
    assert found.kinematic is not None
    assert expected.kinematic is not None
    assert found.kinematic.component("C3333") == pytest.approx(expected.kinematic.component("C3333"), rel=1e-3)


def test_numbers_of_atoms_are_of_the_first_and_the_second() -> None:
    """Breaks when a page's mapping takes the first atom for grain 1: differences and forces point to the first."""
    assert contact_lists.LAMMPS["id2"] == "c_ids[1]"
    assert contact_lists.LAMMPS["id1"] == "c_ids[2]"
    assert [contact_lists.LIGGGHTS[name] for name in ("x2", "y2", "z2", "id2")] == [f"c_fc[{k}]" for k in (1, 2, 3, 7)]


def test_every_estimate_is_above_the_relaxed_stiffness() -> None:
    """Breaks when the record no longer has the order that captions state, the model alone highest."""
    for packing in dem.packings():
        for name in ("C3333", "C2323"):
            relaxed = packing.stiffness["relaxed"][name]
            ways = ["eq. (1)", "eq. (5)", "affine", "rotations only", FROM_SCENE[Hypothesis.KINEMATIC]]
            found = [dem._row(packing, way)[name] for way in (*ways, FROM_LIST[Hypothesis.KINEMATIC])]
            assert min(found) > relaxed
            assert max(found) == packing.stiffness[FROM_SCENE[Hypothesis.KINEMATIC]][name]


def test_shear_is_farther_off_than_compression_and_worst_where_contacts_are_few() -> None:
    """Breaks when the bound does not fall with the coordination number of spheres as the page says."""
    spheres = sorted((packing for packing in dem.packings() if packing.collinear),
                     key=lambda packing: packing.coordination_number)
    for name in dem.DIAGONAL:
        bounds = [packing.bound[name] for packing in spheres]
        assert bounds == sorted(bounds, reverse=True)
        assert spheres[0].recovered[name] == min(packing.recovered[name] for packing in spheres)
    for packing in dem.packings():
        assert min(packing.bound[name] for name in ("C2323", "C1212")) > max(
            packing.bound[name] for name in ("C1111", "C3333"))
        assert max(packing.bound[name] for name in ("C1122", "C1133")) < 0.5  # far too small, not too large


def test_the_sums_bracket_the_bulk_modulus() -> None:
    """Breaks when the caption's bracket is not there, or eq. (1) is more than an eighth too high."""
    for row in rows(dem.bulk_table())[1:]:
        kinematic, static, relaxed = map(number, row[1:4])
        assert static < relaxed < kinematic < 1.125 * relaxed
        assert number(row[5]) < number(row[6]) / 4


def test_eq_5_recovers_less_than_half_in_shear() -> None:
    """Breaks when the caption on spheres or the sentence on clumps is cut off from the record."""
    for packing in dem.packings():
        if packing.collinear:
            assert max(packing.recovered["C2323"], packing.recovered["C1212"]) < 0.5
            assert max(packing.recovered[name] for name in dem.DIAGONAL) < 1
    text = dem.recovered_words().text
    assert "$C_{1111}$ of E_clump_p100" in text
    assert "no lower bound" in text
    assert max(dem._model_shares()) < 0.02  # the static model recovers next to nothing


def test_spins_are_about_half() -> None:
    """Breaks when the share of spins is no longer what the page calls about half."""
    shares = [number(cell) for row in rows(dem.spins_table())[1:] for cell in row[1:]]
    assert min(shares) > 40
    assert max(shares) < 65


def test_what_the_affine_probe_adds_is_the_stress() -> None:
    """Breaks when the difference from eq. (1) is not of the order of p/C3333: within a quarter of it here."""
    for row in rows(dem.affine_table())[1:]:
        assert number(row[-2]) == pytest.approx(number(row[-1]), rel=0.25)


def test_clumps_are_stiffer_on_the_wrong_axis_by_their_normals() -> None:
    """Breaks when the sentence on clumps is cut off from the record."""
    clumps = next(packing for packing in dem.packings() if not packing.collinear)
    way = FROM_LIST[Hypothesis.KINEMATIC]
    normals, branches = (dem._ratio(clumps.stiffness[f"{way}, fabric of {which}"], "C1111", "C3333")
                         for which in ("normals", "branches"))
    true = dem._ratio(clumps.stiffness["relaxed"], "C1111", "C3333")
    assert normals < 1 < true
    assert branches == pytest.approx(true, rel=0.01)


def test_the_packing_that_ships_gives_the_recorded_numbers() -> None:
    """Breaks when the library's answer moves away from the record, which then has to be written again."""
    assert f"{NAME}\n  packing  M 5753" in dem.live().text


def test_taken_tables_are_complete() -> None:
    """Breaks when the file of all components leaves out a packing or a way."""
    body = rows(dem.stiffness_table())[1:]
    assert len(body) == sum(len(packing.stiffness) for packing in dem.packings())
    assert all(len(row) == 8 for row in body)
