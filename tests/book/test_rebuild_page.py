"""What the page on rebuilding says comes from the record of a build and from the files that it names."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest
from page_tools import rebuild
from page_tools.rebuild import BuildTimes


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def times(**steps: float) -> BuildTimes:
    machine = {"cores": "2", "processor": "X", "system": "Linux", "python": "3.11", "load": "0.1"}
    return BuildTimes("make times", machine, steps, {"waves": 3.0, "fabric": 9.5})


def test_the_record_is_of_this_book(book: Path) -> None:
    """Breaks when the record is of no build, or names a page that the table cannot link to."""
    found = rebuild.recorded()
    assert found.command == "make times"
    slowest = sorted(found.pages, key=lambda name: -found.pages[name])[:rebuild.SLOWEST]
    assert all((book / f"{name}.md").exists() for name in slowest)


@pytest.mark.parametrize(("html", "verdict"), [(200.0, "less"), (290.0, "**more**")])
def test_the_bound_is_judged(html: float, verdict: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when checking is not counted, printing is, or a build that is too slow is praised."""
    monkeypatch.setattr(rebuild, "recorded", lambda: times(check=20.0, html=html, pdf=80.0))
    assert f"{verdict} than the 5 minutes" in rebuild.build_words().text
    table = rebuild.page_times().text
    assert table.index("fabric.md") < table.index("waves.md")


def test_digests_are_those_of_the_files(root: Path, tmp_path: Path) -> None:
    """Breaks when a digest is of other files, or cannot be had from ``sha256sum`` as the caption says."""
    (tmp_path / "a.txt").write_text("x", encoding="utf-8")
    line = f"{hashlib.sha256(b'x').hexdigest()}  a.txt\n"
    assert rebuild.digest_of(tmp_path, [tmp_path / "a.txt"]) == hashlib.sha256(line.encode()).hexdigest()
    for patterns in rebuild.SOURCES.values():
        assert rebuild.files_of(root, patterns)


def test_every_named_file_makes_the_pages_new(root: Path) -> None:
    """Breaks when a digest on the page may be that of an older file, because no page is computed again for it."""
    from library_key import WATCHED

    watched = set(rebuild.files_of(root, WATCHED))
    for patterns in rebuild.SOURCES.values():
        assert set(rebuild.files_of(root, patterns)) <= watched


def test_all_pins_are_listed(root: Path) -> None:
    """Breaks when a pinned package is lost from the list."""
    lines = (root / "constraints.txt").read_text(encoding="utf-8").splitlines()
    text = rebuild.pins().text
    assert all(line.replace("==", " ") in text for line in lines if "==" in line)
