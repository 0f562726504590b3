"""Effect ``kinetic``: contact stiffness that follows the estimated contact force in each direction."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from granular.effects.effect import Called, Effect

if TYPE_CHECKING:
    from granular.scene import Scene


def force_coefficients(scene: Scene) -> tuple[Fraction, Fraction]:
    """Estimated contact force at the equator and at the pole, up to a common positive factor, exactly.

    Parameters
    ----------
    scene : Scene
        Gives the principal stresses and D33; D3333 does not enter the fabric tensor N of rank two.

    Returns
    -------
    tuple of Fraction
        a = sigma11/N11 and c = sigma33/N33 [-], N11 = 1/3 - D33/15, N33 = 1/3 + 2 D33/15; the normal force in
        the direction x is proportional to a (1 - x^2) + c x^2, the shear force to |c - a| x sqrt(1 - x^2).

    Notes
    -----
    Exact for the doubles given. Source: eq. (23).
    """
    sigma11, sigma33 = scene.stress.principal
    D33 = Fraction(scene.fabric.D33)
    return 15 * sigma11 / (5 - D33), 15 * sigma33 / (5 + 2 * D33)


def _called_for(scene: Scene) -> Called:
    equator, pole = force_coefficients(scene)
    if equator == pole:
        return Called(False, "the estimated contact force is the same in every direction")
    if equator == 0:
        return Called(True, "the estimated contact force varies with direction: it vanishes at the equator")
    return Called(True, "the estimated contact force varies with direction: at the pole it is "
                        f"{_decimal(pole / equator)} times that at the equator")


def _decimal(ratio: Fraction) -> str:
    try:
        return f"{float(ratio):.6g}"
    except OverflowError:
        return "more than 1e308"


EFFECT = Effect(
    name="kinetic", title="contact stiffness that follows the contact force", source="eqs (20) and (22)-(23)",
    without="every contact then has the stiffness of the ideal assembly under the mean stress, as in the paper's "
            "Table II",
    called_for=_called_for)
