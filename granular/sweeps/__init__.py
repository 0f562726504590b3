"""Sweeps: a scene over grids and lists of its fields, as an xarray dataset, in a Zarr store, on dask.

``definition`` reads what is wanted, ``points`` lays it out and cuts it into chunks, ``engine`` and ``arrays`` compute
a chunk, ``workers`` says where, ``store`` and ``memory`` keep it, and ``run`` puts them together.
"""

from __future__ import annotations

from granular.sweeps.definition import Sweep
from granular.sweeps.run import sweep
from granular.sweeps.store import open_sweep

__all__ = ["Sweep", "open_sweep", "sweep"]
