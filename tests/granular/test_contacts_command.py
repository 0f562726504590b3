"""``granular contacts``: its output, its exit codes, the model beside the list, and the comparison of packings."""

from __future__ import annotations

import gzip
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from granular.__main__ import main
from granular.array_stiffness import axial_stiffness
from granular.contacts.by_angle import ByAngle
from granular.contacts.comparison import compare_folder, read_comparison, write_comparison
from granular.contacts.estimate import estimated_forces
from granular.contacts.example import example_folder
from granular.contacts.lengths import Lengths
from granular.contacts.material import Material
from granular.contacts.prediction import (
    EQUAL_CONTACTS,
    ESTIMATED_FORCES,
    FittedFabric,
    distance,
    equal_contacts,
    fitted_fabric,
    predictions,
)
from granular.contacts.summary import summarise
from granular.contacts.touching import PAGE, Touching
from granular.errors import FileUnreadable, MissingKey, ValueOutOfRange, WrongType
from granular.figures.files import static_bytes
from granular.figures.packings import packings_figure
from granular.hypothesis import Hypothesis

sys.path.insert(0, str(Path(__file__).parent))
from contact_lists import DEM, EXAMPLE, FACTS, HEADER, SOUND, icosahedron, random_block, written

VOLUME = str(FACTS["V"])
MATERIAL = ("--shear-modulus", "29 GPa", "--poisson-ratio", "0.2", "--friction", "0.2126")
SIX = ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212")


@pytest.fixture
def command(capsys):
    """Run a command in this process; give exit code, standard output and standard error."""
    def run(*arguments):
        with pytest.raises(SystemExit) as left:
            main(["contacts", *map(str, arguments)])
        captured = capsys.readouterr()
        return left.value.code, captured.out, captured.err
    return run


def test_json_has_the_keys_of_the_interface(command):
    # Breaks when a key of the fixed interface is renamed, or something else is printed beside the object.
    code, out, err = command(EXAMPLE, "--volume", VOLUME, "--grains", 2000, "--json")
    told = json.loads(out)
    assert (code, err) == (0, "")
    assert (told["contacts"], told["coordination_number"]) == (5753, 5.753)
    assert {"N", "D33"} <= set(told["fabric"]["normals"]) & set(told["fabric"]["branches"])
    assert np.array(told["sum"]["mandel"]).shape == np.array(told["prediction"]["mandel"]).shape == (6, 6)
    assert set(SIX) <= set(told["sum"]) & set(told["prediction"])
    assert told["sum"]["C2323"] == pytest.approx(told["sum"]["mandel"][3][3] / 2)
    assert np.array(told["stress"]).shape == (3, 3)


def test_everything_is_told_with_the_material(command):
    # Breaks when a part of the report is lost: forces by direction, sliding, both hypotheses, both ways of the model.
    code, out, err = command(EXAMPLE, "--volume", VOLUME, "--grains", 2000, "--json", *MATERIAL)
    told = json.loads(out)
    assert (code, err) == (0, "")
    assert told["sliding"] == pytest.approx(2004 / 5753, abs=1e-9)
    every = [told["prediction"], *told["prediction"]["others"]]
    assert [(one["contact_stiffness"], one["hypothesis"]) for one in every] == [
        (source, hypothesis) for source in (EQUAL_CONTACTS, ESTIMATED_FORCES) for hypothesis in ("kinematic", "static")]
    assert all(0 < one["distance"] < 0.3 for one in every)
    assert len(told["by_angle"]["estimated_normal_force"]) == 18
    assert sum(told["by_angle"]["contacts"]) == 5753
    assert told["branch_lengths"]["least"] <= told["branch_lengths"]["quantiles"]["0.5"] <= 0.002


def test_fabric_by_two_routes():
    # Breaks when the sums of this package and its fabric tensors of lists of directions differ.
    packing = summarise(EXAMPLE, volume=FACTS["V"])
    tensor = packing.directions.N2
    assert tensor == pytest.approx(packing.normals, abs=1e-7)  # normals here are rounded to seven digits
    assert [test.significant() for test in packing.tests] == [False, True, False, False]


@pytest.mark.parametrize("width", [80, 60, 45])
def test_text_is_for_people(command, monkeypatch, width):
    # Breaks when the text loses a section, grows wider than its terminal, or breaks between a name and its number.
    monkeypatch.setenv("COLUMNS", str(width))
    code, out, _ = command(EXAMPLE, "--volume", VOLUME, *MATERIAL)
    assert code == 0
    for word in ("Fabric", "without rattlers", "eq. (1)", "eq. (5)", "(23)", "sliding", "needs --grains", "N33 0.34",
                 "greatest 0.002", "s33 128", "80-90"):
        assert word in out
    assert max(map(len, out.splitlines())) <= width


@pytest.mark.parametrize("width", [80, 60])
def test_a_comparison_fits_its_terminal(command, monkeypatch, width):
    # Breaks when the table of a comparison grows wider than a terminal, or loses rows where it folds.
    monkeypatch.setenv("COLUMNS", str(width))
    code, out, _ = command("--compare", example_folder())
    assert code == 0
    assert max(map(len, out.splitlines())) <= width
    assert out.count("relaxed, friction active") == (1 if width == 80 else 2)
    assert "within 0.019 % of C3333" in " ".join(out.split())


def test_stiffer_contacts_of_longer_branches_are_told(command, tmp_path):
    # Breaks when the part of eq. (1) that a model with one kn misses is another one than the list has.
    axes, long = icosahedron(), np.array([1, 1, 1, 2, 2, 2])
    rows = np.array([*(1e-3 * long * axes), *axes, *(np.array([[3e5], [2e5]]) * long)]).T
    path = tmp_path / "list.csv"
    np.savetxt(path, rows, delimiter=",", header="l1,l2,l3,n1,n2,n3,kn,ks", comments="", fmt="%.17g")
    told = json.loads(command(path, "--volume", 1e-8, "--json")[1])
    assert told["stiffer_where_longer"] == pytest.approx((1 + 8) / 2 / ((1 + 4) / 2 * (1 + 2) / 2), rel=1e-14)
    assert "1.2000 times" in " ".join(command(path, "--volume", 1e-8)[1].split())
    assert summarise(EXAMPLE, volume=1.0).stiffer_where_longer == pytest.approx(1, abs=2e-4)  # nearly equal lengths


def test_a_list_of_directions_alone_is_welcome(command, tmp_path):
    # Breaks when forces or stiffnesses are needed for the fabric.
    path = written(tmp_path / "a.csv", "l1,l2,l3,n1,n2,n3", "1,0,0,1,0,0", "0,1,0,0,1,0", "0,0,1,0,0,1")
    code, out, _ = command(path, "--volume", 1, "--json")
    told = json.loads(out)
    assert code == 0
    assert told["stress"] is None
    assert "kn and ks" in told["sum"]["refused"]
    assert told["coordination_number_without_rattlers"] is None
    code, out, _ = command(path, "--volume", 1)
    assert code == 0
    assert "the list has no contact forces" in out


def test_one_contact_is_a_list(command, tmp_path):
    # Breaks when a fabric that the model cannot have, or forces that cannot balance, end in a traceback.
    code, out, _ = command(written(tmp_path / "a.csv", HEADER, SOUND[2]), "--volume", 1e-8, "--json", *MATERIAL)
    told = json.loads(out)
    assert code == 0
    assert "FabricOutOfRange" in told["prediction"]["refused"]
    assert "span" in told["static_sum"]["refused"]
    assert command(written(tmp_path / "a.csv", HEADER, SOUND[2]), "--volume", 1e-8, *MATERIAL)[0] == 0


@pytest.mark.parametrize(("arguments", "words"), [
    ([], ["BadOption", "no contact list"]), ([EXAMPLE], ["BadOption", "--volume is not given", "--volume 1.3e-5"]),
    ([EXAMPLE, "--volume", "0"], ["ValueOutOfRange", "volume = 0.0"]),
    ([EXAMPLE, "--volume", "nan"], ["ValueOutOfRange", "volume = nan"]),
    ([EXAMPLE, "--volume", "much"], ["BadOption", "--volume", "number"]),
    ([EXAMPLE, "--volume", VOLUME, "--grains", "1000"], ["ValueOutOfRange", "1966 or more"]),
    ([EXAMPLE, "--volume", VOLUME, "--column", "n1"], ["BadOption", "NAME=COLUMN"]),
    ([EXAMPLE, "--volume", VOLUME, "--column", "n1=a", "--column", "n1=b"], ["BadOption", "given twice"]),
    ([EXAMPLE, "--volume", VOLUME, "--shear-modulus", "29 kg", "--poisson-ratio", "0.2"], ["BadOption", "29 kg"]),
    ([EXAMPLE, "--volume", VOLUME, "--shear-modulus", "29e9"], ["ConflictingKeys", "without the other"]),
    ([EXAMPLE, "--volume", VOLUME, "--plot", "a.svg", "--out", "b.svg"], ["FigureNotKnown", "--plot all --out a.svg"]),
    ([EXAMPLE, "--volume", VOLUME, "--plot", "roses", "--out", "a.jpg"], ["FigureNotKnown", ".svg"]),
    ([EXAMPLE, "--volume", VOLUME, "--plot", "roses"], ["BadOption", "without --out"]),
    ([EXAMPLE, "--volume", VOLUME, "--cell", "0", "0", "0"], ["ValueOutOfRange", "cell = 0 0 0"]),
    (["--compare", "no_such_folder"], ["FileUnreadable", "no packing"]),
    ([EXAMPLE, "--compare", "folder"], ["BadOption", "one or the other"]),
    ([EXAMPLE, "--volume", VOLUME, "--out", "x.json"], ["BadOption", "without --plot or --compare"]),
])
def test_wrong_input_is_one_line_and_exit_code_2(command, arguments, words):
    # Breaks when a mistake ends in a traceback, in a wrong exit code, or without a remedy.
    code, out, err = command(*arguments)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    for word in words:
        assert word in err


def test_long_readings_say_how_far_they_are(command, monkeypatch):
    # Breaks when a long reading looks like one that hangs, or when progress mixes with the result.
    monkeypatch.setattr("granular.contacts.command.PATIENCE", 0.0)
    code, out, err = command(EXAMPLE, "--volume", VOLUME, "--json")
    assert (code, err) == (0, "Read 5,753 contacts\n")
    json.loads(out)


def test_nothing_heavy_is_loaded_for_a_short_list():
    # Breaks when a short list waits for a compiler, or CSV for a library of Parquet.
    code = ("import sys; from granular.__main__ import main\n"
            f"try: main(['contacts', {str(EXAMPLE)!r}, '--volume', '1e-5', '--json'])\n"
            "except SystemExit: pass\nsys.stderr.write(' '.join(sys.modules))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    loaded = {name.partition(".")[0] for name in done.stderr.split()}
    assert not loaded & {"numba", "pyarrow", "matplotlib", "pandas", "sympy"}


def test_equal_contacts_of_any_stiffness_ratio():
    # Breaks when the two ends of Poisson's ratio do not span all others: between them the model itself is known.
    fabric = FittedFabric(D33=0.4, Dr33=-0.3, length=1.0, inverse_length=1.0)
    for hypothesis in Hypothesis:
        for nu in (0.0, 0.21, 0.37, 0.5):
            known = axial_stiffness(0.4, -0.3, poisson_ratio=nu, kinetic=False, hypothesis=hypothesis)
            found = equal_contacts(fabric, 2 * (1 - nu) / (2 - nu), hypothesis)
            assert found == pytest.approx(known, rel=1e-12, abs=1e-14)
    frictionless = equal_contacts(fabric, 0.0, Hypothesis.KINEMATIC)
    assert frictionless[2:4] == pytest.approx((frictionless[5], frictionless[4]), rel=1e-12)  # Cauchy symmetry


def test_the_fit_recovers_the_fabric_that_made_the_list(tmp_path):
    # Breaks when D33, Dr33 or l_e is fitted to something else than the density and the lengths of the model.
    turned = [icosahedron()]
    rng = np.random.default_rng(2)
    for _ in range(40):
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        turned.append(turn @ icosahedron())
    normal = np.concatenate(turned, axis=1)
    length = 2e-3 * (1 - 0.3 * (1.5 * normal[2] ** 2 - 0.5))
    rows = np.array([*(length * normal), *normal]).T
    np.savetxt(tmp_path / "list.csv", rows, delimiter=",", header="l1,l2,l3,n1,n2,n3", comments="", fmt="%.17g")
    found = fitted_fabric(summarise(tmp_path / "list.csv", volume=1.0))
    # each set of six axes averages polynomials of degree five exactly, so that <l^2> has only the error of degree four
    assert (found.D33, found.Dr33) == (pytest.approx(0.0, abs=1e-12), pytest.approx(-0.3, rel=1e-12))
    assert found.length == pytest.approx(2e-3, rel=1e-9)
    assert 1 / found.inverse_length == pytest.approx(2e-3, rel=1e-3)  # l^-2 is no polynomial; 246 axes average it


def test_the_model_repeats_a_list_that_is_as_it_assumes(tmp_path):
    # Breaks when the unit or the mean stiffness of the prediction is off: here list and model are the same assembly.
    axes = icosahedron()
    rows = np.array([*(2e-3 * axes), *axes, *np.full((3, 6), [[1.0], [3e5], [2e5]])]).T
    np.savetxt(tmp_path / "list.csv", rows, delimiter=",", header="l1,l2,l3,n1,n2,n3,fn,kn,ks", comments="",
               fmt="%.17g")
    packing = summarise(tmp_path / "list.csv", volume=1e-8)
    kinematic, static = predictions(packing)[:2]
    assert kinematic.distance == pytest.approx(0, abs=1e-12)
    assert static.distance == pytest.approx(0, abs=1e-12)
    normal, shear = estimated_forces(packing)
    full = packing.by_angle.contacts > 0
    assert normal[full] == pytest.approx(np.ones(full.sum()), rel=1e-12)
    assert shear[full] == pytest.approx(np.zeros(full.sum()), abs=1e-12)


def test_by_angle_agrees_with_a_direct_count():
    # Breaks when a class is off by one, or the meridian has the wrong sign.
    block, classes = random_block(4000), ByAngle()
    classes.add(block, (block.kn, block.ks))
    angle = np.degrees(np.arccos(np.abs(block.normal[2])))
    here = (angle >= 40) & (angle < 45)
    assert classes.contacts[8] == here.sum()
    assert classes.mean("normal_force")[8] == pytest.approx(block.normal_force[here].mean(), rel=1e-12)
    assert classes.scatter("kn")[8] == pytest.approx(block.kn[here].std(), rel=1e-6)
    upwards = block.normal * np.sign(block.normal[2])
    meridian = np.array([0, 0, 1])[:, None] - upwards * upwards[2]
    from_below = block.shear_force * np.sign(block.normal[2])  # on the upper grain by the lower
    along = np.sum(from_below * meridian, axis=0) / np.sqrt(np.sum(meridian**2, axis=0))
    assert classes.mean("meridian_force")[8] == pytest.approx(along[here].mean(), rel=1e-9)
    wide = classes.merged(2)
    assert wide.contacts[4] == classes.contacts[8] + classes.contacts[9]
    assert wide.contacts @ (1 / wide.relative_density()) == pytest.approx(
        np.sum(wide.contacts.sum() * -np.diff(np.cos(np.radians(wide.degrees)))), rel=1e-12)


def test_lengths_and_counts_in_little_memory():
    # Breaks when a quantile leaves its stated accuracy, or a grain on another page is counted twice.
    rng, lengths, touching = np.random.default_rng(5), Lengths(), Touching()
    sizes = rng.lognormal(-6, 0.5, 5000)
    lengths.add(np.array([sizes, 0 * sizes, 0 * sizes]))
    for share in (0.1, 0.5, 0.9):
        assert lengths.quantile(share) == pytest.approx(np.quantile(sizes, share), rel=1e-3)
    assert (lengths.quantile(0.0), lengths.quantile(1.0)) == (sizes.min(), sizes.max())
    touching.add(np.array([[1, 1, PAGE + 1], [2, 3, 5 * PAGE]]))
    touching.add(np.array([[2], [7]]))
    assert (touching.with_any, touching.with_one) == (6, 4)


def test_fewer_grains_than_touch_are_refused():
    # Breaks when a coordination number above what the list can have is told.
    with pytest.raises(ValueOutOfRange, match="2 or more"):
        summarise(EXAMPLE, volume=1.0, grains=1)


def test_comparison_of_the_example(command, tmp_path):
    # Breaks when eq. (1) leaves the affine probe, or the data are not what the table shows.
    code, out, _ = command("--compare", example_folder(), "--out", tmp_path / "dem.json")
    data = json.loads((tmp_path / "dem.json").read_text("utf-8"))["packings"][0]
    assert code == 0
    assert f"{data['stiffness']['eq. (1)']['C3333'] / 1e6:.1f}" in out
    assert json.loads(command("--compare", example_folder(), "--json")[1])["packings"] == [data]
    assert data["affine_miss"] < 5e-3
    assert 1.2 < data["bound"]["C3333"] < 1.4
    assert 0.3 < data["recovered"]["C3333"] < 0.6


def test_the_picture_of_packings_is_drawn_from_its_data(tmp_path):
    # Breaks when records do not come back as they were written, or the picture needs what a packing may lack.
    packings = compare_folder(example_folder())
    write_comparison(packings, tmp_path / "dem.json")
    again = read_comparison(tmp_path / "dem.json")
    assert again == packings
    del again[0].stiffness["rotations only"]
    assert static_bytes(packings_figure(again), "svg").startswith(b"<?xml")
    for text, kind in ((None, FileUnreadable), ("{", WrongType)):
        path = tmp_path / "other.json"
        if text is not None:
            path.write_text(text, "utf-8")
        with pytest.raises(kind):
            read_comparison(path)


def test_a_wrong_sum_fails_the_comparison(command, tmp_path):
    # Breaks when a comparison always agrees: here the recorded probe is 1 % stiffer.
    known = json.loads((example_folder() / "C_A1_SR15_meta.json").read_text("utf-8"))
    known["affine_probe"]["voigt_elastic"][2][2] *= 1.01
    (tmp_path / "x_contacts.csv.gz").write_bytes(EXAMPLE.read_bytes())
    meta = tmp_path / "x_meta.json"
    meta.write_text(json.dumps(known), "utf-8")
    assert command("--compare", tmp_path)[0] == 1
    for text, kind in (("{}", MissingKey), ("{", WrongType), (json.dumps(known | {"V": "1"}), MissingKey),
                       (json.dumps({key: known[key] for key in ("V", "N_grains", "Gs", "nu", "mu", "e")}), MissingKey)):
        meta.write_text(text, "utf-8")
        with pytest.raises(kind):
            compare_folder(tmp_path)
    meta.unlink()
    with pytest.raises(FileUnreadable):
        compare_folder(tmp_path)


def test_a_packing_to_be_compared_may_be_plain_text(tmp_path):
    # Breaks when only compressed lists are found, or a record does not say where its packing is from.
    (tmp_path / "x_contacts.csv").write_bytes(gzip.decompress(EXAMPLE.read_bytes()))
    (tmp_path / "x_meta.json").write_text((example_folder() / "C_A1_SR15_meta.json").read_text("utf-8"), "utf-8")
    (packing,) = compare_folder(tmp_path)
    assert (packing.name, packing.agrees) == ("x", True)
    assert packing.made_by.startswith("YADE")
    # equal spheres of radius 1 mm that overlap by about 1e-4 of it
    assert packing.length_ratio == pytest.approx(1, abs=1e-3)


@pytest.mark.skipif(not DEM.is_dir(), reason="the packings are not part of the repository")
def test_every_packing_agrees_with_its_affine_probe():
    # Breaks when eq. (1) is off in any component of any packing by more than 0.5 % of C3333.
    packings = compare_folder(DEM)
    assert len(packings) >= 5
    assert all(packing.agrees for packing in packings)


def test_material_from_python():
    # Breaks when what the command line takes cannot be given in Python.
    packing = summarise(EXAMPLE, volume=FACTS["V"], material=Material(shear_modulus=29e9, poisson_ratio=0.2))
    assert distance(packing.kinematic, packing.kinematic) == 0
