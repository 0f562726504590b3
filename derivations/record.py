"""What a derivation is: inputs, outputs, steps that can be shown and checked, assumptions, sources, domain."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from derivations.series import TruncatedSeries
from derivations.symbols import latex


@dataclass(frozen=True)
class Claim:
    """An equality that a step states: two expressions, sets or matrices that must agree identically."""

    left: sp.Basic
    right: sp.Basic

    def residual(self) -> sp.Basic:
        """Return ``left - right`` simplified; zero (or an empty set) when the claim holds."""
        if isinstance(self.left, sp.Set):
            return sp.SymmetricDifference(self.left, self.right)
        difference = sp.expand(self.left - self.right)
        return difference if difference == 0 else sp.simplify(sp.radsimp(difference))

    def holds(self) -> bool:
        """Whether both sides agree identically."""
        return self.residual() in (0, sp.S.EmptySet)


@dataclass(frozen=True)
class Step:
    """One step: what is done, why it follows, what it gives, and the equalities that a machine can check.

    Attributes
    ----------
    title : str
        What the step does.
    because : str
        Why it follows from the step before, in one or two sentences.
    shown : tuple of str
        LaTeX of what it gives, one formula each.
    claims : tuple of Claim
        Equalities behind the formulas.
    result : bool
        Whether the formulas are results that belong on the formula sheet.
    """

    title: str
    because: str
    shown: tuple[str, ...] = ()
    claims: tuple[Claim, ...] = ()
    result: bool = False

    def holds(self) -> bool:
        """Whether every claim of the step holds."""
        return all(claim.holds() for claim in self.claims)


@dataclass(frozen=True)
class Output:
    """One result: the symbol that it defines, its closed form, its unit."""

    symbol: sp.Symbol
    expression: sp.Expr
    unit: str = "-"

    @property
    def name(self) -> str:
        """Name of the result in emitted code."""
        return str(self.symbol.name)

    def latex(self) -> str:
        """Return the result as a formula."""
        return f"{latex(self.symbol)} = {latex(self.expression)}"


@dataclass(frozen=True)
class Function:
    """One function to emit: its arguments, the assignments in order, what it returns.

    The assignments are written by hand so that no digit is lost by a subtraction; :meth:`substituted` puts them
    back together, and a test holds the result against the outputs of the derivation. ``unit`` is the unit of what
    is returned when it differs from that of the symbols, as for normalised components.
    """

    name: str
    summary: str
    arguments: tuple[sp.Symbol, ...]
    assignments: tuple[tuple[sp.Symbol, sp.Expr], ...]
    returns: tuple[sp.Symbol, ...]
    notes: str = ""
    series: tuple[TruncatedSeries, ...] = ()
    unit: str | None = None

    def substituted(self) -> dict[sp.Symbol, sp.Expr]:
        """Return every returned symbol as an expression of the arguments alone."""
        known: dict[sp.Symbol, sp.Expr] = {}
        for symbol, expression in self.assignments:
            known[symbol] = expression.xreplace(known)
        return {symbol: known[symbol] for symbol in self.returns}

    def operations(self) -> int:
        """Count the arithmetic operations of one call; numbers that are given names cost nothing."""
        arithmetic = sum(sp.count_ops(expression) for _, expression in self.assignments if not expression.is_number)
        return int(arithmetic + sum(2 * (len(series.coefficients) - 1) for series in self.series))


@dataclass(frozen=True)
class BatchFunction:
    """A function that is emitted for very many elements at once: as a loop to compile and for blocks by NumPy.

    Attributes
    ----------
    function : Function
        What is computed for one element. Its polynomials are called with a single symbol.
    serves : tuple of relation
        Where it may be used, all of them to hold; in arguments and assigned symbols.
    gate : sympy.Symbol
        An assigned symbol that is a factor of every result: it becomes NaN where the function does not serve.
    passes : tuple of sympy.Symbol
        Assigned symbols after which the loop goes over a few hundred elements before the next assignment: a processor
        works on several elements at once only if what it does to one is short.
    apart : bool
        Whether a result of all elements is followed by the next one, in place of all results of one element.
    tested : tuple of relation
        What is tested where ``serves`` can be told with fewer operations; empty where it cannot.
    """

    function: Function
    serves: tuple[sp.Rel, ...]
    gate: sp.Symbol
    passes: tuple[sp.Symbol, ...] = ()
    apart: bool = False
    tested: tuple[sp.Rel, ...] = ()


@dataclass(frozen=True)
class Derivation:
    """A derivation from its inputs to its outputs.

    Attributes
    ----------
    name, title : str
        Identifier and heading.
    sources : tuple of str
        Equations of Pan & Dong (1999) that it starts from or reaches.
    assumptions : tuple of str
        What is assumed, one sentence each.
    domain : tuple of str
        Where the outputs hold.
    inputs : tuple of sympy.Symbol
        Symbols that the outputs depend on.
    outputs : tuple of Output
        Results.
    steps : tuple of Step
        The way from inputs to outputs.
    functions : tuple of Function
        What is emitted, in order; a later one may use the names that an earlier one returns.
    batch : tuple of BatchFunction
        What is emitted for very many elements.
    """

    name: str
    title: str
    sources: tuple[str, ...]
    assumptions: tuple[str, ...]
    domain: tuple[str, ...]
    inputs: tuple[sp.Symbol, ...]
    outputs: tuple[Output, ...]
    steps: tuple[Step, ...]
    functions: tuple[Function, ...] = field(default=())
    batch: tuple[BatchFunction, ...] = field(default=())

    def output(self, name: str) -> Output:
        """Return one output by name.

        Raises
        ------
        KeyError
            There is no output of that name; the message lists those there are.
        """
        for output in self.outputs:
            if output.name == name:
                return output
        raise KeyError(f"{self.name} has no output {name!r}; it has {', '.join(o.name for o in self.outputs)}")
