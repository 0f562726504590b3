"""The model in one picture: where contacts point, how stiff each of them is, and how stiff the assembly is for it."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from granular.contact_distribution import normal_stiffness, shear_stiffness
from granular.directions import relative_density
from granular.engineering import normal_stiffness as confined_stiffness
from granular.figures.contacts import loading_of
from granular.figures.look import BLUE, GREEN, SOFT_INK, VERMILION, blank, house_style, readable
from granular.figures.surfaces import draw_section

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from granular.evaluation import Evaluation
    from granular.figures.surfaces import Array, Radius
    from granular.scene import Scene

ROOM = 1.28
"""Half the side of a panel over the largest radius in it [-]."""

Curve = tuple["Radius", str, str]


@house_style
def from_contacts(scene: Scene, result: Evaluation) -> Figure:
    """Draw three sections through axis 3: density of contact normals, contact stiffness, stiffness of the assembly.

    Parameters
    ----------
    scene : Scene
        An assembly that is symmetric about axis 3.
    result : Evaluation
        What it was evaluated to.

    Returns
    -------
    matplotlib.figure.Figure
        Three panels; in the first two a dotted circle is the isotropic assembly under an equal stress, in the third the
        circle has the radius of the horizontal stiffness.

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.

    Notes
    -----
    Source: eqs (7), (14), (20), (21) and (23).
    """
    import numpy as np

    stiffness, contacts = result.stiffness, (scene.fabric, loading_of(scene))

    def of_contact(modulus: Radius) -> Radius:
        return lambda cosine: modulus(np.minimum(np.abs(cosine), 1.0))

    def confined(cosine: Array) -> Array:
        angles = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
        return np.array([confined_stiffness(stiffness, degrees=float(angle)) for angle in angles]) / 1e6

    pressed = of_contact(partial(normal_stiffness, *contacts))
    sheared = of_contact(partial(shear_stiffness, *contacts, poisson_ratio=scene.grains.poisson_ratio))
    figure = blank(height=2.45)
    panels = figure.subplots(1, 3)
    _draw(panels[0], "Where contacts\npoint", 1.0, (partial(relative_density, scene.fabric), GREEN, "-"))
    _draw(panels[1], "How stiff\neach contact is", 1.0, (pressed, BLUE, "-"), (sheared, VERMILION, "--"))
    _draw(panels[2], "How stiff\nthe assembly is", stiffness.C1111 / 1e6, (confined, BLUE, "-"))
    for place, text, colour, anchor in ((0.0, "pressed", BLUE, "left"), (1.0, "sheared", VERMILION, "right")):
        panels[1].text(place, 0.0, text, color=readable(colour), transform=panels[1].transAxes, ha=anchor, va="bottom")
    panels[2].text(0.5, 0.0, f"{stiffness.C3333 / 1e6:.0f} up, {stiffness.C1111 / 1e6:.0f} MPa across", ha="center",
                   va="bottom", color=readable(BLUE), transform=panels[2].transAxes)
    return figure


def _draw(axes: Axes, title: str, circle: float, *curves: Curve) -> None:
    """One section: its curves and its circle, without scales, since only the shape is to be seen."""
    import numpy as np

    reach = circle
    for radius, colour, line in curves:
        x, y = draw_section(axes, radius, colour, line=line)
        reach = max(reach, float(np.hypot(x, y).max()))
    angle = np.linspace(0, 2 * np.pi, 181)
    axes.plot(circle * np.cos(angle), circle * np.sin(angle), color=SOFT_INK, linestyle=":", linewidth=1.1)
    room = (-ROOM * reach, ROOM * reach)
    axes.set(aspect="equal", xlim=room, ylim=room, xticks=[], yticks=[])
    axes.set_title(title)
    for side in axes.spines.values():
        side.set_visible(False)
    arm = (-1.1 * reach, 1.1 * reach)
    for across, upward in ((arm, (0.0, 0.0)), ((0.0, 0.0), arm)):
        axes.plot(across, upward, color=SOFT_INK, linewidth=0.5, zorder=0)
