"""Missing values: what NumPy has masked, and ``NA`` of pandas, are NaN everywhere."""

import warnings

import numpy as np
import pytest

import libration as lb
from libration import errors
from libration.sweeps import _values

ROWS = {"amplitude (deg)": [10, 30, 50, 70]}
PERIODS = np.ma.array([2.0075, 2.0399, 2.1033, 9.0], mask=[0, 0, 0, 1])
SWING = lb.Pendulum(1.0, 1.0).release(1.0)
MOTION = lb.simulate("x'' + x = 0", {"x": 1}, [3.0])
LETTERED = lb.expand("x'' + x + b*x^3 = 0", 3).frequency


@pytest.fixture(autouse=True)
def no_warnings():
    """NumPy warns where a masked value becomes a number by accident."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def series(kind):
    return pytest.importorskip("pandas").Series([1, None], dtype=kind)


# The number 1 and a missing one, as they may come.
MISSING = {
    "floats": lambda: np.ma.array([1.0, 2.0], mask=[0, 1]),
    "integers": lambda: np.ma.array([1, 2], mask=[0, 1]),
    "single": lambda: np.ma.array([1.0, 2.0], mask=[0, 1], dtype=np.float32),
    "list": lambda: [1.0, np.ma.masked],
    "tuple": lambda: (1, np.ma.array(2.0, mask=True)),
    "NA": lambda: [1.0, pytest.importorskip("pandas").NA],
    "Float64": lambda: series("Float64"),
    "Int64": lambda: series("Int64"),
}
every = pytest.mark.parametrize("kind", MISSING)


def test_a_fit_leaves_masked_rows_out():
    without = {"amplitude (deg)": [10, 30, 50], "period (s)": PERIODS.data[:3]}
    expected = lb.lab.fit_periods(without, length="1.00(1) m").g
    assert expected.nominal_value == pytest.approx(9.8296, abs=1e-4)
    for periods in (PERIODS, PERIODS.filled(np.nan), list(PERIODS)):
        given = {**ROWS, "period (s)": periods}
        found = lb.lab.fit_periods(given, length="1.00(1) m").g
        assert found.nominal_value == expected.nominal_value
    structured = np.ma.zeros(4, dtype=[("amplitude (deg)", float), ("period (s)", float)])
    structured["amplitude (deg)"], structured["period (s)"] = ROWS["amplitude (deg)"], PERIODS
    found = lb.lab.fit_periods(structured, length="1.00(1) m").g
    assert found.nominal_value == expected.nominal_value


def test_a_fit_leaves_masked_rows_of_a_recording_out():
    t = np.arange(0, 20, 0.05)
    angle = lb.Pendulum(length=0.57).release("40deg")(t).angle + 1e-3 * np.sin(1e4 * t**2)
    wrong = np.arange(len(t)) // 5 == 20
    masked = np.ma.array(np.where(wrong, 3.0, angle), mask=wrong)
    options = {"length": "0.570(1)m", "model": "undamped"}
    found, expected = (
        lb.lab.fit_trace(lb.lab.recording(t=t, angle=it), **options).g.nominal_value
        for it in (masked, masked.filled(np.nan))
    )
    assert found == expected and found == pytest.approx(9.80665, abs=1e-3)


@every
def test_columns_and_functions_of_arrays_have_nan(kind):
    given = MISSING[kind]()
    for found in (
        SWING(given).angle,
        SWING(given).velocity,
        LETTERED(given, b=1.0),
        LETTERED(0.1, b=given),
        lb.formulas["denman"].ratio(given),
        lb.lab.read({"t (s)": [0, 0.1], "angle (deg)": given}).columns["angle (deg)"],
        lb.lab.recording(t=[0, 0.1], angle=given).columns["angle (rad)"],
    ):
        assert np.isnan(found).tolist() == [False, True]
    assert np.array_equal(SWING(given).angle, SWING([1.0, np.nan]).angle, equal_nan=True)


@every
def test_where_nan_has_no_meaning_it_is_refused(kind):
    given = MISSING[kind]()
    with pytest.raises(errors.SimulationError, match="the times contain NaN: give finite ones"):
        lb.simulate("x'' + x = 0", {"x": 1}, given)
    with pytest.raises(errors.SimulationError, match="t = NaN is beyond the motion"):
        MOTION(given)
    with pytest.raises(errors.ExpansionError, match="give finite numbers"):
        lb.expand("x'' + x + x^3 = 0", 3).evaluate(given)
    with pytest.raises(errors.UsageError, match="times: cannot read `nan`"):
        lb.questions.motion("60deg", times=given)
    with pytest.raises(errors.UsageError, match="amplitudes: cannot read `nan`"):
        lb.questions.period(given)
    assert _values("over", given)[1] == "nan"


def test_masks_in_lists_of_arrays_count_too():
    row = np.ma.array([1.0, 2.0], mask=[0, 1])
    assert np.isnan(SWING([row, row]).angle).tolist() == [[False, True]] * 2


def test_missing_numbers_alone():
    pandas = pytest.importorskip("pandas")
    for one in (np.ma.masked, np.ma.array(3, mask=True), pandas.NA):
        assert np.isnan(SWING(one).angle)
        with pytest.raises(errors.PendulumError, match="the length is NaN"):
            lb.Pendulum(one)
        with pytest.raises(TypeError, match="order: got .*: give a whole number"):
            lb.expand("x'' + x + x^3 = 0", one)
        with pytest.raises(errors.ExpansionError, match="the value of b contains nan"):
            lb.expand("x'' + x + b*x^3 = 0", 3, set={"b": one})


def test_texts_of_masked_cells_are_empty():
    table = {"t (s)": [0, 0.1, 0.2], "run": np.ma.array(["a", "b", "a"], mask=[0, 1, 0])}
    assert lb._ask.Table(table).text.splitlines()[2] == b"0.1,"
