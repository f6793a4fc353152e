"""Numbers with uncertainties, and quantities with units, as every query takes them."""

import warnings
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import matplotlib
import numpy as np
import pytest

import libration as lb
from libration import questions
from libration._ask import asked, catalogue

matplotlib.use("agg")
EXAMPLES = Path(__file__).parents[2] / "examples"
# Values that are texts, names or files.
OTHERS = ("FILE", "DIR", "KEY", "COLUMN", "UNIT", "SHEET", "RUN", "HEADER", "COMMAND", "CATALOGUE")
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
    return {it.keyword: {"x": value} if it.example else value}


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


CORRECTIONS = {"bob-radius", "bob-mass", "bob-density", "rod-mass", "rod-length", "air-density"}
CORRECTIONS |= {"stretch", "expansion", "warmer", "support-stiffness", "edge-radius"}
MEASURED = {
    "fit periods": CORRECTIONS | {"length", "linear"},
    "fit lengths": CORRECTIONS | {"edges"},
    "fit amplitudes": {"period"},
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


PENDULUM = lb.Pendulum(1.0)
MOTION = PENDULUM.release(1.0)
SERIES = lb.expand("duffing", 3, letters="epsilon").frequency
DENMAN = lb.formulas["denman"]


def simulated(**given):
    found = lb.simulate("x'' = -k*x", **{"initial": {"x": 1}, "times": 1, "set": {"k": 1}, **given})
    return found.y.tolist()


# Functions and methods outside `questions`, by the name of the argument and what it takes.
NUMBERS_ALONE = [
    ("tolerance", lambda it: MOTION.harmonics(tolerance=it)),
    ("tolerance", lambda it: simulated(tolerance=it)),
    ("tolerance", DENMAN.holds_to),
    ("tolerance", lambda it: lb.formulas.best(1.0, tolerance=it)),
    ("tolerance", lambda it: lb.formulas.simplest(1.0, tolerance=it)),
]
NUMBERS_AND_TEXTS = [
    ("length", lb.Pendulum),
    ("gravity", lambda it: lb.Pendulum(1.0, it)),
    ("angle", PENDULUM.release),
    ("angle", lambda it: lb.Motion(PENDULUM, it)),
    ("velocity", lambda it: PENDULUM.launch(1.0, it)),
    ("amplitude", DENMAN.ratio),
    ("amplitude", DENMAN.error),
    ("amplitude", lambda it: lb.formulas.best(it, 1e-3)),
    ("up_to", DENMAN.worst_error),
    ("initial: x", lambda it: simulated(initial={"x": it})),
    ("set: k", lambda it: simulated(set={"k": it})),
    ("set: epsilon", lambda it: lb.expand("duffing", 3, set={"epsilon": it}).frequency),
    ("about", lambda it: lb.expand("x'' + sin(x - 1/128) = 0", 3, about=it).frequency),
]
ARRAYS = [
    ("t", MOTION),
    ("t", lb.simulate("pendulum", {"theta": 1}, [0, 2])),
    ("times", lambda it: simulated(times=it)),
    ("amplitude", lb.expand("pendulum", 5).evaluate),
    ("amplitudes", lambda it: lb.expand("pendulum", 5).plot(amplitudes=it).lines[0].get_xdata()[0]),
    ("angle", lambda it: lb.lab.recording(t=np.arange(3.0), angle=it).columns["angle (rad)"][0]),
]
OPTIONAL = ("about", "amplitudes", "angle")
SERIES_CALLS = [
    ("x", lambda it: SERIES(it, epsilon=0.5)),
    ("epsilon", lambda it: SERIES(0.5, epsilon=it)),
    ("epsilon", lambda it: SERIES[2](epsilon=it)),
]
QUERIES = [("linear", lambda it: lb.decay(0.1, linear=it))]
CALLS = NUMBERS_ALONE + NUMBERS_AND_TEXTS + ARRAYS + QUERIES
of_all = pytest.mark.parametrize("name, call", CALLS + SERIES_CALLS)


@of_all
def test_numbers_of_every_type_mean_the_same(name, call):
    sympy = pytest.importorskip("sympy")
    expected = call(1 / 128)
    for it in (
        Decimal("0.0078125"),
        Fraction(1, 128),
        np.float32(1 / 128),
        np.float16(1 / 128),
        np.array(1 / 128),
        sympy.Rational(1, 128),
    ):
        assert call(it) == expected


@pytest.mark.parametrize("name, call", CALLS)
def test_uncertainties_are_left_out_with_a_warning_everywhere(name, call):
    expected = call(1 / 128)
    for it in (
        pytest.importorskip("uncertainties").ufloat(1 / 128, 1e-4),
        lb.lab.Measured(1 / 128, 1e-4),
    ):
        with pytest.warns(UserWarning) as told:
            assert call(it) == expected
        message = f"{name}: got {it}: its uncertainty is not used here, only its value"
        assert {str(one.message) for one in told} == {message}
        assert {one.filename for one in told} == {__file__}


@pytest.mark.parametrize("name, call", SERIES_CALLS)
def test_series_propagate_uncertainties(name, call):
    uncertain = pytest.importorskip("uncertainties").ufloat(0.5, 1e-3)
    slope = (call(0.5 + 1e-4) - call(0.5 - 1e-4)) / 2e-4
    assert call(uncertain).nominal_value == call(0.5)
    assert call(uncertain).std_dev == pytest.approx(1e-3 * abs(slope), rel=1e-6)


@of_all
def test_quantities_are_refused_everywhere_with_one_sentence(name, call, quantities):
    for it in quantities:
        with pytest.raises(TypeError, match=f"^{name}: {REFUSED}"):
            call(it)


def test_lists_of_quantities_and_of_uncertain_numbers_are_refused_or_warned_of(quantities):
    for name, call in ARRAYS:
        with pytest.raises(TypeError, match=f"^{name}: {REFUSED}"):
            call([quantities[0]])
    with pytest.warns(UserWarning, match="^t: got .*: its uncertainty is not used here"):
        assert MOTION([lb.lab.Measured(0.5, 0.1)]) == MOTION([0.5])


@pytest.mark.parametrize("calls, wanted", [
    (NUMBERS_ALONE, "a number"),
    (NUMBERS_AND_TEXTS, "a number or (a text|an array of numbers)"),
    (ARRAYS, "a number or an array of numbers"),
])
def test_other_types_are_refused_by_the_name_of_the_argument(calls, wanted):
    for name, call in calls:
        wrong = [(1j, "complex"), (object(), "object"), (b"1", None), ({}, None)]
        wrong += [(None, "NoneType")] if name not in OPTIONAL else []
        wrong += [(True, "True")] if calls is not ARRAYS else []
        wrong += [([1.0, 2.0], None)] if calls is not ARRAYS and name != "amplitude" else []
        wrong += [("noon", "'noon'")] if "text" not in wanted else []
        for it, got in wrong:
            with pytest.raises(TypeError, match=f"^{name}: got {got or '.*'}: give {wanted}$"):
                call(it)
    if calls is ARRAYS:
        with pytest.raises(ValueError, match="^t: got lists of different lengths: give a number"):
            MOTION([[1.0], [1.0, 2.0]])


@pytest.mark.parametrize("name, call", [
    ("order", lambda it: lb.expand("pendulum", it)),
    ("limit", lambda it: MOTION.harmonics(limit=it)),
])
def test_counts_are_whole(name, call):
    assert call(np.int8(5)) == call(np.array(5)) == call(5)
    for it in (5.0, "5", None, True, Decimal(5), lb.lab.Measured(5, 1)):
        with pytest.raises(TypeError, match=f"^{name}: got .*: give a whole number, such as "):
            call(it)


@every
def test_queries_take_fractions_and_decimals_as_the_numbers_that_they_are(question, it):
    exact = it.value.startswith("NAME=VALUE") or it.value == "X"
    for value, text in ((Fraction(1, 128), "1/128"), (Decimal("7.8125e-3"), "0.0078125")):
        number = asked(question.words, given(it, value)).words[-1].rpartition("=")[2]
        assert number == (text if exact else "0.0078125")


def test_sweeps_take_fractions_and_decimals(tmp_path):
    pytest.importorskip("zarr")
    over = {"length": [Fraction(1, 2), Decimal("0.25"), "1m", 2]}
    found = lb.sweep("period", over, tmp_path / "a.zarr", amplitudes=1.0).load()
    assert np.allclose(found.period_s, lb.period(1.0, [0.5, 0.25, 1, 2], lb.STANDARD_GRAVITY))
