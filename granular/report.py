"""Results as text for people and as JSON for programs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from granular.explanation import EffectTable, arithmetic, effect_lines, error_budget, explained
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import PER_CUBIC_METRE, PER_DIAMETER_CUBED

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.evaluation import Evaluation
    from granular.planning import Plan
    from granular.ratios import Ratio
    from granular.routes.work import Work
    from granular.waves import PhaseVelocities, Waves

BOUND = {Hypothesis.KINEMATIC: "uniform strain, an upper bound", Hypothesis.STATIC: "uniform stress, a lower estimate"}
"""What each hypothesis means for the result."""

CONTACTS = {PER_DIAMETER_CUBED: "per (2 r_e)^3, the cube of one grain diameter", PER_CUBIC_METRE: "per m^3"}
"""The unit of the number of contacts in words."""

MEANING = {
    "C1111": "horizontal compression", "C3333": "vertical compression",
    "C1122": "horizontal with horizontal", "C1133": "vertical with horizontal",
    "C2323": "vertical shear", "C1212": "horizontal shear",
}
"""The six components in words; axis 3 is vertical."""

_PREFIXES = ((1e10, 1e9, "GPa"), (1e6, 1e6, "MPa"), (1e3, 1e3, "kPa"))
_LONGEST_FRACTION = 48
_INDENT = (0, 0, 0, 2)


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
    content: dict[str, Any] = {
        "stiffness": {**result.stiffness.components, "mandel": [list(row) for row in result.stiffness.rows]},
        "relative_error": _finite(result.relative_error),
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
    if (waves := result.waves) is not None:
        content["waves"] = _waves_as_json(waves)
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


def _bound(bound: float) -> str:
    return "none is promised by this route" if math.isinf(bound) else f"{bound:.2g} of each component"


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
        "relative_error": _finite(decided.relative_error),
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
    from rich.text import Text

    blocks: list[RenderableType] = [
        _title(f"Stiffness by the {result.hypothesis} hypothesis ({BOUND[result.hypothesis]})"),
        _components(result), "",
        *(Text(f"  {_ratio(ratio)}", overflow="fold") for ratio in result.ratios), "",
        _title("Engineering constants"), _engineering(result), "",
    ]
    if (waves := result.waves) is not None:
        blocks += [_title(f"Waves in the dry assembly, {waves.density:.6g} kg/m^3"), _wave_table(waves), ""]
    blocks += [_title("How it was computed"), _facts({
        "error bound": _bound(result.relative_error),
        **(explained(result) if explain else
           {"route": f"{result.route} ({result.evaluations} evaluations of the integrand)"}),
        "unit": f"(M/V) l_e^2 k_n,ref = {_pressure(result.reference_stiffness)}",
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
    return [_title("What run would do"), _facts({
        "hypothesis": f"{decided.hypothesis} ({BOUND[decided.hypothesis]})",
        "route": f"{decided.route}: {decided.route_reason}",
        "cost": f"{decided.evaluations} evaluations of the integrand; {arithmetic(decided.work)}",
        "error bound": _bound(decided.relative_error)
                       + ("" if decided.rtol is None else f", wanted {decided.rtol:.2g}"),
        "error budget": error_budget(decided.route_error, decided.scaling_error, decided.left_out_error),
    }), *_effect_table(decided)]


def _effect_table(decided: Plan) -> list[RenderableType]:
    return ["", _title("Effects, and how much each component would change at most without them"),
            EffectTable(effect_lines(decided))]


def _title(text: str) -> RenderableType:
    from rich.text import Text

    return Text(text, style="bold")


def _components(result: Evaluation) -> RenderableType:
    six = result.stiffness.components
    size, unit = _unit(max(six.values()))
    numbers = _aligned(f"{value / size:.7g}" for value in six.values())
    return _grid((name, number, unit, MEANING[name]) for name, number in zip(six, numbers, strict=True))


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
    size, unit = _unit(max(constants.E1, constants.E3))
    moduli = {"E1": constants.E1, "E3": constants.E3, "K": constants.K, "G12": constants.G12, "G23": constants.G23}
    ratios = {"nu12": constants.nu12, "nu13": constants.nu13, "nu31": constants.nu31}
    return _lines(
        "  ".join(f"{name} {value / size:.5g}" for name, value in moduli.items()) + f"  {unit}",
        "  ".join(f"{name} {value:.5g}" for name, value in ratios.items()))


def _wave_table(waves: Waves) -> RenderableType:
    def row(name: str, of: PhaseVelocities) -> str:
        return f"{name:<11}P {of.P:.5g}  SV {of.SV:.5g}  SH {of.SH:.5g}  m/s"

    thomsen = waves.thomsen
    delta = "has no value" if thomsen.delta is None else f"{thomsen.delta:.5g}"
    return _lines(
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


def _spin(result: Evaluation) -> str:
    free = result.shear_with_free_spin
    if free is None:
        return "each grain spins until it carries no net couple" if result.plan.fabric.free_spin else ""
    return ("grains turn with the mean deformation; if each spun until it carried no net couple, "
            f"C2323 would be {_pressure(free)}")


def _effects(decided: Plan) -> dict[str, str]:
    def listed(reasons: Mapping[str, str]) -> str:
        return "\n".join(f"{name}: {reason}" for name, reason in reasons.items())

    spent = decided.selection.spent
    return {"simulated": listed(decided.called_for) or "no effect: this is the ideal assembly",
            "left out": listed({name: decided.effects_not_called_for[name] for name in spent}),
            "not called for": listed({name: reason for name, reason in decided.effects_not_called_for.items()
                                      if name not in spent})}


def _pressure(value: float) -> str:
    size, unit = _unit(value)
    return f"{value / size:.7g} {unit}"


def _unit(largest: float) -> tuple[float, str]:
    """A unit in which the largest value is easy to read."""
    for least, size, unit in _PREFIXES:
        if least <= largest < 1e16:
            return size, unit
    return 1.0, "Pa"


def _aligned(numbers: Iterable[str]) -> list[str]:
    """Pad so that decimal points stand below each other."""
    parts = [number.partition(".") for number in numbers]
    left = max(len(whole) for whole, _, _ in parts)
    right = max(len(rest) for _, _, rest in parts)
    return [f"{whole:>{left}}{point or ' '}{rest:<{right}}" for whole, point, rest in parts]


def _lines(*lines: str) -> RenderableType:
    from rich.padding import Padding
    from rich.text import Text

    return Padding(Text("\n".join(lines)), _INDENT)


def _grid(rows: Iterable[tuple[str, ...]]) -> RenderableType:
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    grid = Table.grid(padding=(0, 2, 0, 0))
    for row in rows:
        grid.add_row(*(Text(cell) for cell in row))
    return Padding(grid, _INDENT)


def _facts(facts: Mapping[str, str]) -> RenderableType:
    return _grid((name, text) for name, text in facts.items() if text)
