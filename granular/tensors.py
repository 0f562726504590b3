"""Symmetric second-rank tensors as a scene gives them: fabric and stress."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from granular.errors import SymmetryNotBuilt, TensorUnusable
from granular.fields import Kind, Number
from granular.units import Dimension, shown

Tensor = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
"""A second-rank tensor, row by row."""

_NEAR = 1e-12
"""Two entries of a tensor typed as decimals are the same when they agree to this, relative to the largest."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SymmetricTensor(Kind):
    """A symmetric 3 x 3 tensor, traceless or not.

    Attributes
    ----------
    dimension : Dimension or None
        What each entry measures; None for a pure number.
    traceless : bool
        Whether the three diagonal entries must sum to zero.
    """

    dimension: Dimension | None = None
    traceless: bool = False

    def read(self, value: object, name: str) -> Tensor:
        """Read three rows of three numbers, or say what is wrong with them."""
        rows = list(_rows(value, name))
        entries = [[self._entry(item, f"{name} t{i + 1}{j + 1}") for j, item in enumerate(row)]
                   for i, row in enumerate(rows)]
        (a, b, c), (d, e, f), (g, h, i) = entries
        for this, that, place in ((b, d, "12"), (c, g, "13"), (f, h, "23")):
            if not nearly_equal(this, that, entries):
                raise TensorUnusable(f"{name} has t{place} = {this!r} and t{place[::-1]} = {that!r}",
                                     allowed="allowed only symmetric tensors",
                                     remedy="Make the two entries equal.")
        quarter = math.fsum((a / 4, e / 4, i / 4))  # the trace itself may overflow
        if self.traceless and not nearly_equal(quarter, 0.0, entries):
            raise TensorUnusable(f"{name} has the trace {4 * quarter!r}", allowed="allowed only traceless tensors",
                                 remedy="Subtract a third of the trace from every diagonal entry.")
        return (a, b, c), (d, e, f), (g, h, i)

    def _entry(self, value: object, name: str) -> float:
        return Number(dimension=self.dimension).read(value, name)

    def json_schema(self) -> dict[str, Any]:
        """Three rows of three entries."""
        three = {"type": "array", "minItems": 3, "maxItems": 3}
        return three | {"items": three | {"items": Number(dimension=self.dimension).json_schema()}}


def _rows(value: object, name: str) -> Iterator[Sequence[object]]:
    """The three rows of a nested list; an array of NumPy is taken as its list."""
    value = value.tolist() if hasattr(value, "tolist") else value
    rows = value if isinstance(value, (list, tuple)) else ()
    if len(rows) != 3 or any(not isinstance(row, (list, tuple)) or len(row) != 3 for row in rows):
        raise TensorUnusable(f"{name} = {shown(value)}", allowed="allowed three rows of three numbers",
                             remedy="Write [[t11, t12, t13], [t21, t22, t23], [t31, t32, t33]].")
    yield from rows


def nearly_equal(this: float, that: float, entries: Sequence[Sequence[float]]) -> bool:
    """Whether two numbers agree to the rounding of typed decimals, relative to the largest entry of a tensor.

    Parameters
    ----------
    this, that : float
        The numbers [any unit].
    entries : rows of float
        The tensor that they belong to [same unit].

    Returns
    -------
    bool
        True when they differ by less than 1e-12 of the largest entry.

    Notes
    -----
    Source: a choice; 1e-12 is above the rounding of a dozen typed digits and below any measured fabric.

    Examples
    --------
    >>> nearly_equal(0.1 + 0.2, 0.3, [[0.3]])
    True
    """
    largest = max(abs(entry) for row in entries for entry in row)
    return abs(this / 4 - that / 4) <= _NEAR * (largest / 4)


def require_axial(tensor: Tensor) -> None:
    """Refuse a symmetric tensor that is not axially symmetric about axis 3.

    Parameters
    ----------
    tensor : (3, 3) tuple of float
        The tensor [any unit].

    Raises
    ------
    SymmetryNotBuilt
        It is not diag(t11, t11, t33), to the rounding of typed decimals.

    Notes
    -----
    Source: invariance under rotation about axis 3.

    Examples
    --------
    >>> require_axial(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 2.0)))
    """
    (a, b, c), (_, e, f), _ = tensor
    if not (nearly_equal(a, e, tensor) and all(nearly_equal(off, 0.0, tensor) for off in (b, c, f))):
        raise SymmetryNotBuilt(f"tensor = {shown(tensor)}",
                               allowed="allowed diag(t11, t11, t33), axially symmetric about axis 3",
                               remedy="Other tensors are not built yet: turn the axes, or give the axial part.")
