"""What is compared: kernels with the limit of the machine and with each other, and with what else a user could take."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from granular.batch.engines import compiler_installed
from granular.speed.errors_met import FEW, worst_error
from granular.speed.interleaved import Way
from granular.speed.limit import moved
from granular.speed.sample import FRICTION, POISSON, Sample, sample

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

RTOL = 1e-12
"""Accuracy that is asked of partial slip [-]."""

PER_ITEM = 200
"""Elements that slow ways do in one call [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """Some ways of doing one thing; the first is what the others are compared with.

    Attributes
    ----------
    name : str
        Name on the command line.
    title : str
        What is done.
    goal : str
        What is aimed at, in words.
    ways : callable
        The ways for a number of elements; raises ModuleNotFoundError where another package is not installed.
    """

    name: str
    title: str
    goal: str
    ways: Callable[[int], list[Way]]


def _results(size: int) -> Array:
    import numpy as np

    return np.ones((size, 6))


def stiffness(drawn: Sample, what: str, **options: Any) -> Callable[[], object]:
    """A call of ``axial_stiffness`` on a sample.

    Parameters
    ----------
    drawn : Sample
        The assemblies.
    what : str
        "constant", "kinetic", "slip" (one friction), or "slip, any friction".
    **options
        Passed on: ``out``, ``engine``, ``threads``, ``hypothesis``.

    Returns
    -------
    callable
        Does it.

    Examples
    --------
    >>> stiffness(sample(3), "constant")().shape
    (3, 6)
    """
    from granular.array_stiffness import axial_stiffness

    friction: Any = {"slip": FRICTION, "slip, any friction": drawn.friction}.get(what)
    rtol = RTOL if friction is not None else None
    return partial(axial_stiffness, drawn.D33, drawn.Dr33, drawn.stress_ratio, friction, POISSON,
                   kinetic=what != "constant", rtol=rtol, **options)


def _way(name: str, drawn: Sample, what: str, **options: Any) -> Way:
    """A way of this package, with the error that it makes; too few elements are not looked at."""
    size, call = drawn.D33.size, stiffness(drawn, what, **options)
    return Way(name=name, elements=size, call=call, error=partial(worst_error, what, call) if size >= FEW else None)


def _engines() -> tuple[str, ...]:
    return ("compiled", "numpy") if compiler_installed() else ("numpy",)


def _against_limit(what: str, size: int) -> list[Way]:
    drawn, out = sample(size), _results(size)
    inputs = (drawn.D33, drawn.Dr33) if what == "constant" else (drawn.D33, drawn.Dr33, drawn.stress_ratio)
    return [Way(name="moving the same arrays", elements=size, call=moved(inputs, out)),
            *(_way(f"{what}, {engine}", drawn, what, out=out, engine=engine, threads=1) for engine in _engines())]


def _slip(size: int) -> list[Way]:
    drawn, out = sample(size), _results(size)
    return [_way(f"{what}, {engine}", drawn, what, out=out, engine=engine, threads=1)
            for engine in _engines()[:1] for what in ("kinetic", "slip", "slip, any friction")]


def _threads(size: int) -> list[Way]:
    drawn, out = sample(size), _results(size)
    return [_way(f"kinetic, {count} thread{'' if count == 1 else 's'}", drawn, "kinetic", out=out, threads=count)
            for count in (1, 2)]


def _slopes(what: str, size: int) -> list[Way]:
    from granular.derivatives import axial_gradient

    drawn = sample(size)
    friction: Any = FRICTION if what == "slip" else None
    return [_way(f"{what}, values", drawn, what, engine="numpy", threads=1),
            Way(name=f"{what}, values and slopes", elements=size,
                call=partial(axial_gradient, drawn.D33, drawn.Dr33, drawn.stress_ratio, friction, POISSON,
                             kinetic=what != "constant"))]


def _per_item(size: int) -> list[Way]:
    """One scene after the other, as a loop in Python does it."""
    from scipy.integrate import quad

    from granular.generated.kinematic_constant import kinematic_constant

    drawn, few = sample(size), sample(size).first(min(size, PER_ITEM))
    pairs = list(zip(few.D33.tolist(), few.Dr33.tolist(), strict=True))
    enough = len(pairs) >= FEW

    def closed() -> list[tuple[float, ...]]:
        return [kinematic_constant(D33, 0.0, Dr33, POISSON) for D33, Dr33 in pairs]

    def adaptive() -> list[list[float]]:
        return [[quad(lambda x, D=D33, Dr=Dr33, w=weight: (1 + D * (1.5 * x * x - 0.5)) * (
            1 + Dr * (1.5 * x * x - 0.5)) ** 2 * w(x * x), 0.0, 1.0, epsabs=0.0, epsrel=1e-10)[0]
            for weight in _weights()] for D33, Dr33 in pairs]

    return [_way("constant, all at once", drawn, "constant", threads=1),
            Way(name="closed form, one a call", elements=len(pairs), call=closed,
                error=partial(worst_error, "constant", closed) if enough else None),
            Way(name="scipy.integrate.quad, one a call", elements=len(pairs), call=adaptive,
                error=partial(worst_error, "constant", adaptive) if enough else None)]


def _weights() -> tuple[Callable[[float], float], ...]:
    """What stands with the density and the branches in each component, with y = cos(beta)^2."""
    from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio

    apart, shear = one_minus_stiffness_ratio(POISSON), stiffness_ratio(POISSON)
    return (lambda y: 0.375 * apart * (1 - y) ** 2 + 0.5 * shear * (1 - y), lambda y: apart * y * y + shear * y,
            lambda y: apart * (1 - y) ** 2 / 8, lambda y: apart * y * (1 - y) / 2,
            lambda y: apart * y * (1 - y) / 2 + shear * (1 + y) / 8,
            lambda y: apart * (1 - y) ** 2 / 8 + shear * (1 - y) / 4)


def _moduli(size: int) -> list[Way]:
    import numpy as np

    from granular.speed.peers.rock_physics import moduli

    return list(moduli(np.linspace(1e4, 1e7, size)))


def _stress_induced(size: int) -> list[Way]:
    from granular.speed.peers.rock_physics import anisotropic

    drawn = sample(size)
    return [*(_way(f"this package, {what}, all at once", drawn, what, threads=1) for what in ("kinetic", "slip")),
            anisotropic(min(size, PER_ITEM))]


def _orientations(degree: int, _size: int) -> list[Way]:
    from granular.speed.peers.orientation import average

    return list(average(degree))


def catalogue() -> Iterator[Comparison]:
    """Every comparison, in the order of the table.

    Returns
    -------
    iterator of Comparison
        The comparisons.

    Examples
    --------
    >>> next(catalogue()).name
    'constant'
    """
    yield Comparison(name="constant", title="contacts of equal stiffness",
                     goal="at most 1.15 times moving the same arrays", ways=partial(_against_limit, "constant"))
    yield Comparison(name="kinetic", title="contact stiffness by the force in each direction",
                     goal="at most 4.5 times moving the same arrays", ways=partial(_against_limit, "kinetic"))
    yield Comparison(name="slip", title="partial slip and sliding beside the kinetic fabric",
                     goal="at most 2.5 times kinetic with one friction, 6 times with one for each element", ways=_slip)
    yield Comparison(name="threads", title="two threads beside one", goal="half the time where two cores are idle",
                     ways=_threads)
    for what in ("constant", "kinetic", "slip"):
        yield Comparison(name=f"slopes-{what}", title=f"slopes beside values, {what}",
                         goal="at most 4 times the values", ways=partial(_slopes, what))
    yield Comparison(name="per-item", title="one at a time beside all at once", goal="", ways=_per_item)
    yield Comparison(name="moduli", title="isotropic moduli under many pressures", goal="", ways=_moduli)
    yield Comparison(name="stress-induced", title="stress-induced anisotropy of sphere packs", goal="",
                     ways=_stress_induced)
    for degree in (11, 41, 131):
        yield Comparison(name=f"orientations-{degree}", title=f"mean over the directions of Lebedev's rule of degree "
                         f"{degree}", goal="", ways=partial(_orientations, degree))
