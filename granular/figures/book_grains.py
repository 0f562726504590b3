"""Figures of gradation and grain shape as pages of the book call them; nothing is drawn before a page asks."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from granular.figures.page import Static


def figure_3() -> Static:
    """Figure 3: six gradation curves, per cent finer against the grain diameter.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 3.
    """
    from granular.figures.page import Static
    from granular.figures.paper_figures_3_4 import figure_3 as draw

    return Static(draw())


def figure_4() -> Static:
    """Figure 4: densities of radii, of all branches, and of branches along a direction.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 4.
    """
    from granular.figures.page import Static
    from granular.figures.paper_figures_3_4 import figure_4 as draw

    return Static(draw())


def number_by_reading() -> Static:
    """Draw the number by which gradation enters the stiffness against the spread, for every reading.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (11), (12), (16), (17), (19).
    """
    from granular.figures.gradation_numbers import number_by_reading as draw
    from granular.figures.page import Static

    return Static(draw())


def number_by_cut() -> Static:
    """Draw how that number builds up with the range of sizes.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (11), (12), (16), (17) with r_m and r_M.
    """
    from granular.figures.gradation_numbers import number_by_cut as draw
    from granular.figures.page import Static

    return Static(draw())


def lengths_by_reading() -> Static:
    """Compare the lognormal density of eq. (19) with eq. (17).

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (16), (17), (19).
    """
    from granular.figures.fitted_densities import lengths_by_reading as draw
    from granular.figures.page import Static

    return Static(draw())


def branch_surfaces() -> Static:
    """Draw the weights of Figure 5 beside the true branches of spheroids.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 5, and the branch vector of spheroids.
    """
    from granular.figures.page import Static
    from granular.figures.spheroid_surfaces import branch_surfaces as draw

    return Static(draw())


def touching_spheroids() -> Static:
    """Draw two spheroids in contact, and the angle between branch and normal.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: the branch vector of spheroids.
    """
    from granular.figures.page import Static
    from granular.figures.spheroid_contact import touching_spheroids as draw

    return Static(draw())


def collinear_anisotropy() -> Static:
    """Draw the anisotropy of spheroids against their aspect ratio, true and with branches along the normals.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (6) and (7).
    """
    from granular.figures.collinear_curves import collinear_anisotropy as draw
    from granular.figures.page import Static

    return Static(draw())


def collinear_errors() -> Static:
    """Draw the error of the collinear assumption against the aspect ratio.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (6) and (7).
    """
    from granular.figures.collinear_curves import collinear_errors as draw
    from granular.figures.page import Static

    return Static(draw())


def spin_and_shear() -> Static:
    """Draw the shear anisotropy of spheroids with and without spin, and by the static hypothesis.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (6) and Figure 1(b).
    """
    from granular.figures.collinear_curves import spin_and_shear as draw
    from granular.figures.page import Static

    return Static(draw())
