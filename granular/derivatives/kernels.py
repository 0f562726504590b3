"""Kernels that give six components and their thirty slopes for very many assemblies."""

from __future__ import annotations

from functools import cache

from granular.batch.kernel import BlockFunction, Kernel

RELATIVE_ERROR = 2.0**-47
"""Bound of every slope, of the larger of the slope and the largest component [-]."""


@cache
def _constant_loop() -> BlockFunction:
    from granular.generated.gradients_loop import constant_rows

    return constant_rows


@cache
def _constant_block() -> BlockFunction:
    from granular.generated.gradients_block import constant_rows

    return constant_rows


@cache
def _kinetic_loop() -> BlockFunction:
    from granular.generated.gradients_loop import kinetic_rows

    return kinetic_rows


@cache
def _kinetic_block() -> BlockFunction:
    from granular.generated.gradients_block import kinetic_rows

    return kinetic_rows


CONSTANT = Kernel(name="slopes, constant stiffness, kinematic", inputs=("D33", "Dr33", "poisson_ratio"),
                  relative_error=RELATIVE_ERROR, array=_constant_block, loop=_constant_loop)
"""Serves the whole domain of the model."""

KINETIC = Kernel(name="slopes, kinetic, kinematic", inputs=("D33", "Dr33", "stress_ratio", "poisson_ratio"),
                 relative_error=RELATIVE_ERROR, array=_kinetic_block, loop=_kinetic_loop)
"""Serves 1/9 <= c/a <= 6, with a and c the normal forces at equator and pole."""
