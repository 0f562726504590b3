"""Figures of the model as its pages call them; nothing is drawn, and nothing imported, before a page asks."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import os

    from granular.figures.page import Static


def fabric_of(D33: float, Dr33: float) -> Static:
    """Draw contact normals and branch lengths by direction.

    Parameters
    ----------
    D33, Dr33 : float
        Coefficients of the contact normals and of the branch lengths [-].

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (14).
    """
    from granular.fabric import AxialFabric
    from granular.figures.fabric import fabric_figure
    from granular.figures.page import Static

    return Static(fabric_figure(AxialFabric(D33=D33, Dr33=Dr33)))


def ratios_by_fabric() -> Static:
    """Draw both stiffness ratios against the fabric, contacts of one stiffness.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (7).
    """
    from granular.figures.page import Static
    from granular.figures.ratios_by_fabric import ratios_by_fabric as draw

    return Static(draw())


def along_stress() -> Static:
    """Draw six components against the stress ratio, with slip and without.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (7) and (20)-(23).
    """
    from granular.figures.along_stress import along_stress as draw
    from granular.figures.page import Static

    return Static(draw())


def share_of_friction() -> Static:
    """Draw the shear stiffness of a contact against its share of friction.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    from granular.figures.page import Static
    from granular.figures.share_of_friction import share_of_friction as draw

    return Static(draw())


def approach_to_limits() -> Static:
    """Draw how the stiffness comes near its limits, by certified values.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: ball arithmetic.
    """
    from granular.figures.approach_to_limits import approach_to_limits as draw
    from granular.figures.page import Static

    return Static(draw())


def sizes_by_number(path: str | os.PathLike[str]) -> Static:
    """Draw a sieve curve by volume and by number of grains.

    Parameters
    ----------
    path : str or path-like
        Two columns, size and fraction finer.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (12).
    """
    from granular.figures.page import Static
    from granular.figures.sizes_by_number import sizes_by_number as draw
    from granular.gradation.curve_file import read_curve

    return Static(draw(read_curve(path)))


def pulled_along() -> Static:
    """Draw Young's modulus of the cases of Table II against the direction of the pull.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Table II.
    """
    from granular.figures.page import Static
    from granular.figures.pulled_along import pulled_along as draw

    return Static(draw())
