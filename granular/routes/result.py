"""What every route returns: the six numbers, how good they are, and what they cost."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from granular.routes.work import Work

COMPONENTS = ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212")
"""Order of the six components of a transversely isotropic stiffness, everywhere in this package."""

Six = tuple[float, float, float, float, float, float]


@dataclass(frozen=True, slots=True)
class RouteResult:
    """Six components by one route.

    Attributes
    ----------
    components : tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].
    relative_error : float
        Declared bound for the worst component, relative to that component [-].
    evaluations : int
        Directions in which the integrand was evaluated; 0 for a closed form.
    work : Work or None
        Operations and functions that it took; None where they are not counted.
    """

    components: Six
    relative_error: float
    evaluations: int
    work: Work | None = None


@dataclass(frozen=True, slots=True)
class Promise:
    """What a route would give.

    Attributes
    ----------
    relative_error : float
        Bound for the worst component, relative to that component [-]; infinite where none is promised.
    evaluations : int
        Directions in which the integrand would be evaluated [-].
    work : Work or None
        Operations and functions that it would take; None where they are not counted.
    error_is : str
        "bound", or "estimate" where rules over the sphere are compared; then ``evaluations`` is a prediction, too.
    """

    relative_error: float
    evaluations: int
    work: Work | None = None
    error_is: Literal["bound", "estimate"] = "bound"

    def kept(self, components: Six) -> RouteResult:
        """Put the components to it."""
        return RouteResult(components, self.relative_error, self.evaluations, self.work)
