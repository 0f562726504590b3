"""The emitted closed forms, in exact rational arithmetic: no integrand is evaluated, nothing cancels.

One evaluation takes about 0.1 ms. For many evaluations see :func:`granular.axial_stiffness`, which runs the same
emitted arithmetic on arrays of floats.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.rational import fractions_of, rounded
from granular.routes.result import RouteResult, Six

if TYPE_CHECKING:
    from granular.fabric import AxialFabric

NAME = "closed_form"

LARGEST_RATIO = 9.0
"""Series of the static moments: 1/9 <= w1/w0 <= 9, where they are cut at 2^-57 of their sum."""

ULP = 2.0**-52

RELATIVE_ERROR = {Hypothesis.KINEMATIC: 1 * ULP, Hypothesis.STATIC: 6 * ULP}
"""Bound for a density of rank two. The arithmetic is exact, so that a kinematic component is rounded once; a static
one inherits the rounding of its moments: 1 unit as a rule, 4.6 at the worst of 80,000 random and boundary fabrics."""

RANK_FOUR_FACTOR = 4.5
"""With D3333 the middle coefficient of the density may be negative. The terms that then cancel are at most 4.45 times
the sum: that is the largest ratio over all densities with a double zero and all |v| <= 1/2 (at e0/e2 = 0.63, v = 0)."""


def covers(fabric: AxialFabric, hypothesis: Hypothesis) -> bool:
    """Whether the closed form serves a fabric: always (kinematic), for 1/9 <= w1/w0 <= 9 (static)."""
    if hypothesis is Hypothesis.KINEMATIC:
        return True
    equator, pole = 2 - fabric.Dr33, 2 * (1 + fabric.Dr33)
    return pole <= LARGEST_RATIO * equator and equator <= LARGEST_RATIO * pole


def relative_error(fabric: AxialFabric, hypothesis: Hypothesis) -> float:
    """Declared bound for the worst of the six components, relative to that component [-]."""
    bound = RELATIVE_ERROR[hypothesis]
    return bound if fabric.D3333 == 0 or hypothesis is Hypothesis.KINEMATIC else RANK_FOUR_FACTOR * bound


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             rtol: float | None = None) -> RouteResult:
    """Six components over (M/V) l_e^2 k_n,ref from the emitted closed form.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 1/2.
    hypothesis : Hypothesis
        Kinematic (upper bound) or static (lower estimate).
    rtol : float, optional
        Wanted relative accuracy of every component [-]; refused when it is below the declared bound.

    Returns
    -------
    RouteResult
        Components, declared error bound, and no evaluations at all.

    Raises
    ------
    RouteOutOfDomain
        Static hypothesis with branch lengths at pole and equator more than a factor 9 apart, or ``rtol`` too small.

    Notes
    -----
    Accuracy: :func:`relative_error`. Source: eqs (4), (7), and Figure 1(b) with (23).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> result = evaluate(AxialFabric(D33=0.3), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC)
    >>> result.components[2:4]
    (0.0, 0.0)
    """
    if not covers(fabric, hypothesis):
        raise RouteOutOfDomain(
            f"route = closed_form for Dr33 = {fabric.Dr33!r}",
            allowed="the static closed form serves -16/19 <= Dr33 <= 16/11",
            remedy='Use route = "axial", which serves every admissible fabric.')
    bound = relative_error(fabric, hypothesis)
    if rtol is not None and rtol < bound:
        raise RouteOutOfDomain(f"rtol = {rtol!r}", allowed=f"route closed_form promises {bound:.1e} here",
                               remedy='Ask for less, or use route = "certified".')
    compute = _kinematic if hypothesis is Hypothesis.KINEMATIC else _static
    return RouteResult(compute(fabric, poisson_ratio), bound, 0)


def _kinematic(fabric: AxialFabric, poisson_ratio: float) -> Six:
    from granular.generated.kinematic_constant import kinematic_constant

    exact = fractions_of(fabric.D33, fabric.D3333, fabric.Dr33, poisson_ratio)
    return rounded(kinematic_constant(*exact))


def _static(fabric: AxialFabric, poisson_ratio: float) -> Six:
    from granular.generated.static_constant import static_moments, stiffness_from_moments

    moments = static_moments(fabric.D33, fabric.D3333, fabric.Dr33)
    return rounded(stiffness_from_moments(*fractions_of(*moments, fabric.D33, poisson_ratio)))
