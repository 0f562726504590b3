"""Start-up: what is loaded before something needs it.

Modules are counted, not seconds: a time would be a verdict on the machine.
"""

from __future__ import annotations

import subprocess
import sys
from importlib import resources
from pathlib import Path

import pytest

SCENES = Path(str(resources.files("granular") / "data" / "scenes"))
NUMERIC = {"numpy", "scipy", "sympy", "pint", "matplotlib", "plotly", "pandas", "flint", "quadpy", "numba", "mpmath"}
HEAVY = NUMERIC | {"pydantic", "typer", "rich", "tomllib", "decimal", "json"}


def loaded(code, *arguments):
    """Names of all modules in a fresh interpreter after some code."""
    script = f"{code}\nimport sys; sys.stderr.write(' '.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", script, *map(str, arguments)], capture_output=True, text=True,
                          check=True, timeout=60)
    return set(done.stderr.split())


def test_import_granular_loads_next_to_nothing():
    # Breaks when a name that should wait is imported at once.
    bare, with_granular = loaded(""), loaded("import granular")
    added = {name.partition(".")[0] for name in with_granular - bare}
    assert not added & HEAVY
    assert added - sys.stdlib_module_names <= {"granular"}


def test_names_are_loaded_one_by_one():
    # Breaks when asking for a light name loads a heavy one.
    assert "pydantic" not in loaded("import granular; granular.AxialFabric; granular.Hypothesis")
    assert "numpy" not in loaded("import granular; granular.Scene; granular.Stiffness; granular.evaluate")


def test_the_entry_point_waits_for_its_libraries():
    # Breaks when a library loads before main can catch Ctrl-C.
    assert not {name.partition(".")[0] for name in loaded("from granular.__main__ import main")} & HEAVY


def run(*arguments):
    return ("import sys; from granular.__main__ import main\n"
            f"try: main({[str(argument) for argument in arguments]!r})\n"
            "except SystemExit as left: assert left.code == 0, left.code")


@pytest.mark.parametrize("arguments", [
    ("run", SCENES / "table_ii_3.toml"), ("run", SCENES / "wave_speeds.toml"),
    ("run", SCENES / "wave_speeds.toml", "--json"), ("run", SCENES / "wave_speeds.toml", "--route", "axial"),
    ("run", SCENES / "table_iii_3.toml"), ("run", SCENES / "table_v_2.toml"), ("plan", SCENES / "table_v_2.toml"),
    ("plan", SCENES / "wave_speeds.toml"), ("schema",), ("--version",), ("--help",),
], ids=lambda words: " ".join(Path(str(word)).name for word in words))
def test_commands_load_no_numeric_library(arguments):
    # Breaks when a scalar path imports NumPy, or a usual unit goes to pint: each costs as much as the whole run.
    assert not {name.partition(".")[0] for name in loaded(run(*arguments))} & NUMERIC


@pytest.mark.parametrize("name", ["table_ii_3.toml", "table_v_2.toml"])
def test_scenes_about_axis_3_load_nothing_for_tensors(name):
    # Breaks when what serves scenes without an axis is imported for the others: none of its modules is needed.
    assert not {module for module in loaded(run("run", SCENES / name)) if module.startswith("granular.general")}


def test_an_unusual_unit_loads_pint(tmp_path):
    # Breaks when the list of tests above forbids what a rare unit needs, or pint is never asked.
    path = tmp_path / "scene.toml"
    path.write_text((SCENES / "table_ii_1.toml").read_text("utf-8").replace("28 kPa", "0.2855 kgf/cm^2"), "utf-8")
    assert "pint" in loaded(run("run", path))
