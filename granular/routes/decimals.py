"""Decimal arithmetic for the few numbers of a scene that every direction shares: rounded once, never on the way."""

from __future__ import annotations

from decimal import Context, Decimal
from fractions import Fraction

DIGITS = Context(prec=50)
"""Working precision; its exponents reach far beyond those of doubles, so that nothing overflows on the way."""


def decimal(value: Fraction) -> Decimal:
    """Turn a fraction into a decimal of the current context [-]."""
    return Decimal(value.numerator) / Decimal(value.denominator)
