"""The search for the worst input: random contact forces and spheroids against ball arithmetic, singly and by arrays."""

from __future__ import annotations

import heapq
import json
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from granular.checks.comparison import worst_relative
from granular.checks.loads import LoadedCase, loaded_sample
from granular.checks.spheroid_cases import SpheroidCase, spheroid_sample
from granular.checks.voices import MOST_ERROR
from granular.hypothesis import Hypothesis
from granular.output import write_text
from granular.routes import axial, certified

if TYPE_CHECKING:
    from rich.table import Table

Case = LoadedCase | SpheroidCase

ARRAY = "axial_stiffness"
"""Name under which the function for arrays is shown."""

BLOCK = 64
"""Inputs that go through the function for arrays together."""

DIGITS = 20
"""Of an enclosure: errors of 1e-15 are then known to 1e-5 of themselves."""

SHOWN = 10
"""How many of the worst are listed."""

FOUND_NONE, FOUND_SOME = 0, 1
"""Exit codes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """What one route did with one input under one hypothesis.

    Attributes
    ----------
    number : int
        Which input of the sample, from 1.
    case : LoadedCase or SpheroidCase
        The input.
    hypothesis : Hypothesis
        Kinematic or static.
    route : str
        ``"axial"`` for one scene at a time, ``"axial_stiffness"`` for arrays.
    component : str
        The component that is worst relative to itself.
    error : float
        Its relative error against the enclosure [-]; infinite for a wrong zero and for what is not finite.
    """

    number: int
    case: Case
    hypothesis: Hypothesis
    route: str
    component: str
    error: float

    @property
    def agrees(self) -> bool:
        """Whether the error is at most 2e-15 (kinematic) or 4e-15 (static)."""
        return self.error <= MOST_ERROR[self.hypothesis]

    def as_json(self) -> dict[str, object]:
        """Everything, with inputs as strings that carry all their digits."""
        return {"number": self.number, "kind": self.case.kind, "inputs": self.case.inputs(),
                "hypothesis": self.hypothesis.value, "route": self.route, "component": self.component,
                "error": self.error if math.isfinite(self.error) else None, "agrees": self.agrees}


@dataclass(slots=True)
class Summary:
    """What is kept of a search, however long it is.

    Attributes
    ----------
    comparisons, misses : int
        How many there were [-].
    worst : list of Finding
        The worst ten, worst first.
    by_route : dict
        (route, hypothesis, kind) -> number of comparisons and the worst of them.
    """

    comparisons: int = 0
    misses: int = 0
    worst: list[Finding] = field(default_factory=list)
    by_route: dict[tuple[str, Hypothesis, str], tuple[int, Finding]] = field(default_factory=dict)

    def add(self, finding: Finding) -> None:
        """Count a finding."""
        self.comparisons += 1
        self.misses += not finding.agrees
        self.worst = heapq.nlargest(SHOWN, [*self.worst, finding], key=_severity)
        key = (finding.route, finding.hypothesis, finding.case.kind)
        count, worst = self.by_route.get(key, (0, finding))
        self.by_route[key] = (count + 1, max(worst, finding, key=_severity))


def _severity(finding: Finding) -> float:
    return finding.error / MOST_ERROR[finding.hypothesis]


def findings(count: int, *, seed: int, finished: Callable[[int], None] | None = None) -> Iterator[Finding]:
    """Compare the axial route, one scene at a time and for arrays, with ball arithmetic.

    Parameters
    ----------
    count : int
        How many random inputs with contact forces, and how many spheroids [-].
    seed : int
        Start of the random numbers.
    finished : callable or None
        Told how many inputs have been done, to show progress.

    Returns
    -------
    iterator of Finding
        One for each input and route under the kinematic hypothesis, and under the static one where every contact
        sticks and no grain spins. The function for arrays takes densities of rank two, stress ratios above 0, and no
        spheroids.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: enclosures to 20 digits. Source: :func:`granular.routes.certified.enclose`.

    Examples
    --------
    >>> all(finding.agrees for finding in findings(2, seed=7))
    True
    """
    sample = enumerate(loaded_sample(count, seed=seed), start=1)
    shapes = spheroid_sample(count, seed=seed)
    while block := list(islice(sample, BLOCK)):
        arrays = {hypothesis: _by_arrays(block, hypothesis) for hypothesis in Hypothesis}
        for (number, case), spheroid in zip(block, shapes, strict=False):
            for hypothesis in _finite(case):
                known = _known(case, hypothesis)
                yield _alone(number, case, hypothesis, known)
                if number in arrays[hypothesis]:
                    yield _finding(number, case, hypothesis, ARRAY, arrays[hypothesis][number], known)
            for hypothesis in _finite(spheroid):
                yield _alone(number, spheroid, hypothesis, _known(spheroid, hypothesis))
            if finished is not None:
                finished(number)


def _finite(case: Case) -> tuple[Hypothesis, ...]:
    return tuple(Hypothesis) if case.kind in ("stick", "spheroid") else (Hypothesis.KINEMATIC,)


def _known(case: Case, hypothesis: Hypothesis) -> list[Fraction]:
    return [enclosure.midpoint for enclosure in certified.enclose(
        case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis, loading=case.loading, digits=DIGITS)]


def _alone(number: int, case: Case, hypothesis: Hypothesis, known: list[Fraction]) -> Finding:
    """Evaluate one scene at a time."""
    one = axial.evaluate(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis, loading=case.loading)
    return _finding(number, case, hypothesis, axial.NAME, list(one.components), known)


def _finding(number: int, case: Case, hypothesis: Hypothesis, route: str, computed: list[float],
             known: list[Fraction]) -> Finding:
    component, error, _ = worst_relative(computed, known)
    return Finding(number=number, case=case, hypothesis=hypothesis, route=route, component=component, error=error)


def _by_arrays(block: list[tuple[int, LoadedCase]], hypothesis: Hypothesis) -> dict[int, list[float]]:
    """Number -> six components by the function for arrays, of the inputs that it takes."""
    from granular.array_stiffness import axial_stiffness

    found: dict[int, list[float]] = {}
    for without in (True, False):
        chosen = [(number, case) for number, case in block
                  if (case.loading.friction is None) is without and hypothesis in _finite(case)
                  and case.fabric.D3333 == 0 and case.loading.sigma11 == 1 and case.loading.sigma33 > 0]
        if not chosen:
            continue
        columns = [[case.fabric.D33, case.fabric.Dr33, float(case.loading.sigma33), case.poisson_ratio]
                   for _, case in chosen]
        d33, dr33, ratio, nu = map(list, zip(*columns, strict=True))
        friction = None if without else [case.loading.friction or 0.0 for _, case in chosen]
        rows = axial_stiffness(d33, dr33, ratio, friction, nu, hypothesis=hypothesis).tolist()
        found |= dict(zip((number for number, _ in chosen), rows, strict=True))
    return found


def run_search(count: int, *, seed: int, json_out: Path | None = None) -> int:
    """Search, show the worst ten with their inputs, and say whether anything is off by more than is allowed.

    Parameters
    ----------
    count : int
        How many random inputs with contact forces, and how many spheroids [-].
    seed : int
        Start of the random numbers.
    json_out : Path or None
        File for the worst ten and the summary as JSON; it is replaced only once the search is complete.

    Returns
    -------
    int
        Exit code: 1 when a component is off by more than 2e-15 (kinematic) or 4e-15 (static) of itself, otherwise 0.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    OutputUnwritable
        ``json_out`` cannot be written.

    Notes
    -----
    Accuracy: relative errors, component by component, against enclosures to 20 digits. Source: eqs (6), (7),
    (20)-(23).
    """
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    summary = Summary()
    with Progress(*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn(),
                  console=Console(stderr=True)) as progress:
        task = progress.add_task("Searching", total=count)
        for finding in findings(count, seed=seed, finished=lambda number: progress.update(task, completed=number)):
            summary.add(finding)
    if json_out is not None:
        write_text(json_out, json.dumps(_as_json(summary, count, seed), indent=1) + "\n")
    console = Console(highlight=False, markup=False, emoji=False)
    console.print(_overview(summary))
    console.print(_worst(summary))
    console.print(f"{count} inputs from seed {seed} and as many spheroids, {summary.comparisons} comparisons, "
                  f"{summary.misses} beyond {MOST_ERROR[Hypothesis.KINEMATIC]:g} (kinematic) or "
                  f"{MOST_ERROR[Hypothesis.STATIC]:g} (static)", soft_wrap=True)
    return FOUND_SOME if summary.misses else FOUND_NONE


def _as_json(summary: Summary, count: int, seed: int) -> dict[str, object]:
    return {"inputs": count, "seed": seed, "comparisons": summary.comparisons, "misses": summary.misses,
            "allowed": {hypothesis.value: bound for hypothesis, bound in MOST_ERROR.items()},
            "worst": [finding.as_json() for finding in summary.worst],
            "by_route": [{"comparisons": number, "worst": worst.as_json()}
                         for number, worst in summary.by_route.values()]}


def _overview(summary: Summary) -> Table:
    from rich.table import Table

    table = Table(title="Worst relative error of six components", title_justify="left", box=None, pad_edge=False)
    for heading in ("contacts", "route", "hypothesis", "comparisons", "worst", "component"):
        table.add_column(heading, no_wrap=True)
    for (route, hypothesis, kind), (number, worst) in sorted(summary.by_route.items()):
        table.add_row(kind, route, hypothesis.value, str(number), f"{worst.error:.2e}", worst.component)
    return table


def _worst(summary: Summary) -> Table:
    from rich.table import Table

    table = Table(title="The worst, with inputs to run them again", title_justify="left", box=None, pad_edge=False,
                  padding=(0, 1))
    for heading in ("number", "error", "what", "inputs"):
        table.add_column(heading, no_wrap=True)
    for finding in summary.worst:
        inputs = "\n".join(f"{name} = {value}" for name, value in finding.case.inputs().items())
        table.add_row(str(finding.number), f"{finding.error:.2e}",
                      f"{finding.component}\n{finding.hypothesis}\n{finding.route}\n{finding.case.kind}", inputs,
                      style=None if finding.agrees else "bold red")
    return table
