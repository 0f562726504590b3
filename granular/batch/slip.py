"""Kernels for contacts that slip: tables in place of sums over directions, where 1e-12 is enough."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from granular.batch.kernel import BlockFunction, Kernel

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.batch.slip_tables import Table

RELATIVE_ERROR = 1e-12
"""Bound of every component that is not subnormal [-]; the worst met in the tests is half of it."""

ONE_FROM = 1 << 13
"""Elements from which a table for one friction is made: it takes as long as some five thousand of them."""

ANY_FROM = 1 << 18
"""Elements from which the table for any friction is made, once in a process: it takes as long as some 170,000."""

LEAST, MOST = 1e-3, 3.0
"""Friction for which a table of its own is made [-]; beyond it panels would have to be narrower."""

INPUTS = ("D33", "Dr33", "stress_ratio", "poisson_ratio", "friction_coefficient")


def kernel_for(friction: NDArray[np.float64], size: int, rtol: float | None) -> Kernel | None:
    """The kernel that serves a batch with slip.

    Parameters
    ----------
    friction : (...) array
        mu of the elements, one value or many [-].
    size : int
        Number of elements [-].
    rtol : float, optional
        Wanted relative accuracy [-]; None is full precision.

    Returns
    -------
    Kernel or None
        None where full precision is wanted or where a table takes longer than it saves. The number of elements
        decides, never what was computed before.

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``. Source: the derivation ``slip_table``.

    Examples
    --------
    >>> import numpy as np
    >>> kernel_for(np.array(0.2), 10**6, None) is None, kernel_for(np.array(0.2), 10, 1e-12) is None
    (True, True)
    """
    if rtol is None or rtol < RELATIVE_ERROR or size < ONE_FROM:
        return None
    first = friction.flat[0].item()
    if friction.size == 1 or bool((friction == first).all()):
        return one_friction(first) if LEAST < first <= MOST else None
    return any_friction() if size >= ANY_FROM else None


@lru_cache(maxsize=32)
def one_friction(friction: float) -> Kernel:
    """The kernel for one friction.

    Parameters
    ----------
    friction : float
        mu, from 0.001 to 3 [-].

    Returns
    -------
    Kernel
        With its table, which is made here.

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``. Source: the derivation ``slip_table``.
    """
    from granular.batch.slip_tables import friction_table

    return _kernel("one friction", friction_table(friction))


@lru_cache(maxsize=1)
def any_friction() -> Kernel:
    """The kernel for friction that varies.

    Returns
    -------
    Kernel
        With its table, which is made here.

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``. Source: the derivation ``slip_table``.
    """
    from granular.batch.slip_tables import general_table

    return _kernel("any friction", general_table())


def _kernel(kind: str, table: Table) -> Kernel:
    return Kernel(name=f"partial slip, {kind}, kinematic", inputs=INPUTS, relative_error=RELATIVE_ERROR,
                  array=_array, loop=_loop, helpers=_helpers, exact_helpers=_exact_helpers,
                  tables=(table.coefficients, table.middle, table.narrowness))


@cache
def _array() -> BlockFunction:
    from granular.batch.slip_array import partial_slip

    return partial_slip


@cache
def _loop() -> BlockFunction:
    from granular.batch.slip_loop import partial_slip

    return partial_slip


def _helpers() -> tuple[Callable[..., object], ...]:
    from granular.batch.slip_loop import HELPERS

    return HELPERS


def _exact_helpers() -> tuple[Callable[..., object], ...]:
    from granular.batch.slip_share import HELPERS

    return HELPERS
