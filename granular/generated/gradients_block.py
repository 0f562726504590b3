"""Slopes of the stiffness: blocks of elements at once.

Emitted by ``derivations write`` from the derivation ``gradients``; do not edit.
Source: (7), (20), (21), (23), Figure 1(b) of Pan & Dong (1999).
Domain: constant_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5; kinetic_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, a <= 9*c, c <= 6*a.
Operations: 774 (316 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

SOFT = np.array([
    [506.92573489437746, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [821.306967846488, 0.0, 0.0, -3.55007001715272, 4.200302941088526, 0.0, 0.0],
    [661.7188477770511, -5.7235810935215, 5.875913798339083, -5.0060467914341675, 0.8168191875213652, 6.082331096529521, -8.631238100584213],
    [563.6747489849864, -9.823143878361055, 2.575698954651351, 5.471112028092155, -9.481723578829216, 6.982055224541575, -0.2538817780095012],
    [599.5228287880177, 6.592466366274278, -12.348835085328517, 10.194344298861074, -1.1040504919166811, -11.307913347531725, 19.831040887128975],
    [605.1497620522066, 21.58851392543368, -6.964376898794086, -7.941719515273703, 15.871808595613848, -12.080722645565205, -4.6219412457033044],
    [623.3532430827689, -3.839373486133894, 18.94990754466455, -16.27921252080582, 0.20196307795977816, 20.47332371845884, -33.57047253012832],
    [709.2934784480804, -36.69706750582114, 14.311727558792116, 11.104087569679225, -23.91980839832898, 14.241900057726225, 20.034753317825693],
    [763.5546883468976, -6.59409496009477, -25.140861984698745, 23.70879795264758, 2.610756601424082, -34.934719006014475, 47.531892048629004],
    [694.827964977562, 53.96539938953534, -25.76155995911737, -14.085999689432983, 32.699512940850646, -10.474037522681988, -53.15704375295891],
    [630.1957183157525, 31.91502264966188, 27.92884103677617, -31.449383471558143, -8.13288285121476, 52.67089049591067, -49.40155795042603],
    [770.3918807574934, -62.96017587310922, 40.382223858548116, 15.675685269910822, -39.553670529445974, -4.587587711010591, 107.35574633544685],
    [1027.719572392018, -74.51091826080773, -22.786976213880433, 37.27703126727633, 16.210373574912754, -65.96944355267874, 12.07435529573402],
    [1059.536728822857, 43.5717939795874, -53.209864904903085, -14.768372031966857, 40.76788151104653, 33.419057634855484, -163.2453315544091],
    [780.6479530951765, 119.82280731177282, 7.239126791636089, -38.602085381488074, -24.52115653486248, 60.38790904192574, 96.83853584187563],
    [606.9475479290057, 25.68561873165533, 55.54261020641397, 11.244085033954436, -33.97330627248665, -65.68375493343302, 147.95334293967846],
    [971.8123362549478, -115.73549257511839, 13.56513455650788, 34.18591728190136, 28.892593474743464, -25.108359135394547, -255.66682543546608],
    [1728.8586171308682, -114.86163372231981, -41.90458045562057, -6.457410494579497, 21.178375803756264, 73.8442486306299, 57.28697308876897],
    [2247.2398190045683, 17.37556561085129, -27.22171945701583, -25.701357466063413, -26.606334841629277, -21.855203619901797, 256.0859728506816],
    [2048.0000000000005, 118.15384615384615, 19.692307692307622, 2.461538461538488, -8.615384615384606, -45.230769230769226, -390.92307692307685],
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

    Operations: 153.
    """
    rows = out.reshape(-1, 36)
    with np.errstate(all="ignore"):  # what is not served may be anything
        complement = 2 - nu
        over_complement = 1/complement
        level = 1/221760
        e0 = 2 - D33
        half_e1 = D33 + 1
        density0 = 1024*e0 + 768
        density1 = 32*e0 + 288
        density2 = 32*half_e1 + 144
        density3 = 100*half_e1 + 120
        density4 = 560*half_e1 + 210
        w0 = 2 - Dr33
        half_w1 = Dr33 + 1
        twice_w1 = 4*half_w1
        level_w0 = level*w0
        level_w0_Dr33 = -level
        level_half_w1 = half_w1*level
        square0 = level_w0*w0
        square0_Dr33 = -level_w0 + level_w0_Dr33*w0
        square1 = level_w0*twice_w1
        square1_Dr33 = 4*level_w0 + level_w0_Dr33*twice_w1
        square2 = level_half_w1*twice_w1
        square2_Dr33 = level*twice_w1 + 4*level_half_w1
        sum0 = density0*square0 + density1*square1 + density2*square2
        sum0_D33 = -1024*square0 - 32*square1 + 32*square2
        sum0_Dr33 = density0*square0_Dr33 + density1*square1_Dr33 + density2*square2_Dr33
        sum1 = density1*square0 + density2*square1 + density3*square2
        sum1_D33 = -32*square0 + 32*square1 + 100*square2
        sum1_Dr33 = density1*square0_Dr33 + density2*square1_Dr33 + density3*square2_Dr33
        sum2 = density2*square0 + density3*square1 + density4*square2
        sum2_D33 = 32*square0 + 100*square1 + 560*square2
        sum2_Dr33 = density2*square0_Dr33 + density3*square1_Dr33 + density4*square2_Dr33
        served = (e0*half_e1 >= 0.0) & (square1 > 0.0) & (nu >= 0.0) & (nu <= 0.5)
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

    Operations: 621.
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
        start_a_of = less_a*less_a
        start_a_even = 0.3876953125*start_a_of + 0.186279296875
        start_a_even = start_a_even*start_a_of + 1.0
        start_a_odd = -0.09765625*start_a_of + -0.45849609375
        start_a_odd = start_a_odd*start_a_of + -0.23828125
        start_a = start_a_odd*less_a + start_a_even
        start_c_of = less_c*less_c
        start_c_even = 0.3876953125*start_c_of + 0.186279296875
        start_c_even = start_c_even*start_c_of + 1.0
        start_c_odd = -0.09765625*start_c_of + -0.45849609375
        start_c_odd = start_c_odd*start_c_of + -0.23828125
        start_c = start_c_odd*less_c + start_c_even
        squared_a = start_a*start_a
        squared_c = start_c*start_c
        rest_a = -a*squared_a*start_a + 1
        rest_c = -c*squared_c*start_c + 1
        gain_a_of = rest_a*rest_a
        gain_a_even = 0.1255700042913689*gain_a_of + 0.17283814150989257
        gain_a_even = gain_a_even*gain_a_of + 0.33333333370512586
        gain_a_odd = 0.1447154561559821*gain_a_of + 0.22222138492592086
        gain_a = gain_a_odd*rest_a + gain_a_even
        gain_c_of = rest_c*rest_c
        gain_c_even = 0.1255700042913689*gain_c_of + 0.17283814150989257
        gain_c_even = gain_c_even*gain_c_of + 0.33333333370512586
        gain_c_odd = 0.1447154561559821*gain_c_of + 0.22222138492592086
        gain_c = gain_c_odd*rest_c + gain_c_even
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
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (a <= 9*c) & (c <= 6*a)
        level = np.where(served, over_roots*over_roots*unit, np.nan)
        v = over_roots*(-root_a + root_c)
        g0, g1, g2, g3, g4, g5, g6 = polynomials(SOFT, v)
        over_pole = forces*(5 - D33)
        a_D33 = a*a*fifteenth*(SR + 2)
        a_SR = -a*equator_part*fifteenth*over_pole
        c_D33 = -2*c*fifteenth*over_pole*(SR + 2)
        c_SR = 2*equator_part*fifteenth*over_pole*over_pole
        e0 = 2 - D33
        e1 = 2*D33 + 2
        density0 = e0*g0 + e1*g1
        density0_D33 = -g0 + 2*g1
        density1 = e0*g1 + e1*g2
        density1_D33 = -g1 + 2*g2
        density2 = e0*g2 + e1*g3
        density2_D33 = -g2 + 2*g3
        density3 = e0*g3 + e1*g4
        density3_D33 = -g3 + 2*g4
        density4 = e0*g4 + e1*g5
        density4_D33 = -g4 + 2*g5
        density5 = e0*g5 + e1*g6
        density5_D33 = -g5 + 2*g6
        w0 = 2 - Dr33
        half_w1 = Dr33 + 1
        twice_w1 = 4*half_w1
        level_w0 = level*w0
        level_w0_Dr33 = -level
        level_half_w1 = half_w1*level
        square0 = level_w0*w0
        square0_Dr33 = -level_w0 + level_w0_Dr33*w0
        square1 = level_w0*twice_w1
        square1_Dr33 = 4*level_w0 + level_w0_Dr33*twice_w1
        square2 = level_half_w1*twice_w1
        square2_Dr33 = level*twice_w1 + 4*level_half_w1
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
