"""Commands on more than one scene: a sweep."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from granular.commands.printing import print_text


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
    print_text(text)
    raise typer.Exit(code)
