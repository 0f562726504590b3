"""How tables of partial slip are laid out, and how the panel of an element is found.

Panels of the margin to sliding are halves or quarters of octaves, so that a panel is read off the leading bits of a
number and is as narrow as the onset of sliding is near. About the onset there is one panel on either side.
"""

from __future__ import annotations

import math

import numpy as np

INTEGRALS = 6
"""Integrals of s^(5-k) x^(2k), k = 0 ... 5: all that a density of rank two asks for."""

KNOWN = 4
"""Numbers that ``slip_state`` gives for each element: the level of the stiffness, the contrast, kappa and 1 - kappa."""

DENOMINATOR = 3465.0
"""What ``slip_rows`` wants the integrals to be multiplied by: all moments of the directions are whole then."""

ZONE = 1 / 256
"""Margin to sliding up to which the part that is not smooth at the onset is taken out of a table.

Farther before the onset it would be many times as large as what it is taken from."""

ZONE_BITS = 1023 - 8
"""Exponent of ``ZONE`` as it stands in a double."""

DELICATE = 1 / 512
"""Contrast below which plain arithmetic would lose digits of kappa."""

BETWEEN_ROOTS = math.sqrt(math.pi) * math.gamma(4 / 3) / math.gamma(11 / 6)
"""B(1/2, 4/3)."""

STRENGTHS = np.array([math.sqrt(3) * BETWEEN_ROOTS, -2 * BETWEEN_ROOTS])
"""Strength of what is not smooth before and after the onset of sliding."""

CONTRASTS = (-0.351, 0.291)
"""Contrasts of the cube roots of the forces that tables serve: those of the kinetic kernel, 1/9 <= c/a <= 6."""

COLUMNS = 8
"""Panels of the contrast where friction varies."""

COLUMN_WIDTH = (CONTRASTS[1] - CONTRASTS[0]) / COLUMNS

BEFORE = 8
"""Octaves from the zone up to where there is no shear force."""

OCTAVES = 14
"""Octaves of the margin where friction varies: up to kappa = 65, where friction is below 0.02 at the end of the
domain."""

TERMS = 11
"""Coefficients of a polynomial for one friction, in quarters of octaves: at most 5e-13 of the value is left out, and
that only near the largest friction that is served."""

ROWS = (13, 13, 12, 11, 11, 10, 10, 7, 7, 4, 4)
"""Powers of the margin that go with each power of the contrast, in halves of octaves: 4e-13 is left out."""

HALVES, QUARTERS = 51, 50
"""Bits of a double behind those that tell halves and quarters of octaves apart."""

POSITIVE = (1 << 63) - 1
"""All bits of a double but its sign."""

ALIGNED = 16
"""Elements of a panel start at multiples of this, so that vector code has no remainder."""


def intervals(octaves: int, parts: int) -> list[tuple[float, float]]:
    """Panels of abs(margin) on one side: the zone, parts of octaves, and a last one that is never reached.

    Parameters
    ----------
    octaves, parts : int
        Number of octaves from the zone on, and of panels in each [-].

    Returns
    -------
    list of tuple of 2 float
        Lower and upper end of each [-].

    Notes
    -----
    Source: the layout of a double.

    Examples
    --------
    >>> intervals(1, 2)
    [(0.0, 0.00390625), (0.00390625, 0.005859375), (0.005859375, 0.0078125), (0.0078125, inf)]
    """
    found = [(0.0, ZONE)]
    for octave in range(octaves):
        start = ZONE * 2**octave
        found += [(start * (1 + part / parts), start * (1 + (part + 1) / parts)) for part in range(parts)]
    return [*found, (ZONE * 2**octaves, math.inf)]
