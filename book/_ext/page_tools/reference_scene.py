"""What a scene file may say, from the models that read it: every key with its kind, bounds, default and example."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any, get_args

from pydantic.fields import FieldInfo

from granular import GranularError, Scene, plan
from granular.effects import CATALOGUE as EFFECTS
from granular.fields import Kind, Number, Text, Word, WordsOrAuto
from granular.fitting.data import Names
from granular.scene_file import read_scene
from granular.sweeps.scene_fields import SceneField, scene_fields, table_types
from granular.table import Table
from granular.tensors import FourthRankTensor, SymmetricTensor
from page_tools.contents import BOOK
from page_tools.markup import Markup, table
from page_tools.reference_text import prose, quoted

EXAMPLES = BOOK.parent / "granular" / "data" / "scenes"
"""Whole scenes; together they use every key of a scene file, which a test demands."""

BASE: dict[str, Any] = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_coefficient": 0.3},
    "packing": {"void_ratio": 0.5744}, "stress": {"mean": "28 kPa"}}
"""A scene that calls for no effect, to which one key is added."""

NEEDED = "needed"


def files() -> list[Path]:
    """The example scenes."""
    return sorted(EXAMPLES.glob("*.toml"))


def overview() -> Markup:
    """Every key in one table, and in full in the file beside it."""
    rows = [[f"{{confval}}`{field.name}`", taken(field.kind), quoted(default(field.name))]
            for field in scene_fields().values()]
    full = [[field.name, ", ".join(bare(field.kind)), default(field.name), field.description,
             " ".join(feeds(field.name)), example(field.name)[0]] for field in scene_fields().values()]
    return table(["key", "takes", "default"], rows, label="tab-scene-keys", look="reference",
                 caption="Keys of a scene file.", take_away="scene_keys.csv",
                 taken=[["key", "takes", "default", "meaning", "feeds", "example"], *full])


def keys_of(name: str) -> Markup:
    """All that is known of the keys of one table of a scene file."""
    about = prose(_sentence(table_types()[name].__doc__ or ""))
    return Markup("\n\n".join([about, *(_entry(field) for field in scene_fields().values() if field.table == name)]))


def _sentence(doc: str) -> str:
    return doc.partition("\n\n")[0]


def _entry(field: SceneField) -> str:
    line, file = example(field.name)
    effects = ", ".join(f"`{effect}`" for effect in feeds(field.name))
    facts = {"Takes": taken(field.kind), "Default": quoted(default(field.name)), "Feeds": effects,
             "Example": f"`{line}` in {{ref}}`{file} <{label_of(file)}>`"}
    told = "\n".join(f"- {name}: {fact}" for name, fact in facts.items() if fact)
    return f"::::{{confval}} {field.name}\n\n{_capital(prose(field.description))}.\n\n{told}\n\n::::"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def label_of(file: str) -> str:
    """Label of the section that shows an example scene."""
    return f"sec-scene-{file.removesuffix('.toml').replace('_', '-')}"


def taken(kind: Kind) -> str:
    """What a key takes, as markup."""
    return quoted(", ".join(bare(kind)))


def bare(kind: Kind) -> list[str]:
    """What a key takes: its kind with its unit, and its bounds or choices."""
    match kind:
        case Number():
            return [_quantity(kind), *_bounds(kind)]
        case SymmetricTensor():
            return [f"three rows of three numbers, each a {_quantity(kind)}", "symmetric",
                    *(["traceless"] if kind.traceless else [])]
        case FourthRankTensor():
            return ["lists of three numbers, four deep, each a pure number"]
        case Word():
            return ["a word", *_choices(kind.words)]
        case Names():
            return ["a list", *_choices(kind.words)]
        case WordsOrAuto():
            return ['"auto"', "or a list", *_choices(kind.words)]
        case Text():
            return ["a text"]
    return [json.dumps(kind.json_schema())]


def _quantity(kind: Number | SymmetricTensor) -> str:
    dimension = kind.dimension
    return "pure number" if dimension is None else f"{dimension.name} [{dimension.si}]"


def _bounds(kind: Number) -> list[str]:
    ends = ((">", kind.above), (">=", kind.at_least), ("<=", kind.at_most), ("<", kind.below))
    found = [f"{sign} {end:g}" for sign, end in ends if end is not None]
    return [" and ".join(found) + (f" ({kind.why})" if kind.why else "")] if found else []


def _choices(words: tuple[str, ...]) -> list[str]:
    return ["out of " + ", ".join(f'"{word}"' for word in words)]


@cache
def _models() -> dict[str, FieldInfo]:
    return dict(_walk(Scene, ""))


def _walk(model: type[Table], above: str) -> Iterator[tuple[str, FieldInfo]]:
    for key, field in model.model_fields.items():
        name = f"{above}.{key}".lstrip(".")
        yield name, field
        for inner in (field.annotation, *get_args(field.annotation)):
            if isinstance(inner, type) and issubclass(inner, Table):
                yield from _walk(inner, name)


def default(name: str) -> str:
    """What stands for a key that is not given: its value, that nothing does, or that it has to be."""
    field = _models()[name]
    if field.is_required():
        return NEEDED
    return "none" if field.default is None else json.dumps(field.default)


@cache
def scenes() -> dict[str, dict[str, Any]]:
    """The example scenes as they stand in their files."""
    return {path.name: tomllib.loads(path.read_text(encoding="utf-8")) for path in files()}


def value_in(scene: dict[str, Any], name: str) -> Any:
    """The value of a key in a scene, None where it has none."""
    *path, key = name.split(".")
    return _at(scene, path).get(key)


def example(name: str) -> tuple[str, str]:
    """A line with a key, and the example scene that has it."""
    file, value = next((file, found) for file, scene in scenes().items()
                       if (found := value_in(scene, name)) is not None)
    key = name.rpartition(".")[2]
    text = json.dumps(value)
    return f"{key} = {text if len(text) < 80 else '[[[[0.2, 0, 0], ...], ...], ...]'}", file


@cache
def feeds(name: str) -> tuple[str, ...]:
    """Effects that a key may call for: with the values that example scenes give it, alone or beside what they have."""
    found = set[str]()
    for file, scene in scenes().items():
        if value_in(scene, name) is not None and not name.startswith("model."):
            read = read_scene(EXAMPLES / file)
            read.pop("model", None)
            found |= (_effects(read) - _effects(_without(read, name))) | (_effects(_alone(read, name)) - _effects(BASE))
    return tuple(effect.name for effect in EFFECTS if effect.name in found)


def _effects(scene: dict[str, Any]) -> set[str]:
    return set(plan(Scene.model_validate(scene)).called_for)


def _without(scene: dict[str, Any], name: str) -> dict[str, Any]:
    """A scene without a key, or as it is where it needs the key."""
    less = deepcopy(scene)
    *path, key = name.split(".")
    del _at(less, path)[key]
    return less if _is_scene(less) else scene


def _alone(scene: dict[str, Any], name: str) -> dict[str, Any]:
    """A scene without any effect but for one key of another scene; what else its table needs is zero or as it was."""
    *path, key = name.split(".")
    given, plain_table = _at(scene, path), _at(BASE, path)
    zero = {other: _zero(value) for other, value in given.items()}
    for others in (plain_table, {}, zero, given):
        built = deepcopy(BASE)
        home = built
        for part in path[:-1]:
            home = home.setdefault(part, {})
        home[path[-1]] = {**others, key: given[key]}
        if _is_scene(built):
            return built
    return BASE


def _at(scene: dict[str, Any], path: list[str]) -> dict[str, Any]:
    for part in path:
        scene = scene.get(part, {})
    return scene


def _zero(value: Any) -> Any:
    if isinstance(value, list):
        return [_zero(part) for part in value]
    return 0 if isinstance(value, float | int) else value


def _is_scene(tables: dict[str, Any]) -> bool:
    try:
        Scene.model_validate(tables)
    except GranularError:
        return False
    return True
