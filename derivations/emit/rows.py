"""Two functions that every emitted loop calls: where it keeps what it goes over again, and how results leave it.

Here they are plain Python, so that a loop runs without a compiler; ``granular.batch.compiled_rows`` has what takes
their place where there is one.
"""

from __future__ import annotations

MODULE = '''\
"""Where an emitted loop keeps what it goes over again, and how its results leave it: plain forms of both.

Emitted by ``derivations write``; do not edit.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def scratch_of(size: int) -> Array:
    """Make a place for numbers that a loop keeps from one pass to the next.

    Parameters
    ----------
    size : int
        How many [-].

    Returns
    -------
    scratch : (size,) array [-]
        Zeros.
    """
    return np.zeros(size)


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
'''


def rows_module() -> str:
    """Return the text of ``granular/generated/rows.py``."""
    return MODULE
