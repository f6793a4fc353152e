"""Equations of SymPy as text."""

from typing import Any


def text_of_sympy(given: Any) -> str:
    """An equation of SymPy as text: x(t) becomes x, its derivatives x' and x''."""
    import sympy

    equation: Any = given if isinstance(given, sympy.Equality) else sympy.Eq(given, 0, evaluate=False)
    functions = equation.atoms(sympy.core.function.AppliedUndef)
    derivatives = sorted(equation.atoms(sympy.Derivative), key=lambda it: -it.derivative_count)
    for it in derivatives:
        equation = equation.xreplace({it: sympy.Symbol(f"{it.expr.func.__name__}" + "'" * it.derivative_count)})
    for it in functions:
        equation = equation.xreplace({it: sympy.Symbol(it.func.__name__)})
    return f"{sympy.sstr(equation.lhs)} = {sympy.sstr(equation.rhs)}"
