"""Print expressions as arithmetic that keeps integers whole, so that exact input gives exact output."""

from __future__ import annotations

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter


class ArithmeticPrinter(PythonCodePrinter):
    """Python source with ``3*p0/8`` instead of ``(3/8)*p0``: only + - * / on integers and arguments.

    Fed with ``fractions.Fraction`` the code is then exact; fed with floats every quotient is rounded once.
    """

    def __init__(self) -> None:
        """Leave out module names: emitted modules import what they call."""
        super().__init__({"fully_qualified_modules": False, "allow_unknown_functions": True})

    def _print_Mul(self, expr: sp.Mul) -> str:
        """Numerator factors first, then one division by the product of the denominator's factors."""
        above: list[str] = []
        below: list[str] = []
        sign = ""
        for factor in expr.args if not expr.is_commutative or _unevaluated(expr) else expr.as_ordered_factors():
            if factor.is_Rational:
                sign = "-" if (factor < 0) != (sign == "-") else ""
                if abs(factor.p) != 1:
                    above.insert(0, str(abs(factor.p)))
                if factor.q != 1:
                    below.insert(0, str(factor.q))
            elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
                below.append(self._factor(sp.Pow(factor.base, -factor.exp)))
            else:
                above.append(self._factor(factor))
        numerator = "*".join(above) or "1"
        if not below:
            return sign + numerator
        denominator = "*".join(below)
        if "*" in denominator:
            denominator = f"({denominator})"
        return f"{sign}{numerator}/{denominator}"

    def _factor(self, factor: sp.Expr) -> str:
        text = self._print(factor)
        return f"({text})" if factor.is_Add else str(text)

    def _print_Rational(self, expr: sp.Rational) -> str:
        return f"{expr.p}/{expr.q}"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        """Square and cube roots by name, small whole powers as products, everything else as a power."""
        del rational
        if abs(expr.exp) == sp.Rational(1, 3):
            return f"{'1/' if expr.exp < 0 else ''}cbrt({self._print(expr.base)})"
        if expr.exp == sp.Rational(1, 2):
            return f"sqrt({self._print(expr.base)})"
        if expr.exp == sp.Rational(-1, 2):
            return f"1/sqrt({self._print(expr.base)})"
        if expr.exp == -1:
            return f"1/{self._factor(expr.base)}"
        if expr.exp in (2, 3) and expr.base.is_Symbol:
            return "*".join([self._print(expr.base)] * int(expr.exp))
        power = self._print(expr.exp)
        whole_or_name = expr.exp.is_Integer or expr.exp.is_Symbol
        return f"{self._factor(expr.base)}**{power if whole_or_name else f'({power})'}"


def _unevaluated(expr: sp.Mul) -> bool:
    return bool(expr.args and expr != sp.Mul(*expr.args))


def python_source(expression: sp.Expr) -> str:
    """Print one expression as Python arithmetic."""
    return str(ArithmeticPrinter().doprint(expression))
