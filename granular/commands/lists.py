"""The command on contact lists."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from granular.commands.options import (
    DONE,
    MISSED,
    AsJson,
)
from granular.commands.printing import print_blocks, print_json, print_text
from granular.errors import BadOption


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
            print_text(told)
        else:
            print_blocks(told)
        raise typer.Exit(DONE if agree else MISSED)
    summary = summary_of(file, volume=volume, grains=grains, columns=column or (), step=step, spheres_only=spheres,
                         drop_bad=drop_bad, cell=cell, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio,
                         friction=friction)
    if figure is not None and out is not None:
        from granular.figures.contact_list import save_contact_list

        save_contact_list(summary, out, figure)
    if json:
        from granular.contacts.as_json import summary_as_json

        print_json(summary_as_json(summary))
    else:
        from granular.contacts.as_text import summary_as_text

        print_blocks(summary_as_text(summary))
