"""A named corpus of hard inputs: what is certified, what the package gives, and what an obvious formula gives."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from typing import Any

from granular.checks import naive
from granular.checks.voices import MOST_ERROR
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial
from granular.routes.result import COMPONENTS

UNIT_OF_STIFFNESS = "(M/V) l_e^2 k_n"
"""The component of the cases that are hard by their physical scale [Pa]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scale:
    """Physical inputs of the unit of stiffness.

    Attributes
    ----------
    shear_modulus : float
        G_s [Pa].
    mean_stress : float
        p [Pa].
    contacts_per_volume : float
        M/V [1/m^3].
    branch_length : float
        l_e [m].
    """

    shear_modulus: float
    mean_stress: float
    contacts_per_volume: float
    branch_length: float


@dataclass(frozen=True, slots=True, kw_only=True)
class HardCase:
    """An input on which an obvious way of computing fails.

    Attributes
    ----------
    name : str
        Short name, unique in the corpus.
    family : str
        Kind of difficulty, as in the stored certified cases.
    why : str
        What makes it hard.
    fabric : AxialFabric
        Contact normals, and branch lengths or shape [-].
    loading : Loading or None
        Stress and friction; None for contacts that all have the same stiffness.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    hypothesis : Hypothesis
        Kinematic or static.
    scale : Scale or None
        Physical inputs where the unit of stiffness itself is hard.
    component : str
        The component in question, over (M/V) l_e^2 k_n,ref [-], or the unit of stiffness [Pa].
    certified : Fraction
        Its value, to 1e-30 of itself.
    naive : str
        Label of the naive way, a key of :data:`granular.checks.naive.NAIVE` or ``"powers before the cube root"``.
    off_by : float
        Relative error that the naive way has at least [-]; infinite where it gives no number, or a number for zero.
    """

    name: str
    family: str
    why: str
    fabric: AxialFabric
    loading: Loading | None
    poisson_ratio: float
    hypothesis: Hypothesis
    scale: Scale | None
    component: str
    certified: Fraction
    naive: str
    off_by: float


@dataclass(frozen=True, slots=True, kw_only=True)
class HardComparison:
    """A hard case with both values.

    Attributes
    ----------
    case : HardCase
        The input and its certified value; the properties below repeat what a table shows of it.
    stable, naive : float
        What the package gives, and what the naive way gives, in the unit of the case.
    stable_error, naive_error : float
        Their relative errors [-]; nan for what is no number, infinite for an overflow and for a number where the
        value is zero.
    """

    case: HardCase
    stable: float
    naive: float
    stable_error: float
    naive_error: float

    @property
    def name(self) -> str:
        """A few words."""
        return self.case.name

    @property
    def why(self) -> str:
        """What makes the case hard."""
        return self.case.why

    @property
    def component(self) -> str:
        """The component in question."""
        return self.case.component

    @property
    def certified(self) -> Fraction:
        """Its certified value."""
        return self.case.certified

    @property
    def naive_label(self) -> str:
        """What is naive about the naive way."""
        return self.case.naive

    @property
    def as_stated(self) -> bool:
        """Whether the package is right to 2e-15 (kinematic) or 4e-15 (static), and the naive way as far off as stated.

        An infinite error is equal to an infinite bound, and no number is as far off as any.
        """
        return self.stable_error <= MOST_ERROR[self.case.hypothesis] and not self.naive_error < self.case.off_by


@lru_cache(maxsize=1)
def hard_cases() -> tuple[HardCase, ...]:
    """Read the corpus.

    Returns
    -------
    tuple of HardCase
        In the order of the file.

    Notes
    -----
    Accuracy: inputs are exact, values certified to 1e-30. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> len({case.name for case in hard_cases()}) == len(hard_cases()) > 20
    True
    """
    text = (files("granular") / "data" / "hard_cases.json").read_text(encoding="utf-8")
    return tuple(_case(entry) for entry in json.loads(text)["cases"])


def comparison() -> tuple[HardComparison, ...]:
    """Compute every case of the corpus by the package and by its naive way.

    Returns
    -------
    tuple of HardComparison
        In the order of :func:`hard_cases`; takes about a second.

    Notes
    -----
    Accuracy: errors are against the certified value. Source: eqs (7) and (20)-(23).

    Examples
    --------
    >>> first, *_ = comparison()
    >>> first.stable_error < 2e-15 < first.naive_error
    True
    """
    return tuple(_compared(case) for case in hard_cases())


def relative_error(value: float, known: Fraction) -> float:
    """Relative error of a number that may not be one.

    Parameters
    ----------
    value : float
        What was computed, in any unit [-].
    known : Fraction
        What it should be, in the same unit [-].

    Returns
    -------
    float
        ``|value - known| / |known|`` [-]; nan for nan, infinite for infinity and for anything but 0 where 0 is known.

    Examples
    --------
    >>> relative_error(1.0, Fraction(2)), relative_error(1e-17, Fraction(0)), relative_error(0.0, Fraction(0))
    (0.5, inf, 0.0)
    """
    if not math.isfinite(value):
        return abs(value)
    if known == 0:
        return 0.0 if value == 0 else math.inf
    return float(abs(Fraction(value) - known) / abs(known))


def _compared(case: HardCase) -> HardComparison:
    stable, simple = _scales(case, case.scale) if case.scale is not None else _components(case)
    return HardComparison(case=case, stable=stable, naive=simple,
                          stable_error=relative_error(stable, case.certified),
                          naive_error=relative_error(simple, case.certified))


def _components(case: HardCase) -> tuple[float, float]:
    index = COMPONENTS.index(case.component)
    result = axial.evaluate(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=case.hypothesis,
                            loading=case.loading)
    simple = naive.NAIVE[case.naive](case.fabric, case.loading, case.poisson_ratio, case.hypothesis)
    return result.components[index], simple[index]


def _scales(case: HardCase, scale: Scale) -> tuple[float, float]:
    from granular.contact_law import normal_stiffness

    spring = normal_stiffness(scale.shear_modulus, case.poisson_ratio, mean_stress=scale.mean_stress,
                              contacts_per_volume=scale.contacts_per_volume)
    return (spring * scale.branch_length * (scale.contacts_per_volume * scale.branch_length),
            naive.scale_in_the_printed_order(scale.shear_modulus, case.poisson_ratio, scale.mean_stress,
                                             scale.contacts_per_volume, scale.branch_length))


def _case(entry: dict[str, Any]) -> HardCase:
    stress = entry.get("stress")
    loading = None if stress is None else Loading(
        sigma11=Fraction(float(stress["sigma11"])), sigma33=Fraction(float(stress["sigma33"])),
        friction=None if stress["friction"] is None else float(stress["friction"]))
    scale = entry.get("scale")
    return HardCase(
        name=entry["name"], family=entry["family"], why=entry["why"],
        fabric=AxialFabric(D33=float(entry["D33"]), D3333=float(entry["D3333"]), Dr33=float(entry["Dr33"]),
                           aspect_ratio=float(entry.get("aspect_ratio", 1)), free_spin=entry.get("spin") == "relaxed"),
        loading=loading, poisson_ratio=float(entry["poisson_ratio"]), hypothesis=Hypothesis(entry["hypothesis"]),
        scale=None if scale is None else Scale(**{key: float(value) for key, value in scale.items()}),
        component=entry["component"], certified=Fraction(entry["certified"]), naive=entry["naive"],
        off_by=float(entry["off_by"]))
