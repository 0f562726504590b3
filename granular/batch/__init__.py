"""Stiffness of very many assemblies at once: kernels that take blocks of elements, engines that run them.

What a kernel is
----------------
A kernel answers one question (constant stiffness, kinetic fabric, partial slip ...) for a block of n elements::

    unserved = block(x_1, ..., x_m, *tables, out)

``x_i`` are (n,) arrays, float64, contiguous, read only; ``out`` is (6 n,), float64, contiguous: six places an element,
one element after another. The block writes C1111, C3333, C1122, C1133, C2323, C1212 of every element that it serves and
NaN in all six places of every other element, and returns how many these others are. It serves an element only where it
keeps ``Kernel.relative_error``; it checks every value for itself, so that no pass over the arrays is needed before.
Elements outside the domain of the model are simply not served: the caller looks at what is left, refuses it or computes
it another way. A block knows nothing of shapes, strides, threads and errors, and works element by element: its values
do not depend on the block that an element is in.

There are two forms of each block, ``Kernel.array`` on whole arrays by NumPy, always there, and ``Kernel.loop`` as a
plain Python loop that numba compiles where it is installed. A loop takes one argument more, whether its results go past
the caches; it works in passes over some hundred elements, whose results stand in columns until
:mod:`granular.batch.compiled_rows` weaves them into rows. Both do the same IEEE operations in the same order (no
fast-math, no fused multiply-add), so that **both give the same bits**: which of them runs is a question of time alone.
Each is loaded when it is first needed. The loop can also be compiled with products and sums fused, where a caller asks
for the engine ``fused``: a little faster where arithmetic decides, the same bounds, other last bits.

What the caller gets
--------------------
:func:`granular.batch.evaluation.evaluate_batch` cuts broadcast arguments of any layout and type into blocks, one value
that serves all elements into a block that stays in cache, shares the blocks among threads, and returns the indices of
the elements that were not served.

A new kernel is one file that makes a :class:`granular.batch.kernel.Kernel`, and one place in
``granular.array_stiffness`` that says when it is asked.
"""
