"""The stiffness with contact forces, slip, opening and spheroids by one rule along the meridian, for a single scene.

The twin for arrays is ``axial_kinetic_array``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from operator import mul, truediv
from typing import TYPE_CHECKING, Any

from granular.errors import ResultOutOfRange
from granular.hypothesis import Hypothesis
from granular.routes.arithmetic import FRACTIONS, Arithmetic
from granular.routes.result import Six
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.routes.contact_rule import ContactRule


def components_by_contacts(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                           contacts: ContactRule, arithmetic: Arithmetic = FRACTIONS) -> Six:
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
    arithmetic : Arithmetic
        What is done with the moments.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    The error of the rule, plus rounding of about one unit in the last place of each moment; what is done with the
    moments is exact in fractions.

    Source
    ------
    Eq. (7), and Figure 1(b) with (23).
    """
    nu = arithmetic.number(poisson_ratio)
    lam0, rest = (2 - 2 * nu) / (2 - nu), nu / (2 - nu)
    weight = contacts.directions.weight(fabric, hypothesis)
    moments = partial(_moments, contacts, arithmetic)
    if hypothesis is Hypothesis.KINEMATIC:
        along = list(map(mul, weight, contacts.normal))
        p = moments(along)
        q, lost = p, [arithmetic.number(0)] * 3
        if contacts.chi is not None and contacts.gamma is not None:
            q = moments(list(map(mul, along, contacts.chi)))
            lost = moments(list(map(mul, along, contacts.gamma)))
        shear = [lam0 * moment for moment in q]
        apart = [rest * moment + lam0 * less for moment, less in zip(p, lost, strict=True)]
        return arithmetic.finished(from_weights(fabric, p, shear, apart[:2], arithmetic))
    along = list(map(truediv, weight, contacts.normal))
    u = moments(along)
    v, more = u, [arithmetic.number(0)] * 3
    if contacts.chi is not None and contacts.gamma is not None:
        yielding = list(map(truediv, along, contacts.chi))
        v = moments(yielding)
        more = moments(list(map(mul, yielding, contacts.gamma)))
    shear = [moment / lam0 for moment in v]
    apart = [(rest * moment + beyond) / lam0 for moment, beyond in zip(u, more, strict=True)]
    return arithmetic.finished(_from_flexibilities(fabric, contacts, u, shear, apart[:2], arithmetic))


def work_by_contacts(fabric: AxialFabric, hypothesis: Hypothesis, contacts: ContactRule,
                     arithmetic: Arithmetic) -> Work:
    """Count what :func:`components_by_contacts` does.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    contacts : ContactRule
        Directions, weights and contact stiffness.
    arithmetic : Arithmetic
        What is done with the moments.

    Returns
    -------
    Work
        Operations and functions.

    Notes
    -----
    Accuracy: exact; a test counts the same with numbers that count. Source: the functions of this module.
    """
    nodes, slips = len(contacts), contacts.chi is not None
    weight = contacts.directions.work_of_weight(fabric, hypothesis)
    triples = 3 if slips else 1  # moments of the normal and shear stiffness, and of their difference
    moments = (Work(6) * nodes + arithmetic.additions(nodes) * 3) * triples  # each weighted first
    if hypothesis is Hypothesis.KINEMATIC:
        ends = Work(40) if fabric.collinear else Work(55)
        return weight + moments + ends + (Work(19) if fabric.free_spin else Work())
    if fabric.collinear:
        return weight + moments + Work(71)
    balance = contacts.directions.work_of_balance(fabric) + Work(2) * nodes + arithmetic.additions(nodes) * 2
    return weight + moments + balance + Work(73)


def from_weights(fabric: AxialFabric, normal: Sequence[Any], shear: Sequence[Any], apart: Sequence[Any],
                 arithmetic: Arithmetic = FRACTIONS) -> Sequence[Any]:
    """Six kinematic components from moments, exactly in fractions.

    Parameters
    ----------
    fabric : AxialFabric
        Branch vectors [-].
    normal, shear : sequence of 3 Fraction
        Moments of k_n and k_r with s^2, s y and y^2, weighted by density and branches [-].
    apart : sequence of 2 Fraction
        The first two moments of k_n - k_r [-].
    arithmetic : Arithmetic
        What numbers are; the moments are such numbers.

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

        six: Any = kinetic_components.stiffness_from_weights(*arithmetic.numbers(*normal, *shear, *apart))
        return tuple(six)
    from granular.generated import spheroid

    squared = arithmetic.number(fabric.aspect_ratio) ** 2
    found = list(spheroid.stiffness_from_weights(*arithmetic.numbers(*normal, *shear, *apart, squared)))
    if fabric.free_spin and any(shear):
        found[4:5] = spheroid.relaxed_shear(*arithmetic.numbers(*shear, apart[1], squared))
    elif fabric.free_spin and squared != 1:  # without friction no couple turns spheres: their shear stiffness stays
        raise ResultOutOfRange("C2323 = 0 for spheroids without friction that are free to spin",
                               allowed="allowed only a stiffness that resists every strain",
                               remedy="Let the grains turn with the mean deformation, or give them friction.")
    return _over_equal_volume(fabric, found, arithmetic)


def _from_flexibilities(fabric: AxialFabric, contacts: ContactRule, normal: Sequence[Any], shear: Sequence[Any],
                        apart: Sequence[Any], arithmetic: Arithmetic) -> Sequence[Any]:
    """Six static components from moments of 1/k_n, of 1/k_r, and of their difference."""
    if fabric.collinear:
        from granular.generated import kinetic_components

        six: Any = kinetic_components.stiffness_from_flexibilities(
            *arithmetic.numbers(*normal, *shear, *apart, fabric.D33))
        return tuple(six)
    from granular.generated import spheroid

    weight = contacts.directions.balance(fabric)
    s, y = contacts.directions.sine_squared, contacts.directions.cosine_squared
    across = arithmetic.total(list(map(mul, weight, s))) / 2
    along = arithmetic.total(list(map(mul, weight, y))) * arithmetic.number(fabric.aspect_ratio) ** 2
    found = spheroid.stiffness_from_flexibilities(*arithmetic.numbers(*normal, *shear, *apart, across, along))
    return _over_equal_volume(fabric, found, arithmetic)


def _over_equal_volume(fabric: AxialFabric, components: Iterable[Any], arithmetic: Arithmetic) -> Sequence[Any]:
    """From components over (M/V) (2a)^2 k_n,ref to components over (M/V) l_e^2 k_n,ref."""
    from granular.spheroid import squared_equator

    size = arithmetic.number(squared_equator(fabric.aspect_ratio))
    return tuple(arithmetic.number(component) * size for component in components)


def _moments(contacts: ContactRule, arithmetic: Arithmetic, weight: list[float]) -> list[Any]:
    """Moments of a weight with s^2, s y and y^2."""
    s, y = contacts.directions.sine_squared, contacts.directions.cosine_squared
    across, along = list(map(mul, weight, s)), list(map(mul, weight, y))
    return [arithmetic.total(list(map(mul, part, form))) for part, form in ((across, s), (across, y), (along, y))]
