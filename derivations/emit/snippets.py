"""Print the functions of a derivation as pieces of Python to copy: each runs by itself and imports nothing but math."""

from __future__ import annotations

import re
from dataclasses import dataclass

from derivations.emit.module import (
    all_series,
    assignments,
    chain,
    chained_body,
    coefficient_table,
    end_to_end,
    end_to_end_operations,
    output_units,
)
from derivations.emit.scalar import POLYNOMIAL, scalar_function
from derivations.record import Derivation, Function, Output

MATHEMATICS = ("cbrt", "exp", "expm1", "gamma", "log1p", "pi", "sqrt")
"""Names of the standard library's mathematics that snippets may use."""

HYPERGEOMETRIC = '''\
def hyper(upper: tuple[float, float], lower: tuple[float], z: float) -> float:
    """Gauss's hypergeometric series for z < 1; for negative z after Pfaff's transformation."""
    (first, second), (third,) = upper, lower
    if z < 0:
        return hyper((first, third - second), lower, z/(z - 1))/(1 - z)**first
    total, term, n = 0.0, 1.0, 0
    while abs(term) > 1e-17*abs(total):
        total += term
        term *= (first + n)*(second + n)*z/((third + n)*(n + 1))
        n += 1
    return total
'''


@dataclass(frozen=True)
class Snippet:
    """A piece of code: the function that a reader calls, what it does, what it costs, and the text."""

    name: str
    summary: str
    operations: int
    code: str


def snippets(derivation: Derivation) -> tuple[Snippet, ...]:
    """Code of every emitted function, functions that follow one another in one piece, then outputs without any."""
    whole, linked = end_to_end(derivation), chain(derivation)[1]
    found = []
    if whole is not None:
        bodies = [*(_of(function, derivation) for function in linked),
                  scalar_function(whole, chained_body(derivation), end_to_end_operations(derivation),
                                  output_units(derivation))]
        found.append(Snippet(whole.name, whole.summary, end_to_end_operations(derivation),
                             _complete(bodies, derivation)))
    alone = [function for function in derivation.functions if function not in linked]
    return (*found, *(_snippet(function, derivation) for function in (*alone, *output_functions(derivation))))


def output_functions(derivation: Derivation) -> tuple[Function, ...]:
    """Functions for the outputs that no emitted function returns, from the same expressions as their formulas."""
    returned = {symbol.name for function in derivation.functions for symbol in function.returns}
    left = [output for output in derivation.outputs if output.name not in returned]
    groups: list[list[Output]] = []
    while left:
        widest = max(left, key=lambda output: len(output.expression.free_symbols)).expression.free_symbols
        groups.append([output for output in left if output.expression.free_symbols <= widest])
        left = [output for output in left if output not in groups[-1]]
    return tuple(_from_outputs(derivation, group) for group in groups)


def _from_outputs(derivation: Derivation, outputs: list[Output]) -> Function:
    free = set().union(*(output.expression.free_symbols for output in outputs))
    known = [symbol for symbol in derivation.inputs if symbol in free]
    others = sorted(free - set(known), key=lambda symbol: str(symbol.name))
    names = [output.name for output in outputs]
    return Function(
        "_".join(names) if len(names) < 3 else derivation.name, f"{derivation.title}: {', '.join(names)}.",
        (*known, *others), tuple((output.symbol, output.expression) for output in outputs),
        tuple(output.symbol for output in outputs))


def _snippet(function: Function, derivation: Derivation) -> Snippet:
    return Snippet(function.name, function.summary, function.operations(),
                   _complete([_of(function, derivation)], derivation))


def _of(function: Function, derivation: Derivation) -> str:
    return scalar_function(function, assignments(function), function.operations(), output_units(derivation))


def _complete(bodies: list[str], derivation: Derivation) -> str:
    """Put before functions what they need: imports, tables of coefficients, helpers."""
    code = "\n".join(re.sub(r'""".*?"""', "", body, flags=re.DOTALL) for body in bodies)
    tables = [coefficient_table(one) for one in all_series(derivation) if re.search(rf"\b{one.name}\b", code)]
    helpers = [*([POLYNOMIAL] if tables else []), *([HYPERGEOMETRIC] if re.search(r"\bhyper\(", code) else [])]
    called = [name for name in MATHEMATICS if re.search(rf"\b{name}\b(?! =)", code) and not _assigned(name, code)]
    imports = [f"from math import {', '.join(called)}\n"] if called else []
    return "\n\n".join(["\n".join([*imports, *tables]), *helpers, *bodies] if imports or tables
                       else [*helpers, *bodies]).rstrip("\n")


def _assigned(name: str, code: str) -> bool:
    """Whether a name is a result of the function, as Thomsen's gamma, and not the function of that name."""
    return re.search(rf"^    {name} = ", code, flags=re.MULTILINE) is not None

