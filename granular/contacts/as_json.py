"""The object that ``granular contacts --json`` prints; its keys are those of the command line's interface."""

from __future__ import annotations

import math
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

from granular.contacts.by_angle import QUANTITIES
from granular.contacts.estimate import estimated_forces
from granular.contacts.prediction import Predicted, fitted_fabric, predictions
from granular.errors import FabricOutOfRange
from granular.hypothesis import Hypothesis
from granular.notation import MANDEL_PAIRS

if TYPE_CHECKING:
    from collections.abc import Iterable

    from granular.contacts.summary import ContactSummary
    from granular.elasticity import Stiffness

NAMES = tuple(f"C{i}{j}{k}{m}" for (i, j), (k, m) in combinations_with_replacement(MANDEL_PAIRS, 2))
"""The 21 different components, by tensor indices."""

SHARES = (0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99)
"""Shares of the branches whose greatest length is told."""


def summary_as_json(summary: ContactSummary) -> dict[str, Any]:
    """Everything that a list tells, as plain numbers.

    Parameters
    ----------
    summary : ContactSummary
        A list.

    Returns
    -------
    dict
        Numbers, strings, lists and dicts, SI units; None where something is not given.

    Notes
    -----
    Source: the command line's interface.

    Examples
    --------
    >>> from granular.contacts.example import example_facts, example_path
    >>> from granular.contacts.summary import summarise
    >>> told = summary_as_json(summarise(example_path(), volume=example_facts()["V"], grains=2000))
    >>> told["contacts"], told["coordination_number"], round(told["sum"]["C3333"] / 1e6)
    (5753, 5.753, 628)
    """
    return {
        "file": summary.name.strip('"'), "contacts": summary.contacts, "dropped": summary.dropped,
        "volume": summary.volume,
        "contacts_per_volume": summary.contacts_per_volume, "grains": summary.grains,
        "coordination_number": summary.coordination_number,
        "coordination_number_without_rattlers": summary.coordination_without_rattlers, "rattlers": summary.rattlers,
        "fabric": _fabric(summary), "branch_lengths": _lengths(summary), "by_angle": _by_angle(summary),
        "stress": None if summary.stress is None else summary.stress.tolist(),
        "stress_is_whole": summary.stress_is_whole, "sliding": summary.sliding,
        "stiffness_source": summary.stiffness_source, "mean_kn": summary.mean_kn, "mean_ks": summary.mean_ks,
        "stiffer_where_longer": summary.stiffer_where_longer,
        "sum": _with_reason(summary.kinematic, summary.no_kinematic),
        "raw": None if summary.raw is None else summary.raw.tolist(),
        "static_sum": _with_reason(summary.static, summary.no_static), "prediction": _prediction(summary),
    }


def components_as_json(stiffness: Stiffness) -> dict[str, Any]:
    """A stiffness without assumed symmetry.

    Parameters
    ----------
    stiffness : Stiffness
        Any [Pa].

    Returns
    -------
    dict
        The 21 different components by tensor indices, and ``mandel``, a 6 x 6 list [Pa].

    Notes
    -----
    Source: the command line's interface.
    """
    return {name: stiffness.component(name) for name in NAMES} | {"mandel": [list(row) for row in stiffness.rows]}


def _with_reason(stiffness: Stiffness | None, reason: str) -> dict[str, Any]:
    return {"refused": reason} if stiffness is None else components_as_json(stiffness)


def _fabric(summary: ContactSummary) -> dict[str, Any]:
    told: dict[str, Any] = {
        name: {"N": tensor.tolist(), "D33": 7.5 * (float(tensor[2, 2]) - 1 / 3), "D33_error": summary.doubt_of(name),
               "D": [[7.5 * (float(tensor[i, j]) - (1 / 3 if i == j else 0.0)) for j in range(3)] for i in range(3)]}
        for name, tensor in (("normals", summary.normals), ("branches", summary.branches))}
    told["normals"]["tests"] = [{"name": test.name, "statistic": test.statistic, "p": test.p, "words": test.words,
                                 "degrees_of_freedom": test.degrees_of_freedom} for test in summary.tests]
    try:
        fitted = fitted_fabric(summary)
        return told | {"branch_length": {"Dr33": fitted.Dr33, "l_e": fitted.length}}
    except FabricOutOfRange as refusal:
        return told | {"branch_length": {"refused": str(refusal)}}


def _lengths(summary: ContactSummary) -> dict[str, Any]:
    lengths = summary.lengths
    stragglers = summary.stragglers
    return {"far_longer": None if stragglers is None else dict(zip(("branches", "from", "others_up_to"), stragglers,
                                                                   strict=True)),
            "mean": summary.length_moments["l"], "mean_square": summary.length_moments["l2"], "least": lengths.least,
            "greatest": lengths.greatest, "quantiles": {f"{share:g}": lengths.quantile(share) for share in SHARES}}


def _by_angle(summary: ContactSummary) -> dict[str, Any]:
    classes = summary.by_angle
    told: dict[str, Any] = {"degrees": classes.degrees.tolist(), "contacts": classes.contacts.astype(int).tolist(),
                            "relative_density": classes.relative_density().tolist()}
    for name in QUANTITIES[1:]:
        mean, scatter = classes.mean(name), classes.scatter(name)
        if name != "inverse_length" and mean is not None and scatter is not None:
            told[name] = {"mean": _finite(mean), "scatter": _finite(scatter)}
    if (estimate := estimated_forces(summary)) is not None:
        told["estimated_normal_force"], told["estimated_meridian_force"] = map(_finite, estimate)
    return told


def _finite(values: Iterable[float]) -> list[float | None]:
    """A class without contacts has no mean."""
    return [float(value) if math.isfinite(value) else None for value in values]


def _prediction(summary: ContactSummary) -> dict[str, Any]:
    """The model under the kinematic hypothesis first, which is what stands beside the sum; then every other way."""
    every = predictions(summary)
    usable = [one for one in every if one.stiffness is not None and one.hypothesis is Hypothesis.KINEMATIC]
    first = usable[0] if usable else every[0]
    return _predicted(first) | {"others": [_predicted(one) for one in every if one is not first]}


def _predicted(one: Predicted) -> dict[str, Any]:
    told: dict[str, Any] = {"fabric_of": one.directions, "contact_stiffness": one.source,
                            "hypothesis": str(one.hypothesis), "distance": one.distance}
    if one.stiffness is None:
        return told | {"refused": one.refused}
    return told | one.stiffness.components | {"mandel": [list(row) for row in one.stiffness.rows]}
