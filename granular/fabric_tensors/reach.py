"""How weak an anisotropy a list of directions can show, before any direction is measured."""

from __future__ import annotations

from granular.errors import TooFewDirections, ValueOutOfRange
from granular.fabric_tensors.tensors import LEAST_NUMBER


def least_seen(number: float, *, axis_known: bool = True, power: float = 0.9, level: float = 0.05) -> float:
    """Weakest axial anisotropy of rank two that a list of directions shows.

    Parameters
    ----------
    number : float
        Number of independent directions, or the effective one [-], 16 or more.
    axis_known : bool
        Whether the axis is known beforehand; otherwise any anisotropy of rank two is looked for.
    power : float
        Share of lists in which it shall be significant, above the level and below 1 [-].
    level : float
        Share of lists of an isotropic fabric that are called anisotropic, between 0 and 1 [-].

    Returns
    -------
    float
        Amount of D33 [-].

    Raises
    ------
    TooFewDirections
        Fewer than 16.
    ValueOutOfRange
        Power or level.

    Notes
    -----
    Accuracy: first order in D33; the scatter is taken for that of an isotropic fabric.
    Source: non-central chi-squared distribution of the test in ``uniformity``, with n D33^2/5 for its centre.

    Examples
    --------
    >>> round(least_seen(1000), 3), round(least_seen(1000, axis_known=False), 3)
    (0.229, 0.287)
    """
    from scipy.special import chdtri, chndtrinc

    if not number >= LEAST_NUMBER:
        raise TooFewDirections(f"number = {number:g}", allowed=f"needed: {LEAST_NUMBER} or more",
                               remedy="Plan for more directions.")
    if not 0 < level < power < 1:
        raise ValueOutOfRange(f"power = {power!r} with level = {level!r}", allowed="allowed 0 < level < power < 1",
                              remedy="Give shares such as 0.9 and 0.05.")
    dof = 1 if axis_known else 5
    centre = chndtrinc(float(chdtri(dof, level)), dof, 1 - power)
    return float((5 * centre / number) ** 0.5)
