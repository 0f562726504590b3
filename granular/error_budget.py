"""What becomes of a wanted accuracy: shares of effects left out, of the step to pascals, of the tie of C1212."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from granular.gradation import LengthMoments

SCALING_ERROR = 1.5 * 2.0**-52
"""What the step to pascals adds [-]: a reference stiffness and a product, each rounded once, and what the coordination
number and the mean stress, which enter with the powers 2/3 and 1/3, have lost to rounding before."""

COARSE = 2.0**-44
"""A rule that knows no axis and errs by more than this may break C1212 = (C1111 - C1122)/2 visibly, and C1212 is then
set by it [-]."""

COARSE_SHARE = 0.8
"""What setting C1212 leaves of a wanted accuracy: without slip, which such rules do not serve, the bound grows by
(C1111 + C1122)/(2 C1212), at most 5/4 [-]."""


def remaining(rtol: float | None, left_out_error: float) -> float | None:
    """What is left of a wanted accuracy once effects have been left out.

    Parameters
    ----------
    rtol : float or None
        Wanted relative accuracy of every component [-].
    left_out_error : float
        Bound for the relative change by what was left out [-], below ``rtol``.

    Returns
    -------
    float or None
        Wanted relative accuracy of every component of the smaller model [-]; ``rtol`` itself where nothing was left
        out.

    Notes
    -----
    Source: (1 + left out)(1 + remaining) - 1 = rtol, rounded down.
    """
    if rtol is None or not left_out_error:
        return rtol
    return (rtol - left_out_error) / (1 + left_out_error) * (1 - 2.0**-50)


def with_left_out(relative_error: float, left_out_error: float) -> float:
    """Error of a smaller model, as an error of the whole.

    Parameters
    ----------
    relative_error : float
        Bound for the components of the model that was computed [-].
    left_out_error : float
        Bound for the relative change by what was left out [-].

    Returns
    -------
    float
        Bound for the components of the model with everything that the scene calls for [-].

    Notes
    -----
    Source: the product of two factors next to one.
    """
    if not left_out_error:
        return relative_error
    return left_out_error + relative_error + left_out_error * relative_error


def scaling_error(lengths: LengthMoments | None) -> float:
    """What the step to pascals adds to the error of a route.

    Parameters
    ----------
    lengths : LengthMoments or None
        Moments of the branch lengths of graded grains.

    Returns
    -------
    float
        Bound relative to a component [-]: ``SCALING_ERROR``, and for graded grains the errors of two moments, which
        both enter a static component, with as many roundings.

    Notes
    -----
    Source: the products in ``granular.evaluation``.
    """
    return SCALING_ERROR if lengths is None else 2 * (SCALING_ERROR + lengths.relative_error)


def route_accuracy(rtol: float | None, lengths: LengthMoments | None = None, *,
                   keeps_axis: bool = True) -> float | None:
    """What is left of a wanted accuracy for the route, before the step to pascals and the tie of C1212.

    Parameters
    ----------
    rtol : float or None
        Wanted relative accuracy of every component in pascals [-].
    lengths : LengthMoments or None
        Moments of the branch lengths of graded grains.
    keeps_axis : bool
        Whether the route needs no tie of C1212.

    Returns
    -------
    float or None
        Wanted relative accuracy of every normalised component [-].

    Notes
    -----
    Source: :func:`scaling_error` and ``COARSE_SHARE``.
    """
    if rtol is None:
        return None
    return (COARSE_SHARE * rtol if rtol > COARSE and not keeps_axis else rtol) - scaling_error(lengths)
