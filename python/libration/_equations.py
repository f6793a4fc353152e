"""Equations of SymPy as text, with the symbols that they have."""

from functools import cache
from typing import Any

from .errors import UsageError


def text_of_sympy(given: Any) -> str:
    """An equation of SymPy as text: x(t) becomes x, its derivatives x' and x''.

    Raises
    ------
    UsageError
        Numbers, and pieces of functions, that no formula of the package describes.
    """
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
    printed = _printer()().doprint
    return f"{printed(equation.lhs)} = {printed(equation.rhs)}"


def symbols_of_sympy(given: Any) -> dict[str, Any]:
    """The symbols of an equation by their names, with their assumptions.

    Raises
    ------
    UsageError
        Two symbols with the same name and different assumptions.
    """
    found: dict[str, Any] = {}
    for symbol in given.free_symbols:
        if found.setdefault(symbol.name, symbol) != symbol:
            raise UsageError(
                f"two symbols are called {symbol.name}: give them different names, or the same "
                "assumptions"
            )
    return found


def constant_of_sympy(formula: str, symbols: dict[str, Any]) -> Any:
    """A constant of the package, such as ``sqrt(2)``, as SymPy has it."""
    import sympy

    names = {"ln": sympy.log, "abs": sympy.Abs, **symbols}
    return sympy.sympify(formula.replace("^", "**"), locals=names)


@cache
def _printer() -> Any:
    """A printer for the functions that SymPy calls otherwise, or that the package has not."""
    import sympy
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):  # type: ignore[misc]
        def _print_Abs(self, it: Any) -> str:
            return f"abs({self._print(it.args[0])})"

        def _print_log(self, it: Any) -> str:
            return f"ln({self._print(it.args[0])})"

        def _print_Exp1(self, it: Any) -> str:
            return "exp(1)"

        def _print_Float(self, it: Any) -> str:
            return repr(float(it)) if it._prec == 53 else super()._print_Float(it)

        def _print_Heaviside(self, it: Any) -> str:
            if it.args[1] != sympy.S.Half:
                raise refused(it, "give it the value 1/2 at zero")
            return f"((1 + sign({self._print(it.args[0])}))/2)"

        def _print_Max(self, it: Any) -> str:
            return self._extreme(it, "+")

        def _print_Min(self, it: Any) -> str:
            return self._extreme(it, "-")

        def _extreme(self, it: Any, sign: str) -> str:
            first, *others = [self._print(arg) for arg in it.args]
            for other in others:
                first = f"(({first} + ({other}) {sign} abs({first} - ({other})))/2)"
            return first

        def _print_sec(self, it: Any) -> str:
            return f"(1/cos({self._print(it.args[0])}))"

        def _print_csc(self, it: Any) -> str:
            return f"(1/sin({self._print(it.args[0])}))"

        def _print_cot(self, it: Any) -> str:
            return f"(1/tan({self._print(it.args[0])}))"

        def _print_Piecewise(self, it: Any) -> str:
            return f"({self._print(_in_one_formula(it, list(it.args)))})"

    def unknown(self: Any, it: Any) -> str:
        raise refused(it, "give its digits, or a symbol with a value")

    for name in ("EulerGamma", "Catalan", "GoldenRatio", "TribonacciConstant", "ImaginaryUnit"):
        setattr(Printer, f"_print_{name}", unknown)
    for name in ("Infinity", "NegativeInfinity", "ComplexInfinity", "NaN"):
        setattr(Printer, f"_print_{name}", unknown)
    return Printer


def _in_one_formula(given: Any, pieces: list[Any]) -> Any:
    """A function in pieces by the signs of differences, at which it is the mean of its pieces."""
    import sympy

    (piece, condition), *others = pieces
    if condition == sympy.true:
        return piece
    if not isinstance(condition, (sympy.Gt, sympy.Ge, sympy.Lt, sympy.Le)):
        raise refused(given, "give conditions such as x > 0, one a piece")
    if not others:
        raise refused(given, "its pieces do not cover all values")
    rest = _in_one_formula(given, others)
    above = condition.gts - condition.lts
    return (piece + rest) / 2 + sympy.sign(above) * (piece - rest) / 2


def refused(given: Any, reason: str) -> UsageError:
    """The error for what has no formula in the package."""
    return UsageError(f"{given} of SymPy has no formula here: {reason}")
