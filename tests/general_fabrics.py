"""Fabrics and rotations without an axis, for tests."""

from __future__ import annotations

import numpy as np

from granular.general import GeneralFabric


def rotation(seed: int) -> np.ndarray:
    """A random rotation."""
    q, r = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def traceless(size: float, seed: int) -> np.ndarray:
    """A traceless tensor whose least principal value is -size."""
    a = np.random.default_rng(seed).normal(size=(3, 3))
    a = (a + a.T) / 2
    a -= np.eye(3) * np.trace(a) / 3
    return a * size / -np.linalg.eigvalsh(a)[0]


def harmonic(direction: np.ndarray, factor: float) -> np.ndarray:
    """The traceless tensor of rank four whose form is factor P4(n . direction)."""
    e, one = np.outer(direction, direction), np.eye(3)
    pairs = ("ij,kl->ijkl", "ik,jl->ijkl", "il,jk->ijkl")
    mixed = sum(np.einsum(p, one, e) + np.einsum(p, e, one) for p in pairs) / 6
    deltas = sum(np.einsum(p, one, one) for p in pairs) / 3
    return factor * (35 * np.einsum("ij,kl->ijkl", e, e) - 30 * mixed + 3 * deltas) / 8


def general_fabric(seed: int, *, branches: float = 0.6) -> GeneralFabric:
    """A fabric with all three tensors, none of which shares an axis with another."""
    axes = rotation(seed + 50)
    fourth = harmonic(axes[0], 0.15) - harmonic(axes[1], 0.1)
    return GeneralFabric(traceless(0.5, seed), D4=fourth, Dr=traceless(branches, seed + 100) if branches else None)


def apart(found: np.ndarray, expected: np.ndarray) -> float:
    """Worst difference over the largest entry."""
    return float(np.abs(found - expected).max() / np.abs(expected).max())
