"""Directions in a scene: density of contact normals, and branch length, about axis 3 or by tensors."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Annotated, Self

from pydantic import Field, model_validator

from granular.errors import AxisNeeded, ConflictingKeys, FabricOutOfRange, MissingKey, TensorUnusable
from granular.fabric import AxialFabric
from granular.fields import Number
from granular.table import Table
from granular.tensors import ZERO, FourthRankTensor, SymmetricTensor, Tensor, Tensor4, is_axial
from granular.units import shown


class ContactNormals(Table):
    """Density of contact normals: P2 and P4 coefficients about axis 3, or tensors of rank two and four."""

    D33: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P2 coefficient of the density of contact normals, -1 to 2 without D3333")
    D3333: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P4 coefficient of the density of contact normals, inside a region with D33")
    tensor: Annotated[Tensor | None, SymmetricTensor(traceless=True, optional=True)] = Field(
        default=None, description="general traceless D_ij in place of D33")
    tensor4: Annotated[Tensor4 | None, FourthRankTensor(optional=True)] = Field(
        default=None, description="general D_ijkl beside tensor, the same for every order of its indices, all traces "
                                  "zero")

    @model_validator(mode="after")
    def _admissible(self) -> Self:
        if self.tensor is not None and self.D3333 is not None:
            raise ConflictingKeys("tensor and D3333 are both given",
                                  allowed="allowed D33 with D3333, or tensor with tensor4",
                                  remedy="Delete one of them.")
        if self.tensor4 is not None and self.tensor is None:
            raise MissingKey("tensor is not given beside tensor4",
                             allowed="allowed D33 with D3333, or tensor with tensor4",
                             remedy="Add tensor (nine zeros for none), or delete tensor4.")
        _require_one(self.D33, self.tensor)
        if self.axial:
            D33, D3333 = self.coefficients
            _require_axial_fabric(lambda: AxialFabric(D33=D33, D3333=D3333), "D33", self.tensor)
        else:
            _require_general_fabric(D=self.second, D4=self.tensor4)
        return self

    @property
    def axial(self) -> bool:
        """Whether the density is symmetric about axis 3, to the rounding of typed decimals."""
        return self.tensor4 is None and (self.tensor is None or is_axial(self.tensor))

    @property
    def coefficients(self) -> tuple[float, float]:
        """D33 and D3333 [-], whichever way they were given; refused without axis 3."""
        return _axial_coefficient(self.D33, self.tensor, self.axial), self.D3333 or 0.0

    @property
    def second(self) -> Tensor:
        """D_ij [-], whichever way it was given."""
        return _about_axis_3(self.D33) if self.tensor is None else self.tensor

    @property
    def fourth(self) -> Tensor4 | None:
        """D_ijkl [-], whichever way it was given; None where there is none."""
        if not self.D3333:
            return self.tensor4
        from granular.general.axis import fourth_about_axis_3

        return fourth_about_axis_3(self.D3333)


class BranchAnisotropy(Table):
    """How the branch length changes with direction: W = 1 + D33 P2, or a tensor."""

    D33: Annotated[float | None, Number(optional=True)] = Field(
        default=None, description="P2 coefficient of the branch length, inside (-1, 2)")
    tensor: Annotated[Tensor | None, SymmetricTensor(traceless=True, optional=True)] = Field(
        default=None, description="general traceless D_ij in place of D33")

    @model_validator(mode="after")
    def _positive_length(self) -> Self:
        _require_one(self.D33, self.tensor)
        if self.axial:
            _require_axial_fabric(lambda: AxialFabric(Dr33=self.coefficient), "Dr33", self.tensor)
        else:
            _require_general_fabric(Dr=self.second)
        return self

    @property
    def axial(self) -> bool:
        """Whether branch lengths are symmetric about axis 3, to the rounding of typed decimals."""
        return self.tensor is None or is_axial(self.tensor)

    @property
    def coefficient(self) -> float:
        """Dr33 [-], whichever way it was given; refused without axis 3."""
        return _axial_coefficient(self.D33, self.tensor, self.axial)

    @property
    def second(self) -> Tensor:
        """Dr_ij [-], whichever way it was given."""
        return _about_axis_3(self.D33) if self.tensor is None else self.tensor


def _require_one(D33: float | None, tensor: Tensor | None) -> None:
    """Refuse a coefficient and a tensor at once, and neither of them."""
    if D33 is not None and tensor is not None:
        raise ConflictingKeys("D33 and tensor are both given", allowed="allowed one of the two",
                              remedy="Delete one of them.")
    if D33 is None and tensor is None:
        raise MissingKey("D33 is not given", allowed="allowed D33, or tensor", remedy="Add D33 (0 for none).")


def _axial_coefficient(D33: float | None, tensor: Tensor | None, axial: bool) -> float:
    """D33 [-] from itself or from a tensor diag(-D/2, -D/2, D)."""
    if not axial:
        raise AxisNeeded(f"tensor = {shown(tensor)}",
                         allowed="allowed diag(t11, t11, t33) where a coefficient about axis 3 is asked for",
                         remedy="Ask for the tensor.")
    return (D33 or 0.0) if tensor is None else tensor[2][2]


def _about_axis_3(D33: float | None) -> Tensor:
    """The tensor of a coefficient about axis 3."""
    if not D33:
        return ZERO
    return (-D33 / 2, 0.0, 0.0), (0.0, -D33 / 2, 0.0), (0.0, 0.0, D33)


def _require_axial_fabric(build: Callable[[], AxialFabric], name: str, tensor: Tensor | None) -> None:
    """Refuse a coefficient outside its region, under the name that stands in the scene file."""
    try:
        build()
    except FabricOutOfRange as error:
        written = "D33 of the tensor" if tensor else "D33"
        raise FabricOutOfRange(error.found.replace(name, written, 1), allowed=error.allowed.replace(name, "D33"),
                               remedy=error.remedy.replace(name, "D33")) from None


def _require_general_fabric(*, D: Tensor = ZERO, D4: Tensor4 | None = None, Dr: Tensor | None = None) -> None:
    """Refuse tensors that no fabric has, under the names that stand in the scene file."""
    from granular.scene_tensors import general_fabric

    try:
        general_fabric(D, D4, Dr)
    except (FabricOutOfRange, TensorUnusable) as error:
        found, allowed, remedy = (re.sub(r"\bDr?\b", "tensor", re.sub(r"\bD4\b", "tensor4", text))
                                  for text in (error.found, error.allowed, error.remedy))
        raise type(error)(found, allowed=allowed, remedy=remedy) from None
