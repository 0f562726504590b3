"""What a sweep is: a base scene, the fields that vary, what is kept of every point, and how it is computed."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from granular.errors import ConflictingKeys, SweepEmpty, SweepTooLarge, UnknownKey, WrongType, found_at
from granular.fields import chosen, nearest
from granular.reading import bytes_of
from granular.routes.catalogue import ROUTES
from granular.scene import Scene
from granular.scene_file import read_toml
from granular.sweeps.arrays import require_array_options
from granular.sweeps.axes import Axis, read_axis
from granular.sweeps.outputs import OUTPUTS
from granular.sweeps.points import Points, chunk_shape
from granular.sweeps.scene_fields import scene_fields, table_types
from granular.units import shown, shown_path

CASE = "case"
"""Dimension of the fields that vary together."""

CURVE = "gradation.file"
"""The field that names a file beside the scene."""

EVALUATE, ARRAYS = "evaluate", "axial_stiffness"
"""The two engines: scene by scene with all that a scene can hold, or whole arrays of axial fabrics at once."""

DEFAULT_OUTPUTS = {EVALUATE: ("stiffness", "relative_error", "route", "effects", "evaluations"),
                   ARRAYS: ("stiffness", "relative_error")}
"""What is kept unless a sweep says so."""

MOST_POINTS = 1_000_000
"""Most points of a sweep that has not been called large."""

CHUNKS = 64
"""How many chunks a sweep has unless it says so, as far as their sizes allow."""

CHUNK_SIZES = {EVALUATE: (16, 4096), ARRAYS: (4096, 65536)}
"""Least and most points of such a chunk."""

_RUN_KEYS = ("outputs", "engine", "route", "chunk")
_SWEEP_KEYS = ("grid", "list", "run")
_RANGE_KEYS = {"start", "stop", "num"}


@dataclass(frozen=True, slots=True)
class Sweep:
    """A sweep over fields of a scene.

    Attributes
    ----------
    base : dict
        Tables of the scene that all points share.
    grid : tuple of Axis
        Fields that vary independently of each other, a dimension each.
    together : tuple of Axis
        Fields that vary together along one more dimension, ``case``.
    outputs : tuple of str
        What is kept of every point.
    engine : str
        ``evaluate`` or ``axial_stiffness``.
    route : str
        "auto", or the name of a route for all points.
    chunk : int
        Most points of a chunk.
    folder : Path
        Where the names of gradation curves start from.
    """

    base: Mapping[str, Any]
    grid: tuple[Axis, ...]
    together: tuple[Axis, ...]
    outputs: tuple[str, ...]
    engine: str
    route: str
    chunk: int
    folder: Path

    @classmethod
    def of(cls, base: Mapping[str, Any] | Scene, *, grid: Mapping[str, object] | None = None,
           together: Mapping[str, object] | None = None, outputs: Sequence[str] | None = None,
           engine: str = EVALUATE, route: str = "auto", chunk: int | None = None,
           folder: str | os.PathLike[str] = ".", places: tuple[str, str] = ("grid", "together")) -> Self:
        """Read a sweep from its parts.

        Parameters
        ----------
        base : dict or Scene
            Tables of the scene that all points share.
        grid, together : dict, optional
            Field -> its values, or a range.
        outputs : sequence of str, optional
            What is kept of every point.
        engine, route : str
            How it is computed.
        chunk : int, optional
            Most points of a chunk [-]; by default about 64 chunks.
        folder : path-like
            Where the names of gradation curves start from.
        places : tuple of str
            Names of ``grid`` and ``together`` in messages.

        Returns
        -------
        Sweep
            With all values read.

        Raises
        ------
        GranularError
            A field that does not exist, a value that it could never take, no point, or an option that is not known.

        Notes
        -----
        Source: the interface of this package.
        """
        tables = base.model_dump(exclude_none=True) if isinstance(base, Scene) else dict(base)
        axes = tuple(read_axis(name, values, place=places[0], distinct=True)
                     for name, values in _items(grid, places[0]))
        cases = tuple(read_axis(name, values, place=places[1], distinct=False)
                      for name, values in _items(together, places[1]))
        _require_one_dimension_each(axes, cases, places)
        chosen_engine = chosen(engine, (EVALUATE, ARRAYS), name="engine")
        kept = _outputs(outputs, chosen_engine)
        if chosen_engine == ARRAYS:
            require_array_options([axis.name for axis in (*axes, *cases)], kept)
        return cls(base=tables, grid=axes, together=cases, outputs=kept,
                   engine=chosen_engine, route=chosen(route, ("auto", *ROUTES), name="route"),
                   chunk=_chunk(chunk, _count(axes, cases), chosen_engine), folder=Path(folder))

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read a sweep file.

        Parameters
        ----------
        path : str or path-like
            A TOML file: the tables of a scene, or ``scene`` with the name of a scene file; and ``[sweep.grid]``,
            ``[sweep.list]`` and ``[sweep.run]``.

        Returns
        -------
        Sweep
            With all values read.

        Raises
        ------
        GranularError
            The file cannot be read, or is no sweep.

        Notes
        -----
        Source: the interface of this package.
        """
        content = read_toml(path)
        parts = _table(content.pop("sweep", {}), "sweep", _SWEEP_KEYS)
        run = _table(parts.get("run", {}), "sweep.run", _RUN_KEYS)
        folder = Path(path).parent
        if "scene" in content:
            tables, folder = _other_scene(content, folder)
        else:
            tables = content
        return cls.of(tables, grid=_flat(parts.get("grid", {}), "sweep.grid"),
                      together=_flat(parts.get("list", {}), "sweep.list"), folder=folder,
                      places=("sweep.grid", "sweep.list"), **run)

    @property
    def dimensions(self) -> dict[str, tuple[Axis, ...]]:
        """Dimension -> the fields that vary along it."""
        return {axis.name: (axis,) for axis in self.grid} | ({CASE: self.together} if self.together else {})

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of places along each dimension."""
        return tuple(axes[0].size for axes in self.dimensions.values())

    @property
    def count(self) -> int:
        """Number of points."""
        return _count(self.grid, self.together)

    @property
    def chunk_shape(self) -> tuple[int, ...]:
        """Places of a chunk along each dimension."""
        return chunk_shape(self.shape, self.chunk)

    @property
    def points(self) -> Points:
        """All points; the names of gradation curves lead there from any folder."""
        base = dict(self.base)
        if isinstance(gradation := base.get("gradation"), Mapping) and isinstance(gradation.get("file"), str):
            base["gradation"] = {**gradation, "file": self._located(gradation["file"])}
        return Points(base, tuple(
            tuple({axis.name: self._located(axis.values[place]) if axis.name == CURVE else axis.values[place]
                   for axis in axes} for place in range(axes[0].size))
            for axes in self.dimensions.values()))

    def content(self) -> dict[str, Any]:
        """All that decides about the numbers, as JSON takes it; gradation curves by the hash of their content."""
        return {"scene": _as_json(self.base),
                "grid": {axis.name: list(axis.labels) for axis in self.grid},
                "list": {axis.name: list(axis.labels) for axis in self.together},
                "outputs": list(self.outputs), "engine": self.engine, "route": self.route, "chunk": self.chunk,
                "files": {name: hashlib.sha256(bytes_of(Path(self._located(name)), shown_path(name),
                                                        kind="a gradation curve")).hexdigest()
                          for name in self._curves()}}

    def require_size(self, *, large: bool) -> None:
        """Refuse more points than anybody asks for by intention, unless the sweep is called large.

        Raises
        ------
        SweepTooLarge
            It has more than a million.
        """
        if self.count > MOST_POINTS and not large:
            raise SweepTooLarge(f"{self.count:,} points ({' x '.join(map(str, self.shape))})",
                                allowed=f"allowed up to {MOST_POINTS:,} by mistake",
                                remedy="Give fewer values, or say --large (large=True) if they are all wanted.")

    def _curves(self) -> Iterator[str]:
        gradation = self.base.get("gradation")
        names = [gradation.get("file")] if isinstance(gradation, Mapping) else []
        names += [value for axis in (*self.grid, *self.together) if axis.name == CURVE for value in axis.values]
        yield from dict.fromkeys(name for name in names if isinstance(name, str) and name.strip())

    def _located(self, name: object) -> str:
        return str((self.folder / str(name)).absolute())


def _items(given: Mapping[str, object] | None, place: str) -> list[tuple[str, object]]:
    if given is None:
        return []
    if not isinstance(given, Mapping):
        raise WrongType(f"{place} = {shown(given)}", allowed="allowed a table of fields with their values",
                        remedy='Write it like {"stress.ratio": [1.0, 1.5]}.')
    return list(given.items())


def _require_one_dimension_each(axes: Sequence[Axis], cases: Sequence[Axis], places: tuple[str, str]) -> None:
    if not axes and not cases:
        raise SweepEmpty("no field varies", allowed="needed: one field at least",
                         remedy=f"Give values to a field under {places[0]} or {places[1]}.")
    names = [axis.name for axis in axes]
    for case in cases:
        if case.name in names:
            raise ConflictingKeys(f"{case.name} stands under {places[0]} and {places[1]}", allowed="allowed under one",
                                  remedy="Delete one of the two.")
        if case.size != cases[0].size:
            raise ConflictingKeys(f"{places[1]} {case.name} has {case.size} values and {cases[0].name} has "
                                  f"{cases[0].size}", allowed="allowed equally many, for they vary together",
                                  remedy=f"Make them equally long, or move one to {places[0]}.")


def _count(axes: Sequence[Axis], cases: Sequence[Axis]) -> int:
    count = cases[0].size if cases else 1
    for axis in axes:
        count *= axis.size
    return count


def _outputs(given: Sequence[str] | None, engine: str) -> tuple[str, ...]:
    if given is None:
        return DEFAULT_OUTPUTS[engine]
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise WrongType(f"outputs = {shown(given)}", allowed=f"allowed a list out of {', '.join(OUTPUTS)}",
                        remedy='Write it like ["stiffness", "ratios"].')
    names = tuple(chosen(name, tuple(OUTPUTS), name=f"outputs[{place}]") for place, name in enumerate(given))
    if not names:
        raise SweepEmpty("outputs = []", allowed=f"needed: at least one out of {', '.join(OUTPUTS)}",
                         remedy="Name one, or leave outputs out.")
    if len(set(names)) < len(names):
        raise ConflictingKeys(f"outputs = {shown(list(names))}", allowed="allowed each output once",
                              remedy="Delete the second one.")
    return names


def _chunk(given: int | None, count: int, engine: str) -> int:
    if given is None:
        least, most = CHUNK_SIZES[engine]
        return min(max(least, -(-count // CHUNKS)), most)
    if isinstance(given, bool) or not isinstance(given, int) or given < 1:
        raise WrongType(f"chunk = {shown(given)}", allowed="allowed a whole number of points from 1",
                        remedy="Leave it out for about 64 chunks.")
    return given


def _table(content: object, name: str, known: Sequence[str]) -> dict[str, Any]:
    """A table of the sweep file, all of whose keys are known."""
    if not isinstance(content, dict):
        raise WrongType(f"{name} = {shown(content)}", allowed="a table belongs here",
                        remedy="Write a table with keys and values.")
    for key in content:
        if key not in known:
            near = nearest(key, known, cutoff=0.0)
            raise UnknownKey(f"{name}.{key} is not a known key", allowed=f"the nearest known one is {near}",
                             remedy=f"The keys here are {', '.join(known)}.")
    return content


def _other_scene(content: dict[str, Any], folder: Path) -> tuple[dict[str, Any], Path]:
    """The tables of the scene file that a sweep file names."""
    name = content.pop("scene")
    if content:
        raise ConflictingKeys(f"scene and {next(iter(content))} are both given",
                              allowed="allowed the name of a scene file, or the tables of a scene",
                              remedy="Delete one of the two.")
    if not isinstance(name, str) or not name.strip():
        raise WrongType(f"scene = {shown(name)}", allowed="allowed the name of a scene file",
                        remedy='Write it like scene = "scene.toml".')
    path = folder / name
    with found_at("scene: "):
        return read_toml(path), path.parent


def _flat(content: object, place: str) -> dict[str, object]:
    """Fields with their values, whether their names are written "stress.ratio" or come apart at the dot."""
    if not isinstance(content, dict):
        raise WrongType(f"{place} = {shown(content)}", allowed="a table of fields belongs here",
                        remedy='Write lines like "stress.ratio" = [1.0, 1.5] below it.')
    flat = dict[str, object]()
    for name, values in _leaves(content, ""):
        if name in flat:
            raise ConflictingKeys(f"{place} {name} is given twice", allowed="allowed once",
                                  remedy="Delete one of them.")
        flat[name] = values
    return flat


def _leaves(content: dict[str, Any], above: str) -> Iterator[tuple[str, object]]:
    for key, value in content.items():
        name = f"{above}.{key}".lstrip(".")
        inside = isinstance(value, dict) and name not in scene_fields() and not _RANGE_KEYS & value.keys()
        if inside and (name in table_types() or any(known.startswith(f"{name}.") for known in scene_fields())):
            yield from _leaves(value, name)
        else:
            yield name, value


def _as_json(value: Any) -> Any:
    """A scene as JSON takes it; anything that TOML knows and JSON does not has no place in a scene."""
    return json.loads(json.dumps(value, default=str))


