"""Speed from the stored measurements of ``granular speed``; a page that is built measures nothing."""

from __future__ import annotations

from functools import lru_cache

from granular.derivatives import PARAMETERS
from granular.figures.cost_pareto import size
from granular.figures.page import Interactive
from granular.figures.speed import curves, effect_costs, scaling, scaling_interactive
from granular.routes.result import COMPONENTS
from granular.speed.comparisons import LARGE, MET, catalogue
from granular.speed.interleaved import Measured
from granular.speed.peers.rock_physics import first_integral, misplaced_bracket
from granular.speed.store import Row, Study, read
from page_tools.cost_tables import STYLE
from page_tools.cost_words import capital, short
from page_tools.markup import Described, Markup, plain, table
from page_tools.pictures import pictured

DATA = "_data/speed.json"

PAST = "moving them past the caches"
"""Name of the way that moves the same arrays without reading first what is written."""

PEERS = ("per-item", "moduli", "stress-induced", "orientations-11", "orientations-41", "orientations-131")
"""Comparisons with what else a user could take."""


@lru_cache(maxsize=1)
def measured(data: str = DATA) -> Study:
    """Read the stored measurements once for the page; a file that was left unfinished stops the build."""
    study = read(data)
    absent = {one.name for one in catalogue()} - {row.name for row in study.rows}
    if absent:
        raise AssertionError(f"{data} has no {', '.join(sorted(absent))}: {study.command} --out {data}")
    return study


def scaling_figure() -> Markup:
    """Show time against number, with a caption that states what comes out."""
    study = measured()
    named = {curve.name: curve for curve in curves(study)}
    fast, limit = named["constant, compiled"], named["moving the same arrays"]
    most = max(fast.sizes)
    each = (f"One assembly a call takes {_time(fast.nanoseconds[0])}, one of {_count(most)} takes "
            f"{_time(fast.nanoseconds[-1])}; moving the same arrays takes {_time(limit.nanoseconds[-1])}.")
    alt = ("Time of one assembly against how many are computed in one call, both on logarithmic axes: "
           + "; ".join(f"{curve.name} from {_time(curve.nanoseconds[0])} to {_time(curve.nanoseconds[-1])}"
                       for curve in named.values()))
    return pictured(scaling(study), name="fig-speed-scaling", alt=alt, caption=(
        f"Calls cost until there are some thousand assemblies; from then on the kernels do. {each}"))


def scaling_to_explore() -> Described:
    """The same picture with values for the pointer."""
    return Described(Interactive(scaling_interactive(measured()), "speed-scaling"),
                     "Time of one assembly against how many are computed in one call; curves can be switched off")


def effects(name: str) -> Markup:
    """Show what each effect costs, of many assemblies (``effects``) or of scenes (``scenes``)."""
    row = measured().of(name)[-1]
    dearest, plainest = max(row.ways, key=lambda way: way.nanoseconds), row.ways[0]
    caption = (f"{capital(row.title)}. {capital(plainest.name)} alone takes {_time(plainest.nanoseconds)}, the dearest "
               f"({dearest.name}) {_time(dearest.nanoseconds)}. Errors: {row.errors}.")
    each = "; ".join(f"{way.name} {_time(way.nanoseconds)}" for way in row.ways)
    alt = f"Bars of the time of one {row.each}: {each}"
    return pictured(effect_costs(row), name=f"fig-speed-{name}", alt=alt, caption=caption)


def wanted() -> Markup:
    """List every bound that is aimed at beside what was measured, whether it is met or not."""
    rows = [line for row in measured().rows for way in row.ways for line in _judged(row, way)]
    grid = table(["comparison", "at most", "measured", "least", "error", "met"], rows, label="tab-speed-wanted",
                 align="lrrrrl", take_away="speed.csv", look="dense",
                 caption="Bounds that are aimed at, and what was measured. A ratio is the median over the rounds of "
                         "the time of an element over that of the other way in the same round; beside it the least "
                         "time over the least, which other load disturbs less. Memory is the most beside what is "
                         "given, over the size of that.")
    return Markup(f"{STYLE}\n\n{grid.text}")


def _judged(row: Row, way: Measured) -> list[list[str]]:
    where, error, found = f"`{row.name}`, {_count(row.size)}", short(way.error), []
    if way.wanted is not None:
        found.append([f"{way.name}, over {row.ways[0].name}<br>{where}", f"{way.wanted:g}", size(way.ratio),
                      size(way.least), error, _verdict(way.ratio <= way.wanted)])
    if way.memory is not None and way.memory_wanted is not None:
        found.append([f"{way.name}: memory<br>{where}", f"{way.memory_wanted:g}", f"{way.memory:.2g}", "–", error,
                      _verdict(way.memory <= way.memory_wanted)])
    return found


def _verdict(met: bool) -> str:
    return "yes" if met else "**no**"


def met() -> Markup:
    """Say how many of them are met, and name the comparisons that have one which is not."""
    judged = [(row.name, line) for row in measured().rows for way in row.ways for line in _judged(row, way)]
    missed = [name for name, line in judged if line[-1] != _verdict(met=True)]
    first = f"{len(judged) - len(missed)} of {len(judged)} bounds are met in the stored run."
    names = ", ".join(f"`{name}`" for name in dict.fromkeys(missed))
    load = measured().machine.get("load", "–")
    return Markup(f"{first} Not met in {names}. The load of the machine was {load} when it began." if missed else first)


def limits() -> Markup:
    """Say what arithmetic takes by itself, what memory takes past the caches, and what slopes have to write."""
    told, past = [], []
    for name, kind in (("constant", "contacts of one stiffness"), ("kinetic", "contacts that follow their force")):
        row = next(row for row in measured().of(name) if row.size == LARGE)
        apart, fused = (size(way.ratio) for way in row.ways if "operations alone" in way.name)
        told.append(f"{apart} for {kind} ({fused} fused)")
        past += [size(way.ratio) for way in row.ways if way.name == PAST]
    values, slopes = len(COMPONENTS), len(COMPONENTS) * (1 + len(PARAMETERS))
    least = [f"{size(way.ratio)} times as long as the values by `{engine}`" for engine in ("compiled", "fused")
             for row in measured().of(f"slopes-constant-{engine}") for way in row.ways if way.name == PAST]
    return Markup(
        "A kernel moves its arrays and does its arithmetic. The arithmetic alone, on numbers that never leave the "
        f"cache, takes {' and '.join(told)} times as long as moving the arrays. Plain stores read a line of memory "
        f"before they write it. Compiled kernels write large results past the caches: moving the arrays that way takes "
        f"{' and '.join(past)} of the time, so that a kernel may be faster than a plain copy. Slopes of contacts of "
        f"one stiffness are {slopes} numbers in place of {values}; to move them past the caches, without computing "
        f"any, takes {' and '.join(least)}.")


def peers() -> Markup:
    """List what else a user could take, with times and errors."""
    rows = []
    for row in (found for name in PEERS for found in measured().of(name)):
        for way in row.ways:
            rows.append([row.title if way is row.ways[0] else "", plain(way.name), size(way.ratio),
                         _time(way.nanoseconds), short(way.error)])
    note = "; ".join(f"{row.title}: {row.errors}" for name in PEERS for row in measured().of(name)
                     if row.errors != MET and name not in PEERS[-2:])
    grid = table(["question", "way", "time over ours", "each", "error"], rows, label="tab-speed-peers",
                 align="llrrr", take_away="peers.csv", look="dense",
                 caption=f"Other ways to the same numbers. Errors are the {MET}, except: {note}.")
    absent = [f"{row.title}: {row.failure}" for row in measured().rows if row.failure]
    return Markup(f"{grid.text}\n\nNot measured: {'; '.join(absent)}.\n") if absent else grid


def agreements() -> Markup:
    """List numbers of other packages beside what they are meant to be."""
    study = measured()
    packages = " and ".join(dict.fromkeys(one.package for one in study.agreements)) or "none"
    rows = [[plain(one.quantity), f"{one.theirs:.6g}", f"{one.meant:.6g} {one.unit}", short(one.distance)]
            for one in study.agreements]
    return table(["number", "gives", "is meant to give", "apart"], rows, label="tab-speed-agreement", align="lrrr",
                 take_away="agreement.csv", look="dense",
                 caption=f"Numbers of {packages}. A distance of a few $10^{{-16}}$ is rounding.")


def bracket(quotient: float = 2.0) -> Markup:
    """Compute the integral of sqrt(q + x^2), what stands in its place there, and quadrature as the judge."""
    from scipy.integrate import quad

    known = quad(lambda x: (quotient + x * x) ** 0.5, 0.0, 1.0, epsabs=0.0, epsrel=1e-13)[0]
    rows = [["quadrature", f"{known:.12f}", "–"]]
    for name, value in (("$\\tfrac12\\sqrt{1+q} + \\tfrac q2\\ln\\frac{1+\\sqrt{1+q}}{\\sqrt q}$",
                         first_integral(quotient)),
                        ("$\\tfrac12\\sqrt{1+q} + \\tfrac q2\\ln\\left(1+\\frac{\\sqrt{1+q}}{\\sqrt q}\\right)$",
                         misplaced_bracket(quotient))):
        rows.append([name, f"{value:.12f}", short(abs(value / known - 1))])
    return table(["way", f"for $q = {quotient:g}$", "error"], rows, label="tab-speed-bracket", align="lrr",
                 caption="$I_0 = \\int_0^1 \\sqrt{q + x^2}\\,dx$ three ways; the last one is what the package takes.")


def machine() -> Markup:
    """Say where, with which versions and how often it was measured, and how to do it again."""
    study = measured()
    about = dict(study.machine)
    processor, cores, system, load = (about.pop(name, "–") for name in ("processor", "cores", "system", "load"))
    packages = ", ".join(f"{name} {version}" for name, version in about.items())
    spreads = sorted(100 * way.spread for row in study.rows for way in row.ways[1:])
    return Markup(f"Measured on {processor}, {cores} cores, {system}, with {packages}, in {study.rounds} rounds or "
                  f"fewer. The load was {load} when it began. The spread of the ratios, half the distance of their "
                  f"quartiles over them, is {spreads[len(spreads) // 2]:.0f} % in the median and {spreads[-1]:.0f} % "
                  f"at most.\n\n```console\n$ {study.command} --out book/_data/speed.json\n```\n")


def _time(nanoseconds: float) -> str:
    for unit, name in ((1.0, "ns"), (1e3, "µs"), (1e6, "ms")):
        if nanoseconds < 1e3 * unit:
            return f"{size(nanoseconds / unit)} {name}"
    return f"{size(nanoseconds / 1e9)} s"


def _count(value: int) -> str:
    exponent = len(str(value)) - 1
    return f"$10^{{{exponent}}}$" if value == 10 ** exponent and exponent > 2 else size(value)
