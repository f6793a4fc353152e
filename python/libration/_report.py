"""Reports of fits as text, in the sections of lmfit's ``fit_report``."""

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

STATISTICS = (
    "model",
    "law",
    "preferred",
    "weighting",
    "rows",
    "rows_incomplete",
    "passages",
    "converged",
    "rms_residual_rad",
    "rms_residual_rad_per_s",
    "rms_s",
    "amplitude_scatter",
    "chi2_per_dof",
    "dof",
    "birge_ratio",
    "uncertainties_enlarged_by",
    "aicc",
)
LEAST_CORRELATION = 0.1


class Result(NamedTuple):
    """A value with its standard uncertainty and its unit."""

    name: str
    value: float
    uncertainty: float | None
    unit: str

    def __str__(self) -> str:
        """The value with the digits of its uncertainty, and the uncertainty in per cent."""
        unit = "" if self.unit in ("", "1") else f" {self.unit}"
        if self.uncertainty is None or not 0 < self.uncertainty < np.inf:
            return f"{self.value:.6g}{unit}"
        exponent = int(np.floor(np.log10(max(abs(self.value), self.uncertainty))))
        is_long = abs(exponent) > 5
        scale = 10.0**exponent if is_long else 1.0
        text = " ± ".join(rounded(self.value / scale, self.uncertainty / scale))
        text = f"({text})e{exponent:+03d}" if is_long else text
        return text + unit + (f" ({self._percent})" if self.value else "")

    @property
    def _percent(self) -> str:
        percent = 100 * (self.uncertainty or 0) / abs(self.value)
        return (f"{percent:#.2g}".rstrip(".") if percent < 99.5 else f"{percent:.0f}") + " %"


def report(title: str, fit: Mapping[str, Any], units: Mapping[str, str]) -> str:
    """The report of a fit, from its JSON and the units of its fields."""
    chosen = _chosen(fit)
    given = fit.get("parameters", [])
    parameters = [Result(it["name"], it["value"], it["uncertainty"], it["unit"]) for it in given]
    results = [*_results(fit, "", units), *_results(chosen, _place(fit), units)]
    # What a model has in common with the whole fit is written once.
    first = {it.value: it for it in reversed([*parameters, *results])}
    others = [it for it in results if first[it.value] is it]
    correlations = _correlations([it.name for it in parameters], fit.get("correlations", []))
    sections = {
        "Fit": [title],
        "Fit Statistics": _aligned(_statistics(fit, chosen), " = "),
        "Parameters": _aligned([(it.name, str(it)) for it in parameters], "  "),
        "Results": _aligned([(it.name, str(it)) for it in others], "  "),
        f"Correlations of at least {LEAST_CORRELATION}": _aligned(correlations, " = "),
        "Warnings": [_folded(f"- {it}") for it in fit.get("warnings", [])],
    }
    bodies = {name: textwrap.indent("\n".join(lines), "    ") for name, lines in sections.items()}
    return "\n".join(f"[[{name}]]\n{body}" for name, body in bodies.items() if body)


def _chosen(fit: Mapping[str, Any]) -> Mapping[str, Any]:
    """The model or law of the results, among those compared."""
    wanted = {"model": fit.get("preferred"), "law": fit.get("law"), "key": "exact"}
    candidates = [*fit.get("models", []), *fit.get("laws", [])]
    of = [it for it in candidates for name, value in wanted.items() if it.get(name, "") == value]
    return of[0] if of else {}


def _place(fit: Mapping[str, Any]) -> str:
    """The path of the compared models in the names of fields."""
    return "models[]." if "models" in fit else "laws[]."


def _statistics(fit: Mapping[str, Any], own: Mapping[str, Any]) -> list[tuple[str, str]]:
    known = {**own, "model": None, "law": own.get("key"), **fit}
    present = [(name, known[name]) for name in STATISTICS if known.get(name) is not None]
    return [(name, f"{it:.6g}" if isinstance(it, float) else str(it)) for name, it in present]


def _results(fields: Mapping[str, Any], place: str, units: Mapping[str, str]) -> Iterator[Result]:
    """The fields that have an uncertainty."""
    for name, uncertainty in fields.items():
        value = fields.get(name.replace("_uncertainty", "", 1))
        if "_uncertainty" in name and isinstance(value, float):
            unit = units.get(place + name, "")
            yield Result(name.partition("_uncertainty")[0], value, uncertainty, unit)


def _correlations(names: list[str], matrix: list[list[float]]) -> list[tuple[str, str]]:
    """The correlation coefficients of two parameters, the largest first."""
    pairs = [(matrix[j][i], names[i], names[j]) for j in range(len(matrix)) for i in range(j)]
    large = [it for it in pairs if abs(it[0]) >= LEAST_CORRELATION]
    large.sort(key=lambda it: -abs(it[0]))
    return [(f"C({one}, {other})", f"{coefficient:+.3f}") for coefficient, one, other in large]


def rounded(value: float, uncertainty: float) -> tuple[str, str]:
    """A value and its uncertainty with two digits of the uncertainty."""
    # The power of ten after rounding: 0.00995 is 0.010.
    digits = max(0, 1 - int(f"{uncertainty:.1e}".partition("e")[2]))
    return f"{value:.{digits}f}", f"{uncertainty:.{digits}f}"


def _aligned(pairs: Sequence[tuple[str, str]], between: str) -> list[str]:
    width = max((len(name) for name, _ in pairs), default=0)
    return [f"{name:{width}}{between}{text}" for name, text in pairs]


def _folded(text: str) -> str:
    return textwrap.fill(text, 92, subsequent_indent="  ", break_long_words=False)
