"""Contact lists that cannot be right."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class ContactFileUnusable(GranularError):
    """A contact file that is damaged, cut off, empty, not what its name says, or Parquet without its library."""

    code = "G-CON-01"
    title = "A contact file that cannot be used"


class ContactColumnsMissing(GranularError):
    """A contact list without a column that is needed, or with a part only of columns that belong together."""

    code = "G-CON-02"
    title = "A contact list without its columns"


class ContactValuesMissing(GranularError):
    """Contacts with a number that is missing or not finite, or a list without contacts."""

    code = "G-CON-03"
    title = "Contacts with missing values"


class ContactImpossible(GranularError):
    """A contact that two grains cannot have: no branch, no unit normal, tension, a negative stiffness."""

    code = "G-CON-04"
    title = "Contacts that cannot be"


class ContactTwice(GranularError):
    """The same two bodies touch more than once in a list."""

    code = "G-CON-05"
    title = "The same contact twice"
