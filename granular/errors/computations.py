"""What cannot be computed, or not to the accuracy that is wanted."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class ComplianceInfinite(GranularError):
    """Contacts slide or have opened in some directions, so that the static compliance is infinite."""

    code = "G-STA-01"
    title = "An infinite compliance"


class RouteOutOfDomain(GranularError):
    """A route was named that does not cover the scene, or cannot keep the wanted accuracy."""

    code = "G-RTE-01"
    title = "A route outside its domain"


class CertifiedArithmeticMissing(GranularError):
    """The route in ball arithmetic was named, and the library that does it is not installed."""

    code = "G-RTE-02"
    title = "Ball arithmetic is not installed"


class ArrayNotUsable(GranularError):
    """An array argument that is not numeric, or whose shape does not broadcast with the others."""

    code = "G-ARR-01"
    title = "An array argument that cannot be used"


class NotFinite(GranularError):
    """A number that is NaN, infinite, or too large for double precision."""

    code = "G-NUM-01"
    title = "A number that is not finite"


class ResultOutOfRange(GranularError):
    """A result that double precision cannot hold with all its digits."""

    code = "G-NUM-02"
    title = "A result outside double precision"
