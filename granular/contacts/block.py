"""A block of contacts: what a file gives at a time, as arrays with one column a contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import ArrayNotUsable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Ids = NDArray[np.int64]

_HEIGHTS = {"branch": 3, "normal": 3, "spheres": 2, "grains": 2, "radii": 2, "shear_force": 3}
"""How many rows an array has; the others have none but the contacts themselves."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactBlock:
    """Some contacts of a list; what the list does not give is None.

    Parameters
    ----------
    branch : (3, n) array
        l, from the centre of the first grain to that of the second [m].
    normal : (3, n) array
        n, unit vector across the contact, the same way as the branch [-].
    spheres : (2, n) array of int, optional
        Numbers of the two bodies that touch.
    grains : (2, n) array of int, optional
        Numbers of the grains that they belong to; those of the spheres where each is a grain.
    radii : (2, n) array, optional
        Radii of curvature at the contact [m].
    normal_force : (n,) array, optional
        fn [N], compression positive.
    shear_force : (3, n) array, optional
        fs [N], on the second grain by the first.
    kn, ks : (n,) array, optional
        Normal and shear stiffness [N/m].
    overlap : (n,) array, optional
        By how much the two bodies overlap [m].

    Raises
    ------
    ArrayNotUsable
        An array of another shape than that of the branches asks for.
    """

    branch: Array
    normal: Array
    spheres: Ids | None = None
    grains: Ids | None = None
    radii: Array | None = None
    normal_force: Array | None = None
    shear_force: Array | None = None
    kn: Array | None = None
    ks: Array | None = None
    overlap: Array | None = None

    def __post_init__(self) -> None:
        contacts = self.branch.shape[-1] if self.branch.ndim else 0
        for name in self.__slots__:
            array = getattr(self, name)
            wanted = (_HEIGHTS[name], contacts) if name in _HEIGHTS else (contacts,)
            if array is not None and array.shape != wanted:
                raise ArrayNotUsable(f"{name} has the shape {array.shape}", allowed=f"needed: {wanted}",
                                     remedy="Give one column for every contact.")

    @property
    def size(self) -> int:
        """Contacts in it [-]."""
        return int(self.branch.shape[1])

    @property
    def bodies(self) -> Ids | None:
        """Numbers of the two grains, or else of the two spheres."""
        return self.spheres if self.grains is None else self.grains

    @property
    def has_clumps(self) -> bool:
        """Whether some grain here is another body than the sphere that touches."""
        return self.grains is not None and self.spheres is not None and bool((self.grains != self.spheres).any())
