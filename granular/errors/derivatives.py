"""Slopes that cannot be computed, and fits that cannot be made."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class SlopeInfinite(GranularError):
    """Contacts are exactly at the onset of sliding, where the stiffness has an infinite slope."""

    code = "G-SLP-01"
    title = "An infinite slope"


class SlopesNotBuilt(GranularError):
    """A scene holds something by which slopes are not derived."""

    code = "G-SLP-02"
    title = "A scene without slopes"


class MeasurementsTooFew(GranularError):
    """A fit has more unknowns than measurements that say something about them."""

    code = "G-FIT-01"
    title = "Too few measurements"
