"""The stress on an assembly, as a scene gives it."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Field, model_validator

from granular.errors import AxisNeeded, ConflictingKeys, MissingKey, StressNotCompressive
from granular.fields import Number
from granular.table import Table
from granular.tensors import SymmetricTensor, Tensor, is_axial
from granular.units import PRESSURE, shown

if TYPE_CHECKING:
    from granular.loading import Loading


class Stress(Table):
    """The stress on the assembly, compression positive: its mean and ratio, or a tensor."""

    mean: Annotated[float | None, Number(
        dimension=PRESSURE, above=0.0, optional=True, why="compression is positive",
        remedy="Give the mean compressive stress as a positive number.")] = Field(
        default=None, description="mean stress (sigma11 + sigma22 + sigma33)/3")
    ratio: Annotated[float | None, Number(
        at_least=0.0, optional=True, why="contacts carry no tension",
        remedy="Give a tensor for a stress with a tension, under which contacts open.")] = Field(
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
        sigma11, sigma33 = self.principal if self.axial else (1, 1)  # the mean says enough of other tensors
        if sigma11 <= 0 and sigma33 <= 0:
            raise StressNotCompressive(
                f"tensor has t11 = {float(sigma11)!r} Pa and t33 = {float(sigma33)!r} Pa",
                allowed="allowed only a stress with some compression (compression is positive)",
                remedy="Give compressive stresses as positive numbers.")
        if self.mean_stress <= 0.0:
            raise StressNotCompressive(
                f"tensor has the mean {self.mean_stress!r} Pa",
                allowed="allowed a mean above 0 Pa, because the unit of stiffness is that of the isotropic assembly "
                "under the mean stress",
                remedy="Give a stress whose compression outweighs its tension.")
        return self

    @property
    def axial(self) -> bool:
        """Whether the stress is symmetric about axis 3, to the rounding of typed decimals."""
        return self.tensor is None or is_axial(self.tensor)

    @property
    def matrix(self) -> Tensor:
        """The stress tensor up to a positive factor [-], compression positive, whichever way it was given."""
        if self.tensor is not None:
            return self.tensor
        return (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0 if self.ratio is None else self.ratio)

    @property
    def principal(self) -> tuple[Fraction, Fraction]:
        """sigma11 and sigma33 up to a common positive factor, exactly as given [-]; refused without axis 3."""
        if not self.axial:
            raise AxisNeeded(f"stress.tensor = {shown(self.tensor)}",
                             allowed="allowed diag(t11, t11, t33) where stresses along and across axis 3 are asked for",
                             remedy="Ask for the tensor.")
        if self.tensor is not None:
            return Fraction(self.tensor[0][0]), Fraction(self.tensor[2][2])
        return Fraction(1), Fraction(1 if self.ratio is None else self.ratio)

    def loading(self, friction: float | None) -> Loading:
        """Principal stresses along and across axis 3, and friction, as the contacts feel them."""
        from granular.loading import Loading

        sigma11, sigma33 = self.principal
        return Loading(sigma11=sigma11, sigma33=sigma33, friction=friction)

    @property
    def mean_stress(self) -> float:
        """Mean stress p [Pa], compression positive, whichever way it was given."""
        if self.tensor is not None and self.axial:
            sigma11, sigma33 = self.principal
            return float((2 * sigma11 + sigma33) / 3)
        if self.tensor is not None:
            return float(sum(Fraction(self.tensor[place][place]) for place in range(3)) / 3)
        assert self.mean is not None  # _compressive has seen to it
        return self.mean
