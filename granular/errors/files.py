"""Files, options and standard output that cannot be used."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class FileUnreadable(GranularError):
    """The file is missing, is a folder, or may not be read."""

    code = "G-INP-01"
    title = "The file cannot be read"


class NotToml(GranularError):
    """The file is not UTF-8 text in TOML."""

    code = "G-INP-02"
    title = "The file is not TOML"


class FileTooLarge(GranularError):
    """The file is larger than any scene."""

    code = "G-INP-03"
    title = "The file is too large"


class BadOption(GranularError):
    """An option of the command line, or its value, is not known."""

    code = "G-INP-04"
    title = "A command-line option that is not known"


class OutputUnwritable(GranularError):
    """Standard output cannot take the result, for instance because the disk is full."""

    code = "G-INP-05"
    title = "The output cannot be written"
