"""Stiffness with constant contact stiffness, static hypothesis: scalar functions.

Emitted by ``derivations write`` from the derivation ``static_constant``; do not edit.
Source: (2), (23), (24), Figure 1(b) of Pan & Dong (1999).
Domain: E nowhere negative; -1 < Dr33 < 2; the emitted series: 1/9 <= w1/w0 <= 9; 0 <= nu <= 1/2.
Operations: 596 (340 in the outputs as derived, moments counted apart).
"""

from __future__ import annotations

from math import sqrt

# 30 terms for |v| <= 1/2; left out: 4e-18 of the sum.
SERIES_0 = (
    0.40634920634920635,
    0.11082251082251082,
    -0.07104007104007104,
    -0.04830724830724831,
    -0.005516052574876105,
    0.0004662691969193517,
    -9.677285219080885e-05,
    2.8687604404389976e-05,
    -1.0480538142403804e-05,
    4.4115160550750805e-06,
    -2.060231635846305e-06,
    1.0424403900291544e-06,
    -5.623351944798233e-07,
    3.197013859763979e-07,
    -1.899232928879396e-07,
    1.171234909204634e-07,
    -7.459352531112481e-08,
    4.8860035092926367e-08,
    -3.2804869842556513e-08,
    2.2513590708441705e-08,
    -1.5756523643225468e-08,
    1.1223504977700396e-08,
    -8.123017789564237e-09,
    5.964815360662556e-09,
    -4.438340038790749e-09,
    3.342800808052822e-09,
    -2.5459331753647137e-09,
    1.9591110690888096e-09,
    -1.5220085064112492e-09,
    1.192962795843824e-09,
)

# 37 terms for |v| <= 1/2; left out: 5e-18 of the sum.
SERIES_1 = (
    0.050793650793650794,
    -0.009235209235209235,
    -0.035164835164835165,
    -0.007104007104007104,
    0.0008984479572714867,
    -0.00025732781150737807,
    0.00010007192669731369,
    -4.6282668439082495e-05,
    2.4011524886474407e-05,
    -1.3534174255671092e-05,
    8.126066211574541e-06,
    -5.129050090240722e-06,
    3.3717526074912746e-06,
    -2.292760429820932e-06,
    1.6042884931021508e-06,
    -1.150434965785355e-06,
    8.427366738769652e-07,
    -6.289740203454124e-07,
    4.772514973235885e-07,
    -3.674977426199352e-07,
    2.8674555894840466e-07,
    -2.2641921969326506e-07,
    1.8072724462696623e-07,
    -1.456839543830737e-07,
    1.1849912164548037e-07,
    -9.718876649414364e-08,
    8.03219592073524e-08,
    -6.685307060736684e-08,
    5.600875999918669e-08,
    -4.7210659379838484e-08,
    4.002172217950589e-08,
    -3.410850030055977e-08,
    2.9214294329448618e-08,
    -2.5139823951041395e-08,
    2.172916343600892e-08,
    -1.8859405632413884e-08,
    1.643299470420042e-08,
)

# 44 terms for |v| <= 1/2; left out: 3e-18 of the sum.
SERIES_2 = (
    0.025396825396825397,
    0.009235209235209235,
    -0.001776001776001776,
    0.0007104007104007104,
    -0.00036564742447095386,
    0.00021553953442498335,
    -0.00013856112927320357,
    9.466909453448691e-05,
    -6.768840259215814e-05,
    5.01395574756727e-05,
    -3.820980069697816e-05,
    2.9805885587672114e-05,
    -2.3709227172011907e-05,
    1.9175814503956884e-05,
    -1.5733052440505165e-05,
    1.3070535873650445e-05,
    -1.097845314997164e-05,
    9.311410332397287e-06,
    -7.9664288399399e-06,
    6.869149167697339e-06,
    -5.964944838480036e-06,
    5.213061035310284e-06,
    -4.58266514682079e-06,
    4.050134098138848e-06,
    -3.597158574004898e-06,
    3.209397073485048e-06,
    -2.87550645739108e-06,
    2.5864343796639343e-06,
    -2.3348965306526615e-06,
    2.1149860493817215e-06,
    -1.921878627481651e-06,
    1.751607690471691e-06,
    -1.6008914465569609e-06,
    1.4669987073903788e-06,
    -1.347643961525539e-06,
    1.2409047110466625e-06,
    -1.1451558907498522e-06,
    1.0590174958416087e-06,
    -9.813124969207227e-07,
    9.110328220749417e-07,
    -8.473117061489134e-07,
    7.894010963745974e-07,
    -7.366530968472626e-07,
    6.885046569798894e-07,
)

# 48 terms for |v| <= 1/2; left out: 7e-18 of the sum.
SERIES_3 = (
    0.031746031746031744,
    -0.002886002886002886,
    -0.01554001554001554,
    0.005061605061605062,
    -0.0027867557279321986,
    0.0018138036713888108,
    -0.001289388286292311,
    0.0009692824338133262,
    -0.0007577077653803996,
    0.0006098223677978692,
    -0.0005020439311033952,
    0.0004208960817244112,
    -0.00035817868192003705,
    0.0003086498458167462,
    -0.00026882233778785503,
    0.00023629834530835642,
    -0.00020938261259485384,
    0.0001868477158031254,
    -0.00016778644118405889,
    0.00015151603474216043,
    -0.00013751440840179812,
    0.0001253766241785562,
    -0.00011478458469579537,
    0.00010548552522641459,
    -9.727649380776579e-05,
    8.999298157898186e-05,
    -8.350047824149977e-05,
    7.768812088917038e-05,
    -7.246386200266415e-05,
    6.775075410488888e-05,
    -6.348406494964808e-05,
    5.960901719823683e-05,
    -5.607900242327256e-05,
    5.2854158786008314e-05,
    -4.9900230000325114e-05,
    4.718764364920324e-05,
    -4.4690761873536245e-05,
    4.23872684944315e-05,
    -4.0257664857595605e-05,
    3.828485287223931e-05,
    -3.645378840268198e-05,
    3.4751191748737446e-05,
    -3.316530470281179e-05,
    3.1685685802720445e-05,
    -3.030303706034139e-05,
    2.9009056749023025e-05,
    -2.77963138604658e-05,
    2.6658140657187884e-05,
)

# 44 terms for |v| <= 1/2; left out: 7e-18 of the sum.
SERIES_4 = (
    0.1111111111111111,
    -0.06060606060606061,
    -0.014763014763014764,
    0.018026418026418026,
    -0.0054938525526760824,
    0.002683659649603922,
    -0.001551595978840561,
    0.0009881684400462163,
    -0.000671607299686449,
    0.0004786355466123941,
    -0.0003537756405594932,
    0.00026919083707477683,
    -0.00020975089790427454,
    0.00016670713193419582,
    -0.0001347435095077403,
    0.00011049514942729625,
    -9.175784427419035e-05,
    7.704478607738486e-05,
    -6.532734470816553e-05,
    5.587793328708838e-05,
    -4.817174052399309e-05,
    4.182357336505637e-05,
    -3.65462709156622e-05,
    3.212272436365562e-05,
    -2.838668266478525e-05,
    2.5209352455908337e-05,
    -2.2489892939692064e-05,
    2.014857489133377e-05,
    -1.8121791038669685e-05,
    1.635837187921452e-05,
    -1.4816834409383205e-05,
    1.3463305859924913e-05,
    -1.2269941475008572e-05,
    1.121370777154362e-05,
    -1.0275438878633343e-05,
    9.43909882703748e-06,
    -8.691200522421303e-06,
    8.020344902312818e-06,
    -7.416852993130637e-06,
    6.872470301360555e-06,
    -6.3801279137127935e-06,
    5.933748345951619e-06,
    -5.528086920474938e-06,
    5.158601517485519e-06,
)


def polynomial(coefficients: tuple[float, ...], v: float) -> float:
    """Evaluate a polynomial by Horner's rule, coefficients in rising order."""
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * v + coefficient
    return total


def static_moments(D33: float, D3333: float, Dr33: float) -> tuple[float, float, float]:
    """Moments <E W^-2 s^2>, <E W^-2 s x^2>, <E W^-2 x^4> of the static weight.

    The series hold for 1/9 <= w1/w0 <= 9, that is -16/19 <= Dr33 <= 16/11.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    D3333 : float [-]
        P4 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.

    Returns
    -------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 459.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    w0 = (2 - Dr33)/2
    w1 = Dr33 + 1
    geometric_mean = sqrt(w0)*sqrt(w1)
    square = Dr33/2 + 2*geometric_mean + 2
    v = 3*Dr33/(2*square)
    h0 = 2*polynomial(SERIES_0, v)/(w0*(geometric_mean + w0))
    h1 = 4*polynomial(SERIES_1, v)/(square*w0)
    h2 = 16*polynomial(SERIES_2, v)/(square*square)
    h3 = 8*polynomial(SERIES_3, v)/(square*(geometric_mean + w1))
    h4 = 4*polynomial(SERIES_4, v)/(square*w1)
    p0 = e0*h0 + e1*h1 + e2*h2
    p1 = e0*h1 + e1*h2 + e2*h3
    p2 = e0*h2 + e1*h3 + e2*h4
    return p0, p1, p2


def stiffness_from_moments(
    p0: float, p1: float, p2: float, D33: float, nu: float,
) -> tuple[float, float, float, float, float, float]:
    """Six stiffness components over (M/V) l_e^2 k_n from the positive moments of E/W^2.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    nu : float [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.

    Operations: 73.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    delta = lam*p0*p2 + one_minus_lam*p1*p1 + p1*(p0 + p1 + p2)
    shear_sum = p0*(lam + 1) + 2*p1
    eight_S2323 = (lam*p1 + p1 + 2*p2)/(fifteen_N33*fifteen_N33) - 2*one_minus_lam*p1/(fifteen_N11*fifteen_N33) + (lam*p1 + p0)/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11*lam/(225*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*one_minus_lam*(lam*p0*(p1 + p2) + one_minus_lam*p1*(p0 + 2*p1))/(225*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C3333 = fifteen_N33*fifteen_N33*(lam*p0 + p1)/(225*delta)
    C1133 = fifteen_N11*fifteen_N33*one_minus_lam*p1/(225*delta)
    C2323 = 2*lam/(225*eight_S2323)
    return C1111, C3333, C1122, C1133, C2323, C1212


def compliance_from_moments(
    p0: float, p1: float, p2: float, D33: float, nu: float,
) -> tuple[float, float, float, float, float, float]:
    """Six compliance components times (M/V) l_e^2 k_n from the positive moments of E/W^2.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    nu : float [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    S1111 : float [-]
        Compliance component 1111.
    S3333 : float [-]
        Compliance component 3333.
    S1122 : float [-]
        Compliance component 1122.
    S1133 : float [-]
        Compliance component 1133.
    S2323 : float [-]
        Compliance component 2323.
    S1212 : float [-]
        Compliance component 1212.

    Operations: 64.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    A11 = 15/fifteen_N11
    A33 = 15/fifteen_N33
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    S1111 = A11*A11*(3*p0/8 + (p0/8 + p1/2)/lam)
    S3333 = A33*A33*(p2 + p1/lam)
    S1122 = -A11*A11*one_minus_lam*p0/(8*lam)
    S1133 = -A11*A33*one_minus_lam*p1/(2*lam)
    S2323 = A11*A11*(p1 + p0/lam)/8 - A11*A33*one_minus_lam*p1/(4*lam) + A33*A33*(p1 + (p1 + 2*p2)/lam)/8
    S1212 = A11*A11*(p0/4 + (p0/4 + p1/2)/lam)/2
    return S1111, S3333, S1122, S1133, S2323, S1212


def static_constant(
    D33: float, D3333: float, Dr33: float, nu: float,
) -> tuple[float, float, float, float, float, float]:
    """Stiffness with constant contact stiffness, static hypothesis, from the fabric to the components.

    The series hold for 1/9 <= w1/w0 <= 9, that is -16/19 <= Dr33 <= 16/11.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    D3333 : float [-]
        P4 coefficient of the contact-normal density.
    Dr33 : float [-]
        P2 coefficient of the branch-length weight.
    nu : float [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.

    Operations: 532.
    """
    p0, p1, p2 = static_moments(D33, D3333, Dr33)
    return stiffness_from_moments(p0, p1, p2, D33, nu)
