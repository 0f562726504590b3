"""Command line of the derivations: list them, show one, write what they emit, check what is on disk."""

from __future__ import annotations

import sys
from enum import StrEnum
from typing import Annotated

import typer

app = typer.Typer(
    help="Closed forms of the stiffness of granular assemblies: what there is, how it follows, what is emitted.",
    no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)


class Format(StrEnum):
    """How a derivation is shown."""

    TEXT = "text"
    LATEX = "latex"
    PYTHON = "python"


@app.command("list")
def list_() -> None:
    """List the derivations with their source equations and operation counts."""
    from rich.console import Console
    from rich.progress import track
    from rich.table import Table

    from derivations.catalogue import CATALOGUE
    from derivations.emit.module import operations_before

    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading, justify in (("name", "left"), ("title", "left"), ("equations", "left"), ("as derived", "right"),
                             ("emitted", "right")):
        table.add_column(heading, justify="right" if justify == "right" else "left", overflow="fold")
    for build in track(CATALOGUE, "Deriving", console=Console(stderr=True), transient=True):
        derivation = build()
        emitted = sum(function.operations() for function in derivation.functions)
        table.add_row(derivation.name, derivation.title, ", ".join(derivation.sources) or "-",
                      str(operations_before(derivation)), str(emitted) if emitted else "-")
    Console().print(table)
    typer.echo("\nOperations: of the outputs as derived, and of the emitted functions. Show one: derivations show NAME")


@app.command()
def show(name: Annotated[str, typer.Argument(help="Name of a derivation, as listed.")],
         form: Annotated[Format, typer.Option("--format", help="What to print.")] = Format.TEXT) -> None:
    """Show a derivation with its steps, each checked while you wait."""
    from derivations import present
    from derivations.catalogue import derivation, names

    if name not in names():
        typer.echo(f"There is no derivation {name!r}. There are: {', '.join(names())}.", err=True)
        raise typer.Exit(2)
    record = derivation(name)
    printed = {Format.TEXT: present.text, Format.LATEX: present.latex_lines, Format.PYTHON: present.python_source}
    typer.echo(printed[form](record))


@app.command()
def write() -> None:
    """Regenerate every emitted file; what nothing emits any more is removed."""
    from derivations.emit.files import all_cores, emitted_files
    from derivations.emit.files import write as write_files

    wanted = emitted_files(all_cores())
    changed = write_files(wanted=wanted)
    for path in changed:
        typer.echo(f"  {path}")
    typer.echo(f"{len(changed)} of {len(wanted)} emitted files changed.")


@app.command()
def check() -> None:
    """Hold the emitted files against the derivations; exit code 1 and a diff when they differ."""
    from derivations.emit.files import all_cores, differences, emitted_files

    reports = differences(wanted=emitted_files(all_cores()))
    for report in reports:
        typer.echo(report)
    if reports:
        typer.echo(f"{len(reports)} emitted files differ from the derivations. "
                   "To accept what the derivations say: derivations write", err=True)
        raise typer.Exit(1)
    typer.echo("Emitted files agree with the derivations.")


def main() -> None:
    """Run the command line."""
    try:
        app()
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(1)


if __name__ == "__main__":
    main()
