"""How fast the one rule for all contacts converges: its error against the density of equidistant nodes."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from granular.fabric import AxialFabric
from granular.figures.look import BLUE, GREEN, SOFT_INK, VERMILION, blank, house_style
from granular.figures.page import Static
from granular.generated import mohr_circle
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified
from granular.routes.log_tangent import TANGENT
from granular.routes.log_tangent_tables import STEPS
from granular.routes.slip_geometry import Sliding, Sticking, slip_geometry
from page_tools.averages import components
from page_tools.markup import Markup, numbers_to_take_away

POISSON_RATIO, FABRIC = 0.21, AxialFabric()
STATES = {"every contact sticks": Loading.of_ratio(3, friction=0.75),
          "at the onset": Loading.of_ratio(4, friction=0.75),
          "some contacts slide": Loading.of_ratio(6, friction=0.75)}
"""Three stresses on an isotropic packing; with mu = 3/4 the second is exactly at the onset of sliding."""

COLOURS = dict(zip(STATES, (BLUE, GREEN, VERMILION), strict=True))
NODES = tuple(range(2, STEPS + 1))
"""Nodes for each unit of the mapped variable; the library takes the last, and lets them hurry off in the tails."""

FARTHEST, NEAREST = 50.0, 24.0
"""Ends of the mapped lines, beyond which less than rounding is left."""

LEAST = 1e-17
"""Errors below this are drawn at the lower edge."""


def predicted(nodes: int) -> float:
    """Return exp(-2 pi (pi/4)/step), the error of the trapezoidal rule in a strip of half width pi/4."""
    return math.exp(-2 * math.pi * (math.pi / 4) * nodes)


def errors(loading: Loading) -> list[float]:
    """Worst relative error of six components for each density of nodes, against certified values."""
    known = certified.evaluate(FABRIC, poisson_ratio=POISSON_RATIO, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    found = []
    for nodes in NODES:
        six = _components(loading, nodes)
        found.append(max(abs(value / true - 1) for value, true in zip(six, known.components, strict=True)))
    return found


@house_style
def convergence_figure() -> Static:
    """Draw the error of the rule against the density of its nodes, with the predicted slope."""
    figure = blank(height=3.4)
    axes = figure.add_subplot()
    for (name, loading), marker in zip(STATES.items(), "osD", strict=True):
        axes.semilogy(NODES, [max(error, LEAST) for error in errors(loading)], marker=marker, markersize=5,
                      linewidth=1.0, color=COLOURS[name], label=name)
    shown = [nodes for nodes in NODES if predicted(nodes) > LEAST]
    axes.semilogy(shown, [predicted(nodes) for nodes in shown], color=SOFT_INK, linestyle="--", linewidth=1.0,
                  label=r"$\exp(-\pi^2/(2\,\mathrm{step}))$")
    axes.set(xlabel="nodes for each unit of the mapped variable, 1/step", ylabel="relative error [–]", ylim=(LEAST, 1),
             xticks=NODES)
    axes.legend(frameon=False, loc="upper right")
    return Static(figure)


def convergence_numbers() -> Markup:
    """Offer the numbers behind the figure."""
    columns = {"nodes per unit": NODES, "predicted": [predicted(nodes) for nodes in NODES]}
    columns |= {name: errors(loading) for name, loading in STATES.items()}
    return numbers_to_take_away("convergence.csv", columns, digits=3)


def _components(loading: Loading, nodes: int) -> tuple[float, ...]:
    """Six components from equidistant nodes of the three maps."""
    a, c = loading.coefficients(FABRIC.D33)
    assert loading.friction is not None, "the states have friction"
    t, measure, chi, gamma = np.array(list(_rows(slip_geometry(a, c, loading.friction), nodes))).T
    directions = np.array([_direction(tangent) for tangent in t])
    s, y = directions.T
    return components(FABRIC, POISSON_RATIO, directions=directions, measure=measure * s * np.sqrt(y),
                      normal=np.cbrt(float(a) * s + float(c) * y), chi=chi, gamma=gamma)


def _rows(geometry: Sticking | Sliding, nodes: int) -> Iterator[tuple[float, float, float, float]]:
    """Yield tan(beta), d(log tan(beta)), chi and 1 - chi at the nodes."""
    if isinstance(geometry, Sticking):
        scale = max(math.sqrt(geometry.delta / 2), TANGENT)
        for u in _equidistant(-FARTHEST, FARTHEST, nodes):
            growth, rate, chi, gamma = mohr_circle.sticking_node(
                math.sinh(u), math.cosh(u), scale, geometry.delta, geometry.kappa)
            yield geometry.center * growth ** math.copysign(1, u), rate / nodes, chi, gamma
        return
    assert geometry.pole is not None and geometry.equator is not None, "contacts stick at pole and equator"
    for w in _equidistant(-NEAREST, FARTHEST, nodes):
        grown = math.exp(w)
        p = grown * grown / (2 * (1 + grown))
        growth, rate, chi, gamma = mohr_circle.beside_node(p, p * (2 + grown) / (1 + grown), geometry.rho)
        yield geometry.equator * growth, rate / nodes, chi, gamma
        yield geometry.pole / growth, rate / nodes, chi, gamma
    center, half = math.sqrt(geometry.pole * geometry.equator), math.log(geometry.equator / geometry.pole) / 4
    for u in _equidistant(-NEAREST, NEAREST, nodes):
        growth, rate = mohr_circle.between_node(math.sinh(u), math.cosh(u), math.sinh(half), math.cosh(half))
        yield center * growth ** math.copysign(1, u), rate / nodes, 0.0, 1.0


def _equidistant(first: float, last: float, nodes: int) -> Iterator[float]:
    yield from ((j + 0.5) / nodes for j in range(math.floor(first * nodes), math.ceil(last * nodes)))


def _direction(t: float) -> tuple[float, float]:
    """Squared sine and cosine of the angle with the tangent t."""
    return (t * t / (1 + t * t), 1 / (1 + t * t)) if t <= 1 else (1 / (1 + t**-2), t**-2 / (1 + t**-2))
