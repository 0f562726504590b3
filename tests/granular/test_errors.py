"""The catalogue of refusals: complete, coded once, and safe to send between processes."""

from __future__ import annotations

import importlib
import pickle
import pkgutil
import re
from concurrent.futures import ProcessPoolExecutor

import pytest

import granular
from granular.errors import CATALOGUE, GranularError


def subclasses(kind):
    return {kind} | {below for child in kind.__subclasses__() for below in subclasses(child)}


def test_the_catalogue_is_complete():
    # Breaks when a class of refusals is defined anywhere and not entered: the book would lack its section.
    for module in pkgutil.walk_packages(granular.__path__, "granular."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    inside = {kind for kind in subclasses(GranularError) - {GranularError} if kind.__module__.startswith("granular")}
    assert inside == set(CATALOGUE)
    assert len(CATALOGUE) == len(inside)


def test_codes_are_unique_and_well_formed():
    # Breaks when two refusals share a code, or a code has another form.
    codes = [kind.code for kind in CATALOGUE]
    assert len(set(codes)) == len(codes)
    assert all(re.fullmatch(r"G-[A-Z]{3}-\d\d", code) for code in codes)


@pytest.mark.parametrize("kind", CATALOGUE, ids=lambda kind: kind.__name__)
def test_every_class_says_what_it_is(kind):
    # Breaks when a class has no title or no docstring of its own.
    assert "title" in vars(kind)
    assert kind.title[0].isupper()
    assert not kind.title.endswith(".")
    assert "code" in vars(kind)
    assert kind.__doc__ != GranularError.__doc__


@pytest.mark.parametrize("kind", CATALOGUE, ids=lambda kind: kind.__name__)
def test_the_message_has_class_code_value_bound_and_remedy(kind):
    # Breaks when the format of the sentence changes: the book and scripts quote it.
    refusal = kind("D33 = 2.3", allowed="allowed -1 <= D33 <= 2", remedy="Give less.")
    assert str(refusal) == f"{kind.__name__} [{kind.code}]: D33 = 2.3, allowed -1 <= D33 <= 2. Give less."
    assert isinstance(refusal, ValueError)
    assert str(kind("a", allowed="b", remedy="c.", more=1)).endswith("c. (1 more mistake in the same input)")
    assert str(kind("a", allowed="b", remedy="c.", more=2)).endswith("c. (2 more mistakes in the same input)")


@pytest.mark.parametrize("kind", CATALOGUE, ids=lambda kind: kind.__name__)
def test_survives_pickling(kind):
    # Breaks when a worker process cannot hand its refusal back: keyword-only arguments need help there.
    refusal = kind("a = 1", allowed="allowed a > 1", remedy="Give more.", more=3)
    again = pickle.loads(pickle.dumps(refusal))
    assert type(again) is kind
    assert (str(again), again.found, again.allowed, again.remedy, again.more) == (
        str(refusal), "a = 1", "allowed a > 1", "Give more.", 3)


def _refuse() -> None:
    granular.AxialFabric(D33=2.3)


def test_comes_back_from_a_worker_process():
    # Breaks when the error of a worker kills its pool instead of reaching the caller.
    with ProcessPoolExecutor(1) as pool, pytest.raises(GranularError, match=r"D33 = 2\.3"):
        pool.submit(_refuse).result(timeout=60)
