mod online;
mod power_series;
mod truncated;

use dashu_int::IBig;
use libration::series::{even_reciprocal, exponential};

fn integers(values: &[i64]) -> Vec<IBig> {
    values.iter().copied().map(IBig::from).collect()
}

#[test]
fn exponential_of_a_logarithm_gives_the_geometric_series() {
    // −ln(1 − x) = Σ xʲ/j.
    let length = 300;
    assert_eq!(exponential(&vec![IBig::ONE; length], length), vec![IBig::ONE; length]);
}

#[test]
fn reciprocal_of_the_cosine_gives_the_euler_numbers() {
    // OEIS A000364.
    let cosine: Vec<IBig> = (0..8).map(|n| IBig::from(1 - 2 * (n % 2))).collect();
    let euler = integers(&[1, 1, 5, 61, 1385, 50521, 2702765, 199360981]);
    assert_eq!(even_reciprocal(&cosine, 8), euler);
}

#[test]
fn reciprocal_of_the_reciprocal_is_the_series() {
    let a: Vec<IBig> = (0..260_i64).map(|n| IBig::from(1 + n * (n - 7)).pow(3)).collect();
    let b = even_reciprocal(&a, a.len());
    assert_eq!(even_reciprocal(&b, a.len()), a);
}
