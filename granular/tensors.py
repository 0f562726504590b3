"""Tensors as a scene gives them: fabric of rank two and four, and stress."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, cast

from granular.errors import TensorUnusable
from granular.fields import Kind, Number
from granular.units import Dimension, shown

Tensor = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
"""A second-rank tensor, row by row."""

Tensor4 = tuple[tuple[Tensor, Tensor, Tensor], tuple[Tensor, Tensor, Tensor], tuple[Tensor, Tensor, Tensor]]
"""A fourth-rank tensor, index by index."""

ZERO: Tensor = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
"""The tensor of something isotropic."""

_THREE: dict[str, Any] = {"type": "array", "minItems": 3, "maxItems": 3}
"""JSON schema of a list of three."""

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
        return _THREE | {"items": _THREE | {"items": Number(dimension=self.dimension).json_schema()}}


@dataclass(frozen=True, slots=True, kw_only=True)
class FourthRankTensor(Kind):
    """All 81 components of a pure tensor of rank four; its symmetry is left to whoever uses it."""

    def read(self, value: object, name: str) -> Tensor4:
        """Read three blocks of three blocks of three rows of three numbers."""
        blocks = [[list(_rows(block, name)) for block in _three(part, name)] for part in _three(_listed(value), name)]
        first, second, third = (
            tuple(tuple(tuple(Number().read(item, f"{name} t{i + 1}{j + 1}{k + 1}{m + 1}")
                              for m, item in enumerate(row)) for k, row in enumerate(block))
                  for j, block in enumerate(part)) for i, part in enumerate(blocks))
        return cast("Tensor4", (first, second, third))

    def json_schema(self) -> dict[str, Any]:
        """Lists of three, four deep."""
        found: dict[str, Any] = Number().json_schema()
        for _ in range(4):
            found = _THREE | {"items": found}
        return found


def _three(value: object, name: str) -> Sequence[object]:
    """Three parts of a tensor of rank four."""
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise TensorUnusable(f"{name} = {shown(value)}", allowed="allowed lists of three, four deep",
                             remedy="Write D_ijkl as [[[[t1111, t1112, t1113], ...], ...], ...].")
    return value


def _listed(value: object) -> object:
    """An array of NumPy as its list."""
    return value.tolist() if hasattr(value, "tolist") else value


def _rows(value: object, name: str) -> Iterator[Sequence[object]]:
    """The three rows of a nested list; an array of NumPy is taken as its list."""
    value = _listed(value)
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


def shown_direction(direction: Sequence[float]) -> str:
    """Write a direction with four digits, its largest component positive.

    Parameters
    ----------
    direction : sequence of 3 float
        A vector [-].

    Returns
    -------
    str
        Such as "(0.7071, 0, -0.7071)".

    Notes
    -----
    Source: n and -n are one direction of contacts.

    Examples
    --------
    >>> shown_direction([-0.8, 1e-18, 0.6])
    '(0.8, 0, -0.6)'
    """
    largest = max(direction, key=abs)
    sign = -1.0 if largest < 0 else 1.0
    return "(" + ", ".join(f"{0.0 + round(sign * value, 6):.4g}" for value in direction) + ")"


def span(name: str, tensor: Tensor) -> str:
    """Say between which values one plus a quadratic form lies.

    Parameters
    ----------
    name : str
        What it is.
    tensor : (3, 3) tuple of float
        The symmetric tensor of the form [-].

    Returns
    -------
    str
        Such as "W from 0.85 to 1.3".

    Notes
    -----
    Source: principal values.

    Examples
    --------
    >>> span("W", ((0.3, 0.0, 0.0), (0.0, -0.15, 0.0), (0.0, 0.0, -0.15)))
    'W from 0.85 to 1.3'
    """
    import numpy as np

    values = np.linalg.eigvalsh(np.array(tensor))
    return f"{name} from {1 + values[0]:.6g} to {1 + values[2]:.6g}"


def is_axial(tensor: Tensor) -> bool:
    """Tell whether a symmetric tensor is axially symmetric about axis 3.

    Parameters
    ----------
    tensor : (3, 3) tuple of float
        The tensor [any unit].

    Returns
    -------
    bool
        Whether it is diag(t11, t11, t33), to the rounding of typed decimals.

    Notes
    -----
    Source: invariance under rotation about axis 3.

    Examples
    --------
    >>> is_axial(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 2.0)))
    True
    """
    (a, b, c), (_, e, f), _ = tensor
    return nearly_equal(a, e, tensor) and all(nearly_equal(off, 0.0, tensor) for off in (b, c, f))
