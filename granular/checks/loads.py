"""Random admissible inputs with contact forces: fabrics, stress ratios, friction, with much weight on what is hard."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from granular.checks.sample import admissible_sample
from granular.fabric import AxialFabric
from granular.loading import Loading


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadedCase:
    """A fabric, a loading and Poisson's ratio, every number a double.

    Attributes
    ----------
    kind : str
        Whether some contacts slide, all stick, or some have opened.
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    loading : Loading
        Stress and friction.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    """

    kind: str
    fabric: AxialFabric
    loading: Loading
    poisson_ratio: float

    def inputs(self) -> dict[str, str]:
        """Every input with all its digits, so that the case can be run again."""
        names = {"D33": self.fabric.D33, "D3333": self.fabric.D3333, "Dr33": self.fabric.Dr33,
                 "nu": self.poisson_ratio, "sigma33/sigma11": float(self.loading.sigma33), "mu": self.loading.friction}
        if self.loading.sigma11 != 1:
            names |= {"sigma33/sigma11": None, "sigma11": float(self.loading.sigma11),
                      "sigma33": float(self.loading.sigma33)}
        return {name: "none" if value is None else repr(value) for name, value in names.items()
                if not (name == "sigma33/sigma11" and value is None) and not (name == "D3333" and value == 0)}


def loaded_sample(count: int, *, seed: int) -> Iterator[LoadedCase]:
    """Draw fabrics, loadings and Poisson's ratios.

    Parameters
    ----------
    count : int
        How many [-].
    seed : int
        Start of the random numbers; the same seed gives the same sample, and a longer one begins with a shorter one.

    Returns
    -------
    iterator of LoadedCase
        Fabrics and Poisson's ratios as :func:`granular.checks.sample.admissible_sample` draws them, to their ends. A
        stress ratio from 1e-10 to 1e10, one in eight next to 1 or exactly 1, one in sixteen with a principal stress
        that vanishes or is a tension. A friction coefficient from 1e-10 to 1e6; for a third of the draws within
        1e-1 to 1e-14 of the one at which sliding begins, or exactly the double next to it; none at all for one in
        eight, 0 for one in sixteen.

    Notes
    -----
    Accuracy: every input is admissible exactly. Source: the onset 4 a c mu^2 = (c - a)^2 of eqs (21) and (23).

    Examples
    --------
    >>> [case.kind for case in loaded_sample(4, seed=2)] == [case.kind for case in loaded_sample(5, seed=2)][:4]
    True
    """
    rng = random.Random(seed)
    for fabric, nu in admissible_sample(count, seed=seed):
        sigma11, sigma33 = _stresses(rng)
        loading = Loading(sigma11=sigma11, sigma33=sigma33, friction=_friction(rng, fabric, sigma11, sigma33))
        yield LoadedCase(kind=_kind(fabric, loading), fabric=fabric, loading=loading, poisson_ratio=nu)


def _stresses(rng: random.Random) -> tuple[Fraction, Fraction]:
    kind, size = rng.randrange(16), rng.random()
    if kind == 0:
        tension = rng.choice((0.0, -size, -math.exp2(-60 * size)))
        return (Fraction(tension) / 2, Fraction(1)) if rng.random() < 0.5 else (Fraction(1), Fraction(tension) * 2)
    ratio = 10 ** rng.uniform(-10, 10)
    if kind == 1:
        ratio = 1 + rng.choice((0.0, 1.0, -1.0)) * math.exp2(-52 * size)
    return Fraction(1), Fraction(ratio)


def _friction(rng: random.Random, fabric: AxialFabric, sigma11: Fraction, sigma33: Fraction) -> float | None:
    kind, away = rng.randrange(16), rng.choice((-1, 1)) * 10 ** rng.uniform(-14, -1)
    free = 10 ** rng.uniform(-10, 6)
    if kind < 2:
        return None
    if kind == 2:
        return 0.0
    a, c = Loading(sigma11=sigma11, sigma33=sigma33).coefficients(fabric.D33)
    if kind < 8 and a > 0 and c > 0 and a != c:
        onset = math.sqrt((c - a) ** 2 / (4 * a * c))
        return onset if kind == 3 else onset * (1 + away)
    return free


def _kind(fabric: AxialFabric, loading: Loading) -> str:
    if loading.opens():
        return "open"
    return "slide" if loading.slides(fabric.D33) else "stick"
