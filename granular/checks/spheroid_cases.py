"""Random aligned spheroids whose contacts all have the same stiffness, with much weight on what is hard."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, replace

from granular.checks.sample import admissible_sample
from granular.fabric import AxialFabric

ALWAYS = (1.0, 1 + 1e-8, 1 - 1e-8, 1 + 2.0**-52, 1 - 2.0**-53, 1e-4, 1e4, 1 / 3, 3.0)
"""Aspect ratios that every sample begins with: the sphere, its neighbours, the ends, and the ends of the series."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SpheroidCase:
    """Contact normals, an aspect ratio, a spin and Poisson's ratio, every number a double.

    Attributes
    ----------
    fabric : AxialFabric
        Contact normals, aspect ratio and spin [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    """

    fabric: AxialFabric
    poisson_ratio: float

    loading = None
    """All contacts have the same stiffness."""

    @property
    def kind(self) -> str:
        """What is special about the contacts: they are those of spheroids, or of grains that are free to spin."""
        return "spin" if self.fabric.free_spin else "spheroid"

    def inputs(self) -> dict[str, str]:
        """Every input with all its digits, so that the case can be run again."""
        names = {"D33": self.fabric.D33, "D3333": self.fabric.D3333, "aspect_ratio": self.fabric.aspect_ratio,
                 "nu": self.poisson_ratio}
        return {name: repr(value) for name, value in names.items() if not (name == "D3333" and value == 0)}


def spheroid_sample(count: int, *, seed: int) -> Iterator[SpheroidCase]:
    """Draw contact normals, aspect ratios and Poisson's ratios.

    Parameters
    ----------
    count : int
        How many [-].
    seed : int
        Start of the random numbers; the same seed gives the same sample, and a longer one begins with a shorter one.

    Returns
    -------
    iterator of SpheroidCase
        Normals and Poisson's ratios as :func:`granular.checks.sample.admissible_sample` draws them, to their ends.
        First the aspect ratios of ``ALWAYS``; then a logarithm uniform from 1e-4 to 1e4, or for a third of the draws
        a distance of 1e-1 to 1e-16 from 1. A half is free to spin.

    Notes
    -----
    Accuracy: every case is admissible exactly. Source: the singularity of the elementary form at the sphere.

    Examples
    --------
    >>> [case.fabric.aspect_ratio for case in spheroid_sample(2, seed=1)]
    [1.0, 1.00000001]
    """
    rng = random.Random(seed)
    for number, (fabric, nu) in enumerate(admissible_sample(count, seed=seed)):
        spin, shape = rng.random() < 0.5, _shape(rng)
        if number < len(ALWAYS):
            shape = ALWAYS[number]
        yield SpheroidCase(fabric=replace(fabric, Dr33=0.0, aspect_ratio=shape, free_spin=spin), poisson_ratio=nu)


def _shape(rng: random.Random) -> float:
    away = rng.choice((-1, 1)) * 10 ** rng.uniform(-16, -1)
    return 1 + away if rng.random() < 1 / 3 else float(10 ** rng.uniform(-4, 4))
