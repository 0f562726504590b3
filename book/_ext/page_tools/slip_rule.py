"""How fast the one rule for all contacts converges, as numbers to take away."""

from __future__ import annotations

from granular.checks.convergence import NODES, STATES, errors, predicted
from page_tools.markup import Markup, numbers_to_take_away


def convergence_numbers() -> Markup:
    """Offer the numbers behind the figure."""
    columns = {"nodes per unit": NODES, "predicted": [predicted(nodes) for nodes in NODES]}
    columns |= {name: errors(name) for name in STATES}
    return numbers_to_take_away("convergence.csv", columns, digits=3)
