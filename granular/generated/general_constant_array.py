"""Stiffness of a fabric without an axis, constant contact stiffness: functions of arrays.

Emitted by ``derivations write`` from the derivation ``general_constant``; do not edit.
Source: (2), (4), (6), (7), (14) of Pan & Dong (1999).
Domain: E nowhere negative; 1 + Dr_ij n_i n_j > 0; tensors symmetric and traceless; 0 <= nu <= 1/2.
Operations: 996 (219 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def tensor_moments(
    D11: Array, D22: Array, D33: Array, D23: Array, D13: Array, D12: Array, D1111: Array, D1112: Array, D1113: Array, D1122: Array, D1123: Array, D1133: Array, D1222: Array, D1223: Array, D1233: Array, D1333: Array, D2222: Array, D2223: Array, D2233: Array, D2333: Array, D3333: Array, Dr11: Array, Dr22: Array, Dr33: Array, Dr23: Array, Dr13: Array, Dr12: Array,
) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array]:
    """Moments <E W^2 n_i n_j n_k n_l> of the kinematic weight.

    Exact for exact fractions. With a branch tensor of zero they are the moments of E.

    Parameters
    ----------
    D11 : (...) array [-]
        Component 11 of the contact-normal tensor, traceless.
    D22 : (...) array [-]
        Component 22 of the contact-normal tensor, traceless.
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D23 : (...) array [-]
        Component 23 of the contact-normal tensor, traceless.
    D13 : (...) array [-]
        Component 13 of the contact-normal tensor, traceless.
    D12 : (...) array [-]
        Component 12 of the contact-normal tensor, traceless.
    D1111 : (...) array [-]
        Component 1111 of the contact-normal tensor of rank four, symmetric and traceless.
    D1112 : (...) array [-]
        Component 1112 of the contact-normal tensor of rank four, symmetric and traceless.
    D1113 : (...) array [-]
        Component 1113 of the contact-normal tensor of rank four, symmetric and traceless.
    D1122 : (...) array [-]
        Component 1122 of the contact-normal tensor of rank four, symmetric and traceless.
    D1123 : (...) array [-]
        Component 1123 of the contact-normal tensor of rank four, symmetric and traceless.
    D1133 : (...) array [-]
        Component 1133 of the contact-normal tensor of rank four, symmetric and traceless.
    D1222 : (...) array [-]
        Component 1222 of the contact-normal tensor of rank four, symmetric and traceless.
    D1223 : (...) array [-]
        Component 1223 of the contact-normal tensor of rank four, symmetric and traceless.
    D1233 : (...) array [-]
        Component 1233 of the contact-normal tensor of rank four, symmetric and traceless.
    D1333 : (...) array [-]
        Component 1333 of the contact-normal tensor of rank four, symmetric and traceless.
    D2222 : (...) array [-]
        Component 2222 of the contact-normal tensor of rank four, symmetric and traceless.
    D2223 : (...) array [-]
        Component 2223 of the contact-normal tensor of rank four, symmetric and traceless.
    D2233 : (...) array [-]
        Component 2233 of the contact-normal tensor of rank four, symmetric and traceless.
    D2333 : (...) array [-]
        Component 2333 of the contact-normal tensor of rank four, symmetric and traceless.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr11 : (...) array [-]
        Component 11 of the branch tensor, traceless.
    Dr22 : (...) array [-]
        Component 22 of the branch tensor, traceless.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
    Dr23 : (...) array [-]
        Component 23 of the branch tensor, traceless.
    Dr13 : (...) array [-]
        Component 13 of the branch tensor, traceless.
    Dr12 : (...) array [-]
        Component 12 of the branch tensor, traceless.

    Returns
    -------
    M1111 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 1.
    M1112 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 2.
    M1113 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 3.
    M1122 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 2, 2.
    M1123 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 2, 3.
    M1133 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 3, 3.
    M1222 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 2, 2.
    M1223 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 2, 3.
    M1233 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 3, 3.
    M1333 : (...) array [-]
        Mean of the weight times the normal's components 1, 3, 3, 3.
    M2222 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 2, 2.
    M2223 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 2, 3.
    M2233 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 3, 3.
    M2333 : (...) array [-]
        Mean of the weight times the normal's components 2, 3, 3, 3.
    M3333 : (...) array [-]
        Mean of the weight times the normal's components 3, 3, 3, 3.

    Operations: 858.
    """
    w200 = Dr11 + 1
    w110 = 2*Dr12
    w101 = 2*Dr13
    w020 = Dr22 + 1
    w011 = 2*Dr23
    w002 = Dr33 + 1
    v400 = w200*w200
    v310 = 2*w110*w200
    v301 = 2*w101*w200
    v220 = 2*w020*w200 + w110*w110
    v211 = 2*w011*w200 + 2*w101*w110
    v202 = 2*w002*w200 + w101*w101
    v130 = 2*w020*w110
    v121 = 2*w011*w110 + 2*w020*w101
    v112 = 2*w002*w110 + 2*w011*w101
    v103 = 2*w002*w101
    v040 = w020*w020
    v031 = 2*w011*w020
    v022 = 2*w002*w020 + w011*w011
    v013 = 2*w002*w011
    v004 = w002*w002
    e400 = D11 + D1111 + 1
    e310 = 4*D1112 + 2*D12
    e301 = 4*D1113 + 2*D13
    e220 = D11 + 6*D1122 + D22 + 2
    e211 = 12*D1123 + 2*D23
    e202 = D11 + 6*D1133 + D33 + 2
    e130 = 2*D12 + 4*D1222
    e121 = 12*D1223 + 2*D13
    e112 = 2*D12 + 12*D1233
    e103 = 2*D13 + 4*D1333
    e040 = D22 + D2222 + 1
    e031 = 4*D2223 + 2*D23
    e022 = D22 + 6*D2233 + D33 + 2
    e013 = 2*D23 + 4*D2333
    e004 = D33 + D3333 + 1
    o800 = e400*v400
    o710 = e310*v400 + e400*v310
    o701 = e301*v400 + e400*v301
    o620 = e220*v400 + e310*v310 + e400*v220
    o611 = e211*v400 + e301*v310 + e310*v301 + e400*v211
    o602 = e202*v400 + e301*v301 + e400*v202
    o530 = e130*v400 + e220*v310 + e310*v220 + e400*v130
    o521 = e121*v400 + e211*v310 + e220*v301 + e301*v220 + e310*v211 + e400*v121
    o512 = e112*v400 + e202*v310 + e211*v301 + e301*v211 + e310*v202 + e400*v112
    o503 = e103*v400 + e202*v301 + e301*v202 + e400*v103
    o440 = e040*v400 + e130*v310 + e220*v220 + e310*v130 + e400*v040
    o431 = e031*v400 + e121*v310 + e130*v301 + e211*v220 + e220*v211 + e301*v130 + e310*v121 + e400*v031
    o422 = e022*v400 + e112*v310 + e121*v301 + e202*v220 + e211*v211 + e220*v202 + e301*v121 + e310*v112 + e400*v022
    o413 = e013*v400 + e103*v310 + e112*v301 + e202*v211 + e211*v202 + e301*v112 + e310*v103 + e400*v013
    o404 = e004*v400 + e103*v301 + e202*v202 + e301*v103 + e400*v004
    o350 = e040*v310 + e130*v220 + e220*v130 + e310*v040
    o341 = e031*v310 + e040*v301 + e121*v220 + e130*v211 + e211*v130 + e220*v121 + e301*v040 + e310*v031
    o332 = e022*v310 + e031*v301 + e112*v220 + e121*v211 + e130*v202 + e202*v130 + e211*v121 + e220*v112 + e301*v031 + e310*v022
    o323 = e013*v310 + e022*v301 + e103*v220 + e112*v211 + e121*v202 + e202*v121 + e211*v112 + e220*v103 + e301*v022 + e310*v013
    o314 = e004*v310 + e013*v301 + e103*v211 + e112*v202 + e202*v112 + e211*v103 + e301*v013 + e310*v004
    o305 = e004*v301 + e103*v202 + e202*v103 + e301*v004
    o260 = e040*v220 + e130*v130 + e220*v040
    o251 = e031*v220 + e040*v211 + e121*v130 + e130*v121 + e211*v040 + e220*v031
    o242 = e022*v220 + e031*v211 + e040*v202 + e112*v130 + e121*v121 + e130*v112 + e202*v040 + e211*v031 + e220*v022
    o233 = e013*v220 + e022*v211 + e031*v202 + e103*v130 + e112*v121 + e121*v112 + e130*v103 + e202*v031 + e211*v022 + e220*v013
    o224 = e004*v220 + e013*v211 + e022*v202 + e103*v121 + e112*v112 + e121*v103 + e202*v022 + e211*v013 + e220*v004
    o215 = e004*v211 + e013*v202 + e103*v112 + e112*v103 + e202*v013 + e211*v004
    o206 = e004*v202 + e103*v103 + e202*v004
    o170 = e040*v130 + e130*v040
    o161 = e031*v130 + e040*v121 + e121*v040 + e130*v031
    o152 = e022*v130 + e031*v121 + e040*v112 + e112*v040 + e121*v031 + e130*v022
    o143 = e013*v130 + e022*v121 + e031*v112 + e040*v103 + e103*v040 + e112*v031 + e121*v022 + e130*v013
    o134 = e004*v130 + e013*v121 + e022*v112 + e031*v103 + e103*v031 + e112*v022 + e121*v013 + e130*v004
    o125 = e004*v121 + e013*v112 + e022*v103 + e103*v022 + e112*v013 + e121*v004
    o116 = e004*v112 + e013*v103 + e103*v013 + e112*v004
    o107 = e004*v103 + e103*v004
    o080 = e040*v040
    o071 = e031*v040 + e040*v031
    o062 = e022*v040 + e031*v031 + e040*v022
    o053 = e013*v040 + e022*v031 + e031*v022 + e040*v013
    o044 = e004*v040 + e013*v031 + e022*v022 + e031*v013 + e040*v004
    o035 = e004*v031 + e013*v022 + e022*v013 + e031*v004
    o026 = e004*v022 + e013*v013 + e022*v004
    o017 = e004*v013 + e013*v004
    o008 = e004*v004
    M1111 = o008/429 + o026/3003 + o044/5005 + o062/3003 + o080/429 + 5*o206/3003 + o224/3003 + o242/3003 + 5*o260/3003 + o404/429 + o422/1287 + o440/429 + o602/143 + o620/143 + o800/13
    M1112 = o116/3003 + o134/5005 + o152/3003 + o170/429 + o314/3003 + o332/3003 + 5*o350/3003 + o512/1287 + o530/429 + o710/143
    M1113 = o107/429 + o125/3003 + o143/5005 + o161/3003 + 5*o305/3003 + o323/3003 + o341/3003 + o503/429 + o521/1287 + o701/143
    M1122 = o008/1287 + o026/3003 + o044/3003 + o062/1287 + o080/143 + o206/3003 + o224/5005 + o242/3003 + o260/429 + o404/3003 + o422/3003 + 5*o440/3003 + o602/1287 + o620/429 + o800/143
    M1123 = o017/1287 + o035/3003 + o053/3003 + o071/1287 + o215/3003 + o233/5005 + o251/3003 + o413/3003 + o431/3003 + o611/1287
    M1133 = o008/143 + o026/1287 + o044/3003 + o062/3003 + o080/1287 + o206/429 + o224/3003 + o242/5005 + o260/3003 + 5*o404/3003 + o422/3003 + o440/3003 + o602/429 + o620/1287 + o800/143
    M1222 = o116/3003 + o134/3003 + o152/1287 + o170/143 + o314/5005 + o332/3003 + o350/429 + o512/3003 + 5*o530/3003 + o710/429
    M1223 = o107/1287 + o125/3003 + o143/3003 + o161/1287 + o305/3003 + o323/5005 + o341/3003 + o503/3003 + o521/3003 + o701/1287
    M1233 = o116/1287 + o134/3003 + o152/3003 + o170/1287 + o314/3003 + o332/5005 + o350/3003 + o512/3003 + o530/3003 + o710/1287
    M1333 = o107/143 + o125/1287 + o143/3003 + o161/3003 + o305/429 + o323/3003 + o341/5005 + 5*o503/3003 + o521/3003 + o701/429
    M2222 = o008/429 + 5*o026/3003 + o044/429 + o062/143 + o080/13 + o206/3003 + o224/3003 + o242/1287 + o260/143 + o404/5005 + o422/3003 + o440/429 + o602/3003 + 5*o620/3003 + o800/429
    M2223 = o017/429 + 5*o035/3003 + o053/429 + o071/143 + o215/3003 + o233/3003 + o251/1287 + o413/5005 + o431/3003 + o611/3003
    M2233 = o008/143 + o026/429 + 5*o044/3003 + o062/429 + o080/143 + o206/1287 + o224/3003 + o242/3003 + o260/1287 + o404/3003 + o422/5005 + o440/3003 + o602/3003 + o620/3003 + o800/1287
    M2333 = o017/143 + o035/429 + 5*o053/3003 + o071/429 + o215/1287 + o233/3003 + o251/3003 + o413/3003 + o431/5005 + o611/3003
    M3333 = o008/13 + o026/143 + o044/429 + 5*o062/3003 + o080/429 + o206/143 + o224/1287 + o242/3003 + o260/3003 + o404/429 + o422/3003 + o440/5005 + 5*o602/3003 + o620/3003 + o800/429
    return M1111, M1112, M1113, M1122, M1123, M1133, M1222, M1223, M1233, M1333, M2222, M2223, M2233, M2333, M3333


def stiffness_from_tensor_moments(
    M1111: Array, M1112: Array, M1113: Array, M1122: Array, M1123: Array, M1133: Array, M1222: Array, M1223: Array, M1233: Array, M1333: Array, M2222: Array, M2223: Array, M2233: Array, M2333: Array, M3333: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array]:
    """All 21 components over (M/V) l_e^2 k_n from the moments of E W^2.

    Parameters
    ----------
    M1111 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 1.
    M1112 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 2.
    M1113 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 1, 3.
    M1122 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 2, 2.
    M1123 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 2, 3.
    M1133 : (...) array [-]
        Mean of the weight times the normal's components 1, 1, 3, 3.
    M1222 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 2, 2.
    M1223 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 2, 3.
    M1233 : (...) array [-]
        Mean of the weight times the normal's components 1, 2, 3, 3.
    M1333 : (...) array [-]
        Mean of the weight times the normal's components 1, 3, 3, 3.
    M2222 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 2, 2.
    M2223 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 2, 3.
    M2233 : (...) array [-]
        Mean of the weight times the normal's components 2, 2, 3, 3.
    M2333 : (...) array [-]
        Mean of the weight times the normal's components 2, 3, 3, 3.
    M3333 : (...) array [-]
        Mean of the weight times the normal's components 3, 3, 3, 3.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C1123 : (...) array [-]
        Stiffness component 1123.
    C1113 : (...) array [-]
        Stiffness component 1113.
    C1112 : (...) array [-]
        Stiffness component 1112.
    C2222 : (...) array [-]
        Stiffness component 2222.
    C2233 : (...) array [-]
        Stiffness component 2233.
    C2223 : (...) array [-]
        Stiffness component 2223.
    C2213 : (...) array [-]
        Stiffness component 2213.
    C2212 : (...) array [-]
        Stiffness component 2212.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C3323 : (...) array [-]
        Stiffness component 3323.
    C3313 : (...) array [-]
        Stiffness component 3313.
    C3312 : (...) array [-]
        Stiffness component 3312.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C2313 : (...) array [-]
        Stiffness component 2313.
    C2312 : (...) array [-]
        Stiffness component 2312.
    C1313 : (...) array [-]
        Stiffness component 1313.
    C1312 : (...) array [-]
        Stiffness component 1312.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 138.
    """
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    C1111 = M1111*one_minus_lam + lam*(4*M1111 + 4*M1122 + 4*M1133)/4
    C1122 = M1122*one_minus_lam
    C1133 = M1133*one_minus_lam
    C1123 = M1123*one_minus_lam
    C1113 = M1113*one_minus_lam + lam*(2*M1113 + 2*M1223 + 2*M1333)/4
    C1112 = M1112*one_minus_lam + lam*(2*M1112 + 2*M1222 + 2*M1233)/4
    C2222 = M2222*one_minus_lam + lam*(4*M1122 + 4*M2222 + 4*M2233)/4
    C2233 = M2233*one_minus_lam
    C2223 = M2223*one_minus_lam + lam*(2*M1123 + 2*M2223 + 2*M2333)/4
    C2213 = M1223*one_minus_lam
    C2212 = M1222*one_minus_lam + lam*(2*M1112 + 2*M1222 + 2*M1233)/4
    C3333 = M3333*one_minus_lam + lam*(4*M1133 + 4*M2233 + 4*M3333)/4
    C3323 = M2333*one_minus_lam + lam*(2*M1123 + 2*M2223 + 2*M2333)/4
    C3313 = M1333*one_minus_lam + lam*(2*M1113 + 2*M1223 + 2*M1333)/4
    C3312 = M1233*one_minus_lam
    C2323 = M2233*one_minus_lam + lam*(M1122 + M1133 + M2222 + 2*M2233 + M3333)/4
    C2313 = M1233*one_minus_lam + lam*(M1112 + M1222 + M1233)/4
    C2312 = M1223*one_minus_lam + lam*(M1113 + M1223 + M1333)/4
    C1313 = M1133*one_minus_lam + lam*(M1111 + M1122 + 2*M1133 + M2233 + M3333)/4
    C1312 = M1123*one_minus_lam + lam*(M1123 + M2223 + M2333)/4
    C1212 = M1122*one_minus_lam + lam*(M1111 + 2*M1122 + M1133 + M2222 + M2233)/4
    return C1111, C1122, C1133, C1123, C1113, C1112, C2222, C2233, C2223, C2213, C2212, C3333, C3323, C3313, C3312, C2323, C2313, C2312, C1313, C1312, C1212


def general_constant(
    D11: Array, D22: Array, D33: Array, D23: Array, D13: Array, D12: Array, D1111: Array, D1112: Array, D1113: Array, D1122: Array, D1123: Array, D1133: Array, D1222: Array, D1223: Array, D1233: Array, D1333: Array, D2222: Array, D2223: Array, D2233: Array, D2333: Array, D3333: Array, Dr11: Array, Dr22: Array, Dr33: Array, Dr23: Array, Dr13: Array, Dr12: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array]:
    """Stiffness of a fabric without an axis, constant contact stiffness, from the fabric to the components.

    Exact for exact fractions. With a branch tensor of zero they are the moments of E.

    Parameters
    ----------
    D11 : (...) array [-]
        Component 11 of the contact-normal tensor, traceless.
    D22 : (...) array [-]
        Component 22 of the contact-normal tensor, traceless.
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D23 : (...) array [-]
        Component 23 of the contact-normal tensor, traceless.
    D13 : (...) array [-]
        Component 13 of the contact-normal tensor, traceless.
    D12 : (...) array [-]
        Component 12 of the contact-normal tensor, traceless.
    D1111 : (...) array [-]
        Component 1111 of the contact-normal tensor of rank four, symmetric and traceless.
    D1112 : (...) array [-]
        Component 1112 of the contact-normal tensor of rank four, symmetric and traceless.
    D1113 : (...) array [-]
        Component 1113 of the contact-normal tensor of rank four, symmetric and traceless.
    D1122 : (...) array [-]
        Component 1122 of the contact-normal tensor of rank four, symmetric and traceless.
    D1123 : (...) array [-]
        Component 1123 of the contact-normal tensor of rank four, symmetric and traceless.
    D1133 : (...) array [-]
        Component 1133 of the contact-normal tensor of rank four, symmetric and traceless.
    D1222 : (...) array [-]
        Component 1222 of the contact-normal tensor of rank four, symmetric and traceless.
    D1223 : (...) array [-]
        Component 1223 of the contact-normal tensor of rank four, symmetric and traceless.
    D1233 : (...) array [-]
        Component 1233 of the contact-normal tensor of rank four, symmetric and traceless.
    D1333 : (...) array [-]
        Component 1333 of the contact-normal tensor of rank four, symmetric and traceless.
    D2222 : (...) array [-]
        Component 2222 of the contact-normal tensor of rank four, symmetric and traceless.
    D2223 : (...) array [-]
        Component 2223 of the contact-normal tensor of rank four, symmetric and traceless.
    D2233 : (...) array [-]
        Component 2233 of the contact-normal tensor of rank four, symmetric and traceless.
    D2333 : (...) array [-]
        Component 2333 of the contact-normal tensor of rank four, symmetric and traceless.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr11 : (...) array [-]
        Component 11 of the branch tensor, traceless.
    Dr22 : (...) array [-]
        Component 22 of the branch tensor, traceless.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
    Dr23 : (...) array [-]
        Component 23 of the branch tensor, traceless.
    Dr13 : (...) array [-]
        Component 13 of the branch tensor, traceless.
    Dr12 : (...) array [-]
        Component 12 of the branch tensor, traceless.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C1123 : (...) array [-]
        Stiffness component 1123.
    C1113 : (...) array [-]
        Stiffness component 1113.
    C1112 : (...) array [-]
        Stiffness component 1112.
    C2222 : (...) array [-]
        Stiffness component 2222.
    C2233 : (...) array [-]
        Stiffness component 2233.
    C2223 : (...) array [-]
        Stiffness component 2223.
    C2213 : (...) array [-]
        Stiffness component 2213.
    C2212 : (...) array [-]
        Stiffness component 2212.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C3323 : (...) array [-]
        Stiffness component 3323.
    C3313 : (...) array [-]
        Stiffness component 3313.
    C3312 : (...) array [-]
        Stiffness component 3312.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C2313 : (...) array [-]
        Stiffness component 2313.
    C2312 : (...) array [-]
        Stiffness component 2312.
    C1313 : (...) array [-]
        Stiffness component 1313.
    C1312 : (...) array [-]
        Stiffness component 1312.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 996.
    """
    M1111, M1112, M1113, M1122, M1123, M1133, M1222, M1223, M1233, M1333, M2222, M2223, M2233, M2333, M3333 = tensor_moments(D11, D22, D33, D23, D13, D12, D1111, D1112, D1113, D1122, D1123, D1133, D1222, D1223, D1233, D1333, D2222, D2223, D2233, D2333, D3333, Dr11, Dr22, Dr33, Dr23, Dr13, Dr12)
    return stiffness_from_tensor_moments(M1111, M1112, M1113, M1122, M1123, M1133, M1222, M1223, M1233, M1333, M2222, M2223, M2233, M2333, M3333, nu)
