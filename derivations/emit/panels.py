"""Polynomials that many elements of a panel share, as loops to be compiled: three at a time, odd and even powers apart.

A processor starts several operations in each cycle but waits for the result of each. Six chains that do not wait for
one another keep it busy; one Horner chain alone would not.
"""

from __future__ import annotations

TOGETHER = 3
"""Polynomials in one loop."""

SIZES = (4, 7, 10, 11, 12, 13)
"""Numbers of coefficients for which a loop is emitted."""

FIRST = (4, 11)
"""Those with which a sum of rows begins."""

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
    """{summary}

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the {size} that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
{other}    values : (6, m) array [-]
        Values, n of three rows of which are {done}.
    first, last : int
        Where these begin and end.

    Operations: {operations}.
    """
'''

OTHER = """\
    other : (n,) array [-]
        Factor of the values.
"""


def panel_module() -> str:
    """Return the text of ``granular/generated/panel_rows.py``."""
    return "\n".join([HEADER, *("\n" + _function(size, first=True) for size in FIRST),
                      *("\n" + _function(size, first=False) for size in SIZES)])


def _function(size: int, *, first: bool) -> str:
    operations = 1 + TOGETHER * (2 * (size - 1) + (0 if first else 2))
    name, other = (f"set_row_{size}", "") if first else (f"add_row_{size}", "other: Array, ")
    summary = ("Set three values of each element to polynomials." if first else
               "Multiply three values of each element by one variable, and add a polynomial in the other to each.")
    said = DOCSTRING.format(operations=operations, summary=summary, size=size, other="" if first else OTHER,
                            done="set" if first else "changed in place")
    lines = [f"def {name}(rows: Array, k: int, at: int, variable: Array, {other}values: Array, first: int, "
             "last: int) -> None:",
             said.rstrip("\n")]
    lines += [f"    {_name(k, i)} = rows[k + {k}, at + {i}]" for k in range(TOGETHER) for i in range(size)]
    lines += [f"    v{k} = values[k + {k}, first:last]" for k in range(TOGETHER)]
    lines += ["    for r in range(variable.size):", "        x = variable[r]", "        z = x*x"]
    lines += _chains(size)
    before = "" if first else "v{k}[r]*other[r] + "
    lines += [f"        v{k}[r] = {before.format(k=k)}(even{k} + x*odd{k})" for k in range(TOGETHER)]
    return "\n".join(lines) + "\n"


def _chains(size: int) -> list[str]:
    """Even and odd parts by Horner's rule, a term of each in turn."""
    parts = [(f"{part}{k}", [_name(k, i) for i in range(size)][(size - 1 + shift) % 2::2])
             for k in range(TOGETHER) for shift, part in enumerate(("even", "odd"))]
    lines = []
    for term in range((size + 1) // 2):
        for name, coefficients in parts:
            own = term - ((size + 1) // 2 - len(coefficients))
            if own == 0:
                lines.append(f"        {name} = {coefficients[0]}")
            elif own > 0:
                lines.append(f"        {name} = {name}*z + {coefficients[own]}")
    return lines


def _name(k: int, i: int) -> str:
    return f"{'abc'[k]}{i}"
