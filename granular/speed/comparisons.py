"""What is compared: kernels with the limit of the machine and with each other, and with what else a user could take."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from granular.batch.engines import compiler_installed
from granular.speed import contact_lists, effects, questions
from granular.speed.errors_met import FEW, worst_error
from granular.speed.interleaved import Way
from granular.speed.limit import moved, moved_past
from granular.speed.questions import Question
from granular.speed.sample import POISSON, Sample, sample
from granular.speed.ways import engines, operations_alone, results, slopes, values

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

PER_ITEM = 200
"""Elements that slow ways do in one call [-]."""

LARGE, CONTACTS = 10**6, 10**7
"""Elements, or contacts, of a comparison [-]."""

SLOW = 20_000
"""Elements of a comparison whose ways sum over directions for each of them [-]."""

BY_NUMPY = 2**18
"""Elements of partial slip by NumPy [-]: fewer have no table for every friction."""

SIZES = (1, 10, 100, 1000, 10**4, 10**5, 10**6, 10**7)
"""Elements for the picture of time against number [-]."""

MOST_BY_NUMPY = 10**6
"""Elements from which on slip is not computed by NumPy for that picture [-]: it would take minutes."""

MET = "worst met against ball arithmetic"
"""What the error of a comparison is unless it says otherwise."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """Some ways of doing one thing; the first is what the others are compared with.

    Attributes
    ----------
    name : str
        Name on the command line.
    title : str
        What is done.
    ways : callable
        The ways for a number of elements; raises ModuleNotFoundError where another package is not installed.
    sizes : tuple of int
        Numbers of elements for which it is made [-].
    each : str
        What an element is.
    errors : str
        What the errors beside the times are.
    rounds : int or None
        Most rounds [-]; None leaves it to the command.
    """

    name: str
    title: str
    ways: Callable[[int], list[Way]]
    sizes: tuple[int, ...] = (LARGE,)
    each: str = "assembly"
    errors: str = MET
    rounds: int | None = None


def _against_limit(question: Question, name: str, wanted: float, size: int) -> list[Way]:
    drawn, out = sample(size), results(size)
    question = replace(question, grains_differ=True)  # everything that a kernel takes is an array here
    return [Way(name="moving the same arrays", elements=size, call=moved(_read(question, drawn), out)),
            *(_past_the_caches(_read(question, drawn), out) if size == LARGE else ()),
            *(operations_alone(question, size) if size == LARGE else ()),
            *(values(f"{name}, {engine}", question, drawn, out=out, engine=engine, threads=1,
                     wanted=wanted if engine != "numpy" and size == LARGE else None) for engine in engines())]


def _past_the_caches(inputs: tuple[Array, ...], out: Array) -> tuple[Way, ...]:
    """Moving arrays without reading first what is written; none without a compiler."""
    if not compiler_installed():
        return ()
    return (Way(name="moving them past the caches", elements=inputs[0].size, call=moved_past(inputs, out)),)


def _read(question: Question, drawn: Sample) -> tuple[Array, ...]:
    """The arrays that a kernel without friction reads."""
    grains = (drawn.poisson_ratio,) if question.grains_differ else ()
    return (drawn.D33, drawn.Dr33, *((drawn.stress_ratio,) if question.kinetic else ()), *grains)


def _slip_against_limit(size: int) -> list[Way]:
    drawn, out, question = sample(size), results(size), replace(questions.SLIP, grains_differ=True)
    able = engines() if size <= MOST_BY_NUMPY else engines()[:2]
    return [Way(name="moving the same arrays", elements=size, call=moved(_read(question, drawn), out)),
            *(values(f"slip, {engine}", question, drawn, out=out, engine=engine, threads=1) for engine in able)]


def _slip(engine: str, size: int) -> list[Way]:
    drawn, out = sample(size), results(size)
    asked = (("kinetic", questions.KINETIC, None), ("slip, one friction", questions.SLIP, 2.5),
             ("slip, a friction each", questions.SLIP_EACH, 6.0))
    return [values(name, question, drawn, out=out, engine=engine, threads=1,
                   wanted=None if engine == "numpy" else wanted) for name, question, wanted in asked]


def _threads(question: Question, size: int) -> list[Way]:
    drawn, out = sample(size), results(size)
    return [values(f"{count} thread{'' if count == 1 else 's'}", question, drawn, out=out, threads=count,
                   wanted=None if count == 1 else 0.6) for count in (1, 2)]


def _slopes(question: Question, engine: str, size: int) -> list[Way]:
    import numpy as np

    drawn = sample(size)
    found = question.slopes(drawn)()
    rows = np.concatenate([found[0][..., None], found[1]], axis=-1).reshape(size, -1)
    return [values("values", question, drawn, out=results(size), engine=engine, threads=1),
            slopes("values and slopes", question, drawn, out=found, engine=engine, threads=1, wanted=4.0),
            Way(name="moving what slopes move", elements=size, call=moved(_read(question, drawn), rows)),
            *_past_the_caches(_read(question, drawn), rows)]


def _slopes_with_slip(size: int) -> list[Way]:
    drawn = sample(size)
    return [values("values, full precision", questions.SLIP_FULL, drawn, threads=1),
            slopes("values and slopes", questions.SLIP_FULL, drawn, threads=1, wanted=4.0),
            values("values to 1e-12, from tables", questions.SLIP, drawn, threads=1)]


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

    return [values("constant, all at once", questions.CONSTANT, drawn, threads=1),
            Way(name="closed form, one a call", elements=len(pairs), call=closed,
                error=partial(worst_error, questions.CONSTANT, closed) if enough else None),
            Way(name="scipy.integrate.quad, one a call", elements=len(pairs), call=adaptive,
                error=partial(worst_error, questions.CONSTANT, adaptive) if enough else None)]


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
    return [values("this package, kinetic, all at once", questions.KINETIC, drawn, threads=1),
            values("this package, slip, all at once", questions.SLIP, drawn, threads=1),
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
    yield Comparison(name="constant", title="contacts of equal stiffness", sizes=SIZES,
                     ways=partial(_against_limit, questions.CONSTANT, "constant", 1.15))
    yield Comparison(name="kinetic", title="contact stiffness by the force in each direction", sizes=SIZES,
                     ways=partial(_against_limit, questions.KINETIC, "kinetic", 4.5))
    yield Comparison(name="slip", title="partial slip and sliding, one friction", sizes=SIZES,
                     ways=_slip_against_limit)
    for engine, size in (("fused", LARGE), ("compiled", LARGE), ("numpy", BY_NUMPY)):
        yield Comparison(name=f"slip-{engine}", title=f"partial slip beside the kinetic fabric, {engine}",
                         ways=partial(_slip, engine), sizes=(size,))
    for name, question in (("constant", questions.CONSTANT), ("kinetic", questions.KINETIC), ("slip", questions.SLIP)):
        yield Comparison(name=f"threads-{name}", title=f"two threads beside one, {name}",
                         ways=partial(_threads, question))
    differences = "values as before; slopes against differences of ball arithmetic"
    for name, question in (("constant", questions.CONSTANT), ("kinetic", questions.KINETIC)):
        for engine in ("fused", "compiled", "numpy"):
            yield Comparison(name=f"slopes-{name}-{engine}", title=f"slopes beside values, {name}, {engine}",
                             ways=partial(_slopes, question, engine), errors=differences)
    yield Comparison(name="slopes-slip", title="slopes beside values, slip", ways=_slopes_with_slip, sizes=(SLOW,),
                     errors=differences)
    yield Comparison(name="effects", title="effect after effect, many assemblies at once", ways=effects.arrays)
    yield Comparison(name="scenes", title="effect after effect, one scene at a time", ways=effects.scenes, sizes=(1,),
                     each="scene", errors="the bound that the result states")
    yield Comparison(name="contacts", title="sum of eq. (1) over a contact list in memory", ways=contact_lists.sums,
                     sizes=(CONTACTS,), each="contact", errors="distance of the two sums")
    yield Comparison(name="parquet", title="summary of a contact list in a Parquet file", each="contact",
                     ways=contact_lists.streamed, sizes=(CONTACTS,), errors="", rounds=1)
    yield Comparison(name="per-item", title="one assembly after the other beside all at once", ways=_per_item)
    yield Comparison(name="moduli", title="isotropic moduli under many pressures", ways=_moduli, each="pressure",
                     errors="against the formula in floats, at the first pressure")
    yield Comparison(name="stress-induced", title="stress-induced anisotropy of sphere packs", ways=_stress_induced,
                     errors=f"{MET}; of the other package against its own formulas")
    for degree in (11, 41, 131):
        yield Comparison(name=f"orientations-{degree}", title=f"mean over the directions of Lebedev's rule of degree "
                         f"{degree}", ways=partial(_orientations, degree), sizes=(1,), each="direction",
                         errors="against the closed form")
