"""The emitted closed forms: no integrand is evaluated, nothing cancels."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.result import RouteResult

if TYPE_CHECKING:
    from granular.fabric import AxialFabric

NAME = "closed_form"

LARGEST_RATIO = 9.0
"""Series of the static moments: 1/9 <= w1/w0 <= 9, where they are cut at 2^-57 of their sum."""

ULP = 2.0**-52

RELATIVE_ERROR = {Hypothesis.KINEMATIC: 4 * ULP, Hypothesis.STATIC: 8 * ULP}
"""Bound for a density of rank two. About twenty roundings of half a unit each, of which the positive form lets none
grow; the worst of six components over 20,000 random and boundary fabrics was 2.6 (kinematic) and 4.1 (static) units
of 2^-52."""

RANK_FOUR_FACTOR = 16.0
"""With D3333 the middle coefficient of the density may be negative; the terms that then cancel are at most this many
times the sum, since the density itself is nowhere negative."""


def covers(fabric: AxialFabric, hypothesis: Hypothesis) -> bool:
    """Whether the closed form serves a fabric: always (kinematic), for 1/9 <= w1/w0 <= 9 (static)."""
    if hypothesis is Hypothesis.KINEMATIC:
        return True
    equator, pole = 2 - fabric.Dr33, 2 * (1 + fabric.Dr33)
    return pole <= LARGEST_RATIO * equator and equator <= LARGEST_RATIO * pole


def relative_error(fabric: AxialFabric, hypothesis: Hypothesis) -> float:
    """Declared bound for the worst of the six components, relative to that component [-]."""
    bound = RELATIVE_ERROR[hypothesis]
    return bound if fabric.D3333 == 0 else RANK_FOUR_FACTOR * bound


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
    if hypothesis is Hypothesis.KINEMATIC:
        from granular.generated.kinematic_constant import kinematic_constant as closed_form
    else:
        from granular.generated.static_constant import static_constant as closed_form
    return RouteResult(closed_form(fabric.D33, fabric.D3333, fabric.Dr33, poisson_ratio), bound, 0)
