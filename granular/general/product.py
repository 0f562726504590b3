"""Integrals over the sphere by a product rule that is split at the edges of sliding and opening.

The half sphere is cut into four triangles whose corners are the directions without shear force. In each, meridians run
from one corner to the opposite side (``meridians``); over the azimuth, panels end where the number of edges on a
meridian changes, crowd there, and are halved until halving changes nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from granular.general.lebedev import FLOOR, Assembly, Integral, Weights, monomials
from granular.general.meridians import Integrand, Meridians, directions, edges_passed, panels
from granular.generated.gauss_legendre import NODES, WEIGHTS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Whole = NDArray[np.int64]

CROWDING = 6
"""Power of the map that crowds azimuths towards the ends of a panel: edges that appear leave the power 5/6 of the
distance, edges that leave through a side 4/3, and a sixth power makes both smooth."""

ACROSS = 10
"""Gauss nodes on a panel over the azimuth [-]."""

ALONG = (10, 14, 20)
"""Gauss nodes on a panel along a meridian [-], one after the other when the first do not suffice."""

ROUNDS = 40
"""Times a panel over the azimuth may be halved [-]."""

MOST = 4e6
"""Directions after which the rule gives up [-]."""

CHUNK = 150_000
"""Directions that are evaluated at once [-]: a few tens of megabytes."""

SAMPLES = 48
"""Meridians of each triangle on which edges are counted first [-]."""


@dataclass(frozen=True, slots=True)
class Triangles:
    """Four spherical triangles that cover a half sphere.

    Attributes
    ----------
    pole, first, second, limit : (4, 3) arrays
        Corner from which meridians start, axes of the azimuth at a right angle to it, normal of the opposite side [-].
    width : (4,) array
        Azimuth from the second corner, where it is zero, to the third [rad].
    """

    pole: Array
    first: Array
    second: Array
    limit: Array
    width: Array

    def meridians(self, which: Whole, azimuth: Array) -> Meridians:
        """Great circles of given azimuths."""
        import numpy as np

        towards = np.cos(azimuth)[:, None] * self.first[which] + np.sin(azimuth)[:, None] * self.second[which]
        return Meridians(self.pole[which], towards, self.limit[which])


@dataclass(frozen=True, slots=True)
class Azimuths:
    """Panels over the azimuth: azimuth = start + reach x^6 for x between low and high.

    Attributes
    ----------
    which : (p,) array of int
        Triangle of each panel [-].
    start, reach : (p,) arrays
        Azimuth at the end towards which nodes crowd, and signed distance to the other end [rad].
    low, high : (p,) arrays
        Part of it that the panel covers [-].
    """

    which: Whole
    start: Array
    reach: Array
    low: Array
    high: Array

    def picked(self, chosen: NDArray[np.bool_]) -> Azimuths:
        """Some of the panels."""
        return Azimuths(self.which[chosen], self.start[chosen], self.reach[chosen], self.low[chosen],
                        self.high[chosen])

    def halved(self) -> Azimuths:
        """Both halves of every panel, one after the other."""
        import numpy as np

        middle = (self.low + self.high) / 2
        return Azimuths(np.repeat(self.which, 2), np.repeat(self.start, 2), np.repeat(self.reach, 2),
                        np.stack([self.low, middle], axis=1).ravel(), np.stack([middle, self.high], axis=1).ravel())

    def joined(self, other: Azimuths) -> Azimuths:
        """These panels and others."""
        import numpy as np

        return Azimuths(*(np.concatenate([getattr(self, name), getattr(other, name)])
                          for name in ("which", "start", "reach", "low", "high")))


def corners(integrand: Integrand) -> tuple[Array, int]:
    """Directions in which the contact force has no shear, and the one from which meridians should start.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.

    Returns
    -------
    corners : (3, 3) array
        One direction a column [-], right-handed; principal directions of the normal force where shear does not matter.
    pole : int
        The column whose principal value is furthest from the others [-].

    Notes
    -----
    Accuracy: 1e-15. Source: B = sigma A has three real directions B n = b n, because A is positive definite.
    """
    import numpy as np

    if integrand.forces is None:
        tensor = np.zeros((3, 3)) if integrand.branches is None else integrand.branches
        values, vectors = np.linalg.eigh(tensor)
    elif integrand.slips:
        values, vectors = _real_directions(integrand.forces)
    else:
        values, vectors = np.linalg.eigh((integrand.forces + integrand.forces.T) / 2)
    if np.linalg.det(vectors) < 0:
        vectors = -vectors
    return vectors, 2 if values[2] - values[1] >= values[1] - values[0] else 0


def _real_directions(B: Array) -> tuple[Array, Array]:
    import numpy as np

    values, vectors = np.linalg.eig(B)
    if np.iscomplexobj(values) or abs(np.linalg.det(vectors)) < 1e-3:  # rounding of equal principal values
        values, vectors = np.linalg.eigh((B + B.T) / 2)
    order = np.argsort(values)
    return values[order], vectors[:, order] / np.linalg.norm(vectors[:, order], axis=0)


def triangles(integrand: Integrand) -> Triangles:
    """Cut a half sphere into four triangles.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.

    Returns
    -------
    Triangles
        With the corners of :func:`corners`, each once or with the opposite sign.

    Notes
    -----
    Source: three planes through the centre cut the sphere into eight triangles, opposite ones being equal.
    """
    import numpy as np

    vectors, top = corners(integrand)
    found: dict[str, list[Array]] = {name: [] for name in ("pole", "first", "second", "limit")}
    width = []
    for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        pole = vectors[:, top]
        second, third = (sign * vectors[:, (top + step) % 3] for sign, step in zip(signs, (1, 2), strict=True))
        if np.linalg.det(np.stack([pole, second, third])) < 0:
            second, third = third, second
        start = second - (second @ pole) * pole
        start = start / np.linalg.norm(start)
        side, normal = np.cross(pole, start), np.cross(second, third)
        for name, vector in zip(found, (pole, start, side, normal / np.linalg.norm(normal)), strict=True):
            found[name].append(vector)
        width.append(math.atan2(float(third @ side), float(third @ start)))
    pole, first, second, limit = (np.array(vectors) for vectors in found.values())
    return Triangles(pole, first, second, limit, np.array(width))


def first_azimuths(integrand: Integrand, cut: Triangles) -> Azimuths:
    """Panels between the corners and the azimuths at which edges appear or vanish.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.
    cut : Triangles
        The triangles.

    Returns
    -------
    Azimuths
        Two panels between each two of them, which crowd towards the ends.

    Notes
    -----
    Accuracy: azimuths at which the number of edges changes are halved down to rounding. Two that lie between two
    samples go unseen here, and are left to the halving of panels. Source: bisection.
    """
    import numpy as np

    share: Array = (np.arange(SAMPLES) + 0.5) / SAMPLES
    which = np.repeat(np.arange(4), SAMPLES)
    azimuth = cut.width[:, None] * share
    edges = edges_passed(integrand, cut.meridians(which, azimuth.ravel())).reshape(4, SAMPLES)
    row, column = np.nonzero(np.diff(edges, axis=1))
    low, high, below = azimuth[row, column], azimuth[row, column + 1], edges[row, column]
    for _ in range(50 if row.size else 0):
        middle = (low + high) / 2
        same = edges_passed(integrand, cut.meridians(row, middle)) == below
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = []
    for place in range(4):
        stops = [0.0, *sorted(((low + high) / 2)[row == place].tolist()), float(cut.width[place])]
        for left, right in pairwise(stops):
            if right - left > 1e-14:
                reach = (right - left) / 2
                found += [(place, left, reach), (place, right, -reach)]
    table = np.array(found)
    ones = np.ones(len(found))
    return Azimuths(table[:, 0].astype(np.int64), table[:, 1], table[:, 2], 0 * ones, ones)


@dataclass(slots=True)
class _Rule:
    """The inner rule, and what it has been asked for."""

    weights: Weights
    integrand: Integrand
    cut: Triangles
    finest: float
    along: int = ALONG[0]
    across: int = ACROSS
    evaluations: int = 0

    def sums(self, azimuths: Azimuths) -> Array:
        """Moments of every panel over the azimuth, (p, 21)."""
        import numpy as np

        x, w = np.array(NODES[self.across]), np.array(WEIGHTS[self.across])
        found = np.zeros((azimuths.which.size, 21))
        each = max(1, CHUNK // (self.across * 300))
        for begin in range(0, azimuths.which.size, each):
            chosen = slice(begin, begin + each)
            low, width = azimuths.low[chosen, None], (azimuths.high - azimuths.low)[chosen, None]
            place = low + width * x
            reach = azimuths.reach[chosen, None]
            azimuth = azimuths.start[chosen, None] + reach * place**CROWDING
            weight = np.abs(reach) * CROWDING * place ** (CROWDING - 1) * width * w
            which = np.repeat(azimuths.which[chosen], self.across)
            inner = self._along(self.cut.meridians(which, azimuth.ravel()))
            found[chosen] = (inner * weight.reshape(-1, 1)).reshape(-1, self.across, 21).sum(axis=1)
        return found

    def _along(self, meridians: Meridians) -> Array:
        """Integrals along meridians, (k, 21)."""
        import numpy as np

        cut = panels(self.integrand, meridians, finest=self.finest)
        found = np.zeros((len(meridians.pole), 21))
        if cut.which.size == 0:
            return found
        x, w = np.array(NODES[self.along]), np.array(WEIGHTS[self.along])
        span = (cut.far - cut.near)[:, None]
        plain = cut.near[:, None] + span * x
        distance = np.where(cut.cubic[:, None], span * x**3, plain)
        weight = np.abs(span) * np.where(cut.cubic[:, None], 3 * x**2, 1.0) * w
        angle = (cut.root[:, None] + distance).ravel()
        n = directions(meridians, np.repeat(cut.which, self.along), angle)
        fourth, second = self.weights(n)
        area = weight.ravel() * np.sin(angle) / (2 * math.pi)
        self.evaluations += angle.size
        products = monomials(n)
        products[:15] *= area * fourth
        products[15:] *= area * second
        starts = np.flatnonzero(np.diff(cut.which, prepend=-1)) * self.along
        found[cut.which[starts // self.along]] = np.add.reduceat(products, starts, axis=1).T
        return found


def integrated(weights: Weights, assembly: Assembly, integrand: Integrand, *, rtol: float) -> Integral:
    """Average over the sphere until panels, nodes and halvings agree.

    Parameters
    ----------
    weights : callable
        The integrand.
    assembly : callable
        From moments to the stiffness.
    integrand : Integrand
        What decides where it is not smooth.
    rtol : float
        Wanted error of the worst entry over the largest one [-].

    Returns
    -------
    Integral
        The stiffness by the finest rule, whether it reaches ``rtol`` or not.

    Notes
    -----
    Accuracy: twice the difference between two rules is stated, of which the coarser has fewer nodes on every panel,
    along meridians and across, and no less than five times the tolerance to which panels were halved, which makes half
    of ``rtol`` at first: an estimate. Source: geometric meshes, Gauss nodes.
    """
    import numpy as np

    cut = triangles(integrand)
    first = first_azimuths(integrand, cut)
    error, evaluations, mandel = math.inf, 0, np.zeros((6, 6))
    for attempt, along in enumerate(ALONG):
        sharp = rtol * 10.0 ** -(1 + attempt)
        rule = _Rule(weights, integrand, cut, finest=max(sharp, 1e-15) ** 0.6, along=along, evaluations=evaluations)
        kept, coarse = _refined(rule, assembly, first, sharp)
        rule.along, rule.across = along + (4 if along < 20 else 8), ACROSS + 2
        mandel = assembly(rule.sums(kept).sum(axis=0))
        evaluations = rule.evaluations
        change = float(np.abs(mandel - coarse).max() / np.abs(mandel).max())
        error = max(2 * change, 5 * sharp, FLOOR)
        if error <= rtol or evaluations > MOST:
            break
    return Integral(mandel, error, evaluations)


def _refined(rule: _Rule, assembly: Assembly, first: Azimuths, tolerance: float) -> tuple[Azimuths, Array]:
    """Halve panels over the azimuth until that changes nothing; the panels, and the stiffness by them."""
    import numpy as np

    open_, sums = first, rule.sums(first)
    done: list[Azimuths] = []
    total_done = np.zeros(21)
    for _ in range(ROUNDS):
        halves = open_.halved()
        finer = rule.sums(halves)
        both = finer.reshape(-1, 2, 21).sum(axis=1)
        change = np.abs(both - sums).max(axis=1)
        total = total_done + both.sum(axis=0)
        allowed = tolerance * float(np.abs(total).max())
        good = change <= allowed / max(8.0, 0.5 * len(change))
        done.append(open_.picked(good).halved())
        total_done = total_done + both[good].sum(axis=0)
        if change.sum() <= allowed or good.all() or rule.evaluations > MOST:
            done.append(open_.picked(~good).halved())
            total_done = total_done + both[~good].sum(axis=0)
            break
        again = np.repeat(~good, 2)
        open_, sums = halves.picked(again), finer[again]
    else:
        done.append(open_)
        total_done = total_done + sums.sum(axis=0)
    kept = done[0]
    for more in done[1:]:
        kept = kept.joined(more)
    return kept, assembly(total_done)
