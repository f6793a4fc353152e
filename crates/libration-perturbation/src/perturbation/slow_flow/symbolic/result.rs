//! The slow flow as formulas.

use super::criteria::{Peak, ResponseCurve};
use super::equations::Found;
use super::evaluation::{FormulaSums, SlowFlowAt};
use super::force::DriveFrequency;
use super::letters::{Column, Letters, Sum};
use super::notes::{notes, peak_note};
use super::phase_sums::{PhaseSum, append, append_term, real_and_imaginary};
use super::scales::{Forced, Solved};
use super::setting::{Names, Setting};
use super::steady::{Obstacle, Steady, SteadyEquations};
use super::steady_state::{MOST_TERMS, SteadyState};
use libration_numbers::algebra::{Rational, Ring};
use libration_numbers::internals::algebra::InOrder;

/// A slow flow as formulas in plain text, which [`Expression`](libration_numbers::expression::Expression) reads.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SymbolicSlowFlow {
    /// Highest order in the small parameters.
    pub order: usize,
    /// p and q of the resonance; `None` without drive.
    pub resonance: Option<(u32, u32)>,
    /// Terms of the equation that are of higher order and left out.
    pub order_note: Option<String>,
    /// The natural frequency ω0.
    pub natural_frequency: String,
    /// The drive frequency W by ω0 and the detuning.
    pub drive_frequency: Option<String>,
    /// The name or the value of W in the equation.
    pub drive: Option<String>,
    /// Names in the formulas with their meanings: amplitude, phase, detuning, and ω0 if it has a name.
    pub letters: Vec<(&'static str, String)>,
    /// dA/dt.
    pub amplitude_rate: String,
    /// dφ/dt.
    pub phase_rate: String,
    /// The displacement.
    pub displacement: String,
    /// The equilibrium.
    pub equilibrium: String,
    /// Restrictions of the displacement.
    pub displacement_note: Option<&'static str>,
    /// Steady states.
    pub steady_state: SteadyState,
    pub(super) sums: FormulaSums,
}

impl SymbolicSlowFlow {
    /// The slow flow with numbers for all symbols, and for W unless it is a number in the equation.
    ///
    /// # Errors
    /// The names that have no value.
    pub fn at(
        &self,
        value: &dyn Fn(&str) -> Option<f64>,
        drive_frequency: Option<f64>,
    ) -> Result<SlowFlowAt<'_>, Vec<String>> {
        self.sums.at(value, drive_frequency)
    }
}

pub(super) fn collected(
    setting: &Setting,
    forced: &Forced<'_>,
    properties: &Found,
    solved: &Solved,
    order: i64,
) -> SymbolicSlowFlow {
    let letters = forced.letters;
    let names = &setting.names;
    let rates = rates(letters, &solved.rates[0]);
    let lowest = lowest_order(letters, &rates).unwrap_or(order);
    let is_driven = setting.drive.is_some();
    let steady = SteadyEquations { letters, rates: rates.clone(), order, lowest, is_driven }.solve();
    let steady_state = steady_state(setting, forced, (&rates, &steady), properties, [lowest, order]);
    let per_amplitude = letters.power(Column::Amplitude, -1);
    let phase = |k: i64| multiple(k, &names.coordinates[0].phase);
    let is_kinked = forced.terms.iter().flatten().any(super::scales::SmallForceTerm::is_kinked);
    SymbolicSlowFlow {
        order: usize::try_from(order).unwrap_or(0),
        resonance: setting
            .drive
            .is_some()
            .then_some(setting.resonance)
            .and_then(|(p, q)| Some((u32::try_from(p).ok()?, u32::try_from(q).ok()?))),
        order_note: properties.left_out.clone(),
        natural_frequency: forced.omega0.to_string(),
        drive_frequency: setting.drive.is_some().then(|| drive_frequency(forced, setting.resonance)),
        drive: setting.drive.as_ref().map(drive_name),
        letters: explained(names, setting, properties),
        amplitude_rate: rates[0].text(letters, phase),
        phase_rate: rates[1].times(letters, &per_amplitude).text(letters, phase),
        displacement: displacement(setting, forced, solved, properties.equilibrium.as_ref()),
        equilibrium: properties.equilibrium.as_ref().map_or_else(|| "0".to_owned(), ToString::to_string),
        displacement_note: is_kinked.then_some("harmonics of forces with abs or sign are left out"),
        steady_state,
        sums: FormulaSums {
            symbols: letters.ring.letters()[..letters.given].to_vec(),
            drive: setting.drive.clone(),
            resonance: setting.resonance,
            omega0: forced.omega0.clone(),
            square: properties.natural.clone(),
            unit: letters.unit(&forced.detuning),
            rates,
            steady,
        },
    }
}

/// A′ and A·φ′: real and imaginary part of 2z′·e^{−iφ}.
pub(super) fn rates(letters: &Letters, rate: &Sum) -> [PhaseSum; 2] {
    PhaseSum::parts(letters, &turned(letters, rate))
}

/// 2z′·e^{−iφ} in powers of e^{iφ}.
pub(super) fn turned(letters: &Letters, rate: &Sum) -> Sum {
    let [z, conjugate, wave] =
        [Column::Phasor, Column::Conjugate, Column::Wave].map(|column| letters.index(column));
    let turned = letters.changed(rate, |powers, factor| {
        powers[wave] = powers[z] - powers[conjugate] - 2;
        factor.clone()
    });
    letters.scaled(&polar(letters, &turned), &Rational::from(2))
}

/// The sum with A/2 in place of each z and z̄.
pub(super) fn polar(letters: &Letters, sum: &Sum) -> Sum {
    let [phasors, conjugates, amplitudes] =
        [Column::Phasor, Column::Conjugate, Column::Amplitude].map(|column| letters.indices(column));
    let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
    letters.changed(sum, |powers, factor| {
        let mut halvings = 0;
        for ((&z, &conjugate), &amplitude) in phasors.iter().zip(&conjugates).zip(&amplitudes) {
            let degree = powers[z] + powers[conjugate];
            (powers[z], powers[conjugate]) = (0, 0);
            powers[amplitude] += degree;
            halvings += degree / 2;
        }
        (0..halvings).fold(factor.clone(), |product, _| product * half.clone())
    })
}

/// The lowest order at which the slow flow is not zero.
pub(super) fn lowest_order(letters: &Letters, rates: &[PhaseSum; 2]) -> Option<i64> {
    let sums = rates.iter().flat_map(|rate| rate.harmonics.values().flatten());
    sums.filter_map(|sum| letters.lowest_order(sum)).min()
}

fn steady_state(
    setting: &Setting,
    forced: &Forced<'_>,
    (rates, steady): (&[PhaseSum; 2], &Steady),
    properties: &Found,
    [lowest, order]: [i64; 2],
) -> SteadyState {
    let letters = &setting.letters;
    let is_driven = setting.drive.is_some();
    let amplitude = letters.index(Column::Amplitude);
    let depends_on_amplitude = |sum: &&Sum| sum.half_powers().any(|(powers, _)| powers[amplitude] != 0);
    let text = |sum: &Option<Sum>| sum.as_ref().filter(|sum| is_short(sum)).map(|sum| letters.text(sum));
    let phase = |k: i64| multiple(k, &setting.names.coordinates[0].phase);
    let shown = if is_driven { 2 } else { 1 };
    let relation = steady.relation.clone().filter(|relation| is_driven || depends_on_amplitude(&relation));
    let mut state = SteadyState {
        equations: rates.iter().take(shown).map(|rate| rate.text(letters, phase)).collect(),
        relation: text(&relation),
        phase: steady.phase.as_ref().and_then(|(m, parts)| {
            let divided = |part: &Sum| match &steady.denominator {
                Some(below) => format!("({})/({})", letters.text(part), letters.text(below)),
                None => letters.text(part),
            };
            Some((usize::try_from(*m).ok()?, parts.each_ref().map(divided)))
        }),
        trace: text(&steady.trace),
        determinant: text(&steady.determinant),
        ..SteadyState::default()
    };
    let is_curve = steady.phase.is_some() || steady.obstacle == Some(Obstacle::Sums);
    if let Some(relation) = steady.relation.as_ref().filter(|_| is_curve) {
        let curve = ResponseCurve { letters, relation, order: order - lowest, omega0: &forced.omega0 };
        describe(&mut state, &curve, &properties.drives, steady);
    }
    if let Some(relation) = relation.as_ref().filter(|_| !is_driven) {
        let curve = ResponseCurve { letters, relation, order: order - lowest, omega0: &forced.omega0 };
        describe_cycle(&mut state, &curve, &rates[1], order);
    }
    state.notes = notes(&state, is_driven, steady, forced.highest_order());
    state
}

/// Backbone, peak, folds and critical drive.
fn describe(state: &mut SteadyState, curve: &ResponseCurve<'_>, drives: &[usize], steady: &Steady) {
    let backbone = curve.backbone();
    if let Some(Peak { power, root, detuning }) = backbone.as_ref().and_then(|backbone| curve.peak(backbone))
    {
        state.peak_amplitude = Some(root_text(curve.letters, &power, root)).filter(|_| is_short(&power));
        state.peak_detuning = detuning.filter(is_short).map(|sum| curve.letters.text(&sum));
    }
    if state.peak_amplitude.is_none() {
        state.notes.push(peak_note(curve, backbone.as_ref(), steady));
    }
    state.backbone = backbone.filter(is_short).map(|sum| curve.letters.text(&sum));
    state.folds = curve.folds().filter(is_short).map(|sum| curve.letters.text(&sum));
    if let Some([amplitude, value]) = curve.critical_drive(drives) {
        (state.drive_amplitude, state.critical_drive) = (Some(amplitude), Some(value));
    }
    if steady.order > steady.lowest && state.critical_drive.is_some() {
        state.notes.push("critical_drive is to lowest order".to_owned());
    }
}

/// Amplitude and frequency of the only limit cycle.
fn describe_cycle(state: &mut SteadyState, curve: &ResponseCurve<'_>, turning: &PhaseSum, order: i64) {
    let letters = curve.letters;
    let is_negative = |power: &Sum| power.as_single_term().is_some_and(|(_, factor)| factor.is_negative());
    let Some((power, root)) = curve.only_amplitude().filter(|(power, _)| !is_negative(power)) else { return };
    let rate = letters.times(&turning.in_cosine_and_sine(letters, 1), &letters.power(Column::Amplitude, -1));
    let rate = curve.at_power(&rate, &power, root, order);
    state.cycle_frequency = rate.filter(is_short).map(|rate| letters.text(&letters.add(curve.omega0, &rate)));
    state.cycle_amplitude = Some(root_text(letters, &power, root)).filter(|_| is_short(&power));
}

fn is_short(sum: &Sum) -> bool {
    !sum.is_beyond_limit() && sum.half_powers().count() <= MOST_TERMS
}

/// The positive root of a sum.
fn root_text(letters: &Letters, power: &Sum, root: i64) -> String {
    let exponent = Rational::new(1, root).unwrap_or_else(|| Rational::from(1));
    if let Some(value) = letters.ring.power(power, &exponent).filter(|_| power.as_single_term().is_some()) {
        return letters.text(&value);
    }
    match root {
        1 => letters.text(power),
        2 => format!("sqrt({})", letters.text(power)),
        _ => format!("({})^(1/{root})", letters.text(power)),
    }
}

fn multiple(k: i64, of: &str) -> String {
    if k == 1 { of.to_owned() } else { format!("{k}*{of}") }
}

fn drive_name(drive: &DriveFrequency) -> String {
    match drive {
        DriveFrequency::Symbol(name) => name.clone(),
        DriveFrequency::Number(number) => number.to_string(),
    }
}

pub(super) fn drive_frequency(forced: &Forced<'_>, (p, q): (i64, i64)) -> String {
    let letters = forced.letters;
    let resonant = letters.scaled(&forced.omega0, &Rational::new(p, q).unwrap_or_else(|| Rational::from(1)));
    format!("{resonant} + {}", letters.text(&forced.detuning))
}

fn explained(names: &Names, setting: &Setting, properties: &Found) -> Vec<(&'static str, String)> {
    let mut list = vec![
        ("amplitude", names.coordinates[0].amplitude.clone()),
        ("phase", names.coordinates[0].phase.clone()),
    ];
    if let Some(drive) = &setting.drive {
        list.push(("detuning", names.detuning.clone()));
        list.push(("drive_frequency", drive_name(drive)));
    }
    if let Some(natural) = &properties.natural {
        list.push(("natural_frequency", names.natural.clone()));
        list.push(("natural_frequency_value", format!("sqrt({natural})")));
    }
    list
}

/// The displacement as harmonics of W·t/p, or of ω0·t without drive, each with its multiple of φ.
fn displacement(
    setting: &Setting,
    forced: &Forced<'_>,
    solved: &Solved,
    equilibrium: Option<&Sum>,
) -> String {
    let letters = forced.letters;
    let motion = &solved.displacements[0];
    let [z, conjugate] = [Column::Phasor, Column::Conjugate].map(|column| letters.index(column));
    let mut turns: Vec<i64> =
        motion.half_powers().map(|(powers, _)| (powers[z] - powers[conjugate]) / 2).collect();
    turns.put_in_order_by(|turn| (turn.abs(), -turn));
    turns.dedup();
    let mut harmonics = letters.exponents(motion, Column::Wave);
    harmonics.retain(|&k| k >= 0);
    let q = forced.harmonics[0];
    harmonics.put_in_order_by(|&k| (k != q, k));
    let mut text = equilibrium.map_or_else(String::new, ToString::to_string);
    for k in harmonics {
        let of_wave = letters.coefficient(motion, Column::Wave, k);
        for &turn in turns.iter().filter(|&&turn| k > 0 || turn >= 0) {
            let harmonic = letters.part(&of_wave, |powers| (powers[z] - powers[conjugate]) / 2 == turn);
            if harmonic.is_zero() {
                continue;
            }
            append_wave(&mut text, setting, forced, &harmonic, [k, turn]);
        }
    }
    text
}

/// Appends the real wave of a complex amplitude and its conjugate.
fn append_wave(text: &mut String, setting: &Setting, forced: &Forced<'_>, wave: &Sum, [k, turn]: [i64; 2]) {
    let letters = forced.letters;
    let doubled = if k == 0 && turn == 0 { 1 } else { 2 };
    let amplitude = letters.scaled(&polar(letters, wave), &Rational::from(doubled));
    let [real, imaginary] = real_and_imaginary(letters, &amplitude);
    let mut angle = fast_angle(setting, forced, k);
    let phase = &setting.names.coordinates[0].phase;
    match turn {
        0 => {}
        -1 => append_term(&mut angle, &format!("-{phase}")),
        _ => append_term(&mut angle, &multiple(turn, phase)),
    }
    let sine = letters.scaled(&imaginary, &Rational::from(-1));
    for (name, coefficient) in [("cos", real), ("sin", sine)] {
        let function = (!angle.is_empty()).then(|| format!("{name}({angle})"));
        append(text, &letters.text(&coefficient), function);
    }
}

/// The phase of the k-th harmonic of s.
pub(super) fn fast_angle(setting: &Setting, forced: &Forced<'_>, k: i64) -> String {
    let letters = forced.letters;
    let (frequency, whole) = match &setting.drive {
        Some(DriveFrequency::Number(number)) => (letters.number(number.clone()), forced.drive_harmonic),
        Some(DriveFrequency::Symbol(name)) => {
            return angle(&fraction(k, forced.drive_harmonic), name);
        }
        None => (forced.omega0.clone(), forced.harmonics[0]),
    };
    let factor = fraction(k, whole);
    match frequency.to_constant() {
        Some(number) => angle(&(factor * number), "1"),
        None => angle(&factor, &frequency.to_string()),
    }
}

fn fraction(above: i64, below: i64) -> Rational {
    Rational::new(above, below).unwrap_or_else(|| Rational::from(0))
}

/// A multiple of a frequency times t; an empty text for zero.
pub(super) fn angle(factor: &Rational, frequency: &str) -> String {
    let is_product = frequency.contains(['/', '+', ' ']);
    let frequency = if is_product { format!("({frequency})") } else { frequency.to_owned() };
    match (factor.to_string().as_str(), frequency.as_str()) {
        ("0", _) => String::new(),
        ("1", "1") => "t".to_owned(),
        ("1", frequency) => format!("{frequency}*t"),
        (factor, "1") => format!("{factor}*t"),
        (factor, frequency) => format!("{factor}*{frequency}*t"),
    }
}
