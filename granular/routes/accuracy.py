"""What a route promises against what is wanted: one refusal, worded the same way by every route."""

from __future__ import annotations

from granular.errors import RouteOutOfDomain

RANK_FOUR_FACTOR = 4.5
"""With D3333 the middle coefficient of the density may be negative. The terms that then cancel are at most 4.45 times
the sum: that is the largest ratio over all densities with a double zero and all |v| <= 1/2 (at e0/e2 = 0.63, v = 0)."""

HALF_ULP = 2.0**-53
"""Largest relative error of rounding an exact value to the nearest binary64 number [-]."""


def require_accuracy(route: str, declared: float, rtol: float | None) -> None:
    """Refuse a wanted accuracy that a route does not keep.

    Parameters
    ----------
    route : str
        Name of the route, as ``--route`` takes it.
    declared : float
        What the route declares for its worst component, relative to that component [-], >= 0.
    rtol : float or None
        What is wanted, in the same sense [-], > 0; None when the declared accuracy is good enough.

    Returns
    -------
    None

    Raises
    ------
    RouteOutOfDomain
        ``rtol`` is not a positive number, or is below ``declared``.

    Notes
    -----
    A declared error is a bound, so that equality is accepted.

    Examples
    --------
    >>> require_accuracy("axial", 1e-15, 1e-12)
    >>> require_accuracy("axial", 1e-15, 1e-16)  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
    granular.errors.RouteOutOfDomain: rtol = 1e-16 by the route axial
    """
    if rtol is None:
        return
    if not rtol > 0:
        raise RouteOutOfDomain(f"rtol = {rtol!r}", allowed="allowed rtol > 0",
                               remedy="Give the relative accuracy wanted of every component, such as 1e-12.")
    if rtol < declared:
        raise RouteOutOfDomain(f"rtol = {rtol!r} by the route {route}",
                               allowed=f"allowed rtol >= {declared:.2g} for this fabric",
                               remedy="Ask for less, or leave the route to the plan.")
