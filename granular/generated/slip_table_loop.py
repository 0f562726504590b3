"""Partial slip about its onset: what a table can hold: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``slip_table``; do not edit.
Source: (20), (21), (23) of Pan & Dong (1999).
Domain: slip_state: D33 >= -1.0, D33 <= 2.0, a <= 9*c, c <= 6*a; slip_rows: Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, level > 0.0, lost0 >= 0.0.
Operations: 413 (7736 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import scratch_of, write_rows

Array: TypeAlias = npt.NDArray[np.float64]


def slip_state(all_D33: Array, all_SR: Array, all_mu: Array, out: Array) -> int:
    """Level of the stiffness, cubic contrast of the forces, share of the friction used up and left.

    Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_SR : (n,) array [-]
        Stress ratio, principal stress along over across axis 3.
    all_mu : (n,) array [-]
        Friction coefficient between grains.
    out : (4 n,) array [-]
        level, v, kappa, margin, each for all elements, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 96.
    """
    third = 1/3
    unit = 1/443520
    scratch = scratch_of(544)
    keep_a = scratch[0:128]
    keep_c = scratch[136:264]
    keep_root_a = scratch[272:400]
    keep_root_c = scratch[408:536]
    unserved = 0
    for start in range(0, all_D33.size, 128):
        stop = min(start + 128, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_SR = all_SR[start:stop]
        some_mu = all_mu[start:stop]
        some_level = out[0*all_D33.size:1*all_D33.size][start:stop]
        some_v = out[1*all_D33.size:2*all_D33.size][start:stop]
        some_kappa = out[2*all_D33.size:3*all_D33.size][start:stop]
        some_margin = out[3*all_D33.size:4*all_D33.size][start:stop]
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
            mu = some_mu[i]
            a = keep_a[i]
            c = keep_c[i]
            root_a = keep_root_a[i]
            root_c = keep_root_c[i]
            roots = root_a + root_c
            over_roots = 1/roots
            served = (D33 >= -1.0) & (D33 <= 2.0) & (a <= 9*c) & (c <= 6*a)
            unserved += not served
            level = roots*unit if served else np.nan
            v = over_roots*(-root_a + root_c)
            square = v*v
            growth_of = square*square
            growth_even = 7.510115621976816*growth_of + 12.983404091516944
            growth_even = growth_even*growth_of + 11.504144503993611
            growth_even = growth_even*growth_of + 9.570311938428365
            growth_even = growth_even*growth_of + 7.124999999951793
            growth_even = growth_even*growth_of + 3.0
            growth_odd = 34.42581677198594*growth_of + 15.3271637993778
            growth_odd = growth_odd*growth_of + 12.372823066093193
            growth_odd = growth_odd*growth_of + 10.582056867999349
            growth_odd = growth_odd*growth_of + 8.437500007245387
            growth_odd = growth_odd*growth_of + 5.500000000000125
            growth = growth_odd*square + growth_even
            kappa = growth*abs(v)/mu
            margin = 1 - kappa
            some_level[i] = level
            some_v[i] = v
            some_kappa[i] = kappa
            some_margin[i] = margin
    return unserved


def slip_rows(all_D33: Array, all_Dr33: Array, all_nu: Array, all_level: Array, all_v: Array, all_lost0: Array, all_lost1: Array, all_lost2: Array, all_lost3: Array, all_lost4: Array, all_lost5: Array, out: Array, streamed: bool) -> int:
    """Six components over (M/V) l_e^2 k_n,ref with partial slip.

    What slip takes is counted in units of the mean cube root of the forces, times 3465.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    all_nu : (n,) array [-]
        Poisson's ratio of the grain material.
    all_level : (n,) array [-]
    all_v : (n,) array [-]
        Contrast of the roots of the branch-length weight at pole and equator.
    all_lost0 : (n,) array [-]
    all_lost1 : (n,) array [-]
    all_lost2 : (n,) array [-]
    all_lost3 : (n,) array [-]
    all_lost4 : (n,) array [-]
    all_lost5 : (n,) array [-]
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 317.
    """
    scratch = scratch_of(936)
    keep_contrast = scratch[0:64]
    keep_f0 = scratch[72:136]
    keep_f1 = scratch[144:208]
    keep_f2 = scratch[216:280]
    keep_f3 = scratch[288:352]
    keep_f4 = scratch[360:424]
    keep_f5 = scratch[432:496]
    column_C1111 = scratch[504:568]
    column_C3333 = scratch[576:640]
    column_C1122 = scratch[648:712]
    column_C1133 = scratch[720:784]
    column_C2323 = scratch[792:856]
    column_C1212 = scratch[864:928]
    columns = scratch[504:936]
    unserved = 0
    for start in range(0, all_D33.size, 64):
        stop = min(start + 64, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_nu = all_nu[start:stop]
        some_level = all_level[start:stop]
        some_v = all_v[start:stop]
        some_lost0 = all_lost0[start:stop]
        some_lost1 = all_lost1[start:stop]
        some_lost2 = all_lost2[start:stop]
        some_lost3 = all_lost3[start:stop]
        some_lost4 = all_lost4[start:stop]
        some_lost5 = all_lost5[start:stop]
        for i in range(stop - start):
            v = some_v[i]
            contrast = v
            keep_contrast[i] = contrast
        half = (stop - start + 1)//2
        for i in range(half):
            contrast = keep_contrast[i]
            contrast_too = keep_contrast[i + half]
            f1 = -0.681114526638451
            f1_too = -0.681114526638451
            f2 = -0.6448530994941937
            f2_too = -0.6448530994941937
            f3 = 1.3578204037912385
            f3_too = 1.3578204037912385
            f4 = -1.1453090253436675
            f4_too = -1.1453090253436675
            f1 = f1*contrast + 1.6230495115734476
            f1_too = f1_too*contrast_too + 1.6230495115734476
            f2 = f2*contrast + -2.0615131639337565
            f2_too = f2_too*contrast_too + -2.0615131639337565
            f3 = f3*contrast + 1.0001308104875504
            f3_too = f3_too*contrast_too + 1.0001308104875504
            f4 = f4*contrast + 0.9446767363215737
            f4_too = f4_too*contrast_too + 0.9446767363215737
            f5 = -2.82297396368279
            f5_too = -2.82297396368279
            f0 = -4.546318711523686
            f0_too = -4.546318711523686
            f1 = f1*contrast + 3.0258622050863377
            f1_too = f1_too*contrast_too + 3.0258622050863377
            f2 = f2*contrast + 0.26459272328021677
            f2_too = f2_too*contrast_too + 0.26459272328021677
            f3 = f3*contrast + -2.7146261734134396
            f3_too = f3_too*contrast_too + -2.7146261734134396
            f4 = f4*contrast + 3.001577654277903
            f4_too = f4_too*contrast_too + 3.001577654277903
            f5 = f5*contrast + -0.49894294272562195
            f5_too = f5_too*contrast_too + -0.49894294272562195
            f0 = f0*contrast + -3.119570333962791
            f0_too = f0_too*contrast_too + -3.119570333962791
            f1 = f1*contrast + -2.6650096693667598
            f1_too = f1_too*contrast_too + -2.6650096693667598
            f2 = f2*contrast + 4.239023330627392
            f2_too = f2_too*contrast_too + 4.239023330627392
            f3 = f3*contrast + -1.980997895160333
            f3_too = f3_too*contrast_too + -1.980997895160333
            f4 = f4*contrast + -2.43922093557402
            f4_too = f4_too*contrast_too + -2.43922093557402
            f5 = f5*contrast + 6.399088826535958
            f5_too = f5_too*contrast_too + 6.399088826535958
            f0 = f0*contrast + 8.878537664159156
            f0_too = f0_too*contrast_too + 8.878537664159156
            f1 = f1*contrast + -6.546511322612836
            f1_too = f1_too*contrast_too + -6.546511322612836
            f2 = f2*contrast + 0.3706640828750369
            f2_too = f2_too*contrast_too + 0.3706640828750369
            f3 = f3*contrast + 4.603490595267432
            f3_too = f3_too*contrast_too + 4.603490595267432
            f4 = f4*contrast + -4.946901400105296
            f4_too = f4_too*contrast_too + -4.946901400105296
            f5 = f5*contrast + -0.8811121188867673
            f5_too = f5_too*contrast_too + -0.8811121188867673
            f0 = f0*contrast + 9.892064566275682
            f0_too = f0_too*contrast_too + 9.892064566275682
            f1 = f1*contrast + 2.6038626781127148
            f1_too = f1_too*contrast_too + 2.6038626781127148
            f2 = f2*contrast + -6.936244936726151
            f2_too = f2_too*contrast_too + -6.936244936726151
            f3 = f3*contrast + 3.031342870960518
            f3_too = f3_too*contrast_too + 3.031342870960518
            f4 = f4*contrast + 5.209188581484684
            f4_too = f4_too*contrast_too + 5.209188581484684
            f5 = f5*contrast + -11.292788699818386
            f5_too = f5_too*contrast_too + -11.292788699818386
            f0 = f0*contrast + -12.4799749165955
            f0_too = f0_too*contrast_too + -12.4799749165955
            f1 = f1*contrast + 11.938888599247987
            f1_too = f1_too*contrast_too + 11.938888599247987
            f2 = f2*contrast + -1.6702435408934053
            f2_too = f2_too*contrast_too + -1.6702435408934053
            f3 = f3*contrast + -7.30108476530955
            f3_too = f3_too*contrast_too + -7.30108476530955
            f4 = f4*contrast + 6.736889084711712
            f4_too = f4_too*contrast_too + 6.736889084711712
            f5 = f5*contrast + 6.320279093235818
            f5_too = f5_too*contrast_too + 6.320279093235818
            f0 = f0*contrast + -25.964787484683303
            f0_too = f0_too*contrast_too + -25.964787484683303
            f1 = f1*contrast + 0.23473979078158907
            f1_too = f1_too*contrast_too + 0.23473979078158907
            f2 = f2*contrast + 10.254534254724458
            f2_too = f2_too*contrast_too + 10.254534254724458
            f3 = f3*contrast + -4.136779025020829
            f3_too = f3_too*contrast_too + -4.136779025020829
            f4 = f4*contrast + -9.969054345037073
            f4_too = f4_too*contrast_too + -9.969054345037073
            f5 = f5*contrast + 16.5005022146651
            f5_too = f5_too*contrast_too + 16.5005022146651
            f0 = f0*contrast + 5.708920950608579
            f0_too = f0_too*contrast_too + 5.708920950608579
            f1 = f1*contrast + -18.80336456724852
            f1_too = f1_too*contrast_too + -18.80336456724852
            f2 = f2*contrast + 4.271392333104574
            f2_too = f2_too*contrast_too + 4.271392333104574
            f3 = f3*contrast + 10.728191530070514
            f3_too = f3_too*contrast_too + 10.728191530070514
            f4 = f4*contrast + -7.189992271632052
            f4_too = f4_too*contrast_too + -7.189992271632052
            f5 = f5*contrast + -19.251296521803365
            f5_too = f5_too*contrast_too + -19.251296521803365
            f0 = f0*contrast + 49.24001791208917
            f0_too = f0_too*contrast_too + 49.24001791208917
            f1 = f1*contrast + -8.9039852418593
            f1_too = f1_too*contrast_too + -8.9039852418593
            f2 = f2*contrast + -13.525960996995131
            f2_too = f2_too*contrast_too + -13.525960996995131
            f3 = f3*contrast + 5.001472614523118
            f3_too = f3_too*contrast_too + 5.001472614523118
            f4 = f4*contrast + 16.789240885441274
            f4_too = f4_too*contrast_too + 16.789240885441274
            f5 = f5*contrast + -16.128675648415005
            f5_too = f5_too*contrast_too + -16.128675648415005
            f0 = f0*contrast + 25.46436858851001
            f0_too = f0_too*contrast_too + 25.46436858851001
            f1 = f1*contrast + 23.39989637869322
            f1_too = f1_too*contrast_too + 23.39989637869322
            f2 = f2*contrast + -8.572865622523768
            f2_too = f2_too*contrast_too + -8.572865622523768
            f3 = f3*contrast + -14.4909532955523
            f3_too = f3_too*contrast_too + -14.4909532955523
            f4 = f4*contrast + 4.0842765802638406
            f4_too = f4_too*contrast_too + 4.0842765802638406
            f5 = f5*contrast + 41.42820447574571
            f5_too = f5_too*contrast_too + 41.42820447574571
            f0 = f0*contrast + -69.01523114238569
            f0_too = f0_too*contrast_too + -69.01523114238569
            f1 = f1*contrast + 25.59620057648662
            f1_too = f1_too*contrast_too + 25.59620057648662
            f2 = f2*contrast + 15.478994399700156
            f2_too = f2_too*contrast_too + 15.478994399700156
            f3 = f3*contrast + -5.23869099628221
            f3_too = f3_too*contrast_too + -5.23869099628221
            f4 = f4*contrast + -24.058001459512962
            f4_too = f4_too*contrast_too + -24.058001459512962
            f5 = f5*contrast + -4.224094844804309
            f5_too = f5_too*contrast_too + -4.224094844804309
            f0 = f0*contrast + -118.80474942602964
            f0_too = f0_too*contrast_too + -118.80474942602964
            f1 = f1*contrast + -16.9211118296269
            f1_too = f1_too*contrast_too + -16.9211118296269
            f2 = f2*contrast + 14.441791366965987
            f2_too = f2_too*contrast_too + 14.441791366965987
            f3 = f3*contrast + 18.095902759683327
            f3_too = f3_too*contrast_too + 18.095902759683327
            f4 = f4*contrast + 4.753982175429124
            f4_too = f4_too*contrast_too + 4.753982175429124
            f5 = f5*contrast + -60.74509120243451
            f5_too = f5_too*contrast_too + -60.74509120243451
            f0 = f0*contrast + -17.883623120562746
            f0_too = f0_too*contrast_too + -17.883623120562746
            f1 = f1*contrast + -45.76581725750462
            f1_too = f1_too*contrast_too + -45.76581725750462
            f2 = f2*contrast + -14.916567436674686
            f2_too = f2_too*contrast_too + -14.916567436674686
            f3 = f3*contrast + 4.648725886576156
            f3_too = f3_too*contrast_too + 4.648725886576156
            f4 = f4*contrast + 28.159085497339756
            f4_too = f4_too*contrast_too + 28.159085497339756
            f5 = f5*contrast + 61.92903072228614
            f5_too = f5_too*contrast_too + 61.92903072228614
            f0 = f0*contrast + 188.91609113804486
            f0_too = f0_too*contrast_too + 188.91609113804486
            f1 = f1*contrast + -11.299198222135354
            f1_too = f1_too*contrast_too + -11.299198222135354
            f2 = f2*contrast + -21.907438278685532
            f2_too = f2_too*contrast_too + -21.907438278685532
            f3 = f3*contrast + -22.014130348551106
            f3_too = f3_too*contrast_too + -22.014130348551106
            f4 = f4*contrast + -20.218147178113846
            f4_too = f4_too*contrast_too + -20.218147178113846
            f5 = f5*contrast + 26.552988807288244
            f5_too = f5_too*contrast_too + 26.552988807288244
            f0 = f0*contrast + 339.7888386125262
            f0_too = f0_too*contrast_too + 339.7888386125262
            f1 = f1*contrast + 54.05731523378324
            f1_too = f1_too*contrast_too + 54.05731523378324
            f2 = f2*contrast + 11.583710407240257
            f2_too = f2_too*contrast_too + 11.583710407240257
            f3 = f3*contrast + -3.378582202109864
            f3_too = f3_too*contrast_too + -3.378582202109864
            f4 = f4*contrast + -25.339366515840215
            f4_too = f4_too*contrast_too + -25.339366515840215
            f5 = f5*contrast + -125.42986425339637
            f5_too = f5_too*contrast_too + -125.42986425339637
            f0 = f0*contrast + 315.0769230769107
            f0_too = f0_too*contrast_too + 315.0769230769107
            f1 = f1*contrast + 78.7692307692314
            f1_too = f1_too*contrast_too + 78.7692307692314
            f2 = f2*contrast + 39.384615384614875
            f2_too = f2_too*contrast_too + 39.384615384614875
            f3 = f3*contrast + 34.46153846153857
            f3_too = f3_too*contrast_too + 34.46153846153857
            f4 = f4*contrast + 51.6923076923081
            f4_too = f4_too*contrast_too + 51.6923076923081
            f5 = f5*contrast + 142.15384615384534
            f5_too = f5_too*contrast_too + 142.15384615384534
            f0 = f0*contrast + -1083.076923076923
            f0_too = f0_too*contrast_too + -1083.076923076923
            f1 = f1*contrast + -68.92307692307692
            f1_too = f1_too*contrast_too + -68.92307692307692
            f2 = f2*contrast + -11.076923076923077
            f2_too = f2_too*contrast_too + -11.076923076923077
            f3 = f3*contrast + 3.0769230769230758
            f3_too = f3_too*contrast_too + 3.0769230769230758
            f4 = f4*contrast + 26.923076923076923
            f4_too = f4_too*contrast_too + 26.923076923076923
            f5 = f5*contrast + 218.07692307692307
            f5_too = f5_too*contrast_too + 218.07692307692307
            f0 = f0*contrast + 1280.0
            f0_too = f0_too*contrast_too + 1280.0
            f1 = f1*contrast + 128.0
            f1_too = f1_too*contrast_too + 128.0
            f2 = f2*contrast + 48.0
            f2_too = f2_too*contrast_too + 48.0
            f3 = f3*contrast + 40.0
            f3_too = f3_too*contrast_too + 40.0
            f4 = f4*contrast + 70.0
            f4_too = f4_too*contrast_too + 70.0
            f5 = f5*contrast + 315.0
            f5_too = f5_too*contrast_too + 315.0
            keep_f0[i] = f0
            keep_f0[i + half] = f0_too
            keep_f1[i] = f1
            keep_f1[i + half] = f1_too
            keep_f2[i] = f2
            keep_f2[i + half] = f2_too
            keep_f3[i] = f3
            keep_f3[i + half] = f3_too
            keep_f4[i] = f4
            keep_f4[i + half] = f4_too
            keep_f5[i] = f5
            keep_f5[i + half] = f5_too
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            nu = some_nu[i]
            level = some_level[i]
            lost0 = some_lost0[i]
            lost1 = some_lost1[i]
            lost2 = some_lost2[i]
            lost3 = some_lost3[i]
            lost4 = some_lost4[i]
            lost5 = some_lost5[i]
            f0 = keep_f0[i]
            f1 = keep_f1[i]
            f2 = keep_f2[i]
            f3 = keep_f3[i]
            f4 = keep_f4[i]
            f5 = keep_f5[i]
            e0 = 2 - D33
            e1 = 2*D33 + 2
            density0 = e0*f0 + e1*f1
            density1 = e0*f1 + e1*f2
            density2 = e0*f2 + e1*f3
            density3 = e0*f3 + e1*f4
            density4 = e0*f4 + e1*f5
            lost_density0 = e0*lost0 + e1*lost1
            lost_density1 = e0*lost1 + e1*lost2
            lost_density2 = e0*lost2 + e1*lost3
            lost_density3 = e0*lost3 + e1*lost4
            lost_density4 = e0*lost4 + e1*lost5
            w0 = 2 - Dr33
            half_w1 = Dr33 + 1
            twice_w1 = 4*half_w1
            level_w0 = level*w0
            level_half_w1 = half_w1*level
            square0 = level_w0*w0
            square1 = level_w0*twice_w1
            square2 = level_half_w1*twice_w1
            sum0 = density0*square0 + density1*square1 + density2*square2
            sum1 = density1*square0 + density2*square1 + density3*square2
            sum2 = density2*square0 + density3*square1 + density4*square2
            taken0 = lost_density0*square0 + lost_density1*square1 + lost_density2*square2
            taken1 = lost_density1*square0 + lost_density2*square1 + lost_density3*square2
            taken2 = lost_density2*square0 + lost_density3*square1 + lost_density4*square2
            complement = 2 - nu
            served = (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (level > 0.0) & (lost0 >= 0.0)
            unserved += not served
            one_minus_lam = nu/complement if served else np.nan
            lam = 1 - one_minus_lam
            kept0 = sum0 - taken0
            kept1 = sum1 - taken1
            kept2 = sum2 - taken2
            shear0 = lam*taken0 + one_minus_lam*sum0
            quarter = lam*taken1 + one_minus_lam*sum1
            shear1 = 4*quarter
            both = kept0 + kept1
            later = kept1 + kept2
            along = kept1*lam + sum2
            C1111 = lam*(kept0 + 4*kept1) + 3*sum0
            C3333 = 8*along
            C1122 = shear0
            C1133 = shear1
            C2323 = lam*(both + 2*later) + shear1
            C1212 = 2*both*lam + shear0
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
        write_rows(columns, 6, 72, out[6*start:6*stop], streamed)
    return unserved
