"""What one reading of a contact list tells: numbers, fabric, lengths, forces, stress and stiffness."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.contacts.by_angle import ByAngle
from granular.contacts.contact_list import ContactList
from granular.contacts.kernels import symmetric
from granular.contacts.lengths import Lengths
from granular.contacts.material import Material
from granular.contacts.moments import Moments
from granular.contacts.touching import Touching
from granular.errors import TensorNotInvertible, TooFewDirections, ValueOutOfRange

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.elasticity import Stiffness
    from granular.fabric_tensors import FabricTensors, SymmetryTest

    Array = NDArray[np.float64]

FROM_LIST, FROM_FORCES = "kn and ks of the list", "Hertz-Mindlin from the contact forces"
"""Where contact stiffnesses come from."""

NO_STIFFNESS = ("the list does not have both kn and ks, and to take them from the forces it needs fn, with "
                "--shear-modulus and --poisson-ratio")
"""Why there is no stiffness."""

COLLINEAR = 1 - 1e-6
"""Mean cosine of the angle between branch and normal above which they are taken for one direction [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactSummary:
    """What a contact list tells.

    Attributes
    ----------
    name : str
        Name of the file.
    volume : float
        V [m^3].
    grains : int or None
        All grains, with and without contacts [-].
    contacts, dropped : int
        M, and how many contacts were left out [-].
    touching, with_one : int or None
        Grains with contacts, and with one only [-]; None for a list that does not number them.
    normals, branches : (3, 3) array
        Mean of n_i n_j, and of the same for the directions of branches [-].
    balance : (3, 3) array
        H_ik = (1/V) sum l_i n_k/l [1/m^3]: f_j = sigma_pj H^-1_kp n_k/l balances the stress.
    directions : FabricTensors
        Fabric tensors of the normals up to rank four, with their scatter.
    lengths : Lengths
        Distribution of branch lengths.
    length_moments : dict
        Means of l [m], l^2 [m^2], l^-2 [1/m^2], and of P2, P2^2 [-] and l P2 [m] for normals and branches.
    by_angle : ByAngle
        Contacts by the angle of their normal from axis 3.
    stress : (3, 3) array or None
        sigma_ij of eq. (24) [Pa]; None without normal forces.
    stress_is_whole : bool
        Whether shear forces took part.
    sliding : float or None
        Share of the contacts that slide [-]; None without friction coefficient or forces.
    stiffness_source : str or None
        Where contact stiffnesses come from.
    mean_kn, mean_ks : float or None
        Means over the contacts [N/m].
    stiffer_where_longer : float or None
        <l^2 kn> over <l^2> <kn> [-]: what eq. (1) has, and no model with one kn for all branch lengths.
    raw : (3, 3, 3, 3) array or None
        C_ijkl of eq. (1) without any symmetrisation [Pa].
    kinematic : Stiffness or None
        Eq. (1), minor-symmetrised [Pa].
    static : Stiffness or None
        Eq. (5) and Figure 1(b), minor-symmetrised [Pa].
    no_kinematic, no_static : str
        Why there is none; empty where there is.
    stragglers : tuple or None
        How many branches are far longer than all others [-], the shortest of these and the longest of the others [m];
        None where there are none, or where radii tell that they reach.
    material : Material
        What was said of the grains.
    """

    name: str
    volume: float
    grains: int | None
    contacts: int
    dropped: int
    touching: int | None
    with_one: int | None
    normals: Array
    branches: Array
    balance: Array
    directions: FabricTensors
    lengths: Lengths
    length_moments: dict[str, float]
    by_angle: ByAngle
    stress: Array | None
    stress_is_whole: bool
    sliding: float | None
    stiffness_source: str | None
    mean_kn: float | None
    mean_ks: float | None
    stiffer_where_longer: float | None
    raw: Array | None
    kinematic: Stiffness | None
    static: Stiffness | None
    no_kinematic: str
    no_static: str
    stragglers: tuple[int, float, float] | None
    material: Material

    @property
    def contacts_per_volume(self) -> float:
        """M/V [1/m^3]."""
        return self.contacts / self.volume

    def doubt_of(self, directions: str) -> float:
        """Standard error of D33 of the normals or of the branches [-], as if contacts were drawn one by one."""
        moments = self.length_moments
        spread = moments[f"P2^2 of {directions}"] - moments[f"P2 of {directions}"] ** 2
        return 5 * math.sqrt(max(spread, 0.0) / self.contacts)

    @property
    def tests(self) -> tuple[SymmetryTest, ...]:
        """Whether the normals are anisotropic at all, and axially symmetric about axis 3; none for a short list."""
        from granular.fabric_tensors import significance

        try:
            return significance(self.directions, axis=(0.0, 0.0, 1.0)).tests
        except TooFewDirections:
            return ()

    @property
    def is_collinear(self) -> bool:
        """Whether branches follow the normals, as between spheres; the mean cosine of their angle decides."""
        return float(self.balance.trace()) / self.contacts_per_volume > COLLINEAR

    @property
    def coordination_number(self) -> float | None:
        """2 M over all grains [-]; None unless their number is given."""
        return None if self.grains is None else 2 * self.contacts / self.grains

    @property
    def coordination_without_rattlers(self) -> float | None:
        """(2 M - N1)/(N - N0 - N1) [-], N0 and N1 the grains with no contact and with one."""
        if self.touching is None or self.with_one is None or self.touching == self.with_one:
            return None
        return (2 * self.contacts - self.with_one) / (self.touching - self.with_one)

    @property
    def rattlers(self) -> int | None:
        """Grains with no contact or with one [-]; None unless the number of all grains is given."""
        if self.grains is None or self.touching is None or self.with_one is None:
            return None
        return self.grains - self.touching + self.with_one


def summarise(path: str | os.PathLike[str], *, volume: float, grains: int | None = None,
              columns: Mapping[str, str] | None = None, step: int | None = None, spheres_only: bool = False,
              drop_bad: bool = False, cell: Sequence[float] | None = None, material: Material | None = None,
              progress: Callable[[int], None] | None = None) -> ContactSummary:
    """Read a contact list once and tell what it holds.

    Parameters
    ----------
    path : str or path-like
        CSV or white-space text (both also with gzip), Parquet, or a dump of LAMMPS or LIGGGHTS.
    volume : float
        Volume of the sample that the contacts are in [m^3], > 0.
    grains : int, optional
        How many grains are in that volume, with those that touch nothing [-].
    columns : mapping, optional
        Native name -> name in the file.
    step : int, optional
        Time step of a dump [-]; the last one by default.
    spheres_only : bool
        Take missing normals along the branches.
    drop_bad : bool
        Leave out contacts with a number that is missing or not finite.
    cell : sequence of 3 float, optional
        Edges of a periodic cell [m], 0 where it has no period, for branches between centres that are both inside it.
    material : Material, optional
        Elasticity of the grains, for lists without stiffnesses; friction, to say which contacts slide.
    progress : callable, optional
        Called with the number of contacts read so far [-].

    Returns
    -------
    ContactSummary
        Numbers, fabric, lengths, forces, stress and stiffness.

    Raises
    ------
    ValueOutOfRange
        A volume that is not positive, or fewer grains than touch.
    GranularError
        As ``granular.contacts.contact_list.ContactList``.

    Notes
    -----
    Accuracy: sums to about 1e-14 of their largest component. Source: eqs (1), (2), (5), (14), (20), (21), (24).

    Examples
    --------
    >>> from granular.contacts.example import example_facts, example_path
    >>> packing = summarise(example_path(), volume=example_facts()["V"], grains=2000)
    >>> packing.contacts, packing.coordination_number, round(packing.kinematic.component("C3333") / 1e6, 1)
    (5753, 5.753, 627.9)
    """
    if not (volume > 0 and math.isfinite(volume)):
        raise ValueOutOfRange(f"volume = {volume!r}", allowed="allowed volume > 0",
                              remedy="Give the volume of the sample in m^3, grains and voids together.")
    if grains is not None and grains < 2:
        raise ValueOutOfRange(f"grains = {grains!r}", allowed="allowed 2 or more (two grains make a contact)",
                              remedy="Give the number of all grains in the volume, or leave it out.")
    material = Material() if material is None else material
    from granular.fabric_tensors import Moments as DirectionMoments

    contacts = ContactList(path, columns=columns, step=step, spheres_only=spheres_only, drop_bad=drop_bad,
                           cell=cell)
    moments, by_angle, lengths = Moments(material.friction), ByAngle(), Lengths()
    touching, numbered, source, directions = Touching(), True, None, DirectionMoments()
    for block in contacts.blocks():
        stiffness = (block.kn, block.ks) if block.kn is not None and block.ks is not None else material.stiffness(block)
        if stiffness is not None:
            source = FROM_LIST if stiffness[0] is block.kn else FROM_FORCES
        moments.add(block, stiffness)
        by_angle.add(block, stiffness)
        directions.add(block.normal.T, normalise=True)
        lengths.add(block.branch)
        if block.bodies is None:
            numbered = False
        else:
            touching.add(block.bodies)
        if progress is not None:
            progress(contacts.read)
    counts = (touching.with_any, touching.with_one) if numbered else (None, None)
    if grains is not None and counts[0] is not None and counts[0] > grains:
        raise ValueOutOfRange(f"grains = {grains}", allowed=f"allowed {counts[0]} or more, as many touch in "
                              f"{contacts.name}", remedy="Give the number of all grains, with those that touch "
                              "nothing; for clumps, that of the clumps, with their numbers in grain1 and grain2.")
    if grains is not None and counts[0] is not None:
        _refuse_too_small(volume, counts[0], moments.least_radius, contacts.name)
    return _summary(contacts, moments, by_angle, directions.fabric(), lengths, counts, volume, grains, source, material)


def _refuse_too_small(volume: float, grains: int, radius: float, file: str) -> None:
    """Refuse a volume that could not even hold the grains if all of them were as small as the smallest."""
    least = grains * 4 / 3 * math.pi * radius**3 if math.isfinite(radius) else 0.0
    if volume < least:
        raise ValueOutOfRange(f"volume = {volume:g}", allowed=f"allowed {least:.4g} m^3 or more, as {grains} spheres "
                              f"of the smallest radius in {file}, {radius:.4g} m, take that much",
                              remedy="Give the volume in m^3 and the list in m.")


def _summary(contacts: ContactList, moments: Moments, by_angle: ByAngle, directions: FabricTensors, lengths: Lengths,
             counts: tuple[int | None, int | None], volume: float, grains: int | None, source: str | None,
             material: Material) -> ContactSummary:
    size = moments.contacts
    raw = kinematic = static = None
    no_kinematic, no_static = "", ""
    balance = moments.mixed / volume
    if source is None:
        no_kinematic = no_static = NO_STIFFNESS
    else:
        raw = moments.kinematic.tensor() / volume
        kinematic = _stiffness(raw)
        static, no_static = _static(moments, balance, volume)
    return ContactSummary(
        name=contacts.name, volume=volume, grains=grains, contacts=size, dropped=contacts.dropped, touching=counts[0],
        with_one=counts[1], normals=symmetric(moments.normals) / size, branches=symmetric(moments.branches) / size,
        balance=balance, directions=directions, lengths=lengths,
        length_moments={name: total / size for name, total in moments.lengths.items()},
        by_angle=by_angle, stress=moments.stress / volume if moments.forces else None,
        stress_is_whole=moments.shears == size,
        sliding=moments.sliding / size if material.friction is not None and moments.shears else None,
        stiffness_source=source, mean_kn=moments.kn / size if source else None,
        mean_ks=moments.ks / size if source else None,
        stiffer_where_longer=size * moments.kn_l2 / (moments.lengths["l2"] * moments.kn) if moments.kn > 0 else None,
        raw=raw, kinematic=kinematic, static=static,
        no_kinematic=no_kinematic, no_static=no_static,
        stragglers=None if math.isfinite(moments.least_radius) else lengths.stragglers(), material=material)


def _stiffness(tensor: Array) -> Stiffness:
    from granular.elasticity import Stiffness
    from granular.routes.direction_sums import mandel_matrix, symmetrised

    return Stiffness.from_mandel(mandel_matrix(symmetrised(tensor)))


def _static(moments: Moments, balance: Array, volume: float) -> tuple[Stiffness | None, str]:
    """Invert the compliance of eq. (5), where there is one."""
    import numpy as np

    from granular.elasticity import Compliance
    from granular.routes.direction_sums import mandel_matrix, symmetrised

    if moments.flexible < moments.stiff:
        return None, (f"{moments.stiff - moments.flexible} contacts have no shear stiffness, so that the compliance is "
                      "infinite")
    if abs(np.linalg.det(balance)) <= 1e-12 * np.abs(balance).max() ** 3:
        return None, "the contacts do not span all directions, so that they cannot carry every stress"
    forces = np.linalg.inv(balance)  # f_j = sigma_pj forces_kp n_k / l
    compliance = np.einsum("kp,mq,kjml->pjql", forces, forces, moments.static.tensor()) / volume
    try:
        return Compliance.from_mandel(mandel_matrix(symmetrised(compliance))).stiffness(), ""
    except TensorNotInvertible:
        return None, "the compliance has no inverse"


