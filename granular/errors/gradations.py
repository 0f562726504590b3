"""Gradation curves that cannot be right."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class CurveMalformed(GranularError):
    """A gradation curve that is no table of at least two sizes with the fraction finer than each."""

    code = "G-GRD-01"
    title = "A gradation curve that is no table of two columns"


class CurveInPercent(GranularError):
    """A gradation curve whose second column is in percent."""

    code = "G-GRD-02"
    title = "A gradation curve in percent"


class CurveNotMonotone(GranularError):
    """A gradation curve on which less is finer than a larger size, or that gives one size twice."""

    code = "G-GRD-03"
    title = "A gradation curve that is not monotone"


class CurveIncomplete(GranularError):
    """A gradation curve that does not begin at 0 or does not end at 1."""

    code = "G-GRD-04"
    title = "A gradation curve that does not reach 0 and 1"
