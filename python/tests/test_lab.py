"""The laboratory: recordings from files and arrays, fits of them, and plans."""

import io
import pickle
from pathlib import Path

import numpy as np
import pytest

import libration as lb
from libration import fit as fits

SWING = Path(__file__).parents[2] / "examples/swing_synthetic.csv"


@pytest.fixture(scope="module")
def swing():
    return lb.lab.read(SWING)


def test_what_is_read_is_what_the_file_holds(swing):
    lines = [line.split(",") for line in SWING.read_text().splitlines() if line[0].isdigit()]
    t, theta = np.array(lines, dtype=float).T
    assert list(swing.columns) == ["t (s)", "theta (deg)"]
    assert np.array_equal(swing.columns["t (s)"], t)
    assert np.array_equal(swing.columns["theta (deg)"], theta)
    trace = swing.trace_values[0]
    assert trace.unit == "rad" and np.allclose(trace["values"], np.radians(theta), rtol=1e-15)
    assert isinstance(swing, lb.lab.Recording) and pickle.loads(pickle.dumps(swing)) == swing


def test_cells_that_are_no_numbers_are_missing():
    columns = lb.lab.read(
        {"t (s)": [0, 0.1, 0.2, 0.3], "angle (deg)": [61, np.nan, 38, 20]}
    ).columns
    assert np.isnan(columns["angle (deg)"][1]) and columns["angle (deg)"][2] == 38


def test_fits_take_recordings_as_they_take_files(swing):
    options = {"length": "0.56m±0.002m", "model": "linear"}
    by_file, by_recording = lb.lab.fit_trace(SWING, **options), lb.lab.fit_trace(swing, **options)
    assert by_recording == by_file
    trace = swing.trace_values[0]
    by_arrays = lb.lab.fit_trace(
        lb.lab.recording(t=trace.times_s, angle=trace["values"]), **options
    )
    assert by_arrays["gravity_m_per_s2"] == pytest.approx(by_file["gravity_m_per_s2"], rel=1e-9)


def test_what_was_chosen_in_reading_is_chosen_in_the_fit():
    t = np.arange(0, 12, 0.05)
    angle = lb.Pendulum(0.57).release("40deg")(t).angle + 1e-3 * np.sin(1e4 * t**2)
    table = {"a": t, "b": np.degrees(angle)}
    with pytest.raises(lb.errors.NoAnswer):
        lb.lab.fit_trace(table, model="undamped")
    rec = lb.lab.read(table, time=1, time_unit="s", angle=2, angle_unit="deg")
    fit = lb.lab.fit_trace(rec, model="undamped", length="0.57(1)m")
    assert fit.g.nominal_value == pytest.approx(9.80665, rel=2e-3)
    assert "--angle=2" in fit.question and "--angle-unit=deg" in fit.question
    part = lb.lab.fit_trace(
        lb.lab.read(table, time=1, time_unit="s", angle=2, angle_unit="deg", to=6),
        model="undamped",
        to=9,
    )
    assert part["rows"] == np.count_nonzero(t <= 9)


def test_recordings_from_arrays_know_their_units_and_uncertainties():
    t = np.arange(0, 6, 0.05)
    rec = lb.lab.recording(t=t, angle=0.4 * np.cos(3 * t), uncertainty=0.01)
    assert rec.trace_values[0]["values"] == (0.4 * np.cos(3 * t)).tolist()
    assert set(rec.trace_values[0]["uncertainties"]) == {0.01}
    rate = lb.lab.recording(t=t, angular_velocity=-1.2 * np.sin(3 * t))
    assert rate.traces.seen.tolist() == ["angular velocity"]
    video = lb.lab.recording(
        t=t, x=0.5 * np.sin(0.4 * np.cos(3 * t)), y=-0.5 * np.cos(0.4 * np.cos(3 * t))
    )
    assert np.allclose(
        np.abs(video.trace_values[0]["values"]), np.abs(0.4 * np.cos(3 * t)), atol=1e-9
    )


def test_arrays_need_names_of_columns():
    rows = [(0.0, 61.0), (0.1, 55.0), (0.2, 38.0)]
    named = np.array(rows, dtype=[("t (s)", float), ("theta (deg)", float)])
    assert lb.lab.read(named).columns["theta (deg)"].tolist() == [61, 55, 38]
    with pytest.raises(TypeError, match="an array has no names of columns"):
        lb.lab.read(np.array(rows))


def test_arrays_that_do_not_fit_together_are_refused():
    with pytest.raises(
        ValueError, match=r"the columns differ in shape \(t \(s\): \(3,\), angle \(rad\): \(2,\)\)"
    ):
        lb.lab.recording(t=[0, 1, 2], angle=[1, 2])
    with pytest.raises(ValueError, match="one dimension"):
        lb.lab.recording(t=[[0, 1]], angle=[[1, 2]])
    with pytest.raises(TypeError, match="^read takes no `angel`: it takes .*angle, "):
        lb.lab.read({"t (s)": [0, 1], "angle (deg)": [1, 2]}, angel=2)
    with pytest.raises(ValueError, match="two tables are given"):
        lb.lab.fit_trace([{"t (s)": [0, 1]}, {"t (s)": [0, 1]}])


def test_results_are_values_with_uncertainties(swing, monkeypatch):
    fit = lb.lab.fit_trace(swing, length="0.56m±0.002m", model="linear")
    assert fit.g.nominal_value == fit["gravity_m_per_s2"]
    assert fit.g.std_dev == fit["gravity_uncertainty_m_per_s2"]
    assert fit.t0.nominal_value == fit["small_angle_period_s"]
    assert fit.parameters["omega0"].nominal_value == fit["parameters"][0]["value"]
    rows = fit.residuals()
    assert len(rows) == fit["rows"]
    assert np.allclose(rows.value - rows.fitted, rows.residual, atol=1e-15)
    with pytest.raises(lb.errors.NoAnswer, match="give length"):
        lb.lab.fit_trace(swing, model="linear").g
    monkeypatch.setitem(__import__("sys").modules, "uncertainties", None)
    assert isinstance(fit.g, lb.lab.Measured)
    assert fit.g.n == fit["gravity_m_per_s2"]
    assert float(fit.g) == fit.g.n
    assert str(fit.g) == "9.809+/-0.035"


def test_the_package_uncertainties_writes_the_same():
    uncertainties = pytest.importorskip("uncertainties")
    for value, uncertainty in [(9.80938, 0.035038), (9.84, 0.1), (123.4, 12.0), (1.0, 0.0012)]:
        assert (
            str(fits.Measured(value, uncertainty))
            == f"{uncertainties.ufloat(value, uncertainty):.2u}"
        )
    length = uncertainties.ufloat(0.56, 0.002)
    table = {"amplitude (deg)": [10, 30, 50, 70], "period (s)": [2.0075, 2.0399, 2.1033, 2.2054]}
    assert (
        lb.lab.fit_periods(table, length=length).g.nominal_value
        == lb.lab.fit_periods(table, length="0.56±0.002").g.nominal_value
    )


def test_periods_lengths_and_gates():
    lengths = np.array([0.3, 0.5, 0.7, 0.9, 1.1])
    table = {
        "length (m)": lengths,
        "period (s)": lb.period(np.radians(10), lengths, 9.81) + 1e-4 * np.array([1, -1, 0, 1, -1]),
    }
    fit = lb.lab.fit_lengths(table, amplitude="10deg")
    assert abs(fit.g.nominal_value - 9.81) < 5 * fit.g.std_dev
    gates = lb.lab.fit_gates({"t (s)": np.arange(1, 30) * 1.01}, signals="passages", amplitude=0.2)
    assert gates.t0.nominal_value == pytest.approx(2.02 / lb.period_ratio(0.2), rel=1e-2)


def test_a_plan_keeps_its_promise():
    """A recording as it was planned, with normal noise: the fit is about as uncertain as was
    wanted.
    """
    plan = lb.lab.plan(
        g_to=1e-3,
        length="1.0000(1)m",
        angle_noise="0.2deg",
        rate=60,
        amplitudes="5deg,10deg",
        angle_scale=0,
    )
    motion = lb.Pendulum(1.0).release(plan.amplitude_rad)
    t = np.arange(0, plan.duration_s, 1 / 60)
    angle = motion(t).angle + np.random.default_rng(1).normal(0, np.radians(0.2), len(t))
    fit = lb.lab.fit_trace(lb.lab.recording(t=t, angle=angle), length="1.0000(1)m", model="linear")
    expected = next(it for it in plan.choices if it.is_best).total
    assert expected <= 1e-3 and 0.7 < fit.g.std_dev / fit.g.nominal_value / expected < 1.3
    assert abs(fit.g.nominal_value - 9.80665) < 4 * fit.g.std_dev


def test_harmonics_of_a_recording_are_those_of_its_file(swing):
    by_file, by_recording = lb.lab.spectrum(SWING, harmonics=5), lb.lab.spectrum(swing, harmonics=5)
    assert by_recording == by_file and "--spectrum" in by_recording.question
    trace = by_file.traces[0]
    assert trace.harmonics.n.tolist() == [0, 1, 2, 3, 4, 5] and len(trace.windows) == 2
    for window in trace.windows:
        terms = lb.questions.fourier(window["amplitude_rad"], harmonics=3).harmonics
        assert window.harmonics.theory[1::2] == pytest.approx(terms.angle_rad, rel=1e-9)
    assert abs(trace.harmonics[3]["deviation"]) < 3
    with pytest.raises(lb.errors.NoAnswer, match="swings are too few"):
        lb.lab.spectrum(swing, to=3)
    with pytest.raises(TypeError):
        lb.lab.spectrum(swing, harmonic=3)


def test_power_is_that_of_scipy(swing):
    signal = pytest.importorskip("scipy.signal")
    trace, found = swing.trace_values[0], lb.lab.spectrum(swing).traces[0]
    t, y = np.asarray(trace.times_s), np.asarray(trace["values"])
    step = np.diff(t)
    stands_for = np.minimum(np.convolve(step, [0.5, 0.5], "full"), 3 * np.median(step))
    weights = stands_for * np.sin(np.pi * (t - t[0]) / (t[-1] - t[0])) ** 2
    hz = np.asarray(found["spectrum_hz"])
    if "floating_mean" not in signal.lombscargle.__doc__:
        pytest.skip("this SciPy has no floating mean")
    powers = signal.lombscargle(
        t, y, 2 * np.pi * hz, weights=weights, floating_mean=True, normalize=True
    )
    np.testing.assert_allclose(found["spectrum_powers"], powers, atol=1e-9)


def test_names_of_columns_are_no_rows_even_where_they_are_numbers():
    pandas = pytest.importorskip("pandas")
    amplitude = np.radians(np.linspace(5, 140, 30))
    period = 2 * lb.period_ratio(amplitude)
    named = lb.lab.fit_periods({"amplitude (rad)": amplitude, "T (s)": period}, length="99.4(1)cm")
    numbered = lb.lab.fit_periods(pandas.DataFrame(np.c_[amplitude, period]), length="99.4(1)cm")
    assert numbered["rows"] == 30 and numbered.g.nominal_value == named.g.nominal_value
    read = lb.lab.read(
        pandas.DataFrame(np.c_[[0.0, 0.1, 0.2], [61.0, 55.0, 38.0]]),
        time=1,
        angle=2,
        angle_unit="deg",
    )
    assert read.columns["0"].tolist() == [0.0, 0.1, 0.2]


def test_what_is_no_table_is_refused():
    for given in (b"swing.csv", io.StringIO("t,x")):
        with pytest.raises(TypeError, match="give the name of a file"):
            lb.lab.read(given)
    with pytest.raises(ValueError, match="there are no columns"):
        lb.lab.read({})


def test_squared_periods_are_read():
    # T² = 4.025 L: g = 4π²/4.025 = 9.808.
    fit = lb.lab.fit_lengths(
        {"L (cm)": [20, 40, 60, 80], "T^2 (s^2)": [0.805, 1.610, 2.415, 3.22]}
    )
    assert abs(fit.g.nominal_value - 4 * np.pi**2 / 4.025) < 1e-6
    assert any("squares of the period" in sentence for sentence in fit["told_from_file"])


def test_a_decay_that_is_no_straight_line_is_no_centre_that_wanders():
    # 0.8 m, released at 60°, losing a twelfth from one side to the other, read to 0.03°.
    t = np.arange(0, 30, 1 / 30)
    angle = np.degrees(lb.simulate("x'' = -12.2625*sin(x) - 0.2*x'", {"x": "60deg"}, times=t)["x"])
    deviations = []
    for seed in range(8):
        noise = 0.03 * np.random.default_rng(seed).normal(size=t.size)
        fit = lb.lab.fit_trace(
            {"t (s)": t, "angle (deg)": angle + noise}, length="0.800(1)m", model="linear"
        )
        assert not any("wanders" in warning for warning in fit["warnings"])
        assert fit["beta_uncertainty"] < 1.5e-3
        deviations.append((fit["beta"] - 1) / fit["beta_uncertainty"])
    assert abs(np.mean(deviations)) < 3 / np.sqrt(8)


def test_a_gap_costs_the_cycles_in_it_alone():
    t = np.arange(0, 30, 1 / 30)
    angle = np.degrees(lb.simulate("x''=-12.2625*sin(x)-0.05*x'", {"x": "50deg"}, times=t)["x"])
    angle += 0.3 * np.random.default_rng(0).normal(size=t.size)
    angle[100:130] = np.nan
    fit = lb.lab.fit_trace({"t (s)": t, "angle (deg)": angle}, length="0.800(1)m", model="linear")
    assert len(fit.cycles) >= 24


def test_calendar_times_and_an_index_are_columns():
    pandas = pytest.importorskip("pandas")
    t = np.arange(0, 10, 0.05)
    angle = lb.Pendulum(length=0.57).release("20deg")(t).angle + 1e-3 * np.sin(1e4 * t**2)
    named = lb.lab.fit_trace({"t (s)": t, "angle (rad)": angle}, model="undamped").t0
    stamps = pandas.Timestamp("2025-12-31 23:59:55") + pandas.to_timedelta(t, unit="s")
    missing = stamps.where(np.arange(len(t)) != 7)
    for table in (
        {"time": stamps, "angle (rad)": angle},
        {"time": stamps.tz_localize("UTC"), "angle (rad)": angle},
        {"time": missing, "angle (rad)": angle},
        pandas.DataFrame({"angle (rad)": angle}, index=stamps),
        pandas.DataFrame({"angle (rad)": angle}, index=pandas.Index(t, name="t (s)")),
    ):
        found = lb.lab.fit_trace(table, model="undamped").t0
        assert found.nominal_value == pytest.approx(named.nominal_value, abs=0.1 * named.std_dev)
