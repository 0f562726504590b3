"""Partial slip about its onset: what a table can hold: blocks of elements at once.

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

CUBIC = np.array([
    [0.0, -1.127008120885365, 0.8839119593836494, -0.1580949141442354, -0.7382162053420058, 0.0],
    [2.0281187593279353, -1.289698911916548, -0.16754064142702293, 1.2724491501533515, -1.5439457762283508, -0.06381189564321746],
    [0.4038307676315138, 1.9904366903562027, -2.349654762057456, 1.0516673020274019, 1.1853237769118847, -2.855518030460831],
    [-5.488884065791915, 3.251868536740753, 0.08733605960256001, -2.6829223631774592, 3.1496169926334425, -0.4788087422117175],
    [-3.290228764813496, -2.712327543512398, 4.276134717914542, -1.9876355715993155, -2.4702152299799938, 6.410492389575234],
    [9.05828465887658, -6.581248950769799, 0.39790878892421877, 4.598617655810052, -4.969655344433994, -0.8836334050852646],
    [9.920759410715927, 2.6068678526260234, -6.9386018937374825, 3.031764432081388, 5.211157039816521, -11.294420223424808],
    [-12.498197308348882, 11.941737821282828, -1.6724781844464234, -7.300685080955348, 6.738755390588093, 6.320437814359273],
    [-25.967255356561367, 0.23464705643670614, 10.254606986229199, -4.136792033647848, -9.96911508816298, 16.500624421739914],
    [5.709979185989808, -18.803498481028065, 4.271497361621296, 10.728172744857623, -7.190079988233513, -19.251301746478575],
    [49.24013351177756, -8.903984327190697, -13.525961714369302, 5.001472742831381, 16.789241484570216, -16.128680747939512],
    [25.464333426291123, 23.399899971839027, -8.572868440626399, -14.490952791511496, 4.084278933856874, 41.428204559348906],
    [-69.01523403031084, 25.596200592380644, 15.47899438723448, -5.238690994052622, -24.05800144910201, -4.2240947286106865],
    [-118.80474879999404, -16.92111188107454, 14.44179140731635, 18.095902752466333, 4.753982141729736, -60.74509120292158],
    [-17.88362308587936, -45.76581725788825, -14.916567436373807, 4.6487258865223415, 28.159085497088473, 61.92903072097954],
    [188.9160911329836, -11.299198221802731, -21.907438278946408, -22.014130348504448, -20.21814717789597, 26.552988807287875],
    [339.7888386123718, 54.05731523378518, 11.583710407238737, -3.3785822021095924, -25.339366515838947, -125.42986425339075],
    [315.07692307692275, 78.76923076923077, 39.38461538461537, 34.461538461538474, 51.692307692307686, 142.15384615384534],
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


def slip_state(D33: Array, Dr33: Array, SR: Array, nu: Array, out: Array) -> int:
    """The sums of the normal stiffness, their level, the cubic contrast of the forces, 1 - k_r/k_n.

    Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.

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
    out : (6 n,) array [-]
        sum0, sum1, sum2, level, v, one_minus_lam, each for all elements, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 347.
    """
    rows = out.reshape(6, -1)
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
        rows[5] = nu*over_complement
        one_minus_lam = rows[5]
        lam = 1 - one_minus_lam
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5) & (equator_part <= 9*pole_part) & (pole_part <= 6*equator_part)
        level = np.where(served, roots*unit, np.nan)
        rows[3] = level
        rows[4] = over_roots*(-root_a + root_c)
        v = rows[4]
        f0, f1, f2, f3, f4, f5 = polynomials(CUBIC, v)
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
        rows[0] = density0*square0 + density1*square1 + density2*square2
        rows[1] = density1*square0 + density2*square1 + density3*square2
        rows[2] = density2*square0 + density3*square1 + density4*square2
    return int(served.size - np.count_nonzero(served))
