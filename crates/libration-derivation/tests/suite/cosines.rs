//! Projections and derivatives of cosines.

use libration::algebra::Rational;
use libration_derivation::internals::paper::{cosine, projection, second_derivative};

#[test]
fn each_cosine_projects_on_itself_alone() {
    for (n, m) in (1..8).flat_map(|n| (1..8).map(move |m| (n, m))) {
        let expected = Rational::from(i64::from(n == m));
        assert_eq!(projection(&cosine(n), m).to_constant(), Some(expected), "{n} on {m}");
    }
}

#[test]
fn the_second_derivative_of_a_cosine_is_minus_its_square_times_it() {
    assert_eq!(second_derivative(&cosine(5)), cosine(5).scaled(&Rational::from(-25)));
}
