"""Equations of SymPy as text, with the symbols that they have."""

import re
from functools import cache
from typing import Any, NamedTuple

from ._names import FUNCTIONS, name_in_formulas
from .errors import UsageError


def text_of_sympy(given: Any) -> str:
    """An equation of SymPy as text, or an expression as one that is zero."""
    return equation_of_sympy(given).text


class Equation(NamedTuple):
    """An equation of SymPy, or several, as formulas have them."""

    text: str
    symbols: dict[str, Any]
    """SymPy's symbols, with their assumptions, by their names in the text."""


def motion_of_sympy(given: Any) -> Equation:
    """Equations of motion: x(t) becomes x, its derivatives x' and x'', and the time t.

    Raises
    ------
    UsageError
        As for `equation_of_sympy`; a function without a derivative.
    """
    found = equation_of_sympy(given)
    together = _together(given)
    moving = {it.expr for it in _of_kind(together, "Derivative")}
    for it in _of_kind(together, "AppliedUndef"):
        if moving and it not in moving:
            raise refused(
                it,
                "it has no derivative in the equation: write it out as a formula, give a symbol "
                "for a constant, or a list with an equation for each function",
            )
    return found


def equation_of_sympy(given: Any) -> Equation:
    """An equation of SymPy, an expression that is zero, or a list of them, as text and symbols.

    Raises
    ------
    UsageError
        Numbers, functions, and derivatives that no formula of the package describes; names that
        formulas read as something else; different symbols with the same name.
    """
    import sympy

    together = _together(given)
    for it in together:
        is_one = isinstance(it, (sympy.Equality, sympy.Expr))
        if not is_one or getattr(it, "is_Matrix", False):
            raise UsageError(
                f"got {type(it).__name__} of SymPy: give an equation, such as "
                "Eq(x(t).diff(t, 2) + x(t), 0), or an expression that is zero"
            )
    time = _time(together)
    names = _names(together, time)
    text = "; ".join(
        " = ".join(
            _printed(side, names)
            for side in (it.args if isinstance(it, sympy.Equality) else (it, sympy.S.Zero))
        )
        for it in together
    )
    if re.search(r"\bd\w*/dt[23]?\b", text):
        raise UsageError("a symbol dt below a fraction is read as a derivative: rename it")
    symbols = {it.name: old for old, it in names.items() if _is_letter(old) and old != time}
    return Equation(text, symbols)


def is_of_sympy(given: Any) -> bool:
    """True for an equation or expression of SymPy with symbols, and for a list of them."""
    if isinstance(given, (list, tuple)):
        return bool(given) and all(map(is_of_sympy, given))
    return hasattr(given, "free_symbols") and not getattr(given, "is_number", False)


def _together(given: Any) -> Any:
    """One equation, or several, as a tuple of SymPy."""
    import sympy

    is_several = isinstance(given, (list, tuple, sympy.Tuple))
    return sympy.Tuple(*given) if is_several else sympy.Tuple(given)


def formula_of_sympy(given: Any) -> str:
    """A number or an expression of SymPy as a formula."""
    return _printed(given, _names(given, _time(given)))


def _printed(given: Any, names: dict[Any, Any]) -> str:
    return str(_printer()().doprint(given.xreplace(names)))


def _of_kind(given: Any, kind: str) -> list[Any]:
    """The applied functions, or the derivatives, in a given order."""
    import sympy

    return sorted(given.atoms(getattr(sympy.core.function, kind)), key=str)


def _is_letter(it: Any) -> bool:
    """True for a symbol, and for one with an index, such as ``k[1]``."""
    import sympy

    return isinstance(it, (sympy.Symbol, sympy.Indexed))


def _names(given: Any, time: Any) -> dict[Any, Any]:
    """The symbol in place of each derivative, function and symbol."""
    import sympy

    functions, found = _of_kind(given, "AppliedUndef"), dict[Any, Any]()
    owners: dict[str, Any] = {} if time is None else {"t": time, time.name: time}
    letters = given.atoms(sympy.Symbol, sympy.Indexed) - {time}
    for it in [*functions, *sorted(letters, key=str)]:
        name = it.name if _is_letter(it) else it.func.__name__
        # Without functions, names with primes are derivatives, as in text.
        marks = 0 if functions else min(2, len(name) - len(name.rstrip("'")))
        name = name_in_formulas(it, name[: len(name) - marks]) + "'" * marks
        if owners.setdefault(name, it) != it:
            raise _two(name, owners[name], it, time)
        assumptions = it.assumptions0 if _is_letter(it) else {}
        found[it] = sympy.Symbol(name, **assumptions)
    for it in _of_kind(given, "Derivative"):
        found[it] = sympy.Symbol(found[it.expr].name + "'" * it.derivative_count)
    if time is not None:
        found[time] = sympy.Symbol("t", **time.assumptions0)
    return found


def _two(name: str, first: Any, second: Any, time: Any) -> UsageError:
    """The error for a name that two symbols or functions have."""
    if first == time and str(second) != str(time):
        return UsageError(
            f"{second} is not the time of this equation, which is {time} and is written t in "
            "formulas: give it another name"
        )
    kinds = [_is_letter(it) for it in (first, second)]
    if any(kinds) and not all(kinds):
        return UsageError(
            f"a function and a symbol are called {name}: write the function with its argument "
            "everywhere, or give the symbol another name"
        )
    what = "symbols" if all(kinds) else "functions"
    return UsageError(
        f"two {what} are called {name}: give them different names, or the same assumptions"
    )


def _time(given: Any) -> Any:
    """The symbol on which all functions depend; None without functions.

    Raises
    ------
    UsageError
        Functions of something else, such as x(t - 1) and x(0); derivatives of something else, or
        by something else.
    """
    functions = _of_kind(given, "AppliedUndef")
    for it in functions:
        _refuse_arguments(it)
    for it in functions[1:]:
        if it.args != functions[0].args:
            raise refused(it, f"{functions[0]} depends on another symbol: give one time for both")
    time = functions[0].args[0] if functions else None
    for it in _of_kind(given, "Derivative"):
        if it.expr not in functions:
            raise refused(it, "write it with derivatives of functions alone, as .doit() does")
        if any(by != time for by, _ in it.variable_count):
            raise refused(it, f"give derivatives by {time}, on which {it.expr} depends")
        if not it.derivative_count.is_Integer:
            raise refused(it, "give the order of the derivative as a number")
    return time


def _refuse_arguments(it: Any) -> None:
    """Refuses functions of anything but one symbol."""
    function = it.func.__name__
    if len(it.args) != 1:
        raise refused(it, f"give a function of the time alone, such as {function}(t)")
    (argument,) = it.args
    if argument.is_Symbol:
        return
    if _of_kind(argument, "AppliedUndef"):
        raise refused(it, f"write the function {function} out, as in sin(x(t))")
    if not argument.free_symbols:
        raise refused(it, "it is a value at one time: give a symbol for it")
    raise refused(
        it,
        f"it is {function} at another time than {function}(t), which no equation here can have: "
        "give all functions the same symbol, without delays or factors",
    )


def constant_of_sympy(formula: str, symbols: dict[str, Any]) -> Any:
    """A constant of the package, such as ``sqrt(2)``, as SymPy has it.

    Letters are symbols, those too that SymPy or Python would read otherwise, as E and lambda.
    """
    import sympy

    known: dict[str, Any] = {"ln": sympy.log, "abs": sympy.Abs, "sign": sympy.sign}
    letters: dict[str, Any] = {}

    def placeholder(found: re.Match[str]) -> str:
        name = found[0]
        if name in FUNCTIONS or name == "pi":
            return name
        letters[f"_{name}"] = symbols.get(name, sympy.Symbol(name))
        return f"_{name}"

    text = re.sub(r"(?<![\w.])[A-Za-z]\w*", placeholder, formula.replace("^", "**"))
    return sympy.sympify(text, locals=known | letters)


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
            return repr(float(it)) if it._prec == 53 else str(super()._print_Float(it))

        def _print_Heaviside(self, it: Any) -> str:
            if it.args[1] != sympy.S.Half:
                raise refused(it, "give it the value 1/2 at zero")
            return f"((1 + sign({self._print(it.args[0])}))/2)"

        def _print_Max(self, it: Any) -> str:
            return self._extreme(it, "+")

        def _print_Min(self, it: Any) -> str:
            return self._extreme(it, "-")

        def _extreme(self, it: Any, sign: str) -> str:
            first, *others = [str(self._print(arg)) for arg in it.args]
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

        def _print_Function(self, it: Any) -> str:
            name = it.func.__name__
            is_known = name in FUNCTIONS and it.func is getattr(sympy, name, None)
            if not is_known or len(it.args) != 1:
                known = ", ".join(FUNCTIONS)
                raise refused(it, f"{name} is not a known function; the functions are {known}")
            return f"{name}({self._print(it.args[0])})"

    def unknown(self: Any, it: Any) -> str:
        raise refused(it, "give its digits, or a symbol with a value")

    def unwritten(self: Any, it: Any) -> str:
        raise refused(it, "write it with sums, products, powers and functions, as .doit() does")

    for name in ("Integral", "Sum", "Product", "Limit", "Subs"):
        setattr(Printer, f"_print_{name}", unwritten)
    setattr(Printer, "_print_Quantity", unknown)

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
