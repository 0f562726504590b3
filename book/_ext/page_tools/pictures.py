"""Figures whose caption or description a cell writes, with the numbers behind them."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

from granular.figures.drawn_data import drawn_data
from granular.figures.files import static_bytes
from granular.figures.page import numbers_link
from page_tools.markup import Markup

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def pictured(figure: Figure, *, name: str, alt: str, caption: str) -> Markup:
    """Number a figure so that pages can refer to it, and offer its numbers below it."""
    picture = base64.b64encode(static_bytes(figure, "svg")).decode()
    link = numbers_link(name, drawn_data(figure))
    return Markup(f":::{{figure}} data:image/svg+xml;base64,{picture}\n:name: {name}\n:alt: {alt}\n\n{caption}\n:::\n\n"
                  f"{link}\n")
