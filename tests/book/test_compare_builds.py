"""The comparison of two built books reports every difference, and none between equal books."""

from __future__ import annotations

from pathlib import Path

from compare_builds import differences, digest


def build(root: Path, **pages: str) -> Path:
    for name, text in pages.items():
        path = root / "html" / f"{name}.html"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


def test_equal_books_do_not_differ(tmp_path: Path) -> None:
    """Breaks when the folder's own name counts as a difference."""
    assert differences(build(tmp_path / "a", index="x"), build(tmp_path / "b", index="x")) == []


def test_every_difference_is_named(tmp_path: Path) -> None:
    """Breaks when a changed, a lost or an added page goes unnoticed."""
    first = build(tmp_path / "a", index="x", only_first="y")
    second = build(tmp_path / "b", index="z", only_second="y")
    found = differences(first, second)
    assert found == ["differs: html/index.html", f"only in {first}: html/only_first.html",
                     f"only in {second}: html/only_second.html"]


def test_equal_books_have_one_digest(tmp_path: Path) -> None:
    """Breaks when the digest takes the folder along, or does not see a page that changed its name or its text."""
    first = digest(build(tmp_path / "a", index="x"))
    assert digest(build(tmp_path / "b", index="x")) == first
    assert digest(build(tmp_path / "c", index="y")) != first
    assert digest(build(tmp_path / "d", other="x")) != first
