"""Stiffness and compliance as two types, Mandel matrices inside and named Voigt orders at the edge."""

from __future__ import annotations

from typing import ClassVar

from granular.elastic_tensor import ElasticTensor
from granular.notation import mandel_factor


class Stiffness(ElasticTensor):
    """Stress per strain [Pa]; a frozen 6x6 Mandel matrix with named ways in and out.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(C1111=9.0, C3333=7.0, C1122=3.0, C1133=2.0,
    ...                                         C2323=2.5, C1212=3.0)
    >>> sand.C2323, sand.component("C3232"), sand.is_positive_definite()
    (2.5, 2.5, True)
    >>> float(sand.voigt("standard")[3, 3]), float(sand.voigt("paper")[3, 3])
    (2.5, 3.0)
    >>> Stiffness.from_voigt(sand.voigt("paper"), order="paper") == sand
    True
    >>> sand.compliance().S2323
    0.1
    """

    __slots__ = ()
    symbol: ClassVar[str] = "C"
    meaning: ClassVar[str] = "stiffness"

    @classmethod
    def transversely_isotropic(cls, C1111: float, C3333: float, C1122: float, C1133: float, C2323: float,
                               C1212: float) -> Stiffness:
        """Build from the six components of a solid that is transversely isotropic about axis 3.

        Parameters
        ----------
        C1111, C3333, C1122, C1133, C2323, C1212 : float
            Tensor components [Pa]; C1212 = (C1111 - C1122)/2 to rounding.

        Returns
        -------
        Stiffness
            The checked tensor [Pa].

        Raises
        ------
        TensorNotElastic
            A value that is not a finite number, or a C1212 that contradicts C1111 and C1122.

        Notes
        -----
        Source: invariance of C_ijkl under rotation about axis 3.
        """
        return cls._checked_six((C1111, C3333, C1122, C1133, C2323, C1212))

    @property
    def C1111(self) -> float:
        """Horizontal normal stiffness [Pa]."""
        return self.component("C1111")

    @property
    def C3333(self) -> float:
        """Vertical normal stiffness, along axis 3 [Pa]."""
        return self.component("C3333")

    @property
    def C1122(self) -> float:
        """Coupling of the two horizontal directions [Pa]."""
        return self.component("C1122")

    @property
    def C1133(self) -> float:
        """Coupling of the vertical with a horizontal direction [Pa]."""
        return self.component("C1133")

    @property
    def C2323(self) -> float:
        """Shear in a vertical plane [Pa]; C44 in the standard Voigt order, C66 in the paper's."""
        return self.component("C2323")

    @property
    def C1212(self) -> float:
        """Shear in the horizontal plane [Pa]; C66 in the standard Voigt order, C44 in the paper's."""
        return self.component("C1212")

    def compliance(self) -> Compliance:
        """Invert.

        Returns
        -------
        Compliance
            Strain per stress [1/Pa].

        Raises
        ------
        TensorNotInvertible
            The stiffness is singular.

        Notes
        -----
        Accuracy: for a tensor built from six components, the exact inverse of the six, rounded once;
        otherwise the condition number times 1e-16.
        Source: ``granular.mandel.axial_inverse``.
        """
        return Compliance(self._inverse_rows())

    @classmethod
    def _voigt_factor(cls, row: int, column: int) -> float:
        return 1 / mandel_factor(row, column)


class Compliance(ElasticTensor):
    """Strain per stress [1/Pa]; a frozen 6x6 Mandel matrix with named ways in and out.

    A Voigt compliance is not the matrix of its tensor components: with engineering shear strains its
    shear rows and columns carry a factor 2 each, so that S44 = 4 S2323 in the standard order.

    Examples
    --------
    >>> sand = Compliance.transversely_isotropic(S1111=9.0, S3333=7.0, S1122=3.0, S1133=2.0,
    ...                                          S2323=2.5, S1212=3.0)
    >>> sand.S2323, float(sand.voigt("standard")[3, 3]), float(sand.voigt("paper")[3, 3])
    (2.5, 10.0, 12.0)
    """

    __slots__ = ()
    symbol: ClassVar[str] = "S"
    meaning: ClassVar[str] = "compliance"

    @classmethod
    def transversely_isotropic(cls, S1111: float, S3333: float, S1122: float, S1133: float, S2323: float,
                               S1212: float) -> Compliance:
        """Build from the six components of a solid that is transversely isotropic about axis 3.

        Parameters
        ----------
        S1111, S3333, S1122, S1133, S2323, S1212 : float
            Tensor components [1/Pa], without Voigt factors; S1212 = (S1111 - S1122)/2 to rounding.

        Returns
        -------
        Compliance
            The checked tensor [1/Pa].

        Raises
        ------
        TensorNotElastic
            A value that is not a finite number, or an S1212 that contradicts S1111 and S1122.

        Notes
        -----
        Source: invariance of S_ijkl under rotation about axis 3.
        """
        return cls._checked_six((S1111, S3333, S1122, S1133, S2323, S1212))

    @property
    def S1111(self) -> float:
        """Horizontal strain under horizontal stress [1/Pa]."""
        return self.component("S1111")

    @property
    def S3333(self) -> float:
        """Vertical strain under vertical stress [1/Pa]."""
        return self.component("S3333")

    @property
    def S1122(self) -> float:
        """Horizontal strain under the other horizontal stress [1/Pa]."""
        return self.component("S1122")

    @property
    def S1133(self) -> float:
        """Horizontal strain under vertical stress [1/Pa]."""
        return self.component("S1133")

    @property
    def S2323(self) -> float:
        """Tensor shear strain in a vertical plane [1/Pa]; 1/(4 C2323)."""
        return self.component("S2323")

    @property
    def S1212(self) -> float:
        """Tensor shear strain in the horizontal plane [1/Pa]; 1/(4 C1212)."""
        return self.component("S1212")

    def stiffness(self) -> Stiffness:
        """Invert.

        Returns
        -------
        Stiffness
            Stress per strain [Pa].

        Raises
        ------
        TensorNotInvertible
            The compliance is singular.

        Notes
        -----
        Accuracy: for a tensor built from six components, the exact inverse of the six, rounded once;
        otherwise the condition number times 1e-16.
        Source: ``granular.mandel.axial_inverse``.
        """
        return Stiffness(self._inverse_rows())

    @classmethod
    def _voigt_factor(cls, row: int, column: int) -> float:
        return mandel_factor(row, column)
