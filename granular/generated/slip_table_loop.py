"""Partial slip about its onset: what a table can hold: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``slip_table``; do not edit.
Source: (20), (21), (23) of Pan & Dong (1999).
Domain: slip_state: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, equator_part <= 9*pole_part, pole_part <= 6*equator_part.
Operations: 347 (7736 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def slip_state(all_D33: Array, all_Dr33: Array, all_SR: Array, all_nu: Array, out: Array) -> int:
    """The sums of the normal stiffness, their level, the cubic contrast of the forces, 1 - k_r/k_n.

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
        sum0, sum1, sum2, level, v, one_minus_lam, each for all elements, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 347.
    """
    third = 1/3
    unit = 1/443520
    scratch = np.ones(1008)
    keep_a = scratch[0:64]
    keep_c = scratch[72:136]
    keep_equator_part = scratch[144:208]
    keep_f0 = scratch[216:280]
    keep_f1 = scratch[288:352]
    keep_f2 = scratch[360:424]
    keep_f3 = scratch[432:496]
    keep_f4 = scratch[504:568]
    keep_f5 = scratch[576:640]
    keep_level = scratch[648:712]
    keep_pole_part = scratch[720:784]
    keep_root_a = scratch[792:856]
    keep_root_c = scratch[864:928]
    keep_v = scratch[936:1000]
    unserved = 0
    for start in range(0, all_D33.size, 64):
        stop = min(start + 64, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_SR = all_SR[start:stop]
        some_nu = all_nu[start:stop]
        some_sum0 = out[0*all_D33.size:1*all_D33.size][start:stop]
        some_sum1 = out[1*all_D33.size:2*all_D33.size][start:stop]
        some_sum2 = out[2*all_D33.size:3*all_D33.size][start:stop]
        some_level = out[3*all_D33.size:4*all_D33.size][start:stop]
        some_v = out[4*all_D33.size:5*all_D33.size][start:stop]
        some_one_minus_lam = out[5*all_D33.size:6*all_D33.size][start:stop]
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
            keep_pole_part[i] = pole_part
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
            start_a = -0.09765625
            start_a_too = -0.09765625
            start_c = -0.09765625
            start_c_too = -0.09765625
            start_a = start_a*less_a + 0.3876953125
            start_a_too = start_a_too*less_a_too + 0.3876953125
            start_c = start_c*less_c + 0.3876953125
            start_c_too = start_c_too*less_c_too + 0.3876953125
            start_a = start_a*less_a + -0.45849609375
            start_a_too = start_a_too*less_a_too + -0.45849609375
            start_c = start_c*less_c + -0.45849609375
            start_c_too = start_c_too*less_c_too + -0.45849609375
            start_a = start_a*less_a + 0.186279296875
            start_a_too = start_a_too*less_a_too + 0.186279296875
            start_c = start_c*less_c + 0.186279296875
            start_c_too = start_c_too*less_c_too + 0.186279296875
            start_a = start_a*less_a + -0.23828125
            start_a_too = start_a_too*less_a_too + -0.23828125
            start_c = start_c*less_c + -0.23828125
            start_c_too = start_c_too*less_c_too + -0.23828125
            start_a = start_a*less_a + 1.0
            start_a_too = start_a_too*less_a_too + 1.0
            start_c = start_c*less_c + 1.0
            start_c_too = start_c_too*less_c_too + 1.0
            squared_a = start_a*start_a
            squared_a_too = start_a_too*start_a_too
            squared_c = start_c*start_c
            squared_c_too = start_c_too*start_c_too
            rest_a = -a*squared_a*start_a + 1
            rest_a_too = -a_too*squared_a_too*start_a_too + 1
            rest_c = -c*squared_c*start_c + 1
            rest_c_too = -c_too*squared_c_too*start_c_too + 1
            gain_a = 0.11095869532083524
            gain_a_too = 0.11095869532083524
            gain_c = 0.11095869532083524
            gain_c_too = 0.11095869532083524
            gain_a = gain_a*rest_a + 0.12482853223593965
            gain_a_too = gain_a_too*rest_a_too + 0.12482853223593965
            gain_c = gain_c*rest_c + 0.12482853223593965
            gain_c_too = gain_c_too*rest_c_too + 0.12482853223593965
            gain_a = gain_a*rest_a + 0.1440329218106996
            gain_a_too = gain_a_too*rest_a_too + 0.1440329218106996
            gain_c = gain_c*rest_c + 0.1440329218106996
            gain_c_too = gain_c_too*rest_c_too + 0.1440329218106996
            gain_a = gain_a*rest_a + 0.1728395061728395
            gain_a_too = gain_a_too*rest_a_too + 0.1728395061728395
            gain_c = gain_c*rest_c + 0.1728395061728395
            gain_c_too = gain_c_too*rest_c_too + 0.1728395061728395
            gain_a = gain_a*rest_a + 0.2222222222222222
            gain_a_too = gain_a_too*rest_a_too + 0.2222222222222222
            gain_c = gain_c*rest_c + 0.2222222222222222
            gain_c_too = gain_c_too*rest_c_too + 0.2222222222222222
            gain_a = gain_a*rest_a + 0.3333333333333333
            gain_a_too = gain_a_too*rest_a_too + 0.3333333333333333
            gain_c = gain_c*rest_c + 0.3333333333333333
            gain_c_too = gain_c_too*rest_c_too + 0.3333333333333333
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
            equator_part = keep_equator_part[i]
            pole_part = keep_pole_part[i]
            root_a = keep_root_a[i]
            root_c = keep_root_c[i]
            complement = 2 - nu
            roots = root_a + root_c
            reciprocal = 1/(complement*roots)
            over_roots = complement*reciprocal
            over_complement = reciprocal*roots
            one_minus_lam = nu*over_complement
            lam = 1 - one_minus_lam
            served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (equator_part <= 9*pole_part) & (pole_part <= 6*equator_part)
            unserved += not served
            level = roots*unit if served else np.nan
            v = over_roots*(-root_a + root_c)
            keep_level[i] = level
            keep_v[i] = v
            some_level[i] = level
            some_v[i] = v
            some_one_minus_lam[i] = one_minus_lam
        half = (stop - start + 1)//2
        for i in range(half):
            v = keep_v[i]
            v_too = keep_v[i + half]
            f1 = -1.127008120885365
            f1_too = -1.127008120885365
            f2 = 0.8839119593836494
            f2_too = 0.8839119593836494
            f3 = -0.1580949141442354
            f3_too = -0.1580949141442354
            f4 = -0.7382162053420058
            f4_too = -0.7382162053420058
            f0 = 2.0281187593279353
            f0_too = 2.0281187593279353
            f1 = f1*v + -1.289698911916548
            f1_too = f1_too*v_too + -1.289698911916548
            f2 = f2*v + -0.16754064142702293
            f2_too = f2_too*v_too + -0.16754064142702293
            f3 = f3*v + 1.2724491501533515
            f3_too = f3_too*v_too + 1.2724491501533515
            f4 = f4*v + -1.5439457762283508
            f4_too = f4_too*v_too + -1.5439457762283508
            f5 = -0.06381189564321746
            f5_too = -0.06381189564321746
            f0 = f0*v + 0.4038307676315138
            f0_too = f0_too*v_too + 0.4038307676315138
            f1 = f1*v + 1.9904366903562027
            f1_too = f1_too*v_too + 1.9904366903562027
            f2 = f2*v + -2.349654762057456
            f2_too = f2_too*v_too + -2.349654762057456
            f3 = f3*v + 1.0516673020274019
            f3_too = f3_too*v_too + 1.0516673020274019
            f4 = f4*v + 1.1853237769118847
            f4_too = f4_too*v_too + 1.1853237769118847
            f5 = f5*v + -2.855518030460831
            f5_too = f5_too*v_too + -2.855518030460831
            f0 = f0*v + -5.488884065791915
            f0_too = f0_too*v_too + -5.488884065791915
            f1 = f1*v + 3.251868536740753
            f1_too = f1_too*v_too + 3.251868536740753
            f2 = f2*v + 0.08733605960256001
            f2_too = f2_too*v_too + 0.08733605960256001
            f3 = f3*v + -2.6829223631774592
            f3_too = f3_too*v_too + -2.6829223631774592
            f4 = f4*v + 3.1496169926334425
            f4_too = f4_too*v_too + 3.1496169926334425
            f5 = f5*v + -0.4788087422117175
            f5_too = f5_too*v_too + -0.4788087422117175
            f0 = f0*v + -3.290228764813496
            f0_too = f0_too*v_too + -3.290228764813496
            f1 = f1*v + -2.712327543512398
            f1_too = f1_too*v_too + -2.712327543512398
            f2 = f2*v + 4.276134717914542
            f2_too = f2_too*v_too + 4.276134717914542
            f3 = f3*v + -1.9876355715993155
            f3_too = f3_too*v_too + -1.9876355715993155
            f4 = f4*v + -2.4702152299799938
            f4_too = f4_too*v_too + -2.4702152299799938
            f5 = f5*v + 6.410492389575234
            f5_too = f5_too*v_too + 6.410492389575234
            f0 = f0*v + 9.05828465887658
            f0_too = f0_too*v_too + 9.05828465887658
            f1 = f1*v + -6.581248950769799
            f1_too = f1_too*v_too + -6.581248950769799
            f2 = f2*v + 0.39790878892421877
            f2_too = f2_too*v_too + 0.39790878892421877
            f3 = f3*v + 4.598617655810052
            f3_too = f3_too*v_too + 4.598617655810052
            f4 = f4*v + -4.969655344433994
            f4_too = f4_too*v_too + -4.969655344433994
            f5 = f5*v + -0.8836334050852646
            f5_too = f5_too*v_too + -0.8836334050852646
            f0 = f0*v + 9.920759410715927
            f0_too = f0_too*v_too + 9.920759410715927
            f1 = f1*v + 2.6068678526260234
            f1_too = f1_too*v_too + 2.6068678526260234
            f2 = f2*v + -6.9386018937374825
            f2_too = f2_too*v_too + -6.9386018937374825
            f3 = f3*v + 3.031764432081388
            f3_too = f3_too*v_too + 3.031764432081388
            f4 = f4*v + 5.211157039816521
            f4_too = f4_too*v_too + 5.211157039816521
            f5 = f5*v + -11.294420223424808
            f5_too = f5_too*v_too + -11.294420223424808
            f0 = f0*v + -12.498197308348882
            f0_too = f0_too*v_too + -12.498197308348882
            f1 = f1*v + 11.941737821282828
            f1_too = f1_too*v_too + 11.941737821282828
            f2 = f2*v + -1.6724781844464234
            f2_too = f2_too*v_too + -1.6724781844464234
            f3 = f3*v + -7.300685080955348
            f3_too = f3_too*v_too + -7.300685080955348
            f4 = f4*v + 6.738755390588093
            f4_too = f4_too*v_too + 6.738755390588093
            f5 = f5*v + 6.320437814359273
            f5_too = f5_too*v_too + 6.320437814359273
            f0 = f0*v + -25.967255356561367
            f0_too = f0_too*v_too + -25.967255356561367
            f1 = f1*v + 0.23464705643670614
            f1_too = f1_too*v_too + 0.23464705643670614
            f2 = f2*v + 10.254606986229199
            f2_too = f2_too*v_too + 10.254606986229199
            f3 = f3*v + -4.136792033647848
            f3_too = f3_too*v_too + -4.136792033647848
            f4 = f4*v + -9.96911508816298
            f4_too = f4_too*v_too + -9.96911508816298
            f5 = f5*v + 16.500624421739914
            f5_too = f5_too*v_too + 16.500624421739914
            f0 = f0*v + 5.709979185989808
            f0_too = f0_too*v_too + 5.709979185989808
            f1 = f1*v + -18.803498481028065
            f1_too = f1_too*v_too + -18.803498481028065
            f2 = f2*v + 4.271497361621296
            f2_too = f2_too*v_too + 4.271497361621296
            f3 = f3*v + 10.728172744857623
            f3_too = f3_too*v_too + 10.728172744857623
            f4 = f4*v + -7.190079988233513
            f4_too = f4_too*v_too + -7.190079988233513
            f5 = f5*v + -19.251301746478575
            f5_too = f5_too*v_too + -19.251301746478575
            f0 = f0*v + 49.24013351177756
            f0_too = f0_too*v_too + 49.24013351177756
            f1 = f1*v + -8.903984327190697
            f1_too = f1_too*v_too + -8.903984327190697
            f2 = f2*v + -13.525961714369302
            f2_too = f2_too*v_too + -13.525961714369302
            f3 = f3*v + 5.001472742831381
            f3_too = f3_too*v_too + 5.001472742831381
            f4 = f4*v + 16.789241484570216
            f4_too = f4_too*v_too + 16.789241484570216
            f5 = f5*v + -16.128680747939512
            f5_too = f5_too*v_too + -16.128680747939512
            f0 = f0*v + 25.464333426291123
            f0_too = f0_too*v_too + 25.464333426291123
            f1 = f1*v + 23.399899971839027
            f1_too = f1_too*v_too + 23.399899971839027
            f2 = f2*v + -8.572868440626399
            f2_too = f2_too*v_too + -8.572868440626399
            f3 = f3*v + -14.490952791511496
            f3_too = f3_too*v_too + -14.490952791511496
            f4 = f4*v + 4.084278933856874
            f4_too = f4_too*v_too + 4.084278933856874
            f5 = f5*v + 41.428204559348906
            f5_too = f5_too*v_too + 41.428204559348906
            f0 = f0*v + -69.01523403031084
            f0_too = f0_too*v_too + -69.01523403031084
            f1 = f1*v + 25.596200592380644
            f1_too = f1_too*v_too + 25.596200592380644
            f2 = f2*v + 15.47899438723448
            f2_too = f2_too*v_too + 15.47899438723448
            f3 = f3*v + -5.238690994052622
            f3_too = f3_too*v_too + -5.238690994052622
            f4 = f4*v + -24.05800144910201
            f4_too = f4_too*v_too + -24.05800144910201
            f5 = f5*v + -4.2240947286106865
            f5_too = f5_too*v_too + -4.2240947286106865
            f0 = f0*v + -118.80474879999404
            f0_too = f0_too*v_too + -118.80474879999404
            f1 = f1*v + -16.92111188107454
            f1_too = f1_too*v_too + -16.92111188107454
            f2 = f2*v + 14.44179140731635
            f2_too = f2_too*v_too + 14.44179140731635
            f3 = f3*v + 18.095902752466333
            f3_too = f3_too*v_too + 18.095902752466333
            f4 = f4*v + 4.753982141729736
            f4_too = f4_too*v_too + 4.753982141729736
            f5 = f5*v + -60.74509120292158
            f5_too = f5_too*v_too + -60.74509120292158
            f0 = f0*v + -17.88362308587936
            f0_too = f0_too*v_too + -17.88362308587936
            f1 = f1*v + -45.76581725788825
            f1_too = f1_too*v_too + -45.76581725788825
            f2 = f2*v + -14.916567436373807
            f2_too = f2_too*v_too + -14.916567436373807
            f3 = f3*v + 4.6487258865223415
            f3_too = f3_too*v_too + 4.6487258865223415
            f4 = f4*v + 28.159085497088473
            f4_too = f4_too*v_too + 28.159085497088473
            f5 = f5*v + 61.92903072097954
            f5_too = f5_too*v_too + 61.92903072097954
            f0 = f0*v + 188.9160911329836
            f0_too = f0_too*v_too + 188.9160911329836
            f1 = f1*v + -11.299198221802731
            f1_too = f1_too*v_too + -11.299198221802731
            f2 = f2*v + -21.907438278946408
            f2_too = f2_too*v_too + -21.907438278946408
            f3 = f3*v + -22.014130348504448
            f3_too = f3_too*v_too + -22.014130348504448
            f4 = f4*v + -20.21814717789597
            f4_too = f4_too*v_too + -20.21814717789597
            f5 = f5*v + 26.552988807287875
            f5_too = f5_too*v_too + 26.552988807287875
            f0 = f0*v + 339.7888386123718
            f0_too = f0_too*v_too + 339.7888386123718
            f1 = f1*v + 54.05731523378518
            f1_too = f1_too*v_too + 54.05731523378518
            f2 = f2*v + 11.583710407238737
            f2_too = f2_too*v_too + 11.583710407238737
            f3 = f3*v + -3.3785822021095924
            f3_too = f3_too*v_too + -3.3785822021095924
            f4 = f4*v + -25.339366515838947
            f4_too = f4_too*v_too + -25.339366515838947
            f5 = f5*v + -125.42986425339075
            f5_too = f5_too*v_too + -125.42986425339075
            f0 = f0*v + 315.07692307692275
            f0_too = f0_too*v_too + 315.07692307692275
            f1 = f1*v + 78.76923076923077
            f1_too = f1_too*v_too + 78.76923076923077
            f2 = f2*v + 39.38461538461537
            f2_too = f2_too*v_too + 39.38461538461537
            f3 = f3*v + 34.461538461538474
            f3_too = f3_too*v_too + 34.461538461538474
            f4 = f4*v + 51.692307692307686
            f4_too = f4_too*v_too + 51.692307692307686
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
            level = keep_level[i]
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
            some_sum0[i] = sum0
            some_sum1[i] = sum1
            some_sum2[i] = sum2
    return unserved
