"""The wave speeds of the tutorial for the laboratory: made up by a rule from tests on sand, with stated scatter.

The rule is not the model of this book, so that the model can be wrong about it. The shear modulus follows Hardin and
Richart (1963) for round grains, 6908 (2.17 - e)^2/(1 + e) sqrt(p) in kPa. Of an unequal stress the one along which a
wave travels and the one along which it vibrates count alike, so that sqrt(p) becomes (s_i s_j)^(1/4). Compression
follows from Poisson's ratio. Horizontal stiffness is greater by two factors, as in a deposit laid down by gravity.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from math import sqrt

import numpy as np

VOID_RATIO, GRAIN_DENSITY = 0.65, 2650.0
"""Of the specimen [-] and of its mineral [kg/m^3]."""

POISSON_RATIO = 0.2
"""Of the sand as a whole [-]."""

HORIZONTAL = {"compression": 1.12, "shear": 1.06}
"""Stiffness of horizontal waves over that of vertical ones under equal stresses [-]."""

SCATTER = {"Vp": 0.01, "Vs": 0.008}
"""Standard deviation of a reading over the reading [-]."""

SEED = 1
"""Start of the random numbers: the same scatter every time."""


@dataclass(frozen=True, slots=True)
class State:
    """A state of stress: its name in the file, and its vertical and horizontal stress [kPa]."""

    label: str
    vertical: float
    horizontal: float

    @property
    def mean(self) -> float:
        """Mean stress [kPa]."""
        return (self.vertical + 2 * self.horizontal) / 3


EQUAL = (State("50 kPa", 50, 50), State("100 kPa", 100, 100), State("200 kPa", 200, 200))
UNEQUAL = State("ratio 2", 200, 100)


def shear_modulus(along: float, across: float) -> float:
    """Shear modulus [Pa] under the stresses along travel and vibration [kPa]."""
    return 6908e3 * (2.17 - VOID_RATIO) ** 2 / (1 + VOID_RATIO) * (along * across) ** 0.25


def speeds(state: State) -> dict[str, float]:
    """Five speeds without scatter [m/s]."""
    up, level = state.vertical, state.horizontal
    confined = 2 * (1 - POISSON_RATIO) / (1 - 2 * POISSON_RATIO)
    moduli = {
        "Vp_vertical": confined * shear_modulus(up, up),
        "Vp_horizontal": HORIZONTAL["compression"] * confined * shear_modulus(level, level),
        "Vs_vh": shear_modulus(up, level),
        "Vs_hv": shear_modulus(level, up),
        "Vs_hh": HORIZONTAL["shear"] * shear_modulus(level, level),
    }
    return {name: sqrt(modulus * (1 + VOID_RATIO) / GRAIN_DENSITY) for name, modulus in moduli.items()}


def readings(states: tuple[State, ...]) -> str:
    """Read the speeds of some states with scatter, as tables of a data file."""
    scatter, text = np.random.default_rng(SEED), ""
    for state in states:
        stress = f'mean = "{state.mean:.6g} kPa", ratio = {state.vertical / state.horizontal:g}'
        text += f'\n[[measured]]\nlabel = "{state.label}"\nstress = {{ {stress} }}\n'
        for name, speed in speeds(state).items():
            share = SCATTER[name[:2]]
            text += f'{name} = "{speed * (1 + share * scatter.normal()):.0f} m/s +- {share * speed:.1f} m/s"\n'
    return text


HEAD = """\
# Bender and compression elements on one specimen{what}.
# Made up: a rule from resonant-column tests, two factors for
# the deposit, and scatter of 1 % in Vp and of 0.8 % in Vs.

[grains]
shear_modulus = "31 GPa"
poisson_ratio = 0.21
friction_angle = "24 deg"
density = "2650 kg/m^3"

[packing]
void_ratio = 0.65

[fit]
unknowns = ["D33", "Dr33"]
scale = "modes"               # only anisotropy counts
"""

DATA_FILES = {"lab_speeds.toml": HEAD.format(what="") + readings(EQUAL),
              "lab_ratio.toml": HEAD.format(what=", one state more") + readings((*EQUAL, UNEQUAL))}
"""Both data files by their name."""


def main() -> None:
    """Print the data file that is named."""
    sys.stdout.write(DATA_FILES[sys.argv[1]])


if __name__ == "__main__":
    main()
