"""Benchmarks run only when they are asked for: ``pytest tests/benchmarks -m benchmark``."""

from __future__ import annotations

import pytest


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Skip what measures time unless the expression of ``-m`` names it."""
    if "benchmark" in config.getoption("markexpr"):
        return
    off = pytest.mark.skip(reason="a benchmark; run it with -m benchmark")
    for item in items:
        if item.get_closest_marker("benchmark"):
            item.add_marker(off)
