"""The fields of a scene by their names in the scene file, such as ``stress.ratio``: what a sweep may vary."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import get_args

from granular.errors import UnknownKey, ValueOutOfRange
from granular.fields import Kind, Number, nearest
from granular.scene import Scene
from granular.table import Table
from granular.units import shown

DIMENSIONLESS = "1"
"""Unit of a pure number, as UDUNITS and CF write it."""


@dataclass(frozen=True, slots=True)
class SceneField:
    """One field of a scene.

    Attributes
    ----------
    name : str
        Its tables and its key, parted by dots.
    kind : Kind
        Reads a value, or refuses it.
    description : str
        What it is.
    """

    name: str
    kind: Kind
    description: str

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers, and stand on a coordinate as such."""
        return isinstance(self.kind, Number)

    @property
    def unit(self) -> str | None:
        """SI unit of a number; None for words, lists and tensors."""
        if not isinstance(self.kind, Number):
            return None
        return DIMENSIONLESS if self.kind.dimension is None else self.kind.dimension.si

    @property
    def table(self) -> str:
        """The table of the scene file that it belongs to."""
        return self.name.partition(".")[0]

    def read(self, value: object, name: str) -> object:
        """Read a value in SI units, or refuse it under a name."""
        if value is None:
            raise ValueOutOfRange(f"{name} is None", allowed="allowed only values that a scene file could hold",
                                  remedy="Leave it out, and make a second sweep of scenes without this key.")
        return self.kind.read(value, name)


@cache
def scene_fields() -> dict[str, SceneField]:
    """Every field of a scene, in the order of the scene file."""
    return {field.name: field for field in _fields_of(Scene, "")}


@cache
def table_types() -> dict[str, type[Table]]:
    """The tables of a scene file."""
    return {name: kind for name, field in Scene.model_fields.items() for kind in _tables(field.annotation)}


def scene_field(name: str) -> SceneField:
    """Find a field.

    Parameters
    ----------
    name : str
        Its tables and its key, parted by dots.

    Returns
    -------
    SceneField
        What it takes.

    Raises
    ------
    UnknownKey
        There is none of this name; the nearest one is named.

    Notes
    -----
    Source: the scene file's interface.

    Examples
    --------
    >>> scene_field("stress.mean").unit
    'Pa'
    """
    known = scene_fields()
    if name in known:
        return known[name]
    near = nearest(name, list(known), cutoff=0.0)
    raise UnknownKey(f"{shown(name)} is no field of a scene", allowed=f"the nearest one is {near}",
                     remedy="Name a table and a key of the scene file, parted by dots.")


def _fields_of(model: type[Table], above: str) -> Iterator[SceneField]:
    for key, field in model.model_fields.items():
        name = f"{above}.{key}".lstrip(".")
        kind = next((kind for kind in field.metadata if isinstance(kind, Kind)), None)
        if kind is not None:
            yield SceneField(name, kind, field.description or "")
        for inner in _tables(field.annotation):
            yield from _fields_of(inner, name)


def _tables(annotation: object) -> Iterator[type[Table]]:
    for kind in (annotation, *get_args(annotation)):
        if isinstance(kind, type) and issubclass(kind, Table):
            yield kind
