use libration::algebra::{BigFloat, Floats, Rational, Ring};
use libration::expression::{Expression, Function, Symbol};
use libration::internals::expression::{Jet, Tape, difference};

fn formula(text: &str) -> Expression {
    text.parse().unwrap()
}

#[test]
fn derivatives_have_their_closed_forms() {
    for (text, slope) in [
        ("x^3", "3*x^2"),
        ("sin(a*x)", "a*cos(a*x)"),
        ("x'*x''*a", "0"),
        ("a/(1 + x^2)", "-2*a*x/(1 + x^2)^2"),
        ("sqrt(1 + x^2)", "x/sqrt(1 + x^2)"),
        ("2^x", "2^x*ln(2)"),
        ("x^a", "a*x^(a - 1)"),
        ("abs(x)", "sign(x)"),
        ("x*sign(x)", "sign(x)"),
        ("tanh(-x)", "-1/cosh(x)^2"),
    ] {
        let computed = formula(text).derivative(&Symbol::plain("x"));
        assert!(difference(computed.clone(), formula(slope)).vanishes(), "{text}: {computed}");
    }
}

/// The value at a point, in 300 bits.
fn value(tree: &Expression, at: &BigFloat) -> BigFloat {
    let tape = Tape::new(&[tree], &[Symbol::plain("x")]).unwrap();
    Jet::new(&Floats { precision: 300 }, &tape, std::slice::from_ref(at)).unwrap().result(0)[0].clone()
}

#[test]
fn derivatives_agree_with_differences() {
    let floats = Floats { precision: 300 };
    let at = floats.rational(&Rational::new(3, 7).unwrap()).unwrap();
    let step = BigFloat::from_integer(1, 300) / BigFloat::from_integer(1 << 60, 300);
    let functions = Function::ALL.map(|function| format!("{}(x*x + x/3)", function.name()));
    let others = ["x^x", "(1 + x)^(x - 2)/x", "exp(-x)^2 - x/(2 - sin(x))", "-x^(2/3)*abs(x - 1)"];
    for text in functions.iter().map(String::as_str).chain(others) {
        let tree = formula(text);
        let slope = value(&tree.derivative(&Symbol::plain("x")), &at);
        let rise = value(&tree, &(at.clone() + step.clone())) - value(&tree, &(at.clone() - step.clone()));
        // The error of the central difference is the third derivative times 2⁻¹²⁰/6.
        let error = (rise.halved() / step.clone() - slope).exponent();
        assert!(error.is_none_or(|exponent| exponent < -100), "{text}: 2^{error:?}");
    }
}
