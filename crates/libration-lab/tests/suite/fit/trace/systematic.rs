//! Errors common to all rows, which do not show in the scatter and are added to it.

use libration_lab::fit::Uncertain;
use libration_lab::fit::trace::Parameter;
use libration_lab::internals::fit::trace::profile;
use libration_lab::internals::fit::trace::systematic::add;
use nalgebra::DMatrix;

/// 3e-3 by the scatter.
fn fitted(degrees_of_freedom: f64) -> Parameter {
    let mut fitted = Parameter {
        estimate: Uncertain { value: 4.0, uncertainty: 3e-3 },
        degrees_of_freedom,
        ..Parameter::default()
    };
    fitted.intervals = profile::linear_intervals(&fitted);
    fitted
}

fn with_another(mut parameter: Parameter, deviation: f64) -> Parameter {
    add(
        std::slice::from_mut(&mut parameter),
        &mut [vec![1.0]],
        &DMatrix::from_element(1, 1, deviation * deviation),
    );
    parameter
}

#[test]
fn errors_add_in_squares() {
    let same = with_another(fitted(1000.0), 0.0);
    assert_eq!(same, fitted(1000.0));
    let more = with_another(fitted(1e9), 4e-3);
    assert!((more.estimate.uncertainty - 5e-3).abs() < 1e-15, "3, 4, 5: {more:?}");
    let [[low, high], [_, highest]] = more.intervals;
    assert!((low - 3.995).abs() < 1e-9 && (high - 4.005).abs() < 1e-9);
    assert!((highest - 4.0 - 1.959_964 * 5e-3).abs() < 1e-8);
}

/// Three degrees of freedom for both contributions become twelve, for which Student's 95 % is 2.179 (Abramowitz and
/// Stegun table 26.10).
#[test]
fn intervals_are_those_of_students_t() {
    let more = with_another(fitted(3.0), 3e-3);
    assert!((more.degrees_of_freedom - 12.0).abs() < 1e-9, "{more:?}");
    let half = 0.5 * (more.intervals[1][1] - more.intervals[1][0]);
    assert!((half / (2.179 * 3e-3 * 2.0_f64.sqrt()) - 1.0).abs() < 1e-3, "{half:e}");
}

#[test]
fn a_shared_error_correlates_what_it_moves() {
    let mut parameters = vec![fitted(1e9), fitted(1e9)];
    let mut correlations = vec![vec![1.0, 0.2], vec![0.2, 1.0]];
    let covariance = DMatrix::from_element(2, 2, 16e-6);
    add(&mut parameters, &mut correlations, &covariance);
    // (0.2·9 + 16)/25.
    assert!((correlations[0][1] - 0.712).abs() < 1e-12 && (correlations[1][0] - 0.712).abs() < 1e-12);
    assert!((correlations[0][0] - 1.0).abs() < 1e-15);
}
