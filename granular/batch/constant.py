"""Kernels for contacts that are all equally stiff."""

from __future__ import annotations

from functools import cache

from granular.batch.kernel import BlockFunction, Kernel

RELATIVE_ERROR = 2.0**-49
"""Bound of every component that is not subnormal [-]."""


@cache
def _loop() -> BlockFunction:
    from granular.generated.kinematic_constant_loop import kinematic_constant

    return kinematic_constant


@cache
def _block() -> BlockFunction:
    from granular.generated.kinematic_constant_block import kinematic_constant

    return kinematic_constant


@cache
def _static_loop() -> BlockFunction:
    from granular.generated.static_constant_loop import static_constant

    return static_constant


@cache
def _static_block() -> BlockFunction:
    from granular.generated.static_constant_block import static_constant

    return static_constant


KINEMATIC = Kernel(name="constant stiffness, kinematic", inputs=("D33", "Dr33", "poisson_ratio"),
                   relative_error=RELATIVE_ERROR, array=_block, loop=_loop)
"""Serves the whole domain of the model."""

STATIC = Kernel(name="constant stiffness, static", inputs=("D33", "Dr33", "poisson_ratio"),
                relative_error=RELATIVE_ERROR, array=_static_block, loop=_static_loop)
"""Serves branch lengths at pole and equator within a factor 9, -16/19 <= Dr33 <= 16/11."""
