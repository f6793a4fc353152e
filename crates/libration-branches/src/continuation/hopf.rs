//! Hopf points, where a limit cycle shrinks to an equilibrium.
//!
//! # Method
//! A cycle that shrinks to an equilibrium ends at the Hopf point, which is solved
//! for separately, from the eigenvalues of the equilibrium and not from the motion.

use super::field::{Field, Rates};
use super::point::BranchPoint;
use libration_motion::orbit::Stability;
use libration_numbers::algebra::{Complex, Doubles};
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::linear::{eigenvalues, solve};
use libration_numbers::internals::roots::{NewtonError, newton};
use libration_numbers::roots::{Tolerance, zero_between};
use std::f64::consts::TAU;

/// An equilibrium at a value of the parameter.
struct Rest {
    state: Vec<f64>,
    /// Eigenvalues of the Jacobian matrix of the rates.
    eigenvalues: Vec<Complex>,
    /// The eigenvalue above the real axis whose frequency is nearest to that of the cycle.
    critical: Complex,
}

/// The Hopf point near a state, a period and a value of the parameter, for a range of this
/// width: a pair of eigenvalues is imaginary there. Its error is that of the parameter.
pub(super) fn hopf(
    field: &Field,
    near: &[f64],
    [period, value]: [f64; 2],
    width: f64,
) -> Option<BranchPoint> {
    /// The first distance of the search, relative to the range, and the number of its doublings.
    const NEAR: f64 = 1e-6;
    const DOUBLINGS: i32 = 16;
    let rest = |value: f64| Rest::near(field, near, value, TAU / period);
    let growth = |value: f64| rest(value).map_or(f64::NAN, |rest| rest.critical.re);
    let ends = |doublings: i32| {
        let aside = NEAR * width * libm::exp2(f64::from(doublings));
        [value - aside, value + aside].map(|end| (end, growth(end)))
    };
    let mut brackets = (0..DOUBLINGS).map(ends);
    let bracket = brackets.find(|[a, b]| a.1.is_finite() && b.1.is_finite() && (a.1 > 0.0) != (b.1 > 0.0))?;
    let parameter = zero_between(bracket, Tolerance::relative(f64::EPSILON), growth)?;
    let Rest { state, eigenvalues, critical } = rest(parameter)?;
    let [a, b] = bracket;
    let slope = ((b.1 - a.1) / (b.0 - a.0)).abs();
    let error = 4.0 * f64::EPSILON * (parameter.abs() + eigenvalues.first()?.abs() / slope);
    let period = TAU / critical.im;
    let multiplier = |number: Complex| {
        Complex { re: libm::cos(number.im * period), im: libm::sin(number.im * period) }
            .scaled(libm::exp(number.re * period))
    };
    // An eigenvalue has an error of a few roundings of the largest.
    let rounding = 16.0 * f64::EPSILON * eigenvalues.first()?.abs() * period;
    let with_error = |number: Complex| (multiplier(number), multiplier(number).abs() * rounding);
    let mut multipliers: Vec<(Complex, f64)> = eigenvalues.into_iter().map(with_error).collect();
    multipliers.put_in_order(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let point = BranchPoint {
        parameter,
        period,
        rotation: None,
        ranges: state.iter().map(|x| [*x; 2]).collect(),
        state,
        stability: Stability::Undetermined,
        multipliers: vec![],
        multiplier_errors: vec![],
        error,
    };
    Some(point.with_multipliers(multipliers))
}

impl Rest {
    /// Finds an equilibrium by Newton's method, from a state.
    fn near(field: &Field, state: &[f64], value: f64, frequency: f64) -> Option<Self> {
        const MOST_ROUNDS: usize = 30;
        /// Size, relative to the state, below which a correction that no longer shrinks counts as rounding: it has half of the digits, and the
        /// next one, if it were not rounding, all of them.
        const ROUNDING: f64 = 1e-9;
        let numbers = state.len();
        let jacobian = |rates: &Rates| -> Vec<Vec<f64>> {
            rates.slopes.iter().map(|row| row[..numbers].to_vec()).collect()
        };
        let step = |at: &[f64]| {
            let rates = field.at(at, &[value]).ok_or(NewtonError::NoValue)?;
            let missed: Vec<f64> = rates.rates.iter().map(|rate| -rate).collect();
            let change = solve(&Doubles, |x| x.abs(), &jacobian(&rates), &missed);
            change.filter(|change| change.iter().all(|x| x.is_finite())).ok_or(NewtonError::NoSlope)
        };
        let mut before = f64::INFINITY;
        let largest = |numbers: &[f64]| numbers.iter().map(|x| x.abs()).fold(0.0, f64::max);
        let is_last = |change: &[f64], at: &[f64]| {
            let size = largest(change);
            let last = size == 0.0 || (size > 0.5 * before && size < ROUNDING * largest(at));
            before = size;
            last
        };
        let state = newton(&Doubles, state, MOST_ROUNDS, step, is_last).ok()?;
        let eigenvalues = eigenvalues(&jacobian(&field.at(&state, &[value])?))?;
        let off = |number: &&Complex| (number.im - frequency).abs();
        let above = eigenvalues.iter().filter(|eigenvalue| eigenvalue.im > 0.0);
        let critical = *above.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some(Self { state, eigenvalues, critical })
    }
}
