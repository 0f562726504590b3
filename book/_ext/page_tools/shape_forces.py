"""Contact forces between spheroids on a page: what the estimate of eq. (22) carries, and what balance changes."""

from __future__ import annotations

import math

from granular import AxialFabric, Hypothesis
from granular.collinear import Ratios
from granular.loading import Loading
from granular.routes import axial
from granular.spheroid import stress_carried
from granular.spheroid_forces import balancing
from page_tools.markup import Markup, table
from page_tools.shape import POISSON, percent

SHAPES = (0.5, 0.7, 0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.25, 1.5)
EVALUATED = (0.8, 0.9, 1.0, 1.1, 1.25)
STRESS_RATIOS = (1.0, 1.5)
HEADER = ("b/a", "sigma33/sigma11", "evaluated at", "contacts", "C1111/C3333", "change of C1111/C3333", "C2323/C1212",
          "change of C2323/C1212")
"""Columns of the file of the second table, two of which have the same head on the page."""

FRICTION_ANGLE = 12.0
"""Of the paper's tables [degrees]."""


def carried_table() -> Markup:
    """List the share of the stress that the estimated forces carry, and the stress ratio at which they balance it."""
    rows = []
    for shape in SHAPES:
        across, along = stress_carried(AxialFabric(aspect_ratio=shape))
        rows.append([f"{shape:g}", f"{across:.3f}", f"{along:.3f}", f"{across / along:.3f}"])
    return table(["$b/a$", "$\\sigma_{11}$ carried", "$\\sigma_{33}$ carried", "factor on the stress ratio"], rows,
                 label="tab-carried", align="rrrr", take_away="stress_carried.csv",
                 caption="Mean stress that the forces of equation (22) make on aligned spheroids, over the stress that "
                         "they were estimated from, and the factor that puts the stress ratio right; isotropic "
                         "contact normals.")


def balanced_table() -> Markup:
    """Compare both ratios with forces as estimated and with forces that balance the stress."""
    rows = []
    for shape in EVALUATED:
        fabric = AxialFabric(aspect_ratio=shape)
        for ratio in STRESS_RATIOS:
            given = Loading.of_ratio(ratio, friction=math.tan(math.radians(FRICTION_ANGLE)))
            balanced = balancing(given, fabric)
            estimated, better = (_ratios(fabric, loading) for loading in (given, balanced))
            rows.append([f"{shape:g}", f"{ratio:g}", f"{float(balanced.sigma33 / balanced.sigma11):.3f}",
                         _state(balanced), *(text for before, after in zip(estimated, better, strict=True)
                                             for text in (f"{before:.4f}", percent(after / before - 1)))])
    return table(["$b/a$", "$\\sigma_{33}/\\sigma_{11}$", "at", "contacts", "$C_{1111}/C_{3333}$", "change",
                  "$C_{2323}/C_{1212}$", "change"], rows, label="tab-balanced", align="rrrlrrrr",
                 take_away="balanced.csv", taken=[HEADER, *rows],
                 caption="Ratios of the stiffness with forces as equation (22) estimates them, and their change when "
                         "the forces balance the stress. The third column is the stress ratio at which this is an "
                         "evaluation, the fourth what contacts do there. Isotropic contact normals, fixed spin, "
                         f"friction angle {FRICTION_ANGLE:g}°.")


def _ratios(fabric: AxialFabric, loading: Loading) -> Ratios:
    six = axial.evaluate(fabric, poisson_ratio=POISSON, hypothesis=Hypothesis.KINEMATIC, loading=loading).components
    return Ratios(six[0] / six[1], six[4] / six[5])


def _state(loading: Loading) -> str:
    return "slide" if loading.slides(0) else "stick"
