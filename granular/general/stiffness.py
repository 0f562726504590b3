"""The stiffness of an assembly without an axis: all 21 constants, by the route that suits."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Literal, get_args

from granular.errors import ComplianceInfinite, RouteOutOfDomain, UnknownChoice, ValueOutOfRange
from granular.general import closed_form
from granular.general.axis import AxialScene, axial_scene, rotation_to
from granular.general.components import compliance_tensor, inverted, mandel_of, stiffness_tensor, symmetric_tensor
from granular.general.lebedev import Integral
from granular.general.loading import contact_stiffness, most_mobilised
from granular.general.meridians import Integrand
from granular.hypothesis import Hypothesis
from granular.notation import MANDEL_PAIRS, mandel_factor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.elasticity import Stiffness
    from granular.general.fabric import GeneralFabric
    from granular.general.loading import GeneralLoading

    Array = NDArray[np.float64]

Route = Literal["auto", "axial", "closed_form", "lebedev", "product"]
"""Names of the ways to compute."""

FINEST, COARSEST = 1e-12, 1e-1
"""Wanted accuracies between these can be asked for [-]."""

TURNED, TURNED_AT_ONSET = 2e-13, 4e-12
"""What turning a scene to axis 3 and back may add to the error of a component, over the largest [-]: rounding of the
tensors and of the result. At the onset of sliding the stiffness moves like the power 5/6 of a change in stress."""


ONSET = 1e-6
"""Onset of sliding is near when kappa^2 is this close to 1 [-]."""


@dataclass(frozen=True, slots=True)
class GeneralStiffness:
    """A stiffness of an assembly without an axis.

    Attributes
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix over (M/V) l_e^2 k_n,ref, order 11, 22, 33, 23, 13, 12 [-].
    relative_error : float
        Error of the worst component over the largest entry of the matrix [-].
    error_is : str
        "bound", or "estimate" where two rules were compared.
    evaluations : int
        Directions in which the integrand was evaluated [-]; 0 for a closed form.
    route : str
        What computed it; behind "axial" stands the axial route that was taken.
    axis : tuple of 3 float or None
        Axis of symmetry where the scene has one [-].
    """

    rows: tuple[tuple[float, ...], ...]
    relative_error: float
    error_is: Literal["bound", "estimate"]
    evaluations: int
    route: str
    axis: tuple[float, float, float] | None = None

    def mandel(self) -> Array:
        """Mandel matrix over (M/V) l_e^2 k_n,ref [-], (6, 6), a fresh array."""
        import numpy as np

        return np.array(self.rows)

    @property
    def components(self) -> dict[str, float]:
        """All 21 components by name, C1111 to C1212, over (M/V) l_e^2 k_n,ref [-]."""
        return {f"C{i}{j}{k}{m}": self.rows[row][column] / mandel_factor(row, column)
                for (row, (i, j)), (column, (k, m)) in combinations_with_replacement(enumerate(MANDEL_PAIRS), 2)}

    def stiffness(self, reference: float = 1.0) -> Stiffness:
        """The tensor times a reference stiffness, (M/V) l_e^2 k_n,ref [Pa]."""
        from granular.elasticity import Stiffness

        return Stiffness.from_mandel(self.rows).scaled(reference)


def general_stiffness(fabric: GeneralFabric, *, poisson_ratio: float, hypothesis: Hypothesis | str,
                      loading: GeneralLoading | None = None, rtol: float = 1e-9,
                      route: Route = "auto") -> GeneralStiffness:
    """Compute the stiffness of an assembly for any fabric and any stress.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    hypothesis : Hypothesis or str
        "kinematic" or "static".
    loading : GeneralLoading, optional
        Stress and friction, for contacts whose stiffness follows their force; contacts of equal stiffness otherwise.
    rtol : float
        Wanted error of every component over the largest [-], 1e-12 to 0.1.
    route : str
        "auto", or one of "axial" (scenes with an axis in whatever frame), "closed_form" (contacts of equal stiffness),
        "lebedev" (smooth integrands), "product" (all scenes).

    Returns
    -------
    GeneralStiffness
        All 21 constants over (M/V) l_e^2 k_n,ref, with their error and the route.

    Raises
    ------
    ValueOutOfRange
        ``poisson_ratio`` is outside its interval.
    UnknownChoice
        There is no such hypothesis or route.
    RouteOutOfDomain
        ``rtol`` is outside its range, or the named route does not serve the scene or does not reach ``rtol``.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: a bound by the closed form and, but for ``TURNED``, by the axial routes; an estimate by rules over the
    sphere, the difference between two of them. Source: eqs (1)-(7), (20)-(23) and Figure 1(b).

    Examples
    --------
    >>> from granular.general.fabric import GeneralFabric
    >>> from granular.general.loading import GeneralLoading
    >>> sheared = GeneralLoading([[1.0, 0.4, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 0.8]], friction=0.3)
    >>> found = general_stiffness(GeneralFabric([[0.3, 0, 0], [0, -0.1, 0], [0, 0, -0.2]]), poisson_ratio=0.2,
    ...                           hypothesis="kinematic", loading=sheared, rtol=1e-6)
    >>> found.route, found.relative_error <= 1e-6, len(found.components)
    ('product', True, 21)
    """
    _require(poisson_ratio, hypothesis, rtol, route)
    hypothesis = Hypothesis(hypothesis)
    if route in ("auto", "axial"):
        scene = axial_scene(fabric, loading)
        if scene is not None:
            return _by_axial_route(scene, poisson_ratio, hypothesis, rtol)
        if route == "axial":
            raise _out_of_domain(route, "whose tensors share an axis", "auto")
    if route in ("auto", "closed_form"):
        if loading is None and closed_form.covers(fabric, hypothesis):
            matrix = closed_form.mandel_matrix(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis)
            return GeneralStiffness(_rows(matrix), closed_form.RELATIVE_ERROR, "bound", 0, "closed_form")
        if route == "closed_form":
            raise _out_of_domain(route, "with contacts of equal stiffness (static: and branches of one length)",
                                 "product")
    return _by_sphere(fabric, poisson_ratio, hypothesis, loading, rtol, route)


def _require(poisson_ratio: float, hypothesis: Hypothesis | str, rtol: float, route: str) -> None:
    if not 0 <= poisson_ratio <= 0.5:
        raise ValueOutOfRange(f"poisson_ratio = {poisson_ratio!r}", allowed="allowed 0 <= poisson_ratio <= 0.5",
                              remedy="Give Poisson's ratio of the grain material.")
    for name, value, known in (("hypothesis", hypothesis, tuple(map(str, Hypothesis))),
                               ("route", route, get_args(Route))):
        if value not in known:
            raise UnknownChoice(f"{name} = {value!r}", allowed=f"allowed {', '.join(known)}",
                                remedy="Name one of them.")
    if not FINEST <= rtol <= COARSEST:
        raise RouteOutOfDomain(f"rtol = {rtol!r} without an axis",
                               allowed=f"allowed {FINEST:g} <= rtol <= {COARSEST:g}",
                               remedy="Give a relative accuracy in that range.")


def _out_of_domain(route: str, allowed: str, instead: str) -> RouteOutOfDomain:
    return RouteOutOfDomain(f"route = {route}", allowed=f"allowed only scenes {allowed}",
                            remedy=f"Use the route {instead}.")


def _rows(matrix: Array) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(row) for row in matrix.tolist())


def _by_axial_route(scene: AxialScene, poisson_ratio: float, hypothesis: Hypothesis, rtol: float) -> GeneralStiffness:
    from granular.mandel import axial_rows, turned
    from granular.routes.choice import choose

    chosen = choose("auto", scene.fabric, hypothesis, scene.loading, rtol)
    result = chosen.route.evaluate(scene.fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                   loading=scene.loading, rtol=rtol)
    rows: tuple[tuple[float, ...], ...] = axial_rows(result.components)
    error = result.relative_error
    if scene.axis != (0.0, 0.0, 1.0):
        rows = turned(axial_rows(result.components), rotation_to(scene.axis), "stiffness")
        error += TURNED_AT_ONSET if _near_onset(scene) else TURNED
    return GeneralStiffness(rows, error, "bound", result.evaluations, f"axial: {chosen.route.name}", scene.axis)


def _near_onset(scene: AxialScene) -> bool:
    """Whether one direction is just about to slide."""
    tilt = None if scene.loading is None else scene.loading.tilt(scene.fabric.D33)
    return tilt is not None and abs(tilt - 1) < ONSET


def _by_sphere(fabric: GeneralFabric, poisson_ratio: float, hypothesis: Hypothesis,
               loading: GeneralLoading | None, rtol: float, route: Route) -> GeneralStiffness:
    import numpy as np

    from granular.general import lebedev, product

    forces = None if loading is None else loading.force_tensor(fabric)
    friction = None if loading is None else loading.friction
    static = hypothesis is Hypothesis.STATIC
    branches = np.array(fabric.Dr) if static and fabric.Dr is not None else None
    integrand = Integrand(forces, friction, branches)
    if static:
        _require_finite_compliance(integrand)
    weights = partial(_weights, fabric, integrand, poisson_ratio, static)
    inverse = np.asarray(np.linalg.inv(fabric.tensor()), dtype=np.float64) if static else None
    assembly = partial(_assembled, inverse)
    smooth = not integrand.slips and (forces is None or float(np.linalg.eigvalsh(forces + forces.T)[0]) > 0)
    found: Integral | None = None
    if route == "lebedev" and not smooth:
        raise _out_of_domain(route, "where no contact slips or has opened", "product")
    if smooth and route != "product":
        found, name = lebedev.integrated(weights, assembly, rtol=rtol), "lebedev"
    if found is None or (found.error > rtol and route != "lebedev"):
        found, name = product.integrated(weights, assembly, integrand, rtol=rtol), "product"
    if found.error > rtol:
        raise RouteOutOfDomain(f"rtol = {rtol!r} by the route {name}",
                               allowed=f"allowed about {found.error:.1e} and more for this scene",
                               remedy="Ask for less." if name == "product" else "Ask for less, or use product.")
    return GeneralStiffness(_rows(found.mandel), found.error, "estimate", found.evaluations, name)


def _weights(fabric: GeneralFabric, integrand: Integrand, poisson_ratio: float, static: bool,
             directions: Array) -> tuple[Array, Array]:
    """What stands with n_i n_j n_k n_l and with n_i n_k in the average over the contacts."""
    import numpy as np

    from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio

    density, length = fabric.relative_density(directions), fabric.branch_weight(directions)
    if integrand.forces is None:
        one = np.ones_like(density)
        normal, shear, apart = (one, stiffness_ratio(poisson_ratio) * one,
                                one_minus_stiffness_ratio(poisson_ratio) * one)
    else:
        normal, shear, apart = contact_stiffness(integrand.forces, integrand.friction, directions, poisson_ratio)
    if not static:
        weight = density * length**2
        return weight * apart, weight * shear
    weight = density / (length**2 * np.maximum(shear, 1e-300))
    return -weight * apart / np.maximum(normal, 1e-300), weight


def _assembled(inverse_fabric: Array | None, moments: Array) -> Array:
    """Mandel matrix of the stiffness from the 15 and the 6 moments."""
    fourth, second = symmetric_tensor(moments[:15], 4), symmetric_tensor(moments[15:], 2)
    if inverse_fabric is None:
        return mandel_of(stiffness_tensor(fourth, second))
    return inverted(compliance_tensor(fourth, second, inverse_fabric))


def _require_finite_compliance(integrand: Integrand) -> None:
    """Refuse contacts that slide or have opened: they yield without limit to their share of the stress."""
    if integrand.forces is None:
        return
    used, direction = most_mobilised(integrand.forces)
    friction = math.inf if integrand.friction is None else integrand.friction
    if used < math.inf and (friction == math.inf or (friction > 0 and 1 + used**2 <= (1 + friction**2) * (1 + 1e-13))):
        return
    where = ", ".join(f"{value:.4g}" for value in direction)
    what = (f"have opened along n = ({where})" if used == math.inf else
            f"slide along n = ({where}), where the shear force is {used:.6g} times the normal force")
    raise ComplianceInfinite(
        f"hypothesis = static with contacts that {what}",
        allowed="allowed only where every contact sticks"
        + ("" if used == math.inf else f" (here friction = {friction!r})")
        + ": one that does not yields without limit to its share of the stress, so that the compliance is infinite",
        remedy='Leave the loading or the friction out, or use hypothesis = "kinematic".')
