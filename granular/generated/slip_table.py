"""Partial slip about its onset: what a table can hold: scalar functions.

Emitted by ``derivations write`` from the derivation ``slip_table``; do not edit.
Source: (20), (21), (23) of Pan & Dong (1999).
Domain: a, c > 0, a != c; margin <= 1.
Operations: 369 (7736 in the outputs as derived).
"""

from __future__ import annotations

from math import cbrt, sqrt


def onset_part(
    margin: float, eta: float, onset_strength: float,
) -> tuple[float, float, float, float, float, float]:
    """What is not smooth at the onset of sliding in the six moments of the stiffness left by slip.

    Contrast of the cube roots of the forces, with 1 for the mean of these. The strength is B(1/2, 4/3) times
    sqrt(3) before the onset, margin > 0, and times -2 after it.

    Parameters
    ----------
    margin : float [-]
        Friction left where contacts are nearest to sliding, 1 - kappa.
    eta : float [-]
        Contrast of the roots of the normal contact force at pole and equator.
    onset_strength : float [-]
        Factor of what is not smooth at the onset, one on either side.

    Returns
    -------
    singular0 : float [-]
    singular1 : float [-]
    singular2 : float [-]
    singular3 : float [-]
    singular4 : float [-]
    singular5 : float [-]

    Operations: 369.
    """
    square = eta*eta
    even = 1 - square
    cube = even*even*even
    half = eta*(square + 3)
    share = 1 - margin
    radius = sqrt(cube*share*share + half*half)
    left_over = cube*margin*(share + 1)/((radius + 3*square + 1))
    w = -left_over/(2*radius)
    S = half/(2*radius) + 1/2
    C = -half/(2*radius) + 1/2
    S2 = S*S
    C2 = C*C
    S4 = S2*S2
    C4 = C2*C2
    z0 = S*S4
    z1 = C*S4
    z2 = C2*S*S2
    z3 = C*C2*S2
    z4 = C4*S
    z5 = C*C4
    w1 = 3*w/11
    w2 = 9*w/17
    w3 = 15*w/23
    w4 = 21*w/29
    w5 = 27*w/35
    factor = sqrt(S)*onset_strength*cbrt(abs(left_over))*sqrt(abs(w))
    singular0 = factor*(w1*(w2*(w3*(w4*(w5*(-z0 + 55*z1 - 330*z2 + 462*z3 - 165*z4 + 11*z5) + 5*z0 - 220*z1 + 990*z2 - 924*z3 + 165*z4) - 10*z0 + 330*z1 - 990*z2 + 462*z3) + 10*z0 - 220*z1 + 330*z2) - 5*z0 + 55*z1) + z0)
    singular1 = factor*(w1*(w2*(w3*(w4*(w5*(z0 - 55*z1 + 330*z2 - 462*z3 + 165*z4 - 11*z5) - 4*z0 + 185*z1 - 900*z2 + 966*z3 - 240*z4 + 9*z5) + 6*z0 - 226*z1 + 846*z2 - 630*z3 + 84*z4) - 4*z0 + 118*z1 - 312*z2 + 126*z3) + z0 - 23*z1 + 36*z2) + z1)
    singular2 = factor*(w1*(w2*(w3*(w4*(w5*(-z0 + 55*z1 - 330*z2 + 462*z3 - 165*z4 + 11*z5) + 3*z0 - 150*z1 + 810*z2 - 1008*z3 + 315*z4 - 18*z5) - 3*z0 + 141*z1 - 696*z2 + 756*z3 - 189*z4 + 7*z5) + z0 - 52*z1 + 248*z2 - 224*z3 + 35*z4) + 6*z1 - 33*z2 + 21*z3) + z2)
    singular3 = factor*(w1*(w2*(w3*(w4*(w5*(z0 - 55*z1 + 330*z2 - 462*z3 + 165*z4 - 11*z5) - 2*z0 + 115*z1 - 720*z2 + 1050*z3 - 390*z4 + 27*z5) + z0 - 75*z1 + 540*z2 - 840*z3 + 315*z4 - 21*z5) + 15*z1 - 160*z2 + 280*z3 - 100*z4 + 5*z5) + 15*z2 - 35*z3 + 10*z4) + z3)
    singular4 = factor*(w1*(w2*(w3*(w4*(w5*(-z0 + 55*z1 - 330*z2 + 462*z3 - 165*z4 + 11*z5) + z0 - 80*z1 + 630*z2 - 1092*z3 + 465*z4 - 36*z5) + 28*z1 - 378*z2 + 882*z3 - 462*z4 + 42*z5) + 70*z2 - 280*z3 + 190*z4 - 20*z5) + 28*z3 - 29*z4 + 3*z5) + z4)
    singular5 = factor*(w1*(w2*(w3*(w4*(w5*(z0 - 55*z1 + 330*z2 - 462*z3 + 165*z4 - 11*z5) + 45*z1 - 540*z2 + 1134*z3 - 540*z4 + 45*z5) + 210*z2 - 882*z3 + 630*z4 - 70*z5) + 210*z3 - 300*z4 + 50*z5) + 45*z4 - 15*z5) + z5)
    return singular0, singular1, singular2, singular3, singular4, singular5
