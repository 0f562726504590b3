"""An outside route: a way of computing the stiffness that is not one of this package."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from granular.cost.records import Outcome
from granular.cost.scenes import CostScene

TOLERANCES: dict[str, Any] = {f"rtol {rtol:.0e}": rtol for rtol in (1e-3, 1e-6, 1e-9, 1e-12)}
"""Tolerances of adaptive rules [-]."""

MOST_SCALAR, MOST_ARRAY = 100_000, 1_000_000
"""Evaluations after which a route is stopped: one direction at a time, and many at a time."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OutsideRoute:
    """A way of computing, with its settings.

    Attributes
    ----------
    name : str
        Name on the command line.
    title : str
        What it does.
    settings : mapping of str to value
        Name of each setting and what ``run`` takes for it.
    run : callable
        Six components of a scene with one setting.
    """

    name: str
    title: str
    settings: Mapping[str, Any]
    run: Callable[[CostScene, Any], Outcome]
