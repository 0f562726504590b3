"""The published JSON schema of a scene, generated from the models."""

from __future__ import annotations

import json
from typing import Any

from pydantic import BaseModel


def schema_of(model: type[BaseModel]) -> dict[str, Any]:
    """JSON schema of a model, without the null that Python needs and a TOML file cannot hold.

    Parameters
    ----------
    model : type
        The scene model.

    Returns
    -------
    dict
        JSON schema, draft 2020-12.

    Notes
    -----
    Source: generated from the models, never typed.
    """
    schema: dict[str, Any] = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **_without_null(model.model_json_schema()),
    }
    definitions = schema["$defs"]
    definitions["Grains"]["not"] = {"required": ["friction_angle", "friction_coefficient"]}
    definitions["Grains"]["description"] += " At most one of friction_angle and friction_coefficient."
    definitions["ContactNormals"]["oneOf"] = _either("D33", "tensor", forbid=("D3333",), besides=("tensor4",))
    definitions["BranchAnisotropy"]["oneOf"] = _either("D33", "tensor")
    definitions["Stress"]["oneOf"] = _either("mean", "tensor", forbid=("ratio",))
    definitions["Packing"]["not"] = {"required": ["coordination_number", "coordination_relation"]}
    definitions["Packing"]["description"] += " At most one of coordination_number and coordination_relation."
    definitions["Gradation"]["oneOf"] = [_complete("lognormal", ("median", "spread"), forbid=("file",)),
                                         _complete("curve", ("file",), forbid=("median", "spread", "form"))]
    schema["not"] = {"anyOf": [{"required": ["branches", "shape"]}, _both("shape", "spin", "relaxed",
                                                                          "model", "hypothesis", "static")]}
    return schema


def schema_text(model: type[BaseModel]) -> str:
    """The schema as the text of the published file.

    Parameters
    ----------
    model : type
        The scene model.

    Returns
    -------
    str
        Indented JSON with a final newline.

    Notes
    -----
    Source: generated from the models, never typed.
    """
    return json.dumps(schema_of(model), indent=2, ensure_ascii=False) + "\n"


def _either(first: str, second: str, *, forbid: tuple[str, ...] = (),
            besides: tuple[str, ...] = ()) -> list[dict[str, Any]]:
    """One of two keys, each without the other one and what goes with that."""
    return [{"required": [key], "not": _any_of(*others)}
            for key, others in ((first, (second, *besides)), (second, (first, *forbid)))]


def _any_of(*keys: str) -> dict[str, Any]:
    """At least one of some keys."""
    return {"required": list(keys)} if len(keys) == 1 else {"anyOf": [{"required": [key]} for key in keys]}


def _complete(distribution: str, needed: tuple[str, ...], *, forbid: tuple[str, ...]) -> dict[str, Any]:
    """A gradation of one kind, with the keys that it needs and without those of the other kind."""
    return {"properties": {"distribution": {"const": distribution}}, "required": list(needed),
            "not": {"anyOf": [{"required": [key]} for key in forbid]}}


def _both(first: str, first_key: str, first_value: str, second: str, second_key: str,
          second_value: str) -> dict[str, Any]:
    """Two tables that each hold a key with a certain value."""
    return {"required": [first, second],
            "properties": {table: {"required": [key], "properties": {key: {"const": value}}}
                           for table, key, value in ((first, first_key, first_value),
                                                     (second, second_key, second_value))}}


def _without_null(node: Any) -> Any:
    if isinstance(node, list):
        return [_without_null(item) for item in node]
    if not isinstance(node, dict):
        return node
    node = {key: _without_null(item) for key, item in node.items()
            if not (key == "default" and item is None) and not (key == "title" and isinstance(item, str))}
    choices = [choice for choice in node.get("anyOf", []) if choice != {"type": "null"}]
    if len(choices) == 1 and len(node["anyOf"]) == 2:
        del node["anyOf"]
        node = {**choices[0], **node}
    return node
