"""Periodic motions of any oscillator as exact power series.

>>> import libration as lb
>>> s = lb.expand("x'' + sin(x) = 0", order=5)
>>> s.frequency.coefficients
(Fraction(1, 1), Fraction(0, 1), Fraction(-1, 16), Fraction(0, 1), Fraction(1, 3072))
>>> s.period.coefficients[4]
Fraction(11, 3072)
>>> print(s.evaluate(0.5))
1.0158487955729167 (left out: at most 3.9e-06)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Context, Decimal
from fractions import Fraction
from math import isqrt, sqrt
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, overload

import numpy as np
from numpy.typing import NDArray

from . import _ask, _native, _plot, _signs, questions
from ._equations import Equation, motion_of_sympy
from ._numbers import Number, Numbers, floats, operand, whole
from ._numbers import text as _text
from ._progress import Tell, go_on, told
from ._record import Record, Shown
from .errors import ExpansionError, UsageError
from .polynomial import Polynomial

if TYPE_CHECKING:
    import sympy
    from matplotlib.axes import Axes

__all__ = ["Coefficient", "Evaluation", "Expansion", "GaugeSeries", "Series", "expand"]

Coefficient: TypeAlias = Fraction | Polynomial | Decimal
"""A fraction, a polynomial in symbols and constants such as π, or a number rounded to digits."""


@dataclass(frozen=True)
class Series:
    """A power series: ``coefficients[n]`` stands before the n-th power of a variable."""

    coefficients: tuple[Coefficient, ...]
    """Coefficients by ascending powers, from the zeroth: fractions if exact, else decimals."""
    variable: str
    """The name of the variable, such as ``"A"``."""

    def __len__(self) -> int:
        return len(self.coefficients)

    def __getitem__(self, power: int) -> Coefficient:
        return self.coefficients[power]

    @overload
    def __call__(self, x: Number, **letters: Number) -> float: ...
    @overload
    def __call__(self, x: Any, **letters: Any) -> Any: ...
    def __call__(self, x: Any, **letters: Any) -> Any:
        """The sum of the terms, with values for symbols; `Expansion.evaluate` has a bound.

        Arrays give arrays, and numbers of the package uncertainties propagate theirs.
        """
        at = operand("x", x)
        total: Any = 0.0
        for c in reversed(self.coefficients):
            total = total * at + (c(**letters) if isinstance(c, Polynomial) else float(c))
        return total

    def __str__(self) -> str:
        present = [(n, c) for n, c in enumerate(self.coefficients) if not _is_zero(c)]
        terms = [_term(c, self.variable, n) for n, c in present]
        return " + ".join(terms).replace("+ -", "- ") or "0"

    def to_sympy(self) -> "sympy.Expr":
        """The polynomial with SymPy's exact numbers and symbols; rounded coefficients are floats
        with their digits.
        """
        import sympy

        x = sympy.Symbol(self.variable)
        total: Any = sympy.Integer(0)
        for n, c in enumerate(self.coefficients):
            if isinstance(c, Polynomial):
                total += c.to_sympy() * x**n
            elif isinstance(c, Decimal):
                total += sympy.Float(str(c), _DIGITS) * x**n
            else:
                total += sympy.Rational(c.numerator, c.denominator) * x**n
        return total

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {_native.latex(str(self))}$"


@dataclass(frozen=True)
class GaugeSeries:
    """The series by powers of the parameter ε that a gauge defines, or of the strength of a
    self-excitation.
    """

    frequency: Series
    """Ω/ω0."""
    cos: dict[int, Series]
    """Coefficients of cos kΩt, by k."""
    sin: dict[int, Series]
    """Coefficients of sin kΩt, by k."""
    x_max: Series
    """The largest displacement."""
    x_min: Series
    """The smallest displacement."""


@dataclass(frozen=True, eq=False, repr=False)
class Evaluation(Record, Shown):
    """A series in numbers, term by term.

    Of an array of amplitudes numbers are arrays, and the terms of each stand along the last axis.
    """

    value: float | NDArray[np.float64]
    """The sum of all terms, rounded to a float."""
    remainder: float | NDArray[np.float64]
    """A bound on the remainder, or an estimate where it is not proven, without the rounding;
    infinite where the series is not known to converge.
    """
    is_proven: bool
    """True if the remainder is proven; False for an estimate from the decay of the terms."""
    powers: NDArray[np.int64]
    """The powers of the terms that are not zero."""
    terms: NDArray[np.float64]
    """The terms, from the lowest power on."""
    sums: NDArray[np.float64]
    """Up to and with each term."""

    def _facts(self) -> list[tuple[str, object]]:
        left_out = "left out, at most" if self.is_proven else "left out, about"
        return [("value", self.value), (left_out, self.remainder), ("terms", len(self.powers))]

    def __str__(self) -> str:
        bound = "at most" if self.is_proven else "about"
        if np.ndim(self.value) > 0:
            return f"{self.value} (left out: {bound} {self.remainder})"
        if self.remainder == np.inf:
            return f"{self.value!r} (no bound on the remainder)"
        kind = "" if self.is_proven else ", an estimate"
        return f"{self.value!r} (left out: {bound} {self.remainder:.2g}{kind})"


@dataclass(frozen=True, eq=False)
class Expansion(Record):
    """Periodic motions x = xₑ + Σₖ aₖ·cos kΩt + bₖ·sin kΩt as power series; `expand` makes it.

    `frequency`, `period` and `harmonics` are by powers of the amplitude, the largest displacement
    from the equilibrium; of a limit cycle, whose amplitude is not free, by powers of the strength
    of its excitation.
    """

    equation: str
    """The equation, as it was read."""
    displacement: str
    """The name of the displacement."""
    order: int
    """The highest power of the displacement, for a limit cycle also of the frequency,
    which otherwise has one power less.
    """
    frequency: Series
    """Ω/ω0."""
    period: Series | None
    """T/T0; None for a limit cycle."""
    harmonics: dict[int, Series]
    """aₖ by k; bₖ where `phase_origin` is "passage", of limit cycles both are in `gauge_series`."""
    half_swing: "tuple[Series, Series] | None"
    """Ω/ω0 and T/T0 by powers of half the distance of the turning points, for asymmetric wells."""
    epsilon: Series | None
    """The parameter of the gauge by powers of the amplitude."""
    gauge: str | None
    """Meaning of ε; None for a limit cycle."""
    gauge_series: GaugeSeries
    """The series in powers of ε, or of the strength."""
    phase_origin: str
    """State of the motion at t = 0: "turning_point", "passage" or "first_harmonic"."""
    equilibrium: Coefficient
    """The equilibrium."""
    omega0_squared: Coefficient
    """ω0², the squared frequency of small oscillations."""
    unit_squared: Coefficient
    """Harmonics and turning points of limit cycles are in units of the root of this."""
    constants: dict[str, str]
    """Names in the coefficients that stand for other constants."""
    digits: int | None
    """Number of right digits of each coefficient, then a `decimal.Decimal`; None where coefficients
    are exact.
    """
    is_proven: bool
    """True if a second, exact computation proves at least the frequency by the amplitude."""
    _question: Any = field(repr=False, compare=False)
    _expansion: Any = field(repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_expansion": None}

    @property
    def omega0(self) -> Coefficient | None:
        """ω0, the frequency of small oscillations; None where its square is a sum with symbols.

        Examples
        --------
        >>> import libration as lb
        >>> print(lb.expand("x'' + 2*x + x^3 = 0").omega0)
        sqrt(2)
        """
        return _root(self.omega0_squared)

    @property
    def angular_frequency(self) -> Series | None:
        """Ω itself, as `frequency` is expanded; None where `omega0` is None."""
        omega0 = self.omega0
        if omega0 is None:
            return None
        if self.digits is not None and isinstance(self.omega0_squared, Fraction):
            omega0 = _CONTEXT.sqrt(_rounded(self.omega0_squared))
        products = tuple(_product(omega0, c) for c in self.frequency.coefficients)
        return Series(products, self.frequency.variable)

    def evaluate(self, amplitude: Numbers, quantity: str = "period") -> Evaluation:
        """A series at an amplitude, or a strength of self-excitation, with a bound on the rest.

        The sum itself is rounded once.

        Parameters
        ----------
        amplitude : array_like
            The largest displacement from the equilibrium; where that is an angle, in radians. A
            number or an array of any shape.
        quantity : str
            ``"period"`` (T/T0), ``"frequency"`` (Ω/ω0), or a harmonic, such as ``"a3"``.

        Examples
        --------
        >>> import libration as lb
        >>> s = lb.expand("pendulum", order=31)
        >>> print(s.evaluate(1.0471975511965976))
        1.0731820071493643 (left out: at most 2.6e-17)
        """
        expansion = self._expansion
        if expansion is None:  # after a pickle
            question, order, gauge = self._question
            expansion, _ = _native.expand(question, order, gauge, None)
            object.__setattr__(self, "_expansion", expansion)
        amplitudes = floats("amplitude", amplitude)
        if not np.isfinite(amplitudes).all():
            raise ExpansionError(f"amplitude: got {amplitude!r}: give finite numbers")
        name = _text("quantity", quantity, "period")
        found = [expansion.evaluate(float(it), name) for it in amplitudes.flat]
        if not found:
            raise ExpansionError("amplitude: got an empty array: give at least one amplitude")
        powers = np.array([power for power, _, _ in found[0][3]], dtype=np.int64)
        steps = [[step[1:] for step in it[3]] for it in found]
        columns = np.array(steps).reshape(*amplitudes.shape, len(powers), 2)
        if amplitudes.ndim == 0:
            one, left_out, is_theorem, _ = found[0]
            return Evaluation(one, left_out, is_theorem, powers, columns[..., 0], columns[..., 1])
        value, remainder = np.array([it[:2] for it in found]).T.reshape(2, *amplitudes.shape)
        is_proven = all(it[2] for it in found)
        return Evaluation(value, remainder, is_proven, powers, columns[..., 0], columns[..., 1])

    def _given(self) -> dict[str, Any]:
        (text, values, letters, about), order, gauge = self._question
        given: dict[str, Any] = {"oscillator": text, "set": dict(values), "about": about}
        given |= {"letters": letters or None, "order": order}
        return given | ({"gauge": gauge} if self.gauge is not None else {})

    def to_dict(self) -> dict[str, Any]:
        """The series as `libration expand` has them in JSON."""
        return questions.expand(**self._given()).to_dict()

    def code(self, language: Literal["c", "python", "rust", "fortran"] = "c") -> str:
        """Frequency, period and displacement as functions of a programming language.

        Examples
        --------
        >>> import libration as lb
        >>> print(lb.expand("duffing", order=3).code("python").splitlines()[0])
        # Duffing oscillator: x'' + x + x^3 = 0
        """
        languages = ("c", "python", "rust", "fortran")
        if language not in languages:
            known = ", ".join(languages)
            raise UsageError.about("language", f"unknown value `{language}`: give one of {known}")
        return _ask.text("expand", {**self._given(), "format": language})

    def to_latex(self) -> str:
        """All series in LaTeX."""
        return _ask.text("expand", {**self._given(), "format": "latex"})

    def plot(self, ax: "Axes | None" = None, amplitudes: Numbers | None = None) -> "Axes":
        """Draws partial sums of the frequency against the amplitude, or against the strength.

        Parameters
        ----------
        ax : matplotlib.axes.Axes
            The axes to draw into; new ones, if they are not given.
        amplitudes : array_like
            Amplitudes; from 0 to 1, if they are not given.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ExpansionError
            Coefficients contain symbols.
        """
        if any(isinstance(c, Polynomial) and c.letters for c in self.frequency.coefficients):
            raise ExpansionError("the coefficients contain symbols: give them values with set")
        given = np.linspace(0, 1, 201) if amplitudes is None else amplitudes
        at = floats("amplitudes", given).ravel()
        ax = _plot.axes(ax, (self.frequency.variable, "Ω/ω0"))
        coefficients = enumerate(self.frequency.coefficients)
        powers = [power for power, c in coefficients if power and not _is_zero(c)]
        for power in powers[-6:]:
            part = Series(self.frequency.coefficients[: power + 1], self.frequency.variable)
            ax.plot(at, [part(x) for x in at], label=f"to {self.frequency.variable}^{power}")
        _plot.legend(ax)
        return ax

    def __str__(self) -> str:
        return f"{self.equation}: Ω/ω0 = {self.frequency} + …"

    def _repr_latex_(self) -> str:
        series = _native.latex(str(self.frequency))
        return f"$\\displaystyle \\frac{{\\Omega}}{{\\omega_0}} = {series} + \\dots$"


def expand(
    oscillator: "str | sympy.Eq | sympy.Expr",
    order: int = 7,
    *,
    set: Mapping[str, _ask.Value] | None = None,
    letters: str | Sequence[str] = (),
    about: _ask.Value | None = None,
    gauge: str = "fundamental",
    progress: bool | Tell = False,
) -> Expansion:
    """The exact perturbation series of an oscillator, to any order.

    Parameters
    ----------
    oscillator : str or sympy.Eq or sympy.Expr
        An equation of motion, such as ``"x'' + x + a*x^3 = 0"``, a key of the catalogue, such as
        ``"pendulum"`` or ``"van_der_pol"``, or an equation of SymPy for a function of one symbol,
        which is the time, whatever its name (an expression is one that is zero). Parameters without
        a value are symbolic, and positive where a root of them is taken.
    order : int
        Up to this power of the amplitude, from 1 to 1000.
    set : dict
        Values of parameters: numbers, fractions, or formulas such as ``"1/2"``. Floats are taken as
        the decimals that they print as.
    letters : str or sequence of str
        Parameters of a named oscillator that stay letters, such as ``"epsilon"``.
    about : float or str
        The equilibrium; the one nearest to zero if it is not given.
    gauge : str
        Meaning of the parameter ε: ``"fundamental"``, ``"x_max"``, ``"half_swing"``, ``"energy"``,
        ``"nome"``, or ``"A1=1,A3=-1/192"``.
    progress : bool or callable
        True for a bar, where tqdm is installed; or a function of how much is done and of how much
        (or None).

    Returns
    -------
    Expansion

    Raises
    ------
    ExpansionError
        Text that is not an equation, an equation without a stable equilibrium, an invalid order
        or gauge.
    UsageError
        What of SymPy has no formula, such as a delay; names that formulas read as something else;
        a symbol that is declared negative where the result takes its root.
    Interrupted
        Ctrl-C; its ``partial`` is the expansion to a lower order, if there is one.

    References
    ----------
    A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations, Wiley 1979, section 2.3.1.

    Examples
    --------
    >>> import libration as lb
    >>> print(lb.expand("x'' + x + a*x^3 = 0", order=5).frequency)
    1 + 3/8*a*A^2 - 21/256*a^2*A^4
    >>> cycle = lb.expand("van_der_pol", order=4)
    >>> print(cycle.frequency)
    1 - 1/16*mu^2 + 17/3072*mu^4
    """
    if not isinstance(oscillator, str) and not hasattr(oscillator, "free_symbols"):
        raise TypeError(
            f"oscillator: got {type(oscillator).__name__}: give the name of an oscillator, or its "
            "equation as text, such as \"x'' + sin(x) = 0\", or as SymPy has it"
        )
    is_text = isinstance(oscillator, str)
    text, symbols = Equation(oscillator, {}) if is_text else motion_of_sympy(oscillator)
    position = None if about is None else _ask.formula("about", about)
    is_several = np.iterable(letters) and not isinstance(letters, str)
    several = letters if is_several else _text("letters", letters, "epsilon").split(",")
    kept = [_text("letters", it, "epsilon") for it in several]
    gauge = _text("gauge", gauge, "fundamental")
    question = (text, _ask.by_name("set", set), kept, position)
    order = whole("order", order, 7)
    if order < 0:
        raise ExpansionError(f"order {order} is out of range: give 1 to 1000")
    with told(progress, "expand") as tell:
        found, stopped_by = _native.expand(question, order, gauge, tell)
    expansion = None if found is None else _expansion(found, (question, order, gauge), symbols)
    if expansion is not None:
        _signs.refuse_assumed(oscillator, symbols, expansion)
    go_on(stopped_by, expansion)
    assert expansion is not None
    return expansion


def _expansion(found: Any, question: Any, symbols: dict[str, Any]) -> Expansion:
    it = found.fields()
    constants = {name: (formula, value) for name, formula, value in it.get("constants", [])}
    are_exact = it.get("are_exact", [True, True])
    coefficient = _Reader(it["digits"], constants, symbols)
    exactly = _Reader(None, constants, symbols)
    equilibrium, omega0_squared = (
        (exactly if is_exact else coefficient)(it[name])
        for is_exact, name in zip(are_exact, ("equilibrium", "omega0_squared"))
    )
    taken = _letters_of(it["of_amplitude"] or [it["frequency_ratio"]])
    own, amplitude = _free(it["variable"], taken), _free("A", taken)
    _series = coefficient.series
    of_amplitude, half_swing = it["of_amplitude"], it["of_half_swing"]
    harmonics = it["harmonics"]
    of_gauge = GaugeSeries(
        frequency=_series(it["frequency_ratio"], own),
        cos={k: _series(cos, own) for k, (cos, _) in harmonics},
        sin={k: _series(sin, own) for k, (_, sin) in harmonics},
        x_max=_series(it["x_max"], own),
        x_min=_series(it["x_min"], own),
    )
    frequency, period, epsilon, waves = of_amplitude or (None, None, None, [])
    halves = [_series(it, amplitude) for it in (half_swing or ())[:2]]
    by_amplitude = {k: _series(wave, amplitude) for k, wave in waves}
    return Expansion(
        equation=it["equation"],
        displacement=it["displacement"],
        order=it["order"],
        frequency=_series(frequency, amplitude) if of_amplitude else of_gauge.frequency,
        period=_series(period, amplitude) if of_amplitude else None,
        harmonics=by_amplitude if of_amplitude else of_gauge.cos,
        half_swing=(halves[0], halves[1]) if halves else None,
        epsilon=_series(epsilon, amplitude) if of_amplitude else None,
        gauge=it["gauge"],
        gauge_series=of_gauge,
        phase_origin=it["phase_origin"],
        equilibrium=equilibrium,
        omega0_squared=omega0_squared,
        unit_squared=coefficient(it["unit_squared"]),
        constants={name: formula for name, (formula, _) in constants.items() if name != formula},
        digits=it["digits"],
        is_proven=it["is_proven"],
        _question=question,
        _expansion=found,
    )


@dataclass(frozen=True)
class _Reader:
    """Coefficients from the terms that the library gives."""

    digits: int | None
    constants: dict[str, tuple[str, float]]
    symbols: dict[str, Any]

    def series(self, coefficients: Any, variable: str) -> Series:
        return Series(tuple(self(terms) for terms in coefficients), variable)

    def __call__(self, terms: Any) -> Coefficient:
        if all(not powers for _, powers in terms):
            value = sum((_fraction(factor) for factor, _ in terms), Fraction(0))
            return value if self.digits is None else _rounded(value)
        terms = tuple((_fraction(factor), _powers(powers)) for factor, powers in terms)
        return Polynomial(terms, self.constants, self.symbols)


_DIGITS = 40
"""Digits of rounded coefficients."""
_CONTEXT = Context(prec=_DIGITS)


def _rounded(value: Fraction) -> Decimal:
    return _CONTEXT.divide(Decimal(value.numerator), Decimal(value.denominator))


def _letters_of(terms: Any) -> set[str]:
    """The names in nested lists of terms."""
    if isinstance(terms, tuple) and len(terms) == 2 and isinstance(terms[0], str):
        return {letter for letter, _ in terms[1]}
    return set().union(*map(_letters_of, terms)) if isinstance(terms, (list, tuple)) else set()


def _free(name: str, taken: set[str]) -> str:
    """The name, with a number if a symbol has it."""
    return name if name not in taken else f"{name}_1"


def _root(square: Coefficient) -> Coefficient | None:
    """The positive root, of symbols that are positive."""
    if isinstance(square, Decimal):
        return _CONTEXT.sqrt(square)
    if isinstance(square, Fraction):
        root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
        if root**2 == square:
            return root
        name = f"sqrt({square})"
        return Polynomial(((Fraction(1), ((name, Fraction(1)),)),), {name: (name, sqrt(square))})
    if len(square.terms) != 1:
        return None
    ((factor, powers),) = square.terms
    letters = Polynomial(
        ((Fraction(1), tuple((letter, power / 2) for letter, power in powers)),),
        square.constants,
        square.symbols,
    )
    number = _root(factor)
    return None if number is None else _product(number, letters)


def _product(root: Coefficient, c: Coefficient) -> Coefficient:
    """The product with a root, which has one term."""
    if isinstance(root, Decimal) and isinstance(c, Decimal):
        return _CONTEXT.multiply(root, c)
    if isinstance(root, Fraction) and isinstance(c, Fraction):
        return root * c
    first, second = _polynomial(root), _polynomial(c)
    terms = tuple(
        (own * other, _merged(powers, others))
        for own, powers in first.terms
        for other, others in second.terms
        if own * other
    )
    constants = {**first.constants, **second.constants}
    return Polynomial(terms, constants, {**first.symbols, **second.symbols})


def _polynomial(c: Coefficient) -> Polynomial:
    return c if isinstance(c, Polynomial) else Polynomial(((Fraction(c), ()),))


def _merged(
    powers: tuple[tuple[str, Fraction], ...], others: tuple[tuple[str, Fraction], ...]
) -> tuple[tuple[str, Fraction], ...]:
    """The powers of a product, in alphabetical order."""
    sums: dict[str, Fraction] = {}
    for name, power in (*powers, *others):
        sums[name] = sums.get(name, Fraction(0)) + power
    return tuple((name, power) for name, power in sorted(sums.items()) if power)


def _powers(powers: list[tuple[str, str]]) -> tuple[tuple[str, Fraction], ...]:
    return tuple((letter, Fraction(exponent)) for letter, exponent in powers)


def _fraction(text: str) -> Fraction:
    numerator, _, denominator = text.partition("/")
    return Fraction(_integer(numerator), _integer(denominator or "1"))


def _integer(text: str) -> int:
    """An integer as `int` reads it, without the limit of 4300 digits."""
    digits = text.lstrip("-")
    value = 0
    for start in range(0, len(digits), 4000):
        part = digits[start : start + 4000]
        value = value * 10 ** len(part) + int(part)
    return -value if text.startswith("-") else value


def _is_zero(c: Coefficient) -> bool:
    return not c.terms if isinstance(c, Polynomial) else c == 0


def _term(c: Coefficient, variable: str, power: int) -> str:
    x = variable if power == 1 else f"{variable}^{power}"
    if power == 0:
        return str(c)
    if isinstance(c, Polynomial):
        return f"{c}*{x}" if len(c.terms) == 1 else f"({c})*{x}"
    if abs(c) == 1:
        return x if c > 0 else f"-{x}"
    return f"{c}*{x}".replace("E", "e") if isinstance(c, Decimal) else f"{c}*{x}"
