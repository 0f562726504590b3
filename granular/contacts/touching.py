"""How many grains have no contact, one, or more: a byte for every grain, and no more."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

PAGE = 1 << 16
"""Grains whose counts stand together."""


class Touching:
    """Contacts of each grain, counted up to two."""

    def __init__(self) -> None:
        """Begin without contacts."""
        self._pages: dict[int, NDArray[np.uint8]] = {}

    def add(self, grains: NDArray[np.int64]) -> None:
        """Take the grains of some more contacts.

        Parameters
        ----------
        grains : (2, n) array of int
            Numbers of the grains that touch [-].

        Notes
        -----
        Source: counting.
        """
        import numpy as np

        numbers, counts = np.unique(grains, return_counts=True)
        page = numbers // PAGE
        starts = np.flatnonzero(np.concatenate([[True], page[1:] != page[:-1]]))
        for start, end in zip(starts, [*starts[1:], numbers.size], strict=True):
            known = self._pages.setdefault(int(page[start]), np.zeros(PAGE, dtype=np.uint8))
            place = numbers[start:end] - page[start] * PAGE
            known[place] = np.minimum(known[place] + np.minimum(counts[start:end], 2), 2).astype(np.uint8)

    @property
    def with_one(self) -> int:
        """Grains with exactly one contact [-]."""
        return sum(int((page == 1).sum()) for page in self._pages.values())

    @property
    def with_any(self) -> int:
        """Grains with at least one contact [-]."""
        return sum(int((page > 0).sum()) for page in self._pages.values())
