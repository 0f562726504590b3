"""Run a sweep: look at every point, compute what is missing chunk by chunk, and hand over the dataset."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from granular.errors import BadOption
from granular.fields import chosen
from granular.scene import Scene
from granular.sweeps.arrays import require_array_scene
from granular.sweeps.definition import ARRAYS, EVALUATE, Sweep
from granular.sweeps.engine import Task
from granular.sweeps.libraries import require_libraries
from granular.sweeps.memory import Memory
from granular.sweeps.points import SceneBuilder, chunks_of, require_scenes
from granular.sweeps.store import Store
from granular.units import shown

if TYPE_CHECKING:
    import xarray as xr

Advanced = Callable[[str, int, int], None]
"""Told what is being done, how many more points it has been done for, and how many there are."""

ERROR, NAN = "error", "nan"
"""What becomes of a point that is refused: the sweep stops there, or the point stays empty."""


@dataclass(frozen=True, slots=True)
class Ran:
    """A sweep that is finished.

    Attributes
    ----------
    dataset : xarray.Dataset
        Its numbers.
    chunks, found : int
        How many chunks it has, and how many of them were finished already.
    """

    dataset: xr.Dataset
    chunks: int
    found: int


def sweep(
    scene: str | os.PathLike[str] | Mapping[str, Any] | Scene | Sweep,
    *,
    grid: Mapping[str, object] | None = None,
    together: Mapping[str, object] | None = None,
    outputs: Sequence[str] | None = None,
    engine: str = EVALUATE,
    route: str = "auto",
    chunk: int | None = None,
    out: str | os.PathLike[str] | None = None,
    invalid: str = ERROR,
    workers: int | None = None,
    scheduler: str | None = None,
    large: bool = False,
) -> xr.Dataset:
    """Evaluate a scene over grids and lists of its fields.

    Parameters
    ----------
    scene : str, path-like, dict, Scene or Sweep
        What all points share: a scene, or its tables, which may lack what the sweep varies. A path is a sweep file,
        which says all up to ``chunk`` itself.
    grid : dict, optional
        Field, such as ``"stress.ratio"`` -> its values: a list or an array [SI], strings with units, or a range
        ``{"start": ..., "stop": ..., "num": ..., "spacing": "linear"}`` (or ``"log"``). Each is a dimension.
    together : dict, optional
        The same for fields that vary together, all with equally many values, along the dimension ``case``.
    outputs : sequence of str, optional
        What is kept of every point: stiffness, mandel, ratios, reference_stiffness, engineering, waves,
        relative_error, route, effects, evaluations.
    engine : "evaluate" or "axial_stiffness"
        Scene by scene with a plan for each; or arrays of axial fabrics with all effects, which is faster by far.
    route : str
        "auto", or the route of all points.
    chunk : int, optional
        Most points of a chunk [-], which is computed and stored at once.
    out : path-like, optional
        Folder of the Zarr store; one that holds a part of the same sweep is gone on with. Nothing is stored without.
    invalid : "error" or "nan"
        Whether a refused point stops the sweep, or stays empty, with its code in the variable ``refusal``.
    workers : int, optional
        Processes on this machine [-]; by default this one, and one a core where it would take long.
    scheduler : str, optional
        Address of a dask scheduler, such as ``"tcp://10.0.0.1:8786"``.
    large : bool
        Whether more than a million points are meant.

    Returns
    -------
    xarray.Dataset
        Dimensions named by the fields; all variables in SI units, which stand in their attributes.

    Raises
    ------
    UnknownKey, WrongType, ValueOutOfRange, UnknownChoice, ConflictingKeys, MissingKey
        A field, value or option that cannot be right; points are named.
    SweepEmpty, SweepTooLarge
        There is no point, or there are more than a million and the sweep is not called large.
    SweepFolderTaken, OutputUnwritable
        The folder holds something else, or cannot be written.
    SchedulerUnreachable, WorkersUnusable
        The scheduler does not answer; or workers are lost, or would compute other bits.
    SweepLibraryMissing
        xarray, Zarr or dask is not installed.
    GranularError
        A point is refused; it is named.

    Notes
    -----
    Accuracy: that of every point by itself, see ``relative_error``. The same bits whatever the number of workers.
    Source: ``granular.evaluate`` and ``granular.axial_stiffness``.

    Examples
    --------
    >>> base = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744},
    ...         "stress": {"mean": "28 kPa"}}
    >>> dataset = sweep(base, grid={"packing.contact_normals.D33": [0.0, 0.3]}, outputs=["ratios"])
    >>> [round(value, 4) for value in dataset.C1111_over_C3333.values.tolist()]
    [1.0, 0.8552]
    """
    if isinstance(scene, Sweep | str | os.PathLike):
        if grid is not None or together is not None or outputs is not None or chunk is not None:
            raise BadOption("grid, together, outputs or chunk with a sweep that has its own",
                            allowed="allowed with a scene or its tables", remedy="Write them into the sweep.")
        defined = scene if isinstance(scene, Sweep) else Sweep.from_toml(scene)
    else:
        defined = Sweep.of(scene, grid=grid, together=together, outputs=outputs, engine=engine, route=route,
                           chunk=chunk)
    return run_sweep(defined, out=None if out is None else Path(out), invalid=invalid, workers=workers,
                     scheduler=scheduler, large=large).dataset


def run_sweep(sweep: Sweep, *, out: Path | None = None, invalid: str = ERROR, workers: int | None = None,
              scheduler: str | None = None, large: bool = False,
              advanced: Advanced = lambda what, more, of: None) -> Ran:
    """Run a sweep that has been read.

    Parameters
    ----------
    sweep : Sweep
        The sweep.
    out : Path, optional
        Folder of the store.
    invalid, workers, scheduler, large
        As for :func:`sweep`.
    advanced : callable
        Told how far it is.

    Returns
    -------
    Ran
        The dataset, and how much of it was finished already.

    Raises
    ------
    GranularError
        As :func:`sweep`.

    Notes
    -----
    Accuracy and source: :func:`sweep`.
    """
    from granular.sweeps.workers import reached, refuse_inside_a_worker

    refuse_inside_a_worker()
    require_libraries()
    chosen(invalid, (ERROR, NAN), name="invalid")
    _require_workers(workers, scheduler)
    sweep.require_size(large=large)
    with reached(scheduler) as client:
        return _run(sweep, out, keep_going=invalid == NAN, workers=workers, client=client, advanced=advanced)


def _run(sweep: Sweep, out: Path | None, *, keep_going: bool, workers: int | None, client: Any,
         advanced: Advanced) -> Ran:
    from granular.sweeps.workers import computed

    points, chunks = sweep.points, chunks_of(sweep.shape, sweep.chunk_shape)
    if sweep.engine == ARRAYS:
        require_array_scene(SceneBuilder(points.base).scene(points.at(0)))
    require_scenes(points, keep_going=keep_going, advanced=lambda more: advanced("Checking", more, points.count))
    target = Memory(sweep) if out is None else Store(sweep, out)
    try:
        found = len(target.finished)
        tasks = {number: partial(Task, points.part(here), sweep.outputs, sweep.engine, sweep.route, keep_going)
                 for number, here in enumerate(chunks) if number not in target.finished}
        advanced("Computing", sum(points.part(chunks[number]).count for number in target.finished), points.count)
        for number, block in computed(tasks, workers=workers, client=client):
            target.put(number, block)
            advanced("Computing", points.part(chunks[number]).count, points.count)
    finally:
        target.close()
    return Ran(target.dataset(), len(chunks), found)


def _require_workers(workers: int | None, scheduler: str | None) -> None:
    if workers is None:
        return
    if scheduler is not None:
        raise BadOption("workers and scheduler are both given",
                        allowed="allowed one of the two, for a scheduler has workers of its own",
                        remedy="Leave one of them out.")
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise BadOption(f"workers = {shown(workers)}", allowed="allowed a whole number from 1",
                        remedy="Leave it out for as many as there are cores.")
