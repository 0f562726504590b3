"""What ``granular contacts`` shows: the list in words and tables, and the model beside it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from granular.contacts.estimate import estimated_forces
from granular.contacts.layout import columns, facts, title
from granular.contacts.moments import BRANCHES, NORMALS
from granular.contacts.prediction import EQUAL_CONTACTS, ESTIMATED_FORCES, Predicted, fitted_fabric, predictions
from granular.errors import FabricOutOfRange
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.contacts.by_angle import ByAngle
    from granular.contacts.summary import ContactSummary
    from granular.elasticity import Stiffness
    from granular.fabric_tensors import SymmetryTest

SHOWN = ("C1111", "C2222", "C3333", "C1122", "C1133", "C2233", "C2323", "C1313", "C1212")
"""Components that an assembly with three planes of symmetry has; the others are small, and in the JSON output."""

TOLD = 2e-3
"""Share of eq. (1) from which the stiffness of long branches is worth a line [-]."""

_SHORT = {EQUAL_CONTACTS: "mean kn", ESTIMATED_FORCES: "forces"}
_WIDE = 2


def summary_as_text(summary: ContactSummary) -> list[RenderableType]:
    """Blocks for a console of any width.

    Parameters
    ----------
    summary : ContactSummary
        A list.

    Returns
    -------
    list of renderable
        For ``rich.console.Console.print``, in order.

    Notes
    -----
    Source: the command line's interface.
    """
    every = predictions(summary)
    blocks: list[RenderableType] = [
        title("Contacts"), facts(_counts(summary)), "", title("Fabric"), facts(_fabric(summary)), "",
        title("By the angle of the normal from axis 3"), _angles(summary), ""]
    blocks += [title("Stress and forces"), facts(_forces(summary)), ""]
    blocks.append(title("Stiffness [MPa]: sums over the list, and the model of the fitted fabric"))
    for hypothesis, name, truth in ((Hypothesis.KINEMATIC, "eq. (1)", summary.kinematic),
                                    (Hypothesis.STATIC, "eq. (5)", summary.static)):
        usable = [one for one in every if one.hypothesis is hypothesis and one.stiffness is not None]
        if truth is not None or usable:
            blocks += [_stiffness(hypothesis, name, truth, usable), ""]
    return [*blocks, facts(_how(summary, every))]


def _counts(summary: ContactSummary) -> dict[str, str]:
    without = summary.coordination_without_rattlers
    rattlers = "" if summary.rattlers is None else f"; {summary.rattlers} of {summary.grains} grains rattle"
    return {
        "list": f"{summary.name}",
        "contacts": f"{summary.contacts}"
                + (f", {summary.dropped} left out" if summary.dropped else ""),
        "per volume": f"{summary.contacts_per_volume:.6g} 1/m^3",
        "coordination": "needs --grains" if summary.coordination_number is None else
                        f"{summary.coordination_number:.4f} with all grains",
        "without rattlers": ("needs id1 id2" if without is None else f"{without:.4f}") + rattlers,
    }


def _fabric(summary: ContactSummary) -> dict[str, str | list[str]]:
    def tensor(of: Any, name: str) -> list[str]:
        return [f"D33 {7.5 * (float(of[2, 2]) - 1 / 3):+.4f} +/- {summary.doubt_of(name):.4f}",
                *(f"N{k}{k} {of[k - 1, k - 1]:.4f}" for k in (1, 2, 3))]

    lengths, moments = summary.lengths, summary.length_moments
    told: dict[str, str | list[str]] = {
        "normals": tensor(summary.normals, NORMALS),
        "seen in them": "\n".join(_words(test) for test in summary.tests),
        "branches": tensor(summary.branches, BRANCHES)}
    try:
        told["lengths"] = f"Dr33 {fitted_fabric(summary).Dr33:+.5f} by direction"
    except FabricOutOfRange as refusal:
        told["model"] = str(refusal)
    quantiles = [f"{round(100 * share)} % {lengths.quantile(share):.5g}" for share in (0.1, 0.5, 0.9)]
    told["lengths [m]"] = [f"mean {moments['l']:.6g}", f"least {lengths.least:.5g}", *quantiles,
                           f"greatest {lengths.greatest:.5g}"]
    if summary.stiffer_where_longer is not None and abs(summary.stiffer_where_longer - 1) > TOLD:
        told["sizes"] = (f"contacts of long branches are stiffer: <l^2 kn> is {summary.stiffer_where_longer:.4f} times "
                         "<l^2> <kn>. The model has one kn for all lengths and misses that factor of eq. (1)")
    if summary.stragglers is not None:
        many, above, below = summary.stragglers
        told["far longer"] = (
            f"{many} of the branches, from {above:.5g} m; the others end at {below:.5g} m. In a periodic cell they "
            "lack its period, and all numbers here are wrong: add it with --cell LX LY LZ")
    return told


def _words(test: SymmetryTest) -> str:
    """With the level in one piece, where no line ends."""
    return test.words.replace("the given axis", "axis 3").replace("p = ", "p=").replace("p < ", "p<")


def _angles(summary: ContactSummary) -> RenderableType:
    """Classes of ten degrees, with the forces that the stress alone would give."""
    wide: ByAngle = summary.by_angle.merged(_WIDE)
    shown: list[tuple[str, str, Any, str]] = [
        ("", "M", wide.contacts, ".0f"), ("", "4 pi E", wide.relative_density(), ".3f"),
        ("l/", "mean", _over(wide.mean("length"), summary.length_moments["l"]), ".3f")]
    groups = [len(shown)]
    estimate = estimated_forces(summary, wide)
    if estimate is not None:
        shown += [("fn", "[N]", wide.mean("normal_force"), ".3g"), ("eq.", "(23)", estimate[0], ".3g")]
        groups.append(2)
        if summary.stress_is_whole:
            shown += [("|fs|", "[N]", wide.mean("shear_force"), ".3g"),
                      ("fs up", "[N]", wide.mean("meridian_force"), ".2g"), ("eq.", "(23)", estimate[1], ".2g")]
            groups.append(3)
    if (stiff := wide.mean("kn")) is not None:
        shown += [("kn", "[kN/m]", _over(stiff, 1e3), ".4g")]
        groups.append(1)
    edges = wide.degrees
    rows = [[f"{edges[k]:.0f}-{edges[k + 1]:.0f}",
             *("-" if math.isnan(values[k]) else format(values[k], form) for _, _, values, form in shown)]
            for k in range(wide.contacts.size)]
    heads = [["", *(top for top, _, _, _ in shown)], ["degrees", *(below for _, below, _, _ in shown)]]
    return columns(heads + rows, groups)


def _over(values: Any, unit: float) -> Any:
    return values / unit


def _forces(summary: ContactSummary) -> dict[str, str | list[str]]:
    if summary.stress is None:
        return {"stress": "the list has no contact forces"}
    stress = summary.stress / 1e3
    told: dict[str, str | list[str]] = {
        "stress [kPa]": [*(f"s{k}{k} {stress[k - 1, k - 1]:.5g}" for k in (1, 2, 3)),
                         *(f"s{i}{j} {stress[i - 1, j - 1]:.2g}" for i, j in ((2, 3), (1, 3), (1, 2)))],
        "of": "" if summary.stress_is_whole else "normal forces only; the list has no shear forces"}
    mean, across = float(stress.trace()) / 3, float(stress[0, 0] + stress[1, 1]) / 2
    ratio = f", s33 over the mean of s11 and s22: {float(stress[2, 2]) / across:.4f}" if across > 0 else ""
    told["mean stress"] = f"{mean:.5g} kPa{ratio}"
    if summary.sliding is not None:
        told["sliding"] = f"{100 * summary.sliding:.2f} % of the contacts, at mu = {summary.material.friction:g}"
    return told


def _stiffness(hypothesis: Hypothesis, name: str, truth: Stiffness | None, usable: list[Predicted]) -> RenderableType:
    """One hypothesis: the sum over the list, then what the model says."""
    beside = ([] if truth is None else [("", name, truth, "")]) + [
        (one.directions, _SHORT[one.source], one.stiffness, "" if one.distance is None else f"{one.distance:.2%}")
        for one in usable if one.stiffness is not None]
    return columns([[str(hypothesis), *(top for top, _, _, _ in beside)], ["", *(below for _, below, _, _ in beside)],
                    *([part, *(f"{stiffness.component(part) / 1e6:.5g}" for _, _, stiffness, _ in beside)]
                      for part in SHOWN), ["distance", *(away for _, _, _, away in beside)]])


def _how(summary: ContactSummary, every: list[Predicted]) -> dict[str, str]:
    told = {"kn and ks": summary.stiffness_source or "", "no eq. (1)": summary.no_kinematic,
            "no eq. (5)": summary.no_static if not summary.no_kinematic else "",
            "model": "of the fabric of normals or branches; with the mean kn and ks of the list, or with forces that "
                     "are estimated from the stress",
            "distance": "norm of the difference of all 81 components over that of the sum"}
    refused = {one.refused for one in every if one.stiffness is None} - {summary.no_kinematic}
    return told | ({"no prediction": "\n".join(sorted(refused))} if refused else {})
