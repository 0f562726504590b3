"""How far the stiffness moves when an effect is left out: from ranges of the integrands to the six components.

Each component is made of averages over directions with positive integrands. Where no integrand changes by more than a
ratio, no average does, whatever the rest of the integrand is.

Kinematic, eq. (6): a component is a sum with positive coefficients of averages of (density times branches) times k_n,
k_r, or k_n - k_r, so that it changes by no more than they do. Grains that are free to spin make it the least of such
sums, which changes by no more either.

Static, Figure 1(b) and (23): with u = 1/k_n, v = 1/k_r, g = v - u and w the share of the branches, the block of normal
directions is C_iikk = N_i N_k (M^-1)_ik (no sum), where M has the row sums <E w u n_i^2> and the elements
-<E w g n_i^2 n_k^2> off the diagonal. By the theorem of matrices and trees the cofactors of M are polynomials of degree
two, and its determinant is one of degree three, in the row sums and in the elements off the diagonal without their
sign, all with positive coefficients. Where those change by ratios in [lo, hi], the elements of the inverse change by
ratios in [lo^2/hi^3, hi^2/lo^3]; Alfa, Xue and Ye (2002) show the same for any order. C1212 is N_11^2 over an average
of u and v with positive coefficients. So is C2323 as long as N_11/N_33 stays: 4 S2323 is the square of the length of
a + b, with a = n_2 e_3/N_11 and b = n_3 e_2/N_33 under the scalar product <E w (s . )>, and neither a nor b is longer
than sqrt(2) times a + b: with x = cos(beta), y = x^2, s = 1 - y and g = t v the square of the cosine between the two is
at most <t y^2 v>/(<y v> + <t y^2 v>) <= 1/2. A change of N_11/N_33 by exp(h) then changes that square of a length by
ratios in [2 exp(-h) - 1, 2 exp(h) - 1], beside the common factor.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects.ranges import UNCHANGED, Range, expm1
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.gradation import SizeDistribution
    from granular.loading import Loading


@dataclass(frozen=True, slots=True)
class Bound:
    """How much an effect may matter.

    Attributes
    ----------
    value : float
        \\|C_without - C_with\\|/C_with is at most this for each of the six components [-]; inf where nothing is proved.
    reason : str
        Where it comes from.
    """

    value: float
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """What the simulated effects leave of a scene, whether it has an axis of symmetry or not.

    Attributes
    ----------
    sizes : SizeDistribution or None
        Sizes of the grains; None when all are taken as equally large.
    poisson_ratio : float
        Poisson ratio of the solid [-].
    hypothesis : Hypothesis
        Kinematic or static.
    """

    sizes: SizeDistribution | None
    poisson_ratio: float
    hypothesis: Hypothesis

    @property
    def static(self) -> bool:
        """Whether the stress is uniform, rather than the strain."""
        return self.hypothesis is Hypothesis.STATIC


@dataclass(frozen=True, slots=True, kw_only=True)
class Simulated(Common):
    """What the simulated effects leave of a scene with an axis, about that axis.

    Attributes
    ----------
    fabric : AxialFabric
        Contact normals and branches [-].
    loading : Loading or None
        What the stress does to the contacts; None when all contacts are taken as equally stiff.
    """

    fabric: AxialFabric
    loading: Loading | None

    @property
    def slips(self) -> bool:
        """Whether friction limits the shear forces."""
        return self.loading is not None and self.loading.friction is not None

    @property
    def opens(self) -> bool:
        """Whether contacts open in some direction."""
        return self.loading is not None and self.loading.opens()

    def require_finite_compliance(self) -> None:
        """Refuse the static hypothesis with contacts that slide or have opened."""
        if self.static and self.loading is not None:
            self.loading.require_finite_compliance(self.fabric.D33)


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """What leaving an effect out does to the integrands, in any direction: ratios of without to with.

    Attributes
    ----------
    share : Range
        Density of contact normals times the share of the branches: products of their components (kinematic), or
        their inverse square (static).
    normal : Range
        k_n.
    chi : Range
        k_r/k_n.
    apart : Range
        1 - k_r/k_n.
    across, along : Range
        N_11 and N_33, which balance forces and stress (static).
    """

    share: Range = UNCHANGED
    normal: Range = UNCHANGED
    chi: Range = UNCHANGED
    apart: Range = UNCHANGED
    across: Range = UNCHANGED
    along: Range = UNCHANGED


def largest_change(change: Change, simulated: Simulated) -> float:
    """Bound the relative change of the components.

    Parameters
    ----------
    change : Change
        Of the integrands.
    simulated : Simulated
        The model with the effect.

    Returns
    -------
    float
        Bound of \\|C_without - C_with\\|/C_with for the worst component [-]; inf where there is none.

    Notes
    -----
    Accuracy: rigorous, rounding covered. Source: see the head of this file; A. S. Alfa, J. Xue, Q. Ye, Math. Comp. 71
    (2002), for diagonally dominant M-matrices.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> plain = Simulated(fabric=AxialFabric(), loading=None, sizes=None, poisson_ratio=0.21,
    ...                   hypothesis=Hypothesis.KINEMATIC)
    >>> round(largest_change(Change(normal=Range.of(0.9, 1.2)), plain), 10)
    0.2
    """
    # k_n = k_r throughout, and C1122 = C1133 = 0, where Poisson's ratio is zero and no contact slips
    apart = simulated.poisson_ratio > 0.0 or simulated.slips
    return _static(change, apart=apart) if simulated.static else _kinematic(change, apart=apart)


def _kinematic(change: Change, *, apart: bool) -> float:
    normal = change.share * change.normal
    kinds = normal | normal * change.chi
    return (kinds | normal * change.apart if apart else kinds).change


def _static(change: Change, *, apart: bool) -> float:
    normal = change.share / change.normal
    shear = normal / change.chi
    carried = change.across ** 2.0 | change.along ** 2.0
    block = normal ** -1.0
    if apart:
        elements = normal | shear * change.apart
        block = elements ** 2.0 / elements ** 3.0
    turned = change.across * change.along * _turned(change.across, change.along)
    return max((block * carried).change, (change.across ** 2.0 / (normal | shear)).change,
               (turned / (normal | shear)).change)


def _turned(across: Range, along: Range) -> Range:
    """Ratio of 1/S2323 that comes from N_11/N_33 alone."""
    h = max(across.high - along.low, along.high - across.low)
    if not h < math.log(2.0):
        return Range(-math.log1p(2 * expm1(h)) if h < 300 else -math.inf, math.inf)
    return Range(-math.log1p(2 * math.expm1(h)), -math.log1p(2 * math.expm1(-h)))
