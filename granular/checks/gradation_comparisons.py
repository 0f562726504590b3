"""Gradation: moments of branch length against certified values, closed forms, and where sizes are nearly equal."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files

from granular.checks.comparison import Comparison, error_in_ulp
from granular.checks.voices import UNIT
from granular.gradation import Lognormal, length_moments
from granular.gradation.branch_lengths import branch_lengths
from granular.hypothesis import Hypothesis

NAME = "lengths"
"""Name under which the rules for branch lengths are shown."""

FORMS = ("paper", "classical")

NARROW = (1 + 2.0**-20, 1 + 2.0**-14)
"""Spreads whose fourth power of the logarithm is below rounding."""

SPREADS = (1.001, 1.2, 1.5, 2.0, 3.0, 10.0)

STEP = 0.25
"""Step in standard deviations of ln l, at which equal steps integrate Gaussian tails to rounding [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CertifiedGradation:
    """A spread with certified moments of branch length.

    Attributes
    ----------
    name : str
        Identifier in the stored file.
    spread : float
        Geometric standard deviation of the sizes [-].
    known : dict
        Hypothesis -> <l^2>_g/(4 <r^3>^(2/3)) (kinematic), or 4 <r^3>^(2/3) <l^-2>_g (static) [-], to 1e-30.
    """

    name: str
    spread: float
    known: dict[Hypothesis, Fraction]


@lru_cache(maxsize=1)
def stored_gradations() -> tuple[CertifiedGradation, ...]:
    """Read the certified moments.

    Returns
    -------
    tuple of CertifiedGradation
        In the order of the file.

    Notes
    -----
    Accuracy: inputs are exact, outputs certified to 1e-30. Source: the ``origin`` that the file states.

    Examples
    --------
    >>> min(case.spread for case in stored_gradations()) < 1.01
    True
    """
    text = (files("granular") / "data" / "certified_gradation.json").read_text(encoding="utf-8")
    return tuple(
        CertifiedGradation(name=entry["id"], spread=float(entry["spread"]), known={
            Hypothesis.KINEMATIC: Fraction(entry["second"]), Hypothesis.STATIC: Fraction(entry["inverse_second"])})
        for entry in json.loads(text)["cases"])


def gradation_comparisons() -> Iterator[Comparison]:
    """Compare branch lengths of lognormal sizes with all that is known of them.

    Returns
    -------
    iterator of Comparison
        One for each moment, spread and form of the density.

    Notes
    -----
    Accuracy: what the library states of each moment. Source: certified values; first order in ln^2 of a spread next to
    one; <l^2>_total/<r^3>^(2/3) = 2 (exp(-L^2) + exp(-2 L^2)) with L = ln s_r (``derivations.gradation``,
    ``derivations.narrow_gradation``).

    Examples
    --------
    >>> all(comparison.agrees for comparison in gradation_comparisons())
    True
    """
    for case in stored_gradations():
        for form in FORMS:
            yield from _moments("gradation", f"{case.name}, {form}", Lognormal(0.005, case.spread, form=form),
                                case.known)
    for spread in NARROW:
        narrow = Fraction(math.log1p(spread - 1)) ** 2
        yield from _moments("gradation: narrow", f"spread {spread!r}", Lognormal(0.005, spread), {
            Hypothesis.KINEMATIC: 1 + 5 * narrow / 2, Hypothesis.STATIC: 1 + 7 * narrow / 2})
    for spread in SPREADS:
        yield _all_branches(spread)


def _moments(group: str, case: str, sizes: Lognormal, known: dict[Hypothesis, Fraction]) -> Iterator[Comparison]:
    found = length_moments(sizes)
    for hypothesis, value, name in ((Hypothesis.KINEMATIC, found.second, "<l^2>"),
                                    (Hypothesis.STATIC, found.inverse_second, "<l^-2>")):
        yield Comparison(group=group, case=case, hypothesis=hypothesis, route=NAME, component=name,
                         error=error_in_ulp(value, known[hypothesis]), allowed=found.relative_error / UNIT)


def _all_branches(spread: float) -> Comparison:
    """Mean square over all branches, from the density (16) in equal steps of ln l, over that of equal volumes."""
    import numpy as np

    sizes = Lognormal(0.005, spread)
    lengths, width = branch_lengths(sizes), sizes.log_spread
    place = np.arange(-9.0, 10.0 + 4.0 * width, STEP)
    length = sizes.median_by_number * np.exp(width * place)
    share = length * lengths.total_density(length)
    found = math.fsum(share * length**2) / math.fsum(share) / (sizes.equal_volume_diameter / 2) ** 2
    known = Fraction(2 * (math.exp(-(width**2)) + math.exp(-2 * width**2)))
    return Comparison(group="gradation: all branches", case=f"spread {spread:g}", hypothesis=Hypothesis.KINEMATIC,
                      route=NAME, component="<l^2>", error=error_in_ulp(found, known),
                      allowed=lengths.relative_error / UNIT)
