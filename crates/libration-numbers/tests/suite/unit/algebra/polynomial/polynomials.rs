use libration::algebra::{Polynomial, Polynomials, Rational, Ring};
use libration::expression::Function;

#[test]
fn what_is_no_polynomial_is_refused() {
    let x = Polynomial::variable("x");
    let half = Rational::new(1, 2).unwrap();
    assert_eq!(Polynomials.value(Function::Sin, &x), None);
    assert_eq!(Polynomials.power(&x, &half), None);
    assert_eq!(Polynomials.over_integer(&x, 0), None);
    assert_eq!(Polynomials.divide(&x, &x.pow(2)), None);
}

#[test]
fn functions_of_numbers_have_their_values() {
    let constant = |n: i64| Polynomial::constant(Rational::from(n));
    assert_eq!(Polynomials.value(Function::Cosh, &constant(0)), Some(constant(1)));
    assert_eq!(Polynomials.value(Function::Sin, &constant(1)), None);
    assert_eq!(Polynomials.power(&constant(4), &Rational::new(-1, 2).unwrap()).unwrap().to_string(), "1/2");
}
