"""A scene: an assembly of grains, the stress on it, and what is wanted; the same names as the scene file."""

from __future__ import annotations

import math
import os
from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from granular.anisotropy import BranchAnisotropy, ContactNormals
from granular.errors import ConflictingKeys, MissingKey, ValueOutOfRange
from granular.fabric import AxialFabric
from granular.fields import Number, Text, Word, WordsOrAuto
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import DEFAULT_RELATION
from granular.stress import Stress
from granular.table import Table
from granular.units import ANGLE, DENSITY, LENGTH, PRESSURE

__all__ = ["BranchAnisotropy", "Branches", "ContactNormals", "Gradation", "Grains", "Model", "Packing", "Scene",
           "Shape", "Stress"]

EFFECT_NAMES = ("packing", "branches", "gradation", "deviation", "kinetic", "slip", "opening")
"""Names of all effects, in the order of the scene file; a test holds them against the catalogue."""


class Grains(Table):
    """The solid that the grains are made of, and the friction between them."""

    shear_modulus: Annotated[float, Number(dimension=PRESSURE, above=0.0)] = Field(
        description="shear modulus of the solid, G_s")
    poisson_ratio: Annotated[float, Number(at_least=0.0, at_most=0.5)] = Field(
        description="Poisson ratio of the solid, nu")
    friction_angle: Annotated[float | None, Number(
        dimension=ANGLE, at_least=0.0, below=1.5707963267948966, optional=True, why="90 deg",
        remedy='A bare number is in radians; degrees are written like "12 deg".')] = Field(
        default=None, description="friction angle between two grains; leave out for contacts that never slip")
    friction_coefficient: Annotated[float | None, Number(at_least=0.0, optional=True)] = Field(
        default=None, description="its tangent mu, in place of friction_angle")
    density: Annotated[float | None, Number(dimension=DENSITY, above=0.0, optional=True)] = Field(
        default=None, description="mass density of the solid, for wave speeds")

    @model_validator(mode="after")
    def _friction_given_once(self) -> Self:
        if self.friction_angle is not None and self.friction_coefficient is not None:
            raise ConflictingKeys("friction_angle and friction_coefficient are both given",
                                  allowed="allowed one of the two", remedy="Delete one of them.")
        return self

    @property
    def friction(self) -> float | None:
        """Friction coefficient mu [-], whichever way it was given; None for contacts that never slip."""
        return self.friction_coefficient if self.friction_angle is None else math.tan(self.friction_angle)


class Packing(Table):
    """How densely the grains are packed, and where their contacts point."""

    void_ratio: Annotated[float, Number(above=0.0)] = Field(
        description="volume of voids over volume of solids, e")
    coordination_number: Annotated[float | None, Number(above=0.0, optional=True)] = Field(
        default=None, description="mean number of contacts per grain, N; by default from e = 1.66 - 0.125 N")
    contact_normals: ContactNormals | None = Field(
        default=None, description="density of contact normals; isotropic by default")

    @model_validator(mode="after")
    def _has_contacts(self) -> Self:
        if self.coordination <= 0.0:
            raise ValueOutOfRange(
                f"void_ratio = {self.void_ratio!r} without coordination_number",
                allowed=f"allowed void_ratio < {DEFAULT_RELATION.intercept} there (the default line e = "
                        f"{DEFAULT_RELATION.intercept} - {DEFAULT_RELATION.slope} N would give "
                        f"N = {self.coordination:.6g})",
                remedy="Add coordination_number, or give a smaller void_ratio.")
        return self

    @property
    def coordination(self) -> float:
        """Mean number of contacts per grain [-], given or by the default relation."""
        if self.coordination_number is not None:
            return self.coordination_number
        return DEFAULT_RELATION.coordination_number(self.void_ratio)


class Branches(Table):
    """The vectors from grain centre to grain centre."""

    anisotropy: BranchAnisotropy | None = Field(
        default=None, description="how the branch length changes with direction; isotropic by default")
    length_ratio: Annotated[float, Number(above=0.0)] = Field(
        default=1.0, description="equivalent branch length l_e over twice the equal-volume radius")


class Gradation(Table):
    """Grain sizes by volume."""

    distribution: Annotated[str, Word(words=("lognormal", "curve"))] = Field(
        description='"lognormal" with median and spread, or "curve" with file')
    median: Annotated[float | None, Number(dimension=LENGTH, above=0.0, optional=True)] = Field(
        default=None, description="median grain size by volume")
    spread: Annotated[float | None, Number(above=1.0, optional=True)] = Field(
        default=None, description="geometric standard deviation s_r")
    file: Annotated[str | None, Text(optional=True)] = Field(
        default=None, description="table of size and fraction finer")

    @model_validator(mode="after")
    def _complete(self) -> Self:
        needed = {"lognormal": ("median", "spread"), "curve": ("file",)}[self.distribution]
        for key in ("median", "spread", "file"):
            given = getattr(self, key) is not None
            if given and key not in needed:
                raise ConflictingKeys(f'{key} is given with distribution = "{self.distribution}"',
                                      allowed=f"allowed {' and '.join(needed)} there",
                                      remedy=f"Delete {key}.")
            if not given and key in needed:
                raise MissingKey(f"{key} is not given",
                                 allowed=f'distribution = "{self.distribution}" needs it',
                                 remedy=f"Add {key}.")
        return self


class Shape(Table):
    """Aligned spheroids with exact branch vectors."""

    aspect_ratio: Annotated[float, Number(above=0.0)] = Field(
        description="b/a, with b along axis 3 and a across")


class Model(Table):
    """How the stiffness is to be computed."""

    hypothesis: Annotated[Hypothesis, Word(words=tuple(Hypothesis), kind=Hypothesis)] = Field(
        default=Hypothesis.KINEMATIC,
        description="uniform strain (an upper bound) or uniform stress (a lower estimate)")
    effects: Annotated[str | tuple[str, ...], WordsOrAuto(words=EFFECT_NAMES)] = Field(
        default="auto", description="what to simulate; auto: what the scene calls for and nothing else")
    rtol: Annotated[float | None, Number(above=0.0, below=1.0, optional=True)] = Field(
        default=None, description="wanted relative accuracy of every component")


class Scene(Table):
    """An assembly of grains, the stress on it, and the wanted model.

    Parameters
    ----------
    grains : Grains
        Solid and friction.
    packing : Packing
        Void ratio, coordination number, density of contact normals.
    branches : Branches, optional
        Branch lengths; isotropic spheres by default.
    gradation : Gradation, optional
        Grain sizes; one size by default.
    shape : Shape, optional
        Aligned spheroids; then no branches.
    stress : Stress
        Mean stress and ratio.
    model : Model, optional
        Hypothesis, effects, wanted accuracy.

    Raises
    ------
    GranularError
        One sentence with value, bound and remedy for the first mistake.

    Examples
    --------
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> scene.stress.mean_stress, round(scene.packing.coordination, 4)
    (28000.0, 8.6848)
    """

    grains: Grains = Field(description="the solid, and the friction between grains")
    packing: Packing = Field(description="how densely the grains are packed, and where contacts point")
    branches: Branches | None = Field(default=None, description="the vectors from centre to centre")
    gradation: Gradation | None = Field(default=None, description="grain sizes; one size by default")
    shape: Shape | None = Field(default=None, description="aligned spheroids with exact branch vectors")
    stress: Stress = Field(description="the stress on the assembly, compression positive")
    model: Model = Field(default_factory=Model, description="hypothesis, effects and wanted accuracy")

    @model_validator(mode="after")
    def _branches_or_shape(self) -> Self:
        if self.branches is not None and self.shape is not None:
            raise ConflictingKeys("branches and shape are both given",
                                  allowed="allowed one of the two (a shape has its own branch vectors)",
                                  remedy="Delete [branches] or [shape].")
        return self

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read a scene file.

        Parameters
        ----------
        path : str or path-like
            A TOML file of at most 1 MiB in UTF-8.

        Returns
        -------
        Scene
            The validated scene.

        Raises
        ------
        GranularError
            The file cannot be read, is not TOML, or is no scene; one sentence each.

        Notes
        -----
        Source: the scene file's interface.
        """
        from granular.scene_file import read_toml

        return cls.model_validate(read_toml(path))

    @classmethod
    def json_schema(cls) -> dict[str, Any]:
        """JSON schema (draft 2020-12) of a scene, as published in ``granular/data/scene.schema.json``.

        Returns
        -------
        dict
            The schema.

        Notes
        -----
        Source: the scene file's interface; generated from the models, never typed.
        """
        from granular.scene_schema import schema_of

        return schema_of(cls)

    @property
    def fabric(self) -> AxialFabric:
        """Everything that the scene says about contact normals and branches, simulated or not [-]."""
        normals = self.packing.contact_normals
        D33, D3333 = normals.coefficients if normals is not None else (0.0, 0.0)
        anisotropy = self.branches.anisotropy if self.branches is not None else None
        Dr33 = anisotropy.coefficient if anisotropy is not None else 0.0
        return AxialFabric(D33=D33, D3333=D3333, Dr33=Dr33)

    @property
    def length_ratio(self) -> float:
        """Equivalent branch length over the grain diameter, l_e/(2 r_e) [-]."""
        return 1.0 if self.branches is None else self.branches.length_ratio
