"""What stands for ``granular.generated.rows`` in compiled loops: scratch on the stack, rows woven by vector code.

A compiler that turns a loop into vector code has several elements at hand, a result of each in one register; in memory
all results of an element come first. Left to itself it weaves six columns into rows with three times the instructions
that it takes. It also has to check that no two arrays overlap before each pass over 64 elements, unless it can see that
what is kept lies on the stack. And only by name can results go straight to memory: an array that is larger than the
caches would otherwise be read before it is written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

WOVEN_BY_FOUR = 6
"""Numbers in a row up to which four elements are woven at a time: their rows follow one another in memory. Longer rows
are written two at a time, since few places can be written to past the caches at once."""

LINE = 64
"""Bytes at a multiple of which scratch and frames begin: as many as a cache moves at once."""


@lru_cache(maxsize=1)
def row_functions() -> dict[str, Callable[..., Any]]:
    """Functions that numba puts in place of calls in a loop, by the names under which it calls them.

    Returns
    -------
    dict
        ``aligned_frame``, ``part_of``, ``read_rows``, ``scratch_of`` and ``write_rows``.

    Raises
    ------
    ModuleNotFoundError
        numba is not installed.

    Notes
    -----
    Accuracy: numbers are moved, none is computed. Rows that go past the caches have to begin at a multiple of 16 bytes.
    Their own thread sees them at once; others do once it has given back the interpreter, which compiled loops do when
    they return. Source: the language of LLVM.
    """
    from numba import types
    from numba.core import cgutils
    from numba.extending import intrinsic
    from numba.np import arrayobj

    @intrinsic(prefer_literal=True)
    def scratch_of(typing: Any, size: Any) -> Any:
        count, array = size.literal_value, types.Array(types.float64, 1, "C")

        def make(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            whole = cgutils.alloca_once(builder, context.get_value_type(types.float64), size=count)
            whole.align = LINE
            made = context.make_array(array)(context, builder)
            arrayobj.populate_array(made, data=whole, shape=[context.get_constant(types.intp, count)],
                                    strides=[context.get_constant(types.intp, 8)],
                                    itemsize=context.get_constant(types.intp, 8), meminfo=None)
            return made._getvalue()

        return array(size), make

    @intrinsic
    def part_of(typing: Any, whole: Any, first: Any, last: Any) -> Any:
        def make(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            given, made = context.make_array(whole)(context, builder, arguments[0]), context.make_array(whole)(
                context, builder)
            begin, end = (context.cast(builder, value, kind, types.intp) for value, kind in zip(
                arguments[1:], signature.args[1:], strict=True))
            arrayobj.populate_array(made, data=builder.gep(given.data, [begin]), shape=[builder.sub(end, begin)],
                                    strides=[given.itemsize], itemsize=given.itemsize, meminfo=None)
            return made._getvalue()

        return whole(whole, first, last), make

    @intrinsic
    def aligned_frame(typing: Any) -> Any:
        def make(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            builder.function.attributes.add("nounwind")  # llvmlite forgets the other where it stands alone
            builder.function.attributes.alignstack = LINE
            return context.get_dummy_value()

        return types.void(), make

    @intrinsic(prefer_literal=True)
    def write_rows(typing: Any, columns: Any, width: Any, spacing: Any, out: Any, streamed: Any) -> Any:
        def make(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            source = context.make_array(columns)(context, builder, arguments[0])
            target = context.make_array(out)(context, builder, arguments[3])
            weave = _Weave(builder, source.data, target.data, width.literal_value, spacing.literal_value)
            count = builder.udiv(target.nitems, weave.number(width.literal_value))
            with builder.if_else(arguments[4]) as (past, kept):
                with past:
                    weave.all(count, streamed=True)
                with kept:
                    weave.all(count, streamed=False)
            return context.get_dummy_value()

        return types.void(columns, width, spacing, out, types.boolean), make

    @intrinsic(prefer_literal=True)
    def read_rows(typing: Any, rows: Any, width: Any, where: Any, factor: Any, columns: Any, spacing: Any) -> Any:
        def make(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            source, places, factors, target = (context.make_array(kind)(context, builder, value) for kind, value in zip(
                (rows, where, factor, columns), (arguments[0], *arguments[2:5]), strict=True))
            weave = _Weave(builder, target.data, source.data, width.literal_value, spacing.literal_value)
            weave.back(places.nitems, places.data, factors.data)
            return context.get_dummy_value()

        return types.void(rows, width, where, factor, columns, spacing), make

    return {"aligned_frame": aligned_frame, "part_of": part_of, "read_rows": read_rows, "scratch_of": scratch_of,
            "write_rows": write_rows}


class _Weave:
    """Instructions that bring columns into rows, a few elements at a time."""

    def __init__(self, builder: Any, source: Any, target: Any, width: int, spacing: int) -> None:
        from llvmlite import ir

        self.ir, self.builder, self.source, self.target = ir, builder, source, target
        self.width, self.spacing = width, spacing
        self.mark = builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)])

    def number(self, value: int) -> Any:
        """A whole number, as places are counted."""
        return self.ir.Constant(self.ir.IntType(64), value)

    def all(self, count: Any, *, streamed: bool) -> None:
        """Every row: what comes before the first that stores of four may begin with, and what is left, one by one."""
        builder, first = self.builder, self.number(0)
        size = 4 if self.width <= WOVEN_BY_FOUR else 2
        if streamed and size == 4:
            odd = builder.and_(builder.lshr(builder.ptrtoint(self.target, first.type), self.number(4)), self.number(1))
            first = builder.select(builder.icmp_unsigned("<", odd, count), odd, count)
            with self._each(first) as i:
                self._one(i, streamed=streamed)
        groups = builder.udiv(builder.sub(count, first), self.number(size))
        with self._each(groups) as group:
            i = builder.add(first, builder.mul(group, self.number(size)))
            (self._four if size == 4 else self._two)(i, streamed=streamed)
        done = builder.add(first, builder.mul(groups, self.number(size)))
        with self._each(builder.sub(count, done)) as i:
            self._one(builder.add(done, i), streamed=streamed)

    def back(self, count: Any, places: Any, factors: Any) -> None:
        """Rows at some places into columns again, times a factor for each: four at a time, and what is left."""
        groups = self.builder.udiv(count, self.number(4))
        with self._each(groups) as group:
            self._back(self.builder.mul(group, self.number(4)), places, factors, 4)
        done = self.builder.mul(groups, self.number(4))
        with self._each(self.builder.sub(count, done)) as rest:
            self._back(self.builder.add(done, rest), places, factors, 1)

    def _back(self, i: Any, places: Any, factors: Any, size: int) -> None:
        builder = self.builder
        rows = [builder.mul(builder.zext(builder.load(builder.gep(places, [builder.add(i, self.number(j))])), i.type),
                            self.number(self.width)) for j in range(size)]
        factor = self._load_at(builder.gep(factors, [i]), size)
        for k in range(0, self.width, 2):
            pairs = [self._load_at(builder.gep(self.target, [builder.add(row, self.number(k))]), 2) for row in rows]
            if size == 1:
                columns = [self._mixed(pairs[0], pairs[0], (half,)) for half in range(2)]
            else:
                even, odd = (self._mixed(pairs[first], pairs[first + 2], (0, 1, 2, 3)) for first in range(2))
                columns = [self._mixed(even, odd, (half, 4 + half, 2 + half, 6 + half)) for half in range(2)]
            for half, column in enumerate(columns):
                place = builder.bitcast(self._column(k + half, i), column.type.as_pointer())
                builder.store(builder.fmul(column, factor), place, align=8)

    @contextmanager
    def _each(self, count: Any) -> Iterator[Any]:
        from numba.core import cgutils

        with cgutils.for_range(self.builder, count) as loop:
            yield loop.index

    def _one(self, i: Any, *, streamed: bool) -> None:
        for k in range(0, self.width, 2):
            pair = self.ir.Constant(self._vector(2), self.ir.Undefined)
            for half in range(2):
                found = self.builder.load(self._column(k + half, i))
                pair = self.builder.insert_element(pair, found, self.ir.Constant(self.ir.IntType(32), half))
            self._store(pair, i, k, streamed=streamed)

    def _two(self, i: Any, *, streamed: bool) -> None:
        for k in range(0, self.width, 2):
            left, right = self._load(k, i, 2), self._load(k + 1, i, 2)
            for element in range(2):
                self._store(self._mixed(left, right, (element, 2 + element)), i, element * self.width + k,
                            streamed=streamed)

    def _four(self, i: Any, *, streamed: bool) -> None:
        columns = [self._load(k, i, 4) for k in range(self.width)]
        pairs = list(zip(columns[::2], columns[1::2], strict=True))
        even = [self._mixed(left, right, (0, 4, 2, 6)) for left, right in pairs]
        odd = [self._mixed(left, right, (1, 5, 3, 7)) for left, right in pairs]
        halves = [(vector, half) for vectors, half in ((even, 0), (odd, 0), (even, 2), (odd, 2)) for vector in vectors]
        for place, ((left, a), (right, b)) in enumerate(zip(halves[::2], halves[1::2], strict=True)):
            self._store(self._mixed(left, right, (a, a + 1, 4 + b, 5 + b)), i, 4 * place, streamed=streamed)

    def _vector(self, size: int) -> Any:
        return self.ir.VectorType(self.ir.DoubleType(), size)

    def _column(self, k: int, i: Any) -> Any:
        return self.builder.gep(self.source, [self.builder.add(i, self.number(self.spacing * k))])

    def _load(self, k: int, i: Any, size: int) -> Any:
        return self._load_at(self._column(k, i), size)

    def _load_at(self, place: Any, size: int) -> Any:
        return self.builder.load(self.builder.bitcast(place, self._vector(size).as_pointer()), align=8)

    def _mixed(self, left: Any, right: Any, order: tuple[int, ...]) -> Any:
        mask = self.ir.Constant(self.ir.VectorType(self.ir.IntType(32), len(order)), order)
        return self.builder.shuffle_vector(left, right, mask)

    def _store(self, value: Any, i: Any, place: int, *, streamed: bool) -> None:
        at = self.builder.add(self.builder.mul(i, self.number(self.width)), self.number(place))
        pointer = self.builder.bitcast(self.builder.gep(self.target, [at]), value.type.as_pointer())
        stored = self.builder.store(value, pointer, align=8 * value.type.count if streamed else 8)
        if streamed:
            stored.set_metadata("nontemporal", self.mark)
