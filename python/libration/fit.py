"""Fits of measurements: what they found, with uncertainties.

>>> import libration as lb
>>> fit = lb.lab.fit_periods({"amplitude (deg)": [10, 30, 50, 70], "period (s)": [2.0075, 2.0399, 2.1033, 2.2054]}, length="1.00(1) m")
>>> round(fit.g.nominal_value, 3), round(fit.g.std_dev, 3)
(9.838, 0.099)
>>> fit.laws[0]["key"], round(fit.laws[0]["t0_s"], 4)
('exact', 2.0032)
"""

import csv
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._ask import Path, answered
from .answer import Answer, Rows
from .errors import Interrupted, NoAnswer

if TYPE_CHECKING:
    from uncertainties import UFloat

__all__ = ["Fit", "Measured"]


class Measured(NamedTuple):
    """A value with its standard uncertainty, where the package uncertainties is not installed."""

    nominal_value: float
    std_dev: float

    @property
    def n(self) -> float:
        """The value."""
        return self.nominal_value

    @property
    def s(self) -> float:
        """Its standard uncertainty."""
        return self.std_dev

    def __float__(self) -> float:
        return self.nominal_value

    def __str__(self) -> str:
        """With two digits of the uncertainty."""
        if not 0 < self.std_dev < np.inf:
            return f"{self.nominal_value!r}+/-{self.std_dev!r}"
        digits = max(0, 1 - int(np.floor(np.log10(self.std_dev))))
        return f"{self.nominal_value:.{digits}f}+/-{self.std_dev:.{digits}f}"


def measured(value: float, uncertainty: float) -> "UFloat | Measured":
    """A number of the package uncertainties, where that is installed."""
    try:
        from uncertainties import ufloat
    except ImportError:
        return Measured(value, uncertainty)
    number: UFloat = ufloat(value, uncertainty)
    return number


class Fit(Answer):
    """The answer to a fit: all fields of the command's JSON, and the results as values with uncertainties."""

    __slots__ = ()

    @property
    def g(self) -> "UFloat | Measured":
        """Gravity in m/s², where the length of the pendulum was given."""
        return self._measured("gravity_m_per_s2", "gravity_uncertainty_m_per_s2", "gravity follows from the length of the pendulum: give length, such as \"0.57m±0.004m\"")

    @property
    def t0(self) -> "UFloat | Measured":
        """The period of small swings in seconds."""
        names = ("small_angle_period_s", "small_angle_period_uncertainty_s") if "small_angle_period_s" in self else ("t0_s", "t0_uncertainty_s")
        if "laws" in self and names[0] not in self and "t0_s" in self["laws"][0]:
            return measured(self["laws"][0]["t0_s"], self["laws"][0]["t0_uncertainty_s"])
        return self._measured(*names, "this fit has no period of small swings")

    def _measured(self, value: str, uncertainty: str, why_not: str) -> "UFloat | Measured":
        if self.get(value) is None:
            raise NoAnswer(why_not)
        spread = self.get(uncertainty)
        return measured(self[value], float("nan") if spread is None else spread)

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of a fitted motion by name, as values with uncertainties."""
        return {it["name"]: measured(it["value"], float("nan") if it["uncertainty"] is None else it["uncertainty"]) for it in self.get("parameters", [])}

    def residuals(self) -> Rows:
        """Of a fitted motion: time, value, fitted value and residual of each row, in SI units."""
        lines = list(csv.DictReader(self._again(["--csv"]).splitlines()))
        return Rows([{name: cell if name == "trace" else float(cell) for name, cell in line.items()} for line in lines])

    def report(self, file: Path) -> None:
        """Writes a report of a fitted motion with pictures, as .html, or as .md with the pictures beside it.

        The fit is made again for it; ``report=`` of `libration.lab.fit_trace` writes it with the first.
        """
        self._again([f"--report={file}"])

    def _again(self, form: list[str]) -> str:
        text, error = answered(self._asked, form)
        if error is not None:
            raise Interrupted(text or None) from error
        return text
