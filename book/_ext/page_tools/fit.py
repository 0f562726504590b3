"""Fabric from wave speeds on a page: one fit told and drawn, experiments compared beforehand, slopes of a scene."""

from __future__ import annotations

from functools import lru_cache
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from granular import Scene, evaluate, fit, sensitivity
from granular.derivatives.report import sensitivity_as_text
from granular.figures.fit import fit_map
from granular.figures.page import Static
from granular.fitting import Data, Fit
from granular.fitting.problem import Problem
from granular.fitting.quantities import quantity
from granular.fitting.report import fit_as_text
from granular.fitting.result import combinations_at
from page_tools.markup import Markup, table

WIDTH = 74
"""Columns of a report, as many as a page shows side by side."""

TRUE = {"D33": 0.3, "Dr33": -0.1}
"""Fabric of the experiments that are compared beforehand."""

SHARE = 0.01
"""Uncertainty of every speed in them, over the speed [-]."""

SPEEDS = ("Vp_vertical", "Vp_horizontal", "Vs_vh", "Vs_hh")

EXPERIMENTS: dict[str, dict[str, Any]] = {
    "isotropic stress, no friction": {"ratios": (1.0,)},
    "stress ratios 0.5, 1 and 2.5, no friction": {"ratios": (0.5, 1.0, 2.5)},
    "isotropic stress, angle of friction 22°": {"ratios": (1.0,), "friction": "22 deg"},
    "stress ratios 0.5, 1 and 2.5, angle of friction 22°": {"ratios": (0.5, 1.0, 2.5), "friction": "22 deg"},
    "the same, with the factors the same in all states": {"ratios": (0.5, 1.0, 2.5), "friction": "22 deg",
                                                          "scale": "common modes"},
    "isotropic stress, static hypothesis, one factor": {"ratios": (1.0,), "hypothesis": "static", "scale": "states"},
}
"""What is measured, and what is believed of the sample."""


@lru_cache(maxsize=2)
def fitted(file: str) -> Fit:
    """Fit a data file once for a page."""
    return fit(file)


def data_file(file: str) -> Markup:
    """Show a data file."""
    return Markup(f"```toml\n{Path(file).read_text(encoding='utf-8')}```\n")


def told(file: str) -> Markup:
    """Say what ``granular fit`` says of a data file."""
    return _report(f"granular fit {Path(file).name}", fit_as_text(fitted(file)))


def slopes_told(file: str) -> Markup:
    """Say what ``granular sensitivity`` says of a scene."""
    return _report(f"granular sensitivity {Path(file).name}", sensitivity_as_text(sensitivity(Scene.from_toml(file))))


def _report(command: str, blocks: list[Any]) -> Markup:
    text = StringIO()
    console = Console(file=text, width=WIDTH, color_system=None, force_terminal=False, force_jupyter=False)
    for block in blocks:
        console.print(block)
    lines = "\n".join(line.rstrip() for line in text.getvalue().splitlines())
    return Markup(f"```console\n$ {command}\n{lines}\n```\n")


def drawn(file: str) -> Static:
    """Draw the map of a fitted data file."""
    return Static(fit_map(fitted(file)))


def experiments() -> Markup:
    """Compare what six experiments would tell of one fabric, by the slopes at that fabric alone."""
    rows = []
    for name, options in EXPERIMENTS.items():
        best, worst = combinations_at(*_planned(**options))
        rows.append([name, f"$D_{{33}} {best.coefficients[1]:+.2f}\\,D^r_{{33}}$", f"{best.standard_error:.3f}",
                     f"{_alone(best, worst, 0):.2f}", f"{_alone(best, worst, 1):.2f}"])
    return table(
        ["experiment", "seen best", "to", "$D_{33}$ to", "$D^r_{33}$ to"], rows, label="tab-experiments",
        align="llrrr", take_away="experiments.csv",
        caption=f"Standard errors of four wave speeds known to {100 * SHARE:.0f} % each, two of compression and two of "
        f"shear, for $D_{{33}} = {TRUE['D33']}$ and $D^r_{{33}} = {TRUE['Dr33']}$; factors of compression and of shear "
        "are unknown in each state unless it says otherwise.")


def _alone(best: Any, worst: Any, place: int) -> float:
    """Standard error of one unknown from the two singular directions, which are independent."""
    total = 0.0
    for one in (best, worst):
        length = float(np.hypot(*one.coefficients))
        total += (one.coefficients[place] / length * one.standard_error / length) ** 2
    return float(np.sqrt(total))


def _planned(ratios: tuple[float, ...], *, friction: str | None = None, hypothesis: str = "kinematic",
             scale: str = "modes") -> tuple[Problem, Any]:
    """An experiment on the true fabric, with its own stiffness as data, and where its unknowns end."""
    grains = {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "density": "2650 kg/m^3"}
    if friction is not None:
        grains["friction_angle"] = friction
    states = []
    for ratio in ratios:
        stress = {"mean": "100 kPa", "ratio": ratio}
        found = evaluate(Scene(
            grains=grains, packing={"void_ratio": 0.62, "contact_normals": {"D33": TRUE["D33"]}}, stress=stress,
            branches={"anisotropy": {"D33": TRUE["Dr33"]}}, model={"hypothesis": hypothesis}))
        state: dict[str, Any] = {"stress": stress}
        for name in SPEEDS:
            kind = quantity(name)
            speed = np.prod([c**p for c, p in zip(found.stiffness.components.values(), kind.powers, strict=True)])
            value = float(speed * (found.density or 1.0) ** kind.density_power)
            state[name] = {"value": value, "uncertainty": SHARE * value}
        states.append(state)
    problem = Problem.of(Data.of_tables({"grains": grains, "packing": {"void_ratio": 0.62}, "measured": states,
                                         "model": {"hypothesis": hypothesis}, "fit": {"scale": scale}}))
    unknowns = np.array([TRUE[name] for name in problem.unknowns])
    return problem, np.concatenate([unknowns, np.zeros(len(problem.factors))])
