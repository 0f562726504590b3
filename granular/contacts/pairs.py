"""Whether two bodies touch twice in a list, in memory that does not grow with it.

Pairs are written to a few temporary files by a hash of the two numbers, so that equal pairs meet in one of them; each
file is then sorted by itself. Short lists never leave memory.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from typing import IO, TYPE_CHECKING

from granular.errors import ContactImpossible, ContactTwice

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Keys = NDArray[np.uint64]

IN_MEMORY = 1 << 18
"""Pairs that are kept in memory before they are written [-], 2 MiB and five times that while they are."""

FILES = 64
"""Temporary files, so that of 10^8 contacts 12 MB are in memory at a time."""

_LARGEST = (1 << 32) - 1
_MIX = 0x9E3779B97F4A7C15
"""The golden ratio times 2^64, which scatters the bits of a product."""


class Pairs:
    """The pairs of bodies of a list.

    Parameters
    ----------
    file : str
        Name of the list, for messages.
    """

    def __init__(self, file: str) -> None:
        """Begin without pairs."""
        self._file = file
        self._kept: list[Keys] = []
        self._size = 0
        self._parts: list[IO[bytes]] = []

    def add(self, spheres: NDArray[np.int64]) -> None:
        """Take the pairs of some more contacts.

        Parameters
        ----------
        spheres : (2, n) array of int
            Numbers of the two bodies [-], 0 to 2^32 - 1.

        Raises
        ------
        ContactImpossible
            A number outside that range, or a body that touches itself.
        """
        import numpy as np

        if spheres.size and (int(spheres.min()) < 0 or int(spheres.max()) > _LARGEST):
            wrong = int(spheres.min()) if int(spheres.min()) < 0 else int(spheres.max())
            raise ContactImpossible(f"{self._file}: a body has the number {wrong}", allowed=f"allowed 0 to {_LARGEST}",
                                    remedy="Number the bodies from 0 or 1; leave out contacts with walls.")
        low, high = spheres.min(axis=0).astype(np.uint64), spheres.max(axis=0).astype(np.uint64)
        if (same := low == high).any():
            raise ContactImpossible(f"{self._file}: body {int(low[np.argmax(same)])} touches itself",
                                    allowed="allowed two different bodies", remedy="Check which columns are id1 id2.")
        self._kept.append(low << np.uint64(32) | high)
        self._size += low.size
        if self._size > IN_MEMORY:
            self._spill()

    def refuse_twice(self) -> None:
        """Refuse the list if two bodies touch twice in it.

        Raises
        ------
        ContactTwice
            With the number of pairs and one of them.

        Notes
        -----
        Source: exact; equal pairs stand beside each other once they are sorted.
        """
        import numpy as np

        repeated, example = 0, 0
        for keys in self._sorted_parts():
            again = keys[1:][keys[1:] == keys[:-1]]
            if again.size and not repeated:
                example = int(again[0])
            repeated += int(np.unique(again).size)
        self.close()
        if repeated:
            raise ContactTwice(
                f"{self._file}: {repeated} pair{'' if repeated == 1 else 's'} of bodies "
                f"{'stands' if repeated == 1 else 'stand'} in it more than once, such as {example >> 32} and "
                f"{example & _LARGEST}", allowed="allowed each pair once (by id1 and id2, in either order)",
                remedy="Export every contact from one side only; for clumps give the numbers of their spheres.")

    def close(self) -> None:
        """Remove the temporary files."""
        for part in self._parts:
            part.close()
        self._parts, self._kept, self._size = [], [], 0

    def _spill(self) -> None:
        import numpy as np

        if not self._parts:
            self._parts = [tempfile.TemporaryFile() for _ in range(FILES)]  # noqa: SIM115  (they close together)
        keys = np.concatenate(self._kept)
        where = (keys * np.uint64(_MIX)) >> np.uint64(64 - FILES.bit_length() + 1)
        order = np.argsort(where, kind="stable")
        ends = np.cumsum(np.bincount(where.astype(np.int64), minlength=FILES))
        for part, some in zip(self._parts, np.split(keys[order], ends[:-1]), strict=True):
            part.write(some.tobytes())
        self._kept, self._size = [], 0

    def _sorted_parts(self) -> Iterator[Keys]:
        """All pairs in some sorted parts, equal ones in the same part."""
        import numpy as np

        if not self._parts:
            yield np.sort(np.concatenate([np.empty(0, dtype=np.uint64), *self._kept]))
            return
        if self._kept:
            self._spill()
        for part in self._parts:
            part.seek(0)
            yield np.sort(np.frombuffer(part.read(), dtype=np.uint64))
