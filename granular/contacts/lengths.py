"""The distribution of branch lengths in memory that does not grow with the list: a histogram with very fine classes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

PER_OCTAVE = 8192
"""Classes between a length and its double, 8.5e-5 of the length apart."""

GAP = 2.0
"""How much longer than all others some branches are before they are told apart [-]."""

_OCTAVES = (-50, 30)
"""Powers of two of the shortest and the longest length that have classes of their own [m]: 1e-15 to 1e9."""


class Lengths:
    """Branch lengths of a list.

    Attributes
    ----------
    least, greatest : float
        Shortest and longest branch [m].
    """

    def __init__(self) -> None:
        """Begin without lengths."""
        import numpy as np

        self.least, self.greatest = math.inf, 0.0
        self._counts = np.zeros((_OCTAVES[1] - _OCTAVES[0]) * PER_OCTAVE, dtype=np.int64)

    def add(self, branch: Array) -> None:
        """Take some more branches.

        Parameters
        ----------
        branch : (3, n) array
            l [m].

        Notes
        -----
        Source: a histogram of the logarithm.
        """
        import numpy as np

        length = np.sqrt(np.sum(branch**2, axis=0))
        self.least, self.greatest = min(self.least, float(length.min())), max(self.greatest, float(length.max()))
        place = ((np.log2(length) - _OCTAVES[0]) * PER_OCTAVE).astype(np.int64)
        place = np.clip(place, 0, self._counts.size - 1)
        low = int(place.min())
        counts = np.bincount(place - low)
        self._counts[low:low + counts.size] += counts

    def stragglers(self) -> tuple[int, float, float] | None:
        """Branches that are far longer than all others, as between centres that lack a period.

        Returns
        -------
        (int, float, float) or None
            How many they are [-], the shortest of them and the longest of the others [m]; None where there is no gap of
            a factor ``GAP``, or where those beyond it are not the fewer.

        Notes
        -----
        Accuracy: 8.5e-5 of a length. Source: the widest empty part of the histogram.

        Examples
        --------
        >>> import numpy as np
        >>> lengths = Lengths()
        >>> lengths.add(np.array([[1.0, 1.1, 1.2, 14.0], [0.0] * 4, [0.0] * 4]))
        >>> lengths.stragglers()[0]
        1
        """
        import numpy as np

        filled = np.flatnonzero(self._counts)
        steps = np.diff(filled)
        if not steps.size or steps.max() <= PER_OCTAVE * math.log2(GAP):
            return None
        last = int(np.argmax(steps))
        beyond, total = int(self._counts[filled[last + 1]:].sum()), int(self._counts.sum())
        if 2 * beyond > total:
            return None
        below, above = (math.exp2(_OCTAVES[0] + (int(filled[place]) + 0.5) / PER_OCTAVE) for place in (last, last + 1))
        return beyond, above, below

    def quantile(self, share: float) -> float:
        """The length that a share of all branches does not exceed.

        Parameters
        ----------
        share : float
            From 0 to 1 [-].

        Returns
        -------
        float
            Length [m].

        Notes
        -----
        Accuracy: 8.5e-5 of the length, and never outside the shortest and the longest. Source: the histogram.

        Examples
        --------
        >>> import numpy as np
        >>> lengths = Lengths()
        >>> lengths.add(np.array([[1.0, 2.0, 3.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]))
        >>> round(lengths.quantile(0.5), 3)
        2.0
        """
        import numpy as np

        if share >= 1:
            return self.greatest
        upto = np.cumsum(self._counts)
        place = int(np.searchsorted(upto, max(share * upto[-1], 0.5)))
        middle = math.exp2(_OCTAVES[0] + (place + 0.5) / PER_OCTAVE)
        return min(max(middle, self.least), self.greatest)
