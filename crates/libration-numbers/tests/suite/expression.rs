//! Formulas as text: accepted notations, rejected text with its hint, output, and derivatives.

use libration::algebra::Rational;
use libration::expression::{DEEPEST_TREE, Equation, Expression, Function, LONGEST_TEXT, Symbol};

use libration_testing::random::Random;

fn formula(text: &str) -> Expression {
    text.parse().unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Accepted input, and its output with all brackets.
const UNDERSTOOD: &[(&str, &str)] = &[
    // Mathematical precedence.
    ("-x^2", "-(x^2)"),
    ("2^3^2", "2^(3^2)"),
    ("2^-3", "2^(-3)"),
    ("2^-3^2", "2^(-(3^2))"),
    ("-2^2", "-(2^2)"),
    ("a/b*c", "(a/b)*c"),
    ("a-b-c", "(a-b)-c"),
    ("a-b+c", "(a-b)+c"),
    ("a/b/c", "(a/b)/c"),
    ("-a*b", "-(a*b)"),
    ("2*-a*b", "(2*(-a))*b"),
    ("a - -b", "a-(-b)"),
    ("+a", "a"),
    ("a^b*c", "(a^b)*c"),
    // Numbers, exactly.
    ("0.1", "1e-1"),
    ("1.50E+2", "150"),
    (".5", "0.5"),
    ("2.", "2"),
    ("1e-3x", "0.001*x"),
    ("2e", "2*e"),
    // Products without a sign.
    ("2x", "2*x"),
    ("2 x", "2*x"),
    ("2(x+1)", "2*(x+1)"),
    ("(1+x)(1-x)", "(1+x)*(1-x)"),
    ("2 sin(x)", "2*sin(x)"),
    ("x x'^2", "x*(x'^2)"),
    ("(1+x^2) x''", "(1+(x^2))*x''"),
    ("omega0^2 sin(theta)", "(omega0^2)*sin(theta)"),
    ("x^2(1-x)", "(x^2)*(1-x)"),
    ("2x^2", "2*(x^2)"),
    ("2x/3", "(2*x)/3"),
    ("2pi(1+x)", "(2*pi)*(1+x)"),
    ("2 a b", "(2*a)*b"),
    // Notations of keyboards.
    ("x**2", "x^2"),
    ("x·y×z", "(x*y)*z"),
    ("x − 1", "x-1"),
    ("x²", "x^2"),
    ("x⁻²y", "(x^(-2))*y"),
    ("x¹⁰", "x^10"),
    ("2πx", "(2*pi)*x"),
    ("θ", "theta"),
    ("ω0 t", "omega0*t"),
    ("ω₀t", "omega0*t"),
    ("µ", "mu"),
    ("ε+ϵ", "epsilon+epsilon"),
    ("ω_d", "omega_d"),
    ("x₁", "x1"),
    ("θ̇ + θ̈", "theta' + theta''"),
    ("ẋ + ẍ", "x' + x''"),
    ("x′ + x″ + x''", "(x' + x'')+x''"),
    ("x\"", "x''"),
    ("arcsin(x)+arctan(y)", "asin(x)+atan(y)"),
    ("x'' + sgn(x')", "x'' + sign(x')"),
    ("√(2)", "sqrt(2)"),
    ("sin (x)", "sin(x)"),
    // LaTeX.
    (r"\ddot{x} + \dot x", "x'' + x'"),
    (r"\ddot{\theta} + \frac{g}{l}\sin\theta", "theta'' + g/l*sin(theta)"),
    (r"\ddot\theta_1 + \omega_{0}^{2} \theta_1", "theta_1'' + omega_0^2*theta_1"),
    (r"\ddot{x}_{1} + \ddot{x_1}", "x_1'' + x_1''"),
    (r"\frac{1}{2} x \cdot \left(1 + x^{2}\right)", "(1/2)*x*(1 + x^2)"),
    (r"\sqrt{1 + x^2} \, \varepsilon \times \mathrm{mass}", "sqrt(1 + x^2)*epsilon*mass"),
    (r"\frac{d^2 x}{dt^2} + \dfrac{\mathrm{d}\theta}{\mathrm{d}t}", "x'' + theta'"),
    (r"\frac{d^2}{b}", "d^2/b"),
    ("a^{2}{x}", "(a^2)*x"),
    // Leibniz's notation.
    ("d2x/dt2 + dx/dt", "x'' + x'"),
    ("d^2x/dt^2 + d^2 θ / dt^2", "x'' + theta''"),
    ("d²x/dt² + d²θ₁/dt²", "x'' + theta1''"),
    ("d^{2}x/dt^{2} + d3y/dt3", "x'' + y'''"),
    ("2 dx_a/dt", "2*x_a'"),
    // Text that only resembles a derivative.
    ("d2x/d2t + d2x/dt", "d2x/d2t + d2x/dt"),
    ("dx/dt2 + dx/dtau + dx", "dx/dt2 + dx/dtau + dx"),
    ("d/dt", "d/dt"),
    // Functions without brackets, before text that cannot belong to the argument.
    ("sin x", "sin(x)"),
    ("2 + sin 2x", "2 + sin(2*x)"),
    ("sin ωt - 1", "sin(omega*t) - 1"),
    ("sin 2ωt", "sin(2*omega*t)"),
    ("a sin θ cos θ", "a*sin(theta)*cos(theta)"),
    ("sin x*cos x + (cos 2 x)^2", "sin(x)*cos(x) + cos(2*x)^2"),
    ("sin x'", "sin(x')"),
    (r"\sin \frac{x}{2}", "sin(x/2)"),
    // Variables, which have primes somewhere in the text, before brackets.
    ("x''(t) + x'(t) + 2x(t)", "x'' + x' + 2*x"),
    ("x'' + x(1+x^2)", "x'' + x*(1 + x^2)"),
    ("x'' + (1 - x^2)x'(1 + x)", "x'' + (1 - x^2)*x'*(1 + x)"),
    ("x'' + sin x(t)", "x'' + sin(x)"),
    ("x'' + x(x) + x(k1 + k2)", "x'' + x*x + x*(k1 + k2)"),
    // Typographic marks.
    ("x‘’ + x´ + 1⁄2", "x'' + x' + 1/2"),
    ("xy", "xy"),
];

#[test]
fn what_physicists_type_is_understood() {
    for (text, meaning) in UNDERSTOOD {
        assert_eq!(formula(text), formula(meaning), "{text}");
    }
}

#[test]
fn trees_are_those_of_the_precedence_of_mathematics() {
    let symbol = |name: &str| Box::new(Expression::symbol(name));
    let number = |n: i64| Box::new(Expression::Number(Rational::from(n)));
    let square = Expression::Power(symbol("x"), number(2));
    assert_eq!(formula("-x^2"), Expression::Negate(Box::new(square.clone())));
    let product = Expression::Multiply(number(2), Box::new(square));
    assert_eq!(formula("2x^2"), product);
    assert_eq!(
        formula("a-sin(2)"),
        Expression::Subtract(symbol("a"), Box::new(Expression::Call(Function::Sin, number(2))))
    );
    assert_eq!(formula("0.1"), Expression::Number(Rational::new(1, 10).unwrap()));
    assert_eq!(formula("x''"), Expression::Symbol(Symbol { name: "x".to_owned(), primes: 2 }));
}

/// Rejected input, the character of the error, and a part of the message.
const REFUSED: &[(&str, usize, &str)] = &[
    ("", 1, "the formula is empty"),
    ("  ", 3, "the formula is empty"),
    ("sin x^2", 1, "`sin x^2` may be sin(x^2) or sin(x)^2"),
    ("sin x²", 1, "may be sin(x²) or sin(x)²"),
    ("2 + sin x y", 5, "may be sin(x y) or sin(x) y"),
    ("cos 2x/3", 1, "may be cos(2x/3) or cos(2x)/3"),
    ("sin x*y", 1, "may be sin(x*y) or sin(x)*y"),
    ("sin -x", 1, "write sin(x)"),
    ("sin", 1, "write sin(x)"),
    ("sin cos x", 1, "write sin(x)"),
    ("sin^2(x)", 1, "sin(x)^2"),
    ("√2", 1, "write sqrt(x)"),
    ("1/2x", 4, "(1/2)*x or 1/(2*x)"),
    ("1/2 x", 5, "(1/2)*x or 1/(2*x)"),
    ("a/b(c)", 3, "`b(` is not a known function"),
    ("1/2(x+1)", 4, "ambiguous"),
    ("2^3x", 4, "2^3*x or 2^(3*x)"),
    ("2^-3x", 5, "2^3*x"),
    ("x²^3", 3, "(x^2)^3"),
    ("x(1-x)", 1, "write x*( for a product"),
    ("x (1-x)", 1, "not a known function"),
    ("x(t)", 1, "write x instead of x(t)"),
    ("k(t) + x''", 1, "write k instead of k(t)"),
    ("x'' + f(x)", 7, "`f(` is not a known function"),
    ("x'' + x(t-1)", 7, "x at another time"),
    ("x'(2(t-1))", 1, "x' at another time"),
    ("x'' + x(0)", 7, "x at another time"),
    ("x'' + x(T)", 7, "x at another time"),
    ("x'' + 2^x(1+x)", 9, "2^3*x or 2^(3*x)"),
    ("x'' + 1/x(1+x)", 10, "(1/2)*x or 1/(2*x)"),
    (r"\frac12", 1, r"write \frac{a}{b}"),
    (r"\frac{a}", 1, r"write \frac{a}{b}"),
    (r"\frac{a}{b", 9, "this brace is not closed"),
    (r"\ddot{2}", 1, r"write \ddot{x}"),
    (r"\ddot{x", 1, r"write \ddot{x}"),
    (r"\dddot{x}'", 1, "at most x'''"),
    (r"2 + \foo x", 5, r"the command \foo of LaTeX is not known"),
    (r"\", 1, "of LaTeX is not known"),
    (r"\mathrm x", 1, r"write \mathrm{max}"),
    ("x^{2", 3, "brace is not closed"),
    ("d3x/dt2 y", 9, "(1/2)*x or 1/(2*x)"),
    ("e^x", 1, "write exp(x)"),
    ("2 3", 3, "write a*2"),
    ("x 2", 3, "write a*2"),
    ("x''''", 1, "at most x'''"),
    ("x^", 3, "expected a number, a name or (, found the end"),
    ("*x", 1, "found `*`"),
    ("(x", 1, "not closed"),
    ("x)", 2, "`)` cannot follow"),
    ("()", 2, "found `)`"),
    ("1,5", 2, "with a point"),
    ("[x]", 1, "write brackets as ( and )"),
    ("|x|", 1, "abs(x)"),
    ("x = 1", 3, "not an equation"),
    ("жx", 1, "Latin or Greek"),
    ("x + θ̇̇̇̇", 5, "at most x'''"),
    ("(1+x)'", 6, "directly follow a name"),
    (".", 1, "write numbers as 0.5"),
    ("1.2.3", 4, "write a*2"),
    ("1e1001", 1, "too long"),
    ("1e999999999", 1, "too long"),
    ("1e99999999999999999999", 1, "too long"),
    ("\u{0}", 1, "`\\0` is not understood"),
];

#[test]
fn what_is_wrong_or_ambiguous_is_refused_at_its_place_with_a_hint() {
    for (text, column, part) in REFUSED {
        let error = text.parse::<Expression>().unwrap_err();
        assert!(error.to_string().contains(part), "{text}\n{error}");
        assert_eq!(error.column, *column, "{text}\n{error}");
        assert_eq!(text[..error.byte].chars().count() + 1, error.column, "{text}");
    }
}

#[test]
fn the_caret_stands_below_the_place() {
    let error = "θ̈ + ω² √θ".parse::<Expression>().unwrap_err();
    let expected = "at character 9: the argument of sqrt must be in brackets: write sqrt(x), or sqrt(x)^2 \
                    for its square\n  θ̈ + ω² √θ\n         ^";
    assert_eq!(error.to_string(), expected);
    let long = format!("{}1 @ 2{}", "1+".repeat(200), "+1".repeat(200));
    let error = long.parse::<Expression>().unwrap_err().to_string();
    let lines: Vec<&str> = error.lines().collect();
    let caret = lines[2].chars().position(|c| c == '^').unwrap();
    assert_eq!(lines[1].chars().nth(caret), Some('@'), "{error}");
    assert!(lines[1].chars().count() < 70, "{error}");
}

#[test]
fn hostile_texts_are_refused_quickly() {
    let many = |part: &str, times: usize| part.repeat(times);
    let hostile = [
        many("(", 1_000_000),
        many("(", LONGEST_TEXT),
        many("-", LONGEST_TEXT - 1) + "x",
        many("x^", LONGEST_TEXT / 2 - 1) + "x",
        many("sin(", 2000) + "x" + &many(")", 2000),
        many("1+", LONGEST_TEXT / 2 - 1) + "1",
        many("x ", LONGEST_TEXT / 2),
        many("9", 2_000),
        many("x", 2_000_000),
        many("x'", LONGEST_TEXT / 2),
        many("√", 3_000),
        many("2^(", 3_000),
        many("{", LONGEST_TEXT),
        many(r"\frac{", LONGEST_TEXT / 7),
        many(r"\frac{1}{", LONGEST_TEXT / 9),
        many(r"\ddot{", LONGEST_TEXT / 6),
        many(r"\", LONGEST_TEXT),
        many("sin ", LONGEST_TEXT / 4),
        many("sin 2x cos ", LONGEST_TEXT / 12) + "^",
        many("x'(", LONGEST_TEXT / 3),
        many("d2", LONGEST_TEXT / 2 - 1) + "/",
        "sin ".to_owned() + &many("ω", LONGEST_TEXT / 4) + "^2",
    ];
    for text in hostile {
        let error = text.parse::<Expression>().unwrap_err().to_string();
        assert!(error.len() < 500, "{error}");
    }
}

#[test]
fn powers_too_large_to_write_stay_powers() {
    for text in ["2^10^10^10", "10^1e300", "(1/3)^-1e999", "((2^9999)^9999)^9999", "0^-1", "0/0", "1/0"] {
        let tree = formula(text);
        assert_eq!(tree.to_rational(), None, "{text}");
        assert_eq!(formula(&tree.to_string()), tree);
    }
    assert_eq!(formula("(-1)^2000000 + 1^1e300").to_rational(), Some(Rational::from(2)));
    // Products of 2.8 million times 2.8 thousand bits would take hours.
    assert_eq!(formula("((7^1000)^1000)^1000").to_f64(), Some(f64::INFINITY));
    assert_eq!(formula("((7^1000)^1000)^-1000").to_f64(), Some(0.0));
}

#[test]
fn the_deepest_trees_fit_the_stack_of_a_thread() {
    let sum = format!("x{}", "*sin(x)/x".repeat(DEEPEST_TREE / 2 - 1));
    let power = format!("x{}", "^x".repeat(99));
    let calls = format!("{}x{}", "sin(x*".repeat(99), ")".repeat(99));
    let body = move || {
        let x = Symbol::plain("x");
        for text in [&sum, &power, &calls] {
            let tree = formula(text);
            assert_eq!(formula(&tree.to_string()), tree);
            let slope = tree.derivative(&x);
            assert!(slope.clone() == slope && !slope.to_latex().is_empty() && slope.contains(&x));
            assert!(slope.substitute(&x, &formula("1/(1 + x)")).simplified().contains(&x));
            assert!(tree.polynomial_degree(std::slice::from_ref(&x)).is_none());
        }
    };
    std::thread::Builder::new().stack_size(1 << 21).spawn(body).unwrap().join().unwrap();
}

/// A random tree that could come from text.
fn random_tree(random: &mut Random, levels: u32) -> Expression {
    if levels == 0 || random.below(8) == 0 {
        return random_leaf(random);
    }
    let mut part = || Box::new(random_tree(random, levels - 1));
    let (a, b) = (part(), part());
    let function = Function::ALL[usize::try_from(random.below(13)).unwrap()];
    match random.below(7) {
        0 => Expression::Negate(a),
        1 => Expression::Add(a, b),
        2 => Expression::Subtract(a, b),
        3 => Expression::Multiply(a, b),
        4 => Expression::Divide(a, b),
        5 => Expression::Power(a, b),
        _ => Expression::Call(function, a),
    }
}

fn random_leaf(random: &mut Random) -> Expression {
    let names = ["x", "x'", "x''", "theta", "omega0", "mu", "t", "k_1"];
    match random.below(3) {
        0 => formula(names[usize::try_from(random.below(8)).unwrap()]),
        1 => Expression::Pi,
        _ => {
            let exponent = i64::try_from(random.below(50)).unwrap() - 25;
            formula(&format!("{}e{exponent}", random.below(100_000)))
        }
    }
}

#[test]
fn what_is_written_is_read_back_as_the_same_tree() {
    let mut random = Random::seeded(7);
    for _ in 0..20_000 {
        let tree = random_tree(&mut random, 5);
        let text = tree.to_string();
        assert_eq!(formula(&text), tree, "{text}");
    }
}

#[test]
fn brackets_are_written_only_where_they_matter() {
    for text in
        ["-x^2 + 3*x/(1 + x^2) - (a - b)", "2^3^2", "(2^3)^2", "-x*y", "2*(-x)", "x^(-1)", "sin(-x)^2"]
    {
        assert_eq!(formula(text).to_string(), text);
    }
    let third = Expression::Number(Rational::new(-1, 3).unwrap());
    let x = Box::new(Expression::symbol("x"));
    assert_eq!(Expression::Power(x.clone(), Box::new(third.clone())).to_string(), "x^(-1/3)");
    assert_eq!(Expression::Subtract(x, Box::new(third)).to_string(), "x - (-1/3)");
}

#[test]
fn latex_is_that_of_a_textbook() {
    for (text, latex) in [
        ("theta'' + omega0^2*sin(theta)", r"\ddot{\theta} + \omega_{0}^{2} \sin\left(\theta\right)"),
        ("sqrt(1+x^2)/2", r"\frac{\sqrt{1 + x^{2}}}{2}"),
        ("2*3*(x-1)", r"2 \cdot 3 \left(x - 1\right)"),
        ("-exp(-x)^2", r"-\left(\mathrm{e}^{-x}\right)^{2}"),
        ("abs(mass)", r"\left|\mathrm{mass}\right|"),
        ("sign(x)", r"\operatorname{sgn}\left(x\right)"),
        ("1e-30*pi", r"10^{-30} \pi"),
        ("(a/b)^2", r"\left(\frac{a}{b}\right)^{2}"),
    ] {
        assert_eq!(formula(text).to_latex(), latex);
    }
}

#[test]
fn constants_are_worked_out_exactly() {
    for (text, value) in [
        ("1/3 + 1/6", "1/2"),
        ("(2/3)^-2", "9/4"),
        ("sqrt(4/9)*8^(2/3)", "8/3"),
        ("cos(0) + exp(0) - ln(1) + sin(x-x)", "2"),
        ("abs(-0.5)", "1/2"),
        ("sign(-0.5) + sign(0)", "-1"),
        ("0*x + 7", "7"),
    ] {
        assert_eq!(formula(text).to_rational(), Some(value.parse().unwrap()), "{text}");
    }
    for text in ["sqrt(2)", "pi", "x", "sin(1)", "sqrt(-4)", "ln(0)"] {
        assert_eq!(formula(text).to_rational(), None, "{text}");
    }
}

#[test]
fn simplified_formulas_are_short() {
    for (text, short) in [
        ("0 + 1*x - 0", "x"),
        ("-(-x)", "x"),
        ("2*(3*x)", "6*x"),
        ("x - (-y)", "x + y"),
        ("x + -2", "x - 2"),
        ("(-x)/(-y)", "x/y"),
        ("x^1*y^0", "x"),
        ("0 - x", "-x"),
        ("c*(abs(v)^3*sign(v))", "c*v^3"),
        ("abs(v)^2*sign(v) + abs(v)*sign(v)", "v*abs(v) + v"),
        ("abs(v)^0*sign(v) + abs(v)^0.5*sign(v)", "sign(v) + abs(v)^0.5*sign(v)"),
        ("abs(v)^2*sign(w)", "abs(v)^2*sign(w)"),
    ] {
        assert_eq!(formula(text).simplified().to_string(), short, "{text}");
    }
}

/// A function, its inverse, and a point at which both have rational derivatives.
const INVERSES: &[(&str, &str, &str)] = &[
    ("ln(u)", "exp(x)", "0"),
    ("exp(u)", "ln(x)", "1"),
    ("u^2", "sqrt(x)", "4"),
    ("u^(3/2)", "x^(2/3)", "8"),
    ("sin(u)", "asin(x)", "0"),
    ("tan(u)", "atan(x)", "0"),
    ("1/u - 1", "1/(1 + x)", "2/7"),
];

#[test]
fn derivatives_of_inverse_functions_multiply_to_one() {
    let (u, x) = (Symbol::plain("u"), Symbol::plain("x"));
    for (outer, inner, position) in INVERSES {
        let (outer, inner) = (formula(outer), formula(inner));
        let product = Expression::Multiply(
            Box::new(outer.derivative(&u).substitute(&u, &inner)),
            Box::new(inner.derivative(&x)),
        );
        let value = product.substitute(&x, &formula(position));
        assert_eq!(value.to_rational(), Some(Rational::from(1)), "{outer}: {value}");
    }
}

#[test]
fn log_is_the_natural_logarithm_and_the_reading_says_so() {
    for (text, expected) in [("log(x)", "ln(x)"), (r"\log x", "ln(x)"), ("2*log(1 + x)^2", "2*ln(1 + x)^2")] {
        assert_eq!(formula(text), formula(expected), "{text}");
    }
    assert_eq!(Equation::read_as("x'' + log(1 + x) = 0").as_deref(), Some("x'' + ln(1 + x) = 0"));
    assert_eq!(Equation::read_as("x'' + ln(1 + x) = 0"), None);
}
