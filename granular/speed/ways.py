"""Ways of this package to answer a question about very many assemblies."""

from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING, Any

from granular.batch import constant, kinetic
from granular.batch.engines import compiler_installed
from granular.speed.errors_met import FEW, worst_error, worst_slope_error
from granular.speed.interleaved import Way
from granular.speed.limit import computed
from granular.speed.questions import Question
from granular.speed.sample import Sample

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def values(name: str, question: Question, drawn: Sample, *, wanted: float | None = None, **options: Any) -> Way:
    """A way that computes the components, with the error that it makes.

    Parameters
    ----------
    name : str
        What it is, for a table.
    question : Question
        What is asked.
    drawn : Sample
        The assemblies; an error is looked for where there are ``FEW`` of them.
    wanted : float or None
        Bound that is aimed at for its time over that of the first way [-].
    **options
        Passed on to ``axial_stiffness``.

    Returns
    -------
    Way
        To be measured.
    """
    size, call = drawn.D33.size, question.call(drawn, **options)
    return Way(name=name, elements=size, call=call, wanted=wanted,
               error=partial(worst_error, question, call) if size >= FEW else None)


def slopes(name: str, question: Question, drawn: Sample, *, wanted: float | None = None, **options: Any) -> Way:
    """A way that computes the components and all their slopes, with the error of the slopes.

    Parameters
    ----------
    name : str
        What it is, for a table.
    question : Question
        What is asked.
    drawn : Sample
        The assemblies; an error is looked for where there are ``FEW`` of them.
    wanted : float or None
        Bound that is aimed at for its time over that of the first way [-].
    **options
        Passed on to ``axial_gradient``.

    Returns
    -------
    Way
        To be measured.
    """
    size, call = drawn.D33.size, question.slopes(drawn, **options)
    return Way(name=name, elements=size, call=call, wanted=wanted,
               error=partial(worst_slope_error, question, call) if size >= FEW else None)


def operations_alone(question: Question, size: int) -> tuple[Way, ...]:
    """As many operations as the kernel of a question has, without memory: the other limit of the machine.

    Parameters
    ----------
    question : Question
        Kinematic, without friction.
    size : int
        How many assemblies [-].

    Returns
    -------
    tuple of 2 Way
        Each operation by itself, and a multiplication fused with an addition; none without numba.

    Notes
    -----
    Source: the operations that the emitted loop states.
    """
    if not compiler_installed():
        return ()
    kernel = kinetic.KINEMATIC if question.kinetic else constant.KINEMATIC
    count = int(re.findall(r"Operations: (\d+)", kernel.loop().__doc__ or "")[-1])
    return tuple(Way(name=f"its {count} operations alone{', fused' if fused else ''}", elements=size,
                     call=computed(size, count, fused=fused)) for fused in (False, True))


def engines() -> tuple[str, ...]:
    """Engines that run here, the fastest first.

    Returns
    -------
    tuple of str
        Names as ``axial_stiffness`` takes them.
    """
    return ("fused", "compiled", "numpy") if compiler_installed() else ("numpy",)


def results(size: int) -> Array:
    """A place for the components of some assemblies, in memory that has been written to.

    Parameters
    ----------
    size : int
        How many [-].

    Returns
    -------
    (n, 6) array
        Ones [-].
    """
    import numpy as np

    return np.ones((size, 6))
