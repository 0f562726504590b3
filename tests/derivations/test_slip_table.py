"""What is not smooth about the onset of sliding: the emitted part against integrals of the plain integrand."""

from __future__ import annotations

import math
from itertools import pairwise

import mpmath
import pytest
import sympy as sp

from derivations import batch_constant
from derivations.emit.panels import BEGINNINGS, FOLLOWING, name_of, panel_module
from derivations.slip_table import even_part, onset_part, singular_moments
from derivations.symbols import eta, margin, onset_strength
from granular.batch import slip_layout
from granular.generated import panel_rows
from granular.generated.slip_table import onset_part as emitted_part

DIGITS = 20


def moments(kept: mpmath.mpf, contrast: mpmath.mpf, wanted: tuple[int, ...]) -> list[mpmath.mpf]:
    """Some moments of what is left of the normal force, mean cube root 1, by quadrature between its roots."""
    a, c = (1 - contrast) ** 3, (1 + contrast) ** 3
    shear = 2 * (1 - kept) * mpmath.sqrt(a * c)
    nearest = mpmath.atan(mpmath.sqrt(c / a))
    edges = [mpmath.mpf(0), nearest, mpmath.pi / 2]
    if kept < 0:
        root = mpmath.sqrt(shear**2 - 4 * a * c)
        edges = [0, mpmath.atan(2 * c / (shear + root)), mpmath.atan((shear + root) / (2 * a)), mpmath.pi / 2]

    def integrand(beta: mpmath.mpf, k: int) -> mpmath.mpf:
        sine, cosine = mpmath.sin(beta), mpmath.cos(beta)
        left = a * sine**2 + c * cosine**2 - shear * sine * cosine
        return sine ** (11 - 2 * k) * cosine ** (2 * k) * mpmath.cbrt(max(left, 0))

    parts = list(pairwise(edges))
    if kept < 0:
        del parts[1]
    return [mpmath.fsum(mpmath.quad(lambda beta, k=k: integrand(beta, k), part) for part in parts) for k in wanted]


def part(kept: mpmath.mpf, contrast: mpmath.mpf) -> list[mpmath.mpf]:
    """The emitted part that is not smooth, in working precision."""
    between = mpmath.beta(mpmath.mpf(1) / 2, mpmath.mpf(4) / 3)
    strength = mpmath.sqrt(3) * between if kept > 0 else -2 * between
    values = {margin: kept, eta: contrast, onset_strength: strength}
    known: dict[sp.Symbol, mpmath.mpf] = dict(values)
    function = onset_part()
    for symbol, expression in function.assignments:
        arguments = sorted(expression.free_symbols, key=str)
        known[symbol] = sp.lambdify(arguments, expression, "mpmath")(*(known[one] for one in arguments))
    return [known[symbol] for symbol in function.returns]


@pytest.mark.parametrize(("contrast", "wanted"), [("0.2", (0, 3)), ("-0.3", (1, 5))])
def test_what_is_left_is_one_smooth_function(contrast: str, wanted: tuple[int, ...]) -> None:
    """A wrong strength on one side, or a wrong polynomial, leaves a kink: differences across the onset show it.

    The tenth differences of a function that is analytic out to about 0.8 are some 10! (step/0.8)^10, 1e-10 of it;
    with what is not smooth they are above 1e-6.
    """
    with mpmath.workdps(DIGITS):
        points = [mpmath.mpf(2 * j - 11) / 128 for j in range(11)]
        whole = [moments(point, mpmath.mpf(contrast), wanted) for point in points]
        rough = [part(point, mpmath.mpf(contrast)) for point in points]

        def difference(values: list[mpmath.mpf]) -> mpmath.mpf:
            return abs(mpmath.fsum((-1) ** j * math.comb(10, j) * value for j, value in enumerate(values)) / values[5])

        for place, k in enumerate(wanted):
            assert difference([w[place] - p[k] for w, p in zip(whole, rough, strict=True)]) < 2e-9, k
            assert difference([w[place] for w in whole]) > 1e-6, k


@pytest.mark.parametrize(("kept", "contrast"), [(0.05, 0.2), (-0.05, -0.3), (0.001, 0.0), (-1e-9, 0.29)])
def test_emitted_part_is_that_of_the_derivation(kept: float, contrast: float) -> None:
    """The emitted arithmetic against the closed form, an independent sum, on both sides; to the digits of a double."""
    strength = 2.9 if kept > 0 else -3.4
    closed = sp.lambdify((margin, eta, onset_strength), singular_moments(), "mpmath")
    with mpmath.workdps(DIGITS):
        expected = closed(*(mpmath.mpf(value) for value in (kept, contrast, strength)))
    for found, value in zip(emitted_part(kept, contrast, strength), expected, strict=True):
        assert found == pytest.approx(float(value), rel=1e-14)  # sums of 36 terms with coefficients up to 1134


def test_leading_coefficients_are_the_weights() -> None:
    """Q_k(0) is the weight in the direction nearest to sliding."""
    at_equator, at_pole = sp.symbols("S C", real=True)
    assert [even_part(k)[0] for k in range(6)] == [at_equator ** (5 - k) * at_pole**k for k in range(6)]


@pytest.mark.parametrize(("sizes", "first"), [*((one, True) for one in BEGINNINGS),
                                              *((one, False) for one in FOLLOWING)])
def test_rows_of_panels(sizes: tuple[int, ...], first: bool) -> None:
    """Three polynomials against Horner's rule in fractions: a coefficient in the wrong half or row breaks it."""
    rows = [[sp.Rational((-1) ** i * (7 * k + i + 1), 8) for i in range(sum(sizes) + 2)] for k in range(3)]
    x, y = sp.Rational(3, 8), sp.Rational(-5, 4)

    class Rows:
        """Coefficients as exact numbers, indexed like an array."""

        def __getitem__(self, place: tuple[int, int, int]) -> sp.Rational:
            assert place[0] == 9
            return rows[place[1]][place[2]]

    class Column(list[sp.Rational]):
        """One element, with the attribute that the loop asks for."""

        size = 1

    class Columns:
        """Three columns of one element each; what begins at a place is the column that begins there."""

        def __init__(self) -> None:
            self.each = [Column([sp.Rational(k + 1)]) for k in range(3)]

        def __getitem__(self, place: slice) -> Column:
            assert place.stop == place.start + 1
            return self.each[place.start // 5]

    columns, middle, narrowness = Columns(), sp.Rational(1, 4), sp.Integer(3)
    other = () if first and len(sizes) == 1 else (Column([y]),)
    expected = [sp.Integer(0) if first else sp.Rational(k + 1) for k in range(3)]
    for k in range(3):
        done = 2
        for size in sizes:
            total = sp.Integer(0)
            for coefficient in rows[k][done:done + size]:
                total = total * (x if other else (x - middle) * narrowness) + coefficient
            expected[k], done = expected[k] * y + total, done + size
    between = other or (middle, narrowness)
    getattr(panel_rows, name_of(sizes, first=first))(Rows(), 9, 0, 2, Column([x]), *between, columns, 5)
    assert [column[0] for column in columns.each] == expected


def test_tables_and_components_count_in_the_same_unit() -> None:
    """A table that is multiplied by another number than the emitted components expect."""
    assert batch_constant.DENOMINATOR == slip_layout.DENOMINATOR


def test_emitting_rows_twice_gives_the_same_text() -> None:
    """Emission must not depend on anything but the sizes."""
    assert panel_module() == panel_module()
