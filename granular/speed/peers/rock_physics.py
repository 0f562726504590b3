"""rockphypy: Hertz-Mindlin moduli of arrays, and the stress-induced anisotropy of sphere packs, one item a call."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.speed.interleaved import Way
from granular.speed.sample import POISSON

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

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

    return (Way(name="this package", elements=pressure.size, call=lambda: isotropic(pressure)),
            Way(name="rockphypy, GM.hertzmindlin", elements=pressure.size, call=theirs))


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


def anisotropic(count: int) -> Way:
    """Five constants of a sphere pack under a uniaxial strain on top of a hydrostatic one, one pack a call.

    Parameters
    ----------
    count : int
        How many packs [-].

    Returns
    -------
    Way
        A loop over them.

    Raises
    ------
    ModuleNotFoundError
        rockphypy is not installed.

    Notes
    -----
    Source: Johnson et al. (1998) as that package has it. Its first integral has the bracket of the logarithm in the
    wrong place, so that times can be compared, and numbers not.
    """
    from rockphypy import GM

    strains = [-1e-4 * (1 + step / count) for step in range(count)]

    def theirs() -> list[object]:
        return [GM.johnson(BULK / 1e9, SHEAR / 1e9, COORDINATION, 0.36, strain, 0.5 * strain) for strain in strains]

    return Way(name="rockphypy, GM.johnson, one pack a call", elements=count, call=theirs)
