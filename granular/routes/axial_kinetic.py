"""The stiffness with contact forces, partial slip and opening by one rule along the meridian, for a single scene.

The twin for arrays is ``axial_kinetic_array``.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.rational import accurate_sum, fractions_of, rounded
from granular.routes.result import Six

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.routes.contact_rule import ContactRule


def components_by_contacts(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                           contacts: ContactRule) -> Six:
    """Evaluate the six components by a given rule, with no promise about its error.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    contacts : ContactRule
        Directions, weights and contact stiffness.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    The error of the rule, plus rounding of about one unit in the last place of each moment; what is done with the
    moments is exact.

    Source
    ------
    Eq. (7), and Figure 1(b) with (23).
    """
    from granular.generated import kinetic_components as emitted

    nu = Fraction(poisson_ratio)
    lam0, rest = (2 - 2 * nu) / (2 - nu), nu / (2 - nu)
    weight = contacts.directions.weight(fabric, hypothesis)
    if hypothesis is Hypothesis.KINEMATIC:
        along = list(map(float.__mul__, weight, contacts.normal))
        p = _moments(contacts, along)
        q, lost = p, [Fraction(0)] * 3
        if contacts.chi is not None and contacts.gamma is not None:
            q = _moments(contacts, list(map(float.__mul__, along, contacts.chi)))
            lost = _moments(contacts, list(map(float.__mul__, along, contacts.gamma)))
        shear = [lam0 * moment for moment in q]
        apart = [rest * moment + lam0 * less for moment, less in zip(p, lost, strict=True)]
        return rounded(emitted.stiffness_from_weights(*fractions_of(*p, *shear, *apart[:2])))
    along = list(map(float.__truediv__, weight, contacts.normal))
    u = _moments(contacts, along)
    v, more = u, [Fraction(0)] * 3
    if contacts.chi is not None and contacts.gamma is not None:
        yielding = list(map(float.__truediv__, along, contacts.chi))
        v = _moments(contacts, yielding)
        more = _moments(contacts, list(map(float.__mul__, yielding, contacts.gamma)))
    shear = [moment / lam0 for moment in v]
    apart = [(rest * moment + beyond) / lam0 for moment, beyond in zip(u, more, strict=True)]
    return rounded(emitted.stiffness_from_flexibilities(
        *fractions_of(*u, *shear, *apart[:2], fabric.D33)))


def _moments(contacts: ContactRule, weight: list[float]) -> list[Fraction]:
    """Moments of a weight with s^2, s y and y^2."""
    s, y = contacts.directions.sine_squared, contacts.directions.cosine_squared
    across, along = list(map(float.__mul__, weight, s)), list(map(float.__mul__, weight, y))
    return [accurate_sum(list(map(float.__mul__, part, form))) for part, form in ((across, s), (across, y), (along, y))]
