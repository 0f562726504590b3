"""All comparisons, one after the other."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from granular.checks.comparison import Comparison
from granular.checks.force_limit_comparisons import force_limit_comparisons
from granular.checks.general_comparisons import general_comparisons
from granular.checks.gradation_comparisons import gradation_comparisons
from granular.checks.limit_comparisons import limit_comparisons
from granular.checks.monte_carlo import monte_carlo_comparisons
from granular.checks.on_the_fly import loaded_comparisons, sample_comparisons
from granular.checks.spheroid_comparisons import spheroid_comparisons, spheroid_limit_comparisons
from granular.checks.stored import stored_comparisons

SOURCES: dict[str, Callable[[], Iterator[Comparison]]] = {
    "stored certified cases": stored_comparisons,
    "symbolic limits": limit_comparisons,
    "limits with contact forces": force_limit_comparisons,
    "limits of the shape": spheroid_limit_comparisons,
    "gradation": gradation_comparisons,
    "random admissible fabrics, certified on the fly": sample_comparisons,
    "random contact forces, certified on the fly": loaded_comparisons,
    "random spheroids, certified on the fly": spheroid_comparisons,
    "frames without an axis": general_comparisons,
    "contacts drawn at random": monte_carlo_comparisons,
}
"""What is compared with what, in the order in which it is shown."""


def table(*, started: Callable[[str], None] | None = None) -> list[Comparison]:
    """Run every comparison.

    Parameters
    ----------
    started : callable or None
        Told the name of each part before it starts, to show progress.

    Returns
    -------
    list of Comparison
        Stored cases, then limits, then random inputs, in about a quarter of a minute. Without python-flint the parts
        that are certified on the fly are empty.

    Notes
    -----
    Accuracy: each comparison says what it allows. Source: the modules of this package.

    Examples
    --------
    >>> all(comparison.agrees for comparison in table())  # doctest: +SKIP
    True
    """
    comparisons: list[Comparison] = []
    for name, source in SOURCES.items():
        if started is not None:
            started(name)
        comparisons.extend(source())
    return comparisons
