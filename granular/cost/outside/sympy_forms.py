"""SymPy on the closed form: ``evalf`` to so many digits, and ``lambdify`` into doubles.

The emitted functions are called on symbols; the moments that floats take from a series are written as the
hypergeometric functions that they are. Expressions are built once and kept; what is timed is their evaluation.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from granular.cost.outside.arithmetic import library, rational
from granular.cost.outside.route import OutsideRoute
from granular.cost.records import NotServed, Outcome
from granular.cost.scenes import CostScene
from granular.hypothesis import Hypothesis

DIGITS = {f"{digits} digits": digits for digits in (15, 30, 50)}
NAMES = ("D33", "Dr33", "nu", "a", "c", "r")


def _evalf(scene: CostScene, digits: int) -> Outcome:
    sympy = library("sympy")
    kind = _kind(scene)
    moments, components = _form(*kind), _components(kind[0], kind[2])
    values = {name: sympy.Rational(value.numerator, value.denominator) for name, value in _values(scene).items()}
    subs = {sympy.Symbol(name): value for name, value in values.items()}
    known = [moment.evalf(digits, subs=subs) for moment in moments]
    return Outcome([rational(component.evalf(digits)) for component in components(known, values)])


def _lambdified(scene: CostScene, _setting: None) -> Outcome:
    function = _function(*_kind(scene))
    return Outcome([float(component) for component in function(*map(float, _values(scene).values()))])


def _kind(scene: CostScene) -> tuple[bool, bool, bool]:
    """Static, with forces, spheroids; or the reason why there is no closed form."""
    static, forces = scene.hypothesis is Hypothesis.STATIC, scene.loading is not None
    spheroid = scene.fabric.aspect_ratio != 1.0
    if scene.spread is not None:
        raise NotServed("the moments of eq. (17) have no closed form")
    if scene.loading is not None and scene.loading.slips(scene.fabric.D33):
        raise NotServed("SymPy is given no closed form with slip")
    if static and forces and scene.fabric.Dr33 != 0:
        raise NotServed("two different powers under the integral: no hypergeometric function of one variable")
    if spheroid and (static or forces):
        raise NotServed("SymPy is given no closed form of these spheroids")
    return static, forces, spheroid


def _values(scene: CostScene) -> dict[str, Fraction]:
    a, c = (Fraction(1), Fraction(1)) if scene.loading is None else scene.loading.coefficients(scene.fabric.D33)
    numbers = (scene.fabric.D33, scene.fabric.Dr33, scene.poisson_ratio)
    return dict(zip(NAMES, (*map(Fraction, numbers), a, c, Fraction(scene.fabric.aspect_ratio)), strict=True))


@lru_cache
def _form(static: bool, forces: bool, spheroid: bool) -> tuple[Any, ...]:
    """The three moments as expressions; none where the components themselves are rational."""
    sympy = library("sympy")
    D33, Dr33, _, a, c, r = sympy.symbols(NAMES)
    x2 = sympy.Symbol("x2")
    third, half = sympy.Rational(1, 3), sympy.Rational(1, 2)
    length, weight = 1 + Dr33 * (3 * x2 - 1) / 2, 1 + D33 * (3 * x2 - 1) / 2
    if spheroid:
        scale, slope, power = sympy.Integer(1), r**2 - 1, sympy.Integer(-1)
    elif forces:
        slope, power = (c - a) / a, -third if static else third
        scale = a**power
        weight *= 1 if static else length**2
    elif static:
        scale, slope, power = (1 - Dr33 / 2) ** -2, 3 * Dr33 / (2 - Dr33), sympy.Integer(-2)
    else:
        return ()

    def moment(k: int) -> Any:
        """Mean of weight times scale (1 + slope x^2)^power with the k-th product of s and x^2."""
        polynomial = sympy.Poly(sympy.expand(weight * (1 - x2) ** (2 - k) * x2**k), x2)
        return scale * sum(
            coefficient * sympy.hyper((-power, j + half), (j + 3 * half,), -slope) / (2 * j + 1)
            for (j,), coefficient in polynomial.terms())

    return tuple(moment(k) for k in range(3))


def _components(static: bool, spheroid: bool) -> Callable[[Sequence[Any], Mapping[str, Any]], Any]:
    """The emitted functions on whatever numbers or symbols."""
    from granular.generated import kinematic_constant, static_constant
    from granular.generated import spheroid as spheroids

    def components(moments: Sequence[Any], values: Mapping[str, Any]) -> Any:
        D33, Dr33, nu, _, _, r = values.values()
        if not moments:
            return kinematic_constant.kinematic_constant(D33, 0 * D33, Dr33, nu)
        p0, p1, p2 = moments
        if spheroid:
            size = r ** (-2 * (r / r) / 3)  # an exact power for exact numbers
            return [size * one for one in spheroids.stiffness_from_moments(p0, p1, p2, r**2, nu)]
        if static:
            return static_constant.stiffness_from_moments(p0, p1, p2, D33, nu)
        return kinematic_constant.stiffness_from_moments(p0, p1, p2, nu)

    return components


@lru_cache
def _function(static: bool, forces: bool, spheroid: bool) -> Any:
    """Six components as a function of doubles, with SciPy's hypergeometric function."""
    from scipy.special import hyp2f1

    sympy = library("sympy")
    gauss, symbols = sympy.Function("hyp2f1"), sympy.symbols(NAMES)
    moments = [moment.replace(sympy.hyper, lambda upper, lower, z: gauss(*upper, *lower, z))
               for moment in _form(static, forces, spheroid)]
    form = _components(static, spheroid)(moments, dict(zip(NAMES, symbols, strict=True)))
    return sympy.lambdify(symbols, list(form), modules=[{"hyp2f1": hyp2f1}, "math"], cse=True)


EVALF = OutsideRoute(name="sympy_evalf", title="SymPy evalf of the closed form", settings=DIGITS, run=_evalf)
LAMBDIFY = OutsideRoute(name="sympy_lambdify", title="SymPy lambdify of the closed form", settings={"floats": None},
                        run=_lambdified)
