"""With which versions and from which data the pages were computed."""

from __future__ import annotations

import hashlib
import platform
from importlib.metadata import version
from pathlib import Path

from page_tools.markup import Markup, table

PACKAGES = ("granular", "sympy", "numpy", "scipy", "python-flint", "matplotlib", "plotly", "pydantic",
            "jupyter-book", "Sphinx", "myst-nb", "sphinx-book-theme")
DATA_FILES = {
    "_data/table_ii.csv": "printed ratios of Table II",
    "_data/table_iii.csv": "printed ratios of Table III",
    "_data/table_iv.csv": "printed ratios of Table IV",
    "_data/table_v.csv": "printed ratios of Table V",
    "_data/isotropic_28kpa.csv": "printed stiffness of the isotropic assemblies",
    "_data/table_ii_case_3.toml": "scene of Table II, case 3",
    "_data/spheroids.toml": "scene of aligned spheroids",
    "_data/table_i.csv": "printed sizes and spreads of Table I",
    "_data/sand.csv": "sieve curve made up for the page on grain sizes",
    "_data/sand.toml": "scene with that curve",
    "_data/fit_sand.toml": "wave speeds made up for the page on fits",
    "_data/length_times.json": "measured times of branch lengths",
    "_data/cost.json": "measured times and errors of every way of computing",
    "_data/build_times.json": "measured times of a cold build and of its pages",
    "_data/speed.json": "measured times of many assemblies, beside the limit of the machine and other packages",
    "_data/promises.json": "results at four wanted accuracies, held against certified values",
    "_data/choices.json": "measured times of the route that a plan chose and of all others",
    "_data/nearly_isotropic.toml": "scene of a soil that is nearly isotropic",
    "_data/tilted_fabric.toml": "scene of a tilted deposit, without an axis",
    "_data/sweep.toml": "sweep of the page on sweeps",
    "_data/soil.toml": "scene of the first five minutes",
    "_data/lab_sieve.csv": "sieve curve made up for the tutorial for the laboratory",
    "_data/lab_sand.toml": "its scene",
    "_data/lab_equal.toml": "the same with grain sizes left out",
    "_data/lab_speeds.toml": "wave speeds made up for it",
    "_data/lab_ratio.toml": "the same with one state of stress more",
    "_data/many_lists.py": "script of the tutorial on simulated packings",
    "_data/dem.json": "sums, model and probes of packings from a discrete-element program",
}


def versions() -> Markup:
    """List the versions that decide the numbers and the pages."""
    rows = [["Python", platform.python_version()], *([name, version(name)] for name in PACKAGES)]
    return table(["what", "version"], rows, label="tab-versions",
                 caption="Versions with which these pages were computed and built.")


def data_files() -> Markup:
    """List the data files with their digests."""
    rows = [[f"{{download}}`{Path(name).name} <{name}>`", meaning, _in_two_lines(_digest(Path(name)))]
            for name, meaning in DATA_FILES.items()]
    return table(["file", "what it holds", "SHA-256"], rows, label="tab-data",
                 caption="Data files of this book.")


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _in_two_lines(digest: str) -> str:
    half = len(digest) // 2
    return f"`{digest[:half]}` `{digest[half:]}`"
