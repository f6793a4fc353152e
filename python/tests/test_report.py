"""Reports of fits as text: all results, with the digits that the uncertainties leave."""

import re
from pathlib import Path

import pytest

import libration as lb
from libration._report import Result

EXAMPLES = Path(__file__).parents[2] / "examples"
FITS = {
    "fit trace": ("swing_synthetic.csv", {"length": "0.56m±0.002m"}),
    "fit periods": ("period_table_synthetic.csv", {"length": "0.9940(5) m"}),
    "fit lengths": ("lengths_synthetic.csv", {"amplitude": "10deg"}),
    "fit gates": ("gate_synthetic.csv", {"length": "0.958m±0.001m", "diameter": "25.0(1) mm"}),
    "fit response": ("response_synthetic.csv", {}),
}


def fit_of(name):
    file, given = FITS[name]
    return getattr(lb.lab, name.replace(" ", "_"))(EXAMPLES / file, **given)


@pytest.fixture(scope="module", params=FITS)
def fit(request):
    return fit_of(request.param)


def sections(text):
    """The lines of a report by the titles of its sections."""
    _, *parts = re.split(r"^\[\[(.*)\]\]\n", text, flags=re.M)
    return {title: body.splitlines() for title, body in zip(parts[::2], parts[1::2])}


def written(value, uncertainty, unit):
    """A value as the package uncertainties writes it, with its unit and relative uncertainty."""
    uncertainties = pytest.importorskip("uncertainties")
    number = f"{uncertainties.ufloat(value, uncertainty):.2u}".replace("+/-", " ± ")
    return re.compile(re.escape(f"{number} {unit}".strip()) + r" \([\d.]+ %\)$")


def test_parameters_have_the_digits_of_their_uncertainties(fit):
    lines = sections(fit.report_text()).get("Parameters", [])
    assert len(lines) == len(fit.get("parameters", []))
    for line, it in zip(lines, fit.get("parameters", [])):
        assert line.split()[0] == it["name"]
        assert written(it["value"], it["uncertainty"], it["unit"]).search(line)


def test_gravity_and_the_period_are_among_the_results(fit):
    lines = {line.split()[0]: line for line in sections(fit.report_text())["Results"]}
    names = {"gravity": ("g", "m/s²"), "t0": ("t0", "s"), "small_angle_period": ("t0", "s")}
    found = [names[name] for name in lines if name in names]
    assert len(found) == {"fit lengths": 1, "fit response": 0}.get(fit._asked.command, 2)
    for name, (attribute, unit) in names.items():
        if name in lines:
            value = getattr(fit, attribute)
            assert written(value.nominal_value, value.std_dev, unit).search(lines[name])
    percent = re.search(r"\((.*) %\)", next(iter(lines.values())))[1]
    assert 0 < float(percent) < 100


def test_a_value_is_written_once(fit):
    found = sections(fit.report_text())
    names = [line.split()[0] for part in ("Parameters", "Results") for line in found.get(part, [])]
    assert len(names) == len(set(names))
    assert "[[Fit]]\n    " + fit.question == "\n".join(fit.report_text().splitlines()[:2])


def test_statistics_are_those_of_the_result(fit):
    lines = sections(fit.report_text())["Fit Statistics"]
    found = dict(re.split(r" += ", line.strip(), maxsplit=1) for line in lines)
    assert found.get("rows", found.get("passages")) == str(fit.get("rows", fit.get("passages")))
    chosen = {"fit response": ("models", 1), "fit periods": ("laws", 0), "fit lengths": ("laws", 1)}
    if fit._asked.command in chosen:
        name, place = chosen[fit._asked.command]
        assert found["chi2_per_dof"] == f"{fit[name][place]['chi2_per_dof']:.6g}"


def test_warnings_are_those_of_the_result(fit):
    text = " ".join(" ".join(sections(fit.report_text()).get("Warnings", [])).split())
    assert text == " ".join(f"- {warning}" for warning in fit["warnings"])
    assert all(len(line) <= 100 for line in fit.report_text().splitlines()[2:])


def test_large_correlations_come_first():
    fit = fit_of("fit trace")
    lines = sections(fit.report_text())["Correlations of at least 0.1"]
    sizes = [abs(float(line.split()[-1])) for line in lines]
    assert sizes == sorted(sizes, reverse=True) and min(sizes) >= 0.1
    names = [it["name"] for it in fit["parameters"]]
    first = re.search(r"C\((\w+), (\w+)\) += (.*)", lines[0])
    one, other = names.index(first[1]), names.index(first[2])
    assert first[3] == f"{fit['correlations'][one][other]:+.3f}"


@pytest.mark.parametrize(
    "value, uncertainty, unit, text",
    [
        (9.80938, 0.035038, "m/s²", "9.809 ± 0.035 m/s² (0.36 %)"),
        (1.0, 0.004, "1", "1.0000 ± 0.0040 (0.40 %)"),
        (1.0, 0.5, "s", "1.00 ± 0.50 s (50 %)"),
        (-0.003, 0.0241, "rad/s", "-0.003 ± 0.024 rad/s (803 %)"),
        (1234.5, 120.0, "s", "1234 ± 120 s (9.7 %)"),
        (-3.25e-9, 1.2e-11, "1/s", "(-3.250 ± 0.012)e-09 1/s (0.37 %)"),
        (4.5e8, 1e6, "", "(4.500 ± 0.010)e+08 (0.22 %)"),
        (0.0, 0.01, "m", "0.000 ± 0.010 m"),
        (0.56, None, "m", "0.56 m"),
        (0.56, float("nan"), "m", "0.56 m"),
        (0.56, float("inf"), "", "0.56"),
        (0.56, 0.0, "m", "0.56 m"),
    ],
)
def test_results_have_the_digits_that_their_uncertainty_leaves(value, uncertainty, unit, text):
    assert str(Result("x", value, uncertainty, unit)) == text
