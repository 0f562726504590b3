"""The command ``granular cost``: measure scene after scene, keep what is finished, and print a table."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from granular.cost import outside
from granular.cost.machine import machine
from granular.cost.measurement import ROUTE_NAMES, measure_scene, settings_of
from granular.cost.scenes import NAMES, SCENES, CostScene
from granular.cost.store import Study, resumed
from granular.cost.table import tables
from granular.cost.timing import UNIT
from granular.errors import BadOption
from granular.fields import chosen
from granular.routes.catalogue import CATALOGUE

DONE, INTERRUPTED = 0, 130
"""Exit codes."""

ROUNDS = 15
"""How often everything is timed unless told otherwise [-]."""

Advanced = Callable[[str], None]
"""Told what is being measured after each step."""


def run_cost(*, out: Path | None = None, rounds: int = ROUNDS, scenes: Sequence[str] = (), routes: Sequence[str] = (),
             resume: bool = False, advanced: Advanced | None = None) -> int:
    """Measure, print a table, and write the data after every scene.

    Parameters
    ----------
    out : Path or None
        JSON file for the data; it is replaced as a whole after every scene. None writes none.
    rounds : int
        How often everything is timed [-], >= 2.
    scenes, routes : sequence of str
        Names of what is measured; none means all.
    resume : bool
        Measure only what ``out`` does not hold yet.
    advanced : callable or None
        Told what is measured after each step, in place of the progress bar on standard error.

    Returns
    -------
    int
        Exit code: 0 done, 130 stopped by Ctrl-C, with the finished scenes kept. Times are shown, never judged.

    Raises
    ------
    UnknownChoice
        There is no such scene or route.
    BadOption
        There is nothing to resume, or it does not fit.
    CertifiedArithmeticMissing
        python-flint is not installed.
    OutputUnwritable
        ``out`` cannot be written.

    Notes
    -----
    Accuracy and source: :func:`granular.cost.measurement.measure_scene`.
    """
    wanted_scenes = [chosen(name, NAMES, name="--scene") for name in scenes] or list(NAMES)
    wanted_routes = [chosen(name, ROUTE_NAMES, name="--route") for name in routes] or list(ROUTE_NAMES)
    command = _command(scenes, routes, rounds)
    if resume and out is None:
        raise BadOption("--resume without --out", allowed="allowed together with --out FILE",
                        remedy="Name the file that holds what was measured.")
    study = resumed(out, command=command, rounds=rounds) if resume and out is not None else Study(command, rounds)
    selected = [scene for scene in SCENES if scene.name in wanted_scenes]
    if out is not None:
        study.write(out)  # a file that cannot be written is told before minutes are spent
    try:
        _measure_all(study, selected, wanted_routes, out, advanced)
    except KeyboardInterrupt:
        finished = sum(not study.missing(scene, wanted_routes) for scene in selected)
        kept = "" if out is None else f"; {out} holds them, and --resume goes on"
        print(f"Stopped: {finished} of {len(selected)} scenes are measured{kept}.", file=sys.stderr)
        return INTERRUPTED
    study.complete = True
    if out is not None:
        study.write(out)
    _show(study)
    return DONE


def list_of_names() -> str:
    """Name every scene and every route, one a line with what it is."""
    titles = {scene.name: scene.title for scene in SCENES}
    routes = [*((route.name, route.title) for route in CATALOGUE),
              *((route.name, route.title) for route in outside.CATALOGUE)]
    width = max(len(name) for name in (*titles, *dict(routes))) + 2
    return "\n".join(["Scenes", *(f"  {name:{width}}{title}" for name, title in titles.items()),
                      "Routes", *(f"  {name:{width}}{title}" for name, title in routes)]) + "\n"


def _measure_all(study: Study, scenes: Sequence[CostScene], routes: Sequence[str], out: Path | None,
                 advanced: Advanced | None) -> None:
    from rich.console import Console
    from rich.progress import Progress

    steps = {scene.label: settings_of(scene, study.missing(scene, routes)) for scene in scenes}
    with Progress(console=Console(stderr=True), transient=True, disable=advanced is not None) as progress:
        task = progress.add_task("", total=sum(len(settings) + study.rounds for settings in steps.values()))
        for scene in scenes:
            settings = steps[scene.label]

            def step(label: str = scene.label) -> None:
                progress.update(task, advance=1, description=label)
                if advanced is not None:
                    advanced(label)

            if not settings:
                continue
            measured = measure_scene(scene, settings, rounds=study.rounds, advanced=step)
            study.add(measured.costs, measured.unit_seconds)
            if out is not None:
                study.write(out)


def _show(study: Study) -> None:
    from rich.console import Console

    console = Console(highlight=False, markup=False, emoji=False)
    console.print(f"Least time that reaches an accuracy, over {UNIT}.\n")
    for block in tables(study.costs):
        console.print(block)
    described = machine()
    console.print(f"Measured in {study.rounds} rounds on {described.pop('processor')}: " + ", ".join(
        f"{name} {value}" for name, value in described.items()), soft_wrap=True)


def _command(scenes: Sequence[str], routes: Sequence[str], rounds: int) -> str:
    words = ["granular cost", *(f"--scene {name}" for name in scenes), *(f"--route {name}" for name in routes)]
    return " ".join([*words, f"--rounds {rounds}"] if rounds != ROUNDS else words)
