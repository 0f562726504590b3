"""Figures 3 to 9 of the paper: the numbers behind them, their other views, and how statements on them are judged."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal

import numpy as np

import granular
from granular.directions import branch_weight, relative_density
from granular.fabric import AxialFabric
from granular.figures.contacts_interactive import contacts_interactive, forces_interactive
from granular.figures.page import Interactive, Static
from granular.figures.paper_figure_5 import BRANCHES, NORMALS
from granular.figures.paper_figure_6 import FLATTEST, SCENE
from granular.figures.paper_figure_7_9 import CASES, POISSON_RATIO, data
from granular.figures.paper_figures_3_4 import table_i
from granular.figures.paper_roses import roses as draw_roses
from granular.gradation import branch_lengths
from granular.routes.result import COMPONENTS
from page_tools.markup import Markup, numbers_to_take_away, table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Contacts = Literal[7, 8, 9]

HOLDS, NOT_QUITE, FAILS = "holds", "not quite", "does not hold"


def said(number: int, rows: Iterable[tuple[str, str, str]]) -> Markup:
    """Put what the paper says of a figure beside what was computed and the verdict."""
    return table(["the paper says", "computed", "verdict"], list(rows), label=f"tab-said-{number}", align="lll",
                 look="words-first errata", take_away=f"figure_{number}_statements.csv",
                 caption=f"What the text of the paper says of Figure {number}.")


def ruled(holds: bool, otherwise: str = FAILS) -> str:
    """The verdict on a statement."""
    return HOLDS if holds else otherwise


def figure_numbers(number: int) -> Markup:
    """Offer the columns behind a figure."""
    if number in CASES:
        return numbers_to_take_away(f"figure_{number}.csv", data(number))
    return numbers_to_take_away(f"figure_{number}.csv", COLUMNS[number]())


def roses(number: Contacts) -> Static:
    """Draw Figure 7, 8 or 9 around a circle, as the paper does."""
    return Static(draw_roses(number))


def turned(number: Contacts) -> Interactive:
    """Make the last assembly of Figure 8 (forces) or 9 (stiffnesses) to turn."""
    make = forces_interactive if number == 8 else contacts_interactive
    case = CASES[number][-1]
    return Interactive(make(case.fabric, case.loading, poisson_ratio=POISSON_RATIO), f"figure-{number}")


def gradation_curves() -> dict[str, Array]:
    """Diameters in millimetres and per cent finer of the six assemblies."""
    diameter = np.geomspace(0.5, 200.0, 101)
    return {"diameter_mm": diameter, **{f"curve_{row.curve}_percent": 100 * row.sizes.fraction_finer(1e-3 * diameter)
                                        for row in table_i()}}


def densities() -> dict[str, Array]:
    """Radius or length in millimetres, and the three densities over its logarithm."""
    size = np.geomspace(0.1, 500.0, 121)
    columns = {"size_mm": size}
    for row in table_i():
        lengths = branch_lengths(row.sizes)
        columns |= {f"r_fp_{row.curve}": 1e-3 * size * 2.0 * row.sizes.density_by_number(2e-3 * size),
                    f"l_gtotal_{row.curve}": 1e-3 * size * lengths.total_density(1e-3 * size),
                    f"l_g_{row.curve}": 1e-3 * size * lengths.density(1e-3 * size)}
    return columns


def weights() -> dict[str, Array]:
    """Weights of the branch lengths and density of the contact normals against the angle from axis 3."""
    degrees = np.linspace(0.0, 90.0, 91)
    cosine = np.cos(np.radians(degrees))
    return {"beta": degrees, **{f"W Dr33={value:g}": branch_weight(AxialFabric(Dr33=value), cosine)
                                for value in BRANCHES},
            f"4 pi E D33={NORMALS:g}": relative_density(AxialFabric(D33=NORMALS), cosine)}


def components() -> dict[str, Array]:
    """Six components in megapascals against the anisotropy of the branches."""
    reference = granular.evaluate(granular.Scene.model_validate(SCENE)).reference_stiffness
    anisotropy = np.linspace(0.0, FLATTEST, 91)
    values = granular.axial_stiffness(0.0, anisotropy, kinetic=False) * reference / 1e6
    return {"Dr33": anisotropy, **{f"{name}_MPa": values[:, place] for place, name in enumerate(COMPONENTS)}}


COLUMNS = {3: gradation_curves, 4: densities, 5: weights, 6: components}
