"""Numerics held against certified values, symbolic limits and each other: what ``granular check`` runs."""

from granular.checks.command import run_checks
from granular.checks.comparison import Comparison
from granular.checks.grouping import Row, rows
from granular.checks.run import table

__all__ = ["Comparison", "Row", "rows", "run_checks", "table"]
