"""Mistakes of a reader of the documentation: each message names the argument in Python's
words, and says what would work.
"""

import re

import numpy as np
import pytest

import libration as lb
from libration import errors, questions

TABLE = {"t (s)": [0, 1, 2], "angle (deg)": [1, 2, 3]}
SWING = lb.Pendulum(1.0).release(1.0)
SOLUTION = lb.simulate("pendulum", {"theta": 1}, [0, 1], events=["theta"])
START = {"initial": {"theta": 0.2}, "points": 2, "skip": 0}

REFUSED = {
    "texts that are not numbers": [
        (lambda: lb.Pendulum("one metre"), errors.QuantityError, "length: cannot read `one metre`"),
        (lambda: SWING.pendulum.release("sixty"), errors.QuantityError, "angle: cannot read"),
        (
            lambda: SWING.pendulum.launch(0, "fast"),
            errors.QuantityError,
            "velocity: cannot read `fast` as an angular velocity: write 0.3rad/s",
        ),
        (
            lambda: lb.formulas["denman"].error("abc"),
            errors.QuantityError,
            "amplitude: cannot read `abc` as an angle: write 60deg",
        ),
        (lambda: lb.formulas["denman"].holds_to("1e-3"), TypeError, "tolerance: got '1e-3': give"),
        (lambda: SOLUTION("1s"), TypeError, "t: got '1s': give a number or an array of numbers"),
    ],
    "numbers out of range": [
        (lambda: SWING.harmonics(tolerance=-1), ValueError, "tolerance: got -1.0: give zero"),
        (lambda: SWING.harmonics(tolerance=np.nan), ValueError, "tolerance: got nan: give zero"),
        (
            lambda: lb.formulas["denman"].holds_to(np.nan),
            errors.FormulaError,
            "tolerance: got nan: give zero or more, such as 1e-3",
        ),
        (lambda: lb.formulas.best(1, -1), errors.FormulaError, "tolerance: got -1: give"),
        (
            lambda: lb.formulas.best("200deg", 1e-3),
            errors.FormulaError,
            "amplitude: got 3.490658503988659 rad, 200°, and swings stay below pi: give a smaller",
        ),
        (lambda: lb.formulas["denman"].worst_error("200deg"), errors.FormulaError, "up_to: got"),
        (
            lambda: lb.simulate("pendulum", {"theta": 1}, 1, tolerance=-1),
            errors.SimulationError,
            "tolerance: got -1: give a number from 1e-18 to 0.1, such as 1e-12",
        ),
    ],
    "other types": [
        (lambda: lb.Motion("1m", 1.0), TypeError, "pendulum: got str: give a Pendulum, such as"),
        (
            lambda: lb.expand(lambda x: x),
            TypeError,
            "oscillator: got function: give the name of an oscillator, or its equation as text",
        ),
        (lambda: lb.expand("pendulum", gauge=3), TypeError, "gauge: got int: give a text, such as"),
        (lambda: lb.expand("duffing", letters=3), TypeError, "letters: got int: give a text"),
        (lambda: lb.expand("duffing", letters=[3]), TypeError, "letters: got int: give a text"),
        (
            lambda: lb.expand("pendulum", 3).evaluate(1.0, 3),
            TypeError,
            'quantity: got int: give a text, such as "period"',
        ),
        (
            lambda: lb.simulate("pendulum", {"theta": 1}, 1, events=3),
            TypeError,
            'events: got 3: give formulas as text, such as ["theta = 0"], or with what counts',
        ),
        (
            lambda: lb.simulate("pendulum", {"theta": 1}, 1, events={"theta": 1}),
            TypeError,
            "events: got {'theta': 1}: give formulas as text",
        ),
        (
            lambda: lb.simulate("pendulum", {"theta": 1}, 1, until=("theta",)),
            TypeError,
            "until: got ('theta',): give a formula as text, such as \"theta = 0\", or with",
        ),
        (lambda: lb.lab.read(3), TypeError, "got int: give the name of a file as text or"),
    ],
    "values without their names": [
        (
            lambda: questions.simulate("pendulum", initial=[1, 0], times=1),
            TypeError,
            'initial: got list: give values by name, such as {"theta": "60deg"}',
        ),
        (
            lambda: lb.expand("duffing", set=[("epsilon", 1)]),
            TypeError,
            "set: got [('epsilon', 1)]: give values by name, such as {\"k\": 0.1}",
        ),
        (
            lambda: lb.response("driven_pendulum", over=0.3),
            TypeError,
            'over: got 0.3: give values by name, such as {"omega": (0.3, 1.4)}',
        ),
        (
            lambda: lb.stability("kapitza", map=3),
            TypeError,
            'map: got int: give values by name, such as {"omega": (5, 20), "a": (0.01, 0.6)}',
        ),
        (lambda: lb.sweep("period", 3, "x.zarr"), TypeError, "over: got 3: give values by name"),
    ],
    "names that do not exist": [
        (
            lambda: lb.expand("pendulum", 3).code("basic"),
            errors.UsageError,
            "language: unknown value `basic`: give one of c, python, rust, fortran",
        ),
        (
            lambda: lb.section("lorenz", direction="up"),
            errors.UsageError,
            "direction: unknown value `up`: give rising, falling or any",
        ),
        (
            lambda: lb.derive("foo"),
            errors.UsageError,
            "method: unknown value `foo`: give elliptic, short, formulas, perturbation",
        ),
        (lambda: SOLUTION["phi"], KeyError, "the state has no variable `phi`: it has theta"),
        (
            lambda: SOLUTION.events["phi"],
            KeyError,
            "the event `phi` was not looked for: there are theta",
        ),
        (lambda: lb.lab.read(TABLE, foo=3), TypeError, "read takes no `foo`: it takes values, "),
        (lambda: lb.lab.spectrum(TABLE, foo=3), TypeError, "spectrum takes no `foo`: it takes"),
        (
            lambda: lb.sweep("period", {"foo": [1, 2]}, "x.zarr"),
            errors.UsageError,
            "over: `foo` is not an option of `period`, which are from_file, period, ratio, excess",
        ),
        (
            lambda: lb.sweep("perod", {"length": [1]}, "x.zarr"),
            errors.UsageError,
            "command: `perod` is not a query with numbers in its result",
        ),
    ],
    "what is missing": [
        (
            lambda: questions.period(),
            errors.UsageError,
            "amplitudes, from_file, period, ratio and excess: one of them is required",
        ),
        (
            lambda: lb.decay("60deg"),
            errors.UsageError,
            "damping: give dry, linear, quadratic, cubic or power, such as linear=0.1; without "
            "damping use questions.motion",
        ),
        (
            lambda: lb.orbit("pendulum"),
            errors.UsageError,
            'initial: the initial state is missing: give it, such as initial={"theta": "60deg"};',
        ),
        (
            lambda: questions.simulate("x'' = -k*x", initial={"x": 1}, times=1),
            errors.UsageError,
            'set: `k` has no value: give it one, such as set={"k": 0.1}',
        ),
        (
            lambda: lb.backbone("duffing", amplitudes=[]),
            ValueError,
            "amplitudes: got no value: give at least one",
        ),
    ],
    "tables in place of files": [
        (
            lambda: lb.lab.fit_trace(TABLE),
            errors.NoAnswer,
            "the table: give at least 14 rows of the table: 3 cannot determine 5 parameters",
        ),
        (lambda: lb.lab.spectrum(TABLE), errors.NoAnswer, "the table: 3 rows are too few"),
        (
            lambda: lb.lab.recording(t=[0, 1, 2], angle=[1, 2]),
            ValueError,
            "the columns differ in shape (t (s): (3,), angle (rad): (2,))",
        ),
    ],
}
CALLS = [(kind, *call) for kind, calls in REFUSED.items() for call in calls]


@pytest.mark.parametrize("kind, call, error, message", CALLS)
def test_messages_are_in_the_words_of_python(kind, call, error, message):
    with pytest.raises(error, match=f"^['\"]?{re.escape(message)}") as found:
        call()
    assert "--" not in str(found.value)


def test_errors_name_their_arguments():
    for call, names in [
        (lambda: lb.Pendulum("one"), ("length",)),
        (lambda: lb.Pendulum(1, "g"), ("gravity",)),
        (lambda: lb.Pendulum(-1), ("length",)),
        (lambda: lb.Pendulum(1, np.nan), ("gravity",)),
        (lambda: lb.Pendulum(1e-300, 1e300), ("length", "gravity")),
        (lambda: SWING.pendulum.release("x"), ("angle",)),
        (lambda: SWING.pendulum.launch(0, np.inf), ("velocity",)),
        (lambda: SWING.pendulum.launch(0, 1e200), ("velocity",)),
        (lambda: lb.formulas["denman"].worst_error("200deg"), ("up_to",)),
    ]:
        with pytest.raises(lb.LibrationError) as found:
            call()
        assert tuple(found.value.parameters) == names and found.value.parameter == names[0]


def test_whole_numbers_of_radians_are_warned_of_as_queries_do():
    for call in [
        lambda: SWING.pendulum.release(60),
        lambda: SWING.pendulum.launch(60.0, 1),
        lambda: lb.formulas["denman"].error(60),
        lambda: lb.simulate("pendulum", {"theta": 60}, 1),
        lambda: questions.simulate("pendulum", initial={"theta": 60}, times=1),
    ]:
        with pytest.warns(UserWarning, match=r"^taken as 60(\.0)? rad .* for degrees") as told:
            call()
        assert [it.filename for it in told] == [__file__]
    # What was calculated is rarely whole; what is not an angle has no degrees.
    later = SWING.pendulum.launch(3.0, 9.0)(5.0)
    assert later.angle > 4 and SWING.pendulum.launch(*later).angle == later.angle
    lb.simulate("x'' = -x", {"x": 60}, 1)


def test_ranges_by_name_are_pairs():
    given = {"set": {"c": 0.1}, "initial": {"theta": "180deg"}, "lines": 0}
    edges = lb.stability("kapitza", map={"omega": (5, 6), "a": (0.1, 0.4)}, **given)
    assert edges == lb.stability("kapitza", map="omega=5:6,a=0.1:0.4", **given)
    diagram = lb.bifurcation("driven_pendulum", over={"A": (1, 1.1, 0.1)}, **START)
    assert diagram == lb.bifurcation("driven_pendulum", over="A=1:1.1:0.1", **START)
    weak = lb.melnikov("driven_pendulum", over={"A": (0, 1)}, set={"c": 0.1, "omega": 1})
    assert weak == lb.melnikov("driven_pendulum", over="A=0:1", set={"c": 0.1, "omega": 1})
