"""Slopes of the stiffness: blocks of elements at once.

Emitted by ``derivations write`` from the derivation ``gradients``; do not edit.
Source: (7), (20), (21), (23), Figure 1(b) of Pan & Dong (1999).
Domain: constant_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5; kinetic_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, equator_part <= 9*pole_part, pole_part <= 6*equator_part.
Operations: 785 (316 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

START = np.array([
    [-0.09765625],
    [0.3876953125],
    [-0.45849609375],
    [0.186279296875],
    [-0.23828125],
    [1.0],
])

BINOMIAL = np.array([
    [0.11095869532083524],
    [0.12482853223593965],
    [0.1440329218106996],
    [0.1728395061728395],
    [0.2222222222222222],
    [0.3333333333333333],
])

SOFT = np.array([
    [498.2025285515298, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [820.7933278818413, 0.0, -3.185153929846088, 1.5459178636473552, 0.0, -3.1466403407951056, 0.0],
    [645.9569903342167, 2.818519599421114, -0.9498779498028835, -2.622519298964307, 4.200302941088526, -4.445570227381617, 0.0],
    [525.9884549944857, -4.117024921851465, 7.520151919381473, -5.538159449690905, 0.8168191875213652, 5.707596401977305, -8.631238100584213],
    [587.096195817639, -10.768883332718913, 3.0412733728570065, 5.088604488947386, -9.481723578829216, 8.618815209371748, -0.2538817780095012],
    [624.5847541569365, 5.962657387992461, -12.709473831086397, 10.265133583155906, -1.1040504919166811, -10.880499106638531, 19.831040887128975],
    [603.8637369097783, 21.712802960907393, -7.05950813523337, -7.874974923013812, 15.871808595613848, -12.329360580329318, -4.6219412457033044],
    [620.7771342799351, -3.73597343499998, 18.993899883496553, -16.283449286785853, 0.20196307795977816, 20.388119992119535, -33.57047253012832],
    [709.2874919184154, -36.704845603520766, 14.322272794473227, 11.097681983532915, -23.91980839832898, 14.261996330735153, 20.034753317825693],
    [763.7157342164453, -6.603302372324879, -25.14413326859875, 23.70886164632967, 2.610756601424082, -34.926493645159816, 47.531892048629004],
    [694.8324301311233, 53.965598134553545, -25.76224981786642, -14.085631969118571, 32.699512940850646, -10.474966344984844, -53.15704375295891],
    [630.1894415548753, 31.9155035587408, 27.928993440111345, -31.449377839742887, -8.13288285121476, 52.6704426452616, -49.40155795042603],
    [770.3916420191198, -62.96017405818026, 40.382250954952866, 15.67567241905213, -39.553670529445974, -4.587563200621134, 107.35574633544685],
    [1027.7197225366012, -74.5109331177692, -22.786980601461522, 37.27703093764248, 16.210373574912754, -65.96942940019497, 12.07435529573402],
    [1059.536734680609, 43.57179376538123, -53.20986552574466, -14.768371766096525, 40.76788151104653, 33.41905728806474, -163.2453315544091],
    [780.6479510141401, 119.82280757145125, 7.239126865414743, -38.60208537431418, -24.52115653486248, 60.38790879168576, 96.83853584187563],
    [606.9475478586938, 25.68561873592048, 55.5426102140571, 11.244085030950812, -33.97330627248665, -65.68375493118958, 147.95334293967846],
    [971.8123362697286, -115.73549257740811, 13.565134555866706, 34.18591728183356, 28.892593474743464, -25.108359133178784, -255.66682543546608],
    [1728.8586171312295, -114.86163372235002, -41.90458045566291, -6.45741049456395, 21.178375803756264, 73.84424863062569, 57.28697308876897],
    [2247.2398190045274, 17.375565610859113, -27.22171945701363, -25.701357466063186, -26.606334841629277, -21.85520361990936, 256.0859728506816],
    [2047.9999999999998, 118.1538461538462, 19.69230769230769, 2.461538461538464, -8.615384615384606, -45.230769230769226, -390.92307692307685],
    [1181.5384615384614, 98.46153846153847, 29.53846153846154, 18.46153846153846, 21.53846153846154, 48.46153846153846, 266.53846153846155],
])


def polynomials(table: Array, v: Array) -> Array:
    """Evaluate polynomials by Horner's rule for every element at once, a row of the result for each.

    Parameters
    ----------
    table : (terms, rows) array [-]
        Coefficients, highest power first.
    v : (n,) array [-]
        Variable.

    Returns
    -------
    total : (rows, n) array [-]
        Values.
    """
    total = np.zeros((table.shape[1], v.size))
    for coefficients in table:
        total *= v
        total += coefficients[:, np.newaxis]
    return total


def constant_rows(D33: Array, Dr33: Array, nu: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n and their slopes, for contacts that are equally stiff.

    Slopes by D33, Dr33, SR, mu and nu, six each; those by SR and mu are zero.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (36 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33,
        C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR,
        C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_mu, C3333_mu, C1122_mu, C1133_mu, C2323_mu, C1212_mu,
        C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu of each element in turn, NaN for those that
        are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 146.
    """
    rows = out.reshape(-1, 36)
    with np.errstate(all="ignore"):  # what is not served may be anything
        complement = 2 - nu
        over_complement = 1/complement
        zero0 = 11/4
        zero1 = 11
        zero2 = -11/2
        zero3 = -11/5
        zero4 = -11/8
        rate0 = -16/3465
        rate1 = -1/6930
        rate2 = 1/6930
        rate3 = 5/11088
        rate4 = 1/396
        shifted0 = D33 - zero0
        shifted1 = D33 - zero1
        shifted2 = D33 - zero2
        shifted3 = D33 - zero3
        shifted4 = D33 - zero4
        density0 = rate0*shifted0
        density1 = rate1*shifted1
        density2 = rate2*shifted2
        density3 = rate3*shifted3
        density4 = rate4*shifted4
        w0 = 2 - Dr33
        half_w1 = Dr33 + 1
        twice_w1 = 4*half_w1
        square0 = w0*w0
        square0_Dr33 = -2*w0
        square1 = twice_w1*w0
        square1_Dr33 = -twice_w1 + 4*w0
        square2 = half_w1*twice_w1
        square2_Dr33 = 4*half_w1 + twice_w1
        sum0 = density0*square0 + density1*square1 + density2*square2
        sum0_D33 = rate0*square0 + rate1*square1 + rate2*square2
        sum0_Dr33 = density0*square0_Dr33 + density1*square1_Dr33 + density2*square2_Dr33
        sum1 = density1*square0 + density2*square1 + density3*square2
        sum1_D33 = rate1*square0 + rate2*square1 + rate3*square2
        sum1_Dr33 = density1*square0_Dr33 + density2*square1_Dr33 + density3*square2_Dr33
        sum2 = density2*square0 + density3*square1 + density4*square2
        sum2_D33 = rate2*square0 + rate3*square1 + rate4*square2
        sum2_Dr33 = density2*square0_Dr33 + density3*square1_Dr33 + density4*square2_Dr33
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5)
        one_minus_lam = np.where(served, nu*over_complement, np.nan)
        one_minus_lam_nu = 2*over_complement*over_complement
        lam = 1 - one_minus_lam
        lam_nu = -one_minus_lam_nu
        four_r1 = 4*sum1
        four_r1_D33 = 4*sum1_D33
        four_r1_Dr33 = 4*sum1_Dr33
        both = sum0 + sum1
        both_D33 = sum0_D33 + sum1_D33
        both_Dr33 = sum0_Dr33 + sum1_Dr33
        later = sum1 + sum2
        later_D33 = sum1_D33 + sum2_D33
        later_Dr33 = sum1_Dr33 + sum2_Dr33
        along = lam*sum1 + sum2
        along_D33 = lam*sum1_D33 + sum2_D33
        along_Dr33 = lam*sum1_Dr33 + sum2_Dr33
        along_nu = lam_nu*sum1
        rows[:, 0] = lam*(four_r1 + sum0) + 3*sum0
        rows[:, 6] = four_r1_D33*lam + sum0_D33*(lam + 3)
        rows[:, 12] = four_r1_Dr33*lam + sum0_Dr33*(lam + 3)
        rows[:, 30] = lam_nu*(four_r1 + sum0)
        rows[:, 1] = 8*along
        rows[:, 7] = 8*along_D33
        rows[:, 13] = 8*along_Dr33
        rows[:, 31] = 8*along_nu
        rows[:, 2] = one_minus_lam*sum0
        C1122 = rows[:, 2]
        rows[:, 8] = one_minus_lam*sum0_D33
        C1122_D33 = rows[:, 8]
        rows[:, 14] = one_minus_lam*sum0_Dr33
        C1122_Dr33 = rows[:, 14]
        rows[:, 32] = one_minus_lam_nu*sum0
        C1122_nu = rows[:, 32]
        rows[:, 3] = four_r1*one_minus_lam
        C1133 = rows[:, 3]
        rows[:, 9] = four_r1_D33*one_minus_lam
        C1133_D33 = rows[:, 9]
        rows[:, 15] = four_r1_Dr33*one_minus_lam
        C1133_Dr33 = rows[:, 15]
        rows[:, 33] = four_r1*one_minus_lam_nu
        C1133_nu = rows[:, 33]
        rows[:, 4] = C1133 + lam*(both + 2*later)
        rows[:, 10] = C1133_D33 + both_D33*lam + 2*lam*later_D33
        rows[:, 16] = C1133_Dr33 + both_Dr33*lam + 2*lam*later_Dr33
        rows[:, 34] = C1133_nu + lam_nu*(both + 2*later)
        rows[:, 5] = C1122 + 2*both*lam
        rows[:, 11] = C1122_D33 + 2*both_D33*lam
        rows[:, 17] = C1122_Dr33 + 2*both_Dr33*lam
        rows[:, 35] = C1122_nu + 2*both*lam_nu
        rows[:, 18] = 0
        rows[:, 19] = 0
        rows[:, 20] = 0
        rows[:, 21] = 0
        rows[:, 22] = 0
        rows[:, 23] = 0
        rows[:, 24] = 0
        rows[:, 25] = 0
        rows[:, 26] = 0
        rows[:, 27] = 0
        rows[:, 28] = 0
        rows[:, 29] = 0
    return int(served.size - np.count_nonzero(served))


def kinetic_rows(D33: Array, Dr33: Array, SR: Array, nu: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n,ref and their slopes, when contacts follow their force without slip.

    Slopes by D33, Dr33, SR, mu and nu, six each; those by mu are zero. Served for 1/9 <= c/a <= 6 with a and
    c the normal forces at equator and pole.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    SR : (n,) array [-]
        Stress ratio, principal stress along over across axis 3.
    nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (36 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33,
        C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR,
        C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_mu, C3333_mu, C1122_mu, C1133_mu, C2323_mu, C1212_mu,
        C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu of each element in turn, NaN for those that
        are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 639.
    """
    rows = out.reshape(-1, 36)
    with np.errstate(all="ignore"):  # what is not served may be anything
        third = 1/3
        fifteenth = 1/15
        unit = 1/55440
        equator_part = 2*D33 + 5
        pole_part = SR*(5 - D33)
        forces = 15/(equator_part*(5 - D33)*(SR + 2))
        a = equator_part*forces
        c = forces*pole_part
        less_a = a - 1
        less_c = c - 1
        start_a, = polynomials(START, less_a)
        start_c, = polynomials(START, less_c)
        squared_a = start_a*start_a
        squared_c = start_c*start_c
        rest_a = -a*squared_a*start_a + 1
        rest_c = -c*squared_c*start_c + 1
        gain_a, = polynomials(BINOMIAL, rest_a)
        gain_c, = polynomials(BINOMIAL, rest_c)
        inverse_a = gain_a*rest_a*start_a + start_a
        inverse_c = gain_c*rest_c*start_c + start_c
        square_a = inverse_a*inverse_a
        square_c = inverse_c*inverse_c
        near_a = a*square_a
        near_c = c*square_c
        root_a = near_a + square_a*third*(a - near_a*near_a*near_a)
        root_c = near_c + square_c*third*(c - near_c*near_c*near_c)
        complement = 2 - nu
        roots = root_a + root_c
        reciprocal = 1/(complement*roots)
        over_roots = complement*reciprocal
        over_complement = reciprocal*roots
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (equator_part <= 9*pole_part) & (pole_part <= 6*equator_part)
        level = np.where(served, over_roots*over_roots*unit, np.nan)
        v = over_roots*(-root_a + root_c)
        g0, g1, g2, g3, g4, g5, g6 = polynomials(SOFT, v)
        L0 = g0*level
        L1 = g1*level
        L2 = g2*level
        L3 = g3*level
        L4 = g4*level
        L5 = g5*level
        L6 = g6*level
        over_pole = forces*(5 - D33)
        a_D33 = a*a*fifteenth*(SR + 2)
        a_SR = -a*equator_part*fifteenth*over_pole
        c_D33 = -2*c*fifteenth*over_pole*(SR + 2)
        c_SR = 2*equator_part*fifteenth*over_pole*over_pole
        e0 = 2 - D33
        e1 = 2*D33 + 2
        density0 = L0*e0 + L1*e1
        density0_D33 = -L0 + 2*L1
        density1 = L1*e0 + L2*e1
        density1_D33 = -L1 + 2*L2
        density2 = L2*e0 + L3*e1
        density2_D33 = -L2 + 2*L3
        density3 = L3*e0 + L4*e1
        density3_D33 = -L3 + 2*L4
        density4 = L4*e0 + L5*e1
        density4_D33 = -L4 + 2*L5
        density5 = L5*e0 + L6*e1
        density5_D33 = -L5 + 2*L6
        w0 = 2 - Dr33
        half_w1 = Dr33 + 1
        twice_w1 = 4*half_w1
        square0 = w0*w0
        square0_Dr33 = -2*w0
        square1 = twice_w1*w0
        square1_Dr33 = -twice_w1 + 4*w0
        square2 = half_w1*twice_w1
        square2_Dr33 = 4*half_w1 + twice_w1
        S0 = density0*square0 + density1*square1 + density2*square2
        S0_D33 = density0_D33*square0 + density1_D33*square1 + density2_D33*square2
        S0_Dr33 = density0*square0_Dr33 + density1*square1_Dr33 + density2*square2_Dr33
        S1 = density1*square0 + density2*square1 + density3*square2
        S1_D33 = density1_D33*square0 + density2_D33*square1 + density3_D33*square2
        S1_Dr33 = density1*square0_Dr33 + density2*square1_Dr33 + density3*square2_Dr33
        S2 = density2*square0 + density3*square1 + density4*square2
        S2_D33 = density2_D33*square0 + density3_D33*square1 + density4_D33*square2
        S2_Dr33 = density2*square0_Dr33 + density3*square1_Dr33 + density4*square2_Dr33
        S3 = density3*square0 + density4*square1 + density5*square2
        S3_D33 = density3_D33*square0 + density4_D33*square1 + density5_D33*square2
        S3_Dr33 = density3*square0_Dr33 + density4*square1_Dr33 + density5*square2_Dr33
        sum0 = S0*a + S1*c
        sum0_D33 = S0_D33*a + S1_D33*c + third*(S0*a_D33 + S1*c_D33)
        sum0_Dr33 = S0_Dr33*a + S1_Dr33*c
        sum0_SR = third*(S0*a_SR + S1*c_SR)
        sum1 = S1*a + S2*c
        sum1_D33 = S1_D33*a + S2_D33*c + third*(S1*a_D33 + S2*c_D33)
        sum1_Dr33 = S1_Dr33*a + S2_Dr33*c
        sum1_SR = third*(S1*a_SR + S2*c_SR)
        sum2 = S2*a + S3*c
        sum2_D33 = S2_D33*a + S3_D33*c + third*(S2*a_D33 + S3*c_D33)
        sum2_Dr33 = S2_Dr33*a + S3_Dr33*c
        sum2_SR = third*(S2*a_SR + S3*c_SR)
        one_minus_lam = nu*over_complement
        one_minus_lam_nu = 2*over_complement*over_complement
        lam = 1 - one_minus_lam
        lam_nu = -one_minus_lam_nu
        four_r1 = 4*sum1
        four_r1_D33 = 4*sum1_D33
        four_r1_Dr33 = 4*sum1_Dr33
        four_r1_SR = 4*sum1_SR
        both = sum0 + sum1
        both_D33 = sum0_D33 + sum1_D33
        both_Dr33 = sum0_Dr33 + sum1_Dr33
        both_SR = sum0_SR + sum1_SR
        later = sum1 + sum2
        later_D33 = sum1_D33 + sum2_D33
        later_Dr33 = sum1_Dr33 + sum2_Dr33
        later_SR = sum1_SR + sum2_SR
        along = lam*sum1 + sum2
        along_D33 = lam*sum1_D33 + sum2_D33
        along_Dr33 = lam*sum1_Dr33 + sum2_Dr33
        along_SR = lam*sum1_SR + sum2_SR
        along_nu = lam_nu*sum1
        rows[:, 0] = lam*(four_r1 + sum0) + 3*sum0
        rows[:, 6] = four_r1_D33*lam + sum0_D33*(lam + 3)
        rows[:, 12] = four_r1_Dr33*lam + sum0_Dr33*(lam + 3)
        rows[:, 18] = four_r1_SR*lam + sum0_SR*(lam + 3)
        rows[:, 30] = lam_nu*(four_r1 + sum0)
        rows[:, 1] = 8*along
        rows[:, 7] = 8*along_D33
        rows[:, 13] = 8*along_Dr33
        rows[:, 19] = 8*along_SR
        rows[:, 31] = 8*along_nu
        rows[:, 2] = one_minus_lam*sum0
        C1122 = rows[:, 2]
        rows[:, 8] = one_minus_lam*sum0_D33
        C1122_D33 = rows[:, 8]
        rows[:, 14] = one_minus_lam*sum0_Dr33
        C1122_Dr33 = rows[:, 14]
        rows[:, 20] = one_minus_lam*sum0_SR
        C1122_SR = rows[:, 20]
        rows[:, 32] = one_minus_lam_nu*sum0
        C1122_nu = rows[:, 32]
        rows[:, 3] = four_r1*one_minus_lam
        C1133 = rows[:, 3]
        rows[:, 9] = four_r1_D33*one_minus_lam
        C1133_D33 = rows[:, 9]
        rows[:, 15] = four_r1_Dr33*one_minus_lam
        C1133_Dr33 = rows[:, 15]
        rows[:, 21] = four_r1_SR*one_minus_lam
        C1133_SR = rows[:, 21]
        rows[:, 33] = four_r1*one_minus_lam_nu
        C1133_nu = rows[:, 33]
        rows[:, 4] = C1133 + lam*(both + 2*later)
        rows[:, 10] = C1133_D33 + both_D33*lam + 2*lam*later_D33
        rows[:, 16] = C1133_Dr33 + both_Dr33*lam + 2*lam*later_Dr33
        rows[:, 22] = C1133_SR + both_SR*lam + 2*lam*later_SR
        rows[:, 34] = C1133_nu + lam_nu*(both + 2*later)
        rows[:, 5] = C1122 + 2*both*lam
        rows[:, 11] = C1122_D33 + 2*both_D33*lam
        rows[:, 17] = C1122_Dr33 + 2*both_Dr33*lam
        rows[:, 23] = C1122_SR + 2*both_SR*lam
        rows[:, 35] = C1122_nu + 2*both*lam_nu
        rows[:, 24] = 0
        rows[:, 25] = 0
        rows[:, 26] = 0
        rows[:, 27] = 0
        rows[:, 28] = 0
        rows[:, 29] = 0
    return int(served.size - np.count_nonzero(served))
