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
/// whatever the gauge. `None` when a number is not rational, or the check is interrupted.
pub(crate) fn agrees_with_the_potential(
    model: &Model<Rational>,
    set: &SeriesSet<Rational>,
    watch: &Watch<'_>,
) -> Option<bool> {
    let square = squared_energy_amplitude(model, &set.x_max, watch)?;
    if square != squared_energy_amplitude(model, &set.x_min, watch)? {
        return Some(false);
    }
    let x = displacement(&Rationals, &model.tape, model.values.clone(), &model.omega0_squared, model.order)?;
    let by_square: Vec<Rational> = period_ratio(&Rationals, &x)?.into_iter().step_by(2).collect();
    let length = set.frequency.len();
    let mut period = vec![Rationals.zero(); length];
    for (n, coefficient) in by_square.iter().enumerate().rev() {
        if watch.reached(2 * n).is_err() {
            return None;
        }
        period = product(&Rationals, &period, &square, length);
        period[0] = Rationals.add(&period[0], coefficient);
    }
    let mut one = vec![Rationals.zero(); length];
    one[0] = Rational::from(1);
    Some(product(&Rationals, &period, &set.frequency, length) == one)
}

/// ρ² = 2V/ω0² at a displacement that is itself a series: −2/ω0²·∫ F dx.
fn squared_energy_amplitude(
    model: &Model<Rational>,
    x: &[Rational],
    watch: &Watch<'_>,
) -> Option<Vec<Rational>> {
    let mut jet = Jet::with_values(&Rationals, &model.tape, model.values.clone());
    let mut square = vec![Rationals.zero(), Rationals.zero()];
    let mut slope = vec![];
    for (n, coefficient) in x.iter().enumerate().skip(1) {
        if watch.reached(n).is_err() {
            return None;
        }
        let mut inputs = vec![Rationals.zero(); model.tape.inputs()];
        *inputs.first_mut()? = coefficient.clone();
        jet.extend(&inputs).ok()?;
        slope.push(Rationals.times_integer(coefficient, i64::try_from(n).ok()?));
        // n + 1 times the coefficient of V at order n + 1.
        let work = Rationals.convolution(&jet.result(0)[1..=n], &slope);
        let energy =
            Rationals.over_integer(&Rationals.times_integer(&work, -2), u64::try_from(n + 1).ok()?)?;
        square.push(Rationals.divide(&energy, &model.omega0_squared)?);
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
