"""Branch lengths on a page: how well the rules do, what eq. (19) neglects, lengths that change with direction."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from granular import AxialFabric, Scene, axial_stiffness, evaluate
from granular.branch_products import along_normals, lognormal_lengths
from granular.branch_spread import stiffness_with_spread
from granular.branch_stiffness import stiffness_by_direction
from granular.checks.length_rule import SPREADS, STRETCHES, rule_errors
from granular.directions import branch_weight
from granular.gradation.fitted_lengths import neglected
from granular.routes.direction_sums import axial_components
from granular.routes.result import COMPONENTS
from page_tools.markup import Markup, table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

POISSON_RATIO = 0.21
FABRIC = AxialFabric(D33=0.3, Dr33=-0.3)
"""The fabric of Table II, case 3."""

SPREAD, ANISOTROPY = 1.5, 0.5
"""Spread of the lengths, and how it changes with direction, of the example [-]."""

NEGLECTED_FOR = (1.05, 1.2, 1.5, 2.0, 3.0)


def rule_table() -> Markup:
    """List the error of both trapezoidal rules against their number of nodes, for three spreads."""
    of_spread = [rule_errors(spread) for spread in SPREADS]
    rows, taken = [], [["step", *(f"{what}, s_r = {spread:g}" for spread in SPREADS for what in ("nodes", "error"))]]
    for place, stretch in enumerate(STRETCHES):
        found = [errors[place] for errors in of_spread]
        rows.append([f"{stretch:g}", *(cell for one in found for cell in (f"{one.nodes}", _power(one.error)))])
        taken.append([f"{stretch:g}", *(cell for one in found for cell in (f"{one.nodes}", f"{one.error:.1e}"))])
    heads = [f"{spread:g}: {what}" for spread in SPREADS for what in ("nodes", "error")]
    return table(["step", *heads], rows, label="tab-length-rule", align="r" * (1 + len(heads)), taken=taken,
                 take_away="branch_length_rule.csv",
                 caption="Relative error of $\\langle\\ell^2\\rangle$ by both rules against certified values, for "
                         f"$s_r$ = {', '.join(f'{spread:g}' for spread in SPREADS)}; steps over those of the library, "
                         "and pairs of nodes.")


def rule_words() -> Markup:
    """Say what wide steps leave, and how the number of nodes depends on the spread."""
    wide = STRETCHES.index(2.0)
    worst = [max(rule_errors(spread)[place].error for spread in SPREADS) for place in (wide, -1)]
    narrow, broad = (rule_errors(spread)[-1].nodes for spread in (SPREADS[0], SPREADS[-1]))
    return Markup(
        f"Steps twice as wide as those of the library leave errors up to {_power(worst[0])}, and its own up to "
        f"{_power(worst[1])}, which is rounding. The certified values were computed from the definitions (16) and "
        f"(17) in multiple precision. A spread of {SPREADS[-1]:g} needs {100 * (broad / narrow - 1):.0f} % more "
        f"nodes than one of {SPREADS[0]:g}, and a narrow one needs no care: the steps are counted in spreads.\n")


def rule_times(data: str) -> Markup:
    """State the stored times with the machine they were measured on."""
    content = json.loads(Path(data).read_text(encoding="utf-8"))
    about = content["machine"]
    rows = [[name.replace("s_r", "$s_r$"), f"{1e3 * seconds:.1f} ms"] for name, seconds in content["seconds"].items()]
    grid = table(["sizes", "time for both moments"], rows, label="tab-length-times", align="lr",
                 caption="Time for $\\langle\\ell^2\\rangle$ and $\\langle\\ell^{-2}\\rangle$ together, median of "
                         f"{content['rounds']} rounds.")
    return Markup(f"{grid.text}\nMeasured on {about['processor']}, {about['cores']} cores, {about['system']}, with "
                  f"Python {about['python']}, by `granular.checks.length_rule.measure_times`.\n")


def neglected_table() -> Markup:
    """Compare eq. (19) with eq. (17): the largest difference of the densities, and ratios of moments."""
    rows = []
    for spread in NEGLECTED_FOR:
        found = neglected(spread)
        rows.append([f"{spread:g}", f"{found.spread_of_lengths:.4f}", f"{100 * found.largest_difference:.2g} %",
                     *(f"{value:.4f}" for value in (found.mean, found.mean_square, 1 / found.inverse_square)),
                     f"{found.third_of_all:.4f}"])
    return table(["$s_r$", "$s_\\ell$", "densities apart", "$\\langle\\ell\\rangle$", "$\\langle\\ell^2\\rangle$",
                  "$1/\\langle\\ell^{-2}\\rangle$", "$\\langle\\ell^3\\rangle_{\\mathrm{total}}$"], rows,
                 label="tab-neglected", align="rrrrrrr", take_away="eq_19_against_eq_17.csv",
                 caption="Eq. (19) over eq. (17). Densities of $\\ln\\ell$ differ by at most the given share of their "
                         "largest value; then moments along a direction, and the third moment of all branches before "
                         "the cube root.")


def neglected_words() -> Markup:
    """Say how good eq. (19) is near its maximum, and what it loses in the tail."""
    some, wide = (neglected(spread) for spread in (1.5, 2.0))
    lost = [100 * (1 - found.mean_square) for found in (some, wide)]
    return Markup(
        f"Densities of the lognormal form are off by up to {100 * wide.largest_difference:.1f} % of their maximum "
        "for $s_r = 2$. Its tail of long branches is too thin. The mean square length lives in that tail after the "
        f"cube root, and (19) loses {lost[0]:.0f} % of it for $s_r = 1.5$ and {lost[1]:.0f} % for $s_r = 2$.\n")


def spread_by_direction() -> Markup:
    """Compare a rule over the sphere with Kummer functions for a median and a spread that change with direction."""
    found = stiffness_by_direction(along_normals(_lengths(ANISOTROPY)), fabric=AxialFabric(D33=FABRIC.D33),
                                   poisson_ratio=POISSON_RATIO, rtol=1e-12)
    closed, even = (stiffness_with_spread(SPREAD, anisotropy, poisson_ratio=POISSON_RATIO, fabric=FABRIC)
                    for anisotropy in (ANISOTROPY, 0.0))
    sums = axial_components(found.mandel)
    rows = [[f"$C_{{{name[1:]}}}$", f"{constant:.10f}", f"{exactly:.10f}", f"{summed:.10f}"]
            for name, constant, exactly, summed in zip(COMPONENTS, even, closed, sums, strict=True)]
    return table(["component", "the same spread everywhere", "Kummer functions", f"{found.evaluations} directions"],
                 rows, label="tab-spread", align="lrrr", take_away="spread_by_direction.csv",
                 caption=f"Stiffness over $(M/V)\\,\\ell_{{50}}^2k_n$ for $D_{{33}} = {FABRIC.D33:g}$, median "
                         f"$1 {FABRIC.Dr33:+g}\\,P_2$ and spread {SPREAD:g}, first in every direction, then with "
                         f"$L_\\ell = L_e(1 {ANISOTROPY:+g}\\,P_2)$ in two ways.")


def dirac_limit() -> Markup:
    """Show that a spread of 1 gives the stiffness of one length in each direction."""
    found = stiffness_by_direction(along_normals(lognormal_lengths(_median, 1.0)),
                                   fabric=AxialFabric(D33=FABRIC.D33), poisson_ratio=POISSON_RATIO, rtol=1e-12)
    known = axial_stiffness(FABRIC.D33, FABRIC.Dr33, poisson_ratio=POISSON_RATIO, kinetic=False)
    worst = max(abs(one / other - 1) for one, other in zip(axial_components(found.mandel), known, strict=True))
    return Markup(f"For $s_\\ell = 1$ the rule over the sphere and the closed form of case 3 of Table II, which knows "
                  f"one length in each direction, agree to {_power(worst)} in the worst component.\n")


def bound_of_scene(scene: str) -> Markup:
    """Show how the error of the branch lengths enters the bound of a scene."""
    result = evaluate(Scene.from_toml(scene))
    lengths = result.plan.lengths
    assert lengths is not None, "the scene has sizes"
    return Markup(f"For the sieve curve of [](gradation.md) the moments are known to {_power(lengths.relative_error)}, "
                  f"and the components to {_power(result.relative_error)}.\n")


def _lengths(anisotropy: float) -> Callable[[Array], Array]:
    log_variance, weight = math.log(SPREAD) ** 2, AxialFabric(Dr33=anisotropy)

    def spread(n: Array) -> Array:
        import numpy as np

        found: Array = np.exp(np.sqrt(log_variance * branch_weight(weight, n[2])))
        return found

    return lognormal_lengths(_median, spread)


def _median(n: Array) -> Array:
    return branch_weight(FABRIC, n[2])


def _power(error: float) -> str:
    return f"{error:.1e}".replace("-", "−") if error else "0"
