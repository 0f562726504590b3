"""Stiffness with constant contact stiffness, static hypothesis: blocks of elements at once.

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

Array: TypeAlias = npt.NDArray[np.float64]

QUARTIC = np.array([
    [-2470.9337528082315, -712.2146378033709, -383.53506537485913, -1324.8423475841669],
    [1712.614598276011, 552.2329295083438, -312.9875646204825, -972.9567701192093],
    [3002.187209448274, 871.3434759890511, 471.18915593598626, 1614.8875154651082],
    [-1998.4984479769555, -654.4701620341945, 373.7048933509737, 1144.152561353229],
    [-2558.9000721431185, -750.2241037100641, -408.0426475541776, -1382.873681474101],
    [1629.109886054949, 546.07606987633, -315.5183450740541, -943.5233351865458],
    [2002.0585971820692, 594.3897452790802, 325.825618592248, 1088.1244636107356],
    [-1208.7709352758814, -417.63191982573323, 244.92394576129686, 710.6277501300734],
    [-1511.0295253107386, -455.22818259045835, -251.7946832861158, -826.5545443610919],
    [853.8349461961445, 306.285574608125, -183.16643602690274, -511.28084820194135],
    [1101.1367238115474, 337.3502592925289, 188.82164024166138, 606.5719940542596],
    [-571.2516643592382, -214.72863364265018, 131.4908817525072, 349.88088710901144],
    [-768.4326986816257, -239.88971700249786, -136.1157058229767, -426.3233263006157],
    [355.69185860861023, 141.84450704963558, -89.79460792546833, -223.99576720908271],
    [507.27797194187235, 161.5258265291901, 93.4761146289665, 283.0769966414344],
    [-200.41758849362935, -86.1716281307453, 56.91248275060036, 130.5144802979583],
    [-311.498004573492, -100.82065715447638, -59.700390424555984, -173.8490405353263],
    [97.71122994602199, 46.10228986683698, -32.63842040303719, -65.95365418866585],
    [174.3589743589691, 56.205128205126705, 34.638694638693835, 95.34965034964755],
    [-38.34032634032544, -19.841491841491557, 15.477855477855318, 26.340326340325834],
    [-88.72727272727272, -25.939393939393938, -16.727272727272727, -43.93939393939394],
    [10.666666666666666, 5.333333333333333, -5.333333333333333, -6.666666666666666],
    [48.0, 8.0, 6.0, 15.0],
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


def static_constant(D33: Array, Dr33: Array, nu: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.

    Served for branch lengths at pole and equator within a factor 9.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 292.
    """
    rows = out.reshape(-1, 6)
    with np.errstate(all="ignore"):  # what is not served may be anything
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
        h0, h1, h2, h3 = polynomials(QUARTIC, v)
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
        gate = np.where(served, 7*mean_length*mean_length/30, np.nan)
        sums = p1 + p2
        mixed = nu*p1
        bulk = complement*p1*(p0 + sums) + mixed*p1 + p0*p2*share
        shear = 2*complement*p1 + p0*(complement + share)
        vertical = fifteen_N11*fifteen_N11*(complement*(p2 + sums) + p1*share) - 2*fifteen_N11*fifteen_N33*mixed + fifteen_N33*fifteen_N33*(complement*p0 + p1*share)
        over_bulk = gate/bulk
        over_shear = 1/shear
        rows[:, 5] = 2*fifteen_N11*fifteen_N11*gate*over_shear*share
        C1212 = rows[:, 5]
        rows[:, 2] = fifteen_N11*fifteen_N11*nu*over_bulk*over_shear*(mixed*(p0 + 2*p1) + p0*share*sums)
        C1122 = rows[:, 2]
        rows[:, 0] = C1122 + 2*C1212
        rows[:, 1] = fifteen_N33*fifteen_N33*over_bulk*(complement*p1 + p0*share)
        rows[:, 3] = fifteen_N11*fifteen_N33*mixed*over_bulk
        rows[:, 4] = 2*fifteen_N11*fifteen_N11*fifteen_N33*fifteen_N33*gate*share/vertical
    return int(served.size - np.count_nonzero(served))
