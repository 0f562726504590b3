"""Sweeps on a page: the command with its answer, a run that is killed and gone on with, what can be kept, and maps."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import granular
from granular.figures.page import Static
from granular.figures.sweep_maps import effects_map, sweep_maps
from granular.sweeps import Sweep
from granular.sweeps.outputs import OUTPUTS, REFUSALS
from granular.sweeps.run import run_sweep
from page_tools.commands import COLOURED, WIDTH
from page_tools.markup import Markup, plain, table

if TYPE_CHECKING:
    import xarray as xr

FILE = "_data/sweep.toml"
"""The sweep of the first example."""

D33, RATIO, HYPOTHESIS, RTOL = "packing.contact_normals.D33", "stress.ratio", "model.hypothesis", "model.rtol"

WEAK = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "12 deg"},
        "packing": {"void_ratio": 0.5744}, "branches": {"anisotropy": {"D33": -0.001}},
        "stress": {"mean": "28 kPa", "ratio": 1.0001}}
"""A scene that is nearly isotropic, for the map of effects."""

EFFECT_GRID = {D33: {"start": 1e-10, "stop": 1.0, "num": 21, "spacing": "log"},
               RTOL: {"start": 1e-9, "stop": 1e-1, "num": 9, "spacing": "log"}}


@cache
def _kept() -> tempfile.TemporaryDirectory[str]:
    """A folder with the sweep file, as long as this page is computed."""
    kept = tempfile.TemporaryDirectory()
    shutil.copy(FILE, kept.name)
    return kept


def _folder() -> Path:
    return Path(_kept().name)


def command(*options: str) -> Markup:
    """Run ``granular sweep`` on the example, and show it with its answer."""
    shell = {name: value for name, value in os.environ.items() if name not in COLOURED}
    words = ["sweep", Path(FILE).name, *options]
    done = subprocess.run([sys.executable, "-m", "granular", *words], check=True, capture_output=True, encoding="utf-8",
                          cwd=_folder(), env={**shell, "COLUMNS": str(WIDTH), "PYTHONUTF8": "1"})
    return Markup(f"```console\n$ {' '.join(['granular', *words])}\n{done.stdout}```\n")


def opened(name: str) -> xr.Dataset:
    """The dataset that the command has written."""
    return granular.open_sweep(_folder() / name)


def variables(dataset: xr.Dataset) -> Markup:
    """Coordinates and variables of a dataset with their units."""
    rows = [[f"`{name}`", " × ".join(str(size) for size in array.shape), array.attrs.get("units", ""),
             plain(array.attrs.get("long_name", ""))]
            for name, array in (*dataset.coords.items(), *dataset.data_vars.items())]
    return table(["name", "size", "unit", "what it is"], rows, label="tab-sweep-variables", align="lrll",
                 caption="Coordinates and variables of the example.")


def outputs() -> Markup:
    """Everything that can be kept of a point."""
    rows = [[f"`{output.name}`", ", ".join(f"`{variable.name}`" for variable in output.variables),
             ", ".join(dict.fromkeys(variable.unit or "none" for variable in output.variables))]
            for output in OUTPUTS.values()]
    rows.append(["always", f"`{REFUSALS.name}`", "none"])
    return table(["output", "variables", "units"], rows, label="tab-sweep-outputs",
                 caption="What a sweep can keep of every point.")


def provenance(dataset: xr.Dataset) -> Markup:
    """Attributes that say where the numbers come from; hashes by their beginning."""
    rows = [[f"`{name}`", plain(text if len(text := str(value)) <= 24 else text[:24] + "…")]
            for name, value in dataset.attrs.items()]
    return table(["attribute", "value"], rows, label="tab-sweep-attributes",
                 caption="Attributes of the example; long ones are cut here.")


def ratio_maps(dataset: xr.Dataset) -> Static:
    """Horizontal over vertical compression by both hypotheses."""
    return Static(sweep_maps(dataset, "C1111_over_C3333", x=D33, y=RATIO, panels=HYPOTHESIS))


def map_of_effects() -> Static:
    """Which effects a nearly isotropic scene gets, by its anisotropy and by the wanted accuracy."""
    return Static(effects_map(granular.sweep(WEAK, grid=EFFECT_GRID, outputs=["effects"]), x=D33, y=RTOL))


def gone_on_with() -> Markup:
    """Kill a run after some chunks, go on, and compare with the undisturbed store byte for byte."""
    sweep, out = Sweep.from_toml(FILE), _folder() / "killed"
    script = ("import os, signal, sys\nfrom granular.commands import run_command\n"
              "from granular.sweeps.store import Store\n"
              "record = Store._record\n"
              "def killing(self, line):\n    record(self, line)\n"
              "    if len(self.finished) == 3:\n        os.kill(os.getpid(), signal.SIGKILL)\n"
              "Store._record = killing\nrun_command(sys.argv[1:])")
    subprocess.run([sys.executable, "-c", script, "sweep", str(_folder() / Path(FILE).name), "--out", str(out),
                    "--invalid", "nan"], check=False, capture_output=True)
    ran = run_sweep(sweep, out=out, invalid="nan")
    same = _files(out) == _files(_folder() / "maps")
    return Markup(f"Killed with `kill -9` after its fourth chunk and started again, the example found {ran.found} of "
                  f"{ran.chunks} chunks finished, and computed {ran.chunks - ran.found}. Its store and the one above "
                  f"are {'the same, byte for byte' if same else 'different'}.\n")


def _files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
