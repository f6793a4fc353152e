use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::algebra::composition;

#[test]
fn steps_of_any_size_give_what_one_power_after_the_other_gives() {
    let series = |seed: i64, length: i64| -> Vec<Rational> {
        (0..length).map(|n| Rational::new(if n == 0 { 0 } else { seed - n * n }, n + seed).unwrap()).collect()
    };
    for (outer, inner, length) in [(0, 4, 5), (1, 3, 4), (5, 6, 4), (7, 12, 12), (12, 12, 12), (30, 9, 17)] {
        let (outer, inner) = (series(5, outer), series(3, inner));
        let mut expected = vec![Rational::from(0); length];
        for factor in outer.iter().take(length).rev() {
            expected = Rationals.series_product(&expected, &inner, length);
            expected[0] = expected[0].clone() + factor.clone();
        }
        assert_eq!(composition(&outer, &inner, length, &|| true), Some(expected));
    }
    let steps = std::cell::Cell::new(0);
    let until =
        |last| composition(&series(5, 30), &series(3, 30), 30, &|| steps.replace(steps.get() + 1) < last);
    assert!(until(4).is_none() && until(100).is_some());
}
