"""Pendulum and motion as a Python programmer would guess them."""

import copy
import pickle
from decimal import Decimal
from fractions import Fraction

import matplotlib
import mpmath as mp
import numpy as np
import pytest

import libration as lb
import truth
from truth import ulps

matplotlib.use("agg")
PENDULUM = lb.Pendulum(length=0.994, gravity=9.81)
STARTS = {
    "libration": PENDULUM.release("60deg"),
    "rotation": PENDULUM.launch("-30deg", 9.0),
    "separatrix": lb.Pendulum(1.0, 9.0).launch(0.0, 6.0),
    "rest (stable)": PENDULUM.release(0.0),
    "rest (upright)": PENDULUM.release("180deg"),
}


def read_back(it):
    """The object of a text, after ``from libration import *; from numpy import *``."""
    names = {name: getattr(lb, name) for name in lb.__all__}
    return eval(repr(it), {**vars(np), **names, "Fraction": Fraction})


def test_pendulums_say_what_they_are():
    assert repr(PENDULUM) == "Pendulum(length=0.994, gravity=9.81)"
    assert lb.Pendulum("99.4 cm", "9.81 m/s^2") == PENDULUM != lb.Pendulum(1.0)
    assert lb.Pendulum(1).gravity == lb.STANDARD_GRAVITY == 9.80665
    assert len({PENDULUM, lb.Pendulum(0.994, 9.81)}) == 1
    assert ulps(PENDULUM.small_angle_period, truth.seconds(0, 0.994, 9.81)) <= 0.6
    assert ulps(PENDULUM.angular_frequency, mp.sqrt(mp.mpf(9.81) / mp.mpf(0.994))) <= 0.6


def test_pendulums_stay_what_they_are():
    with pytest.raises(AttributeError):
        PENDULUM.length = 2.0
    with pytest.raises(AttributeError):
        PENDULUM.release(1.0).angle = 2.0


@pytest.mark.parametrize("regime", STARTS)
def test_motions_pickle_copy_compare(regime):
    motion = STARTS[regime]
    assert motion.regime == regime
    for other in (pickle.loads(pickle.dumps(motion)), copy.copy(motion), copy.deepcopy(motion)):
        assert other == motion and hash(other) == hash(motion) and other(1.25) == motion(1.25)
    assert read_back(motion) == motion


def test_periods_are_the_exact_ones():
    angle = mp.pi / 3
    assert ulps(STARTS["libration"].period, truth.seconds(angle, 0.994, 9.81)) <= 0.6
    # π - 1e-300: 2/π·ln(8/δ) of the small period.
    top = PENDULUM.release("pi-1e-300")
    assert ulps(
        top.period, truth.seconds(0, 0.994, 9.81) * 2 / mp.pi * mp.log(8 / mp.mpf("1e-300"))
    ) <= 0.6
    assert (top.amplitude, top.complement) == (np.pi, 1e-300)
    assert STARTS["separatrix"].period == np.inf and np.isnan(STARTS["rest (upright)"].period)
    assert STARTS["rest (stable)"].period == PENDULUM.small_angle_period
    assert STARTS["rotation"].amplitude is None and STARTS["rotation"].complement is None


def test_energies():
    assert ulps(STARTS["libration"].energy_ratio, mp.sin(mp.pi / 6) ** 2) <= 1
    assert STARTS["separatrix"].energy_ratio == 1 and STARTS["separatrix"].energy_excess == 0
    assert STARTS["rotation"].energy_excess == pytest.approx(
        STARTS["rotation"].energy_ratio - 1, rel=1e-15
    )
    # J = 8ω0(E - k'²K)/π.
    m = mp.mpf(1) / 4
    omega0 = mp.sqrt(mp.mpf(9.81) / mp.mpf(0.994))
    action = 8 * omega0 * (mp.ellipe(m) - (1 - m) * mp.ellipk(m)) / mp.pi
    assert ulps(STARTS["libration"].action, action) <= 2


@pytest.mark.parametrize("shape", [(), (0,), (1,), (7,), (2, 3), (2, 0, 4)])
def test_times_have_any_shape(shape):
    t = np.linspace(-3, 3, int(np.prod(shape))).reshape(shape)
    motion = STARTS["rotation"]
    angle, velocity = motion(t)
    assert np.shape(angle) == np.shape(velocity) == shape
    each = [motion(float(x)) for x in np.ravel(t)]
    assert np.ravel(angle).tolist() == [x.angle for x in each]
    assert np.ravel(velocity).tolist() == [x.velocity for x in each]
    for other in (
        np.copy(t, order="F"),
        np.repeat(t[..., None], 2, -1)[..., 0],
        t.astype(">f8"),
        t.astype(object).astype(float),
    ):
        assert np.array_equal(motion(other).angle, angle)


def test_states_are_those_of_the_ufunc():
    motion, t = PENDULUM.launch(0.3, 9.0), np.linspace(0, 9, 50)
    lone = lb.motion(t, 0.3, 9.0, PENDULUM.angular_frequency)
    # ω0 is rounded for the ufunc.
    np.testing.assert_allclose(motion(t).angle, lone[0], rtol=1e-14)
    angle = motion(2.0).angle
    assert isinstance(angle, float) and np.isnan(motion(np.inf).angle)


def test_harmonics_add_up_to_the_motion():
    for motion in (STARTS["libration"], STARTS["rotation"]):
        h = motion.harmonics(tolerance=1e-15)
        t = np.linspace(0, 1, 30)
        phase = h.fundamental * (t - h.epoch)
        waves = np.cos if motion.regime == "libration" else np.sin
        angle = h.mean_velocity * (t - h.epoch) + waves(np.outer(phase, h.n)) @ h.angle
        np.testing.assert_allclose(angle, motion(t).angle, atol=1e-13)
        assert len(h) == len(h.n)
        assert h == motion.harmonics(tolerance=1e-15) != motion.harmonics(tolerance=1e-3)
        assert pickle.loads(pickle.dumps(h)) == h
    assert len(STARTS["libration"].harmonics(limit=2)) == 2


def test_pictures_show_the_motion():
    for motion in STARTS.values():
        if motion.regime == "rest (upright)":
            continue
        ax = motion.plot()
        t, angle = ax.lines[0].get_data()
        assert np.array_equal(np.degrees(motion(t).angle), angle)
        assert (ax.get_xlabel(), ax.get_ylabel()) == ("t / s", "θ / °")
        assert motion.plot(ax=ax, t=[0, 1]) is ax
        matplotlib.pyplot.close()


@pytest.mark.parametrize("call, error, message", [
    (lambda: lb.Pendulum(-1.0), lb.errors.PendulumError, "length is -1.0: give a positive"),
    (lambda: lb.Pendulum(1e-300, 1e300), lb.errors.PendulumError, "out of range"),
    (lambda: lb.Pendulum("1 s"), lb.errors.QuantityError, "is a time, not a length"),
    (lambda: lb.Pendulum(1j), TypeError, "^length: got complex: give a number or a text"),
    (lambda: lb.Pendulum(None), TypeError, "^length: got NoneType"),
    (lambda: PENDULUM.release("60 degrees of"), lb.errors.QuantityError, "60 degrees of"),
    (lambda: PENDULUM.release(np.inf), lb.errors.QuantityError, "give a finite angle"),
    (lambda: PENDULUM.release([1.0, 2.0]), TypeError, "^angle: got list: give a number"),
    (lambda: PENDULUM.release("pi-1e-308"), lb.errors.QuantityError, "at least 1e-300 rad"),
    (lambda: PENDULUM.launch(0.0, np.nan), lb.errors.PendulumError, "velocity is NaN"),
    (lambda: PENDULUM.launch(0.0, "3m"), lb.errors.QuantityError, "not an angular velocity"),
    (lambda: PENDULUM.release(1.0)("noon"), TypeError, "^t: got 'noon': give a number or an array"),
    (lambda: PENDULUM.release(1.0)(np.array([1j])), TypeError, "^t: got complex"),
    (lambda: PENDULUM.release(1.0)([None]), TypeError, "^t: got NoneType"),
    (lambda: PENDULUM.release(1.0).harmonics(limit=-1), ValueError, "limit: got -1"),
])
def test_what_cannot_be_is_refused_with_the_reason(call, error, message):
    with pytest.raises(error, match=message) as caught:
        call()
    assert not isinstance(caught.value, lb.LibrationError) or isinstance(caught.value, ValueError)


def test_texts_without_a_unit_are_warned_of():
    with pytest.warns(UserWarning, match="taken as 60 rad"):
        PENDULUM.release("60")


def test_states_of_arrays_are_compared():
    motion = lb.Pendulum("1m").release("60deg")
    times = [0.0, 0.5]
    assert motion(times) == motion(times) and not motion(times) != motion(times)
    assert motion(times) != motion([0.0, 0.6]) and motion(0.1) == motion(0.1)


def test_objects_are_printed_so_that_they_can_be_read_back():
    times, tenths = np.linspace(0, 1, 11), np.arange(7) / 10
    motion = PENDULUM.release(np.float32(1.1))
    series = lb.expand("pendulum", 5)
    for it in [
        lb.Pendulum("99.4cm", "9.81m/s^2"),
        motion,
        PENDULUM.launch("-30deg", Decimal("2.5")),
        motion(0.3),
        motion(times),
        motion(np.inf),
        motion.harmonics(),
        series.evaluate(0.3),
        series.evaluate([0.1, 0.2]),
        series.frequency,
        lb.formulas["denman"],
        lb.simulate("pendulum", {"theta": "60deg"}, 1)(times),
        lb.simulate("pendulum", {"theta": 1}, [0, 5], events=["theta"]).events["theta"],
        lb.simulate("pendulum", {"theta": "60deg"}, 1.0),
        lb.simulate("x' = -k*x", {"x": 1}, times, set={"k": "1/3"}, tolerance=1e-9),
        lb.simulate("x'' = -x", {"x": 1}, tenths, events={"x": "falling"}, until=("x", "any")),
        lb.simulate("x'' = -x", {"x": 1}, tenths, events=["x"], until=("x", "rising")),
        lb.simulate("x' = -x", {"x": 1}, []),
    ]:
        assert read_back(it) == it, repr(it)
    spaced = repr(lb.simulate("x' = -x", {"x": 1}, times))
    assert spaced == "simulate(\"x' = -x\", initial={'x': '1'}, times=linspace(0.0, 1.0, 11))"
    with pytest.raises(lb.errors.SimulationError) as stopped:
        lb.simulate("x' = x^2", {"x": 1}, [0.5, 2])
    ended = repr(stopped.value.partial)
    assert ended.startswith("<Simulation of equations of motion, 1 states: ")
    assert "ended: it reached t = 1.0\n" in str(lb.simulate("x' = -x", {"x": 1}, 1))


def test_notebooks_show_facts():
    pendulum = lb.Pendulum(1.0, 9.81)
    shown = [
        pendulum,
        pendulum.release("60deg"),
        lb.expand("pendulum", 5).evaluate(0.5),
        lb.simulate("x' = -x", {"x": 1}, [0, 1]),
    ]
    for it, fact in zip(shown, ["9.81 m/s²", "libration", "left out, at most", "t = 1.0"]):
        assert fact in it._repr_html_() and it._repr_html_().startswith("<table>")
