"""What the rule for slipping contacts computes at each node: three maps of the log-tangent variable, without loss.

The maps are proved in ``derivations.slip_maps``; here they are put in order so that no digit is lost: exp(sigma) is
formed as a square of a sum of positive terms, 1 - chi as a quotient, and distances from the ends of a range are
never differences. Arguments are tabulated hyperbolic functions of fixed nodes.
"""

from __future__ import annotations

import sympy as sp

from derivations.record import Function
from derivations.symbols import kappa

sinh_v, S, P = sp.symbols("sinh_v S P", real=True)
cosh_v, slope, scale, reach, edge_sine = sp.symbols("cosh_v slope scale reach edge_sine", positive=True)
left = sp.Symbol("left", nonnegative=True)
q, root, cosh_sigma, share, growth, rate, chi, loss, under, at_edge = sp.symbols(
    "q root cosh_sigma share growth rate chi loss under at_edge", real=True)


def _slip(kept: sp.Expr, used: sp.Expr) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """Chi, and 1 - chi from 1 - chi^3, which is the share of the friction that is used up."""
    return (share, kept / cosh_sigma), (chi, sp.cbrt(share)), (loss, used / (cosh_sigma * (1 + chi + chi**2)))


def sticking_node() -> Function:
    """Emit a node of the map sinh(sigma/2) = scale sinh(v) over all directions."""
    return Function(
        "sticking_node", "A node of sinh(sigma/2) = scale sinh(v), for contacts that all stick.",
        (sinh_v, cosh_v, scale, left, kappa),
        ((q, scale * sinh_v), (root, sp.sqrt(1 + q**2)), (cosh_sigma, 1 + 2 * q**2),
         *_slip(2 * q**2 + left, kappa),
         (growth, (sp.Abs(q) + root) ** 2), (rate, 2 * scale * cosh_v / root)),
        (growth, rate, chi, loss),
        notes="With left = 1 - kappa and scale = sqrt(left/2) or more. growth is exp(|sigma|), rate is d(sigma)/dv, "
              "chi is the shear stiffness over that without slip, loss is 1 - chi.", unit="-")


def beside_node() -> Function:
    """Emit a node of the map sinh(sigma/2) = edge_sine (1 + P) beside a sliding range."""
    return Function(
        "beside_node", "A node of sinh(sigma/2) = edge_sine (1 + P), for sticking contacts beside a sliding range.",
        (P, slope, edge_sine),
        ((at_edge, edge_sine + sp.sqrt(1 + edge_sine**2)),
         (q, edge_sine * (1 + P)), (root, sp.sqrt(1 + q**2)), (cosh_sigma, 1 + 2 * q**2),
         *_slip(2 * edge_sine**2 * P * (2 + P), 1 + 2 * edge_sine**2),
         (growth, ((q + root) / at_edge) ** 2), (rate, 2 * edge_sine * slope / root)),
        (growth, rate, chi, loss),
        notes="With P = e^(2w)/(2 (1 + e^w)), slope = dP/dw and edge_sine = sinh(psi/2) at the edge of the range. "
              "growth is exp(|sigma| - psi), the ratio of tan(beta) to its value at the edge.", unit="-")


def between_node() -> Function:
    """Emit a node of the map sinh(sigma/2) = edge_sine S/sqrt(reach^2 + S^2) inside a sliding range."""
    return Function(
        "between_node", "A node of sinh(sigma/2) = edge_sine S/sqrt(reach^2 + S^2), inside a sliding range.",
        (sinh_v, cosh_v, edge_sine, reach),
        ((under, sp.sqrt(reach**2 + sinh_v**2)), (q, edge_sine * sinh_v / under), (root, sp.sqrt(1 + q**2)),
         (growth, (sp.Abs(q) + root) ** 2),
         (rate, 2 * edge_sine * cosh_v * reach**2 / (root * under**3))),
        (growth, rate),
        notes="With edge_sine = sinh(psi/2) at the ends of the range and reach = sqrt(1 + edge_sine^2).", unit="-")


def functions() -> tuple[Function, ...]:
    """All node functions, to be emitted with the derivation that proves the maps."""
    return sticking_node(), beside_node(), between_node()
