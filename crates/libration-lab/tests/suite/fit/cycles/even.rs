//! An even function as a sum of Chebyshev polynomials of its square, for more evaluations than the construction of the sum takes.

use libration_lab::internals::fit::cycles::even::Even;

#[test]
fn the_sum_is_the_function() {
    let function = |x: f64| libm::cos(3.0 * x) / (1.2 - x * x);
    let even = Even::new(0.9, function).unwrap();
    for n in 0..=100 {
        let x = 0.9 * (f64::from(n) / 50.0 - 1.0);
        assert!((even.at(x).unwrap() - function(x)).abs() < 1e-12, "{x}");
    }
    assert_eq!(even.at(0.9_f64.next_up()), None);
}

#[test]
fn what_is_not_smooth_is_refused() {
    assert!(Even::new(1.0, f64::abs).is_none());
    assert!(Even::new(0.9, |x| 1.0 / (0.82 - x * x)).is_none());
}
