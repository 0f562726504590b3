"""The commands of granular, each a thin call of what does the work; heavy imports wait inside them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import typer

from granular.commands.fits import fit
from granular.commands.lists import contacts
from granular.commands.many import sweep
from granular.commands.options import DONE
from granular.commands.printing import print_text
from granular.commands.scenes import plan, plot, run, schema, sensitivity
from granular.commands.studies import check, cost, speed
from granular.errors import BadOption

app = typer.Typer(
    name="granular", add_completion=False, pretty_exceptions_enable=False,
    help="The elastic stiffness of granular assemblies from the statistics of their contacts.")

COMMANDS = (run, plan, sensitivity, plot, check, contacts, fit, cost, speed, sweep, schema)
"""In the order of the help text."""

for _command in COMMANDS:
    app.command()(_command)


@app.callback(invoke_without_command=True)
def _start(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Show the version and stop.")] = False,
) -> None:
    if version:
        from granular import __version__

        print_text(f"granular {__version__}\n")
        raise typer.Exit
    if context.invoked_subcommand is None:
        print_text(context.get_help() + "\n")


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
