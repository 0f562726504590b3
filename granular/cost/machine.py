"""Where times were measured, without naming the machine."""

from __future__ import annotations

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

PACKAGES = ("granular", "numpy", "scipy", "python-flint", "sympy", "mpmath", "legacy-quadpy")


def machine(packages: tuple[str, ...] = PACKAGES) -> dict[str, str]:
    """Describe where times were measured, without naming the machine.

    Parameters
    ----------
    packages : tuple of str
        Whose versions are told.

    Returns
    -------
    dict
        Processor, cores, system, and versions of Python and of the packages that do the arithmetic.
    """
    described = {"processor": _processor(), "cores": str(os.cpu_count()), "system": platform.system(),
                 "python": platform.python_version()}
    for package in packages:
        try:
            described[package] = version(package)
        except PackageNotFoundError:
            described[package] = "not installed"
    return described


def _processor() -> str:
    """Name the processor; Linux tells it in a file, other systems through the platform module."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()
