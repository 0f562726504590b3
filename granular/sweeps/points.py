"""The points of a sweep: a grid, cut into chunks; each point a base scene with some fields set."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Any

from granular.errors import (
    AxisNeeded,
    FileUnreadable,
    GranularError,
    MissingKey,
    NotToml,
    UnknownKey,
    WrongType,
    found_at,
)
from granular.scene import Scene
from granular.sweeps.scene_fields import table_types
from granular.table import Table
from granular.units import shown

Values = Mapping[str, object]
"""Field -> value at one place of one dimension."""

Slices = tuple[slice, ...]
"""Where a chunk lies in the grid."""


@dataclass(frozen=True, slots=True)
class Points:
    """Scenes on a grid.

    Attributes
    ----------
    base : dict
        Tables of the scene that all points share.
    dimensions : tuple of tuple of dict
        For each dimension the fields that vary along it, with their values at each place.
    """

    base: Mapping[str, Any]
    dimensions: tuple[tuple[Values, ...], ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of places along each dimension."""
        return tuple(len(places) for places in self.dimensions)

    @property
    def count(self) -> int:
        """Number of points."""
        return math.prod(self.shape)

    def part(self, slices: Slices) -> Points:
        """The points of one chunk."""
        return Points(self.base, tuple(places[here] for places, here in zip(self.dimensions, slices, strict=True)))

    def values(self) -> Iterator[dict[str, object]]:
        """The fields that vary, point by point; the last dimension runs fastest."""
        for places in itertools.product(*self.dimensions):
            yield {name: value for place in places for name, value in place.items()}

    def at(self, place: int) -> dict[str, object]:
        """The fields that vary, with their values at one point."""
        return next(itertools.islice(self.values(), place, None))

    def along(self, table: str) -> tuple[tuple[int, ...], Iterator[dict[str, object]]]:
        """Shape and values of the part of the grid on which a table varies; other dimensions have one place."""
        mine = [any(_table(name) == table for name in places[0]) for places in self.dimensions]
        part = self.part(tuple(slice(None) if varies else slice(1) for varies in mine))
        return part.shape, ({name: value for name, value in point.items() if _table(name) == table}
                            for point in part.values())


@dataclass(slots=True)
class SceneBuilder:
    """Builds the scenes of a sweep, and each of their tables once.

    Attributes
    ----------
    base : dict
        Tables that all scenes share.
    """

    base: Mapping[str, Any]
    _built: dict[tuple[object, ...], Table | None] = field(default_factory=dict)

    def scene(self, values: Values) -> Scene:
        """Build the scene of one point.

        Raises
        ------
        GranularError
            It is none.
        """
        tables = {name: self.table(name, {key: value for key, value in values.items() if _table(key) == name})
                  for name in table_types()}
        unknown = {name: content for name, content in self.base.items() if name not in tables}
        return Scene.model_validate({name: table for name, table in tables.items() if table is not None} | unknown)

    def table(self, name: str, values: Values) -> Table | None:
        """Build one table, or return it where it was built before; where there is none, what a scene has then."""
        key = (name, *values.items())
        if key not in self._built:
            content = self.base.get(name)
            if values or content is not None:
                content = _with(content, values)
                with found_at(f"{name}." if isinstance(content, Mapping) else ""):
                    self._built[key] = table_types()[name].model_validate(content)
            else:
                standard = Scene.model_fields[name]
                self._built[key] = None if standard.is_required() else standard.get_default(call_default_factory=True)
        return self._built[key]


MISTAKES = (UnknownKey, MissingKey, WrongType, FileUnreadable, NotToml, AxisNeeded)
"""Refusals that speak of the sweep itself: no point of it escapes them, and none becomes a gap."""


def require_scenes(points: Points, *, keep_going: bool, advanced: Callable[[int], None]) -> None:
    """Refuse the first point that is no scene.

    Parameters
    ----------
    points : Points
        The sweep.
    keep_going : bool
        Whether only mistakes in the sweep itself are refused, and points that mean nothing are left for later.
    advanced : callable
        Told after each point how many more have been looked at.

    Raises
    ------
    GranularError
        What is wrong with it, and which point it is.

    Notes
    -----
    Source: the scene file's interface.
    """
    builder = SceneBuilder(points.base)
    for table in table_types():
        for values in points.along(table)[1]:
            with _left_for_later(keep_going), at_point(values):
                builder.table(table, values)
    for values in points.values():
        with _left_for_later(keep_going), at_point(values):
            builder.scene(values)
        advanced(1)


@contextmanager
def _left_for_later(keep_going: bool) -> Iterator[None]:
    try:
        yield
    except GranularError as refusal:
        if not keep_going or isinstance(refusal, MISTAKES):
            raise


def at_point(values: Values) -> AbstractContextManager[None]:
    """Say at which point something was found that is refused."""
    return found_at(f"point {described(values)}: " if values else "")


def described(values: Values) -> str:
    """Name a point by its fields and their values."""
    return ", ".join(f"{name} = {shown(value)}" for name, value in values.items())


def chunk_shape(shape: Sequence[int], wanted: int) -> tuple[int, ...]:
    """Cut a grid into chunks of about a wanted number of points, the last dimensions whole.

    Parameters
    ----------
    shape : sequence of int
        Number of places along each dimension [-].
    wanted : int
        Most points of a chunk [-], >= 1.

    Returns
    -------
    tuple of int
        Places of a chunk along each dimension [-].

    Notes
    -----
    Source: a policy of this package; it knows nothing of workers, so that a store has the same files whatever their
    number.

    Examples
    --------
    >>> chunk_shape((31, 20, 10), 256)
    (1, 20, 10)
    """
    left, places = wanted, list[int]()
    for size in reversed(shape):
        places.insert(0, min(size, left))
        left = max(1, left // size) if left >= size else 1
    return tuple(places)


def shape_of(chunk: Slices) -> tuple[int, ...]:
    """Places of a chunk along each dimension."""
    return tuple(part.stop - part.start for part in chunk)


def chunks_of(shape: Sequence[int], places: Sequence[int]) -> list[Slices]:
    """Where each chunk lies, in the order in which they are computed."""
    return list(itertools.product(*(
        [slice(start, min(start + step, size)) for start in range(0, size, step)]
        for size, step in zip(shape, places, strict=True))))


def _table(name: str) -> str:
    return name.partition(".")[0]


def _with(content: object, values: Values) -> object:
    """A table with some fields set; those that it lacks so far are added."""
    if content is not None and not isinstance(content, Mapping):
        return content  # the table itself will refuse it
    changed = dict(content or {})
    for name, value in values.items():
        *path, key = name.split(".")[1:]
        here = changed
        for inner in path:
            below = here.get(inner)
            if below is not None and not isinstance(below, Mapping):
                raise WrongType(f"{inner} = {shown(below)}", allowed="a table belongs here",
                                remedy="Write a table with keys and values.")
            here[inner] = dict(below or {})
            here = here[inner]
        here[key] = value
    return changed


