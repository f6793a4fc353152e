"""Charts, the content of the pictures of results, and their plots with matplotlib."""

import copy
import json
import pickle
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import libration as lb
from libration import questions
from libration._ask import catalogue

EXAMPLES = Path(__file__).parents[2] / "examples"

DRAWN = {
    "decay": lambda: lb.decay("60deg", linear=0.1, cycles=2),
    "period": lambda: questions.period("10deg:170deg:20deg"),
    "motion": lambda: questions.motion("60deg"),
    "fourier": lambda: questions.fourier("170deg"),
    "plan": lambda: lb.lab.plan(g_to=1e-3, length="1.00(1) m", angle_noise="0.2deg", rate=60),
    "backbone": lambda: lb.backbone("duffing", amplitudes=[0.5, 1]),
    "simulate": lambda: questions.simulate(
        "double_pendulum", initial={"theta1": 1}, times="0:2:0.1"
    ),
    "modes": lambda: lb.modes("double_pendulum"),
    "orbit": lambda: lb.orbit(
        "double_pendulum", initial={"theta1": 0.1, "theta2": 0.141}, period=8
    ),
    "resonance": lambda: lb.resonance(
        "x'' = -x - x*y; y'' = -4.1*y - x^2/2", order=2, initial={"x": 0.1, "y": 0.02}
    ),
    "melnikov": lambda: lb.melnikov("driven_pendulum", set={"A": 0.3, "c": 0.1, "omega": 1}),
    "response": lambda: lb.response(
        "driven_pendulum", set={"A": 0.15, "c": 0.1}, over="omega=0.7:0.95", sweeps=5
    ),
    "stability": lambda: lb.stability(
        "kapitza", set={"c": 0.1}, map="omega=5:6,a=0.1:0.4", initial={"theta": "180deg"}, lines=0
    ),
    "section": lambda: lb.section(
        "driven_pendulum", set={"A": 1.5, "c": 0.5}, initial={"theta": 0.2}, points=3, skip=0
    ),
    "bifurcation": lambda: lb.bifurcation(
        "driven_pendulum",
        set={"c": 0.5},
        over="A=1:1.1:0.1",
        initial={"theta": 0.2},
        points=2,
        skip=0,
        sweep="both",
    ),
    "lyapunov": lambda: lb.lyapunov("pendulum", initial={"theta": 1}, intervals=30),
    "inspect": lambda: lb.lab.spectrum(EXAMPLES / "swing_synthetic.csv"),
    "fit gates": lambda: lb.lab.fit_gates(
        {"t (s)": np.arange(1, 30) * 1.01 + 1e-4 * np.sin(np.arange(29) ** 2)},
        amplitude=0.2,
        signals="passages",
    ),
    "fit response": lambda: lb.lab.fit_response(
        EXAMPLES / "response_synthetic.csv", model="pendulum"
    ),
    "fit trace": lambda: lb.lab.fit_trace(
        lb.lab.recording(
            t=np.arange(0, 9, 0.05),
            angle=0.5 * np.cos(3.1 * np.arange(0, 9, 0.05)) + 1e-3 * np.sin(np.arange(180) ** 2),
        ),
        model="undamped",
    ),
    "fit periods": lambda: lb.lab.fit_periods(
        {
            "amplitude (deg)": [10, 30, 50, 70],
            "period (s)": [2.0075, 2.0399, 2.1033, 2.2054],
            "u(period) (s)": [0.001, 0.001, 0.002, 0.003],
        }
    ),
    "fit lengths": lambda: lb.lab.fit_lengths(EXAMPLES / "lengths_synthetic.csv"),
    "fit amplitudes": lambda: lb.lab.fit_amplitudes(EXAMPLES / "amplitudes_synthetic.csv"),
}


@pytest.fixture
def pyplot():
    pytest.importorskip("matplotlib").use("agg")
    from matplotlib import pyplot

    yield pyplot
    pyplot.close("all")


def of_labels(ax):
    return [it for it in ax.get_legend_handles_labels()[1] if it]


def name_of(series):
    return [series[name] for name in sorted(series) if name[0] not in "xy"]


def is_drawn(panel, ax, above=()):
    """Asserts that axes have the limits, curves, points, labels and error bars of a panel."""
    explained = [name_of(series) for it in above for series in it["series"]]
    for name in "xy":
        axis = panel[name]
        assert getattr(ax, f"get_{name}lim")() == pytest.approx((axis["from"], axis["to"]))
        scale = "log" if axis["scale"] == "logarithmic" else "linear"
        assert getattr(ax, f"get_{name}scale")() == scale
    assert ax.get_ylabel() == panel["y"]["label"]
    new = [series for series in panel["series"] if name_of(series) not in explained]
    named = [series["label"] for series in new if series["label"]]
    assert sorted(of_labels(ax)) == sorted(named)
    shown = [text.get_text() for text in ax.get_legend().get_texts()] if named else []
    assert sorted(shown) == sorted(dict.fromkeys(named))
    lines = [series for series in panel["series"] if series["mark"] != "band"]
    # The caps of error bars are markers of their own.
    drawn = [line for line in ax.lines if line.get_marker() not in ("_", "|")]
    assert len(drawn) == len(lines)
    for series, line in zip(lines, drawn):
        expected = np.array([series["x"], series["y"]], dtype=float)
        np.testing.assert_array_equal(np.array(line.get_data(), dtype=float), expected)
        assert line.get_color() == series["colour"]
    with_bars = [it for it in lines if "x_uncertainty" in it or "y_uncertainty" in it]
    assert len(ax.containers) == len(with_bars)
    for series, container in zip(with_bars, ax.containers):
        *_, bars = container.lines
        ends = np.array([it for it in bars[-1].get_segments() if len(it)])
        if "y_uncertainty" in series and ends.size:
            halves = np.array(series["y_uncertainty"], dtype=float)
            halves = halves[np.isfinite(halves)]
            np.testing.assert_allclose(0.5 * np.ptp(ends[:, :, 1], axis=1), halves, rtol=1e-6)


@pytest.mark.parametrize("name", DRAWN)
def test_a_plot_draws_the_chart(name, pyplot):
    answer = DRAWN[name]()
    chart = answer.chart()
    assert chart["schema"] == 2 and chart["title"]
    axes = answer.plot()
    drawn = axes if isinstance(axes, np.ndarray) else [axes]
    assert len(drawn) == len(chart["panels"]) and isinstance(axes, np.ndarray) == (len(drawn) > 1)
    for place, (panel, ax) in enumerate(zip(chart["panels"], drawn)):
        is_drawn(panel, ax, chart["panels"][:place])
    title = " ".join(drawn[0].figure.get_suptitle().split())
    assert title == " ".join([chart["title"], ", ".join(chart["parameters"])]).strip()
    assert drawn[-1].get_xlabel()
    drawn[0].figure.canvas.draw()
    _, given = pyplot.subplots(len(drawn), 1, squeeze=False)
    again = answer.plot(given[:, 0])
    for place, (panel, ax) in enumerate(zip(chart["panels"], np.ravel(again))):
        assert ax is given[place, 0] and ax.get_xlabel() and not ax.figure.get_suptitle()
        is_drawn(panel, ax, chart["panels"][:place])


def test_all_commands_that_draw_are_tested():
    draw = {
        words
        for words, question in catalogue().items()
        if any(parameter.name == "figure" for parameter in question.parameters)
    }
    assert {name for name in draw if not name.startswith("figure")} == set(DRAWN)


@pytest.mark.parametrize("name", ["decay", "response", "fit trace", "modes"])
def test_the_chart_is_that_of_the_command(name, tmp_path):
    answer = DRAWN[name]()
    picture = answer.picture()
    picture.save(tmp_path / "a.json")
    saved = json.loads((tmp_path / "a.json").read_text())
    assert picture.chart() == saved
    if name != "response":
        # The picture of the command has sweeps that the result was not asked for.
        assert answer.chart() == saved


def test_axes_must_be_as_many_as_panels(pyplot):
    decay = DRAWN["decay"]()
    _, ax = pyplot.subplots()
    with pytest.raises(TypeError, match="got 1 Axes: the picture has 2 panels; give a seq"):
        decay.plot(ax)
    _, several = pyplot.subplots(3)
    with pytest.raises(TypeError, match="got 3 Axes: the picture has 2 panels"):
        decay.plot(several)
    period = DRAWN["period"]()
    with pytest.raises(TypeError, match="got 3 Axes: the picture has 1 panel; give one Axes"):
        period.plot(several)
    assert period.plot(ax) is ax and period.plot([ax]) is ax


def test_two_results_share_axes(pyplot):
    _, ax = pyplot.subplots()
    questions.period("10deg:30deg:10deg").plot(ax)
    questions.period("10deg:170deg:10deg").plot(ax)
    questions.period("10deg:30deg:10deg").plot(ax)
    assert ax.get_xlim()[1] > 170 and len(ax.get_legend().get_texts()) == 2


def test_ticks_are_parts_of_a_turn(pyplot):
    motion = questions.motion("60deg")
    ticks = np.ravel(motion.plot())[0].get_yticks()
    assert set(np.round(ticks % 15, 9)) == {0}
    radians = questions.motion("150deg").picture(angles="radians").plot()
    axis = np.ravel(radians)[0].yaxis
    axis.axes.figure.canvas.draw()
    assert "π/2" in [label.get_text() for label in axis.get_ticklabels()]
    modes = DRAWN["modes"]().plot()
    modes.figure.canvas.draw()
    assert [label.get_text() for label in modes.get_xticklabels()] == ["θ₁", "θ₂"]


def test_a_followed_mode_is_drawn_with_its_stability(pyplot):
    answer = lb.modes("double_pendulum", follow=2, amplitudes=["30deg", "50deg", "60deg"])
    lines = {line.get_label(): line for line in answer.plot().lines}
    assert np.degrees(answer.points.amplitude[:2]).tolist() == pytest.approx(
        lines["stable"].get_xdata().tolist()
    )
    assert lines["unstable"].get_xdata().round(9).tolist() == [60]
    np.testing.assert_array_equal(
        lines["ω + κa²"].get_ydata(), answer.points.series_angular_frequency_rad_per_s
    )


def test_motions_in_both_directions_and_with_sensitivities_are_drawn(pyplot):
    both = questions.simulate("x'' = -4*x", initial={"x": 1}, times="-3:2:0.5").plot()
    assert both.get_xlim() == (-3, 2)
    t, x = both.lines[0].get_data()
    np.testing.assert_allclose(x, np.cos(2 * t), atol=1e-10)
    question = {"initial": {"x": 1}, "set": {"c": 0.1}, "times": "0:2:0.5"}
    system = "x'' = -c*x' - 4*x"
    curves = [
        questions.simulate(system, **question, **more).chart()["panels"][0]["series"][0]
        for more in ({}, {"sensitivity": "c"})
    ]
    np.testing.assert_allclose(curves[1]["y"], curves[0]["y"], atol=1e-10)


def test_what_has_no_picture_says_so():
    with pytest.raises(TypeError, match="there is no picture of this result of `list`"):
        lb.list_("lorenz").plot()
    with pytest.raises(TypeError, match=r"lab\.spectrum"):
        lb.lab.read(EXAMPLES / "swing_synthetic.csv").plot()
    with pytest.raises(TypeError, match="give initial"):
        lb.resonance("x'' = -x - x*y; y'' = -4.1*y - x^2/2", order=2).plot()


def test_pickled_results_are_drawn(pyplot):
    decay = DRAWN["decay"]()
    for other in (pickle.loads(pickle.dumps(decay)), copy.deepcopy(decay)):
        assert other.chart() == decay.chart()


def test_a_plot_takes_no_second_run(pyplot):
    start = time.perf_counter()
    answer = questions.decay("90deg", linear=0.001, cycles=3000)
    computed = time.perf_counter() - start
    answer.chart()
    start = time.perf_counter()
    answer.chart()
    assert time.perf_counter() - start < max(0.5 * computed, 0.05)


def test_pictures_of_the_pendulum_are_plotted(pyplot):
    picture = lb.figure.errors(formulas=["bernoulli", "black_vel_2"])
    ax = picture.plot()
    is_drawn(picture.chart()["panels"][0], ax)
    assert ax.get_yscale() == "log" and of_labels(ax)[0] == "Bernoulli"


def test_matplotlib_is_needed_for_plots_only():
    script = (
        "import sys; sys.modules['matplotlib'] = None; import libration as lb\n"
        "answer = lb.questions.motion('60deg'); print(len(answer.chart()['panels']))\n"
        "answer.plot()"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert run.stdout.strip().isdigit()
    assert "pictures need matplotlib: pip install 'libration[plot]'" in run.stderr
