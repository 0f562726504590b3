"""What all tables of a scene file have in common."""

from __future__ import annotations

from functools import cache
from typing import Any, Self, get_args

from pydantic import BaseModel, ConfigDict

from granular.refusals import one_sentence


class Table(BaseModel):
    """One table of the scene file: frozen, no unknown keys, and every mistake is one clear sentence."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    def __init__(self, /, **values: Any) -> None:
        """Build the table from its keys; mistakes are GranularError."""
        with one_sentence(type(self), homes=_homes):
            super().__init__(**values)

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Build the table from a dict; mistakes are GranularError."""
        with one_sentence(cls, homes=_homes):
            return super().model_validate(obj, **options)


@cache
def _homes() -> dict[str, str]:
    """Key -> the table it belongs to, for keys that were written in the wrong one."""
    from granular.scene import Scene

    homes: dict[str, str] = {}
    _enter(Scene, "", homes)
    return homes


def _enter(model: type[Table], name: str, homes: dict[str, str]) -> None:
    for key, field in model.model_fields.items():
        if name:
            homes.setdefault(key, name)
        for kind in (field.annotation, *get_args(field.annotation)):
            if isinstance(kind, type) and issubclass(kind, Table):
                _enter(kind, f"{name}.{key}".lstrip("."), homes)
