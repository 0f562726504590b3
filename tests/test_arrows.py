"""The architecture is a one-way street: derivations -> granular/generated -> granular -> book."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

FORBIDDEN = {
    "derivations": {"granular", "numpy", "scipy", "matplotlib", "plotly", "pandas", "pint", "pydantic", "flint"},
    "granular": {"derivations", "sympy", "quadpy", "book"},
    "granular/generated": {"derivations", "sympy", "granular", "scipy", "matplotlib"},
}
"""What the modules of a package may never import, not even inside a function."""

LAZY = {"numpy", "scipy", "matplotlib", "plotly", "pandas", "pint", "flint", "rich", "numba", "dask",
        "distributed", "xarray", "zarr"}
"""What granular may load only inside the one function that needs it, on the way of a single scene."""

ARRAYS_ARE_THEIR_SUBJECT = ("granular/batch/slip_", "granular/figures/", "granular/generated/", "granular/fitting/",
                            "granular/derivatives/integrals.py", "granular/derivatives/rows.py",
                            "granular/derivatives/slip.py", "granular/routes/axial_array.py",
                            "granular/routes/axial_kinetic_array.py", "granular/routes/expansions.py",
                            "granular/routes/log_tangent_array.py", "granular/routes/slip_geometry_array.py")


def imports(path: Path, *, top_level: bool) -> Iterator[tuple[int, str]]:
    """Line and top package of every import; with ``top_level`` only those that run when the module is imported."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    nodes = _eager(tree.body) if top_level else ast.walk(tree)
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name.split(".")[0]) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not _own(path, node.module):
            yield node.lineno, node.module.split(".")[0]


def _own(path: Path, module: str) -> bool:
    """Whether an emitted file takes something from another emitted one."""
    return path.parent.name == "generated" and module.startswith("granular.generated.")


def _eager(body: list[ast.stmt]) -> Iterator[ast.AST]:
    """Statements that run on import: everything but function bodies and blocks for type checkers."""
    for node in body:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            yield from _eager(node.orelse)
            continue
        yield node
        for inner in ("body", "orelse", "finalbody"):
            yield from _eager(getattr(node, inner, []))


@pytest.mark.parametrize("package", FORBIDDEN)
def test_nothing_knows_what_stands_to_its_right(package: str) -> None:
    """An import against the direction of the arrows breaks this; the message names the file and the rule."""
    wrong = [f"{path.relative_to(ROOT)}:{line} imports {name}: {package} must not"
             for path in sorted((ROOT / package).rglob("*.py")) for line, name in imports(path, top_level=False)
             if name in FORBIDDEN[package]]
    assert wrong == []


def test_only_the_comparison_loads_what_the_product_must_not() -> None:
    """A library loaded by its name anywhere but in the ways from outside would pass the test above unseen."""
    wrong = [f"{path.relative_to(ROOT)}:{call.lineno} loads {call.args[0].value}"
             for path in sorted((ROOT / "granular").rglob("*.py"))
             if not path.relative_to(ROOT).as_posix().startswith("granular/cost/outside/")
             for call in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
             if isinstance(call, ast.Call) and call.args and isinstance(call.args[0], ast.Constant)
             and getattr(call.func, "attr", getattr(call.func, "id", "")) in ("import_module", "__import__", "library")
             and str(call.args[0].value).split(".")[0] in FORBIDDEN["granular"]]
    assert wrong == []


def test_heavy_libraries_wait_until_they_are_needed() -> None:
    """A heavy import at the top of a module that a single scene passes through would slow every run."""
    wrong = [f"{path.relative_to(ROOT)}:{line} imports {name} at the top; import it where it is needed"
             for path in sorted((ROOT / "granular").rglob("*.py"))
             if not path.relative_to(ROOT).as_posix().startswith(ARRAYS_ARE_THEIR_SUBJECT)
             for line, name in imports(path, top_level=True) if name in LAZY]
    assert wrong == []


def test_import_granular_loads_nothing_heavy() -> None:
    """What really gets loaded, as the interpreter sees it."""
    heavy = sorted(LAZY | {"sympy", "pydantic", "typer"})
    code = f"import sys, granular; print([name for name in {heavy} if name in sys.modules])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"


def test_files_stay_short() -> None:
    """One idea a file: a module of more than 400 lines holds more than one."""
    lengths = {path.relative_to(ROOT).as_posix(): len(path.read_text(encoding="utf-8").splitlines())
               for folder in ("derivations", "granular", "tests", "book/_ext") for path in (ROOT / folder).rglob("*.py")
               if "generated" not in path.parts}
    assert {name: lines for name, lines in lengths.items() if lines > 400} == {}


def test_every_file_says_what_it_is_for() -> None:
    """A module without a docstring leaves its reader guessing."""
    folders = ("derivations", "granular", "tests", "book/_ext")
    paths = [path for folder in folders for path in (ROOT / folder).rglob("*.py")]
    silent = [path for path in paths if not ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))]
    assert silent == []
