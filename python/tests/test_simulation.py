"""Motions in time, against closed forms, mpmath and SciPy."""

import copy
import pickle

import matplotlib
import numpy as np
import pytest
import scipy.integrate

import libration as lb
from interruption import interrupted_after
from libration import errors
from truth import motion

matplotlib.use("agg")
TIMES = np.linspace(0, 20, 41)
PENDULUM = lb.simulate(
    "theta'' + 9*sin(theta) = 0", {"theta": "60deg", "theta'": 2.5}, TIMES, tolerance=1e-15
)


def test_the_pendulum_has_its_exact_motion():
    exact = np.array([[float(x) for x in motion(t, np.pi / 3, 2.5, 3)] for t in TIMES])
    np.testing.assert_allclose(PENDULUM["theta"], exact[:, 0], atol=1e-13)
    np.testing.assert_allclose(PENDULUM["theta'"], exact[:, 1], atol=1e-13)
    between = np.array([[0.1, 7.77], [13.3, 19.99]])
    states = PENDULUM(between)
    assert states.y.shape == (2, 2, 2) and states["theta"].shape == (2, 2)
    expected = [[float(motion(t, np.pi / 3, 2.5, 3)[0]) for t in row] for row in between]
    np.testing.assert_allclose(states["theta"], expected, atol=1e-13)
    assert np.array_equal(PENDULUM(TIMES).y[0], PENDULUM.y[0]) and PENDULUM(0.0)["theta'"] == 2.5


def test_a_damped_and_driven_system_as_scipy_has_it():
    found = lb.simulate("driven_pendulum", {"theta": 0.2}, TIMES, set={"A": 1.5, "c": "1/2"})
    names = dict(zip(found.names, found(0.0).y))
    assert names == {"theta": 0.2, "theta'": 0.0} and found.units == ("rad", "rad/s")
    # θ'' = -θ'/2 - sin θ + 1.5 cos(2t/3), as `found.equation` says.
    right = lambda t, y: [y[1], -0.5 * y[1] - np.sin(y[0]) + 1.5 * np.cos(2 / 3 * t)]
    theirs = scipy.integrate.solve_ivp(
        right, (0, 20), [0.2, 0], "DOP853", TIMES, rtol=1e-12, atol=1e-12
    )
    np.testing.assert_allclose(found["theta"], theirs.y[0], atol=1e-6)


def test_the_energy_of_coupled_systems_is_kept():
    found = lb.simulate(
        "x'' = -x - 2*x*y; y'' = -y - x^2 + y^2", {"x": 0.1, "y": 0.2, "x'": "1/5"}, TIMES
    )
    x, y, u, v = found.y.T
    energy = (u**2 + v**2 + x**2 + y**2) / 2 + x**2 * y - y**3 / 3
    np.testing.assert_allclose(energy, energy[0], rtol=1e-13)


def test_errors_of_all_states_hold():
    exact = np.array([[float(x) for x in motion(t, np.pi / 3, 2.5, 3)] for t in TIMES])
    assert PENDULUM.errors.shape == PENDULUM.y.shape and PENDULUM.determined_until is None
    # The typed start is half an ulp off: sin and cos of the exact motion, and its own rounding.
    assert np.all(np.abs(PENDULUM.y - exact) <= PENDULUM.errors + 2e-14)
    assert np.all(PENDULUM.errors[0] == 0) and np.all(PENDULUM.errors < 1e-12)
    both = lb.simulate("x'' = -x", {"x": 1}, [-50, 0, 50], events=["x"])
    expected = np.array([np.cos(both.t), -np.sin(both.t)]).T
    assert np.all(np.abs(both.y - expected) <= both.errors)
    passages = both.events["x"]
    whole = np.round(passages.t / np.pi - 0.5) + 0.5
    assert passages.errors.shape == passages.y.shape
    assert np.all(np.abs(passages.t - whole * np.pi) <= passages.t_errors)
    assert np.all(passages.t_errors < 1e-11)


def test_motions_are_determined_for_a_while_only():
    top = lb.simulate("pendulum", {"theta": "179.999999deg"}, [0, 20, 100])
    assert 40 < top.determined_until < 100
    assert np.all(np.isfinite(top.errors[:2])) and np.all(np.isnan(top.errors[2]))
    assert "not determined" in top._repr_html_()
    without = lb.simulate("pendulum", {"theta": 1}, [0, 1], errors=False, events=["theta"])
    assert without.errors is None and without.events["theta"].errors is None
    assert without.to_dict()["no_errors"] == "--no-errors"
    chain = lb.simulate("x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..40", {"x[1]": 1}, [0, 1])
    assert chain.errors is None
    assert "theta = 1," in lb.simulate("pendulum", {"theta": 1}, 0)._repr_html_()


def test_times_on_both_sides_of_the_start():
    found = lb.simulate("x'' = -9.81", {"x": 1, "x'": 2}, [-1, -0.5, 0, 0.5, 1], events=["x"])
    t = np.array([-1, -0.5, 0, 0.5, 1])
    np.testing.assert_allclose(found["x"], 1 + 2 * t - 9.81 / 2 * t**2, rtol=1e-15)
    np.testing.assert_allclose(
        found([[-0.9, 0.9]])["x'"], [[2 + 9.81 * 0.9, 2 - 9.81 * 0.9]], rtol=1e-14
    )
    roots = np.roots([-9.81 / 2, 2, 1])
    np.testing.assert_allclose(found.events["x"].t, np.sort(roots), rtol=1e-14)
    assert found.events["x"].contact == ("rising", "falling") and found.end == 1
    backward = lb.simulate("x'' = -9.81", {"x": 1, "x'": 2}, [-0.5, -1])
    assert np.array_equal(backward["x"], found["x"][1::-1])


def test_events_and_the_end_at_one():
    # sin t: zeros at multiples of π.
    found = lb.simulate(
        "x'' + x = 0", {"x'": 1}, 10.0, events={"x": "falling", "x' = 0": "any", "x = 2": "any"}
    )
    np.testing.assert_allclose(found.events["x"].t, [np.pi, 3 * np.pi], rtol=1e-14)
    np.testing.assert_allclose(
        found.events["x' = 0"].t, np.pi * np.array([0.5, 1.5, 2.5]), rtol=1e-14
    )
    assert len(found.events["x = 2"]) == 0 and found.events["x = 2"].y.shape == (0, 2)
    for until, end in (
        ("x = 1/2", np.pi / 6), (("x", "falling"), np.pi), (("x", "rising"), 2 * np.pi)
    ):
        ended = lb.simulate("x'' + x = 0", {"x'": 1}, np.arange(1, 10), until=until)
        assert ended.end == pytest.approx(end, rel=1e-14)
        assert ended.t.tolist() == list(range(1, int(end) + 1))


def test_a_text_is_one_event():
    sol = lb.simulate("theta'' + sin(theta) = 0", {"theta": "90deg"}, 10.0, events="theta")
    assert list(sol.events) == ["theta"] and len(sol.events["theta"]) == 3


def test_a_number_is_one_time():
    found = lb.simulate("x' = x", {"x": 1}, 1)
    assert found.t.tolist() == [1.0]
    assert found["x"][0] == pytest.approx(np.e, rel=1e-14)
    assert found.names == ("x",)
    assert lb.simulate("x' = x", {"x": 1}, 0)(0)["x"] == 1
    assert len(lb.simulate("x' = x", {"x": 1}, [])) == 0


def test_values_are_numbers_fractions_or_formulas():
    from fractions import Fraction

    given = [(0.5, 2), ("1/2", "sqrt(4)"), (Fraction(1, 2), Fraction(2))]
    given += [(np.float64(0.5), np.int64(2))]
    each = [lb.simulate("x'' = -k*x", {"x": x}, [1.0], set={"k": k})["x"][0] for x, k in given]
    assert set(each) == {each[0]} and each[0] == pytest.approx(np.cos(np.sqrt(2)) / 2, rel=1e-14)
    chain = lb.simulate(
        "x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..3; x[0] = 0; x[4] = 0",
        {"x[i]": "sin(pi*i/4)"},
        [0.0],
    )
    np.testing.assert_allclose(chain.y[0, :3], np.sin(np.pi * np.arange(1, 4) / 4), rtol=1e-15)


def test_results_pickle_copy_compare_and_go_elsewhere():
    for other in (pickle.loads(pickle.dumps(PENDULUM)), copy.deepcopy(PENDULUM)):
        assert other == PENDULUM and other(3.3) == PENDULUM(3.3)
    pytest.importorskip("xarray")
    table = PENDULUM.to_xarray()
    assert table["theta"].attrs == {"units": "rad"}
    assert np.array_equal(table["theta'"], PENDULUM["theta'"])
    ax = PENDULUM.plot()
    assert np.array_equal(ax.lines[0].get_ydata(), PENDULUM["theta"])
    assert ax.get_ylabel() == "theta / rad"
    assert PENDULUM.plot("theta", "theta'", ax=ax) is ax
    matplotlib.pyplot.close()


def test_a_motion_that_stops_is_known_up_to_there():
    with pytest.raises(errors.SimulationError, match="singularity, at t = 0.99999") as caught:
        lb.simulate("x' = x^2", {"x": 1}, [0.25, 0.5, 2])
    partial = caught.value.partial
    assert partial.t.tolist() == [0.25, 0.5] and partial(0.9)["x"] == pytest.approx(10, rel=1e-10)


def test_ctrl_c_ends_a_long_motion_and_keeps_what_is_done():
    times = np.linspace(0, 1e9, 1_000_001)
    stopped = interrupted_after(0.3, lambda: lb.simulate("double_pendulum", {"theta1": 2.0}, times))
    partial = stopped.partial
    assert 0 < partial.end < 1e9 and partial.names == ("theta1", "theta2", "theta1'", "theta2'")
    assert partial(partial.end / 2).y.shape == (4,)


def test_progress_is_told_and_may_end_the_call():
    told = []
    lb.simulate(
        "double_pendulum",
        {"theta1": 2.0},
        4000.0,
        progress=lambda done, of: told.append((done, of)),
    )
    assert told == sorted(told) and {of for _, of in told} == {1000}

    def refuse(done, of):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        lb.simulate("double_pendulum", {"theta1": 2.0}, 1e9, progress=refuse)


@pytest.mark.parametrize("call, message", [
    (lambda: lb.simulate("x'", {}, 1), "has no = sign"),
    (lambda: lb.simulate("dubble_pendulum", {}, 1), "nearest are double_pendulum"),
    (lambda: lb.simulate("x'' = -k*x", {"x": 1}, 1), 'give it one, such as set={"k": 0.1}'),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, 1, set={"k": 1}), "no parameter"),
    (lambda: lb.simulate("x'' = -x", {"y": 1}, 1), "no state variable `y`: it has x, x'"),
    (lambda: lb.simulate("x'' = -x", {"x": "1 kg"}, 1), "cannot read `1 kg`"),
    (lambda: lb.simulate("x'' = -x", {"x": np.nan}, 1), "x: cannot read `nan`"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, [1, 0.5]), "must lead away from the start"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, [1, np.inf]), "times contain inf"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, [[1.0]]), "2 dimensions"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, 1, tolerance=1.0), "tolerance: got 1: give a"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, 1, events=["y"]), "no state variable `y`"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, 1, events=["x +"]), "x \\+"),
    (lambda: lb.simulate("x'' = -x", {"x": 1}, 1, events={"x": "up"}), "unknown direction `up`"),
    (lambda: PENDULUM(21.0), "t = 21.0 is beyond the motion"),
    (lambda: PENDULUM(np.nan), "t = NaN is beyond the motion"),
])
def test_what_cannot_be_is_refused_with_the_reason(call, message):
    with pytest.raises(errors.SimulationError, match=message):
        call()


def test_other_types_are_refused():
    with pytest.raises(TypeError, match="times: got 'noon': give a number or an array of numbers"):
        lb.simulate("x'' = -x", {"x": 1}, "noon")
    with pytest.raises(TypeError, match="initial: got 1: give values by name"):
        lb.simulate("x'' = -x", 1, 2.0)
    with pytest.raises(TypeError, match=r"set: got \[1\]: give values by name"):
        lb.simulate("x'' = -k*x", {"x": 1}, 2.0, set=[1])
    with pytest.raises(TypeError):
        PENDULUM(1j)
    with pytest.raises(KeyError, match="it has theta, theta'"):
        PENDULUM["phi"]


def test_a_function_in_the_place_of_equations_is_refused():
    with pytest.raises(TypeError, match="give the name of a system, or its equations as text"):
        lb.simulate(lambda t, y: y, {"x": 1}, times=1)


def test_a_motion_that_is_too_long_to_be_kept_ends_with_its_beginning():
    # Equations of many coordinates, of which 1 GB is reached soon.
    chain = "x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..256"
    with pytest.raises(lb.errors.SimulationError, match="take 1 GB") as stopped:
        lb.simulate(chain, {"x[1]": 1}, times=1e9)
    assert stopped.value.partial.end > 1000


def test_a_simulation_says_how_it_ended():
    whole = lb.simulate("pendulum", {"theta": 1}, [0, 1])
    assert whole.success and whole.message == "it reached t = 1.0"
    frame = whole.to_pandas()
    assert list(frame.columns) == ["theta", "theta'"]
    assert frame.index.name == "t"
    assert frame["theta"][0.0] == 1.0
    with pytest.raises(lb.errors.SimulationError) as stopped:
        lb.simulate("x' = x^2", {"x": 1}, [0, 2])
    assert not stopped.value.partial.success and "singularity" in stopped.value.partial.message
