"""Polynomials that many elements of a panel share, as loops to be compiled: three at a time, odd and even powers apart.

A processor starts several operations in each cycle but waits for the result of each. Six chains that do not wait for
one another keep it busy; one Horner chain alone would not.
"""

from __future__ import annotations

TOGETHER = 3
"""Polynomials in one loop."""

SIZES = (4, 7, 10, 12, 14)
"""Numbers of coefficients for which a loop is emitted."""

HEADER = '''\
"""Rows of polynomials in two variables for the elements of a panel: loops over elements, to be compiled.

Emitted by ``derivations write``; do not edit. Even and odd powers are summed apart, each by Horner's rule in the square
of the variable.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
'''

DOCSTRING = '''\
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the {size} that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: {operations}.
    """
'''


def panel_module() -> str:
    """Return the text of ``granular/generated/panel_rows.py``."""
    return "\n".join([HEADER, *("\n" + _function(size) for size in SIZES)])


def _function(size: int) -> str:
    operations = 1 + TOGETHER * (2 * (size - 1) + 2)
    lines = [f"def add_row_{size}(rows: Array, at: int, variable: Array, other: Array, "
             "v0: Array, v1: Array, v2: Array) -> None:",
             DOCSTRING.format(size=size, operations=operations).rstrip("\n")]
    lines += [f"    {_name(k, i)} = rows[{k}, at + {i}]" for k in range(TOGETHER) for i in range(size)]
    lines += ["    for r in range(variable.size):", "        x = variable[r]", "        z = x*x"]
    lines += [f"        v{k}[r] = v{k}[r]*other[r] + ({_sum(k, size)})" for k in range(TOGETHER)]
    return "\n".join(lines) + "\n"


def _sum(k: int, size: int) -> str:
    """Even part plus x times the odd part."""
    names = [_name(k, i) for i in range(size)]
    return f"{_horner(names[(size - 1) % 2::2])} + x*{_horner(names[size % 2::2])}"


def _horner(names: list[str]) -> str:
    text = names[0]
    for name in names[1:]:
        text = f"({text}*z + {name})"
    return text


def _name(k: int, i: int) -> str:
    return f"{'abc'[k]}{i}"
