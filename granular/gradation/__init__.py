"""Gradation, eqs (8)-(18): grain sizes by volume and by number, measured curves, and what they do to branch lengths."""

from __future__ import annotations

from granular.gradation.branch_lengths import BranchLengths, Moment, branch_lengths
from granular.gradation.curve_file import read_curve
from granular.gradation.length_moments import LengthMoments, length_moments
from granular.gradation.lognormal import SPREAD, Lognormal
from granular.gradation.measured_curve import MeasuredCurve
from granular.gradation.size_distribution import SIZE, SizeDistribution

__all__ = ["SIZE", "SPREAD", "BranchLengths", "LengthMoments", "Lognormal", "MeasuredCurve", "Moment",
           "SizeDistribution", "branch_lengths", "length_moments", "read_curve"]
