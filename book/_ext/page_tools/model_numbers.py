"""Numbers of the model's pages: values to check another program against, and how much each limit matters."""

from __future__ import annotations

import math
from dataclasses import dataclass

import granular
from granular.carried import carried_stress
from granular.checks.on_the_fly import certified_components
from granular.fabric import AxialFabric
from granular.figures.approach_to_limits import LIMITS, STEPS, distances
from granular.figures.mohr_circle import FRICTION_ANGLE, onset_ratio
from granular.figures.waves import TABLE_II_CASE_3
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.result import COMPONENTS
from page_tools.markup import Markup, table

NU = 0.21
FRICTION = math.tan(math.radians(FRICTION_ANGLE))

Case = tuple[float, float, float]
"""D33, Dr33 and stress ratio."""


@dataclass(frozen=True, slots=True)
class Values:
    """A table of values to check against: which assemblies, and what acts on their contacts."""

    label: str
    caption: str
    cases: tuple[Case, ...]
    kinetic: bool = False
    friction: float | None = None
    hypothesis: Hypothesis = Hypothesis.KINEMATIC


ALIKE = ((0.0, 0.0, 1.0), (0.3, 0.0, 1.0), (0.3, -0.3, 1.0))
STRESSED = ((0.0, 0.0, 1.5), (0.3, -0.3, 1.0), (0.3, -0.3, 2.0))
TABLES = {
    "constant": Values("tab-check-kinematic", "contacts of one stiffness, kinematic hypothesis", ALIKE),
    "static": Values("tab-check-static", "contacts of one stiffness, static hypothesis", ALIKE,
                     hypothesis=Hypothesis.STATIC),
    "sticking": Values("tab-check-kinetic", "contacts that follow their forces and do not slip", STRESSED, True),
    "slipping": Values("tab-check-slip", f"contacts that follow their forces and slip, friction angle "
                       f"{FRICTION_ANGLE:g}°", STRESSED, True, FRICTION),
}
APART = 1e-12
"""What the compiled way of computing may be off from the certified value; the digits shown are the certified ones."""


def check_values(kind: str) -> Markup:
    """Six components of three assemblies to twelve digits, from ball arithmetic."""
    wanted = TABLES[kind]
    columns = [_certified(wanted, case) for case in wanted.cases]
    for case, known in zip(wanted.cases, columns, strict=True):
        normals, branches, ratio = case
        found = granular.axial_stiffness(normals, branches, ratio, wanted.friction, NU, kinetic=wanted.kinetic,
                                         hypothesis=wanted.hypothesis.value)
        if max(abs(one / two - 1) for one, two in zip(found.tolist(), known, strict=True)) > APART:
            raise AssertionError(f"{kind}: {case} is not what the library computes")
    rows = [[f"$C_{{{name[1:]}}}$", *(f"{known[place]:.12f}" for known in columns)]
            for place, name in enumerate(COMPONENTS)]
    heads = ["", *(_named(case, stress=wanted.kinetic) for case in wanted.cases)]
    plain = ["component", *(f"D33={a:g} Dr33={b:g} SR={c:g}" for a, b, c in wanted.cases)]
    return table(heads, rows, label=wanted.label, align="lrrr", take_away=f"{wanted.label[4:]}.csv",
                 taken=[plain, *([name, *row[1:]] for name, row in zip(COMPONENTS, rows, strict=True))],
                 caption=f"Numbers to check against: {wanted.caption}, Poisson's ratio {NU:g}, over "
                         r"$(M/V)\,\ell_e^2 k_{n,\mathrm{ref}}$; certified, all digits. Above the columns "
                         r"$D_{33}$, $D^{r}_{33}$" + (r", $\sigma_{33}/\sigma_{11}$." if wanted.kinetic else "."))


def _certified(wanted: Values, case: Case) -> list[float]:
    normals, branches, ratio = case
    loading = Loading.of_ratio(ratio, friction=wanted.friction) if wanted.kinetic else None
    fabric = AxialFabric(D33=normals, Dr33=branches)
    return [float(value) for value in certified_components(fabric, NU, wanted.hypothesis, loading)]


def _named(case: Case, *, stress: bool) -> str:
    normals, branches, ratio = (f"{value:g}".replace("-", "−") for value in case)
    return f"{normals}, {branches}" + (f", {ratio}" if stress else "")


def hypotheses_apart() -> Markup:
    """By how much the static estimate lies below the kinematic one, isotropic packing."""
    both = [granular.axial_stiffness(0.0, 0.0, poisson_ratio=NU, kinetic=False, hypothesis=name)
            for name in ("kinematic", "static")]
    shear = COMPONENTS.index("C2323")
    return Markup(f"For an isotropic packing with $\\nu = {NU:g}$ the static hypothesis gives the same bulk modulus "
                  f"and a shear modulus that is {100 * (1 - both[1][shear] / both[0][shear]):.2g} % lower; real loose "
                  "packings are far below both in shear ([](dem.md)).\n")


def carried(ratio: float) -> Markup:
    """The stress ratio that forces carry when those of sliding contacts are cut down to their friction."""
    across, along = carried_stress(AxialFabric(), Loading.of_ratio(ratio, friction=FRICTION))
    return Markup(f"- In an isotropic packing under the stress ratio {ratio:g} with a friction angle of "
                  f"{FRICTION_ANGLE:g}°, forces cut down to the friction carry the stress ratio {along / across:.2f} "
                  "and the full mean stress. Up to the onset of sliding nothing is missing.\n")


def slip_counts() -> Markup:
    """By how much slip lowers the shear stiffness, at the onset and beyond it."""
    onset = onset_ratio(FRICTION_ANGLE)
    said = []
    for ratio in (1.25, onset, 2.0):
        slipping, sticking = (granular.axial_stiffness(0.0, 0.0, ratio, friction, NU) for friction in (FRICTION, None))
        least, most = sorted(100 * float(1 - slipping[place] / sticking[place])
                             for place in (COMPONENTS.index("C2323"), COMPONENTS.index("C1212")))
        said.append(f"by {least:.0f} and {most:.0f} % at the stress ratio {ratio:.4g}")
    return Markup(f"For an isotropic packing with a friction angle of {FRICTION_ANGLE:g}° slip lowers the two shear "
                  f"components {said[0]}, {said[1]}, where the first contacts slide, and {said[2]}.\n")


def limit_table() -> Markup:
    """How far the stiffness is from four limits, far from each and close to it."""
    rows, places = [], (0, 2, 5, len(STEPS) - 1)
    for limit in LIMITS:
        found = distances(limit)
        power = "5/6" if limit.power < 1 else f"{limit.power:g}"
        rows.append([limit.name.replace(r"\to", r"\to "), power, *(f"{found[place]:.2e}" for place in places)])
    return table(["limit", "power", *(f"{STEPS[place]:.1e}" for place in places)], rows, label="tab-approach",
                 align="lrrrrr", take_away="approach_to_limits.csv",
                 caption="Relative change of $C_{2323}$ at some distances from four limits, isotropic packing, "
                         "certified. The distance is $\\sigma_{33}/\\sigma_{11} - 1$, $1/\\mu$, $\\mu$, and "
                         "$\\mu/\\mu_{\\mathrm{onset}} - 1$.")


def grains_in_a_wave(grain: float, *, least: float = 10.0) -> Markup:
    """The frequency up to which a wave is long against the grains of a size in metres."""
    waves = granular.evaluate(granular.Scene.model_validate(TABLE_II_CASE_3)).waves
    if waves is None:
        raise AssertionError("the scene gives a density")
    slowest = min(min(waves.at(float(angle)).SV, waves.at(float(angle)).SH) for angle in range(0, 91, 5))
    return Markup(f"The slowest shear wave of the example runs at {slowest:.0f} m/s. With grains of {1e3 * grain:g} mm "
                  f"it is {least:g} grains long at {slowest / (least * grain) / 1e3:.2g} kHz; above that it begins to "
                  "see single grains.\n")
