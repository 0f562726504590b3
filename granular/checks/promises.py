"""Whether a plan keeps its promise: random scenes at several wanted accuracies against their true stiffness."""

from __future__ import annotations

import heapq
import json
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from granular.checks.random_scenes import RandomScene, random_scenes
from granular.checks.true_stiffness import TrueStiffness, true_error, true_stiffness
from granular.errors import GranularError
from granular.output import write_text

if TYPE_CHECKING:
    from rich.table import Table

    from granular.evaluation import Evaluation
    from granular.scene import Scene

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12)
"""Wanted relative accuracies of every scene [-]."""

SHOWN, KEPT = 10, 200
"""How many of the worst are listed, and of the misses and refusals kept in the file."""

KEPT_ALL, BROKE_SOME = 0, 1
"""Exit codes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """One scene at one wanted accuracy.

    Attributes
    ----------
    drawn : RandomScene
        The scene.
    rtol : float
        Wanted relative accuracy of every component [-].
    error : float
        True relative error of the worst component in pascals [-]; infinite for what is no number, and where the
        evaluation ended in anything but a result or a refusal.
    component : str
        Which component; or what the evaluation ended in.
    bound : float
        Relative error that the result states [-].
    doubt : float
        Relative error that the true value may have itself [-].
    route : str
        Route that was chosen; empty where there is no result.
    evaluations : int
        Directions in which the integrand was evaluated [-].
    left_out : tuple of str
        Effects that the same scene has without a wanted accuracy, and that this result does without.
    refusal : str
        Message of a refusal, empty for a result.
    """

    drawn: RandomScene
    rtol: float
    error: float
    component: str
    bound: float
    doubt: float
    route: str = ""
    evaluations: int = 0
    left_out: tuple[str, ...] = ()
    refusal: str = ""

    @property
    def kept(self) -> bool:
        """Whether the true error is at most the stated one, and that at most what was wanted.

        A result that states more than was wanted should have been a refusal, which breaks no promise.
        """
        return bool(self.refusal) or (self.error - self.doubt <= min(self.rtol, self.bound) and not self.unsure)

    @property
    def unsure(self) -> bool:
        """Whether the result states a larger error than was wanted."""
        return not self.refusal and self.bound > self.rtol

    def as_json(self) -> dict[str, object]:
        """Everything, with the scene as the text of a scene file."""
        return {"number": self.drawn.number, "kind": self.drawn.kind, "rtol": self.rtol, "component": self.component,
                "error": _finite(self.error), "stated": _finite(self.bound), "route": self.route,
                "evaluations": self.evaluations, "left_out": list(self.left_out), "refusal": self.refusal,
                "kept": self.kept, "scene": self.drawn.toml()}


@dataclass(slots=True)
class Group:
    """What is kept of the scenes of one kind at one wanted accuracy.

    Attributes
    ----------
    count, refused, misses, unsure : int
        Scenes, and how many of them were refused, how many promises were broken, and how many of these because the
        result stated a larger error than was wanted [-].
    over_rtol, over_bound : float
        Worst true error over the wanted accuracy and over the stated error [-]; an error within the doubt of the true
        value counts as none of the second.
    evaluations : int
        Sum of the evaluations [-].
    with_less : int
        Results that do without an effect which the scene has [-].
    """

    count: int = 0
    refused: int = 0
    misses: int = 0
    unsure: int = 0
    over_rtol: float = 0.0
    over_bound: float = 0.0
    evaluations: int = 0
    with_less: int = 0

    def add(self, outcome: Outcome) -> None:
        """Count an outcome."""
        self.count += 1
        self.misses += not outcome.kept
        self.unsure += outcome.unsure
        if outcome.refusal:
            self.refused += 1
            return
        self.over_rtol = max(self.over_rtol, outcome.error / outcome.rtol)
        self.over_bound = max(self.over_bound, _over(outcome.error - outcome.doubt, outcome.bound))
        self.evaluations += outcome.evaluations
        self.with_less += bool(outcome.left_out)

    def as_json(self, kind: str, rtol: float) -> dict[str, object]:
        """What the file says of the group."""
        served = self.count - self.refused
        return {"kind": kind, "rtol": rtol, "count": self.count, "refused": self.refused, "misses": self.misses,
                "stated_above_wanted": self.unsure, "worst_error_over_rtol": _finite(self.over_rtol),
                "worst_error_over_bound": _finite(self.over_bound),
                "mean_evaluations": self.evaluations / served if served else None,
                "with_effects_left_out": self.with_less}


@dataclass(slots=True)
class Record:
    """What is kept of a run, however long it is.

    Attributes
    ----------
    groups : dict
        (kind, wanted accuracy) -> what is kept of them.
    worst, misses, refusals : list of Outcome
        The worst ten by true error over wanted accuracy, broken promises first; the first of all misses and refusals.
    """

    groups: dict[tuple[str, float], Group] = field(default_factory=dict)
    worst: list[Outcome] = field(default_factory=list)
    misses: list[Outcome] = field(default_factory=list)
    refusals: list[Outcome] = field(default_factory=list)

    def add(self, outcome: Outcome) -> None:
        """Count an outcome."""
        self.groups.setdefault((outcome.drawn.kind, outcome.rtol), Group()).add(outcome)
        self.worst = heapq.nlargest(SHOWN, [*self.worst, outcome], key=_severity)
        if not outcome.kept and len(self.misses) < KEPT:
            self.misses.append(outcome)
        if outcome.refusal and len(self.refusals) < KEPT:
            self.refusals.append(outcome)

    @property
    def broken(self) -> int:
        """Number of broken promises [-]."""
        return sum(group.misses for group in self.groups.values())

    @property
    def refused(self) -> int:
        """Number of refusals [-]."""
        return sum(group.refused for group in self.groups.values())


def _severity(outcome: Outcome) -> tuple[bool, float]:
    return not outcome.kept, outcome.error / outcome.rtol


def _over(error: float, bound: float) -> float:
    if error <= 0:
        return 0.0
    return error / bound if bound > 0 else math.inf


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def outcomes(count: int, *, seed: int, finished: Callable[[int], None] | None = None) -> Iterator[Outcome]:
    """Evaluate random scenes at every wanted accuracy, with the route and the effects left to the plan.

    Parameters
    ----------
    count : int
        How many scenes [-].
    seed : int
        Start of the random numbers.
    finished : callable or None
        Told how many scenes have been done, to show progress.

    Returns
    -------
    iterator of Outcome
        One for each scene and wanted accuracy.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: true values to 1e-19, see :func:`granular.checks.true_stiffness.true_stiffness`. Source: eqs (1)-(23).

    Examples
    --------
    >>> all(outcome.kept for outcome in outcomes(2, seed=7))
    True
    """
    for drawn in random_scenes(count, seed=seed):
        scene = drawn.scene
        truth, effects = true_stiffness(scene), _effects_of(scene)
        for rtol in ACCURACIES:
            yield _outcome(drawn, scene, rtol, truth, effects)
        if finished is not None:
            finished(drawn.number)


def _effects_of(scene: Scene) -> tuple[str, ...]:
    """Effects of the scene when no accuracy is given."""
    from granular.planning import plan

    return plan(scene).effects_simulated


def _outcome(drawn: RandomScene, scene: Scene, rtol: float, truth: TrueStiffness,
             effects: tuple[str, ...]) -> Outcome:
    from granular.evaluation import evaluate

    try:
        result: Evaluation = evaluate(scene, rtol=rtol)
    except GranularError as refusal:
        return Outcome(drawn=drawn, rtol=rtol, error=0.0, component="", bound=0.0, doubt=0.0, refusal=str(refusal))
    except Exception as failure:  # whatever it is, no number was given where one was promised
        return Outcome(drawn=drawn, rtol=rtol, error=math.inf, component=f"{type(failure).__name__}: {failure}",
                       bound=0.0, doubt=0.0)
    component, error = true_error(result, truth)
    left_out = tuple(name for name in effects if name not in result.effects_simulated)
    return Outcome(drawn=drawn, rtol=rtol, error=error, component=component, bound=result.relative_error,
                   doubt=truth.doubt, route=result.route, evaluations=result.evaluations, left_out=left_out)


def run_promises(count: int, *, seed: int, json_out: Path | None = None) -> int:
    """Check the promises of a plan, show the worst with their scenes, and say whether any was broken.

    Parameters
    ----------
    count : int
        How many random scenes [-].
    seed : int
        Start of the random numbers.
    json_out : Path or None
        File for the outcome as JSON; it is replaced only once the run is complete.

    Returns
    -------
    int
        Exit code: 1 when a true error is above the wanted or the stated one, or a stated one above what was wanted,
        otherwise 0.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    OutputUnwritable
        ``json_out`` cannot be written.

    Notes
    -----
    Accuracy and source: :func:`outcomes`.
    """
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    record = Record()
    with Progress(*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn(),
                  console=Console(stderr=True)) as progress:
        task = progress.add_task("Checking promises", total=count)
        for outcome in outcomes(count, seed=seed, finished=lambda number: progress.update(task, completed=number)):
            record.add(outcome)
    if json_out is not None:
        write_text(json_out, json.dumps(_as_json(record, count, seed), indent=1) + "\n")
    console = Console(highlight=False, markup=False, emoji=False)
    console.print(_overview(record))
    shown = [outcome for outcome in record.worst if not outcome.kept] or record.worst
    console.print("The worst, as scene files", style="italic")
    for outcome in shown:
        console.print(_heading(outcome), style=None if outcome.kept else "bold red", soft_wrap=True)
        console.print(outcome.drawn.toml(), soft_wrap=True)
    asked = count * len(ACCURACIES)
    console.print(f"{count} scenes from seed {seed}, {asked} promises asked for, {record.refused} refused, "
                  f"{record.broken} broken", soft_wrap=True)
    return BROKE_SOME if record.broken else KEPT_ALL


def _as_json(record: Record, count: int, seed: int) -> dict[str, object]:
    return {"command": f"granular check --promises {count} --seed {seed}", "seed": seed, "scenes": count,
            "rtols": list(ACCURACIES), "promises": count * len(ACCURACIES), "refused": record.refused,
            "broken": record.broken,
            "by_kind": [group.as_json(kind, rtol) for (kind, rtol), group in record.groups.items()],
            "misses": [outcome.as_json() for outcome in record.misses],
            "refusals": [outcome.as_json() for outcome in record.refusals],
            "worst": [outcome.as_json() for outcome in record.worst]}


def _heading(outcome: Outcome) -> str:
    head = f"# scene {outcome.drawn.number}, {outcome.drawn.kind}, rtol {outcome.rtol:g}"
    if not outcome.route:
        return f"{head}: {outcome.refusal or outcome.component}"
    less = f", without {', '.join(outcome.left_out)}" if outcome.left_out else ""
    return (f"{head}: {outcome.component} off by {outcome.error:.2e}, stated {outcome.bound:.2e}, by "
            f"{outcome.route}{less}")


def _overview(record: Record) -> Table:
    from rich.table import Table

    table = Table(title="True error over the wanted and over the stated one, worst of each kind",
                  title_justify="left", box=None, pad_edge=False, padding=(0, 1), collapse_padding=True)
    for heading in ("scenes", "rtol", "count", "refused", "/wanted", "/stated", "directions", "with less"):
        table.add_column(heading, no_wrap=True, justify="left" if heading == "scenes" else "right")
    shown = ""
    for (kind, rtol), group in record.groups.items():
        served = max(1, group.count - group.refused)
        table.add_row("" if kind == shown else kind, f"{rtol:g}", str(group.count), str(group.refused),
                      f"{group.over_rtol:.2g}", f"{group.over_bound:.2g}", f"{group.evaluations / served:.1f}",
                      str(group.with_less), style="bold red" if group.misses else None)
        shown = kind
    return table
