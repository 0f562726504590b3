"""Every stored certified case by every route that serves it: contacts of equal stiffness, with forces, spheroids."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from typing import Any

from granular.checks.comparison import Comparison, worst_component, worst_relative
from granular.checks.voices import (
    MOST_ERROR,
    MOST_UNITS,
    ORDINARY_ERROR,
    allowed_error,
    allowed_units,
    attempt,
    voices,
)
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.result import COMPONENTS

ORDINARY = frozenset({"paper", "isotropic", "interior", "scale"})
"""Families with contact forces that are not hard."""

GROUPS = {
    "forces: paper": ("paper",), "forces: interior": ("isotropic", "interior", "scale"),
    "forces: c - a tiny": ("tiny-D", "tiny-stress", "balanced"),
    "forces: fabric edges": ("D-edge", "Dr-edge", "corner"), "forces: nu-edge": ("nu-edge",),
    "forces: friction": ("mu-to-0", "mu-like-D", "mu-to-inf", "frictionless"),
    "forces: near onset": ("tangent", "near-tangent"), "forces: SR far from 1": ("SR-to-0", "SR-to-inf", "large-both")}
"""Families with contact forces that are shown together; the others under their own names."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CertifiedCase:
    """A fabric with certified components.

    Attributes
    ----------
    name : str
        Identifier in the stored file.
    family : str
        What kind of difficulty it stands for.
    why : str
        What makes it hard, or what it represents.
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    loading : Loading or None
        Stress and friction; None for contacts that all have the same stiffness.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    known : dict
        Hypothesis -> six components over (M/V) l_e^2 k_n,ref [-], certified to 1e-33 of each; no static ones where
        contacts slide.
    """

    name: str
    family: str
    why: str
    fabric: AxialFabric
    loading: Loading | None
    poisson_ratio: float
    known: dict[Hypothesis, tuple[Fraction, ...]]


@lru_cache(maxsize=1)
def stored_cases() -> tuple[CertifiedCase, ...]:
    """Read the certified cases of contacts that all have the same stiffness.

    Returns
    -------
    tuple of CertifiedCase
        In the order of the file.

    Notes
    -----
    Accuracy: inputs are exact, outputs certified to 1e-33. Source: the ``origin`` that the file states.

    Examples
    --------
    >>> {case.family for case in stored_cases()} >= {"paper", "isotropic", "D-edge", "Dr-edge", "corner"}
    True
    """
    return _read("certified_constant.json")


@lru_cache(maxsize=1)
def kinetic_cases() -> tuple[CertifiedCase, ...]:
    """Read the certified cases of contacts that stiffen with their force.

    Returns
    -------
    tuple of CertifiedCase
        In the order of the file.

    Notes
    -----
    Accuracy: inputs are exact, outputs certified to 1e-33. Source: the ``origin`` that the file states.

    Examples
    --------
    >>> {case.family for case in kinetic_cases()} >= {"paper", "tangent", "near-tangent", "SR-to-inf", "mu-to-0"}
    True
    """
    return _read("certified_kinetic.json")


@lru_cache(maxsize=1)
def spheroid_cases() -> tuple[CertifiedCase, ...]:
    """Read the certified cases of aligned spheroids, with contacts of equal stiffness and with contact forces.

    Returns
    -------
    tuple of CertifiedCase
        In the order of the file.

    Notes
    -----
    Accuracy: inputs are exact, outputs certified to 1e-33. Source: the ``origin`` that the file states.

    Examples
    --------
    >>> {case.fabric.free_spin for case in spheroid_cases()} == {True, False}
    True
    """
    return _read("certified_spheroid.json")


def _read(name: str) -> tuple[CertifiedCase, ...]:
    text = (files("granular") / "data" / name).read_text(encoding="utf-8")
    return tuple(
        CertifiedCase(
            name=entry["id"], family=entry["family"], why=entry["why"],
            fabric=AxialFabric(D33=float(entry["D33"]), D3333=float(entry["D3333"]), Dr33=float(entry["Dr33"]),
                               aspect_ratio=float(entry.get("aspect_ratio", 1)),
                               free_spin=entry.get("spin") == "relaxed"),
            loading=_loading(entry), poisson_ratio=float(entry["poisson_ratio"]),
            known={hypothesis: tuple(Fraction(entry[hypothesis][name]) for name in COMPONENTS)
                   for hypothesis in Hypothesis if hypothesis in entry})
        for entry in json.loads(text)["cases"])


def _loading(entry: dict[str, Any]) -> Loading | None:
    if "stress_ratio" not in entry:
        return None
    friction = None if entry["friction"] is None else float(entry["friction"])
    return Loading.of_ratio(float(entry["stress_ratio"]), friction=friction)


def stored_comparisons() -> Iterator[Comparison]:
    """Compare every route with every stored case that it serves.

    Returns
    -------
    iterator of Comparison
        One for each case, hypothesis and route that serves it.

    Notes
    -----
    Accuracy: see :func:`granular.checks.voices.allowed_units` and :func:`~granular.checks.voices.allowed_error`.
    Source: the stored cases.

    Examples
    --------
    >>> next(stored_comparisons()).agrees
    True
    """
    usable = voices()
    for case in (*stored_cases(), *kinetic_cases(), *spheroid_cases()):
        group = case.family if case.loading is None else _shown_under(case.family)
        for hypothesis, known in case.known.items():
            for voice in usable:
                result = attempt(voice, case.fabric, case.poisson_ratio, hypothesis, case.loading)
                if result is None:
                    continue
                if case.loading is None:
                    component, error = worst_component(result.components, known)
                    allowed = allowed_units(voice, result, aim=MOST_UNITS)
                else:
                    component, relative, units = worst_relative(result.components, known)
                    error, allowed = relative * units, allowed_error(voice, result, aim=_aim(case, hypothesis)) * units
                yield Comparison(group=group, case=case.name, hypothesis=hypothesis, route=voice.NAME,
                                 component=component, error=error, allowed=allowed)


def _shown_under(family: str) -> str:
    return next((group for group, families in GROUPS.items() if family in families), family)


def _aim(case: CertifiedCase, hypothesis: Hypothesis) -> float:
    ordinary = case.family in ORDINARY and hypothesis is Hypothesis.KINEMATIC
    return ORDINARY_ERROR if ordinary else MOST_ERROR[hypothesis]
