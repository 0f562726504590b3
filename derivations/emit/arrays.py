"""Print a derivation as a module of NumPy functions: the same arithmetic on arrays of any broadcastable shapes."""

from __future__ import annotations

import sympy as sp

from derivations.emit.module import (
    all_series,
    assignments,
    called_functions,
    chained_body,
    docstring,
    end_to_end,
    end_to_end_operations,
    header,
    output_units,
)
from derivations.record import Derivation, Function

POLYNOMIAL = '''\
def polynomial(coefficients: tuple[float, ...], v: Array) -> Array:
    """Evaluate a polynomial by Horner's rule for every element at once, coefficients in rising order."""
    total = np.zeros_like(v)
    for coefficient in reversed(coefficients):
        total *= v
        total += coefficient
    return total
'''


def array_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME_array.py``."""
    series, units = all_series(derivation), output_units(derivation)
    bodies = [_function(function, assignments(function), function.operations(), units)
              for function in derivation.functions]
    whole = end_to_end(derivation)
    if whole is not None:
        bodies.append(_function(whole, chained_body(derivation), end_to_end_operations(derivation), units))
    imports = ["from __future__ import annotations\n", "from typing import TypeAlias\n",
               "import numpy as np", "import numpy.typing as npt"]
    if called_functions(bodies):
        imports.append(f"from numpy import {called_functions(bodies)}")
    if series:
        imports.append(f"\nfrom .{derivation.name} import {', '.join(one.name for one in series)}")
    imports.append("\nArray: TypeAlias = npt.NDArray[np.float64]")
    parts = [header(derivation, "functions of arrays"), "\n".join(imports) + "\n"]
    blocks = [*([POLYNOMIAL] if series else []), *bodies]
    return "\n".join(parts) + "\n\n" + "\n\n".join(blocks)


def _function(function: Function, body: str, operations: int, units: dict[sp.Symbol, str]) -> str:
    arguments = ", ".join(f"{a.name}: Array" for a in function.arguments)
    returns = ", ".join(["Array"] * len(function.returns))
    signature = f"def {function.name}({arguments}) -> tuple[{returns}]:"
    if len(signature) > 110:
        signature = f"def {function.name}(\n    {arguments},\n) -> tuple[{returns}]:"
    return f"{signature}\n{docstring(function, '(...) array', operations, units)}\n{body}\n"
