"""Sweeps on disk: whatever the moment at which a process dies, the same command ends with the same bytes."""

from __future__ import annotations

import resource
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import granular
from granular.errors import OutputUnwritable, SweepFolderTaken, SweepLibraryMissing
from granular.sweeps import Sweep
from granular.sweeps.run import run_sweep
from granular.sweeps.store import LEDGER, Store

BASE = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744},
        "stress": {"mean": "28 kPa"}}
SWEEP = Sweep.of(BASE, grid={"branches.anisotropy.D33": [-0.3, -0.1, 0.0, 0.2],
                             "model.hypothesis": ["kinematic", "static"]},
                 together={"packing.contact_normals.D33": [0.0, 0.0, 0.3],
                           "model.effects": ["auto", ["branches"], "auto"]},
                 outputs=["stiffness", "route", "effects", "evaluations"], chunk=6)
CHUNKS = 4


class Killed(BaseException):
    """Stands for kill -9: no handler of ordinary errors sees it."""


def files(folder: Path) -> dict[str, bytes]:
    """Every file of a store with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file()}


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    """The store of a run that nobody disturbed."""
    folder = tmp_path_factory.mktemp("whole") / "sweep"
    ran = run_sweep(SWEEP, out=folder)
    assert (ran.chunks, ran.found) == (CHUNKS, 0)
    return folder


def test_the_store_is_what_memory_would_hold(whole):
    # Breaks when a chunk is written to another place, or xarray alone cannot read the store.
    held = granular.sweep(SWEEP)
    with granular.open_sweep(whole) as ours, xr.open_zarr(whole) as plain:
        assert ours.identical(held)
        assert plain.load().equals(held)
        assert ours.C1111.chunks == ((1,) * 4, (2,) * 1, (3,))
        assert list(ours.data_vars) == list(held.data_vars)
    assert not (whole / LEDGER).exists()


def die_at(monkeypatch, owner, name: str, call: int, *, after: bool) -> None:
    """Let the process die at some call of a function, before or after the function has done its work."""
    function, seen = getattr(owner, name), Counter()

    def dying(*arguments, **options):
        seen[name] += 1
        if seen[name] == call and not after:
            raise Killed
        result = function(*arguments, **options)
        if seen[name] == call:
            raise Killed
        return result

    monkeypatch.setattr(owner, name, dying)


def half_a_line(self, line: str) -> None:
    """Record half a line of the ledger, and die."""
    self._ledger.write(line[:len(line) // 2])
    self._ledger.flush()
    raise Killed


VARIABLES = 10  # six components, route, effects, evaluations, refusals
MOMENTS = [
    ("metadata begins", xr.Dataset, "to_zarr", 1, False), ("metadata is written", xr.Dataset, "to_zarr", 1, True),
    ("store is complete beside its place", Path, "rename", 1, False), ("store stands", Path, "rename", 1, True),
    ("first variable of the first chunk", Store, "_place", 1, True),
    ("third variable of the second chunk", Store, "_place", VARIABLES + 3, True),
    ("last variable of the last chunk", Store, "_place", VARIABLES * CHUNKS, True),
    ("before a chunk is recorded", Store, "_record", 2, False), ("a chunk is recorded", Store, "_record", 2, True),
    ("all chunks are recorded", Store, "_record", CHUNKS, True),
    ("store says that it is complete", Store, "_drop_ledger", 1, False),
    ("ledger is gone", Store, "_drop_ledger", 1, True),
]


@pytest.mark.parametrize(("owner", "name", "call", "after"), [moment[1:] for moment in MOMENTS],
                         ids=[moment[0] for moment in MOMENTS])
def test_whenever_it_dies_it_ends_with_the_same_bytes(owner, name, call, after, whole, tmp_path, monkeypatch):
    # Breaks when a chunk counts as finished too early, something half-written stays, or the order of files matters.
    out = tmp_path / "sweep"
    with monkeypatch.context() as patched, pytest.raises(Killed):
        die_at(patched, owner, name, call, after=after)
        run_sweep(SWEEP, out=out)
    finished = {"_record": call - 1 + after, "_place": (call - 1) // VARIABLES, "_drop_ledger": CHUNKS}.get(name, 0)
    ran = run_sweep(SWEEP, out=out)
    assert ran.found == finished
    assert files(out) == files(whole)
    assert list(tmp_path.iterdir()) == [out]


def test_half_a_line_of_the_ledger_counts_for_nothing(whole, tmp_path, monkeypatch):
    # Breaks when the next line is written behind what is left of the last one.
    out = tmp_path / "sweep"
    with monkeypatch.context() as patched, pytest.raises(Killed):
        patched.setattr(Store, "_record", half_a_line)
        run_sweep(SWEEP, out=out)
    with monkeypatch.context() as patched, pytest.raises(Killed):
        die_at(patched, Store, "_record", 2, after=True)
        assert run_sweep(SWEEP, out=out).found == 0
    assert run_sweep(SWEEP, out=out).found == 2
    assert files(out) == files(whole)


def test_files_that_were_cut_short_are_computed_again(whole, tmp_path, monkeypatch):
    # Breaks when the ledger is believed without looking: a machine without power may lose files that were closed.
    out = tmp_path / "sweep"
    with monkeypatch.context() as patched, pytest.raises(Killed):
        die_at(patched, Store, "_record", 3, after=True)
        run_sweep(SWEEP, out=out)
    cut, gone, stray = out / "C1111/c/0/0/0", out / "route/c/1/0/0", out / "C1111/c/0/0/0.abc.partial"
    cut.write_bytes(cut.read_bytes()[:-3])
    gone.unlink()
    stray.write_bytes(b"half")
    assert run_sweep(SWEEP, out=out).found == 1
    assert files(out) == files(whole)


def test_a_complete_store_is_not_computed_again(whole, monkeypatch):
    # Breaks when a second call writes anything.
    before = files(whole)
    monkeypatch.setattr("granular.sweeps.engine.Task.compute", lambda self: pytest.fail("computed"))
    assert run_sweep(SWEEP, out=whole).found == CHUNKS
    assert files(whole) == before


def test_a_folder_with_anything_else_is_left_alone(whole, tmp_path):
    # Breaks when a sweep writes among the files of somebody else, or into another sweep.
    (tmp_path / "notes").mkdir()
    (tmp_path / "notes" / "mine.txt").write_text("mine", "utf-8")
    with pytest.raises(SweepFolderTaken, match="holds no sweep"):
        run_sweep(SWEEP, out=tmp_path / "notes")
    with pytest.raises(SweepFolderTaken, match="is no folder"):
        run_sweep(SWEEP, out=tmp_path / "notes" / "mine.txt")
    other = Sweep.of(BASE, grid={"stress.ratio": [1.0, 1.5]})
    with pytest.raises(SweepFolderTaken, match="another sweep"):
        run_sweep(other, out=whole)
    with pytest.raises(SweepFolderTaken, match="holds no sweep"):
        granular.open_sweep(tmp_path)
    (tmp_path / "empty").mkdir()
    assert run_sweep(other, out=tmp_path / "empty").found == 0


def test_numbers_of_another_version_are_not_gone_on_with(whole, monkeypatch):
    # Breaks when one store holds the numbers of two versions.
    from granular.sweeps import store

    monkeypatch.setattr(store, "fingerprint", lambda: {"granular_source_sha256": "another"})
    with pytest.raises(SweepFolderTaken, match="granular_source_sha256"):
        run_sweep(SWEEP, out=whole)


def test_one_process_writes_at_a_time(tmp_path, monkeypatch):
    # Breaks when two runs of one command write into each other's chunks.
    out = tmp_path / "sweep"
    with monkeypatch.context() as patched, pytest.raises(Killed):
        die_at(patched, Store, "_record", 1, after=True)
        run_sweep(SWEEP, out=out)
    first = Store(SWEEP, out)
    with pytest.raises(SweepFolderTaken, match="another process"):
        run_sweep(SWEEP, out=out)
    first.close()
    assert run_sweep(SWEEP, out=out).found == 1


def test_a_full_disk_keeps_what_is_finished(whole, tmp_path, monkeypatch):
    # Breaks when the chunk under way counts as finished, or the refusal hides what the system said.
    out, record = tmp_path / "sweep", Store._record
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)

    def filling(self, line: str) -> None:
        record(self, line)
        if len(self.finished) == 1:
            resource.setrlimit(resource.RLIMIT_FSIZE, (16, hard))

    with monkeypatch.context() as patched:
        patched.setattr(Store, "_record", filling)
        try:
            with pytest.raises(OutputUnwritable, match="file too large"):
                run_sweep(SWEEP, out=out)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert run_sweep(SWEEP, out=out).found == 2
    assert files(out) == files(whole)


def test_what_cannot_fit_is_refused_before_it_begins(tmp_path, monkeypatch):
    # Breaks when the disk is full only after hours.
    monkeypatch.setattr("shutil.disk_usage", lambda path: type("usage", (), {"free": 100}))
    with pytest.raises(OutputUnwritable, match=r"100 bytes left, needed: [\d,]+ bytes"):
        run_sweep(SWEEP, out=tmp_path / "sweep")
    assert not list(tmp_path.iterdir())


def test_a_folder_that_does_not_exist_is_told(tmp_path):
    # Breaks when the system's own error comes through.
    with pytest.raises(OutputUnwritable, match="no such file"):
        run_sweep(SWEEP, out=tmp_path / "missing" / "sweep")


def test_gradation_curves_are_found_beside_the_scene_and_known_by_content(tmp_path, monkeypatch):
    # Breaks when a curve is looked for from the working directory, or may change under an unfinished sweep.
    curve = tmp_path / "curve.csv"
    curve.write_text("size [mm], fraction finer\n2, 1\n1, 0.4\n0.5, 0\n", "utf-8")
    file = tmp_path / "sweep.toml"
    file.write_text("""
        [grains]
        shear_modulus = "31 GPa"
        poisson_ratio = 0.21
        [packing]
        void_ratio = 0.6
        [stress]
        mean = "28 kPa"
        [gradation]
        distribution = "curve"
        file = "curve.csv"
        [sweep.grid]
        stress.ratio = [1.0, 1.5]
        """, "utf-8")
    monkeypatch.chdir("/")
    first = Sweep.from_toml(file).content()
    assert len(first["files"]["curve.csv"]) == 64
    assert granular.sweep(file, out=tmp_path / "sweep").C1111.attrs["units"] == "Pa"
    curve.write_text(curve.read_text("utf-8").replace("0.4", "0.5"), "utf-8")
    assert Sweep.from_toml(file).content() != first
    with pytest.raises(SweepFolderTaken):
        granular.sweep(file, out=tmp_path / "sweep")


def test_libraries_that_are_missing_are_named(monkeypatch):
    # Breaks when Python's own error comes through.
    monkeypatch.setitem(__import__("sys").modules, "zarr", None)
    with pytest.raises(SweepLibraryMissing, match="zarr"):
        granular.sweep(BASE, grid={"stress.ratio": [1.0]})


def test_texts_and_numbers_survive_the_way_to_disk(whole):
    # Breaks when a type changes between memory and disk.
    with granular.open_sweep(whole) as dataset:
        assert dataset.route.values[0, 0, 1] == "closed_form"
        assert dataset.evaluations.dtype == np.int64
        assert dataset.simulated.dtype == bool
        assert dataset["model.hypothesis"].values.tolist() == ["kinematic", "static"]
