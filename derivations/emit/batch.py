"""Print functions for very many elements: a loop that a compiler can turn into vector code, and blocks for NumPy.

Both forms hold the same operations in the same order, so that both give the same bits: Horner's rule for polynomials,
coefficients as correctly rounded decimals, no operation that a library may round in its own way.
"""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import groupby
from textwrap import fill

import sympy as sp

from derivations.emit.module import WIDTH, called_functions, correctly_rounded, docstring, header
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

PASS, GAP = 64, 8
"""Elements that one pass of a loop goes over, and the numbers between what is kept of them: it all stays in the nearest
cache, and no two rows of it are a power of two apart."""

SHORT = 8
"""Terms up to which even and odd powers of a polynomial are summed apart: there are too few polynomials beside it."""

SIDE_BY_SIDE = 6
"""Polynomials of two elements that a processor has registers for: 12 chains, none of which waits for another."""

RELATIONS = {sp.StrictGreaterThan: ">", sp.GreaterThan: ">=", sp.StrictLessThan: "<", sp.LessThan: "<="}


def loop_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_loop.py``."""
    bodies = [_loop(one, _tables(derivation)) for one in derivation.batch]
    return "\n".join([_header(derivation, "a loop over elements, to be compiled"), _imports(bodies), "",
                      "\n\n".join(bodies)])


def block_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_block.py``."""
    tables = _tables(derivation)
    groups = {_table_name(group): group for one in derivation.batch for group in _polynomial_groups(one)
              if not _is_short(tables[_called(group[0][1])])}
    bodies = [_block(one, tables) for one in derivation.batch]
    parts = [_header(derivation, "blocks of elements at once"), _imports(bodies)]
    parts += [_table(name, [tables[_called(e)] for _, e in group]) for name, group in groups.items()]
    return "\n".join(parts) + "\n\n" + "\n\n".join(
        [*([POLYNOMIALS] if groups else []), *bodies])


def _imports(bodies: list[str]) -> str:
    """NumPy's functions in both forms: they take what is outside their domain without a stop."""
    called = called_functions(bodies)
    return IMPORTS.replace("typing as npt\n", f"typing as npt\nfrom numpy import {called}\n") if called else IMPORTS


def _header(derivation: Derivation, kind: str) -> str:
    """Module docstring with the domain and the operations of what is emitted for batches."""
    domain = tuple(f"{function.name}: {', '.join(map(_relation, one.serves))}"
                   for one in derivation.batch for function in (one.function,))
    return header(replace(derivation, functions=tuple(one.function for one in derivation.batch),
                          domain=domain), kind)


def _tables(derivation: Derivation) -> dict[str, TruncatedSeries]:
    return {series.name: series for one in derivation.batch for series in one.function.series}


def _signature(one: BatchFunction) -> str:
    arguments = ", ".join(f"{a.name}: Array" for a in one.function.arguments)
    return f"def {one.function.name}({arguments}, out: Array) -> int:"


def _docstring(one: BatchFunction) -> str:
    described = docstring(one.function, "(n,) array", one.function.operations(), {})
    before = described.split("    Returns\n")[0].rstrip()
    names = ", ".join(result.name for result in one.function.returns)
    count = len(one.function.returns)
    order = "each for all elements" if one.apart else "of each element in turn"
    places = fill(f"{names}{',' * one.apart} {order}, NaN for those that are not served.", WIDTH,
                  initial_indent=" " * 8, subsequent_indent=" " * 8)
    return (f"{before}\n    out : ({count} n,) array [-]\n{places}\n\n    Returns\n    -------\n"
            "    unserved : int\n        How many elements are not served.\n\n"
            f'    Operations: {one.function.operations()}.\n    """')


def _served(one: BatchFunction) -> str:
    return " & ".join(f"({_relation(relation)})" for relation in one.serves)


def _relation(relation: sp.Rel) -> str:
    return f"{python_source(relation.lhs)} {RELATIONS[relation.func]} {_number(relation.rhs)}"


def _number(expression: sp.Expr) -> str:
    return correctly_rounded(expression) if expression.is_Rational else python_source(expression)


def _is_polynomial(expression: sp.Expr) -> bool:
    return bool(expression.func.__name__ == "polynomial")


def _called(expression: sp.Expr) -> str:
    return str(expression.args[0].name)


def _loop(one: BatchFunction, tables: dict[str, TruncatedSeries]) -> str:
    names = [a.name for a in one.function.arguments]
    passes = _passes(one)
    kept = _kept(one, passes)
    lines = [f"{symbol.name} = {python_source(number)}" for symbol, number in one.function.assignments
             if number.is_number]
    if kept:
        lines.append(f"scratch = np.ones({len(kept) * (PASS + GAP)})")
    lines += [*(f"keep_{name} = scratch[{k * (PASS + GAP)}:{k * (PASS + GAP) + PASS}]"
                for k, name in enumerate(sorted(kept))), "unserved = 0"]
    if len(passes) == 1:
        lines += [f"for i in range(all_{names[0]}.size):",
                  *_indented(_pass(one, passes[0], kept, tables, "all", "out"))]
    else:
        width = len(one.function.returns)
        lines += [f"for start in range(0, all_{names[0]}.size, {PASS}):",
                  f"    stop = min(start + {PASS}, all_{names[0]}.size)",
                  *(f"    some_{name} = all_{name}[start:stop]" for name in names),
                  *([f"    some_{r.name} = out[{k}*all_{names[0]}.size:{k + 1}*all_{names[0]}.size][start:stop]"
                     for k, r in enumerate(one.function.returns)] if one.apart else
                    [f"    some_out = out[{width}*start:{width}*stop]"])]
        for members in passes:
            body = _pass(one, members, kept, tables, "some", "some_out")
            if _only_keeps(one, members):
                lines += ["    half = (stop - start + 1)//2", "    for i in range(half):",
                          *_indented(_twice(body), 2)]
            else:
                lines += ["    for i in range(stop - start):", *_indented(body, 2)]
    signature, head = _signature(one), _docstring(one)
    for name in names:
        signature = signature.replace(f"{name}: Array", f"all_{name}: Array", 1)
        head = head.replace(f"    {name} : (n,)", f"    all_{name} : (n,)", 1)
    return "\n".join([signature, head, *_indented(lines), "    return unserved\n"])


def _indented(lines: list[str], depth: int = 1) -> list[str]:
    return [" " * 4 * depth + line for line in lines]


def _passes(one: BatchFunction) -> list[list[Assignment]]:
    passes: list[list[Assignment]] = [[]]
    for assignment in one.function.assignments:
        if assignment[1].is_number:
            continue  # stands before the loop
        passes[-1].append(assignment)
        if assignment[0] in one.passes:
            passes.append([])
    return passes


def _needed(one: BatchFunction, members: list[Assignment]) -> set[str]:
    """Names that a pass reads, those that it assigns itself among them."""
    read = set().union(*(e.free_symbols - {e.args[0]} if _is_polynomial(e) else e.free_symbols for _, e in members))
    if any(symbol == one.gate for symbol, _ in members):
        read |= set().union(*(relation.free_symbols for relation in one.serves))
    return {symbol.name for symbol in read}


def _kept(one: BatchFunction, passes: list[list[Assignment]]) -> set[str]:
    """Names that a pass assigns and a later one reads."""
    kept: set[str] = set()
    for k, members in enumerate(passes):
        later = set().union(*(_needed(one, following) for following in passes[k + 1:]))
        kept |= {symbol.name for symbol, _ in members} & later
    return kept


def _pass(one: BatchFunction, members: list[Assignment], kept: set[str], tables: dict[str, TruncatedSeries],
          source: str, target: str) -> list[str]:
    own, needed = {symbol.name for symbol, _ in members}, _needed(one, members)
    lines = [f"{a.name} = {source}_{a.name}[i]" for a in one.function.arguments if a.name in needed]
    lines += [f"{name} = keep_{name}[i]" for name in sorted((needed & kept) - own)]
    for polynomials, run in groupby(members, lambda assignment: _is_polynomial(assignment[1])):
        if polynomials:
            members_of_run = list(run)
            short = [one for one in members_of_run if _is_short(tables[_called(one[1])])]
            lines += [line for together in zip(*(_apart(symbol, e, tables[_called(e)]) for symbol, e in short),
                                               strict=True) for line in together]
            lines += _horner([one for one in members_of_run if one not in short], tables)
            continue
        for symbol, expression in run:
            if symbol == one.gate:
                lines += [f"served = {_served(one)}", "unserved += not served",
                          f"{symbol.name} = {python_source(expression)} if served else np.nan"]
            else:
                lines.append(f"{symbol.name} = {python_source(expression)}")
    lines += [f"keep_{name}[i] = {name}" for name in sorted(own & kept)]
    stored = _stored(one, own)
    if one.apart:
        lines += [f"some_{r.name}[i] = {r.name}" for _, r in stored]
    elif stored:
        lines += [f"place = {len(one.function.returns)}*i",
                  *(f"{target}[place + {k}] = {r.name}" for k, r in stored)]
    return lines


def _only_keeps(one: BatchFunction, members: list[Assignment]) -> bool:
    """Whether a pass reads and writes only what is kept, and leaves registers for a second element."""
    arguments = {a.name for a in one.function.arguments}
    polynomials = sum(1 for _, expression in members if _is_polynomial(expression))
    return (not arguments & _needed(one, members) and not _stored(one, {symbol.name for symbol, _ in members})
            and all(symbol != one.gate for symbol, _ in members) and 0 < polynomials <= SIDE_BY_SIDE)


def _twice(body: list[str]) -> list[str]:
    """Each line for an element and for the one half a pass further, so that neither waits for the other.

    Where the elements are odd in number the last line of what is kept is computed for no element.
    """
    own = {line.split(" = ")[0] for line in body if "[" not in line.split(" = ")[0]}
    lines = []
    for line in body:
        again = re.sub(r"\b[A-Za-z_]\w*\b", lambda found: f"{found[0]}_too" if found[0] in own else found[0], line)
        lines += [line, again.replace("[i]", "[i + half]")]
    return lines


def _stored(one: BatchFunction, own: set[str]) -> list[tuple[int, sp.Symbol]]:
    """Results that a pass writes, with their places: those that it assigns, and numbers beside the first of all."""
    returns = one.function.returns
    numbers = {symbol.name for symbol, expression in one.function.assignments if expression.is_number}
    return [(k, r) for k, r in enumerate(returns)
            if r.name in own or (r.name in numbers and returns[0].name in own)]


def _is_short(series: TruncatedSeries) -> bool:
    return len(series.coefficients) <= SHORT


def _apart(symbol: sp.Symbol, expression: sp.Expr, series: TruncatedSeries) -> list[str]:
    """A short polynomial, its even and odd powers apart, each by Horner's rule in the square of the variable."""
    name, variable, square = symbol.name, expression.args[1].name, f"{symbol.name}_of"
    lines, parts = [f"{square} = {variable}*{variable}"], []
    for part, first in (("even", 0), ("odd", 1)):
        total, *others = [correctly_rounded(c) for c in reversed(series.coefficients[first::2])]
        for number in others:
            lines.append(f"{name}_{part} = {total}*{square} + {number}")
            total = f"{name}_{part}"
        parts.append(total)
    return [*lines, f"{name} = {parts[1]}*{variable} + {parts[0]}"]


def _horner(run: list[Assignment], tables: dict[str, TruncatedSeries]) -> list[str]:
    """Polynomials side by side, a term of each in turn: none has to wait for the one before."""
    columns = [[correctly_rounded(c) for c in reversed(tables[_called(e)].coefficients)] for _, e in run]
    longest = max(map(len, columns), default=0)
    lines = []
    for term in range(longest):
        for (symbol, expression), column in zip(run, columns, strict=True):
            own = term - (longest - len(column))
            if own == 0:
                lines.append(f"{symbol.name} = {column[0]}")
            elif own > 0:
                lines.append(f"{symbol.name} = {symbol.name}*{expression.args[1].name} + {column[own]}")
    return lines


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


def _block(one: BatchFunction, tables: dict[str, TruncatedSeries]) -> str:
    lines = []
    columns = {r: f"rows[{k}]" if one.apart else f"rows[:, {k}]" for k, r in enumerate(one.function.returns)}
    groups, read = iter(_polynomial_groups(one)), _needed(one, list(one.function.assignments))
    for key, members in groupby(one.function.assignments, _group_key):
        if key is not None:
            group = next(groups)
            if _is_short(tables[_called(group[0][1])]):
                lines += [line for symbol, e in group for line in _apart(symbol, e, tables[_called(e)])]
                continue
            names = ", ".join(symbol.name for symbol, _ in group) + ("," if len(group) == 1 else "")
            lines.append(f"{names} = polynomials({_table_name(group)}, {key.name})")
            continue
        for symbol, expression in members:
            if symbol == one.gate:
                lines += [f"served = {_served(one)}",
                          f"{symbol.name} = np.where(served, {python_source(expression)}, np.nan)"]
                if symbol in columns:
                    lines.append(f"{columns[symbol]} = {symbol.name}")
            elif symbol in columns:
                lines.append(f"{columns[symbol]} = {python_source(expression)}")
                if symbol.name in read:
                    lines.append(f"{symbol.name} = {columns[symbol]}")
            else:
                lines.append(f"{symbol.name} = {python_source(expression)}")
    body = "\n".join(f"        {line}" for line in lines)
    shape = f"{len(columns)}, -1" if one.apart else f"-1, {len(columns)}"
    return (f"{_signature(one)}\n{_docstring(one)}\n    rows = out.reshape({shape})\n"
            '    with np.errstate(all="ignore"):  # what is not served may be anything\n'
            f"{body}\n    return int(served.size - np.count_nonzero(served))\n")
