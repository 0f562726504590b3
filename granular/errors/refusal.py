"""What every refusal is: a code, the value, the bound and the remedy.

An error reads ``FabricOutOfRange [G-FAB-01]: D33 = 2.3, allowed -1 <= D33 <= 2 (E(n) would be negative).
Give a smaller D33.``
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import ClassVar


class GranularError(ValueError):
    """Base of all refusals.

    Parameters
    ----------
    found : str
        What was given, with its name and value, e.g. ``"D33 = 2.3"``.
    allowed : str
        The bound that it broke, e.g. ``"allowed -1 <= D33 <= 2"``.
    remedy : str
        What to do about it, one sentence.
    more : int
        How many further mistakes the same input has [-].
    """

    code: ClassVar[str] = "G-000"
    title: ClassVar[str] = "Refused"

    def __init__(self, found: str, *, allowed: str, remedy: str, more: int = 0) -> None:
        """Compose the one sentence that the user reads."""
        self.found, self.allowed, self.remedy, self.more = found, allowed, remedy, more
        others = f" ({more} more {'mistake' if more == 1 else 'mistakes'} in the same input)" if more else ""
        super().__init__(f"{type(self).__name__} [{self.code}]: {found}, {allowed}. {remedy}{others}")

    def __reduce__(self) -> tuple[Callable[..., GranularError], tuple[object, ...]]:
        """Survive the way back from a worker process, which rebuilds an exception from its arguments."""
        return _rebuilt, (type(self), self.found, self.allowed, self.remedy, self.more)


def _rebuilt(kind: type[GranularError], found: str, allowed: str, remedy: str, more: int) -> GranularError:
    return kind(found, allowed=allowed, remedy=remedy, more=more)


@contextmanager
def found_at(place: str) -> Iterator[None]:
    """Say where something was found that is refused; what is allowed and the remedy stay as they are.

    Parameters
    ----------
    place : str
        Put before what was found, with its separator, e.g. ``"line 3: "``.

    Raises
    ------
    GranularError
        In place of each one raised inside, with the place.

    Notes
    -----
    Source: the error format of this package.

    Examples
    --------
    >>> from granular.errors import FileTooLarge
    >>> with found_at("line 3: "):
    ...     raise FileTooLarge("size = 0", allowed="allowed size > 0", remedy="Give one.")
    Traceback (most recent call last):
    granular.errors.FileTooLarge: FileTooLarge [G-INP-03]: line 3: size = 0, allowed size > 0. Give one.
    """
    try:
        yield
    except GranularError as refusal:
        raise type(refusal)(f"{place}{refusal.found}", allowed=refusal.allowed, remedy=refusal.remedy,
                            more=refusal.more) from None
