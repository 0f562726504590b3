"""Partial slip about its onset: what a table can hold: blocks of elements at once.

Emitted by ``derivations write`` from the derivation ``slip_table``; do not edit.
Source: (20), (21), (23) of Pan & Dong (1999).
Domain: slip_state: D33 >= -1.0, D33 <= 2.0, a <= 9*c, c <= 6*a; slip_rows: Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5, level > 0.0, lost0 >= 0.0.
Operations: 413 (7736 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

CUBIC = np.array([
    [0.0, -0.681114526638451, -0.6448530994941937, 1.3578204037912385, -1.1453090253436675, 0.0],
    [0.0, 1.6230495115734476, -2.0615131639337565, 1.0001308104875504, 0.9446767363215737, -2.82297396368279],
    [-4.546318711523686, 3.0258622050863377, 0.26459272328021677, -2.7146261734134396, 3.001577654277903, -0.49894294272562195],
    [-3.119570333962791, -2.6650096693667598, 4.239023330627392, -1.980997895160333, -2.43922093557402, 6.399088826535958],
    [8.878537664159156, -6.546511322612836, 0.3706640828750369, 4.603490595267432, -4.946901400105296, -0.8811121188867673],
    [9.892064566275682, 2.6038626781127148, -6.936244936726151, 3.031342870960518, 5.209188581484684, -11.292788699818386],
    [-12.4799749165955, 11.938888599247987, -1.6702435408934053, -7.30108476530955, 6.736889084711712, 6.320279093235818],
    [-25.964787484683303, 0.23473979078158907, 10.254534254724458, -4.136779025020829, -9.969054345037073, 16.5005022146651],
    [5.708920950608579, -18.80336456724852, 4.271392333104574, 10.728191530070514, -7.189992271632052, -19.251296521803365],
    [49.24001791208917, -8.9039852418593, -13.525960996995131, 5.001472614523118, 16.789240885441274, -16.128675648415005],
    [25.46436858851001, 23.39989637869322, -8.572865622523768, -14.4909532955523, 4.0842765802638406, 41.42820447574571],
    [-69.01523114238569, 25.59620057648662, 15.478994399700156, -5.23869099628221, -24.058001459512962, -4.224094844804309],
    [-118.80474942602964, -16.9211118296269, 14.441791366965987, 18.095902759683327, 4.753982175429124, -60.74509120243451],
    [-17.883623120562746, -45.76581725750462, -14.916567436674686, 4.648725886576156, 28.159085497339756, 61.92903072228614],
    [188.91609113804486, -11.299198222135354, -21.907438278685532, -22.014130348551106, -20.218147178113846, 26.552988807288244],
    [339.7888386125262, 54.05731523378324, 11.583710407240257, -3.378582202109864, -25.339366515840215, -125.42986425339637],
    [315.0769230769107, 78.7692307692314, 39.384615384614875, 34.46153846153857, 51.6923076923081, 142.15384615384534],
    [-1083.076923076923, -68.92307692307692, -11.076923076923077, 3.0769230769230758, 26.923076923076923, 218.07692307692307],
    [1280.0, 128.0, 48.0, 40.0, 70.0, 315.0],
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


def slip_state(D33: Array, SR: Array, mu: Array, out: Array) -> int:
    """Level of the stiffness, cubic contrast of the forces, share of the friction used up and left.

    Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    SR : (n,) array [-]
        Stress ratio, principal stress along over across axis 3.
    mu : (n,) array [-]
        Friction coefficient between grains.
    out : (4 n,) array [-]
        level, v, kappa, margin, each for all elements, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 96.
    """
    rows = out.reshape(4, -1)
    with np.errstate(all="ignore"):  # what is not served may be anything
        third = 1/3
        unit = 1/443520
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
        roots = root_a + root_c
        over_roots = 1/roots
        served = (D33 >= -1.0) & (D33 <= 2.0) & (a <= 9*c) & (c <= 6*a)
        level = np.where(served, roots*unit, np.nan)
        rows[0] = level
        rows[1] = over_roots*(-root_a + root_c)
        v = rows[1]
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
        rows[2] = growth*abs(v)/mu
        kappa = rows[2]
        rows[3] = 1 - kappa
    return int(served.size - np.count_nonzero(served))


def slip_rows(D33: Array, Dr33: Array, nu: Array, level: Array, v: Array, lost0: Array, lost1: Array, lost2: Array, lost3: Array, lost4: Array, lost5: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n,ref with partial slip.

    What slip takes is counted in units of the mean cube root of the forces, times 3465.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    nu : (n,) array [-]
        Poisson's ratio of the grain material.
    level : (n,) array [-]
    v : (n,) array [-]
        Contrast of the roots of the branch-length weight at pole and equator.
    lost0 : (n,) array [-]
    lost1 : (n,) array [-]
    lost2 : (n,) array [-]
    lost3 : (n,) array [-]
    lost4 : (n,) array [-]
    lost5 : (n,) array [-]
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 317.
    """
    rows = out.reshape(-1, 6)
    with np.errstate(all="ignore"):  # what is not served may be anything
        contrast = v
        f0, f1, f2, f3, f4, f5 = polynomials(CUBIC, contrast)
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
        one_minus_lam = np.where(served, nu/complement, np.nan)
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
        rows[:, 0] = lam*(kept0 + 4*kept1) + 3*sum0
        rows[:, 1] = 8*along
        rows[:, 2] = shear0
        rows[:, 3] = shear1
        rows[:, 4] = lam*(both + 2*later) + shear1
        rows[:, 5] = 2*both*lam + shear0
    return int(served.size - np.count_nonzero(served))
