"""Elastic tensors, their components and their waves."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class IndexNotKnown(GranularError):
    """A component name, or an order of index pairs, that does not exist."""

    code = "G-ELA-01"
    title = "A component or an index order that does not exist"


class TensorNotElastic(GranularError):
    """Numbers that are no stiffness or compliance: not finite, of a wrong shape, or without its symmetry."""

    code = "G-ELA-02"
    title = "Not an elastic tensor"


class TensorNotInvertible(GranularError):
    """A stiffness or compliance that is singular to rounding, so that its inverse means nothing."""

    code = "G-ELA-03"
    title = "A singular elastic tensor"


class TensorNotPositive(GranularError):
    """A stiffness that stores no energy in some strain, where a stable solid is needed."""

    code = "G-ELA-04"
    title = "A stiffness that is not positive definite"


class DirectionNotValid(GranularError):
    """A rotation that is not orthogonal, or an angle that is not a finite number."""

    code = "G-ELA-05"
    title = "A direction that does not exist"


class DensityOutOfRange(GranularError):
    """A mass density that is not positive, or a void ratio that is negative."""

    code = "G-WAV-01"
    title = "A density outside its range"
