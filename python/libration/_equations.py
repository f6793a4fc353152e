"""Equations of SymPy as text."""

from typing import Any


def text_of_sympy(given: Any) -> str:
    """An equation of SymPy as text: x(t) becomes x, its derivatives x' and x''."""
    import sympy

    is_equation = isinstance(given, sympy.Equality)
    equation: Any = given if is_equation else sympy.Eq(given, 0, evaluate=False)
    functions = equation.atoms(sympy.core.function.AppliedUndef)
    derivatives = sorted(equation.atoms(sympy.Derivative), key=lambda it: -it.derivative_count)
    for it in derivatives:
        name = it.expr.func.__name__ + "'" * it.derivative_count
        equation = equation.xreplace({it: sympy.Symbol(name)})
    for it in functions:
        equation = equation.xreplace({it: sympy.Symbol(it.func.__name__)})
    return f"{sympy.sstr(equation.lhs)} = {sympy.sstr(equation.rhs)}"
