"""Commands that check and measure the package itself."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from granular.commands.options import (
    require_one,
    rounds_of,
)
from granular.commands.printing import print_text


def check(
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write all comparisons as JSON.")] = None,
    random: Annotated[int | None, typer.Option(
        "--random", metavar="N", min=1, help="Instead, search N random inputs with contact forces, and as many "
                                             "spheroids, for the worst error against ball arithmetic.")] = None,
    promises: Annotated[int | None, typer.Option(
        "--promises", metavar="N", min=1, help="Instead, evaluate N random scenes at four wanted accuracies, and hold "
                                               "what was promised against their true stiffness.")] = None,
    choices: Annotated[int | None, typer.Option(
        "--choices", metavar="N", min=1, help="Instead, time every route on N random scenes, and say how often the "
                                              "plan's own was the cheapest that is accurate enough.")] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="S", help="Start of the random inputs.")] = 1999,
) -> None:
    """Numerics against symbolic limits, quadrature and certified values; exit code 1 on any miss."""
    require_one({"--random": random, "--promises": promises, "--choices": choices})
    if promises is not None:
        from granular.checks.promises import run_promises

        raise typer.Exit(run_promises(promises, seed=seed, json_out=out))
    if choices is not None:
        from granular.checks.choices import run_choices

        raise typer.Exit(run_choices(choices, seed=seed, json_out=out))
    if random is not None:
        from granular.checks.search import run_search

        raise typer.Exit(run_search(random, seed=seed, json_out=out))
    from granular.checks import run_checks

    raise typer.Exit(run_checks(json_out=out))


def cost(
    scene: Annotated[list[str] | None, typer.Option(
        "--scene", metavar="NAME", help="Measure this scene only; may be repeated.")] = None,
    route: Annotated[list[str] | None, typer.Option(
        "--route", metavar="NAME", help="Measure this route only; may be repeated.")] = None,
    rounds: Annotated[str, typer.Option("--rounds", metavar="N", help="How often everything is timed.")] = "15",
    out: Annotated[Path | None, typer.Option(
        "--out", metavar="FILE", help="Write the measured data as JSON, after every scene.")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Measure only what FILE does not hold yet.")] = False,
    names: Annotated[bool, typer.Option("--list", help="Name the scenes and routes and stop.")] = False,
) -> None:
    """Measure accuracy against time for every route."""
    from granular.cost import list_of_names, run_cost

    if names:
        print_text(list_of_names())
        return
    raise typer.Exit(run_cost(out=out, rounds=rounds_of(rounds), scenes=scene or (), routes=route or (), resume=resume))


def speed(
    only: Annotated[list[str] | None, typer.Option(
        "--only", metavar="NAME", help="Make this comparison only; may be repeated.")] = None,
    rounds: Annotated[str, typer.Option("--rounds", metavar="N", help="How often everything is timed.")] = "9",
    largest: Annotated[int, typer.Option(
        "--largest", metavar="N", min=1, help="Most assemblies in one call.")] = 10**7,
    out: Annotated[Path | None, typer.Option(
        "--out", metavar="FILE", help="Write the measured data as JSON, after every comparison.")] = None,
) -> None:
    """Measure how fast many assemblies are computed, beside the limit of the machine and other packages."""
    from granular.speed.command import run_speed

    raise typer.Exit(run_speed(out=out, rounds=rounds_of(rounds), only=only or (), largest=largest))
