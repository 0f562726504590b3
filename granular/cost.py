"""Accuracy against work for every way of computing: what ``granular cost`` measures and the book shows."""

from __future__ import annotations

import json
import math
import os
import platform
import random
import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from fractions import Fraction
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING

from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.output import write_text
from granular.routes import axial, certified, closed_form, exact, midpoint, sphere
from granular.routes.result import RouteResult

if TYPE_CHECKING:
    from rich.table import Table

POISSON_RATIO = 0.21
"""Poisson's ratio of the grain material in every case [-]."""

CASES = {
    "Table II, case 3": AxialFabric(D33=0.3, Dr33=-0.3),
    "branches 8 to 1": AxialFabric(D33=1.0, Dr33=1.4),
}
"""A mild fabric, and one near the end of what the static closed form serves, where rules need many more nodes."""

NODES = (4, 8, 12, 16, 20, 28, 40, 80)
DEGREES = (5, 11, 17, 23, 29, 47, 83, 131)
PANELS = (12, 24, 48, 96, 384)
DIGITS = (15, 30, 100)

REFERENCE_DIGITS = 150
"""Digits of the values that errors are taken against [-]."""

SHORTEST = 1e-3
"""A timing repeats its call until it takes about this long [s], far above the resolution of the clock."""

PACKAGES = ("numpy", "scipy", "python-flint")


@dataclass(frozen=True, slots=True, kw_only=True)
class Cost:
    """What one setting of one route gives and takes.

    Attributes
    ----------
    case : str
        Which fabric.
    hypothesis : Hypothesis
        Kinematic or static.
    route : str
        Which way of computing.
    setting : str
        Its arithmetic, nodes, degree, panels or digits.
    error : float
        Relative error of the worst component [-].
    evaluations : int
        Directions in which the integrand was evaluated [-]; 0 for a closed form.
    time_ratio : float
        Time of one call over that of the emitted closed form in floats in the same round, median of the rounds [-].
    spread : float
        Half the distance of the quartiles of that ratio, over the ratio [-].
    """

    case: str
    hypothesis: Hypothesis
    route: str
    setting: str
    error: float
    evaluations: int
    time_ratio: float
    spread: float


Components = Sequence[Fraction] | Sequence[float]


@dataclass(frozen=True, slots=True)
class _Setting:
    route: str
    setting: str
    evaluations: int
    call: Callable[[], Components]


def measure(*, rounds: int = 15, advanced: Callable[[], None] | None = None) -> list[Cost]:
    """Measure errors and times of every route over its settings.

    Parameters
    ----------
    rounds : int
        How often everything is timed, all settings once in each round and in random order [-], >= 2.
    advanced : callable or None
        Told after each round of each case, to show progress.

    Returns
    -------
    list of Cost
        For each case and hypothesis, first the closed form in floats, then the others.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed: there would be nothing to take errors against.

    Notes
    -----
    Accuracy: errors are certified to all the digits shown. Times are ratios within one process and one round, so
    that the load of the machine acts on both; ``spread`` says how well they repeat. Source: this machine.
    """
    costs: list[Cost] = []
    for case, fabric in CASES.items():
        for hypothesis in Hypothesis:
            known = [enclosure.midpoint for enclosure in certified.enclose(
                fabric, poisson_ratio=POISSON_RATIO, hypothesis=hypothesis, digits=REFERENCE_DIGITS)]
            settings = list(_settings(fabric, hypothesis))
            ratios = _time_ratios(settings, rounds, advanced)
            for setting, observed in zip(settings, ratios, strict=True):
                lower, middle, upper = statistics.quantiles(observed, n=4)
                costs.append(Cost(
                    case=case, hypothesis=hypothesis, route=setting.route, setting=setting.setting,
                    error=_error(setting.call(), known), evaluations=setting.evaluations, time_ratio=middle,
                    spread=(upper - lower) / (2 * middle)))
    return costs


def run_cost(*, out: Path | None = None, rounds: int = 15) -> int:
    """Measure, print a table, and write the data.

    Parameters
    ----------
    out : Path or None
        JSON file for the data with machine and versions; it is replaced only once it is complete. None writes none.
    rounds : int
        How often everything is timed [-], >= 2.

    Returns
    -------
    int
        Exit code: 0. Times are shown, never judged.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    OutputUnwritable
        ``out`` cannot be written.

    Notes
    -----
    Accuracy and source: :func:`measure`.
    """
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("Measuring", total=len(CASES) * len(Hypothesis) * rounds)
        costs = measure(rounds=rounds, advanced=lambda: progress.advance(task))
    if out is not None:
        content = {"machine": machine(), "poisson_ratio": POISSON_RATIO, "rounds": rounds,
                   "costs": [asdict(cost) for cost in costs]}
        write_text(out, json.dumps(content, indent=1) + "\n")
    console = Console(highlight=False, markup=False, emoji=False)
    console.print(_rendered(costs))
    described = machine()
    console.print(f"Measured in {rounds} rounds on {described.pop('processor')}: " + ", ".join(
        f"{name} {value}" for name, value in described.items()), soft_wrap=True)
    return 0


def machine() -> dict[str, str]:
    """Describe where times were measured, without naming the machine.

    Returns
    -------
    dict
        Processor, cores, system, and versions of Python and of the packages that do the arithmetic.
    """
    described = {"processor": _processor(), "cores": str(os.cpu_count()), "system": platform.system(),
                 "python": platform.python_version()}
    for package in PACKAGES:
        try:
            described[package] = version(package)
        except PackageNotFoundError:
            described[package] = "not installed"
    return described


def _processor() -> str:
    """Name the processor; Linux tells it in a file, other systems through the platform module."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def _settings(fabric: AxialFabric, hypothesis: Hypothesis) -> Iterator[_Setting]:
    """Every route in every setting; what the others are timed against comes first."""
    yield _Setting(closed_form.NAME, "floats", 0, partial(_emitted, fabric, hypothesis))
    for route, setting in ((closed_form, "fractions"), (exact, "fractions")):
        if route is closed_form or hypothesis is Hypothesis.KINEMATIC:
            yield _Setting(route.NAME, setting, 0, _components_of(route.evaluate, fabric, hypothesis))
    for nodes in NODES:
        rule = axial.suitable_rule(fabric, hypothesis, nodes=nodes)
        yield _Setting(axial.NAME, f"{nodes} nodes", nodes, partial(
            axial.components_by_rule, fabric, poisson_ratio=POISSON_RATIO, hypothesis=hypothesis, rule=rule))
    for degree in DEGREES:
        yield _Setting(sphere.NAME, f"degree {degree}", sphere.directions_of(degree), partial(
            sphere.components_by_degree, fabric, poisson_ratio=POISSON_RATIO, hypothesis=hypothesis, degree=degree))
    for panels in PANELS:
        yield _Setting(midpoint.NAME, f"{panels} panels", panels,
                       _components_of(partial(midpoint.evaluate, panels=panels), fabric, hypothesis))
    for digits in DIGITS:
        yield _Setting(certified.NAME, f"{digits} digits", 0, partial(_midpoints, fabric, hypothesis, digits))


def _emitted(fabric: AxialFabric, hypothesis: Hypothesis) -> Components:
    """The emitted module as it stands, in floats."""
    from granular.generated.kinematic_constant import kinematic_constant
    from granular.generated.static_constant import static_constant

    emitted = kinematic_constant if hypothesis is Hypothesis.KINEMATIC else static_constant
    return emitted(fabric.D33, fabric.D3333, fabric.Dr33, POISSON_RATIO)


def _components_of(evaluate: Callable[..., RouteResult], fabric: AxialFabric,
                   hypothesis: Hypothesis) -> Callable[[], Components]:
    return lambda: evaluate(fabric, poisson_ratio=POISSON_RATIO, hypothesis=hypothesis).components


def _midpoints(fabric: AxialFabric, hypothesis: Hypothesis, digits: int) -> Components:
    return tuple(enclosure.midpoint for enclosure in certified.enclose(
        fabric, poisson_ratio=POISSON_RATIO, hypothesis=hypothesis, digits=digits))


def _time_ratios(settings: list[_Setting], rounds: int, advanced: Callable[[], None] | None) -> list[list[float]]:
    """Time every setting in every round, over the closed form's time in that round."""
    repeats = [max(1, math.ceil(SHORTEST / _time(setting.call, 3))) for setting in settings]
    ratios: list[list[float]] = [[] for _ in settings]
    order, rng = list(range(len(settings))), random.Random(1999)
    for _ in range(rounds):
        rng.shuffle(order)
        seconds = {index: _time(settings[index].call, repeats[index]) for index in order}
        for index, observed in enumerate(ratios):
            observed.append(seconds[index] / seconds[0])
        if advanced is not None:
            advanced()
    return ratios


def _time(call: Callable[[], object], repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def _error(components: Components, known: list[Fraction]) -> float:
    """Worst relative error; floats and fractions are both exact numbers here."""
    return max(float(abs(Fraction(components[i]) - exactly) / exactly) for i, exactly in enumerate(known))


def _rendered(costs: list[Cost]) -> Table:
    from rich.table import Table

    table = Table(title="Relative error of the worst component; time over the closed form in floats",
                  title_justify="left", box=None, pad_edge=False, padding=(0, 1), collapse_padding=True,
                  header_style="bold")
    for heading in ("case", "hypothesis", "route", "setting"):
        table.add_column(heading, no_wrap=True)
    for heading in ("directions", "error", "time"):
        table.add_column(heading, justify="right", no_wrap=True)
    shown = ("", "")
    for cost in costs:
        place = (cost.case, str(cost.hypothesis))
        table.add_row(*(place if place != shown else ("", "")), cost.route, cost.setting, str(cost.evaluations),
                      f"{cost.error:.1e}", f"{cost.time_ratio:.3g}")
        shown = place
    return table
