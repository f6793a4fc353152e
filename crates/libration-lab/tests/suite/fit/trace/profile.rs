//! Student's quantiles for the intervals of the profile likelihood.

use libration_lab::internals::fit::trace::profile::{LEVELS, students};

#[test]
fn quantiles_of_student() {
    // Two-sided 95 % of 10 and 30 degrees of freedom, Abramowitz and Stegun table 26.10.
    for (degrees, quantile) in [(10.0, 2.228), (30.0, 2.042)] {
        assert!((students(LEVELS[1], degrees) - quantile).abs() < 5e-4);
    }
    // The fewest degrees of freedom that are used: 4.303 and 1.321.
    assert!((students(LEVELS[1], 2.0) / 4.303 - 1.0).abs() < 0.04);
    assert!((students(LEVELS[0], 2.0) / 1.321 - 1.0).abs() < 0.01);
}
