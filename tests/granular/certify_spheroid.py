"""Remake the stored stiffness of aligned spheroids, with 34 digits.

Run ``python tests/granular/certify_spheroid.py > granular/data/certified_spheroid.json``; it takes five minutes.
Contacts of equal stiffness are enclosed in ball arithmetic by the library. Contacts that follow their force are
integrated here, with nothing of the library, in multiple precision: in the variable q = ln tan(beta), in which
directions, branches and forces all have their singularities at the distance pi/2 from the real axis, by tanh-sinh rules
on pieces that end where contacts begin to slide or open. Two steps of the rules must agree to 1e-33, and the finer one
is kept. A test holds this integration against ball arithmetic where both apply.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

import mpmath
from mpmath import mpf

COMPONENTS = ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212")
DIGITS, WORKING = 34, 60
LOWEST, HIGHEST, LONGEST = -70, 135, 1
"""Range of q that matters, beyond the singularities; longest piece."""

ORIGIN = (
    "Contacts of equal stiffness: enclosures in ball arithmetic (Arb), hypergeometric moments. Contacts that follow "
    "their force: quadrature in multiple precision over ln tan(beta), by tanh-sinh rules on pieces that end where "
    "contacts begin to slide or open, two steps of which agree to 1e-33. Inputs are the full decimal expansions of "
    "binary64 numbers, so that reading them loses nothing. Outputs have 34 significant digits; the relative distance "
    "to the true value is at most 1e-33. Static values are absent where contacts slide or have opened, because the "
    "compliance is infinite there, and where grains are free to spin, because no spin enters. Remade by "
    "tests/granular/certify_spheroid.py.")
NORMALISATION = (
    "components over (M/V) l_e^2 k_n,ref, l_e twice the equal-volume radius; branches 2 M^2 n/|M n| with "
    "M = diag(a, a, b), aspect_ratio = b/a; equal stiffness: k_n = k_n,ref, k_r = lambda_0 k_n, lambda_0 = "
    "2 (1 - nu)/(2 - nu); with stress_ratio = sigma33/sigma11: k_n and k_r as for branches along the normals, zero "
    "where the estimated normal force is a tension; friction null: no contact slips; spin relaxed: each grain spins "
    "until it carries no net couple; static: forces that balance the stress by the mean of n^l_i n_k over the contacts")


@dataclass(frozen=True, kw_only=True)
class Case:
    """Inputs of one stored case, every number a double."""

    family: str
    why: str
    aspect_ratio: float
    D33: float = 0.0
    D3333: float = 0.0
    spin: str = "fixed"
    poisson_ratio: float = 0.21
    stress_ratio: float | None = None
    friction: float | None = None


def equal_cases():
    """Contacts of equal stiffness."""
    near = (1.0, 1 + 2.0**-52, 1 - 2.0**-53, 1 + 1e-8, 1 - 1e-8, 1.001, 0.999)
    for shape in near:
        yield Case(family="near 1", why="the elementary form divides by powers of r^2 - 1", aspect_ratio=shape, D33=0.3)
    yield Case(family="near 1", why="spheres that are free to spin", aspect_ratio=1.0, D33=0.3, spin="relaxed")
    yield Case(family="near 1", why="spheres to rounding, free to spin", aspect_ratio=1 + 2.0**-52, D33=-0.5,
               D3333=0.3, spin="relaxed")
    for shape in (0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1.1, 1.5, 2.0, 3.0):
        yield Case(family="ordinary", why="a row of the table of collinear errors", aspect_ratio=shape)
    for shape in (0.3, 0.8, 1.5, 3.0):
        yield Case(family="ordinary", why="a row of the table of collinear errors, free to spin", aspect_ratio=shape,
                   spin="relaxed")
    for shape in (1e-4, 1e-2, 1e2, 1e4):
        yield Case(family="extreme", why="plates or needles", aspect_ratio=shape, D33=0.3)
        yield Case(family="extreme", why="plates or needles, free to spin", aspect_ratio=shape, D33=-0.4, D3333=0.2,
                   spin="relaxed")
    yield Case(family="boundary", why="no contacts at the equator, which carry needles", aspect_ratio=1e4, D33=2.0)
    yield Case(family="boundary", why="no contacts at the pole, which carry plates", aspect_ratio=1e-4, D33=-1.0)
    yield Case(family="boundary", why="no contacts at the equator, free to spin", aspect_ratio=3.0, D33=2.0,
               spin="relaxed")
    yield Case(family="boundary", why="a double zero of the density between pole and equator", aspect_ratio=1 / 3,
               D33=float(Fraction(5, 7)), D3333=float(Fraction(12, 7)))
    yield Case(family="boundary", why="all coupling vanishes at nu = 0", aspect_ratio=0.6, D33=0.3, poisson_ratio=0.0)
    yield Case(family="boundary", why="tiny coupling", aspect_ratio=1.7, D33=0.3, poisson_ratio=1e-15)
    yield Case(family="boundary", why="incompressible grains", aspect_ratio=0.8, D33=-1.0, D3333=0.0, poisson_ratio=0.5,
               spin="relaxed")


def force_cases():
    """Contacts that follow their force: sticking, sliding in part, without friction, opened."""
    for shape, d33, ratio in ((0.5, 0.3, 1.5), (0.9, 0.0, 1.0), (1.2, -0.4, 0.6), (3.0, 0.3, 2.0), (1e-4, 0.2, 3.0),
                              (1e4, 0.2, 1 / 3)):
        yield Case(family="stick", why="no friction data, so that no contact slips", aspect_ratio=shape, D33=d33,
                   stress_ratio=ratio)
    for shape, d33, ratio, friction in ((0.8, 0.3, 1.2, 0.5), (2.0, -0.3, 0.8, 0.6), (1 - 1e-8, 0.0, 1.1, 0.3),
                                        (30.0, 0.5, 1.3, 1.0), (0.01, 0.0, 1.5, 0.8)):
        yield Case(family="slip", why="friction takes from the shear stiffness, and every contact sticks",
                   aspect_ratio=shape, D33=d33, stress_ratio=ratio, friction=friction)
    mu = math.tan(math.radians(12))
    for shape, d33, ratio, friction, spin in (
            (0.8, 0.0, 2.0, mu, "fixed"), (1.25, 0.3, 2.0, mu, "relaxed"), (0.3, -0.5, 4.0, 0.4, "fixed"),
            (3.0, 0.0, 0.2, 0.3, "fixed"), (1e-4, 0.3, 2.0, mu, "fixed"), (1e4, 0.3, 2.0, mu, "relaxed"),
            (1 + 2.0**-52, 0.3, 2.0, mu, "fixed"), (0.6, 0.3, 1e4, 0.5, "relaxed")):
        yield Case(family="slide", why="some contacts slide, with a cube-root edge on either side", aspect_ratio=shape,
                   D33=d33, stress_ratio=ratio, friction=friction, spin=spin)
    yield Case(family="frictionless", why="every contact slides", aspect_ratio=0.8, D33=0.3, stress_ratio=1.5,
               friction=0.0)
    yield Case(family="frictionless", why="every contact slides", aspect_ratio=2.5, D33=0.3, stress_ratio=0.7,
               friction=0.0)
    for shape, ratio, friction in ((0.7, -0.2, 0.5), (1.4, -0.2, None), (2.0, -0.5, 0.2)):
        yield Case(family="opening", why="contacts around the pole have opened", aspect_ratio=shape, D33=0.3,
                   stress_ratio=ratio, friction=friction)
    yield Case(family="opening", why="contacts around the pole have opened, free to spin", aspect_ratio=0.5, D33=0.0,
               stress_ratio=-0.3, friction=0.4, spin="relaxed")


def forces_and_edges(case):
    """Normal forces a and c at equator and pole, and the values of tan(beta) at which contacts slide or open."""
    ratio, d33 = Fraction(case.stress_ratio), Fraction(case.D33)
    mean = (2 + ratio) / 3
    a, c = (exact(force) for force in (5 / (mean * (5 - d33)), 5 * ratio / (mean * (5 + 2 * d33))))
    edges = [mpmath.sqrt(-c / a)] if a * c < 0 else []
    if case.friction:
        linear = abs(c - a) / exact(Fraction(case.friction))
        discriminant = linear**2 - 4 * a * c
        if discriminant > 0:
            root = (linear + mpmath.sqrt(discriminant)) / 2
            edges += [edge for edge in (root / a, c / root) if edge > 0]
    return a, c, edges


def exact(number):
    """A rational number in the working precision."""
    return mpf(number.numerator) / number.denominator


def integrals(case, *, halvings):
    """The sums over the contacts: three moments of k_n and of k_r, of their inverses, and two of n^l_i n_k."""
    r2 = exact(Fraction(case.aspect_ratio) ** 2)
    d, q4 = Fraction(case.D33), Fraction(case.D3333)
    e0, e1, e2 = (exact(e) for e in (1 - d / 2 + 3 * q4 / 8, 2 + d / 2 - 3 * q4, 1 + d + q4))
    places = [mpf(0), mpmath.log(r2) / 2, mpmath.log(r2)]
    loaded = case.stress_ratio is not None
    a, c, edges = forces_and_edges(case) if loaded else (mpf(1), mpf(1), [])
    if loaded and a * c > 0:
        places.append(mpmath.log(c / a) / 2)
    edges = [mpmath.log(edge) for edge in edges]
    low, high = min(*places, *edges, 0) + LOWEST, max(*places, *edges, 0) + HIGHEST
    shear_bound = abs(c - a) / exact(Fraction(case.friction)) if case.friction else mpf(0)
    rigid = compliance_is_finite(case)
    totals = [mpf(0)] * 14

    def add(q, weight):
        t2 = mpmath.exp(2 * q)
        y = 1 / (1 + t2)
        s = t2 * y
        measure = weight * s * mpmath.sqrt(y) * (e0 * s * s + e1 * s * y + e2 * y * y)
        force = a * s + c * y
        normal = mpmath.cbrt(force) if force > 0 else mpf(0)
        if case.friction == 0:
            shear = mpf(0)
        else:
            left = force - shear_bound * mpmath.sqrt(s * y)
            shear = mpmath.cbrt(left) if left > 0 else mpf(0)
        height, length = s + r2 * y, s + r2**2 * y
        forms = (s * s, s * y, y * y)
        for k, form in enumerate(forms):
            totals[k] += measure * form / height * normal
            totals[3 + k] += measure * form / height * shear
            if rigid:
                totals[6 + k] += measure * form * height / length / normal
                totals[9 + k] += measure * form * height / length / shear
        along = measure / mpmath.sqrt(length)
        totals[12] += along * s
        totals[13] += along * r2 * y

    ends = sorted([low, high, *places, *edges])
    for first, last in pairwise(ends):
        pieces = max(1, int(mpmath.ceil((last - first) / LONGEST)))
        for piece in range(pieces if last > first else 0):
            width = (last - first) / pieces
            for q, weight in tanh_sinh(first + piece * width, width, halvings):
                add(q, weight)
    return totals


def tanh_sinh(start, width, halvings):
    """Nodes and weights of a tanh-sinh rule on one piece, with distances from both ends kept accurate."""
    step = mpf(1) / 2**halvings
    place = -int(mpf(9) / 2 / step)
    while place <= int(mpf(9) / 2 / step):
        inner = mpmath.pi / 2 * mpmath.sinh(place * step)
        share = 1 / (1 + mpmath.exp(-2 * inner))
        weight = step * width * mpmath.pi / 4 * mpmath.cosh(place * step) / mpmath.cosh(inner) ** 2
        yield start + width * share, weight
        place += 1


def compliance_is_finite(case):
    """Whether a static stiffness is stored."""
    if case.spin == "relaxed" or case.friction == 0 or (case.stress_ratio or 1) < 0:
        return False
    return not (case.friction and forces_and_edges(case)[2])


def components(case, *, halvings):
    """Six components under each hypothesis, from eqs (6), (7), (24) and Figure 1(b)."""
    totals = integrals(case, halvings=halvings)
    r2, nu = exact(Fraction(case.aspect_ratio) ** 2), exact(Fraction(case.poisson_ratio))
    lam0 = (2 - 2 * nu) / (2 - nu)
    size = mpmath.cbrt(r2) ** -1
    n, k = totals[0:3], [lam0 * moment for moment in totals[3:6]]
    apart = [one - other for one, other in zip(n, k, strict=True)]
    if case.poisson_ratio < 1e-3 and case.friction is None:
        apart = [nu / (2 - nu) * moment for moment in n]
    c_2323 = (apart[1] + k[0] + k[1]) / 2
    c_3232 = r2**2 * (apart[1] / 2 + k[1] + k[2])
    c_2332 = r2 * apart[1] / 2
    shear = (c_2323 + 2 * c_2332 + c_3232) / 4
    if case.spin == "relaxed":
        shear = (c_2323 * c_3232 - c_2332**2) / (c_2323 + c_3232 - 2 * c_2332)
    found = {"kinematic": (3 * apart[0] / 8 + (k[0] + k[1]) / 2, r2**2 * (apart[2] + k[1] + k[2]), apart[0] / 8,
                           r2 * apart[1] / 2, shear, apart[0] / 8 + (k[0] + k[1]) / 4)}
    if compliance_is_finite(case):
        found["static"] = static(totals, lam0)
    return {name: [size * component for component in six] for name, six in found.items()}


def static(totals, lam0):
    """Six components from moments of 1/k_n and 1/k_r and from the balance of forces."""
    u, v = totals[6:9], [moment / lam0 for moment in totals[9:12]]
    apart = [one - other for one, other in zip(u, v, strict=True)]
    a1, a3 = 2 / totals[12], 1 / totals[13]
    s11 = a1**2 * (3 * apart[0] / 8 + (v[0] + v[1]) / 2)
    s33 = a3**2 * (apart[2] + v[1] + v[2])
    s12, s13 = a1**2 * apart[0] / 8, a1 * a3 * apart[1] / 2
    s2323 = (a1**2 * (apart[1] + v[0] + v[1]) / 2 + a1 * a3 * apart[1] + a3**2 * (apart[1] / 2 + v[1] + v[2])) / 4
    block = mpmath.matrix([[s11, s12, s13], [s12, s11, s13], [s13, s13, s33]]) ** -1
    return block[0, 0], block[2, 2], block[0, 1], block[0, 2], 1 / (4 * s2323), 1 / (2 * (s11 - s12))


def by_quadrature(case, *, halvings=5):
    """Six components under each hypothesis; two steps of the rule must agree."""
    with mpmath.workdps(WORKING):
        fine, coarse = (components(case, halvings=number) for number in (halvings, halvings - 1))
        for name, six in fine.items():
            for one, other in zip(six, coarse[name], strict=True):
                apart = abs(one - other)
                assert apart <= mpf(10) ** (1 - DIGITS) * abs(one), (case, name, mpmath.nstr(apart / one, 3))
        return {name: [mpmath.nstr(value, DIGITS, min_fixed=-5, strip_zeros=False) for value in six]
                for name, six in fine.items()}


def by_balls(case):
    """Six components under each hypothesis, from enclosures that are narrower than what is stored."""
    from granular.fabric import AxialFabric
    from granular.hypothesis import Hypothesis
    from granular.routes import certified

    fabric = AxialFabric(D33=case.D33, D3333=case.D3333, aspect_ratio=case.aspect_ratio,
                         free_spin=case.spin == "relaxed")
    found = {}
    for hypothesis in (Hypothesis.KINEMATIC,) if fabric.free_spin else Hypothesis:
        six = certified.enclose(fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis, digits=DIGITS + 6)
        with mpmath.workdps(WORKING):
            found[hypothesis.value] = [
                mpmath.nstr(exact(enclosure.midpoint), DIGITS, min_fixed=-5, strip_zeros=False) for enclosure in six]
    return found


def entry(number, case):
    """One case as it is stored."""
    numbers = {"D33": case.D33, "D3333": case.D3333, "Dr33": 0.0, "aspect_ratio": case.aspect_ratio,
               "poisson_ratio": case.poisson_ratio}
    stored = {"id": f"s{number:03d}", "family": f"spheroids: {case.family}", "why": case.why, "spin": case.spin,
              **{name: str(Decimal(value)) for name, value in numbers.items()}}
    loaded = case.stress_ratio is not None
    if loaded:
        stored |= {"stress_ratio": str(Decimal(case.stress_ratio)),
                   "friction": None if case.friction is None else str(Decimal(case.friction))}
    found = by_quadrature(case) if loaded else by_balls(case)
    return stored | {name: dict(zip(COMPONENTS, six, strict=True)) for name, six in found.items()}


def main():
    """Print the stored file."""
    cases = [entry(number, case) for number, case in enumerate((*equal_cases(), *force_cases()))]
    print(json.dumps({"title": "Certified stiffness of aligned spheroids", "origin": ORIGIN,
                      "normalisation": NORMALISATION, "order": list(COMPONENTS), "cases": cases}, indent=1))


if __name__ == "__main__":
    main()
