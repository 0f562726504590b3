"""Solids with and without an axis of symmetry, for tests."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

from granular.elasticity import Stiffness


def solid(seed: int, least: float = 0.5) -> Stiffness:
    """A positive definite tensor without any symmetry."""
    half = np.random.default_rng(seed).normal(size=(6, 6))
    return Stiffness.from_mandel(half @ half.T / 6 + least * np.eye(6))


@st.composite
def axial_solids(draw: Any) -> Stiffness:
    """Positive definite and axial about axis 3, far from singular; shear may be stiffer than compression."""
    shear, vertical, plane, normal = (draw(st.floats(0.05, 10.0)) for _ in range(4))
    poised = draw(st.sampled_from([0.0, 0.9, -0.9]) | st.floats(-0.9, 0.9))
    return Stiffness.transversely_isotropic(plane / 2 + shear, normal, plane / 2 - shear,
                                            poised * (plane * normal / 2) ** 0.5, vertical, shear)
