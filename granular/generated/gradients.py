"""Slopes of the stiffness: scalar functions.

Emitted by ``derivations write`` from the derivation ``gradients``; do not edit.
Source: (7), (20), (21), (23), Figure 1(b) of Pan & Dong (1999).
Domain: -1 <= D33 <= 2; -1 < Dr33 < 2; 0 <= nu <= 1/2; a, c > 0: no contact opens; with slip: mu > 0, not exactly at the onset of sliding; the emitted series: 1/9 <= c/a <= 9.
Operations: 3205 (316 in the outputs as derived).
"""

from __future__ import annotations

from math import cbrt, sqrt

# 30 terms for |eta| <= 1/2; left out: 7e-18 of the sum.
FORCE_0 = (
    0.340992340992341,
    0.3940355940355941,
    0.3640223248066368,
    0.3083697889339347,
    0.2584881444344456,
    0.22237155496998046,
    0.19697334046854592,
    0.17816187619203547,
    0.16345281659091743,
    0.15152403071314918,
    0.14159949254913692,
    0.13317991471951032,
    0.1259287858384824,
    0.11960039539996979,
    0.11396124658523198,
    0.10896276351593569,
    0.10515741842760204,
    0.10139282628129732,
    0.09224291631706727,
    0.08723643161790856,
    0.11749757770287789,
    0.12218084739509115,
    -0.024834784892962133,
    -0.050533866907036894,
    0.38304509762160677,
    0.4279121443176401,
    -0.44463290291684365,
    -0.5014162167311362,
    0.5316685674272014,
    0.556911739477772,
)

# 26 terms for |eta| <= 1/2; left out: 3e-18 of the sum.
FORCE_1 = (
    0.028416028416028416,
    0.022732822732822733,
    0.00854338109240075,
    -0.0005604353729566392,
    -0.002587488120503821,
    -0.0017984806194176377,
    -0.0010083011391108126,
    -0.0006201023490666603,
    -0.0004219733411390879,
    -0.00030385458487454294,
    -0.0002278424227652265,
    -0.00017614874253948045,
    -0.00013955397643566434,
    -0.00011277038611923173,
    -9.238875331884632e-05,
    -7.685770425485712e-05,
    -6.680644270468526e-05,
    -5.759493628742204e-05,
    -3.859068326771538e-05,
    -3.0871260863714544e-05,
    -6.754938817723825e-05,
    -6.59476549655734e-05,
    3.8607602983064024e-05,
    4.385741129242991e-05,
    -9.568428513819076e-05,
    -9.203211683594739e-05,
)

# 23 terms for |eta| <= 1/2; left out: 2e-18 of the sum.
FORCE_2 = (
    0.008524808524808525,
    0.003788803788803789,
    -0.0015972408129270854,
    -0.002039724089947816,
    -0.0004889327979191488,
    0.00013464888511003598,
    9.143067022519596e-05,
    3.074666210566059e-05,
    1.497728390139087e-05,
    8.019775216998829e-06,
    4.7496459435984946e-06,
    2.9658936277583885e-06,
    1.9510132605137986e-06,
    1.3319806872334167e-06,
    9.390778706846798e-07,
    6.580892504052728e-07,
    4.803056434571726e-07,
    4.4997916046689645e-07,
    3.622547039115044e-07,
    3.336213105598409e-08,
    -3.3838296603178384e-09,
    3.9437935137780305e-07,
    3.394376255188919e-07,
)

# 20 terms for |eta| <= 1/2; left out: 3e-18 of the sum.
FORCE_3 = (
    0.005328005328005328,
    0.0004736004736004737,
    -0.0021126295636099642,
    -0.0003592325573749932,
    0.0004995903019840934,
    9.92037561012544e-05,
    -3.3952096870436785e-05,
    -3.503305763122827e-06,
    -2.020202996558721e-06,
    -5.091824676603507e-07,
    -3.5362875174767804e-07,
    -1.2438896321488055e-07,
    -9.360244692165742e-08,
    -3.982904770921618e-08,
    -3.267939640181116e-08,
    -1.6125154282174173e-08,
    -9.392438331651417e-09,
    -4.434891025322561e-09,
    -1.0917616096546535e-08,
    -6.722277610514135e-09,
)

# 21 terms for |eta| <= 1/2; left out: 2e-18 of the sum.
FORCE_4 = (
    0.006216006216006216,
    -0.0016576016576016572,
    -0.00203137458039419,
    0.0011356690636588607,
    0.0002130935127918503,
    -0.00023732138837863622,
    3.611397880736552e-05,
    -4.992314307511361e-06,
    2.8924122699882405e-06,
    -1.0858282760837156e-06,
    6.543985612268011e-07,
    -3.323225977542636e-07,
    2.1396810545235158e-07,
    -1.255223332315825e-07,
    8.508535799887806e-08,
    -5.97667034219993e-08,
    4.350481429313841e-08,
    -1.5403376063915716e-08,
    9.419420424037463e-09,
    -3.285131752544077e-08,
    2.6469943387251337e-08,
)

# 24 terms for |eta| <= 1/2; left out: 2e-18 of the sum.
FORCE_5 = (
    0.013986013986013986,
    -0.008702408702408702,
    0.00030470618705910976,
    0.002769084296432154,
    -0.0017687977784262103,
    0.0005527322199130186,
    -0.00014558922532446916,
    6.572195048455553e-05,
    -3.8075765318876066e-05,
    2.375636836132253e-05,
    -1.58451161922274e-05,
    1.1034620904230598e-05,
    -7.96576034641255e-06,
    5.91477994999295e-06,
    -4.531104287030164e-06,
    3.528257473930254e-06,
    -2.5862528781700076e-06,
    2.0177960041103344e-06,
    -2.4714215095375637e-06,
    2.1826988999783804e-06,
    3.9921368538192685e-07,
    -5.793760388500106e-07,
    -2.8787129952776323e-06,
    2.620246106591733e-06,
)

# 27 terms for |eta| <= 1/2; left out: 7e-18 of the sum.
FORCE_6 = (
    0.07692307692307693,
    -0.07521367521367522,
    0.049941344058991206,
    -0.02574393080068438,
    0.012170950251422312,
    -0.006662061572848111,
    0.004527175302817523,
    -0.0034387372905335047,
    0.002738502067027686,
    -0.0022480795598313224,
    0.0018876629420880367,
    -0.0016131162561344098,
    0.0013982293078231107,
    -0.0012271226391611858,
    0.0010873919468373456,
    -0.00096278605784023,
    0.0008628698300837365,
    -0.0008450983600552932,
    0.0007890464544407428,
    -0.0003948881846542951,
    0.00029153784820312517,
    -0.001416701075155916,
    0.001483984414804968,
    0.001232631357862695,
    -0.0013877490619032074,
    -0.00218529545200974,
    0.002195843016695502,
)


def polynomial(coefficients: tuple[float, ...], v: float) -> float:
    """Evaluate a polynomial by Horner's rule, coefficients in rising order."""
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * v + coefficient
    return total


def kinematic_constant_gradient(
    D33: float, Dr33: float, nu: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Six components over (M/V) l_e^2 k_n and their slopes by D33, Dr33 and nu, every contact equally stiff.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    nu : float [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.
    C1111_D33 : float [-]
    C3333_D33 : float [-]
    C1122_D33 : float [-]
    C1133_D33 : float [-]
    C2323_D33 : float [-]
    C1212_D33 : float [-]
    C1111_Dr33 : float [-]
    C3333_Dr33 : float [-]
    C1122_Dr33 : float [-]
    C1133_Dr33 : float [-]
    C2323_Dr33 : float [-]
    C1212_Dr33 : float [-]
    C1111_nu : float [-]
    C3333_nu : float [-]
    C1122_nu : float [-]
    C1133_nu : float [-]
    C2323_nu : float [-]
    C1212_nu : float [-]

    Operations: 254.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    omega0 = e0*w0*w0
    omega0_D33 = -w0*w0/2
    omega0_Dr33 = -e0*w0
    omega1 = w0*(2*e0*w1 + e1*w0)
    omega1_D33 = w0*w0 - w0*w1
    omega1_Dr33 = 2*e0*w0 - e0*w1 - e1*w0
    omega2 = w1*(e0*w1 + 2*e1*w0)
    omega2_D33 = 2*w0*w1 - w1*w1/2
    omega2_Dr33 = 2*e0*w1 + 2*e1*w0 - e1*w1
    omega3 = e1*w1*w1
    omega3_D33 = w1*w1
    omega3_Dr33 = 2*e1*w1
    sum0 = 1280*omega0 + 128*omega1 + 48*omega2 + 40*omega3
    sum0_D33 = 1280*omega0_D33 + 128*omega1_D33 + 48*omega2_D33 + 40*omega3_D33
    sum0_Dr33 = 1280*omega0_Dr33 + 128*omega1_Dr33 + 48*omega2_Dr33 + 40*omega3_Dr33
    p0 = sum0/3465
    p0_D33 = sum0_D33/3465
    p0_Dr33 = sum0_Dr33/3465
    sum1 = 128*omega0 + 48*omega1 + 40*omega2 + 70*omega3
    sum1_D33 = 128*omega0_D33 + 48*omega1_D33 + 40*omega2_D33 + 70*omega3_D33
    sum1_Dr33 = 128*omega0_Dr33 + 48*omega1_Dr33 + 40*omega2_Dr33 + 70*omega3_Dr33
    p1 = sum1/3465
    p1_D33 = sum1_D33/3465
    p1_Dr33 = sum1_Dr33/3465
    sum2 = 48*omega0 + 40*omega1 + 70*omega2 + 315*omega3
    sum2_D33 = 48*omega0_D33 + 40*omega1_D33 + 70*omega2_D33 + 315*omega3_D33
    sum2_Dr33 = 48*omega0_Dr33 + 40*omega1_Dr33 + 70*omega2_Dr33 + 315*omega3_Dr33
    p2 = sum2/3465
    p2_D33 = sum2_D33/3465
    p2_Dr33 = sum2_Dr33/3465
    lam = 2*(1 - nu)/(2 - nu)
    lam_nu = -2/((2 - nu)**2)
    one_minus_lam = nu/(2 - nu)
    one_minus_lam_nu = 2/((2 - nu)**2)
    C1111 = lam*(p0/8 + p1/2) + 3*p0/8
    C1111_D33 = lam*p0_D33/8 + lam*p1_D33/2 + 3*p0_D33/8
    C1111_Dr33 = lam*p0_Dr33/8 + lam*p1_Dr33/2 + 3*p0_Dr33/8
    C1111_nu = lam_nu*(p0/8 + p1/2)
    C3333 = lam*p1 + p2
    C3333_D33 = lam*p1_D33 + p2_D33
    C3333_Dr33 = lam*p1_Dr33 + p2_Dr33
    C3333_nu = lam_nu*p1
    C1122 = one_minus_lam*p0/8
    C1122_D33 = one_minus_lam*p0_D33/8
    C1122_Dr33 = one_minus_lam*p0_Dr33/8
    C1122_nu = one_minus_lam_nu*p0/8
    C1133 = one_minus_lam*p1/2
    C1133_D33 = one_minus_lam*p1_D33/2
    C1133_Dr33 = one_minus_lam*p1_Dr33/2
    C1133_nu = one_minus_lam_nu*p1/2
    C2323 = lam*(p0/8 + 3*p1/8 + p2/4) + one_minus_lam*p1/2
    C2323_D33 = lam*p0_D33/8 + lam*p2_D33/4 + p1_D33*(3*lam/8 + one_minus_lam/2)
    C2323_Dr33 = lam*p0_Dr33/8 + lam*p2_Dr33/4 + p1_Dr33*(3*lam/8 + one_minus_lam/2)
    C2323_nu = lam_nu*(p0/8 + 3*p1/8 + p2/4) + one_minus_lam_nu*p1/2
    C1212 = lam*(p0/4 + p1/4) + one_minus_lam*p0/8
    C1212_D33 = lam*p1_D33/4 + p0_D33*(lam/4 + one_minus_lam/8)
    C1212_Dr33 = lam*p1_Dr33/4 + p0_Dr33*(lam/4 + one_minus_lam/8)
    C1212_nu = lam_nu*(p0/4 + p1/4) + one_minus_lam_nu*p0/8
    return C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33, C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu


def kinematic_kinetic_gradient(
    D33: float, Dr33: float, SR: float, nu: float, L0: float, L1: float, L2: float, L3: float, L4: float, L5: float, L6: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Six components over (M/V) l_e^2 k_n,ref and their slopes by D33, Dr33, SR and nu, no contact slipping.

    L0 ... L6 are the integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    SR : float [-]
        Stress ratio, principal stress along over across axis 3.
    nu : float [-]
        Poisson's ratio of the grain material.
    L0 : float [-]
    L1 : float [-]
    L2 : float [-]
    L3 : float [-]
    L4 : float [-]
    L5 : float [-]
    L6 : float [-]

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.
    C1111_D33 : float [-]
    C3333_D33 : float [-]
    C1122_D33 : float [-]
    C1133_D33 : float [-]
    C2323_D33 : float [-]
    C1212_D33 : float [-]
    C1111_Dr33 : float [-]
    C3333_Dr33 : float [-]
    C1122_Dr33 : float [-]
    C1133_Dr33 : float [-]
    C2323_Dr33 : float [-]
    C1212_Dr33 : float [-]
    C1111_SR : float [-]
    C3333_SR : float [-]
    C1122_SR : float [-]
    C1133_SR : float [-]
    C2323_SR : float [-]
    C1212_SR : float [-]
    C1111_nu : float [-]
    C3333_nu : float [-]
    C1122_nu : float [-]
    C1133_nu : float [-]
    C2323_nu : float [-]
    C1212_nu : float [-]

    Operations: 382.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    omega0 = e0*w0*w0
    omega0_D33 = -w0*w0/2
    omega0_Dr33 = -e0*w0
    omega1 = w0*(2*e0*w1 + e1*w0)
    omega1_D33 = w0*w0 - w0*w1
    omega1_Dr33 = 2*e0*w0 - e0*w1 - e1*w0
    omega2 = w1*(e0*w1 + 2*e1*w0)
    omega2_D33 = 2*w0*w1 - w1*w1/2
    omega2_Dr33 = 2*e0*w1 + 2*e1*w0 - e1*w1
    omega3 = e1*w1*w1
    omega3_D33 = w1*w1
    omega3_Dr33 = 2*e1*w1
    a = 15/((5 - D33)*(SR + 2))
    a_D33 = a/(5 - D33)
    a_SR = -a/(SR + 2)
    c = 15*SR/((2*D33 + 5)*(SR + 2))
    c_D33 = -2*c/((2*D33 + 5))
    c_SR = 2*c/(SR*(SR + 2))
    S0 = L0*omega0 + L1*omega1 + L2*omega2 + L3*omega3
    S0_D33 = L0*omega0_D33 + L1*omega1_D33 + L2*omega2_D33 + L3*omega3_D33
    S0_Dr33 = L0*omega0_Dr33 + L1*omega1_Dr33 + L2*omega2_Dr33 + L3*omega3_Dr33
    S1 = L1*omega0 + L2*omega1 + L3*omega2 + L4*omega3
    S1_D33 = L1*omega0_D33 + L2*omega1_D33 + L3*omega2_D33 + L4*omega3_D33
    S1_Dr33 = L1*omega0_Dr33 + L2*omega1_Dr33 + L3*omega2_Dr33 + L4*omega3_Dr33
    S2 = L2*omega0 + L3*omega1 + L4*omega2 + L5*omega3
    S2_D33 = L2*omega0_D33 + L3*omega1_D33 + L4*omega2_D33 + L5*omega3_D33
    S2_Dr33 = L2*omega0_Dr33 + L3*omega1_Dr33 + L4*omega2_Dr33 + L5*omega3_Dr33
    S3 = L3*omega0 + L4*omega1 + L5*omega2 + L6*omega3
    S3_D33 = L3*omega0_D33 + L4*omega1_D33 + L5*omega2_D33 + L6*omega3_D33
    S3_Dr33 = L3*omega0_Dr33 + L4*omega1_Dr33 + L5*omega2_Dr33 + L6*omega3_Dr33
    p0 = S0*a + S1*c
    p0_D33 = S0*a_D33/3 + S0_D33*a + S1*c_D33/3 + S1_D33*c
    p0_Dr33 = S0_Dr33*a + S1_Dr33*c
    p0_SR = S0*a_SR/3 + S1*c_SR/3
    p1 = S1*a + S2*c
    p1_D33 = S1*a_D33/3 + S1_D33*a + S2*c_D33/3 + S2_D33*c
    p1_Dr33 = S1_Dr33*a + S2_Dr33*c
    p1_SR = S1*a_SR/3 + S2*c_SR/3
    p2 = S2*a + S3*c
    p2_D33 = S2*a_D33/3 + S2_D33*a + S3*c_D33/3 + S3_D33*c
    p2_Dr33 = S2_Dr33*a + S3_Dr33*c
    p2_SR = S2*a_SR/3 + S3*c_SR/3
    lam = 2*(1 - nu)/(2 - nu)
    lam_nu = -2/((2 - nu)**2)
    one_minus_lam = nu/(2 - nu)
    one_minus_lam_nu = 2/((2 - nu)**2)
    C1111 = lam*(p0/8 + p1/2) + 3*p0/8
    C1111_D33 = lam*p0_D33/8 + lam*p1_D33/2 + 3*p0_D33/8
    C1111_Dr33 = lam*p0_Dr33/8 + lam*p1_Dr33/2 + 3*p0_Dr33/8
    C1111_SR = lam*p0_SR/8 + lam*p1_SR/2 + 3*p0_SR/8
    C1111_nu = lam_nu*(p0/8 + p1/2)
    C3333 = lam*p1 + p2
    C3333_D33 = lam*p1_D33 + p2_D33
    C3333_Dr33 = lam*p1_Dr33 + p2_Dr33
    C3333_SR = lam*p1_SR + p2_SR
    C3333_nu = lam_nu*p1
    C1122 = one_minus_lam*p0/8
    C1122_D33 = one_minus_lam*p0_D33/8
    C1122_Dr33 = one_minus_lam*p0_Dr33/8
    C1122_SR = one_minus_lam*p0_SR/8
    C1122_nu = one_minus_lam_nu*p0/8
    C1133 = one_minus_lam*p1/2
    C1133_D33 = one_minus_lam*p1_D33/2
    C1133_Dr33 = one_minus_lam*p1_Dr33/2
    C1133_SR = one_minus_lam*p1_SR/2
    C1133_nu = one_minus_lam_nu*p1/2
    C2323 = lam*(p0/8 + 3*p1/8 + p2/4) + one_minus_lam*p1/2
    C2323_D33 = lam*p0_D33/8 + lam*p2_D33/4 + p1_D33*(3*lam/8 + one_minus_lam/2)
    C2323_Dr33 = lam*p0_Dr33/8 + lam*p2_Dr33/4 + p1_Dr33*(3*lam/8 + one_minus_lam/2)
    C2323_SR = lam*p0_SR/8 + lam*p2_SR/4 + p1_SR*(3*lam/8 + one_minus_lam/2)
    C2323_nu = lam_nu*(p0/8 + 3*p1/8 + p2/4) + one_minus_lam_nu*p1/2
    C1212 = lam*(p0/4 + p1/4) + one_minus_lam*p0/8
    C1212_D33 = lam*p1_D33/4 + p0_D33*(lam/4 + one_minus_lam/8)
    C1212_Dr33 = lam*p1_Dr33/4 + p0_Dr33*(lam/4 + one_minus_lam/8)
    C1212_SR = lam*p1_SR/4 + p0_SR*(lam/4 + one_minus_lam/8)
    C1212_nu = lam_nu*(p0/4 + p1/4) + one_minus_lam_nu*p0/8
    return C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33, C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR, C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu


def static_constant_gradient(
    D33: float, Dr33: float, nu: float, H0: float, H1: float, H2: float, H3: float, H4: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Six static components over (M/V) l_e^2 k_n and their slopes by D33, Dr33 and nu, every contact equally stiff.

    H0 ... H4 are the integrals of s^(4-m) x^(2m) / W^3 over x from 0 to 1.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    nu : float [-]
        Poisson's ratio of the grain material.
    H0 : float [-]
    H1 : float [-]
    H2 : float [-]
    H3 : float [-]
    H4 : float [-]

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.
    C1111_D33 : float [-]
    C3333_D33 : float [-]
    C1122_D33 : float [-]
    C1133_D33 : float [-]
    C2323_D33 : float [-]
    C1212_D33 : float [-]
    C1111_Dr33 : float [-]
    C3333_Dr33 : float [-]
    C1122_Dr33 : float [-]
    C1133_Dr33 : float [-]
    C2323_Dr33 : float [-]
    C1212_Dr33 : float [-]
    C1111_nu : float [-]
    C3333_nu : float [-]
    C1122_nu : float [-]
    C1133_nu : float [-]
    C2323_nu : float [-]
    C1212_nu : float [-]

    Operations: 576.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    Y0 = H0*e0 + H1*e1
    Y0_D33 = -H0/2 + H1
    Y1 = H1*e0 + H2*e1
    Y1_D33 = -H1/2 + H2
    Y2 = H2*e0 + H3*e1
    Y2_D33 = -H2/2 + H3
    Y3 = H3*e0 + H4*e1
    Y3_D33 = -H3/2 + H4
    u0 = Y0*w0 + Y1*w1
    u0_D33 = Y0_D33*w0 + Y1_D33*w1
    u0_Dr33 = Y0 - 2*Y1
    u1 = Y1*w0 + Y2*w1
    u1_D33 = Y1_D33*w0 + Y2_D33*w1
    u1_Dr33 = Y1 - 2*Y2
    u2 = Y2*w0 + Y3*w1
    u2_D33 = Y2_D33*w0 + Y3_D33*w1
    u2_Dr33 = Y2 - 2*Y3
    lam = 2*(1 - nu)/(2 - nu)
    lam_nu = -2/((2 - nu)**2)
    one_minus_lam = nu/(2 - nu)
    one_minus_lam_nu = 2/((2 - nu)**2)
    v0 = u0/lam
    v0_D33 = u0_D33/lam
    v0_Dr33 = u0_Dr33/lam
    v0_nu = -lam_nu*u0/(lam*lam)
    v1 = u1/lam
    v1_D33 = u1_D33/lam
    v1_Dr33 = u1_Dr33/lam
    v1_nu = -lam_nu*u1/(lam*lam)
    v2 = u2/lam
    v2_D33 = u2_D33/lam
    v2_Dr33 = u2_Dr33/lam
    v2_nu = -lam_nu*u2/(lam*lam)
    g0 = one_minus_lam*v0
    g0_D33 = one_minus_lam*v0_D33
    g0_Dr33 = one_minus_lam*v0_Dr33
    g0_nu = one_minus_lam*v0_nu + one_minus_lam_nu*v0
    g1 = one_minus_lam*v1
    g1_D33 = one_minus_lam*v1_D33
    g1_Dr33 = one_minus_lam*v1_Dr33
    g1_nu = one_minus_lam*v1_nu + one_minus_lam_nu*v1
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    delta_D33 = g1_D33*u1 + u0_D33*(u2 + v1) + u1_D33*(g1 + v1) + u2_D33*(u0 + v1) + v1_D33*(u0 + u1 + u2)
    delta_Dr33 = g1_Dr33*u1 + u0_Dr33*(u2 + v1) + u1_Dr33*(g1 + v1) + u2_Dr33*(u0 + v1) + v1_Dr33*(u0 + u1 + u2)
    delta_nu = g1_nu*u1 + v1_nu*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    shear_sum_D33 = u0_D33 + v0_D33 + 2*v1_D33
    shear_sum_Dr33 = u0_Dr33 + v0_Dr33 + 2*v1_Dr33
    shear_sum_nu = v0_nu + 2*v1_nu
    eight_S2323 = (u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33) - 2*g1/(fifteen_N11*fifteen_N33) + (u1 + v0)/(fifteen_N11*fifteen_N11)
    eight_S2323_D33 = u1_D33*(fifteen_N33**-2 + fifteen_N11**-2) + v1_D33/(fifteen_N33*fifteen_N33) + 2*v2_D33/(fifteen_N33*fifteen_N33) - 4*(u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33*fifteen_N33) - 2*g1_D33/(fifteen_N11*fifteen_N33) + 4*g1/(fifteen_N11*fifteen_N33*fifteen_N33) + v0_D33/(fifteen_N11*fifteen_N11) - 2*g1/(fifteen_N11*fifteen_N11*fifteen_N33) + 2*(u1 + v0)/(fifteen_N11*fifteen_N11*fifteen_N11)
    eight_S2323_Dr33 = u1_Dr33*(fifteen_N33**-2 + fifteen_N11**-2) + v1_Dr33/(fifteen_N33*fifteen_N33) + 2*v2_Dr33/(fifteen_N33*fifteen_N33) - 2*g1_Dr33/(fifteen_N11*fifteen_N33) + v0_Dr33/(fifteen_N11*fifteen_N11)
    eight_S2323_nu = v1_nu/(fifteen_N33*fifteen_N33) + 2*v2_nu/(fifteen_N33*fifteen_N33) - 2*g1_nu/(fifteen_N11*fifteen_N33) + v0_nu/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11/(225*shear_sum)
    C1212_D33 = -2*fifteen_N11*fifteen_N11*shear_sum_D33/(225*shear_sum*shear_sum) - 4*fifteen_N11/(225*shear_sum)
    C1212_Dr33 = -2*fifteen_N11*fifteen_N11*shear_sum_Dr33/(225*shear_sum*shear_sum)
    C1212_nu = -2*fifteen_N11*fifteen_N11*shear_sum_nu/(225*shear_sum*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum)
    C1122_D33 = fifteen_N11*fifteen_N11*g0*u2_D33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_D33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_D33*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_D33/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_D33*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - 2*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum) - delta_D33*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1122_Dr33 = fifteen_N11*fifteen_N11*g0*u2_Dr33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_Dr33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_Dr33*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_Dr33/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_Dr33*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - delta_Dr33*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1122_nu = fifteen_N11*fifteen_N11*g0*v1_nu/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_nu*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_nu/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_nu*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - delta_nu*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C1111_D33 = C1122_D33 + 2*C1212_D33
    C1111_Dr33 = C1122_Dr33 + 2*C1212_Dr33
    C1111_nu = C1122_nu + 2*C1212_nu
    C3333 = fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta)
    C3333_D33 = fifteen_N33*fifteen_N33*u0_D33/(225*delta) + fifteen_N33*fifteen_N33*v1_D33/(225*delta) + 4*fifteen_N33*(u0 + v1)/(225*delta) - delta_D33*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C3333_Dr33 = fifteen_N33*fifteen_N33*u0_Dr33/(225*delta) + fifteen_N33*fifteen_N33*v1_Dr33/(225*delta) - delta_Dr33*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C3333_nu = fifteen_N33*fifteen_N33*v1_nu/(225*delta) - delta_nu*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C1133 = fifteen_N11*fifteen_N33*g1/(225*delta)
    C1133_D33 = fifteen_N11*fifteen_N33*g1_D33/(225*delta) + 2*fifteen_N11*g1/(225*delta) - fifteen_N33*g1/(225*delta) - delta_D33*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C1133_Dr33 = fifteen_N11*fifteen_N33*g1_Dr33/(225*delta) - delta_Dr33*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C1133_nu = fifteen_N11*fifteen_N33*g1_nu/(225*delta) - delta_nu*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C2323 = 2/(225*eight_S2323)
    C2323_D33 = -2*eight_S2323_D33/(225*eight_S2323*eight_S2323)
    C2323_Dr33 = -2*eight_S2323_Dr33/(225*eight_S2323*eight_S2323)
    C2323_nu = -2*eight_S2323_nu/(225*eight_S2323*eight_S2323)
    return C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33, C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu


def static_kinetic_gradient(
    D33: float, Dr33: float, SR: float, nu: float, T0: float, T1: float, T2: float, T3: float, T4: float, T5: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Six static components over (M/V) l_e^2 k_n,ref and their slopes by D33, Dr33, SR and nu, no contact slipping.

    T0 ... T5 are the integrals of s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3) over x from 0 to 1.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    SR : float [-]
        Stress ratio, principal stress along over across axis 3.
    nu : float [-]
        Poisson's ratio of the grain material.
    T0 : float [-]
    T1 : float [-]
    T2 : float [-]
    T3 : float [-]
    T4 : float [-]
    T5 : float [-]

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.
    C1111_D33 : float [-]
    C3333_D33 : float [-]
    C1122_D33 : float [-]
    C1133_D33 : float [-]
    C2323_D33 : float [-]
    C1212_D33 : float [-]
    C1111_Dr33 : float [-]
    C3333_Dr33 : float [-]
    C1122_Dr33 : float [-]
    C1133_Dr33 : float [-]
    C2323_Dr33 : float [-]
    C1212_Dr33 : float [-]
    C1111_SR : float [-]
    C3333_SR : float [-]
    C1122_SR : float [-]
    C1133_SR : float [-]
    C2323_SR : float [-]
    C1212_SR : float [-]
    C1111_nu : float [-]
    C3333_nu : float [-]
    C1122_nu : float [-]
    C1133_nu : float [-]
    C2323_nu : float [-]
    C1212_nu : float [-]

    Operations: 861.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    a = 15/((5 - D33)*(SR + 2))
    a_D33 = a/(5 - D33)
    a_SR = -a/(SR + 2)
    c = 15*SR/((2*D33 + 5)*(SR + 2))
    c_D33 = -2*c/((2*D33 + 5))
    c_SR = 2*c/(SR*(SR + 2))
    Z0 = T0*e0 + T1*e1
    Z0_D33 = -T0/2 + T1
    Z1 = T1*e0 + T2*e1
    Z1_D33 = -T1/2 + T2
    Z2 = T2*e0 + T3*e1
    Z2_D33 = -T2/2 + T3
    Z3 = T3*e0 + T4*e1
    Z3_D33 = -T3/2 + T4
    Z4 = T4*e0 + T5*e1
    Z4_D33 = -T4/2 + T5
    Y0 = Z0*a + Z1*c
    Y0_D33 = Z0_D33*a + Z1_D33*c
    Y1 = Z1*a + Z2*c
    Y1_D33 = Z1_D33*a + Z2_D33*c
    Y2 = Z2*a + Z3*c
    Y2_D33 = Z2_D33*a + Z3_D33*c
    Y3 = Z3*a + Z4*c
    Y3_D33 = Z3_D33*a + Z4_D33*c
    u0 = Y0*w0 + Y1*w1
    u0_D33 = Y0_D33*w0 + Y1_D33*w1 + a_D33*(-Z0*w0/3 - Z1*w1/3) + c_D33*(-Z1*w0/3 - Z2*w1/3)
    u0_Dr33 = Y0 - 2*Y1
    u0_SR = a_SR*(-Z0*w0/3 - Z1*w1/3) + c_SR*(-Z1*w0/3 - Z2*w1/3)
    u1 = Y1*w0 + Y2*w1
    u1_D33 = Y1_D33*w0 + Y2_D33*w1 + a_D33*(-Z1*w0/3 - Z2*w1/3) + c_D33*(-Z2*w0/3 - Z3*w1/3)
    u1_Dr33 = Y1 - 2*Y2
    u1_SR = a_SR*(-Z1*w0/3 - Z2*w1/3) + c_SR*(-Z2*w0/3 - Z3*w1/3)
    u2 = Y2*w0 + Y3*w1
    u2_D33 = Y2_D33*w0 + Y3_D33*w1 + a_D33*(-Z2*w0/3 - Z3*w1/3) + c_D33*(-Z3*w0/3 - Z4*w1/3)
    u2_Dr33 = Y2 - 2*Y3
    u2_SR = a_SR*(-Z2*w0/3 - Z3*w1/3) + c_SR*(-Z3*w0/3 - Z4*w1/3)
    lam = 2*(1 - nu)/(2 - nu)
    lam_nu = -2/((2 - nu)**2)
    one_minus_lam = nu/(2 - nu)
    one_minus_lam_nu = 2/((2 - nu)**2)
    v0 = u0/lam
    v0_D33 = u0_D33/lam
    v0_Dr33 = u0_Dr33/lam
    v0_SR = u0_SR/lam
    v0_nu = -lam_nu*u0/(lam*lam)
    v1 = u1/lam
    v1_D33 = u1_D33/lam
    v1_Dr33 = u1_Dr33/lam
    v1_SR = u1_SR/lam
    v1_nu = -lam_nu*u1/(lam*lam)
    v2 = u2/lam
    v2_D33 = u2_D33/lam
    v2_Dr33 = u2_Dr33/lam
    v2_SR = u2_SR/lam
    v2_nu = -lam_nu*u2/(lam*lam)
    g0 = one_minus_lam*v0
    g0_D33 = one_minus_lam*v0_D33
    g0_Dr33 = one_minus_lam*v0_Dr33
    g0_SR = one_minus_lam*v0_SR
    g0_nu = one_minus_lam*v0_nu + one_minus_lam_nu*v0
    g1 = one_minus_lam*v1
    g1_D33 = one_minus_lam*v1_D33
    g1_Dr33 = one_minus_lam*v1_Dr33
    g1_SR = one_minus_lam*v1_SR
    g1_nu = one_minus_lam*v1_nu + one_minus_lam_nu*v1
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    delta_D33 = g1_D33*u1 + u0_D33*(u2 + v1) + u1_D33*(g1 + v1) + u2_D33*(u0 + v1) + v1_D33*(u0 + u1 + u2)
    delta_Dr33 = g1_Dr33*u1 + u0_Dr33*(u2 + v1) + u1_Dr33*(g1 + v1) + u2_Dr33*(u0 + v1) + v1_Dr33*(u0 + u1 + u2)
    delta_SR = g1_SR*u1 + u0_SR*(u2 + v1) + u1_SR*(g1 + v1) + u2_SR*(u0 + v1) + v1_SR*(u0 + u1 + u2)
    delta_nu = g1_nu*u1 + v1_nu*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    shear_sum_D33 = u0_D33 + v0_D33 + 2*v1_D33
    shear_sum_Dr33 = u0_Dr33 + v0_Dr33 + 2*v1_Dr33
    shear_sum_SR = u0_SR + v0_SR + 2*v1_SR
    shear_sum_nu = v0_nu + 2*v1_nu
    eight_S2323 = (u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33) - 2*g1/(fifteen_N11*fifteen_N33) + (u1 + v0)/(fifteen_N11*fifteen_N11)
    eight_S2323_D33 = u1_D33*(fifteen_N33**-2 + fifteen_N11**-2) + v1_D33/(fifteen_N33*fifteen_N33) + 2*v2_D33/(fifteen_N33*fifteen_N33) - 4*(u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33*fifteen_N33) - 2*g1_D33/(fifteen_N11*fifteen_N33) + 4*g1/(fifteen_N11*fifteen_N33*fifteen_N33) + v0_D33/(fifteen_N11*fifteen_N11) - 2*g1/(fifteen_N11*fifteen_N11*fifteen_N33) + 2*(u1 + v0)/(fifteen_N11*fifteen_N11*fifteen_N11)
    eight_S2323_Dr33 = u1_Dr33*(fifteen_N33**-2 + fifteen_N11**-2) + v1_Dr33/(fifteen_N33*fifteen_N33) + 2*v2_Dr33/(fifteen_N33*fifteen_N33) - 2*g1_Dr33/(fifteen_N11*fifteen_N33) + v0_Dr33/(fifteen_N11*fifteen_N11)
    eight_S2323_SR = u1_SR*(fifteen_N33**-2 + fifteen_N11**-2) + v1_SR/(fifteen_N33*fifteen_N33) + 2*v2_SR/(fifteen_N33*fifteen_N33) - 2*g1_SR/(fifteen_N11*fifteen_N33) + v0_SR/(fifteen_N11*fifteen_N11)
    eight_S2323_nu = v1_nu/(fifteen_N33*fifteen_N33) + 2*v2_nu/(fifteen_N33*fifteen_N33) - 2*g1_nu/(fifteen_N11*fifteen_N33) + v0_nu/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11/(225*shear_sum)
    C1212_D33 = -2*fifteen_N11*fifteen_N11*shear_sum_D33/(225*shear_sum*shear_sum) - 4*fifteen_N11/(225*shear_sum)
    C1212_Dr33 = -2*fifteen_N11*fifteen_N11*shear_sum_Dr33/(225*shear_sum*shear_sum)
    C1212_SR = -2*fifteen_N11*fifteen_N11*shear_sum_SR/(225*shear_sum*shear_sum)
    C1212_nu = -2*fifteen_N11*fifteen_N11*shear_sum_nu/(225*shear_sum*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum)
    C1122_D33 = fifteen_N11*fifteen_N11*g0*u2_D33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_D33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_D33*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_D33/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_D33*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - 2*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum) - delta_D33*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1122_Dr33 = fifteen_N11*fifteen_N11*g0*u2_Dr33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_Dr33/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_Dr33*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_Dr33/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_Dr33*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - delta_Dr33*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1122_SR = fifteen_N11*fifteen_N11*g0*u2_SR/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_SR/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_SR*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_SR/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_SR*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - delta_SR*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1122_nu = fifteen_N11*fifteen_N11*g0*v1_nu/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_nu*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_nu/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_nu*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) - delta_nu*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C1111_D33 = C1122_D33 + 2*C1212_D33
    C1111_Dr33 = C1122_Dr33 + 2*C1212_Dr33
    C1111_SR = C1122_SR + 2*C1212_SR
    C1111_nu = C1122_nu + 2*C1212_nu
    C3333 = fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta)
    C3333_D33 = fifteen_N33*fifteen_N33*u0_D33/(225*delta) + fifteen_N33*fifteen_N33*v1_D33/(225*delta) + 4*fifteen_N33*(u0 + v1)/(225*delta) - delta_D33*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C3333_Dr33 = fifteen_N33*fifteen_N33*u0_Dr33/(225*delta) + fifteen_N33*fifteen_N33*v1_Dr33/(225*delta) - delta_Dr33*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C3333_SR = fifteen_N33*fifteen_N33*u0_SR/(225*delta) + fifteen_N33*fifteen_N33*v1_SR/(225*delta) - delta_SR*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C3333_nu = fifteen_N33*fifteen_N33*v1_nu/(225*delta) - delta_nu*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C1133 = fifteen_N11*fifteen_N33*g1/(225*delta)
    C1133_D33 = fifteen_N11*fifteen_N33*g1_D33/(225*delta) + 2*fifteen_N11*g1/(225*delta) - fifteen_N33*g1/(225*delta) - delta_D33*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C1133_Dr33 = fifteen_N11*fifteen_N33*g1_Dr33/(225*delta) - delta_Dr33*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C1133_SR = fifteen_N11*fifteen_N33*g1_SR/(225*delta) - delta_SR*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C1133_nu = fifteen_N11*fifteen_N33*g1_nu/(225*delta) - delta_nu*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C2323 = 2/(225*eight_S2323)
    C2323_D33 = -2*eight_S2323_D33/(225*eight_S2323*eight_S2323)
    C2323_Dr33 = -2*eight_S2323_Dr33/(225*eight_S2323*eight_S2323)
    C2323_SR = -2*eight_S2323_SR/(225*eight_S2323*eight_S2323)
    C2323_nu = -2*eight_S2323_nu/(225*eight_S2323*eight_S2323)
    return C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33, C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR, C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu


def static_slope(
    u0: float, u1: float, u2: float, v0: float, v1: float, v2: float, g0: float, g1: float, D33: float, u0_t: float, u1_t: float, u2_t: float, v0_t: float, v1_t: float, v2_t: float, g0_t: float, g1_t: float, D33_t: float,
) -> tuple[float, float, float, float, float, float]:
    """Slope of the six static components along a direction in which flexibilities and fabric change.

    A name that ends in _t is the slope of that quantity along the direction.

    Parameters
    ----------
    u0 : float [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : float [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : float [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    v0 : float [-]
        Moment of the tangential flexibility with the fourth power of the sine.
    v1 : float [-]
        Moment of the tangential flexibility with squared sine and squared cosine.
    v2 : float [-]
        Moment of the tangential flexibility with the fourth power of the cosine.
    g0 : float [-]
        Tangential less normal flexibility, moment with the fourth power of the sine.
    g1 : float [-]
        Tangential less normal flexibility, moment with squared sine and cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    u0_t : float [-]
    u1_t : float [-]
    u2_t : float [-]
    v0_t : float [-]
    v1_t : float [-]
    v2_t : float [-]
    g0_t : float [-]
    g1_t : float [-]
    D33_t : float [-]

    Returns
    -------
    C1111_t : float [-]
    C3333_t : float [-]
    C1122_t : float [-]
    C1133_t : float [-]
    C2323_t : float [-]
    C1212_t : float [-]

    Operations: 248.
    """
    fifteen_N11 = 5 - D33
    fifteen_N11_t = -D33_t
    fifteen_N33 = 2*D33 + 5
    fifteen_N33_t = 2*D33_t
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    delta_t = g1_t*u1 + u0_t*(u2 + v1) + u1_t*(g1 + v1) + u2_t*(u0 + v1) + v1_t*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    shear_sum_t = u0_t + v0_t + 2*v1_t
    eight_S2323 = (u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33) - 2*g1/(fifteen_N11*fifteen_N33) + (u1 + v0)/(fifteen_N11*fifteen_N11)
    eight_S2323_t = fifteen_N11_t*(2*g1/(fifteen_N11*fifteen_N11*fifteen_N33) - 2*(u1 + v0)/(fifteen_N11*fifteen_N11*fifteen_N11)) + fifteen_N33_t*(-2*(u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33*fifteen_N33) + 2*g1/(fifteen_N11*fifteen_N33*fifteen_N33)) + u1_t*(fifteen_N33**-2 + fifteen_N11**-2) + v1_t/(fifteen_N33*fifteen_N33) + 2*v2_t/(fifteen_N33*fifteen_N33) - 2*g1_t/(fifteen_N11*fifteen_N33) + v0_t/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11/(225*shear_sum)
    C1212_t = -2*fifteen_N11*fifteen_N11*shear_sum_t/(225*shear_sum*shear_sum) + 4*fifteen_N11*fifteen_N11_t/(225*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum)
    C1122_t = fifteen_N11*fifteen_N11*g0*u2_t/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0*v1_t/(225*delta*shear_sum) + fifteen_N11*fifteen_N11*g0_t*(u2 + v1)/(225*delta*shear_sum) + 4*fifteen_N11*fifteen_N11*g1*g1_t/(225*delta*shear_sum) - fifteen_N11*fifteen_N11*shear_sum_t*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum*shear_sum) + 2*fifteen_N11*fifteen_N11_t*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum) - delta_t*fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C1111_t = C1122_t + 2*C1212_t
    C3333 = fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta)
    C3333_t = fifteen_N33*fifteen_N33*u0_t/(225*delta) + fifteen_N33*fifteen_N33*v1_t/(225*delta) + 2*fifteen_N33*fifteen_N33_t*(u0 + v1)/(225*delta) - delta_t*fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta*delta)
    C1133 = fifteen_N11*fifteen_N33*g1/(225*delta)
    C1133_t = fifteen_N11*fifteen_N33*g1_t/(225*delta) + fifteen_N11*fifteen_N33_t*g1/(225*delta) + fifteen_N11_t*fifteen_N33*g1/(225*delta) - delta_t*fifteen_N11*fifteen_N33*g1/(225*delta*delta)
    C2323 = 2/(225*eight_S2323)
    C2323_t = -2*eight_S2323_t/(225*eight_S2323*eight_S2323)
    return C1111_t, C3333_t, C1122_t, C1133_t, C2323_t, C1212_t


def normal_moments(
    D33: float, Dr33: float, SR: float, L0: float, L1: float, L2: float, L3: float, L4: float, L5: float, L6: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float]:
    """Moments of E W^2 k_n over k_n,ref and their slopes by D33, Dr33 and SR.

    L0 ... L6 are the integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    SR : float [-]
        Stress ratio, principal stress along over across axis 3.
    L0 : float [-]
    L1 : float [-]
    L2 : float [-]
    L3 : float [-]
    L4 : float [-]
    L5 : float [-]
    L6 : float [-]

    Returns
    -------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    p0_D33 : float [-]
    p1_D33 : float [-]
    p2_D33 : float [-]
    p0_Dr33 : float [-]
    p1_Dr33 : float [-]
    p2_Dr33 : float [-]
    p0_SR : float [-]
    p1_SR : float [-]
    p2_SR : float [-]

    Operations: 217.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    omega0 = e0*w0*w0
    omega0_D33 = -w0*w0/2
    omega0_Dr33 = -e0*w0
    omega1 = w0*(2*e0*w1 + e1*w0)
    omega1_D33 = w0*w0 - w0*w1
    omega1_Dr33 = 2*e0*w0 - e0*w1 - e1*w0
    omega2 = w1*(e0*w1 + 2*e1*w0)
    omega2_D33 = 2*w0*w1 - w1*w1/2
    omega2_Dr33 = 2*e0*w1 + 2*e1*w0 - e1*w1
    omega3 = e1*w1*w1
    omega3_D33 = w1*w1
    omega3_Dr33 = 2*e1*w1
    a = 15/((5 - D33)*(SR + 2))
    a_D33 = a/(5 - D33)
    a_SR = -a/(SR + 2)
    c = 15*SR/((2*D33 + 5)*(SR + 2))
    c_D33 = -2*c/((2*D33 + 5))
    c_SR = 2*c/(SR*(SR + 2))
    S0 = L0*omega0 + L1*omega1 + L2*omega2 + L3*omega3
    S0_D33 = L0*omega0_D33 + L1*omega1_D33 + L2*omega2_D33 + L3*omega3_D33
    S0_Dr33 = L0*omega0_Dr33 + L1*omega1_Dr33 + L2*omega2_Dr33 + L3*omega3_Dr33
    S1 = L1*omega0 + L2*omega1 + L3*omega2 + L4*omega3
    S1_D33 = L1*omega0_D33 + L2*omega1_D33 + L3*omega2_D33 + L4*omega3_D33
    S1_Dr33 = L1*omega0_Dr33 + L2*omega1_Dr33 + L3*omega2_Dr33 + L4*omega3_Dr33
    S2 = L2*omega0 + L3*omega1 + L4*omega2 + L5*omega3
    S2_D33 = L2*omega0_D33 + L3*omega1_D33 + L4*omega2_D33 + L5*omega3_D33
    S2_Dr33 = L2*omega0_Dr33 + L3*omega1_Dr33 + L4*omega2_Dr33 + L5*omega3_Dr33
    S3 = L3*omega0 + L4*omega1 + L5*omega2 + L6*omega3
    S3_D33 = L3*omega0_D33 + L4*omega1_D33 + L5*omega2_D33 + L6*omega3_D33
    S3_Dr33 = L3*omega0_Dr33 + L4*omega1_Dr33 + L5*omega2_Dr33 + L6*omega3_Dr33
    p0 = S0*a + S1*c
    p0_D33 = S0*a_D33/3 + S0_D33*a + S1*c_D33/3 + S1_D33*c
    p0_Dr33 = S0_Dr33*a + S1_Dr33*c
    p0_SR = S0*a_SR/3 + S1*c_SR/3
    p1 = S1*a + S2*c
    p1_D33 = S1*a_D33/3 + S1_D33*a + S2*c_D33/3 + S2_D33*c
    p1_Dr33 = S1_Dr33*a + S2_Dr33*c
    p1_SR = S1*a_SR/3 + S2*c_SR/3
    p2 = S2*a + S3*c
    p2_D33 = S2*a_D33/3 + S2_D33*a + S3*c_D33/3 + S3_D33*c
    p2_Dr33 = S2_Dr33*a + S3_Dr33*c
    p2_SR = S2*a_SR/3 + S3*c_SR/3
    return p0, p1, p2, p0_D33, p1_D33, p2_D33, p0_Dr33, p1_Dr33, p2_Dr33, p0_SR, p1_SR, p2_SR


def soft_moments(
    D33: float, Dr33: float, SR: float, T0: float, T1: float, T2: float, T3: float, T4: float, T5: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float]:
    """Moments of E W^-2/k_n times k_n,ref and their slopes by D33, Dr33 and SR.

    T0 ... T5 are the integrals of s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3) over x from 0 to 1.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    SR : float [-]
        Stress ratio, principal stress along over across axis 3.
    T0 : float [-]
    T1 : float [-]
    T2 : float [-]
    T3 : float [-]
    T4 : float [-]
    T5 : float [-]

    Returns
    -------
    u0 : float [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : float [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : float [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    u0_D33 : float [-]
    u1_D33 : float [-]
    u2_D33 : float [-]
    u0_Dr33 : float [-]
    u1_Dr33 : float [-]
    u2_Dr33 : float [-]
    u0_SR : float [-]
    u1_SR : float [-]
    u2_SR : float [-]

    Operations: 196.
    """
    e0 = 1 - D33/2
    e1 = D33 + 1
    w0 = 1 - Dr33/2
    w1 = Dr33 + 1
    a = 15/((5 - D33)*(SR + 2))
    a_D33 = a/(5 - D33)
    a_SR = -a/(SR + 2)
    c = 15*SR/((2*D33 + 5)*(SR + 2))
    c_D33 = -2*c/((2*D33 + 5))
    c_SR = 2*c/(SR*(SR + 2))
    Z0 = T0*e0 + T1*e1
    Z0_D33 = -T0/2 + T1
    Z1 = T1*e0 + T2*e1
    Z1_D33 = -T1/2 + T2
    Z2 = T2*e0 + T3*e1
    Z2_D33 = -T2/2 + T3
    Z3 = T3*e0 + T4*e1
    Z3_D33 = -T3/2 + T4
    Z4 = T4*e0 + T5*e1
    Z4_D33 = -T4/2 + T5
    Y0 = Z0*a + Z1*c
    Y0_D33 = Z0_D33*a + Z1_D33*c
    Y1 = Z1*a + Z2*c
    Y1_D33 = Z1_D33*a + Z2_D33*c
    Y2 = Z2*a + Z3*c
    Y2_D33 = Z2_D33*a + Z3_D33*c
    Y3 = Z3*a + Z4*c
    Y3_D33 = Z3_D33*a + Z4_D33*c
    u0 = Y0*w0 + Y1*w1
    u0_D33 = Y0_D33*w0 + Y1_D33*w1 + a_D33*(-Z0*w0/3 - Z1*w1/3) + c_D33*(-Z1*w0/3 - Z2*w1/3)
    u0_Dr33 = Y0 - 2*Y1
    u0_SR = a_SR*(-Z0*w0/3 - Z1*w1/3) + c_SR*(-Z1*w0/3 - Z2*w1/3)
    u1 = Y1*w0 + Y2*w1
    u1_D33 = Y1_D33*w0 + Y2_D33*w1 + a_D33*(-Z1*w0/3 - Z2*w1/3) + c_D33*(-Z2*w0/3 - Z3*w1/3)
    u1_Dr33 = Y1 - 2*Y2
    u1_SR = a_SR*(-Z1*w0/3 - Z2*w1/3) + c_SR*(-Z2*w0/3 - Z3*w1/3)
    u2 = Y2*w0 + Y3*w1
    u2_D33 = Y2_D33*w0 + Y3_D33*w1 + a_D33*(-Z2*w0/3 - Z3*w1/3) + c_D33*(-Z3*w0/3 - Z4*w1/3)
    u2_Dr33 = Y2 - 2*Y3
    u2_SR = a_SR*(-Z2*w0/3 - Z3*w1/3) + c_SR*(-Z3*w0/3 - Z4*w1/3)
    return u0, u1, u2, u0_D33, u1_D33, u2_D33, u0_Dr33, u1_Dr33, u2_Dr33, u0_SR, u1_SR, u2_SR


def shear_slopes(
    D33: float, SR: float, mu: float, a: float, c: float, d: float, side: float, Q0: float, Q1: float, Q2: float, Q3: float, R0: float, R1: float, R2: float,
) -> tuple[float, float, float, float, float, float, float, float, float]:
    """Slopes of the moments of k_r/lambda_0 by D33 and SR through the forces, and by mu.

    Q0 ... Q3 are <w s^(3-k) x^(2k)>, R0 ... R2 are <w s^(2-k) x^(2k) x sqrt(s)>, both with w = E W^2
    h^(-2/3)/3 over the contacts that stick; side is the sign of d = c - a. For flexibilities 1/(k_r/lambda_0)
    take w = -E W^-2 h^(-4/3)/3.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    SR : float [-]
        Stress ratio, principal stress along over across axis 3.
    mu : float [-]
        Friction coefficient between grains.
    a : float [-]
        Normal contact force at the equator, 1 when all is isotropic.
    c : float [-]
        Normal contact force at the pole, 1 when all is isotropic.
    d : float [-]
        Normal contact force at the pole less that at the equator.
    side : float [-]
    Q0 : float [-]
    Q1 : float [-]
    Q2 : float [-]
    Q3 : float [-]
    R0 : float [-]
    R1 : float [-]
    R2 : float [-]

    Returns
    -------
    q0_D33 : float [-]
    q0_SR : float [-]
    q0_mu : float [-]
    q1_D33 : float [-]
    q1_SR : float [-]
    q1_mu : float [-]
    q2_D33 : float [-]
    q2_SR : float [-]
    q2_mu : float [-]

    Operations: 102.
    """
    q0_D33 = a*(Q0 + R0*side/mu)/(5 - D33) - 2*c*(Q1 - R0*side/mu)/((2*D33 + 5))
    q0_SR = -a*(Q0 + R0*side/mu)/(SR + 2) + 2*c*(Q1 - R0*side/mu)/(SR*(SR + 2))
    q0_mu = R0*d*side/(mu*mu)
    q1_D33 = a*(Q1 + R1*side/mu)/(5 - D33) - 2*c*(Q2 - R1*side/mu)/((2*D33 + 5))
    q1_SR = -a*(Q1 + R1*side/mu)/(SR + 2) + 2*c*(Q2 - R1*side/mu)/(SR*(SR + 2))
    q1_mu = R1*d*side/(mu*mu)
    q2_D33 = a*(Q2 + R2*side/mu)/(5 - D33) - 2*c*(Q3 - R2*side/mu)/((2*D33 + 5))
    q2_SR = -a*(Q2 + R2*side/mu)/(SR + 2) + 2*c*(Q3 - R2*side/mu)/(SR*(SR + 2))
    q2_mu = R2*d*side/(mu*mu)
    return q0_D33, q0_SR, q0_mu, q1_D33, q1_SR, q1_mu, q2_D33, q2_SR, q2_mu


def reference_slopes(
    void_ratio: float, coordination: float, nu: float, coordination_by_void_ratio: float,
) -> tuple[float, float, float]:
    """Slopes of the logarithm of (M/V) l_e^2 k_n,ref by void ratio, coordination number and nu.

    coordination_by_void_ratio is dN/de where N follows from e, and 0 where N is given.

    Parameters
    ----------
    void_ratio : float [-]
        Volume of voids over volume of solids.
    coordination : float [-]
        Mean number of contacts of a grain.
    nu : float [-]
        Poisson's ratio of the grain material.
    coordination_by_void_ratio : float [-]

    Returns
    -------
    log_reference_void_ratio : float [-]
    log_reference_coordination : float [-]
    log_reference_nu : float [-]

    Operations: 10.
    """
    log_reference_coordination = 2/(3*coordination)
    log_reference_void_ratio = coordination_by_void_ratio*log_reference_coordination - 2/(3*(void_ratio + 1))
    log_reference_nu = 2/(3*(1 - nu))
    return log_reference_void_ratio, log_reference_coordination, log_reference_nu


def force_moments(a: float, c: float, d: float) -> tuple[float, float, float, float, float, float, float]:
    """Integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1, m = 0 ... 6.

    The series hold for 1/9 <= c/a <= 9. The difference d = c - a is an argument of its own.

    Parameters
    ----------
    a : float [-]
        Normal contact force at the equator, 1 when all is isotropic.
    c : float [-]
        Normal contact force at the pole, 1 when all is isotropic.
    d : float [-]
        Normal contact force at the pole less that at the equator.

    Returns
    -------
    L0 : float [-]
    L1 : float [-]
    L2 : float [-]
    L3 : float [-]
    L4 : float [-]
    L5 : float [-]
    L6 : float [-]

    Operations: 359.
    """
    both = a*c
    square = a + 2*sqrt(both) + c
    eta = d/square
    mean_square = square/4
    first = cbrt(mean_square)
    correction = -first + mean_square/(first*first)
    root = correction/3 + first
    scale = root**-2
    L0 = scale*polynomial(FORCE_0, eta)
    L1 = scale*polynomial(FORCE_1, eta)
    L2 = scale*polynomial(FORCE_2, eta)
    L3 = scale*polynomial(FORCE_3, eta)
    L4 = scale*polynomial(FORCE_4, eta)
    L5 = scale*polynomial(FORCE_5, eta)
    L6 = scale*polynomial(FORCE_6, eta)
    return L0, L1, L2, L3, L4, L5, L6
