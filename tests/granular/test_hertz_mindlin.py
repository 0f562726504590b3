"""The second opinion: right in itself, and equal to the library for the isotropic assembly."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular import Scene, evaluate
from granular.hertz_mindlin import moduli


def test_published_example() -> None:
    """Breaks when a factor of the formula is lost: quartz grains, porosity 0.4, 8.6 contacts, 20 MPa."""
    bulk_solid, shear_solid = 36.6e9, 45e9
    poisson_ratio = (3 * bulk_solid - 2 * shear_solid) / (2 * (3 * bulk_solid + shear_solid))
    bulk, shear = moduli(shear_solid, poisson_ratio, mean_stress=20e6, void_ratio=0.4 / 0.6, coordination_number=8.6)
    assert bulk == pytest.approx(1.9063198609e9, rel=1e-10)  # the digits of the example
    assert shear == pytest.approx(2.8028054171e9, rel=1e-10)


# between 0 and 1e-6 the library may refuse the tiny C1122, which is not compared here
@given(poisson_ratio=st.just(0.0) | st.floats(1e-6, 0.5), void_ratio=st.floats(0.3, 1.2), coordination=st.floats(2, 12),
       stress=st.floats(1e3, 1e8), shear_modulus=st.floats(1e9, 1e11))
def test_library_agrees(poisson_ratio: float, void_ratio: float, coordination: float, stress: float,
                        shear_modulus: float) -> None:
    """Breaks when the chain from contacts to stiffness gains or loses a factor anywhere."""
    scene = Scene.model_validate({
        "grains": {"shear_modulus": shear_modulus, "poisson_ratio": poisson_ratio},
        "packing": {"void_ratio": void_ratio, "coordination_number": coordination}, "stress": {"mean": stress}})
    stiffness = evaluate(scene).stiffness
    bulk, shear = moduli(shear_modulus, poisson_ratio, mean_stress=stress, void_ratio=void_ratio,
                         coordination_number=coordination)
    # both sides round about twenty times; 1e-14 is forty roundings, a lost factor would be of the order of one
    assert stiffness.C2323 == pytest.approx(shear, rel=1e-14)
    assert stiffness.C3333 == pytest.approx(bulk + 4 * shear / 3, rel=1e-14)
