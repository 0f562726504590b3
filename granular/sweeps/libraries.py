"""The libraries of sweeps, which belong to an extra of their own."""

from __future__ import annotations

from importlib.util import find_spec

from granular.errors import SweepLibraryMissing

NEEDED = ("xarray", "zarr", "dask", "distributed")
"""What a sweep loads."""


def require_libraries() -> None:
    """Refuse before anything else where a library is missing.

    Raises
    ------
    SweepLibraryMissing
        One of them is not installed.

    Notes
    -----
    Source: the extra ``sweep`` of this package.
    """
    for name in NEEDED:
        if find_spec(name) is None:
            raise SweepLibraryMissing(f"{name} is not installed", allowed=f"needed: {', '.join(NEEDED)}",
                                      remedy='Install them with pip install "granular[sweep]".')
