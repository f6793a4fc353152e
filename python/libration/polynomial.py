"""Symbolic coefficients: sums of products of powers of symbols, with fractions before them."""

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

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

    @property
    def letters(self) -> tuple[str, ...]:
        """The symbols that occur, in alphabetical order."""
        return tuple(sorted({letter for _, powers in self.terms for letter, _ in powers}))

    def __call__(self, **values: Any) -> Any:
        """The value for these values of the symbols, numbers or arrays; numbers of the package
        uncertainties propagate theirs.
        """
        missing = [letter for letter in self.letters if letter not in values]
        if missing:
            wanted = ", ".join(self.letters)
            raise TypeError(f"no value for {', '.join(missing)}: give one for each of {wanted}")
        at = {letter: operand(letter, values[letter]) for letter in self.letters}
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
        """The same with SymPy's symbols, which are positive."""
        import sympy

        total: Any = sympy.Integer(0)
        for factor, powers in self.terms:
            term: Any = sympy.Rational(*factor.as_integer_ratio())
            for letter, exponent in powers:
                power = sympy.Rational(*exponent.as_integer_ratio())
                term *= sympy.Symbol(letter, positive=True) ** power
            total += term
        return total


def _product(factor: Fraction, powers: tuple[tuple[str, Fraction], ...]) -> str:
    names = [it if power == 1 else f"{it}^{_exponent(power)}" for it, power in powers]
    if names and abs(factor) == 1:
        return ("-" if factor < 0 else "") + "*".join(names)
    return "*".join([str(factor), *names])


def _exponent(exponent: Fraction) -> str:
    return str(exponent) if exponent.denominator == 1 else f"({exponent})"
