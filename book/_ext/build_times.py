"""Measure how long a cold build takes: ``python build_times.py OUT.json``, from the last commit, in another folder.

What is measured is ``make book`` after its installation: checking all derivations and numbers, computing every page
without anything from before, and writing them; then printing the book, where there is a Chromium.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from build_seconds import seconds_of_pages

from granular.cost.machine import machine

ROOT = Path(__file__).resolve().parents[2]
COMMAND = "make times"
PACKAGES = ("granular", "sympy", "numpy", "jupyter-book", "Sphinx")


def timed(*command: str, folder: Path) -> float:
    """Run a command to its end and say how many seconds it took."""
    begun = time.monotonic()
    subprocess.run(command, cwd=folder, check=True, env=os.environ | {"PYTHONPATH": str(folder)})
    return round(time.monotonic() - begun, 1)


def measure(folder: Path, tools: Path) -> dict[str, Any]:
    """Build the last commit in an empty folder and take the times of its steps and of its pages."""
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, check=True, capture_output=True).stdout
    subprocess.run(["tar", "-x", "-C", str(folder)], input=archive, check=True)
    load = f"{os.getloadavg()[0]:.1f}"
    make = ("make", "--no-print-directory", f"BIN={tools}", f"--old-file={tools.parent / '.ready'}",
            f"VENV={tools.parent}")
    steps = {"check": timed(*make, "check", folder=folder), "html": timed(*make, "html", folder=folder)}
    if shutil.which("chromium"):
        steps["pdf"] = timed(str(tools / "python"), "book/_ext/pdf.py", "book/_build/html", "book.pdf", folder=folder)
    pages = seconds_of_pages(folder / "book" / "_build" / ".jupyter_cache")
    return {"command": COMMAND, "machine": machine(PACKAGES) | {"load": load}, "steps": steps, "pages": pages}


def main() -> int:
    """Measure and write the record."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("out", type=Path)
    out = parser.parse_args().out
    with tempfile.TemporaryDirectory() as folder:
        record = measure(Path(folder), Path(sys.prefix) / "bin")
    out.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    print(f"{out}: {sum(record['steps'].values()):.0f} s for {len(record['pages'])} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
