"""The kinematic stiffness as rational numbers: the emitted closed form fed with fractions.

Decimal data such as D33 = 0.3 and nu = 0.21 are rational, the closed form has only the four operations, and so the
components are rational numbers: C1111/C3333 = 678697/466603 for the first case of Table II.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import HALF_ULP, require_accuracy
from granular.routes.rational import fractions_of, rounded
from granular.routes.result import RouteResult
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

NAME = "exact"

WORK = Work(103)
"""What the emitted closed form takes, here of rational numbers."""


def rational_components(fabric: AxialFabric, *, poisson_ratio: float,
                        decimal: bool = True) -> tuple[Fraction, ...]:
    """Six components under the kinematic hypothesis as rational numbers.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    decimal : bool
        True reads each number as the shortest decimal that names it, 0.3 as 3/10. False takes the binary64
        number as it is, 0.3 as 5404319552844595/2**54.

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    Exact.

    Source
    ------
    Eq. (7), integrated.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> c1111, c3333, *_ = rational_components(AxialFabric(D33=0.3, Dr33=-0.3), poisson_ratio=0.21)
    >>> c1111 / c3333
    Fraction(452950, 368827)
    """
    from granular.generated.kinematic_constant import kinematic_constant

    numbers = (fabric.D33, fabric.D3333, fabric.Dr33, poisson_ratio)
    exact = fractions_of(*(Fraction(repr(float(number))) if decimal else number for number in numbers))
    components: Any = kinematic_constant(*exact)
    return tuple(components)


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
    """Six components from rational arithmetic, rounded to the nearest binary64 numbers.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-]; its binary64 numbers are taken as they are.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic; the static components are not rational.
    loading : Loading or None
        Must be None: cube roots of contact forces are not rational either.
    rtol : float or None
        Relative accuracy wanted of every component [-]; refused below half a unit in the last place.

    Returns
    -------
    RouteResult
        Components over (M/V) l_e^2 k_n,ref [-]; no integrand is evaluated.

    Accuracy
    --------
    Half a unit in the last place, 2**-53 of each component.

    Raises
    ------
    RouteOutOfDomain
        The static hypothesis, a loading, spheroids, or an ``rtol`` that a binary64 number cannot hold.

    Source
    ------
    Eq. (7), integrated.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> evaluate(AxialFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC).components[0] == 1/3
    True
    """
    if hypothesis is not Hypothesis.KINEMATIC:
        raise RouteOutOfDomain("route = exact under the static hypothesis",
                               allowed="allowed: the kinematic hypothesis, whose components are rational",
                               remedy="Use the route closed_form or axial.")
    if loading is not None:
        raise RouteOutOfDomain("route = exact with contact forces",
                               allowed="allowed: contacts of equal stiffness, for which the components are rational",
                               remedy="Use the route closed_form or axial.")
    if not fabric.collinear:
        raise RouteOutOfDomain(f"route = exact for aspect_ratio = {fabric.aspect_ratio!r}",
                               allowed="allowed: branches along the contact normals, for which the components are "
                               "rational", remedy="Use the route closed_form or axial.")
    require_accuracy(NAME, HALF_ULP, rtol)
    components = rational_components(fabric, poisson_ratio=poisson_ratio, decimal=False)
    return RouteResult(rounded(components), HALF_ULP, 0, WORK)
