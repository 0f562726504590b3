"""The emitted closed forms: no integrand is evaluated, and in exact rational arithmetic nothing cancels.

With contact forces the moments are exact Gegenbauer series in the contrast of the forces at pole and equator, for
1/9 <= c/a <= 9. Elementary terms plus one Legendre integral, and the hypergeometric function, cover the rest of the
domain and partial slip, but lose digits in doubles: there they are identities, which ``certified`` evaluates in balls.

Where an accuracy is wanted that floats keep, they are evaluated in floats, some fifty times as fast. For many
evaluations see :func:`granular.axial_stiffness`, which runs the same emitted arithmetic on arrays of floats.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import RANK_FOUR_FACTOR
from granular.routes.arithmetic import FLOAT_ERROR, FLOATS, Arithmetic, arithmetic_for
from granular.routes.result import Promise, RouteResult, Six
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

NAME = "closed_form"

LARGEST_RATIO = 9.0
"""Series of the static moments: 1/9 <= w1/w0 <= 9, where they are cut at 2^-57 of their sum."""

ULP = 2.0**-52

RELATIVE_ERROR = {Hypothesis.KINEMATIC: 1 * ULP, Hypothesis.STATIC: 6 * ULP}
"""Bound for a density of rank two. The arithmetic is exact, so that a kinematic component is rounded once; a static
one inherits the rounding of its moments: 1 unit as a rule, 4.6 at the worst of 80,000 random and boundary fabrics."""

KINETIC_ERROR = 4 * ULP
"""The same with contact forces: the moments are series in floats, one for each power of the cosine."""

LARGEST_ASPECT = 3.0
"""Series of the moments of spheroids: 1/3 <= b/a <= 3, where they are cut at 2^-57 of their sum."""

SPHEROID_ERROR = 4 * ULP
"""The same for spheroids: their moments are series in floats."""

WORK = {
    "kinematic": Work(103), "static": Work(533, 2), "spheroids": Work(467),
    "kinetic kinematic": Work(622, 2), "kinetic static": Work(545, 2), "kinetic frictionless": Work(608, 2),
}
"""What each of the emitted forms takes; those with contact forces and the static one are series of fixed lengths."""


def covers(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None) -> bool:
    """Whether the closed form serves a scene.

    Spheroids: for 1/3 <= aspect ratio <= 3 and contacts of equal stiffness (kinematic). Branches along the normals
    and contacts of equal stiffness: always (kinematic), for 1/9 <= w1/w0 <= 9 (static). Contacts whose stiffness
    follows their force: for forces at pole and equator within a factor 9 that stick all over or slide all over
    (kinematic), and branches of one length besides (static).
    """
    if not fabric.collinear:
        return (hypothesis is Hypothesis.KINEMATIC and loading is None
                and 1 <= LARGEST_ASPECT * fabric.aspect_ratio <= LARGEST_ASPECT**2)
    if loading is not None:
        return _covers_forces(fabric, hypothesis, loading)
    if hypothesis is Hypothesis.KINEMATIC:
        return True
    equator, pole = 2 - fabric.Dr33, 2 * (1 + fabric.Dr33)
    return pole <= LARGEST_RATIO * equator and equator <= LARGEST_RATIO * pole


def relative_error(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None, *,
                   rtol: float | None = None) -> float:
    """Declared bound for the worst of the six components, relative to that component [-].

    A wanted accuracy of ``QUICK`` or looser is served in floats.
    """
    if arithmetic_for(rtol) is FLOATS:
        return FLOAT_ERROR
    if not fabric.collinear:
        return SPHEROID_ERROR if fabric.D3333 == 0 else RANK_FOUR_FACTOR * SPHEROID_ERROR
    if loading is None:
        bound = RELATIVE_ERROR[hypothesis]
        return bound if fabric.D3333 == 0 or hypothesis is Hypothesis.KINEMATIC else RANK_FOUR_FACTOR * bound
    return KINETIC_ERROR if fabric.D3333 == 0 else RANK_FOUR_FACTOR * KINETIC_ERROR


def promise(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None, *,
            rtol: float | None = None) -> Promise:
    """Say how well an evaluation of a scene that is covered would do, and what it would take.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.
    rtol : float or None
        Wanted relative accuracy of every component [-].

    Returns
    -------
    Promise
        Bound of the error, no evaluations, operations and functions.

    Notes
    -----
    Accuracy: a bound. Source: :func:`relative_error`.
    """
    kind = str(hypothesis)
    if not fabric.collinear:
        kind = "spheroids"
    elif loading is not None:
        kind = "kinetic frictionless" if loading.friction == 0 else f"kinetic {kind}"
    spun = Work(19) if fabric.free_spin else Work()
    return Promise(relative_error(fabric, hypothesis, loading, rtol=rtol), 0, WORK[kind] + spun)


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
    """Six components over (M/V) l_e^2 k_n,ref from the emitted closed form.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 1/2.
    hypothesis : Hypothesis
        Kinematic (upper bound) or static (lower estimate).
    loading : Loading, optional
        Stress and friction, for contacts whose stiffness follows their force.
    rtol : float, optional
        Wanted relative accuracy of every component [-]; refused when it is below the declared bound.

    Returns
    -------
    RouteResult
        Components, declared error bound, and no evaluations at all.

    Raises
    ------
    RouteOutOfDomain
        What :func:`covers` excludes, or ``rtol`` too small.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

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
    if loading is not None and hypothesis is Hypothesis.STATIC:
        loading.require_finite_compliance(fabric.D33)
    if not covers(fabric, hypothesis, loading):
        if not fabric.collinear:
            raise RouteOutOfDomain(
                f"route = closed_form for aspect_ratio = {fabric.aspect_ratio!r}",
                allowed=f"its series serve 1/{LARGEST_ASPECT:g} <= aspect_ratio <= {LARGEST_ASPECT:g} with contacts of "
                "equal stiffness under the kinematic hypothesis",
                remedy='Use route = "axial", which serves every shape, or "certified".')
        if loading is not None:
            raise RouteOutOfDomain(
                "route = closed_form with contact forces",
                allowed="the series serves forces at pole and equator within a factor 9, without partial slip or "
                "opening, and under the static hypothesis branches of one length",
                remedy='Use route = "axial", which serves every loading, or "certified", which evaluates the closed '
                "form with slip in ball arithmetic, where its cancellation does no harm.")
        raise RouteOutOfDomain(
            f"route = closed_form for Dr33 = {fabric.Dr33!r}",
            allowed="the static closed form serves -16/19 <= Dr33 <= 16/11",
            remedy='Use route = "axial", which serves every admissible fabric.')
    promised, arithmetic = promise(fabric, hypothesis, loading, rtol=rtol), arithmetic_for(rtol)
    if rtol is not None and rtol < promised.relative_error:
        raise RouteOutOfDomain(f"rtol = {rtol!r}",
                               allowed=f"route closed_form promises {promised.relative_error:.1e} here",
                               remedy='Ask for less, or use route = "certified".')
    if loading is not None:
        return promised.kept(_kinetic(fabric, poisson_ratio, hypothesis, loading, arithmetic))
    if not fabric.collinear:
        return promised.kept(_spheroids(fabric, poisson_ratio, arithmetic))
    compute = _kinematic if hypothesis is Hypothesis.KINEMATIC else _static
    return promised.kept(compute(fabric, poisson_ratio, arithmetic))


def _kinematic(fabric: AxialFabric, poisson_ratio: float, arithmetic: Arithmetic) -> Six:
    from granular.generated.kinematic_constant import kinematic_constant

    numbers = arithmetic.numbers(fabric.D33, fabric.D3333, fabric.Dr33, poisson_ratio)
    return arithmetic.finished(kinematic_constant(*numbers))


def _static(fabric: AxialFabric, poisson_ratio: float, arithmetic: Arithmetic) -> Six:
    """Moments from the emitted series, in floats."""
    from granular.generated.static_constant import static_moments, stiffness_from_moments

    moments = static_moments(fabric.D33, fabric.D3333, fabric.Dr33)
    return arithmetic.finished(stiffness_from_moments(*arithmetic.numbers(*moments, fabric.D33, poisson_ratio)))


def _spheroids(fabric: AxialFabric, poisson_ratio: float, arithmetic: Arithmetic) -> Six:
    """Moments from the emitted series, in floats."""
    from granular.generated.spheroid import spheroid_moments
    from granular.routes.axial_kinetic import from_weights

    normal = arithmetic.numbers(*spheroid_moments(fabric.D33, fabric.D3333, fabric.aspect_ratio))
    nu = arithmetic.number(poisson_ratio)
    shear = [(2 - 2 * nu) / (2 - nu) * moment for moment in normal]
    apart = [nu / (2 - nu) * moment for moment in normal[:2]]
    return arithmetic.finished(from_weights(fabric, normal, shear, apart, arithmetic))


def _covers_forces(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading) -> bool:
    a, c = loading.coefficients(fabric.D33)
    if loading.opens() or not (c <= LARGEST_RATIO * a and a <= LARGEST_RATIO * c):
        return False
    if hypothesis is Hypothesis.STATIC and fabric.Dr33 != 0:
        return False
    return not loading.slips(fabric.D33) or loading.friction == 0


def _kinetic(fabric: AxialFabric, poisson_ratio: float, hypothesis: Hypothesis, loading: Loading,
             arithmetic: Arithmetic) -> Six:
    """Moments from the emitted series, in floats; without friction k_r is zero."""
    from granular.generated import kinematic_constant, kinetic, static_constant

    exact_a, exact_c = loading.coefficients(fabric.D33)
    a, c, d = float(exact_a), float(exact_c), float(exact_c - exact_a)
    if hypothesis is Hypothesis.STATIC:
        moments = kinetic.kinetic_static_moments(fabric.D33, fabric.D3333, a, c, d)
        return arithmetic.finished(static_constant.stiffness_from_moments(
            *arithmetic.numbers(*moments, fabric.D33, poisson_ratio)))
    moments = kinetic.kinetic_moments(fabric.D33, fabric.D3333, fabric.Dr33, a, c, d)
    if loading.friction == 0:
        from granular.generated.kinetic_components import stiffness_from_weights

        return arithmetic.finished(stiffness_from_weights(*arithmetic.numbers(*moments, 0, 0, 0, *moments[:2])))
    return arithmetic.finished(kinematic_constant.stiffness_from_moments(*arithmetic.numbers(*moments, poisson_ratio)))
