"""The README's promises: its picture is what the library draws, its Python lines run, its commands exist."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PICTURE = ROOT / "book/_static/figure_6.svg"


def test_the_picture_is_computed() -> None:
    """The picture shows numbers; when they change it must be drawn again (python -m tests.test_readme)."""
    from granular import figures

    assert PICTURE.read_text(encoding="utf-8") == figures.figure_6()._repr_svg_()


def test_python_lines_run() -> None:
    """Each Python block runs as it stands, in order, in one session."""
    blocks = re.findall(r"```python\n(.*?)```", README, flags=re.S)
    assert len(blocks) == 3
    run = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(blocks)], capture_output=True, text=True,
                         cwd=ROOT, check=False)
    assert (run.returncode, run.stderr) == (0, "")
    assert re.fullmatch(r"5836\d+\.\d+ Pa, within \d\.\d+e-1[56] of itself\n", run.stdout)


def test_commands_exist() -> None:
    """Every command named in the README answers to --help."""
    named = sorted(set(re.findall(r"^    (granular|derivations) (\w+)", README, flags=re.M)))
    assert len(named) >= 5
    for program, command in named:
        run = subprocess.run([sys.executable, "-m", program, command, "--help"], capture_output=True, text=True,
                             check=False)
        assert run.returncode == 0, f"{program} {command}"


def test_links_and_targets_exist() -> None:
    """A file or a make target named in the README that is not there breaks this."""
    for name in re.findall(r"\]\(([^)]+)\)", README):
        assert (ROOT / name).is_file(), name
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.M))
    assert set(re.findall(r"make (\w+)", README)) <= targets


if __name__ == "__main__":
    from granular import figures

    PICTURE.write_text(figures.figure_6()._repr_svg_(), encoding="utf-8")
