"""What proves the errata on names, components, moduli and bounds: the printed value beside the computed one."""

from __future__ import annotations

import numpy as np
import sympy as sp

from derivations.fabric import fabric_tensor
from derivations.symbols import D33, latex
from granular import Evaluation, Hypothesis, Scene, axial_stiffness, evaluate, hertz_mindlin
from granular.loading import Loading
from page_tools.errata_record import proved
from page_tools.markup import Markup, table
from page_tools.paper import RATIOS, ROUNDING, cases, evaluated, scene_of

PRINTED_TENSOR = sp.Rational(2, 15), sp.Rational(1, 3)
"""Printed factors of delta_ij and of D_ij below equation (23)."""

FABRIC = 0.3
"""D33 of the packing in which forces of both hypotheses are compared."""


def fabric_tensor_check() -> Markup:
    """Compare the printed fabric tensor with the average of n_i n_j over the sphere, by their traces."""
    of_delta, of_fabric = PRINTED_TENSOR
    printed = of_delta - of_fabric * D33 / 2, of_delta + of_fabric * D33
    traces = [sp.expand(2 * pair[0] + pair[1]) for pair in (printed, fabric_tensor())]
    rows = [[name, *(f"${latex(sp.expand(value))}$" for value in (*pair, trace))]
            for name, pair, trace in zip(("printed", "averaged over the sphere"), (printed, fabric_tensor()), traces,
                                         strict=True)]
    return proved(traces == [sp.Rational(2, 5), 1], "for every $D_{33}$ the averaged tensor has the trace 1, the "
                  "printed one the trace 2/5", table(
                      ["", "$N_{11} = N_{22}$", "$N_{33}$", "trace"], rows, label="tab-fabric-tensor",
                      caption="The fabric tensor and its trace, which must be 1."))


def shear_order_check(data: str) -> Markup:
    """Show the shear ratio both ways up beside the printed one."""
    name, column = RATIOS[1]
    rows, nearer = [], []
    for case in cases(data):
        ratio = next(ratio.value for ratio in evaluated(case).ratios if ratio.name == name)
        rows.append([case["case"], f"{ratio:.4f}", f"{1 / ratio:.4f}", case[column]])
        nearer.append(abs(ratio - float(case[column])) < 0.01 * abs(1 / ratio - float(case[column])))
    return proved(all(nearer), "every printed ratio is that of the first column, to a hundredth of its distance from "
                  "the second", table(
                      ["case", "$C_{2323}/C_{1212}$", "$C_{1212}/C_{2323}$", "printed $C_{66}/C_{44}$"], rows,
                      label="tab-shear-order", align="lrrr",
                      caption="The printed shear ratio is vertical over horizontal."))


def grain_modulus_check() -> Markup:
    """Evaluate the isotropic assembly with the printed and with the meant shear modulus of the grains."""
    found = {modulus: _with_grains(modulus).stiffness.C3333 for modulus in ("31 Pa", "31 GPa")}
    rows = [["31 Pa", f"{found['31 Pa']:.4g} Pa"], ["31 GPa", f"{found['31 GPa'] / 1e6:.4g} MPa"]]
    return proved(abs(found["31 GPa"] / found["31 Pa"] / 1e6 - 1) < ROUNDING,
                  "the two differ by a factor of a million, to rounding", table(
                      ["$G_s$", "$C_{3333}$ under 28 kPa"], rows, label="tab-grain-modulus", align="lr",
                      caption="The isotropic assembly with the printed shear modulus of the grains and with the meant "
                              "one."))


def isotropic_moduli_check(data: str) -> Markup:
    """Compare printed, computed and independently computed stiffness of the isotropic assembly."""
    scene = scene_of(0.0, 0.0)
    components = evaluate(scene).stiffness.components
    bulk, shear = hertz_mindlin.moduli(
        scene.grains.shear_modulus, scene.grains.poisson_ratio, mean_stress=scene.stress.mean_stress,
        void_ratio=scene.packing.void_ratio, coordination_number=scene.packing.coordination)
    independent = {"C3333": bulk + 4 * shear / 3, "C2323": shear, "C1133": bulk - 2 * shear / 3}
    rows, factors = [], []
    for row in cases(data):
        name, printed = row["component"], float(row["printed_MPa"])
        computed = components[name] / 1e6
        factors.append(printed / computed)
        rows.append([f"$C_{{{name[1:]}}}$", row["printed_MPa"], f"{computed:.8g}", f"{independent[name] / 1e6:.8g}",
                     f"{printed / computed:.3f}"])
    # 1e-11: the coupling stiffness is a difference of two moduli forty times as large
    agree = all(abs(independent[name] / components[name] - 1) < 1e-11 for name in independent)
    return proved(agree and min(factors) > 9, "model and formula agree to eleven digits, and every printed value is "
                  "more than nine times as large", table(
                      ["component", "printed", "computed", "Hertz–Mindlin", "printed / computed"], rows,
                      label="tab-isotropic", align="lrrrr", take_away="isotropic_28kpa_compared.csv",
                      caption="Stiffness of the isotropic assemblies under 28 kPa, in MPa."))


def bounds_check(data: str) -> Markup:
    """Compare both hypotheses by the eigenvalues of their difference."""
    rows, signs = [], []
    for case in cases(data):
        kinematic, static = (evaluated(case, hypothesis=hypothesis) for hypothesis in Hypothesis)
        found = np.linalg.eigvalsh((kinematic.stiffness.mandel() - static.stiffness.mandel())
                                   / kinematic.reference_stiffness)
        signs.append(found[0] > -ROUNDING < found[-1])
        rows.append([case["case"], f"{kinematic.stiffness.C3333 / 1e6:.2f}", f"{static.stiffness.C3333 / 1e6:.2f}",
                     f"{max(found[0], 0.0):.5f}", f"{found[-1]:.5f}"])
    return proved(all(signs), "no eigenvalue of the difference is negative", table(
        ["case of Table II", "$C_{3333}$ kinematic", "$C_{3333}$ static", "least eigenvalue", "largest"], rows,
        label="tab-which-bound", align="lrrrr",
        caption="The kinematic stiffness is the larger one. Components in MPa; eigenvalues of kinematic minus static "
                "stiffness, normalised."))


def two_estimates_check() -> Markup:
    """Compare contact forces by equation (23) with those of uniform strain in the same packing."""
    a, c = (float(value) for value in Loading.of_ratio(1).coefficients(FABRIC))
    c1111, c3333, c1122, c1133, _, _ = axial_stiffness(FABRIC, 0.0, kinetic=False)
    across, along = np.linalg.solve([[c1111 + c1122, c1133], [2 * c1133, c3333]], [1.0, 1.0])
    rows = [["equation (23)", f"{c / a:.4f}"], ["uniform strain, contacts of one stiffness", f"{along / across:.4f}"]]
    return proved(abs(c / a - along / across) > 1e-3, "uniform strain gives other forces than equation (23)", table(
        ["forces by", "$f_n$ at the pole over $f_n$ at the equator"], rows, label="tab-two-estimates", align="lr",
        caption=f"Normal forces under isotropic stress in a packing with $D_{{33}} = {FABRIC:g}$, by two hypotheses."))


def level_check() -> Markup:
    """Evaluate the last case of Table V under its mean stress and under three times as much."""
    found = []
    for mean in ("28 kPa", "84 kPa"):
        content = scene_of(0.0, 0.0, effects=["packing", "branches", "kinetic", "slip"]).model_dump(exclude_none=True)
        content["grains"]["friction_angle"] = "12 deg"
        content["stress"] = {"mean": mean, "ratio": 2.0}
        found.append([ratio.value for ratio in evaluate(Scene.model_validate(content)).ratios])
    apart = max(abs(one / other - 1) for one, other in zip(*found, strict=True))
    return proved(apart < ROUNDING, "under three times the stress both ratios of Table V, stress ratio 2, are the same "
                  "to rounding")


def _with_grains(shear_modulus: str) -> Evaluation:
    content = scene_of(0.0, 0.0).model_dump()
    content["grains"]["shear_modulus"] = shear_modulus
    return evaluate(Scene.model_validate(content))
