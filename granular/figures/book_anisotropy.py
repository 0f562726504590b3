"""Maps of anisotropy as pages of the book call them; nothing is drawn, and nothing imported, before a page asks."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from granular.figures.anisotropy_maps import Place
    from granular.figures.page import Interactive, Static
    from granular.figures.ternary import Fabric3


def constant_maps(places: Sequence[Place] = ()) -> Static:
    """Six measures of anisotropy over the fabric, for contacts of one stiffness.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (4).
    """
    from granular.figures.anisotropy_maps import constant_maps as draw
    from granular.figures.page import Static

    return Static(draw(places))


def stress_maps(places: Sequence[Place] = ()) -> Static:
    """Both ratios of the paper over the fabric under three stress ratios.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (4) and (20) to (23).
    """
    from granular.figures.anisotropy_maps import stress_maps as draw
    from granular.figures.page import Static

    return Static(draw(places))


def isotropic_lines() -> Static:
    """Where each of the two ratios is one, with equal contacts and under three stress ratios.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (4) and (20) to (23).
    """
    from granular.figures.isotropic_lines import isotropic_lines as draw
    from granular.figures.page import Static

    return Static(draw())


def anisotropy_interactive(places: Sequence[Place] = ()) -> Interactive:
    """Make the map with values under the pointer and a slider over the stress ratio.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    Interactive
        Shows itself in a page that has loaded plotly.js.

    Notes
    -----
    Source: eqs (4) and (20) to (23).
    """
    from granular.figures.anisotropy_interactive import anisotropy_interactive as make
    from granular.figures.page import Interactive

    return Interactive(make(places), "anisotropy")


def fabric_triangle(marked: Sequence[Fabric3] = ()) -> Static:
    """Draw the triangle of fabrics with lines of equal anisotropy.

    Parameters
    ----------
    marked : sequence of Fabric3
        Fabrics to mark.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eq. (4) with contacts of one stiffness.
    """
    from granular.figures.page import Static
    from granular.figures.ternary import fabric_triangle as draw

    return Static(draw(marked))
