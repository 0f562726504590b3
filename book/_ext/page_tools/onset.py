"""How far the answer follows the last digits of the friction next to the onset of sliding."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

import granular
from granular.loading import Loading
from granular.routes.result import COMPONENTS
from page_tools.markup import Markup, table

STRESS_RATIO, ONSET = 4.0, 0.75
"""An isotropic packing under this stress ratio begins to slide at exactly this friction coefficient."""

DISTANCES = (1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
SHOWN = tuple(COMPONENTS.index(name) for name in ("C1111", "C3333", "C2323", "C1212"))


def sensitivity(distance: float) -> float:
    """Largest change in the logarithm of a component over that in the logarithm of the friction."""
    exact = Loading.of_ratio(STRESS_RATIO, friction=ONSET).tilt(0.0)
    assert exact == 1, "the onset is where it is said to be"
    friction = ONSET * (1 + distance * np.array([0.95, 1.05]))
    low, high = np.log(granular.axial_stiffness(0.0, 0.0, STRESS_RATIO, friction)[:, SHOWN])
    return float(np.max(np.abs(high - low)) / abs(math.log(friction[1] / friction[0])))


def sensitivity_table() -> Markup:
    """List the sensitivity on both sides of the onset against the inverse sixth root of the distance."""
    rows = []
    for distance in DISTANCES:
        above, below = sensitivity(distance), sensitivity(-distance)
        rows.append([f"$10^{{{round(math.log10(distance))}}}$", f"{distance ** (-1 / 6):.1f}", f"{above:.2f}",
                     f"{below:.2f}"])
    return table([r"$\lvert\mu/\mu_0 - 1\rvert$", "to the power −1/6", "all stick", "some slide"], rows,
                 label="tab-sensitivity", align="rrrr", take_away="sensitivity.csv",
                 caption="Relative change of the most sensitive of $C_{1111}$, $C_{3333}$, $C_{2323}$, $C_{1212}$ over "
                         "that of the friction coefficient, at relative distances from the onset $\\mu_0$; "
                         "isotropic packing, stress ratio 4, $\\mu_0 = 3/4$.")


def rounded_tangent() -> Markup:
    """Show what the rounding of tan(30 deg) does where the exact tangent is at the onset."""
    nearest = math.tan(math.radians(30))
    neighbours = [math.nextafter(nearest, 0), nearest, math.nextafter(nearest, 1)]
    component = COMPONENTS.index("C1212")
    values = [float(granular.axial_stiffness(0.0, 0.0, 3.0, friction)[component]) for friction in neighbours]
    rows = [[repr(friction), "some slide" if Loading.of_ratio(3, friction=friction).slides(0) else "all stick",
             _signed(float((3 * Fraction(friction) ** 2 - 1) / 2)), _signed(value / values[1] - 1)]
            for friction, value in zip(neighbours, values, strict=True)]
    return table([r"$\mu$", "contacts", r"$\mu/\tan 30^\circ - 1$", "change of $C_{1212}$"], rows,
                 label="tab-rounded", align="llrr",
                 caption="The double nearest to tan 30° in the middle, and its neighbours, for an isotropic packing "
                         "under the stress ratio 3, whose contacts begin to slide at tan 30°.")


def _signed(value: float) -> str:
    return "0" if value == 0 else f"{value:+.1e}".replace("-", "−")
