//! The effect of residuals that are alike from row to row on uncertainties.

use libration_lab::internals::fit::trace::noise::{FACTOR, Part, Rows, mean_effect, memories};
use libration_lab::internals::statistics::count;
use libration_lab::measurement::{Observable, Trace};
use nalgebra::DMatrix;

fn part(times: &[f64]) -> Part<'_> {
    let rows = times.iter().flat_map(|&t| [libm::sin(t), 1.0 + t * t]).collect();
    Part { times, first: 0, places: vec![0, 1], rows }
}

fn covariance(times: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(times.len(), times.len(), |i: usize, j: usize| {
        let memory = libm::exp(-(times[i] - times[j]).abs() / TIME);
        (1.0 - WHITE) * memory + if i == j { WHITE } else { 0.0 }
    })
}

/// Uneven times, and both parts.
const TIMES: [f64; 11] = [0.0, 0.3, 0.4, 1.0, 1.7, 1.9, 2.0, 2.4, 2.5, 3.0, 3.6];
const TIME: f64 = 0.8;
const WHITE: f64 = 0.3;

/// Comparison with the inverse and the determinant of the whole matrix.
#[test]
fn the_filter_gives_what_the_whole_covariance_gives() {
    let (part, whole) = (part(&TIMES), covariance(&TIMES));
    let mut products = DMatrix::zeros(2, 2);
    let logarithm = part.add_products(WHITE, &memories(TIME, &TIMES), &mut products);
    assert!((logarithm - libm::log(whole.determinant())).abs() < 1e-12);
    let columns = DMatrix::from_fn(TIMES.len(), 2, |row, column| part.rows[2 * row + column]);
    let expected = columns.transpose() * whole.try_inverse().unwrap() * columns;
    assert!((&products - &expected).norm() < 1e-13 * expected.norm());
}

#[test]
fn the_spread_is_that_of_the_whole_covariance() {
    let response = DMatrix::from_fn(1, TIMES.len(), |_, n| libm::cos(count(n)));
    let rows = Rows { parts: vec![part(&TIMES)], parameters: 1 };
    let expected = (&response * covariance(&TIMES) * response.transpose())[(0, 0)];
    let [separate, shared] = rows.spreads(&[memories(TIME, &TIMES)], &response)[0];
    assert!((separate + 2.0 * (1.0 - WHITE) * shared - expected).abs() < 1e-12);
}

/// Half of the weight at e² times the variance: the mean is e, and the logarithms scatter by 1.
#[test]
fn noises_that_disagree_leave_few_degrees_of_freedom() {
    let effect = mean_effect(&[0.0, 2.0], &[0.5, 0.5], 1e9);
    assert!((effect.inflation - std::f64::consts::E).abs() < 1e-12);
    assert!((effect.degrees_of_freedom - 2.0).abs() < 1e-6, "{effect:?}");
    let alike = mean_effect(&[0.5, 0.5], &[0.9, 0.1], 30.0);
    assert!((alike.degrees_of_freedom - 30.0).abs() < 1e-9);
}

#[test]
fn times_go_up_to_an_eighth_of_the_trace() {
    let times: Vec<f64> = (0..81).map(|row| 0.1 * f64::from(row)).collect();
    let trace = Trace::new("eight seconds", Observable::Angle, times.clone(), vec![0.0; 81], None).unwrap();
    let of_noise = libration_lab::internals::fit::trace::noise::times(&[trace]);
    assert!(of_noise.iter().all(|time| (0.039..=1.0).contains(time)));
    assert!(of_noise.iter().any(|time| *time > 1.0 / FACTOR));
}
