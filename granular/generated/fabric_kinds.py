"""Fabric tensors of three kinds: scalar functions.

Emitted by ``derivations write`` from the derivation ``fabric_kinds``; do not edit.
Source: N_ij below (23), (14) of Pan & Dong (1999).
Domain: N_ii = 1; density of rank four at most, or its part of rank four at most.
Operations: 272 (405 in the outputs as derived).
"""

from __future__ import annotations


def third_kind(
    N1111: float, N1112: float, N1113: float, N1122: float, N1123: float, N1133: float, N1222: float, N1223: float, N1233: float, N1333: float, N2222: float, N2223: float, N2233: float, N2333: float, N3333: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """D_ij and D_ijkl from the moments of rank four.

    Parameters
    ----------
    N1111 : float [-]
        Mean of n1 n1 n1 n1 over the contacts.
    N1112 : float [-]
        Mean of n1 n1 n1 n2 over the contacts.
    N1113 : float [-]
        Mean of n1 n1 n1 n3 over the contacts.
    N1122 : float [-]
        Mean of n1 n1 n2 n2 over the contacts.
    N1123 : float [-]
        Mean of n1 n1 n2 n3 over the contacts.
    N1133 : float [-]
        Mean of n1 n1 n3 n3 over the contacts.
    N1222 : float [-]
        Mean of n1 n2 n2 n2 over the contacts.
    N1223 : float [-]
        Mean of n1 n2 n2 n3 over the contacts.
    N1233 : float [-]
        Mean of n1 n2 n3 n3 over the contacts.
    N1333 : float [-]
        Mean of n1 n3 n3 n3 over the contacts.
    N2222 : float [-]
        Mean of n2 n2 n2 n2 over the contacts.
    N2223 : float [-]
        Mean of n2 n2 n2 n3 over the contacts.
    N2233 : float [-]
        Mean of n2 n2 n3 n3 over the contacts.
    N2333 : float [-]
        Mean of n2 n3 n3 n3 over the contacts.
    N3333 : float [-]
        Mean of n3 n3 n3 n3 over the contacts.

    Returns
    -------
    D11 : float [-]
        Component 11 of the contact-normal tensor, traceless.
    D12 : float [-]
        Component 12 of the contact-normal tensor, traceless.
    D13 : float [-]
        Component 13 of the contact-normal tensor, traceless.
    D22 : float [-]
        Component 22 of the contact-normal tensor, traceless.
    D23 : float [-]
        Component 23 of the contact-normal tensor, traceless.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    D1111 : float [-]
        Component 1111 of the contact-normal tensor of rank four, symmetric and traceless.
    D1112 : float [-]
        Component 1112 of the contact-normal tensor of rank four, symmetric and traceless.
    D1113 : float [-]
        Component 1113 of the contact-normal tensor of rank four, symmetric and traceless.
    D1122 : float [-]
        Component 1122 of the contact-normal tensor of rank four, symmetric and traceless.
    D1123 : float [-]
        Component 1123 of the contact-normal tensor of rank four, symmetric and traceless.
    D1133 : float [-]
        Component 1133 of the contact-normal tensor of rank four, symmetric and traceless.
    D1222 : float [-]
        Component 1222 of the contact-normal tensor of rank four, symmetric and traceless.
    D1223 : float [-]
        Component 1223 of the contact-normal tensor of rank four, symmetric and traceless.
    D1233 : float [-]
        Component 1233 of the contact-normal tensor of rank four, symmetric and traceless.
    D1333 : float [-]
        Component 1333 of the contact-normal tensor of rank four, symmetric and traceless.
    D2222 : float [-]
        Component 2222 of the contact-normal tensor of rank four, symmetric and traceless.
    D2223 : float [-]
        Component 2223 of the contact-normal tensor of rank four, symmetric and traceless.
    D2233 : float [-]
        Component 2233 of the contact-normal tensor of rank four, symmetric and traceless.
    D2333 : float [-]
        Component 2333 of the contact-normal tensor of rank four, symmetric and traceless.
    D3333 : float [-]
        P4 coefficient of the contact-normal density.

    Operations: 99.
    """
    N11 = N1111 + N1122 + N1133
    N12 = N1112 + N1222 + N1233
    N13 = N1113 + N1223 + N1333
    N22 = N1122 + N2222 + N2233
    N23 = N1123 + N2223 + N2333
    N33 = N1133 + N2233 + N3333
    D11 = (15*N11 - 5)/2
    D12 = 15*N12/2
    D13 = 15*N13/2
    D22 = (15*N22 - 5)/2
    D23 = 15*N23/2
    D33 = (15*N33 - 5)/2
    D1111 = (-270*N11 + 315*N1111 + 27)/8
    D1112 = (315*N1112 - 135*N12)/8
    D1113 = (315*N1113 - 135*N13)/8
    D1122 = (-45*N11 + 315*N1122 - 45*N22 + 9)/8
    D1123 = (315*N1123 - 45*N23)/8
    D1133 = (-45*N11 + 315*N1133 - 45*N33 + 9)/8
    D1222 = (-135*N12 + 315*N1222)/8
    D1223 = (315*N1223 - 45*N13)/8
    D1233 = (-45*N12 + 315*N1233)/8
    D1333 = (-135*N13 + 315*N1333)/8
    D2222 = (-270*N22 + 315*N2222 + 27)/8
    D2223 = (315*N2223 - 135*N23)/8
    D2233 = (-45*N22 + 315*N2233 - 45*N33 + 9)/8
    D2333 = (-135*N23 + 315*N2333)/8
    D3333 = (-270*N33 + 315*N3333 + 27)/8
    return D11, D12, D13, D22, D23, D33, D1111, D1112, D1113, D1122, D1123, D1133, D1222, D1223, D1233, D1333, D2222, D2223, D2233, D2333, D3333


def second_kind(
    N1111: float, N1112: float, N1113: float, N1122: float, N1123: float, N1133: float, N1222: float, N1223: float, N1233: float, N1333: float, N2222: float, N2223: float, N2233: float, N2333: float, N3333: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """F_ij and F_ijkl from the moments of rank four.

    Parameters
    ----------
    N1111 : float [-]
        Mean of n1 n1 n1 n1 over the contacts.
    N1112 : float [-]
        Mean of n1 n1 n1 n2 over the contacts.
    N1113 : float [-]
        Mean of n1 n1 n1 n3 over the contacts.
    N1122 : float [-]
        Mean of n1 n1 n2 n2 over the contacts.
    N1123 : float [-]
        Mean of n1 n1 n2 n3 over the contacts.
    N1133 : float [-]
        Mean of n1 n1 n3 n3 over the contacts.
    N1222 : float [-]
        Mean of n1 n2 n2 n2 over the contacts.
    N1223 : float [-]
        Mean of n1 n2 n2 n3 over the contacts.
    N1233 : float [-]
        Mean of n1 n2 n3 n3 over the contacts.
    N1333 : float [-]
        Mean of n1 n3 n3 n3 over the contacts.
    N2222 : float [-]
        Mean of n2 n2 n2 n2 over the contacts.
    N2223 : float [-]
        Mean of n2 n2 n2 n3 over the contacts.
    N2233 : float [-]
        Mean of n2 n2 n3 n3 over the contacts.
    N2333 : float [-]
        Mean of n2 n3 n3 n3 over the contacts.
    N3333 : float [-]
        Mean of n3 n3 n3 n3 over the contacts.

    Returns
    -------
    F11 : float [-]
    F12 : float [-]
    F13 : float [-]
    F22 : float [-]
    F23 : float [-]
    F33 : float [-]
    F1111 : float [-]
    F1112 : float [-]
    F1113 : float [-]
    F1122 : float [-]
    F1123 : float [-]
    F1133 : float [-]
    F1222 : float [-]
    F1223 : float [-]
    F1233 : float [-]
    F1333 : float [-]
    F2222 : float [-]
    F2223 : float [-]
    F2233 : float [-]
    F2333 : float [-]
    F3333 : float [-]

    Operations: 99.
    """
    N11 = N1111 + N1122 + N1133
    N12 = N1112 + N1222 + N1233
    N13 = N1113 + N1223 + N1333
    N22 = N1122 + N2222 + N2233
    N23 = N1123 + N2223 + N2333
    N33 = N1133 + N2233 + N3333
    F11 = (15*N11 - 3)/2
    F12 = 15*N12/2
    F13 = 15*N13/2
    F22 = (15*N22 - 3)/2
    F23 = 15*N23/2
    F33 = (15*N33 - 3)/2
    F1111 = (-210*N11 + 315*N1111 + 15)/8
    F1112 = (315*N1112 - 105*N12)/8
    F1113 = (315*N1113 - 105*N13)/8
    F1122 = (-35*N11 + 315*N1122 - 35*N22 + 5)/8
    F1123 = (315*N1123 - 35*N23)/8
    F1133 = (-35*N11 + 315*N1133 - 35*N33 + 5)/8
    F1222 = (-105*N12 + 315*N1222)/8
    F1223 = (315*N1223 - 35*N13)/8
    F1233 = (-35*N12 + 315*N1233)/8
    F1333 = (-105*N13 + 315*N1333)/8
    F2222 = (-210*N22 + 315*N2222 + 15)/8
    F2223 = (315*N2223 - 105*N23)/8
    F2233 = (-35*N22 + 315*N2233 - 35*N33 + 5)/8
    F2333 = (-105*N23 + 315*N2333)/8
    F3333 = (-210*N33 + 315*N3333 + 15)/8
    return F11, F12, F13, F22, F23, F33, F1111, F1112, F1113, F1122, F1123, F1133, F1222, F1223, F1233, F1333, F2222, F2223, F2233, F2333, F3333


def first_kind(
    D11: float, D12: float, D13: float, D22: float, D23: float, D1111: float, D1112: float, D1113: float, D1122: float, D1123: float, D1133: float, D1222: float, D1223: float, D1233: float, D1333: float, D2222: float, D2223: float, D2233: float, D2333: float, D3333: float,
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Moments of rank four from D_ij, whose trace is zero, and D_ijkl.

    Parameters
    ----------
    D11 : float [-]
        Component 11 of the contact-normal tensor, traceless.
    D12 : float [-]
        Component 12 of the contact-normal tensor, traceless.
    D13 : float [-]
        Component 13 of the contact-normal tensor, traceless.
    D22 : float [-]
        Component 22 of the contact-normal tensor, traceless.
    D23 : float [-]
        Component 23 of the contact-normal tensor, traceless.
    D1111 : float [-]
        Component 1111 of the contact-normal tensor of rank four, symmetric and traceless.
    D1112 : float [-]
        Component 1112 of the contact-normal tensor of rank four, symmetric and traceless.
    D1113 : float [-]
        Component 1113 of the contact-normal tensor of rank four, symmetric and traceless.
    D1122 : float [-]
        Component 1122 of the contact-normal tensor of rank four, symmetric and traceless.
    D1123 : float [-]
        Component 1123 of the contact-normal tensor of rank four, symmetric and traceless.
    D1133 : float [-]
        Component 1133 of the contact-normal tensor of rank four, symmetric and traceless.
    D1222 : float [-]
        Component 1222 of the contact-normal tensor of rank four, symmetric and traceless.
    D1223 : float [-]
        Component 1223 of the contact-normal tensor of rank four, symmetric and traceless.
    D1233 : float [-]
        Component 1233 of the contact-normal tensor of rank four, symmetric and traceless.
    D1333 : float [-]
        Component 1333 of the contact-normal tensor of rank four, symmetric and traceless.
    D2222 : float [-]
        Component 2222 of the contact-normal tensor of rank four, symmetric and traceless.
    D2223 : float [-]
        Component 2223 of the contact-normal tensor of rank four, symmetric and traceless.
    D2233 : float [-]
        Component 2233 of the contact-normal tensor of rank four, symmetric and traceless.
    D2333 : float [-]
        Component 2333 of the contact-normal tensor of rank four, symmetric and traceless.
    D3333 : float [-]
        P4 coefficient of the contact-normal density.

    Returns
    -------
    N1111 : float [-]
        Mean of n1 n1 n1 n1 over the contacts.
    N1112 : float [-]
        Mean of n1 n1 n1 n2 over the contacts.
    N1113 : float [-]
        Mean of n1 n1 n1 n3 over the contacts.
    N1122 : float [-]
        Mean of n1 n1 n2 n2 over the contacts.
    N1123 : float [-]
        Mean of n1 n1 n2 n3 over the contacts.
    N1133 : float [-]
        Mean of n1 n1 n3 n3 over the contacts.
    N1222 : float [-]
        Mean of n1 n2 n2 n2 over the contacts.
    N1223 : float [-]
        Mean of n1 n2 n2 n3 over the contacts.
    N1233 : float [-]
        Mean of n1 n2 n3 n3 over the contacts.
    N1333 : float [-]
        Mean of n1 n3 n3 n3 over the contacts.
    N2222 : float [-]
        Mean of n2 n2 n2 n2 over the contacts.
    N2223 : float [-]
        Mean of n2 n2 n2 n3 over the contacts.
    N2233 : float [-]
        Mean of n2 n2 n3 n3 over the contacts.
    N2333 : float [-]
        Mean of n2 n3 n3 n3 over the contacts.
    N3333 : float [-]
        Mean of n3 n3 n3 n3 over the contacts.

    Operations: 74.
    """
    D33 = -D11 - D22
    N1111 = (36*D11 + 8*D1111 + 63)/315
    N1112 = (8*D1112 + 18*D12)/315
    N1113 = (8*D1113 + 18*D13)/315
    N1122 = (6*D11 + 8*D1122 + 6*D22 + 21)/315
    N1123 = (8*D1123 + 6*D23)/315
    N1133 = (6*D11 + 8*D1133 + 6*D33 + 21)/315
    N1222 = (18*D12 + 8*D1222)/315
    N1223 = (8*D1223 + 6*D13)/315
    N1233 = (6*D12 + 8*D1233)/315
    N1333 = (18*D13 + 8*D1333)/315
    N2222 = (36*D22 + 8*D2222 + 63)/315
    N2223 = (8*D2223 + 18*D23)/315
    N2233 = (6*D22 + 8*D2233 + 6*D33 + 21)/315
    N2333 = (18*D23 + 8*D2333)/315
    N3333 = (36*D33 + 8*D3333 + 63)/315
    return N1111, N1112, N1113, N1122, N1123, N1133, N1222, N1223, N1233, N1333, N2222, N2223, N2233, N2333, N3333
