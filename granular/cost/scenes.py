"""The scenes on which accuracy is weighed against time: one for each effect, and the hard ones."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading

POISSON_RATIO = 0.21
"""Poisson's ratio of the grain material in every scene [-]."""

FRICTION = math.tan(math.radians(12))
"""Friction of the printed tables, 12 degrees [-]."""

BOTH = tuple(Hypothesis)
KINEMATIC = (Hypothesis.KINEMATIC,)
"""Contacts that slide or have opened make the static compliance infinite."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CostScene:
    """One scene under one hypothesis.

    Attributes
    ----------
    name : str
        Name on the command line.
    title : str
        What it is, in one line.
    fabric : AxialFabric
        Contact normals and branches [-].
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.
    poisson_ratio : float
        Of the grain material [-].
    hypothesis : Hypothesis
        Kinematic or static.
    spread : float or None
        Geometric standard deviation of lognormal sizes [-]; None for grains of one size.
    """

    name: str
    title: str
    fabric: AxialFabric
    loading: Loading | None = None
    poisson_ratio: float = POISSON_RATIO
    hypothesis: Hypothesis
    spread: float | None = None

    @property
    def label(self) -> str:
        """Name and hypothesis."""
        return f"{self.name}, {self.hypothesis}"

    def inputs(self) -> dict[str, Any]:
        """Every number that defines the scene, as JSON takes it."""
        found: dict[str, Any] = {"poisson_ratio": self.poisson_ratio, "D33": self.fabric.D33, "Dr33": self.fabric.Dr33,
                                 "aspect_ratio": self.fabric.aspect_ratio}
        if self.loading is not None:
            found |= {"stress_ratio": float(self.loading.sigma33 / self.loading.sigma11),
                      "friction": self.loading.friction}
        if self.spread is not None:
            found["spread"] = self.spread
        return found


TILTED = AxialFabric(D33=0.3, Dr33=-0.3)
"""The fabric of Table II, case 3: more contacts along axis 3, longer branches across it."""

NEARLY_SLIDING = 1 / (2 * math.sqrt(2)) / (1 - 1e-9)
"""Friction that contacts use up to 1 - 1e-9 where they are nearest to sliding, under a stress ratio of 2 [-]."""


def _under(hypotheses: tuple[Hypothesis, ...], name: str, title: str, fabric: AxialFabric,
           loading: Loading | None = None, *, spread: float | None = None) -> tuple[CostScene, ...]:
    return tuple(CostScene(name=name, title=title, fabric=fabric, loading=loading, hypothesis=hypothesis,
                           spread=spread) for hypothesis in hypotheses)


SCENES: tuple[CostScene, ...] = (
    *_under(BOTH, "isotropic", "isotropic fabric, contacts of equal stiffness", AxialFabric()),
    *_under(BOTH, "equal-contacts", "Table II, case 3: contacts of equal stiffness", TILTED),
    *_under(BOTH, "unequal-branches", "branches 8 to 1, near the end of what the static closed form serves",
            AxialFabric(D33=1.0, Dr33=1.4)),
    *_under(BOTH, "kinetic", "Table III, case 2: stiffness follows the force, no contact slips", TILTED,
            Loading.of_ratio(1)),
    *_under(BOTH, "sticking", "Table III, case 3: partial slip, every contact sticks", TILTED,
            Loading.of_ratio(1, friction=FRICTION)),
    *_under(KINEMATIC, "sliding", "Table V, stress ratio 2: some contacts slide", AxialFabric(),
            Loading.of_ratio(2, friction=FRICTION)),
    *_under(BOTH, "near-tangency", "contacts that use up all but 1e-9 of their friction", AxialFabric(),
            Loading.of_ratio(2, friction=NEARLY_SLIDING)),
    *_under(KINEMATIC, "opened", "a tension along axis 3 has opened contacts, others slide", AxialFabric(),
            Loading.of_ratio(Fraction(-0.2), friction=FRICTION)),
    *_under(BOTH, "graded", "lognormal sizes, s_r = 1.5, with the fabric of Table II, case 3", TILTED, spread=1.5),
    *_under(BOTH, "spheroid", "flat aligned spheroids, contacts of equal stiffness",
            AxialFabric(D33=0.3, aspect_ratio=0.8)),
    *_under(KINEMATIC, "sliding-spheroid", "flat aligned spheroids, some contacts slide",
            AxialFabric(aspect_ratio=0.8), Loading.of_ratio(2.0, friction=FRICTION)),
)
"""Every scene, from the plainest to the most involved."""

NAMES = tuple(dict.fromkeys(scene.name for scene in SCENES))
"""Names of the scenes, each once."""
