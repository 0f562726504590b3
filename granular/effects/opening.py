"""Effect ``opening``: contacts without a compressive force carry nothing."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Simulated
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.kinetic import force_coefficients

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.general import GeneralLoading
    from granular.loading import Loading
    from granular.scene import Scene


def _called_for(scene: Scene) -> Called:
    equator, pole = force_coefficients(scene)
    if equator >= 0 and pole >= 0:
        return Called(False, "no contact is pulled" if 0 in (equator, pole) else "every contact is compressed")
    where = "around the pole" if pole < 0 else "around the equator"
    return Called(True, f"the estimated normal force is a tension {where}")


def _add_to_loading(scene: Scene, loading: Loading | None) -> Loading:
    return loading or scene.loading_about_axis(None)


def _bound(simulated: Simulated | GeneralSimulated) -> Bound:
    if not simulated.opens:
        return Bound(0.0, "no contact is pulled")
    return Bound(math.inf, "the cube root of a tension is no stiffness")


def _called_for_by_tensors(scene: Scene) -> Called:
    from granular.effects.forms import least_force

    least = least_force(scene.general_loading(None).force_tensor(scene.general_fabric))
    if least >= 0:
        return Called(False, "no contact is pulled" if least == 0 else "every contact is compressed")
    return Called(True, f"the estimated normal force is a tension in some directions: down to {least:.6g} of that of "
                        "the isotropic assembly")


def _add_to_general(scene: Scene, loading: GeneralLoading | None) -> GeneralLoading:
    return loading or scene.general_loading(None)


EFFECT = Effect(
    name="opening", title="contacts that have opened", equations="the local yield condition that goes with eq. (20)",
    without="contacts then never open", called_for=_called_for, bound=_bound, add_to_loading=_add_to_loading,
    requires=("kinetic",), modules=("granular.routes.log_tangent_opening", "granular.routes.opening_rule"),
    without_axis=WithoutAxis(called_for=_called_for_by_tensors, bound=_bound, add_to_loading=_add_to_general))
