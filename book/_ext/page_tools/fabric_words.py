"""What the coefficients of the fabric mean, said with the densities and lengths that the library computes."""

from __future__ import annotations

from granular import AxialFabric
from granular.directions import branch_weight, relative_density
from page_tools.markup import Markup

PACKING, BRANCHES = 0.3, -0.3
"""D33 and Dr33 of case 3 of Table II."""


def packing_words() -> Markup:
    """Say what D33 does to the density of contact normals at pole and equator."""
    pole, equator = (relative_density(AxialFabric(D33=PACKING), x) for x in (1.0, 0.0))
    return Markup(
        f"**$D_{{33}}$** shifts contacts towards axis 3 or away from it. With $D_{{33}} = {PACKING:g}$ the density of "
        f"contact normals is {pole:.2f} of the isotropic one at the pole and {equator:.2f} at the equator, the kind of "
        "fabric that grains settling under gravity form. With $D_{33} = -1$ no contact is vertical; with "
        "$D_{33} = 2$ none is horizontal.\n")


def branch_words() -> Markup:
    """Say what Dr33 does to branches along axis 3 and across."""
    along, across = (branch_weight(AxialFabric(Dr33=BRANCHES), x) for x in (1.0, 0.0))
    return Markup(
        f"**$D^{{r}}_{{33}}$** stretches branches. With $D^{{r}}_{{33}} = {BRANCHES:g}$ a vertical branch is "
        f"{along:.2f} of $\\ell_e$ and a horizontal one {across:.2f}: flat grains that lie down. The paper uses it as "
        "a stand-in for grain shape and preferred orientation.\n")
