"""Figures that are not known, or cannot be written."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class FigureNotKnown(GranularError):
    """A figure, or a file format for it, that does not exist."""

    code = "G-FIG-01"
    title = "A figure or format that does not exist"


class FigureNotWritten(GranularError):
    """A figure file that could not be written; nothing is left half done."""

    code = "G-FIG-02"
    title = "A figure that could not be written"
