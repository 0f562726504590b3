"""Directions in a scene: density of contact normals, and branch length, each about axis 3."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from granular.errors import ConflictingKeys, FabricOutOfRange, MissingKey
from granular.fabric import AxialFabric
from granular.fields import Number
from granular.table import Table
from granular.tensors import SymmetricTensor, Tensor, require_axial


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


def _axial_coefficient(D33: float | None, tensor: Tensor | None) -> float:
    """D33 [-] from itself or from a tensor diag(-D/2, -D/2, D)."""
    if D33 is not None and tensor is not None:
        raise ConflictingKeys("D33 and tensor are both given", allowed="allowed one of the two",
                              remedy="Delete one of them.")
    if tensor is not None:
        require_axial(tensor)
        return tensor[2][2]
    if D33 is None:
        raise MissingKey("D33 is not given", allowed="allowed D33, or tensor", remedy="Add D33 (0 for none).")
    return D33


def _renamed(error: FabricOutOfRange, name: str, written: str) -> FabricOutOfRange:
    """Return the same refusal with the name that stands in the scene file."""
    return FabricOutOfRange(error.found.replace(name, written, 1), allowed=error.allowed.replace(name, "D33"),
                            remedy=error.remedy.replace(name, "D33"))
