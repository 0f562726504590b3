"""Print a derivation as a module of pure-Python scalar functions that imports nothing but math."""

from __future__ import annotations

import sympy as sp

from derivations.emit.module import (
    all_series,
    assignments,
    called_functions,
    chained_body,
    coefficient_table,
    docstring,
    end_to_end,
    end_to_end_operations,
    header,
    output_units,
)
from derivations.record import Derivation, Function

POLYNOMIAL = '''\
def polynomial(coefficients: tuple[float, ...], v: float) -> float:
    """Evaluate a polynomial by Horner's rule, coefficients in rising order."""
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * v + coefficient
    return total
'''


def scalar_module(derivation: Derivation) -> str:
    """Return the text of ``granular/generated/NAME.py``."""
    series, units = all_series(derivation), output_units(derivation)
    bodies = [scalar_function(function, assignments(function), function.operations(), units)
              for function in derivation.functions]
    whole = end_to_end(derivation)
    if whole is not None:
        bodies.append(scalar_function(whole, chained_body(derivation), end_to_end_operations(derivation), units))
    imports = ["from __future__ import annotations\n"]
    if called_functions(bodies):
        imports.append(f"from math import {called_functions(bodies)}")
    parts = [header(derivation, "scalar functions"), "\n".join(imports).rstrip("\n") + "\n"]
    parts += [coefficient_table(one) for one in series]
    blocks = [*([POLYNOMIAL] if series else []), *bodies]
    return "\n".join(parts) + "\n\n" + "\n\n".join(blocks)


def scalar_function(function: Function, body: str, operations: int, units: dict[sp.Symbol, str]) -> str:
    """Return the text of one function."""
    arguments = ", ".join(f"{a.name}: float" for a in function.arguments)
    returns = ", ".join(["float"] * len(function.returns))
    signature = f"def {function.name}({arguments}) -> tuple[{returns}]:"
    if len(signature) > 110:
        signature = f"def {function.name}(\n    {arguments},\n) -> tuple[{returns}]:"
    return f"{signature}\n{docstring(function, 'float', operations, units)}\n{body}\n"
