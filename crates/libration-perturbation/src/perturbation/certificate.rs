//! Exact checks of a family's series by a method without harmonics.
//!
//! # Method
//! Up to order 15 everything is computed again in plain rationals, with √ω0² where the velocity enters and ω0 is irrational. Above that order, for
//! x″ = F(x), the relation between frequency and turning points is compared exactly with the reversion of the potential. For centres whose force
//! depends on the velocity the period as a function of the amplitude is compared with that along the orbits in the plane of states
//! (`conservative.rs`, `first_integral.rs`). Neither method knows harmonics of the motion in time. `Certificate` says which check was made. If two
//! methods disagree the result is an error.

use super::conservative::{displacement, period_ratio};
use super::first_integral::{self, PlaneOfStates};
use super::model::{Model, Motion};
use super::series_set::SeriesSet;
use super::shape::Shape;
use libration_numbers::internals::expression::Jet;
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::{composition, product};
use libration_numbers::{
    algebra::{Rational, Rationals, Ring},
    internals::algebra::{HarmonicSums, Quadratic, QuadraticField},
};

/// Returns `true` if frequency and turning points of x″ = F(x) agree exactly with the reversion of the potential: both turning
/// points have the same potential energy, and the period at that energy is T/T0. The series are in the variable of any gauge,
/// and compared by `same`. `None` when a number is not in the ring, or the check is interrupted.
pub fn agrees_with_the_potential<R: Ring>(
    ring: &R,
    model: &Model<R::Element>,
    set: &SeriesSet<R::Element>,
    same: impl Fn(&Vec<R::Element>, &Vec<R::Element>) -> bool,
    watch: &Watch<'_>,
) -> Option<bool> {
    let square = squared_energy_amplitude(ring, model, &set.x_max, watch)?;
    if !are_opposite(ring, model, set)
        && !same(&square, &squared_energy_amplitude(ring, model, &set.x_min, watch)?)
    {
        return Some(false);
    }
    let x = displacement(ring, &model.tape, model.values.clone(), &model.omega0_squared, model.order)?;
    let by_square: Vec<R::Element> = period_ratio(ring, &x)?.into_iter().step_by(2).collect();
    let length = set.frequency.len();
    let period = composition(ring, &by_square, &square, length, &|| watch.go_on().is_ok())?;
    let mut one = vec![ring.zero(); length];
    one[0] = ring.rational(&Rational::from(1))?;
    Some(same(&product(ring, &period, &set.frequency, length), &one))
}

/// Returns `true` if the turning points are opposite in an even potential, and so have the same energy.
fn are_opposite<R: Ring>(ring: &R, model: &Model<R::Element>, set: &SeriesSet<R::Element>) -> bool {
    let is_odd = matches!(model.motion, Motion::Centre { shape: Shape::Odd, .. });
    is_odd && set.x_max.iter().zip(&set.x_min).all(|(max, min)| ring.is_zero(&ring.add(max, min)))
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

/// Returns `true` if the period as a function of the amplitude agrees exactly with that along the curves of the first integral. `None` when
/// a number is not rational, or the check is cancelled.
pub(crate) fn agrees_with_the_first_integral(
    model: &Model<Rational>,
    set: &SeriesSet<Rational>,
    watch: &Watch<'_>,
) -> Option<bool> {
    let period = &set.of_amplitude.as_ref()?.period;
    if let Some(omega0) = model.omega0_squared.square_root() {
        let plane = plane_of_states(model, Rational::clone, omega0);
        return Some(first_integral::period_ratio(&Rationals, plane, period.len(), watch)? == *period);
    }
    let field = Fractions::with_root_of(&model.omega0_squared);
    let plane = plane_of_states(model, |value| field.ring.plain(value.clone()), field.ring.square_root()?);
    let ratio = first_integral::period_ratio(&field.ring, plane, period.len(), watch)?;
    Some(field.are(&ratio, period))
}

/// A model in the numbers of a ring that holds ω0.
fn plane_of_states<F: Ring>(
    model: &Model<Rational>,
    number: impl Fn(&Rational) -> F::Element,
    omega0: F::Element,
) -> PlaneOfStates<'_, F> {
    PlaneOfStates {
        tape: &model.tape,
        values: model.values.iter().map(&number).collect(),
        omega0_squared: number(&model.omega0_squared),
        omega0,
    }
}

/// Fractions, and one irrational square root.
struct Fractions {
    ring: QuadraticField<Rationals>,
}

impl Fractions {
    fn with_root_of(square: &Rational) -> Self {
        Self { ring: QuadraticField { base: Rationals, square: square.clone() } }
    }

    /// The square root of a fraction; `None` where it is neither a fraction nor the root adjoined to the field.
    fn root(&self, square: &Rational) -> Option<Quadratic<Rational>> {
        match square.square_root() {
            Some(root) => Some(self.ring.plain(root)),
            None if *square == self.ring.square => self.ring.square_root(),
            None => None,
        }
    }

    /// Returns `true` if the numbers are these fractions.
    fn are(&self, numbers: &[Quadratic<Rational>], fractions: &[Rational]) -> bool {
        let is = |(number, fraction): (&Quadratic<Rational>, &Rational)| {
            *number == self.ring.plain(fraction.clone())
        };
        numbers.len() == fractions.len() && numbers.iter().zip(fractions).all(is)
    }
}

/// Returns `true` if plain rational arithmetic, harmonic by harmonic, gives the same numbers; if ω0 or the unit of a limit cycle is not rational,
/// the arithmetic of fractions with its root. `None` if it is cancelled.
pub(crate) fn agrees_with_plain_rationals(
    model: &Model<Rational>,
    set: &SeriesSet<Rational>,
    watch: &Watch<'_>,
) -> Option<bool> {
    let Some(square) = model.irrational_roots().next() else {
        let ring = HarmonicSums { numbers: Rationals };
        let plain = model.series(&ring, |number| Some(number.clone()), Rational::square_root, watch)?;
        return (!watch.is_stopped()).then(|| plain.numbers() == set.numbers());
    };
    let field = Fractions::with_root_of(square);
    let ring = HarmonicSums { numbers: field.ring.clone() };
    let number = |number: &Rational| Some(field.ring.plain(number.clone()));
    let series = model.series(&ring, number, |square| field.root(square), watch)?;
    (!watch.is_stopped()).then(|| field.are(&series.numbers(), &set.numbers()))
}
