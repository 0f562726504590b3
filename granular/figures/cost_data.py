"""The data of ``granular cost`` as figures and pages read it: scene by scene, each measurement a record."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from granular.cost.records import Cost
from granular.hypothesis import Hypothesis

_NUMBER = re.compile(r"\d[\d.e+-]*")


@dataclass(frozen=True)
class MeasuredScene:
    """One scene under one hypothesis, with everything that was measured on it.

    Attributes
    ----------
    name, title : str
        Name on the command line, and what the scene is in one line.
    hypothesis : Hypothesis
        Kinematic or static.
    inputs : mapping
        Every number that defines the scene.
    digits : int
        Digits of the values that errors are measured against [-].
    costs : sequence of Cost
        All settings of all routes, failed ones among them.
    """

    name: str
    title: str
    hypothesis: Hypothesis
    inputs: Mapping[str, float | None]
    digits: int
    costs: Sequence[Cost]

    @property
    def label(self) -> str:
        """Name and hypothesis."""
        return f"{self.name}, {self.hypothesis}"

    @cached_property
    def results(self) -> tuple[Cost, ...]:
        """Settings that gave components and were timed, whatever they warned of."""
        return tuple(cost for cost in self.costs if cost.error is not None and cost.time_ratio is not None)

    @cached_property
    def sound(self) -> tuple[Cost, ...]:
        """Those of them that warned of nothing: a warned result is no answer, however good it happens to be."""
        return tuple(cost for cost in self.results if cost.failure is None)

    @property
    def paper(self) -> Cost | None:
        """The rule that the printed tables carry; None where it was not measured."""
        return next((cost for cost in self.sound if cost.paper), None)

    def routes(self, kind: str) -> Iterator[tuple[str, list[Cost]]]:
        """Results of each route of a kind, "product" or "outside"."""
        for name in dict.fromkeys(cost.route for cost in self.costs if cost.kind == kind):
            yield name, [cost for cost in self.results if cost.route == name]


@dataclass(frozen=True)
class CostData:
    """One run of ``granular cost``.

    Attributes
    ----------
    command : str
        What measures it again.
    machine : mapping
        Processor, cores, system, versions, and the median time of the unit [s].
    rounds : int
        How often everything was timed at most [-].
    unit : str
        What a time ratio of 1 is.
    complete : bool
        Nothing of what the command asks for is missing.
    scenes : tuple of MeasuredScene
        From the plainest to the most involved.
    """

    command: str
    machine: Mapping[str, Any]
    rounds: int
    unit: str
    complete: bool
    scenes: tuple[MeasuredScene, ...]

    @property
    def unit_seconds(self) -> float:
        """Median time of the unit [s]."""
        return float(self.machine["unit_seconds"])

    def of_name(self, name: str) -> tuple[MeasuredScene, ...]:
        """The scene of that name, under each hypothesis that was measured."""
        return tuple(scene for scene in self.scenes if scene.name == name)


def read_cost_data(path: str | Path) -> CostData:
    """Read the file that ``granular cost`` wrote.

    Parameters
    ----------
    path : str or path-like
        The file.

    Returns
    -------
    CostData
        Its content as records.

    Notes
    -----
    Accuracy: four digits, as written. Source: the file; a file of another format is refused by the records.
    """
    content = json.loads(Path(path).read_text(encoding="utf-8"))
    costs = [Cost(**cost | {"hypothesis": Hypothesis(cost["hypothesis"])}) for cost in content["costs"]]
    scenes = tuple(MeasuredScene(
        name=one["name"], title=one["title"], hypothesis=Hypothesis(one["hypothesis"]), inputs=one["inputs"],
        digits=one["reference_digits"],
        costs=tuple(cost for cost in costs if (cost.scene, str(cost.hypothesis)) == (one["name"], one["hypothesis"])))
        for one in content["scenes"])
    return CostData(content["command"], content["machine"], content["rounds"], content["unit"], content["complete"],
                    scenes)


def series(costs: Sequence[Cost]) -> Iterator[list[Cost]]:
    """Split the settings of a route into those that differ in one number, coarsest first.

    Parameters
    ----------
    costs : sequence of Cost
        Of one route.

    Returns
    -------
    iterator of list of Cost
        E.g. tolerances, then numbers of nodes; a setting without a number stands alone.

    Notes
    -----
    Source: the names of the settings, such as "rtol 1e-06" and "24 panels".
    """
    kinds: dict[str, list[tuple[float, Cost]]] = {}
    for cost in costs:
        found = _NUMBER.search(cost.setting)
        number = float(found.group()) if found else 0.0
        kinds.setdefault(_NUMBER.sub("", cost.setting).strip(), []).append((abs(number), cost))
    for kind, members in kinds.items():
        yield [cost for _, cost in sorted(members, key=lambda pair: pair[0], reverse=kind == "rtol")]
