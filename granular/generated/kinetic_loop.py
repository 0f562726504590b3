"""Moments of the kinetic fabric without slip: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``kinetic``; do not edit.
Source: (7), (20), (25), (26) of Pan & Dong (1999).
Domain: kinematic_kinetic: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, a <= 9*c, c <= 6*a.
Operations: 350 (580 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import scratch_of, write_rows

Array: TypeAlias = npt.NDArray[np.float64]


def kinematic_kinetic(all_D33: Array, all_Dr33: Array, all_SR: Array, all_nu: Array, out: Array, streamed: bool) -> int:
    """Six components over (M/V) l_e^2 k_n,ref when the stiffness of a contact follows its force, without slip.

    Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.

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
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 350.
    """
    third = 1/3
    unit = 1/443520
    scratch = scratch_of(1440)
    keep_a = scratch[0:64]
    keep_c = scratch[72:136]
    keep_f0 = scratch[144:208]
    keep_f1 = scratch[216:280]
    keep_f2 = scratch[288:352]
    keep_f3 = scratch[360:424]
    keep_f4 = scratch[432:496]
    keep_f5 = scratch[504:568]
    keep_lam = scratch[576:640]
    keep_level = scratch[648:712]
    keep_one_minus_lam = scratch[720:784]
    keep_root_a = scratch[792:856]
    keep_root_c = scratch[864:928]
    keep_v = scratch[936:1000]
    column_C1111 = scratch[1008:1072]
    column_C3333 = scratch[1080:1144]
    column_C1122 = scratch[1152:1216]
    column_C1133 = scratch[1224:1288]
    column_C2323 = scratch[1296:1360]
    column_C1212 = scratch[1368:1432]
    columns = scratch[1008:1440]
    unserved = 0
    for start in range(0, all_D33.size, 64):
        stop = min(start + 64, all_D33.size)
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
            one_minus_lam = nu*over_complement
            lam = 1 - one_minus_lam
            served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (a <= 9*c) & (c <= 6*a)
            unserved += not served
            level = roots*unit if served else np.nan
            v = over_roots*(-root_a + root_c)
            keep_lam[i] = lam
            keep_level[i] = level
            keep_one_minus_lam[i] = one_minus_lam
            keep_v[i] = v
        half = (stop - start + 1)//2
        for i in range(half):
            v = keep_v[i]
            v_too = keep_v[i + half]
            f1 = -0.681114526638451
            f1_too = -0.681114526638451
            f2 = -0.6448530994941937
            f2_too = -0.6448530994941937
            f3 = 1.3578204037912385
            f3_too = 1.3578204037912385
            f4 = -1.1453090253436675
            f4_too = -1.1453090253436675
            f1 = f1*v + 1.6230495115734476
            f1_too = f1_too*v_too + 1.6230495115734476
            f2 = f2*v + -2.0615131639337565
            f2_too = f2_too*v_too + -2.0615131639337565
            f3 = f3*v + 1.0001308104875504
            f3_too = f3_too*v_too + 1.0001308104875504
            f4 = f4*v + 0.9446767363215737
            f4_too = f4_too*v_too + 0.9446767363215737
            f5 = -2.82297396368279
            f5_too = -2.82297396368279
            f0 = -4.546318711523686
            f0_too = -4.546318711523686
            f1 = f1*v + 3.0258622050863377
            f1_too = f1_too*v_too + 3.0258622050863377
            f2 = f2*v + 0.26459272328021677
            f2_too = f2_too*v_too + 0.26459272328021677
            f3 = f3*v + -2.7146261734134396
            f3_too = f3_too*v_too + -2.7146261734134396
            f4 = f4*v + 3.001577654277903
            f4_too = f4_too*v_too + 3.001577654277903
            f5 = f5*v + -0.49894294272562195
            f5_too = f5_too*v_too + -0.49894294272562195
            f0 = f0*v + -3.119570333962791
            f0_too = f0_too*v_too + -3.119570333962791
            f1 = f1*v + -2.6650096693667598
            f1_too = f1_too*v_too + -2.6650096693667598
            f2 = f2*v + 4.239023330627392
            f2_too = f2_too*v_too + 4.239023330627392
            f3 = f3*v + -1.980997895160333
            f3_too = f3_too*v_too + -1.980997895160333
            f4 = f4*v + -2.43922093557402
            f4_too = f4_too*v_too + -2.43922093557402
            f5 = f5*v + 6.399088826535958
            f5_too = f5_too*v_too + 6.399088826535958
            f0 = f0*v + 8.878537664159156
            f0_too = f0_too*v_too + 8.878537664159156
            f1 = f1*v + -6.546511322612836
            f1_too = f1_too*v_too + -6.546511322612836
            f2 = f2*v + 0.3706640828750369
            f2_too = f2_too*v_too + 0.3706640828750369
            f3 = f3*v + 4.603490595267432
            f3_too = f3_too*v_too + 4.603490595267432
            f4 = f4*v + -4.946901400105296
            f4_too = f4_too*v_too + -4.946901400105296
            f5 = f5*v + -0.8811121188867673
            f5_too = f5_too*v_too + -0.8811121188867673
            f0 = f0*v + 9.892064566275682
            f0_too = f0_too*v_too + 9.892064566275682
            f1 = f1*v + 2.6038626781127148
            f1_too = f1_too*v_too + 2.6038626781127148
            f2 = f2*v + -6.936244936726151
            f2_too = f2_too*v_too + -6.936244936726151
            f3 = f3*v + 3.031342870960518
            f3_too = f3_too*v_too + 3.031342870960518
            f4 = f4*v + 5.209188581484684
            f4_too = f4_too*v_too + 5.209188581484684
            f5 = f5*v + -11.292788699818386
            f5_too = f5_too*v_too + -11.292788699818386
            f0 = f0*v + -12.4799749165955
            f0_too = f0_too*v_too + -12.4799749165955
            f1 = f1*v + 11.938888599247987
            f1_too = f1_too*v_too + 11.938888599247987
            f2 = f2*v + -1.6702435408934053
            f2_too = f2_too*v_too + -1.6702435408934053
            f3 = f3*v + -7.30108476530955
            f3_too = f3_too*v_too + -7.30108476530955
            f4 = f4*v + 6.736889084711712
            f4_too = f4_too*v_too + 6.736889084711712
            f5 = f5*v + 6.320279093235818
            f5_too = f5_too*v_too + 6.320279093235818
            f0 = f0*v + -25.964787484683303
            f0_too = f0_too*v_too + -25.964787484683303
            f1 = f1*v + 0.23473979078158907
            f1_too = f1_too*v_too + 0.23473979078158907
            f2 = f2*v + 10.254534254724458
            f2_too = f2_too*v_too + 10.254534254724458
            f3 = f3*v + -4.136779025020829
            f3_too = f3_too*v_too + -4.136779025020829
            f4 = f4*v + -9.969054345037073
            f4_too = f4_too*v_too + -9.969054345037073
            f5 = f5*v + 16.5005022146651
            f5_too = f5_too*v_too + 16.5005022146651
            f0 = f0*v + 5.708920950608579
            f0_too = f0_too*v_too + 5.708920950608579
            f1 = f1*v + -18.80336456724852
            f1_too = f1_too*v_too + -18.80336456724852
            f2 = f2*v + 4.271392333104574
            f2_too = f2_too*v_too + 4.271392333104574
            f3 = f3*v + 10.728191530070514
            f3_too = f3_too*v_too + 10.728191530070514
            f4 = f4*v + -7.189992271632052
            f4_too = f4_too*v_too + -7.189992271632052
            f5 = f5*v + -19.251296521803365
            f5_too = f5_too*v_too + -19.251296521803365
            f0 = f0*v + 49.24001791208917
            f0_too = f0_too*v_too + 49.24001791208917
            f1 = f1*v + -8.9039852418593
            f1_too = f1_too*v_too + -8.9039852418593
            f2 = f2*v + -13.525960996995131
            f2_too = f2_too*v_too + -13.525960996995131
            f3 = f3*v + 5.001472614523118
            f3_too = f3_too*v_too + 5.001472614523118
            f4 = f4*v + 16.789240885441274
            f4_too = f4_too*v_too + 16.789240885441274
            f5 = f5*v + -16.128675648415005
            f5_too = f5_too*v_too + -16.128675648415005
            f0 = f0*v + 25.46436858851001
            f0_too = f0_too*v_too + 25.46436858851001
            f1 = f1*v + 23.39989637869322
            f1_too = f1_too*v_too + 23.39989637869322
            f2 = f2*v + -8.572865622523768
            f2_too = f2_too*v_too + -8.572865622523768
            f3 = f3*v + -14.4909532955523
            f3_too = f3_too*v_too + -14.4909532955523
            f4 = f4*v + 4.0842765802638406
            f4_too = f4_too*v_too + 4.0842765802638406
            f5 = f5*v + 41.42820447574571
            f5_too = f5_too*v_too + 41.42820447574571
            f0 = f0*v + -69.01523114238569
            f0_too = f0_too*v_too + -69.01523114238569
            f1 = f1*v + 25.59620057648662
            f1_too = f1_too*v_too + 25.59620057648662
            f2 = f2*v + 15.478994399700156
            f2_too = f2_too*v_too + 15.478994399700156
            f3 = f3*v + -5.23869099628221
            f3_too = f3_too*v_too + -5.23869099628221
            f4 = f4*v + -24.058001459512962
            f4_too = f4_too*v_too + -24.058001459512962
            f5 = f5*v + -4.224094844804309
            f5_too = f5_too*v_too + -4.224094844804309
            f0 = f0*v + -118.80474942602964
            f0_too = f0_too*v_too + -118.80474942602964
            f1 = f1*v + -16.9211118296269
            f1_too = f1_too*v_too + -16.9211118296269
            f2 = f2*v + 14.441791366965987
            f2_too = f2_too*v_too + 14.441791366965987
            f3 = f3*v + 18.095902759683327
            f3_too = f3_too*v_too + 18.095902759683327
            f4 = f4*v + 4.753982175429124
            f4_too = f4_too*v_too + 4.753982175429124
            f5 = f5*v + -60.74509120243451
            f5_too = f5_too*v_too + -60.74509120243451
            f0 = f0*v + -17.883623120562746
            f0_too = f0_too*v_too + -17.883623120562746
            f1 = f1*v + -45.76581725750462
            f1_too = f1_too*v_too + -45.76581725750462
            f2 = f2*v + -14.916567436674686
            f2_too = f2_too*v_too + -14.916567436674686
            f3 = f3*v + 4.648725886576156
            f3_too = f3_too*v_too + 4.648725886576156
            f4 = f4*v + 28.159085497339756
            f4_too = f4_too*v_too + 28.159085497339756
            f5 = f5*v + 61.92903072228614
            f5_too = f5_too*v_too + 61.92903072228614
            f0 = f0*v + 188.91609113804486
            f0_too = f0_too*v_too + 188.91609113804486
            f1 = f1*v + -11.299198222135354
            f1_too = f1_too*v_too + -11.299198222135354
            f2 = f2*v + -21.907438278685532
            f2_too = f2_too*v_too + -21.907438278685532
            f3 = f3*v + -22.014130348551106
            f3_too = f3_too*v_too + -22.014130348551106
            f4 = f4*v + -20.218147178113846
            f4_too = f4_too*v_too + -20.218147178113846
            f5 = f5*v + 26.552988807288244
            f5_too = f5_too*v_too + 26.552988807288244
            f0 = f0*v + 339.7888386125262
            f0_too = f0_too*v_too + 339.7888386125262
            f1 = f1*v + 54.05731523378324
            f1_too = f1_too*v_too + 54.05731523378324
            f2 = f2*v + 11.583710407240257
            f2_too = f2_too*v_too + 11.583710407240257
            f3 = f3*v + -3.378582202109864
            f3_too = f3_too*v_too + -3.378582202109864
            f4 = f4*v + -25.339366515840215
            f4_too = f4_too*v_too + -25.339366515840215
            f5 = f5*v + -125.42986425339637
            f5_too = f5_too*v_too + -125.42986425339637
            f0 = f0*v + 315.0769230769107
            f0_too = f0_too*v_too + 315.0769230769107
            f1 = f1*v + 78.7692307692314
            f1_too = f1_too*v_too + 78.7692307692314
            f2 = f2*v + 39.384615384614875
            f2_too = f2_too*v_too + 39.384615384614875
            f3 = f3*v + 34.46153846153857
            f3_too = f3_too*v_too + 34.46153846153857
            f4 = f4*v + 51.6923076923081
            f4_too = f4_too*v_too + 51.6923076923081
            f5 = f5*v + 142.15384615384534
            f5_too = f5_too*v_too + 142.15384615384534
            f0 = f0*v + -1083.076923076923
            f0_too = f0_too*v_too + -1083.076923076923
            f1 = f1*v + -68.92307692307692
            f1_too = f1_too*v_too + -68.92307692307692
            f2 = f2*v + -11.076923076923077
            f2_too = f2_too*v_too + -11.076923076923077
            f3 = f3*v + 3.0769230769230758
            f3_too = f3_too*v_too + 3.0769230769230758
            f4 = f4*v + 26.923076923076923
            f4_too = f4_too*v_too + 26.923076923076923
            f5 = f5*v + 218.07692307692307
            f5_too = f5_too*v_too + 218.07692307692307
            f0 = f0*v + 1280.0
            f0_too = f0_too*v_too + 1280.0
            f1 = f1*v + 128.0
            f1_too = f1_too*v_too + 128.0
            f2 = f2*v + 48.0
            f2_too = f2_too*v_too + 48.0
            f3 = f3*v + 40.0
            f3_too = f3_too*v_too + 40.0
            f4 = f4*v + 70.0
            f4_too = f4_too*v_too + 70.0
            f5 = f5*v + 315.0
            f5_too = f5_too*v_too + 315.0
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
            f0 = keep_f0[i]
            f1 = keep_f1[i]
            f2 = keep_f2[i]
            f3 = keep_f3[i]
            f4 = keep_f4[i]
            f5 = keep_f5[i]
            lam = keep_lam[i]
            level = keep_level[i]
            one_minus_lam = keep_one_minus_lam[i]
            e0 = 2 - D33
            e1 = 2*D33 + 2
            density0 = e0*f0 + e1*f1
            density1 = e0*f1 + e1*f2
            density2 = e0*f2 + e1*f3
            density3 = e0*f3 + e1*f4
            density4 = e0*f4 + e1*f5
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
            four_r1 = 4*sum1
            both = sum0 + sum1
            later = sum1 + sum2
            along = lam*sum1 + sum2
            C1111 = lam*(four_r1 + sum0) + 3*sum0
            C3333 = 8*along
            C1122 = one_minus_lam*sum0
            C1133 = four_r1*one_minus_lam
            C2323 = C1133 + lam*(both + 2*later)
            C1212 = C1122 + 2*both*lam
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
        write_rows(columns, 6, 72, out[6*start:6*stop], streamed)
    return unserved
