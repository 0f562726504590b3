"""A function of direction as a surface: its distance from the centre is its value; static and to be turned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.look import INK, MAP

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Radius = Callable[[Array], Array]

TO_TURN = (45, 61)
"""Points from pole to pole and once around in an interactive figure: smooth to the eye, some 70 kB a surface."""

IN_PRINT = (109, 61)
"""The same in a static figure, where no interpolation hides the faces."""


@dataclass(frozen=True, slots=True)
class Surface:
    """Points of an axially symmetric surface about axis 3.

    Attributes
    ----------
    x, y, z : (parallels, meridians) array
        Coordinates along axes 1, 2, 3 [unit of the radius].
    radius : (parallels, meridians) array
        Distance from the centre.
    """

    x: Array
    y: Array
    z: Array
    radius: Array


def surface(radius: Radius, points: tuple[int, int]) -> Surface:
    """Points of the surface of a function of the cosine of the angle from axis 3.

    Parameters
    ----------
    radius : callable
        Takes an array of cosines [-], gives an array of distances [any unit].
    points : tuple of 2 int
        ``TO_TURN`` or ``IN_PRINT`` [-].

    Returns
    -------
    Surface
        Rounded to four decimals, so that a page that holds it stays small.

    Notes
    -----
    Source: spherical coordinates.
    """
    import numpy as np

    beta = np.linspace(0.0, np.pi, points[0])[:, None]
    around = np.linspace(0.0, 2 * np.pi, points[1])[None, :]
    distance = radius(np.cos(beta)) + 0 * around
    x = distance * np.sin(beta) * np.cos(around)
    y = distance * np.sin(beta) * np.sin(around)
    z = distance * np.cos(beta)
    return Surface(*(np.round(array, 4) + 0.0 for array in (x, y, z, distance)))


def draw_surface(axes: Any, shown: Surface, *, reach: float, low: float, high: float,
                 zoom: float = 1.45) -> ScalarMappable:
    """Draw a surface with its three axes, equal scales, coloured by distance and shaded from above.

    Parameters
    ----------
    axes : Axes3D
        Empty.
    shown : Surface
        What to draw.
    reach : float
        Half the side of the cube that is shown [unit of the radius].
    low, high : float
        Ends of the colour scale [unit of the radius].
    zoom : float
        How much of the panel the cube fills [-].

    Returns
    -------
    ScalarMappable
        For a colour bar.

    Notes
    -----
    Source: distance as value, as in Figure 5.
    """
    import matplotlib as mpl
    import numpy as np
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    colours = ScalarMappable(Normalize(low, high), mpl.colormaps[MAP])
    faces = colours.to_rgba((shown.radius[:-1, :-1] + shown.radius[1:, 1:]) / 2)
    draw_faces(axes, shown, np.asarray(faces), reach=reach, zoom=zoom)
    return colours


def draw_faces(axes: Any, shown: Surface, faces: Array, *, reach: float, zoom: float = 1.45) -> None:
    """Draw a surface in given colours with its three axes and equal scales, shaded from above.

    Parameters
    ----------
    axes : Axes3D
        Empty.
    shown : Surface
        What to draw.
    faces : (parallels - 1, meridians - 1, 4) array
        Red, green, blue and opacity of each face, 0 to 1 [-].
    reach : float
        Half the side of the cube that is shown [unit of the radius].
    zoom : float
        How much of the panel the cube fills [-].

    Notes
    -----
    Source: the look of this package.
    """
    import numpy as np
    from matplotlib.colors import LightSource

    shaded = _shaded(shown, faces, LightSource(azdeg=20, altdeg=50))
    axes.plot_surface(shown.x, shown.y, shown.z, facecolors=shaded, rstride=1, cstride=1, linewidth=0,
                      antialiased=False, shade=False, rasterized=True)
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), zlim=(-reach, reach))
    axes.set_box_aspect((1, 1, 1), zoom=zoom)
    axes.set_proj_type("ortho")
    axes.view_init(elev=24, azim=45)  # axes 1 and 2 both come towards the reader
    axes.set_axis_off()
    for axis, skin in enumerate(float(points.max()) for points in (shown.x, shown.y, shown.z)):
        direction = np.eye(3)[axis]
        start, end, beyond = (direction * (skin + more * reach) for more in (0.0, 0.36, 0.47))
        axes.plot(*zip(start, end, strict=True), color=INK, linewidth=0.9, zorder=10)
        axes.text(*beyond, str(axis + 1), ha="center", va="center", color=INK, zorder=10)


def plotly_surface(shown: Surface, *, low: float, high: float, name: str, **more: Any) -> Any:
    """Make a surface for plotly.

    Parameters
    ----------
    shown : Surface
        What to draw.
    low, high : float
        Ends of the colour scale [unit of the radius].
    name : str
        What the pointer says.
    **more
        Anything else that plotly's surface takes.

    Returns
    -------
    plotly.graph_objects.Surface
        Single precision: four decimals are all that is shown.

    Notes
    -----
    Source: distance as value, as in Figure 5.
    """
    import numpy as np
    from plotly import graph_objects

    x, y, z, radius = (array.astype(np.float32) for array in (shown.x, shown.y, shown.z, shown.radius))
    return graph_objects.Surface(
        x=x, y=y, z=z, surfacecolor=radius, cmin=low, cmax=high, colorscale="Viridis", name=name,
        customdata=at_pointer(shown.radius).astype(np.float32),
        hovertemplate=f"{name} = %{{customdata:.3f}}<extra></extra>",
        lighting={"ambient": 0.8, "diffuse": 0.35, "specular": 0.02},
        lightposition={"x": 1500, "y": 700, "z": 1500}, **more)


def at_pointer(values: Array) -> Array:
    """Arrange values for the pointer, as ``customdata`` of a surface.

    Parameters
    ----------
    values : (parallels, meridians, ...) array
        One entry for each point of the surface [any unit].

    Returns
    -------
    (meridians, parallels, ...) array
        The same entries [same unit]: plotly looks up what the pointer shows by column and row, not by row and column.

    Notes
    -----
    Source: what a browser shows; anything else would name the value of another point.
    """
    import numpy as np

    return np.ascontiguousarray(np.swapaxes(values, 0, 1))


def plotly_bar(title: str, **more: Any) -> dict[str, Any]:
    """Settings of a colour bar under the scene, where a narrow page has room for it.

    Parameters
    ----------
    title : str
        What the colours mean, with its unit.
    **more
        Anything else that plotly's colour bar takes.

    Returns
    -------
    dict
        For ``colorbar`` of a surface.

    Notes
    -----
    Source: the look of this package.
    """
    return {"title": {"text": title, "side": "top"}, "orientation": "h", "thickness": 10, "len": 0.7,
            "x": 0.5, "xanchor": "center", "y": 0.0, "yanchor": "bottom", "nticks": 6, **more}


def plotly_axes(reach: float) -> list[Any]:
    """Make the three axes as lines with their names; plotly's own would be cut on a narrow page.

    Parameters
    ----------
    reach : float
        Length of each [unit of the radius].

    Returns
    -------
    list of plotly.graph_objects.Scatter3d
        Three traces.

    Notes
    -----
    Source: the look of this package.
    """
    from plotly import graph_objects

    return [graph_objects.Scatter3d(
        **{name: [0, reach if name == along else 0] for name in "xyz"}, mode="lines+text", text=["", label],
        textposition="top center", textfont={"size": 15, "color": INK}, line={"color": INK, "width": 3},
        hoverinfo="skip", showlegend=False) for along, label in zip("xyz", ("1", "2", "3"), strict=True)]


def plotly_space(reach: float) -> dict[str, Any]:
    """Settings of a three-dimensional plotly scene: equal scales, and no box around it.

    Parameters
    ----------
    reach : float
        Half the side of the cube that is shown [unit of the radius].

    Returns
    -------
    dict
        For ``layout.scene``.

    Notes
    -----
    Source: the look of this package.
    """
    axis = {"range": [-reach, reach], "visible": False}
    return {"xaxis": axis, "yaxis": axis, "zaxis": axis, "aspectmode": "cube", "domain": {"y": [0.14, 0.97]},
            "camera": {"center": {"z": 0.06}, "eye": {"x": 1.05, "y": 1.05, "z": 0.65}}}


def draw_section(axes: Axes, radius: Radius, colour: str, *, line: str = "-") -> tuple[Array, Array]:
    """Draw the cut of a surface with a plane that holds axis 3.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    radius : callable
        Takes an array of cosines [-], gives an array of distances [any unit].
    colour : str
        Of the curve.
    line : str
        matplotlib's line style; curves that may coincide need different ones.

    Returns
    -------
    x, y : (361,) array
        The curve: horizontal and along axis 3 [unit of the radius].

    Notes
    -----
    Source: spherical coordinates.
    """
    import numpy as np

    angle = np.linspace(0.0, 2 * np.pi, 361)
    distance = radius(np.cos(angle))
    x, y = distance * np.sin(angle), distance * np.cos(angle)
    axes.plot(x, y, color=colour, linestyle=line)
    return x, y


def frame_section(axes: Axes, side: float, *, across: str, upward: str, ticks: int = 7) -> None:
    """Give a section equal scales, and ticks that count outwards from the centre.

    Parameters
    ----------
    axes : Axes
        Holds a section.
    side : float
        Half the side of what is shown [unit of the radius].
    across, upward : str
        What the two axes are, with the unit.
    ticks : int
        At most as many along each axis [-].

    Notes
    -----
    Source: the look of this package.
    """
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    axes.set(aspect="equal", xlim=(-side, side), ylim=(-side, side), xlabel=across, ylabel=upward)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(ticks, symmetric=True))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{abs(value):g}"))


def _shaded(shown: Surface, faces: Array, light: Any) -> Array:
    """Face colours under a light, from the normals of the faces."""
    import numpy as np

    points = np.stack([shown.x, shown.y, shown.z], axis=-1)
    diagonal = points[1:, 1:] - points[:-1, :-1]
    other = points[1:, :-1] - points[:-1, 1:]
    normals = np.cross(other, diagonal)
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    normals = normals / np.where(length > 0, length, 1)
    centre = (points[1:, 1:] + points[:-1, :-1]) / 2
    outward = np.sign((normals * centre).sum(axis=-1, keepdims=True))
    brightness = (normals * outward * light.direction).sum(axis=-1)
    shade = 0.72 + 0.28 * np.clip((brightness + 0.4) / 1.4, 0, 1)
    colours: Array = np.concatenate([faces[..., :3] * shade[..., None], faces[..., 3:]], axis=-1)
    return colours
