"""What stiffness and compliance have in common: a checked Mandel matrix and its other notations."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Self

from granular.errors import TensorNotElastic
from granular.mandel import (
    ROUNDING,
    Matrix,
    Rows,
    axial_inverse,
    axial_is_positive,
    axial_rows,
    built_from_six,
    general_inverse,
    is_axial,
    number,
    six_of,
    symmetric_rows,
    turned,
)
from granular.notation import MANDEL_PAIRS, Order, component_place, mandel_factor, row_of, voigt_rows

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

SIX = ("1111", "3333", "1122", "1133", "2323", "1212")
"""Indices of the components of a transversely isotropic tensor about axis 3, in their fixed order."""


@dataclass(frozen=True, slots=True, repr=False)
class ElasticTensor(ABC):
    """What stiffness and compliance have in common; use one of the two.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Symmetric Mandel matrix, rows in the order 11 22 33 23 13 12.

    Raises
    ------
    TensorNotElastic
        A wrong shape, a value that is not a finite number, or a matrix that is not symmetric.

    Notes
    -----
    Source: Mandel's notation; see ``granular.notation``.
    """

    rows: Rows

    symbol: ClassVar[str] = "X"
    meaning: ClassVar[str] = "tensor"

    def __post_init__(self) -> None:
        """Check the matrix and make it exactly symmetric."""
        object.__setattr__(self, "rows", symmetric_rows(self.rows, self.meaning))

    @classmethod
    def from_mandel(cls, matrix: Matrix) -> Self:
        """Build from a Mandel matrix in the order 11 22 33 23 13 12.

        Parameters
        ----------
        matrix : (6, 6) numbers
            Stiffness [Pa] or compliance [1/Pa]; shear rows and columns carry sqrt(2) each.

        Returns
        -------
        Stiffness or Compliance
            The checked tensor; differences across the diagonal within rounding are averaged away.

        Raises
        ------
        TensorNotElastic
            A wrong shape, a value that is not a finite number, or a matrix that is not symmetric.

        Notes
        -----
        Source: Mandel's notation; see ``granular.notation``.
        """
        return cls(symmetric_rows(matrix, cls.meaning))

    @classmethod
    def from_voigt(cls, matrix: Matrix, *, order: Order = "standard") -> Self:
        """Build from a Voigt matrix (engineering shear strains) in a named index order.

        Parameters
        ----------
        matrix : (6, 6) numbers
            Stiffness [Pa] or compliance [1/Pa]; a compliance carries its usual factors 2 and 4.
        order : "standard" or "paper"
            Order of the index pairs, see ``granular.notation``.

        Returns
        -------
        Stiffness or Compliance
            The checked tensor.

        Raises
        ------
        IndexNotKnown
            An unknown order.
        TensorNotElastic
            A wrong shape, a value that is not a finite number, or a matrix that is not symmetric.

        Notes
        -----
        Source: the paper's order stands under PARAMETRIC STUDY OF MICROFEATURES.
        """
        place = {row: m for m, row in enumerate(voigt_rows(order))}
        given = symmetric_rows(matrix, cls.meaning)
        return cls.from_mandel([[given[place[p]][place[q]] / cls._voigt_factor(p, q) for q in range(6)]
                                for p in range(6)])

    @classmethod
    def from_tensor(cls, tensor: ArrayLike) -> Self:
        """Build from all 81 components.

        Parameters
        ----------
        tensor : (3, 3, 3, 3) array
            Stiffness [Pa] or compliance [1/Pa] with minor and major symmetry.

        Returns
        -------
        Stiffness or Compliance
            The checked tensor.

        Raises
        ------
        TensorNotElastic
            A wrong shape, a value that is not a finite number, or a missing symmetry. A sum over contacts
            whose branches and normals differ has no minor symmetry: symmetrise it first, knowingly.

        Notes
        -----
        Source: symmetry of stress and strain (minor) and a stored energy (major).
        """
        import numpy as np

        full = np.asarray(tensor, dtype=float)
        if full.shape != (3, 3, 3, 3):
            raise TensorNotElastic(f"{cls.meaning} of shape {full.shape}", allowed="needed: (3, 3, 3, 3)",
                                   remedy="Give all 81 components X[i, j, k, l].")
        slack = ROUNDING * np.abs(full).max()
        for axes in ((1, 0, 2, 3), (0, 1, 3, 2)):
            if np.abs(full - full.transpose(axes)).max() > slack:
                raise TensorNotElastic(f"{cls.meaning} that changes when two indices of a pair are swapped",
                                       allowed="needed: X_ijkl = X_jikl = X_ijlk to rounding",
                                       remedy="Average over ij and ji and over kl and lk first.")
        return cls.from_mandel([[full[i - 1, j - 1, k - 1, m - 1] * mandel_factor(row, column)
                                 for column, (k, m) in enumerate(MANDEL_PAIRS)]
                                for row, (i, j) in enumerate(MANDEL_PAIRS)])

    @property
    def components(self) -> dict[str, float]:
        """The six components by name [Pa] or [1/Pa]; refused unless transversely isotropic."""
        if not self.is_transversely_isotropic():
            raise TensorNotElastic(f"{self.meaning} without transverse isotropy about axis 3",
                                   allowed="six components describe only a transversely isotropic one",
                                   remedy="Use mandel(), voigt() or component().")
        return {self.symbol + name: value for name, value in zip(SIX, six_of(self.rows), strict=True)}

    def component(self, name: str) -> float:
        """One component by its four tensor indices.

        Parameters
        ----------
        name : str
            ``"C2323"`` of a stiffness, ``"S2323"`` of a compliance; any of the 81.

        Returns
        -------
        float
            The component [Pa] or [1/Pa].

        Raises
        ------
        IndexNotKnown
            Any other name; C44 and its like mean different things in different orders.

        Notes
        -----
        Source: minor and major symmetry.
        """
        row, column = component_place(name, self.symbol)
        return self.rows[row][column] / mandel_factor(row, column)

    def is_transversely_isotropic(self) -> bool:
        """Tell whether axis 3 is an axis of full rotational symmetry, to rounding.

        Returns
        -------
        bool
            True when all 36 entries follow from six to 2^-40 of the largest.

        Notes
        -----
        Source: invariance under rotation about axis 3.
        """
        return is_axial(self.rows)

    def is_positive_definite(self) -> bool:
        """Tell whether every deformation stores energy.

        Returns
        -------
        bool
            Decided exactly, by its inequalities, for a tensor built from six components; otherwise by
            eigenvalues, of which the least must exceed 6 units of rounding of the greatest.

        Notes
        -----
        Source: for transverse isotropy C2323 > 0, C1212 > 0, C3333 > 0, (C1111 + C1122) C3333 > 2 C1133^2.
        """
        if built_from_six(self.rows):
            return axial_is_positive(six_of(self.rows))
        import numpy as np

        energies = np.linalg.eigvalsh(self.mandel())
        return bool(energies[0] > 6 * np.finfo(float).eps * energies[-1])

    def mandel(self) -> NDArray[np.float64]:
        """Mandel matrix in the order 11 22 33 23 13 12.

        Returns
        -------
        (6, 6) array
            Stiffness [Pa] or compliance [1/Pa]; a fresh array each time.

        Notes
        -----
        Source: Mandel's notation; see ``granular.notation``.
        """
        import numpy as np

        return np.array(self.rows)

    def voigt(self, order: Order = "standard") -> NDArray[np.float64]:
        """Voigt matrix (engineering shear strains) in a named index order.

        Parameters
        ----------
        order : "standard" or "paper"
            Order of the index pairs, see ``granular.notation``.

        Returns
        -------
        (6, 6) array
            Stiffness [Pa], or compliance [1/Pa] with its factors 2 and 4.

        Raises
        ------
        IndexNotKnown
            An unknown order.

        Notes
        -----
        Source: the paper's order stands under PARAMETRIC STUDY OF MICROFEATURES.
        """
        import numpy as np

        rows = voigt_rows(order)
        return np.array([[self.rows[p][q] * self._voigt_factor(p, q) for q in rows] for p in rows])

    def tensor(self) -> NDArray[np.float64]:
        """All 81 components.

        Returns
        -------
        (3, 3, 3, 3) array
            ``X[i, j, k, l]`` [Pa] or [1/Pa], indices from 0.

        Notes
        -----
        Source: minor and major symmetry.
        """
        import numpy as np

        plain = np.array([[value / mandel_factor(p, q) for q, value in enumerate(row)]
                          for p, row in enumerate(self.rows)])
        pair = np.array([[row_of(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)])
        full: NDArray[np.float64] = plain[pair[:, :, None, None], pair[None, None, :, :]]
        return full

    def rotated(self, rotation: ArrayLike) -> Self:
        """Turn the solid: a direction n of it becomes R n.

        Parameters
        ----------
        rotation : (3, 3) array
            Orthogonal matrix R [-].

        Returns
        -------
        Stiffness or Compliance
            X'_ijkl = R_ia R_jb R_kc R_ld X_abcd [Pa] or [1/Pa].

        Raises
        ------
        DirectionNotValid
            R is not a 3x3 orthogonal matrix.

        Notes
        -----
        Source: ``granular.mandel.turned``.
        """
        return type(self)(turned(self.rows, rotation, self.meaning))

    def scaled(self, factor: float) -> Self:
        """Multiply every component, for instance by a reference stiffness.

        Parameters
        ----------
        factor : float
            Any finite number [-] or [Pa].

        Returns
        -------
        Stiffness or Compliance
            The multiple.

        Raises
        ------
        TensorNotElastic
            A component would not be finite.

        Notes
        -----
        Source: linearity.
        """
        return self.from_mandel([[value * factor for value in row] for row in self.rows])

    def __repr__(self) -> str:
        """Show the six numbers of a transversely isotropic tensor, or else the whole Mandel matrix."""
        if built_from_six(self.rows):
            six = ", ".join(f"{name}={value!r}" for name, value in self.components.items())
            return f"{type(self).__name__}.transversely_isotropic({six})"
        return f"{type(self).__name__}.from_mandel({self.rows!r})"

    @classmethod
    @abstractmethod
    def _voigt_factor(cls, row: int, column: int) -> float:
        """What a Mandel entry is multiplied by to stand in the Voigt matrix of this kind of tensor."""

    @classmethod
    def _checked_six(cls, values: Iterable[float]) -> Self:
        """Build from six components after checking the one that two others fix."""
        x1111, x3333, x1122, x1133, x2323, x1212 = (
            number(value, cls.symbol + name) for name, value in zip(SIX, values, strict=True))
        rows = axial_rows((x1111, x3333, x1122, x1133, x2323, x1212))
        if not is_axial(rows):
            half = f"({cls.symbol}1111 - {cls.symbol}1122)/2"
            raise TensorNotElastic(f"{cls.symbol}1212 = {x1212!r} beside {half} = {(x1111 - x1122) / 2!r}",
                                   allowed="the two are equal in a transversely isotropic solid",
                                   remedy=f"Give {cls.symbol}1212 = {half}, or use from_mandel.")
        return cls(rows)

    def _inverse_rows(self) -> Rows:
        if built_from_six(self.rows):
            return axial_rows(axial_inverse(six_of(self.rows), self.meaning))
        return general_inverse(self.rows, self.meaning)
