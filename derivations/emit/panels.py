"""Polynomials that many elements of a panel share, as loops to be compiled: three at a time, odd and even powers apart.

A processor starts several operations in each cycle but waits for the result of each. Six chains that do not wait for
one another keep it busy; one Horner chain alone would not. There are more coefficients than registers: they stand on
the stack as whole vectors, which take twice as long to read where they lie across two lines of the cache.
"""

from __future__ import annotations

TOGETHER = 3
"""Polynomials in one loop."""

BEGINNINGS = ((11,), (4, 4))
"""Rows with which a sum begins, by their numbers of coefficients: the one row of a single friction, and two of many."""

FOLLOWING = ((7, 7), (10, 10), (11, 11), (12, 13), (13,))
"""Rows that are added to a sum in one loop."""

HEADER = '''\
"""Rows of polynomials in two variables for the elements of a panel: loops over elements, to be compiled.

Emitted by ``derivations write``; do not edit. Even and odd powers are summed apart, each by Horner's rule in the square
of the variable.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import aligned_frame

Array: TypeAlias = npt.NDArray[np.float64]
'''

DOCSTRING = '''\
    """{summary}

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of {sizes} in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
{other}    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are {done}.
    spacing : int
        Numbers from one column to the next.

    Operations: {operations}.
    """
'''

OTHER = """\
    other : (n,) array [-]
        Factor of the values.
"""

AFFINE = """\
    middle, narrowness : float [-]
        What is taken from the variable first, and what it is multiplied by then.
"""


def panel_module() -> str:
    """Return the text of ``granular/generated/panel_rows.py``."""
    return "\n".join([HEADER, *("\n" + _function(sizes, first=True) for sizes in BEGINNINGS),
                      *("\n" + _function(sizes, first=False) for sizes in FOLLOWING)])


def name_of(sizes: tuple[int, ...], *, first: bool) -> str:
    """Name of the function for some rows."""
    return f"{'set' if first else 'add'}_row{'s' if len(sizes) > 1 else ''}_{'_'.join(map(str, sizes))}"


def _function(sizes: tuple[int, ...], *, first: bool) -> str:
    added = len(sizes) - first
    operations = 1 + 2 * (not added) + TOGETHER * (sum(2 * (size - 1) for size in sizes) + 2 * added)
    other = "other: Array, " if added else "middle: float, narrowness: float, "
    each = "a polynomial" if len(sizes) == 1 else "polynomials in turn"
    summary = ("Set three values of each element to polynomials." if first and not added else
               "Set three values of each element to polynomials, then multiply them by one variable and add another."
               if first else f"Multiply three values of each element by one variable, and add {each} in the other.")
    said = DOCSTRING.format(operations=operations, summary=summary, sizes=" and ".join(map(str, sizes)),
                            other=OTHER if added else AFFINE, done="set" if first else "changed in place")
    names = [[f"{'abc'[k]}{i}" for i in range(sum(sizes))] for k in range(TOGETHER)]
    lines = [f"def {name_of(sizes, first=first)}(rows: Array, one: int, k: int, at: int, "
             f"variable: Array, {other}"
             "columns: Array, spacing: int) -> None:", said.rstrip("\n"), "    aligned_frame()"]
    lines += [f"    {name} = rows[one, k + {k}, at + {i}]" for k in range(TOGETHER) for i, name in enumerate(names[k])]
    lines += [f"    v{k} = columns[spacing*(k + {k}):spacing*(k + {k}) + variable.size]" for k in range(TOGETHER)]
    variable = "variable[r]" if added else "(variable[r] - middle)*narrowness"
    lines += ["    for r in range(variable.size):", f"        x = {variable}", "        z = x*x"]
    if added:
        lines.append("        y = other[r]")
    for number, size in enumerate(sizes):
        done = sum(sizes[:number])
        lines += _chains([column[done:done + size] for column in names])
        for k in range(TOGETHER):
            before = "" if first and number == 0 else f"{f'v{k}[r]' if number == 0 else f'value{k}'}*y + "
            target = f"v{k}[r]" if number == len(sizes) - 1 else f"value{k}"
            lines.append(f"        {target} = {before}(even{k} + x*odd{k})")
    return "\n".join(lines) + "\n"


def _chains(columns: list[list[str]]) -> list[str]:
    """Even and odd parts by Horner's rule, a term of each in turn."""
    size = len(columns[0])
    parts = [(f"{part}{k}", column[(size - 1 + shift) % 2::2])
             for k, column in enumerate(columns) for shift, part in enumerate(("even", "odd"))]
    lines = []
    for term in range((size + 1) // 2):
        for name, coefficients in parts:
            own = term - ((size + 1) // 2 - len(coefficients))
            if own == 0:
                lines.append(f"        {name} = {coefficients[0]}")
            elif own > 0:
                lines.append(f"        {name} = {name}*z + {coefficients[own]}")
    return lines
