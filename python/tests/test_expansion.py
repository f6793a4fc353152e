"""Exact series, against published fractions and mpmath."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest
import sympy

import libration as lb
from interruption import interrupted_after
from libration import errors
from truth import ratio

PENDULUM = lb.expand("x'' + sin(x) = 0", order=13)


def test_the_pendulum_has_the_coefficients_of_its_elliptic_integral():
    # T/T0 = Σ ((2n)!/4ⁿn!²)² sin²ⁿ(A/2), expanded by SymPy.
    a = sympy.Symbol("A")
    exact = sum(
        (sympy.Rational(sympy.binomial(2 * n, n)) / 4**n) ** 2 * sympy.sin(a / 2) ** (2 * n)
        for n in range(7)
    )
    expected = sympy.series(exact, a, 0, 13).removeO()
    assert sympy.expand(PENDULUM.period.to_sympy() - expected) == 0
    assert PENDULUM.period.coefficients[4] == Fraction(11, 3072)
    assert PENDULUM.frequency.coefficients[:5] == (1, 0, Fraction(-1, 16), 0, Fraction(1, 3072))
    assert PENDULUM.is_proven and PENDULUM.digits is None and PENDULUM.gauge == "fundamental"


def test_published_series():
    # Nayfeh and Mook, equation 2.3.33, and the limit cycle of Van der Pol.
    shift = lb.expand("x'' + w^2*x + a*x^2 + b*x^3 = 0", order=3).frequency[2]
    assert shift == lb.Polynomial(
        ((Fraction(3, 8), (("b", 1), ("w", -2))), (Fraction(-5, 12), (("a", 2), ("w", -4))))
    )
    assert str(shift) == "3/8*b*w^-2 - 5/12*a^2*w^-4" and shift.letters == ("a", "b", "w")
    cycle = lb.expand("van_der_pol", order=4)
    assert cycle.frequency.coefficients == (1, 0, Fraction(-1, 16), 0, Fraction(17, 3072))
    assert cycle.period is None and cycle.gauge is None and cycle.frequency.variable == "mu"
    assert lb.expand("x'' + x + x^3 = 0", order=5).frequency.coefficients == (
        1, 0, Fraction(3, 8), 0, Fraction(-21, 256)
    )


def test_values_of_parameters_are_exact():
    for value in (Fraction(1, 10), "1/10", 0.1):
        assert lb.expand("x'' + x + a*x^3 = 0", 3, set={"a": value}).frequency[2] == Fraction(3, 80)
    named = lb.expand("duffing", 3, letters=["epsilon"]).frequency[2]
    assert named == lb.Polynomial(((Fraction(3, 8), (("epsilon", Fraction(1)),)),))
    other = lb.expand("x'' = x - x^3", 3, about=-1)
    assert other.equilibrium == -1 and other.omega0_squared == 2


def test_equations_of_sympy_are_read():
    t, k = sympy.symbols("t k")
    x, theta = sympy.Function("x")(t), sympy.Function("theta")(t)
    assert lb.expand(sympy.Eq(theta.diff(t, 2), -sympy.sin(theta)), 9).frequency == lb.expand(
        "pendulum", 9
    ).frequency
    found = lb.expand(x.diff(t, 2) + x + k * x**3 * x.diff(t) ** 2 / 3, 7)
    assert found.frequency == lb.expand("x'' + x + k*x^3*x'^2/3 = 0", 7).frequency
    assert sympy.expand(found.frequency.to_sympy().subs(sympy.Symbol("k", positive=True), 0)) == 1


def test_sums_with_their_remainders():
    for degrees in (10, 60, 120):
        found = PENDULUM.evaluate(float(np.radians(degrees)))
        truth = ratio(np.radians(degrees))
        assert found.is_proven
        assert abs(found.value - truth) <= found.remainder + np.spacing(found.value) / 2
        assert found.sums[-1] == found.value and found.powers.tolist() == [0, 2, 4, 6, 8, 10, 12]
        np.testing.assert_allclose(np.cumsum(found.terms), found.sums, rtol=1e-14)
        assert PENDULUM.period(float(np.radians(degrees))) == pytest.approx(found.value, rel=1e-15)
    assert PENDULUM.evaluate(0.5, "frequency").value == pytest.approx(
        float(1 / ratio(0.5)), abs=1e-11
    )
    assert PENDULUM.evaluate(0.5, "a3").value == pytest.approx(
        PENDULUM.harmonics[3](0.5), rel=1e-14
    )
    assert str(found).endswith(f"(left out: at most {found.remainder:.2g})")
    assert str(PENDULUM.evaluate(4.0)).endswith("(no bound on the remainder)")


def test_the_harmonics_are_those_of_the_exact_motion():
    exact = lb.Pendulum(9.81, 9.81).release(0.3).harmonics()
    for n, angle in zip(exact.n[:3].tolist(), exact.angle):
        assert PENDULUM.harmonics[n](0.3) == pytest.approx(angle, rel=1e-8)


def test_the_gauge_moves_what_epsilon_means_and_nothing_else():
    for gauge in ("x_max", "energy", "nome", "A1=1,A3=-1/192"):
        other = lb.expand("pendulum", 7, gauge=gauge)
        assert other.gauge == gauge
        assert other.frequency == lb.expand("pendulum", 7).frequency
    assert lb.expand("pendulum", 7, gauge="x_max").gauge_series.x_max.coefficients[:4] == (
        0, 1, 0, 0
    )


def test_coefficients_that_are_no_fractions_say_so():
    found = lb.expand("x'' + sin(x) - cos(x) = 0", 3)
    assert found.digits == 40 and float(found.equilibrium) == pytest.approx(np.pi / 4)


def test_letters_get_values():
    series = lb.expand("x'' + w^2*x + b*x^3 = 0", 5).frequency
    assert series(0.5, w=1.0, b=1.0) == lb.expand("x'' + x + x^3 = 0", 5).frequency(0.5)
    with pytest.raises(TypeError, match="no value for b: give one for each of b, w"):
        series(0.5, w=1.0)
    assert lb.expand("x'' + k*x + x^3 = 0", 3).frequency[2](k=4.0) == 3 / 32


def test_results_pickle_copy_compare_and_print():
    for other in (pickle.loads(pickle.dumps(PENDULUM)), copy.deepcopy(PENDULUM)):
        assert other == PENDULUM and other.evaluate(0.3) == PENDULUM.evaluate(0.3)
    assert PENDULUM != lb.expand("x'' + sin(x) = 0", order=11)
    assert str(lb.expand("x'' + sin(x) = 0", 3)) == "x'' + sin(x) = 0: Ω/ω0 = 1 - 1/16*A^2 + …"
    assert r"\frac{1}{16} A^{2}" in PENDULUM._repr_latex_()
    assert r"\frac{1}{16} A^{2}" in PENDULUM.frequency._repr_latex_()


def test_large_numbers_come_through_whole():
    # Beyond the 4300 digits that `int` reads by itself.
    from libration.expansion import _integer

    number, text = -(7**6000), ""
    rest = -number
    while rest:
        rest, part = divmod(rest, 10**1000)
        text = str(part).zfill(1000) + text
    assert _integer("-" + text.lstrip("0")) == number and _integer("0") == 0


@pytest.mark.parametrize("call, error, message", [
    (lambda: lb.expand("x''"), errors.ExpansionError, "write x'' = 0"),
    (lambda: lb.expand("x'' - x = 0"), errors.ExpansionError, "points away from it"),
    (lambda: lb.expand("pendulm"), errors.UnknownKeyError, "nearest are pendulum"),
    (lambda: lb.expand("pendulum", 0), errors.ExpansionError, "give 1 to 1000"),
    (
        lambda: lb.expand("pendulum", -1),
        errors.ExpansionError,
        "order -1 is out of range: give 1 to 1000",
    ),
    (lambda: lb.expand("pendulum", gauge="q"), errors.ExpansionError, "unknown gauge `q`"),
    (lambda: lb.expand("duffing", set={"z": 1}), errors.ExpansionError, "no parameter `z`"),
    (lambda: lb.expand("duffing", set={"epsilon": "1/0"}), errors.ExpansionError, "1/0"),
    (lambda: lb.expand("duffing", letters=["z"]), errors.ExpansionError, "no parameter `z`"),
    (lambda: lb.expand("x'' + k*x = 0").evaluate(1.0), errors.ExpansionError, "contain symbols"),
    (lambda: PENDULUM.evaluate(1.0, "a"), errors.ExpansionError, "unknown quantity"),
])
def test_what_cannot_be_is_refused_with_the_reason(call, error, message):
    with pytest.raises(error, match=message):
        call()


def test_ctrl_c_ends_a_long_expansion_and_keeps_what_is_done():
    stopped = interrupted_after(
        0.3, lambda: lb.expand("x'' + w^2*x + a*x^2 + b*x^3 + c*x^4 + d*x^5 = 0", 200)
    )
    assert isinstance(stopped, KeyboardInterrupt)
    assert 1 <= stopped.partial.order < 200
    assert str(stopped.partial.frequency[2]) == "3/8*b*w^-2 - 5/12*a^2*w^-4"


def test_progress_is_told_and_may_end_the_call():
    told = []
    lb.expand("pendulum", 301, progress=lambda done, of: told.append((done, of)))
    assert told and all(of is None or done <= of for done, of in told)

    def refuse(done, of):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        lb.expand("pendulum", 801, progress=refuse)
    assert lb.expand("pendulum", 5, progress=True).order == 5


def test_an_array_of_amplitudes_is_evaluated():
    series = lb.expand("pendulum", 7)
    amplitudes = np.array([[0.1, 0.5], [1.0, 1.5]])
    found = series.evaluate(amplitudes)
    assert found.value.shape == (2, 2) and found.terms.shape == (2, 2, len(found.powers))
    for place, amplitude in np.ndenumerate(amplitudes):
        one = series.evaluate(amplitude)
        assert (found.value[place], found.remainder[place]) == (one.value, one.remainder)
    np.testing.assert_array_equal(found.sums[..., -1], series.evaluate(amplitudes).sums[..., -1])
    for wrong in (np.inf, np.nan, [0.1, np.inf], []):
        with pytest.raises(lb.errors.ExpansionError, match="amplitude: got"):
            series.evaluate(wrong)
