"""rockphypy: Hertz-Mindlin moduli of arrays, and the stress-induced anisotropy of sphere packs, one item a call."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from granular.speed.interleaved import Way
from granular.speed.sample import POISSON

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Five = tuple[float, ...]

SHEAR, VOID_RATIO, COORDINATION = 31e9, 0.5744, 8.6848
"""Solid and packing of the printed tables: [Pa], [-], [-]."""

BULK = 2 * SHEAR * (1 + POISSON) / (3 * (1 - 2 * POISSON))
"""Bulk modulus of the solid [Pa]."""

ROUGH = 1.0
"""Its share of rough contacts [-]; by its formula all are rough at 1, though its own help says 0."""


def moduli(pressure: Array) -> tuple[Way, Way]:
    """Bulk and shear modulus of isotropic packings under many pressures.

    Parameters
    ----------
    pressure : (n,) array
        Mean stress [Pa].

    Returns
    -------
    ours, theirs : Way
        Both give K and G [Pa], (n,) each.

    Raises
    ------
    ModuleNotFoundError
        rockphypy is not installed.

    Notes
    -----
    Source: the same formula, that of rough spheres without slip.
    """
    from rockphypy import GM

    porosity = VOID_RATIO / (1 + VOID_RATIO)
    megapascals = pressure / 1e6

    def theirs() -> tuple[Array, Array]:
        bulk, shear = GM.hertzmindlin(BULK / 1e9, SHEAR / 1e9, porosity, COORDINATION, megapascals, ROUGH)
        return 1e9 * bulk, 1e9 * shear

    def error(call: Callable[[], tuple[Array, Array]]) -> float:
        from granular.hertz_mindlin import moduli as known

        first = known(SHEAR, POISSON, mean_stress=float(pressure[0]), void_ratio=VOID_RATIO,
                      coordination_number=COORDINATION)
        return max(abs(float(found[0]) / right - 1) for found, right in zip(call(), first, strict=True))

    ours = partial(isotropic, pressure)
    return (Way(name="this package", elements=pressure.size, call=ours, error=partial(error, ours)),
            Way(name="rockphypy, GM.hertzmindlin", elements=pressure.size, call=theirs, error=partial(error, theirs)))


def isotropic(pressure: Array) -> tuple[Array, Array]:
    """K and G of isotropic packings under many pressures, from one stiffness and one power of the pressure.

    Parameters
    ----------
    pressure : (n,) array
        Mean stress [Pa].

    Returns
    -------
    bulk, shear : (n,) array
        Moduli [Pa].

    Notes
    -----
    Accuracy: a few units in the last place. Source: eqs (4), (20) and (23): all components go like p^(1/3).

    Examples
    --------
    >>> import numpy as np
    >>> bulk, _ = isotropic(np.array([28e3]))
    >>> round(float(bulk[0]) / 1e6, 2)
    194.74
    """
    import numpy as np

    from granular.array_stiffness import axial_stiffness
    from granular.contact_law import reference_stiffness

    c1111, _, c1122, _, c2323, _ = axial_stiffness(0.0, 0.0, poisson_ratio=POISSON, kinetic=False).tolist()
    unit = reference_stiffness(SHEAR, POISSON, mean_stress=1.0, void_ratio=VOID_RATIO,
                               coordination_number=COORDINATION)
    root = np.cbrt(pressure)
    return (c1111 + 2 * c1122) / 3 * unit * root, c2323 * unit * root


POROSITY, STRAIN = 0.36, -1e-4
"""Of the sphere packs under a strain along one axis [-]; compression is negative there."""


def anisotropic(count: int) -> Way:
    """Five constants of a sphere pack under a uniaxial strain on top of a hydrostatic one, one pack a call.

    Parameters
    ----------
    count : int
        How many packs [-].

    Returns
    -------
    Way
        A loop over them; its error is that of the worst constant of the first pack.

    Raises
    ------
    ModuleNotFoundError
        rockphypy is not installed.

    Notes
    -----
    Source: Johnson et al. (1998) as that package has it.
    """
    from rockphypy import GM

    strains = [STRAIN * (1 + step / count) for step in range(count)]

    def theirs() -> list[object]:
        return [GM.johnson(BULK / 1e9, SHEAR / 1e9, COORDINATION, POROSITY, strain, 0.5 * strain) for strain in strains]

    def error() -> float:
        import numpy as np

        found, known = np.asarray(constants(2.0)), np.asarray(sphere_pack(2.0))
        return float(abs(found / known - 1).max())

    return Way(name="rockphypy, GM.johnson, one pack a call", elements=count, call=theirs, error=error)


def constants(quotient: float) -> Five:
    """C11, C33, C13, C44, C66 of that package for one sphere pack.

    Parameters
    ----------
    quotient : float
        Hydrostatic over uniaxial strain [-], > 0.

    Returns
    -------
    tuple of 5 float
        Constants [GPa].

    Raises
    ------
    ModuleNotFoundError
        rockphypy is not installed.

    Notes
    -----
    Source: ``GM.johnson``.
    """
    from rockphypy import GM

    matrix = GM.johnson(BULK / 1e9, SHEAR / 1e9, COORDINATION, POROSITY, STRAIN, STRAIN / quotient)[0]
    return tuple(float(matrix[i, j]) for i, j in ((0, 0), (2, 2), (0, 2), (3, 3), (5, 5)))


def sphere_pack(quotient: float) -> Five:
    """The same constants, by integrals over the contacts of the pack.

    Parameters
    ----------
    quotient : float
        Hydrostatic over uniaxial strain [-], > 0.

    Returns
    -------
    tuple of 5 float
        C11, C33, C13, C44, C66 [GPa].

    Notes
    -----
    Each contact presses in by sqrt(q + x^2), q the quotient and x the cosine to axis 3, so that every constant is made
    of three integrals of it. Source: Norris and Johnson (1997).
    """
    scale, b, c = _scales(quotient)
    i0, i2, i4 = integrals(quotient, first_integral(quotient))
    return (scale * (2 * b * (i0 - i2) + 3 * c / 4 * (i0 - 2 * i2 + i4)), *_by_integrals(scale, b, c, i0, i2, i4))


def as_written(quotient: float) -> Five:
    """The same constants as rockphypy 0.0.2 writes them, with its two slips.

    Parameters
    ----------
    quotient : float
        Hydrostatic over uniaxial strain [-], > 0.

    Returns
    -------
    tuple of 5 float
        C11, C33, C13, C44, C66 [GPa].

    Notes
    -----
    The bracket of a logarithm is misplaced (:func:`misplaced_bracket`). C11 is no integral but its first terms for
    little uniaxial strain, with the strains of the second one inverted and all of it divided by sqrt(q).
    Source: ``GM.johnson`` of that version.
    """
    scale, b, c = _scales(quotient)
    return (scale * (4 * b / 3 + 2 * c / 5 + quotient * (2 * b / 15 + c / 35)),
            *_by_integrals(scale, b, c, *integrals(quotient, misplaced_bracket(quotient))))


def _scales(quotient: float) -> tuple[float, float, float]:
    normal, shear = 4 * SHEAR / (1 - POISSON) / 1e9, 8 * SHEAR / (2 - POISSON) / 1e9
    scale = 3 / 32 * normal * shear * COORDINATION * (1 - POROSITY) * math.sqrt(-STRAIN / quotient)
    return scale, 2 / (math.pi * normal), 4 / math.pi * (1 / shear - 1 / normal)


def _by_integrals(scale: float, b: float, c: float, i0: float, i2: float, i4: float) -> Five:
    return (scale * (4 * b * i2 + 2 * c * i4), scale * c * (i2 - i4), scale * (b / 2 * (i0 + i2) + c * (i2 - i4)),
            scale * (b * (i0 - i2) + c / 4 * (i0 - 2 * i2 + i4)))


def integrals(quotient: float, first: float) -> tuple[float, float, float]:
    """Integrals of x^(2k) sqrt(q + x^2) over x from 0 to 1 for k = 0, 1, 2, from the first of them.

    Parameters
    ----------
    quotient : float
        q [-], > 0.
    first : float
        The integral for k = 0 [-].

    Returns
    -------
    tuple of 3 float
        The integrals [-].

    Notes
    -----
    Accuracy: digits are lost where q is far above 1. Source: integration by parts.
    """
    second = ((1 + quotient) ** 1.5 - quotient * first) / 4
    return first, second, ((1 + quotient) ** 1.5 - 3 * quotient * second) / 6


def first_integral(quotient: float) -> float:
    """I_0, the integral of sqrt(q + x^2) over x from 0 to 1.

    Parameters
    ----------
    quotient : float
        q [-], > 0.

    Returns
    -------
    float
        The integral [-].

    Notes
    -----
    Accuracy: a few units in the last place. Source: an elementary integral.

    Examples
    --------
    >>> round(first_integral(5.0), 6)
    2.308513
    """
    return (math.sqrt(1 + quotient) + quotient * math.asinh(1 / math.sqrt(quotient))) / 2


def misplaced_bracket(quotient: float) -> float:
    """What rockphypy 0.0.2 takes for it: log(1 + sqrt(1 + q)/a) where log((1 + sqrt(1 + q))/a) belongs, a^2 = q.

    Parameters
    ----------
    quotient : float
        q [-], > 0.

    Returns
    -------
    float
        Another number [-].

    Notes
    -----
    Source: ``GM.johnson`` of that version.

    Examples
    --------
    >>> round(misplaced_bracket(5.0), 6)
    3.07416
    """
    root = math.sqrt(1 + quotient)
    return (root + quotient * math.log(1 + root / math.sqrt(quotient))) / 2
