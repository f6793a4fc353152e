//! The normal form of a system about an equilibrium, with its terms, and the conversion of states to amplitudes.

use super::expansion::{DivisorRules, Expansion, LinearMotion, NormalFormObstacle, expand};
use super::linear_motion::{exactly, in_digits};
use super::polynomials::{Polynomial, Powers};
use super::{LARGEST_ORDER, NormalFormError};
use crate::normal_modes::{Behaviour, NormalModes};
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};
use libration_numbers::{
    algebra::{Complex, Ring},
    internals::algebra::{Quadratic, Tower},
};
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::Tape,
};

/// Normal form: the slow change of the modal amplitudes of a system, aⱼ′ = iωⱼaⱼ + Σ c·a^p·ā^q over the
/// resonant monomials. To first order the coordinates are xₑ + Re Σ aⱼφⱼ, with the shapes φⱼ of the modes.
///
/// # Accuracy
/// Exact to the order, with coefficients in square roots, if frequencies and shapes are exact; numerical computations use the same form in
/// floating-point numbers. Omitted terms are of the next order in the amplitudes.
///
/// # References
/// A. H. Nayfeh, *The Method of Normal Forms*, 2nd edition, Wiley 2011.
#[derive(Clone, Debug)]
pub struct NormalForm {
    /// The equilibrium and the modes.
    pub modes: NormalModes,
    /// Largest degree of the monomials.
    pub order: usize,
    /// The terms that remain: the changes of the frequencies with the amplitudes, and resonances.
    pub slow_terms: Vec<SlowTerm>,
    /// The smallest divisors of the removed terms, in ascending order: a small divisor restricts the amplitudes.
    pub small_divisors: Vec<Divisor>,
    /// The modal coordinate of each mode without the linear amplitude, in floating-point numbers.
    transform: Vec<Polynomial<Complex>>,
}

/// A term of the slow flow of a mode.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowTerm {
    /// The index of the mode whose amplitude the term changes.
    pub mode: usize,
    /// The powers of all amplitudes.
    pub powers: Vec<u8>,
    /// The powers of the conjugate amplitudes.
    pub conjugate_powers: Vec<u8>,
    /// The coefficient.
    pub coefficient: Complex,
    /// The coefficient with square roots, if it is known exactly.
    pub exact: Option<String>,
    /// The frequency of the monomial minus that of the mode, in rad/s: zero for an exact resonance.
    pub detuning: f64,
}

/// A removed monomial, with its divisor.
#[derive(Clone, Debug, PartialEq)]
pub struct Divisor {
    /// The index of the mode that it would change.
    pub mode: usize,
    /// The powers of all amplitudes.
    pub powers: Vec<u8>,
    /// The powers of the conjugate amplitudes.
    pub conjugate_powers: Vec<u8>,
    /// The frequency of the monomial minus that of the mode, in rad/s.
    pub divisor: f64,
}

impl SlowTerm {
    /// Returns `true` if the term exists whatever the frequencies: a power of |a|² times the amplitude itself, which changes the frequency.
    #[must_use]
    pub fn is_of_every_system(&self) -> bool {
        let one = |k: usize| u8::from(k == self.mode);
        (0..self.powers.len()).all(|k| self.powers[k] == self.conjugate_powers[k] + one(k))
    }
}

/// Number of the smallest divisors that are kept.
const TOLD: usize = 5;

impl NormalForm {
    /// The normal form about the equilibrium near a guess, up to an order in the amplitudes.
    /// Divisors smaller than `detuning` times the lowest frequency count as resonances.
    ///
    /// # Errors
    /// No equilibrium or modes, as for [`NormalModes::about`]; a mode that does not oscillate;
    /// an order outside 2 … [`LARGEST_ORDER`]; accelerations without power series. Cancellation.
    pub fn about(
        equation: &Equation,
        guess: &[f64],
        order: usize,
        detuning: f64,
        progress: &dyn Progress,
    ) -> Result<Self, NormalFormError> {
        let watch = &Watch::new(progress);
        if !(2..=LARGEST_ORDER).contains(&order) {
            return Err(NormalFormError::Order(order));
        }
        let modes = NormalModes::about(equation, guess, &watch.part())?;
        if let Some(number) = modes.modes.iter().position(|mode| mode.behaviour != Behaviour::Oscillating) {
            return Err(NormalFormError::NotOscillating(number + 1));
        }
        let formulas: Vec<_> = equation.accelerations().iter().collect();
        let plain = equation.variables().iter().map(|name| Symbol::plain(name));
        let symbols: Vec<Symbol> = plain.clone().chain(plain.map(|plain| plain.with_primes(1))).collect();
        let tape = Tape::new(&formulas, &symbols)?;
        let least = modes.modes.iter().map(|mode| mode.frequency()).fold(f64::INFINITY, f64::min);
        let smallest = detuning * least;
        watch.begin(Stage::Whole, Some(order));
        let exact = exactly(&modes).map(|linear| {
            let tower = linear.numbers.base.clone();
            let number = |x: &Vec<_>| tower.number(x);
            let judge = DivisorRules { number: &number, smallest };
            expand(&linear, &judge, &tape, order, &watch.part())
                .map(|series| NumericalExpansion::exact(&tower, series))
        });
        let expansion = match exact {
            Some(Ok(expansion)) => expansion,
            Some(Err(NormalFormObstacle::Interrupted(interrupted))) => return Err(interrupted.into()),
            Some(Err(NormalFormObstacle::NoSeries)) | None => {
                let linear: LinearMotion<_> = in_digits(&modes);
                // Zero up to rounding.
                let judge = DivisorRules { number: &|x: &f64| *x, smallest: smallest.max(1e-9 * least) };
                let expansion = expand(&linear, &judge, &tape, order, watch).map_err(failure)?;
                NumericalExpansion::in_digits(expansion)
            }
        };
        Ok(Self {
            modes,
            order,
            slow_terms: expansion.slow,
            small_divisors: expansion.divisors,
            transform: expansion.transform,
        })
    }

    /// The amplitudes of a state, coordinates and then velocities, by inverting the
    /// transform of this order; `None` if the state is too far from equilibrium for that.
    #[must_use]
    pub fn amplitudes_of(&self, state: &[f64]) -> Option<Vec<Complex>> {
        const STEPS: usize = 200;
        let modal = self.modal(state)?;
        let mut amplitudes = modal.clone();
        for _ in 0..STEPS {
            let beyond = self.beyond(&amplitudes);
            let next: Vec<Complex> = modal.iter().zip(&beyond).map(|(z, more)| *z - *more).collect();
            let change = next.iter().zip(&amplitudes).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max);
            let size = next.iter().map(|a| a.abs()).fold(0.0, f64::max);
            if !next.iter().all(|a| a.is_finite()) {
                return None;
            }
            amplitudes = next;
            // A few rounding errors.
            if change <= 1e-15 * size {
                return Some(amplitudes);
            }
        }
        None
    }

    /// The modal coordinates without the linear amplitudes.
    fn beyond(&self, amplitudes: &[Complex]) -> Vec<Complex> {
        self.transform.iter().map(|polynomial| value(polynomial, amplitudes)).collect()
    }

    /// z with x − xₑ = Re Σ zⱼφⱼ and v = Re Σ iωⱼzⱼφⱼ.
    fn modal(&self, state: &[f64]) -> Option<Vec<Complex>> {
        let n = self.modes.modes.len();
        let right: Vec<f64> =
            (0..2 * n).map(|i| state[i] - if i < n { self.modes.equilibrium[i] } else { 0.0 }).collect();
        let entry = |i: usize, j: usize| {
            let mode = &self.modes.modes[j % n];
            let part = mode.shape[i % n];
            let part = if i < n { part } else { part * Complex::new(0.0, mode.frequency()) };
            if j < n { part.re } else { -part.im }
        };
        let matrix: Vec<Vec<f64>> = (0..2 * n).map(|i| (0..2 * n).map(|j| entry(i, j)).collect()).collect();
        let solution = libration_numbers::internals::linear::solve(
            &libration_numbers::algebra::Doubles,
            |x| x.abs(),
            &matrix,
            &right,
        )?;
        Some((0..n).map(|j| Complex::new(solution[j], solution[j + n])).collect())
    }
}

fn failure(obstacle: NormalFormObstacle) -> NormalFormError {
    match obstacle {
        NormalFormObstacle::NoSeries => NormalFormError::NoSeries,
        NormalFormObstacle::Interrupted(interrupted) => interrupted.into(),
    }
}

/// The value of a polynomial in amplitudes and their conjugates.
fn value(polynomial: &Polynomial<Complex>, amplitudes: &[Complex]) -> Complex {
    let bars = amplitudes.iter().map(|a| Complex::new(a.re, -a.im));
    let all: Vec<Complex> = amplitudes.iter().copied().chain(bars).collect();
    let term = |(powers, value): (&Powers, &Complex)| {
        powers.iter().zip(&all).fold(*value, |product, (power, a)| product * a.powi(u32::from(*power)))
    };
    polynomial.iter().map(term).sum()
}

/// An expansion in floating-point numbers, with the texts of exact coefficients.
struct NumericalExpansion {
    slow: Vec<SlowTerm>,
    divisors: Vec<Divisor>,
    transform: Vec<Polynomial<Complex>>,
}

impl NumericalExpansion {
    fn exact(tower: &Tower, expansion: Expansion<Tower>) -> Self {
        let text = |z: &Quadratic<Vec<_>>| Some(complex_text(tower, &z.plain, &z.root));
        Self::new(expansion, &|x| tower.number(x), &text)
    }

    fn in_digits(expansion: Expansion<libration_numbers::algebra::Doubles>) -> Self {
        Self::new(expansion, &|x| *x, &|_| None)
    }

    fn new<N: Ring>(
        expansion: Expansion<N>,
        number: &dyn Fn(&N::Element) -> f64,
        text: &dyn Fn(&Quadratic<N::Element>) -> Option<String>,
    ) -> Self {
        let complex = |z: &Quadratic<N::Element>| Complex::new(number(&z.plain), number(&z.root));
        let halves = |powers: &Powers| {
            let (plain, bars) = powers.split_at(powers.len() / 2);
            (plain.to_vec(), bars.to_vec())
        };
        let mut slow = vec![];
        let mut divisors: Vec<Divisor> = vec![];
        for term in &expansion.divisors {
            let (powers, conjugate_powers) = halves(&term.powers);
            let (mode, divisor) = (term.mode, number(&term.divisor));
            match expansion.slow[mode].get(&term.powers) {
                Some(value) => slow.push(SlowTerm {
                    mode,
                    powers,
                    conjugate_powers,
                    coefficient: complex(value),
                    exact: text(value),
                    detuning: divisor,
                }),
                None => divisors.push(Divisor { mode, powers, conjugate_powers, divisor }),
            }
        }
        slow.put_in_order_by(|term| term.mode);
        divisors.put_in_order(|a, b| a.divisor.abs().total_cmp(&b.divisor.abs()));
        divisors.truncate(TOLD);
        let in_digits = |polynomial: &Polynomial<Quadratic<N::Element>>| {
            polynomial.iter().map(|(powers, value)| (powers.clone(), complex(value))).collect()
        };
        Self { slow, divisors, transform: expansion.transform.iter().map(in_digits).collect() }
    }
}

/// Text such as `-1/16*i` or `1/2 + sqrt(3)*i`.
fn complex_text(
    tower: &Tower,
    re: &Vec<libration_numbers::algebra::Rational>,
    im: &Vec<libration_numbers::algebra::Rational>,
) -> String {
    let imaginary = tower.text(im);
    let is_sum = imaginary.contains(" + ") || imaginary.contains(" - ");
    let imaginary = match imaginary.as_str() {
        "1" => "i".to_owned(),
        "-1" => "-i".to_owned(),
        _ if is_sum => format!("({imaginary})*i"),
        _ => format!("{imaginary}*i"),
    };
    match (tower.is_zero(re), tower.is_zero(im)) {
        (_, true) => tower.text(re),
        (true, false) => imaginary,
        (false, false) => format!("{} + {imaginary}", tower.text(re)),
    }
}
