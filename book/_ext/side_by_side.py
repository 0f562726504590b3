"""Compute the pages side by side before they are read: as many at a time as there are cores, a kernel for each.

MyST-NB computes a page where it reads it, one page after another. Here every page that is missing in the execution
cache is computed beforehand and put there; MyST-NB then finds all outputs as if it had computed them in an earlier
build. No page shares a kernel with another, so none can depend on what another one did.
"""

from __future__ import annotations

import asyncio
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn
from myst_nb.core.read import create_nb_reader
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbformat import NotebookNode
from sphinx.errors import ExtensionError
from sphinx.util import logging

if TYPE_CHECKING:
    from jupyter_cache.base import JupyterCacheAbstract
    from sphinx.application import Sphinx
    from sphinx.environment import BuildEnvironment

LOGGER = logging.getLogger(__name__)


@dataclass(frozen=True)
class Page:
    """A page with cells: its name, its file and, once computed, its notebook with outputs."""

    name: str
    path: Path
    notebook: NotebookNode
    seconds: float = 0.0
    failure: str = ""
    failed_cell: int = 0  # number in the notebook

    def line(self) -> int:
        """Line of the file at which the source of the failed cell starts."""
        return int(self.notebook.metadata.source_map[self.failed_cell]) + 1


class Told(Protocol):
    """What is told whenever a page is done."""

    def __call__(self, page: Page) -> None: ...


def cores() -> int:
    """How many pages to compute at a time: the cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


async def compute(page: Page, *, timeout: int, free: asyncio.Semaphore) -> Page:
    """Run the cells of a page in a kernel of their own, in the folder of the page, as soon as a core is free."""
    reached = [0]
    client = NotebookClient(page.notebook, timeout=timeout, record_timing=False,
                            resources={"metadata": {"path": str(page.path.parent)}},
                            on_cell_start=lambda cell, cell_index: reached.__setitem__(0, cell_index))
    failure = ""
    async with free:
        begun = time.monotonic()
        try:
            await client.async_execute()
        except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
            failure = str(error)
        return replace(page, seconds=time.monotonic() - begun, failure=failure, failed_cell=reached[0])


def missing_pages(env: BuildEnvironment, names: list[str], cache: JupyterCacheAbstract) -> Iterator[Page]:
    """The pages with cells, out of those to be read, whose outputs are not in the cache."""
    configurations: Any = env  # MyST keeps its own two settings there
    for name in names:
        path = Path(env.doc2path(name))
        text = path.read_text(encoding="utf-8")
        reader = create_nb_reader(str(path), configurations.myst_config, configurations.mystnb_config, text)
        if reader is None:
            continue
        notebook = reader.read(text)
        try:
            cache.match_cache_notebook(notebook)
        except KeyError:
            yield Page(name, path, notebook)


async def compute_all(pages: list[Page], cache: JupyterCacheAbstract, *, timeout: int, told: Told) -> list[Page]:
    """Compute pages, keep those that succeed in the cache, and return those that fail."""
    failed = []
    free = asyncio.Semaphore(cores())
    tasks = [asyncio.create_task(compute(page, timeout=timeout, free=free)) for page in pages]  # begun in this order
    for done in asyncio.as_completed(tasks):
        page = await done
        if page.failure:
            failed.append(page)
        else:
            cache.cache_notebook_bundle(
                CacheBundleIn(page.notebook, str(page.path), data={"execution_seconds": page.seconds}),
                check_validity=False, overwrite=True)
        told(page)
    return failed


@contextmanager
def progress(total: int) -> Iterator[Told]:
    """Show on standard error which page is done and how many are left: a bar on a screen, lines in a log."""
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    console = Console(stderr=True, highlight=False)
    with Progress(*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn(), console=console,
                  transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("Computing pages", total=total)
        left = total

        def told(page: Page) -> None:
            nonlocal left
            left -= 1
            bar.update(task, advance=1)
            result = "failed" if page.failure else "computed"
            bar.console.print(f"{page.name} {result} in {page.seconds:.0f} s, {left} left", soft_wrap=True)

        yield told


def compute_before_reading(app: Sphinx, env: BuildEnvironment, names: list[str]) -> None:
    """Fill the cache for the pages about to be read; stop the build when a cell fails."""
    settings: Any = app.config
    cache = get_cache(settings.nb_execution_cache_path)
    pages = list(missing_pages(env, names, cache))
    if not pages:
        return
    with progress(len(pages)) as told:
        failed = asyncio.run(compute_all(pages, cache, timeout=settings.nb_execution_timeout, told=told))
    for page in failed:
        LOGGER.error(page.failure, location=(page.name, page.line()))
    if failed:
        raise ExtensionError(f"cells failed on {', '.join(sorted(page.name for page in failed))}")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("env-before-read-docs", compute_before_reading)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
