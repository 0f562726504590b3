"""The command line: output, exit codes, and everything of the issue's list of bad input."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from importlib import resources
from pathlib import Path

import jsonschema
import pytest

from granular.__main__ import main
from granular.errors import CATALOGUE
from granular.routes.result import COMPONENTS
from granular.scene import Scene

SCENES = Path(str(resources.files("granular") / "data" / "scenes"))
CODES = {kind.__name__: kind.code for kind in CATALOGUE}
SOUND = """\
[grains]
shear_modulus = "31 GPa"
poisson_ratio = 0.21

[packing]
void_ratio = 0.5744
contact_normals = { D33 = 0.0 }

[branches]
anisotropy = { D33 = -0.3 }

[stress]
mean = "28 kPa"
"""


@pytest.fixture
def command(capsys):
    """Run a command in this process; give exit code, standard output and standard error."""
    def run(*arguments):
        with pytest.raises(SystemExit) as left:
            main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return left.value.code, captured.out, captured.err
    return run


def process(*arguments, **options):
    return subprocess.run([sys.executable, "-m", "granular", *map(str, arguments)], capture_output=True, text=True,
                          check=False, timeout=60, **options)


@pytest.fixture
def edited(tmp_path):
    """Write the sound scene with one piece of text replaced."""
    def write(old="", new=""):
        assert old in SOUND
        path = tmp_path / "scene.toml"
        path.write_text(SOUND.replace(old, new, 1) if old else SOUND + new, "utf-8")
        return path
    return write


# ---- answers


@pytest.mark.parametrize(("case", "ratio"), [
    (1, "C1111/C3333 = 678697/466603 = 1.4545491563491877"),
    (2, "C1111/C3333 = 4001/4793 = 0.8347590235760484"),
    (3, "C1111/C3333 = 452950/368827 = 1.2280825427639517"),
])
def test_table_ii_to_the_last_digit(command, case, ratio):
    # Breaks when the exact ratio is not found, or its decimal is not the double nearest to it.
    code, out, err = command("run", SCENES / f"table_ii_{case}.toml")
    assert (code, err) == (0, "")
    assert ratio in [line.strip() for line in out.splitlines()]


@pytest.mark.parametrize("name", [path.name for path in sorted(SCENES.glob("*.toml"))])
@pytest.mark.parametrize(("words", "columns"), [
    (("run",), 80), (("plan",), 80), (("run", "--explain"), 80), (("plan",), 45), (("plan",), 140)])
def test_output_fits_the_terminal(command, monkeypatch, name, words, columns):
    # Breaks when a line is wider than a terminal, or colours reach something that is none.
    monkeypatch.setenv("COLUMNS", str(columns))
    code, out, _ = command(*words, SCENES / name)
    assert code == 0
    assert max(map(len, out.splitlines())) <= columns
    assert "\x1b" not in out
    assert not any(line.endswith(" ") for line in out.splitlines())
    assert out.isascii()


def test_run_reports_its_evidence(command):
    # Breaks when a part of the report is lost: components, ratios, moduli, speeds, bound, route, effects, contacts.
    _, out, _ = command("run", SCENES / "wave_speeds.toml")
    for part in (*COMPONENTS, "MPa", "C1111/C3333 = ", "C2323/C1212 = ", "E1", "nu12", "m/s", "Thomsen", "error bound",
                 "static hypothesis", "closed_form", "simulated", "not called for", "opening: every contact",
                 "per (2 r_e)^3"):
        assert part in out


def test_run_without_density_has_no_waves(command):
    # Breaks when speeds are invented.
    code, out, _ = command("run", SCENES / "table_ii_1.toml")
    assert code == 0
    assert "m/s" not in out


def test_json_is_one_object_and_nothing_else(command):
    # Breaks when anything but the object is printed, or a key of the interface is lost.
    code, out, err = command("run", SCENES / "wave_speeds.toml", "--json")
    content = json.loads(out)
    assert (code, err) == (0, "")
    assert {"stiffness", "relative_error", "error_is", "axis", "reference_stiffness", "hypothesis", "route",
            "evaluations", "effects", "work", "contacts_per_volume", "contacts_per_volume_unit",
            "waves"} == set(content)
    assert [len(row) for row in content["stiffness"]["mandel"]] == [6] * 6
    assert "NaN" not in out and "Infinity" not in out


def test_options_reach_the_evaluation(command):
    # Breaks when --route or --rtol is read and dropped.
    content = json.loads(command("run", SCENES / "table_ii_3.toml", "--route", "axial", "--rtol", "1e-9", "--json")[1])
    assert content["route"] == "axial"
    assert content["evaluations"] > 0
    assert json.loads(command("plan", SCENES / "table_ii_3.toml", "--rtol", "1e-9", "--json")[1])["rtol"] == 1e-9


def test_schema_is_the_published_one(command):
    # Breaks when the command prints another schema than the file that ships.
    code, out, _ = command("schema")
    assert code == 0
    assert out == (SCENES.parent / "scene.schema.json").read_text("utf-8")
    jsonschema.Draft202012Validator.check_schema(json.loads(out))
    assert json.loads(out) == Scene.json_schema()


def test_version_and_help(command):
    # Breaks when the version or a command disappears from the front door.
    assert command("--version")[:2] == (0, "granular 0.1.0\n")
    code, out, _ = command("--help")
    assert code == 0
    for name in ("run", "plan", "plot", "check", "cost", "schema"):
        assert name in out
    assert command()[:2] == (0, out)


def test_plot_writes_the_file_and_says_so(command, tmp_path):
    # Breaks when the figure is not written where it was asked for.
    out = tmp_path / "fabric.svg"
    code, text, _ = command("plot", SCENES / "table_ii_3.toml", "--what", "fabric", "--out", out)
    assert (code, text) == (0, f"Wrote {out}\n")
    assert out.read_bytes().lstrip().startswith(b"<?xml")


@pytest.mark.parametrize("verdict", [0, 1])
def test_check_leaves_with_the_verdict(command, monkeypatch, verdict):
    # Breaks when a miss ends with exit code 0, which every script would take for agreement.
    monkeypatch.setattr("granular.checks.run_checks", lambda *, json_out: verdict)
    assert command("check")[0] == verdict


# ---- refusals

BAD_SCENES = [
    ("unknown key", "void_ratio", "void_ration", "UnknownKey", ["packing.void_ration", "void_ratio"]),
    ("unknown table", "[stress]", "[stres]", "UnknownKey", ["stres ", "stress"]),
    ("not TOML", "[stress]", "[stress", "NotToml", ["line 12"]),
    ("wrong unit", "28 kPa", "28 kg", "UnitOfOtherDimension", ["stress.mean", "28 kg", "kPa"]),
    ("unknown unit", "28 kPa", "28 kPx", "UnitUnknown", ["stress.mean", "kPx"]),
    ("D33 above", "D33 = 0.0", "D33 = 2.3", "FabricOutOfRange", ["contact_normals.D33 = 2.3", "-1 <= D33 <= 2"]),
    ("D33 below", "D33 = 0.0", "D33 = -1.1", "FabricOutOfRange", ["contact_normals.D33 = -1.1", "-1 <= D33 <= 2"]),
    ("D33 with D3333", "D33 = 0.0", "D33 = 0.0, D3333 = 3.0", "FabricOutOfRange", ["D3333 = 3.0", ">= 0"]),
    ("Dr above", "D33 = -0.3", "D33 = 2", "FabricOutOfRange", ["branches.anisotropy.D33 = 2", "-1 < D33 < 2"]),
    ("Dr below", "D33 = -0.3", "D33 = -1", "FabricOutOfRange", ["branches.anisotropy.D33 = -1", "-1 < D33 < 2"]),
    ("nu above", "0.21", "0.51", "ValueOutOfRange", ["grains.poisson_ratio = 0.51", "0 <= poisson_ratio <= 0.5"]),
    ("nu below", "0.21", "-0.1", "ValueOutOfRange", ["grains.poisson_ratio = -0.1"]),
    ("void ratio of zero", "0.5744", "0", "ValueOutOfRange", ["packing.void_ratio = 0", "void_ratio > 0"]),
    ("negative void ratio", "0.5744", "-0.5", "ValueOutOfRange", ["packing.void_ratio = -0.5"]),
    ("coordination of zero", "contact_normals =", "coordination_number = 0\ncontact_normals =", "ValueOutOfRange",
     ["packing.coordination_number = 0", "> 0"]),
    ("no coordination left", "0.5744", "1.7", "ValueOutOfRange", ["packing.void_ratio = 1.7", "coordination_number"]),
    ("NaN", "0.5744", "nan", "NotFinite", ["packing.void_ratio = nan"]),
    ("inf", "0.5744", "inf", "NotFinite", ["packing.void_ratio = inf"]),
    ("overflow", "0.5744", "1e400", "NotFinite", ["packing.void_ratio"]),
    ("overflow with a unit", "28 kPa", "1e400 Pa", "NotFinite", ["stress.mean"]),
    ("negative stress", "28 kPa", "-28 kPa", "ValueOutOfRange", ["stress.mean", "-28 kPa", "mean > 0 Pa"]),
    ("negative ratio", 'mean = "28 kPa"', 'mean = "28 kPa"\nratio = -0.5', "ValueOutOfRange", ["stress.ratio = -0.5"]),
    ("string for a number", "0.5744", '"0.5744"', "WrongType", ["packing.void_ratio", "quotation marks"]),
    ("list for a number", "0.5744", "[0.5744]", "WrongType", ["packing.void_ratio = [0.5744]"]),
    ("truth value", "0.5744", "true", "WrongType", ["packing.void_ratio = true"]),
    ("unicode minus", "28 kPa", "−28 kPa", "QuantityUnreadable", ["stress.mean"]),
    ("empty string", '"28 kPa"', '""', "QuantityUnreadable", ["stress.mean"]),
    ("no spread", 'mean = "28 kPa"',
     'mean = "28 kPa"\n[gradation]\ndistribution = "lognormal"\nmedian = "5 mm"\nspread = 1.0',
     "ValueOutOfRange", ["gradation.spread = 1.0", "spread"]),
    ("a curve that is not there", 'mean = "28 kPa"',
     'mean = "28 kPa"\n[gradation]\ndistribution = "curve"\nfile = "no_such.csv"',
     "FileUnreadable", ["no_such.csv", "does not exist"]),
    ("branches and a shape", 'mean = "28 kPa"', 'mean = "28 kPa"\n[shape]\naspect_ratio = 0.8',
     "ConflictingKeys", ["branches and shape"]),
    ("gradation known to 1e-14", 'mean = "28 kPa"',
     'mean = "28 kPa"\n[gradation]\ndistribution = "lognormal"\nmedian = "5 mm"\nspread = 1.5\n[model]\nrtol = 1e-15',
     "RouteOutOfDomain", ["rtol = 1e-15 with a gradation"]),
    ("static and sliding", "poisson_ratio = 0.21\n",
     'poisson_ratio = 0.21\nfriction_angle = "0 deg"\n[model]\nhypothesis = "static"\n', "ComplianceInfinite",
     ["infinite", "slip out", "friction_coefficient = 0.0"]),
    ("slip without friction", 'mean = "28 kPa"', 'mean = "28 kPa"\n[model]\neffects = ["kinetic", "slip"]',
     "MissingKey", ["friction_angle"]),
    ("accuracy", 'mean = "28 kPa"', 'mean = "28 kPa"\n[model]\nrtol = 1e-30', "RouteOutOfDomain", ["rtol = 1e-30"]),
]


def assert_refused(result, kind, parts):
    """Exit code 2, one line on standard error with class, code and the parts, nothing on standard output."""
    code, out, err = result
    assert code == 2, (code, out, err)
    assert out == ""
    assert len(err.splitlines()) == 1
    assert err.startswith(f"{kind} [{CODES[kind]}]: ")
    assert all(part in err for part in parts), err
    assert "Traceback" not in err


@pytest.mark.parametrize("case", BAD_SCENES, ids=[case[0] for case in BAD_SCENES])
def test_bad_scenes(command, edited, case):
    # Breaks when wrong input is answered, or refused with a traceback, without its name, or with another exit code.
    _, old, new, kind, parts = case
    path = edited(old, new)
    before = sorted(path.parent.iterdir())
    assert_refused(command("run", path), kind, parts)
    assert_refused(command("plan", path, "--json"), kind, parts)
    assert sorted(path.parent.iterdir()) == before


def test_overflowing_results_are_refused(command, edited):
    # Breaks when infinity reaches the output: the scene is in range, its stiffness is not.
    path = edited('"31 GPa"', "1.7e308")
    path.write_text(path.read_text("utf-8").replace('"28 kPa"', "1.7e308"), "utf-8")
    path.write_text(path.read_text("utf-8") + "[model]\n", "utf-8")
    assert_refused(command("run", path, "--json"), "ResultOutOfRange", ["1.8e+308"])


BAD_COMMAND_LINES = [
    (["run", "no_such.toml"], "FileUnreadable", ["no_such.toml", "does not exist"]),
    (["run", "."], "FileUnreadable", ["folder"]),
    (["run", ""], "FileUnreadable", ["folder"]),
    (["run"], "BadOption", ["SCENE"]),
    (["rum"], "BadOption", ["rum", "run"]),
    (["run", "a", "b"], "BadOption", ["b"]),
    (["run", "a", "--jsn"], "BadOption", ["--jsn"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol", "tiny"], "BadOption", ["tiny", "1e-12"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol", "0"], "ValueOutOfRange", ["rtol = 0"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol=-1e-9"], "ValueOutOfRange", ["rtol = -1e-09"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol", "nan"], "NotFinite", ["rtol = nan"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol", "1e400"], "NotFinite", ["rtol = inf"]),
    (["run", SCENES / "table_ii_1.toml", "--rtol", "1e-17"], "RouteOutOfDomain", ["1e-17", "certified"]),
    (["run", SCENES / "table_ii_1.toml", "--route", "axil"], "UnknownChoice", ["axil", "axial"]),
    (["plot", SCENES / "table_ii_1.toml", "--what", "fabrics", "--out", "x.svg"], "FigureNotKnown", ["fabrics"]),
    (["plot", SCENES / "table_ii_1.toml", "--what", "fabric", "--out", "x.xyz"], "FigureNotKnown", ["xyz"]),
    (["plot", SCENES / "table_ii_1.toml", "--what", "fabric", "--out", "no/such/x.svg"], "FigureNotWritten",
     ["no/such"]),
    (["plot", "no_such.toml", "--what", "fabric", "--out", "x.svg"], "FileUnreadable", ["no_such.toml"]),
    (["--color", "run"], "BadOption", ["--color"]),
    (["cost", "--rounds", "1"], "BadOption", ['--rounds = "1"', "2"]),
    (["cost", "--rounds", "many"], "BadOption", ["many"]),
]


@pytest.mark.parametrize("case", BAD_COMMAND_LINES, ids=lambda case: " ".join(Path(word).name for word in case[0]))
def test_bad_command_lines(command, tmp_path, monkeypatch, case):
    # Breaks when a wrong command line gets a traceback, another exit code, or leaves a file behind.
    arguments, kind, parts = case
    monkeypatch.chdir(tmp_path)
    assert_refused(command(*arguments), kind, parts)
    assert list(tmp_path.iterdir()) == []


def test_a_huge_file_is_refused_before_it_is_parsed(command, tmp_path):
    # Breaks when megabytes are parsed before they are refused.
    path = tmp_path / "huge.toml"
    with path.open("wb") as file:
        file.truncate(1 << 34)  # 16 GiB of nothing, no space on the disk
    assert_refused(command("run", path), "FileTooLarge", ["1048576"])


# ---- as a process


def test_as_a_process(edited):
    # Breaks when the installed entry point differs from the function: exit codes, streams, one line.
    good = process("run", SCENES / "table_ii_1.toml")
    assert (good.returncode, good.stderr) == (0, "")
    assert "678697/466603" in good.stdout
    bad = process("run", edited("28 kPa", "28 kg"))
    assert_refused((bad.returncode, bad.stdout, bad.stderr), "UnitOfOtherDimension", ["stress.mean"])


@pytest.mark.parametrize("environment", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C"}, {"COLUMNS": "20"},
                                         {"PYTHONWARNINGS": "error"}, {"TERM": "dumb"}])
def test_in_odd_surroundings(edited, environment):
    # Breaks when an encoding, a narrow window or a strict interpreter turns a refusal or a report into a traceback.
    surroundings = {**os.environ, **environment}
    bad = process("run", edited("28 kPa", "−28 kPа °"), env=surroundings)
    assert_refused((bad.returncode, bad.stdout, bad.stderr), "QuantityUnreadable", ["stress.mean"])
    assert process("run", SCENES / "wave_speeds.toml", env=surroundings).returncode == 0


def test_a_reader_that_goes_away_is_no_error():
    # Breaks when `granular run ... | head -1` prints a traceback.
    read, write = os.pipe()
    os.close(read)
    with os.fdopen(write, "w") as closed:
        done = subprocess.run([sys.executable, "-m", "granular", "run", SCENES / "table_ii_1.toml"], stdout=closed,
                              stderr=subprocess.PIPE, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_is_one_line():
    # Breaks when a result that could not be written passes for done.
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([sys.executable, "-m", "granular", "run", SCENES / "table_ii_1.toml"], stdout=full,
                              stderr=subprocess.PIPE, text=True, check=False, timeout=60)
    assert_refused((done.returncode, "", done.stderr), "OutputUnwritable", ["no space left"])


@pytest.mark.skipif(os.name != "posix", reason="needs a shell that can close a stream")
def test_a_closed_output_is_one_line():
    # Breaks when a missing standard output gets a traceback.
    done = subprocess.run(["/bin/sh", "-c", f"{sys.executable} -m granular run {SCENES / 'table_ii_1.toml'} >&-"],
                          capture_output=True, text=True, check=False, timeout=60)
    assert_refused((done.returncode, done.stdout, done.stderr), "OutputUnwritable", ["closed"])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs a pipe with a name")
def test_ctrl_c_is_clean(tmp_path):
    # Breaks when an interrupted command prints a traceback. It waits for a scene that never comes.
    path = tmp_path / "scene.toml"
    os.mkfifo(path)
    waiting = subprocess.Popen([sys.executable, "-m", "granular", "run", path], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    try:
        with open_for_writing(path, patience=60.0):
            # A signal that falls between Python's last look and the system call is seen only when the call returns,
            # which here it never does; half a second later the command certainly waits inside the call.
            time.sleep(0.5)
            waiting.send_signal(signal.SIGINT)
            out, err = waiting.communicate(timeout=60)
    finally:
        waiting.kill()
        waiting.wait()
    assert (waiting.returncode, out, err) == (130, "", "")


def open_for_writing(path, *, patience):
    """Open a named pipe once somebody reads from it."""
    for _ in range(int(patience / 0.05)):
        try:
            return os.fdopen(os.open(path, os.O_WRONLY | os.O_NONBLOCK), "w")
        except OSError:
            time.sleep(0.05)
    raise AssertionError("nobody opened the pipe")
