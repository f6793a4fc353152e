use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::algebra::{Quadratic, QuadraticField};

#[test]
fn quotients_undo_products_in_a_tower() {
    let inner = QuadraticField { base: Rationals, square: Rational::from(2) };
    let element = |a: i64, b: i64| Quadratic { plain: Rational::from(a), root: Rational::from(b) };
    // √(2 − √2) is not in the field of √2.
    let field = QuadraticField { base: inner, square: element(2, -1) };
    let a = Quadratic { plain: element(3, 1), root: element(-2, 5) };
    let b = Quadratic { plain: element(0, 7), root: element(4, -1) };
    assert_eq!(field.divide(&field.multiply(&a, &b), &b), Some(a.clone()));
    let root = field.square_root().unwrap();
    assert_eq!(field.multiply(&root, &root).plain, element(2, -1));
    assert_eq!(field.divide(&a, &field.zero()), None);
}
