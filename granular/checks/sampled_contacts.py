"""Eq. (1) as it stands, summed over contacts drawn at random, with the error that the draw leaves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BATCHES = 400
"""Parts of the sample that the error is taken from. By the distribution of Student a component is then off by more than
five of its standard errors once in 1.1 million draws."""

PER_BATCH = 2500
"""Contacts of one part [-]; a million in all."""


@dataclass(frozen=True, slots=True)
class Contacts:
    """Contacts drawn at random.

    Attributes
    ----------
    weight : (q,) array
        How many contacts each stands for, 1 on average [-].
    normal : (3, q) array
        Unit normals [-].
    branch : (3, q) array
        Branch vectors [any one unit of length].
    normal_stiffness, shear_stiffness : (q,) array
        k_n and k_r [any one unit].
    """

    weight: Array
    normal: Array
    branch: Array
    normal_stiffness: Array
    shear_stiffness: Array


@dataclass(frozen=True, slots=True)
class Estimate:
    """Components from a sample, with their standard errors.

    Attributes
    ----------
    components : tuple of float
        C1111, C3333, C1122, C1133, C2323, C1212 [unit of length^2 times stiffness], or what was asked for.
    standard_errors : tuple of float
        What the draw leaves of each [same unit].
    """

    components: tuple[float, ...]
    standard_errors: tuple[float, ...]


def estimate(draw: Callable[[int], Contacts], *, hypothesis: Hypothesis, free_spin: bool = False,
             batches: int = BATCHES) -> Estimate:
    """Average over the contacts of an assembly, per contact.

    Parameters
    ----------
    draw : callable
        From a number of contacts to that many, drawn independently of those before.
    hypothesis : Hypothesis
        Kinematic: the mean of l_i k_jl l_k. Static: the inverse of the mean of A_pk n_k s_jl A_qm n_m/l^2, where A
        is such that the forces balance the stress in this sample.
    free_spin : bool
        Each grain spins until it carries no net couple; otherwise the sum is symmetrised.
    batches : int
        Number of parts [-], of ``PER_BATCH`` contacts each.

    Returns
    -------
    Estimate
        Six components.

    Notes
    -----
    Accuracy: the standard errors, by leaving out one part after the other. Source: eq. (1), Figure 1(b), (24).
    """
    def components(raw: Array, balance: Array) -> Array:
        import numpy as np

        from granular.routes.direction_sums import axial_components, mandel_matrix, spin_relaxed, symmetrised

        if hypothesis is Hypothesis.KINEMATIC:
            mandel = mandel_matrix(spin_relaxed(raw) if free_spin else symmetrised(raw))
            return np.asarray(axial_components(mandel), dtype=float)
        shares = np.linalg.inv(balance).T
        compliance = np.einsum("pk,qm,kjml->pjql", shares, shares, raw)
        stiffness = np.asarray(np.linalg.inv(mandel_matrix(symmetrised(compliance))), dtype=np.float64)
        return np.asarray(axial_components(stiffness), dtype=float)

    return _by_leaving_out(_sums(draw, hypothesis, batches), components)


def raw_estimate(draw: Callable[[int], Contacts], *, batches: int = BATCHES) -> Estimate:
    """Average l_i k_jl l_k over the contacts of an assembly without any symmetrisation.

    Parameters
    ----------
    draw : callable
        From a number of contacts to that many, drawn independently of those before.
    batches : int
        Number of parts [-], of ``PER_BATCH`` contacts each.

    Returns
    -------
    Estimate
        The three sums over 2 and 3 in which no index stands alone: T2323, T3232 and T2332.

    Notes
    -----
    Accuracy: the standard errors. Source: eq. (1).
    """
    def components(raw: Array, _balance: Array) -> Array:
        import numpy as np

        return np.array([raw[1, 2, 1, 2], raw[2, 1, 2, 1], raw[1, 2, 2, 1]])

    return _by_leaving_out(_sums(draw, Hypothesis.KINEMATIC, batches), components)


def _sums(draw: Callable[[int], Contacts], hypothesis: Hypothesis, batches: int) -> Iterator[tuple[Array, Array]]:
    """The fourth-rank mean of each part, and its mean of n^l_i n_k."""
    import numpy as np

    from granular.routes.direction_sums import contact_tensor, fourth_rank

    for _ in range(batches):
        contacts = draw(PER_BATCH)
        n, branch = contacts.normal, contacts.branch
        weight = contacts.weight / PER_BATCH
        normal, shear = contacts.normal_stiffness, contacts.shear_stiffness
        if hypothesis is Hypothesis.KINEMATIC:
            yield (fourth_rank(weight * branch[:, None] * branch[None, :], contact_tensor(n, normal - shear, shear)),
                   np.eye(3))
        else:
            squared = np.sum(branch**2, axis=0)
            yield (fourth_rank(weight / squared * n[:, None] * n[None, :],
                               contact_tensor(n, 1 / normal - 1 / shear, 1 / shear)),
                   (weight / np.sqrt(squared) * branch) @ n.T)


def _by_leaving_out(sums: Iterator[tuple[Array, Array]], components: Callable[[Array, Array], Array]) -> Estimate:
    """What all parts give together, and how much that changes when one of them is left out (jackknife)."""
    import numpy as np

    raw, balance = (np.array(parts) for parts in zip(*sums, strict=True))
    count = len(raw)
    whole = components(raw.mean(axis=0), balance.mean(axis=0))
    without = np.array([components((raw.sum(axis=0) - one) / (count - 1), (balance.sum(axis=0) - other) / (count - 1))
                        for one, other in zip(raw, balance, strict=True)])
    spread = np.sqrt((count - 1) / count * np.sum((without - without.mean(axis=0)) ** 2, axis=0))
    return Estimate(tuple(whole.tolist()), tuple(spread.tolist()))
