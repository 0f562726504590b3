"""Print functions for very many elements: a loop that a compiler can turn into vector code, and blocks for NumPy.

Both forms hold the same operations in the same order, so that both give the same bits: Horner's rule for polynomials,
coefficients as correctly rounded decimals, no operation that a library may round in its own way.
"""

from __future__ import annotations

from itertools import groupby
from textwrap import fill

import sympy as sp

from derivations.emit.module import WIDTH, all_series, correctly_rounded, docstring, header
from derivations.emit.printer import python_source
from derivations.record import BatchFunction, Derivation
from derivations.series import TruncatedSeries

Assignment = tuple[sp.Symbol, sp.Expr]

IMPORTS = """\
from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
"""

POLYNOMIALS = '''\
def polynomials(table: Array, v: Array) -> Array:
    """Evaluate polynomials by Horner's rule for every element at once, a row of the result for each.

    Parameters
    ----------
    table : (terms, rows) array [-]
        Coefficients, highest power first.
    v : (n,) array [-]
        Variable.

    Returns
    -------
    total : (rows, n) array [-]
        Values.
    """
    total = np.zeros((table.shape[1], v.size))
    for coefficients in table:
        total *= v
        total += coefficients[:, np.newaxis]
    return total
'''

RELATIONS = {sp.StrictGreaterThan: ">", sp.GreaterThan: ">=", sp.StrictLessThan: "<", sp.LessThan: "<="}


def loop_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_loop.py``."""
    return "\n".join([header(derivation, "a loop over elements, to be compiled"), IMPORTS, "",
                      "\n\n".join(_loop(one, _tables(derivation)) for one in derivation.batch)])


def block_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_block.py``."""
    groups = {_table_name(group): group for one in derivation.batch for group in _polynomial_groups(one)}
    parts = [header(derivation, "blocks of elements at once"), IMPORTS]
    parts += [_table(name, [_tables(derivation)[_called(e)] for _, e in group]) for name, group in groups.items()]
    return "\n".join(parts) + "\n\n" + "\n\n".join(
        [*([POLYNOMIALS] if groups else []), *(_block(one) for one in derivation.batch)])


def _tables(derivation: Derivation) -> dict[str, TruncatedSeries]:
    return {series.name: series for one in derivation.batch for series in one.function.series} | {
        series.name: series for series in all_series(derivation)}


def _signature(one: BatchFunction) -> str:
    arguments = ", ".join(f"{a.name}: Array" for a in one.function.arguments)
    return f"def {one.function.name}({arguments}, out: Array) -> int:"


def _docstring(one: BatchFunction) -> str:
    described = docstring(one.function, "(n,) array", one.function.operations(), {})
    before = described.split("    Returns\n")[0].rstrip()
    names = ", ".join(result.name for result in one.function.returns)
    count = len(one.function.returns)
    places = fill(f"{names} of each element in turn, NaN for those that are not served.", WIDTH,
                  initial_indent=" " * 8, subsequent_indent=" " * 8)
    return (f"{before}\n    out : ({count} n,) array [-]\n{places}\n\n    Returns\n    -------\n"
            "    unserved : int\n        How many elements are not served.\n\n"
            f'    Operations: {one.function.operations()}.\n    """')


def _served(one: BatchFunction) -> str:
    return " & ".join(f"({python_source(r.lhs)} {RELATIONS[r.func]} {_number(r.rhs)})" for r in one.serves)


def _number(expression: sp.Expr) -> str:
    return correctly_rounded(expression) if expression.is_Rational else python_source(expression)


def _is_polynomial(expression: sp.Expr) -> bool:
    return bool(expression.func.__name__ == "polynomial")


def _called(expression: sp.Expr) -> str:
    return str(expression.args[0].name)


def _loop(one: BatchFunction, tables: dict[str, TruncatedSeries]) -> str:
    arguments, returns = one.function.arguments, one.function.returns
    inside = [f"{a.name} = all_{a.name}[i]" for a in arguments]
    for symbol, expression in one.function.assignments:
        if symbol == one.gate:
            inside += [f"served = {_served(one)}", "unserved += not served",
                       f"{symbol.name} = {python_source(expression)} if served else np.nan"]
        elif _is_polynomial(expression):
            first, *others = reversed(tables[_called(expression)].coefficients)
            inside += [f"{symbol.name} = {correctly_rounded(first)}",
                       *(f"{symbol.name} = {symbol.name}*{expression.args[1].name} + {correctly_rounded(c)}"
                         for c in others)]
        else:
            inside.append(f"{symbol.name} = {python_source(expression)}")
    inside += [f"place = {len(returns)}*i", *(f"out[place + {k}] = {r.name}" for k, r in enumerate(returns))]
    renamed = _signature(one)
    for a in arguments:
        renamed = renamed.replace(f"{a.name}: Array", f"all_{a.name}: Array", 1)
    head = _docstring(one)
    for a in arguments:
        head = head.replace(f"    {a.name} : (n,)", f"    all_{a.name} : (n,)", 1)
    body = "\n".join(f"        {line}" for line in inside)
    return (f"{renamed}\n{head}\n    unserved = 0\n    for i in range(all_{arguments[0].name}.size):\n{body}\n"
            "    return unserved\n")


def _polynomial_groups(one: BatchFunction) -> list[list[Assignment]]:
    """Polynomials of the same variable that follow one another: they are evaluated together."""
    return [list(members) for key, members in groupby(one.function.assignments, _group_key) if key is not None]


def _group_key(assignment: Assignment) -> sp.Symbol | None:
    expression = assignment[1]
    return expression.args[1] if _is_polynomial(expression) else None


def _table_name(group: list[Assignment]) -> str:
    """Name of a common table: that of its first member without its number."""
    return _called(group[0][1]).rstrip("0123456789_")


def _table(name: str, members: list[TruncatedSeries]) -> str:
    terms = max(len(series.coefficients) for series in members)
    rows = [[correctly_rounded(series.coefficients[n]) if n < len(series.coefficients) else "0.0"
             for series in members] for n in reversed(range(terms))]
    return f"{name} = np.array([\n" + "\n".join(f"    [{', '.join(row)}]," for row in rows) + "\n])\n"


def _block(one: BatchFunction) -> str:
    lines = []
    groups = iter(_polynomial_groups(one))
    for key, members in groupby(one.function.assignments, _group_key):
        if key is not None:
            group = next(groups)
            names = ", ".join(symbol.name for symbol, _ in group) + ("," if len(group) == 1 else "")
            lines.append(f"{names} = polynomials({_table_name(group)}, {key.name})")
            continue
        for symbol, expression in members:
            if symbol == one.gate:
                lines += [f"served = {_served(one)}",
                          f"{symbol.name} = np.where(served, {python_source(expression)}, np.nan)"]
            elif symbol in one.function.returns:
                lines.append(f"rows[:, {one.function.returns.index(symbol)}] = {python_source(expression)}")
            else:
                lines.append(f"{symbol.name} = {python_source(expression)}")
    body = "\n".join(f"        {line}" for line in lines)
    return (f"{_signature(one)}\n{_docstring(one)}\n    rows = out.reshape(-1, {len(one.function.returns)})\n"
            '    with np.errstate(all="ignore"):  # what is not served may be anything\n'
            f"{body}\n    return int(served.size - np.count_nonzero(served))\n")
