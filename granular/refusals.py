"""From a pydantic report to one sentence: the first mistake in full, and how many more there are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from pydantic import BaseModel, ValidationError

from granular.errors import GranularError, MissingKey, UnknownKey, WrongType
from granular.fields import Kind, nearest
from granular.units import shown

Homes = Callable[[], dict[str, str]]
"""Gives, for every key of a scene, the table it belongs to."""


@contextmanager
def one_sentence(model: type[BaseModel], *, homes: Homes) -> Iterator[None]:
    """Turn the ValidationError of a model into a GranularError that names value, bound and remedy.

    Parameters
    ----------
    model : type
        The model being built; its keys are the known ones.
    homes : callable
        Table of every key, for keys that stand in the wrong one.

    Raises
    ------
    GranularError
        In place of every ``pydantic.ValidationError``.

    Notes
    -----
    Source: the error format of this package.
    """
    try:
        yield
    except ValidationError as error:
        raise _first_of(error, model, homes) from None
    except TypeError as error:
        if "keywords must be strings" not in str(error):
            raise
        raise WrongType("a key is not text", allowed="allowed only text as keys",
                        remedy="Write every key as a string.") from None


def _first_of(error: ValidationError, model: type[BaseModel], homes: Homes) -> GranularError:
    """The mistake to report: an unknown key before all others, for it often makes another one missing.

    Only that one is put into words. A hostile file can have as many mistakes as it has bytes.
    """
    items = error.errors(include_url=False)
    first = _refusal(min(items, key=lambda item: not _is_unknown_key(item)), model, homes)
    more = len(items) - 1 + sum(getattr(_inner(item), "more", 0) for item in items)
    return type(first)(first.found, allowed=first.allowed, remedy=first.remedy, more=more)


def _is_unknown_key(item: Any) -> bool:
    return item["type"] == "extra_forbidden" or isinstance(_inner(item), UnknownKey)


def _inner(item: Any) -> Any:
    return item.get("ctx", {}).get("error")


def _refusal(item: Any, model: type[BaseModel], homes: Homes) -> GranularError:
    """One mistake. A refusal from a table inside this one is already worded and only lacks the table's name."""
    name = ".".join(str(part) for part in item["loc"])
    inner = _inner(item)
    if isinstance(inner, GranularError):
        found = inner.found if not name or _is_leaf(name, model) else f"{name}.{inner.found}"
        return type(inner)(found, allowed=inner.allowed, remedy=inner.remedy, more=inner.more)
    if item["type"] == "extra_forbidden":
        return _unknown_key(name, model, homes)
    if item["type"] == "missing":
        description = model.model_fields[name].description
        return MissingKey(f"{name} is not given", allowed="a scene needs it",
                          remedy=f"Add {name} ({description}).")
    return WrongType(f"{name or 'scene'} = {shown(item['input'])}", allowed="a table belongs here",
                     remedy="Write a table with keys and values.")


def _is_leaf(name: str, model: type[BaseModel]) -> bool:
    """Whether a key holds a value, whose refusal carries the key itself, rather than a table."""
    field = model.model_fields.get(name)
    return field is not None and any(isinstance(kind, Kind) for kind in field.metadata)


def _unknown_key(key: str, model: type[BaseModel], homes: Homes) -> UnknownKey:
    known = list(model.model_fields)
    written = key if re.fullmatch(r"[\w-]{1,60}", key) else shown(key)
    listed = f"The keys here are {', '.join(known)}."
    if (home := homes().get(key)) is not None:
        return UnknownKey(f"{written} is not a known key here", allowed=f"it belongs in [{home}]",
                          remedy=f"Move it there. {listed}")
    near = nearest(key, known)
    return UnknownKey(f"{written} is not a known key",
                      allowed=f"the nearest known one is {near or nearest(key, known, cutoff=0.0)}",
                      remedy=f"Write {near}, or delete it. {listed}" if near else f"Delete it. {listed}")
