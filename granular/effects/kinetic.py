"""Effect ``kinetic``: contact stiffness that follows the estimated contact force in each direction."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.ranges import Range

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.general import GeneralLoading
    from granular.loading import Loading
    from granular.scene import Scene


def force_coefficients(scene: Scene) -> tuple[Fraction, Fraction]:
    """Estimated contact force at the equator and at the pole, over that of the isotropic assembly, exactly.

    Parameters
    ----------
    scene : Scene
        One with an axis; gives the principal stresses and D33 about it. D3333 does not enter the fabric tensor N of
        rank two.

    Returns
    -------
    tuple of Fraction
        a and c [-], see :meth:`granular.loading.Loading.coefficients`.

    Notes
    -----
    Exact for the doubles given. Source: eq. (23).
    """
    return scene.loading_about_axis(None).coefficients(scene.fabric_about_axis.D33)


def _called_for(scene: Scene) -> Called:
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, EQUAL)
    if equator <= 0:
        return Called(True, "the estimated contact force varies with direction: "
                            + ("it vanishes at the equator" if equator == 0 else "it is a tension at the equator"))
    if pole < 0:
        return Called(True, "the estimated contact force varies with direction: it is a tension at the pole")
    return Called(True, "the estimated contact force varies with direction: at the pole it is "
                        f"{_decimal(pole / equator)} times that at the equator")


def _decimal(ratio: Fraction) -> str:
    try:
        return f"{float(ratio):.6g}"
    except OverflowError:
        return "more than 1e308"


def _add_to_loading(scene: Scene, loading: Loading | None) -> Loading:
    return loading or scene.loading_about_axis(None)


def _bound(simulated: Simulated) -> Bound:
    loading = simulated.loading
    if loading is None:
        return Bound(0.0, "every contact has one stiffness")
    if loading.friction is not None or loading.opens():
        return Bound(math.inf, NEEDED)
    stiffness = Range.of(*loading.coefficients(simulated.fabric.D33)) ** (1 / 3)
    return Bound(largest_change(Change(normal=stiffness ** -1.0), simulated), LARGEST)


def forces_are_equal(scene: Scene) -> bool:
    """Tell whether contacts of every direction carry one normal force and no shear force, exactly.

    Parameters
    ----------
    scene : Scene
        Any one; D_ijkl does not enter.

    Returns
    -------
    bool
        Whether the stress is the mean stress times 3 N.

    Notes
    -----
    Exact for the doubles given. Source: eq. (23) with N_ij = delta_ij/3 + 2 D_ij/15.
    """
    D, stress = scene.general_fabric.D, scene.general_loading(None).stress
    mean = sum(Fraction(stress[place][place]) for place in range(3)) / 3
    return all(Fraction(stress[i][j]) == mean * (int(i == j) + Fraction(2, 5) * Fraction(D[i][j]))
               for i in range(3) for j in range(3))


def _called_for_by_tensors(scene: Scene) -> Called:
    import numpy as np

    if forces_are_equal(scene):
        return Called(False, EQUAL)
    forces = scene.general_loading(None).force_tensor(scene.general_fabric)
    values = np.linalg.eigvalsh((forces + forces.T) / 2)
    return Called(True, "the estimated contact force varies with direction: over that of the isotropic assembly from "
                        f"{values[0]:.6g} to {values[2]:.6g}")


def _add_to_general(scene: Scene, loading: GeneralLoading | None) -> GeneralLoading:
    return loading or scene.general_loading(None)


def _bound_of_tensors(simulated: GeneralSimulated) -> Bound:
    from granular.effects.forms import eigenvalue_range, largest_change_of_form, least_force

    loading = simulated.loading
    if loading is None:
        return Bound(0.0, "every contact has one stiffness")
    if loading.friction is not None or simulated.opens:
        return Bound(math.inf, NEEDED)
    forces = simulated.forces
    if least_force(forces) == 0.0:
        return Bound(math.inf, "contacts without a force would get a stiffness back")
    stiffness = eigenvalue_range((forces + forces.T) / 2) ** (1 / 3)
    return Bound(largest_change_of_form(Change(normal=stiffness ** -1.0), simulated), LARGEST)


EQUAL = "the estimated contact force is the same in every direction"
NEEDED = "slip and opening need it"
LARGEST = "the cube root of the contact force in any direction"
"""Why it is called for or not, and why there is a bound or none."""

EFFECT = Effect(
    name="kinetic", title="contact stiffness that follows the contact force", equations="eqs (20) and (22)-(23)",
    without="every contact then has the stiffness of the ideal assembly under the mean stress, as in the paper's "
            "Table II",
    called_for=_called_for, bound=_bound, add_to_loading=_add_to_loading,
    without_axis=WithoutAxis(called_for=_called_for_by_tensors, bound=_bound_of_tensors,
                             add_to_loading=_add_to_general))
