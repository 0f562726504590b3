"""Measures of elastic anisotropy of a transversely isotropic stiffness, for whole grids of assemblies at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.errors import ArrayNotUsable
from granular.generated import engineering, waves

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Measure:
    """One number that says how far a stiffness is from isotropy, or what it is.

    Attributes
    ----------
    name : str
        Plain name, e.g. ``"C1111/C3333"``.
    symbol : str
        TeX without dollar signs.
    meaning : str
        What it compares.
    of : callable
        Takes the six components, each a float or an array of one shape; gives the measure [-].
    isotropic : float or None
        Its value in every isotropic solid [-]; None where that depends on the solid.
    """

    name: str
    symbol: str
    meaning: str
    of: Callable[[tuple[Array, ...]], Array]
    isotropic: float | None


MEASURES: dict[str, Measure] = {measure.name: measure for measure in (
    Measure("C1111/C3333", "C_{1111}/C_{3333}", "compression across over along axis 3, $(V_{Ph}/V_{Pv})^2$",
            lambda six: six[0] / six[1], 1.0),
    Measure("C2323/C1212", "C_{2323}/C_{1212}", "shear in a vertical over that in the horizontal plane, "
            "$(V_{hv}/V_{hh})^2$", lambda six: six[4] / six[5], 1.0),
    Measure("E1/E3", "E_1/E_3", "Young's modulus across over along axis 3, $E_h/E_v$",
            lambda six: _engineering(six)[0] / _engineering(six)[1], 1.0),
    Measure("nu31", r"\nu_{31}", "strain across axis 3 under stress along it, $\\nu_{vh}$",
            lambda six: _engineering(six)[4], None),
    Measure("nu12", r"\nu_{12}", "strain across axis 3 under stress across it, $\\nu_{hh}$",
            lambda six: _engineering(six)[2], None),
    Measure("epsilon", r"\epsilon", "Thomsen's parameter of compression across and along axis 3",
            lambda six: _thomsen(six)[0], 0.0),
    Measure("gamma", r"\gamma", "Thomsen's parameter of shear across and along axis 3",
            lambda six: _thomsen(six)[1], 0.0),
    Measure("delta", r"\delta", "Thomsen's parameter of compression near axis 3", lambda six: _thomsen(six)[2], 0.0),
    Measure("P anisotropy", r"V_{Ph}/V_{Pv} - 1", "how much faster P waves run across axis 3 than along it",
            lambda six: (six[0] / six[1]) ** 0.5 - 1, 0.0),
)}
"""Measures by name. Epsilon and the P anisotropy are functions of C1111/C3333 alone, gamma of C2323/C1212 alone."""


def measure(stiffness: ArrayLike, name: str) -> Array:
    """Take one measure of many stiffnesses.

    Parameters
    ----------
    stiffness : (..., 6) array
        C1111, C3333, C1122, C1133, C2323, C1212, positive definite [any one unit], as ``axial_stiffness`` gives them.
    name : str
        A key of ``MEASURES``.

    Returns
    -------
    (...) array
        The measure [-]; nan where the stiffness is.

    Raises
    ------
    ArrayNotUsable
        The last axis has not six places.

    Notes
    -----
    Accuracy: some units in the last place; Poisson's ratios and delta lose the digits that their differences cancel.
    Source: the closed forms of ``derivations.engineering`` and ``derivations.waves``.

    Examples
    --------
    >>> from granular import axial_stiffness
    >>> measure(axial_stiffness([0.0, 0.3], 0.0, kinetic=False), "C1111/C3333").round(4)
    array([1.    , 0.8348])
    """
    import numpy as np

    values = np.asarray(stiffness, dtype=np.float64)
    if values.ndim == 0 or values.shape[-1] != 6:
        raise ArrayNotUsable(f"stiffness of shape {values.shape}", allowed="needed: six components along the last axis",
                             remedy="Give what axial_stiffness returns.")
    return MEASURES[name].of(tuple(np.moveaxis(values, -1, 0)))


def _engineering(six: tuple[Array, ...]) -> tuple[Array, ...]:
    # the emitted functions are arithmetic alone, and serve arrays as they serve numbers
    evaluate: Any = engineering.engineering_constants
    constants: tuple[Array, ...] = evaluate(*six)
    return constants


def _thomsen(six: tuple[Array, ...]) -> tuple[Array, ...]:
    evaluate: Any = waves.thomsen
    parameters: tuple[Array, ...] = evaluate(six[0], six[1], six[3], six[4], six[5])
    return parameters
