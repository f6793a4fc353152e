use libration::algebra::{Rational, Ring};
use libration::internals::algebra::Tower;

fn tower_of(squares: &[i64]) -> Tower {
    let mut tower = Tower::default();
    for square in squares {
        tower.adjoin_root(&[Rational::from(*square)]).unwrap();
    }
    tower
}

#[test]
fn roots_that_are_there_are_found() {
    let mut tower = tower_of(&[2]);
    let two = |sign: i64| vec![Rational::from(2), Rational::from(sign)];
    // √(2 − √2)·√(2 + √2) = √2, so that the second root is in the field of the first.
    let lower = tower.adjoin_root(&two(-1)).unwrap();
    let upper = tower.adjoin_root(&tower.lifted(&two(1))).unwrap();
    assert_eq!(tower.zero().len(), 4);
    assert!((tower.number(&upper) - (2.0 + 2.0_f64.sqrt()).sqrt()).abs() < 1e-15);
    assert_eq!(tower.text(&tower.multiply(&lower, &upper)), "sqrt(2)");
    assert_eq!(tower.adjoin_root(&tower.rational(&Rational::from(-1)).unwrap()), None);
}

#[test]
fn quotients_undo_products() {
    let tower = tower_of(&[2, 3, 5]);
    let element = |seed: i64| -> Vec<Rational> {
        (0..8).map(|n| Rational::new((n * n + seed) % 7 - 3, 1 + n).unwrap()).collect()
    };
    let (a, b) = (element(1), element(4));
    assert_eq!(tower.divide(&tower.multiply(&a, &b), &b), Some(a));
    assert_eq!(tower.divide(&b, &tower.zero()), None);
}

#[test]
fn a_square_is_no_further_root() {
    let mut tower = tower_of(&[3]);
    let root = tower.adjoin_root(&[Rational::new(3, 4).unwrap()]).unwrap();
    assert_eq!((root.len(), tower.text(&root).as_str()), (2, "1/2*sqrt(3)"));
}
