"""Gauss-Legendre rules on [0, 1], correctly rounded: the roots are polished in 60 digits before they become doubles."""

from __future__ import annotations

from mpmath import mp, mpf

SIZES = (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 22, 24, 28, 32, 36, 40, 48, 56, 64, 72, 80)


def rule(size: int) -> tuple[list[float], list[float]]:
    """Nodes in rising order and weights of the rule with ``size`` nodes on [0, 1]."""
    with mp.workdps(60):
        nodes, weights = [], []
        for index in range(size):
            root = mp.cos(mp.pi * (size - index - mpf(1) / 4) / (size + mpf(1) / 2))
            for _ in range(6):
                value, slope = _legendre(size, root)
                root -= value / slope
            _, slope = _legendre(size, root)
            nodes.append(float((1 + root) / 2))
            weights.append(float(1 / ((1 - root**2) * slope**2)))
    return nodes, weights


def _legendre(degree: int, point: mpf) -> tuple[mpf, mpf]:
    """Legendre polynomial and its derivative by the three-term recurrence."""
    before, here = mpf(1), point
    for n in range(2, degree + 1):
        before, here = here, ((2 * n - 1) * point * here - (n - 1) * before) / n
    return here, degree * (point * here - before) / (point**2 - 1)


def gauss_module() -> str:
    """Return the text of ``granular/generated/gauss_legendre.py``."""
    lines = ['"""Gauss-Legendre nodes and weights on [0, 1], correctly rounded.', "",
             "Emitted by ``derivations write``; do not edit. A rule with n nodes is exact for polynomials of degree",
             '2n - 1; nodes and weights were computed in 60 digits."""', "",
             "from __future__ import annotations", "", "from typing import Final"]
    rules = {size: rule(size) for size in SIZES}
    for name, part in (("NODES", 0), ("WEIGHTS", 1)):
        lines += ["", f"{name}: Final[dict[int, tuple[float, ...]]] = {{"]
        for size in SIZES:
            lines.append(f"    {size}: (")
            lines += [f"        {number!r}," for number in rules[size][part]]
            lines.append("    ),")
        lines.append("}")
    return "\n".join(lines) + "\n"
