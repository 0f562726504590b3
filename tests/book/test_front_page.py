"""What the first pages say of the model's error."""

from __future__ import annotations

import pytest
from page_tools import start
from page_tools.dem import RELAXED, bulk_modulus, packings

from granular import Scene, evaluate
from granular.engineering import engineering_constants

GRAINS = {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}


def bulk(void_ratio: float, **packing: float) -> float:
    scene = Scene(grains=GRAINS, packing={"void_ratio": void_ratio, **packing}, stress={"mean": "100 kPa"})
    return engineering_constants(evaluate(scene).stiffness).K


def test_guessed_contacts_count_as_in_the_model(monkeypatch: pytest.MonkeyPatch, root: object) -> None:
    """Breaks when a packing is scaled to the number of contacts of its void ratio in another way than a scene is."""
    monkeypatch.chdir(f"{root}/book")
    expected = [bulk_modulus(one, start.SCENE) / bulk_modulus(one, RELAXED) * bulk(one.void_ratio)
                / bulk(one.void_ratio, coordination_number=one.coordination_number)
                for one in packings() if one.collinear]
    assert len(expected) == 4
    # a few roundings of either side
    assert start.bulk_guessed() == pytest.approx((min(expected), max(expected)), rel=1e-13)


def test_guessing_makes_it_worse(monkeypatch: pytest.MonkeyPatch, root: object) -> None:
    """Breaks when the box says of guessed contacts what holds for known ones."""
    monkeypatch.chdir(f"{root}/book")
    assert start.bulk_guessed()[0] > start.bulk_overrated()[1]
    assert start.shear_guessed()[1] > start.overrated("C2323", "C1212")[1]
