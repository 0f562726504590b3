"""The execution cache follows the library: a change of anything that decides a number gives a new key."""

from __future__ import annotations

import os
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from library_key import forget_old_caches, library_digest, use_library

FILES = ("granular/a.py", "granular/data/b.json", "granular/data/contacts/e.csv.gz", "granular/data/scenes/f.toml",
         "derivations/c.py", "book/_data/d.csv", "constraints.txt")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for name in FILES:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("one", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("name", [*FILES, "granular/new.py"])
def test_key_follows_every_watched_file(checkout: Path, name: str) -> None:
    """Breaks when a page could show a number that the library no longer gives."""
    before = library_digest(checkout)
    (checkout / name).write_text("two", encoding="utf-8")
    assert library_digest(checkout) != before


def test_key_does_not_follow_compiled_files(checkout: Path) -> None:
    """Breaks when running the library once makes all pages be computed again."""
    before = library_digest(checkout)
    compiled = checkout / "granular" / "__pycache__" / "a.pyc"
    compiled.parent.mkdir()
    compiled.write_text("compiled", encoding="utf-8")
    assert library_digest(checkout) == before


def test_key_does_not_depend_on_the_folder(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Breaks when a build in another folder would compute everything again, or differ."""
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "checkout"
    checkout.rename(elsewhere)
    after = library_digest(elsewhere)
    elsewhere.rename(checkout)
    assert library_digest(checkout) == after


def test_kernels_find_the_library_beside_the_book(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when pages would be computed with an installed copy instead of the one that they describe."""
    monkeypatch.setenv("PYTHONPATH", "/before")
    book = checkout / "book"
    app: Any = SimpleNamespace(srcdir=str(book), outdir=str(book / "_build" / "html"))
    config: Any = {}
    use_library(app, config)
    paths = os.environ["PYTHONPATH"].split(os.pathsep)
    assert paths == [str(checkout), str(checkout / "book" / "_ext"), "/before"]
    assert config["library_key"] == library_digest(checkout)
    assert config["nb_execution_cache_path"].endswith(library_digest(checkout))


def test_old_caches_are_forgotten(tmp_path: Path) -> None:
    """Breaks when every edit of the library leaves another cache behind, or the one in use is deleted."""
    for age, name in enumerate(["in use", "first", "second", "third", "fourth"]):
        (tmp_path / name).mkdir()
        os.utime(tmp_path / name, (1000 - age, 1000 - age))
    forget_old_caches(tmp_path, keep="in use", newest=2)
    assert {path.name for path in tmp_path.iterdir()} == {"in use", "first", "second"}
