"""The data file of the cost study: whole after every scene, and taken up again where it was left."""

from __future__ import annotations

import json
import statistics
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from granular.cost.machine import machine
from granular.cost.records import Cost
from granular.cost.reference import reference_digits
from granular.cost.scenes import SCENES, CostScene
from granular.cost.timing import UNIT
from granular.errors import BadOption
from granular.hypothesis import Hypothesis
from granular.output import write_text

DIGITS_SHOWN = 4
"""Significant digits of times and errors in the file [-]."""


@dataclass(slots=True)
class Study:
    """What has been measured so far.

    Attributes
    ----------
    command : str
        What measures it again.
    rounds : int
        How often everything is timed [-].
    costs : list of Cost
        In the order of scenes and routes.
    unit_seconds : list of float
        Times of the unit [s].
    complete : bool
        Nothing of what the command asks for is missing.
    """

    command: str
    rounds: int
    costs: list[Cost] = field(default_factory=list)
    unit_seconds: list[float] = field(default_factory=list)
    complete: bool = False

    def add(self, costs: Iterable[Cost], unit_seconds: Iterable[float]) -> None:
        """Take in a scene, in its place among the others."""
        places = {(scene.name, scene.hypothesis): place for place, scene in enumerate(SCENES)}
        self.costs = sorted((*self.costs, *costs), key=lambda cost: places[cost.scene, cost.hypothesis])
        self.unit_seconds += unit_seconds

    def missing(self, scene: CostScene, routes: Sequence[str]) -> list[str]:
        """Those of the routes that a scene has no measurement of."""
        known = {cost.route for cost in self.costs
                 if (cost.scene, cost.hypothesis) == (scene.name, scene.hypothesis)}
        return [route for route in routes if route not in known]

    def content(self) -> dict[str, Any]:
        """The study as JSON takes it."""
        present = {(cost.scene, cost.hypothesis) for cost in self.costs}
        scenes = [{"name": scene.name, "title": scene.title, "hypothesis": str(scene.hypothesis),
                   "inputs": scene.inputs(), "reference_digits": reference_digits(scene)}
                  for scene in SCENES if (scene.name, scene.hypothesis) in present]
        seconds = float(f"{statistics.median(self.unit_seconds):.3g}") if self.unit_seconds else None
        return {"command": self.command, "machine": machine() | {"unit_seconds": seconds}, "rounds": self.rounds,
                "unit": UNIT, "complete": self.complete, "scenes": scenes,
                "costs": [_rounded(cost) for cost in self.costs]}

    def write(self, path: Path) -> None:
        """Replace the file by all that has been measured.

        Raises
        ------
        OutputUnwritable
            It cannot be written; what was there stays.
        """
        lines = []
        for key, value in self.content().items():
            if isinstance(value, list):
                items = ",\n  ".join(json.dumps(item, allow_nan=False) for item in value)
                lines.append(f'"{key}": [\n  {items}]')
            else:
                lines.append(f'"{key}": {json.dumps(value, allow_nan=False)}')
        write_text(path, "{" + ",\n ".join(lines) + "}\n")


def resumed(path: Path, *, command: str, rounds: int) -> Study:
    """Take up a study where it was left.

    Parameters
    ----------
    path : Path
        Its data file; one that does not exist starts a new study.
    command : str
        What measures all of it.
    rounds : int
        How often everything is timed [-].

    Returns
    -------
    Study
        What the file holds.

    Raises
    ------
    BadOption
        The file is no data of a cost study, or was measured on another machine, with other versions or rounds.

    Notes
    -----
    Source: the file itself.
    """
    study = Study(command, rounds)
    if not path.exists():
        return study
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        before, times = dict(content["machine"]), content["rounds"]
        seconds = before.pop("unit_seconds")
        costs = [Cost(**cost | {"hypothesis": Hypothesis(cost["hypothesis"])}) for cost in content["costs"]]
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        raise _refusal(path, "a file that this command wrote", "no data of a cost study") from None
    now = machine()
    other = next((name for name in now if before.get(name) != now[name]), None)
    if other is not None:
        raise _refusal(path, f"measurements with {other} {now[other]}", f"made with {before.get(other)}")
    if times != rounds:
        raise _refusal(path, f"measurements in {rounds} rounds", f"made in {times}")
    study.costs, study.unit_seconds = costs, [] if seconds is None else [seconds]
    return study


def _refusal(path: Path, allowed: str, found: str) -> BadOption:
    return BadOption(f"--resume with {path.name} ({found})", allowed=f"allowed {allowed}",
                     remedy="Name another file, or leave --resume out to measure everything again.")


def _rounded(cost: Cost) -> dict[str, Any]:
    content = asdict(cost)
    for name in ("error", "promised", "time_ratio", "spread"):
        if content[name] is not None:
            content[name] = float(f"{content[name]:.{DIGITS_SHOWN}g}")
    return content
