"""A sweep on disk: a Zarr store that is whole from the start, and a ledger of the chunks that are finished.

The store appears in one step, with all its metadata and no numbers. Every file of a chunk is written under another
name and renamed; once all are in place the ledger gets a line with a digest of what was written, and only that line
makes the chunk finished. When the last one is, one rename of the metadata says so, and the ledger goes.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from granular.errors import OutputUnwritable, SweepFolderTaken
from granular.sweeps.dataset import COMPLETE, TITLE, array_of, dataset_of, promised_arrays
from granular.sweeps.definition import Sweep
from granular.sweeps.engine import Block
from granular.sweeps.outputs import variables_of
from granular.sweeps.points import Slices, chunks_of, shape_of
from granular.sweeps.provenance import fingerprint, hash_of

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

LEDGER = ".ledger"
"""File in an unfinished store with one line for each finished chunk: its number, and the digest of its numbers."""


class Store:
    """The store of one sweep, open for writing by this process alone.

    Parameters
    ----------
    sweep : Sweep
        What belongs into it.
    folder : Path
        Where it is, or will be.
    """

    def __init__(self, sweep: Sweep, folder: Path) -> None:
        """Take up what is there, or begin anew."""
        import zarr

        self.sweep, self.folder = sweep, folder
        self._variables = variables_of(sweep.outputs)
        self._chunks = chunks_of(sweep.shape, sweep.chunk_shape)
        if not folder.exists() or (folder.is_dir() and not any(folder.iterdir())):
            self._begin()
        self._require_same_sweep()
        with _told(folder):
            self._group: Any = zarr.open_group(str(folder), mode="r+")
            self._ledger = _locked(folder / LEDGER, folder) if not self.complete else None
            self.finished = set(range(len(self._chunks))) if self.complete else self._finished()
            self._remove_remains()

    @property
    def complete(self) -> bool:
        """Whether every chunk is finished."""
        return bool(self._group.attrs[COMPLETE])

    def put(self, number: int, block: Block) -> None:
        """Write a chunk; it is finished when this returns, and not before.

        Parameters
        ----------
        number : int
            Which one it is.
        block : dict
            Its numbers.

        Raises
        ------
        OutputUnwritable
            The disk is full, or the folder may not be written.
        """
        here = self._chunks[number]
        arrays = {variable.name: array_of(variable, block[variable.name], shape_of(here))
                  for variable in self._variables}
        with _told(self.folder):
            for name, array in arrays.items():
                self._place(name, here, array)
            self._record(f"{number} {_digest(arrays)}\n")
        self.finished.add(number)

    def close(self) -> None:
        """Say that the store is complete where it is, and let others at it."""
        if self._ledger is None:
            return
        with _told(self.folder), self._ledger:
            if len(self.finished) == len(self._chunks):
                self._group.attrs[COMPLETE] = 1
                self._drop_ledger()
        self._ledger = None

    def dataset(self) -> xr.Dataset:
        """The dataset, read piece by piece when it is needed."""
        return open_sweep(self.folder)

    def _begin(self) -> None:
        """Make the store beside its place, and move it there in one step."""
        beside = self.folder.parent / f".{self.folder.name}.partial"
        with _told(self.folder):
            if beside.exists():
                shutil.rmtree(beside)
            _require_space(self.sweep, self.folder.parent)
            with warnings.catch_warnings():
                # Zarr says so of every consolidated store in its third format; xarray reads it either way
                warnings.filterwarnings("ignore", message="Consolidated metadata")
                dataset_of(self.sweep, promised_arrays(self.sweep)).to_zarr(
                    str(beside), mode="w-", compute=False, zarr_format=3, consolidated=True)
            (beside / LEDGER).touch()
            beside.rename(self.folder)

    def _require_same_sweep(self) -> None:
        found = attributes_in(self.folder)
        content = self.sweep.content()
        if found["sweep_sha256"] != hash_of(content):
            raise SweepFolderTaken(f"{self.folder} holds another sweep", allowed="allowed the same sweep, to go on",
                                   remedy="Name another folder, or delete that one.")
        for name, value in fingerprint().items():
            if found.get(name) != value:
                raise SweepFolderTaken(
                    f"{self.folder} was begun with {name} = {found.get(name)!r}, and here it is {value!r}",
                    allowed="allowed the same, so that all numbers are of one kind",
                    remedy="Name another folder, or delete that one.")

    def _finished(self) -> set[int]:
        """Chunks of the ledger whose numbers are still those that were written."""
        assert self._ledger is not None  # only an unfinished store is asked
        self._ledger.seek(0)
        whole, end, _ = self._ledger.read().rpartition("\n")
        self._ledger.truncate(len(whole) + len(end))  # a line that was cut short goes, so that the next one is whole
        digests = dict(line.split() for line in whole.splitlines())  # of two lines for a chunk the later one counts
        return {int(number) for number, digest in digests.items() if self._digest_on_disk(int(number)) == digest}

    def _digest_on_disk(self, number: int) -> str | None:
        try:
            return _digest({variable.name: self._group[variable.name][self._chunks[number]]
                            for variable in self._variables})
        except (OSError, RuntimeError, ValueError):  # a file that was cut short
            return None

    def _place(self, name: str, here: Slices, array: NDArray[Any]) -> None:
        """Write the part of one variable; Zarr gives the file another name until it is whole."""
        self._group[name][here] = array

    def _drop_ledger(self) -> None:
        (self.folder / LEDGER).unlink(missing_ok=True)

    def _record(self, line: str) -> None:
        assert self._ledger is not None  # nothing is put into a complete store
        self._ledger.write(line)
        self._ledger.flush()
        os.fsync(self._ledger.fileno())

    def _remove_remains(self) -> None:
        """Delete what a killed process had not renamed yet, and the ledger of a complete store."""
        for path in self.folder.rglob("*.partial"):
            path.unlink()
        if self.complete:
            self._drop_ledger()


def attributes_in(folder: Path) -> dict[str, Any]:
    """Global attributes of the sweep in a folder.

    Parameters
    ----------
    folder : Path
        The folder.

    Returns
    -------
    dict
        What the store says of itself.

    Raises
    ------
    SweepFolderTaken
        It is a file, or holds no sweep.

    Notes
    -----
    Source: the store.
    """
    import zarr

    try:
        attributes = dict(zarr.open_group(str(folder), mode="r").attrs) if folder.is_dir() else {}
    except (OSError, ValueError):  # no Zarr store; its own errors are of these kinds
        attributes = {}
    if attributes.get("title") != TITLE:
        raise SweepFolderTaken(f"{folder} {'holds no sweep' if folder.is_dir() else 'is no folder'}",
                               allowed="allowed a new folder, an empty one, or the unfinished part of the same sweep",
                               remedy="Name another folder.")
    return attributes


def open_sweep(folder: str | os.PathLike[str]) -> xr.Dataset:
    """Open the dataset of a sweep.

    Parameters
    ----------
    folder : path-like
        Where ``granular.sweep`` or ``granular sweep`` wrote it.

    Returns
    -------
    xarray.Dataset
        Read piece by piece, when it is needed; the attribute ``complete`` is 0 while chunks are missing.

    Raises
    ------
    SweepFolderTaken
        The folder holds no sweep.
    SweepLibraryMissing
        xarray, Zarr or dask is not installed.

    Notes
    -----
    ``xarray.open_zarr`` reads it too. Source: the store.

    Examples
    --------
    >>> import tempfile, granular
    >>> scene = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744}}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = granular.sweep(scene, grid={"stress.mean": ["28 kPa", "224 kPa"]}, out=f"{folder}/stress")
    ...     with open_sweep(f"{folder}/stress") as dataset:
    ...         [round(value, 4) for value in (dataset.C3333 / dataset.C3333[0]).values.tolist()]
    [1.0, 2.0]
    """
    from granular.sweeps.libraries import require_libraries

    require_libraries()
    import xarray as xr

    outputs = json.loads(attributes_in(Path(folder))["sweep"])["outputs"]
    dataset: xr.Dataset = xr.open_zarr(str(folder), consolidated=True)
    return dataset[[variable.name for variable in variables_of(outputs)]]


@contextmanager
def _told(folder: Path) -> Iterator[None]:
    """A disk that is full, or a folder that may not be written, in one sentence."""
    try:
        yield
    except OSError as error:
        raise OutputUnwritable(f"{folder} ({(error.strerror or str(error)).lower()})",
                               allowed="it must be a folder that can be written",
                               remedy="Free some space, or name another folder; the same sweep goes on from the chunks "
                                      "that are finished.") from None


def _require_space(sweep: Sweep, parent: Path) -> None:
    """Refuse before anything is computed what will not fit; compression only makes it smaller."""
    needed = sum(array.nbytes for array in promised_arrays(sweep).values())
    free = shutil.disk_usage(parent).free
    if needed > free:
        raise OutputUnwritable(f"{parent} has {free:,} bytes left", allowed=f"needed: {needed:,} bytes for this sweep",
                               remedy="Free some space, name a folder on another disk, or keep fewer outputs.")


def _locked(path: Path, folder: Path) -> IO[str]:
    """The ledger, open for this process alone as long as it lives."""
    import fcntl

    ledger = path.open("a+", encoding="ascii", newline="\n")
    try:
        fcntl.flock(ledger, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        ledger.close()
        raise SweepFolderTaken(f"{folder} is being written by another process", allowed="allowed one process at a time",
                               remedy="Wait for it, or name another folder.") from None
    return ledger


def _digest(arrays: Mapping[str, Any]) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for array in arrays.values():
        text = array.dtype.kind == "T"
        digest.update("\0".join(array.ravel().tolist()).encode() if text else array.tobytes())
    return digest.hexdigest()
