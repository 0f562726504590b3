"""Command line of granular: every refusal becomes one line on standard error and exit code 2."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

REFUSED, INTERRUPTED = 2, 130
"""Exit codes of input that is wrong and of Ctrl-C; a command itself leaves with 0, or with 1 when a check failed."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a command and leave with its exit code.

    Parameters
    ----------
    arguments : sequence of str, optional
        Arguments; those of the process by default.

    Raises
    ------
    SystemExit
        Always: 0 done, 1 a check failed, 2 the input is wrong, 130 stopped by Ctrl-C.

    Notes
    -----
    Source: the command line's interface.
    """
    sys.exit(_exit_code(arguments))


def _exit_code(arguments: Sequence[str] | None) -> int:
    try:
        # imported here, so that Ctrl-C is quiet while the libraries load
        from granular.commands import run_command
        from granular.errors import GranularError

        try:
            return run_command(arguments)
        except GranularError as refusal:
            print(refusal, file=sys.stderr)
            return REFUSED
    except KeyboardInterrupt:
        return INTERRUPTED


def __getattr__(name: str) -> Any:
    """Offer ``app`` and ``run_command`` here too, without loading their libraries before they are asked for."""
    if name in ("app", "run_command"):
        from granular import commands

        return getattr(commands, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


if __name__ == "__main__":
    main()
