"""The columns of a contact list by name: which ones a file has, and the block that they make.

A list needs a branch vector (``l1 l2 l3``, or the two centres ``x1 y1 z1 x2 y2 z2`` whose difference it is) and a
contact normal (``n1 n2 n3``). Everything else adds to what can be told.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.contacts.block import ContactBlock
from granular.errors import BadOption, ContactColumnsMissing, ContactImpossible
from granular.units import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

GROUPS: dict[str, tuple[str, ...]] = {
    "spheres": ("id1", "id2"), "grains": ("grain1", "grain2"), "branch": ("l1", "l2", "l3"),
    "centres": ("x1", "y1", "z1", "x2", "y2", "z2"), "normal": ("n1", "n2", "n3"), "radii": ("R1", "R2"),
    "normal_force": ("fn",), "shear_force": ("fs1", "fs2", "fs3"), "force": ("f1", "f2", "f3"), "kn": ("kn",),
    "ks": ("ks",), "overlap": ("overlap",),
}
"""Native names of the columns that belong together: all of a group, or none. A force vector ``f1 f2 f3`` is that on the
second grain by the first, and stands for ``fn`` and ``fs1 fs2 fs3``."""

_STAND_INS = ("centres", "force")
"""Groups that stand for others; a file that has a part of one means something else by it."""

NATIVE = tuple(name for group in GROUPS.values() for name in group)
"""All native names."""

_AXES = {"1": "x", "2": "y", "3": "z"}
ALIASES = {name: f"{name[:-1]}{_AXES[name[-1]]}" for group in ("branch", "normal", "shear_force", "force")
           for name in GROUPS[group]}
"""Names with x, y, z in place of 1, 2, 3, which are known too."""


@dataclass(frozen=True, slots=True)
class Columns:
    """Which column of a file holds what.

    Attributes
    ----------
    names : dict
        Native name -> name in the file.
    spheres_only : bool
        Whether normals are taken along the branches.
    """

    names: dict[str, str]
    spheres_only: bool = False

    @property
    def wanted(self) -> tuple[str, ...]:
        """Names in the file, in the order of the rows that ``block`` takes."""
        return tuple(self.names.values())

    def block(self, rows: Array, whole_branch: Callable[[Array], Array] | None = None) -> ContactBlock:
        """Make a block of the columns of a file.

        Parameters
        ----------
        rows : (k, n) array
            The columns ``wanted``, one a row [SI].
        whole_branch : callable, optional
            What adds the period to branches that lack it.

        Returns
        -------
        ContactBlock
            Branches, normals, and what else there is.

        Raises
        ------
        ContactImpossible
            A body whose number is not whole.
        """
        import numpy as np

        at = {name: row for row, name in enumerate(self.names)}

        def group(name: str) -> Array | None:
            if any(member not in at for member in GROUPS[name]):
                return None
            first, size = at[GROUPS[name][0]], len(GROUPS[name])
            return rows[first] if size == 1 else rows[first:first + size]

        def whole(name: str) -> NDArray[np.int64] | None:
            found = group(name)
            if found is None:
                return None
            numbers = found.astype(np.int64)
            if (broken := (numbers != found).any(axis=0)).any():
                value = found[:, np.argmax(broken)]
                raise ContactImpossible(
                    f"{' '.join(self.names[member] for member in GROUPS[name])} = {value[0]:.10g} {value[1]:.10g}",
                    allowed="allowed whole numbers", remedy="Check which columns number the bodies.")
            return numbers

        branch, centres = group("branch"), group("centres")
        if branch is None:
            assert centres is not None  # columns_of has seen to that
            branch = centres[3:] - centres[:3]
        if whole_branch is not None:
            branch = whole_branch(branch)
        normal = group("normal")
        if normal is None:
            length = np.sqrt(np.sum(branch**2, axis=0))
            normal = branch / np.where(length > 0, length, 1.0)
        along, across = group("normal_force"), group("shear_force")
        if along is None and (force := group("force")) is not None:
            along = np.asarray(np.sum(force * normal, axis=0))
            across = force - along * normal
        return ContactBlock(branch=branch, normal=normal, spheres=whole("spheres"), grains=whole("grains"),
                            radii=group("radii"), normal_force=along, shear_force=across, kn=group("kn"),
                            ks=group("ks"), overlap=group("overlap"))


def columns_of(found: Sequence[str], mapping: Mapping[str, str], *, file: str, spheres_only: bool = False) -> Columns:
    """Find the columns of a file.

    Parameters
    ----------
    found : sequence of str
        Names in the file.
    mapping : mapping
        Native name -> name in the file, for columns that are named otherwise.
    file : str
        Name of the file, for messages.
    spheres_only : bool
        Take missing normals along the branches, which is right for spheres and wrong for everything else.

    Returns
    -------
    Columns
        Native name -> name in the file, groups that are whole.

    Raises
    ------
    ContactColumnsMissing
        A column is not there, a group is incomplete, or two columns have one name.
    BadOption
        The mapping names no native column.

    Notes
    -----
    Source: the native names are those of the command line's interface.

    Examples
    --------
    >>> columns_of(["l1", "l2", "l3", "nx", "ny", "nz"], {}, file="list.csv").names["n3"]
    'nz'
    """
    for native in mapping:
        if native not in NATIVE:
            near = difflib.get_close_matches(native, NATIVE, n=1)
            raise BadOption(f"--column {native}={mapping[native]}", allowed=f"allowed names: {', '.join(NATIVE)}",
                            remedy=f"Did you mean {near[0]}?" if near else "Write it like --column n1=nx.")
    names: dict[str, str] = {}
    for native in NATIVE:
        for name in [mapping[native]] if native in mapping else [native, ALIASES.get(native, native)]:
            if found.count(name) > 1:
                raise ContactColumnsMissing(f"{file} has {found.count(name)} columns named {shown(name)}",
                                            allowed="allowed one", remedy="Rename the one that is not meant.")
            if name in found:
                names[native] = name
                break
        else:
            if native in mapping:
                raise ContactColumnsMissing(f"{file} has no column {shown(mapping[native])}, which is to be {native}",
                                            allowed=f"found: {_listed(found)}", remedy="Name one of these.")
    return Columns(_whole_groups(names, found, file, spheres_only), spheres_only)


def _whole_groups(names: dict[str, str], found: Sequence[str], file: str, spheres_only: bool) -> dict[str, str]:
    """Refuse what is incomplete and what is not there at all; drop what something else makes needless."""
    kept: dict[str, str] = {}
    for group, members in GROUPS.items():
        missing = [name for name in members if name not in names]
        if missing and len(missing) < len(members) and group not in _STAND_INS:
            _refuse(missing, found, file)
        if not missing:
            kept.update({name: names[name] for name in members})
    if "l1" in kept or "x1" not in kept:
        kept = {name: column for name, column in kept.items() if name not in GROUPS["centres"]}
    needed = [name for name in (*GROUPS["branch"], *GROUPS["normal"]) if name not in kept]
    if "x1" in kept:
        needed = [name for name in needed if name not in GROUPS["branch"]]
    if spheres_only:
        needed = [name for name in needed if name not in GROUPS["normal"]]
    if needed:
        _refuse(needed, found, file)
    return kept


def _refuse(missing: Iterable[str], found: Sequence[str], file: str) -> None:
    missing = list(missing)
    along = (" For spheres, --spheres takes normals along the branches." if set(missing) == set(GROUPS["normal"])
             else "")
    raise ContactColumnsMissing(
        f"{file} has no column {' '.join(missing)}", allowed=f"found: {_listed(found)}",
        remedy=f"Say which column is which, like --column {missing[0]}=NAME.{along}")


def _listed(found: Sequence[str]) -> str:
    return ", ".join(shown(name) for name in found[:40]) + (" and more" if len(found) > 40 else "")
