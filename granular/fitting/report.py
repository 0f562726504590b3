"""A fit as text for people and as JSON for programs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from granular.fitting.data import SCALES

if TYPE_CHECKING:
    from rich.console import RenderableType

    from granular.fitting.result import Combination, Estimate, Fit

SCALE_IN_WORDS = dict(zip(SCALES, (
    "a factor of compression and one of shear in each state: only the anisotropy of the data counts",
    "a factor of compression and one of shear for all states: how both grow with stress counts, too",
    "one factor in each state: ratios within a state count, those of shear to compression too",
    "one factor for all states: how the stiffness grows with stress counts, too",
    "none: the stiffness of the model is taken as it is"), strict=True))
"""What each choice of scale lets the data say."""

SUSPICIOUS = 0.01
"""Below this p-value it is said that the model does not describe the data [-]."""


def fit_as_json(result: Fit) -> dict[str, Any]:
    """The object that ``granular fit --json`` prints.

    Parameters
    ----------
    result : Fit
        A fitted fabric.

    Returns
    -------
    dict
        Plain numbers, strings, lists and dicts; None for what is not finite.

    Notes
    -----
    Source: the command line's interface.
    """
    names = [one.name for one in (*result.estimates, *result.factors)]
    return {
        "estimates": {one.name: _estimate(one) for one in result.estimates},
        "factors": {one.name: {"value": one.value, "standard_error": _finite(one.standard_error)}
                    for one in result.factors},
        "scale": result.problem.data.scale,
        "chi_square": result.chi_square, "degrees_of_freedom": result.degrees_of_freedom, "p_value": result.p_value,
        "covariance": {"names": names, "matrix": _matrix(result.covariance)},
        "correlation": {"names": names, "matrix": _matrix(result.correlation)},
        "combinations": [{"coefficients": dict(zip(result.problem.unknowns, one.coefficients, strict=True)),
                          "value": one.value, "standard_error": _finite(one.standard_error),
                          "singular_value": one.singular_value} for one in result.combinations],
        "residuals": [{"name": one.name, "state": one.state, "measured": one.measured, "fitted": one.fitted,
                       "uncertainty": one.uncertainty, "sigmas": one.sigmas} for one in result.residuals],
        "other_minima": list(result.others),
    }


def _estimate(one: Estimate) -> dict[str, Any]:
    return {"value": one.value, "standard_error": _finite(one.standard_error), "at_bound": one.at_bound,
            "intervals": [{"level": each.level, "low": each.low, "high": each.high, "low_open": each.low_open,
                           "high_open": each.high_open} for each in one.intervals]}


def _matrix(matrix: Any) -> list[list[float | None]]:
    return [[_finite(value) for value in row] for row in matrix.tolist()]


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def fit_as_text(result: Fit) -> list[RenderableType]:
    """What ``granular fit`` shows, for a console of any width.

    Parameters
    ----------
    result : Fit
        A fitted fabric.

    Returns
    -------
    list of renderable
        Blocks for ``rich.console.Console.print``, in order.

    Notes
    -----
    Source: the command line's interface.
    """
    from rich.text import Text

    data = result.problem.data
    states = len(data.scenes)
    head = (f"Fit of {', '.join(data.unknowns)} to {len(data.measurements)} measurements in {states} "
            f"{'state' if states == 1 else 'states'} of stress")
    factors = [Text(f"  {one.name}: {_with_error(one.value, one.standard_error)}") for one in result.factors]
    return [
        _title(head), _estimates(result),
        *(Text(f"  {line}") for line in remarks(result)), "",
        _title("What the data see"),
        *(Text(f"  {_combination(one, result)}") for one in result.combinations), "",
        _title("Factors, sample over model"), Text(f"  {SCALE_IN_WORDS[data.scale]}"), *factors, "",
        _title("Measurements"), _residuals(result)]


def remarks(result: Fit) -> list[str]:
    """Say how well the model describes the data, and what else a reader has to know.

    Parameters
    ----------
    result : Fit
        A fitted fabric.

    Returns
    -------
    list of str
        Sentences.

    Notes
    -----
    Source: the result.
    """
    if result.p_value is None:
        lines = [f"chi-square {result.chi_square:.3g} without a degree of freedom: the data cannot contradict the "
                 "model."]
    else:
        verdict = ("; the model does not describe these data within their uncertainties"
                   if result.p_value < SUSPICIOUS else "")
        lines = [f"chi-square {result.chi_square:.3g} with {result.degrees_of_freedom} degrees of freedom, p = "
                 f"{result.p_value:.3g}{verdict}."]
    lines += [f"{one.name} ends at the bound of the search: the data ask for more than the model allows."
              for one in result.estimates if one.at_bound]
    lines += [f"The {100 * each.level:.0f} % interval of {one.name} is open {_open(each.low_open, each.high_open)}: "
              "the data do not end it." for one in result.estimates for each in one.intervals[-1:]
              if each.low_open or each.high_open]
    for other in result.others:
        where = ", ".join(f"{name} = {other[name]:.3g}" for name in result.problem.unknowns)
        lines.append(f"Another minimum, chi-square {other['chi_square']:.3g}: {where}.")
    return lines


def _open(low: bool, high: bool) -> str:
    return "on both sides" if low and high else "downwards" if low else "upwards"


def _estimates(result: Fit) -> RenderableType:
    from rich.padding import Padding
    from rich.table import Table

    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column("unknown")
    table.add_column("estimate", justify="right")
    table.add_column("std. error", justify="right")
    for each in result.estimates[0].intervals:
        table.add_column(f"{100 * each.level:.0f} % interval", justify="right")
    for one in result.estimates:
        table.add_row(one.name, f"{one.value:+.4f}", f"{one.standard_error:.2g}",
                      *(f"{each.low:+.3f} to {each.high:+.3f}" for each in one.intervals))
    return Padding(table, (0, 0, 0, 2))


def _combination(one: Combination, result: Fit) -> str:
    terms = " ".join(f"{'-' if factor < 0 else '+'} {'' if factor == 1 else f'{abs(factor):.3g} '}{name}"
                     for factor, name in zip(one.coefficients, result.problem.unknowns, strict=True))
    return f"{terms.removeprefix('+ ')} = {_with_error(one.value, one.standard_error)}"


def _with_error(value: float, error: float) -> str:
    if not math.isfinite(error):
        return f"{value:.4g}, which nothing says"
    return f"{value:.4g} +- {error:.2g}"


def _residuals(result: Fit) -> RenderableType:
    from rich.padding import Padding
    from rich.table import Table

    several = len(result.problem.data.scenes) > 1
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    for name in (*(("state",) if several else ()), "quantity", "measured", "+-", "fitted", "sigmas"):
        table.add_column(name, justify="left" if name in ("state", "quantity") else "right")
    for one in result.residuals:
        table.add_row(*((one.state,) if several else ()), one.name, f"{one.measured:.5g}", f"{one.uncertainty:.2g}",
                      f"{one.fitted:.5g}", f"{one.sigmas:+.2f}")
    return Padding(table, (0, 0, 0, 2))


def _title(text: str) -> RenderableType:
    from rich.text import Text

    return Text(text, style="bold")
