"""The grain sizes of a scene, as a scene gives them."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Self

from pydantic import Field, PrivateAttr, model_validator

from granular.errors import ConflictingKeys, MissingKey, found_at
from granular.fields import Text, Word
from granular.gradation import SIZE, SPREAD, Lognormal, SizeDistribution, read_curve
from granular.table import Table


class Gradation(Table):
    """Grain sizes by volume; sizes are diameters, as sieves measure them."""

    distribution: Annotated[str, Word(words=("lognormal", "curve"))] = Field(
        description='"lognormal" with median and spread, or "curve" with file')
    median: Annotated[float | None, replace(SIZE, optional=True)] = Field(
        default=None, description="median grain size by volume; with form paper the symbol printed in eq. (18), "
                                  "which is the most frequent size")
    spread: Annotated[float | None, replace(SPREAD, optional=True)] = Field(
        default=None, description="geometric standard deviation s_r")
    form: Annotated[str | None, Word(words=("paper", "classical"), optional=True)] = Field(
        default=None, description="density of a lognormal distribution: eq. (18) as printed, without 1/size (paper, "
                                  "the default), or with it (classical)")
    file: Annotated[str | None, Text(optional=True)] = Field(
        default=None, description="table of size and fraction finer; relative to the folder of the scene file")

    _curve: SizeDistribution | None = PrivateAttr(default=None)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        needed = {"lognormal": ("median", "spread"), "curve": ("file",)}[self.distribution]
        possible = {"lognormal": ("median", "spread", "form"), "curve": ("file",)}[self.distribution]
        for key in ("median", "spread", "form", "file"):
            given = getattr(self, key) is not None
            if given and key not in possible:
                raise ConflictingKeys(f'{key} is given with distribution = "{self.distribution}"',
                                      allowed=f"allowed {' and '.join(possible)} there",
                                      remedy=f"Delete {key}.")
            if not given and key in needed:
                raise MissingKey(f"{key} is not given",
                                 allowed=f'distribution = "{self.distribution}" needs it',
                                 remedy=f"Add {key}.")
        if self.file is not None:
            self._curve = _curve_from(self.file)
        return self

    @property
    def sizes(self) -> SizeDistribution:
        """Grain sizes: densities by volume and by number, fraction finer, characteristic sizes."""
        if self._curve is not None:
            return self._curve
        assert self.median is not None  # _complete has seen to both
        assert self.spread is not None
        return Lognormal(self.median, self.spread, form=self.form or "paper")


def _curve_from(file: str) -> SizeDistribution:
    """Read the curve; what is wrong with it is told under the key that names the file."""
    with found_at("file = "):
        return read_curve(file)
