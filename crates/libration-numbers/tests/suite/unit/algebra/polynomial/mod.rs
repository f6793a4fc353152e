mod polynomials;
mod text;
mod variable;

use libration::algebra::{Polynomial, Rational, Variable};
use std::ops::Add;

fn variable(name: &str) -> Polynomial {
    Polynomial::variable(name)
}

fn number(text: &str) -> Polynomial {
    Polynomial::constant(text.parse().unwrap())
}

/// x³ − 2/3·x·y + y²/5 − 7.
fn sample() -> Polynomial {
    let (x, y) = (variable("x"), variable("y"));
    x.pow(3) - number("2/3") * x * y.clone() + number("1/5") * y.pow(2) - number("7")
}

#[test]
fn arithmetic_keeps_the_ring_laws() {
    let (a, b, c) = (sample(), variable("x") + number("1/2"), variable("y").pow(2) - variable("z"));
    assert_eq!(a.clone() * (b.clone() + c.clone()), a.clone() * b.clone() + a.clone() * c.clone());
    assert_eq!(b.clone() * c.clone(), c.clone() * b.clone());
    assert_eq!((b.clone() * c.clone()) * a.clone(), b * (c * a.clone()));
    assert!((a.clone() - a).is_zero());
}

#[test]
fn a_value_is_the_same_before_and_after_an_operation() {
    let at = |name: &str| Variable::from(name);
    let values = |variable: &Variable| {
        (*variable == at("x")).then(|| Rational::from(-3)).or_else(|| "5/7".parse().ok())
    };
    let value = |polynomial: &Polynomial| polynomial.value(values).unwrap();
    // −27 − (2/3)(−3)(5/7) + (25/49)/5 − 7 = −1591/49 by hand.
    assert_eq!(value(&sample()).to_string(), "-1591/49");
    assert_eq!(value(&(sample() * sample())), value(&sample()) * value(&sample()));
    let substituted = sample().substitute(&at("x"), &number("-3"));
    assert_eq!(value(&substituted), value(&sample()));
    assert_eq!(sample().value(|_| None), None);
}

#[test]
fn division_undoes_multiplication_and_refuses_a_rest() {
    let divisor = variable("x") - variable("y").pow(2);
    let multiple = sample() * divisor.clone();
    assert_eq!(multiple.divide_exactly(&divisor), Some(sample()));
    assert_eq!((multiple + number("1")).divide_exactly(&divisor), None);
    assert_eq!(sample().divide_exactly(&Polynomial::zero()), None);
    assert_eq!(Polynomial::zero().divide_exactly(&divisor), Some(Polynomial::zero()));
}

#[test]
fn a_polynomial_is_the_sum_of_its_coefficients_times_powers() {
    let x = Variable::from("x");
    let powers = (0..=sample().degree_in(&x))
        .map(|power| sample().coefficient(&x, power) * Polynomial::variable(x.clone()).pow(power));
    assert_eq!(powers.fold(Polynomial::zero(), Add::add), sample());
    assert_eq!(sample().degree(), 3);
}

#[test]
fn the_primitive_multiple_has_coprime_integers() {
    let scaled = sample().scaled(&Rational::new(22, 35).unwrap());
    assert_eq!(scaled.primitive().to_string(), "-105 - 10*x*y + 3*y^2 + 15*x^3");
    assert_eq!(number("-7/3").primitive(), number("-1"));
    assert!(Polynomial::zero().primitive().is_zero());
}

#[test]
fn derivatives_obey_the_product_rule() {
    let (x, b) = (Variable::from("x"), variable("x").pow(2) * variable("y") + variable("x"));
    let left = (sample() * b.clone()).derivative(&x);
    assert_eq!(left, sample().derivative(&x) * b.clone() + sample() * b.derivative(&x));
}
