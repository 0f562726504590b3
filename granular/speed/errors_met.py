"""The worst error of many elements, found on a few of them by ball arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from granular.speed.sample import FRICTION, POISSON, sample

FEW = 40
"""Elements of a sample that are held against ball arithmetic [-]: its first ones."""

Six = tuple[float, ...]


@lru_cache(maxsize=8)
def certified(what: str) -> tuple[Six, ...]:
    """Components of the first elements of the sample, every digit proved.

    Parameters
    ----------
    what : str
        As in :func:`granular.speed.comparisons.stiffness`.

    Returns
    -------
    tuple of tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: half a unit in the last place. Source: the route ``certified``.
    """
    from granular.fabric import AxialFabric
    from granular.hypothesis import Hypothesis
    from granular.loading import Loading
    from granular.routes.catalogue import ROUTES

    drawn, found = sample(FEW), []
    for place in range(FEW):
        friction = {"slip": FRICTION, "slip, any friction": float(drawn.friction[place])}.get(what)
        loading = None if what == "constant" else Loading.of_ratio(float(drawn.stress_ratio[place]), friction=friction)
        fabric = AxialFabric(D33=float(drawn.D33[place]), Dr33=float(drawn.Dr33[place]))
        found.append(ROUTES["certified"].evaluate(fabric, poisson_ratio=POISSON, hypothesis=Hypothesis.KINEMATIC,
                                                  loading=loading).components)
    return tuple(found)


def worst_error(what: str, call: Callable[[], object]) -> float:
    """Worst relative error of any component of the first elements.

    Parameters
    ----------
    what : str
        As in :func:`granular.speed.comparisons.stiffness`.
    call : callable
        Gives the components of the sample, (n, 6) [-], n at least ``FEW``.

    Returns
    -------
    float
        The error [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Source: :func:`certified`.
    """
    import numpy as np

    known = np.array(certified(what))
    found = np.asarray(call())[:FEW]
    return float(np.abs(found / known - 1).max())
