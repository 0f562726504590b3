"""What a sweep file and the data file of a fit may say, whole example scenes, and what is refused in any of them."""

from __future__ import annotations

import inspect
import json

import granular
from granular.errors import CATALOGUE
from granular.fields import Kind
from granular.fitting.data import FitTable
from granular.fitting.quantities import SPEED, SPEEDS
from granular.routes.result import COMPONENTS
from granular.sweeps.axes import RANGE_KEYS, SPACINGS
from granular.sweeps.definition import DEFAULT_OUTPUTS
from page_tools.markup import Markup, plain, table
from page_tools.reference_scene import EXAMPLES, files, label_of, taken
from page_tools.reference_text import items, prose, sections

SWEEP_KEYS = {"sweep.grid": "grid", "sweep.list": "together", "sweep.run.outputs": "outputs",
              "sweep.run.engine": "engine", "sweep.run.route": "route", "sweep.run.chunk": "chunk"}
"""Key of a sweep file -> the argument of ``granular.sweep`` that means the same, and explains it."""

SUBJECTS = ("INP", "UNI", "SCN", "FAB", "GRD", "SWP", "FIT", "NUM")
"""Letters in the codes of what a file can be refused for."""


def example_scenes() -> Markup:
    """Every example scene, whole and to take away."""
    return Markup("\n\n".join(_listing(path.name) for path in files()))


def _listing(file: str) -> str:
    path = f"../{EXAMPLES.relative_to(EXAMPLES.parents[2]).as_posix()}"
    beside = "".join(f", with {{download}}`{name} <{path}/{name}>` beside it" for name in _named_in(file))
    return (f"```{{literalinclude}} {path}/{file}\n:language: toml\n:name: {label_of(file)}\n"
            f":caption: \"{{download}}`{file} <{path}/{file}>`{beside}\"\n```")


def _named_in(file: str) -> list[str]:
    text = (EXAMPLES / file).read_text(encoding="utf-8")
    return [path.name for path in sorted(EXAMPLES.glob("*.csv")) if f'"{path.name}"' in text]


def sweep_keys() -> Markup:
    """Keys of a sweep file, explained as the arguments of ``granular.sweep`` are."""
    told = {name: body for head, body in items(sections(inspect.getdoc(granular.sweep) or "")["Parameters"])
            for name in head.partition(" : ")[0].split(", ")}
    defaults = inspect.signature(granular.sweep).parameters
    rows = [[f"`{key}`", prose(told[argument]), _default(key, defaults[argument].default)]
            for key, argument in SWEEP_KEYS.items()]
    return table(["key", "what it says", "default"], rows, label="tab-sweep-keys", look="reference",
                 caption="Keys of a sweep file, beside those of a scene.")


def _default(key: str, value: object) -> str:
    if key.endswith("outputs"):
        return "; ".join(f"`{engine}`: {', '.join(kept)}" for engine, kept in DEFAULT_OUTPUTS.items())
    return "none" if value is None else f"`{json.dumps(value)}`"


def range_keys() -> Markup:
    """How a range is written, in one sentence."""
    words = ", ".join(f"`{key}`" for key in RANGE_KEYS[:-1])
    return Markup(f"A range is a table with the keys {words} and, where it is not "
                  f"`\"{SPACINGS[0]}\"`, `{RANGE_KEYS[-1]} = \"{SPACINGS[1]}\"`.")


def measured_quantities() -> Markup:
    """What can be measured, by its name in the data file."""
    rows = [[f"`{name}`", f"[{SPEED.si}]", f"density times its square is `{component}`"]
            for name, component in SPEEDS.items()]
    rows += [[f"`{name}`", r"\[Pa\]", "component of the stiffness"] for name in COMPONENTS]
    rows.append(["two of one kind, such as `C1111/C3333`", r"\[-\]", "their ratio"])
    return table(["name", "unit", "what it is"], rows, label="tab-measured", look="reference",
                 caption="What a fit can start from.")


def fit_keys() -> Markup:
    """Keys of the table ``[fit]``."""
    return Markup("\n\n".join(
        f"::::{{confval}} fit.{name}\n\n{plain(field.description or '').capitalize()}.\n\n"
        f"- Takes: {taken(_kind(field))}\n- Default: `{json.dumps(field.default)}`\n\n::::"
        for name, field in FitTable.model_fields.items()))


def _kind(field: object) -> Kind:
    return next(kind for kind in getattr(field, "metadata", ()) if isinstance(kind, Kind))


def refusals_of_files() -> Markup:
    """Refusals that a file can meet, each a link to its section."""
    rows = [[f"{{ref}}`{kind.code} <error-{kind.code.lower()}>`", plain(kind.title)]
            for kind in CATALOGUE if kind.code.split("-")[1] in SUBJECTS]
    return table(["code", "what it means"], rows, label="tab-file-refusals", look="reference",
                 caption="What a scene, a sweep or a data file can be refused for.")
