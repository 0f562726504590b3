"""The derivations there are, in the order in which they build on one another."""

from __future__ import annotations

from collections.abc import Callable

from derivations.engineering import engineering, isotropic
from derivations.equations import equations
from derivations.fabric import fabric
from derivations.fabric_kinds import fabric_kinds
from derivations.forces import contact_forces
from derivations.general_constant import general_constant
from derivations.gradation import gradation
from derivations.gradients import gradients
from derivations.gradients_first_order import first_order_fabric
from derivations.kinematic import kinematic_constant, kinematic_three
from derivations.kinetic import kinetic
from derivations.kinetic_components import kinetic_components
from derivations.kinetic_limits import kinetic_limits
from derivations.mohr import mohr_circle
from derivations.partial_slip import partial_slip
from derivations.record import Derivation
from derivations.slip_table import slip_table
from derivations.spheroid import spheroid
from derivations.static import static_constant, static_three
from derivations.waves import waves

CATALOGUE: tuple[Callable[[], Derivation], ...] = (
    fabric,
    fabric_kinds,
    equations,
    gradation,
    kinematic_constant,
    kinematic_three,
    static_constant,
    static_three,
    general_constant,
    spheroid,
    contact_forces,
    mohr_circle,
    kinetic_components,
    kinetic,
    kinetic_limits,
    partial_slip,
    slip_table,
    gradients,
    first_order_fabric,
    isotropic,
    engineering,
    waves,
)


def names() -> tuple[str, ...]:
    """Names of all derivations."""
    return tuple(build.__name__ for build in CATALOGUE)


def derivation(name: str) -> Derivation:
    """Build one derivation by name.

    Raises
    ------
    KeyError
        There is no derivation of that name; the message lists those there are.
    """
    for build in CATALOGUE:
        if build.__name__ == name:
            return build()
    raise KeyError(f"no derivation {name!r}; there are {', '.join(names())}")
