"""The two measures of anisotropy, exactly where they are rational."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from granular.elasticity import Stiffness
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes.exact import rational_components
from granular.routes.result import COMPONENTS

PAIRS = (("C1111", "C3333"), ("C2323", "C1212"))
"""Horizontal over vertical compression, vertical over horizontal shear: the paper's C11/C33 and C66/C44."""


@dataclass(frozen=True, slots=True)
class Ratio:
    """A ratio of two components.

    Attributes
    ----------
    name : str
        E.g. ``"C1111/C3333"``.
    value : float
        The ratio [-]; the double nearest to ``exact`` where that is given.
    exact : Fraction or None
        The same as a fraction, for the given decimals; None where it is not rational.
    """

    name: str
    value: float
    exact: Fraction | None


def ratios(stiffness: Stiffness, *, fabric: AxialFabric, poisson_ratio: float,
           hypothesis: Hypothesis, equal_contacts: bool = True) -> tuple[Ratio, ...]:
    """C1111/C3333 and C2323/C1212 of an evaluated scene.

    With contacts of one stiffness and the kinematic hypothesis the components are rational in D33, D3333, Dr33 and
    nu. Those are read as the decimals that were given, 0.3 as 3/10, so that the ratio is the exact answer to the
    question on paper.

    Parameters
    ----------
    stiffness : Stiffness
        The evaluated stiffness [Pa].
    fabric : AxialFabric
        The fabric that was simulated [-].
    poisson_ratio : float
        Poisson ratio of the solid [-].
    hypothesis : Hypothesis
        Kinematic or static.
    equal_contacts : bool
        Whether all contacts are equally stiff; otherwise the ratios are not rational.

    Returns
    -------
    tuple of Ratio
        The two ratios.

    Notes
    -----
    Accuracy: exact and rounded once where rational; elsewhere twice the stiffness' own bound.
    Source: eqs (4) and (7), and the paper's Tables II-V.

    Examples
    --------
    >>> one = Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0)
    >>> pair = ratios(one, fabric=AxialFabric(Dr33=-0.3), poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
    >>> str(pair[0].exact)
    '678697/466603'
    """
    if hypothesis is not Hypothesis.KINEMATIC or not (equal_contacts and fabric.collinear):
        six = stiffness.components
        return tuple(Ratio(f"{over}/{under}", six[over] / six[under], None) for over, under in PAIRS)
    exact = dict(zip(COMPONENTS, rational_components(fabric, poisson_ratio=poisson_ratio), strict=True))
    quotients = {f"{over}/{under}": exact[over] / exact[under] for over, under in PAIRS}
    return tuple(Ratio(name, float(quotient), quotient) for name, quotient in quotients.items())
