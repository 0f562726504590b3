"""Fabric tensors on a page: the packing that comes with the library, drawn lists, and what a list can show."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

from granular.contacts.contact_list import ContactList
from granular.contacts.example import example_path
from granular.errors import FabricOutOfRange
from granular.fabric_tensors import (
    Moments,
    axial_fabric,
    axial_symmetry,
    bootstrap,
    component_intervals,
    directions_of,
    fabric_of,
    least_density,
    significance,
)
from granular.fabric_tensors.reach import least_seen
from granular.fabric_tensors.sampling import axial_tensors, isotropic, tensors_of
from granular.fabric_tensors.significance import FOR_RANK_FOUR
from granular.fabric_tensors.uncertainty import axial_intervals, axis_interval, principal_intervals
from granular.figures.fabric_rose import rose
from granular.figures.page import Static
from page_tools.markup import Markup, plain, table

VERTICAL = (0.0, 0.0, 1.0)
TILT = (0.0, 1.0, 1.0)
DRAWN = 400
"""Directions of a drawn list: as many as a patient observer measures in thin sections."""

ROUNDING = 1e-12
"""What another order of the same sums may change in a component of rank four [-]; 315/8 times that of a mean."""

NUMBERS = (50, 100, 400, 1000, 5000, 20_000, 100_000)


@lru_cache(maxsize=1)
def normals() -> Any:
    """Contact normals of the packing that comes with the library."""
    import numpy as np

    return np.concatenate([block.normal.T for block in ContactList(example_path()).blocks()])


def _drawn_lists() -> tuple[tuple[str, Any], ...]:
    """Lists of directions whose densities are known."""
    three = tensors_of([[-0.9, 0, 0], [0, 0, 0], [0, 0, 0.9]])
    return (("no preference", directions_of(isotropic(), DRAWN, seed=1)),
            ("$D_{33} = 0.8$ about an axis between axes 2 and 3", directions_of(axial_tensors(0.8, axis=TILT), DRAWN,
                                                                                  seed=2)),
            ("$D_{11}, D_{22}, D_{33} = -0.9, 0, 0.9$", directions_of(three, DRAWN, seed=3)))


def drawn_directions(number: int) -> Any:
    """Directions of one of the drawn lists, counted from zero."""
    return _drawn_lists()[number][1]


def packing_rose() -> Static:
    """Rose diagrams of the packing."""
    return Static(rose(normals()))


def drawn_rose() -> Static:
    """Rose diagrams of the second drawn list, about the vertical."""
    return Static(rose(drawn_directions(1)))


def packing_values() -> Markup:
    """D33 and D3333 of the packing about the vertical, with intervals in both ways."""
    tensors = fabric_of(normals())
    resampled = axial_intervals(bootstrap(normals()), VERTICAL)
    rows = []
    for name, rank, place, again in (("$D_{33}$", "D2", (2, 2), resampled[0]),
                                     ("$D_{3333}$", "D4", (2, 2, 2, 2), resampled[1])):
        one = component_intervals(tensors, rank)
        rows.append([name, f"{one.value[place]:.3f}", _ends(one.low[place], one.high[place]),
                     _ends(again.low, again.high)])
    return table(["coefficient", "value", "95 %, formula", "95 %, bootstrap"], rows,
                 label="tab-packing-fabric", align="lrrr",
                 caption=f"The {tensors.count} contacts of the packing, about the vertical.")


def packing_verdict() -> Markup:
    """Every test of the packing, with the vertical as the axis that is known."""
    tests = significance(fabric_of(normals()), VERTICAL)
    if [test.significant() for test in tests.tests[:2]] != [False, True]:
        raise AssertionError("the page says that only the sharper question is answered")
    return _tests(tests, "tab-packing-tests",
                  "Tests of the packing; the vertical is known to be its axis.")


def drawn_verdicts() -> Markup:
    """What the tests say of drawn lists, and the axis with its cone."""
    rows = []
    for name, directions in _drawn_lists():
        tensors = fabric_of(directions)
        tests = significance(tensors)
        found = "–"
        if tests.tests[0].significant() and not axial_symmetry(tensors).significant():
            cone = axis_interval(bootstrap(directions))
            found = f"({', '.join(f'{part:.2f}' for part in cone.axis)}) ± {math.degrees(cone.angle):.0f}°"
        rows.append([name, found, plain(_sentence(tests.words))])
    return table(["drawn from", "axis, 95 %", "what the tests say"], rows, label="tab-drawn", align="lll",
                 look="words-first",
                 caption=f"Lists of {DRAWN} directions drawn from known densities, tested without that knowledge.")


def principal_values() -> Markup:
    """Principal values of the third drawn list with intervals."""
    name, directions = _drawn_lists()[2]
    interval = principal_intervals(bootstrap(directions))
    found = "; ".join(f"{value:.2f} ({_ends(low, high, digits=2)})" for value, low, high in zip(
        interval.value, interval.low, interval.high, strict=True))
    return Markup(f"The principal values of $D_{{ij}}$ of the list from {name} are {found}.\n")


def numbers_needed() -> Markup:
    """Weakest D33 that so many directions show."""
    rows = [[f"{number}", f"{least_seen(number):.3f}", f"{least_seen(number, axis_known=False):.3f}"]
            for number in NUMBERS]
    return table(["directions", "axis known", "axis unknown"], rows, label="tab-directions-needed", align="rrr",
                 take_away="directions_needed.csv",
                 caption="The weakest $|D_{33}|$ that is significant at 5 % in nine lists of ten.")


def few_directions_for_rank_four() -> Markup:
    """How many directions tests of rank four ask for."""
    return Markup(f"Tests of rank four are refused below {FOR_RANK_FOUR} effective directions.\n")


def negative_density() -> Markup:
    """Implied density of a few directions about an axis, and its refusal as an axial fabric."""
    import numpy as np

    about_vertical = np.random.default_rng(5).normal(VERTICAL, 0.3, size=(60, 3))
    tensors = fabric_of(about_vertical, normalise=True)
    least = least_density(tensors)
    try:
        axial_fabric(tensors)
    except FabricOutOfRange as refusal:
        return Markup(f"Of 60 directions close to the vertical the sentence is “{plain(least.words)}”, and the axial "
                      f"fabric is refused:\n\n```text\n{refusal}\n```\n")
    raise AssertionError("the density was meant to be negative")


def one_section() -> Markup:
    """Fabric of directions that all lie in a section, evenly in it."""
    import numpy as np

    angle = np.pi * (np.arange(180) + 0.5) / 180
    tensors = fabric_of(np.stack([np.cos(angle), 0 * angle, np.sin(angle)], axis=1))
    return Markup(f"Directions spread evenly over the plane of axes 1 and 3, taken as directions in space, give "
                  f"$D_{{22}} = {tensors.D2[1, 1]:.2f}$: a strong fabric about axis 2 that only tells how the section "
                  "was cut.\n")


def in_blocks() -> Markup:
    """The packing read in blocks against the whole list: the same but for rounding."""
    import numpy as np

    sums = Moments()
    for block in ContactList(example_path()).blocks():
        for part in np.array_split(block.normal.T, 7):
            sums.add(part)
    whole, again = fabric_of(normals()), sums.fabric()
    apart = max(float(np.abs(getattr(whole, name) - getattr(again, name)).max())
                for name in ("N2", "N4", "F2", "F4", "D2", "D4"))
    if apart > ROUNDING:
        raise AssertionError(f"blocks and the whole list differ by {apart}")
    return Markup(f"The packing in seven blocks and the packing in one agree in every component within {ROUNDING:g}.\n")


def _tests(tests: Any, label: str, caption: str) -> Markup:
    rows = [[test.name, f"{test.statistic:.2f}", str(test.degrees_of_freedom), _chance(test.p), plain(
        test.fails if test.significant() else test.holds)] for test in tests]
    return table(["question", "statistic", "freedom", "$p$", "verdict at 5 %"], rows, label=label, align="lrrrl",
                 caption=caption)


def _chance(p: float) -> str:
    return "< 1e-6" if p < 1e-6 else f"{p:.2g}"


def _ends(low: float, high: float, *, digits: int = 3) -> str:
    return f"{low:.{digits}f} to {high:.{digits}f}"


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
