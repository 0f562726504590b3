"""A fit as a least-squares problem: residuals in units of the uncertainty, and their exact slopes.

Every measured quantity is a product of powers of the six components, so that the logarithm of what the model says is
linear in the logarithms of the components. Factors between model and sample add to them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from granular.derivatives.axial_gradient import PARAMETERS, axial_gradient
from granular.derivatives.state import AxialState, axial_state
from granular.errors import MeasurementsTooFew
from granular.fitting.data import Data
from granular.fitting.quantities import SHEAR
from granular.routes.result import COMPONENTS
from granular.waves import bulk_density

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BOUNDS = {"D33": (-1.0, 2.0), "Dr33": (-0.999, 1.998), "coordination_number": (0.1, 20.0),
          "friction_coefficient": (0.001, 10.0)}
"""Range in which each unknown is looked for [-]; branches keep a length in every direction."""

LOG_FACTOR = 50.0
"""Largest logarithm of a factor between model and sample [-]."""


@dataclass(frozen=True, slots=True)
class Factor:
    """A factor between the stiffness of the model and that of the sample.

    Attributes
    ----------
    name : str
        What it multiplies, for tables.
    states : tuple of int
        The states in which it does.
    components : tuple of str
        The components that it multiplies.
    """

    name: str
    states: tuple[int, ...]
    components: tuple[str, ...]


def factors_of(data: Data) -> tuple[Factor, ...]:
    """Factors that a choice of scale brings, as far as any measurement feels them.

    Parameters
    ----------
    data : Data
        Measurements and scale.

    Returns
    -------
    tuple of Factor
        For each mode, state, both, or neither.

    Notes
    -----
    Source: the choices of ``granular.fitting.data.SCALES``.
    """
    every = tuple(range(len(data.scenes)))
    stretch = tuple(name for name in COMPONENTS if name not in SHEAR)
    one = len(every) == 1
    modes = (("factor of compression", stretch), ("factor of shear", SHEAR))
    made = {
        "none": [],
        "common modes": [Factor(mode, every, components) for mode, components in modes],
        "common": [Factor("factor", every, COMPONENTS)],
        "states": [Factor("factor" if one else f"factor, {data.labels[k]}", (k,), COMPONENTS) for k in every],
        "modes": [Factor(mode if one else f"{mode}, {data.labels[k]}", (k,), components) for k in every
                  for mode, components in modes],
    }[data.scale]
    return tuple(factor for factor in made if any(_felt(factor, data)))


def _felt(factor: Factor, data: Data) -> list[float]:
    """Power of a factor in each measurement [-]."""
    return [sum(power for name, power in zip(COMPONENTS, one.kind.powers, strict=True) if name in factor.components)
            if one.state in factor.states else 0.0 for one in data.measurements]


@dataclass(frozen=True)
class Problem:
    """Residuals of a fit.

    Attributes
    ----------
    data : Data
        What was measured.
    states : tuple of AxialState
        The model of each state, with the unknowns at rest.
    factors : tuple of Factor
        Factors between model and sample.
    """

    data: Data
    states: tuple[AxialState, ...]
    factors: tuple[Factor, ...]

    @classmethod
    def of(cls, data: Data) -> Problem:
        """Set up a fit.

        Parameters
        ----------
        data : Data
            What was measured.

        Returns
        -------
        Problem
            Its residuals.

        Raises
        ------
        MeasurementsTooFew
            Fewer measurements than unknowns and factors.

        Notes
        -----
        Source: counting.
        """
        problem = cls(data, tuple(axial_state(scene) for scene in data.scenes), factors_of(data))
        wanted = [*data.unknowns, *(factor.name for factor in problem.factors)]
        if len(data.measurements) < len(wanted):
            raise MeasurementsTooFew(
                f"{len(data.measurements)} measured for {len(wanted)} unknowns ({', '.join(wanted)})",
                allowed="needed: at least as many measurements as unknowns",
                remedy="Measure more, at several states of stress for instance, or name fewer unknowns or factors "
                '(fit.scale = "states", "common" or "none").')
        return problem

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of what is to be found, without factors."""
        return self.data.unknowns

    @property
    def size(self) -> int:
        """Number of unknowns and factors."""
        return len(self.unknowns) + len(self.factors)

    @cached_property
    def bounds(self) -> tuple[Array, Array]:
        """Least and largest value of each unknown and of the logarithm of each factor [-]."""
        ends = [BOUNDS[name] for name in self.unknowns] + [(-LOG_FACTOR, LOG_FACTOR)] * len(self.factors)
        low, high = np.array(ends).T
        return low, high

    @cached_property
    def _powers(self) -> Array:
        """Power of each component in each measurement, (n, 6)."""
        return np.array([one.kind.powers for one in self.data.measurements])

    @cached_property
    def factor_powers(self) -> Array:
        """Power of each factor in each measurement, (n, factors) [-]."""
        rows = [_felt(factor, self.data) for factor in self.factors]
        return np.array(rows).reshape(len(self.factors), len(self.data.measurements)).T

    @cached_property
    def _offsets(self) -> Array:
        """Logarithm of what multiplies the powers of the normalised components in each measurement."""
        offsets = []
        for one in self.data.measurements:
            scene, state = self.data.scenes[one.state], self.states[one.state]
            offset = sum(one.kind.powers) * np.log(state.factor)
            if one.kind.density_power and scene.grains.density is not None:
                offset += one.kind.density_power * np.log(
                    bulk_density(scene.grains.density, scene.packing.void_ratio))
            offsets.append(offset)
        return np.array(offsets)

    @cached_property
    def _state_of(self) -> NDArray[np.intp]:
        return np.array([one.state for one in self.data.measurements])

    @cached_property
    def values(self) -> Array:
        """Measured values [SI]."""
        return np.array([one.value for one in self.data.measurements])

    @cached_property
    def uncertainties(self) -> Array:
        """Their standard deviations [SI]."""
        return np.array([one.uncertainty for one in self.data.measurements])

    def predicted(self, fabric: Array) -> tuple[Array, Array]:
        """Logarithms of what the model says without factors, and their slopes.

        Parameters
        ----------
        fabric : (..., unknowns) array
            Values of the unknowns [-].

        Returns
        -------
        tuple of 2 array
            (..., n) logarithms and (..., n, unknowns) slopes [-].
        """
        found = {name: fabric[..., place, None] for place, name in enumerate(self.unknowns)}

        def of(name: str) -> Array:
            known: Array = np.array([getattr(state, name) for state in self.states])
            return known

        first = self.states[0]
        friction = None if first.friction is None else found.get("friction_coefficient", of("friction"))
        value, jacobian = axial_gradient(
            found.get("D33", of("D33")), found.get("Dr33", of("Dr33")), of("stress_ratio"), friction,
            of("poisson_ratio"), kinetic=first.kinetic, hypothesis=first.hypothesis)
        logs, slopes = np.log(value), jacobian / value[..., None]
        powers, where = self._powers, self._state_of
        result = self._offsets + np.einsum("nc,...nc->...n", powers, logs[..., where, :])
        by = []
        for name in self.unknowns:
            if name == "coordination_number":
                start = np.array([scene.packing.coordination for scene in self.data.scenes])[where]
                share, total = found[name] / start, powers.sum(axis=-1)
                result = result + 2 / 3 * total * np.log(share)
                by.append(np.broadcast_to(2 / 3 * total / found[name], result.shape))
                continue
            column = slopes[..., PARAMETERS.index(name)][..., where, :]
            by.append(np.broadcast_to(np.einsum("nc,...nc->...n", powers, column), result.shape))
        return result, np.stack(by, axis=-1)

    def residuals(self, unknowns: Array) -> tuple[Array, Array]:
        """Model less measurement over the uncertainty, and its slopes, for many trials at once.

        Parameters
        ----------
        unknowns : (..., size) array
            Unknowns, then logarithms of the factors [-].

        Returns
        -------
        tuple of 2 array
            (..., n) residuals and (..., n, size) slopes [-].
        """
        count = len(self.unknowns)
        logs, slopes = self.predicted(unknowns[..., :count])
        model = np.exp(logs + unknowns[..., count:] @ self.factor_powers.T)
        powers = np.broadcast_to(self.factor_powers, (*logs.shape, len(self.factors)))
        scaled = (model / self.uncertainties)[..., None] * np.concatenate([slopes, powers], axis=-1)
        return (model - self.values) / self.uncertainties, scaled

    def best_factors(self, fabric: Array, *, rounds: int = 30) -> tuple[Array, Array]:
        """The factors that fit best at given unknowns, for many of them at once, by Gauss-Newton steps.

        Parameters
        ----------
        fabric : (..., unknowns) array
            Values of the unknowns [-].
        rounds : int
            Most steps [-].

        Returns
        -------
        tuple of 2 array
            (..., factors) logarithms of the factors, and (...) chi-square [-].
        """
        logs, _ = self.predicted(fabric)
        powers = self.factor_powers
        # to start from: logarithms, in which the problem is linear
        weights = (self.values / self.uncertainties)[:, None] * powers
        start = (np.log(self.values) - logs) * (self.values / self.uncertainties)
        factors = np.einsum("fn,...n->...f", np.linalg.pinv(weights), start)
        for _ in range(rounds if self.factors else 0):
            model = np.exp(logs + factors @ powers.T)
            slopes = (model / self.uncertainties)[..., None] * powers
            left = (self.values - model) / self.uncertainties
            step = np.einsum("...fn,...n->...f", np.linalg.pinv(slopes), left)
            factors = factors + step
            if abs(step).max(initial=0.0) < 1e-13:
                break
        model = np.exp(logs + factors @ powers.T)
        chi_square: Array = (((model - self.values) / self.uncertainties) ** 2).sum(axis=-1)
        return factors, chi_square
