"""A data file: the scene without the unknowns, what was measured in which state of stress, and what is to be found."""

from __future__ import annotations

import os
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, model_validator

from granular.errors import (
    ConflictingKeys,
    MeasurementsTooFew,
    MissingKey,
    UnknownChoice,
    WrongType,
    found_at,
)
from granular.fields import Kind, Word, chosen
from granular.fitting.quantities import Quantity, quantity, reading
from granular.hypothesis import Hypothesis
from granular.table import Table
from granular.units import shown

if TYPE_CHECKING:
    from granular.scene import Scene

UNKNOWNS = ("D33", "Dr33", "coordination_number", "friction_coefficient")
"""What may be found."""

SCALES = ("modes", "common modes", "states", "common", "none")
"""What stands between the stiffness of the model and that of the sample: a factor of compression and one of shear, for
each state or for all of them; one factor, for each state or for all of them; or nothing."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Names(Kind):
    """A list of different words out of a list."""

    words: tuple[str, ...]

    def read(self, value: object, name: str) -> tuple[str, ...]:
        """Read the list, or refuse it."""
        if not isinstance(value, (list, tuple)) or not value:
            raise WrongType(f"{name} = {shown(value)}", allowed=f"allowed a list out of {', '.join(self.words)}",
                            remedy='Write a list such as ["D33", "Dr33"].')
        listed = tuple(chosen(item, self.words, name=f"{name}[{place}]") for place, item in enumerate(value))
        if len(set(listed)) < len(listed):
            raise UnknownChoice(f"{name} = {shown(value)}", allowed="allowed each word once",
                                remedy="Delete the second one.")
        return listed

    def json_schema(self) -> dict[str, Any]:
        """Array of the words."""
        return {"type": "array", "uniqueItems": True, "items": {"type": "string", "enum": list(self.words)}}


class FitTable(Table):
    """The table ``[fit]``: what is unknown, and what is believed of the scale."""

    unknowns: Annotated[tuple[str, ...], Names(words=UNKNOWNS)] = Field(
        default=("D33", "Dr33"), description="what is to be found")
    scale: Annotated[str, Word(words=SCALES)] = Field(
        default="modes", description="which factors between model and sample are found as well")

    @model_validator(mode="after")
    def _level_known(self) -> FitTable:
        if "coordination_number" in self.unknowns and self.scale != "none":
            raise ConflictingKeys(f'unknown coordination_number with scale = "{self.scale}"',
                                  allowed="allowed one of the two: both multiply all components alike",
                                  remedy='Write scale = "none", or leave coordination_number out.')
        return self


@dataclass(frozen=True, slots=True)
class Measurement:
    """One measured number.

    Attributes
    ----------
    kind : Quantity
        What was measured.
    value, uncertainty : float
        The number and its standard deviation [SI].
    state : int
        Which state of stress it belongs to, from 0.
    """

    kind: Quantity
    value: float
    uncertainty: float
    state: int


@dataclass(frozen=True, slots=True)
class Data:
    """What a fit starts from.

    Attributes
    ----------
    scenes : tuple of Scene
        One for each state of stress, with the unknowns at rest.
    labels : tuple of str
        Their names.
    measurements : tuple of Measurement
        All of them, by state.
    unknowns : tuple of str
        What is to be found.
    scale : str
        One of ``SCALES``.
    """

    scenes: tuple[Scene, ...]
    labels: tuple[str, ...]
    measurements: tuple[Measurement, ...]
    unknowns: tuple[str, ...]
    scale: str

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Data:
        """Read a data file.

        Parameters
        ----------
        path : str or path-like
            A TOML file of at most 1 MiB in UTF-8.

        Returns
        -------
        Data
            The validated data.

        Raises
        ------
        GranularError
            The file cannot be read, or says nothing that can be fitted; one sentence each.

        Notes
        -----
        Source: the format of the data file.
        """
        from granular.scene_file import read_scene

        return cls.of_tables(read_scene(path))

    @classmethod
    def of_tables(cls, tables: Mapping[str, Any]) -> Data:
        """Read the tables of a data file.

        Parameters
        ----------
        tables : mapping
            Those of a scene, ``measured``, a table or a list of them, and ``fit``.

        Returns
        -------
        Data
            The validated data.

        Raises
        ------
        GranularError
            As :meth:`from_toml`.

        Notes
        -----
        Source: the format of the data file.
        """
        rest = deepcopy(dict(tables))
        measured, wanted = rest.pop("measured", None), rest.pop("fit", {})
        if not isinstance(wanted, Mapping):
            raise WrongType(f"fit = {shown(wanted)}", allowed="allowed a table [fit]", remedy="Write [fit].")
        table = FitTable.model_validate(dict(wanted))
        states = [measured] if isinstance(measured, Mapping) else measured
        if not isinstance(states, list) or not states or not all(isinstance(one, Mapping) for one in states):
            raise MissingKey("measured is not given", allowed="needed: [measured], or [[measured]] once for each state",
                             remedy='Add [measured] with lines such as Vs_vh = "212 m/s +- 3 m/s".')
        scenes, labels, measurements = [], [], []
        for number, state in enumerate(states):
            label = str(state.get("label", f"state {number + 1}"))
            with found_at("" if len(states) == 1 else f"{label}: "):
                scenes.append(_scene(rest, state, table))
                measurements += _measurements(state, number, scenes[-1])
            labels.append(label)
        return cls(tuple(scenes), tuple(labels), tuple(measurements), table.unknowns, table.scale)


OWN = ("stress", "void_ratio", "label")
"""Keys of a state that are no measured quantities."""


def _scene(tables: Mapping[str, Any], state: Mapping[str, Any], table: FitTable) -> Scene:
    """The scene of one state: its own stress and void ratio, and the unknowns at values to start from."""
    from granular.derivatives.state import axial_state
    from granular.scene import Scene

    scene = deepcopy(dict(tables))
    for key, home in (("stress", None), ("void_ratio", "packing")):
        if key in state and home is None:
            scene[key] = state[key]
        elif key in state and home is not None:
            scene[home] = {**scene.get(home, {}), key: state[key]}
    _require_unknown(scene, table)
    if "friction_coefficient" in table.unknowns:
        scene["grains"] = {**scene.get("grains", {}), "friction_coefficient": 0.5}
    made = Scene.model_validate(scene)
    if axial_state(made).hypothesis is Hypothesis.STATIC and made.grains.friction is not None:
        raise ConflictingKeys('a fit under hypothesis = "static" with friction',
                              allowed="allowed friction under the kinematic hypothesis only: a fabric under which "
                              "contacts slide has no static stiffness",
                              remedy='Leave the friction out, or write hypothesis = "kinematic".')
    return made


PLACES = {"D33": ("packing", "contact_normals"), "Dr33": ("branches", "anisotropy"),
          "coordination_number": ("packing", "coordination_number"),
          "friction_coefficient": ("grains", "friction_coefficient", "friction_angle")}
"""Table of each unknown, and keys that would give it."""


def _require_unknown(scene: Mapping[str, Any], table: FitTable) -> None:
    """Refuse a value for what is to be found."""
    for name in table.unknowns:
        home, *keys = PLACES[name]
        given = [key for key in keys if isinstance(scene.get(home), Mapping) and key in scene[home]]
        if given:
            raise ConflictingKeys(f"{home}.{given[0]} is given while {name} is unknown",
                                  allowed="allowed one of the two",
                                  remedy=f"Delete {given[0]}, or take {name} out of fit.unknowns.")


def _measurements(state: Mapping[str, Any], number: int, scene: Scene) -> list[Measurement]:
    found = []
    for name, value in state.items():
        if name in OWN:
            continue
        kind = quantity(name)
        if kind.density_power and scene.grains.density is None:
            raise MissingKey("grains.density is not given", allowed=f"needed: {name} is a wave speed",
                             remedy='Add density = "2650 kg/m^3" to [grains].')
        if scene.grains.poisson_ratio == 0 and any(kind.powers[2:4]):
            raise ConflictingKeys(f"{name} with poisson_ratio = 0", allowed="allowed only with a Poisson's ratio above "
                                  "0: the model has C1122 = C1133 = 0 there", remedy=f"Leave {name} out.")
        found.append(Measurement(kind, *reading(value, kind), number))
    if not found:
        raise MeasurementsTooFew("nothing is measured", allowed="needed: at least one quantity in each state",
                                 remedy='Add lines such as Vs_vh = "212 m/s +- 3 m/s".')
    return found
