"""What two grains in contact cannot have: every row of a list is checked before it takes part in a sum."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NoReturn

from granular.errors import ContactImpossible, ContactValuesMissing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.block import ContactBlock

    Array = NDArray[np.float64]

UNIT = 1e-5
"""How far the length of a normal may be from 1 [-]: six written digits keep within a twentieth of that."""

SHOWN = 3
"""Contacts that a message names."""

REACH = 1e-5
"""How far apart two spheres may be, over the sum of their radii [-]: a branch of six digits is no better."""

EXTREME = 1e60
"""No length, force or stiffness in SI units is larger, and no length or stiffness smaller than its inverse: what is has
squares and fourth powers that no number holds."""

PERIOD = "branches across a periodic boundary lack its period, which --cell LX LY LZ adds"
"""What makes a branch too long, or turns it round."""


def finite_rows(rows: Array) -> NDArray[np.bool_]:
    """Tell which contacts have all their numbers.

    Parameters
    ----------
    rows : (k, n) array
        Columns of a list, one a row [any unit].

    Returns
    -------
    (n,) array of bool
        True where all are finite [-].

    Notes
    -----
    Source: a number that is not finite makes every sum so.
    """
    import numpy as np

    return np.asarray(np.isfinite(rows).all(axis=0))


class Missing:
    """Contacts that lack a number, counted over a whole list.

    Parameters
    ----------
    columns : tuple of str
        Names of the columns in the file.

    Attributes
    ----------
    contacts : int
        How many lack a number [-].
    """

    def __init__(self, columns: tuple[str, ...]) -> None:
        """Begin without any."""
        self.contacts = 0
        self._columns, self._first = columns, list[tuple[str, int]]()

    def add(self, rows: Array, bad: NDArray[np.bool_], *, first: int) -> None:
        """Take some more of them.

        Parameters
        ----------
        rows : (k, n) array
            Columns of a list, one a row [any unit].
        bad : (n,) array of bool
            Which contacts lack a number [-].
        first : int
            Number of the first of these contacts in the list, from 1.

        Notes
        -----
        Source: counting.
        """
        import numpy as np

        self.contacts += int(bad.sum())
        for contact in np.flatnonzero(bad)[:SHOWN - len(self._first)]:
            column = int(np.argmax(~np.isfinite(rows[:, contact])))
            self._first.append((f"{self._columns[column]} = {rows[column, contact]}", first + int(contact)))

    def refuse(self, *, file: str, contacts: int, place_of: Callable[[int], str]) -> NoReturn:
        """Refuse the list.

        Parameters
        ----------
        file : str
            Name of the file, for messages.
        contacts : int
            Of the whole list [-].
        place_of : callable
            Number of a contact -> where it stands.

        Raises
        ------
        ContactValuesMissing
            Always, with the number of contacts and the first of them.

        Notes
        -----
        Source: a policy of this package.
        """
        named = ", ".join(f"{value} in {place_of(contact)}" for value, contact in self._first)
        beginning = "first " if self.contacts > len(self._first) else ""
        raise ContactValuesMissing(
            f"{file}: {self.contacts} of {_counted(contacts)} with a value that is missing or not finite, {beginning}"
            f"{named}", allowed="allowed finite numbers",
            remedy="Find out why, or leave such contacts out with --drop-bad.")


def check(block: ContactBlock, *, file: str, numbers: NDArray[np.int64], place_of: Callable[[int], str]) -> None:
    """Refuse contacts that two grains cannot have.

    Parameters
    ----------
    block : ContactBlock
        Contacts; all their numbers are finite.
    file : str
        Name of the file, for messages.
    numbers : (n,) array of int
        Number of each contact in the list, from 1 [-].
    place_of : callable
        Number of a contact -> where it stands.

    Raises
    ------
    ContactImpossible
        A number beyond all measure; a branch without length; a normal that is no unit vector or points against the
        branch; a tension; spheres that do not reach each other; a radius, an overlap or a stiffness that cannot be.

    Notes
    -----
    Spheres that do not reach each other are looked for only where each grain is a sphere, for the branch of a clump
    does not end in the centres of its spheres. Source: geometry; tolerances are for numbers of six digits.
    """
    import numpy as np

    def refuse(bad: NDArray[np.bool_], what: str, value: Callable[[int], str], allowed: str, remedy: str) -> None:
        if bad.any():
            worst = int(np.argmax(bad))
            raise ContactImpossible(f"{file}: {_counted(int(bad.sum()))} with {what}, first {value(worst)} in "
                                    f"{place_of(int(numbers[worst]))}", allowed=f"allowed {allowed}", remedy=remedy)

    if not block.size:
        return
    for name in block.__slots__:
        values = getattr(block, name)
        if values is not None and values.dtype.kind == "f":
            largest = np.abs(values.reshape(-1, block.size)).max(axis=0, initial=0.0)
            refuse(largest > EXTREME, f"a value beyond all measure ({name.replace('_', ' ')})",
                   partial(_shown_at, largest), f"values up to {EXTREME:g}", "Check which column it is, and its unit.")
    length = np.sqrt(np.sum(block.branch**2, axis=0))
    unit = np.sqrt(np.sum(block.normal**2, axis=0))
    along = np.sum(block.branch * block.normal, axis=0)
    refuse(length == 0, "a branch of no length", lambda k: "l = 0", "l > 0",
           "Give the vector from grain centre to grain centre; a wall has none.")
    for name, array in (("l", length), ("kn", block.kn)):
        if array is not None:
            refuse((array > 0) & (array < 1 / EXTREME), f"{name} that is next to nothing", partial(_shown_at, array),
                   f"{name} >= {1 / EXTREME:g}", "Check which column it is, and its unit.")
    refuse(np.abs(unit - 1) > UNIT, "a normal that is no unit vector", lambda k: f"|n| = {unit[k]:.7g}",
           f"|n| = 1 within {UNIT:g}", "Check which columns are n1 n2 n3, and write them with at least six digits.")
    against = along <= 0
    if not block.has_clumps or 2 * int(against.sum()) > block.size:  # clumps that interlock may have one
        refuse(against, "a branch against its normal", lambda k: f"l.n = {along[k]:.4g} m", "l.n > 0",
               "Let both point from the first grain to the second: change the sign of one of them. Where only some are "
               f"wrong: {PERIOD}.")
    for name, array in (("kn", block.kn), ("R1 R2", None if block.radii is None else block.radii.min(axis=0))):
        if array is not None:
            refuse(array <= 0, f"{name} that is not positive", partial(_shown_at, array), "positive values",
                   "Check which column it is; leave out contacts that carry nothing.")
    if (shear := block.ks) is not None:
        refuse(shear < 0, "ks below zero", lambda k: f"{shear[k]:.4g}", "ks >= 0", "Check which column it is.")
    if (force := block.normal_force) is not None:
        refuse(force < 0, "a tensile force", lambda k: f"fn = {force[k]:.4g} N", "fn >= 0, compression positive",
               "Change the sign if tension is positive there, exchange the two grains if f1 f2 f3 is the force on the "
               f"first; leave out contacts that are held by cohesion. Where only some are wrong: {PERIOD}.")
    if (overlap := block.overlap) is not None:
        refuse(overlap < 0, "a negative overlap", lambda k: f"overlap = {overlap[k]:.4g} m", "overlap >= 0",
               "Leave out pairs that do not touch.")
    if (radii := block.radii) is not None and not block.has_clumps:
        gap = length - radii.sum(axis=0)
        refuse(gap > REACH * radii.sum(axis=0), "grains that do not reach each other",
               lambda k: f"l = {length[k]:.7g} m for R1 + R2 = {radii[:, k].sum():.7g} m", "l <= R1 + R2",
               f"Leave out pairs that do not touch; {PERIOD}.")


def _shown_at(values: Array, k: int) -> str:
    return f"{values[k]:.4g}"


def _counted(number: int) -> str:
    return f"{number} contact" if number == 1 else f"{number} contacts"
