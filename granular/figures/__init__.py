"""Figures of scenes as files, and the figures of the book; nothing is drawn, and nothing imported, before it is asked.

Scene figures are named by ``what``, as in ``granular plot``; ``save`` writes one. The functions without arguments
make what a page of the book shows.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from granular.errors import FigureNotKnown
from granular.figures.book import (
    admissible_region,
    coordinates,
    figure_5,
    figure_5_interactive,
    figure_6,
    figure_7,
    figure_8,
    figure_9,
    hard_cases,
    hypotheses,
    mohr,
    mohr_interactive,
    over_the_sphere,
    rule_convergence,
    slip_onset,
    table_ii_waves,
)
from granular.figures.book_grains import (
    branch_surfaces,
    collinear_anisotropy,
    collinear_errors,
    figure_3,
    figure_4,
    lengths_by_reading,
    number_by_cut,
    number_by_reading,
    spin_and_shear,
    touching_spheroids,
)
from granular.figures.scene_figure import SceneFigure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.scene import Scene

__all__ = [
    "SCENE_FIGURES",
    "SceneFigure",
    "admissible_region",
    "branch_surfaces",
    "collinear_anisotropy",
    "collinear_errors",
    "coordinates",
    "figure_3",
    "figure_4",
    "figure_5",
    "figure_5_interactive",
    "figure_6",
    "figure_7",
    "figure_8",
    "figure_9",
    "hard_cases",
    "hypotheses",
    "lengths_by_reading",
    "mohr",
    "mohr_interactive",
    "number_by_cut",
    "number_by_reading",
    "over_the_sphere",
    "rule_convergence",
    "save",
    "slip_onset",
    "spin_and_shear",
    "table_ii_waves",
    "touching_spheroids",
]


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
    from granular.figures.waves import required_density

    required_density(scene.grains.density)
    return evaluate(scene).waves


def _forces(scene: Scene) -> Figure:
    from granular.figures.contacts import contacts_of, forces_figure

    return forces_figure(contacts_of(scene))


def _forces_interactive(scene: Scene) -> Any:
    from granular.figures.contacts import loading_of
    from granular.figures.contacts_interactive import forces_interactive

    return forces_interactive(scene.fabric, loading_of(scene), poisson_ratio=scene.grains.poisson_ratio)


def _contacts(scene: Scene) -> Figure:
    from granular.figures.contacts import contacts_figure, contacts_of

    return contacts_figure(contacts_of(scene), poisson_ratio=scene.grains.poisson_ratio)


def _contacts_interactive(scene: Scene) -> Any:
    from granular.figures.contacts import loading_of
    from granular.figures.contacts_interactive import contacts_interactive

    return contacts_interactive(scene.fabric, loading_of(scene), poisson_ratio=scene.grains.poisson_ratio)


SCENE_FIGURES: dict[str, SceneFigure] = {
    "fabric": SceneFigure("density of contact normals and branch length by direction", _fabric,
                          _fabric_interactive),
    "stiffness": SceneFigure("Young's modulus and normal stiffness by direction", _stiffness,
                             _stiffness_interactive),
    "waves": SceneFigure("phase speeds of P, SV and SH against the angle from axis 3", _waves,
                         _waves_interactive),
    "forces": SceneFigure("normal and shear force of the contacts against the angle from axis 3", _forces,
                          _forces_interactive),
    "contacts": SceneFigure("normal and shear stiffness of the contacts against the angle from axis 3", _contacts,
                            _contacts_interactive),
}
"""Figures by name, of scenes that are symmetric about axis 3; ``granular.figures.without_axis`` has those of others."""


def save(scene: Scene, *, what: str, out: str | os.PathLike[str]) -> Path:
    """Draw a figure of a scene into a file.

    Parameters
    ----------
    scene : Scene
        The assembly and the stress on it.
    what : str
        "fabric", "stiffness", "waves", "forces" or "contacts".
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
    MissingKey
        "waves" of a scene without a density of the grains.

    Notes
    -----
    Accuracy: curves and surfaces are drawn from the values of ``granular.evaluate``; forces and stiffnesses of the
    contacts, whatever effects the scene asks for, from those of ``granular.contact_distribution``. A scene that is not
    symmetric about axis 3 is drawn over the sphere, in the frame of its tensors.
    Source: the interface of ``granular plot``.
    """
    from granular.figures import files

    path = files.target(out)
    figure = _scene_figure(scene, what)
    if path.suffix.lower() == files.INTERACTIVE_SUFFIX:
        files.write(path, lambda: files.whole_page(figure.interactive(scene), what, figure.title))
    else:
        files.write(path, lambda: files.static_bytes(figure.static(scene), path.suffix.lower().removeprefix(".")))
    return path


def _scene_figure(scene: Scene, what: str) -> SceneFigure:
    if what not in SCENE_FIGURES:
        raise FigureNotKnown(f"what = {what!r}", allowed=f"allowed: {', '.join(SCENE_FIGURES)}",
                             remedy="Name one of these figures.")
    if scene.axial:
        return SCENE_FIGURES[what]
    from granular.figures.without_axis import FIGURES

    return FIGURES[what]
