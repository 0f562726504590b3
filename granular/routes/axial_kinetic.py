"""The stiffness with contact forces, slip, opening and spheroids by one rule along the meridian, for a single scene.

The twin for arrays is ``axial_kinetic_array``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from granular.errors import ResultOutOfRange
from granular.hypothesis import Hypothesis
from granular.routes.rational import accurate_sum, fractions_of, rounded
from granular.routes.result import Six
from granular.spheroid import squared_equator

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
        return rounded(from_weights(fabric, p, shear, apart[:2]))
    along = list(map(float.__truediv__, weight, contacts.normal))
    u = _moments(contacts, along)
    v, more = u, [Fraction(0)] * 3
    if contacts.chi is not None and contacts.gamma is not None:
        yielding = list(map(float.__truediv__, along, contacts.chi))
        v = _moments(contacts, yielding)
        more = _moments(contacts, list(map(float.__mul__, yielding, contacts.gamma)))
    shear = [moment / lam0 for moment in v]
    apart = [(rest * moment + beyond) / lam0 for moment, beyond in zip(u, more, strict=True)]
    return rounded(_from_flexibilities(fabric, contacts, u, shear, apart[:2]))


def from_weights(fabric: AxialFabric, normal: Sequence[Fraction], shear: Sequence[Fraction],
                 apart: Sequence[Fraction]) -> Sequence[Fraction]:
    """Six kinematic components from moments, exactly.

    Parameters
    ----------
    fabric : AxialFabric
        Branch vectors [-].
    normal, shear : sequence of 3 Fraction
        Moments of k_n and k_r with s^2, s y and y^2, weighted by density and branches [-].
    apart : sequence of 2 Fraction
        The first two moments of k_n - k_r [-].

    Returns
    -------
    sequence of 6 Fraction
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Raises
    ------
    ResultOutOfRange
        Spheroids without friction that are free to spin do not resist vertical shear.

    Notes
    -----
    Accuracy: exact, but for the size of a spheroid, which is good to 1e-38. Source: eqs (6) and (7).
    """
    if fabric.collinear:
        from granular.generated import kinetic_components

        six: Any = kinetic_components.stiffness_from_weights(*fractions_of(*normal, *shear, *apart))
        return tuple(six)
    from granular.generated import spheroid

    squared = Fraction(fabric.aspect_ratio) ** 2
    found = list(spheroid.stiffness_from_weights(*fractions_of(*normal, *shear, *apart, squared)))
    if fabric.free_spin and any(shear):
        found[4:5] = spheroid.relaxed_shear(*fractions_of(*shear, apart[1], squared))
    elif fabric.free_spin and squared != 1:  # without friction no couple turns spheres: their shear stiffness stays
        raise ResultOutOfRange("C2323 = 0 for spheroids without friction that are free to spin",
                               allowed="allowed only a stiffness that resists every strain",
                               remedy="Let the grains turn with the mean deformation, or give them friction.")
    return _over_equal_volume(fabric, found)


def _from_flexibilities(fabric: AxialFabric, contacts: ContactRule, normal: Sequence[Fraction],
                        shear: Sequence[Fraction], apart: Sequence[Fraction]) -> Sequence[Fraction]:
    """Six static components from moments of 1/k_n, of 1/k_r, and of their difference."""
    if fabric.collinear:
        from granular.generated import kinetic_components

        six: Any = kinetic_components.stiffness_from_flexibilities(
            *fractions_of(*normal, *shear, *apart, fabric.D33))
        return tuple(six)
    from granular.generated import spheroid

    weight = contacts.directions.balance(fabric)
    s, y = contacts.directions.sine_squared, contacts.directions.cosine_squared
    across = accurate_sum(list(map(float.__mul__, weight, s))) / 2
    along = accurate_sum(list(map(float.__mul__, weight, y))) * Fraction(fabric.aspect_ratio) ** 2
    found = spheroid.stiffness_from_flexibilities(*fractions_of(*normal, *shear, *apart, across, along))
    return _over_equal_volume(fabric, found)


def _over_equal_volume(fabric: AxialFabric, components: Iterable[Any]) -> Sequence[Fraction]:
    """From components over (M/V) (2a)^2 k_n,ref to components over (M/V) l_e^2 k_n,ref."""
    size = squared_equator(fabric.aspect_ratio)
    return tuple(Fraction(component) * size for component in components)


def _moments(contacts: ContactRule, weight: list[float]) -> list[Fraction]:
    """Moments of a weight with s^2, s y and y^2."""
    s, y = contacts.directions.sine_squared, contacts.directions.cosine_squared
    across, along = list(map(float.__mul__, weight, s)), list(map(float.__mul__, weight, y))
    return [accurate_sum(list(map(float.__mul__, part, form))) for part, form in ((across, s), (across, y), (along, y))]
