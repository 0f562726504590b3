"""Numbers that count what is done with them, so that declared costs can be held against what code really does."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass
class Tally:
    """What has been done so far: + - * / and powers, and calls of roots and other functions."""

    operations: int = 0
    functions: int = 0


TALLY = Tally()


def _counted(name: str) -> Callable[..., Any]:
    plain = getattr(float, name)

    def operate(self: float, *others: Any) -> Any:
        result = plain(float(self), *(float(other) for other in others))
        if result is NotImplemented:
            return result
        TALLY.operations += 1
        return Number(result)

    return operate


class Number(float):
    """A double that counts."""

    for _name in ("add", "sub", "mul", "truediv", "pow"):
        locals()[f"__{_name}__"] = _counted(f"__{_name}__")
        locals()[f"__r{_name}__"] = _counted(f"__r{_name}__")

    def __neg__(self) -> Number:
        return Number(-float(self))

    def __abs__(self) -> Number:
        return Number(abs(float(self)))


def counting(function: Callable[..., float]) -> Callable[..., Number]:
    """Make a function of one double count its calls."""
    def call(value: float) -> Number:
        TALLY.functions += 1
        return Number(function(value))

    return call


def total(terms: list[float]) -> Number:
    """Add doubles, counting."""
    TALLY.operations += len(terms) - 1
    return Number(math.fsum(terms))


OPERATIONS = {np.add, np.subtract, np.multiply, np.divide, np.power, np.square, np.reciprocal}
FUNCTIONS = {np.sqrt, np.cbrt}
FREE = {np.maximum, np.negative}
"""A comparison and a sign are free, as they are for single numbers."""


class Numbers(np.ndarray):
    """An array of doubles that counts what is done with its elements.

    A sum over products (``einsum``, ``@``) counts as ``numpy.einsum_path`` does: in every term all factors but the
    first are multiplied, and every term is added.
    """

    __array_priority__ = 1.0  # so that joining counting arrays leaves one that counts

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        plain = tuple(np.asarray(value.view(np.ndarray) if isinstance(value, Numbers) else value) for value in inputs)
        result = getattr(ufunc, method)(*plain, **options)
        if ufunc is np.matmul:
            TALLY.operations += 2 * result.size * plain[0].shape[-1]
        elif ufunc in OPERATIONS:
            TALLY.operations += plain[0].size - result.size if method == "reduce" else result.size
        elif ufunc in FUNCTIONS:
            TALLY.functions += result.size
        elif ufunc not in FREE:
            raise NotImplementedError(f"{ufunc} is not counted")
        return np.asarray(result).view(Numbers)

    def __array_function__(self, function: Any, types: Any, inputs: Any, options: Any) -> Any:
        if function is not np.einsum:
            return super().__array_function__(function, types, inputs, options)
        form, *factors = inputs
        arrays = [np.asarray(one).view(np.ndarray) for one in factors]
        sizes = {letter: size for letters, array in zip(form.split("->")[0].split(","), arrays, strict=True)
                 for letter, size in zip(letters, array.shape, strict=True)}
        TALLY.operations += math.prod(sizes.values()) * len(arrays)
        return np.einsum(form, *arrays, **options).view(Numbers)
