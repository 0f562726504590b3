"""Forward differentiation of a list of assignments: one slope for each symbol and each variable, nothing expanded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

Assignments = tuple[tuple[sp.Symbol, sp.Expr], ...]
"""A calculation as an emitted function carries it out."""

Partials = Mapping[sp.Symbol, sp.Expr]
"""Derivatives of one symbol by symbols that it depends on."""

ZERO = sp.Integer(0)


def slope_symbol(symbol: sp.Symbol, variable: sp.Symbol) -> sp.Symbol:
    """Name of the derivative of a symbol by a variable, C1111_D33 say."""
    return sp.Symbol(f"{symbol.name}_{variable.name}", real=True)


def with_slopes(assignments: Assignments, variables: Sequence[sp.Symbol], *,
                slopes: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr] | None = None,
                partials: Mapping[sp.Symbol, Partials] | None = None) -> Assignments:
    """Differentiate a calculation, and return its assignments with those of the slopes among them.

    Parameters
    ----------
    assignments : tuple of (sympy.Symbol, sympy.Expr)
        The calculation.
    variables : sequence of sympy.Symbol
        What to differentiate by.
    slopes : mapping, optional
        (symbol, variable) -> slope, for symbols that are arguments and depend on the variables.
    partials : mapping, optional
        Symbol -> its derivatives by the symbols that it depends on, in place of those of its expression: where a
        derivative is known in a form that keeps more digits.

    Returns
    -------
    tuple of (sympy.Symbol, sympy.Expr)
        A slope that is zero has no assignment; :func:`slope_of` tells which.
    """
    known: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr] = {(v, v): sp.Integer(1) for v in variables}
    known.update(slopes or {})
    result: list[tuple[sp.Symbol, sp.Expr]] = []
    for symbol, expression in assignments:
        result.append((symbol, expression))
        by = (partials or {}).get(symbol) or {
            free: sp.diff(expression, free) for free in sorted(expression.free_symbols, key=lambda one: str(one.name))}
        for variable in variables:
            total = sum((_times(derivative, known[free, variable]) for free, derivative in by.items()
                         if (free, variable) in known), ZERO)
            if total == 0:
                continue
            if total.is_Symbol or total.is_number:
                known[symbol, variable] = total
                continue
            name = slope_symbol(symbol, variable)
            result.append((name, total))
            known[symbol, variable] = name
    return tuple(result)


def _times(derivative: sp.Expr, slope: sp.Expr) -> sp.Expr:
    """A product in which no fraction stands alone as a summand, so that exact input gives exact output."""
    terms = sp.Add.make_args(derivative)
    if any(term.is_Rational and not term.is_Integer for term in terms):
        return sp.Add(*(term * slope for term in terms))
    return derivative * slope


def slope_of(assignments: Assignments, symbol: sp.Symbol, variable: sp.Symbol) -> sp.Symbol:
    """Return the symbol that holds a slope.

    Raises
    ------
    KeyError
        The slope is zero, or another symbol.
    """
    name = slope_symbol(symbol, variable)
    if all(assigned != name for assigned, _ in assignments):
        raise KeyError(f"{symbol} has no slope by {variable} of its own")
    return name
