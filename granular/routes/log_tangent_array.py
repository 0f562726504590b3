"""Arcs of the log-tangent rule for whole arrays of assemblies: the twin of ``log_tangent``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import TYPE_CHECKING

import numpy as np

from granular.routes.log_tangent import WIDEST
from granular.routes.log_tangent_tables import NEAREST, ROOM, STEADY, STEP, STEPS, first_node, hyperbolic, one_sided
from granular.routes.slip_geometry_array import Geometry
from granular.routes.windows import EQUATOR, POLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

ENTRIES = 2**14
"""Elements times nodes evaluated at a time, so that a dozen such arrays stay near the processor."""

NEGLIGIBLE = 2.0**-160
"""Directions whose tangent, or its inverse, is smaller carry nothing, as in ``slip_geometry``."""

FARTHEST = 2.0**500
"""An edge of the sliding range farther out is moved here, as there."""

Nodes = Callable[["Index", "Index"], tuple["Array", "Array", "Array", "Array"]]
"""Elements of a block and node numbers (n, nodes) to tan(beta), measure, chi and gamma."""

NOTHING, ALL = np.zeros((1, 1)), np.ones((1, 1))
"""chi and gamma of contacts that slide."""

Blocks = tuple["Index", "Array", "Array", "Array", "Array"]
"""Elements of a block, and tan(beta), measure, chi and gamma at their nodes."""


@dataclass(frozen=True, slots=True)
class Arc:
    """Elements that need one kind of arc.

    Attributes
    ----------
    index : (n,) array of int
        The elements.
    first, last : (n,) array of int
        First and last node of each.
    nodes : callable
        Takes positions in ``index``.
    """

    index: Index
    first: Index
    last: Index
    nodes: Nodes

    def blocks(self) -> Iterator[Blocks]:
        """Evaluate the nodes a block at a time, elements with equally many nodes together."""
        count = self.last - self.first + 1
        order = np.argsort(count, kind="stable")
        start = 0
        while start < order.size:
            # the longest of a block decides: it may be at most a quarter longer than the shortest
            room = max(1, ENTRIES // max(1, int(count[order[start]])))
            block = order[start:start + room]
            block = block[count[block] <= 1.25 * count[block[0]] + 16]
            start += block.size
            numbers = self.first[block][:, None] + np.arange(int(count[block].max()))
            yield self.index[block], *self.nodes(block, numbers)


def sticking(geometry: Geometry, narrow: NDArray[np.bool_], low: Array, high: Array, smallest: float,
             places: Array, *, outward: bool) -> Arc:
    """Half of the directions of elements whose contacts all stick, or whose sliding range is too narrow to matter.

    Parameters
    ----------
    geometry : Geometry
        Of all elements.
    narrow : (n,) array of bool
        The elements to take [-].
    low, high : (n,) array
        Range of log(tan(beta)) that matters [-].
    smallest : float
        Smallest scale of the map [-].
    places : (m, n) array
        log(tan(beta)) of the singularities [-].
    outward : bool
        True for the half from the direction nearest to sliding towards the equator.

    Returns
    -------
    Arc
        Their nodes.
    """
    from granular.generated.mohr_circle_array import sticking_node

    index = np.flatnonzero(narrow)
    g = geometry.of(index)
    left = np.maximum(g.left, 0.0)
    r = np.maximum(np.sqrt(left / 2), smallest)
    middle = np.log(g.center)
    start = _start_after(np.arcsinh(_singular_sine(np.abs(places[:, index] - middle).max(axis=0)) / r))
    near, far = ((end[index] - middle) * (1 if outward else -1) for end in ((low, high) if outward else (high, low)))
    first, last = (_reached(np.arcsinh(np.sinh(end / 2) / r), start) for end in (near, far))
    table, row = _tables(hyperbolic, start)

    def nodes(block: Index, numbers: Index) -> tuple[Array, Array, Array, Array]:
        sine, cosine = table[:, row[block, None], np.minimum(numbers, table.shape[2] - 1)]
        growth, rate, chi, gamma = sticking_node(sine, cosine, *(part[block, None] for part in (r, left, g.kappa)))
        center = g.center[block, None]
        return (center * growth if outward else center / growth), rate * STEP, chi, gamma

    return _half(index, first, last, nodes)


def beside(geometry: Geometry, wide: NDArray[np.bool_], low: Array, high: Array, rho: Array, places: Array, *,
           outward: bool, nearest: float = NEAREST) -> Arc:
    """Sticking contacts beyond the sliding range (towards the equator), or before it (towards the pole).

    Parameters
    ----------
    geometry : Geometry
        Of all elements.
    wide : (n,) array of bool
        The elements to take [-].
    low, high : (n,) array
        Range of log(tan(beta)) that matters [-].
    rho : (n,) array
        Hyperbolic sine of a quarter of the width of the range [-].
    places : (m, n) array
        log(tan(beta)) of the singularities [-].
    outward : bool
        True towards the equator.
    nearest : float
        How near nodes come to the edge, as in ``log_tangent_tables`` [-].

    Returns
    -------
    Arc
        Their nodes.
    """
    from granular.generated.mohr_circle_array import beside_node

    edge = geometry.equator if outward else geometry.pole
    index = np.flatnonzero(wide & (edge <= 1 / NEGLIGIBLE if outward else edge >= NEGLIGIBLE))
    at, scale = np.clip(edge[index], 1 / FARTHEST, FARTHEST), np.minimum(rho[index], WIDEST)
    log_edge = np.log(at)
    end = np.maximum(high[index], log_edge + EQUATOR) if outward else np.minimum(low[index], log_edge + POLE)
    psi, beyond = 2 * np.arcsinh(scale), (places[:, index] - log_edge) * (1 if outward else -1)
    start = _start_after(np.arcsinh(_singular_sine(psi + np.maximum(beyond.max(axis=0), 0.0)) / scale))
    last = _reached(np.arccosh(np.maximum(1.0, np.sinh(np.minimum(psi + np.abs(end - log_edge), 1300.0) / 2) / scale)),
                    start)
    table, row = _tables(_near_edge(nearest), start)

    def nodes(block: Index, numbers: Index) -> tuple[Array, Array, Array, Array]:
        grown, pace = table[:, row[block, None], np.minimum(numbers, table.shape[2] - 1)]
        p = grown * grown / (2 * (1 + grown))
        growth, rate, chi, gamma = beside_node(p, p * (2 + grown) / (1 + grown) * pace, scale[block, None])
        edges = at[block, None]
        return (edges * growth if outward else edges / growth), rate * STEP, chi, gamma

    count = np.ceil(last * STEPS).astype(np.intp) - first_node(nearest=nearest)
    return Arc(index, np.zeros(index.shape, dtype=np.intp), count, nodes)


def between(geometry: Geometry, wide: NDArray[np.bool_], low: Array, high: Array, places: Array, *,
            outward: bool) -> Arc:
    """Half of the sliding contacts, as far as they matter.

    Parameters
    ----------
    geometry : Geometry
        Of all elements.
    wide : (n,) array of bool
        The elements to take [-].
    low, high : (n,) array
        Range of log(tan(beta)) that matters [-].
    places : (m, n) array
        log(tan(beta)) of the singularities [-].
    outward : bool
        True for the half from the middle of the range towards the equator.

    Returns
    -------
    Arc
        Their nodes.
    """
    from granular.generated.mohr_circle_array import between_node

    first, last = np.maximum(geometry.pole, np.exp(low)), np.minimum(geometry.equator, np.exp(high))
    index = np.flatnonzero(wide & (first < last))
    first, last = first[index], last[index]
    # from the quotient: logarithms of far ends would lose the place of the near one
    edge = np.sqrt(np.sqrt(last / first))
    center, rho = np.sqrt(first) * np.sqrt(last), (edge - 1) * (edge + 1) / (2 * edge)
    reach = np.sqrt(1 + rho * rho)
    singular = np.minimum(np.abs(places[:, index] - np.log(center)).max(axis=0), 2 * np.log(edge))
    start = _start_after(np.arcsinh(1.5 * _singular_sine(singular)))
    far = _reached(np.log(reach) + 21.5, start)
    table, row = _tables(hyperbolic, start)

    def nodes(block: Index, numbers: Index) -> tuple[Array, Array, Array, Array]:
        sine, cosine = table[:, row[block, None], np.minimum(numbers, table.shape[2] - 1)]
        growth, rate = between_node(sine, cosine, rho[block, None], reach[block, None])
        middle = center[block, None]
        return (middle * growth if outward else middle / growth), rate * STEP, NOTHING, ALL

    return _half(index, np.zeros_like(far), far, nodes)


def _half(index: Index, first: Array, last: Array, nodes: Nodes) -> Arc:
    """Nodes on one side of a centre, as far as the range that matters reaches there."""
    here = np.flatnonzero(last > 0)
    return Arc(index[here], np.maximum(_floor(first[here]), 0), _ceil(last[here]),
               lambda block, numbers: nodes(here[block], numbers))


def _floor(value: Array) -> Index:
    return np.floor(value * STEPS - 0.5).astype(np.intp)


def _ceil(value: Array) -> Index:
    return np.ceil(value * STEPS - 0.5).astype(np.intp)


def _singular_sine(distance: Array) -> Array:
    """Modulus of sinh(sigma/2) at the singularities, as in ``log_tangent``."""
    result: Array = np.sqrt(np.cosh(np.minimum(distance, 700.0)) / 2)
    return result


def _start_after(singular: Array) -> Index:
    """Where nodes may begin to hurry, as in ``log_tangent_tables``."""
    return np.clip(np.ceil(np.minimum(singular, STEADY) + ROOM), 2, STEADY).astype(np.intp)


def _reached(v: Array, start: Index) -> Array:
    """Value of w at which the nodes have passed v, as in ``log_tangent_tables``."""
    return np.copysign(np.minimum(np.abs(v), start + np.log1p(np.abs(v))), v)


def _tables(make: Callable[[int], tuple[tuple[float, float], ...]], start: Index) -> tuple[Array, Index]:
    """Stack the tables of all starts, (2, starts, nodes), and say which row is whose; past its end a table weighs 0."""
    starts, row = np.unique(start, return_inverse=True)
    columns = [_columns(make, int(one)) for one in starts]
    longest = max((column.shape[1] for column in columns), default=0)
    table = np.zeros((2, starts.size, longest + 1))
    for place, column in enumerate(columns):
        table[:, place, :column.shape[1]] = column
        table[0, place, column.shape[1]:] = column[0, -1]
    return table, row


@lru_cache(maxsize=8)
def _near_edge(nearest: float) -> Callable[[int], tuple[tuple[float, float], ...]]:
    """Maker of the one-sided tables that come so near; the same object each time, so that tables are kept."""
    return partial(one_sided, nearest=nearest)


@lru_cache(maxsize=512)
def _columns(make: Callable[[int], tuple[tuple[float, float], ...]], start: int) -> Array:
    return np.array(make(start)).T


def directions(t: Array, measure: Array) -> tuple[Array, Array, Array]:
    """Turn tan(beta) and d(log tan(beta)) into squared sine, squared cosine and dx.

    Parameters
    ----------
    t, measure : (...) array
        tan(beta) and d(log tan(beta)) [-].

    Returns
    -------
    tuple of 3 array, (...)
        s, x^2 and dx = s x d(log tan(beta)) [-].
    """
    with np.errstate(divide="ignore", over="ignore", under="ignore"):
        square = t * t
        s, y = 1 / (1 + 1 / square), 1 / (1 + square)
        return s, y, measure * s * np.sqrt(y)
