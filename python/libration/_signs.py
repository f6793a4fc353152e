"""Symbols of SymPy that are declared not to be positive, where roots of letters are taken.

The root of w² is w in all results of the package: its letters are positive. Of a negative symbol
that would be the wrong sign.
"""

import re
from collections.abc import Collection, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from ._equations import constant_of_sympy
from .errors import UsageError
from .polynomial import Polynomial

if TYPE_CHECKING:
    from .expansion import Expansion, Series


def not_positive(symbols: dict[str, Any], with_value: Collection[str] = ()) -> list[str]:
    """The names of symbols without a value that are declared not to be positive."""
    declared = [name for name, it in symbols.items() if it.is_positive is False]
    return sorted(name for name in declared if name not in with_value)


def refuse(names: list[str], symbols: dict[str, Any]) -> None:
    """Refuses the first of these symbols."""
    for name in names:
        kind = "negative" if symbols[name].is_negative else "not positive"
        has_opposite = symbols[name].is_extended_nonpositive
        another = f"write -{name} with a positive" if has_opposite else "give a positive"
        raise UsageError(
            f"the symbol {name} is declared {kind}, and letters in results are positive: {another} "
            f"symbol {name}, or a value with set"
        )


def refuse_assumed(given: Any, symbols: dict[str, Any], found: "Expansion") -> None:
    """Refuses symbols that are declared not to be positive where a result takes them for positive.

    A result that is a rational or smooth function of a symbol, as its equation is, and without a
    root of it, is an identity for all its real values: so for the strength of a cubic force.
    """
    names = not_positive(symbols)
    refuse([it for it in names if _is_assumed(it, given, symbols, found)], symbols)


def _is_assumed(name: str, given: Any, symbols: dict[str, Any], found: "Expansion") -> bool:
    """True where the result may hold for positive values of the symbol only."""
    polynomials = list(_polynomials(found))
    constants = dict(pair for it in polynomials for pair in it.constants.items())
    formulas = {
        constant: formula
        for constant, (formula, _) in constants.items()
        if re.search(rf"(?<!\w){re.escape(name)}(?!\w)", formula)
    }
    letters = {name, *formulas}
    powers = [pair for it in polynomials for _, factors in it.terms for pair in factors]
    if not any(letter in letters for letter, _ in powers):
        return False
    symbol, square = symbols[name], found.omega0_squared
    # The root of a sum is not taken: it is a letter of its own, and positive where motions exist.
    terms = square.terms if isinstance(square, Polynomial) else ()
    of_root = terms[0][1] if len(terms) == 1 else ()
    has_roots = any(letter in letters for letter, _ in of_root) or any(
        letter in letters and power.denominator != 1 for letter, power in powers
    )
    expressions = [given, *(constant_of_sympy(it, symbols) for it in formulas.values())]
    is_smooth = all(_is_smooth_in(symbol, it) for it in expressions)
    # Which limit cycles are stable depends on signs.
    return has_roots or not is_smooth or not symbol.is_extended_real or found.gauge is None


def _is_smooth_in(symbol: Any, given: Any) -> bool:
    """True if a symbol occurs in sums, products, whole powers and smooth functions alone."""
    import sympy

    smooth = (sympy.sin, sympy.cos, sympy.tan, sympy.sinh, sympy.cosh, sympy.tanh, sympy.exp)
    kinds = (sympy.Symbol, sympy.Add, sympy.Mul, sympy.Equality, sympy.atan, *smooth)
    return all(
        isinstance(it, kinds) or (it.is_Pow and it.exp.is_Integer)
        for it in sympy.preorder_traversal(given)
        if it.has(symbol)
    )


def _polynomials(found: "Expansion") -> Iterator[Polynomial]:
    """All symbolic coefficients."""
    of_gauge = found.gauge_series
    series: list[Series | None] = [
        found.frequency,
        found.period,
        found.epsilon,
        *found.harmonics.values(),
        *(found.half_swing or ()),
        *(of_gauge.frequency, of_gauge.x_max, of_gauge.x_min),
        *of_gauge.cos.values(),
        *of_gauge.sin.values(),
    ]
    own: Iterable[Any] = (found.equilibrium, found.omega0_squared, found.unit_squared)
    terms = (it for one in series if one is not None for it in one.coefficients)
    yield from (it for it in (*own, *terms) if isinstance(it, Polynomial))
