"""Equations of SymPy: what they mean here, and that nothing in them is left out in silence."""

import re

import numpy as np
import pytest
import sympy
from sympy import Derivative, Eq, Function, Symbol

import libration as lb
from libration import errors, questions
from libration._equations import constant_of_sympy, text_of_sympy
from libration._names import name_in_formulas

T, S, TAU, K = sympy.symbols("t s tau k")
x, y, f = Function("x"), Function("y"), Function("f")
X = x(T)
OSCILLATOR = X.diff(T, 2) + X
# Every query that takes an equation of motion, with what it needs besides.
QUERIES = {
    "backbone": {"amplitudes": [0.1]},
    "bifurcation": {"over": "A=0:1:1"},
    "derive": {"method": "perturbation"},
    "expand": {},
    "figure_series": {},
    "figure_trajectories": {},
    "lyapunov": {},
    "melnikov": {"over": "A=0:1"},
    "modes": {},
    "orbit": {},
    "resonance": {},
    "response": {"over": "A=0:1"},
    "section": {},
    "simulate": {"times": [1]},
    "stability": {"map": "a=0:1,b=0:1"},
}
ENTRIES = {
    "expand": lb.expand,
    "simulate": lambda it: lb.simulate(it, {"x": 1}, [1.0]),
    **{
        f"questions.{name}": lambda it, name=name, given=given: getattr(questions, name)(
            it, **given
        )
        for name, given in QUERIES.items()
    },
}


def test_every_query_with_an_equation_is_here():
    found = {
        words.replace(" ", "_")
        for words, question in lb._ask.catalogue().items()
        if any(it.value_type == "equation" for it in question.parameters)
    }
    assert found == QUERIES.keys()


@pytest.mark.parametrize("entry", ENTRIES)
def test_delays_are_refused_by_every_entry(entry):
    with pytest.raises(errors.UsageError, match=re.escape("x(t - 1) of SymPy has no formula")):
        ENTRIES[entry](OSCILLATOR + x(T - 1))


REFUSED = [
    (x(T - TAU), "x(t - tau) of SymPy has no formula here: it is x at another time than x(t)"),
    (x(2 * T) ** 3, "x(2*t) of SymPy has no formula here: it is x at another time"),
    (x(0) * X**3, "x(0) of SymPy has no formula here: it is a value at one time: give a symbol"),
    (f(X), "f(x(t)) of SymPy has no formula here: write the function f out, as in sin(x(t))"),
    (f(T), "f(t) of SymPy has no formula here: it has no derivative in the equation"),
    (y(T, S), "y(t, s) of SymPy has no formula here: give a function of the time alone"),
    (y(S).diff(S), "x(t) depends on another symbol: give one time for both"),
    (Derivative(X, S), "Derivative(x(t), s) of SymPy has no formula here: give derivatives by t"),
    (Derivative(X**2, T), "write it with derivatives of functions alone, as .doit() does"),
    (
        Derivative(X, (T, Symbol("n", integer=True))),
        "give the order of the derivative as a number",
    ),
    (Symbol("t", real=True) * X**3, "two symbols are called t"),
    (Symbol("x") * X**3, "a function and a symbol are called x"),
    (Function("x", real=True)(T), "two functions are called x"),
    (Symbol("omega") * X**3 + Symbol("ω"), "two symbols are called omega"),
    (sympy.Integral(X, T), "Integral(x, t) of SymPy has no formula here: write it with sums"),
    (sympy.Mod(X, 2), "Mod(x, 2) of SymPy has no formula here: Mod is not a known function"),
    (Symbol("dx") / Symbol("dt"), "a symbol dt below a fraction is read as a derivative"),
    (sympy.Matrix([[1]]), "give an equation, such as Eq(x(t).diff(t, 2) + x(t), 0)"),
    (sympy.IndexedBase("k")[1] * X + Symbol("k1"), "two symbols are called k1"),
]


@pytest.mark.parametrize("term, message", REFUSED, ids=[str(term) for term, _ in REFUSED])
def test_what_would_be_left_out_is_refused(term, message):
    equation = term if getattr(term, "is_Matrix", False) else OSCILLATOR + term
    for entry in (ENTRIES["expand"], ENTRIES["simulate"], ENTRIES["questions.expand"]):
        with pytest.raises(errors.UsageError, match=re.escape(message)):
            entry(equation)


def test_the_time_has_any_name():
    turned = x(TAU).diff(TAU, 2) + x(TAU)
    assert text_of_sympy(Eq(turned, sympy.cos(K * TAU))) == "x + x'' = cos(k*t)"
    by_tau = lb.simulate(turned - TAU, {"x": 1}, [2.0])
    assert np.array_equal(by_tau.y, lb.simulate("x'' + x - t = 0", {"x": 1}, [2.0]).y)
    with pytest.raises(errors.ExpansionError, match="depends on t"):
        lb.expand(turned + TAU * x(TAU) ** 3)
    drive = sympy.cos(Symbol("W") * TAU)
    small = {"resonance": "1/1", "small": "k:1,F:1"}
    forced = Eq(turned + K * x(TAU) ** 3, Symbol("F") * drive)
    text = "k*x^3 + x + x'' = F*cos(W*t)"
    assert questions.resonance(forced, **small) == questions.resonance(text, **small)
    # A letter t beside it would be taken for the time.
    with pytest.raises(errors.UsageError, match="t is not the time of this equation, which is tau"):
        lb.expand(turned + T * x(TAU) ** 3)
    with pytest.raises(errors.UsageError, match="two symbols are called tau"):
        lb.expand(turned + Symbol("tau", real=True) * x(TAU) ** 3)


def test_texts_with_primes_are_read_without_functions():
    plain = Symbol("x''") + Symbol("x") + Symbol("x") ** 3
    assert lb.expand(plain, 3).frequency == lb.expand("x'' + x + x^3 = 0", 3).frequency
    assert text_of_sympy(X - 1) == "x - 1 = 0"
    with pytest.raises(errors.UsageError, match="is read as a derivative"):
        lb.expand(OSCILLATOR + Symbol("x'") * X**2)


NAMES = {
    "omega_0": "omega_0",
    "lamda": "lamda",
    "k_": "k_",
    "e": "e",
    "E": "E",
    "I": "I",
    "S": "S",
    "max": "max",
    "dt": "dt",
    "ω": "omega",
    "ω₀": "omega0",
    "ω_0a": "omega_0a",
    "µ": "mu",
    "ϑ": "theta",
    "Ω": "Omega",
    "k₁": "k1",
    "k_{1}": "k_1",
    "k[1]": "k1",
    r"\omega_0": "omega_0",
    r"\varphi": "phi",
}


@pytest.mark.parametrize("name", NAMES)
def test_symbols_come_back_as_they_were(name):
    symbol = Symbol(name)
    found = lb.expand(OSCILLATOR + symbol * X**3, 3).frequency
    assert found[2].letters == (NAMES[name],)
    assert found.to_sympy() == 1 + 3 * symbol * Symbol("A") ** 2 / 8


def test_greek_letters_are_those_of_the_parser():
    for code in range(0x370, 0x400):
        letter = chr(code)
        try:
            own = name_in_formulas(letter, letter)
        except errors.UsageError:
            own = None
        try:
            read = lb.expand(f"x'' + x + {letter}*x^3 = 0", 3).frequency[2]
            letters = read.letters if isinstance(read, lb.Polynomial) else ()
        except errors.ExpansionError:
            letters = ()
        assert letters == (() if own is None else (own,)), letter


@pytest.mark.parametrize("name, message", [
    ("pi", "`pi` of SymPy is a number in formulas: give it another name, such as pi_1"),
    ("π", "`π` of SymPy is a number in formulas: give it another name, such as pi_1"),
    ("log", "`log` of SymPy is a function in formulas: give it another name, such as log_1"),
    ("k+1", "`k+1` of SymPy is not one name in formulas, .*: give it another name, such as k_1"),
    ("a b", "`a b` of SymPy is not one name in formulas, .*: give it another name, such as a_b"),
    ("ω0t", "`ω0t` of SymPy is not one name in formulas, .*, such as omega0t"),
    ("_k", "`_k` of SymPy is not one name in formulas, .*: give it another name, such as k"),
    ("é", "`é` of SymPy is not one name in formulas"),
    ("k²", "`k²` of SymPy is not one name in formulas"),
    ("k'", "`k'` of SymPy is read as a derivative, .*: give it another name, such as k_1"),
])  # fmt: skip
def test_names_that_formulas_read_otherwise_are_refused(name, message):
    message = message.replace("k+1", r"k\+1")
    for entry in (ENTRIES["expand"], ENTRIES["simulate"], ENTRIES["questions.modes"]):
        with pytest.raises(errors.UsageError, match=message):
            entry(OSCILLATOR + 2 * Symbol(name) * X**3)
    own = Function(name)(T)
    with pytest.raises(errors.UsageError, match="of SymPy is"):
        lb.expand(own.diff(T, 2) + own)


def test_values_and_their_names_may_be_of_sympy():
    found = lb.simulate(
        X.diff(T, 2) + Symbol("ω") * X,
        {X: sympy.Float(1) / 3, X.diff(T): sympy.E},
        [1.0],
        set={Symbol("ω"): sympy.Rational(1, 3)},
    )
    by_text = lb.simulate(
        "x'' + w*x = 0", {"x": repr(1 / 3), "x'": "exp(1)"}, [1.0], set={"w": "1/3"}
    )
    assert np.array_equal(found.y, by_text.y)
    with pytest.raises(errors.UsageError, match="such as k_1"):
        lb.expand("x'' + x + a*x^3 = 0", set={"a": Symbol("k+1")})


def test_a_system_is_a_list_with_an_equation_for_each_function():
    w, a = sympy.symbols("w a", positive=True)
    other = Function("y")(T)
    system = [
        sympy.Eq(X.diff(T, 2) + w**2 * X + a * X * other, 0),
        other.diff(T, 2) + 4 * w**2 * other + a * X**2,
    ]
    text = "x'' + w^2*x + a*x*y = 0; y'' + 4*w^2*y + a*x^2 = 0"
    values, start = {"w": 1, "a": "1/5"}, {"x": 1, "y": 0.5}
    found = lb.simulate(system, start, [1.0, 2.0], set=values)
    assert np.array_equal(found.y, lb.simulate(text, start, [1.0, 2.0], set=values).y)
    flow = questions.resonance(tuple(system), small="a:1")
    by_text = questions.resonance(text, small="a:1")
    assert flow["coordinates"] == by_text["coordinates"]
    with pytest.raises(errors.UsageError, match="or a list with an equation for each function"):
        lb.simulate(system[:1], start, [1.0], set=values)
    negative = Symbol("k", negative=True)
    with pytest.raises(errors.UsageError, match="k"):
        questions.resonance([X.diff(T, 2) + negative * X, other.diff(T, 2) + other + X])


def test_constants_keep_letters_that_sympy_reads_otherwise():
    for name in ("E", "S", "I", "N", "lambda", "beta"):
        found = lb.expand(f"x'' + x + sin({name})*x^3 = 0", 3).frequency.to_sympy()
        assert found == 1 + 3 * sympy.sin(Symbol(name)) * Symbol("A") ** 2 / 8
    assert constant_of_sympy("1e-3*sqrt(2)", {}) == sympy.Float("1e-3") * sympy.sqrt(2)


W, N = Symbol("w", negative=True), Symbol("n", negative=True)


@pytest.mark.parametrize("force", [
    W**2 * X + X**3,
    W * N * X + X**3,
    X + sympy.sqrt(-W) * X**3,
    X + sympy.sqrt(W**2 + W**2 * X) * X**2,
    sympy.sin(W) ** 2 * X + X**3,
    Symbol("w", nonpositive=True) ** 2 * X + X**3,
    X + Symbol("w", imaginary=True) * X**3,
])  # fmt: skip
def test_symbols_that_are_not_positive_are_refused_where_roots_are_taken(force):
    with pytest.raises(errors.UsageError, match="the symbol [wn] is declared .*, and letters in"):
        lb.expand(X.diff(T, 2) + force, 5)


@pytest.mark.parametrize("force", [
    X + W * X**3,
    K * X + W * X**2 + W**3 * X**4,
    X + X**3 / W,
    (K + W) * X + X**3,
    X + sympy.exp(W) * X**3,
    X + X**2 * sympy.sin(W * X),
    X + W * X * X.diff(T) ** 2,
])  # fmt: skip
def test_results_that_hold_for_all_signs_are_given(force):
    # With the number in the equation instead no sign is assumed.
    found = lb.expand(X.diff(T, 2) + force, 5).frequency.to_sympy()
    values = {W: -sympy.Rational(1, 2), K: 3}
    values[Symbol("omega0", positive=True)] = sympy.sqrt(sympy.Rational(5, 2))
    exact = lb.expand(X.diff(T, 2) + force.subs(values), 5).frequency
    value = float(found.subs(values).subs(Symbol("A"), 0.3))
    assert value == pytest.approx(exact(0.3), rel=1e-14)


def test_a_negative_symbol_may_have_a_value():
    equation = X.diff(T, 2) + W**2 * X + X**3
    assert lb.expand(equation, 3, set={"w": -2}).omega0 == 2
    assert lb.expand(equation, 3, set={W: -2}).omega0 == 2
    for given in ({"w": -2}, {W: -2}, "w=-2", ["w=-2"]):
        assert questions.expand(equation, order=3, set=given).omega0_squared == "4"
    for ask in (questions.expand, questions.resonance):
        with pytest.raises(errors.UsageError, match="write -w with a positive symbol w"):
            ask(equation)
    with pytest.raises(errors.UsageError, match="write -w with a positive symbol w"):
        questions.derive(equation, method="perturbation")
    positive = Symbol("w", positive=True)
    assert lb.expand(equation.subs(W, -positive), 3).omega0.to_sympy() == positive
    assert lb.simulate(equation, {"x": 1}, [1.0], set={"w": -2}).success


def test_the_surface_of_a_section_may_be_of_sympy():
    theta = Symbol("theta")

    def points(at):
        return questions.section("pendulum", initial="theta=1", at=at, points=2).points

    for surface in (theta - sympy.Rational(1, 2), Eq(theta, sympy.Rational(1, 2))):
        assert points(surface) == points("theta - 1/2")


# Equations with damping c.
DAMPED = ["x'' + 2*c*x' + x + x^3 = 0", "x'' - c*(1 - x^2)*x' + x + x^2/3 = 0"]


@pytest.mark.parametrize("equation", DAMPED)
def test_slow_flows_in_sympy_solve_their_equations(equation):
    """The residual falls by 2^5 with the amplitude, without the second power of the damping."""
    flow = questions.expand(equation, order=4, damping_order=1)
    rates = [flow.slow_flow.to_sympy(name) for name in ("amplitude", "phase")]
    letters = [Symbol(flow.letters[name]) for name in ("amplitude", "phase")]
    c, (amplitude, phase) = Symbol("c"), letters
    moved = flow.to_sympy("displacement")

    def by_time(it):
        return sum(rate * it.diff(letter) for rate, letter in zip(rates, letters))

    names = {"x''": "acceleration", "x'": "velocity"}
    text = equation.split("=")[0]
    for name, word in names.items():
        text = text.replace(name, word)
    velocity = by_time(moved)
    of = {"x": moved, "velocity": velocity, "acceleration": by_time(velocity)}
    residual = constant_of_sympy(text, {}).subs(of)
    first = residual.subs(c, 0) + c * residual.diff(c).subs(c, 0)
    at = [first.subs({c: 0.1, phase: 0.7, amplitude: size}).evalf(30) for size in (0.02, 0.01)]
    assert 4.8 < sympy.log(abs(at[0] / at[1]), 2).evalf() < 5.2


def test_formulas_of_answers_are_formulas_of_sympy():
    """Capitals and words that SymPy reads otherwise are symbols; symbols keep their assumptions."""
    equation = "x'' + 2*eps*lambda*x' + E^2*x + eps*beta*x^3 = eps*F*cos(W*t)"
    answer = questions.expand(equation, resonance="1/1")
    E, A, eps, beta, sigma, phi, F = sympy.symbols("E A eps beta sigma phi F")
    phase = answer.slow_flow.to_sympy("phase")
    expected = eps * (3 * beta * A**2 / (8 * E) - sigma - F * sympy.cos(phi) / (2 * E * A))
    assert sympy.expand(phase - expected) == 0
    positive = Symbol("beta", positive=True)
    drive = answer.steady_state.to_sympy("critical_drive", [positive])
    assert positive in drive.free_symbols and not drive.has(sympy.Abs)
    assert len(answer.steady_state.to_sympy("equations")) == 2
    assert answer.steady_state.to_sympy("limit_cycle_amplitude") is None
    for name in ("equation", "schema", "letters"):
        with pytest.raises(TypeError, match=f"`{name}` is not a formula"):
            answer.to_sympy(name)
    with pytest.raises(KeyError, match="no field `amplitude`"):
        answer.to_sympy("amplitude")


def test_expansions_that_are_none_name_what_has_a_result():
    with pytest.raises(errors.ExpansionError, match="no stable limit cycle") as told:
        lb.expand("x'' + c*x' + x = 0")
    hint = "questions.expand with damping_order=2 gives the rate of the amplitude"
    assert told.value.hint == hint
    assert str(told.value).endswith(f"\nhint: {hint}")
    with pytest.raises(errors.ExpansionError) as told:
        lb.expand("x'' = x")
    assert told.value.hint is None and "hint" not in str(told.value)


def test_notes_name_arguments():
    with pytest.warns(UserWarning, match=r"this is the slow flow \(damping_order\)"):
        questions.expand("x'' + c*x'*abs(x') + x = 0", order=2)
