"""The inverse problem: fabric from measured wave speeds or stiffness components.

``fit`` reads a data file, finds D33, Dr33 and what else is unknown by least squares with the exact slopes, and tells
what the data determine: intervals by the profile of chi-square, the combination of unknowns that is known best, and
residuals in units of the uncertainty.
"""

from granular.fitting.data import SCALES, UNKNOWNS, Data
from granular.fitting.result import Combination, Estimate, Fit, Residual, fit

__all__ = ["SCALES", "UNKNOWNS", "Combination", "Data", "Estimate", "Fit", "Residual", "fit"]
