//! The first approximation of a slow flow step by step, as formulas for derivations: each small term along the motion of order zero, with its
//! resonant part.

use super::criteria::ResponseCurve;
use super::equations::Found;
use super::force::DriveFrequency;
use super::letters::{Column, Letters, Sum};
use super::phase_sums::{PhaseSum, append, append_term, real_and_imaginary};
use super::result::{SymbolicSlowFlow, angle, collected, lowest_order, polar, rates};
use super::scales::{Forced, SmallForceTerm, Solved};
use super::setting::Setting;
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
    /// The small terms, x″ + ω0²·x = drive of order zero + Σ terms.
    pub terms: Vec<SmallTerm>,
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

/// A small term of the equation of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct SmallTerm {
    /// The term in displacement and velocity, in W·t and with (p/q)·(ψ − φ) in its place.
    pub force: [String; 2],
    /// The term as a sum of waves; `None` with abs or sign, whose harmonics do not end.
    pub waves: Option<String>,
    /// Waves of the drive whose frequency is that of ψ; empty if there are none.
    pub turning: String,
    /// Factors of cos ψ and sin ψ in the resonant part.
    pub resonant: [String; 2],
    /// The same of the waves of the drive alone.
    pub turned: [String; 2],
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

/// The steps if all terms that act in the lowest order of the slow flow are of this order.
pub(super) fn steps(
    setting: &Setting,
    forced: &Forced<'_>,
    properties: &Found,
    solved: &Solved,
    (equation, order): (&Equation, i64),
) -> Option<SlowFlowSteps> {
    let letters = forced.letters;
    let flow = collected(setting, forced, properties, solved, order);
    lowest_order(letters, &flow.sums.rates)?;
    let detuning = letters.lowest_order(&forced.detuning);
    let orders = forced.terms.iter().flatten().map(|term| term.order).chain(detuning);
    let is_higher = setting.highest_order().is_some_and(|highest| highest > order);
    if is_higher || orders.min().is_some_and(|lowest| lowest < order) {
        return None;
    }
    let written = Written { setting, forced, variable: &equation.variables()[0], is_at_phase: false };
    let acting = forced.terms[0].iter().filter(|term| term.order == order);
    let terms = acting.map(|term| written.term(solved, term)).collect();
    let unperturbed = letters.of_order(&solved.displacements[0], 0);
    let motion = [unperturbed.clone(), forced.velocity(&unperturbed)];
    let at_phase = Written { is_at_phase: true, ..written };
    Some(SlowFlowSteps {
        detuning: setting.drive.as_ref().map(|_| letters.text(&forced.detuning)),
        motion: [&written, &at_phase].map(|written| motion.each_ref().map(|sum| written.waves(sum))),
        drive: written.waves(&forced.drives[0]),
        terms,
        is_by_amplitude: properties.acting_order.is_some(),
        partials: partials(letters, &flow.sums.rates, written.phase()),
        cycle_exponent: cycle_exponent(letters, forced, &flow, order),
        curve: curve(letters, forced, &flow),
        in_time: in_time(letters, &flow.sums.rates),
        flow,
    })
}

/// Formulas in the names of an equation.
#[derive(Clone, Copy)]
struct Written<'a> {
    setting: &'a Setting,
    forced: &'a Forced<'a>,
    variable: &'a str,
    /// `true` for (p/q)·(ψ − φ) in place of W·t.
    is_at_phase: bool,
}

impl Written<'_> {
    fn term(&self, solved: &Solved, term: &SmallForceTerm) -> SmallTerm {
        let (forced, letters) = (self.forced, self.forced.letters);
        let value = forced.along(&solved.displacements[0], term);
        let text = |sum: &PhaseSum| sum.text(letters, |k| multiple(k, self.phase()));
        let minus = letters.number(Rational::from(-1));
        let factors = |waves: &Sum| {
            let coefficient = letters.coefficient(waves, Column::Wave, forced.harmonics[0]);
            let [real, imaginary] = rates(letters, &coefficient);
            [text(&real), text(&imaginary.times(letters, &minus))]
        };
        let wave = letters.index(Column::Wave);
        let resonant = letters.part(&value, |powers| powers[wave].abs() == 2 * forced.harmonics[0]);
        let is_turning = |powers: &[i64]| self.wave_numbers(powers)[1] != 0;
        let turning = letters.part(&resonant, is_turning);
        SmallTerm {
            force: [false, true].map(|is_at_phase| Self { is_at_phase, ..*self }.force(term)),
            waves: (!term.is_kinked()).then(|| self.waves(&value)),
            turning: self.waves(&turning),
            resonant: factors(&value),
            turned: factors(&turning),
        }
    }

    fn phase(&self) -> &str {
        &self.setting.names.coordinates[0].phase
    }

    /// The term as a product.
    fn force(&self, term: &SmallForceTerm) -> String {
        let x = self.variable;
        let [position, velocity] = term.powers[0];
        let power = |base: &str, exponent: usize| match exponent {
            0 => None,
            1 => Some(base.to_owned()),
            _ => Some(format!("{base}^{exponent}")),
        };
        let speed = format!("{x}'");
        let sign = |base: &str, is_factor: bool| is_factor.then(|| format!("sign({base})"));
        let factors = [
            power(x, position),
            sign(x, term.signs[0]),
            power(&speed, velocity),
            sign(&speed, term.signs[1]),
        ];
        let factors: Vec<String> = factors.into_iter().flatten().collect();
        let mut text = String::new();
        let moving = (!factors.is_empty()).then(|| factors.join("*"));
        append(&mut text, &self.waves(&term.coefficient), moving);
        text
    }

    /// j and m of a wave e^{i(jψ + mWt)}.
    fn wave_numbers(&self, powers: &[i64]) -> [i64; 2] {
        let letters = self.forced.letters;
        let [z, conjugate, wave] =
            [Column::Phasor, Column::Conjugate, Column::Wave].map(|column| powers[letters.index(column)]);
        let j = (z - conjugate) / 2;
        [j, (wave / 2 - self.forced.harmonics[0] * j) / self.forced.drive_harmonic]
    }

    /// A real sum of waves, those near the natural frequency first.
    fn waves(&self, sum: &Sum) -> String {
        let letters = self.forced.letters;
        let q = self.forced.harmonics[0];
        let mut all: Vec<[i64; 2]> = sum.half_powers().map(|(powers, _)| self.wave_numbers(powers)).collect();
        all.retain(|[j, m]| *j > 0 || (*j == 0 && *m >= 0));
        let frequency = |[j, m]: &[i64; 2]| (q * j + self.forced.drive_harmonic * m).abs();
        all.sort_by_key(|wave| (frequency(wave) != q, frequency(wave), *wave));
        all.dedup();
        let mut text = String::new();
        for numbers in all {
            let wave_part = letters.part(sum, |powers| self.wave_numbers(powers) == numbers);
            let wave = letters.index(Column::Wave);
            let still = letters.changed(&wave_part, |powers, factor| {
                powers[wave] = 0;
                factor.clone()
            });
            let doubled = if numbers == [0, 0] { 1 } else { 2 };
            let amplitude = letters.scaled(&polar(letters, &still), &Rational::from(doubled));
            let [real, imaginary] = real_and_imaginary(letters, &amplitude);
            let angle = self.angle(numbers);
            let sine = letters.scaled(&imaginary, &Rational::from(-1));
            for (name, coefficient) in [("cos", real), ("sin", sine)] {
                let function = (!angle.is_empty()).then(|| format!("{name}({angle})"));
                append(&mut text, &letters.text(&coefficient), function);
            }
        }
        text
    }

    /// jψ + mWt.
    fn angle(&self, [j, m]: [i64; 2]) -> String {
        let mut text = if j == 0 { String::new() } else { multiple(j, "psi") };
        let turns = Rational::from(m.abs());
        let (p, q) = self.setting.resonance;
        let drive = match &self.setting.drive {
            Some(_) if self.is_at_phase => {
                let turns = turns * Rational::new(p, q).unwrap_or_else(|| Rational::from(1));
                match (turns.to_string().as_str(), j == 0 && m > 0) {
                    ("0", _) => String::new(),
                    ("1", true) => format!("psi - {}", self.phase()),
                    (turns, _) => format!("{turns}*(psi - {})", self.phase()),
                }
            }
            Some(DriveFrequency::Symbol(name)) => angle(&turns, name),
            Some(DriveFrequency::Number(number)) => angle(&(turns * number.clone()), "1"),
            None => String::new(),
        };
        append_term(&mut text, &if m < 0 { format!("-{drive}") } else { drive });
        text
    }
}

fn multiple(k: i64, of: &str) -> String {
    match k {
        1 => of.to_owned(),
        _ => format!("{k}*{of}"),
    }
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
