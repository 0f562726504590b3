"""Aligned spheroids: closed forms against quadrature, series against arc tangents, limits, stored ratios."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from derivations.emit.scalar import scalar_module
from derivations.fabric import DENSITY
from derivations.kinetic_components import functions as collinear_functions
from derivations.spheroid import functions, spheroid
from derivations.spheroid_components import constant_components, positive_components, unsymmetrised
from derivations.spheroid_limits import NEEDLE, PLATE, plate_moment, seven_components
from derivations.spheroid_moments import ELEMENTARY, FABRIC, by_recurrence, elementary_moments, series
from derivations.symbols import (
    D33,
    D3333,
    N11,
    N33,
    POSITIVE_MOMENTS,
    TANGENTIAL_MOMENTS,
    aspect_ratio,
    d0,
    d1,
    e0,
    e1,
    e2,
    lam,
    one_minus_lam,
    p2,
    varrho,
    x,
)

mp = mpmath.mp.clone()
mp.dps = 40

NU = sp.Rational(21, 100)
LAM = sp.Rational(158, 179)
ULP = 2.0**-52

ASPECTS = (sp.Rational(1, 3), sp.Rational(7, 10), 1 - sp.Rational(1, 10**8), sp.Integer(1), 1 + sp.Rational(1, 10**8),
           sp.Rational(3, 2), sp.Integer(3))
FABRICS = ((0, 0), (sp.Rational(3, 10), 0), (-1, 0), (2, 0), (sp.Rational(1, 2), sp.Rational(-1, 5)))


def number(expression: Any) -> Any:
    """A SymPy number in 40 digits."""
    return mp.mpf(str(sp.N(expression, 45)))


@cache
def quadrature(aspect: sp.Rational, fabric: tuple[Any, Any]) -> tuple[Any, ...]:
    """Moments <E s^2/Q>, <E s y/Q>, <E y^2/Q> by numerical integration."""
    density = sp.Poly(DENSITY.subs(dict(zip((D33, D3333), fabric, strict=True))), x)
    coefficients = [number(c) for c in density.all_coeffs()]
    squared = number(aspect) ** 2
    edge = min(mp.mpf(1) / 2, 1 / mp.sqrt(1 + squared))

    def integrand(k: int) -> Callable[[Any], Any]:
        return lambda z: (mp.polyval(coefficients, z) * (1 - z * z) ** (2 - k) * z ** (2 * k)
                          / (1 - z * z + squared * z * z))

    return tuple(mp.quad(integrand(k), [0, edge, 1 - edge * min(1, squared), 1]) for k in range(3))


@cache
def hypergeometric(aspect: sp.Rational) -> tuple[Any, ...]:
    """L_0 to L_4 by Gauss's function."""
    excess = number(aspect) ** 2 - 1
    return tuple(mp.hyp2f1(1, k + mp.mpf(1) / 2, k + mp.mpf(3) / 2, -excess) / (2 * k + 1) for k in range(5))


def closed(aspect: sp.Rational, fabric: tuple[Any, Any]) -> tuple[Any, ...]:
    """The moments by their linear forms in L_0 to L_4."""
    to_fabric = dict(zip((D33, D3333), fabric, strict=True))
    return tuple(mp.fsum(number(c.subs(FABRIC).subs(to_fabric)) * hypergeometric(aspect)[ELEMENTARY.index(one)]
                         for one, c in m.as_coefficients_dict(*ELEMENTARY).items()) for m in elementary_moments())


def components(moments: tuple[Any, ...], aspect: Any, share: sp.Expr = LAM) -> tuple[Any, ...]:
    """Six components and the one with free spin from moments in 40 digits."""
    ratio = number(share)
    values = (*moments, number(aspect) ** 2, ratio, 1 - ratio)
    run = _compiled()
    return tuple(run(*values))


@cache
def _compiled() -> Callable[..., Any]:
    return in_forty_digits((*POSITIVE_MOMENTS, varrho, lam, one_minus_lam), seven_components())


def in_forty_digits(arguments: tuple[sp.Symbol, ...], expressions: tuple[sp.Expr, ...]) -> Callable[..., Any]:
    """Expressions as a function whose fractions, too, have 40 digits."""
    run: Callable[..., Any] = sp.lambdify(arguments, expressions, [{"mpf": mp.mpf}, "mpmath"])
    return run


@cache
def emitted() -> dict[str, Callable[..., Any]]:
    """The emitted scalar functions."""
    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(spheroid()), "spheroid", "exec"), namespace)
    return namespace


@pytest.mark.parametrize("fabric", FABRICS, ids=str)
@pytest.mark.parametrize("aspect", [*ASPECTS, sp.Rational(1, 100), sp.Integer(50)], ids=str)
def test_closed_forms_are_the_integrals(aspect: sp.Rational, fabric: tuple[Any, Any]) -> None:
    """Two ways to one integral to 25 of 40 digits: a wrong coefficient of any L_k breaks this."""
    for found, wanted in zip(closed(aspect, fabric), quadrature(aspect, fabric), strict=True):
        assert abs(found / wanted - 1) < mp.mpf(10) ** -25


@pytest.mark.parametrize("aspect", [sp.Rational(1, 3), sp.Rational(7, 10), sp.Rational(3, 2), sp.Integer(3)], ids=str)
def test_recurrence_is_gauss(aspect: sp.Rational) -> None:
    """Arc tangent or hyperbolic one with the recurrence against the hypergeometric function, 30 digits."""
    excess = number(aspect) ** 2 - 1
    root = mp.sqrt(abs(excess))
    first = (mp.atan(root) if excess > 0 else mp.atanh(root)) / root
    numbers = in_forty_digits(sp.symbols("first e"), by_recurrence(*sp.symbols("first e")))(first, excess)
    for found, wanted in zip(numbers, hypergeometric(aspect), strict=True):
        assert abs(found / wanted - 1) < mp.mpf(10) ** -30


@pytest.mark.parametrize("k", range(5))
@pytest.mark.parametrize("aspect", ASPECTS, ids=str)
def test_series_are_the_closed_forms(k: int, aspect: sp.Rational) -> None:
    """Each series against L_0 to L_4, at the sphere and beside it too: what is cut must stay below 2^-57."""
    contrast = number((aspect - 1) / (aspect + 1))
    half_sum = (1 + number(aspect)) / 2
    terms = [number(c) * contrast**n for n, c in enumerate(series(k).coefficients)]
    divisor = (half_sum, half_sum, half_sum**2, half_sum**2, half_sum * number(aspect))[k]
    exact = mp.fsum((-1) ** j * mp.binomial(4 - k, j) * integral for j, integral in
                    ((j, quadrature_of_power(aspect, k + j)) for j in range(5 - k)))
    assert abs(mp.fsum(terms) / divisor / exact - 1) < mp.mpf(2) ** -57
    assert mp.fsum(map(abs, terms)) < 2 * abs(mp.fsum(terms))


@cache
def quadrature_of_power(aspect: sp.Rational, power: int) -> Any:
    """Integral of x^(2 power)/Q by numerical integration."""
    squared = number(aspect) ** 2
    return mp.quad(lambda z: z ** (2 * power) / (1 - z * z + squared * z * z), [0, mp.mpf(1) / 2, 1])


def test_series_bound_is_kept() -> None:
    """What the cut leaves out is computed, not guessed; a shorter table would break this."""
    assert all(series(k).left_out < sp.Rational(1, 2**57) for k in range(5))


@pytest.mark.parametrize("fabric", [(0.0, 0.0), (0.3, 0.0), (-1.0, 0.0), (2.0, 0.0), (0.5, -0.25)], ids=str)
@pytest.mark.parametrize("aspect", [1 / 3 + 1e-16, 0.5, 0.7, 1 - 1e-3, 1 - 1e-8, 1.0, 1 + 1e-8, 1.1, 1.5, 2.0, 3.0])
def test_floats_keep_their_digits(aspect: float, fabric: tuple[float, float]) -> None:
    """Emitted floats within 3 units in the last place for the moments, 4 for components: nothing may cancel."""
    exact = sp.Rational(*aspect.as_integer_ratio())
    wanted = closed(exact, tuple(sp.Rational(*f.as_integer_ratio()) for f in fabric))
    found = emitted()["spheroid_moments"](*fabric, aspect)
    assert max(abs(mp.mpf(f) / w - 1) for f, w in zip(found, wanted, strict=True)) <= 3 * ULP
    six = emitted()["stiffness_from_moments"](*found, aspect * aspect, 0.21)
    poisson = sp.Rational(*(0.21).as_integer_ratio())
    seven = components(wanted, exact, (2 - 2 * poisson) / (2 - poisson))
    assert max(abs(mp.mpf(f) / w - 1) for f, w in zip(six, seven[:6], strict=True)) <= 4 * ULP


# b/a; C1111/C3333 exact and errors in % of the branches (i) |l| n and (iii) 2|Mn| n; the same of C2323/C1212; free spin
# over symmetrised C2323. Isotropic density, nu = 0.21; printed digits of an independent computation by quadrature.
RATIOS = (
    ("0.3", "51.296", "-97.6", "-96.4", ".5083", "+80.2", "+52.2", ".0716"),
    ("0.5", "9.3649", "-86.1", "-83.2", ".5520", "+60.8", "+48.6", ".3401"),
    ("0.7", "3.1317", "-60.3", "-58.3", ".6587", "+37.3", "+34.2", ".7276"),
    ("0.8", "2.0380", "-42.6", "-41.6", ".7447", "+24.7", "+23.7", ".8801"),
    ("0.9", "1.3983", "-22.4", "-22.1", ".8572", "+12.1", "+12.0", ".9716"),
    ("0.95", "1.1771", "-11.5", "-11.4", ".9246", "+6.0", "+6.0", ".9932"),
    ("1.0", "1", "0", "0", "1", "0", "0", "1"),
    ("1.1", ".7394", "+24.7", "+24.9", "1.1767", "-11.4", "-11.5", ".9769"),
    ("1.5", ".2790", "+156", "+153", "2.2969", "-47.8", "-47.5", ".6749"),
    ("2.0", ".1140", "+448", "+393", "4.9059", "-73.4", "-71.8", ".3584"),
    ("3.0", ".0327", "+1794", "+1237", "15.923", "-91.8", "-89.7", ".1173"),
)


def agrees(value: Any, printed: str) -> bool:
    """Whether a number rounds to the printed digits."""
    decimals = len(printed.partition(".")[2])
    return bool(abs(value - mp.mpf(printed)) <= (mp.mpf("0.5") + mp.mpf(10) ** -6) * mp.mpf(10) ** -decimals)


def collinear(aspect: sp.Rational, length: Callable[[Any, Any], Any]) -> tuple[Any, Any]:
    """C1111/C3333 and C2323/C1212 for branches along the normals of squared length ``length(s, y)``."""
    p = [mp.quad(lambda z, k=k: length(1 - z * z, z * z) * (1 - z * z) ** (2 - k) * z ** (2 * k), [0, mp.mpf(1) / 2, 1])
         for k in range(3)]
    sphere = components(tuple(p), sp.Integer(1))
    return sphere[0] / sphere[1], sphere[4] / sphere[5]


@pytest.mark.parametrize("row", RATIOS, ids=lambda row: row[0])
def test_stored_ratios(row: tuple[str, ...]) -> None:
    """Anisotropy, the error of two collinear branches and the share of free spin, to all printed digits."""
    aspect = sp.Rational(row[0])
    squared = number(aspect) ** 2
    found = components(closed(aspect, (0, 0)), aspect)
    ratios = (found[0] / found[1], found[4] / found[5])
    true_length = collinear(aspect, lambda s, y: (s + squared**2 * y) / (s + squared * y))
    normal_part = collinear(aspect, lambda s, y: s + squared * y)
    for number_, ratio in enumerate(ratios):
        assert agrees(ratio, row[1 + 3 * number_])
        assert agrees(100 * (true_length[number_] / ratio - 1), row[2 + 3 * number_])
        assert agrees(100 * (normal_part[number_] / ratio - 1), row[3 + 3 * number_])
    assert agrees(found[6] / found[4], row[7])


def test_shears_before_symmetrisation() -> None:
    """At b/a = 2 the three vertical shears are .2125, .0152 and 1.9221: a branch index exchanged would swap them."""
    moments = dict(zip(POSITIVE_MOMENTS, closed(sp.Integer(2), (0, 0)), strict=True))
    tangential = {q: number(LAM) * p for q, p in zip(TANGENTIAL_MOMENTS, moments.values(), strict=True)}
    for component, printed in ((2323, ".2125"), (2332, ".0152"), (3232, "1.9221")):
        found = unsymmetrised(component).subs(varrho, 4).subs({**moments, **tangential})
        assert agrees(mp.mpf(str(found)), printed)


@pytest.mark.parametrize("fabric", [(0, 0), (sp.Rational(3, 10), 0), (sp.Rational(-1, 2), sp.Rational(1, 10))], ids=str)
def test_plates(fabric: tuple[Any, Any]) -> None:
    """At b/a = 1e-6 what is left out is about 1e-12 ln(1e6); a wrong constant beside the logarithm breaks this."""
    aspect = sp.Rational(1, 10**6)
    to_fabric = dict(zip((D33, D3333), fabric, strict=True))
    moments = closed(aspect, fabric)
    third = number(plate_moment().subs(FABRIC).subs(to_fabric).subs(aspect_ratio, aspect))
    assert abs(moments[2] / third - 1) < mp.mpf(10) ** -9
    for found, stated in zip(components(moments, aspect), PLATE, strict=True):
        assert abs(found / at(stated, to_fabric, aspect).subs(p2, third) - 1) < mp.mpf(10) ** -9


@pytest.mark.parametrize("fabric", [(0, 0), (sp.Rational(3, 10), 0), (sp.Rational(-1, 2), sp.Rational(1, 10))], ids=str)
def test_needles(fabric: tuple[Any, Any]) -> None:
    """At b/a = 1e9 the next order is 1e-9 of the leading one, with factors below 20."""
    aspect = sp.Integer(10**9)
    to_fabric = dict(zip((D33, D3333), fabric, strict=True))
    for found, stated in zip(components(closed(aspect, fabric), aspect), NEEDLE, strict=True):
        assert abs(found / at(stated, to_fabric, aspect) - 1) < mp.mpf(10) ** -7


def at(stated: sp.Expr, to_fabric: dict[sp.Symbol, Any], aspect: sp.Rational) -> sp.Expr:
    """A leading term for numbers of the fabric, the shape and the stiffness ratio."""
    tensor = {N11: sp.Rational(1, 3) - D33 / 15, N33: sp.Rational(1, 3) + 2 * D33 / 15}
    return sp.N(stated.subs(tensor).subs({e0: FABRIC[e0], e1: FABRIC[e1], e2: FABRIC[e2]}).subs(to_fabric)
                .subs({lam: LAM, aspect_ratio: aspect}), 40)


positive = st.fractions(min_value=Fraction(1, 1000), max_value=1000, max_denominator=1000)


@given(st.tuples(*[positive] * 4), st.fractions(min_value=Fraction(1, 100), max_value=100, max_denominator=100))
def test_free_spin_only_softens(moments: tuple[Fraction, ...], squared: Fraction) -> None:
    """The energy is least with free spin, so its shear is positive and never above the symmetrised one, exactly."""
    q = moments[:3]
    apart = moments[3]
    symmetrised = emitted()["stiffness_from_weights"](*q, *q, Fraction(0), apart, squared)[4]
    relaxed, = emitted()["relaxed_shear"](*q, apart, squared)
    assert 0 < relaxed <= symmetrised


def test_free_spin_of_isotropic_spheres_changes_nothing() -> None:
    """With moments 8/15, 2/15, 1/5 both vertical shears agree; with another fabric they do not, even for spheres."""
    isotropic = (Fraction(8, 15), Fraction(2, 15), Fraction(1, 5))
    for q, same in ((isotropic, True), ((Fraction(1, 2), Fraction(1, 7), Fraction(3, 14)), False)):
        symmetrised = emitted()["stiffness_from_weights"](*q, *q, Fraction(0), Fraction(1, 9), Fraction(1))[4]
        assert (emitted()["relaxed_shear"](*q, Fraction(1, 9), Fraction(1)) == (symmetrised,)) is same


def test_spheres_are_the_collinear_case() -> None:
    """With varrho = 1, N11 and N33 of the fabric, every emitted component is that of branches along the normals."""
    by_name = {function.name: function.substituted() for function in functions()}
    tensor = {N11: sp.Rational(1, 3) - D33 / 15, N33: sp.Rational(1, 3) + 2 * D33 / 15}
    for function in collinear_functions():
        if function.name not in by_name:
            continue
        for symbol, wanted in function.substituted().items():
            assert sp.cancel(by_name[function.name][symbol].subs(varrho, 1).subs(tensor) - wanted) == 0


def test_constant_stiffness_is_a_special_case() -> None:
    """A moment of the wrong stiffness in one place would not reduce to the components with k_r = lambda k_n."""
    special = {**{q: lam * p for q, p in zip(TANGENTIAL_MOMENTS, POSITIVE_MOMENTS, strict=True)},
               d0: one_minus_lam * POSITIVE_MOMENTS[0], d1: one_minus_lam * POSITIVE_MOMENTS[1]}
    for found, wanted in zip(positive_components(), constant_components(), strict=True):
        assert sp.expand(found.xreplace(special) - wanted) == 0


def test_fractions_stay_exact() -> None:
    """A root or a float in the emitted scalar code would turn exact moments into rounded components."""
    for function in functions():
        if function.series:
            continue
        found = emitted()[function.name](*(Fraction(k + 3, 7) for k in range(len(function.arguments))))
        assert all(type(value) is Fraction for value in found)


@pytest.mark.parametrize("aspect", [sp.Rational(1, 2), sp.Integer(2)], ids=str)
def test_static_stiffness_lies_below_free_spin(aspect: sp.Rational) -> None:
    """The static estimate must be the softer in every strain, even with grains free to spin.

    A branch length in the wrong place, or N not that of branch times normal, breaks this.
    """
    squared = number(aspect) ** 2
    moments = closed(aspect, (0, 0))
    ratio = number(LAM)

    def mean(form: Callable[[Any, Any], Any]) -> Any:
        return mp.quad(lambda z: form(1 - z * z, z * z), [0, mp.mpf(1) / 2, 1])

    u = [mean(lambda s, y, k=k: s ** (2 - k) * y**k * (s + squared * y) / (s + squared**2 * y)) for k in range(3)]
    tensor = (mean(lambda s, y: s / 2 / mp.sqrt(s + squared**2 * y)),
              mean(lambda s, y: squared * y / mp.sqrt(s + squared**2 * y)))
    static = emitted()["stiffness_from_flexibilities"](
        *u, *(m / ratio for m in u), *((1 / ratio - 1) * m for m in u[:2]), *tensor)
    kinematic = components(moments, aspect)
    assert static[4] <= kinematic[6]
    assert static[5] <= kinematic[5]
    apart = [above - below for above, below in zip(kinematic[:4], static[:4], strict=True)]
    block = ((apart[0] + apart[2]) * 2, apart[3] * 2, apart[1])
    assert block[0] >= 0 and block[2] >= 0 and block[0] * block[2] >= block[1] ** 2
    assert apart[0] >= apart[2]
