"""Figures as pages of the book call them; nothing is drawn, and nothing imported, before a page asks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from collections.abc import Sequence

    from granular.figures.hard_case_plot import Compared
    from granular.figures.page import Interactive, Static


def coordinates() -> Static:
    """Axes, angles and the local frame of a contact.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 2.
    """
    from granular.figures.axes_and_angles import coordinates as draw
    from granular.figures.page import Static

    return Static(draw(), data=False)


def figure_5() -> Static:
    """Figure 5: branch lengths and contact normals as surfaces, five panels.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 5.
    """
    from granular.figures.page import Static
    from granular.figures.paper_figure_5 import figure_5 as draw

    return Static(draw())


def figure_5_interactive() -> Interactive:
    """Figure 5 to turn, with a slider over Dr33.

    Returns
    -------
    Interactive
        Shows itself in a page that has loaded plotly.js.

    Notes
    -----
    Source: Figure 5.
    """
    from granular.figures.page import Interactive
    from granular.figures.paper_figure_5 import figure_5_interactive as make

    return Interactive(make(), "figure-5")


def figure_6() -> Static:
    """Figure 6: six stiffness components in MPa against Dr33.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 6.
    """
    from granular.figures.page import Static
    from granular.figures.paper_figure_6 import figure_6 as draw

    return Static(draw())


def admissible_region() -> Static:
    """Draw the admissible region of D33 and D3333.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: E >= 0.
    """
    from granular.figures.page import Static
    from granular.figures.region import admissible_region as draw

    return Static(draw())


def hypotheses(against: Literal["Dr33", "D33"] = "Dr33") -> Static:
    """Compare the two hypotheses along one coefficient of the fabric.

    Parameters
    ----------
    against : "Dr33" or "D33"
        Coefficient of the branch lengths or of the contact normals.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 1.
    """
    from granular.figures.page import Static
    from granular.figures.two_hypotheses import hypotheses as draw

    return Static(draw(against))


def table_ii_waves() -> Static:
    """Phase speeds for case 3 of Table II.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Table II.
    """
    from granular.figures.page import Static
    from granular.figures.waves import table_ii_waves as draw

    return Static(draw())


def over_the_sphere(path: str, what: str) -> Static:
    """A figure of a scene that is not symmetric about axis 3.

    Parameters
    ----------
    path : str
        The scene file.
    what : str
        fabric, forces, contacts, stiffness or waves.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: ``granular plot``.
    """
    from granular.figures.page import Static
    from granular.figures.without_axis import FIGURES
    from granular.scene import Scene

    return Static(FIGURES[what].static(Scene.from_toml(path)))


def figure_7() -> Static:
    """Figure 7: contact forces and stiffnesses by direction for four microstructures under isotropic stress.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 7.
    """
    return _contacts_by_direction(7)


def figure_8() -> Static:
    """Figure 8: the same for ideal assemblies with more and more vertical contacts.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 8.
    """
    return _contacts_by_direction(8)


def figure_9() -> Static:
    """Figure 9: the same for an isotropic packing under three stress ratios.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: Figure 9.
    """
    return _contacts_by_direction(9)


def _contacts_by_direction(number: Literal[7, 8, 9]) -> Static:
    from granular.figures.page import Static
    from granular.figures.paper_figure_7_9 import draw

    return Static(draw(number))


def mohr() -> Static:
    """Draw Mohr's circle of the contact forces before, at and after the onset of sliding.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    from granular.figures.mohr_circle import mohr as draw
    from granular.figures.page import Static

    return Static(draw())


def mohr_interactive() -> Interactive:
    """Make Mohr's circle with a slider over the stress ratio and buttons for the friction angle.

    Returns
    -------
    Interactive
        Shows itself in a page that has loaded plotly.js.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    from granular.figures.mohr_sliders import mohr_interactive as make
    from granular.figures.page import Interactive

    return Interactive(make(), "mohr")


def slip_onset() -> Static:
    """Draw both shear components and their slopes through the onset of sliding.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: eqs (20)-(23).
    """
    from granular.figures.page import Static
    from granular.figures.slip_stiffness import slip_onset as draw

    return Static(draw())


def rule_convergence() -> Static:
    """Draw the error of the rule for slip against the density of its nodes.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: the log-tangent rule.
    """
    from granular.figures.convergence import convergence_of_the_rule as draw
    from granular.figures.page import Static

    return Static(draw())


def hard_cases(cases: Sequence[Compared] | None = None) -> Static:
    """Compare the errors of naive formulas with those of this library.

    Parameters
    ----------
    cases : sequence of Compared, optional
        Name, label of the naive formula and both errors of each; by default the named corpus, computed anew.

    Returns
    -------
    Static
        Shows itself in a page.

    Notes
    -----
    Source: the corpus of hard cases.
    """
    from granular.figures.hard_case_plot import hard_cases as draw
    from granular.figures.page import Static

    if cases is None:
        from granular.checks.hard_cases import comparison

        cases = comparison()
    return Static(draw(cases))
