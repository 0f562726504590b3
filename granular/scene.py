"""A scene: an assembly of grains, the stress on it, and what is wanted; the same names as the scene file."""

from __future__ import annotations

import os
from fractions import Fraction
from functools import cache
from typing import Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from granular.errors import (
    ConflictingKeys,
    FabricOutOfRange,
    MissingKey,
    SymmetryNotBuilt,
    ValueOutOfRange,
)
from granular.fabric import AxialFabric
from granular.fields import Number, SymmetricTensor, Tensor, Text, Word, WordsOrAuto, is_axial
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import DEFAULT_RELATION
from granular.refusals import one_sentence
from granular.units import ANGLE, DENSITY, LENGTH, PRESSURE, shown

EFFECT_NAMES = ("packing", "branches", "gradation", "deviation", "kinetic", "slip", "opening")
"""Names of all effects, in the order of the scene file; a test holds them against the catalogue."""


class Table(BaseModel):
    """One table of the scene file: frozen, no unknown keys, and every mistake is one clear sentence."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    def __init__(self, /, **values: Any) -> None:
        """Build the table from its keys; mistakes are GranularError."""
        with one_sentence(type(self), homes=_homes):
            super().__init__(**values)

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Build the table from a dict; mistakes are GranularError."""
        with one_sentence(cls, homes=_homes):
            return super().model_validate(obj, **options)


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


class ContactNormals(Table):
    """Density of contact normals: P2 and P4 coefficients about axis 3, or a tensor."""

    D33: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P2 coefficient of the density of contact normals")
    D3333: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P4 coefficient of the density of contact normals")
    tensor: Annotated[Tensor | None, SymmetricTensor(traceless=True, optional=True)] = Field(
        default=None, description="general traceless D_ij in place of D33")

    @model_validator(mode="after")
    def _admissible(self) -> Self:
        if self.tensor is not None and self.D3333 is not None:
            raise ConflictingKeys("tensor and D3333 are both given",
                                  allowed="allowed D33 with D3333, or tensor", remedy="Delete one of them.")
        D33 = _axial_coefficient(self.D33, self.tensor)
        try:
            AxialFabric(D33=D33, D3333=self.D3333 or 0.0)
        except FabricOutOfRange as error:
            raise _renamed(error, "D33", "D33 of the tensor" if self.tensor else "D33") from None
        return self

    @property
    def coefficients(self) -> tuple[float, float]:
        """D33 and D3333 [-], whichever way they were given."""
        return _axial_coefficient(self.D33, self.tensor), self.D3333 or 0.0


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


class BranchAnisotropy(Table):
    """How the branch length changes with direction: W = 1 + D33 P2, or a tensor."""

    D33: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P2 coefficient of the branch length, inside (-1, 2)")
    tensor: Annotated[Tensor | None, SymmetricTensor(traceless=True, optional=True)] = Field(
        default=None, description="general traceless D_ij in place of D33")

    @model_validator(mode="after")
    def _positive_length(self) -> Self:
        try:
            AxialFabric(Dr33=self.coefficient)
        except FabricOutOfRange as error:
            raise _renamed(error, "Dr33", "D33 of the tensor" if self.tensor else "D33") from None
        return self

    @property
    def coefficient(self) -> float:
        """Dr33 [-], whichever way it was given."""
        return _axial_coefficient(self.D33, self.tensor)


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


class Stress(Table):
    """The stress on the assembly, compression positive: its mean and ratio, or a tensor."""

    mean: Annotated[float | None, Number(
        dimension=PRESSURE, above=0.0, optional=True, why="compression is positive",
        remedy="Give the mean compressive stress as a positive number.")] = Field(
        default=None, description="mean stress (sigma11 + sigma22 + sigma33)/3")
    ratio: Annotated[float | None, Number(
        at_least=0.0, optional=True, why="contacts carry no tension")] = Field(
        default=None, description="sigma33/sigma11, 1 by default")
    tensor: Annotated[Tensor | None, SymmetricTensor(dimension=PRESSURE, optional=True)] = Field(
        default=None, description="stress tensor in place of mean and ratio")

    @model_validator(mode="after")
    def _compressive(self) -> Self:
        if self.tensor is None:
            if self.mean is None:
                raise MissingKey("mean is not given", allowed="allowed mean, or tensor", remedy="Add mean.")
            return self
        extra = [key for key in ("mean", "ratio") if getattr(self, key) is not None]
        if extra:
            raise ConflictingKeys(f"tensor and {extra[0]} are both given",
                                  allowed="allowed mean with ratio, or tensor", remedy="Delete one of them.")
        for index in range(3):
            if self.tensor[index][index] < 0.0:
                place = f"t{index + 1}{index + 1}"
                raise ValueOutOfRange(f"tensor {place} = {self.tensor[index][index]!r} Pa",
                                      allowed=f"allowed {place} >= 0 Pa (compression is positive)",
                                      remedy="Give compressive stresses as positive numbers.")
        _require_axial(self.tensor)
        if self.mean_stress <= 0.0:
            raise ValueOutOfRange(f"tensor has the mean {self.mean_stress!r}", allowed="allowed mean > 0 Pa",
                                  remedy="Give a compressive stress.")
        return self

    @property
    def principal(self) -> tuple[Fraction, Fraction]:
        """sigma11 and sigma33 up to a common positive factor, exactly as given [-]."""
        if self.tensor is not None:
            return Fraction(self.tensor[0][0]), Fraction(self.tensor[2][2])
        return Fraction(1), Fraction(1 if self.ratio is None else self.ratio)

    @property
    def mean_stress(self) -> float:
        """Mean stress p [Pa], compression positive, whichever way it was given."""
        if self.tensor is not None:
            sigma11, sigma33 = self.principal
            return float((2 * sigma11 + sigma33) / 3)
        assert self.mean is not None  # _compressive has seen to it
        return self.mean


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


@cache
def _homes() -> dict[str, str]:
    """Key -> the table it belongs to, for keys that were written in the wrong one."""
    tables: dict[str, type[Table]] = {
        "grains": Grains, "packing": Packing, "packing.contact_normals": ContactNormals, "branches": Branches,
        "branches.anisotropy": BranchAnisotropy, "gradation": Gradation, "shape": Shape, "stress": Stress,
        "model": Model}
    homes: dict[str, str] = {}
    for table, model in tables.items():
        for key in model.model_fields:
            homes.setdefault(key, table)
    return homes


def _axial_coefficient(D33: float | None, tensor: Tensor | None) -> float:
    """D33 [-] from itself or from a tensor diag(-D/2, -D/2, D)."""
    if D33 is not None and tensor is not None:
        raise ConflictingKeys("D33 and tensor are both given", allowed="allowed one of the two",
                              remedy="Delete one of them.")
    if tensor is not None:
        _require_axial(tensor)
        return tensor[2][2]
    if D33 is None:
        raise MissingKey("D33 is not given", allowed="allowed D33, or tensor", remedy="Add D33 (0 for none).")
    return D33


def _require_axial(tensor: Tensor) -> None:
    if not is_axial(tensor):
        raise SymmetryNotBuilt(f"tensor = {shown(tensor)}",
                               allowed="allowed diag(t11, t11, t33), axially symmetric about axis 3",
                               remedy="Other tensors are not built yet: turn the axes, or give the axial part.")


def _renamed(error: FabricOutOfRange, name: str, written: str) -> FabricOutOfRange:
    """Return the same refusal with the name that stands in the scene file."""
    return FabricOutOfRange(error.found.replace(name, written, 1), allowed=error.allowed.replace(name, "D33"),
                            remedy=error.remedy.replace(name, "D33"))
