"""The published formulas for the period, each with its exact error.

>>> import libration as lb
>>> bernoulli = lb.formulas["bernoulli"]
>>> round(bernoulli.error("60deg"), 6)
-0.004326
>>> lb.formulas.best(amplitude="90deg", tolerance=1e-3).key
'black_vel_2'
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._numbers import Number, Numbers, NumberOrText, floats, is_uncertain, number, real
from .errors import FormulaError

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["PeriodFormula", "PeriodFormulas"]


@dataclass(frozen=True)
class PeriodFormula:
    """A formula for T/T0, with what is known about it; ``lb.formulas[key]`` makes it.

    Amplitudes are radians, texts such as ``"60deg"``, or arrays of radians.
    """

    key: str
    """The name in the catalogue."""
    name: str = field(init=False, repr=False, compare=False)
    """The usual name."""
    authors: str = field(init=False, repr=False, compare=False)
    """The authors."""
    year: int | None = field(init=False, repr=False, compare=False)
    """The year of publication, if it is known."""
    source: str = field(init=False, repr=False, compare=False)
    """The source; one that was not verified begins with "attributed to"."""
    latex: str = field(init=False, repr=False, compare=False)
    """The formula for T/T0, as LaTeX."""
    domain: str = field(init=False, repr=False, compare=False)
    """The domain in which it is good and its limit at the end, in words."""
    complexity: int = field(init=False, repr=False, compare=False)
    """The effort: an operation counts 1, a root 2, a function 3."""
    defined_below: float = field(init=False, repr=False, compare=False)
    """The amplitude in radians at and above which it has no value."""
    _formula: "_native.PeriodFormula" = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        formula = _native.PeriodFormula(self.key)
        object.__setattr__(self, "_formula", formula)
        names = [it.name for it in fields(self) if it.name != "_formula"]
        for name, value in zip(names, formula.words(), strict=True):
            object.__setattr__(self, name, value)

    def __reduce__(self) -> tuple[Any, ...]:
        return PeriodFormula, (self.key,)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"

    @overload
    def ratio(self, amplitude: NumberOrText) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def ratio(self, amplitude: Numbers) -> NDArray[np.float64]: ...
    def ratio(self, amplitude: Any) -> Any:
        """The formula's T/T0, to a few ulp; NaN where formula or period are not defined."""
        return _each(amplitude, self._formula.ratio, self._formula.ratios)

    @overload
    def error(self, amplitude: NumberOrText) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def error(self, amplitude: Numbers) -> NDArray[np.float64]: ...
    def error(self, amplitude: Any) -> Any:
        """Formula/exact - 1, with all digits however small; infinite where the formula is not
        defined, NaN where the period is not.
        """
        return _each(amplitude, self._formula.error, self._formula.errors)

    def worst_error(self, up_to: NumberOrText) -> tuple[float, float]:
        """The error of largest magnitude up to an amplitude, and its amplitude in radians."""
        return self._formula.worst_error(number("up_to", up_to))

    def holds_to(self, tolerance: Number) -> float:
        """The amplitude in radians up to which the magnitude of the error is at most a tolerance;
        0 if nowhere, π if everywhere.
        """
        return self._formula.holds_to(_tolerance(tolerance))


class PeriodFormulas(Mapping[str, PeriodFormula]):
    """The catalogue, ``lb.formulas``, by key: a mapping.

    ``power_series_N``, ``black_vel_N`` and ``sin2_series_N`` are found for N up to 1000, of which
    it lists the first few.
    """

    def __getitem__(self, key: str) -> PeriodFormula:
        return PeriodFormula(key)

    def __iter__(self) -> Iterator[str]:
        return iter(_native.formula_keys())

    def __len__(self) -> int:
        return len(_native.formula_keys())

    def __repr__(self) -> str:
        return f"<{len(self)} period formulas: {', '.join(self)}>"

    def simplest(self, amplitude: NumberOrText, tolerance: Number) -> list[PeriodFormula]:
        """The formulas that are right to a tolerance up to an amplitude, the simplest first."""
        up_to, error = number("amplitude", amplitude), _tolerance(tolerance)
        return [PeriodFormula(key) for key in _native.simplest_formulas(up_to, error)]

    def best(self, amplitude: NumberOrText, tolerance: Number) -> PeriodFormula:
        """The simplest formula that is right to a tolerance up to an amplitude (radians or text).

        Raises
        ------
        FormulaError
            None is.
        """
        amplitude = number("amplitude", amplitude)
        for formula in self.simplest(amplitude, tolerance):
            return formula
        raise FormulaError(
            f"no formula of the catalogue is right to {tolerance!r} up to {amplitude!r}: "
            "give a larger tolerance, or use the exact libration.period_ratio"
        )


formulas = PeriodFormulas()


def _tolerance(value: Any) -> float:
    tolerance = real("tolerance", value)
    if not tolerance >= 0:
        raise FormulaError(f"tolerance: got {tolerance:g}: give zero or more, such as 1e-3")
    return tolerance


def _each(
    amplitude: Any, one: "Callable[[Any], float]", many: "Callable[[list[float]], list[float]]"
) -> Any:
    """Numbers and texts one by one, arrays of numbers together."""
    if isinstance(amplitude, str) or is_uncertain(amplitude) or not np.iterable(amplitude):
        return one(number("amplitude", amplitude))
    array = floats("amplitude", amplitude)
    return np.array(many(array.ravel().tolist())).reshape(array.shape)
