"""Contacts by the angle of their normal from axis 3: how many, how long, what they carry, how stiff they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.contacts.moments import NORMALS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.block import ContactBlock

    Array = NDArray[np.float64]

STEP = 5
"""Width of a class of angles [degrees]."""

CLASSES = 90 // STEP

QUANTITIES = ("x2", "length", "inverse_length", "normal_force", "shear_force", "meridian_force", "kn", "ks")
"""What is averaged in each class: cos^2 [-], l [m], 1/l [1/m], fn, the size of fs and its part along the
meridian towards axis 3 [N], kn and ks [N/m]."""


class ByAngle:
    """Sums in classes of five degrees from 0 to 90, n and -n being one contact.

    Attributes
    ----------
    contacts, branches : (18,) array
        Contacts in each class by the angle of their normal, and by that of their branch [-].
    """

    def __init__(self) -> None:
        """Begin without contacts."""
        import numpy as np

        self.contacts, self.branches = np.zeros(CLASSES), np.zeros(CLASSES)
        self._sums = {name: np.zeros((2, CLASSES)) for name in QUANTITIES}
        self._given: set[str] = set()

    def add(self, block: ContactBlock, stiffness: tuple[Array, Array] | None) -> None:
        """Take some more contacts.

        Parameters
        ----------
        block : ContactBlock
            The contacts.
        stiffness : pair of (n,) array, or None
            kn and ks of each [N/m].

        Notes
        -----
        Source: the angle of a line from an axis.
        """
        import numpy as np

        cosine, place = np.abs(block.normal[2]), _classes(block.normal)
        length = np.sqrt(np.sum(block.branch**2, axis=0))
        values: dict[str, Array | None] = {
            "x2": cosine**2, "length": length, "inverse_length": 1 / length, "normal_force": block.normal_force,
            "shear_force": None if block.shear_force is None else np.sqrt(np.sum(block.shear_force**2, axis=0)),
            "meridian_force": None if block.shear_force is None else _towards_axis(block.normal, block.shear_force),
            "kn": None if stiffness is None else stiffness[0], "ks": None if stiffness is None else stiffness[1]}
        self.contacts += np.bincount(place, minlength=CLASSES)
        self.branches += np.bincount(_classes(block.branch), minlength=CLASSES)
        for name, value in values.items():
            if value is not None:
                self._given.add(name)
                self._sums[name] += [np.bincount(place, power, CLASSES) for power in (value, value**2)]

    def merged(self, by: int) -> ByAngle:
        """The same in wider classes.

        Parameters
        ----------
        by : int
            How many classes become one [-], a divisor of 18.

        Returns
        -------
        ByAngle
            With 18/by classes.

        Notes
        -----
        Source: sums add.
        """
        wide = ByAngle()
        wide.contacts, wide.branches = (counts.reshape(-1, by).sum(axis=1) for counts in (self.contacts, self.branches))
        wide._sums = {name: sums.reshape(2, -1, by).sum(axis=2) for name, sums in self._sums.items()}
        wide._given = set(self._given)
        return wide

    @property
    def degrees(self) -> Array:
        """Edges of the classes [degrees], one more than there are classes."""
        import numpy as np

        return np.linspace(0.0, 90.0, self.contacts.size + 1)

    def mean(self, name: str) -> Array | None:
        """Mean of a quantity in each class.

        Parameters
        ----------
        name : str
            One of ``QUANTITIES``.

        Returns
        -------
        (k,) array or None
            Means [SI]; NaN in a class without contacts, None where the list does not give the quantity.

        Notes
        -----
        Source: the arithmetic mean.
        """
        import numpy as np

        if name not in self._given:
            return None
        with np.errstate(invalid="ignore"):
            found: Array = self._sums[name][0] / self.contacts
        return found

    def scatter(self, name: str) -> Array | None:
        """Standard deviation of a quantity in each class.

        Parameters
        ----------
        name : str
            One of ``QUANTITIES``.

        Returns
        -------
        (k,) array or None
            Standard deviations over the contacts of the class [SI]; as ``mean``.

        Notes
        -----
        Accuracy: 1e-8 of the mean, for squares are subtracted. Source: the second moment.
        """
        import numpy as np

        mean = self.mean(name)
        if mean is None:
            return None
        with np.errstate(invalid="ignore"):
            found: Array = np.sqrt(np.maximum(self._sums[name][1] / self.contacts - mean**2, 0.0))
        return found

    def counted(self, directions: str = NORMALS) -> Array:
        """Contacts in each class.

        Parameters
        ----------
        directions : str
            By the angle of their "normals" or "branches".

        Returns
        -------
        (k,) array
            How many [-].

        Notes
        -----
        Source: counting.
        """
        return self.contacts if directions == NORMALS else self.branches

    def relative_density(self, directions: str = NORMALS) -> Array:
        """Contacts of each class over those that an isotropic list of the same number would have.

        Parameters
        ----------
        directions : str
            By the angle of their "normals" or "branches".

        Returns
        -------
        (k,) array
            4 pi E averaged over the class [-].

        Notes
        -----
        Source: the share of the sphere between two angles, the difference of their cosines.
        """
        import numpy as np

        share = -np.diff(np.cos(np.radians(self.degrees)))
        counts = self.counted(directions)
        found: Array = counts / (counts.sum() * share)
        return found


def _classes(vectors: Array) -> NDArray[np.int64]:
    """The class of each vector by its angle from axis 3."""
    import numpy as np

    angle = np.degrees(np.arctan2(np.hypot(vectors[0], vectors[1]), np.abs(vectors[2])))
    found: NDArray[np.int64] = np.minimum((angle / STEP).astype(np.int64), CLASSES - 1)
    return found


def _towards_axis(normal: Array, shear: Array) -> Array:
    """The part of a shear force along the meridian, positive where it presses the grain beyond along axis 3."""
    import numpy as np

    meridian = np.array([[0.0], [0.0], [1.0]]) - normal * normal[2]
    sine = np.sqrt(np.sum(meridian**2, axis=0))
    along: Array = np.sign(normal[2]) * np.sum(meridian * shear, axis=0)
    return along / np.where(sine > 0, sine, 1.0)
