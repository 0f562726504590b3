"""Figures of scenes as files, and the figures of the book; nothing is drawn, and nothing imported, before it is asked.

Scene figures are named by ``what``, as in ``granular plot``; ``save`` writes one. The functions without arguments
make what a page of the book shows.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from granular.errors import EffectNotBuilt, FigureNotKnown, MissingKey

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.figures.page import Interactive, Static
    from granular.scene import Scene


@dataclass(frozen=True, slots=True)
class SceneFigure:
    """One figure that any scene has.

    Attributes
    ----------
    title : str
        What it shows, one line.
    static : callable
        Takes a scene, gives a matplotlib figure.
    interactive : callable
        Takes a scene, gives a plotly figure.
    """

    title: str
    static: Callable[[Scene], Figure]
    interactive: Callable[[Scene], Any]


def _fabric(scene: Scene) -> Figure:
    from granular.figures.fabric import fabric_figure

    return fabric_figure(scene.fabric)


def _fabric_interactive(scene: Scene) -> Any:
    from granular.figures.fabric import fabric_interactive

    return fabric_interactive(scene.fabric)


def _stiffness(scene: Scene) -> Figure:
    from granular.evaluation import evaluate
    from granular.figures.stiffness import stiffness_figure

    return stiffness_figure(evaluate(scene).stiffness)


def _stiffness_interactive(scene: Scene) -> Any:
    from granular.evaluation import evaluate
    from granular.figures.stiffness import stiffness_interactive

    return stiffness_interactive(evaluate(scene).stiffness)


def _waves(scene: Scene) -> Figure:
    from granular.figures.waves import waves_figure

    return waves_figure(_wave_speeds(scene))


def _waves_interactive(scene: Scene) -> Any:
    from granular.figures.waves import waves_interactive

    return waves_interactive(_wave_speeds(scene))


def _wave_speeds(scene: Scene) -> Any:
    from granular.evaluation import evaluate

    speeds = evaluate(scene).waves
    if speeds is None:
        raise MissingKey("grains.density is missing", allowed="needed: a density, for wave speeds",
                         remedy='Give it, for example density = "2650 kg/m^3", or draw another figure.')
    return speeds


SCENE_FIGURES: dict[str, SceneFigure] = {
    "fabric": SceneFigure("density of contact normals and branch length by direction", _fabric,
                          _fabric_interactive),
    "stiffness": SceneFigure("Young's modulus and normal stiffness by direction", _stiffness,
                             _stiffness_interactive),
    "waves": SceneFigure("phase speeds of P, SV and SH against the angle from axis 3", _waves,
                         _waves_interactive),
}
"""Figures of this version by name."""

NEED_FORCES = ("forces", "contacts")
"""Figures of what contacts carry; there is nothing to draw while all carry the same."""

WHAT = (*SCENE_FIGURES, *NEED_FORCES)
"""Every name that ``what`` may have."""


def save(scene: Scene, *, what: str, out: str | os.PathLike[str]) -> Path:
    """Draw a figure of a scene into a file.

    Parameters
    ----------
    scene : Scene
        The assembly and the stress on it.
    what : str
        "fabric", "stiffness" or "waves"; "forces" and "contacts" are refused until contact forces are built.
    out : str or path-like
        The file; its suffix says the format: .svg, .png, .pdf, or .html to turn and read offline. A file of that
        name is replaced when the new one is complete, and untouched otherwise.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FigureNotKnown
        Another name or suffix.
    FigureNotWritten
        No such folder, or no permission to write there.
    EffectNotBuilt
        "forces" or "contacts".
    MissingKey
        "waves" of a scene without a density of the grains.

    Notes
    -----
    Accuracy: curves and surfaces are drawn from the values of ``granular.evaluate``.
    Source: the interface of ``granular plot``.
    """
    from granular.figures import files

    path = files.target(out)
    figure = _scene_figure(what)
    if path.suffix.lower() == files.INTERACTIVE_SUFFIX:
        files.write(path, lambda: files.whole_page(figure.interactive(scene), what, figure.title))
    else:
        files.write(path, lambda: files.static_bytes(figure.static(scene), path.suffix.lower().removeprefix(".")))
    return path


def _scene_figure(what: str) -> SceneFigure:
    if what in NEED_FORCES:
        raise EffectNotBuilt(
            f"what = {what!r}",
            allowed="with constant contact stiffness every contact carries the same, so that there is nothing to "
            "draw, and the effect kinetic is not built yet",
            remedy=f"Draw one of {', '.join(SCENE_FIGURES)}.")
    if what not in SCENE_FIGURES:
        raise FigureNotKnown(f"what = {what!r}", allowed=f"allowed: {', '.join(WHAT)}",
                             remedy="Name one of these figures.")
    return SCENE_FIGURES[what]


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
