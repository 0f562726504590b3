"""Results as text for people and as JSON for programs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from granular import report_tensors
from granular.explanation import (
    EffectTable,
    arithmetic,
    effect_lines,
    error_budget,
    explained,
    predicted,
    relative_to,
    turned,
)
from granular.hypothesis import Hypothesis
from granular.layout import aligned, facts, grid, lines, pressure, title, unit_for
from granular.number_of_contacts import PER_CUBIC_METRE, PER_DIAMETER_CUBED
from granular.tensors import shown_direction

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.evaluation import Evaluation
    from granular.planning import Plan
    from granular.ratios import Ratio
    from granular.routes.work import Work
    from granular.waves import PhaseVelocities, Waves

BOUND = {Hypothesis.KINEMATIC: "uniform strain, an upper bound of the energy",
         Hypothesis.STATIC: "uniform stress, a lower estimate"}
"""What each hypothesis means for the result."""

CONTACTS = {PER_DIAMETER_CUBED: "per (2 r_e)^3, the cube of one grain diameter", PER_CUBIC_METRE: "per m^3"}
"""The unit of the number of contacts in words."""

MEANING = {
    "C1111": "horizontal compression", "C3333": "vertical compression",
    "C1122": "horizontal with horizontal", "C1133": "vertical with horizontal",
    "C2323": "vertical shear", "C1212": "horizontal shear",
}
"""The six components in words; axis 3 is vertical."""

_LONGEST_FRACTION = 48


def evaluation_as_json(result: Evaluation) -> dict[str, Any]:
    """The object that ``granular run --json`` prints.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.

    Returns
    -------
    dict
        Plain numbers, strings, lists and dicts; stiffnesses [Pa], speeds [m/s].

    Notes
    -----
    Source: the command line's interface.
    """
    about_axis_3 = result.plan.of_each_component
    components = result.stiffness.components if about_axis_3 else report_tensors.constants(result)
    content: dict[str, Any] = {
        "stiffness": {**components, "mandel": [list(row) for row in result.stiffness.rows]},
        "relative_error": _finite(result.relative_error),
        "error_is": None if math.isinf(result.relative_error) else result.error_is,
        "axis": None if result.axis is None else list(result.axis),
        "reference_stiffness": result.reference_stiffness,
        "hypothesis": str(result.hypothesis),
        "route": result.route,
        "evaluations": result.evaluations,
        "work": _work(result.work),
        "effects": {"simulated": list(result.effects_simulated), "not_called_for": result.effects_not_called_for},
        "contacts_per_volume": result.contacts_per_volume,
        "contacts_per_volume_unit": result.contacts_per_volume_unit,
    }
    sizes, lengths = result.plan.sizes, result.plan.lengths
    if sizes is not None and lengths is not None:
        content["grain_sizes"] = {
            "D10": sizes.D10, "D30": sizes.D30, "D50": sizes.D50, "D60": sizes.D60,
            "uniformity": sizes.uniformity, "curvature": sizes.curvature,
            "equal_volume_diameter": lengths.equal_volume_diameter,
            "second_moment": lengths.second, "inverse_second_moment": lengths.inverse_second}
    if (free := result.shear_with_free_spin) is not None:
        content["C2323_with_free_spin"] = free
    if not about_axis_3:
        content |= report_tensors.as_json(result)
    if about_axis_3 and (waves := result.waves) is not None:
        content["waves"] = _waves_as_json(waves)
    elif (general := result.general_waves) is not None and not about_axis_3:
        content["waves"] = report_tensors.waves_as_json(general)
    return content


def _waves_as_json(waves: Waves) -> dict[str, Any]:
    def speeds(of: PhaseVelocities) -> dict[str, float]:
        return {"P": of.P, "SV": of.SV, "SH": of.SH}

    thomsen = waves.thomsen
    return {"density": waves.density, "vertical": speeds(waves.vertical), "horizontal": speeds(waves.horizontal),
            "thomsen": {"epsilon": thomsen.epsilon, "gamma": thomsen.gamma, "delta": thomsen.delta}}


def _work(work: Work | None) -> dict[str, int] | None:
    """Counted arithmetic; None for a route that does not count."""
    return None if work is None else {"operations": work.operations, "functions": work.functions}


def _finite(bound: float) -> float | None:
    """A bound as JSON takes it; None where a route promises none."""
    return None if math.isinf(bound) else bound


def _error(decided: Plan, error: float) -> dict[str, str]:
    """The error under a name that says what it is, and of what."""
    if math.isinf(error):
        return {"error bound": "none is promised by this route"}
    return {f"error {decided.error_is}": f"{error:.2g} of {relative_to(decided)}"}


def plan_as_json(decided: Plan) -> dict[str, Any]:
    """The object that ``granular plan --json`` prints.

    Parameters
    ----------
    decided : Plan
        A plan.

    Returns
    -------
    dict
        Plain numbers, strings, lists and dicts.

    Notes
    -----
    Source: the command line's interface.
    """
    return {
        "hypothesis": str(decided.hypothesis),
        "route": decided.route,
        "route_reason": decided.route_reason,
        "evaluations": decided.evaluations,
        "work": _work(decided.work),
        "evaluations_are": "counted" if decided.error_is == "bound" else "predicted",
        "relative_error": _finite(decided.relative_error),
        "error_is": None if math.isinf(decided.relative_error) else decided.error_is,
        "axis": None if decided.axis is None else list(decided.axis),
        "rtol": decided.rtol,
        "effects": {"simulated": list(decided.effects_simulated), "called_for": decided.called_for,
                    "not_called_for": decided.effects_not_called_for},
        "bounds": {name: _finite(bound) for name, bound in decided.bounds.items()},
        "costs": {name: None if cost is None else dict(zip(("with", "without"), cost, strict=True))
                  for name, cost in decided.costs.items()},
        "left_out_error": decided.left_out_error,
    }


def evaluation_as_text(result: Evaluation, *, explain: bool = False) -> list[RenderableType]:
    """What ``granular run`` shows, for a console of any width.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.
    explain : bool
        With the plan: the table of effects, the reason of the route, where the error comes from.

    Returns
    -------
    list of renderable
        Blocks for ``rich.console.Console.print``, in order.

    Notes
    -----
    Source: the command line's interface.
    """
    blocks: list[RenderableType] = [
        title(f"Stiffness by the {result.hypothesis} hypothesis ({BOUND[result.hypothesis]})"),
        *(_about_axis_3(result) if result.plan.of_each_component else report_tensors.stiffness_blocks(result)),
        *_waves(result)]
    evaluations = f"{result.evaluations} evaluations of the integrand"
    by = "" if result.rule == result.route else f"by the rule {result.rule}, "
    blocks += [title("How it was computed"), facts({
        **_error(result.plan, result.relative_error),
        **(explained(result) if explain else {"route": f"{result.route} ({by}{evaluations})"}),
        "unit": f"(M/V) l_e^2 k_n,ref = {pressure(result.reference_stiffness)}",
        "contacts": f"{result.contacts_per_volume:.7g} {CONTACTS[result.contacts_per_volume_unit]}",
        "grain sizes": _sizes(result),
        "spin": _spin(result),
        **({} if explain else _effects(result.plan)),
    })]
    return [*blocks, *_effect_table(result.plan)] if explain else blocks


def plan_as_text(decided: Plan) -> list[RenderableType]:
    """What ``granular plan`` shows, for a console of any width.

    Parameters
    ----------
    decided : Plan
        A plan.

    Returns
    -------
    list of renderable
        Blocks for ``rich.console.Console.print``, in order.

    Notes
    -----
    Source: the command line's interface.
    """
    return [title("What run would do"), facts({
        "hypothesis": f"{decided.hypothesis} ({BOUND[decided.hypothesis]})",
        "route": f"{decided.route}: {decided.route_reason}",
        "axis": _axis(decided),
        "cost": f"{predicted(decided)} evaluations of the integrand"
                + ("" if decided.axis is None else f"; {arithmetic(decided.work)}"),
        **{name: text + ("" if decided.rtol is None else f", wanted {decided.rtol:.2g}")
           for name, text in _error(decided, decided.relative_error).items()},
        "error budget": error_budget(decided.route_error, decided.scaling_error, decided.left_out_error)
                        + turned(decided.turning),
    }), *_effect_table(decided)]


def _effect_table(decided: Plan) -> list[RenderableType]:
    change = ("each component" if decided.axis is not None else "any component, over the largest,")
    about = "" if decided.axis is None or decided.of_each_component else " about the axis"
    return ["", title(f"Effects, and how much {change}{about} would change at most without them"),
            EffectTable(effect_lines(decided))]


def _about_axis_3(result: Evaluation) -> list[RenderableType]:
    """Six components, their two ratios, and moduli."""
    from rich.text import Text

    return [_components(result), "",
            *(Text(f"  {_ratio(ratio)}", overflow="fold") for ratio in result.ratios), "",
            title("Engineering constants"), _engineering(result), ""]


def _waves(result: Evaluation) -> list[RenderableType]:
    if not result.plan.of_each_component:
        return [] if (general := result.general_waves) is None else report_tensors.wave_blocks(general)
    if (waves := result.waves) is None:
        return []
    return [title(f"Waves in the dry assembly, {waves.density:.6g} kg/m^3"), _wave_table(waves), ""]


def _components(result: Evaluation) -> RenderableType:
    six = result.stiffness.components
    size, unit = unit_for(max(six.values()))
    numbers = aligned(f"{value / size:.7g}" for value in six.values())
    return grid((name, number, unit, MEANING[name]) for name, number in zip(six, numbers, strict=True))


def _ratio(ratio: Ratio) -> str:
    """Give the exact fraction where it is short enough to read, then every digit of the double nearest to it."""
    if ratio.exact is None:
        return f"{ratio.name} = {ratio.value!r}"
    fraction = str(ratio.exact)
    if ratio.exact.denominator == 1:
        return f"{ratio.name} = {fraction}"
    if len(fraction) > _LONGEST_FRACTION:
        return f"{ratio.name} = {ratio.value!r} (rounded from an exact fraction)"
    return f"{ratio.name} = {fraction} = {ratio.value!r}"


def _engineering(result: Evaluation) -> RenderableType:
    constants = result.engineering
    size, unit = unit_for(max(constants.E1, constants.E3))
    moduli = {"E1": constants.E1, "E3": constants.E3, "K": constants.K, "G12": constants.G12, "G23": constants.G23}
    ratios = {"nu12": constants.nu12, "nu13": constants.nu13, "nu31": constants.nu31}
    return lines(
        "  ".join(f"{name} {value / size:.5g}" for name, value in moduli.items()) + f"  {unit}",
        "  ".join(f"{name} {value:.5g}" for name, value in ratios.items()))


def _wave_table(waves: Waves) -> RenderableType:
    def row(name: str, of: PhaseVelocities) -> str:
        return f"{name:<11}P {of.P:.5g}  SV {of.SV:.5g}  SH {of.SH:.5g}  m/s"

    thomsen = waves.thomsen
    delta = "has no value" if thomsen.delta is None else f"{thomsen.delta:.5g}"
    return lines(
        row("vertical", waves.vertical), row("horizontal", waves.horizontal),
        f"{'Thomsen':<11}epsilon {thomsen.epsilon:.5g}  gamma {thomsen.gamma:.5g}  delta {delta}",
        f"{'fastest S':<11}{waves.fastest_shear.polarisation} {waves.fastest_shear.speed:.5g} m/s, "
        f"{waves.fastest_shear.degrees:.4g} deg from axis 3")


def _sizes(result: Evaluation) -> str:
    sizes, lengths = result.plan.sizes, result.plan.lengths
    if sizes is None or lengths is None:
        return ""
    factor, what = ((lengths.second, "<l^2>") if result.hypothesis is Hypothesis.KINEMATIC
                    else (1 / lengths.inverse_second, "1/<l^-2>"))
    return (f"D10 {sizes.D10 * 1e3:.4g}  D50 {sizes.D50 * 1e3:.4g}  D60 {sizes.D60 * 1e3:.4g} mm, "
            f"C_u {sizes.uniformity:.4g}  C_c {sizes.curvature:.4g}; the sphere of mean volume has the diameter "
            f"{lengths.equal_volume_diameter * 1e3:.4g} mm, and {what} is {factor:.5g} times its square (1 for equal "
            "grains; far from 1 it is not to be trusted, see the book)")


def _axis(decided: Plan) -> str:
    """The axis, where it is not axis 3."""
    if decided.axis is None:
        return "none: fabric and stress share no axis"
    return "" if decided.of_each_component else f"n = {shown_direction(decided.axis)}, turned to axis 3 and back"


def _spin(result: Evaluation) -> str:
    free = result.shear_with_free_spin
    if not result.plan.of_each_component:
        return ""
    if free is None:
        return "each grain spins until it carries no net couple" if result.plan.fabric.free_spin else ""
    return ("grains turn with the mean deformation; if each spun until it carried no net couple, "
            f"C2323 would be {pressure(free)}")


def _effects(decided: Plan) -> dict[str, str]:
    def listed(reasons: Mapping[str, str]) -> str:
        return "\n".join(f"{name}: {reason}" for name, reason in reasons.items())

    spent = decided.selection.spent
    return {"simulated": listed(decided.called_for) or "no effect: this is the ideal assembly",
            "left out": listed({name: decided.effects_not_called_for[name] for name in spent}),
            "not called for": listed({name: reason for name, reason in decided.effects_not_called_for.items()
                                      if name not in spent})}
