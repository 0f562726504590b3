"""Scenes without an axis about axis 3: fabric, contact forces, contact stiffness and elasticity over the sphere."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.hemisphere import EQUAL, Mark, extreme_marks, principal
from granular.figures.look import BLUE, INK, SOFT_INK, VERMILION
from granular.figures.over_sphere import Map, Picture, Quantity
from granular.figures.stiffness import unit_of

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from granular.elasticity import Stiffness
    from granular.general import GeneralFabric, GeneralLoading

    Array = NDArray[np.float64]
    Values = Callable[[Array], Array]

ROUNDING = 1e-12
"""A shear force below this is drawn as none [-]; forces are of order one."""

STRESS = "principal stress"
"""What is marked where forces are shown."""


def fabric_picture(fabric: GeneralFabric) -> Picture:
    """Density of contact normals and branch length by direction.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].

    Returns
    -------
    Picture
        Principal directions of D on the one map, of Dr on the other.

    Notes
    -----
    Source: eq. (14), with tensors.
    """
    density = Quantity("density of contact normals", "$4\\pi E$", "4πE", "–", fabric.relative_density, BLUE)
    length = Quantity("branch length", "$W$", "W", "–", fabric.branch_weight, VERMILION, "--")
    meaning = "principal value of the tensor"
    return Picture((Map(density, principal(fabric.D), meaning),
                    Map(length, () if fabric.Dr is None else principal(fabric.Dr), meaning)),
                   ((_level(1.0, "isotropic"), density, length),))


def forces_picture(fabric: GeneralFabric, loading: GeneralLoading) -> Picture:
    """Forces on the contacts by direction, over that of the isotropic assembly under the same mean stress.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals [-].
    loading : GeneralLoading
        Stress and friction.

    Returns
    -------
    Picture
        Principal stresses on both maps; the friction as a further rose where there is any.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    import numpy as np

    normal, shear = _forces(fabric, loading)
    stress = principal(loading.stress)
    pressing = Quantity("normal force", "$f_n$", "f<sub>n</sub>", "–", lambda n: np.maximum(normal(n), 0.0), BLUE)
    signed = Quantity("normal force", "$f_n$", "f<sub>n</sub>", "–", normal, BLUE)
    aside = Quantity("shear force", "$f_r$", "f<sub>r</sub>", "–", shear, VERMILION, "--")
    limited: tuple[Quantity, ...] = ()
    used: tuple[Quantity, ...] = ()
    if (friction := loading.friction) is not None:
        limited = (Quantity("friction", "$\\mu f_n$", "μ f<sub>n</sub>", "–",
                            lambda n: friction * np.maximum(normal(n), 0.0), INK, ":"),)
    if friction:
        used = (Quantity("used friction", "$f_r/\\mu f_n$", "f<sub>r</sub>/μ f<sub>n</sub>", "–",
                         lambda n: shear(n) / np.maximum(friction * normal(n), shear(n) + 1e-300), INK),)
    return Picture((Map(signed, stress, STRESS), Map(aside, stress, STRESS)),
                   ((_level(1.0, "isotropic"), pressing), (aside, *limited)),
                   margin=_margin(normal, shear, friction), force=normal,
                   turned=tuple(Map(one, stress, STRESS) for one in (pressing, aside, *used)))


def contacts_picture(fabric: GeneralFabric, loading: GeneralLoading, *, poisson_ratio: float) -> Picture:
    """Stiffness of the contacts by direction, over that of the isotropic assembly under the same mean stress.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals [-].
    loading : GeneralLoading
        Stress and friction.
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    Picture
        Principal stresses on both maps; dotted what equal contacts have.

    Notes
    -----
    Source: eqs (20) and (21), corrected.
    """
    from granular.contact_law import stiffness_ratio
    from granular.general.loading import contact_stiffness

    forces = loading.force_tensor(fabric)
    normal, shear = _forces(fabric, loading)
    stress = principal(loading.stress)
    k_n = Quantity("normal stiffness of contacts", "$k_n$", "k<sub>n</sub>", "–",
                   lambda n: contact_stiffness(forces, loading.friction, n, poisson_ratio)[0], BLUE)
    k_r = Quantity("shear stiffness of contacts", "$k_r$", "k<sub>r</sub>", "–",
                   lambda n: contact_stiffness(forces, loading.friction, n, poisson_ratio)[1], VERMILION, "--")
    equal = (_level(1.0, "equal contacts"), _level(stiffness_ratio(poisson_ratio), ""))
    return Picture((Map(k_n, stress, STRESS), Map(k_r, stress, STRESS)), ((*equal, k_n, k_r),),
                   margin=_margin(normal, shear, loading.friction), force=normal)


def stiffness_picture(stiffness: Stiffness) -> Picture:
    """Young's modulus and the confined stiffness by direction.

    Parameters
    ----------
    stiffness : Stiffness
        Positive definite, of any symmetry [Pa].

    Returns
    -------
    Picture
        The stiffest and the softest direction of each.

    Notes
    -----
    Source: E(n) = 1/S_nnnn and C_nnnn.
    """
    from granular.general.engineering import along, general_engineering

    found = general_engineering(stiffness)
    scale, unit = unit_of(found.stiffest.value)
    hard, soft = stiffness.scaled(1 / scale), stiffness.scaled(1 / scale).compliance()
    young = Quantity("Young's modulus", "$E$", "E", unit, lambda n: 1 / along(soft, n), BLUE)
    confined = Quantity("confined stiffness", "$C_{nnnn}$", "C<sub>nnnn</sub>", unit, lambda n: along(hard, n),
                        VERMILION, "--")
    meaning = "value over all directions"
    return Picture((Map(young, extremes(young.values), meaning), Map(confined, extremes(confined.values), meaning)),
                   ((young, confined),))


def extremes(values: Values) -> tuple[Mark, ...]:
    """Mark where a function of direction is greatest and where it is least.

    Parameters
    ----------
    values : callable
        Takes unit vectors (3, q) [-], gives (q,) values [any unit].

    Returns
    -------
    tuple of Mark
        None where the function is the same everywhere.

    Notes
    -----
    Source: ``granular.general.extremes``.
    """
    from granular.general.extremes import greatest

    high, low = greatest(values), greatest(lambda n: -values(n))
    if high.value + low.value <= EQUAL * abs(high.value):
        return ()
    return *extreme_marks(high, "greatest"), *extreme_marks(low, "least")


def _forces(fabric: GeneralFabric, loading: GeneralLoading) -> tuple[Values, Values]:
    """Normal and shear force as functions of direction."""
    import numpy as np

    tensor = loading.force_tensor(fabric)

    def normal(n: Array) -> Array:
        pressing: Array = ((tensor @ n) * n).sum(axis=0)
        return pressing

    def shear(n: Array) -> Array:
        aside = np.linalg.norm(tensor @ n - normal(n) * n, axis=0)
        return np.where(aside < ROUNDING, 0.0, aside)

    return normal, shear


def _margin(normal: Values, shear: Values, friction: float | None) -> Values | None:
    """Friction over what is used of it, as a difference; contacts slide where it is negative."""
    if friction is None:
        return None
    return lambda n: friction * normal(n) - shear(n)


def _level(value: float, symbol: str) -> Quantity:
    """A dotted circle."""
    import numpy as np

    return Quantity(symbol, symbol, symbol, "–", lambda n: np.full(n.shape[1], value), SOFT_INK, ":")
