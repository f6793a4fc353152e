use libration::expression::{Expression, Symbol};
use libration::internals::expression::Tape;

#[test]
fn what_is_too_large_is_told_from_what_has_no_value() {
    let overflows = |text: &str, x: f64| {
        let formula: Expression = text.parse().unwrap();
        Tape::new(&[&formula], &[Symbol::plain("x")]).unwrap().overflows_at(&[x])
    };
    for (text, x) in
        [("cosh(1000*x)", 1.0), ("x/cosh(1000*x)", 1.0), ("x^3", 1e103), ("exp(x)-exp(x)", 710.0)]
    {
        assert!(overflows(text, x), "{text}");
    }
    for (text, x) in [
        ("cosh(700*x)", 1.0),
        ("1/x", 0.0),
        ("ln(x)", -1.0),
        ("x^(3/2)", 0.0),
        ("cosh(1000*x)/(x - 1)", 1.0),
        ("x", f64::INFINITY),
    ] {
        assert!(!overflows(text, x), "{text}");
    }
}
