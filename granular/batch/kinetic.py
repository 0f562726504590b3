"""Kernels for contacts whose stiffness follows their force, none of them slipping."""

from __future__ import annotations

from functools import cache

from granular.batch.kernel import BlockFunction, Kernel

RELATIVE_ERROR = 2.0**-49
"""Bound of every component that is not subnormal [-]."""


@cache
def _loop() -> BlockFunction:
    from granular.generated.kinetic_loop import kinematic_kinetic

    return kinematic_kinetic


@cache
def _block() -> BlockFunction:
    from granular.generated.kinetic_block import kinematic_kinetic

    return kinematic_kinetic


KINEMATIC = Kernel(name="kinetic, kinematic", inputs=("D33", "Dr33", "stress_ratio", "poisson_ratio"),
                   relative_error=RELATIVE_ERROR, array=_block, loop=_loop)
"""Serves 1/9 <= c/a <= 6, with a and c the normal forces at equator and pole: stress ratios from 1/3 to 3 and any
fabric."""
