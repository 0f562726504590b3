"""Scene files: examples, every way in which a file can fail, and files made to hurt."""

from __future__ import annotations

import os
from importlib import resources
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular import errors
from granular.errors import GranularError
from granular.reading import LARGEST
from granular.scene import Scene
from granular.scene_file import read_toml

EXAMPLES = sorted(Path(str(resources.files("granular") / "data" / "scenes")).glob("*.toml"))


def written(tmp_path, content):
    path = tmp_path / "scene.toml"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_example_scenes_are_scenes_and_start_with_a_comment(path):
    # Breaks when the examples that ship go stale.
    assert path.read_text("utf-8").startswith("# ")
    Scene.from_toml(path)
    Scene.from_toml(str(path))


def test_there_are_examples_for_table_ii():
    # Breaks when the package data are not found.
    assert {"table_ii_1", "table_ii_2", "table_ii_3"} <= {path.stem for path in EXAMPLES}


def test_a_byte_order_mark_is_no_mistake(tmp_path):
    # Breaks when files saved by common editors are refused.
    content = b"\xef\xbb\xbf" + EXAMPLES[0].read_bytes().replace(b"\n", b"\r\n")
    assert Scene.from_toml(written(tmp_path, content)) == Scene.from_toml(EXAMPLES[0])


FILE = '[grains]\nshear_modulus = "31 GPa"\npoisson_ratio = 0.21\n[stress]\nmean = "28 kPa"\n'
BAD_FILES = {
    "not TOML": ("grains = {", errors.NotToml, ["line 1", "column"]),
    "not TOML in the middle": ("[grains]\nshear_modulus = = 3\n", errors.NotToml, ["line 2", "column 17"]),
    "key twice": ("a = 1\na = 2\n", errors.NotToml, ["line 2"]),
    "unclosed string": ('[grains]\na = "x', errors.NotToml, ["line 2", "column"]),
    "not UTF-8": (b"# \xff\xfe\n", errors.NotToml, ["position 2", "UTF-8"]),
    "UTF-16": ("a = 1".encode("utf-16"), errors.NotToml, ["UTF-8"]),
    "binary": (bytes(range(256)), errors.NotToml, []),
    "deep lists": ("a = " + "[" * 50000, errors.NotToml, ["nested"]),
    "huge integer": ("a = " + "9" * 5000, errors.NotToml, ["digits"]),
    "too large": (b"#" * (LARGEST + 1), errors.FileTooLarge, [str(LARGEST)]),
    "empty": ("", errors.MissingKey, ["grains"]),
    "infinite": (FILE + "[packing]\nvoid_ratio = inf\n", errors.NotFinite, ["packing.void_ratio = inf"]),
    "overflow": (FILE + "[packing]\nvoid_ratio = 1e400\n", errors.NotFinite, ["packing.void_ratio = inf"]),
    "date": (FILE + "[packing]\nvoid_ratio = 1979-05-27\n", errors.WrongType, ["packing.void_ratio"]),
    "dotted nonsense": (".".join("a" * 100) + " = 1\n", errors.UnknownKey, ["a is not a known key"]),
    "dots without end": ("\n" + ".".join("a" * 250000) + " = 1\n", errors.NotToml, ["249999 dots in line 2"]),
    "a table name without end": ("[" + ".".join("a" * 250000) + "]\n", errors.NotToml, ["line 1"]),
    "array of tables": (FILE + "[[packing]]\nvoid_ratio = 0.5\n", errors.WrongType, ["packing"]),
}


@pytest.mark.parametrize(("content", "kind", "parts"), BAD_FILES.values(), ids=list(BAD_FILES))
def test_bad_files(tmp_path, content, kind, parts):
    # Breaks when a damaged file gets a traceback, or an error without the place.
    with pytest.raises(kind) as refused:
        Scene.from_toml(written(tmp_path, content))
    assert all(part in str(refused.value) for part in parts), refused.value
    assert str(refused.value).isprintable()


def test_a_file_of_exactly_the_largest_size_is_read(tmp_path):
    # Breaks when the limit moves by one.
    head = EXAMPLES[0].read_bytes()
    Scene.from_toml(written(tmp_path, head + b"#" * (LARGEST - len(head))))


@pytest.mark.parametrize(("path", "word"), [
    ("no_such_scene.toml", "does not exist"), ("", "folder"), ("nul\0byte", "cannot be read"),
    ("x" * 5000, "cannot be read"), ("no/such/folder.toml", "does not exist"),
])
def test_files_that_cannot_be_read(tmp_path, path, word):
    # Breaks when the operating system's own error escapes.
    with pytest.raises(errors.FileUnreadable, match=word):
        read_toml(os.path.join(tmp_path, path))  # noqa: PTH118 -- a Path would swallow the empty name


@pytest.mark.parametrize(("error", "word"), [
    (PermissionError(13, "Permission denied"), "may not be read"), (OSError(5, "Input/output error"), "input/output"),
])
def test_files_that_the_system_withholds(tmp_path, monkeypatch, error, word):
    # Breaks when a forbidden file, or a failing disk, gets a traceback.
    def refuse(*_):
        raise error

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(errors.FileUnreadable, match=word):
        read_toml(tmp_path / "scene.toml")


@given(st.text(max_size=200) | st.binary(max_size=200))
def test_no_file_brings_a_traceback(tmp_path_factory, content):
    # Breaks when some bytes raise anything but a GranularError.
    try:
        Scene.from_toml(written(tmp_path_factory.mktemp("scene"),
                                content if isinstance(content, bytes) else content.encode("utf-8", "surrogatepass")))
    except GranularError as refused:
        assert len(str(refused).splitlines()) == 1
