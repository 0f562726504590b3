"""``axial_stiffness``: six components for whole arrays of fabrics at once, with the manners of a NumPy ufunc."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import ArrayNotUsable, ComplianceInfinite, FabricOutOfRange, UnknownChoice, ValueOutOfRange
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

RELATIVE_ERROR = 2.0**-49
"""Declared bound of every component [-], 8 units in the last place; the worst met in the tests is about half."""

BLOCK = 8192
"""Elements evaluated at a time, so that the dozen intermediate arrays stay in cache."""

LARGEST_RATIO = 9.0
"""Branch lengths at pole and equator up to this factor apart take the emitted static moments."""


def axial_stiffness(
    D33: ArrayLike,
    Dr33: ArrayLike,
    stress_ratio: ArrayLike = 1.0,
    friction_coefficient: ArrayLike | None = None,
    poisson_ratio: ArrayLike = 0.21,
    *,
    kinetic: bool = True,
    hypothesis: Hypothesis | str = Hypothesis.KINEMATIC,
    rtol: float | None = None,
) -> NDArray[np.float64]:
    """Stiffness of axially symmetric assemblies, over (M/V) l_e^2 k_n,ref, for arrays of fabrics.

    k_n,ref is the normal contact stiffness of the isotropic assembly under the same mean stress.

    Parameters
    ----------
    D33 : float or (...) array
        P2 coefficient of the contact-normal density [-], -1 <= D33 <= 2.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2.
    stress_ratio : float or (...) array
        sigma33/sigma11 [-], > 0.
    friction_coefficient : float or (...) array, optional
        Friction between grains [-], >= 0; leave it out for contacts that never slip.
    poisson_ratio : float or (...) array
        Poisson's ratio of the grain material [-], 0 to 1/2.
    kinetic : bool
        Whether the stiffness of a contact follows the force that it carries, with partial slip and sliding where
        friction is given. False: every contact has the stiffness of the ideal assembly under the mean stress,
        whatever the stress ratio and the friction.
    hypothesis : "kinematic" or "static"
        Upper bound or lower estimate.
    rtol : float, optional
        Wanted relative accuracy of every component [-]; refused below the accuracy stated here.

    Returns
    -------
    (..., 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 [-] of each element of the broadcast arguments.

    Raises
    ------
    FabricOutOfRange
        A D33 or Dr33 outside its interval or not finite; the first such element is named.
    ValueOutOfRange
        The same for stress ratio, friction coefficient or Poisson's ratio.
    ComplianceInfinite
        The static hypothesis where contacts slide; the first such element is named.
    ArrayNotUsable
        Arguments that are not real numbers, or whose shapes do not broadcast.
    UnknownChoice
        Another hypothesis.
    RouteOutOfDomain
        ``rtol`` below the accuracy stated here.

    Notes
    -----
    Accuracy: every component to 2^-49, about 1.8e-15 of itself, unless it is below 2.3e-308.
    Cost of an element: a closed form where all contacts carry the same force. Otherwise 28 directions without friction
    (kinematic, forces at pole and equator less than a factor 12 apart), some 200 to 500 where that is not enough, and
    150 to 900 with friction, the more the nearer the onset of sliding.
    Source: eqs (4), (7), and Figure 1(b) with (20)-(23).

    Examples
    --------
    >>> axial_stiffness(0.0, [-0.3, 0.0], kinetic=False).shape
    (2, 6)
    >>> isotropic = axial_stiffness(0, 0, poisson_ratio=0)
    >>> [round(float(value), 12) for value in isotropic]
    [0.333333333333, 0.333333333333, 0.0, 0.0, 0.166666666667, 0.166666666667]
    """
    import numpy as np

    chosen = _hypothesis(hypothesis)
    require_accuracy("axial_stiffness", RELATIVE_ERROR, rtol)
    given = {"D33": _real(D33, "D33"), "Dr33": _real(Dr33, "Dr33"),
             "stress_ratio": _real(stress_ratio, "stress_ratio"),
             "poisson_ratio": _real(poisson_ratio, "poisson_ratio")}
    if friction_coefficient is not None:
        given["friction_coefficient"] = _real(friction_coefficient, "friction_coefficient")
    shape = _common_shape(given)
    _require_range(given)
    d, dr, nu, ratio = (np.broadcast_to(given[name], shape).ravel()
                        for name in ("D33", "Dr33", "poisson_ratio", "stress_ratio"))
    if not kinetic:
        return _with_equal_contacts(d, dr, nu, chosen).reshape(*shape, len(COMPONENTS))
    mu = None if friction_coefficient is None else np.broadcast_to(given["friction_coefficient"], shape).ravel()
    return _with_forces(d, dr, ratio, mu, nu, chosen).reshape(*shape, len(COMPONENTS))


def _with_equal_contacts(D33: Array, Dr33: Array, nu: Array, hypothesis: Hypothesis) -> Array:
    """Contacts that are all equally stiff."""
    import numpy as np

    kernel = _kinematic if hypothesis is Hypothesis.KINEMATIC else _static
    result = np.empty((D33.size, len(COMPONENTS)))
    for start in range(0, D33.size, BLOCK):
        here = slice(start, start + BLOCK)
        for column, values in enumerate(kernel(D33[here], Dr33[here], nu[here])):
            result[here, column] = values
    return result


def _kinematic(D33: Array, Dr33: Array, nu: Array) -> tuple[Array, ...]:
    import numpy as np

    from granular.generated.kinematic_constant_array import kinematic_constant

    return kinematic_constant(D33, np.zeros(()), Dr33, nu)


def _static(D33: Array, Dr33: Array, nu: Array) -> tuple[Array, ...]:
    """Each element by exactly one way of computing its moments: the emitted series, or the axial Gauss rule."""
    import numpy as np

    from granular.generated import static_constant_array as emitted
    from granular.routes.axial_array import static_moments

    moments = np.empty((3, *D33.shape))
    pole, equator = 2 * (1 + Dr33), 2 - Dr33
    near = (pole <= LARGEST_RATIO * equator) & (equator <= LARGEST_RATIO * pole)
    if near.any():
        moments[:, near] = emitted.static_moments(D33[near], np.zeros(()), Dr33[near])
    far = ~near
    if far.any():
        moments[:, far] = static_moments(D33[far], Dr33[far])
    return emitted.stiffness_from_moments(moments[0], moments[1], moments[2], D33, nu)


def _with_forces(D33: Array, Dr33: Array, stress_ratio: Array, friction: Array | None, nu: Array,
                 hypothesis: Hypothesis) -> Array:
    """Contacts whose stiffness follows their force."""
    import numpy as np

    from granular.routes.axial_kinetic_array import components
    from granular.routes.slip_geometry_array import equal_forces

    if hypothesis is Hypothesis.STATIC and friction is not None:
        _require_sticking(D33, stress_ratio, friction)
    alike = equal_forces(D33, stress_ratio)
    if friction is not None:
        alike &= friction > 0
    result = np.empty((D33.size, len(COMPONENTS)))
    result[alike] = _with_equal_contacts(D33[alike], Dr33[alike], nu[alike], hypothesis)
    rest = ~alike
    if rest.any():
        result[rest] = components(D33[rest], Dr33[rest], stress_ratio[rest],
                                  None if friction is None else friction[rest], nu[rest], hypothesis=hypothesis)
    return result


def _require_sticking(D33: Array, stress_ratio: Array, friction: Array) -> None:
    """Refuse the first element whose contacts slide somewhere; exact tangency is no sliding."""
    import numpy as np

    from granular.loading import Loading
    from granular.routes.slip_geometry_array import slides

    sliding = slides(D33, stress_ratio, friction)
    if sliding.any():
        first = int(np.argmax(sliding))
        try:
            Loading.of_ratio(stress_ratio[first].item(), friction=friction[first].item()).require_finite_compliance(
                D33[first].item())
        except ComplianceInfinite as refusal:
            raise ComplianceInfinite(f"{refusal.found}, element {first} of {sliding.size}", allowed=refusal.allowed,
                                     remedy='Say kinetic=False or leave friction_coefficient out there, or use '
                                     'hypothesis="kinematic".') from None


def _hypothesis(name: Hypothesis | str) -> Hypothesis:
    try:
        return Hypothesis(name)
    except ValueError:
        known = ", ".join(repr(choice.value) for choice in Hypothesis)
        raise UnknownChoice(f"hypothesis = {name!r}", allowed=f"allowed: {known}",
                            remedy="Name one of the two hypotheses.") from None


def _real(argument: ArrayLike, name: str) -> Array:
    """An array of floats, or a refusal; text, truth values and masks are not numbers here."""
    import numpy as np

    remedy = f"Give {name} as a number or an array of real numbers."
    if isinstance(argument, np.ma.MaskedArray):
        raise ArrayNotUsable(f"{name} is a masked array", allowed="needed: an array without mask",
                             remedy="Select the valid elements first, for example with .compressed().")
    try:
        array = np.asarray(argument)
    except ValueError:
        raise ArrayNotUsable(f"{name} has rows of different lengths", allowed="needed: one shape",
                             remedy=remedy) from None
    if array.dtype.kind not in "iuf":
        raise ArrayNotUsable(f"{name} holds {array.dtype.name}", allowed="needed: integers or floats",
                             remedy=remedy)
    return array.astype(np.float64)


def _common_shape(given: dict[str, Array]) -> tuple[int, ...]:
    import numpy as np

    try:
        return np.broadcast_shapes(*(array.shape for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.shape)
        raise ArrayNotUsable(f"shapes {shapes}", allowed="needed: shapes that broadcast together",
                             remedy="Insert axes of length 1, for example D33[:, None] with Dr33.") from None


def _require_range(given: dict[str, Array]) -> None:
    """Refuse the first element outside its interval; a comparison with NaN is false, so NaN is refused too."""
    import numpy as np

    def refuse(name: str, admissible: NDArray[np.bool_], kind: type[FabricOutOfRange | ValueOutOfRange],
               allowed: str) -> None:
        if admissible.all():
            return
        index = tuple(int(i) for i in np.unravel_index(int(np.argmin(admissible)), admissible.shape))
        where = f"[{', '.join(map(str, index))}]" if index else ""
        raise kind(f"{name}{where} = {given[name][index].item()!r}", allowed=f"allowed {allowed}",
                   remedy=f"Give every {name} inside the interval.")

    d, dr = given["D33"], given["Dr33"]
    refuse("D33", (d >= -1) & (d <= 2), FabricOutOfRange, "-1 <= D33 <= 2 (E(n) would be negative)")
    refuse("Dr33", (dr > -1) & (dr < 2), FabricOutOfRange,
           "-1 < Dr33 < 2 (the branch length would not be positive)")
    nu, ratio = given["poisson_ratio"], given["stress_ratio"]
    refuse("poisson_ratio", (nu >= 0) & (nu <= 0.5), ValueOutOfRange, "0 <= poisson_ratio <= 0.5")
    refuse("stress_ratio", (ratio > 0) & np.isfinite(ratio), ValueOutOfRange, "0 < stress_ratio < inf")
    if "friction_coefficient" in given:
        mu = given["friction_coefficient"]
        refuse("friction_coefficient", (mu >= 0) & np.isfinite(mu), ValueOutOfRange,
               "0 <= friction_coefficient < inf")
