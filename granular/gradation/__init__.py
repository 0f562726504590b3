"""Gradation, eqs (8)-(18): grain sizes by volume and by number, measured curves, and what they do to branch lengths."""

from __future__ import annotations

from granular.gradation.curve_file import read_curve
from granular.gradation.lognormal import SPREAD, Lognormal
from granular.gradation.measured_curve import MeasuredCurve
from granular.gradation.size_distribution import SIZE, SizeDistribution

__all__ = ["SIZE", "SPREAD", "Lognormal", "MeasuredCurve", "SizeDistribution", "read_curve"]
