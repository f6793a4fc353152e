"""Every question of the command from Python: its parameters, and the same JSON."""

import importlib.util
import inspect
import json
import math
import os
import re
import shlex
import subprocess
import sys
from importlib.machinery import SourceFileLoader
from pathlib import Path

import numpy as np
import pytest

import libration as lb
from libration import _native, questions
from libration._ask import catalogue

ROOT = Path(__file__).parents[2]
SWING = str(ROOT / "examples/swing_synthetic.csv")
DRIVE = {"A": 1.5, "c": "1/2"}

# What is asked by a function, with what it is given, and what is asked of the command.
PAIRS = [
    (questions.period, (["60deg", 1.2],), {"length": "57cm"}, "period 60deg 1.2 --length 57cm"),
    (
        questions.period,
        (np.linspace(0.1, 3, 5),),
        {"formulas": ["bernoulli", "agm_a1"]},
        "period 0.1 0.825 1.55 2.275 3.0 --formulas bernoulli,agm_a1",
    ),
    (
        questions.motion,
        ("-30deg",),
        {"times": [0, 0.5, 1], "velocity": -0.5},
        "motion --times 0,0.5,1 --velocity=-0.5rad/s -- -30deg",
    ),
    (questions.fourier, (1.5,), {"harmonics": 3}, "fourier 1.5 --harmonics 3"),
    (
        questions.formulas,
        (),
        {"amplitude": "90deg", "tolerance": 1e-3},
        "formulas --amplitude 90deg --tolerance 1e-3",
    ),
    (
        questions.formulas,
        (),
        {"crossovers": True, "formulas": "bernoulli,agm_a1"},
        "formulas --crossovers --formulas bernoulli,agm_a1",
    ),
    (
        questions.decay,
        ("60deg",),
        {"linear": 0.1, "power": ["1.5:0.1", "2.5:0.01"], "cycles": 3},
        "decay 60deg --linear 0.1 --power 1.5:0.1 --power 2.5:0.01 --cycles 3",
    ),
    (
        questions.expand,
        ("duffing",),
        {"order": 5, "set": {"epsilon": "1/2"}},
        "expand duffing --order 5 --set epsilon=1/2",
    ),
    (
        questions.expand,
        ("quadratic",),
        {"order": 3, "evaluate": 0.2},
        "expand quadratic --order 3 --evaluate 0.2",
    ),
    (questions.list_, (["duffing", "pendulum"],), {}, "list duffing pendulum"),
    (questions.backbone, (), {"amplitudes": np.array([0.5, 1.0])}, "backbone --amplitudes 0.5,1.0"),
    (
        questions.simulate,
        ("pendulum",),
        {"initial": {"theta": 1, "theta'": "0.5"}, "times": "0:2:0.5", "events": ["turning"]},
        "simulate pendulum --initial \"theta=1,theta'=0.5\" --times 0:2:0.5 --events turning",
    ),
    (questions.list_, (), {}, "list"),
    (questions.modes, ("double_pendulum",), {"set": {"m2": 2}}, "modes double_pendulum --set m2=2"),
    (
        questions.orbit,
        ("driven_pendulum",),
        {"set": {"A": 0.15, "c": 0.1, "omega": 0.82}},
        "orbit driven_pendulum --set A=0.15 --set c=0.1 --set omega=0.82",
    ),
    (
        questions.resonance,
        ("double_pendulum",),
        {"order": 3, "detuning": 0.05},
        "resonance double_pendulum --order 3 --detuning 0.05",
    ),
    (
        questions.melnikov,
        ("driven_pendulum",),
        {"set": {"c": 0.1, "omega": 1}, "over": "A=0:1", "max_drive_periods": 3},
        "melnikov driven_pendulum --set c=0.1 --set omega=1 --over A=0:1 --max-drive-periods 3",
    ),
    (
        questions.response,
        ("driven_pendulum",),
        {"set": {"A": 0.15, "c": 0.1}, "over": "omega=0.7:0.95"},
        "response driven_pendulum --set A=0.15 --set c=0.1 --over omega=0.7:0.95",
    ),
    (
        questions.stability,
        ("kapitza",),
        {
            "set": {"c": 0.1},
            "map": "omega=5:6,a=0.1:0.4",
            "initial": {"theta": "180deg"},
            "lines": 0,
        },
        "stability kapitza --set c=0.1 --map omega=5:6,a=0.1:0.4 --initial theta=180deg --lines 0",
    ),
    (
        questions.section,
        ("driven_pendulum",),
        {
            "set": DRIVE,
            "initial": [{"theta": 0.2}, {"theta": 0.3}],
            "points": 3,
            "skip": 0,
            "fold": True,
        },
        "section driven_pendulum --set A=1.5 --set c=1/2 --initial theta=0.2 --initial theta=0.3 "
        "--points 3 --skip 0 --fold",
    ),
    (
        questions.bifurcation,
        ("driven_pendulum",),
        {
            "set": {"c": 0.5},
            "over": "A=1:1.2:0.1",
            "initial": {"theta": 0.2},
            "points": 2,
            "skip": 0,
            "sweep": "both",
        },
        "bifurcation driven_pendulum --set c=0.5 --over A=1:1.2:0.1 --initial theta=0.2 --points 2 "
        "--skip 0 --sweep both",
    ),
    (
        questions.lyapunov,
        ("driven_pendulum",),
        {"set": DRIVE, "initial": {"theta": 0.2}, "intervals": 20, "transient": 1},
        "lyapunov driven_pendulum --set A=1.5 --set c=1/2 --initial theta=0.2 --intervals 20 "
        "--transient 1",
    ),
    (
        questions.plan,
        (),
        {"g_to": 1e-3, "length": "1.00(1) m", "angle_noise": "0.2deg", "rate": 60},
        "plan --g-to 1e-3 --length '1.00(1) m' --angle-noise 0.2deg --rate 60",
    ),
    (questions.paper, (), {"only": "wrong"}, "paper --only wrong"),
    (
        questions.inspect,
        (SWING,),
        {"from_": 2, "values": True},
        f"inspect {SWING} --from 2 --values",
    ),
    (
        questions.fit_periods,
        (ROOT / "examples/period_table_synthetic.csv",),
        {"length": "0.994m±0.001m"},
        f"fit periods {ROOT}/examples/period_table_synthetic.csv --length 0.994m±0.001m",
    ),
    (
        questions.fit_lengths,
        (ROOT / "examples/lengths_synthetic.csv",),
        {"amplitude": "10deg"},
        f"fit lengths {ROOT}/examples/lengths_synthetic.csv --amplitude 10deg",
    ),
    (
        questions.fit_amplitudes,
        (ROOT / "examples/amplitudes_synthetic.csv",),
        {"model": "linear"},
        f"fit amplitudes {ROOT}/examples/amplitudes_synthetic.csv --model linear",
    ),
    (
        questions.inspect,
        (SWING,),
        {"spectrum": True, "harmonics": 5, "swings": 4},
        f"inspect {SWING} --spectrum --harmonics 5 --swings 4",
    ),
    (
        questions.fit_response,
        (ROOT / "examples/response_synthetic.csv",),
        {"model": "pendulum"},
        f"fit response {ROOT}/examples/response_synthetic.csv --model pendulum",
    ),
    (
        questions.fit_gates,
        (ROOT / "examples/gate_synthetic.csv",),
        {"amplitude": 0.9},
        f"fit gates {ROOT}/examples/gate_synthetic.csv --amplitude 0.9",
    ),
    (
        questions.fit_trace,
        (SWING,),
        {"length": "0.56m±0.002m", "model": "linear", "robust": True},
        f"fit trace {SWING} --length 0.56m±0.002m --model linear --robust",
    ),
    (questions.fields, ("fit trace",), {}, "fields 'fit trace'"),
]


def command(words, **options):
    told = subprocess.run(
        [sys.executable, "-m", "libration", *words], capture_output=True, text=True, **options
    )
    assert told.returncode == 0, told.stderr
    return told.stdout


def without_options(answer):
    """The answer with sentences in which options and arguments are the same: `--sides one` as
    `sides="one"`.
    """
    text = re.sub(r"--([a-z-]+)", lambda found: found[1].replace("-", "_"), json.dumps(answer))
    return json.loads(text.replace('sides=\\"one\\"', "sides one"))


@pytest.mark.parametrize(
    "function, given, options, line", PAIRS, ids=[line[:40] for *_, line in PAIRS]
)
def test_the_json_is_that_of_the_command(function, given, options, line):
    words = shlex.split(line)
    place = 2 if words[0] == "fit" else 1
    of_command = json.loads(command([*words[:place], "--json", *words[place:]]))
    of_function = function(*given, **options).to_dict()
    assert without_options(of_function) == without_options(of_command)


def test_every_question_is_asked_both_ways():
    asked = {function.__name__ for function, *_ in PAIRS}
    others = {
        "derive",
        "sweep",
        "sweep_join",
        "sweep_status",
        *(name for name in questions.__all__ if name.startswith("figure_")),
    }
    assert asked | others == set(questions.__all__)


@pytest.mark.parametrize("words", [it for it in catalogue() if it.startswith("figure ")])
def test_pictures_are_those_of_the_command(words, tmp_path):
    given = {
        "spectrum": {"amplitudes": ["60deg"]},
        "trajectories": {"system": "pendulum", "initial": {"theta": 1}, "to": 9},
        "series": {"order": 9},
    }
    options = given.get(words.split()[1], {})
    typed = {
        "amplitudes": ["--amplitudes", "60deg"],
        "order": ["--order", "9"],
        "system": ["pendulum"],
        "initial": ["--initial", "theta=1"],
        "to": ["--to", "9"],
    }
    line = [*words.split(), *(word for name in options for word in typed[name])]
    picture = getattr(questions, words.replace(" ", "_"))(**options)
    assert picture.svg == picture._repr_svg_() == command([*line, "--output", "-"])
    answer = json.loads(command([*line, "--json", "--output", str(tmp_path / "a.svg")]))
    assert {**picture.to_dict(), "output": ""} == {**answer, "output": ""}
    picture.save(tmp_path / "b.png")
    assert (tmp_path / "b.png").read_bytes().startswith(b"\x89PNG")


def test_sweeps_are_those_of_the_command(tmp_path):
    over = {"A": [1.0, 1.25], "theta": np.array([0.0, 0.5])}
    question = ["lyapunov", "driven_pendulum", "--set", "c=1/2", "--intervals", "5"]
    told = questions.sweep(question, over=over, output=tmp_path / "here")
    there = [
        "sweep",
        "--over",
        "A=1.0,1.25",
        "--over",
        "theta=0.0,0.5",
        "--output",
        str(tmp_path / "there"),
        "--",
        *question,
    ]
    assert told == command(there)
    for name in ("here", "there"):
        questions.sweep_join(tmp_path / name, output=tmp_path / f"{name}.csv")
    assert (tmp_path / "here.csv").read_text() == (tmp_path / "there.csv").read_text()
    status = questions.sweep_status(tmp_path / "here").to_dict()
    assert status == json.loads(command(["sweep", "status", "--json", str(tmp_path / "here")]))


def test_derivations_are_those_of_the_command():
    line = ["derive", "--method", "perturbation", "--order", "3", "--amplitude", "40deg"]
    derivation = lb.derive("perturbation", order=3, amplitude="40deg")
    assert str(derivation) == command(line)
    assert derivation.to_html() == command([*line, "--format", "html"])
    page = derivation._repr_html_()
    assert page.count("&lt;details&gt;") > 3 and page.startswith("<iframe")


def test_the_functions_are_as_the_command_has_its_questions():
    path = ROOT / "scripts" / "questions"
    spec = importlib.util.spec_from_loader(
        "scripts_questions", SourceFileLoader("scripts_questions", str(path))
    )
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    assert script.differences() == [], "run scripts/questions"


# The forms of an answer, pictures' files, scripts for shells, the page for browsers.
ELSEWHERE = {
    *((words, it) for words in ("expand", "resonance") for it in ("latex", "format")),
    ("completions", "shell"), ("page", "output"),
}


def test_python_has_every_question_and_every_option():
    missing = []
    for question in catalogue().values():
        name = question.words.replace(" ", "_")
        function = getattr(questions, "list_" if name == "list" else name, None)
        has = set(inspect.signature(function).parameters) if function else set()
        for it in question.parameters:
            is_form = it.name in ("json", "csv") or (
                question.words.startswith("figure ") and it.name == "output"
            )
            if it.keyword not in has and not is_form and (question.words, it.name) not in ELSEWHERE:
                missing.append((question.words, it.name))
    assert missing == []
    assert len(catalogue()) >= 29


def test_objects_have_the_json_of_the_command():
    motion = lb.Pendulum("57cm", 9.81).launch("40deg", 1.5)
    line = f"motion {motion.angle!r} --velocity 1.5 --length 0.57 --gravity 9.81"
    line = f"{line} --times 0,0.5,1 --json"
    assert motion.to_dict([0, 0.5, 1]) == json.loads(command(shlex.split(line)))
    assert motion.pendulum.to_dict("40deg")["results"][0]["period_s"] == lb.period(
        np.radians(40), 0.57, 9.81
    )
    series = lb.expand("x'' + x + a*x^3 = 0", order=5, set={"a": "1/3"}, gauge="x_max")
    words = ["expand", "x'' + x + a*x^3 = 0", "--order", "5", "--set", "a=1/3", "--gauge", "x_max"]
    assert series.to_dict() == json.loads(command([*words, "--json"]))
    assert series.code("c") == command([*words, "--format", "c"])
    assert lb.expand("van_der_pol", order=2).to_dict() == json.loads(
        command(["expand", "van_der_pol", "--order", "2", "--json"])
    )
    sol = lb.simulate(
        "damped_pendulum", {"theta": "60deg"}, [0, 1, 2.5], set={"c": "0.1"}, events=["theta'"]
    )
    line = "simulate damped_pendulum --initial theta=60deg --times 0,1,2.5 --set c=0.1"
    line = f"{line} --events \"theta'\" --json"
    assert sol.to_dict() == json.loads(command(shlex.split(line)))
    assert [it["state"] for it in sol.to_dict()["samples"]] == sol.y.tolist()
    with pytest.raises(lb.errors.NoAnswer, match="both directions"):
        lb.simulate("pendulum", {"theta": 1}, [0, 1], events={"theta": "rising"}).to_dict()


def test_errors_have_the_reason_in_the_words_of_python():
    with pytest.raises(lb.errors.UsageError, match=r"^amplitude: cannot read `60degg`") as refused:
        lb.decay("60degg", linear=0.1)
    assert refused.value.parameters == ["amplitude"]
    with pytest.raises(lb.errors.UsageError) as refused:
        questions.simulate("driven_pendulum", set="c=k", initial={"theta": 1}, times=[0, 1])
    assert (refused.value.parameter, refused.value.item) == ("set", "c")
    with pytest.raises(
        lb.errors.NoAnswer,
        match="hint: questions.simulate follows the motion; questions.expand with damping_order=2",
    ):
        questions.expand("x'' + 0.1*x' + x = 0")
    with pytest.raises(lb.errors.NoAnswer, match="not below pi"):
        questions.period("200deg")
    with pytest.raises(
        lb.errors.UsageError, match=r"^initial: the system has no state variable `nothing`"
    ):
        lb.section("driven_pendulum", initial={"nothing": 1}, points=3)
    with pytest.raises(TypeError, match="unexpected keyword argument 'lineer'"):
        lb.decay("60deg", lineer=0.1)
    with pytest.raises(TypeError, match="linear|got complex"):
        lb.decay("60deg", linear=1j)
    with pytest.raises(TypeError, match="fold: got 'yes': give True or False"):
        lb.section("driven_pendulum", initial={"theta": 1}, points=3, fold="yes")
    with pytest.raises(lb.errors.NoAnswer, match="cannot read /nowhere.csv"):
        lb.lab.read("/nowhere.csv")
    with pytest.warns(UserWarning, match="for degrees write 30deg"):
        questions.simulate("pendulum", initial={"theta": 30}, times=[0, 1])


def test_numbers_go_down_with_all_their_digits():
    amplitude = 0.1 + 0.2
    answer = questions.period(amplitude)
    assert answer.results[0].amplitude_rad == amplitude
    assert questions.period(np.float64(amplitude)) == answer
    assert questions.period([np.float32(0.1)]).results[0].amplitude_rad == float(np.float32(0.1))


def test_what_is_given_in_other_types():
    sympy = pytest.importorskip("sympy")
    x, t = sympy.Function("x"), sympy.Symbol("t")
    equation = sympy.Eq(x(t).diff(t, 2) + x(t) + x(t) ** 3, 0)
    assert questions.expand(equation, order=3)["frequency_ratio"] == ["1", "0", "3/8"]
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(
        {"amplitude (deg)": [10, 30, 50, 70], "period (s)": [2.0075, 2.0399, 2.1033, 2.2054]}
    )
    by_frame = lb.lab.fit_periods(table)
    assert by_frame == lb.lab.fit_periods({name: table[name].to_numpy() for name in table})
    assert lb.backbone("duffing", amplitudes=pandas.Series([0.5, 1.0])) == lb.backbone(
        "duffing", amplitudes=(0.5, 1)
    )


def test_what_was_answered_is_the_same_in_arrays():
    answer = lb.section("driven_pendulum", set=DRIVE, initial={"theta": 0.2}, points=4, skip=0)
    assert answer.points.state.shape == (4, 2) and answer.points.motion.dtype == np.int64
    assert answer.points[1].state.tolist() == answer["points"][1]["state"]
    assert answer.points["time_s"].tolist() == [it["time_s"] for it in answer["points"]]
    assert len(answer.points[1:]) == 3 and answer.points[-1] == answer.points[3]
    with pytest.raises(AttributeError, match="there are schema, system"):
        answer.nothing
    with pytest.raises(KeyError, match="there are motion, time_s, state"):
        answer.points["nothing"]
    missing = lb.decay("60deg", linear=0.1, cycles=2).turning_points.exact_period_s
    assert np.isnan(missing[0]) and missing[2] > 2


def test_tables_for_pandas_and_xarray():
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    answer = lb.section("driven_pendulum", set=DRIVE, initial={"theta": 0.2}, points=4, skip=0)
    frame = answer.to_pandas()
    errors = ["time_error_s", "theta_error", "theta'_error"]
    assert list(frame) == ["motion", "time_s", "theta", "theta'", *errors] and len(frame) == 4
    assert frame["theta_error"].between(0, 1e-11).all()
    dataset = answer.to_xarray()
    assert dataset["theta'"].values.tolist() == frame["theta'"].tolist()
    assert dataset.attrs["system"] == "driven_pendulum"
    assert dataset.attrs["question"].startswith("libration section")
    assert list(lb.decay("60deg", linear=0.1, cycles=2).turning_points.to_pandas())[:2] == [
        "cycle", "time_s"
    ]


def test_the_question_of_an_answer_can_be_typed():
    answer = lb.decay("60deg", linear=0.1, cycles=2)
    words = shlex.split(answer.question)
    assert json.loads(command([*words[1:2], "--json", *words[2:]])) == answer.to_dict()


def test_files_are_written_and_reports_too(tmp_path):
    picture, report = tmp_path / "fit.svg", tmp_path / "swing.html"
    fit = lb.lab.fit_trace(SWING, length="0.56m±0.002m", model="linear", figure=picture)
    fit.report(report)
    assert picture.read_text().startswith("<svg") and "<!DOCTYPE html>" in report.read_text()[:20]
    assert os.fspath(SWING) in report.read_text()
    rows = tmp_path / "rows.csv"
    answer = questions.simulate("pendulum", initial={"theta": 1}, times=[0, 1], output=rows)
    assert dict(answer) == {} and rows.exists()


def test_introspection_knows_kinds():
    decay = {it.name: it for it in catalogue()["decay"].parameters}
    assert decay["amplitude"].kind == "argument" and decay["amplitude"].is_required
    assert decay["power"].is_repeated and decay["size"].choices == ["page", "column", "slide"]
    assert decay["json"].kind == "flag" and decay["damping-order"].keyword == "damping_order"
    assert _native.questions()[0][0] == "period"


def test_formulas_of_answers_have_other_formats():
    flow = questions.resonance("x''+x+eps*x*y=0; y''+4*y+eps*x^2=0", ratios="1:2")
    assert flow.to_format("latex").count(r"\[") == 8
    functions: dict = {}
    exec(flow.to_format("python"), functions)
    # A_x·A_y/4·sin(2φ_x − φ_y) and −A_x²/8·sin(2φ_x − φ_y).
    assert functions["amplitude_x"](0.4, 0.3, 0.1, 0.8, 0.1) == pytest.approx(
        0.1 * 0.4 * 0.3 / 4 * math.sin(1.5), rel=1e-15
    )
    with pytest.raises(lb.errors.UsageError, match="format"):
        flow.to_format("basic")
    with pytest.raises(lb.errors.UsageError, match="--format"):
        questions.orbit("x''=(1-x^2)*x'-x", initial={"x": 1}).to_format("latex")
