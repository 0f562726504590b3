"""Whether a plan chooses well: its route against every other that is accurate enough, timed on random scenes."""

from __future__ import annotations

import json
import statistics
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from granular.checks.choice_times import ROUNDS, best_times, candidates
from granular.checks.promises import ACCURACIES
from granular.checks.random_scenes import RandomScene, random_scenes
from granular.checks.true_stiffness import true_error, true_stiffness
from granular.output import write_text

if TYPE_CHECKING:
    from rich.table import Table

Key = TypeVar("Key")

NEAR = 1.5
"""A choice is a good one when its route takes at most so many times the time of the cheapest."""

SHOWN, KEPT = 5, 100
"""How many of the worst choices are listed, and kept in the file."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """What a plan chose for one scene at one wanted accuracy, beside all that it could have chosen.

    Attributes
    ----------
    drawn : RandomScene
        The scene.
    rtol : float
        Wanted relative accuracy of every component [-].
    chosen : str
        The plan's route.
    seconds : dict
        Route -> best time of the processor for one evaluation [s], of the plan's route and of those whose true error
        is at most rtol.
    planned : float
        The same with the choice left to the plan [s].
    kept : bool
        Whether the plan's own route is accurate enough.
    """

    drawn: RandomScene
    rtol: float
    chosen: str
    seconds: dict[str, float]
    planned: float
    kept: bool

    @property
    def cheapest(self) -> str:
        """The route that took least."""
        return min(self.seconds, key=lambda name: self.seconds[name])

    @property
    def ratio(self) -> float:
        """Time of the plan's route over that of the cheapest [-], >= 1."""
        return self.seconds[self.chosen] / self.seconds[self.cheapest]

    def as_json(self) -> dict[str, object]:
        """Everything, with the scene as the text of a scene file."""
        return {"number": self.drawn.number, "kind": self.drawn.kind, "rtol": self.rtol, "chosen": self.chosen,
                "cheapest": self.cheapest, "ratio": self.ratio, "seconds": self.seconds, "planned": self.planned,
                "kept": self.kept, "scene": self.drawn.toml()}


def choices(count: int, *, seed: int, rounds: int = ROUNDS,
            finished: Callable[[int], None] | None = None) -> Iterator[Choice]:
    """Time the plan's route and all others on random scenes at every wanted accuracy.

    Parameters
    ----------
    count : int
        How many scenes [-].
    seed : int
        Start of the random numbers.
    rounds : int
        How often each route is timed at least, all of them in each round [-]; the best time counts.
    finished : callable or None
        Told how many scenes have been done, to show progress.

    Returns
    -------
    iterator of Choice
        One for each scene and wanted accuracy that the plan does not refuse.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: errors against true values; times are those of this machine, and nothing is judged by them. A route that
    refuses the accuracy is evaluated without it, and counts when its true error is small enough all the same. Source:
    :func:`granular.evaluate`, by its route's name.
    """
    for drawn in random_scenes(count, seed=seed):
        scene = drawn.scene
        truth = true_stiffness(scene)
        for rtol in ACCURACIES:
            found = candidates(scene, rtol)
            if found is None:
                continue
            planned, routes = found
            errors = {candidate.name: true_error(candidate.result, truth)[1] for candidate in routes}
            chosen = planned.result.route
            good = [candidate for candidate in routes
                    if errors[candidate.name] - truth.doubt <= rtol or candidate.name == chosen]
            times = best_times([planned, *good], rounds=rounds, against=chosen)
            if times[chosen] > NEAR * min(times.values()):  # poor, or disturbed in every round: once more, and longer
                again = best_times([planned, *good], rounds=3 * rounds, against=chosen)
                times = {name: min(seconds, again[name]) for name, seconds in times.items()}
            yield Choice(drawn=drawn, rtol=rtol, chosen=chosen, planned=times.pop(planned.name), seconds=times,
                         kept=errors[chosen] - truth.doubt <= rtol)
        if finished is not None:
            finished(drawn.number)


def run_choices(count: int, *, seed: int, json_out: Path | None = None) -> int:
    """Time choices, and show how often they were good ones and the worst of them with their scenes.

    Parameters
    ----------
    count : int
        How many random scenes [-].
    seed : int
        Start of the random numbers.
    json_out : Path or None
        File for the outcome as JSON, with machine and versions; it is replaced only once the run is complete.

    Returns
    -------
    int
        Exit code: 0. Times are shown, never judged.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    OutputUnwritable
        ``json_out`` cannot be written.

    Notes
    -----
    Accuracy and source: :func:`choices`.
    """
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    with Progress(*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn(),
                  console=Console(stderr=True)) as progress:
        task = progress.add_task("Timing choices", total=count)
        made = list(choices(count, seed=seed, finished=lambda number: progress.update(task, completed=number)))
    record = summary(made, count=count, seed=seed)
    if json_out is not None:
        write_text(json_out, json.dumps(record, indent=1) + "\n")
    console = Console(highlight=False, markup=False, emoji=False)
    console.print(_overview(made))
    for choice in sorted(made, key=lambda choice: -choice.ratio)[:SHOWN]:
        console.print(f"# scene {choice.drawn.number}, {choice.drawn.kind}, rtol {choice.rtol:g}: {choice.chosen} "
                      f"takes {choice.ratio:.2f} times what {choice.cheapest} takes", soft_wrap=True)
        console.print(choice.drawn.toml(), soft_wrap=True)
    shares = statistics_of(made)
    console.print(f"{count} scenes from seed {seed}, {shares['choices']} choices: {100 * shares['share']:.1f} % within "
                  f"{NEAR} times of the cheapest route that is accurate enough, median {shares['median']:.2f}, worst "
                  f"{shares['worst']:.2f}", soft_wrap=True)
    return 0


def statistics_of(made: list[Choice]) -> dict[str, float]:
    """How good choices were.

    Parameters
    ----------
    made : list of Choice
        At least one.

    Returns
    -------
    dict
        Number of choices, share of those within 1.5 of the cheapest, median and worst ratio, the median of the time
        with the plan over that of its route alone, and how many chosen routes were not accurate enough.

    Notes
    -----
    Source: the definitions.
    """
    ratios = [choice.ratio for choice in made]
    return {"choices": len(made), "share": sum(ratio <= NEAR for ratio in ratios) / len(made),
            "median": statistics.median(ratios), "worst": max(ratios),
            "planned_over_chosen": statistics.median(choice.planned / choice.seconds[choice.chosen] for choice in made),
            "not_accurate_enough": sum(not choice.kept for choice in made)}


def summary(made: list[Choice], *, count: int, seed: int) -> dict[str, object]:
    """What the file says.

    Parameters
    ----------
    made : list of Choice
        All choices of a run, at least one.
    count, seed : int
        Scenes and start of the random numbers [-].

    Returns
    -------
    dict
        Command, machine and versions, statistics of all choices and by wanted accuracy and kind of scene, how often
        each route was chosen and was the cheapest, and the worst choices with their scenes.

    Notes
    -----
    Source: :func:`statistics_of`.
    """
    from granular.cost import machine

    return {"command": f"granular check --choices {count} --seed {seed}", "seed": seed, "scenes": count,
            "rtols": list(ACCURACIES), "rounds": ROUNDS, "near": NEAR, "machine": machine(), "all": statistics_of(made),
            "by_rtol": [{"rtol": rtol} | statistics_of(group) for rtol, group in _groups(made, lambda c: c.rtol)],
            "by_kind": [{"kind": kind} | statistics_of(group)
                        for kind, group in _groups(made, lambda c: c.drawn.kind)],
            "routes": [{"chosen": chosen, "cheapest": cheapest, "count": number} for (chosen, cheapest), number in
                       sorted(Counter((choice.chosen, choice.cheapest) for choice in made).items())],
            "worst": [choice.as_json() for choice in sorted(made, key=lambda c: -c.ratio)[:KEPT]
                      if choice.ratio > NEAR or choice is max(made, key=lambda c: c.ratio)]}


def _groups(made: list[Choice], key: Callable[[Choice], Key]) -> list[tuple[Key, list[Choice]]]:
    groups: dict[Key, list[Choice]] = {}
    for choice in made:
        groups.setdefault(key(choice), []).append(choice)
    return list(groups.items())


def _overview(made: list[Choice]) -> Table:
    from rich.table import Table

    table = Table(title="Time of the plan's route over that of the cheapest that is accurate enough",
                  title_justify="left", box=None, pad_edge=False, padding=(0, 1), collapse_padding=True)
    for heading in ("scenes", "rtol", "choices", f"within {NEAR}", "median", "worst", "cheapest there"):
        table.add_column(heading, no_wrap=True, justify="left" if heading in ("scenes", "cheapest there") else "right")
    shown = ""
    for (kind, rtol), group in _groups(made, lambda c: (c.drawn.kind, c.rtol)):
        known, worst = statistics_of(group), max(group, key=lambda c: c.ratio)
        table.add_row("" if kind == shown else kind, f"{rtol:g}", str(len(group)), f"{100 * known['share']:.0f} %",
                      f"{known['median']:.2f}", f"{known['worst']:.2f}",
                      worst.cheapest)
        shown = kind
    return table
