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

PASSES, GAP = (128, 64, 32), 8
"""Elements that one pass of a loop may go over, and the numbers between what is kept of them, so that no two columns of
it are a power of two apart."""

ROOM = 12 * 1024
"""Bytes that what is kept may take: it stays in the nearest cache beside what is read and written."""

SHORT = 12
"""Terms up to which even and odd powers of a polynomial are summed apart: there are too few polynomials beside it."""

SIDE_BY_SIDE = 6
"""Polynomials of two elements that a processor has registers for: 12 chains, none of which waits for another."""

RELATIONS = {sp.StrictGreaterThan: ">", sp.GreaterThan: ">=", sp.StrictLessThan: "<", sp.LessThan: "<="}


def loop_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_loop.py``."""
    bodies = [_loop(one, _tables(derivation)) for one in derivation.batch]
    return "\n".join([_header(derivation, "a loop over elements, to be compiled"),
                      _imports_of_loop(derivation, bodies), "",
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


def _imports_of_loop(derivation: Derivation, bodies: list[str]) -> str:
    """Those of a block, and the two functions that every loop calls."""
    names = "scratch_of" if all(one.apart for one in derivation.batch) else "scratch_of, write_rows"
    ours = f"\nfrom granular.generated.rows import {names}\n\nArray: TypeAlias"
    return _imports(bodies).replace("\nArray: TypeAlias", ours)


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
    return " & ".join(f"({_relation(relation)})" for relation in _tested(one))


def _tested(one: BatchFunction) -> tuple[sp.Rel, ...]:
    return one.tested or one.serves


def _relation(relation: sp.Rel) -> str:
    return f"{python_source(relation.lhs)} {RELATIONS[relation.func]} {_number(relation.rhs)}"


def _number(expression: sp.Expr) -> str:
    return correctly_rounded(expression) if expression.is_Rational else python_source(expression)


def _is_polynomial(expression: sp.Expr) -> bool:
    return bool(expression.func.__name__ == "polynomial")


def _called(expression: sp.Expr) -> str:
    return str(expression.args[0].name)


def _loop(one: BatchFunction, tables: dict[str, TruncatedSeries]) -> str:
    """A loop over elements in passes that all stay in the nearest cache, the results of each written at its end."""
    names, returns = [a.name for a in one.function.arguments], one.function.returns
    passes = _passes(one)
    kept = sorted(_kept(one, passes))
    columns = [] if one.apart else [r.name for r in returns]
    length = _length(len(kept) + len(columns))
    spacing = length + GAP
    numbers = {symbol.name: number for symbol, number in one.function.assignments if number.is_number}
    lines = [f"{name} = {python_source(number)}" for name, number in numbers.items() if name not in columns]
    lines.append(f"scratch = scratch_of({(len(kept) + len(columns)) * spacing})")
    places = {name: f"scratch[{k * spacing}:{k * spacing + length}]"
              for k, name in enumerate([*(f"keep_{name}" for name in kept), *(f"column_{name}" for name in columns)])}
    if columns:
        places["columns"] = f"scratch[{len(kept) * spacing}:{(len(kept) + len(columns)) * spacing}]"
    lines += [f"{name} = {place}" for name, place in places.items() if name.removeprefix("column_") not in numbers]
    lines += [f"{places[f'column_{name}']} = {python_source(numbers[name])}" for name in columns
              if name in numbers]
    size = f"all_{names[0]}.size"
    lines += ["unserved = 0", f"for start in range(0, {size}, {length}):", f"    stop = min(start + {length}, {size})",
              *(f"    some_{name} = all_{name}[start:stop]" for name in names)]
    if one.apart:
        lines += [f"    some_{r.name} = out[{k}*{size}:{k + 1}*{size}][start:stop]" for k, r in enumerate(returns)]
    for members in passes:
        body = _pass(one, members, set(kept), tables)
        if _only_keeps(one, members):
            lines += ["    half = (stop - start + 1)//2", "    for i in range(half):", *_indented(_twice(body), 2)]
        else:
            lines += ["    for i in range(stop - start):", *_indented(body, 2)]
    if columns:
        width = len(columns)
        lines.append(f"    write_rows(columns, {width}, {spacing}, out[{width}*start:{width}*stop], streamed)")
    return "\n".join([_loop_head(one), *_indented(lines), "    return unserved\n"])


def _length(columns: int) -> int:
    """Elements of a pass: as many as there is room for."""
    return next((length for length in PASSES if 8 * columns * (length + GAP) <= ROOM), PASSES[-1])


def _loop_head(one: BatchFunction) -> str:
    signature, head = _signature(one), _docstring(one)
    for argument in one.function.arguments:
        signature = signature.replace(f"{argument.name}: Array", f"all_{argument.name}: Array", 1)
        head = head.replace(f"    {argument.name} : (n,)", f"    all_{argument.name} : (n,)", 1)
    if not one.apart:
        signature = signature.replace("out: Array", "out: Array, streamed: bool")
        said = "    streamed : bool\n        Whether results go past the caches, where a compiler knows how.\n"
        head = head.replace("\n\n    Returns\n", f"\n{said}\n    Returns\n", 1)
    return f"{signature}\n{head}"


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
        read |= set().union(*(relation.free_symbols for relation in _tested(one)))
    return {symbol.name for symbol in read}


def _kept(one: BatchFunction, passes: list[list[Assignment]]) -> set[str]:
    """Names that a pass assigns and a later one reads."""
    kept: set[str] = set()
    for k, members in enumerate(passes):
        later = set().union(*(_needed(one, following) for following in passes[k + 1:]))
        kept |= {symbol.name for symbol, _ in members} & later
    return kept


def _pass(one: BatchFunction, members: list[Assignment], kept: set[str],
          tables: dict[str, TruncatedSeries]) -> list[str]:
    own, needed = {symbol.name for symbol, _ in members}, _needed(one, members)
    lines = [f"{a.name} = some_{a.name}[i]" for a in one.function.arguments if a.name in needed]
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
    target = "some" if one.apart else "column"
    return [*lines, *(f"{target}_{r.name}[i] = {r.name}" for r in one.function.returns if r.name in own)]


def _only_keeps(one: BatchFunction, members: list[Assignment]) -> bool:
    """Whether a pass reads and writes only what is kept, and leaves registers for a second element."""
    arguments = {a.name for a in one.function.arguments}
    polynomials = sum(1 for _, expression in members if _is_polynomial(expression))
    writes = any(symbol == one.gate or symbol in one.function.returns for symbol, _ in members)
    return not arguments & _needed(one, members) and not writes and 0 < polynomials <= SIDE_BY_SIDE


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
