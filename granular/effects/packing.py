"""Effect ``packing``: contact normals that are denser in some directions than in others."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.bound import Bound, Change, Simulated, largest_change
from granular.effects.effect import Called, Effect, WithoutAxis
from granular.effects.ranges import UNCHANGED, UNKNOWN, Range, expm1, log
from granular.tensors import ZERO, span

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.fabric import AxialFabric
    from granular.general import GeneralFabric
    from granular.loading import Loading
    from granular.scene import Scene

STEEPEST = 3 * math.sqrt(3) / 16
"""Largest value of sqrt(u)/(1 + u)^2 over u > 0, at u = 1/3 [-]."""


MAY_CLOSE = "contacts that have opened may close with another density of their normals"
MISSING = "contacts missing in some direction would be put there"
LARGEST = "the largest change of density and contact force in any direction"
"""Why there is a bound or none."""

STEEP = 1000.0
"""Logarithm of a ratio of forces beyond which nothing is claimed, for cosh overflows [-]."""


def _called_for(scene: Scene) -> Called:
    fabric = scene.fabric_about_axis
    D33, D3333 = fabric.D33, fabric.D3333
    if D33 == 0.0 == D3333:
        return Called(False, "contact normals are isotropic")
    about = scene.about_axis
    return Called(True, f"contact normals with D33 = {about.written(D33)}"
                  + (f", D3333 = {about.written(D3333)}" if D3333 else ""))


def _add_to_fabric(scene: Scene, fabric: AxialFabric) -> AxialFabric:
    normals = scene.fabric_about_axis
    return replace(fabric, D33=normals.D33, D3333=normals.D3333)


def _bound(simulated: Simulated) -> Bound:
    """Directions without contacts leave no bound; else the density, the forces and their balance change by ratios."""
    fabric, loading = simulated.fabric, simulated.loading
    if loading is not None and loading.opens():
        return Bound(math.inf, MAY_CLOSE)
    density = Range.of(*_extremes(fabric))
    if math.isinf(density.low):
        return Bound(math.inf, MISSING)
    D33 = Fraction(fabric.D33)
    N11, N33 = Range.of(1 - D33 / 5), Range.of(1 + 2 * D33 / 5)
    change = Change(share=density ** -1.0, across=N11 ** -1.0, along=N33 ** -1.0)
    if not fabric.collinear:  # the mean of n^l_i n_k of spheroids has the same density, and another integrand
        change = replace(change, across=change.share, along=change.share)
    if loading is not None:
        carrying = [ratio for ratio, stress in ((N11, loading.sigma11), (N33, loading.sigma33)) if stress]
        forces = carrying[0] | carrying[-1]
        chi, apart = _slip(simulated, loading)
        change = replace(change, normal=forces ** (1 / 3), chi=chi, apart=apart)
    return Bound(largest_change(change, simulated), LARGEST)


def _extremes(fabric: AxialFabric) -> list[Fraction]:
    """Values of 4 pi E [-] at the pole, at the equator and where it turns in between, exactly."""
    equator, between, pole = fabric.density_coefficients()
    extremes, curvature = [equator, pole], equator - between + pole
    if curvature and 0 < (turn := (2 * equator - between) / (2 * curvature)) < 1:
        extremes.append(equator * (1 - turn) ** 2 + between * turn * (1 - turn) + pole * turn**2)
    return extremes


def _slip(simulated: Simulated, loading: Loading) -> tuple[Range, Range]:
    """Ratios of k_r/k_n and of 1 - k_r/k_n, for contacts whose force is tilted otherwise without D33.

    The tangent of the tilt is (r - 1) t/(t^2 + r) with t = tan(beta) and r the force at the pole over that at the
    equator. Its derivative by log(r) is w (r^(1/2) w^2 + r^(-1/2))/(1 + w^2)^2 with w = t/r^(1/2), and neither of the
    two terms is larger than STEEPEST beside its power of r.
    """
    if loading.friction is None:
        return UNCHANGED, UNCHANGED
    tilt = loading.tilt(simulated.fabric.D33)
    if loading.friction == 0.0:  # all contacts slide, with the density and without it
        return UNCHANGED, UNCHANGED
    (a, c), (a0, c0) = loading.coefficients(simulated.fabric.D33), loading.coefficients(0.0)
    if tilt is None or tilt >= 1 or abs(log(c / a)) > STEEP:
        return UNKNOWN, UNKNOWN
    r, r0 = c / a, c0 / a0
    kappa = math.sqrt(tilt)
    steepest = STEEPEST * 2 * max(math.cosh(log(r) / 2), math.cosh(log(r0) / 2))
    lost = steepest * abs(log(r0 / r)) / loading.friction * (1 + kappa) / float(1 - tilt)
    chi = Range(math.log1p(-lost) / 3 if lost < 1 else -math.inf, math.log1p(lost) / 3)
    nu = Fraction(simulated.poisson_ratio)
    apart = UNKNOWN
    if nu:  # lambda_0/(1 - lambda_0) times the change of chi
        moved = float((2 - 2 * nu) / nu) * max(expm1(chi.high), -math.expm1(chi.low))
        apart = Range(math.log1p(-moved) if moved < 1 else -math.inf, math.log1p(moved))
    if lost < 1 and r != 1:  # 1 - chi = y/(1 + chi + chi^2), y the tilt over the friction
        tilted = Range.of(abs((r0 - 1) / (r - 1))) * (UNCHANGED | Range.of(r / r0))
        apart &= UNCHANGED | tilted / (UNCHANGED | chi**2.0)
    return chi, apart


def _called_for_by_tensors(scene: Scene) -> Called:
    fabric = scene.general_fabric
    if fabric.D == ZERO and fabric.D4 is None:
        return Called(False, "contact normals are isotropic")
    if fabric.D4 is None:
        return Called(True, "contact normals by a tensor, " + span("4 pi E", fabric.D))
    return Called(True, "contact normals by tensors of rank two and four")


def _add_tensors(scene: Scene, fabric: GeneralFabric) -> GeneralFabric:
    normals = scene.general_fabric
    return replace(fabric, D=normals.D, D4=normals.D4)


def _bound_of_tensors(simulated: GeneralSimulated) -> Bound:
    """As about an axis; the static hypothesis has a bound where N stays, that is for a part of rank four alone."""
    from granular.effects.forms import largest_change_of_form, with_forces_of
    from granular.general.fabric import density_range

    if simulated.fabric.D == ZERO and simulated.fabric.D4 is None:
        return Bound(0.0, "contact normals are isotropic")
    if simulated.opens:
        return Bound(math.inf, MAY_CLOSE)
    least, greatest = density_range(simulated.fabric)
    if least <= 0:
        return Bound(math.inf, MISSING)
    if simulated.static and simulated.fabric.D != ZERO:
        return Bound(math.inf, "other forces would balance the same stress")
    change = Change(share=Range.of(least, greatest) ** -1.0)
    if simulated.loading is not None:
        change = with_forces_of(change, simulated,
                                replace(simulated, fabric=replace(simulated.fabric, D=ZERO, D4=None)))
    return Bound(largest_change_of_form(change, simulated), LARGEST)


EFFECT = Effect(
    name="packing", title="anisotropic density of contact normals", equations="eqs (4) and (7)",
    without="contact normals are then isotropic", called_for=_called_for, bound=_bound, add_to_fabric=_add_to_fabric,
    without_axis=WithoutAxis(called_for=_called_for_by_tensors, bound=_bound_of_tensors, add_to_fabric=_add_tensors))
