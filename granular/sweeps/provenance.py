"""What a sweep was computed with: everything that could change a bit of its numbers, and nothing else."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ARITHMETIC = ("numpy", "scipy", "numba", "python-flint")
"""Packages whose arithmetic enters a number."""


@cache
def fingerprint() -> dict[str, str]:
    """Describe what computes here.

    Returns
    -------
    dict
        Version and source of this package, Python, the packages that do arithmetic, processor family, system, and its
        library of functions; no name of a machine, no folder and no date.

    Notes
    -----
    Two processes with the same fingerprint compute the same bits.
    Source: a policy of this package.
    """
    import granular

    libc = " ".join(part for part in platform.libc_ver() if part) or "unknown"
    return {"granular_version": granular.__version__, "granular_source_sha256": source_hash(),
            "python": platform.python_version(), **{name.replace("-", "_"): _version(name) for name in ARITHMETIC},
            "processor": platform.machine(), "system": platform.system(), "libc": libc}


@cache
def source_hash() -> str:
    """Hash of every source file of this package, names and contents."""
    folder = Path(__file__).resolve().parents[1]
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0")
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def hash_of(content: Mapping[str, object]) -> str:
    """Hash of what JSON can hold, whatever the order of its keys."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
