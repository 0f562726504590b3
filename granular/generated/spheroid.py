"""Stiffness of aligned spheroids: scalar functions.

Emitted by ``derivations write`` from the derivation ``spheroid``; do not edit.
Source: (5), (6), (24), (28), Figure 1(b) of Pan & Dong (1999).
Domain: aspect_ratio > 0; the emitted series: 1/3 <= aspect_ratio <= 3; E nowhere negative; 0 <= nu <= 1/2; free spin: k_r > 0 in some directions; flexibilities: k_r > 0 in every direction.
Operations: 548 (100 in the outputs as derived, moments counted apart).
"""

from __future__ import annotations

# 25 terms for |v| <= 1/2; left out: 3e-18 of the sum.
SERIES_0 = (
    0.40634920634920635,
    0.2585858585858586,
    0.09945609945609946,
    0.01989121989121989,
    0.0011700717583070525,
    -6.158272412142381e-05,
    8.797532017346258e-06,
    -1.912506960292665e-06,
    5.355019488819462e-07,
    -1.785006496273154e-07,
    6.770714296208515e-08,
    -2.8393318016358288e-08,
    1.2906053643799222e-08,
    -6.268654626988194e-09,
    3.2190388625074508e-09,
    -1.7333286182732428e-09,
    9.723550785435264e-10,
    -5.653227200834456e-10,
    3.3919363205006735e-10,
    -2.0928968786067987e-10,
    1.3240776170777704e-10,
    -8.567561051679691e-11,
    5.657823336014891e-11,
    -3.806172062410017e-11,
    2.6042229900700117e-11,
)

# 31 terms for |v| <= 1/2; left out: 4e-18 of the sum.
SERIES_1 = (
    0.050793650793650794,
    -0.004617604617604618,
    -0.030192030192030192,
    -0.014563214563214563,
    -0.0015252721135074077,
    0.0001242651397450159,
    -2.5292904549870493e-05,
    7.410964471134077e-06,
    -2.687072279211194e-06,
    1.1251915949721847e-06,
    -5.23521301831837e-07,
    2.6415926225933335e-07,
    -1.4219705532543072e-07,
    8.070892832247299e-08,
    -4.788320307979833e-08,
    2.9497538807400006e-08,
    -1.8769925712599145e-08,
    1.2285674113242022e-08,
    -8.243616664645387e-09,
    5.654558888093011e-09,
    -3.955681881019839e-09,
    2.8165856957396984e-09,
    -2.0378267265610776e-09,
    1.4959615552436515e-09,
    -1.1128402884352747e-09,
    8.379623448647493e-10,
    -6.380779191299716e-10,
    4.909167853356261e-10,
    -3.813257242794418e-10,
    2.9884303159013275e-10,
    -2.361480614053853e-10,
)

# 36 terms for |v| <= 1/2; left out: 7e-18 of the sum.
SERIES_2 = (
    0.025396825396825397,
    0.004617604617604618,
    -0.009057609057609058,
    -0.002131202131202131,
    0.0002820708703061644,
    -8.247686266262118e-05,
    3.244089931396433e-05,
    -1.5108804986312053e-05,
    7.874747409005047e-06,
    -4.452953705881421e-06,
    2.6798728995618166e-06,
    -1.694472657333382e-06,
    1.1154287326897118e-06,
    -7.59290791693945e-07,
    5.317449821004496e-07,
    -3.8157991439415245e-07,
    2.796823112078545e-07,
    -2.088403078473977e-07,
    1.5852759526482836e-07,
    -1.2211305823499738e-07,
    9.530876197427927e-08,
    -7.527673329032069e-08,
    6.009911702866288e-08,
    -4.845528904880981e-08,
    3.9420262912635665e-08,
    -3.233603940976154e-08,
    2.672785617088214e-08,
    -2.2248667636468335e-08,
    1.86417216116696e-08,
    -1.5714944342740438e-08,
    1.3323158166806793e-08,
    -1.1355573715938444e-08,
    9.72688427044516e-09,
    -8.370852443568013e-09,
    7.235642429469201e-09,
    -6.280388787325449e-09,
)

# 44 terms for |v| <= 1/2; left out: 7e-18 of the sum.
SERIES_3 = (
    0.031746031746031744,
    -0.017316017316017316,
    -0.004218004218004218,
    0.00515040515040515,
    -0.0015696721579074521,
    0.0007667598998868349,
    -0.00044331313681158883,
    0.0002823338400132047,
    -0.000191887799910414,
    0.00013675301331782689,
    -0.00010107875444556949,
    7.691166773565053e-05,
    -5.9928827972649866e-05,
    4.7630609124055946e-05,
    -3.849814557364009e-05,
    3.157004269351322e-05,
    -2.6216526935482957e-05,
    2.2012796022109958e-05,
    -1.8664955630904436e-05,
    1.5965123796310965e-05,
    -1.3763354435426597e-05,
    1.1949592390016107e-05,
    -1.0441791690189199e-05,
    9.177921246758748e-06,
    -8.110480761367215e-06,
    7.202672130259525e-06,
    -6.425683697054876e-06,
    5.75673568323822e-06,
    -5.177654582477053e-06,
    4.6738205369184344e-06,
    -4.2333812598237725e-06,
    3.8466588171214035e-06,
    -3.5056975642881634e-06,
    3.20391650615532e-06,
    -2.9358396796095266e-06,
    2.6968853791535653e-06,
    -2.4832001492632293e-06,
    2.29152711494652e-06,
    -2.119100855180182e-06,
    1.963562943245873e-06,
    -1.8228936896322267e-06,
    1.695356670271891e-06,
    -1.5794534058499823e-06,
    1.4738861478530054e-06,
)

# 49 terms for |v| <= 1/2; left out: 4e-18 of the sum.
SERIES_4 = (
    0.1111111111111111,
    -0.030303030303030304,
    -0.031857031857031856,
    0.035586635586635586,
    -0.019498148909913617,
    0.010441639543806726,
    -0.0068951344493140155,
    0.004959414435790799,
    -0.0037595458190423864,
    0.002956683365890527,
    -0.0023902107848988896,
    0.0019743885949542734,
    -0.0016595576770647529,
    0.0014151577442597467,
    -0.001221469552465345,
    0.0010652726095004956,
    -0.0009374178516043461,
    0.000831401959017757,
    -0.0007424948844071497,
    0.0006671870533269199,
    -0.000602828495667967,
    0.0005473870706107866,
    -0.0004992827397051387,
    0.0004572716426879854,
    -0.0004203635277429115,
    0.0003877619728431588,
    -0.00035882046412421767,
    0.00033300968891661017,
    -0.0003098928792706018,
    0.00028910701388549105,
    -0.0002703483369693533,
    0.00025336109509566595,
    -0.00023792869863731121,
    0.00022386672818545817,
    -0.00021101735792924983,
    0.0001992448766847219,
    -0.000188432066097542,
    0.00017847725330491545,
    -0.000169291898070579,
    0.00016079860630202625,
    -0.0001529294858707221,
    0.0001456247788779399,
    -0.00013883171844191388,
    0.00013250356881208903,
    -0.00012659881593579832,
    0.00012108048209479407,
    -0.00011591554332611082,
    0.00011107443236680813,
    -0.00010653061305829636,
)


def polynomial(coefficients: tuple[float, ...], v: float) -> float:
    """Evaluate a polynomial by Horner's rule, coefficients in rising order."""
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * v + coefficient
    return total


def stiffness_from_moments(
    p0: float, p1: float, p2: float, varrho: float, nu: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) (2a)^2 k_n from the moments of E/Q for contacts of equal stiffness.

    Grains turn with the mean deformation.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    varrho : float [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.
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

    Operations: 49.
    """
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    C1111 = lam*p0/8 + lam*p1/2 + 3*p0/8
    C3333 = varrho*varrho*(lam*p1 + p2)
    C1122 = one_minus_lam*p0/8
    C1133 = one_minus_lam*p1*varrho/2
    C2323 = lam*p0/8 + lam*p1/8 + one_minus_lam*p1*(varrho + 1)**2/8 + varrho*varrho*(lam*p1 + lam*p2)/4
    C1212 = lam*p0/4 + lam*p1/4 + one_minus_lam*p0/8
    return C1111, C3333, C1122, C1133, C2323, C1212


def stiffness_from_weights(
    p0: float, p1: float, p2: float, q0: float, q1: float, q2: float, d0: float, d1: float, varrho: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) (2a)^2 k_n,ref from moments of E k_n/Q, E k_r/Q and E (k_n - k_r)/Q.

    All contact stiffnesses over k_n,ref. Grains turn with the mean deformation.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    q0 : float [-]
        Moment of the tangential stiffness with the fourth power of the sine.
    q1 : float [-]
        Moment of the tangential stiffness with squared sine and squared cosine.
    q2 : float [-]
        Moment of the tangential stiffness with the fourth power of the cosine.
    d0 : float [-]
        Normal less tangential stiffness, moment with the fourth power of the sine.
    d1 : float [-]
        Normal less tangential stiffness, moment with squared sine and squared cosine.
    varrho : float [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.

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

    Operations: 30.
    """
    C1111 = 3*p0/8 + q0/8 + q1/2
    C3333 = varrho*varrho*(p2 + q1)
    C1122 = d0/8
    C1133 = d1*varrho/2
    C2323 = d1*(varrho + 1)**2/8 + q0/8 + q1/8 + varrho*varrho*(q1 + q2)/4
    C1212 = d0/8 + q0/4 + q1/4
    return C1111, C3333, C1122, C1133, C2323, C1212


def relaxed_shear(q0: float, q1: float, q2: float, d1: float, varrho: float) -> tuple[float]:
    """Vertical shear component over (M/V) (2a)^2 k_n,ref when grains are free to spin.

    The other five components are those of grains that do not spin. Some contacts must have k_r > 0.

    Parameters
    ----------
    q0 : float [-]
        Moment of the tangential stiffness with the fourth power of the sine.
    q1 : float [-]
        Moment of the tangential stiffness with squared sine and squared cosine.
    q2 : float [-]
        Moment of the tangential stiffness with the fourth power of the cosine.
    d1 : float [-]
        Normal less tangential stiffness, moment with squared sine and squared cosine.
    varrho : float [-]
        Form linear in y, pole over equator: squared aspect ratio of a spheroid.

    Returns
    -------
    relaxed_C2323 : float [-]
        Stiffness component 2323 when grains are free to spin.

    Operations: 19.
    """
    difference = 1 - varrho
    equator = q0/2 + q1/2
    pole = q1 + q2
    half = d1/2
    relaxed_C2323 = varrho*varrho*(equator*pole + half*(equator + pole))/((difference*difference*half + equator + pole*varrho*varrho))
    return relaxed_C2323,


def stiffness_from_flexibilities(
    u0: float, u1: float, u2: float, v0: float, v1: float, v2: float, g0: float, g1: float, N11: float, N33: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) (2a)^2 k_n,ref by the static hypothesis, with l in units of 2a.

    Moments of E l^-2/k_n, E l^-2/k_r and their difference, all contact flexibilities times k_n,ref; N11 and
    N33 are means of the branch direction times the contact normal.

    Parameters
    ----------
    u0 : float [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : float [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : float [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    v0 : float [-]
        Moment of the tangential flexibility with the fourth power of the sine.
    v1 : float [-]
        Moment of the tangential flexibility with squared sine and squared cosine.
    v2 : float [-]
        Moment of the tangential flexibility with the fourth power of the cosine.
    g0 : float [-]
        Tangential less normal flexibility, moment with the fourth power of the sine.
    g1 : float [-]
        Tangential less normal flexibility, moment with squared sine and cosine.
    N11 : float [-]
        Horizontal component of the fabric tensor.
    N33 : float [-]
        Vertical component of the fabric tensor.

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

    Operations: 46.
    """
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    C1212 = 2*N11*N11/shear_sum
    C1122 = N11*N11*(g0*(u2 + v1) + 2*g1*g1)/(delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C3333 = N33*N33*(u0 + v1)/delta
    C1133 = N11*N33*g1/delta
    C2323 = 1/((u1 + v1 + 2*v2)/(2*N33*N33) - g1/(N11*N33) + (u1 + v0)/(2*N11*N11))
    return C1111, C3333, C1122, C1133, C2323, C1212


def spheroid_moments(D33: float, D3333: float, aspect_ratio: float) -> tuple[float, float, float]:
    """Moments <E s^2/Q>, <E s x^2/Q>, <E x^4/Q> with Q = s + r^2 x^2, r the aspect ratio.

    The series hold for 1/3 <= aspect_ratio <= 3.

    Parameters
    ----------
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    D3333 : float [-]
        P4 coefficient of the contact-normal density.
    aspect_ratio : float [-]
        Semi-axis of a spheroid along axis 3 over the one across.

    Returns
    -------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 404.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    mean_axis = (aspect_ratio + 1)/2
    v = (aspect_ratio - 1)/(aspect_ratio + 1)
    h0 = polynomial(SERIES_0, v)/mean_axis
    h1 = polynomial(SERIES_1, v)/mean_axis
    h2 = polynomial(SERIES_2, v)/(mean_axis*mean_axis)
    h3 = polynomial(SERIES_3, v)/(mean_axis*mean_axis)
    h4 = polynomial(SERIES_4, v)/(aspect_ratio*mean_axis)
    p0 = e0*h0 + e1*h1 + e2*h2
    p1 = e0*h1 + e1*h2 + e2*h3
    p2 = e0*h2 + e1*h3 + e2*h4
    return p0, p1, p2
