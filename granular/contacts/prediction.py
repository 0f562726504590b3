"""What the continuum model makes of a list: the fabric about axis 3 that fits it, and the stiffness that follows.

The model knows two numbers of the fabric, D33 of the normals and Dr33 of the branch lengths, besides contacts per
volume, mean square length, and either the mean contact stiffness or the stress, from which it estimates forces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.contact_law import normal_stiffness
from granular.contacts.moments import BRANCHES, NORMALS
from granular.errors import GranularError
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes.result import Six

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.summary import ContactSummary
    from granular.elasticity import Stiffness

    Array = NDArray[np.float64]

EQUAL_CONTACTS, ESTIMATED_FORCES = "mean kn and ks of the list", "forces estimated from the stress"
"""Where the model has its contact stiffnesses from."""

NODES = 64
"""Gauss nodes for averages of the branch length; its weight is a polynomial, and its inverse is smooth."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FittedFabric:
    """Normals and branches about axis 3, as a list has them.

    Attributes
    ----------
    D33 : float
        P2 coefficient of the normals, 15/2 (N33 - 1/3) [-].
    Dr33 : float
        P2 coefficient of the branch length, by least squares over the contacts [-].
    length : float
        l_e [m], with which the model has the mean square of the list.
    inverse_length : float
        1/l_e [1/m], with which it has the mean inverse square.
    """

    D33: float
    Dr33: float
    length: float
    inverse_length: float

    @property
    def axial(self) -> AxialFabric:
        """The fabric as the model takes it; FabricOutOfRange where a density or a length would be negative."""
        return AxialFabric(D33=self.D33, Dr33=self.Dr33)


@dataclass(frozen=True, slots=True, kw_only=True)
class Predicted:
    """One stiffness of the model, or why there is none.

    Attributes
    ----------
    directions : str
        Whether the fabric is that of the normals or that of the branches.
    source : str
        Where contact stiffnesses come from.
    hypothesis : Hypothesis
        Kinematic or static.
    stiffness : Stiffness or None
        Of the assembly [Pa].
    refused : str
        Why there is none; empty where there is.
    distance : float or None
        From the sum over the list under the same hypothesis, over that sum [-]; see :func:`distance`.
    """

    directions: str
    source: str
    hypothesis: Hypothesis
    stiffness: Stiffness | None
    refused: str
    distance: float | None


def fitted_fabric(summary: ContactSummary, directions: str = NORMALS) -> FittedFabric:
    """Fit the two numbers of the model's fabric.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    directions : str
        "normals", or "branches" to take the directions of the branches for both, as if grains touched there.

    Returns
    -------
    FittedFabric
        D33, Dr33 and both lengths.

    Raises
    ------
    FabricOutOfRange
        A density or a branch length would be negative in some direction.

    Notes
    -----
    Accuracy: 1e-13. Source: <P2> = D33/5, which is N33 = 1/3 + 2 D33/15; normal equations of l = b (1 + Dr33 P2).

    Examples
    --------
    >>> from granular.contacts.example import example_facts, example_path
    >>> from granular.contacts.summary import summarise
    >>> found = fitted_fabric(summarise(example_path(), volume=example_facts()["V"]))
    >>> round(found.D33, 3), abs(found.Dr33) < 1e-3
    (0.066, True)
    """
    import numpy as np

    means = summary.length_moments
    mean, square, product = (means[f"{name} of {directions}"] for name in ("P2", "P2^2", "l P2"))
    spread = square - mean**2
    slope = (product - means["l"] * mean) / spread if spread > 1e-9 else 0.0
    fabric = AxialFabric(D33=5 * mean, Dr33=slope / (means["l"] - slope * mean))
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    p2 = 1.5 * ((nodes + 1) / 2) ** 2 - 0.5
    density, weight = weights / 2 * (1 + fabric.D33 * p2), 1 + fabric.Dr33 * p2
    return FittedFabric(D33=fabric.D33, Dr33=fabric.Dr33,
                        length=float(np.sqrt(means["l2"] / (density @ weight**2))),
                        inverse_length=float(np.sqrt(means["inverse_l2"] / (density @ weight**-2))))


def predictions(summary: ContactSummary) -> list[Predicted]:
    """Let the model predict what the list sums to, in every way that the list has the numbers for.

    Parameters
    ----------
    summary : ContactSummary
        A list.

    Returns
    -------
    list of Predicted
        With the mean contact stiffness of the list and with forces estimated from its stress, each under both
        hypotheses; with the fabric of the normals, and where branches deviate from them with that of the branches, too.

    Notes
    -----
    Accuracy: about 1e-14 of what the model says. Source: eqs (4), (7), (20), (22), (23) and Figure 1(b).

    Examples
    --------
    >>> from granular.contacts.example import example_facts, example_path
    >>> from granular.contacts.summary import summarise
    >>> first = predictions(summarise(example_path(), volume=example_facts()["V"]))[0]
    >>> first.distance < 0.05
    True
    """
    fabrics = (NORMALS,) if summary.is_collinear else (NORMALS, BRANCHES)
    return [_predicted(summary, directions, source, hypothesis) for directions in fabrics
            for source in (EQUAL_CONTACTS, ESTIMATED_FORCES) for hypothesis in Hypothesis]


def distance(one: Stiffness, other: Stiffness) -> float:
    """How far two stiffnesses are apart, over the second.

    Parameters
    ----------
    one, other : Stiffness
        Of two assemblies [Pa].

    Returns
    -------
    float
        Norm of the difference of the Mandel matrices over the norm of the second [-]; the norm is that of all 81
        components, which does not depend on the axes.

    Notes
    -----
    Source: the Euclidean norm of a fourth-rank tensor.

    Examples
    --------
    >>> from granular.elasticity import Stiffness
    >>> one = Stiffness.transversely_isotropic(4.0, 4.0, 2.0, 2.0, 1.0, 1.0)
    >>> distance(one.scaled(1.1), one)
    0.1
    """
    import numpy as np

    found = float(np.linalg.norm(one.mandel() - other.mandel()) / np.linalg.norm(other.mandel()))
    return round(found, 15)


def _predicted(summary: ContactSummary, directions: str, source: str, hypothesis: Hypothesis) -> Predicted:
    from granular.elasticity import Stiffness

    truth = summary.kinematic if hypothesis is Hypothesis.KINEMATIC else summary.static
    try:
        fabric = fitted_fabric(summary, directions)
        unit = summary.contacts_per_volume * (
            fabric.length**2 if hypothesis is Hypothesis.KINEMATIC else fabric.inverse_length**-2)
        make = _by_mean_stiffness if source == EQUAL_CONTACTS else _by_estimated_forces
        six = make(summary, fabric, hypothesis)
        stiffness = Stiffness.transversely_isotropic(*(unit * value for value in six))
    except (GranularError, _NotGiven) as refusal:
        return Predicted(directions=directions, source=source, hypothesis=hypothesis, stiffness=None,
                         refused=str(refusal), distance=None)
    return Predicted(directions=directions, source=source, hypothesis=hypothesis, stiffness=stiffness, refused="",
                     distance=None if truth is None else distance(stiffness, truth))


class _NotGiven(Exception):
    """Something that this prediction needs is not in the list."""


def _by_mean_stiffness(summary: ContactSummary, fabric: FittedFabric, hypothesis: Hypothesis) -> Six:
    if summary.mean_kn is None or summary.mean_ks is None:
        raise _NotGiven(summary.no_kinematic)
    if summary.mean_ks == 0 and hypothesis is Hypothesis.STATIC:
        raise _NotGiven("contacts without shear stiffness make the compliance infinite")
    return _scaled(equal_contacts(fabric, summary.mean_ks / summary.mean_kn, hypothesis), summary.mean_kn)


def equal_contacts(fabric: FittedFabric, ratio: float, hypothesis: Hypothesis) -> Six:
    """Six components for contacts that are all equally stiff, whatever the ratio of their stiffnesses.

    The model gives them for the ratios 2/3 to 1 that Poisson's ratio allows. The kinematic stiffness is linear in the
    ratio and the static compliance in its inverse, so that the two ends give all others.

    Parameters
    ----------
    fabric : FittedFabric
        D33 and Dr33 [-].
    ratio : float
        k_s/k_n [-], >= 0; > 0 for the static hypothesis.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: about 1e-14 of the largest, more for a ratio far outside 2/3 to 1. Source: eqs (4) and (7), Figure 1(b).

    Examples
    --------
    >>> from granular.hypothesis import Hypothesis
    >>> plain = FittedFabric(D33=0.0, Dr33=0.0, length=1.0, inverse_length=1.0)
    >>> round(equal_contacts(plain, 0.0, Hypothesis.KINEMATIC)[0], 12)
    0.2
    """
    from granular.array_stiffness import axial_stiffness
    from granular.elasticity import Compliance, Stiffness

    alike, soft = (tuple(float(value) for value in axial_stiffness(
        fabric.D33, fabric.Dr33, poisson_ratio=nu, kinetic=False, hypothesis=hypothesis)) for nu in (0.0, 0.5))
    if hypothesis is Hypothesis.KINEMATIC:
        share = 3 * (1 - ratio)
        c1111, c3333, c1122, c1133, c2323, c1212 = (a + share * (b - a) for a, b in zip(alike, soft, strict=True))
        return c1111, c3333, c1122, c1133, c2323, c1212
    share = 2 * (1 / ratio - 1)
    stiff, flexible = (Stiffness.transversely_isotropic(*six).compliance().components.values() for six in (alike, soft))
    s1111, s3333, s1122, s1133, s2323, s1212 = (a + share * (b - a) for a, b in zip(stiff, flexible, strict=True))
    found = Compliance.transversely_isotropic(s1111, s3333, s1122, s1133, s2323, s1212).stiffness().components
    return (found["C1111"], found["C3333"], found["C1122"], found["C1133"], found["C2323"], found["C1212"])


def _by_estimated_forces(summary: ContactSummary, fabric: FittedFabric, hypothesis: Hypothesis) -> Six:
    from granular.array_stiffness import axial_stiffness

    elastic, stress = summary.material.elastic, summary.stress
    if elastic is None:
        raise _NotGiven("the elasticity of the grains is not given (--shear-modulus, --poisson-ratio)")
    if stress is None:
        raise _NotGiven("the list has no contact forces, from which the stress would follow")
    across, mean = float(stress[0, 0] + stress[1, 1]) / 2, float(stress.trace()) / 3
    if not (across > 0 and float(stress[2, 2]) > 0):
        raise _NotGiven("a principal stress is not a compression")
    reference = normal_stiffness(elastic[0], elastic[1], mean_stress=mean,
                                 contacts_per_volume=summary.contacts_per_volume)
    six = axial_stiffness(fabric.D33, fabric.Dr33, float(stress[2, 2]) / across, poisson_ratio=elastic[1],
                          hypothesis=hypothesis)
    c1111, c3333, c1122, c1133, c2323, c1212 = (float(value) for value in six)
    return _scaled((c1111, c3333, c1122, c1133, c2323, c1212), reference)


def _scaled(six: Six, factor: float) -> Six:
    c1111, c3333, c1122, c1133, c2323, c1212 = (value * factor for value in six)
    return c1111, c3333, c1122, c1133, c2323, c1212
