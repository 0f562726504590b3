"""The command that goes from measurements back to the fabric."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from granular.commands.options import AsJson
from granular.commands.printing import print_blocks, print_json


def fit(
    data: Annotated[str, typer.Argument(
        metavar="DATA", help="A data file (TOML): a scene without the unknowns, [measured], [fit].")],
    figure: Annotated[Path | None, typer.Option(
        "--plot", metavar="FILE", help="Draw chi-square over D33 and Dr33: SVG, PNG or PDF.")] = None,
    json: AsJson = False,
) -> None:
    """Fabric from wave speeds or stiffness, with what the data say about it and what they do not."""
    from granular.fitting import fit as solve
    from granular.fitting.report import fit_as_json, fit_as_text

    result = solve(data)
    if figure is not None:
        from granular.figures.fit import save_fit

        save_fit(result, figure)
    if json:
        print_json(fit_as_json(result))
    else:
        print_blocks(fit_as_text(result))
