"""The vendored MathJax is what its checksums say, complete, and under its licence."""

from __future__ import annotations

import hashlib
from pathlib import Path


def test_files_match_their_checksums(book: Path) -> None:
    """Breaks when a vendored file is edited, lost or added without renewing the list."""
    folder = book / "_vendor" / "mathjax"
    lines = (folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    listed = {name: digest for digest, name in (line.split(maxsplit=1) for line in lines)}
    present = {f"./{path.relative_to(folder).as_posix()}": hashlib.sha256(path.read_bytes()).hexdigest()
               for path in folder.rglob("*") if path.is_file() and path.name != "SHA256SUMS"}
    assert present == listed


def test_licence_and_entry_point_are_there(book: Path) -> None:
    """Breaks when the component that the pages load, or the licence that allows shipping it, is missing."""
    folder = book / "_vendor" / "mathjax"
    assert "Apache License" in (folder / "LICENSE").read_text(encoding="utf-8")
    assert (folder / "tex-chtml.js").stat().st_size > 500_000
