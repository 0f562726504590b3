"""The dataset of a sweep: dimensions named by fields, coordinates with units, and where every number comes from."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from granular.sweeps.definition import Sweep
from granular.sweeps.outputs import EXTENTS, EXTRA_DIMENSIONS, FILL, Form, Variable, variables_of
from granular.sweeps.provenance import fingerprint, hash_of

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray

COMPLETE = "complete"
"""Attribute that says whether all chunks are finished: 0 or 1."""

TITLE = "granular sweep"
"""Attribute by which a store of a sweep is known."""


def attributes_of(sweep: Sweep) -> dict[str, Any]:
    """Global attributes: what was computed, and with what.

    Parameters
    ----------
    sweep : Sweep
        The sweep.

    Returns
    -------
    dict
        Text and numbers; the same for the same sweep, library and kind of machine.

    Notes
    -----
    Source: a policy of this package.
    """
    content = sweep.content()
    return {"title": TITLE, "engine": sweep.engine, "points": sweep.count, COMPLETE: 0,
            "sweep": json.dumps(content), "sweep_sha256": hash_of(content), **fingerprint()}


def array_type(form: Form) -> Any:
    """NumPy's type of what a point has of a variable."""
    import numpy as np

    types: dict[Form, Any] = {"number": np.dtype(float), "count": np.dtype("int64"), "text": np.dtypes.StringDType(),
                              "flags": np.dtype(bool), "matrix": np.dtype(float)}
    return types[form]


def array_of(variable: Variable, values: list[object], shape: tuple[int, ...]) -> NDArray[Any]:
    """Values of the points of a chunk as an array.

    Parameters
    ----------
    variable : Variable
        What they are values of.
    values : list
        One for each point, the last dimension running fastest.
    shape : tuple of int
        Places of the chunk along each dimension.

    Returns
    -------
    array
        Of that shape, and the variable's own dimensions [unit of the variable].

    Notes
    -----
    Source: a policy of this package.

    Examples
    --------
    >>> from granular.sweeps.outputs import REFUSALS
    >>> array_of(REFUSALS, ["", "G-STA-01"], (2, 1)).shape
    (2, 1)
    """
    import numpy as np

    return np.array(values, dtype=array_type(variable.form)).reshape(*shape, *EXTENTS[variable.form])


def blank_arrays(sweep: Sweep) -> dict[str, NDArray[Any]]:
    """Every variable without a value."""
    import numpy as np

    return {variable.name: np.full((*sweep.shape, *EXTENTS[variable.form]), FILL[variable.form],
                                   dtype=array_type(variable.form))
            for variable in variables_of(sweep.outputs)}


def promised_arrays(sweep: Sweep) -> dict[str, Any]:
    """The same, cut into chunks and without any memory: a store writes down no more than what they would be."""
    import dask.array

    return {variable.name: dask.array.full(
        (*sweep.shape, *EXTENTS[variable.form]), FILL[variable.form], dtype=array_type(variable.form),
        chunks=(*sweep.chunk_shape, *EXTENTS[variable.form]))
        for variable in variables_of(sweep.outputs)}


def dataset_of(sweep: Sweep, arrays: Mapping[str, Any]) -> xr.Dataset:
    """Name and describe the arrays of a sweep.

    Parameters
    ----------
    sweep : Sweep
        The sweep.
    arrays : dict
        Variable -> its array, over the whole grid.

    Returns
    -------
    xarray.Dataset
        With coordinates, units and provenance.

    Notes
    -----
    Source: units as CF writes them; "1" for a pure number.
    """
    import xarray as xr

    dimensions = tuple(sweep.dimensions)
    variables = {
        variable.name: ((*dimensions, *(name for name, _ in EXTRA_DIMENSIONS[variable.form])), arrays[variable.name],
                        _described(variable.unit, variable.meaning))
        for variable in variables_of(sweep.outputs)}
    return xr.Dataset(variables, coords=_coordinates(sweep), attrs=attributes_of(sweep))


def _coordinates(sweep: Sweep) -> dict[str, Any]:
    coordinates: dict[str, Any] = {}
    for dimension, axes in sweep.dimensions.items():
        for axis in axes:
            coordinates[axis.name] = (dimension, _labels(axis.labels),
                                      _described(axis.field.unit, axis.field.description))
    for form in dict.fromkeys(variable.form for variable in variables_of(sweep.outputs)):
        for name, labels in EXTRA_DIMENSIONS[form]:
            coordinates[name] = (name, _labels(labels))
    return coordinates


def _labels(labels: tuple[float, ...] | tuple[str, ...]) -> NDArray[np.float64] | NDArray[Any]:
    import numpy as np

    return np.array(labels, dtype=np.dtypes.StringDType() if isinstance(labels[0], str) else float)


def _described(unit: str | None, meaning: str) -> dict[str, str]:
    return ({} if unit is None else {"units": unit}) | {"long_name": meaning}
