//! A slow flow of the lowest order, or of the one after it, step by step, as formulas for derivations: each small term along the motion, with its
//! resonant part.

use super::criteria::ResponseCurve;
use super::equations::Found;
use super::letters::{Column, Letters, Sum};
use super::phase_sums::PhaseSum;
use super::result::{SymbolicSlowFlow, collected};
use super::scales::{Forced, Solved};
use super::second_order::EarlierOrder;
use super::setting::Setting;
use super::small_terms::{SmallTerm, Written, multiple};
use super::steady_state::MOST_TERMS;
use libration_numbers::algebra::Rational;
use libration_numbers::expression::Equation;

/// The formulas from which a slow flow of the lowest order follows, in ψ = (q/p)·W·t + φ, or ψ = ω0·t + φ without drive.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowFlowSteps {
    /// The result.
    pub flow: SymbolicSlowFlow,
    /// W − (p/q)·ω0; `None` without drive.
    pub detuning: Option<String>,
    /// Displacement and velocity of order zero, in W·t and with (p/q)·(ψ − φ) in its place.
    pub motion: [[String; 2]; 2],
    /// A drive of order zero; empty if there is none.
    pub drive: String,
    /// The small terms of this order, or of all orders if there is none before, x″ + ω0²·x = drive of order zero + Σ terms.
    pub terms: Vec<SmallTerm>,
    /// The order before, of which products of two act in this one; `None` if no products act.
    pub before: Option<EarlierOrder>,
    /// `true` if the slow flow is of its lowest order.
    pub has_one_order: bool,
    /// `true` if terms are small because the amplitude is.
    pub is_by_amplitude: bool,
    /// The derivatives of A′ and φ′ with respect to A and φ.
    pub partials: [[String; 2]; 2],
    /// ∂A′/∂A on the only limit cycle.
    pub cycle_exponent: Option<String>,
    /// The response curve, where the relation of steady states is known.
    pub curve: Option<ResponseSteps>,
    /// Amplitude and phase in time; `None` with a drive, or where they are no elementary functions.
    pub in_time: Option<AmplitudeInTime>,
}

/// The solution of a slow flow without drive: u = Aᵐ, with u′ = a·u + b.
#[derive(Clone, Debug, PartialEq)]
pub struct AmplitudeInTime {
    /// m.
    pub power: i64,
    /// a; `None` for zero.
    pub growth: Option<String>,
    /// b; `None` for zero.
    pub constant: Option<String>,
    /// b/a, where both are present and a is a product.
    pub ratio: Option<String>,
    /// The phase; `None` where it is not an elementary function of amplitude and time.
    pub phase: Option<PhaseInTime>,
}

/// A phase φ = Σ factor·Aᵏ + factor·ln A + factor·t + constant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhaseInTime {
    /// Powers k ≠ 0 with their factors.
    pub powers: Vec<(i64, String)>,
    /// The factor of ln A; `None` for zero.
    pub logarithm: Option<String>,
    /// The factor of t; `None` for zero.
    pub time: Option<String>,
}

/// Steps to the properties of a response curve.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseSteps {
    /// The factor of the square of the distance from the backbone, and the relation on the backbone.
    pub ridge: Option<[String; 2]>,
    /// ∂/∂A of the relation, as a product, and the sum without it.
    pub slope: [String; 2],
    /// b and δ where the relation is κ·A²·((σ − b·A²)² + δ²) = D.
    pub cubic: Option<[String; 2]>,
}

/// The steps if the products of two small terms are of a higher order, or of this one and all of terms of half this order. The slow flow begins at
/// the lowest order.
pub(super) fn steps(
    setting: &Setting,
    forced: &Forced<'_>,
    properties: &Found,
    solved: &Solved,
    (equation, [lowest, order]): (&Equation, [i64; 2]),
) -> Option<SlowFlowSteps> {
    let letters = forced.letters;
    let flow = collected(setting, forced, properties, solved, order);
    let detuning = letters.lowest_order(&forced.detuning);
    let first = forced.terms.iter().flatten().map(|term| term.order).min()?;
    if detuning.is_some_and(|detuning| detuning != lowest) {
        return None;
    }
    let written = Written { setting, forced, variable: &equation.variables()[0], is_at_phase: false };
    // Products of two small terms are of twice the first order at least.
    let before = match order < 2 * first {
        true => None,
        false => Some(EarlierOrder::new(&written, solved, [first, lowest, order])?),
    };
    let own = if before.is_some() { order..=order } else { first..=order };
    let unperturbed = letters.of_order(&solved.displacements[0], 0);
    let motion = [unperturbed.clone(), forced.velocity(&unperturbed)];
    let is_one_order = lowest == order;
    let steady = is_one_order.then_some(&flow);
    Some(SlowFlowSteps {
        detuning: setting.drive.as_ref().map(|_| letters.text(&forced.detuning)),
        motion: written.both(&motion),
        drive: written.waves(&forced.drives[0]),
        terms: written.terms(solved, own),
        has_one_order: is_one_order,
        is_by_amplitude: properties.acting_order.is_some(),
        partials: partials(letters, &flow.sums.rates, written.phase()),
        cycle_exponent: steady.and_then(|flow| cycle_exponent(letters, forced, flow, order)),
        curve: steady.and_then(|flow| curve(letters, forced, flow)),
        in_time: is_one_order.then(|| in_time(letters, &flow.sums.rates)).flatten(),
        before,
        flow,
    })
}

/// The derivatives of A′ and φ′ with respect to A and φ.
fn partials(letters: &Letters, [growth, turning]: &[PhaseSum; 2], phase: &str) -> [[String; 2]; 2] {
    let turning = turning.times(letters, &letters.power(Column::Amplitude, -1));
    [growth, &turning].map(|rate| {
        let (mut by_amplitude, mut by_phase) = (rate.clone(), rate.clone());
        for parts in by_amplitude.harmonics.values_mut() {
            *parts = parts.each_ref().map(|part| letters.derivative(part, Column::Amplitude));
        }
        for (k, parts) in &mut by_phase.harmonics {
            let [cosine, sine] = parts.each_ref().map(|part| letters.scaled(part, &Rational::from(*k)));
            *parts = [sine, letters.scaled(&cosine, &Rational::from(-1))];
        }
        [by_amplitude, by_phase].map(|rate| rate.text(letters, |k| multiple(k, phase)))
    })
}

fn cycle_exponent(
    letters: &Letters,
    forced: &Forced<'_>,
    flow: &SymbolicSlowFlow,
    order: i64,
) -> Option<String> {
    flow.steady_state.cycle_amplitude.as_ref()?;
    let steady = &flow.sums.steady;
    let curve =
        ResponseCurve { letters, relation: steady.relation.as_ref()?, order: 0, omega0: &forced.omega0 };
    let (power, root) = curve.only_amplitude()?;
    let exponent = curve.at_power(steady.trace.as_ref()?, &power, root, order)?;
    Some(letters.text(&exponent)).filter(|text| text != "0")
}

/// Formulas of the response curve where the relation is known.
fn curve(letters: &Letters, forced: &Forced<'_>, flow: &SymbolicSlowFlow) -> Option<ResponseSteps> {
    let relation = flow.sums.steady.relation.as_ref().filter(|_| flow.resonance.is_some())?;
    flow.steady_state.relation.as_ref()?;
    let curve = ResponseCurve { letters, relation, order: 0, omega0: &forced.omega0 };
    let curvature = letters.coefficient(relation, Column::Detuning, 2);
    let highest = letters.exponents(relation, Column::Detuning).last().copied();
    let ridge = curve.backbone().filter(|_| highest == Some(2) && flow.steady_state.backbone.is_some());
    let slope = letters.derivative(relation, Column::Amplitude);
    let folds = curve.folds()?;
    let first = |sum: &Sum| {
        let (powers, _) = sum.half_powers().next()?;
        Some(letters.ring.term(powers.clone(), Rational::from(1)))
    };
    let common = letters.times(&first(&slope)?, &letters.inverse(&first(&folds)?)?);
    let cubic = curve.cubic().filter(|_| flow.steady_state.critical_drive.is_some());
    let texts = |parts: [Sum; 2]| parts.map(|sum| letters.text(&sum));
    (slope.half_powers().count() <= MOST_TERMS).then(|| ResponseSteps {
        ridge: ridge.map(|backbone| texts([curvature, curve.on_ridge(&backbone)])),
        slope: texts([common, folds]),
        cubic: cubic.map(texts),
    })
}

/// The solution, where A′ has at most one power of A besides the first.
fn in_time(letters: &Letters, [growth, turning]: &[PhaseSum; 2]) -> Option<AmplitudeInTime> {
    let rates = powers(letters, growth)?;
    let (linear, others): (Vec<_>, Vec<_>) = rates.into_iter().partition(|(power, _)| *power == 1);
    let m = match others.as_slice() {
        [] => 1,
        [(power, _)] => 1 - power,
        _ => return None,
    };
    let factor = |terms: Vec<(i64, Sum)>| {
        terms.into_iter().next().map(|(_, sum)| letters.scaled(&sum, &Rational::from(m)))
    };
    let (a, b) = (factor(linear), factor(others));
    let ratio = match (&a, &b) {
        (Some(a), Some(b)) => letters.inverse(a).map(|inverse| letters.times(b, &inverse)),
        _ => None,
    };
    let turning = powers(letters, &turning.times(letters, &letters.power(Column::Amplitude, -1)))?;
    let phase =
        turning.iter().map(|(n, rate)| phase_in_time(letters, (*n, rate), m, [a.as_ref(), b.as_ref()]));
    let phase = phase.collect::<Option<Vec<PhaseInTime>>>().and_then(joined);
    let text = |sum: Option<Sum>| sum.map(|sum| letters.text(&sum));
    Some(AmplitudeInTime { power: m, growth: text(a), constant: text(b), ratio: text(ratio), phase })
}

/// Powers of A with their factors; `None` if the rate depends on the phase.
fn powers(letters: &Letters, rate: &PhaseSum) -> Option<Vec<(i64, Sum)>> {
    let zero = [letters.zero(), letters.zero()];
    let [rate, _] = match rate.harmonics.len() {
        0 => &zero,
        1 => rate.harmonics.get(&0)?,
        _ => return None,
    };
    let term = |power: i64| (power, letters.coefficient(rate, Column::Amplitude, power));
    Some(letters.exponents(rate, Column::Amplitude).into_iter().map(term).collect())
}

/// ∫ rate·Aⁿ dt along u = Aᵐ, u′ = a·u + b.
fn phase_in_time(
    letters: &Letters,
    (n, rate): (i64, &Sum),
    m: i64,
    [a, b]: [Option<&Sum>; 2],
) -> Option<PhaseInTime> {
    let text = |sum: &Sum| Some(letters.text(sum));
    let over = |by: &Sum, factor: i64| {
        Some(letters.scaled(&letters.times(rate, &letters.inverse(by)?), &Rational::from(factor)))
    };
    let power = |k: i64, factor: &Sum| {
        let part = letters.scaled(factor, &Rational::new(1, k)?);
        Some(PhaseInTime { powers: vec![(k, letters.text(&part))], ..PhaseInTime::default() })
    };
    match (a, b) {
        _ if n == 0 => Some(PhaseInTime { time: text(rate), ..PhaseInTime::default() }),
        (None, None) => None,
        (Some(a), None) => power(n, &over(a, m)?),
        (None, Some(b)) if n + m != 0 => power(n + m, &over(b, m)?),
        (None, Some(b)) => Some(PhaseInTime { logarithm: text(&over(b, m)?), ..PhaseInTime::default() }),
        (Some(a), Some(b)) if n + m == 0 => {
            let time = letters.scaled(&letters.times(&over(b, 1)?, a), &Rational::from(-1));
            Some(PhaseInTime { logarithm: text(&over(b, m)?), time: text(&time), ..PhaseInTime::default() })
        }
        _ => None,
    }
}

/// The sum of phases with different powers, of which at most one has a logarithm, and at most one the time.
fn joined(parts: Vec<PhaseInTime>) -> Option<PhaseInTime> {
    let mut sum = PhaseInTime::default();
    for part in parts {
        let is_twice = |a: &Option<String>, b: &Option<String>| a.is_some() && b.is_some();
        if is_twice(&sum.logarithm, &part.logarithm) || is_twice(&sum.time, &part.time) {
            return None;
        }
        sum.powers.extend(part.powers);
        sum.logarithm = sum.logarithm.or(part.logarithm);
        sum.time = sum.time.or(part.time);
    }
    Some(sum)
}
