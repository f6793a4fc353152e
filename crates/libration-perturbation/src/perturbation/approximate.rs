//! A model's series in floats, where its numbers are not rational, computed twice to know how many digits hold.
//!
//! # Method The computation runs on floats, at growing precision until two runs agree to 40 digits in every coefficient, and the result says so. A
//! coefficient that shrinks as the precision grows is the remainder of a cancellation, and zero.

use super::limit_cycle::first_sine;
use super::model::{Model, Motion, Selected, values_at};
use super::selection::interpolated;
use super::series_set::SeriesSet;

use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Stage;
use libration_numbers::{
    algebra::{BigFloat, Floats, Rational, Ring},
    internals::algebra::HarmonicSums,
};

/// Decimal digits of a result in floats.
pub(crate) const DIGITS: usize = 40;

/// Bits for this many digits.
fn bits(digits: usize) -> usize {
    digits * 10 / 3 + 16
}

/// A model in floats, and its equilibrium.
pub(crate) type Prepared = (Model<BigFloat>, BigFloat);

/// The series with ω0² and the equilibrium.
pub(crate) type Approximated = (SeriesSet<Rational>, Rational, Rational);

/// The series when two precisions agree to [`DIGITS`]; if the comparison is cancelled, to the order that both have. `None` if
/// no precisions agree, or there are no series.
pub(crate) fn approximate_series(
    prepare: &dyn Fn(Floats) -> Option<Prepared>,
    watch: &Watch<'_>,
) -> Option<Approximated> {
    agreed(&|precision| series_at(prepare, precision, watch), watch)
}

/// Computes the same from series that are computed in some way with a given number of bits.
pub(crate) fn agreed(
    series_at: &dyn Fn(usize) -> Option<(SeriesSet<BigFloat>, BigFloat, BigFloat)>,
    watch: &Watch<'_>,
) -> Option<Approximated> {
    let mut precision = bits(DIGITS) + 64;
    let mut coarse = series_at(precision)?.0;
    for _ in 0..6 {
        if watch.is_stopped() {
            return None;
        }
        let before = precision;
        precision += precision / 2;
        let (set, omega0_squared, equilibrium) = series_at(precision)?;
        let fine = set.numbers();
        let coarser = coarse.in_common_with(&set).numbers();
        let pairs = coarser.iter().zip(&fine);
        let numbers = pairs.map(|(coarse, fine)| {
            settled(Rounded { number: coarse, precision: before }, Rounded { number: fine, precision })
        });
        if let Some(numbers) = numbers.collect::<Option<Vec<_>>>() {
            let set = set.with_numbers(numbers.into_iter())?;
            return Some((set, omega0_squared.to_rational(), cleaned(&equilibrium).to_rational()));
        }
        coarse = set;
    }
    None
}

fn series_at(
    prepare: &dyn Fn(Floats) -> Option<Prepared>,
    precision: usize,
    watch: &Watch<'_>,
) -> Option<(SeriesSet<BigFloat>, BigFloat, BigFloat)> {
    let floats = Floats { precision };
    let (model, equilibrium) = prepare(floats)?;
    let ring = HarmonicSums { numbers: floats };
    watch.begin(Stage::Floats { bits: precision }, Some(model.order));
    let set = model.series(&ring, |x| Some(x.clone()), |x| Some(x.sqrt()), watch)?;
    Some((set, model.omega0_squared, equilibrium))
}

fn digits_as_bits() -> isize {
    isize::try_from(bits(DIGITS)).unwrap_or(isize::MAX)
}

/// Replaces remainders of cancellations by zero, and rounds to the digits that are kept.
fn cleaned(x: &BigFloat) -> BigFloat {
    let noise = x.exponent().is_none_or(|exponent| exponent < -digits_as_bits());
    let kept = x.rounded_to(bits(DIGITS));
    if noise { kept.clone() - kept } else { kept }
}

/// A number and its precision in bits.
#[derive(Clone, Copy)]
struct Rounded<'a> {
    number: &'a BigFloat,
    precision: usize,
}

/// The number determined by two precisions: that of the finer one if they agree to [`DIGITS`]; zero if it shrinks
/// with the rounding error, as the remainder of a cancellation does; otherwise `None`.
fn settled(coarse: Rounded<'_>, fine: Rounded<'_>) -> Option<Rational> {
    let gap = (fine.number.clone() - coarse.number.clone()).exponent();
    let size = fine.number.exponent();
    let agree = gap.is_none_or(|gap| size.is_some_and(|size| gap < size - digits_as_bits()));
    if agree {
        return Some(fine.number.rounded_to(bits(DIGITS)).to_rational());
    }
    let gained = isize::try_from(fine.precision - coarse.precision).ok()?;
    // A zero may be as large as the first bit that is lost.
    let size_before = coarse.number.exponent().unwrap_or(-isize::try_from(coarse.precision).ok()?);
    size.is_none_or(|size| size < size_before - gained / 2).then(|| Rational::from(0))
}

/// The centre at the equilibrium next to a number, by Newton's method.
pub(crate) fn centre(
    floats: Floats,
    tape: &Tape,
    near: f64,
    motion: Motion<BigFloat>,
    uses_velocity: bool,
    order: usize,
) -> Option<Prepared> {
    const MOST_STEPS: usize = 64;
    let settled = isize::try_from(floats.precision).ok()? - 8;
    let mut x = BigFloat::from_f64(near, floats.precision)?;
    let (mut force, mut slope) = force_and_slope(floats, tape, &x)?;
    for _ in 0..MOST_STEPS {
        let step = floats.divide(&force, &slope)?;
        x = x - step.clone();
        (force, slope) = force_and_slope(floats, tape, &x)?;
        if step.exponent().is_none_or(|size| size < x.exponent().unwrap_or(0).max(0) - settled) {
            break;
        }
    }
    let values = values_at(&floats, tape, x.clone())?;
    let model = Model { tape: tape.clone(), values, omega0_squared: -slope, uses_velocity, motion, order };
    Some((model, x))
}

/// F and ∂F/∂x at rest.
fn force_and_slope(floats: Floats, tape: &Tape, x: &BigFloat) -> Option<(BigFloat, BigFloat)> {
    let mut jet = Jet::new(&floats, tape, &[x.clone(), floats.zero()]).ok()?;
    jet.extend(&[floats.rational(&1.into())?, floats.zero()]).ok()?;
    let force = jet.result(0);
    Some((force[0].clone(), force[1].clone()))
}

/// The attracting limit cycle of smallest amplitude.
pub(crate) fn limit_cycle(
    floats: Floats,
    tape: &Tape,
    omega0_squared: &Rational,
    degree: usize,
    symmetric: bool,
    order: usize,
) -> Option<Prepared> {
    let omega0_squared = floats.rational(omega0_squared)?;
    let omega0 = omega0_squared.sqrt();
    let ring = HarmonicSums { numbers: floats };
    let amplitudes: Vec<BigFloat> = (1..=i64::try_from(degree.div_ceil(2)).ok()?)
        .map(|a| BigFloat::from_integer(a, floats.precision))
        .collect();
    let value = |a: &BigFloat| floats.divide(&first_sine(&ring, tape, &omega0, a)?, a);
    let values = amplitudes.iter().map(value).collect::<Option<Vec<_>>>()?;
    let squares: Vec<BigFloat> = amplitudes.iter().map(|a| floats.multiply(a, a)).collect();
    let condition = interpolated(&floats, &squares, &values)?;
    let square = attracting_root(floats, &condition)?;
    let selected = Selected {
        amplitude: square.sqrt(),
        unit_squared: floats.rational(&1.into())?,
        slope: slope(floats, &condition, &square),
        degree,
        symmetric,
    };
    let motion = Motion::LimitCycle(selected);
    let model =
        Model { tape: tape.clone(), values: vec![], omega0_squared, uses_velocity: true, motion, order };
    Some((model, floats.zero()))
}

fn at(floats: Floats, condition: &[BigFloat], s: &BigFloat) -> BigFloat {
    condition.iter().rev().fold(floats.zero(), |sum, m| floats.add(&floats.multiply(&sum, s), m))
}

/// Σ (2j + 1)·mⱼsʲ.
fn slope(floats: Floats, condition: &[BigFloat], s: &BigFloat) -> BigFloat {
    let weighted = condition.iter().zip((1..).step_by(2)).map(|(m, weight)| floats.times_integer(m, weight));
    at(floats, &weighted.collect::<Vec<_>>(), s)
}

/// The smallest s at which the condition changes from negative to positive, between 2⁻⁴⁰ and 2⁴⁰, by as many
/// bisections as the floats have bits.
fn attracting_root(floats: Floats, condition: &[BigFloat]) -> Option<BigFloat> {
    const STEPS_PER_OCTAVE: i64 = 32;
    let negative = |s: &BigFloat| at(floats, condition, s) < floats.zero();
    let ratio = floats.power(&floats.rational(&2.into())?, &Rational::new(1, STEPS_PER_OCTAVE)?)?;
    let mut low = floats.power(&floats.rational(&2.into())?, &Rational::from(-40))?;
    for _ in 0..80 * STEPS_PER_OCTAVE {
        let mut high = floats.multiply(&low, &ratio);
        if negative(&low) && !negative(&high) {
            for _ in 0..floats.precision {
                let middle = floats.add(&low, &high).halved();
                if negative(&middle) { low = middle } else { high = middle }
            }
            return Some(low);
        }
        low = high;
    }
    None
}
