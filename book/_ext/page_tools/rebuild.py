"""What a referee needs to make the book again: how long it takes, from which files, at which versions."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from page_tools.markup import Markup, table

DATA = Path("_data", "build_times.json")
LONGEST_COLD_BUILD = 300.0
"""Time that `make book` may take on two cores, its installation apart [s]."""

SLOWEST = 10
"""Pages that the table of times names; the file beside it has all."""

STEPS = {
    "check": ("`make check`", "derivations against emitted files, numbers against every other voice"),
    "html": ("pages of `make book`", "computed without anything from before, written, inspected"),
    "pdf": ("printing of `make pdf`", "from the built pages"),
}
SOURCES = {
    "what derives": ("derivations/**/*",),
    "what was emitted, as code and as formulas": ("granular/generated/*", "book/_formulas/*"),
    "what computes": ("granular/**/*",),
    "what makes tables and figures of the pages": ("book/_ext/**/*.py",),
    "data of the pages": ("book/_data/**/*",),
    "pinned versions": ("constraints.txt",),
}
"""Files for a change of which every page is computed again (library_key.py); others would leave a digest behind."""


@dataclass(frozen=True)
class BuildTimes:
    """Seconds of each step of a cold build and of each page, with the machine on which they were taken."""

    command: str
    machine: dict[str, str]
    steps: dict[str, float]
    pages: dict[str, float]

    @property
    def book(self) -> float:
        """Seconds of `make book` after its installation: all steps but printing."""
        return sum(seconds for name, seconds in self.steps.items() if name != "pdf")


@lru_cache(maxsize=1)
def recorded(data: Path = DATA) -> BuildTimes:
    """Read the record of ``make times``."""
    return BuildTimes(**json.loads(data.read_text(encoding="utf-8")))


def build_words() -> Markup:
    """Say how long a cold build takes, where, and whether that is what it may take."""
    times = recorded()
    where = times.machine
    busy = f", with {where['load']} other processes at work on average when it began" if "load" in where else ""
    bound = "less" if times.book < LONGEST_COLD_BUILD else "**more**"
    return Markup(
        f"A cold `make book` took {_seconds(times.book)} after its installation, {bound} than the "
        f"{LONGEST_COLD_BUILD / 60:.0f} minutes that it may take on two cores: {where['cores']} cores of an "
        f"{where['processor']}, {where['system']}, Python {where['python']}, one run{busy}. `{times.command}` "
        "measures it again.")


def step_table() -> Markup:
    """List the steps of a cold build with their times."""
    times = recorded()
    rows = [[*STEPS[name], _seconds(seconds)] for name, seconds in times.steps.items()]
    return table(["step", "what it does", "time"], rows, label="tab-build-steps", align="llr",
                 caption="Steps of a cold build. Two pages are computed at a time, on two cores.")


def page_times() -> Markup:
    """List the pages that took longest; all of them are in the file."""
    pages = sorted(recorded().pages.items(), key=lambda item: (-item[1], item[0]))
    rows = [[f"[]({name}.md)", f"{seconds:.0f} s"] for name, seconds in pages[:SLOWEST]]
    whole = sum(seconds for _, seconds in pages)
    return table(["page", "time"], rows, label="tab-page-times", align="lr",
                 taken=[["page", "seconds"], *([name, f"{seconds:.1f}"] for name, seconds in pages)],
                 caption=f"The pages that took longest to compute, of {len(pages)} with code; together they took "
                         f"{_seconds(whole)} of the processor, with the start of Python for each.")


def source_table(root: Path = Path("..")) -> Markup:
    """List digests of the sources by kind: equal digests, equal books on equal machines."""
    rows = []
    for meaning, patterns in SOURCES.items():
        paths = files_of(root, patterns)
        digest = digest_of(root, paths)
        half = len(digest) // 2
        rows.append([meaning, ", ".join(f"`{pattern}`" for pattern in patterns), str(len(paths)),
                     f"`{digest[:half]}` `{digest[half:]}`"])
    return table(["what", "files", "number", "SHA-256"], rows, label="tab-sources", align="llrl",
                 caption="Digests of everything that decides a number of this book: the SHA-256 of what `sha256sum` "
                         "prints for these files, in the order of their names.")


def files_of(root: Path, patterns: Sequence[str]) -> list[Path]:
    """Files below a folder that patterns name, in order, without what Python keeps beside them."""
    found = {path for pattern in patterns for path in root.glob(pattern)
             if path.is_file() and "__pycache__" not in path.parts}
    return sorted(found, key=lambda path: path.relative_to(root).as_posix())


def digest_of(root: Path, paths: Sequence[Path]) -> str:
    """Digest of files, each with its name: SHA-256 of the lines that ``sha256sum`` prints for them."""
    lines = (f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.relative_to(root).as_posix()}\n"
             for path in paths)
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def pins(constraints: Path = Path("..", "constraints.txt")) -> Markup:
    """List every pinned version, folded."""
    lines = [line.split("==") for line in constraints.read_text(encoding="utf-8").splitlines() if "==" in line]
    packages = ", ".join(f"{name} {version}" for name, version in lines)
    return Markup(f"::::{{dropdown}} All {len(lines)} pinned versions\n{packages}\n::::")


def _seconds(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest} s" if minutes else f"{rest} s"
