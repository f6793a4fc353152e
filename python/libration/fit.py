"""Fits of measurements: their results, with uncertainties.

>>> import libration as lb
>>> table = {"amplitude (deg)": [10, 30, 50, 70], "period (s)": [2.0075, 2.0399, 2.1033, 2.2054]}
>>> fit = lb.lab.fit_periods(table, length="1.00(1) m")
>>> round(fit.g.nominal_value, 3), round(fit.g.std_dev, 3)
(9.838, 0.099)
>>> fit.laws[0]["key"], round(fit.laws[0]["t0_s"], 4)
('exact', 2.0032)
"""

import csv
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _report
from ._ask import Path, answered
from .answer import Answer, Rows, descriptions
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
        """The standard uncertainty."""
        return self.std_dev

    def __float__(self) -> float:
        return self.nominal_value

    def __str__(self) -> str:
        """The value with two digits of the uncertainty."""
        if not 0 < self.std_dev < np.inf:
            return f"{self.nominal_value!r}+/-{self.std_dev!r}"
        return "+/-".join(_report.rounded(*self))


def measured(value: float, uncertainty: float | None) -> "UFloat | Measured":
    """A number of the package uncertainties, where that is installed."""
    spread = float("nan") if uncertainty is None else uncertainty
    try:
        from uncertainties import ufloat
    except ImportError:
        return Measured(value, spread)
    number: UFloat = ufloat(value, spread)
    return number


def _number(name: str, cell: str) -> str | float:
    return cell if name == "trace" else float(cell)


class Fit(Answer):
    """The result of a fit: all fields of the command's JSON, and values with uncertainties."""

    __slots__ = ()

    @property
    def g(self) -> "UFloat | Measured":
        """Gravity in m/s², where the length of the pendulum was given."""
        names = ("gravity_m_per_s2", "gravity_uncertainty_m_per_s2")
        why_not = "gravity follows from the length of the pendulum: give length, such as "
        return self._measured(*names, f'{why_not}"0.57m±0.004m"')

    @property
    def t0(self) -> "UFloat | Measured":
        """The period of small swings in seconds."""
        name = "small_angle_period" if "small_angle_period_s" in self else "t0"
        names = (f"{name}_s", f"{name}_uncertainty_s")
        if "laws" in self and names[0] not in self and "t0_s" in self["laws"][0]:
            return measured(self["laws"][0]["t0_s"], self["laws"][0]["t0_uncertainty_s"])
        return self._measured(*names, "this fit has no period of small swings")

    def _measured(self, value: str, uncertainty: str, why_not: str) -> "UFloat | Measured":
        if self.get(value) is None:
            raise NoAnswer(why_not)
        return measured(self[value], self.get(uncertainty))

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of a fitted motion by name, as values with uncertainties."""
        found = self.get("parameters", [])
        return {it["name"]: measured(it["value"], it["uncertainty"]) for it in found}

    def residuals(self) -> Rows:
        """Rows of a fitted motion: time, value, fitted value and residual, in SI units."""
        lines = csv.DictReader(self._again(["--csv"]).splitlines())
        return Rows([{name: _number(name, cell) for name, cell in it.items()} for it in lines])

    def report_text(self) -> str:
        """A report as text: statistics, parameters and results with uncertainties, warnings.

        Values have two digits of their standard uncertainty, which follows in per cent too; names
        are those of the JSON. The sections are those of lmfit's ``fit_report``.

        Examples
        --------
        >>> import libration as lb
        >>> amplitude, period = [10, 30, 50, 70], [2.0075, 2.0399, 2.1033, 2.2054]
        >>> fit = lb.lab.fit_periods({"amplitude (deg)": amplitude, "period (s)": period})
        >>> print(fit.report_text())
        [[Fit]]
            libration fit periods --header=present -- -
        [[Fit Statistics]]
            law                       = exact
            weighting                 = none: uncertainties from the scatter
            rows                      = 4
            rows_incomplete           = 0
            rms_s                     = 0.00154487
            uncertainties_enlarged_by = 1
        [[Results]]
            beta  0.9817 ± 0.0072 (0.74 %)
            t0    2.00322 ± 0.00085 s (0.043 %)
        """
        units = {name: unit for name, unit, _ in descriptions()[self._asked.command]}
        return _report.report(self.question, self._fields, units)

    def report(self, file: Path) -> None:
        """Writes a report of the fit with pictures, as .html, .md or .tex.

        The fit is made again for it; ``report=`` of the function that made it, such as
        `libration.lab.fit_trace`, writes it with the first.
        """
        self._again([f"--report={file}"])

    def _again(self, form: list[str]) -> str:
        text, error = answered(self._asked, form)
        if error is not None:
            raise Interrupted(text or None) from error
        return text
