"""Who computes the chunks: this process, as many as the machine has cores, or the workers of a dask scheduler.

A chunk's numbers depend on its points alone, so that nothing here can change a bit; workers that would are refused.
"""

from __future__ import annotations

import logging
import multiprocessing
import os
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from multiprocessing import resource_tracker
from types import ModuleType
from typing import Any

from granular.errors import SchedulerUnreachable, WorkersUnusable
from granular.sweeps.engine import Block, Task
from granular.sweeps.provenance import fingerprint

WORTH = 10.0
"""Seconds of work left over from which starting other processes pays; they need some seconds to start."""

PATIENCE = 10.0
"""Seconds that a scheduler has to answer, and its first worker to show up."""

AHEAD = 2
"""Chunks given out for each thread of the workers, so that none waits and few are lost."""

Tasks = Mapping[int, Callable[[], Task]]
"""Number of a chunk -> what makes its task; made only when it is given out."""


def computed(tasks: Tasks, *, workers: int | None, client: Any = None) -> Iterator[tuple[int, Block]]:
    """Compute chunks, in the order in which they are finished.

    Parameters
    ----------
    tasks : dict
        The chunks to compute.
    workers : int or None
        Processes on this machine; by default this one, and all cores where enough is left to do.
    client : distributed.Client, optional
        Whose workers compute in place of this machine.

    Yields
    ------
    tuple
        Number of a chunk, and its numbers.

    Raises
    ------
    GranularError
        A point is refused, or the workers cannot be used.

    Notes
    -----
    Source: dask.distributed.
    """
    left = dict(tasks)
    if client is not None:
        yield from _on(client, left)
        return
    if workers is None:
        yield from _here(left, until_worth=min(_cores(), len(left)) > 1)
    processes = min(_cores() if workers is None else workers, len(left))
    if processes > 1:
        with _local(processes) as local:
            yield from _on(local, left)
    else:
        yield from _here(left)


def refuse_inside_a_worker() -> None:
    """Refuse to start a sweep in a process that is still importing the script of the one which started it.

    Raises
    ------
    WorkersUnusable
        The script calls the sweep when it is imported, as processes do that somebody else has started.
    """
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        raise WorkersUnusable("a sweep that is called when its script is imported",
                              allowed="allowed only behind a guard in a script that starts processes of its own",
                              remedy='Put the call under if __name__ == "__main__":, or say workers=1.')


def _here(left: dict[int, Callable[[], Task]], *, until_worth: bool = False) -> Iterator[tuple[int, Block]]:
    """Chunks computed by this process, all of them or until other processes are worth starting."""
    spent, done = 0.0, 0
    while left and not (until_worth and done and spent / done * len(left) > WORTH):
        number = next(iter(left))
        begun = time.perf_counter()
        block = left.pop(number)().compute()
        spent, done = spent + time.perf_counter() - begun, done + 1
        yield number, block


def _on(client: Any, left: dict[int, Callable[[], Task]]) -> Iterator[tuple[int, Block]]:
    """Chunks computed by the workers of a client."""
    from dask.distributed import CancelledError, KilledWorker, as_completed
    from distributed.comm.core import CommClosedError

    running, under_way = as_completed(loop=client.loop), dict[Any, int]()

    def give_out() -> None:
        ahead = AHEAD * max(1, sum(client.nthreads().values()))
        while left and len(under_way) < ahead:
            number = next(iter(left))
            future = client.submit(_answer, left.pop(number)(), pure=False)
            under_way[future] = number
            running.add(future)

    try:
        give_out()
        for future in running:
            block, other = future.result()
            number = under_way.pop(future)
            require_same_bits(other)
            give_out()
            yield number, block
    except (CancelledError, KilledWorker, CommClosedError, TimeoutError, ImportError, OSError) as error:
        raise WorkersUnusable(f"a chunk was lost with its worker ({' '.join(str(error).split())[:200]})",
                              allowed="needed: workers that stay, with this version of granular installed",
                              remedy="Look at their logs, then run the same sweep again; finished chunks are kept."
                              ) from None


def _answer(task: Task) -> tuple[Block, dict[str, str]]:
    """Compute a chunk somewhere, and say with what."""
    return task.compute(), fingerprint()


def require_same_bits(other: Mapping[str, str]) -> None:
    """Refuse what another process computed where it might have computed other bits.

    Parameters
    ----------
    other : dict
        Its fingerprint.

    Raises
    ------
    WorkersUnusable
        It differs from that of this process.

    Notes
    -----
    Source: :func:`granular.sweeps.provenance.fingerprint`.
    """
    for name, value in fingerprint().items():
        if other.get(name) != value:
            raise WorkersUnusable(f"a worker has {name} = {other.get(name)!r}, and here it is {value!r}",
                                  allowed="allowed only workers whose numbers have the same bits as those from here",
                                  remedy="Install the same versions there, or run the sweep on that machine.")


@contextmanager
def _local(processes: int) -> Iterator[Any]:
    """A client of that many processes on this machine."""
    from dask.distributed import Client, LocalCluster

    with ExitStack() as stack:
        stack.enter_context(_quiet())
        with _without_interrupt(), _without_script():
            try:
                cluster = stack.enter_context(LocalCluster(
                    n_workers=processes, threads_per_worker=1, processes=True, host="127.0.0.1",
                    dashboard_address="127.0.0.1:0", memory_limit=None, silence_logs=logging.CRITICAL))
                client = stack.enter_context(Client(cluster, set_as_default=False))
            except (OSError, RuntimeError, TimeoutError) as error:
                raise WorkersUnusable(
                    f"{processes} processes could not be started ({' '.join(str(error).split())[:200]})",
                    allowed="needed: memory and processes for as many", remedy="Say fewer, or workers=1.") from None
        yield client


@contextmanager
def reached(address: str | None) -> Iterator[Any]:
    """A client of a scheduler that answers and has workers; None where none is named.

    Parameters
    ----------
    address : str or None
        Address of the scheduler.

    Yields
    ------
    distributed.Client or None
        Connected as long as the context lasts.

    Raises
    ------
    SchedulerUnreachable
        Nothing answers there, or it has no workers.

    Notes
    -----
    Source: dask.distributed.
    """
    if address is None:
        yield None
        return
    from dask.distributed import Client

    with ExitStack() as stack:
        stack.enter_context(_quiet())
        try:
            _knock(address)
            client = stack.enter_context(Client(address, timeout=PATIENCE, set_as_default=False))
        except (OSError, TimeoutError, ValueError, RuntimeError) as error:
            reason = (error.strerror if isinstance(error, OSError) else None) or " ".join(str(error).split())
            raise _unreachable(address, reason[:120].lower()) from None
        with suppress(TimeoutError):
            client.wait_for_workers(1, timeout=PATIENCE)
        if not client.nthreads():
            raise _unreachable(address, "it has no workers")
        yield client


def _knock(address: str) -> None:
    """Fail at once where nothing listens; dask would go on asking until its time is up."""
    from distributed.comm.addressing import parse_address, parse_host_port

    protocol, place = parse_address(address)
    if protocol in ("tcp", "tls"):
        with socket.create_connection(parse_host_port(place), timeout=PATIENCE):
            pass


def _unreachable(address: str, reason: str) -> SchedulerUnreachable:
    return SchedulerUnreachable(f"--scheduler {address} ({reason})",
                                allowed="needed: a dask scheduler that answers, with a worker at least",
                                remedy="Start them with dask scheduler and dask worker, or leave the option out to "
                                       "compute on this machine.")


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep the logs of dask to itself: what matters in them becomes a refusal."""
    loggers = [logging.getLogger(name) for name in ("distributed", "distributed.client", "distributed.core",
                                                    "distributed.nanny", "distributed.scheduler")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


@contextmanager
def _without_interrupt() -> Iterator[None]:
    """Start processes that Ctrl-C does not reach: it is for this one to stop them. It arrives here afterwards."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # it unblocks the signal when it is started, and every process starts it
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _without_script() -> Iterator[None]:
    """Start processes that do not import the script of this one: nothing in it is needed to compute a chunk."""
    script = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = script


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
