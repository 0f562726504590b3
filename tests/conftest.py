"""Settings for all tests: random search takes the time that it needs, and prints what reproduces a failure.

On a build server (CI is set) the search is the same every time, so that a verdict belongs to the change under test;
elsewhere it goes on looking in new places.

Files that take longest are begun first, since each is worked through by one process: begun last, they would keep one
busy while the others have nothing left to do.
"""

from __future__ import annotations

import os

import pytest
from hypothesis import settings

settings.register_profile("granular", deadline=None, print_blob=True, derandomize=bool(os.environ.get("CI")))
settings.load_profile("granular")

LONGEST_FIRST = (
    "tests/book/test_built_book.py", "tests/book/test_built_figures.py", "tests/derivations/test_emission.py",
    "tests/granular/test_figures.py", "tests/book/test_pdf.py", "tests/granular/test_fabric_tensors_scatter.py",
    "tests/granular/test_sweeps_workers.py", "tests/granular/test_fitting.py", "tests/book/test_tutorials.py",
    "tests/granular/test_figures_general.py", "tests/granular/test_command_line.py", "tests/test_docstrings.py",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the longest files; the order of the others, and within a file, stays."""
    rank = {name: number for number, name in enumerate(LONGEST_FIRST)}
    items.sort(key=lambda item: rank.get(item.nodeid.partition("::")[0], len(rank)))
