"""Stiffness with constant contact stiffness, static hypothesis: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``static_constant``; do not edit.
Source: (2), (23), (24), Figure 1(b) of Pan & Dong (1999).
Domain: static_constant: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, w1 <= 9*w0, w0 <= 9*w1.
Operations: 292 (340 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from numpy import sqrt

from granular.generated.rows import scratch_of, write_rows

Array: TypeAlias = npt.NDArray[np.float64]


def static_constant(all_D33: Array, all_Dr33: Array, all_nu: Array, out: Array, streamed: bool) -> int:
    """Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.

    Served for branch lengths at pole and equator within a factor 9.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
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

    Operations: 292.
    """
    scratch = scratch_of(1224)
    keep_h0 = scratch[0:64]
    keep_h1 = scratch[72:136]
    keep_h2 = scratch[144:208]
    keep_h3 = scratch[216:280]
    keep_inverse_ratio = scratch[288:352]
    keep_inverse_spread = scratch[360:424]
    keep_mean_length = scratch[432:496]
    keep_spread = scratch[504:568]
    keep_v = scratch[576:640]
    keep_w0 = scratch[648:712]
    keep_w1 = scratch[720:784]
    column_C1111 = scratch[792:856]
    column_C3333 = scratch[864:928]
    column_C1122 = scratch[936:1000]
    column_C1133 = scratch[1008:1072]
    column_C2323 = scratch[1080:1144]
    column_C1212 = scratch[1152:1216]
    columns = scratch[792:1224]
    unserved = 0
    for start in range(0, all_D33.size, 64):
        stop = min(start + 64, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_nu = all_nu[start:stop]
        for i in range(stop - start):
            Dr33 = some_Dr33[i]
            w0 = 2 - Dr33
            w1 = 2*Dr33 + 2
            ratio = w1/w0
            square_root = sqrt(ratio)
            root = sqrt(square_root)
            plus = root + 1
            v = (root - 1)/plus
            spread = plus/4 + root/4 + square_root/4
            inverse_spread = 1/spread
            inverse_ratio = w0/w1
            mean_length = spread*w0
            keep_inverse_ratio[i] = inverse_ratio
            keep_inverse_spread[i] = inverse_spread
            keep_mean_length[i] = mean_length
            keep_spread[i] = spread
            keep_v[i] = v
            keep_w0[i] = w0
            keep_w1[i] = w1
        half = (stop - start + 1)//2
        for i in range(half):
            v = keep_v[i]
            v_too = keep_v[i + half]
            h0 = -2470.9337528082315
            h0_too = -2470.9337528082315
            h1 = -712.2146378033709
            h1_too = -712.2146378033709
            h2 = -383.53506537485913
            h2_too = -383.53506537485913
            h3 = -1324.8423475841669
            h3_too = -1324.8423475841669
            h0 = h0*v + 1712.614598276011
            h0_too = h0_too*v_too + 1712.614598276011
            h1 = h1*v + 552.2329295083438
            h1_too = h1_too*v_too + 552.2329295083438
            h2 = h2*v + -312.9875646204825
            h2_too = h2_too*v_too + -312.9875646204825
            h3 = h3*v + -972.9567701192093
            h3_too = h3_too*v_too + -972.9567701192093
            h0 = h0*v + 3002.187209448274
            h0_too = h0_too*v_too + 3002.187209448274
            h1 = h1*v + 871.3434759890511
            h1_too = h1_too*v_too + 871.3434759890511
            h2 = h2*v + 471.18915593598626
            h2_too = h2_too*v_too + 471.18915593598626
            h3 = h3*v + 1614.8875154651082
            h3_too = h3_too*v_too + 1614.8875154651082
            h0 = h0*v + -1998.4984479769555
            h0_too = h0_too*v_too + -1998.4984479769555
            h1 = h1*v + -654.4701620341945
            h1_too = h1_too*v_too + -654.4701620341945
            h2 = h2*v + 373.7048933509737
            h2_too = h2_too*v_too + 373.7048933509737
            h3 = h3*v + 1144.152561353229
            h3_too = h3_too*v_too + 1144.152561353229
            h0 = h0*v + -2558.9000721431185
            h0_too = h0_too*v_too + -2558.9000721431185
            h1 = h1*v + -750.2241037100641
            h1_too = h1_too*v_too + -750.2241037100641
            h2 = h2*v + -408.0426475541776
            h2_too = h2_too*v_too + -408.0426475541776
            h3 = h3*v + -1382.873681474101
            h3_too = h3_too*v_too + -1382.873681474101
            h0 = h0*v + 1629.109886054949
            h0_too = h0_too*v_too + 1629.109886054949
            h1 = h1*v + 546.07606987633
            h1_too = h1_too*v_too + 546.07606987633
            h2 = h2*v + -315.5183450740541
            h2_too = h2_too*v_too + -315.5183450740541
            h3 = h3*v + -943.5233351865458
            h3_too = h3_too*v_too + -943.5233351865458
            h0 = h0*v + 2002.0585971820692
            h0_too = h0_too*v_too + 2002.0585971820692
            h1 = h1*v + 594.3897452790802
            h1_too = h1_too*v_too + 594.3897452790802
            h2 = h2*v + 325.825618592248
            h2_too = h2_too*v_too + 325.825618592248
            h3 = h3*v + 1088.1244636107356
            h3_too = h3_too*v_too + 1088.1244636107356
            h0 = h0*v + -1208.7709352758814
            h0_too = h0_too*v_too + -1208.7709352758814
            h1 = h1*v + -417.63191982573323
            h1_too = h1_too*v_too + -417.63191982573323
            h2 = h2*v + 244.92394576129686
            h2_too = h2_too*v_too + 244.92394576129686
            h3 = h3*v + 710.6277501300734
            h3_too = h3_too*v_too + 710.6277501300734
            h0 = h0*v + -1511.0295253107386
            h0_too = h0_too*v_too + -1511.0295253107386
            h1 = h1*v + -455.22818259045835
            h1_too = h1_too*v_too + -455.22818259045835
            h2 = h2*v + -251.7946832861158
            h2_too = h2_too*v_too + -251.7946832861158
            h3 = h3*v + -826.5545443610919
            h3_too = h3_too*v_too + -826.5545443610919
            h0 = h0*v + 853.8349461961445
            h0_too = h0_too*v_too + 853.8349461961445
            h1 = h1*v + 306.285574608125
            h1_too = h1_too*v_too + 306.285574608125
            h2 = h2*v + -183.16643602690274
            h2_too = h2_too*v_too + -183.16643602690274
            h3 = h3*v + -511.28084820194135
            h3_too = h3_too*v_too + -511.28084820194135
            h0 = h0*v + 1101.1367238115474
            h0_too = h0_too*v_too + 1101.1367238115474
            h1 = h1*v + 337.3502592925289
            h1_too = h1_too*v_too + 337.3502592925289
            h2 = h2*v + 188.82164024166138
            h2_too = h2_too*v_too + 188.82164024166138
            h3 = h3*v + 606.5719940542596
            h3_too = h3_too*v_too + 606.5719940542596
            h0 = h0*v + -571.2516643592382
            h0_too = h0_too*v_too + -571.2516643592382
            h1 = h1*v + -214.72863364265018
            h1_too = h1_too*v_too + -214.72863364265018
            h2 = h2*v + 131.4908817525072
            h2_too = h2_too*v_too + 131.4908817525072
            h3 = h3*v + 349.88088710901144
            h3_too = h3_too*v_too + 349.88088710901144
            h0 = h0*v + -768.4326986816257
            h0_too = h0_too*v_too + -768.4326986816257
            h1 = h1*v + -239.88971700249786
            h1_too = h1_too*v_too + -239.88971700249786
            h2 = h2*v + -136.1157058229767
            h2_too = h2_too*v_too + -136.1157058229767
            h3 = h3*v + -426.3233263006157
            h3_too = h3_too*v_too + -426.3233263006157
            h0 = h0*v + 355.69185860861023
            h0_too = h0_too*v_too + 355.69185860861023
            h1 = h1*v + 141.84450704963558
            h1_too = h1_too*v_too + 141.84450704963558
            h2 = h2*v + -89.79460792546833
            h2_too = h2_too*v_too + -89.79460792546833
            h3 = h3*v + -223.99576720908271
            h3_too = h3_too*v_too + -223.99576720908271
            h0 = h0*v + 507.27797194187235
            h0_too = h0_too*v_too + 507.27797194187235
            h1 = h1*v + 161.5258265291901
            h1_too = h1_too*v_too + 161.5258265291901
            h2 = h2*v + 93.4761146289665
            h2_too = h2_too*v_too + 93.4761146289665
            h3 = h3*v + 283.0769966414344
            h3_too = h3_too*v_too + 283.0769966414344
            h0 = h0*v + -200.41758849362935
            h0_too = h0_too*v_too + -200.41758849362935
            h1 = h1*v + -86.1716281307453
            h1_too = h1_too*v_too + -86.1716281307453
            h2 = h2*v + 56.91248275060036
            h2_too = h2_too*v_too + 56.91248275060036
            h3 = h3*v + 130.5144802979583
            h3_too = h3_too*v_too + 130.5144802979583
            h0 = h0*v + -311.498004573492
            h0_too = h0_too*v_too + -311.498004573492
            h1 = h1*v + -100.82065715447638
            h1_too = h1_too*v_too + -100.82065715447638
            h2 = h2*v + -59.700390424555984
            h2_too = h2_too*v_too + -59.700390424555984
            h3 = h3*v + -173.8490405353263
            h3_too = h3_too*v_too + -173.8490405353263
            h0 = h0*v + 97.71122994602199
            h0_too = h0_too*v_too + 97.71122994602199
            h1 = h1*v + 46.10228986683698
            h1_too = h1_too*v_too + 46.10228986683698
            h2 = h2*v + -32.63842040303719
            h2_too = h2_too*v_too + -32.63842040303719
            h3 = h3*v + -65.95365418866585
            h3_too = h3_too*v_too + -65.95365418866585
            h0 = h0*v + 174.3589743589691
            h0_too = h0_too*v_too + 174.3589743589691
            h1 = h1*v + 56.205128205126705
            h1_too = h1_too*v_too + 56.205128205126705
            h2 = h2*v + 34.638694638693835
            h2_too = h2_too*v_too + 34.638694638693835
            h3 = h3*v + 95.34965034964755
            h3_too = h3_too*v_too + 95.34965034964755
            h0 = h0*v + -38.34032634032544
            h0_too = h0_too*v_too + -38.34032634032544
            h1 = h1*v + -19.841491841491557
            h1_too = h1_too*v_too + -19.841491841491557
            h2 = h2*v + 15.477855477855318
            h2_too = h2_too*v_too + 15.477855477855318
            h3 = h3*v + 26.340326340325834
            h3_too = h3_too*v_too + 26.340326340325834
            h0 = h0*v + -88.72727272727272
            h0_too = h0_too*v_too + -88.72727272727272
            h1 = h1*v + -25.939393939393938
            h1_too = h1_too*v_too + -25.939393939393938
            h2 = h2*v + -16.727272727272727
            h2_too = h2_too*v_too + -16.727272727272727
            h3 = h3*v + -43.93939393939394
            h3_too = h3_too*v_too + -43.93939393939394
            h0 = h0*v + 10.666666666666666
            h0_too = h0_too*v_too + 10.666666666666666
            h1 = h1*v + 5.333333333333333
            h1_too = h1_too*v_too + 5.333333333333333
            h2 = h2*v + -5.333333333333333
            h2_too = h2_too*v_too + -5.333333333333333
            h3 = h3*v + -6.666666666666666
            h3_too = h3_too*v_too + -6.666666666666666
            h0 = h0*v + 48.0
            h0_too = h0_too*v_too + 48.0
            h1 = h1*v + 8.0
            h1_too = h1_too*v_too + 8.0
            h2 = h2*v + 6.0
            h2_too = h2_too*v_too + 6.0
            h3 = h3*v + 15.0
            h3_too = h3_too*v_too + 15.0
            keep_h0[i] = h0
            keep_h0[i + half] = h0_too
            keep_h1[i] = h1
            keep_h1[i + half] = h1_too
            keep_h2[i] = h2
            keep_h2[i + half] = h2_too
            keep_h3[i] = h3
            keep_h3[i + half] = h3_too
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            nu = some_nu[i]
            h0 = keep_h0[i]
            h1 = keep_h1[i]
            h2 = keep_h2[i]
            h3 = keep_h3[i]
            inverse_ratio = keep_inverse_ratio[i]
            inverse_spread = keep_inverse_spread[i]
            mean_length = keep_mean_length[i]
            spread = keep_spread[i]
            w0 = keep_w0[i]
            w1 = keep_w1[i]
            e0 = 2 - D33
            e1 = 2*D33 + 2
            complement = 2 - nu
            share = 2 - 2*nu
            fifteen_N11 = 5 - D33
            fifteen_N33 = 2*D33 + 5
            moment0 = h0*spread
            moment1 = h1*inverse_spread
            moment2 = h2*inverse_spread*inverse_spread
            moment3 = h3*inverse_ratio
            p0 = e0*moment0 + e1*moment1
            p1 = e0*moment1 + e1*moment2
            p2 = e0*moment2 + e1*moment3
            served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (w1 <= 9*w0) & (w0 <= 9*w1)
            unserved += not served
            gate = 7*mean_length*mean_length/30 if served else np.nan
            sums = p1 + p2
            mixed = nu*p1
            bulk = complement*p1*(p0 + sums) + mixed*p1 + p0*p2*share
            shear = 2*complement*p1 + p0*(complement + share)
            vertical = fifteen_N11*fifteen_N11*(complement*(p2 + sums) + p1*share) - 2*fifteen_N11*fifteen_N33*mixed + fifteen_N33*fifteen_N33*(complement*p0 + p1*share)
            over_bulk = gate/bulk
            over_shear = 1/shear
            C1212 = 2*fifteen_N11*fifteen_N11*gate*over_shear*share
            C1122 = fifteen_N11*fifteen_N11*nu*over_bulk*over_shear*(mixed*(p0 + 2*p1) + p0*share*sums)
            C1111 = C1122 + 2*C1212
            C3333 = fifteen_N33*fifteen_N33*over_bulk*(complement*p1 + p0*share)
            C1133 = fifteen_N11*fifteen_N33*mixed*over_bulk
            C2323 = 2*fifteen_N11*fifteen_N11*fifteen_N33*fifteen_N33*gate*share/vertical
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
        write_rows(columns, 6, 72, out[6*start:6*stop], streamed)
    return unserved
