"""What emitted loops call: where they keep what they go over again, and how results leave them.

Here they are plain Python, so that a loop runs without a compiler; ``granular.batch.compiled_rows`` has what takes
their place where there is one.
"""

from __future__ import annotations

MODULE = '''\
"""Where an emitted loop keeps what it goes over again, and how its results leave it: plain forms of both.

Emitted by ``derivations write``; do not edit.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Places: TypeAlias = npt.NDArray[np.uint32]


def scratch_of(size: int) -> Array:
    """Make a place for numbers that a loop keeps from one pass to the next.

    Parameters
    ----------
    size : int
        How many [-].

    Returns
    -------
    scratch : (size,) array [-]
        Whatever stood there.
    """
    return np.empty(size)


def part_of(whole: Any, first: int, last: int) -> Any:
    """Make a view of an array that a compiler need not count as a reference; the array has to outlive it.

    Parameters
    ----------
    whole : (n,) array [-]
        The array, of any type.
    first, last : int
        Where the view begins and ends, 0 <= first <= last <= n.

    Returns
    -------
    part : (last - first,) array [-]
        The view.
    """
    return whole[first:last]


def aligned_frame() -> None:
    """Let the frame of the calling function begin where whole vectors do, as a compiler can; here it does nothing."""


def write_rows(columns: Array, width: int, spacing: int, out: Array, streamed: bool) -> None:
    """Write columns, one result of some elements in each, as rows, all results of an element in each.

    Parameters
    ----------
    columns : (width spacing,) array [-]
        A column begins every ``spacing`` numbers.
    width, spacing : int
        Columns, and numbers from one to the next.
    out : (width n,) array [-]
        To be filled, n <= spacing.
    streamed : bool
        Whether rows go past the caches, straight to memory, where a compiler knows how.
    """
    count = out.size//width
    for k in range(width):
        out[k::width] = columns[spacing*k:spacing*k + count]


def read_rows(rows: Array, width: int, where: Places, factor: Array, columns: Array, spacing: int) -> None:
    """Read some rows back into columns, each number times the factor of its element.

    Parameters
    ----------
    rows : (width m,) array [-]
        All numbers of a row, one row after another.
    width : int
        Numbers in a row.
    where : (n,) array of int [-]
        Which row each element has.
    factor : (n,) array [-]
        What its numbers are multiplied by.
    columns : (width spacing,) array [-]
        To be filled; a column begins every ``spacing`` numbers.
    spacing : int
        Numbers from one column to the next, >= n.
    """
    for k in range(width):
        columns[spacing*k:spacing*k + where.size] = rows[k::width][where]*factor
'''


def rows_module() -> str:
    """Return the text of ``granular/generated/rows.py``."""
    return MODULE
