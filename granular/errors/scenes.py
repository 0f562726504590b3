"""Scenes, and the tensors and stresses in them, that cannot be right."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class UnknownKey(GranularError):
    """The scene has a key that does not exist."""

    code = "G-SCN-01"
    title = "A key that does not exist"


class MissingKey(GranularError):
    """The scene lacks a key that it needs."""

    code = "G-SCN-02"
    title = "A key is missing"


class WrongType(GranularError):
    """A string, list, table or truth value stands where something else belongs."""

    code = "G-SCN-03"
    title = "A value of the wrong type"


class ValueOutOfRange(GranularError):
    """A number outside the interval in which it means something."""

    code = "G-SCN-04"
    title = "A value outside its range"


class UnknownChoice(GranularError):
    """A word that is not among the choices."""

    code = "G-SCN-05"
    title = "A word that is not among the choices"


class ConflictingKeys(GranularError):
    """Keys that exclude each other, or that need each other."""

    code = "G-SCN-06"
    title = "Keys that do not go together"


class TensorUnusable(GranularError):
    """A fabric or stress tensor that is not 3 x 3, not symmetric, or not traceless where it must be."""

    code = "G-SCN-07"
    title = "A tensor that is not symmetric or not traceless"


class AxisNeeded(GranularError):
    """Something that wants fabric and stress symmetric about axis 3, with tensors that are not."""

    code = "G-SCN-08"
    title = "A tensor without the axis that is needed"


class StressNotCompressive(GranularError):
    """A stress that does not press the grains together: its mean is not a compression."""

    code = "G-SCN-09"
    title = "A stress without compression"
