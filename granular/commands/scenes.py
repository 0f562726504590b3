"""Commands on one scene: its stiffness, its plan, its slopes, its figures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from granular.commands.options import (
    Accuracy,
    AsJson,
    RouteName,
    SceneFile,
    accuracy_of,
)
from granular.commands.printing import print_blocks, print_json, print_text


def run(
    scene: SceneFile, rtol: Accuracy = None, route: RouteName = "auto",
    explain: Annotated[bool, typer.Option("--explain", help="Show the plan with the result.")] = False,
    json: AsJson = False,
) -> None:
    """Stiffness of a scene, with its error, route, effects and wave speeds."""
    from granular.evaluation import evaluate
    from granular.report import evaluation_as_json, evaluation_as_text, plan_as_json
    from granular.scene import Scene

    result = evaluate(Scene.from_toml(scene), rtol=accuracy_of(rtol), route=route)
    if json:
        print_json(evaluation_as_json(result) | ({"plan": plan_as_json(result.plan)} if explain else {}))
    else:
        print_blocks(evaluation_as_text(result, explain=explain))


def plan(scene: SceneFile, rtol: Accuracy = None, route: RouteName = "auto", json: AsJson = False) -> None:
    """What run would do and why, without doing it."""
    from granular.planning import plan as decide
    from granular.report import plan_as_json, plan_as_text
    from granular.scene import Scene

    decided = decide(Scene.from_toml(scene), rtol=accuracy_of(rtol), route=route)
    if json:
        print_json(plan_as_json(decided))
    else:
        print_blocks(plan_as_text(decided))


def sensitivity(scene: SceneFile, json: AsJson = False) -> None:
    """How much each component changes with each number of a scene."""
    from granular.derivatives import sensitivity as differentiate
    from granular.derivatives.report import sensitivity_as_json, sensitivity_as_text
    from granular.scene import Scene

    result = differentiate(Scene.from_toml(scene))
    if json:
        print_json(sensitivity_as_json(result))
    else:
        print_blocks(sensitivity_as_text(result))


def plot(
    scene: SceneFile,
    what: Annotated[str, typer.Option(
        "--what", metavar="NAME", help="fabric, forces, contacts, stiffness or waves.")],
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="File to write: SVG, PNG, PDF or HTML.")],
) -> None:
    """A figure of a scene."""
    from granular.figures import save
    from granular.scene import Scene

    print_text(f"Wrote {save(Scene.from_toml(scene), what=what, out=out)}\n")


def schema() -> None:
    """JSON schema of a scene file."""
    from granular.scene import Scene
    from granular.scene_schema import schema_text

    print_text(schema_text(Scene))
