//! Taylor series of motions in multiple-precision floats, and the steps for which they hold.

use crate::taylor::StateLayout;
use libration_kernels::elementary::count;
use libration_numbers::algebra::{BigFloat, Floats, Ring};
use libration_numbers::internals::expression::{Jet, Tape};

/// The time series of each component of a state, up to and including an order; `None` if a
/// formula has no value. The tape contains the derivatives given by the equations, as functions
/// of the components of the state and then of further inputs, each given with its rate of change.
pub fn precise_series(
    ring: Floats,
    (layout, tape): (&StateLayout, &Tape),
    order: u32,
    state: &[BigFloat],
    further: &[(&BigFloat, i64)],
) -> Option<Vec<Vec<BigFloat>>> {
    let mut series: Vec<Vec<BigFloat>> = state.iter().map(|x| vec![x.clone()]).collect();
    let inputs: Vec<BigFloat> =
        state.iter().chain(further.iter().map(|(value, _)| *value)).cloned().collect();
    let mut jet = Jet::new(&ring, tape, &inputs).ok()?;
    for n in 1..=order {
        let last = usize::try_from(n - 1).ok()?;
        let mut next = vec![ring.zero(); state.len()];
        for coordinate in 0..layout.coordinates() {
            if let Some(velocity) = layout.velocity(coordinate) {
                next[coordinate] = ring.over_integer(&series[velocity][last], n.into())?;
            }
            next[layout.driven(coordinate)] = ring.over_integer(&jet.result(coordinate)[last], n.into())?;
        }
        let slopes = further.iter().map(|(_, rate)| if n == 1 { *rate } else { 0 });
        let slopes = slopes.map(|slope| BigFloat::from_integer(slope, ring.precision));
        if n < order {
            jet.extend(&next.iter().cloned().chain(slopes).collect::<Vec<_>>()).ok()?;
        }
        series.iter_mut().zip(next).for_each(|(one, next)| one.push(next));
    }
    Some(series)
}

/// The length of a step at whose end the last terms of the series are below the last bit
/// of a number whose first bit is 2^size, and decrease; `None` if the series are finite.
pub fn precise_step(precision: usize, series: &[Vec<BigFloat>], size: isize) -> Option<f64> {
    /// Number of coefficients that give the radius of convergence, some of which vanish by symmetry.
    const LAST: usize = 4;
    let bits = count(precision) + 4.0;
    let of_one = |one: &Vec<BigFloat>| {
        let exponents: Vec<(f64, f64)> = (one.iter().enumerate())
            .filter_map(|(n, c)| Some((count(n), real_exponent(c.exponent()? - size))))
            .collect();
        let order = count(one.len().saturating_sub(1));
        let last = exponents.iter().filter(|(n, _)| *n > order - count(LAST));
        let shortest = last.map(|(n, exponent)| -(bits + exponent) / n).fold(f64::INFINITY, f64::min);
        shortest - excess(&exponents, order, shortest)
    };
    let length = libm::exp2(series.iter().map(of_one).fold(f64::INFINITY, f64::min));
    (length.is_finite() && length > 0.0).then_some(length)
}

/// The number of powers of two by which a step is too long for its terms to decrease by [`FALL`] from the third quarter to the last: small terms
/// may still grow, as those of eˣ do up to the order x, and a sum that ends among these is not close to its limit. In a step that is far too
/// long the last terms of both quarters are the largest; a quarter is an even number of terms, so that both exist or vanish by symmetry.
fn excess(exponents: &[(f64, f64)], order: f64, log2_length: f64) -> f64 {
    /// Powers of two per term.
    const FALL: f64 = 1.5;
    let quarter = 2.0 * libm::floor(0.125 * order);
    let largest = |after: f64, to: f64| {
        let within = exponents.iter().filter(|(n, _)| after < *n && *n <= to);
        within.map(|(n, exponent)| exponent + n * log2_length).fold(f64::NEG_INFINITY, f64::max)
    };
    let middle = order - quarter;
    let (third, last) = (largest(middle - quarter, middle), largest(middle, order));
    if third == f64::NEG_INFINITY { 0.0 } else { f64::max(0.0, (last - third) / quarter + FALL) }
}

/// The sum of a series at a time.
pub fn precise_sum(series: &[BigFloat], time: &BigFloat) -> BigFloat {
    let mut terms = series.iter().rev().cloned();
    let last = terms.next().unwrap_or_else(|| BigFloat::from_integer(0, time.precision()));
    terms.fold(last, |sum, c| sum * time.clone() + c)
}

#[expect(clippy::cast_precision_loss, reason = "exponents are far below 2^53")]
fn real_exponent(exponent: isize) -> f64 {
    exponent as f64
}
