"""``sensitivity``: how much each component of one scene changes with each number of the scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.elasticity import Stiffness
from granular.routes.result import Six

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.derivatives.state import AxialState
    from granular.scene import Scene

CORNER = ("all contacts carry the same force: with friction the stiffness has a corner here, and this is the mean of "
          "the two one-sided slopes")
"""What is said of slopes by D33 and stress ratio where they have a jump."""


@dataclass(frozen=True, slots=True)
class Slope:
    """Slope of the six components by one number of a scene.

    Attributes
    ----------
    name : str
        The number, as the scene file calls it.
    value : float
        What it is in the scene [``unit``].
    unit : str
        Its SI unit, "-" for a pure number.
    slopes : tuple of 6 float
        dC/dx of each component [Pa per unit].
    note : str
        What is held fixed, or has to be known; empty where nothing has.
    """

    name: str
    value: float
    unit: str
    slopes: Six
    note: str = ""


@dataclass(frozen=True, slots=True)
class Sensitivity:
    """Stiffness of a scene and its slopes.

    Attributes
    ----------
    stiffness : Stiffness
        Six components [Pa].
    by : tuple of Slope
        One entry for each number that the stiffness depends on.
    """

    stiffness: Stiffness
    by: tuple[Slope, ...]

    def __getitem__(self, name: str) -> Slope:
        """Slope by the number of that name."""
        for slope in self.by:
            if slope.name == name:
                return slope
        raise KeyError(f"no slope by {name!r}; there are {', '.join(slope.name for slope in self.by)}")

    def relative(self, name: str) -> tuple[float | None, ...]:
        """Change of each component over itself, for one unit of a number: (dC/dx)/C [per unit]; None where C = 0."""
        return tuple(slope / value if value else None
                     for slope, value in zip(self[name].slopes, self.stiffness.components.values(), strict=True))

    def logarithmic(self, name: str) -> tuple[float | None, ...]:
        """Per cent of each component for one per cent of a number: (x/C) dC/dx [-]; None where C = 0."""
        return tuple(None if share is None else share * self[name].value for share in self.relative(name))


def sensitivity(scene: Scene) -> Sensitivity:
    """Differentiate the stiffness of a scene by every number that it depends on.

    Parameters
    ----------
    scene : Scene
        Spheres with fabric and branches of rank two about axis 3, under compression.

    Returns
    -------
    Sensitivity
        Components [Pa] and slopes [Pa per unit], by D33, Dr33, stress ratio (at fixed mean stress), friction
        coefficient, Poisson's ratio, void ratio, coordination number, mean stress, shear modulus and length ratio.

    Raises
    ------
    SlopesNotBuilt
        A shape, a rank-four density, a tension, or tensors that are not symmetric about axis 3.
    SlopeInfinite
        Contacts exactly at the onset of sliding.
    GranularError
        As ``granular.planning.plan``.

    Notes
    -----
    Where the coordination number follows from the void ratio, the slope by void ratio takes that along, and the one
    by coordination number holds the void ratio. Accuracy: as :func:`granular.axial_gradient`. Source:
    ``derivations.gradients``.

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> [round(share, 12) for share in sensitivity(scene).logarithmic("mean_stress")[:2]]
    [0.333333333333, 0.333333333333]
    """
    from granular.derivatives.axial_gradient import PARAMETERS, axial_gradient
    from granular.derivatives.state import axial_state

    state = axial_state(scene)
    value, jacobian = axial_gradient(state.D33, state.Dr33, state.stress_ratio, state.friction, state.poisson_ratio,
                                     kinetic=state.kinetic, hypothesis=state.hypothesis)
    components = state.factor * value
    by = {name: state.factor * jacobian[:, column] for column, name in enumerate(PARAMETERS)}
    entries = [Slope("D33", state.D33, "-", _six(by["D33"]), CORNER if state.corner else ""),
               Slope("Dr33", state.Dr33, "-", _six(by["Dr33"])),
               Slope("stress_ratio", state.stress_ratio, "-", _six(by["stress_ratio"]),
                     f"at fixed mean stress{'; ' + CORNER if state.corner else ''}")]
    if state.friction is not None:
        entries.append(Slope("friction_coefficient", state.friction, "-", _six(by["friction_coefficient"])))
    entries += [Slope(name, number, unit, _six(components * log + (by.get(name, 0.0))), note)
                for name, number, unit, log, note in _scale(scene, state)]
    return Sensitivity(Stiffness.transversely_isotropic(*components.tolist()), tuple(entries))


def _scale(scene: Scene, state: AxialState) -> list[tuple[str, float, str, float, str]]:
    """Numbers that set the scale: name, value, unit, slope of its logarithm, note."""
    from granular.generated.gradients import reference_slopes

    packing, grains = scene.packing, scene.grains
    follows = packing.coordination_number is None
    by_e, by_n, by_nu = reference_slopes(packing.void_ratio, packing.coordination, state.poisson_ratio,
                                         -1 / packing.relation.slope if follows else 0.0)
    line = f"with N = ({packing.relation.intercept!r} - e)/{packing.relation.slope!r}" if follows else "at fixed N"
    stress = scene.stress.mean_stress
    return [("poisson_ratio", state.poisson_ratio, "-", by_nu, ""),
            ("void_ratio", packing.void_ratio, "-", by_e, line),
            ("coordination_number", packing.coordination, "-", by_n, "at fixed void ratio"),
            ("mean_stress", stress, "Pa", 1 / (3 * stress), "at fixed stress ratio"),
            ("shear_modulus", grains.shear_modulus, "Pa", 2 / (3 * grains.shear_modulus), ""),
            ("length_ratio", scene.length_ratio, "-", 2 / scene.length_ratio, "")]


def _six(values: NDArray[np.float64]) -> Six:
    c1111, c3333, c1122, c1133, c2323, c1212 = values.tolist()
    return c1111, c3333, c1122, c1133, c2323, c1212
