"""What proves each erratum: the printed value beside the computed one."""

from __future__ import annotations

import sympy as sp

from derivations.fabric import fabric_tensor
from derivations.symbols import D33, latex
from granular import Evaluation, Scene, evaluate, hertz_mindlin
from page_tools.markup import Markup, table
from page_tools.paper import RATIOS, cases, evaluated, scene_of

PRINTED_TENSOR = sp.Rational(2, 15), sp.Rational(1, 3)
"""Printed factors of delta_ij and of D_ij below equation (23)."""


def fabric_tensor_check() -> Markup:
    """Compare the printed fabric tensor with the average of n_i n_j over the sphere, by their traces."""
    of_delta, of_fabric = PRINTED_TENSOR
    printed = of_delta - of_fabric * D33 / 2, of_delta + of_fabric * D33
    rows = [[name, *(f"${latex(sp.expand(value))}$" for value in (*pair, 2 * pair[0] + pair[1]))]
            for name, pair in (("printed", printed), ("averaged over the sphere", fabric_tensor()))]
    return table(["", "$N_{11} = N_{22}$", "$N_{33}$", "trace"], rows, label="tab-fabric-tensor",
                 caption="The fabric tensor and its trace, which must be 1.")


def shear_order_check(data: str) -> Markup:
    """Show the shear ratio both ways up beside the printed one."""
    name, column = RATIOS[1]
    rows = []
    for case in cases(data):
        ratio = next(ratio.value for ratio in evaluated(case).ratios if ratio.name == name)
        rows.append([case["case"], f"{ratio:.4f}", f"{1 / ratio:.4f}", case[column]])
    return table(["case", "$C_{2323}/C_{1212}$", "$C_{1212}/C_{2323}$", "printed $C_{66}/C_{44}$"], rows,
                 label="tab-shear-order", align="lrrr", caption="The printed shear ratio is vertical over horizontal.")


def grain_modulus_check() -> Markup:
    """Evaluate the isotropic assembly with the printed and with the meant shear modulus of the grains."""
    rows = [[modulus, f"{_with_grains(modulus).stiffness.C3333:.4g} Pa"] for modulus in ("31 Pa", "31 GPa")]
    return table(["$G_s$", "$C_{3333}$ under 28 kPa"], rows, label="tab-grain-modulus", align="lr",
                 caption="The isotropic assembly with the printed shear modulus of the grains and with the meant one.")


def isotropic_moduli_check(data: str) -> Markup:
    """Compare printed, computed and independently computed stiffness of the isotropic assembly."""
    scene = scene_of(0.0, 0.0)
    components = evaluate(scene).stiffness.components
    bulk, shear = hertz_mindlin.moduli(
        scene.grains.shear_modulus, scene.grains.poisson_ratio, mean_stress=scene.stress.mean_stress,
        void_ratio=scene.packing.void_ratio, coordination_number=scene.packing.coordination)
    independent = {"C3333": bulk + 4 * shear / 3, "C2323": shear, "C1133": bulk - 2 * shear / 3}
    rows = []
    for row in cases(data):
        name, printed = row["component"], float(row["printed_MPa"])
        computed = components[name] / 1e6
        rows.append([f"$C_{{{name[1:]}}}$", row["printed_MPa"], f"{computed:.8g}", f"{independent[name] / 1e6:.8g}",
                     f"{printed / computed:.3f}"])
    return table(["component", "printed", "computed", "Hertz–Mindlin", "printed / computed"], rows,
                 label="tab-isotropic", align="lrrrr", take_away="isotropic_28kpa_compared.csv",
                 caption="Stiffness of the isotropic assemblies under 28 kPa, in MPa.")


def _with_grains(shear_modulus: str) -> Evaluation:
    content = scene_of(0.0, 0.0).model_dump()
    content["grains"]["shear_modulus"] = shear_modulus
    return evaluate(Scene.model_validate(content))
