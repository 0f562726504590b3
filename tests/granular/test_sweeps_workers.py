"""Workers: the same bytes whoever computes, kill -9 and Ctrl-C for real, and schedulers that do not serve."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import dask
import pytest
from dask.distributed import LocalCluster

import granular
from granular.errors import BadOption, ComplianceInfinite, SchedulerUnreachable, WorkersUnusable
from granular.sweeps import Sweep, workers
from granular.sweeps.provenance import fingerprint
from granular.sweeps.run import run_sweep
from granular.sweeps.store import LEDGER

FILE = """
scene = "{scene}"
[sweep.grid]
packing.contact_normals.D33 = {{ start = -0.3, stop = 0.6, num = 10 }}
stress.ratio = [1.0, 1.2, 1.4, 1.6, 1.8, 2.0]
[sweep.run]
outputs = ["ratios", "effects"]
chunk = 3
"""
SCENE = Path(granular.__file__).parent / "data" / "scenes" / "table_v_2.toml"
CHUNKS = 20
HERE = "127.0.0.1"


def files(folder: Path) -> dict[str, bytes]:
    """Every file of a store with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file()}


@pytest.fixture(scope="module")
def file(tmp_path_factory) -> Path:
    """A sweep whose points slip and slide, which takes long enough to be disturbed."""
    path = tmp_path_factory.mktemp("definition") / "sweep.toml"
    path.write_text(FILE.format(scene=SCENE.as_posix()), "utf-8")
    return path


@pytest.fixture(scope="module")
def whole(file, tmp_path_factory) -> dict[str, bytes]:
    """The store as one process writes it that nobody disturbs."""
    folder = tmp_path_factory.mktemp("whole") / "sweep"
    assert run_sweep(Sweep.from_toml(file), out=folder, workers=1).chunks == CHUNKS
    return files(folder)


def started(*arguments: object) -> subprocess.Popen[str]:
    """The command line in a process and a process group of its own, as a terminal starts it."""
    return subprocess.Popen([sys.executable, "-m", "granular", "sweep", *map(str, arguments)], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def wait_for_chunks(process: subprocess.Popen[str], out: Path, count: int) -> None:
    """Wait until the ledger holds some chunks; a process that ends before that failed."""
    while process.poll() is None:
        if (out / LEDGER).exists() and len((out / LEDGER).read_text("ascii").splitlines()) >= count:
            return
        time.sleep(0.002)
    pytest.fail(process.communicate()[1])


def wait_until_gone(group: int) -> None:
    """Wait until no process of a group is left; those that were told to stop need a moment."""
    for _ in range(1000):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.03)
    pytest.fail("some processes go on")


def test_kill_9_costs_one_chunk_at_the_most(file, whole, tmp_path):
    # Breaks when a killed process leaves half a store, or what it had finished is computed again.
    out = tmp_path / "sweep"
    process = started(file, "--out", out, "--workers", 1)
    wait_for_chunks(process, out, 2)
    process.kill()
    process.communicate()
    assert process.returncode == -signal.SIGKILL
    lines = (out / LEDGER).read_text("ascii").count("\n")
    ran = run_sweep(Sweep.from_toml(file), out=out, workers=1)
    assert 2 <= lines == ran.found < CHUNKS
    assert files(out) == whole


def test_ctrl_c_stops_all_processes_in_one_sentence(file, whole, tmp_path):
    # Breaks when workers print where they were, go on without their master, or finished chunks are lost.
    out = tmp_path / "sweep"
    process = started(file, "--out", out, "--workers", 2)
    wait_for_chunks(process, out, 1)
    os.killpg(process.pid, signal.SIGINT)
    printed, told = process.communicate()
    assert (process.returncode, printed) == (130, "")
    assert told.strip() == f"Stopped; what is finished is kept in {out}. The same command goes on from there."
    wait_until_gone(process.pid)
    assert run_sweep(Sweep.from_toml(file), out=out, workers=1).found >= 1
    assert files(out) == whole


@pytest.fixture(scope="module")
def cluster():
    """A scheduler whose worker is a process of its own; it gives up a chunk with the first worker that is lost."""
    with (dask.config.set({"distributed.scheduler.allowed-failures": 0}),
          LocalCluster(n_workers=1, threads_per_worker=2, host=HERE, dashboard_address=f"{HERE}:0") as started_cluster):
        yield started_cluster


def test_a_scheduler_gives_the_same_bytes(file, whole, cluster, tmp_path):
    # Breaks when a number, or a file, depends on who computed it or in which order.
    ran = run_sweep(Sweep.from_toml(file), out=tmp_path / "sweep", scheduler=cluster.scheduler_address)
    assert (ran.found, ran.chunks) == (0, CHUNKS)
    assert files(tmp_path / "sweep") == whole


def test_a_refusal_comes_back_from_a_worker(cluster):
    # Breaks when it arrives as something else, or without its point.
    scene = granular.Scene.from_toml(SCENE)
    with pytest.raises(ComplianceInfinite, match=r'point stress\.ratio = 3\.0, model\.hypothesis = "static": '):
        granular.sweep(scene, grid={"stress.ratio": [3.0], "model.hypothesis": ["kinematic", "static"]},
                       scheduler=cluster.scheduler_address)


def test_a_worker_that_dies_is_told(file, cluster, tmp_path, monkeypatch):
    # Breaks when dask's own error comes through, or the sweep waits for ever.
    monkeypatch.setattr(workers, "_answer", die)
    with pytest.raises(WorkersUnusable, match="finished chunks are kept"):
        run_sweep(Sweep.from_toml(file), out=tmp_path / "sweep", scheduler=cluster.scheduler_address)


def die(task) -> None:
    """Kill the worker that computes this."""
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "tpc://127.0.0.1:8786", "nowhere", "tcp://127.0.0.1"])
def test_a_scheduler_that_does_not_answer_is_told_before_anything_is_written(address, file, tmp_path):
    # Breaks when minutes pass first, or a folder is left behind.
    with pytest.raises(SchedulerUnreachable, match="--scheduler"):
        run_sweep(Sweep.from_toml(file), out=tmp_path / "sweep", scheduler=address)
    assert not list(tmp_path.iterdir())


def test_a_scheduler_without_workers_is_told(file, monkeypatch):
    # Breaks when the sweep waits for ever.
    monkeypatch.setattr(workers, "PATIENCE", 1.0)
    with (LocalCluster(n_workers=0, processes=False, host=HERE, protocol="tcp", dashboard_address=f"{HERE}:0") as empty,
          pytest.raises(SchedulerUnreachable, match="no workers")):
        run_sweep(Sweep.from_toml(file), scheduler=empty.scheduler_address)


def test_workers_that_would_compute_other_bits_are_refused():
    # Breaks when a store holds numbers of two versions.
    workers.require_same_bits(fingerprint())
    with pytest.raises(WorkersUnusable, match=r"python = '2\.7\.18'"):
        workers.require_same_bits(fingerprint() | {"python": "2.7.18"})


def test_other_processes_are_started_only_where_much_is_left(monkeypatch):
    # Breaks when a short sweep waits for processes, or a long one computes alone.
    asked = []

    @contextmanager
    def local(processes):
        asked.append(processes)
        yield "client"

    monkeypatch.setattr(workers, "_local", local)
    monkeypatch.setattr(workers, "_on", lambda client, left: workers._here(left))
    monkeypatch.setattr(workers, "_cores", lambda: 4)
    sweep = Sweep.of({"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.6}},
                     grid={"stress.mean": [1e3, 1e4, 1e5, 1e6, 1e7]}, outputs=["ratios"], chunk=1)
    monkeypatch.setattr(workers, "WORTH", 1e9)
    run_sweep(sweep)
    assert asked == []
    monkeypatch.setattr(workers, "WORTH", 0.0)
    run_sweep(sweep)
    assert asked == [4]
    run_sweep(sweep, workers=3)
    assert asked == [4, 3]


def test_a_script_without_a_guard_is_told(monkeypatch):
    # Breaks when every worker starts the sweep again, which makes more workers without end.
    import multiprocessing

    monkeypatch.setattr(multiprocessing.current_process(), "_inheriting", True, raising=False)
    with pytest.raises(WorkersUnusable, match="__main__"):
        granular.sweep({}, grid={"stress.ratio": [1.0]})


def test_the_command_line_says_what_it_did(file, whole, tmp_path, capsys):
    # Breaks when a count or a variable is wrong, or progress goes to standard output.
    from granular.commands import run_command

    out = tmp_path / "sweep"
    assert run_command(["sweep", str(file), "--out", str(out), "--workers", "1"]) == 0
    printed = capsys.readouterr().out
    assert printed == (
        f"Wrote {out}: 60 points in 20 chunks\n  10 packing.contact_normals.D33 x 6 stress.ratio\n"
        f"  C1111_over_C3333, C2323_over_C1212, simulated, refusal\nOpen it with granular.open_sweep(\"{out}\")\n")
    assert files(out) == whole
    assert run_command(["sweep", str(file), "--out", str(out)]) == 0
    assert "20 of them finished before" in capsys.readouterr().out
    with pytest.raises(BadOption, match="--workers"):
        run_command(["sweep", str(file), "--out", str(out), "--workers", "two"])
