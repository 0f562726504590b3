"""The contract of public docstrings: shapes and units of arguments, what is returned, examples that run."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re
import warnings
from collections.abc import Iterator
from types import FunctionType, ModuleType

import pytest

import granular

PUBLIC = sorted(granular.__all__)
UNIT = re.compile(r"\[[^\]]+\]")
NUMERIC = re.compile(r"\b(float|array|ndarray|array_like)\b")


def modules() -> Iterator[ModuleType]:
    """Every module of granular that can be imported without an optional library."""
    for info in pkgutil.walk_packages(granular.__path__, "granular."):
        if not info.name.endswith("__main__"):
            yield importlib.import_module(info.name)


def functions(module: ModuleType) -> Iterator[tuple[str, FunctionType]]:
    """Public functions that a module defines itself."""
    for name, value in vars(module).items():
        if isinstance(value, FunctionType) and value.__module__ == module.__name__ and not name.startswith("_"):
            yield f"{module.__name__}.{name}", value


ALL = dict(pair for module in modules() for pair in functions(module))


def section(doc: str, title: str) -> str:
    """Text of one section of a docstring, empty when it is missing."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\S[^\n]*\n-{{3,}}\n|\Z)", doc, flags=re.S | re.M)
    return found.group(1) if found else ""


@pytest.mark.parametrize("name", sorted(ALL))
def test_numbers_have_units(name: str) -> None:
    """A float or an array described without its unit in brackets breaks this."""
    doc = inspect.cleandoc(ALL[name].__doc__ or "")
    for title in ("Parameters", "Returns"):
        for head, body in re.findall(r"^(\S[^\n]*)\n((?:[ \t]+[^\n]*\n?)*)", section(doc, title), flags=re.M):
            if NUMERIC.search(head) and "tuple" not in head and "dict" not in head:
                assert UNIT.search(head + body), f"{name}: {title}: {head!r} has no unit"


@pytest.mark.parametrize("name", PUBLIC)
def test_public_names_are_explained(name: str) -> None:
    """The names a user imports carry a docstring; functions say what they take, return and raise."""
    value = getattr(granular, name)
    doc = inspect.cleandoc(value.__doc__ or "")
    assert doc
    if isinstance(value, FunctionType):
        for title in ("Parameters", "Returns", "Raises"):
            assert section(doc, title), f"{name}: no section {title}"
        assert ">>>" in doc, f"{name}: no example"


def test_examples_run() -> None:
    """Examples are promises: every one is run, and its output compared."""
    attempted = 0
    for module in [granular, *modules()]:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            result = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
        assert result.failed == 0, module.__name__
        attempted += result.attempted
    assert attempted >= 20
