"""Stiffnesses in any frame: a found axis against axis 3, two rules without an axis, and one rule in two frames."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING

from granular.checks.comparison import Comparison
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.notation import MANDEL_PAIRS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general import GeneralFabric, GeneralLoading, GeneralStiffness

    Array = NDArray[np.float64]

LARGEST = "units of the largest entry"
"""Entries of a matrix in a general frame may vanish, so that the largest one is the measure."""

FRAME = ((2 / 3, -1 / 3, 2 / 3), (2 / 3, 2 / 3, -1 / 3), (-1 / 3, 2 / 3, 2 / 3))
"""A rotation that mixes all three axes."""

NU = 0.21
RTOL = 1e-12
"""Wanted of the rules without an axis [-]."""

AXIAL: tuple[tuple[str, AxialFabric, Loading | None, tuple[Hypothesis, ...]], ...] = (
    ("equal contacts", AxialFabric(D33=0.3, Dr33=-0.3), None, tuple(Hypothesis)),
    ("contact forces", AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(2), tuple(Hypothesis)),
    ("partial slip", AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(1, friction=0.2126), tuple(Hypothesis)),
    ("sliding", AxialFabric(D33=0.3), Loading.of_ratio(2, friction=0.2126), (Hypothesis.KINEMATIC,)),
    ("opened", AxialFabric(D33=0.3), Loading.of_ratio(Fraction(-1, 4), friction=0.3), (Hypothesis.KINEMATIC,)),
)
"""Scenes about axis 3 that are turned into another frame."""

NORMALS = ((0.2, 0.1, 0.05), (0.1, -0.15, -0.05), (0.05, -0.05, -0.05))
BRANCHES = ((-0.1, 0.05, 0.0), (0.05, 0.2, 0.1), (0.0, 0.1, -0.1))
STRESS = ((1.2, 0.2, 0.05), (0.2, 1.0, -0.1), (0.05, -0.1, 0.8))
"""Three tensors that share nothing [-]."""


def general_comparisons() -> Iterator[Comparison]:
    """Compare scenes in any frame with themselves: about axis 3, by another rule, in another frame.

    Returns
    -------
    iterator of Comparison
        The worst entry of the Mandel matrix each time; allowed is what the two results state together.

    Notes
    -----
    Accuracy: that of the routes. Source: a stiffness turns with its scene, and no rule knows of another.

    Examples
    --------
    >>> all(comparison.agrees for comparison in general_comparisons())
    True
    """
    for name, fabric, loading, hypotheses in AXIAL:
        for hypothesis in hypotheses:
            yield _axis_found(name, fabric, loading, hypothesis)
    from granular.general import GeneralFabric, GeneralLoading

    whole, plain = GeneralFabric(NORMALS, Dr=BRANCHES), GeneralFabric(NORMALS)
    for hypothesis in Hypothesis:
        yield _two_rules("equal contacts", "product", "closed_form", plain, None, hypothesis)
        yield _two_rules("contact forces", "lebedev", "product", whole, GeneralLoading(STRESS), hypothesis)
    for name, friction in (("partial slip", 1.0), ("sliding", 0.15)):
        yield _two_frames(name, whole, GeneralLoading(STRESS, friction))


def _axis_found(name: str, fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis) -> Comparison:
    """A scene about axis 3, turned in space and recognised there, against the turned stiffness."""
    import numpy as np

    from granular.general import GeneralFabric, GeneralLoading, general_stiffness
    from granular.mandel import axial_rows, turned
    from granular.routes import axial

    turn, about = np.array(FRAME), np.diag([-0.5, -0.5, 1.0])
    tensors = GeneralFabric(turn @ (fabric.D33 * about) @ turn.T, Dr=turn @ (fabric.Dr33 * about) @ turn.T)
    stress = None if loading is None else GeneralLoading(
        turn @ np.diag([float(loading.sigma11)] * 2 + [float(loading.sigma33)]) @ turn.T, loading.friction)
    found = general_stiffness(tensors, poisson_ratio=NU, hypothesis=hypothesis, loading=stress, rtol=1e-12)
    known = axial.evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis, loading=loading)
    return _compared("any frame", name, hypothesis, "turned", np.array(found.rows),
                     np.array(turned(axial_rows(known.components), turn, "stiffness")),
                     found.relative_error + known.relative_error)


def _two_rules(case: str, route: str, other: str, fabric: GeneralFabric, loading: GeneralLoading | None,
               hypothesis: Hypothesis) -> Comparison:
    found, known = (_by(name, fabric, loading, hypothesis) for name in (route, other))
    return _compared("no axis", f"{case}, against {other}", hypothesis, route, found.mandel(), known.mandel(),
                     found.relative_error + known.relative_error)


def _two_frames(case: str, fabric: GeneralFabric, loading: GeneralLoading) -> Comparison:
    """One rule in two frames: meridians, panels and edges lie elsewhere."""
    import numpy as np

    from granular.general import GeneralFabric, GeneralLoading

    turn = np.array(FRAME)
    there = GeneralFabric(turn @ np.array(fabric.D) @ turn.T, Dr=turn @ np.array(fabric.Dr) @ turn.T)
    one = _by("product", fabric, loading, Hypothesis.KINEMATIC)
    other = _by("product", there, GeneralLoading(turn @ np.array(loading.stress) @ turn.T, loading.friction),
                Hypothesis.KINEMATIC)
    return _compared("no axis", f"{case}, in another frame", Hypothesis.KINEMATIC, "product", other.mandel(),
                     one.stiffness().rotated(turn).mandel(), one.relative_error + other.relative_error)


def _by(name: str, fabric: GeneralFabric, loading: GeneralLoading | None, hypothesis: Hypothesis) -> GeneralStiffness:
    from granular.general.routes import GENERAL_ROUTES

    return GENERAL_ROUTES[name].evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis, loading=loading, rtol=RTOL)


def _compared(group: str, case: str, hypothesis: Hypothesis, route: str, found: Array, known: Array,
              stated: float) -> Comparison:
    import numpy as np

    off = np.abs(found - known)
    row, column = max(combinations_with_replacement(range(6), 2), key=lambda place: float(off[place]))
    name = "C" + "".join(map(str, (*MANDEL_PAIRS[row], *MANDEL_PAIRS[column])))
    return Comparison(group=group, case=case, hypothesis=hypothesis, route=route, component=name,
                      error=float(off.max() / np.abs(known).max()) * 2**52, allowed=stated * 2**52, unit=LARGEST)
