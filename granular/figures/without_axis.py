"""Figures of scenes that are not symmetric about axis 3: the same names, and the same quantities, over the sphere."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from granular.figures.scene_figure import SceneFigure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.figures.over_sphere import Picture
    from granular.general import GeneralWaves
    from granular.scene import Scene


def _fabric(scene: Scene) -> Picture:
    from granular.figures.general_scene import fabric_picture

    return fabric_picture(scene.general_fabric)


def _forces(scene: Scene) -> Picture:
    from granular.figures.general_scene import forces_picture

    return forces_picture(scene.general_fabric, scene.general_loading(scene.grains.friction))


def _contacts(scene: Scene) -> Picture:
    from granular.figures.general_scene import contacts_picture

    return contacts_picture(scene.general_fabric, scene.general_loading(scene.grains.friction),
                            poisson_ratio=scene.grains.poisson_ratio)


def _stiffness(scene: Scene) -> Picture:
    from granular.evaluation import evaluate
    from granular.figures.general_scene import stiffness_picture

    return stiffness_picture(evaluate(scene).stiffness)


def _waves_of(scene: Scene) -> GeneralWaves:
    from granular.evaluation import evaluate
    from granular.figures.waves import required_density
    from granular.general import general_waves

    result = evaluate(scene)
    return general_waves(result.stiffness, density=required_density(result.density))


def _waves(scene: Scene) -> Figure:
    from granular.figures.general_waves import general_waves_figure

    return general_waves_figure(_waves_of(scene))


def _waves_interactive(scene: Scene) -> Any:
    from granular.figures.general_waves import waves_picture
    from granular.figures.over_sphere_interactive import sphere_interactive

    return sphere_interactive(waves_picture(_waves_of(scene)))


def _of(picture: Callable[[Scene], Picture], title: str) -> SceneFigure:
    """Maps and roses, or surfaces to turn, of a picture."""

    def static(scene: Scene) -> Figure:
        from granular.figures.over_sphere import sphere_figure

        return sphere_figure(picture(scene))

    def interactive(scene: Scene) -> Any:
        from granular.figures.over_sphere_interactive import sphere_interactive

        return sphere_interactive(picture(scene))

    return SceneFigure(title, static, interactive)


FIGURES: dict[str, SceneFigure] = {
    "fabric": _of(_fabric, "density of contact normals and branch length over all directions"),
    "stiffness": _of(_stiffness, "Young's modulus and normal stiffness over all directions"),
    "waves": SceneFigure("phase speeds of qP, qS1 and qS2, and shear-wave splitting, over all directions", _waves,
                         _waves_interactive),
    "forces": _of(_forces, "normal and shear force of the contacts over all directions"),
    "contacts": _of(_contacts, "normal and shear stiffness of the contacts over all directions"),
}
"""Figures by name."""
