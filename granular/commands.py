"""The commands of granular, each a thin call of what does the work; heavy imports wait inside them."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from granular.errors import BadOption, OutputUnwritable
from granular.routes.catalogue import ROUTES, WITHOUT_AXIS
from granular.units import shown

if TYPE_CHECKING:
    from rich.console import RenderableType

DONE = 0
"""Exit code of a command that did what it was asked."""

MISSED = 1
"""Exit code of a check that failed."""

app = typer.Typer(
    name="granular", add_completion=False, pretty_exceptions_enable=False,
    help="The elastic stiffness of granular assemblies from the statistics of their contacts.")


SceneFile = Annotated[str, typer.Argument(metavar="SCENE", help="A scene file (TOML).")]
Accuracy = Annotated[str | None, typer.Option(
    "--rtol", metavar="R", help="Wanted relative accuracy of every component, such as 1e-12.")]
RouteName = Annotated[str, typer.Option(
    "--route", metavar="NAME", help=f"auto, {', '.join(ROUTES)}; {', '.join(WITHOUT_AXIS)} without an axis.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


@app.callback(invoke_without_command=True)
def _start(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Show the version and stop.")] = False,
) -> None:
    if version:
        from granular import __version__

        _print(f"granular {__version__}\n")
        raise typer.Exit
    if context.invoked_subcommand is None:
        _print(context.get_help() + "\n")


@app.command()
def run(
    scene: SceneFile, rtol: Accuracy = None, route: RouteName = "auto",
    explain: Annotated[bool, typer.Option("--explain", help="Show the plan with the result.")] = False,
    json: AsJson = False,
) -> None:
    """Stiffness of a scene, with its error, route, effects and wave speeds."""
    from granular.evaluation import evaluate
    from granular.report import evaluation_as_json, evaluation_as_text, plan_as_json
    from granular.scene import Scene

    result = evaluate(Scene.from_toml(scene), rtol=_accuracy(rtol), route=route)
    if json:
        _print_json(evaluation_as_json(result) | ({"plan": plan_as_json(result.plan)} if explain else {}))
    else:
        _print_blocks(evaluation_as_text(result, explain=explain))


@app.command()
def plan(scene: SceneFile, rtol: Accuracy = None, route: RouteName = "auto", json: AsJson = False) -> None:
    """What run would do and why, without doing it."""
    from granular.planning import plan as decide
    from granular.report import plan_as_json, plan_as_text
    from granular.scene import Scene

    decided = decide(Scene.from_toml(scene), rtol=_accuracy(rtol), route=route)
    if json:
        _print_json(plan_as_json(decided))
    else:
        _print_blocks(plan_as_text(decided))


@app.command()
def sensitivity(scene: SceneFile, json: AsJson = False) -> None:
    """How much each component changes with each number of a scene."""
    from granular.derivatives import sensitivity as differentiate
    from granular.derivatives.report import sensitivity_as_json, sensitivity_as_text
    from granular.scene import Scene

    result = differentiate(Scene.from_toml(scene))
    if json:
        _print_json(sensitivity_as_json(result))
    else:
        _print_blocks(sensitivity_as_text(result))


@app.command()
def plot(
    scene: SceneFile,
    what: Annotated[str, typer.Option(
        "--what", metavar="NAME", help="fabric, forces, contacts, stiffness or waves.")],
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="File to write: SVG, PNG, PDF or HTML.")],
) -> None:
    """A figure of a scene."""
    from granular.figures import save
    from granular.scene import Scene

    _print(f"Wrote {save(Scene.from_toml(scene), what=what, out=out)}\n")


@app.command()
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
    _require_one({"--random": random, "--promises": promises, "--choices": choices})
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


@app.command()
def contacts(
    file: Annotated[str | None, typer.Argument(
        metavar="FILE", help="A contact list: CSV or white-space text (.gz too), Parquet, dump of LAMMPS.")] = None,
    volume: Annotated[float | None, typer.Option(
        "--volume", metavar="V", help="Volume of the sample in m^3, grains and voids together.")] = None,
    grains: Annotated[int | None, typer.Option(
        "--grains", metavar="N", help="All grains in it, with those that touch nothing.")] = None,
    column: Annotated[list[str] | None, typer.Option(
        "--column", metavar="NAME=COLUMN", help="Which column holds what, such as n1=nx; may be repeated. Names: "
        "id1 id2 l1 l2 l3 n1 n2 n3 R1 R2 fn fs1 fs2 fs3 kn ks overlap, grain1 grain2 of clumps, centres x1 y1 z1 x2 y2 "
        "z2 in place of l1 l2 l3, a force f1 f2 f3 in place of fn fs1 fs2 fs3.")] = None,
    step: Annotated[int | None, typer.Option(
        "--step", metavar="T", help="Time step of a dump; the last one by default.")] = None,
    spheres: Annotated[bool, typer.Option(
        "--spheres", help="Take missing normals along the branches; right for spheres only.")] = False,
    drop_bad: Annotated[bool, typer.Option(
        "--drop-bad", help="Leave out contacts with a value that is missing or not finite.")] = False,
    cell: Annotated[tuple[float, float, float] | None, typer.Option(
        "--cell", metavar="LX LY LZ", help="Edges of a rectangular periodic cell in m, 0 along an axis without period: "
        "branches become the shortest that it allows. For lists that have centres inside the cell.")] = None,
    shear_modulus: Annotated[str | None, typer.Option(
        "--shear-modulus", metavar="GS", help='Of the grains [Pa], or like "29 GPa".')] = None,
    poisson_ratio: Annotated[float | None, typer.Option(
        "--poisson-ratio", metavar="NU", help="Of the grains.")] = None,
    friction: Annotated[float | None, typer.Option(
        "--friction", metavar="MU", help="Friction coefficient between grains, to count contacts that slide.")] = None,
    figure: Annotated[str | None, typer.Option(
        "--plot", metavar="NAME", help="Draw the list, too, into --out: roses, forces, stiffness or all.")] = None,
    compare: Annotated[Path | None, typer.Option(
        "--compare", metavar="FOLDER", help="Instead, compare every packing of a folder with its measured stiffness; "
                                            "exit code 1 where eq. (1) is off.")] = None,
    out: Annotated[Path | None, typer.Option(
        "--out", metavar="FILE", help="With --plot: the figure, SVG, PNG, PDF or HTML. With --compare: the comparison "
                                      "as JSON.")] = None,
    json: AsJson = False,
) -> None:
    """Fabric, forces and stiffness of a contact list, and what the model makes of it."""
    from granular.contacts.command import compare_to, summary_of

    if compare is None and (out is None) != (figure is None):
        given = f"--out {out} without --plot or --compare" if figure is None else f"--plot {figure} without --out"
        raise BadOption(given, allowed="allowed together", remedy="Write it like --plot all --out contacts.svg, or "
                        "send the result of a list to a file with --json > FILE.")
    if figure is not None and out is not None and compare is None:
        from granular.figures.contact_list import checked_target

        checked_target(figure, out)
    if compare is not None:
        if file is not None or figure is not None:
            raise BadOption("a contact list or a figure is named with --compare", allowed="allowed one or the other",
                            remedy="Run one after the other.")
        told, agree = compare_to(compare, out, as_json=json)
        if isinstance(told, str):
            _print(told)
        else:
            _print_blocks(told)
        raise typer.Exit(DONE if agree else MISSED)
    summary = summary_of(file, volume=volume, grains=grains, columns=column or (), step=step, spheres_only=spheres,
                         drop_bad=drop_bad, cell=cell, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio,
                         friction=friction)
    if figure is not None and out is not None:
        from granular.figures.contact_list import save_contact_list

        save_contact_list(summary, out, figure)
    if json:
        from granular.contacts.as_json import summary_as_json

        _print_json(summary_as_json(summary))
    else:
        from granular.contacts.as_text import summary_as_text

        _print_blocks(summary_as_text(summary))


@app.command()
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
        _print(list_of_names())
        return
    raise typer.Exit(run_cost(out=out, rounds=_rounds(rounds), scenes=scene or (), routes=route or (), resume=resume))


@app.command()
def sweep(
    file: Annotated[str, typer.Argument(metavar="SWEEP", help="A sweep file (TOML).")],
    out: Annotated[Path, typer.Option(
        "--out", metavar="DIR", help="Folder of the Zarr store; one that holds a part of the same sweep is gone on "
                                     "with.")],
    invalid: Annotated[str, typer.Option(
        "--invalid", metavar="WHAT", help="What becomes of a point that is refused: error, or nan with its code.")]
    = "error",
    workers: Annotated[str | None, typer.Option(
        "--workers", metavar="N", help="Processes on this machine; as many as it has cores by default.")] = None,
    scheduler: Annotated[str | None, typer.Option(
        "--scheduler", metavar="ADDRESS", help="Compute on a dask scheduler instead, such as tcp://10.0.0.1:8786.")]
    = None,
    large: Annotated[bool, typer.Option("--large", help="More than a million points are meant.")] = False,
) -> None:
    """A scene over grids and lists of its fields, as a dataset that xarray opens."""
    from granular.sweeps.command import run_sweep_command

    text, code = run_sweep_command(file, out=out, invalid=invalid, workers=workers, scheduler=scheduler, large=large)
    _print(text)
    raise typer.Exit(code)


@app.command()
def schema() -> None:
    """JSON schema of a scene file."""
    from granular.scene import Scene
    from granular.scene_schema import schema_text

    _print(schema_text(Scene))


def run_command(arguments: Sequence[str] | None = None) -> int:
    """Run a command; what is wrong with its input is raised.

    Parameters
    ----------
    arguments : sequence of str, optional
        Arguments; those of the process by default.

    Returns
    -------
    int
        Exit code, 0 or 1, or 130 after Ctrl-C.

    Raises
    ------
    GranularError
        The command line, the scene, or the file it names is wrong.

    Notes
    -----
    Source: the command line's interface.
    """
    try:
        code = app(args=None if arguments is None else list(arguments), prog_name="granular", standalone_mode=False)
    except typer.TyperException as error:
        reason, _, hint = " ".join(error.format_message().split()).partition(". ")
        hint = f"{hint.rstrip('.?')}{'?' if hint.endswith('?') else '.'} " if hint else ""
        raise BadOption(reason.rstrip("."), allowed="allowed are the commands and options that --help lists",
                        remedy=f"{hint}See granular --help.") from None
    return code if isinstance(code, int) else DONE


def _accuracy(text: str | None) -> float | None:
    """The number behind --rtol; whether it can be promised is for the plan to say."""
    if text is None:
        return None
    try:
        return float(text)
    except ValueError:
        raise BadOption(f"--rtol = {shown(text)}", allowed="allowed a number inside (0, 1)",
                        remedy="Write it like --rtol 1e-12.") from None


def _require_one(options: dict[str, int | None]) -> None:
    """Refuse two checks at once."""
    given = [name for name, value in options.items() if value is not None]
    if len(given) > 1:
        raise BadOption(f"{given[0]} and {given[1]} are both given", allowed="allowed one of the two",
                        remedy="Run one after the other.")


def _rounds(text: str) -> int:
    """The number behind --rounds; one round has no spread."""
    if not (text.isascii() and text.isdigit() and 2 <= int(text[:6]) and len(text) <= 6):
        raise BadOption(f"--rounds = {shown(text)}", allowed="allowed whole numbers from 2 to 999999",
                        remedy="Write it like --rounds 15.")
    return int(text)


def _print_json(content: dict[str, Any]) -> None:
    import json

    lines = (f"{json.dumps(key)}: {json.dumps(value, allow_nan=False)}" for key, value in content.items())
    _print("{" + ",\n ".join(lines) + "}\n")


def _print_blocks(blocks: Iterable[RenderableType]) -> None:
    import io

    from rich.console import Console

    buffer = io.StringIO()
    console = Console(file=buffer, force_terminal=_is_terminal(), highlight=False, markup=False,
                      emoji=False)
    for block in blocks:
        console.print(block)
    _print("".join(f"{line.rstrip()}\n" for line in buffer.getvalue().splitlines()))


def _is_terminal() -> bool | None:
    """True on a terminal; None leaves the choice to the environment."""
    return True if sys.stdout is not None and sys.stdout.isatty() else None


def _print(text: str) -> None:
    """Write to standard output at once. A reader that went away is no error; a full disk is."""
    if sys.stdout is None:
        raise OutputUnwritable("standard output (closed)", allowed="it must take the result",
                               remedy="Leave it open, or send it to a file.")
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise typer.Exit(DONE) from None
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise OutputUnwritable(f"standard output ({(error.strerror or str(error)).lower()})",
                               allowed="it must take the result", remedy="Free some space or name another file."
                               ) from None
