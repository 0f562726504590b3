"""The paper's tables against what the library computes; every scene is case 3 of Table II with its fabric exchanged."""

from __future__ import annotations

import csv
import re
import tomllib
from dataclasses import fields
from pathlib import Path
from typing import Any

from granular import Evaluation, Hypothesis, Scene, evaluate
from granular.engineering import EngineeringConstants
from granular.routes import midpoint
from page_tools.markup import Markup, table

SCENE = Path("_data/table_ii_case_3.toml")
PANELS = 24
ROUNDING = 1e-12
"""Eigenvalues this much smaller than the largest are zero to rounding."""
_NAMED = re.compile(r"(nu|[CEGK])(\d*)")
RATIOS = (("C1111/C3333", "C11_over_C33"), ("C2323/C1212", "C66_over_C44"))
"""Each ratio by tensor indices and by the paper's name, the column of the data file."""


def scene_of(D33: float, Dr33: float, **model: Any) -> Scene:
    """Take the scene of case 3 with other fabric coefficients, and other keys of its model."""
    content = tomllib.loads(SCENE.read_text(encoding="utf-8"))
    content["packing"]["contact_normals"] = {"D33": D33}
    content["branches"]["anisotropy"] = {"D33": Dr33}
    content["model"] |= model
    return Scene.model_validate(content)


def cases(data: str) -> list[dict[str, str]]:
    """Read the rows of a data file."""
    with Path(data).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def evaluated(case: dict[str, str], **model: Any) -> Evaluation:
    """Evaluate one case of Table II."""
    return evaluate(scene_of(float(case["D33"]), float(case["Dr33"]), **model))


def rational_ratios(data: str) -> Markup:
    """List the exact ratios as fractions."""
    rows = [[case["case"], case["D33"], case["Dr33"].replace("-", "−"),
             *(f"{ratio.exact}" for ratio in evaluated(case).ratios)] for case in cases(data)]
    return table(["case", "$D_{33}$", "$D^{r}_{33}$", *(typeset(name) for name, _ in RATIOS)], rows,
                 label="tab-rational", align="lrrrr", caption="The exact ratios of Table II.",
                 take_away="table_ii_exact.csv")


def engineering_table(data: str) -> Markup:
    """List the engineering constants of each case, moduli in MPa."""
    of_case = {case["case"]: evaluated(case).engineering for case in cases(data)}
    rows = []
    for field in fields(EngineeringConstants):
        values = [getattr(constants, field.name) for constants in of_case.values()]
        ratio = field.name.startswith("nu")
        rows.append([typeset(field.name), "–" if ratio else "MPa",
                     *(f"{value:.4f}" if ratio else f"{value / 1e6:.1f}" for value in values)])
    return table(["constant", "unit", *(f"case {name}" for name in of_case)], rows, label="tab-engineering",
                 align="llrrr", caption="Engineering constants of the assemblies of Table II under 28 kPa.",
                 take_away="engineering_constants.csv")


def fastest_shear_table(data: str) -> Markup:
    """Name the fastest shear wave of each case over all directions and both polarisations."""
    rows = []
    for case in cases(data):
        waves = evaluated(case).waves
        assert waves is not None, "the scene gives the density of the grains"
        fastest = waves.fastest_shear
        rows.append([case["case"], f"{waves.horizontal.SH:.1f}", f"{waves.vertical.SH:.1f}",
                     f"{fastest.speed:.1f}", f"{fastest.polarisation}, {fastest.degrees:.1f}°",
                     "holds" if fastest.is_horizontal_SH else "does not hold"])
    return table(["case", "horizontal SH", "vertical", "fastest", "which", "the claim"], rows,
                 label="tab-fastest", align="lrrrll",
                 caption="Shear wave speeds in m/s, and the fastest over all directions with its angle from axis 3.",
                 take_away="fastest_shear.csv")


def bound_table(data: str) -> Markup:
    """List the eigenvalues of kinematic minus static stiffness for each case."""
    import numpy as np

    rows = []
    for case in cases(data):
        kinematic, static = (evaluated(case, hypothesis=hypothesis) for hypothesis in Hypothesis)
        gap = (kinematic.stiffness.mandel() - static.stiffness.mandel()) / kinematic.reference_stiffness
        eigenvalues = np.linalg.eigvalsh(gap)
        share = static.stiffness.C3333 / kinematic.stiffness.C3333
        shear = static.stiffness.C2323 / kinematic.stiffness.C2323
        least = 0.0 if abs(eigenvalues[0]) < ROUNDING * eigenvalues[-1] else eigenvalues[0]
        rows.append([case["case"], f"{least:.5f}", f"{eigenvalues[-1]:.5f}", f"{share:.4f}", f"{shear:.4f}"])
    return table(["case", "least", "largest", *(rf"$C^\text{{sta}}_{{{pair}}}/C^\text{{kin}}_{{{pair}}}$"
                                                for pair in ("3333", "2323"))],
                 rows, label="tab-bound", align="lrrrr", take_away="kinematic_minus_static.csv",
                 caption="Least and largest eigenvalue of the normalised difference in Mandel notation; no eigenvalue "
                         "is negative. The last columns compare two components.")


def by_midpoint(result: Evaluation, panels: int) -> dict[str, float]:
    """Both ratios of an evaluated scene by a midpoint rule."""
    plan = result.plan
    c1111, c3333, _, _, c2323, c1212 = midpoint.evaluate(
        plan.fabric, poisson_ratio=plan.poisson_ratio, hypothesis=plan.hypothesis, loading=plan.loading,
        panels=panels).components
    return {"C1111/C3333": c1111 / c3333, "C2323/C1212": c2323 / c1212}


def verdict(value: float, printed: str) -> str:
    """Whether a value becomes the printed decimals when it is rounded, when it is cut, or not at all."""
    digits = len(printed.partition(".")[2])
    if f"{value:.{digits}f}" == printed:
        return "rounded"
    return "cut" if f"{int(value * 10**digits) / 10**digits:.{digits}f}" == printed else "no"


def percent(change: float) -> str:
    """Set a relative change as a percentage with its sign."""
    return f"{100 * change:+.2f} %".replace("-", "−")


def typeset(name: str) -> str:
    """Set C1111/C3333, E1, nu12 or K as a formula."""
    return "$" + "/".join(_NAMED.sub(_with_index, part) for part in name.split("/")) + "$"


def _with_index(match: re.Match[str]) -> str:
    symbol, index = match.groups()
    letter = r"\nu" if symbol == "nu" else symbol
    return f"{letter}_{{{index}}}" if index else letter
