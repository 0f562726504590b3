"""A sweep that is kept in memory and nowhere else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.sweeps.dataset import COMPLETE, array_of, blank_arrays, dataset_of
from granular.sweeps.definition import Sweep
from granular.sweeps.engine import Block
from granular.sweeps.outputs import variables_of
from granular.sweeps.points import chunks_of, shape_of

if TYPE_CHECKING:
    import xarray as xr


class Memory:
    """Takes the chunks of a sweep, as a store does.

    Parameters
    ----------
    sweep : Sweep
        What they belong to.
    """

    def __init__(self, sweep: Sweep) -> None:
        """Begin with nothing."""
        self.sweep, self.finished = sweep, set[int]()
        self._arrays = blank_arrays(sweep)
        self._chunks = chunks_of(sweep.shape, sweep.chunk_shape)

    def put(self, number: int, block: Block) -> None:
        """Take in a chunk."""
        here = self._chunks[number]
        for variable in variables_of(self.sweep.outputs):
            self._arrays[variable.name][here] = array_of(variable, block[variable.name], shape_of(here))
        self.finished.add(number)

    def close(self) -> None:
        """Nothing is left to do."""

    def dataset(self) -> xr.Dataset:
        """All that has been taken in."""
        complete = int(len(self.finished) == len(self._chunks))
        return dataset_of(self.sweep, self._arrays).assign_attrs({COMPLETE: complete})
