"""Numbers with uncertainties, and quantities with units, as every query takes them."""

import warnings
from pathlib import Path

import numpy as np
import pytest

import libration as lb
from libration import questions
from libration._ask import asked, catalogue

EXAMPLES = Path(__file__).parents[2] / "examples"
# Values that are texts, names or files.
OTHERS = ("FILE", "DIR", "KEY", "COLUMN", "UNIT", "SHEET", "RUN", "HEADER", "COMMAND", "QUESTION", "CATALOGUE")
NUMBERS = [
    (question, it)
    for question in catalogue().values()
    for it in question.parameters
    if it.kind != "flag" and not it.choices and not it.value.startswith(OTHERS)
]
every = pytest.mark.parametrize(
    "question, it", NUMBERS, ids=[f"{question.words}-{it.name}" for question, it in NUMBERS]
)
REFUSED = "got a quantity with a unit: give a number in SI units"


def given(it, value):
    """A value as it is given, by name where names belong to it."""
    return {it.keyword: {"x": value} if it.value.startswith("NAME=") else value}


def test_every_query_with_a_number_is_here():
    without = {"list", "fields", "completions", "page"}
    without |= {"sweep join", "sweep status"}
    assert {question.words for question, _ in NUMBERS} == catalogue().keys() - without


@pytest.fixture(scope="module")
def quantities():
    units = pytest.importorskip("pint").UnitRegistry()
    some = [units.Quantity(1.0, "m"), units.Quantity(2.0, ""), units.Quantity([1.0, 2.0], "s")]
    return [*some, units.Measurement(100.0, 1.0, "cm")]


@every
def test_quantities_are_refused_with_one_sentence(question, it, quantities):
    for value in quantities:
        for one in (value, [value]):
            with pytest.raises(TypeError, match=f"^{it.keyword}: {REFUSED}"):
                asked(question.words, given(it, one))


@every
def test_uncertainties_are_used_or_left_out_with_a_warning(question, it):
    uncertainties = pytest.importorskip("uncertainties")
    for value in (uncertainties.ufloat(0.5, 0.01), lb.lab.Measured(0.5, 0.01)):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            words = asked(question.words, given(it, value)).words
        number = words[-1].rpartition("=")[2]
        if it.is_measured:
            assert number == "0.5±0.01" and not told
        else:
            message = f"{it.keyword}: got {value}: its uncertainty is not used here, only its value"
            assert number == "0.5" and [str(it.message) for it in told] == [message]


MEASURED = {
    "fit periods": {"length", "bob-radius", "bob-mass", "bob-density", "rod-mass", "rod-length"}
    | {"air-density", "stretch", "linear"},
    "fit lengths": {"bob-radius"},
    "plan": {"length", "linear"},
}
MEASURED["period"] = {"period", "ratio", "excess"}
MEASURED["fit trace"] = MEASURED["fit periods"] - {"linear"}
MEASURED["fit gates"] = MEASURED["fit periods"] | {"diameter", "gate-distance"}


def test_fits_and_plans_use_the_uncertainties_of_what_was_measured():
    found = {}
    for question, it in NUMBERS:
        if it.is_measured:
            found.setdefault(question.words, set()).add(it.name)
    assert found == MEASURED


def test_the_command_accepts_the_uncertainties_that_are_used():
    uncertainties = pytest.importorskip("uncertainties")
    radius, mass = uncertainties.ufloat(0.02, 1e-4), uncertainties.ufloat(0.05, 1e-3)
    fit = lb.lab.fit_periods(
        EXAMPLES / "period_table_synthetic.csv",
        length=uncertainties.ufloat(0.994, 5e-4),
        bob_radius=radius,
        bob_mass=mass,
        rod_mass=mass / 10,
        rod_length=uncertainties.ufloat(0.99, 0.001),
        air_density=uncertainties.ufloat(1.2, 0.02),
        stretch=uncertainties.ufloat(1e-4, 1e-5),
        linear=uncertainties.ufloat(0.03, 0.001),
    )
    spreads = {it["input"]: it["uncertainty"] for it in fit["budget_inputs"]}
    assert spreads["length"] == 5e-4 and len([it for it in spreads.values() if it]) >= 6
    gates = EXAMPLES / "gate_synthetic.csv"
    found = lb.lab.fit_gates(gates, length=0.958, diameter=radius, gate_distance=0.95 + radius)
    assert found.g.std_dev > 0
    assert lb.lab.fit_lengths(EXAMPLES / "lengths_synthetic.csv", bob_radius=radius)["rows"] == 12


def test_warnings_are_of_the_line_that_asks():
    uncertain = lb.lab.Measured(1.0, 0.1)
    with pytest.warns(UserWarning, match="its uncertainty is not used") as told:
        assert questions.period(1.0, length=uncertain) == questions.period(1.0, length=1.0)
        lb.lab.plan(g_to=1e-3, length="1.00(1)m", angle_noise=lb.lab.Measured(3e-3, 1), rate=60)
    with pytest.warns(UserWarning, match="for degrees write 30deg") as notes:
        questions.simulate("pendulum", initial={"theta": 30}, times=[0, 1])
    assert {it.filename for it in [*told, *notes]} == {__file__}


def test_columns_times_and_axes_with_units_are_refused(tmp_path):
    quantity = pytest.importorskip("pint").UnitRegistry().Quantity
    t = quantity(np.arange(3.0), "ms")
    for what, call in {
        "column `t \\(s\\)`": lambda: lb.lab.read({"t (s)": t, "angle (rad)": [1, 2, 3]}),
        "t": lambda: lb.lab.recording(t=t, angle=[1, 2, 3]),
        "times": lambda: lb.simulate("pendulum", {"theta": 1}, t),
        "over: amplitude": lambda: lb.sweep("period", {"amplitude": t}, tmp_path / "a.zarr"),
    }.items():
        with pytest.raises(TypeError, match=f"^{what}: {REFUSED}"):
            call()


def test_what_is_no_number_is_refused_with_the_name_of_its_parameter():
    for value in (None, 1j, object(), b"1"):
        with pytest.raises(TypeError, match="^linear: got .*: give a number or a text"):
            lb.decay("60deg", linear=[value])


def test_the_amplitude_of_an_uncertain_period_is_uncertain():
    uncertainties = pytest.importorskip("uncertainties")
    found = lb.questions.period(period=uncertainties.ufloat(2.1, 0.01))["results"][0]
    assert found["amplitude_rad"] == pytest.approx(0.8459, abs=1e-4)
    assert found["amplitude_uncertainty_rad"] == pytest.approx(0.0447, abs=1e-4)
