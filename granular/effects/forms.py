"""How far the stiffness of a scene without an axis moves when an effect is left out: ratios of quadratic forms.

The energy of a strain e is the quadratic form of the stiffness, and a mean over the contacts of terms that are not
negative: E W^2 [k_n (n.e.n)^2 + k_r (\\|e n\\|^2 - (n.e.n)^2)] (kinematic). Where neither E W^2 k_n nor E W^2 k_r
changes by a ratio outside [lo, hi], the form does not either, whatever the strain. For symmetric matrices
lo C <= C' <= hi C makes \\|C'_ij - C_ij\\| <= max(hi - 1, 1 - lo) sqrt(C_ii C_jj), which the largest entry of the
Mandel matrix bounds: it stands on the diagonal. The same holds of the compliance under a given stress (static), the
mean of E W^-2 [f_n^2/k_n + f_r^2/k_r] with the forces f = sigma A n, as long as A stays; the stiffness then changes by
the inverse ratios.

A bound is therefore relative to the largest entry, and there is none for single components, which may vanish.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Change, Common
from granular.effects.ranges import Range

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general import GeneralFabric, GeneralLoading

    Array = NDArray[np.float64]

SLACK = 2.0**-46
"""Rounding of eigenvalues and of force tensors, over the largest of them [-]: some sixty units."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GeneralSimulated(Common):
    """What the simulated effects leave of a scene whose tensors share no axis.

    Attributes
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    loading : GeneralLoading or None
        Stress and friction; None when all contacts are taken as equally stiff.
    """

    fabric: GeneralFabric
    loading: GeneralLoading | None

    @property
    def forces(self) -> Array:
        """B of the contact forces f = B n over that of the isotropic assembly [-]; needs a loading."""
        assert self.loading is not None
        return self.loading.force_tensor(self.fabric)

    @property
    def opens(self) -> bool:
        """Whether contacts open in some direction."""
        return self.loading is not None and least_force(self.forces) < 0

    def require_finite_compliance(self) -> None:
        """Refuse the static hypothesis with contacts that slide or have opened."""
        from granular.general.sphere import require_finite_compliance

        if self.static and self.loading is not None:
            require_finite_compliance(self.forces, self.loading.friction)


def least_force(forces: Array) -> float:
    """Smallest normal force over all directions.

    Parameters
    ----------
    forces : (3, 3) array
        B [-].

    Returns
    -------
    float
        n.B n at its least [-]; zero where it is within rounding of that.

    Notes
    -----
    Accuracy: 1e-15 of the largest. Source: the least eigenvalue of the symmetric part.

    Examples
    --------
    >>> import numpy as np
    >>> round(least_force(np.diag([1.0, 2.0, -0.5])), 12)
    -0.5
    """
    import numpy as np

    values = np.linalg.eigvalsh((forces + forces.T) / 2)
    return 0.0 if abs(values[0]) <= SLACK * abs(values[2]) else float(values[0])


def eigenvalue_range(tensor: Array, *, beside: Array | None = None) -> Range:
    """Range of a quadratic form over all directions, or of its ratio to another one.

    Parameters
    ----------
    tensor : (3, 3) array
        Symmetric [-], positive definite.
    beside : (3, 3) array, optional
        Denominator [-], symmetric and positive definite; the identity by default.

    Returns
    -------
    Range
        Logarithms of the least and the greatest ratio [-].

    Notes
    -----
    Accuracy: ``SLACK`` times the condition of the denominator, added on both sides. Source: the generalised
    eigenvalue problem.

    Examples
    --------
    >>> import numpy as np
    >>> round(eigenvalue_range(np.diag([1.0, 1.5, 2.0])).change, 9)
    1.0
    """
    import numpy as np

    below = np.eye(3) if beside is None else beside
    values, vectors = np.linalg.eigh(below)
    inner = (vectors / np.sqrt(values)).T @ (tensor - below) @ (vectors / np.sqrt(values))
    away = np.linalg.eigvalsh((inner + inner.T) / 2)  # less one: digits next to one are kept
    slack = SLACK * float(values[2] / values[0]) * (1 + float(np.abs(away).max()))
    return Range.of(max(Fraction(0), 1 + Fraction(float(away[0])) - Fraction(slack)),
                    1 + Fraction(float(away[2])) + Fraction(slack))


def largest_change_of_form(change: Change, simulated: GeneralSimulated) -> float:
    """Bound the change of the stiffness by what leaving an effect out does to the integrands.

    Parameters
    ----------
    change : Change
        Ratios of without to with, in any direction.
    simulated : GeneralSimulated
        The model with the effect.

    Returns
    -------
    float
        Bound of the change of any entry of the Mandel matrix over the largest one [-]; inf where there is none.

    Notes
    -----
    Accuracy: rigorous, rounding covered. Source: see the head of this file.

    Examples
    --------
    >>> from granular.general import GeneralFabric
    >>> from granular.hypothesis import Hypothesis
    >>> plain = GeneralSimulated(fabric=GeneralFabric(), loading=None, sizes=None, poisson_ratio=0.21,
    ...                          hypothesis=Hypothesis.KINEMATIC)
    >>> round(largest_change_of_form(Change(normal=Range.of(0.9, 1.2)), plain), 10)
    0.2
    """
    if not simulated.static:
        normal = change.share * change.normal
        return (normal | normal * change.chi).change
    if change.across.change or change.along.change:
        return math.inf  # other forces balance the same stress
    normal = change.share / change.normal
    return ((normal | normal / change.chi) ** -1.0).change


def with_forces_of(change: Change, with_it: GeneralSimulated, without_it: GeneralSimulated) -> Change:
    """Add what other contact forces do to the contact stiffnesses.

    Parameters
    ----------
    change : Change
        What else changes.
    with_it, without_it : GeneralSimulated
        The model with an effect that moves the forces, and the one without it.

    Returns
    -------
    Change
        With the ranges of k_n and of k_r/k_n; unknown where contacts slide, or have opened.

    Notes
    -----
    With B' = B + X, and t the vector of the shear force over the normal force, t' - t = (X_s - t X_n)/f'_n, whose
    length is at most \\|X\\| sqrt(1 + \\|t\\|^2)/f'_n. Source: eqs (20), (21) and (23).
    """
    import numpy as np

    from granular.effects.ranges import UNCHANGED, UNKNOWN
    from granular.general.loading import most_mobilised

    assert with_it.loading is not None
    B, other = with_it.forces, without_it.forces
    if least_force(B) <= 0 or least_force(other) <= 0:
        return replace(change, normal=UNKNOWN)
    normal = eigenvalue_range((other + other.T) / 2, beside=(B + B.T) / 2) ** (1 / 3)
    friction = with_it.loading.friction
    if friction is None or friction == 0.0:  # k_r/k_n is the same everywhere
        return replace(change, normal=normal, chi=UNCHANGED)
    used = most_mobilised(B)[0] * (1 + SEARCHED)
    moved = float(np.linalg.norm(other - B, 2)) + SLACK * float(np.linalg.norm(B, 2))
    lost = moved * math.hypot(1, used) / least_force(other) / friction
    if used >= friction or lost >= 1 - used / friction:
        return replace(change, normal=normal, chi=UNKNOWN)
    share = lost / (1 - used / friction)
    return replace(change, normal=normal, chi=Range(math.log1p(-share) / 3, math.log1p(share) / 3))


SEARCHED = 1e-9
"""What the largest share of used friction may lack, as it is searched for [-]."""
