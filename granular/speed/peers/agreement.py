"""Whether other packages give the numbers that their formulas are meant to give."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version

from granular.hertz_mindlin import moduli
from granular.speed.peers import rock_physics
from granular.speed.sample import POISSON

QUOTIENT = 2.0
"""Hydrostatic over uniaxial strain of the sphere pack that is looked at [-]."""

PRESSURE = 1e6
"""Pressure on the isotropic packing that is looked at [Pa]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Agreement:
    """One number of another package, beside what it is meant to be.

    Attributes
    ----------
    package : str
        Name and version.
    quantity : str
        What it is.
    theirs, meant : float
        What the package gives, and what its formula is meant to give, in one unit.
    unit : str
        That unit.
    """

    package: str
    quantity: str
    theirs: float
    meant: float
    unit: str

    @property
    def distance(self) -> float:
        """Relative distance of the two [-]."""
        return abs(self.theirs / self.meant - 1)


def agreements() -> list[Agreement]:
    """Compare what is installed with what its formulas are meant to give.

    Returns
    -------
    list of Agreement
        Empty where nothing is installed.

    Notes
    -----
    Source: Walton (1987) for rough and smooth spheres; Norris and Johnson (1997) for packs under a uniaxial strain.
    """
    try:
        return [*_isotropic(), *_sphere_pack()]
    except ModuleNotFoundError:
        return []


def _isotropic() -> list[Agreement]:
    from rockphypy import GM

    name = f"rockphypy {version('rockphypy')}"
    bulk, shear = moduli(rock_physics.SHEAR, POISSON, mean_stress=PRESSURE, void_ratio=rock_physics.VOID_RATIO,
                         coordination_number=rock_physics.COORDINATION)
    smooth = 3 / 5 * bulk
    porosity = rock_physics.VOID_RATIO / (1 + rock_physics.VOID_RATIO)
    found = [GM.hertzmindlin(rock_physics.BULK / 1e9, rock_physics.SHEAR / 1e9, porosity, rock_physics.COORDINATION,
                             PRESSURE / 1e6, factor) for factor in (0.0, 1.0)]
    return [Agreement(package=name, quantity="bulk modulus, GM.hertzmindlin", theirs=float(found[1][0]),
                      meant=bulk / 1e9, unit="GPa"),
            Agreement(package=name, quantity="shear modulus, f = 1, of rough spheres", theirs=float(found[1][1]),
                      meant=shear / 1e9, unit="GPa"),
            Agreement(package=name, quantity="shear modulus, f = 0, of smooth spheres", theirs=float(found[0][1]),
                      meant=smooth / 1e9, unit="GPa"),
            Agreement(package=name, quantity="shear modulus, f = 0, of rough spheres, as its help says",
                      theirs=float(found[0][1]), meant=shear / 1e9, unit="GPa")]


def _sphere_pack() -> list[Agreement]:
    theirs = rock_physics.constants(QUOTIENT)
    meant = {"": rock_physics.sphere_pack(QUOTIENT), ", with its two slips": rock_physics.as_written(QUOTIENT)}
    name = f"rockphypy {version('rockphypy')}"
    return [Agreement(package=name, quantity=f"{constant} of a sphere pack, GM.johnson{how}", theirs=theirs[place],
                      meant=values[place], unit="GPa")
            for how, values in meant.items() for place, constant in enumerate(("C11", "C33", "C13", "C44", "C66"))]
