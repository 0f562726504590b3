"""Remake the stored second moments of lognormal gradations, from eqs (16) and (17) as they stand, to 30 digits.

Run ``python tests/granular/gradation/certify.py > granular/data/certified_gradation.json``; it takes a minute. Nothing
of the library is used. The convolution is an integral over the radius, in the variable r = l/(1 + exp(-w)) that spreads
both ends to infinity, and the moments are integrals over ln l, each by equal steps, which converge exponentially there.
Two pairs of steps must agree to the digits that are stored.
"""

from __future__ import annotations

import json

import mpmath

SPREADS = (1.001, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0)
ORIGIN = (
    "The definitions of eqs (16) and (17) in multiple precision: the self-convolution of the number density of radii, "
    "its cube root, and its moments, each by the trapezoidal rule in a variable in which it converges exponentially, "
    "with two pairs of steps that agree to 1e-30. Inputs are the full decimal expansions of binary64 numbers, so that "
    "reading them loses nothing. Remade by tests/granular/gradation/certify.py.")


def moments(spread, *, outer_step, inner_step):
    """<l^2>_g/(4 <r^3>^(2/3)) and its inverse counterpart, with radii in units of their median by number."""
    log_spread = mpmath.log(mpmath.mpf(spread))
    tiny = mpmath.mpf(10) ** -(mpmath.mp.dps - 1)

    def by_number(radius):
        return mpmath.exp(-(mpmath.log(radius) / log_spread) ** 2 / 2) / radius

    def total_density(length):
        step, total, largest, place = inner_step * log_spread, mpmath.mpf(0), mpmath.mpf(0), 0
        while True:
            shrunk = mpmath.exp(-step * place)
            radius = length / (1 + shrunk)
            term = by_number(radius) * by_number(radius * shrunk) * radius * shrunk / (1 + shrunk)
            total += term if place == 0 else 2 * term
            if term < largest * tiny:
                return total * step
            largest = max(largest, term)
            place += 1

    known = {}

    def integral(power):
        start = int(1.5 * float((mpmath.mpf(2) / 3 + power) * log_spread) / outer_step)
        total = mpmath.mpf(0)
        for direction in (1, -1):
            largest, place = mpmath.mpf(0), start if direction == 1 else start - 1
            while True:
                length = 2 * mpmath.exp(log_spread * outer_step * place)
                if place not in known:
                    known[place] = total_density(length)
                term = mpmath.cbrt(known[place]) * length ** (power + 1)
                total += term
                if term < min(largest, total) * tiny:
                    break
                largest = max(largest, term)
                place += direction
        return total

    whole, equal = integral(0), 4 * mpmath.exp(3 * log_spread**2)
    return integral(2) / whole / equal, integral(-2) / whole * equal


def certified(spread, *, digits):
    """Both moments, required to agree between two pairs of steps; fewer digits need fewer steps."""
    with mpmath.workdps(digits + 12):
        finest = mpmath.mpf(8) / (mpmath.mpf(digits) + 18)
        fine = moments(spread, outer_step=finest, inner_step=finest / 2)
        coarse = moments(spread, outer_step=finest * 6 / 5, inner_step=finest * 3 / 5)
        for one, other in zip(fine, coarse, strict=True):
            assert abs(one - other) <= mpmath.mpf(10) ** -digits * abs(one), (spread, mpmath.nstr(one - other, 3))
        return fine


def main():
    """Print the stored file."""
    cases = []
    for spread in SPREADS:
        second, inverse = certified(spread, digits=30)
        with mpmath.workdps(60):
            cases.append({"id": f"spread {spread:g}", "spread": mpmath.nstr(mpmath.mpf(spread), 55, strip_zeros=True),
                          "second": mpmath.nstr(second, 31), "inverse_second": mpmath.nstr(inverse, 31)})
    print(json.dumps({"title": "Certified second moments of branch length of lognormal gradations", "origin": ORIGIN,
                      "normalisation": "second = <l^2>_g/(4 <r^3>_p^(2/3)), inverse_second = 4 <r^3>_p^(2/3) <l^-2>_g",
                      "cases": cases}, indent=1))


if __name__ == "__main__":
    main()
