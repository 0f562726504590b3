"""A scene: an assembly of grains, the stress on it, and what is wanted; the same names as the scene file."""

from __future__ import annotations

import math
import os
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import BeforeValidator, Field, model_validator

from granular.anisotropy import BranchAnisotropy, ContactNormals
from granular.axial_scene import AXIS_3, AxialScene, Axis
from granular.errors import AxisNeeded, ConflictingKeys, ValueOutOfRange
from granular.fabric import FLATTEST, AxialFabric
from granular.fields import Number, Text, Word, WordsOrAuto
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import DEFAULT_RELATION, CoordinationRelation
from granular.scene_gradation import Gradation
from granular.stress import Stress
from granular.table import Table
from granular.tensors import ZERO, Tensor, Tensor4
from granular.units import ANGLE, DENSITY, PRESSURE

if TYPE_CHECKING:
    from granular.general import GeneralFabric, GeneralLoading
    from granular.loading import Loading

__all__ = ["BranchAnisotropy", "Branches", "ContactNormals", "CoordinationLine", "Gradation", "Grains", "Model",
           "Packing", "Scene", "Shape", "Stress"]

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


class CoordinationLine(Table):
    """A straight line between void ratio and coordination number, e = intercept - slope N, in place of the default."""

    intercept: Annotated[float, Number()] = Field(description="void ratio at which the line gives no contacts")
    slope: Annotated[float, Number(above=0.0)] = Field(
        description="fall of the void ratio for one more contact per grain")
    source: Annotated[str, Text()] = Field(default="given by the scene", description="where the line comes from")

    @property
    def relation(self) -> CoordinationRelation:
        """The line as the record that is computed with."""
        return CoordinationRelation(intercept=self.intercept, slope=self.slope, source=self.source)


def _keys_of(value: object) -> object:
    """A relation passed in Python, as the keys of the scene file."""
    return asdict(value) if isinstance(value, CoordinationRelation) else value


class Packing(Table):
    """How densely the grains are packed, and where their contacts point."""

    void_ratio: Annotated[float, Number(above=0.0)] = Field(
        description="volume of voids over volume of solids, e")
    coordination_number: Annotated[float | None, Number(above=0.0, optional=True)] = Field(
        default=None, description="mean number of contacts per grain, N; by default from e = 1.66 - 0.125 N")
    coordination_relation: Annotated[CoordinationLine | None, BeforeValidator(_keys_of)] = Field(
        default=None, description="another line between void ratio and N, in place of e = 1.66 - 0.125 N")
    contact_normals: ContactNormals | None = Field(
        default=None, description="density of contact normals; isotropic by default")

    @model_validator(mode="after")
    def _has_contacts(self) -> Self:
        if self.coordination_number is not None and self.coordination_relation is not None:
            raise ConflictingKeys("coordination_number and coordination_relation are both given",
                                  allowed="allowed one of the two", remedy="Delete one of them.")
        if self.coordination <= 0.0:
            line = self.relation
            which = "default line" if self.coordination_relation is None else "scene's own line"
            raise ValueOutOfRange(
                f"void_ratio = {self.void_ratio!r} without coordination_number",
                allowed=f"allowed void_ratio < {line.intercept} there (the {which} e = "
                        f"{line.intercept} - {line.slope} N would give N = {self.coordination:.6g})",
                remedy="Add coordination_number, or give a smaller void_ratio.")
        return self

    @property
    def relation(self) -> CoordinationRelation:
        """The line between void ratio and coordination number in use, with its source."""
        return DEFAULT_RELATION if self.coordination_relation is None else self.coordination_relation.relation

    @property
    def coordination(self) -> float:
        """Mean number of contacts per grain [-], given or by the relation in use."""
        if self.coordination_number is not None:
            return self.coordination_number
        return self.relation.coordination_number(self.void_ratio)


class Branches(Table):
    """The vectors from grain centre to grain centre."""

    anisotropy: BranchAnisotropy | None = Field(
        default=None, description="how the branch length changes with direction; isotropic by default")
    length_ratio: Annotated[float, Number(above=0.0)] = Field(
        default=1.0, description="equivalent branch length l_e over twice the equal-volume radius")


class Shape(Table):
    """Aligned spheroids with exact branch vectors."""

    aspect_ratio: Annotated[float, Number(above=1 / FLATTEST, below=FLATTEST)] = Field(
        description="b/a, with b along axis 3 and a across")
    spin: Annotated[str, Word(words=("fixed", "relaxed"))] = Field(
        default="fixed", description="grains turn with the mean deformation (fixed), or each is free to spin until "
                                     "it carries no net couple (relaxed)")


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

    @model_validator(mode="after")
    def _spin_or_static(self) -> Self:
        if (self.shape is not None and self.shape.spin == "relaxed"
                and self.model.hypothesis is Hypothesis.STATIC):
            raise ConflictingKeys('shape.spin = "relaxed" with model.hypothesis = "static"',
                                  allowed='allowed spin = "relaxed" only with the kinematic hypothesis (the static one '
                                          "gives the forces, and no spin enters)",
                                  remedy='Delete spin, or write hypothesis = "kinematic".')
        return self

    @model_validator(mode="after")
    def _shape_about_axis_3(self) -> Self:
        if self.shape is not None and not (self.axial or self._fabric_about_axis_3.collinear):
            named = "packing.contact_normals" if self.stress.axial else "stress"
            raise AxisNeeded(f"shape with {named}.tensor",
                             allowed="allowed a shape only with tensors diag(t11, t11, t33), for spheroids lie along "
                             "axis 3 and no formula is derived for others",
                             remedy="Turn the tensors until axis 3 is the axis of everything, or delete [shape].")
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
        from granular.scene_file import read_scene

        return cls.model_validate(read_scene(path))

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
    def axial(self) -> bool:
        """Whether all that the scene says about directions is symmetric about axis 3, as far as it is typed."""
        normals, anisotropy = self.packing.contact_normals, self._anisotropy
        return (self.stress.axial and (normals is None or normals.axial)
                and (anisotropy is None or anisotropy.axial))

    @property
    def axis(self) -> Axis | None:
        """The axis that fabric and stress share [-], a unit vector; axis 3 without any anisotropy, None without one."""
        if self.axial:
            return AXIS_3
        about = self._recognised()
        return None if about is None else about.axis

    @property
    def about_axis(self) -> AxialScene:
        """Fabric and stress about the axis that they share, simulated or not; refused without one."""
        if self.axial:
            return AxialScene(self._fabric_about_axis_3, self.stress.loading(None), AXIS_3, recognised=False)
        about = self._recognised()
        if about is None:
            raise AxisNeeded("a scene whose fabric and stress share no axis",
                             allowed="allowed only tensors with one axis of symmetry in common there",
                             remedy="Use what takes any tensors: run, plan, general_fabric, general_loading.")
        return about

    @property
    def fabric_about_axis(self) -> AxialFabric:
        """Contact normals and branches about the axis of the scene, simulated or not [-]; refused without one."""
        return self._fabric_about_axis_3 if self.axial else self.about_axis.fabric

    def loading_about_axis(self, friction: float | None) -> Loading:
        """Principal stresses along and across the axis of the scene, and friction [-]; refused without an axis."""
        return self.stress.loading(friction) if self.axial else self.about_axis.under(friction)

    @property
    def fabric(self) -> AxialFabric:
        """Everything that the scene says about contact normals and branches about axis 3, simulated or not [-].

        Refused where that is not all: use :attr:`about_axis` for another axis, :attr:`general_fabric` without one.
        """
        if self.axial:
            return self._fabric_about_axis_3
        about = self.about_axis
        if about.axis != AXIS_3:
            raise AxisNeeded(f"a scene symmetric about n = ({', '.join(f'{value:.4g}' for value in about.axis)})",
                             allowed="allowed only axis 3 there", remedy="Turn the tensors until axis 3 is the axis.")
        return about.fabric

    @property
    def general_fabric(self) -> GeneralFabric:
        """Everything that the scene says about contact normals and branches, as tensors, but for a shape [-]."""
        from granular.scene_tensors import general_fabric

        return general_fabric(*self._fabric_tensors)

    def general_loading(self, friction: float | None) -> GeneralLoading:
        """Stress tensor up to a positive factor, and friction [-], as the contacts feel them."""
        from granular.general import GeneralLoading

        return GeneralLoading(self.stress.matrix, friction)

    @property
    def _anisotropy(self) -> BranchAnisotropy | None:
        return None if self.branches is None else self.branches.anisotropy

    @property
    def _fabric_tensors(self) -> tuple[Tensor, Tensor4 | None, Tensor | None]:
        normals, anisotropy = self.packing.contact_normals, self._anisotropy
        return (ZERO if normals is None else normals.second, None if normals is None else normals.fourth,
                None if anisotropy is None else anisotropy.second)

    @property
    def _fabric_about_axis_3(self) -> AxialFabric:
        """What is said about axis 3; tensors without it are left out."""
        normals, anisotropy = self.packing.contact_normals, self._anisotropy
        D33, D3333 = normals.coefficients if normals is not None and normals.axial else (0.0, 0.0)
        Dr33 = anisotropy.coefficient if anisotropy is not None and anisotropy.axial else 0.0
        if self.shape is None:
            return AxialFabric(D33=D33, D3333=D3333, Dr33=Dr33)
        return AxialFabric(D33=D33, D3333=D3333, aspect_ratio=self.shape.aspect_ratio,
                           free_spin=self.shape.spin == "relaxed")

    def _recognised(self) -> AxialScene | None:
        """The axis of tensors that are not all symmetric about axis 3."""
        from granular.scene_tensors import recognised

        return recognised(*self._fabric_tensors, self.stress.matrix)

    @property
    def length_ratio(self) -> float:
        """Equivalent branch length over the grain diameter, l_e/(2 r_e) [-]."""
        return 1.0 if self.branches is None else self.branches.length_ratio
