"""A contact list as it is read: block by block, checked, in memory that does not grow with the file."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing
from functools import partial
from typing import TYPE_CHECKING

from granular.contacts.columns import Columns, columns_of
from granular.contacts.files import open_table
from granular.contacts.pairs import Pairs
from granular.contacts.periods import across_periods, periods
from granular.contacts.soundness import Missing, check, finite_rows
from granular.errors import ContactValuesMissing, found_at
from granular.units import shown_path

if TYPE_CHECKING:
    from granular.contacts.block import ContactBlock


class ContactList:
    """A file of contacts, opened and not yet read.

    Parameters
    ----------
    path : str or path-like
        CSV or white-space text (both also with gzip), Parquet, or a dump of LAMMPS or LIGGGHTS.
    columns : mapping, optional
        Native name -> name in the file, for columns that are named otherwise.
    step : int, optional
        Time step of a dump [-]; the last one by default.
    spheres_only : bool
        Take missing normals along the branches.
    drop_bad : bool
        Leave out contacts with a number that is missing or not finite, and count them.
    cell : sequence of 3 float, optional
        Edges of a periodic cell [m], 0 where it has no period: branches are made the shortest that it allows.

    Attributes
    ----------
    name : str
        Name of the file, for messages.
    columns : Columns
        Which column holds what.
    read, dropped : int
        Contacts taken and left out so far [-].

    Raises
    ------
    FileUnreadable, ContactFileUnusable
        The file cannot be used.
    ContactColumnsMissing, BadOption
        A column or a time step is not there.

    Examples
    --------
    >>> from granular.contacts.example import example_path
    >>> sum(block.size for block in ContactList(example_path()).blocks())
    5753
    """

    def __init__(self, path: str | os.PathLike[str], *, columns: Mapping[str, str] | None = None,
                 step: int | None = None, spheres_only: bool = False, drop_bad: bool = False,
                 cell: Sequence[float] | None = None) -> None:
        """Open the file and find its columns."""
        self.name = shown_path(os.fspath(path))
        self._cell = None if cell is None else periods(cell)
        self._table, self._drop_bad = open_table(path, step=step), drop_bad
        self.columns: Columns = columns_of(self._table.columns, columns or {}, file=self.name,
                                           spheres_only=spheres_only)
        self.read = self.dropped = 0

    def blocks(self) -> Iterator[ContactBlock]:
        """Read all contacts, some at a time.

        Returns
        -------
        iterator of ContactBlock
            Checked blocks; at the end it is known that no pair came twice.

        Raises
        ------
        ContactFileUnusable
            The file is damaged or cut off.
        ContactValuesMissing
            A number is missing and may not be left out, or there is no contact at all.
        ContactImpossible, ContactTwice
            Contacts that cannot be.

        Notes
        -----
        Accuracy: numbers as they stand in the file. Source: a policy of this package.
        """
        self.read = self.dropped = 0
        with closing(Pairs(self.name)) as pairs:
            yield from self._checked(pairs)

    def _checked(self, pairs: Pairs) -> Iterator[ContactBlock]:
        """Blocks of contacts that can be, their pairs noted; in the end all of them once more."""
        import numpy as np

        missing, first = Missing(self.columns.wanted), 1
        place_of = self._table.place_of
        for rows in self._table.chunks(self.columns.wanted):
            sound = finite_rows(rows)
            numbers, first = first + np.flatnonzero(sound), first + sound.size
            missing.add(rows, ~sound, first=first - sound.size)
            if missing.contacts and not self._drop_bad:
                continue  # to the end of the file, so that all of them are counted
            whole = None if self._cell is None else partial(
                across_periods, cell=self._cell, numbers=numbers, place_of=place_of)
            with found_at(f"{self.name}: "):
                block = self.columns.block(rows if sound.all() else rows[:, sound], whole)
            self.dropped = missing.contacts
            check(block, file=self.name, numbers=numbers, place_of=place_of)
            if block.spheres is not None:
                pairs.add(block.spheres)
            self.read += block.size
            if block.size:
                yield block
        if missing.contacts and not self._drop_bad:
            missing.refuse(file=self.name, contacts=first - 1, place_of=place_of)
        if not self.read:
            left_out = f" ({self.dropped} left out)" if self.dropped else ""
            raise ContactValuesMissing(f"{self.name} has no contact{left_out}", allowed="needed: at least one",
                                       remedy="Export the contacts again.")
        pairs.refuse_twice()
