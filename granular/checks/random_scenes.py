"""Random scenes, whole ones with units and lists of effects, from the ordinary to the ends of what is served."""

from __future__ import annotations

import json
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.checks.sample import admissible_sample
from granular.loading import Loading

if TYPE_CHECKING:
    from granular.scene import Scene

Tables = dict[str, dict[str, Any]]
"""A scene as its file holds it."""

SPREADS = (1 + 1e-9, 1 + 1e-7, 1 + 1e-6, 1.00001, 1.0001, 1.001, 1.05, 1.1, 1.2, 1.35, 1.5, 2.0, 2.5, 3.0, 5.0, 10.0)
"""Spreads of lognormal sizes; a list, so that each moment is computed once."""

NARROW = SPREADS[:9]
"""Those with which a gradation may be too weak to matter, and a few on."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RandomScene:
    """One random scene.

    Attributes
    ----------
    number : int
        Which of the sample, from 1.
    kind : str
        What is special about it.
    tables : dict
        Its tables, as a scene file holds them.
    """

    number: int
    kind: str
    tables: Tables

    @property
    def scene(self) -> Scene:
        """The scene itself, validated."""
        from granular.scene import Scene

        return Scene.model_validate(self.tables)

    def toml(self) -> str:
        """The scene as the text of a scene file, every number with all its digits."""
        blocks = (f"[{name}]\n" + "".join(f"{key} = {_written(value)}\n" for key, value in table.items())
                  for name, table in self.tables.items())
        return "\n".join(blocks)


def random_scenes(count: int, *, seed: int) -> Iterator[RandomScene]:
    """Draw scenes of every kind in turn.

    Parameters
    ----------
    count : int
        How many [-].
    seed : int
        Start of the random numbers; the same seed gives the same scenes, and a longer sample begins with a shorter one.

    Returns
    -------
    iterator of RandomScene
        Scenes without a wanted accuracy that have a finite stiffness. The kinds are those of ``KINDS``: contact normals
        and branch lengths to the ends of their intervals; stress ratios mostly from 1e-3 to 1e3, some next to 1, some
        from 1e-10 to 1e10 or exactly 0; friction that lets every contact stick, lets some slide, is within 1e-1 to
        1e-14 of the onset of sliding, or is zero, tiny or huge; a tension along one axis; spheroids with aspect ratios
        from 1e-3 to 1e3 and within 1e-1 to 1e-16 of 1; gradations; and features of 1e-14 to 1e-2, several at once or
        beside an extreme one.
        Poisson's ratio is 0, 1/2 or tiny in half of them, and the hypothesis is static in a third where that is finite.

    Notes
    -----
    Accuracy: every scene is admissible exactly. Source: eqs (14), (18), (20)-(23).

    Examples
    --------
    >>> [scene.kind for scene in random_scenes(3, seed=1)]
    ['isotropic', 'packing', 'branches']
    """
    names = tuple(KINDS)
    for number in range(1, count + 1):
        rng = random.Random(f"{seed} {number}")
        kind = names[(number - 1) % len(names)]
        yield RandomScene(number=number, kind=kind, tables=KINDS[kind](rng))


def _written(value: object) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_written(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(_written(item) for item in value) + "]"
    return json.dumps(value) if isinstance(value, str) else repr(value)


def _base(rng: random.Random) -> Tables:
    """Solid, density of the packing and mean stress."""
    nu = rng.choice((0.0, 0.5, math.exp2(rng.uniform(-60, -2)), *(rng.uniform(0, 0.5) for _ in range(3))))
    packing: dict[str, Any] = {"void_ratio": rng.uniform(0.3, 1.2)}
    if rng.random() < 0.5:
        packing["coordination_number"] = rng.uniform(3, 12)
    return {"grains": {"shear_modulus": 10 ** rng.uniform(6, 12), "poisson_ratio": nu}, "packing": packing,
            "stress": {"mean": 10 ** rng.uniform(0, 8)}}


def _normals(rng: random.Random, tables: Tables) -> None:
    fabric, _ = next(admissible_sample(1, seed=rng.getrandbits(32)))
    normals = {"D33": fabric.D33}
    if fabric.D3333:
        normals["D3333"] = fabric.D3333
    tables["packing"]["contact_normals"] = normals


def _branches(rng: random.Random, tables: Tables) -> None:
    fabric, _ = next(admissible_sample(1, seed=rng.getrandbits(32)))
    tables["branches"] = {"anisotropy": {"D33": fabric.Dr33}}
    if rng.random() < 0.3:
        tables["branches"]["length_ratio"] = rng.uniform(0.5, 2)


def _fabric(rng: random.Random, tables: Tables) -> None:
    """Normals in three of four scenes, branches in two of three."""
    if rng.random() < 0.75:
        _normals(rng, tables)
    if rng.random() < 0.67:
        _branches(rng, tables)


def _ratio(rng: random.Random, tables: Tables, *, positive: bool = False) -> None:
    kind = rng.randrange(10)
    ratio = 10 ** rng.uniform(-10, 10) if kind == 0 else 10 ** rng.uniform(-3, 3)
    if kind == 1:
        ratio = 1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-15, -1)
    if kind == 2 and not positive:
        ratio = 0.0
    tables["stress"]["ratio"] = ratio


def _onset(tables: Tables) -> float:
    """Friction coefficient at which the first contacts slide; 0 where no contact carries a shear force."""
    a, c = Loading.of_ratio(tables["stress"].get("ratio", 1.0)).coefficients(_d33(tables))
    return math.sqrt((c - a) ** 2 / (4 * a * c)) if a > 0 and c > 0 else math.inf


def _d33(tables: Tables) -> float:
    return float(tables["packing"].get("contact_normals", {}).get("D33", 0.0))


def _effects(tables: Tables, *names: str) -> None:
    tables.setdefault("model", {})["effects"] = list(names)


def _perhaps_static(rng: random.Random, tables: Tables, *, share: float = 1 / 3) -> Tables:
    """Choose the static hypothesis for some, unless contacts slide or have opened."""
    loading = Loading.of_ratio(tables["stress"].get("ratio", 1.0), friction=tables["grains"].get(
        "friction_coefficient"))
    if rng.random() < share and not loading.slides(_d33(tables)):
        tables.setdefault("model", {})["hypothesis"] = "static"
    return tables


def _isotropic(rng: random.Random) -> Tables:
    tables = _base(rng)
    if rng.random() < 0.5:
        tables["grains"]["friction_coefficient"] = 10 ** rng.uniform(-3, 1)
    return _perhaps_static(rng, tables)


def _packing(rng: random.Random) -> Tables:
    tables = _base(rng)
    _normals(rng, tables)
    if rng.random() < 0.7:
        _effects(tables, "packing")
    return _perhaps_static(rng, tables)


def _only_branches(rng: random.Random) -> Tables:
    tables = _base(rng)
    _branches(rng, tables)
    if rng.random() < 0.6:
        _normals(rng, tables)
        _effects(tables, "packing", "branches")
    return _perhaps_static(rng, tables)


def _kinetic(rng: random.Random) -> Tables:
    tables = _base(rng)
    _fabric(rng, tables)
    _ratio(rng, tables)
    return _perhaps_static(rng, tables)


def _with_friction(rng: random.Random, choose: Callable[[float], float]) -> Tables:
    """A loaded scene, and friction by what it takes until the first contacts slide."""
    while True:
        tables = _base(rng)
        _fabric(rng, tables)
        _ratio(rng, tables, positive=True)
        onset = _onset(tables)
        if 0 < onset < math.inf:
            tables["grains"]["friction_coefficient"] = choose(onset)
            return _perhaps_static(rng, tables)


def _sticking(rng: random.Random) -> Tables:
    return _with_friction(rng, lambda onset: onset * 10 ** rng.uniform(0.02, 3))


def _sliding(rng: random.Random) -> Tables:
    return _with_friction(rng, lambda onset: onset * 10 ** -rng.uniform(0.02, 3))


def _tangency(rng: random.Random) -> Tables:
    exactly = rng.random() < 0.1
    away = 0.0 if exactly else rng.choice((-1, 1)) * 10 ** rng.uniform(-14, -1)
    return _with_friction(rng, lambda onset: onset * (1 + away))


def _friction_at_its_ends(rng: random.Random) -> Tables:
    power = rng.choice((rng.uniform(-10, -3), rng.uniform(3, 10)))
    friction = 0.0 if rng.random() < 0.2 else 10**power
    return _with_friction(rng, lambda _onset: friction)


def _opening(rng: random.Random) -> Tables:
    tables = _base(rng)
    _fabric(rng, tables)
    _stretched(rng, tables, rng.random() if rng.random() < 0.6 else 10 ** rng.uniform(-15, 0))
    if rng.random() < 0.7:
        tables["grains"]["friction_coefficient"] = 10 ** rng.uniform(-2, 2)
    return tables


def _stretched(rng: random.Random, tables: Tables, share: float) -> None:
    """A tension along one axis; at a share of 1 the mean stress almost vanishes."""
    size = 10 ** rng.uniform(1, 8)
    across, along = (size, -1.9 * share * size) if rng.random() < 0.5 else (-0.45 * share * size, size)
    tables["stress"] = {"tensor": [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, along]]}


def _shape(rng: random.Random) -> dict[str, Any]:
    near = 1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-16, -1)
    shape: dict[str, Any] = {"aspect_ratio": near if rng.random() < 1 / 3 else 10 ** rng.uniform(-3, 3)}
    if rng.random() < 0.5:
        shape["spin"] = "relaxed"
    return shape


def _spheroids(rng: random.Random) -> Tables:
    """Spheroids whose contacts all have the same stiffness."""
    tables = _base(rng) | {"shape": _shape(rng)}
    if rng.random() < 0.7:
        _normals(rng, tables)
        _effects(tables, "packing", "deviation")
    return tables if "spin" in tables["shape"] else _perhaps_static(rng, tables)


def _spheroids_with_forces(rng: random.Random) -> Tables:
    """Spheroids whose contact stiffness follows the force."""
    while True:
        tables = _base(rng) | {"shape": _shape(rng)}
        if rng.random() < 0.6:
            _normals(rng, tables)
        _ratio(rng, tables, positive=True)
        if 0 < _onset(tables) < math.inf:
            break
    if rng.random() < 0.6:
        tables["grains"]["friction_coefficient"] = _onset(tables) * 10 ** rng.uniform(-1, 1)
    return tables if "spin" in tables["shape"] else _perhaps_static(rng, tables)


def _graded(rng: random.Random) -> Tables:
    tables = rng.choice((_isotropic, _packing, _only_branches, _kinetic, _sticking, _sliding, _spheroids))(rng)
    tables["gradation"] = _sizes(rng, SPREADS)
    effects = tables.get("model", {}).get("effects")
    if effects is not None:
        effects.append("gradation")
    return tables


def _sizes(rng: random.Random, spreads: tuple[float, ...]) -> dict[str, Any]:
    sizes: dict[str, Any] = {"distribution": "lognormal", "median": 10 ** rng.uniform(-5, -1),
                             "spread": rng.choice(spreads)}
    if rng.random() < 0.5:
        sizes["form"] = "classical"
    return sizes


def _small(rng: random.Random) -> float:
    """Mostly from 1e-14 to 1e-2 of either sign; for a sixth an ordinary number, for a third none."""
    kind = rng.randrange(6)
    if kind < 2:
        return 0.0
    return rng.uniform(-0.5, 0.8) if kind == 2 else _faint_number(rng)


def _faint(rng: random.Random) -> Tables:
    """Several features, each of which may be too weak to matter at a coarse accuracy."""
    tables = _base(rng)
    tables["packing"]["contact_normals"] = {"D33": _small(rng), "D3333": _small(rng) / 3}
    if rng.random() < 0.2:
        tables["shape"] = {"aspect_ratio": 1 + _small(rng), "spin": rng.choice(("fixed", "relaxed"))}
        tables["packing"]["contact_normals"]["D33"] = 0.0  # equal forces: what can be certified
    else:
        tables["branches"] = {"anisotropy": {"D33": _small(rng)}}
        tables["stress"]["ratio"] = 1 + _small(rng)
        kind = rng.randrange(4)
        if kind:
            onset = max(_onset(tables), 1e-12)
            tables["grains"]["friction_coefficient"] = (
                onset * 10 ** rng.uniform(0, 6), 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(2, 12))[kind - 1]
    if rng.random() < 0.4:
        tables["gradation"] = _sizes(rng, NARROW)
    relaxed = tables.get("shape", {}).get("spin") == "relaxed"
    return tables if relaxed else _perhaps_static(rng, tables)


def _faint_beside_extreme(rng: random.Random) -> Tables:
    """One feature to its end, and others that may be too weak to matter beside it."""
    tables = _base(rng)
    extreme = rng.choice((_normals, _branches, _ratio, _round_or_not, _hardly_pulled))
    extreme(rng, tables)
    if "shape" not in tables and "branches" not in tables and rng.random() < 0.7:
        tables["branches"] = {"anisotropy": {"D33": _faint_number(rng)}}
    if "contact_normals" not in tables["packing"] and rng.random() < 0.7:
        tables["packing"]["contact_normals"] = {"D33": _faint_number(rng)}
        if rng.random() < 0.5:
            tables["packing"]["contact_normals"]["D3333"] = _faint_number(rng) / 3
    if "shape" in tables:
        _effects(tables, "packing", "deviation")
    if extreme in (_normals, _branches):  # forces are almost equal where the stress makes up for the normals
        d33 = _d33(tables)
        tables["stress"]["ratio"] = (5 + 2 * d33) / (5 - d33) * (1 + _faint_number(rng))
    if "shape" not in tables and rng.random() < 0.6:
        onset = _onset(tables)
        scale = onset if 0 < onset < math.inf else 1.0
        tables["grains"]["friction_coefficient"] = scale * 10 ** rng.uniform(0, 10)
    if "shape" not in tables and rng.random() < 0.3:
        tables["gradation"] = _sizes(rng, NARROW)
    return tables if "tensor" in tables["stress"] or "spin" in tables.get("shape", {}) else _perhaps_static(rng, tables)


def _round_or_not(rng: random.Random, tables: Tables) -> None:
    tables["shape"] = _shape(rng)


def _hardly_pulled(rng: random.Random, tables: Tables) -> None:
    """A tension along one axis that is a small part of the compression along the other."""
    _stretched(rng, tables, 10 ** rng.uniform(-15, -3))


def _faint_number(rng: random.Random) -> float:
    return float(rng.choice((-1, 1)) * 10 ** rng.uniform(-14, -2))


def _all_at_once(rng: random.Random) -> Tables:
    """Normals, branches, stress, friction and gradation together, none of them extreme."""
    tables = _base(rng)
    tables["packing"]["contact_normals"] = {"D33": rng.uniform(-0.8, 1.2), "D3333": rng.uniform(-0.1, 0.1)}
    tables["branches"] = {"anisotropy": {"D33": rng.uniform(-0.6, 0.8)}, "length_ratio": rng.uniform(0.8, 1.2)}
    tables["stress"]["ratio"] = 10 ** rng.uniform(-0.6, 0.6)
    tables["grains"]["friction_coefficient"] = rng.uniform(0.1, 1)
    tables["gradation"] = _sizes(rng, tuple(spread for spread in SPREADS if 1.05 <= spread <= 3))
    return _perhaps_static(rng, tables)


KINDS: dict[str, Callable[[random.Random], Tables]] = {
    "isotropic": _isotropic, "packing": _packing, "branches": _only_branches, "kinetic": _kinetic,
    "sticking": _sticking, "sliding": _sliding, "next to sliding": _tangency,
    "friction at its ends": _friction_at_its_ends, "opening": _opening, "spheroids": _spheroids,
    "spheroids with forces": _spheroids_with_forces, "gradation": _graded, "faint": _faint,
    "faint beside extreme": _faint_beside_extreme, "all at once": _all_at_once,
}
"""Kinds of scenes, drawn in this order over and over."""
