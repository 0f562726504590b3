"""Slopes of the stiffness: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``gradients``; do not edit.
Source: (7), (20), (21), (23), Figure 1(b) of Pan & Dong (1999).
Domain: constant_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5; kinetic_rows: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, a <= 9*c, c <= 6*a.
Operations: 774 (316 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import scratch_of, write_rows

Array: TypeAlias = npt.NDArray[np.float64]


def constant_rows(all_D33: Array, all_Dr33: Array, all_nu: Array, out: Array, streamed: bool) -> int:
    """Six components over (M/V) l_e^2 k_n and their slopes, for contacts that are equally stiff.

    Slopes by D33, Dr33, SR, mu and nu, six each; those by SR and mu are zero.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    all_nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (36 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33,
        C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR,
        C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_mu, C3333_mu, C1122_mu, C1133_mu, C2323_mu, C1212_mu,
        C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu of each element in turn, NaN for those that
        are not served.
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 153.
    """
    level = 1/221760
    scratch = scratch_of(1440)
    column_C1111 = scratch[0:32]
    column_C3333 = scratch[40:72]
    column_C1122 = scratch[80:112]
    column_C1133 = scratch[120:152]
    column_C2323 = scratch[160:192]
    column_C1212 = scratch[200:232]
    column_C1111_D33 = scratch[240:272]
    column_C3333_D33 = scratch[280:312]
    column_C1122_D33 = scratch[320:352]
    column_C1133_D33 = scratch[360:392]
    column_C2323_D33 = scratch[400:432]
    column_C1212_D33 = scratch[440:472]
    column_C1111_Dr33 = scratch[480:512]
    column_C3333_Dr33 = scratch[520:552]
    column_C1122_Dr33 = scratch[560:592]
    column_C1133_Dr33 = scratch[600:632]
    column_C2323_Dr33 = scratch[640:672]
    column_C1212_Dr33 = scratch[680:712]
    column_C1111_nu = scratch[1200:1232]
    column_C3333_nu = scratch[1240:1272]
    column_C1122_nu = scratch[1280:1312]
    column_C1133_nu = scratch[1320:1352]
    column_C2323_nu = scratch[1360:1392]
    column_C1212_nu = scratch[1400:1432]
    columns = scratch[0:1440]
    scratch[720:752] = 0
    scratch[760:792] = 0
    scratch[800:832] = 0
    scratch[840:872] = 0
    scratch[880:912] = 0
    scratch[920:952] = 0
    scratch[960:992] = 0
    scratch[1000:1032] = 0
    scratch[1040:1072] = 0
    scratch[1080:1112] = 0
    scratch[1120:1152] = 0
    scratch[1160:1192] = 0
    unserved = 0
    for start in range(0, all_D33.size, 32):
        stop = min(start + 32, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_nu = all_nu[start:stop]
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            nu = some_nu[i]
            complement = 2 - nu
            over_complement = 1/complement
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
            unserved += not served
            one_minus_lam = nu*over_complement if served else np.nan
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
            C1111 = lam*(four_r1 + sum0) + 3*sum0
            C1111_D33 = four_r1_D33*lam + sum0_D33*(lam + 3)
            C1111_Dr33 = four_r1_Dr33*lam + sum0_Dr33*(lam + 3)
            C1111_nu = lam_nu*(four_r1 + sum0)
            C3333 = 8*along
            C3333_D33 = 8*along_D33
            C3333_Dr33 = 8*along_Dr33
            C3333_nu = 8*along_nu
            C1122 = one_minus_lam*sum0
            C1122_D33 = one_minus_lam*sum0_D33
            C1122_Dr33 = one_minus_lam*sum0_Dr33
            C1122_nu = one_minus_lam_nu*sum0
            C1133 = four_r1*one_minus_lam
            C1133_D33 = four_r1_D33*one_minus_lam
            C1133_Dr33 = four_r1_Dr33*one_minus_lam
            C1133_nu = four_r1*one_minus_lam_nu
            C2323 = C1133 + lam*(both + 2*later)
            C2323_D33 = C1133_D33 + both_D33*lam + 2*lam*later_D33
            C2323_Dr33 = C1133_Dr33 + both_Dr33*lam + 2*lam*later_Dr33
            C2323_nu = C1133_nu + lam_nu*(both + 2*later)
            C1212 = C1122 + 2*both*lam
            C1212_D33 = C1122_D33 + 2*both_D33*lam
            C1212_Dr33 = C1122_Dr33 + 2*both_Dr33*lam
            C1212_nu = C1122_nu + 2*both*lam_nu
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
            column_C1111_D33[i] = C1111_D33
            column_C3333_D33[i] = C3333_D33
            column_C1122_D33[i] = C1122_D33
            column_C1133_D33[i] = C1133_D33
            column_C2323_D33[i] = C2323_D33
            column_C1212_D33[i] = C1212_D33
            column_C1111_Dr33[i] = C1111_Dr33
            column_C3333_Dr33[i] = C3333_Dr33
            column_C1122_Dr33[i] = C1122_Dr33
            column_C1133_Dr33[i] = C1133_Dr33
            column_C2323_Dr33[i] = C2323_Dr33
            column_C1212_Dr33[i] = C1212_Dr33
            column_C1111_nu[i] = C1111_nu
            column_C3333_nu[i] = C3333_nu
            column_C1122_nu[i] = C1122_nu
            column_C1133_nu[i] = C1133_nu
            column_C2323_nu[i] = C2323_nu
            column_C1212_nu[i] = C1212_nu
        write_rows(columns, 36, 40, out[36*start:36*stop], streamed)
    return unserved


def kinetic_rows(all_D33: Array, all_Dr33: Array, all_SR: Array, all_nu: Array, out: Array, streamed: bool) -> int:
    """Six components over (M/V) l_e^2 k_n,ref and their slopes, when contacts follow their force without slip.

    Slopes by D33, Dr33, SR, mu and nu, six each; those by mu are zero. Served for 1/9 <= c/a <= 6 with a and
    c the normal forces at equator and pole.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    all_SR : (n,) array [-]
        Stress ratio, principal stress along over across axis 3.
    all_nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (36 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212, C1111_D33, C3333_D33, C1122_D33, C1133_D33, C2323_D33,
        C1212_D33, C1111_Dr33, C3333_Dr33, C1122_Dr33, C1133_Dr33, C2323_Dr33, C1212_Dr33, C1111_SR, C3333_SR,
        C1122_SR, C1133_SR, C2323_SR, C1212_SR, C1111_mu, C3333_mu, C1122_mu, C1133_mu, C2323_mu, C1212_mu,
        C1111_nu, C3333_nu, C1122_nu, C1133_nu, C2323_nu, C1212_nu of each element in turn, NaN for those that
        are not served.
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 621.
    """
    third = 1/3
    fifteenth = 1/15
    unit = 1/55440
    scratch = scratch_of(3120)
    keep_S0 = scratch[0:32]
    keep_S0_D33 = scratch[40:72]
    keep_S0_Dr33 = scratch[80:112]
    keep_S1 = scratch[120:152]
    keep_S1_D33 = scratch[160:192]
    keep_S1_Dr33 = scratch[200:232]
    keep_S2 = scratch[240:272]
    keep_S2_D33 = scratch[280:312]
    keep_S2_Dr33 = scratch[320:352]
    keep_S3 = scratch[360:392]
    keep_a = scratch[400:432]
    keep_a_D33 = scratch[440:472]
    keep_a_SR = scratch[480:512]
    keep_c = scratch[520:552]
    keep_c_D33 = scratch[560:592]
    keep_c_SR = scratch[600:632]
    keep_density3 = scratch[640:672]
    keep_density3_D33 = scratch[680:712]
    keep_density4 = scratch[720:752]
    keep_density4_D33 = scratch[760:792]
    keep_density5 = scratch[800:832]
    keep_density5_D33 = scratch[840:872]
    keep_equator_part = scratch[880:912]
    keep_forces = scratch[920:952]
    keep_g0 = scratch[960:992]
    keep_g1 = scratch[1000:1032]
    keep_g2 = scratch[1040:1072]
    keep_g3 = scratch[1080:1112]
    keep_g4 = scratch[1120:1152]
    keep_g5 = scratch[1160:1192]
    keep_g6 = scratch[1200:1232]
    keep_level = scratch[1240:1272]
    keep_over_complement = scratch[1280:1312]
    keep_root_a = scratch[1320:1352]
    keep_root_c = scratch[1360:1392]
    keep_square0 = scratch[1400:1432]
    keep_square0_Dr33 = scratch[1440:1472]
    keep_square1 = scratch[1480:1512]
    keep_square1_Dr33 = scratch[1520:1552]
    keep_square2 = scratch[1560:1592]
    keep_square2_Dr33 = scratch[1600:1632]
    keep_v = scratch[1640:1672]
    column_C1111 = scratch[1680:1712]
    column_C3333 = scratch[1720:1752]
    column_C1122 = scratch[1760:1792]
    column_C1133 = scratch[1800:1832]
    column_C2323 = scratch[1840:1872]
    column_C1212 = scratch[1880:1912]
    column_C1111_D33 = scratch[1920:1952]
    column_C3333_D33 = scratch[1960:1992]
    column_C1122_D33 = scratch[2000:2032]
    column_C1133_D33 = scratch[2040:2072]
    column_C2323_D33 = scratch[2080:2112]
    column_C1212_D33 = scratch[2120:2152]
    column_C1111_Dr33 = scratch[2160:2192]
    column_C3333_Dr33 = scratch[2200:2232]
    column_C1122_Dr33 = scratch[2240:2272]
    column_C1133_Dr33 = scratch[2280:2312]
    column_C2323_Dr33 = scratch[2320:2352]
    column_C1212_Dr33 = scratch[2360:2392]
    column_C1111_SR = scratch[2400:2432]
    column_C3333_SR = scratch[2440:2472]
    column_C1122_SR = scratch[2480:2512]
    column_C1133_SR = scratch[2520:2552]
    column_C2323_SR = scratch[2560:2592]
    column_C1212_SR = scratch[2600:2632]
    column_C1111_nu = scratch[2880:2912]
    column_C3333_nu = scratch[2920:2952]
    column_C1122_nu = scratch[2960:2992]
    column_C1133_nu = scratch[3000:3032]
    column_C2323_nu = scratch[3040:3072]
    column_C1212_nu = scratch[3080:3112]
    columns = scratch[1680:3120]
    scratch[2640:2672] = 0
    scratch[2680:2712] = 0
    scratch[2720:2752] = 0
    scratch[2760:2792] = 0
    scratch[2800:2832] = 0
    scratch[2840:2872] = 0
    unserved = 0
    for start in range(0, all_D33.size, 32):
        stop = min(start + 32, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_SR = all_SR[start:stop]
        some_nu = all_nu[start:stop]
        for i in range(stop - start):
            D33 = some_D33[i]
            SR = some_SR[i]
            equator_part = 2*D33 + 5
            pole_part = SR*(5 - D33)
            forces = 15/(equator_part*(5 - D33)*(SR + 2))
            a = equator_part*forces
            c = forces*pole_part
            keep_a[i] = a
            keep_c[i] = c
            keep_equator_part[i] = equator_part
            keep_forces[i] = forces
        half = (stop - start + 1)//2
        for i in range(half):
            a = keep_a[i]
            a_too = keep_a[i + half]
            c = keep_c[i]
            c_too = keep_c[i + half]
            less_a = a - 1
            less_a_too = a_too - 1
            less_c = c - 1
            less_c_too = c_too - 1
            start_a_of = less_a*less_a
            start_a_of_too = less_a_too*less_a_too
            start_c_of = less_c*less_c
            start_c_of_too = less_c_too*less_c_too
            start_a_even = 0.3876953125*start_a_of + 0.186279296875
            start_a_even_too = 0.3876953125*start_a_of_too + 0.186279296875
            start_c_even = 0.3876953125*start_c_of + 0.186279296875
            start_c_even_too = 0.3876953125*start_c_of_too + 0.186279296875
            start_a_even = start_a_even*start_a_of + 1.0
            start_a_even_too = start_a_even_too*start_a_of_too + 1.0
            start_c_even = start_c_even*start_c_of + 1.0
            start_c_even_too = start_c_even_too*start_c_of_too + 1.0
            start_a_odd = -0.09765625*start_a_of + -0.45849609375
            start_a_odd_too = -0.09765625*start_a_of_too + -0.45849609375
            start_c_odd = -0.09765625*start_c_of + -0.45849609375
            start_c_odd_too = -0.09765625*start_c_of_too + -0.45849609375
            start_a_odd = start_a_odd*start_a_of + -0.23828125
            start_a_odd_too = start_a_odd_too*start_a_of_too + -0.23828125
            start_c_odd = start_c_odd*start_c_of + -0.23828125
            start_c_odd_too = start_c_odd_too*start_c_of_too + -0.23828125
            start_a = start_a_odd*less_a + start_a_even
            start_a_too = start_a_odd_too*less_a_too + start_a_even_too
            start_c = start_c_odd*less_c + start_c_even
            start_c_too = start_c_odd_too*less_c_too + start_c_even_too
            squared_a = start_a*start_a
            squared_a_too = start_a_too*start_a_too
            squared_c = start_c*start_c
            squared_c_too = start_c_too*start_c_too
            rest_a = -a*squared_a*start_a + 1
            rest_a_too = -a_too*squared_a_too*start_a_too + 1
            rest_c = -c*squared_c*start_c + 1
            rest_c_too = -c_too*squared_c_too*start_c_too + 1
            gain_a_of = rest_a*rest_a
            gain_a_of_too = rest_a_too*rest_a_too
            gain_c_of = rest_c*rest_c
            gain_c_of_too = rest_c_too*rest_c_too
            gain_a_even = 0.1255700042913689*gain_a_of + 0.17283814150989257
            gain_a_even_too = 0.1255700042913689*gain_a_of_too + 0.17283814150989257
            gain_c_even = 0.1255700042913689*gain_c_of + 0.17283814150989257
            gain_c_even_too = 0.1255700042913689*gain_c_of_too + 0.17283814150989257
            gain_a_even = gain_a_even*gain_a_of + 0.33333333370512586
            gain_a_even_too = gain_a_even_too*gain_a_of_too + 0.33333333370512586
            gain_c_even = gain_c_even*gain_c_of + 0.33333333370512586
            gain_c_even_too = gain_c_even_too*gain_c_of_too + 0.33333333370512586
            gain_a_odd = 0.1447154561559821*gain_a_of + 0.22222138492592086
            gain_a_odd_too = 0.1447154561559821*gain_a_of_too + 0.22222138492592086
            gain_c_odd = 0.1447154561559821*gain_c_of + 0.22222138492592086
            gain_c_odd_too = 0.1447154561559821*gain_c_of_too + 0.22222138492592086
            gain_a = gain_a_odd*rest_a + gain_a_even
            gain_a_too = gain_a_odd_too*rest_a_too + gain_a_even_too
            gain_c = gain_c_odd*rest_c + gain_c_even
            gain_c_too = gain_c_odd_too*rest_c_too + gain_c_even_too
            inverse_a = gain_a*rest_a*start_a + start_a
            inverse_a_too = gain_a_too*rest_a_too*start_a_too + start_a_too
            inverse_c = gain_c*rest_c*start_c + start_c
            inverse_c_too = gain_c_too*rest_c_too*start_c_too + start_c_too
            square_a = inverse_a*inverse_a
            square_a_too = inverse_a_too*inverse_a_too
            square_c = inverse_c*inverse_c
            square_c_too = inverse_c_too*inverse_c_too
            near_a = a*square_a
            near_a_too = a_too*square_a_too
            near_c = c*square_c
            near_c_too = c_too*square_c_too
            root_a = near_a + square_a*third*(a - near_a*near_a*near_a)
            root_a_too = near_a_too + square_a_too*third*(a_too - near_a_too*near_a_too*near_a_too)
            root_c = near_c + square_c*third*(c - near_c*near_c*near_c)
            root_c_too = near_c_too + square_c_too*third*(c_too - near_c_too*near_c_too*near_c_too)
            keep_root_a[i] = root_a
            keep_root_a[i + half] = root_a_too
            keep_root_c[i] = root_c
            keep_root_c[i + half] = root_c_too
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            nu = some_nu[i]
            a = keep_a[i]
            c = keep_c[i]
            root_a = keep_root_a[i]
            root_c = keep_root_c[i]
            complement = 2 - nu
            roots = root_a + root_c
            reciprocal = 1/(complement*roots)
            over_roots = complement*reciprocal
            over_complement = reciprocal*roots
            served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (a <= 9*c) & (c <= 6*a)
            unserved += not served
            level = over_roots*over_roots*unit if served else np.nan
            v = over_roots*(-root_a + root_c)
            keep_level[i] = level
            keep_over_complement[i] = over_complement
            keep_v[i] = v
        for i in range(stop - start):
            v = keep_v[i]
            g0 = 506.92573489437746
            g0 = g0*v + 821.306967846488
            g3 = -3.55007001715272
            g4 = 4.200302941088526
            g0 = g0*v + 661.7188477770511
            g1 = -5.7235810935215
            g2 = 5.875913798339083
            g3 = g3*v + -5.0060467914341675
            g4 = g4*v + 0.8168191875213652
            g5 = 6.082331096529521
            g6 = -8.631238100584213
            g0 = g0*v + 563.6747489849864
            g1 = g1*v + -9.823143878361055
            g2 = g2*v + 2.575698954651351
            g3 = g3*v + 5.471112028092155
            g4 = g4*v + -9.481723578829216
            g5 = g5*v + 6.982055224541575
            g6 = g6*v + -0.2538817780095012
            g0 = g0*v + 599.5228287880177
            g1 = g1*v + 6.592466366274278
            g2 = g2*v + -12.348835085328517
            g3 = g3*v + 10.194344298861074
            g4 = g4*v + -1.1040504919166811
            g5 = g5*v + -11.307913347531725
            g6 = g6*v + 19.831040887128975
            g0 = g0*v + 605.1497620522066
            g1 = g1*v + 21.58851392543368
            g2 = g2*v + -6.964376898794086
            g3 = g3*v + -7.941719515273703
            g4 = g4*v + 15.871808595613848
            g5 = g5*v + -12.080722645565205
            g6 = g6*v + -4.6219412457033044
            g0 = g0*v + 623.3532430827689
            g1 = g1*v + -3.839373486133894
            g2 = g2*v + 18.94990754466455
            g3 = g3*v + -16.27921252080582
            g4 = g4*v + 0.20196307795977816
            g5 = g5*v + 20.47332371845884
            g6 = g6*v + -33.57047253012832
            g0 = g0*v + 709.2934784480804
            g1 = g1*v + -36.69706750582114
            g2 = g2*v + 14.311727558792116
            g3 = g3*v + 11.104087569679225
            g4 = g4*v + -23.91980839832898
            g5 = g5*v + 14.241900057726225
            g6 = g6*v + 20.034753317825693
            g0 = g0*v + 763.5546883468976
            g1 = g1*v + -6.59409496009477
            g2 = g2*v + -25.140861984698745
            g3 = g3*v + 23.70879795264758
            g4 = g4*v + 2.610756601424082
            g5 = g5*v + -34.934719006014475
            g6 = g6*v + 47.531892048629004
            g0 = g0*v + 694.827964977562
            g1 = g1*v + 53.96539938953534
            g2 = g2*v + -25.76155995911737
            g3 = g3*v + -14.085999689432983
            g4 = g4*v + 32.699512940850646
            g5 = g5*v + -10.474037522681988
            g6 = g6*v + -53.15704375295891
            g0 = g0*v + 630.1957183157525
            g1 = g1*v + 31.91502264966188
            g2 = g2*v + 27.92884103677617
            g3 = g3*v + -31.449383471558143
            g4 = g4*v + -8.13288285121476
            g5 = g5*v + 52.67089049591067
            g6 = g6*v + -49.40155795042603
            g0 = g0*v + 770.3918807574934
            g1 = g1*v + -62.96017587310922
            g2 = g2*v + 40.382223858548116
            g3 = g3*v + 15.675685269910822
            g4 = g4*v + -39.553670529445974
            g5 = g5*v + -4.587587711010591
            g6 = g6*v + 107.35574633544685
            g0 = g0*v + 1027.719572392018
            g1 = g1*v + -74.51091826080773
            g2 = g2*v + -22.786976213880433
            g3 = g3*v + 37.27703126727633
            g4 = g4*v + 16.210373574912754
            g5 = g5*v + -65.96944355267874
            g6 = g6*v + 12.07435529573402
            g0 = g0*v + 1059.536728822857
            g1 = g1*v + 43.5717939795874
            g2 = g2*v + -53.209864904903085
            g3 = g3*v + -14.768372031966857
            g4 = g4*v + 40.76788151104653
            g5 = g5*v + 33.419057634855484
            g6 = g6*v + -163.2453315544091
            g0 = g0*v + 780.6479530951765
            g1 = g1*v + 119.82280731177282
            g2 = g2*v + 7.239126791636089
            g3 = g3*v + -38.602085381488074
            g4 = g4*v + -24.52115653486248
            g5 = g5*v + 60.38790904192574
            g6 = g6*v + 96.83853584187563
            g0 = g0*v + 606.9475479290057
            g1 = g1*v + 25.68561873165533
            g2 = g2*v + 55.54261020641397
            g3 = g3*v + 11.244085033954436
            g4 = g4*v + -33.97330627248665
            g5 = g5*v + -65.68375493343302
            g6 = g6*v + 147.95334293967846
            g0 = g0*v + 971.8123362549478
            g1 = g1*v + -115.73549257511839
            g2 = g2*v + 13.56513455650788
            g3 = g3*v + 34.18591728190136
            g4 = g4*v + 28.892593474743464
            g5 = g5*v + -25.108359135394547
            g6 = g6*v + -255.66682543546608
            g0 = g0*v + 1728.8586171308682
            g1 = g1*v + -114.86163372231981
            g2 = g2*v + -41.90458045562057
            g3 = g3*v + -6.457410494579497
            g4 = g4*v + 21.178375803756264
            g5 = g5*v + 73.8442486306299
            g6 = g6*v + 57.28697308876897
            g0 = g0*v + 2247.2398190045683
            g1 = g1*v + 17.37556561085129
            g2 = g2*v + -27.22171945701583
            g3 = g3*v + -25.701357466063413
            g4 = g4*v + -26.606334841629277
            g5 = g5*v + -21.855203619901797
            g6 = g6*v + 256.0859728506816
            g0 = g0*v + 2048.0000000000005
            g1 = g1*v + 118.15384615384615
            g2 = g2*v + 19.692307692307622
            g3 = g3*v + 2.461538461538488
            g4 = g4*v + -8.615384615384606
            g5 = g5*v + -45.230769230769226
            g6 = g6*v + -390.92307692307685
            g0 = g0*v + 1181.5384615384614
            g1 = g1*v + 98.46153846153847
            g2 = g2*v + 29.53846153846154
            g3 = g3*v + 18.46153846153846
            g4 = g4*v + 21.53846153846154
            g5 = g5*v + 48.46153846153846
            g6 = g6*v + 266.53846153846155
            keep_g0[i] = g0
            keep_g1[i] = g1
            keep_g2[i] = g2
            keep_g3[i] = g3
            keep_g4[i] = g4
            keep_g5[i] = g5
            keep_g6[i] = g6
        for i in range(stop - start):
            D33 = some_D33[i]
            SR = some_SR[i]
            a = keep_a[i]
            c = keep_c[i]
            equator_part = keep_equator_part[i]
            forces = keep_forces[i]
            over_pole = forces*(5 - D33)
            a_D33 = a*a*fifteenth*(SR + 2)
            a_SR = -a*equator_part*fifteenth*over_pole
            c_D33 = -2*c*fifteenth*over_pole*(SR + 2)
            c_SR = 2*equator_part*fifteenth*over_pole*over_pole
            keep_a_D33[i] = a_D33
            keep_a_SR[i] = a_SR
            keep_c_D33[i] = c_D33
            keep_c_SR[i] = c_SR
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            g0 = keep_g0[i]
            g1 = keep_g1[i]
            g2 = keep_g2[i]
            g3 = keep_g3[i]
            g4 = keep_g4[i]
            g5 = keep_g5[i]
            g6 = keep_g6[i]
            level = keep_level[i]
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
            keep_S0[i] = S0
            keep_S0_D33[i] = S0_D33
            keep_S0_Dr33[i] = S0_Dr33
            keep_S1[i] = S1
            keep_S1_D33[i] = S1_D33
            keep_S1_Dr33[i] = S1_Dr33
            keep_S2[i] = S2
            keep_S2_D33[i] = S2_D33
            keep_S2_Dr33[i] = S2_Dr33
            keep_S3[i] = S3
            keep_density3[i] = density3
            keep_density3_D33[i] = density3_D33
            keep_density4[i] = density4
            keep_density4_D33[i] = density4_D33
            keep_density5[i] = density5
            keep_density5_D33[i] = density5_D33
            keep_square0[i] = square0
            keep_square0_Dr33[i] = square0_Dr33
            keep_square1[i] = square1
            keep_square1_Dr33[i] = square1_Dr33
            keep_square2[i] = square2
            keep_square2_Dr33[i] = square2_Dr33
        for i in range(stop - start):
            nu = some_nu[i]
            S0 = keep_S0[i]
            S0_D33 = keep_S0_D33[i]
            S0_Dr33 = keep_S0_Dr33[i]
            S1 = keep_S1[i]
            S1_D33 = keep_S1_D33[i]
            S1_Dr33 = keep_S1_Dr33[i]
            S2 = keep_S2[i]
            S2_D33 = keep_S2_D33[i]
            S2_Dr33 = keep_S2_Dr33[i]
            S3 = keep_S3[i]
            a = keep_a[i]
            a_D33 = keep_a_D33[i]
            a_SR = keep_a_SR[i]
            c = keep_c[i]
            c_D33 = keep_c_D33[i]
            c_SR = keep_c_SR[i]
            density3 = keep_density3[i]
            density3_D33 = keep_density3_D33[i]
            density4 = keep_density4[i]
            density4_D33 = keep_density4_D33[i]
            density5 = keep_density5[i]
            density5_D33 = keep_density5_D33[i]
            over_complement = keep_over_complement[i]
            square0 = keep_square0[i]
            square0_Dr33 = keep_square0_Dr33[i]
            square1 = keep_square1[i]
            square1_Dr33 = keep_square1_Dr33[i]
            square2 = keep_square2[i]
            square2_Dr33 = keep_square2_Dr33[i]
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
            C1111 = lam*(four_r1 + sum0) + 3*sum0
            C1111_D33 = four_r1_D33*lam + sum0_D33*(lam + 3)
            C1111_Dr33 = four_r1_Dr33*lam + sum0_Dr33*(lam + 3)
            C1111_SR = four_r1_SR*lam + sum0_SR*(lam + 3)
            C1111_nu = lam_nu*(four_r1 + sum0)
            C3333 = 8*along
            C3333_D33 = 8*along_D33
            C3333_Dr33 = 8*along_Dr33
            C3333_SR = 8*along_SR
            C3333_nu = 8*along_nu
            C1122 = one_minus_lam*sum0
            C1122_D33 = one_minus_lam*sum0_D33
            C1122_Dr33 = one_minus_lam*sum0_Dr33
            C1122_SR = one_minus_lam*sum0_SR
            C1122_nu = one_minus_lam_nu*sum0
            C1133 = four_r1*one_minus_lam
            C1133_D33 = four_r1_D33*one_minus_lam
            C1133_Dr33 = four_r1_Dr33*one_minus_lam
            C1133_SR = four_r1_SR*one_minus_lam
            C1133_nu = four_r1*one_minus_lam_nu
            C2323 = C1133 + lam*(both + 2*later)
            C2323_D33 = C1133_D33 + both_D33*lam + 2*lam*later_D33
            C2323_Dr33 = C1133_Dr33 + both_Dr33*lam + 2*lam*later_Dr33
            C2323_SR = C1133_SR + both_SR*lam + 2*lam*later_SR
            C2323_nu = C1133_nu + lam_nu*(both + 2*later)
            C1212 = C1122 + 2*both*lam
            C1212_D33 = C1122_D33 + 2*both_D33*lam
            C1212_Dr33 = C1122_Dr33 + 2*both_Dr33*lam
            C1212_SR = C1122_SR + 2*both_SR*lam
            C1212_nu = C1122_nu + 2*both*lam_nu
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
            column_C1111_D33[i] = C1111_D33
            column_C3333_D33[i] = C3333_D33
            column_C1122_D33[i] = C1122_D33
            column_C1133_D33[i] = C1133_D33
            column_C2323_D33[i] = C2323_D33
            column_C1212_D33[i] = C1212_D33
            column_C1111_Dr33[i] = C1111_Dr33
            column_C3333_Dr33[i] = C3333_Dr33
            column_C1122_Dr33[i] = C1122_Dr33
            column_C1133_Dr33[i] = C1133_Dr33
            column_C2323_Dr33[i] = C2323_Dr33
            column_C1212_Dr33[i] = C1212_Dr33
            column_C1111_SR[i] = C1111_SR
            column_C3333_SR[i] = C3333_SR
            column_C1122_SR[i] = C1122_SR
            column_C1133_SR[i] = C1133_SR
            column_C2323_SR[i] = C2323_SR
            column_C1212_SR[i] = C1212_SR
            column_C1111_nu[i] = C1111_nu
            column_C3333_nu[i] = C3333_nu
            column_C1122_nu[i] = C1122_nu
            column_C1133_nu[i] = C1133_nu
            column_C2323_nu[i] = C2323_nu
            column_C1212_nu[i] = C1212_nu
        write_rows(columns, 36, 40, out[36*start:36*stop], streamed)
    return unserved
