//! Levenberg's and Marquardt's method on problems with known minima.

use libration_lab::internals::statistics::levenberg_marquardt::{
    Effort, Linearised, ResidualsError, minimum,
};
use nalgebra::{DMatrix, DVector};

const EFFORT: Effort = Effort { tolerance: 1e-12, patience: 100 };

/// Residuals of a·e^(−bt) at four times from 3·e^(−t/2); undefined for b above 5.
fn exponential(parameters: &DVector<f64>) -> Result<Linearised, ResidualsError> {
    let (a, b) = (parameters[0], parameters[1]);
    if b > 5.0 {
        return Err(ResidualsError::OutOfDomain);
    }
    let times = [0.0, 1.0, 2.0, 3.0];
    let value = |t: f64| libm::exp(-b * t);
    Ok(Linearised {
        residuals: DVector::from_fn(4, |i, _| a * value(times[i]) - 3.0 * libm::exp(-0.5 * times[i])),
        jacobian: DMatrix::from_fn(4, 2, |i, k| {
            if k == 0 { value(times[i]) } else { -a * times[i] * value(times[i]) }
        }),
    })
}

#[test]
fn the_parameters_of_exact_data_come_back() {
    let minimum = minimum(DVector::from_row_slice(&[1.0, 4.9]), EFFORT, exponential).unwrap();
    let [a, b] = [minimum.parameters[0], minimum.parameters[1]];
    assert!((a - 3.0).abs() < 1e-9 && (b - 0.5).abs() < 1e-9 && minimum.converged, "{a} {b}");
    assert!(minimum.linearised.residuals.norm() < 1e-9);
}

/// Rosenbrock's valley, from its usual start.
#[test]
fn a_bent_valley_is_followed_to_its_end() {
    let valley = |p: &DVector<f64>| {
        Ok(Linearised {
            residuals: DVector::from_row_slice(&[10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]]),
            jacobian: DMatrix::from_row_slice(2, 2, &[-20.0 * p[0], 10.0, -1.0, 0.0]),
        })
    };
    let minimum = minimum(DVector::from_row_slice(&[-1.2, 1.0]), EFFORT, valley).unwrap();
    assert!(minimum.parameters.iter().all(|p| (p - 1.0).abs() < 1e-10), "{}", minimum.parameters);
}

#[test]
fn a_search_without_patience_does_not_converge() {
    let effort = Effort { patience: 1, ..EFFORT };
    assert!(!minimum(DVector::from_row_slice(&[1.0, 4.9]), effort, exponential).unwrap().converged);
}

#[test]
fn outside_and_stopped_are_told_apart() {
    let start = |b: f64| DVector::from_row_slice(&[1.0, b]);
    let refused = minimum(start(6.0), EFFORT, exponential).map(|_| ()).unwrap_err();
    assert_eq!(refused, ResidualsError::OutOfDomain);
    let mut evaluations = 0;
    let stopped = |parameters: &DVector<f64>| {
        evaluations += 1;
        if evaluations > 2 { Err(ResidualsError::Stopped) } else { exponential(parameters) }
    };
    assert_eq!(minimum(start(1.0), EFFORT, stopped).map(|_| ()).unwrap_err(), ResidualsError::Stopped);
}

/// A line through its best parameters: the search ends after one evaluation there, and after two from elsewhere.
#[test]
fn a_search_ends_where_nothing_is_promised() {
    let counted = |start: [f64; 2]| {
        let mut evaluations = 0;
        let outcome = minimum(DVector::from_row_slice(&start), EFFORT, |line| {
            evaluations += 1;
            let values = [1.0, 3.0, 2.0, 4.0];
            let x = |i: usize| [-1.5, -0.5, 0.5, 1.5][i];
            Ok(Linearised {
                residuals: DVector::from_fn(4, |i, _| line[0] + line[1] * x(i) - values[i]),
                jacobian: DMatrix::from_fn(4, 2, |i, k| if k == 0 { 1.0 } else { x(i) }),
            })
        });
        let minimum = outcome.unwrap();
        // By hand: the mean, and (1.5·3 + 0.5·(−1))/5.
        assert!((minimum.parameters[0] - 2.5).abs() < 1e-12 && (minimum.parameters[1] - 0.8).abs() < 1e-12);
        assert!(minimum.converged);
        evaluations
    };
    assert_eq!((counted([2.5, 0.8]), counted([2.0, 1.0])), (1, 2));
}
