"""Symbolic coefficients: sums of products of powers of symbols, with fractions before them."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from ._equations import constant_of_sympy
from ._numbers import operand

if TYPE_CHECKING:
    import sympy

__all__ = ["Polynomial"]


@dataclass(frozen=True)
class Polynomial:
    """A sum of terms; exponents may be negative, and halves.

    Examples
    --------
    >>> import libration as lb
    >>> shift = lb.expand("x'' + w^2*x + b*x^3 = 0", order=3).frequency.coefficients[2]
    >>> str(shift), shift(b=0.5, w=2.0)
    ('3/8*b*w^-2', 0.046875)
    """

    terms: tuple[tuple[Fraction, tuple[tuple[str, Fraction], ...]], ...]
    """For each term its fraction, and its symbols with their exponents."""
    constants: Mapping[str, tuple[str, float]] = field(default_factory=dict, compare=False)
    """Formulas and values of the names that are no symbols: of ``pi``, and of ``c1`` for √2."""
    symbols: "Mapping[str, sympy.Symbol]" = field(default_factory=dict, compare=False, repr=False)
    """SymPy's symbols, where the equation had them."""

    @property
    def letters(self) -> tuple[str, ...]:
        """The symbols that occur, in alphabetical order."""
        names = {letter for _, powers in self.terms for letter, _ in powers}
        return tuple(sorted(it for it in names if not self._is_constant(it)))

    def _is_constant(self, name: str) -> bool:
        return name in self.constants and self.constants[name][1] == self.constants[name][1]

    def __call__(self, **values: Any) -> Any:
        """The value for these values of the symbols, numbers or arrays; numbers of the package
        uncertainties propagate theirs.
        """
        missing = [letter for letter in self.letters if letter not in values]
        if missing:
            wanted = ", ".join(self.letters)
            raise TypeError(f"no value for {', '.join(missing)}: give one for each of {wanted}")
        at: dict[str, Any] = {name: value for name, (_, value) in self.constants.items()}
        at |= {letter: operand(letter, values[letter]) for letter in self.letters}
        total: Any = 0.0
        for factor, powers in self.terms:
            term: Any = float(factor)
            for letter, exponent in powers:
                term = term * at[letter] ** float(exponent)
            total += term
        return total

    def __str__(self) -> str:
        return " + ".join(_product(*term) for term in self.terms).replace("+ -", "- ") or "0"

    def to_sympy(self) -> "sympy.Expr":
        """The polynomial in SymPy, with the symbols of the equation, else with positive ones."""
        import sympy

        letters = {it: sympy.Symbol(it, positive=True) for it in self.letters} | {**self.symbols}
        known = {it: constant_of_sympy(text, letters) for it, (text, _) in self.constants.items()}
        total: Any = sympy.Integer(0)
        for factor, powers in self.terms:
            term: Any = sympy.Rational(*factor.as_integer_ratio())
            for letter, exponent in powers:
                power = sympy.Rational(*exponent.as_integer_ratio())
                term *= (known[letter] if letter in known else letters[letter]) ** power
            total += term
        return total


def _product(factor: Fraction, powers: tuple[tuple[str, Fraction], ...]) -> str:
    names = [it if power == 1 else f"{it}^{_exponent(power)}" for it, power in powers]
    if names and abs(factor) == 1:
        return ("-" if factor < 0 else "") + "*".join(names)
    return "*".join([str(factor), *names])


def _exponent(exponent: Fraction) -> str:
    return str(exponent) if exponent.denominator == 1 else f"({exponent})"
