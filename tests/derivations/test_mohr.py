"""Sliding on Mohr's circle: held against the plain Coulomb test direction by direction."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from derivations import mohr, slip_maps
from derivations.symbols import a, c, kappa, mu

SCENES = [(1, 4, "3/4"), (4, 1, "3/4"), (1, 4, "1/2"), (3, 1, "1/4"), (1, 2, "1/2"), ("6/7", "9/7", "1/5")]
"""a, c, mu: the first two are exactly at the onset."""


def numbers(scene: tuple[object, object, object]) -> tuple[sp.Rational, sp.Rational, sp.Rational]:
    """Return the scene in exact fractions."""
    first, second, third = (sp.Rational(str(part)) for part in scene)
    return first, second, third


def sticks(scene: tuple[object, object, object], beta: mpmath.mpf) -> bool:
    """Coulomb's test in one direction, from the forces alone."""
    equator, pole, friction = (mpmath.mpf(part.p) / part.q for part in numbers(scene))
    sine, cosine = mpmath.sin(beta), mpmath.cos(beta)
    return bool(abs(pole - equator) * sine * cosine < friction * (equator * sine**2 + pole * cosine**2))


@pytest.mark.parametrize("scene", SCENES)
def test_sliding_range_is_where_coulomb_says(scene: tuple[object, object, object]) -> None:
    """A wrong kappa, centre or width of the range puts a direction on the wrong side."""
    equator, pole, friction = numbers(scene)
    share = mohr.KAPPA.subs({a: equator, c: pole, mu: friction})
    width = mpmath.acosh(mpmath.mpf(sp.N(share, 30))) if share > 1 else mpmath.mpf(0)
    center = mpmath.sqrt(mpmath.mpf(pole.p * equator.q) / (pole.q * equator.p))
    for step in range(1, 90):
        beta = mpmath.pi * step / 180 + mpmath.mpf(1) / 1000
        sigma = mpmath.log(mpmath.tan(beta) / center)
        assert sticks(scene, beta) == bool(abs(sigma) > width)


@pytest.mark.parametrize("scene", SCENES[:2])
def test_onset_is_exact(scene: tuple[object, object, object]) -> None:
    """At the onset kappa is one and the circle touches: any rounding of the condition would show."""
    equator, pole, friction = numbers(scene)
    at = {a: equator, c: pole, mu: friction}
    record = mohr.mohr_circle()
    assert record.output("kappa").expression.subs(at) == 1
    assert record.output("h0").expression.subs(at) == 0
    sine = friction / sp.sqrt(1 + friction**2)
    assert sp.simplify(pole / equator - (1 + sine) / (1 - sine) if pole > equator
                       else pole / equator - (1 - sine) / (1 + sine)) == 0


@pytest.mark.parametrize("scene", SCENES)
def test_least_value_by_search(scene: tuple[object, object, object]) -> None:
    """The least value m - R must be found over the quarter circle, at 45 deg +- phi/2."""
    at = dict(zip((a, c, mu), numbers(scene), strict=True))
    equator, pole, friction = (mpmath.mpf(part.p) / part.q for part in numbers(scene))
    nearest = mpmath.pi / 4 + (1 if pole > equator else -1) * mpmath.atan(friction) / 2

    def value(beta: mpmath.mpf) -> mpmath.mpf:
        sine, cosine = mpmath.sin(beta), mpmath.cos(beta)
        return equator * sine**2 + pole * cosine**2 - abs(pole - equator) * sine * cosine / friction

    least = mpmath.mpf(sp.N((mohr.CENTER - mohr.AMPLITUDE).subs(at), 20))
    assert abs(value(nearest) - least) < 1e-14
    assert all(value(nearest + shift) > least for shift in (-0.1, -1e-4, 1e-4, 0.1))


@pytest.mark.parametrize("share", [sp.Rational(1, 10), sp.Rational(99, 100), sp.Integer(1)])
def test_sticking_map_keeps_the_margin_positive(share: sp.Rational) -> None:
    """The margin from the mapped variable must be the plain one, cosh(sigma) - kappa, without its cancellation."""
    scale = sp.sqrt((1 - share) / 2)
    for number in (sp.Rational(-3, 2), sp.Integer(0), sp.Rational(1, 3)):
        half_sine = scale * sp.sinh(number)
        sigma = 2 * sp.asinh(half_sine)
        mapped = 2 * scale**2 * sp.cosh(number) ** 2
        assert abs(sp.N(sp.cosh(sigma) - share - mapped, 40)) < sp.Float("1e-35", 40)


@pytest.mark.parametrize("w", [-9, -1, 0, 2])
def test_map_beside_the_range_starts_at_its_edge(w: int) -> None:
    """The margin must vanish at the edge like P and be the plain one elsewhere."""
    rho = sp.Rational(2, 3)
    share = 1 + 2 * rho**2
    P = slip_maps.BESIDE.subs(slip_maps.w, w)
    sigma = 2 * sp.asinh(rho * (1 + P))
    assert abs(sp.N(sp.cosh(sigma) - share - 2 * rho**2 * P * (2 + P), 40)) < sp.Float("1e-35", 40)
    assert sp.N(sigma - sp.acosh(share)) > 0


@pytest.mark.parametrize(("reach_squared", "inside"), [(sp.Integer(1), True), (sp.Integer(2), False)])
def test_reach_of_the_sliding_map(reach_squared: sp.Integer, inside: bool) -> None:
    """With R1^2 = 1 at rho = 1 the zero of the normal force lies inside the strip, as the condition says."""
    rho_squared = sp.Integer(1)
    zero = sp.asin(sp.sqrt(reach_squared / (1 + 2 * rho_squared)))  # sinh(u) = i sin(zero)
    assert bool(zero < sp.pi / 4) == inside
    assert bool(reach_squared < rho_squared + sp.Rational(1, 2)) == inside


def test_opening_limit_by_coulomb() -> None:
    """Beyond sigma_1 contacts stick, before it they slide, before zero they have opened."""
    equator, pole, friction = sp.Integer(3), sp.Rational(-1, 2), sp.Rational(1, 4)
    share = sp.Abs(pole - equator) / (2 * friction * sp.sqrt(equator * -pole))
    limit = mpmath.mpf(sp.N(sp.asinh(share), 20))
    center = mpmath.sqrt(mpmath.mpf(1) / 6)
    for sigma, force, sticking in ((-0.5, False, False), (0.5, True, False), (limit - 1e-6, True, False),
                                   (limit + 1e-6, True, True), (limit + 3, True, True)):
        beta = mpmath.atan(center * mpmath.exp(sigma))
        normal = 3 * mpmath.sin(beta) ** 2 - mpmath.cos(beta) ** 2 / 2
        assert bool(normal > 0) == force
        assert sticks((equator, pole, friction), beta) == sticking


def test_kappa_is_declared_once() -> None:
    """Two symbols for the height of the bell would let the maps speak of another one."""
    assert mohr.mohr_circle().output("kappa").symbol == kappa


@pytest.mark.parametrize("place", [sp.Rational(-5, 2), sp.Rational(1, 3)])
@pytest.mark.parametrize("name", ["sticking_node", "beside_node", "between_node"])
def test_emitted_nodes_are_the_maps_that_are_proved(name: str, place: sp.Rational) -> None:
    """A node that drifts from its map has another exp(|sigma|), d(sigma)/d(variable) or margin than the plain ones."""
    share, scale = sp.Rational(1, 3), sp.Rational(3, 4)
    variable = slip_maps.w if name == "beside_node" else slip_maps.u
    half_sine = {
        "sticking_node": sp.sqrt((1 - share) / 2) * sp.sinh(variable),
        "beside_node": scale * (1 + slip_maps.BESIDE),
        "between_node": scale * sp.sinh(variable) / sp.sqrt(4 + sp.sinh(variable) ** 2),
    }[name]
    beside, slope = (e.subs(variable, place) for e in (slip_maps.BESIDE, sp.diff(slip_maps.BESIDE, slip_maps.w)))
    arguments = {
        "sticking_node": (sp.sinh(place), sp.cosh(place), sp.sqrt((1 - share) / 2), 1 - share, share),
        "beside_node": (beside, slope, scale),
        "between_node": (sp.sinh(place), sp.cosh(place), scale, sp.Integer(2)),
    }[name]
    function = next(one for one in mohr.mohr_circle().functions if one.name == name)
    at = dict(zip(function.arguments, arguments, strict=True))
    found = [expression.subs(at) for expression in function.substituted().values()]
    sigma = 2 * sp.asinh(half_sine)
    edge = 2 * sp.asinh(scale) if name == "beside_node" else 0
    expected = [sp.exp(sp.Abs(sigma.subs(variable, place)) - edge), sp.diff(sigma, variable).subs(variable, place)]
    if len(found) > 2:
        kappa_here = 1 + 2 * scale**2 if name == "beside_node" else share
        chi = sp.cbrt(1 - kappa_here / sp.cosh(sigma.subs(variable, place)))
        expected += [chi, 1 - chi]
    for one, other in zip(found, expected, strict=True):
        assert abs(sp.N(one - other, 30, maxn=300)) < sp.Float("1e-25", 30) * (1 + abs(sp.N(other, 30)))
