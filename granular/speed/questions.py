"""What is asked of very many assemblies: which effects are simulated, under which hypothesis, and how exactly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from typing import TYPE_CHECKING, Any

from granular.hypothesis import Hypothesis
from granular.speed.sample import FRICTION, POISSON, Sample

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

TABLES = 1e-12
"""Accuracy that is asked of partial slip where tables may answer [-]."""

STICKING = 2.0
"""Friction with which no contact of the sample slides [-]: the forces of stress ratios from 1/3 to 3 use up 4/3."""


class Friction(StrEnum):
    """What friction the assemblies have."""

    NONE = "none"
    ONE = "one"
    EACH = "each"
    STICKING = "sticking"


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """One thing that is asked of every assembly of a sample.

    Attributes
    ----------
    branches : bool
        Whether branch lengths follow the direction; all are equal without.
    kinetic : bool
        Whether the stiffness of contacts follows the force.
    friction : Friction
        Friction of the assemblies; any but ``NONE`` means partial slip.
    hypothesis : Hypothesis
        Kinematic or static.
    rtol : float or None
        Accuracy that is asked for [-]; None is full precision.
    grains_differ : bool
        Whether each assembly has a Poisson's ratio of its own.
    """

    branches: bool = True
    kinetic: bool = True
    friction: Friction = Friction.NONE
    hypothesis: Hypothesis = Hypothesis.KINEMATIC
    rtol: float | None = None
    grains_differ: bool = False

    def arguments(self, drawn: Sample) -> tuple[Any, ...]:
        """Fabric, stress ratio, friction and Poisson's ratio, as ``axial_stiffness`` takes them.

        Parameters
        ----------
        drawn : Sample
            The assemblies.

        Returns
        -------
        tuple
            Arrays and numbers [-].
        """
        friction = {Friction.NONE: None, Friction.ONE: FRICTION, Friction.EACH: drawn.friction,
                    Friction.STICKING: STICKING}[self.friction]
        ratio = drawn.stress_ratio if self.kinetic else 1.0  # equal contacts do not ask for it
        nu = drawn.poisson_ratio if self.grains_differ else POISSON
        return (drawn.D33, drawn.Dr33 if self.branches else 0.0, ratio, friction, nu)

    def call(self, drawn: Sample, **options: Any) -> Callable[[], Array]:
        """A call of ``axial_stiffness`` that answers it.

        Parameters
        ----------
        drawn : Sample
            The assemblies.
        **options
            Passed on: ``out``, ``engine``, ``threads``.

        Returns
        -------
        callable
            Gives the components, (n, 6) [-].

        Examples
        --------
        >>> from granular.speed.sample import sample
        >>> CONSTANT.call(sample(3))().shape
        (3, 6)
        """
        from granular.array_stiffness import axial_stiffness

        return partial(axial_stiffness, *self.arguments(drawn), kinetic=self.kinetic, hypothesis=self.hypothesis,
                       rtol=self.rtol, **options)

    def slopes(self, drawn: Sample, **options: Any) -> Callable[[], tuple[Array, Array]]:
        """A call of ``axial_gradient`` that answers it, with all slopes.

        Parameters
        ----------
        drawn : Sample
            The assemblies.
        **options
            Passed on: ``engine``, ``threads``.

        Returns
        -------
        callable
            Gives components, (n, 6), and slopes, (n, 6, 5) [-].
        """
        from granular.derivatives import axial_gradient

        return partial(axial_gradient, *self.arguments(drawn), kinetic=self.kinetic, hypothesis=self.hypothesis,
                       **options)


PACKING = Question(branches=False, kinetic=False)
CONSTANT = Question(kinetic=False)
KINETIC = Question()
SLIP = Question(friction=Friction.ONE, rtol=TABLES)
SLIP_EACH = Question(friction=Friction.EACH, rtol=TABLES)
SLIP_FULL = Question(friction=Friction.ONE)
STATIC = Question(kinetic=False, hypothesis=Hypothesis.STATIC)
STATIC_KINETIC = Question(hypothesis=Hypothesis.STATIC)
STATIC_SLIP = Question(friction=Friction.STICKING, hypothesis=Hypothesis.STATIC)
