"""Sweeps that have no points or too many, and folders, schedulers and workers that cannot serve them."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class SweepEmpty(GranularError):
    """A sweep that has no field to vary, or no value to give it."""

    code = "G-SWP-01"
    title = "A sweep without points"


class SweepTooLarge(GranularError):
    """A sweep of so many points that it is probably a slip of the pen."""

    code = "G-SWP-02"
    title = "A sweep of very many points"


class SweepFolderTaken(GranularError):
    """The output folder holds something else than the unfinished part of the same sweep."""

    code = "G-SWP-03"
    title = "A folder that holds something else"


class SchedulerUnreachable(GranularError):
    """The dask scheduler does not answer, or has no workers."""

    code = "G-SWP-04"
    title = "A scheduler that cannot be used"


class WorkersUnusable(GranularError):
    """Workers that were lost, could not be started, or would compute other bits."""

    code = "G-SWP-05"
    title = "Workers that cannot be used"


class SweepLibraryMissing(GranularError):
    """xarray, Zarr or dask is not installed."""

    code = "G-SWP-06"
    title = "A library for sweeps is not installed"
