"""What scalar and array modules share: docstrings, assignments, the function that runs a derivation from end to end."""

from __future__ import annotations

import re
from fractions import Fraction
from textwrap import fill

import sympy as sp

from derivations.emit.printer import python_source
from derivations.record import Derivation, Function
from derivations.series import TruncatedSeries
from derivations.symbols import GLOSSARY, POSITIVE_MOMENTS

WIDTH = 110


def output_units(derivation: Derivation) -> dict[sp.Symbol, str]:
    """Units of the outputs, for results that are not inputs elsewhere and so are not in the glossary."""
    return {output.symbol: output.unit for output in derivation.outputs}


def header(derivation: Derivation, kind: str) -> str:
    """Module docstring: what it holds, what made it, how to remake it."""
    sources = f"Source: {', '.join(derivation.sources)} of Pan & Dong (1999).\n" if derivation.sources else ""
    return (f'"""{derivation.title}: {kind}.\n\n'
            f"Emitted by ``derivations write`` from the derivation ``{derivation.name}``; do not edit.\n"
            f"{sources}Domain: {'; '.join(derivation.domain)}.\n"
            f"Operations: {sum(f.operations() for f in derivation.functions)}"
            f" ({operations_before(derivation)} in the outputs as derived{_moments_apart(derivation)}).\n"
            f'"""\n')


def _moments_apart(derivation: Derivation) -> str:
    """Say so when the outputs are counted with the moments as symbols, though the functions compute the moments."""
    computed = {symbol for function in derivation.functions for symbol in function.returns}
    free = {symbol for output in derivation.outputs for symbol in output.expression.free_symbols}
    return ", moments counted apart" if computed & free & set(POSITIVE_MOMENTS) else ""


def operations_before(derivation: Derivation) -> int:
    """Operations of the outputs as they are recorded, before any rearrangement."""
    return int(sum(sp.count_ops(output.expression) for output in derivation.outputs))


def docstring(function: Function, kind: str, operations: int, units: dict[sp.Symbol, str]) -> str:
    """Docstring of an emitted function, from the declarations of its symbols."""
    lines = [f'    """{function.summary}', ""]
    if function.notes:
        lines += [fill(function.notes, WIDTH, initial_indent="    ", subsequent_indent="    "), ""]
    lines += ["    Parameters", "    ----------", *_described(function.arguments, kind, units), "",
              "    Returns", "    -------", *_described(function.returns, kind, units, function.unit), "",
              f"    Operations: {operations}.", '    """']
    return "\n".join(lines)


def _described(symbols: tuple[sp.Symbol, ...], kind: str, units: dict[sp.Symbol, str],
               unit: str | None = None) -> list[str]:
    known = {quantity.symbol: quantity for quantity in GLOSSARY}
    lines = []
    for symbol in symbols:
        if symbol in known:
            quantity = known[symbol]
            meaning = quantity.meaning[:1].upper() + quantity.meaning[1:]
            lines.append(f"    {symbol.name} : {kind} [{unit or quantity.unit}]\n        {meaning}.")
        else:
            lines.append(f"    {symbol.name} : {kind} [{unit or units.get(symbol, '-')}]")
    return lines


def assignments(function: Function) -> str:
    """Body of a function: one assignment a line."""
    lines = [f"    {symbol.name} = {python_source(expression)}" for symbol, expression in function.assignments]
    results = ", ".join(symbol.name for symbol in function.returns)
    return "\n".join([*lines, f"    return {results}{',' if len(function.returns) == 1 else ''}"])


CALLED = ("cbrt", "exp", "expm1", "log1p", "sqrt")
"""Functions that math and NumPy know by the same name."""


def called_functions(bodies: list[str]) -> str:
    """Names of the functions that emitted code calls, for the import line; empty when there is none.

    Docstrings are left aside: they may speak of a function that the code goes without.
    """
    code = "".join(body.split('"""')[-1] for body in bodies)
    return ", ".join(name for name in CALLED if re.search(rf"\b{name}\(", code))


def all_series(derivation: Derivation) -> tuple[TruncatedSeries, ...]:
    """Every coefficient table that the functions need, once, in order."""
    found: dict[str, TruncatedSeries] = {}
    for function in derivation.functions:
        found.update({series.name: series for series in function.series})
    return tuple(found.values())


def coefficient_table(series: TruncatedSeries) -> str:
    """Coefficients correctly rounded to double precision, with what the cut leaves out."""
    rows = [f"    {correctly_rounded(c)}," for c in series.coefficients]
    return (f"# {len(series.coefficients)} terms for |{series.variable}| <= {series.limit}; "
            f"left out: {float(series.left_out):.0e} of the sum.\n"
            f"{series.name} = (\n" + "\n".join(rows) + "\n)\n")


def correctly_rounded(number: sp.Rational) -> str:
    """Shortest decimal of the double next to an exact rational."""
    return repr(float(Fraction(int(number.p), int(number.q))))


def chain(derivation: Derivation) -> tuple[tuple[sp.Symbol, ...], tuple[Function, ...]]:
    """Functions that follow one another, each asking for all that the one before returns, and their arguments.

    Empty when the first function already gives the outputs.
    """
    if not derivation.functions:
        return (), ()
    linked = [derivation.functions[0]]
    arguments = list(linked[0].arguments)
    for function in derivation.functions[1:]:
        if set(linked[-1].returns) <= set(function.arguments):
            arguments += [a for a in function.arguments if a not in (*linked[-1].returns, *arguments)]
            linked.append(function)
    return (tuple(arguments), tuple(linked)) if len(linked) > 1 else ((), ())


def chained_body(derivation: Derivation) -> str:
    """Body of the end-to-end function: each call fed with what the one before returned."""
    _, linked = chain(derivation)
    lines = []
    for function, following in zip(linked, (*linked[1:], None), strict=True):
        call = f"{function.name}({', '.join(a.name for a in function.arguments)})"
        lines.append(f"    return {call}" if following is None
                     else f"    {', '.join(r.name for r in function.returns)} = {call}")
    return "\n".join(lines)


def end_to_end(derivation: Derivation) -> Function | None:
    """Return the end-to-end function of a derivation, as a record without assignments of its own."""
    arguments, linked = chain(derivation)
    if not linked:
        return None
    return Function(derivation.name, f"{derivation.title}, from the fabric to the components.", arguments, (),
                    linked[-1].returns, notes=" ".join(f.notes for f in linked if f.notes), unit=linked[-1].unit)


def end_to_end_operations(derivation: Derivation) -> int:
    """Operations of the end-to-end function: the sum over the functions that it calls."""
    return sum(function.operations() for function in chain(derivation)[1])
