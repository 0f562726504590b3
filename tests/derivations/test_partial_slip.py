"""The closed form with partial slip: held against quadrature of the plain integrand, split at its roots."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from derivations.slip_integrals import (
    evaluate_slip_moments,
    integrals_at_tangency,
    integrals_from_root,
    integrals_from_start,
    integrals_to_root,
    slip_moments,
)
from derivations.sphere import axial_moment

Scene = tuple[int | str, int | str, int | str]

DIGITS = 20


def number(value: object) -> mpmath.mpf:
    """Return an exact fraction in working precision."""
    rational = sp.Rational(str(value))
    return mpmath.mpf(rational.p) / rational.q


def by_quadrature(scene: Scene, degree: int) -> list[mpmath.mpf]:
    """Integrate sin^(2(degree-m)+1) cos^(2m) max(f_n - f_r/mu, 0)^(1/3) over beta, from Coulomb's law alone."""
    a, c, mu = (number(part) for part in scene)
    quarter = mpmath.pi / 2
    edges = [mpmath.mpf(0), quarter / 2 + (1 if c > a else -1) * mpmath.atan(mu) / 2, quarter]
    discriminant = ((c - a) / mu) ** 2 - 4 * a * c
    if discriminant > 0:
        roots = [(abs(c - a) / mu + sign * mpmath.sqrt(discriminant)) / (2 * a) for sign in (1, -1)]
        edges += [mpmath.atan(root) for root in roots if root > 0]
    edges.sort()

    def integrand(beta: mpmath.mpf, m: int) -> mpmath.mpf:
        sine, cosine = mpmath.sin(beta), mpmath.cos(beta)
        left = a * sine**2 + c * cosine**2 - abs(c - a) * sine * cosine / mu
        return sine ** (2 * (degree - m) + 1) * cosine ** (2 * m) * mpmath.cbrt(max(left, 0))

    return [mpmath.quad(lambda beta, m=m: integrand(beta, m), edges) for m in range(degree + 1)]


@pytest.mark.parametrize("scene", [
    ("6/7", "9/7", "1"), (3, 2, "2"),          # all stick, either axis
    ("6/7", "9/7", "1/5"), (3, 1, "1/4"),      # some slide, either axis
    (1, 4, "3/4"), (4, 1, "3/4"),              # exactly at the onset
    (3, "-1/2", "1/4"), ("-1/2", 3, "1/4"),    # contacts open about one axis
], ids=str)
def test_closed_form_against_quadrature(scene: Scene) -> None:
    """A wrong sign on one side, a root missed or a recurrence off by one breaks some of the six moments."""
    closed = evaluate_slip_moments(*(sp.Rational(str(part)) for part in scene), digits=DIGITS)
    with mpmath.workdps(DIGITS + 10):
        for moment, expected in zip(closed, by_quadrature(scene, 5), strict=True):
            assert abs(mpmath.mpf(moment) / expected - 1) < mpmath.mpf(10) ** (1 - DIGITS)


def test_rank_four_density_needs_degree_six() -> None:
    """A degree that is fixed somewhere to five breaks this: seven moments of degree six."""
    scene: Scene = ("6/7", "9/7", "1/5")
    closed = evaluate_slip_moments(*(sp.Rational(str(part)) for part in scene), degree=6, digits=DIGITS)
    with mpmath.workdps(DIGITS + 10):
        for moment, expected in zip(closed, by_quadrature(scene, 6), strict=True):
            assert abs(mpmath.mpf(moment) / expected - 1) < mpmath.mpf(10) ** (1 - DIGITS)


def test_degrees_are_consistent() -> None:
    """H_m of degree five is H_m + H_(m+1) of degree six, since s + x^2 = 1: no quadrature involved."""
    five = evaluate_slip_moments(sp.Integer(1), sp.Integer(3), sp.Rational(1, 3), degree=5, digits=30)
    six = evaluate_slip_moments(sp.Integer(1), sp.Integer(3), sp.Rational(1, 3), degree=6, digits=30)
    for m in range(6):
        assert abs(six[m] + six[m + 1] - five[m]) < sp.Float("1e-29", 30) * five[m]


def test_equal_forces_never_slip() -> None:
    """Equal forces carry no shear: the moments are those of the isotropic assembly, exactly and for any friction."""
    moments = slip_moments(sp.Integer(8), sp.Integer(8), sp.Rational(1, 100))
    assert moments == tuple(2 * axial_moment(5 - m, m) for m in range(6))


def test_exact_form_has_two_moduli_only() -> None:
    """An integral of the second kind, or a third modulus, would show among the functions of the exact form."""
    moments = slip_moments(sp.Integer(1), sp.Integer(2), sp.Rational(1, 2))
    found = set().union(*(moment.atoms(sp.elliptic_f) for moment in moments))
    assert found and {f.args[1] for f in found} <= {(2 - sp.sqrt(3)) / 4, (2 + sp.sqrt(3)) / 4}
    assert not any(moment.has(sp.elliptic_e, sp.elliptic_pi, sp.Integral) for moment in moments)


@pytest.mark.parametrize("index", [0, 3])
def test_pieces_against_quadrature(index: int) -> None:
    """Each kind of piece on its own, so that two errors cannot cancel in the sums."""
    with mpmath.workdps(30):
        third = mpmath.mpf(1) / 3
        stick = mpmath.quad(lambda y: y ** (2 * index) * (2 + 5 * y**2) ** third, [0, mpmath.mpf(4) / 5])
        slide = mpmath.quad(lambda v: 2 * v * (1 + v**2) ** (2 * index) * (5 * v**2 * (2 + v**2)) ** third, [0, 1])
        root = mpmath.quad(lambda v: 2 * v * (1 - v**2) ** (2 * index) * (5 * v**2 * (2 - v**2)) ** third, [0, 1])
        pieces = (
            (integrals_from_start(sp.Rational(4, 5), sp.Integer(2), sp.Integer(5), 4), stick),
            (integrals_from_root(sp.Integer(2), sp.Integer(1), sp.Integer(5), 4), slide),
            (integrals_to_root(sp.Integer(5), sp.Integer(5), 4), root),
            (integrals_at_tangency(sp.Integer(1), sp.Integer(8), 4), 2 / (2 * index + mpmath.mpf(5) / 3)),
        )
        for closed, expected in pieces:
            assert abs(mpmath.mpf(sp.N(closed[index], 30)) - expected) < mpmath.mpf(10) ** -18 * expected


@pytest.mark.parametrize("shift", [sp.Rational(1, 10**40), -sp.Rational(1, 10**40)])
def test_onset_is_decided_exactly(shift: sp.Rational) -> None:
    """A decision by floating point calls 1e-40 beside the onset the onset, and then no F of that side is needed."""
    at = slip_moments(sp.Integer(1), sp.Integer(4), sp.Rational(3, 4), digits=100)
    near = slip_moments(sp.Integer(1), sp.Integer(4), sp.Rational(3, 4) * (1 + shift), digits=400)
    for one, other in zip(at, near, strict=True):
        assert sp.Float("1e-41", 50) < abs(one / other - 1) < sp.Float("1e-30", 50)
