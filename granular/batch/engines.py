"""How a block is run: by NumPy, or as a loop that numba compiles where it is installed."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Mapping
from enum import StrEnum
from importlib import import_module
from pathlib import Path
from types import FunctionType
from typing import Any

from granular.batch.kernel import BlockFunction, Kernel
from granular.errors import UnknownChoice

COMPILE_FROM = 1 << 21
"""Elements, in one call or in all calls so far, from which loading the compiler pays: it takes as long as one to ten
million elements by NumPy. Afterwards every size is compiled."""


class Engine(StrEnum):
    """How blocks are run: the first two give the same bits, the third is free to fuse multiplications and additions.

    Fused, a product is not rounded before something is added to it. That is faster and no less accurate, but the last
    bits then depend on what the processor can do, so that it runs only where it is named.
    """

    NUMPY = "numpy"
    COMPILED = "compiled"
    FUSED = "fused"


CONTRACT = {"contract"}
"""What numba is free to do for ``FUSED``: nothing but to fuse."""

_compiled: dict[tuple[BlockFunction, Engine], BlockFunction] = {}
_evaluated: dict[BlockFunction, int] = {}


def choose_engine(kernel: Kernel, size: int, wanted: Engine | str | None = None) -> Engine:
    """Decide how a kernel is run.

    Parameters
    ----------
    kernel : Kernel
        What is computed.
    size : int
        Number of elements [-].
    wanted : Engine or str, optional
        What the caller names; None leaves the choice.

    Returns
    -------
    Engine
        The wanted one; otherwise compiled where numba is installed and this process has had, or now has, many elements
        for the kernel.

    Raises
    ------
    UnknownChoice
        Another engine, or one that is compiled without numba.

    Notes
    -----
    Elements are counted, so that many calls with few elements are compiled in the end. Source: measured.

    Examples
    --------
    >>> from granular.batch.constant import KINEMATIC
    >>> choose_engine(KINEMATIC, 10, "numpy").value
    'numpy'
    """
    engine = engine_named(wanted)
    if engine is not None:
        return engine
    loop = kernel.loop()
    if (loop, Engine.COMPILED) in _compiled:
        return Engine.COMPILED
    _evaluated[loop] = _evaluated.get(loop, 0) + size
    return Engine.COMPILED if _evaluated[loop] >= COMPILE_FROM and compiler_installed() else Engine.NUMPY


def engine_named(name: Engine | str | None) -> Engine | None:
    """The engine of a name.

    Parameters
    ----------
    name : Engine or str or None
        What was given; None leaves the choice.

    Returns
    -------
    Engine or None
        The engine, None for None.

    Raises
    ------
    UnknownChoice
        Another name, or one that is compiled without numba.

    Examples
    --------
    >>> engine_named("numpy").name
    'NUMPY'
    """
    if name is None:
        return None
    try:
        engine = Engine(name)
    except ValueError:
        known = ", ".join(repr(choice.value) for choice in Engine)
        raise UnknownChoice(f"engine = {name!r}", allowed=f"allowed: {known}",
                            remedy="Leave engine out, or name one of these.") from None
    if engine is not Engine.NUMPY and not compiler_installed():
        raise UnknownChoice(f"engine = {engine.value!r} without numba", allowed="allowed: 'numpy'",
                            remedy="Leave engine out, or install numba, as the extra granular[fast] does.")
    return engine


def compiler_installed() -> bool:
    """Whether numba is there and can be loaded, which this does.

    Returns
    -------
    bool
        False where it is not installed, or not for this version of NumPy.

    Notes
    -----
    Source: the import system.
    """
    if sys.modules.get("numba"):
        return True
    try:
        import_module("numba")
    except ImportError:
        return False
    return True


def block_function(kernel: Kernel, engine: Engine) -> BlockFunction:
    """The block function of a kernel, ready to be called.

    Parameters
    ----------
    kernel : Kernel
        What is computed.
    engine : Engine
        How.

    Returns
    -------
    callable
        As the package describes it.

    Notes
    -----
    Source: the kernel.
    """
    if engine is Engine.NUMPY:
        return kernel.array()
    key = kernel.loop(), engine
    if key not in _compiled:
        _compiled[key] = _compile(kernel, fused=engine is Engine.FUSED)
    return _compiled[key]


def _compile(kernel: Kernel, *, fused: bool) -> BlockFunction:
    """Compile for read-only inputs, so that no kind of argument makes numba compile once more."""
    import numba
    from numba import types

    named = _with_helpers(kernel, fused=fused)
    read = [types.Array(types.float64, 1, "C", readonly=True)] * len(kernel.inputs)
    tables = [types.Array(types.float64, table.ndim, "C", readonly=True) for table in kernel.tables]
    signature = types.int64(*read, *tables, types.Array(types.float64, 1, "C"), types.boolean)
    free = CONTRACT if fused else False
    try:
        made: BlockFunction = numba.njit(signature, cache=True, nogil=True, fastmath=free, error_model="numpy")(named)
    except RuntimeError:  # there is no place to keep what was compiled
        made = numba.njit(signature, nogil=True, fastmath=free, error_model="numpy")(named)
    return made


def _with_helpers(kernel: Kernel, *, fused: bool) -> BlockFunction:
    """A copy of the loop of a kernel that calls compiled helpers, under a name that tells what it was made of.

    What numba keeps on disk it finds by the name of a function and the date of its own file: without this a helper
    that changes in another file, or the other way of compiling, would go unnoticed.
    """
    import numba

    from granular.batch import compiled_rows

    loop, helpers, exact = kernel.loop(), kernel.helpers(), kernel.exact_helpers()
    known: dict[str, object] = {**compiled_rows.row_functions()}
    for helper in helpers:
        free = fused and helper not in exact
        known[helper.__name__] = numba.njit(fastmath=CONTRACT if free else False, error_model="numpy", nogil=True)(
            copy_knowing(helper, helper.__name__, known))
    files = {helper.__code__.co_filename for helper in helpers if isinstance(helper, FunctionType)}
    files.add(compiled_rows.__file__)
    digest = hashlib.sha256(b"".join(Path(file).read_bytes() for file in sorted(files))).hexdigest()[:16]
    return copy_knowing(loop, "_".join([loop.__name__, digest, *(["fused"] if fused else [])]), known)


def copy_knowing(function: Callable[..., Any], name: str, known: Mapping[str, object]) -> Callable[..., Any]:
    """Copy a function so that it finds other functions under the names that it calls.

    Parameters
    ----------
    function : callable
        A plain function.
    name : str
        Name of the copy.
    known : mapping
        Functions by the names under which they are called.

    Returns
    -------
    callable
        The copy.

    Raises
    ------
    TypeError
        Something else than a plain function.
    """
    if not isinstance(function, FunctionType):
        raise TypeError(f"{name} is no plain function")
    copy = FunctionType(function.__code__, {**function.__globals__, **known}, name, function.__defaults__)
    copy.__qualname__ = name
    return copy
