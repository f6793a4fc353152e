use libration::algebra::Complex;
use libration::internals::spectrum::{part, transform};
use std::f64::consts::TAU;

#[test]
fn it_is_the_sum_of_its_definition() {
    for length in [1, 2, 4, 64] {
        let values: Vec<Complex> =
            (0..length).map(|n| Complex::new(libm::sin(part(n * n, 3)), part(n % 5, 7))).collect();
        let fast = transform(&values);
        for (k, fast) in fast.iter().enumerate() {
            let slow = values.iter().enumerate().fold(Complex::default(), |sum, (n, x)| {
                sum + *x * Complex::unit(-TAU * part(k * n % length, length))
            });
            assert!((*fast - slow).abs() < 1e-13, "{length} {k}");
        }
    }
}
