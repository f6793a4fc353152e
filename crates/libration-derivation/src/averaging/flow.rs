//! The motion, A′ and ψ′, by powers of the amplitude and of the small parameter, with the products of lower results from which each comes.

use std::collections::BTreeMap;

use super::super::check::{DerivationError, FlowTerms};
use super::super::phase::{PhaseFunction, PiNumber, Wave};
use super::question::AveragingQuestion;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::internals::progress::Watch;

/// The powers of the amplitude and of the small parameter.
pub(crate) type PowerPair = (usize, usize);

/// The slow flow of an oscillation under a weak force, up to some power of amplitude and parameter.
#[derive(Debug)]
pub struct Flow {
    /// The nonzero xₙⱼ.
    pub motion: BTreeMap<PowerPair, PhaseFunction>,
    /// The nonzero coefficients vₙⱼ of the velocity.
    pub(crate) velocity: BTreeMap<PowerPair, PhaseFunction>,
    /// The nonzero aₙⱼ.
    pub growth: BTreeMap<PowerPair, PiNumber>,
    /// The nonzero wₙⱼ; w₀₀ = ω0.
    pub frequency: BTreeMap<PowerPair, PiNumber>,
    /// Derivation of each power, in the order of computation.
    pub(crate) orders: Vec<FlowOrder>,
}

/// One power of the amplitude and of the small parameter.
#[derive(Debug)]
pub(crate) struct FlowOrder {
    pub(crate) powers: PowerPair,
    /// The parts of the equation of motion with their contributions to the right side.
    pub(crate) parts: Vec<Contribution>,
    /// The sum of the contributions.
    pub(crate) forcing: PhaseFunction,
    pub(crate) growth: PiNumber,
    pub(crate) frequency: PiNumber,
    pub(crate) motion: PhaseFunction,
}

/// The contribution of a part of the equation of motion to its right side.
#[derive(Debug)]
pub(crate) struct Contribution {
    pub(crate) part: EquationPart,
    /// The contribution as products of known functions.
    pub(crate) products: Polynomial,
    pub(crate) value: PhaseFunction,
}

/// A part of the equation of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EquationPart {
    /// The square of ψ′ times the second derivative with respect to the phase.
    Fast,
    /// Twice A′ψ′ times the mixed derivative.
    Mixed,
    /// The square of A′ times the second derivative with respect to the amplitude.
    Slow,
    /// A′ times the derivative of ψ′ with respect to the amplitude.
    Detuning,
    /// A′ times the derivative of A′ with respect to the amplitude.
    Drift,
    /// The term of the force with this index.
    Force(usize),
}

/// Series in the amplitude and the small parameter whose coefficients are products of names.
type Named = BTreeMap<PowerPair, Polynomial>;

impl Flow {
    /// Computes all requested powers.
    pub fn new(question: &AveragingQuestion, watch: &Watch<'_>) -> Result<Self, DerivationError> {
        let mut flow = Self {
            motion: alone((1, 0), PhaseFunction::cosine()),
            velocity: BTreeMap::new(),
            growth: BTreeMap::new(),
            frequency: alone((0, 0), question.omega0().clone().into()),
            orders: Vec::new(),
        };
        let omega0 = PiNumber::from(question.omega0().clone());
        flow.velocity.insert((1, 0), PhaseFunction::sine().scaled(&omega0.negated()));
        for powers in places(question) {
            watch.go_on()?;
            if powers != (1, 0) {
                flow.extend(question, powers)?;
            }
        }
        Ok(flow)
    }

    fn extend(&mut self, question: &AveragingQuestion, powers: PowerPair) -> Result<(), DerivationError> {
        let parts = self.parts(&question.flow, powers);
        let forcing = parts.iter().fold(PhaseFunction::default(), |sum, part| sum.plus(&part.value));
        let omega0 = question.omega0();
        let (growth, frequency) = secular(question, &forcing).ok_or(DerivationError::NoPolynomial)?;
        let wave = secular_wave(omega0, &growth, &frequency);
        let square = omega0.clone() * omega0.clone();
        let scale = Rational::from(1).checked_div(&square).ok_or(DerivationError::NoPolynomial)?;
        let forced = forcing.plus(&wave).scaled(&scale.into());
        let begun = forced.begun_at_rest();
        // The velocity vanishes at ψ = 0.
        let slow = self.slow_velocity(powers).plus(&PhaseFunction::cosine().scaled(&growth));
        let slope =
            slow.at_start().scaled(&Rational::from(-1).checked_div(omega0).unwrap_or_else(|| 0.into()));
        let motion = begun.plus(&PhaseFunction::sine().scaled(&slope));
        if !question.flow.kinked && !motion.is_periodic() {
            return Err(DerivationError::NoPolynomial);
        }
        let turn = PhaseFunction::sine().scaled(&frequency.negated());
        let fast = motion.slope().scaled(&omega0.clone().into());
        let velocity = slow.plus(&turn).plus(&fast);
        let (n, j) = powers;
        insert_number(&mut self.growth, powers, &growth);
        match n.checked_sub(1) {
            Some(below) => insert_number(&mut self.frequency, (below, j), &frequency),
            None if frequency.is_zero() => {}
            None => return Err(DerivationError::NoPolynomial),
        }
        insert(&mut self.motion, powers, &motion);
        insert(&mut self.velocity, powers, &velocity);
        self.orders.push(FlowOrder { powers, parts, forcing, growth, frequency, motion });
        Ok(())
    }

    /// Returns `true` if the order contributes nothing: no parts, no motion and no rates.
    pub(crate) fn is_trivial(order: &FlowOrder) -> bool {
        order.parts.is_empty()
            && order.motion.is_zero()
            && order.growth.is_zero()
            && order.frequency.is_zero()
    }

    /// The known part of the velocity, without the newest coefficients.
    fn slow_velocity(&self, powers: PowerPair) -> PhaseFunction {
        let (n, j) = powers;
        let mut sum = PhaseFunction::default();
        for ((m, i), x) in &self.motion {
            let Some(rest) = j.checked_sub(*i) else { continue };
            if let Some(frequency) = n.checked_sub(*m).and_then(|below| self.frequency.get(&(below, rest))) {
                sum = sum.plus(&x.slope().scaled(frequency));
            }
            if let Some(growth) = (n + 1).checked_sub(*m).and_then(|below| self.growth.get(&(below, rest))) {
                let degree = Rational::from(i64::try_from(*m).unwrap_or(i64::MAX));
                sum = sum.plus(&x.scaled(&growth.scaled(&degree)));
            }
        }
        sum
    }

    /// The known contributions to the right side at these powers, part by part.
    fn parts(&self, flow: &FlowTerms, pair: PowerPair) -> Vec<Contribution> {
        let x = names(&self.motion, "x");
        let [slope, curvature] = ["x'", "x''"].map(|letters| names(&self.motion, letters));
        let v = names(&self.velocity, "v");
        let growth = names(&self.growth, "a");
        let mut frequency = names(&self.frequency, "w");
        frequency.insert((0, 0), Polynomial::constant(flow.omega0.clone()));
        let one = alone((0, 0), Polynomial::constant(Rational::from(1)));
        let product = |factors: &[&Named]| {
            let whole = factors.iter().fold(one.clone(), |whole, factor| times(&whole, factor, pair));
            whole.get(&pair).cloned().unwrap_or_default()
        };
        let by_amplitude = |series: &Named| derivative(series);
        let mut parts = vec![
            (EquationPart::Fast, product(&[&frequency, &frequency, &curvature])),
            (
                EquationPart::Mixed,
                product(&[&growth, &frequency, &by_amplitude(&slope)]).scaled(&Rational::from(2)),
            ),
            (EquationPart::Slow, product(&[&growth, &growth, &by_amplitude(&by_amplitude(&x))])),
            (EquationPart::Detuning, product(&[&growth, &by_amplitude(&frequency), &slope])),
            (EquationPart::Drift, product(&[&growth, &by_amplitude(&growth), &by_amplitude(&x)])),
        ];
        for (number, term) in flow.terms.iter().enumerate() {
            let shift = alone((0, term.parameter), Polynomial::constant(term.factor.clone()));
            let powers = std::iter::repeat_n(&x, term.position).chain(std::iter::repeat_n(&v, term.velocity));
            let factors: Vec<&Named> = [&shift].into_iter().chain(powers).collect();
            parts.push((EquationPart::Force(number), product(&factors)));
        }
        let moved = parts.into_iter().map(|(part, products)| {
            let products = -products;
            let value = self.value(&products);
            Contribution { part, products, value }
        });
        moved.filter(|moved| !moved.products.is_zero()).collect()
    }

    /// The value of products of names.
    fn value(&self, products: &Polynomial) -> PhaseFunction {
        let one = PhaseFunction::constant(Rational::from(1).into());
        products.terms().fold(PhaseFunction::default(), |sum, (monomial, factor)| {
            let product = monomial.factors().iter().fold(one.clone(), |product, (variable, exponent)| {
                let value = self.named(variable);
                (0..*exponent).fold(product, |product, _| product.times(&value))
            });
            sum.plus(&product.scaled(&factor.clone().into()))
        })
    }

    fn named(&self, variable: &Variable) -> PhaseFunction {
        let index = usize::try_from(variable.index().unwrap_or(0)).unwrap_or(usize::MAX);
        let powers = (index / 10, index % 10);
        let function =
            |map: &BTreeMap<PowerPair, PhaseFunction>| map.get(&powers).cloned().unwrap_or_default();
        let number = |map: &BTreeMap<PowerPair, PiNumber>| {
            PhaseFunction::constant(map.get(&powers).cloned().unwrap_or_default())
        };
        match variable.letters() {
            "x" => function(&self.motion),
            "x'" => function(&self.motion).slope(),
            "x''" => function(&self.motion).slope().slope(),
            "v" => function(&self.velocity),
            "a" => number(&self.growth),
            _ => number(&self.frequency),
        }
    }
}

/// All pairs of powers, in an order in which each needs only earlier ones.
fn places(question: &AveragingQuestion) -> Vec<PowerPair> {
    let lift = question.flow.lift;
    let all = (0..=question.order).flat_map(|level| {
        (0..=question.parameter_order).filter_map(move |j| Some((level.checked_sub(lift * j)?, j)))
    });
    all.filter(|powers| *powers != (0, 0)).filter(|(n, j)| *n > 0 || (lift == 1 && *j > 0)).collect()
}

/// The coefficients of A′ and ψ′ for which the forced motion has no secular part: the first harmonic of the
/// total force on the right vanishes, or, if only a half swing is known, its projections on both waves.
fn secular(question: &AveragingQuestion, forcing: &PhaseFunction) -> Option<(PiNumber, PiNumber)> {
    let half = Rational::from(-1).checked_div(&(Rational::from(2) * question.omega0().clone()))?;
    let part = |wave: Wave| match question.flow.kinked {
        false => forcing.coefficient(0, 1, wave),
        true => {
            let wave = PhaseFunction::term(0, 1, wave, Rational::from(1).into());
            let whole = forcing.times(&wave).integral().at_half_turns(1);
            whole.scaled(&Rational::from(2)).times_power_of_pi(-1)
        }
    };
    Some((part(Wave::Sine).scaled(&half), part(Wave::Cosine).scaled(&half)))
}

/// 2ω0(w·cos ψ + a·sin ψ).
pub(crate) fn secular_wave(omega0: &Rational, growth: &PiNumber, frequency: &PiNumber) -> PhaseFunction {
    let twice = Rational::from(2) * omega0.clone();
    let cosine = PhaseFunction::cosine().scaled(&frequency.scaled(&twice));
    cosine.plus(&PhaseFunction::sine().scaled(&growth.scaled(&twice)))
}

/// The variable that denotes a coefficient.
pub(crate) fn variable(letters: &str, (n, j): PowerPair) -> Variable {
    Variable::indexed(letters, u32::try_from(10 * n + j).unwrap_or(u32::MAX))
}

/// A map with one entry.
fn alone<V>(powers: PowerPair, value: V) -> BTreeMap<PowerPair, V> {
    let mut map = BTreeMap::new();
    map.insert(powers, value);
    map
}

fn names<V>(coefficients: &BTreeMap<PowerPair, V>, letters: &str) -> Named {
    let mut names = Named::new();
    for powers in coefficients.keys() {
        names.insert(*powers, Polynomial::variable(variable(letters, *powers)));
    }
    names
}

/// The derivative with respect to the amplitude.
fn derivative(series: &Named) -> Named {
    let mut lowered = Named::new();
    for ((n, j), value) in series.iter().filter(|((n, _), _)| *n > 0) {
        let degree = Rational::from(i64::try_from(*n).unwrap_or(i64::MAX));
        lowered.insert((n - 1, *j), value.scaled(&degree));
    }
    lowered
}

/// The product, up to these powers.
fn times(a: &Named, b: &Named, limit: PowerPair) -> Named {
    let mut product = Named::new();
    for ((n, j), left) in a {
        for ((m, i), right) in b.iter().filter(|((m, i), _)| n + m <= limit.0 && j + i <= limit.1) {
            let entry = product.entry((n + m, j + i)).or_default();
            *entry = std::mem::take(entry) + left.clone() * right.clone();
        }
    }
    product
}

fn insert(map: &mut BTreeMap<PowerPair, PhaseFunction>, powers: PowerPair, value: &PhaseFunction) {
    if !value.is_zero() {
        map.insert(powers, value.clone());
    }
}

fn insert_number(map: &mut BTreeMap<PowerPair, PiNumber>, powers: PowerPair, value: &PiNumber) {
    if !value.is_zero() {
        map.insert(powers, value.clone());
    }
}
