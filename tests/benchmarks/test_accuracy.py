"""The measurement behind the declared errors: tens of thousands of random and boundary fabrics."""

from __future__ import annotations

from collections import defaultdict

import pytest

from granular.checks.on_the_fly import sample_comparisons

pytestmark = pytest.mark.benchmark

FABRICS = 10_000


def test_declared_errors() -> None:
    """Some route errs by more than it declares; the worst of each is printed in units in the last place."""
    worst: dict[tuple[str, str, str], float] = defaultdict(float)
    missed = []
    for comparison in sample_comparisons(FABRICS, seed=11):
        key = (comparison.route, comparison.hypothesis.value, comparison.group)
        worst[key] = max(worst[key], comparison.error)
        if not comparison.agrees:
            missed.append(comparison)
    print()
    for (route, hypothesis, group), error in sorted(worst.items()):
        print(f"{route:12} {hypothesis:10} {group:15} {error:8.2f} units")
    assert missed == []
