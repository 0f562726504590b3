"""Compute the points of one chunk, scene by scene; a chunk's numbers depend on nothing but its points."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from granular.errors import GranularError
from granular.sweeps.arrays import evaluate_arrays
from granular.sweeps.definition import ARRAYS
from granular.sweeps.outputs import EXTENTS, FILL, OUTPUTS, Variable, variables_of
from granular.sweeps.points import MISTAKES, Points, SceneBuilder, at_point

Block = Mapping[str, list[object]]
"""Variable -> its values at the points of a chunk, the last dimension running fastest."""


@dataclass(frozen=True, slots=True)
class Task:
    """One chunk, with all that is needed to compute it anywhere.

    Attributes
    ----------
    points : Points
        Its points.
    outputs : tuple of str
        What is kept.
    engine, route : str
        How it is computed.
    keep_going : bool
        Whether a refused point becomes a gap with its code, in place of an error.
    """

    points: Points
    outputs: tuple[str, ...]
    engine: str
    route: str
    keep_going: bool

    def compute(self) -> Block:
        """Compute the chunk.

        Raises
        ------
        GranularError
            The first point that is refused, unless ``keep_going``.
        """
        if self.engine == ARRAYS:
            return evaluate_arrays(self.points, self.outputs, keep_going=self.keep_going)
        return self._scene_by_scene()

    def _scene_by_scene(self) -> Block:
        from granular.evaluation import evaluate

        variables = variables_of(self.outputs)
        block: dict[str, list[object]] = {variable.name: [] for variable in variables}
        builder = SceneBuilder(self.points.base)
        for values in self.points.values():
            try:
                with at_point(values):
                    result = evaluate(builder.scene(values), route=self.route)
                    row = [value for name in self.outputs for value in OUTPUTS[name].read(result)]
                row.append("")
            except GranularError as refusal:
                if not self.keep_going or isinstance(refusal, MISTAKES):
                    raise
                row = [*(blank(variable) for variable in variables[:-1]), refusal.code]
            for variable, value in zip(variables, row, strict=True):
                block[variable.name].append(value)
        return block


def blank(variable: Variable) -> object:
    """What stands where a point was refused, or not computed yet.

    Parameters
    ----------
    variable : Variable
        What a point has of it decides.

    Returns
    -------
    object
        NaN, -1, no text, or no effect.

    Notes
    -----
    Source: a policy of this package.

    Examples
    --------
    >>> from granular.sweeps.outputs import REFUSALS
    >>> blank(REFUSALS)
    ''
    """
    if variable.form == "flags":
        return [False] * EXTENTS["flags"][0]
    if variable.form == "matrix":
        rows, columns = EXTENTS["matrix"]
        return [[math.nan] * columns for _ in range(rows)]
    return FILL[variable.form]
