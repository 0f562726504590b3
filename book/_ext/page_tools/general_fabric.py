"""Fabrics and stresses without a common axis on a page: 21 constants, their class, their error and their cost."""

from __future__ import annotations

from functools import lru_cache

from granular import Scene, axial_stiffness, evaluate
from granular.figures.general_fabric import TILTS, by_tilt, tilted, tilted_fabric
from granular.figures.page import Static
from granular.general import GeneralFabric, GeneralLoading, GeneralStiffness, Symmetry, classify, general_stiffness
from granular.general.axis import rotation_to
from granular.general.fabric import spread_directions
from granular.general.loading import contact_stiffness
from granular.general.routes import GENERAL_AUTO, GENERAL_CATALOGUE
from granular.mandel import six_of, symmetric_rows, turned
from granular.notation import MANDEL_PAIRS
from granular.routes.direction_sums import contact_tensor, fourth_rank, mandel_matrix, symmetrised
from granular.tensors import Tensor
from page_tools.markup import Markup, numbers_to_take_away, plain, table

NU = 0.21
D33, TILT = 0.5, 45.0
"""Fabric of the page's example about its axis [-], and the angle of that axis from the vertical [degrees]."""

OTHER_FRAME = ((2 / 3, -1 / 3, 2 / 3), (2 / 3, 2 / 3, -1 / 3), (-1 / 3, 2 / 3, 2 / 3))
"""A rotation that mixes all three axes."""

WANTED = (1e-3, 1e-5, 1e-7, 1e-9)
FINEST = 1e-11
"""Accuracy of the values that others are compared with [-]."""

SPREAD = 1_000_000
"""Contacts in the plain sum [-]."""

SUM_OFF = 1e-4
"""What the plain sum may be off, over the largest entry [-]: the edge of sliding has a slope that is infinite."""

STICKS = 0.6
"""Friction coefficient with which no contact of the example slides [-]."""

NAMES = ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212")


def example(*, friction: float | None) -> GeneralLoading:
    """Vertical stress of the example."""
    return GeneralLoading(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 2.0)), friction=friction)


def matrix(found: GeneralStiffness) -> Markup:
    """The Mandel matrix; entries below the error are zero."""
    largest = max(abs(value) for row in found.rows for value in row)
    heads = ["".join(map(str, pair)) for pair in MANDEL_PAIRS]
    rows = [[f"**{head}**", *(_entry(value, found.relative_error * largest) for value in row)]
            for head, row in zip(heads, found.rows, strict=True)]
    taken = [["", *heads], *([head, *map(repr, row)] for head, row in zip(heads, found.rows, strict=True))]
    return table(["", *heads], rows, label="tab-general-matrix", align="lrrrrrr", take_away="tilted_fabric.csv",
                 taken=taken, caption="Mandel matrix of the example over $(M/V)\\,\\ell_e^2k_{n,\\mathrm{ref}}$. "
                 f"{_error(found)} over the largest entry; 0 stands for entries below that.")


def distances(found: GeneralStiffness) -> Markup:
    """Say what class the stiffness belongs to and how far it is from the others."""
    symmetry = classify(found.rows, tolerance=found.relative_error)
    if symmetry.name != "general":
        raise AssertionError("the page says that the example belongs to no class")
    rows = [["isotropic", _percent(symmetry.isotropic), "–"],
            ["transversely isotropic", _percent(symmetry.transversely_isotropic), f"axis ({_parts(symmetry.axis)})"],
            ["orthotropic", _percent(symmetry.orthotropic), _frame(symmetry.frame)]]
    return table(["nearest tensor", "distance", "where"], rows, label="tab-general-class",
                 align="lrl", caption="How far the stiffness of the example is from each class, over its norm.")


def in_another_frame(fabric: GeneralFabric, loading: GeneralLoading, found: GeneralStiffness) -> Markup:
    """Turn the scene, compute, turn the result back: what is left is the error of two computations."""
    there = general_stiffness(_turned_fabric(fabric), poisson_ratio=NU, hypothesis="kinematic", loading=GeneralLoading(
        _turned(loading.stress), friction=loading.friction))
    back = turned(symmetric_rows(there.rows, "stiffness"), list(zip(*OTHER_FRAME, strict=True)), "stiffness")
    gap, promised = _apart(back, found.rows), there.relative_error + found.relative_error
    if gap > promised:
        raise AssertionError(f"another frame gives {gap} instead of {promised}")
    return Markup("The same scene in a frame that shares no axis with this one, computed there and turned back, "
                  f"differs by {gap:.0e}. The rule turns with the scene, so this checks the turning, not the rule.\n")


def plain_sum(fabric: GeneralFabric, loading: GeneralLoading, found: GeneralStiffness) -> Markup:
    """Eq. (1) summed over evenly spread contacts: it knows of no edges, moments or frames."""
    n = spread_directions(SPREAD)
    _, shear, apart = contact_stiffness(loading.force_tensor(fabric), loading.friction, n, NU)
    share = fabric.relative_density(n) * fabric.branch_weight(n) ** 2 / SPREAD
    summed = mandel_matrix(symmetrised(fourth_rank(share * n[:, None] * n[None, :], contact_tensor(n, apart, shear))))
    off = _apart(summed, found.rows)
    if off > SUM_OFF:
        raise AssertionError(f"the plain sum is off by {off}")
    return Markup(f"Equation (1) of the paper, summed over {SPREAD:,} evenly spread contacts with their forces, "
                  f"differs by {off:.0e} of the largest entry. The sum knows nothing of edges, moments or frames.\n")


def accuracy(fabric: GeneralFabric, loading: GeneralLoading) -> Markup:
    """Wanted, estimated and true errors, and the directions that they take."""
    best = general_stiffness(fabric, poisson_ratio=NU, hypothesis="kinematic", loading=loading, rtol=FINEST)
    rows = []
    for rtol in WANTED:
        found = general_stiffness(fabric, poisson_ratio=NU, hypothesis="kinematic", loading=loading, rtol=rtol)
        off = _apart(found.rows, best.rows)
        if off > found.relative_error:
            raise AssertionError(f"rtol = {rtol}: off by {off}, stated {found.relative_error}")
        rows.append([f"{rtol:.0e}", f"{found.relative_error:.1e}", f"{off:.1e}", f"{found.evaluations}"])
    return table(["wanted", "stated", "found", "directions"], rows, label="tab-general-accuracy", align="rrrr",
                 take_away="general_accuracy.csv", caption="Errors of the example over its largest entry; found against"
                 f" the values at {FINEST:.0e}, which take {best.evaluations} directions.")


def axial_scene(found: GeneralStiffness, *, stress_ratio: float, friction: float) -> Markup:
    """An axial scene in space, turned to axis 3, beside the same scene given about axis 3."""
    if found.axis is None or not found.route.startswith("axial"):
        raise AssertionError("the page says that the axis is found")
    turn = rotation_to(found.axis)
    six = six_of(turned(symmetric_rows(found.rows, "stiffness"), turn.T, "stiffness"))
    upright = axial_stiffness(D33, 0.0, stress_ratio, friction, NU).tolist()
    by_name = dict(zip(NAMES, six, strict=True))
    if max(abs(a - b) for a, b in zip(six, upright, strict=True)) > (found.relative_error + 1e-12) * max(upright):
        raise AssertionError("turned and upright scenes differ")
    rows = [[f"$C_{{{name[1:]}}}$", f"{by_name[name]:.12f}", f"{value:.12f}"]
            for name, value in zip(NAMES, upright, strict=True)]
    return table(["", "in space, turned to its axis", "given about axis 3"], rows, label="tab-general-axial",
                 align="lrr", caption=f"The axis found is ({_parts(found.axis)}). {_error(found)}.")


def same_scene(file: str, found: GeneralStiffness) -> Markup:
    """The scene of a file beside the same tensors given in Python."""
    result = evaluate(Scene.from_toml(file))
    normalised = [[value / result.reference_stiffness for value in row] for row in result.stiffness.rows]
    off, stated = _apart(normalised, found.rows), result.relative_error + found.relative_error
    if off > stated:
        raise AssertionError(f"the file gives another stiffness: {off} apart, {stated} stated")
    return Markup(f"Over its unit it differs from the result above by {off:.0e} of the largest entry; the two together "
                  f"state {stated:.0e}.\n")


def general_routes() -> Markup:
    """The routes of scenes without an axis."""
    rows = [[f"`{route.name}`<br>{plain(route.title)}", plain(route.domain), plain(route.error_model)]
            for route in GENERAL_CATALOGUE]
    return table(["route", "serves", "error from"], rows, label="tab-general-routes", caption="Routes without an axis. "
                 f"A plan takes the first of {' and '.join(f'`{name}`' for name in GENERAL_AUTO)} that serves.")


def scenes(friction: float) -> Markup:
    """What different scenes become: class, distances, route, directions, error."""
    principal = GeneralFabric(((0.5, 0.0, 0.0), (0.0, -0.1, 0.0), (0.0, 0.0, -0.4)))
    upright_branches = GeneralFabric(tilted(D33, TILT).D, Dr=tilted(-0.3, 0.0).D)
    level = GeneralLoading(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), friction=friction)
    cases = (
        ("axial fabric, equal contacts", tilted(D33, TILT), None),
        ("axial fabric, isotropic stress, slip", tilted(D33, TILT), level),
        ("three principal values, equal contacts", principal, None),
        ("three principal values, vertical stress, slip", principal, example(friction=friction)),
        ("normals and branches about two axes, equal contacts", upright_branches, None),
        ("tilted fabric, vertical stress, none slides", tilted(D33, TILT), example(friction=STICKS)),
        ("tilted fabric, vertical stress, some slide", tilted(D33, TILT), example(friction=friction)),
    )
    found = [[name, *_what_becomes(fabric, loading)] for name, fabric, loading in cases]
    rows = [[name, symmetry, f"{axial}, {orthotropic}", f"`{route}`", error]
            for name, symmetry, axial, orthotropic, route, _, error in found]
    heads = ["scene", "class", "to_transversely_isotropic", "to_orthotropic", "route", "directions", "error"]
    return table(["scene", "class", "distances", "route", "error"], rows, label="tab-general-scenes", align="llrll",
                 look="words-first", take_away="general_scenes.csv", taken=[heads, *found],
                 caption="What scenes become at the default accuracy, with their distances to transverse isotropy and "
                 "to orthotropy. Axes are found, not asked for.")


def picture(loading: GeneralLoading) -> Static:
    """Stiffness by direction, and distance to symmetry against tilt."""
    return Static(tilted_fabric(D33, loading, _by_tilt(loading), degrees=TILT, poisson_ratio=NU))


def picture_numbers(loading: GeneralLoading) -> Markup:
    """The second panel as numbers."""
    found = _by_tilt(loading)
    if any(one.name != "general" for one in found[1:-1]) or found[0].name == found[-1].name:
        raise AssertionError("the page says that only the ends belong to a class")
    return numbers_to_take_away("distance_by_tilt.csv", {
        "tilt_degrees": TILTS, "to_transversely_isotropic": [one.transversely_isotropic for one in found],
        "to_orthotropic": [one.orthotropic for one in found]}, digits=4)


@lru_cache(maxsize=1)
def _by_tilt(loading: GeneralLoading) -> tuple[Symmetry, ...]:
    return by_tilt(D33, loading, poisson_ratio=NU)


def _what_becomes(fabric: GeneralFabric, loading: GeneralLoading | None) -> list[str]:
    found = general_stiffness(fabric, poisson_ratio=NU, hypothesis="kinematic", loading=loading)
    symmetry = classify(found.rows, tolerance=max(found.relative_error, 1e-12))
    return [symmetry.name, _percent(symmetry.transversely_isotropic), _percent(symmetry.orthotropic),
            found.route, str(found.evaluations), f"{found.relative_error:.0e} {found.error_is}"]


def _turned_fabric(fabric: GeneralFabric) -> GeneralFabric:
    return GeneralFabric(_turned(fabric.D))


def _turned(tensor: Tensor) -> Tensor:
    import numpy as np

    turn = np.array(OTHER_FRAME)
    one, two, three = (turn @ np.array(tensor) @ turn.T).tolist()
    return tuple(one), tuple(two), tuple(three)


def _apart(one: object, other: object) -> float:
    """Worst difference over the largest entry."""
    import numpy as np

    return float(np.abs(np.array(one) - np.array(other)).max() / np.abs(np.array(other)).max())


def _error(found: GeneralStiffness) -> str:
    return (f"Route `{found.route}`, {found.evaluations} directions, error {found.relative_error:.0e} "
            f"({found.error_is})")


def _entry(value: float, least: float) -> str:
    return "0" if abs(value) <= least else f"{value:.5f}".replace("-", "−")


def _percent(distance: float) -> str:
    return "0" if distance < 1e-8 else f"{100 * distance:.2f} %"


def _without_sign(axis: tuple[float, float, float]) -> tuple[float, ...]:
    """Rounded, the largest part positive: an axis has no sign."""
    sign = 1 if max(axis, key=abs) > 0 else -1
    return tuple(round(sign * part, 3) + 0.0 for part in axis)


def _frame(frame: tuple[tuple[float, float, float], ...]) -> str:
    return "axes " + ", ".join(f"({_parts(row)})" for row in frame)


def _parts(axis: tuple[float, float, float]) -> str:
    return ", ".join(f"{part:.3f}".replace("-", "−") for part in _without_sign(axis))
