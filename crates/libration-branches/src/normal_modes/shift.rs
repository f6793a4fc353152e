//! Change of the frequency of a mode with its amplitude.

use super::equilibrium::Equilibrium;
use super::lindstedt::{Fundamental, ModeObstacle, Third, ZeroRules, third_order};
use super::linearisation::symbols;
use super::mode::{Behaviour, Mode, Shift};
use super::no_shift::ShiftError;
use libration_numbers::{
    algebra::{Doubles, Rational, Rationals, Ring, Surd},
    internals::algebra::{Quadratic, QuadraticField},
};
use libration_numbers::{expression::Equation, internals::expression::Tape};

/// The shift of one of the modes; exact if its frequency, its shape and the coefficients of the forces are.
pub(super) fn shift(
    equation: &Equation,
    rest: &Equilibrium,
    modes: &[Mode],
    number: usize,
) -> Result<Shift, ShiftError> {
    let mode = &modes[number];
    if mode.behaviour != Behaviour::Oscillating {
        return Err(ShiftError::NotOscillating);
    }
    if mode.multiplicity > 1 {
        return Err(ShiftError::Degenerate);
    }
    let formulas: Vec<_> = equation.accelerations().iter().collect();
    let tape = Tape::new(&formulas, &symbols(equation)).map_err(|_| ShiftError::NotSmooth)?;
    let resonant = resonant(modes, number);
    let exact = rest.exact.as_ref().and_then(|rest| Exact::new(mode, rest));
    match exact.map(|exact| exact.shift(&tape, &resonant)) {
        Some(Ok(shift)) => Ok(shift),
        Some(Err(reason)) if reason != ShiftError::NotSmooth => Err(reason),
        _ => in_digits(&tape, rest, mode, resonant),
    }
}

/// The multiples of the mode's frequency that are frequencies of free oscillations.
fn resonant(modes: &[Mode], number: usize) -> Vec<usize> {
    let exact =
        modes[number].resonances.iter().filter(|resonance| resonance.exact && resonance.other_is_faster);
    let multiples = exact.filter_map(|resonance| usize::try_from(resonance.multiple).ok());
    let free = modes.iter().any(|mode| mode.behaviour == Behaviour::Free);
    multiples.chain(free.then_some(0)).collect()
}

fn in_digits(
    tape: &Tape,
    rest: &Equilibrium,
    mode: &Mode,
    resonant: Vec<usize>,
) -> Result<Shift, ShiftError> {
    /// Fraction of the largest number that is zero: third derivatives lose some digits where terms cancel.
    const ROUNDING: f64 = 1e-11;
    let fundamental = Fundamental {
        frequency: mode.frequency(),
        cosine: mode.shape.iter().map(|part| part.re).collect(),
        sine: mode.shape.iter().map(|part| -part.im).collect(),
        leading: mode.leading(),
    };
    let judge = ZeroRules { size: &|x: &f64| x.abs(), rounding: ROUNDING, resonant };
    let Third { frequency, growth } = third_order(&Doubles, &judge, tape, &rest.at, &fundamental)?;
    if !(frequency.is_finite() && growth.is_finite()) {
        return Err(ShiftError::NotSmooth);
    }
    // Rounding errors of the coefficients, a hundred times the fraction that counts as zero.
    if growth.abs() > 1e-9 * frequency.abs().max(growth.abs()) {
        return Err(ShiftError::NotPeriodic { grows: growth > 0.0 });
    }
    Ok(Shift { coefficient: frequency * mode.frequency(), relative: None })
}

/// A mode in fractions and square roots.
struct Exact<'a> {
    square: &'a Surd,
    shape: &'a [Surd],
    leading: usize,
    rest: &'a [Rational],
    /// The radicand of all surds.
    radicand: Rational,
}

impl<'a> Exact<'a> {
    fn new(mode: &'a Mode, rest: &'a [Rational]) -> Option<Self> {
        let (square, shape) = (mode.frequency_squared.as_ref()?, mode.exact_shape.as_ref()?);
        let radicand = square.radicand().clone();
        let fits = |part: &Surd| part.to_rational().is_some() || *part.radicand() == radicand;
        shape.iter().all(fits).then_some(Self { square, shape, leading: mode.leading(), rest, radicand })
    }

    /// The shift, in the smallest field that contains ω.
    fn shift(&self, tape: &Tape, resonant: &[usize]) -> Result<Shift, ShiftError> {
        let base = QuadraticField { base: Rationals, square: self.radicand.clone() };
        let element = |surd: &Surd| Quadratic { plain: surd.plain().clone(), root: surd.root().clone() };
        let value = |x: &Quadratic<Rational>| self.surd(x).to_f64();
        if let Some(root) = self.square.to_rational().and_then(Rational::square_root) {
            let judge =
                ZeroRules { size: &|x: &_| value(x).abs(), rounding: 0.0, resonant: resonant.to_vec() };
            let third = self.third(&base, &judge, tape, element, base.plain(root))?;
            return self.answer(&third.frequency, value(&third.growth));
        }
        let field = QuadraticField { base, square: element(self.square) };
        let omega = self.square.to_f64().sqrt();
        let size = |x: &Quadratic<Quadratic<Rational>>| (value(&x.plain) + value(&x.root) * omega).abs();
        let judge = ZeroRules { size: &size, rounding: 0.0, resonant: resonant.to_vec() };
        let root = field.square_root().ok_or(ShiftError::NotSmooth)?;
        let third = self.third(&field, &judge, tape, |surd| field.plain(element(surd)), root)?;
        let growth = value(&third.growth.plain) + value(&third.growth.root) * omega;
        if !field.base.is_zero(&third.frequency.root) {
            return Err(ShiftError::NotSmooth);
        }
        self.answer(&third.frequency.plain, growth)
    }

    fn third<N: Ring + Clone>(
        &self,
        field: &N,
        judge: &ZeroRules<'_, N::Element>,
        tape: &Tape,
        element: impl Fn(&Surd) -> N::Element,
        frequency: N::Element,
    ) -> Result<Third<N::Element>, ModeObstacle> {
        let cosine: Vec<N::Element> = self.shape.iter().map(&element).collect();
        let sine = cosine.iter().map(|_| field.zero()).collect();
        let rest: Vec<N::Element> = self.rest.iter().map(|x| element(&Surd::from(x.clone()))).collect();
        third_order(
            field,
            judge,
            tape,
            &rest,
            &Fundamental { frequency, cosine, sine, leading: self.leading },
        )
    }

    fn surd(&self, x: &Quadratic<Rational>) -> Surd {
        Surd::new(x.plain.clone(), x.root.clone(), self.radicand.clone())
    }

    fn answer(&self, relative: &Quadratic<Rational>, growth: f64) -> Result<Shift, ShiftError> {
        if growth != 0.0 {
            return Err(ShiftError::NotPeriodic { grows: growth > 0.0 });
        }
        let relative = self.surd(relative);
        let coefficient = relative.to_f64() * self.square.to_f64().sqrt();
        Ok(Shift { coefficient, relative: Some(relative) })
    }
}
