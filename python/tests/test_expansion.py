"""Exact series, against published fractions and mpmath."""

import copy
import pickle
from decimal import Decimal
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
    assert sympy.expand(found.frequency.to_sympy().subs(k, 0)) == 1


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
    # sin(x) - cos(x) is sqrt(2)*sin(x - pi/4).
    found = lb.expand("x'' + sin(x) - cos(x) = 0", 3)
    assert found.digits == 40 and isinstance(found.equilibrium, Decimal)
    assert str(found.equilibrium) == "0.7853981633974483096156608458198757210493"
    assert all(isinstance(it, Decimal) for it in found.frequency.coefficients)
    (factor,) = (found.frequency.to_sympy() - 1).atoms(sympy.Float)
    assert factor == sympy.Float("-0.0625", 40) and factor._prec > 130
    assert str(found.frequency) == "1 - 0.0625*A^2"
    cycle = lb.expand("x'' - mu*(1 - x^2)*x' + 2*x = 0", 3)
    assert cycle.omega0_squared == Fraction(2) and isinstance(cycle.frequency[2], Decimal)
    assert str(cycle.omega0) == "sqrt(2)" and isinstance(cycle.angular_frequency[0], Decimal)
    assert cycle.angular_frequency(0.0) == pytest.approx(np.sqrt(2), rel=1e-15)


A, K, T = sympy.Symbol("A"), sympy.Symbol("k"), sympy.Symbol("t")
X = sympy.Function("x")(T)


def shift(found, power=2):
    return found.frequency.to_sympy().coeff(sympy.Symbol(found.frequency.variable), power)


def test_roots_and_pi_stay_exact():
    # The mean of |cos|^3 is 4/(3 pi).
    half_wave = lb.expand("x'' + x + x*abs(x) = 0", 3)
    assert shift(half_wave, 1) == 4 / (3 * sympy.pi) and half_wave.digits is None
    assert half_wave.frequency(0.1) == pytest.approx(
        half_wave.evaluate(0.1, "frequency").value, rel=1e-14
    )
    assert half_wave.constants == {} and half_wave.frequency[1].letters == ()
    duffing = lb.expand("x'' + 2*x + x^3 = 0", 3)
    assert str(duffing.omega0) == "sqrt(2)" and duffing.omega0.to_sympy() == sympy.sqrt(2)
    assert duffing.angular_frequency.to_sympy() == sympy.sqrt(2) + 3 * sympy.sqrt(2) * A**2 / 16
    assert lb.expand("x'' + 9*x/4 + x^3 = 0", 3).omega0 == Fraction(3, 2)
    rooted = lb.expand("x'' + sqrt(2)*x + x^3 = 0", 5)
    assert sympy.expand(shift(rooted) - 3 * sympy.sqrt(2) / 16) == 0
    assert rooted.constants == {"c1": "sqrt(2)"} and rooted.is_proven
    assert rooted.omega0.to_sympy() == sympy.root(2, 4)
    mirrored = lb.expand("x'' + 2*x + x*x' = 0", 3).harmonics[2].to_sympy()
    assert mirrored.coeff(A, 2) == sympy.sqrt(2) / 12
    kept = pickle.loads(pickle.dumps(rooted))
    assert kept == rooted and kept.evaluate(0.1) == rooted.evaluate(0.1)
    with_letters = lb.expand("x'' + sqrt(2)*x + a*x^3 = 0", 3).frequency
    assert with_letters(0.5, a=2.0) == pytest.approx(1 + 0.75 * 0.25 / np.sqrt(2), rel=1e-14)
    assert lb.expand("x'' + 2*k*x + x^3 = 0", 3).omega0.to_sympy() == sympy.sqrt(
        2 * sympy.Symbol("k", positive=True)
    )
    assert lb.expand("x'' + (k + m)*x + x^3 = 0", 3).omega0 is None


def test_symbols_keep_their_assumptions():
    strength = sympy.Symbol("a", real=True)
    found = lb.expand(sympy.Eq(X.diff(T, 2) + K * X + strength * X**3, 0), 5)
    assert shift(found) == 3 * strength / (8 * K)
    assert found.angular_frequency.to_sympy().coeff(A, 0) == sympy.sqrt(K)
    assert found.omega0.to_sympy().free_symbols == {K}
    # The amplitude gets another name where a symbol has its own.
    own = lb.expand(X.diff(T, 2) + X + A * X**3, 3).frequency
    assert own.variable == "A_1" and own.to_sympy().coeff(sympy.Symbol("A_1"), 2) == 3 * A / 8
    letters = lb.expand("duffing", 3, letters="epsilon").gauge_series.frequency
    assert letters.variable == "epsilon_1"
    with pytest.raises(errors.UsageError, match="two symbols are called k"):
        lb.expand(X.diff(T, 2) + K * X + sympy.Symbol("k", positive=True) * X**3)


@pytest.mark.parametrize("force, same", [
    (sympy.Abs(X) * X, "x*abs(x)"),
    (sympy.Max(X, 0) * X, "x*(x + abs(x))/2"),
    (sympy.Min(X, 0) * X, "x*(x - abs(x))/2"),
    (sympy.Heaviside(X) * X**2, "x*(x + abs(x))/2"),
    (X**2 / (1 + sympy.Heaviside(X)), "x^2/(1 + (1 + sign(x))/2)"),
    (sympy.Piecewise((X**2, X > 0), (0, True)), "x*(x + abs(x))/2"),
    (3 * sympy.Piecewise((X**2, X > 0), (-(X**2), X <= 0)), "3*x*abs(x)"),
    (sympy.Piecewise((X**2, X < 0), (-2 * X**3, X >= 0)), "x*(x - abs(x))/2 - x^2*(x + abs(x))"),
    (sympy.log(1 + X**3), "ln(1 + x^3)"),
    (sympy.E * X**3, "exp(1)*x^3"),
    (sympy.pi * X**3, "pi*x^3"),
    (sympy.Float("0.1") * X**3, "0.1*x^3"),
    (sympy.Float(1) / 3 * X**3, "0.3333333333333333*x^3"),
    (X**3 * sympy.sec(X) * sympy.cot(X + 1), "x^3/cos(x)/tan(x + 1)"),
])
def test_functions_of_sympy_are_read(force, same):
    found = lb.expand(X.diff(T, 2) + X + force, 3)
    assert found.frequency == lb.expand(f"x'' + x + {same} = 0", 3).frequency


@pytest.mark.parametrize("force, message", [
    (sympy.GoldenRatio * X**3, "GoldenRatio of SymPy has no formula here: give its digits"),
    (sympy.I * X**3, "I of SymPy has no formula here"),
    (sympy.Piecewise((X**2, sympy.Ne(X, 0)), (0, True)), "give conditions such as x > 0"),
    (sympy.Piecewise((X**2, X > 0)), "its pieces do not cover all values"),
    (sympy.Heaviside(X, 1) * X**2, "give it the value 1/2 at zero"),
    (sympy.erf(X), "is not a known function"),
])
def test_what_has_no_formula_is_refused_with_one_sentence(force, message):
    with pytest.raises(errors.LibrationError, match=message):
        lb.expand(X.diff(T, 2) + X + force, 3)


def test_simulations_take_equations_of_sympy():
    found = lb.simulate(sympy.Eq(X.diff(T, 2) + X + sympy.Max(X, 0) ** 2, 0), {"x": 1}, [1.0])
    assert found["x"] == lb.simulate("x'' + x + max(x, 0)^2 = 0", {"x": 1}, [1.0])["x"]


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
