//! Exact checks of a family's series by a road that knows no harmonics.

use super::conservative::{displacement, period_ratio};
use super::first_integral;
use super::model::Model;
use super::series_set::SeriesSet;
use crate::algebra::{HarmonicSums, Rational, Rationals, Ring};
use crate::expression::Jet;
use crate::series::truncated::product;
use crate::watch::Watch;

/// Whether frequency and turning points of x″ = F(x) agree exactly with the reversion of the potential: both turning
/// points have the same potential energy, and the period at that energy is T/T0. In the variable of the series,
/// whatever the gauge; series are compared by `same`. `None` when a number is not in the ring, or the check is interrupted.
pub(crate) fn agrees_with_the_potential<R: Ring>(
    ring: &R,
    model: &Model<R::Element>,
    set: &SeriesSet<R::Element>,
    same: impl Fn(&Vec<R::Element>, &Vec<R::Element>) -> bool,
    watch: &Watch<'_>,
) -> Option<bool> {
    let square = squared_energy_amplitude(ring, model, &set.x_max, watch)?;
    if !same(&square, &squared_energy_amplitude(ring, model, &set.x_min, watch)?) {
        return Some(false);
    }
    let x = displacement(ring, &model.tape, model.values.clone(), &model.omega0_squared, model.order)?;
    let by_square: Vec<R::Element> = period_ratio(ring, &x)?.into_iter().step_by(2).collect();
    let length = set.frequency.len();
    let mut period = vec![ring.zero(); length];
    for (n, coefficient) in by_square.iter().enumerate().rev() {
        if watch.reached(2 * n).is_err() {
            return None;
        }
        period = product(ring, &period, &square, length);
        period[0] = ring.add(&period[0], coefficient);
    }
    let mut one = vec![ring.zero(); length];
    one[0] = ring.rational(&Rational::from(1))?;
    Some(same(&product(ring, &period, &set.frequency, length), &one))
}

/// ρ² = 2V/ω0² at a displacement that is itself a series: −2/ω0²·∫ F dx.
fn squared_energy_amplitude<R: Ring>(
    ring: &R,
    model: &Model<R::Element>,
    x: &[R::Element],
    watch: &Watch<'_>,
) -> Option<Vec<R::Element>> {
    let mut jet = Jet::with_values(ring, &model.tape, model.values.clone());
    let mut square = vec![ring.zero(), ring.zero()];
    let mut slope = vec![];
    for (n, coefficient) in x.iter().enumerate().skip(1) {
        if watch.reached(n).is_err() {
            return None;
        }
        let mut inputs = vec![ring.zero(); model.tape.inputs()];
        *inputs.first_mut()? = coefficient.clone();
        jet.extend(&inputs).ok()?;
        slope.push(ring.times_integer(coefficient, i64::try_from(n).ok()?));
        // n + 1 times the coefficient of V at order n + 1.
        let work = ring.convolution(&jet.result(0)[1..=n], &slope);
        let energy = ring.over_integer(&ring.times_integer(&work, -2), u64::try_from(n + 1).ok()?)?;
        square.push(ring.divide(&energy, &model.omega0_squared)?);
    }
    square.truncate(x.len());
    Some(square)
}

/// Whether the period as a function of the amplitude agrees exactly with the first integral of an odd oscillator.
/// `None` when a number is not rational.
pub(crate) fn agrees_with_the_first_integral(
    model: &Model<Rational>,
    set: &SeriesSet<Rational>,
) -> Option<bool> {
    let of = set.of_amplitude.as_ref()?;
    let length = of.period.len();
    Some(
        first_integral::period_ratio(&model.tape, &model.values, &model.omega0_squared, length)? == of.period,
    )
}

/// Whether plain rational arithmetic, harmonic by harmonic, gives the same numbers. `None` when it meets a root that
/// is not rational.
pub(crate) fn agrees_with_plain_rationals(
    model: &Model<Rational>,
    set: &SeriesSet<Rational>,
    watch: &Watch<'_>,
) -> Option<bool> {
    let ring = HarmonicSums { numbers: Rationals };
    let plain = model.series(&ring, |number| Some(number.clone()), Rational::square_root, watch)?;
    (!watch.is_stopped()).then(|| plain.numbers() == set.numbers())
}
