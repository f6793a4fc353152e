//! The slow flow of coupled oscillators as formulas.

use super::equations::Found;
use super::error::SymbolicSlowFlowError;
use super::letters::{Column, Letters, Sum};
use super::phase_sums::{append, append_term, real_and_imaginary};
use super::result::{fast_angle, polar};
use super::scales::{Forced, Solved};
use super::setting::Setting;
use super::{SymbolicSlowFlowOptions, answered};
use libration_numbers::algebra::Rational;
use libration_numbers::expression::Equation;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::progress::Progress;
use std::collections::BTreeMap;

/// A slow flow of coupled oscillators as formulas in plain text, which [`Expression`](libration_numbers::expression::Expression) reads.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CoupledSlowFlow {
    /// Highest order in the small parameters.
    pub order: usize,
    /// Terms of the equations that are of higher order and left out.
    pub order_note: Option<String>,
    /// p and q of the resonance, with the natural frequency of the first coordinate; `None` without drive.
    pub resonance: Option<(u32, u32)>,
    /// The drive frequency by the natural frequency of the first coordinate and the detuning; `None` without drive.
    pub drive_frequency: Option<String>,
    /// The square of the natural frequency of the first coordinate, where that has a name of its own.
    pub natural_frequency_squared: Option<String>,
    /// Symbol of the detuning of the drive; `None` without drive.
    pub detuning: Option<String>,
    /// The flow of each coordinate.
    pub coordinates: Vec<CoordinateFlow>,
}

/// Amplitude and phase of one coordinate: A·cos(nψ + φ) with terms of other properties, ψ being the phase of the first.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CoordinateFlow {
    /// The coordinate.
    pub name: String,
    /// Symbol of its amplitude.
    pub amplitude: String,
    /// Symbol of its phase.
    pub phase: String,
    /// Multiple of the natural frequency of the first coordinate that is near its own, as a formula.
    pub natural_frequency: String,
    /// Symbol of the detuning of its natural frequency with the square of that frequency, if it differs from the multiple.
    pub detuning: Option<[String; 2]>,
    /// Difference of its natural frequency from the multiple, as a formula.
    pub frequency_difference: Option<String>,
    /// Time derivative of the amplitude.
    pub amplitude_rate: String,
    /// Time derivative of the phase.
    pub phase_rate: String,
    /// The time derivatives of amplitude, and of phase times amplitude, both zero at steady states.
    pub equations: [String; 2],
    /// The displacement.
    pub displacement: String,
}

/// The slow flow of coupled oscillators with symbolic parameters, free or driven, near an internal resonance.
///
/// The linear parts of the equations are those of uncoupled oscillators; coupling, damping and drive are small, or a drive forces a motion away
/// from the natural properties. All motions have the properties of one wave: those of the coordinates are whole multiples of it, from which
/// natural properties and drive differ by small detunings.
///
/// # Errors
/// Equations that are not oscillators with small terms, natural properties whose ratios are not known, an order out of range, cancellation.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::{SymbolicSlowFlowOptions, coupled_slow_flow};
/// use libration::progress::Quiet;
/// let equation = "x'' + w1^2*x + eps*a*x*y = 0; y'' + w2^2*y + eps*b*x^2 = 0".parse()?;
/// let options = SymbolicSlowFlowOptions { ratios: vec![1, 2], ..Default::default() };
/// let flow = coupled_slow_flow(&equation, &options, &Quiet)?;
/// assert_eq!(flow.coordinates[0].amplitude_rate, "eps*a*A_x*A_y/(4*w1)*sin(2*phi_x - phi_y)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// A. H. Nayfeh, D. T. Mook, *Nonlinear Oscillations*, Wiley 1979, chapter 6.
pub fn coupled_slow_flow(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    progress: &dyn Progress,
) -> Result<CoupledSlowFlow, SymbolicSlowFlowError> {
    answered(equation, options, progress, |setting, forced, properties, solved, order| {
        let of_coordinate =
            |coordinate| coordinate_flow(equation, setting, forced, properties, solved, coordinate);
        let is_driven = setting.drive.is_some();
        let (p, q) = setting.resonance;
        CoupledSlowFlow {
            order: usize::try_from(order).unwrap_or(0),
            order_note: properties.left_out.clone(),
            resonance: u32::try_from(p).ok().zip(u32::try_from(q).ok()).filter(|_| is_driven),
            drive_frequency: is_driven.then(|| super::result::drive_frequency(forced, setting.resonance)),
            natural_frequency_squared: properties.natural.as_ref().map(ToString::to_string),
            detuning: is_driven.then(|| setting.names.detuning.clone()),
            coordinates: (0..forced.harmonics.len()).map(of_coordinate).collect(),
        }
    })
}

fn coordinate_flow(
    equation: &Equation,
    setting: &Setting,
    forced: &Forced<'_>,
    properties: &Found,
    solved: &Solved,
    coordinate: usize,
) -> CoordinateFlow {
    let letters = forced.letters;
    let names = &setting.names.coordinates[coordinate];
    let rates = Phases::rates(letters, &solved.rates[coordinate], coordinate);
    let per_amplitude = letters.power_at(letters.index_of(Column::Amplitude, coordinate), -1);
    let angle = |turns: &[i64]| slow_angle(setting, turns);
    let square = properties.natural_squares[coordinate].as_ref();
    CoordinateFlow {
        name: equation.variables()[coordinate].clone(),
        amplitude: names.amplitude.clone(),
        phase: names.phase.clone(),
        natural_frequency: forced.natural_frequency(coordinate).to_string(),
        detuning: square.map(|square| [names.detuning.clone(), square.to_string()]),
        frequency_difference: square.map(|_| letters.text(&setting.detuning(coordinate, 0))),
        amplitude_rate: rates[0].text(letters, angle),
        phase_rate: rates[1].times(letters, &per_amplitude).text(letters, angle),
        equations: rates.each_ref().map(|rate| rate.text(letters, angle)),
        displacement: displacement(setting, forced, &solved.displacements[coordinate], coordinate),
    }
}

/// Σ c·cos(m·φ) + s·sin(m·φ) by the multiples m of the phases, of which the first that is not zero is positive.
struct Phases(BTreeMap<Vec<i64>, [Sum; 2]>);

impl Phases {
    /// A′ and A·φ′ of a coordinate: real and imaginary part of 2z′·e^{−iφ}.
    fn rates(letters: &Letters, rate: &Sum, coordinate: usize) -> [Self; 2] {
        let conjugate = letters.power_at(letters.index_of(Column::Conjugate, coordinate), 1);
        // z̄ is A·e^{−iφ}/2: 2z′·e^{−iφ} is 4·z′·z̄/A.
        let inverse = letters.power_at(letters.index_of(Column::Amplitude, coordinate), -1);
        let turned = letters.times(&letters.times(rate, &conjugate), &inverse);
        Self::parts(letters, &letters.scaled(&turned, &Rational::from(4)))
    }

    /// Real and imaginary part of a sum of products of z and z̄.
    fn parts(letters: &Letters, sum: &Sum) -> [Self; 2] {
        let mut parts = [BTreeMap::<Vec<i64>, [Sum; 2]>::new(), BTreeMap::new()];
        for turns in all_turns(letters, sum) {
            let harmonic = letters.part(sum, |powers| turns_of(letters, powers) == turns);
            let [real, imaginary] = real_and_imaginary(letters, &polar(letters, &harmonic));
            let sign = turns.iter().copied().find(|turn| *turn != 0).map_or(0, i64::signum);
            let key: Vec<i64> = turns.iter().map(|turn| turn * if sign < 0 { -1 } else { 1 }).collect();
            let scaled = |a: &Sum, by: i64| letters.scaled(a, &Rational::from(by));
            // (r + i·m)·(cos + i·sign·sin).
            let both = [[real.clone(), scaled(&imaginary, -sign)], [imaginary.clone(), scaled(&real, sign)]];
            for (part, [cosine, sine]) in parts.iter_mut().zip(both) {
                let pair = part.entry(key.clone()).or_insert_with(|| [letters.zero(), letters.zero()]);
                pair[0] = letters.add(&pair[0], &cosine);
                pair[1] = letters.add(&pair[1], &sine);
            }
        }
        parts.map(Self)
    }

    fn times(&self, letters: &Letters, factor: &Sum) -> Self {
        let each = self
            .0
            .iter()
            .map(|(turns, parts)| (turns.clone(), parts.each_ref().map(|part| letters.times(part, factor))));
        Self(each.collect())
    }

    fn text(&self, letters: &Letters, angle: impl Fn(&[i64]) -> String) -> String {
        let mut text = String::new();
        for (turns, [cosine, sine]) in &self.0 {
            let angle = angle(turns);
            if angle.is_empty() {
                append(&mut text, &letters.text(cosine), None);
                continue;
            }
            for (name, coefficient) in [("cos", cosine), ("sin", sine)] {
                append(&mut text, &letters.text(coefficient), Some(format!("{name}({angle})")));
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }
}

/// The multiples of the phases in a product of powers of z and z̄.
fn turns_of(letters: &Letters, powers: &[i64]) -> Vec<i64> {
    let turn = |coordinate| {
        let [z, conjugate] =
            [Column::Phasor, Column::Conjugate].map(|column| powers[letters.index_of(column, coordinate)]);
        (z - conjugate) / 2
    };
    (0..letters.coordinates).map(turn).collect()
}

fn all_turns(letters: &Letters, sum: &Sum) -> Vec<Vec<i64>> {
    let mut turns: Vec<Vec<i64>> = sum.half_powers().map(|(powers, _)| turns_of(letters, powers)).collect();
    turns.put_in_order_by(|turns| (turns.iter().map(|turn| turn.abs()).sum::<i64>(), turns.clone()));
    turns.dedup();
    turns
}

/// Σ m·φ.
fn slow_angle(setting: &Setting, turns: &[i64]) -> String {
    let mut text = String::new();
    for (&turn, names) in turns.iter().zip(&setting.names.coordinates) {
        match turn {
            0 => {}
            1 => append_term(&mut text, &names.phase),
            -1 => append_term(&mut text, &format!("-{}", names.phase)),
            _ => append_term(&mut text, &format!("{turn}*{}", names.phase)),
        }
    }
    text
}

/// The displacement as waves, beginning with that of the natural frequency of the coordinate.
fn displacement(setting: &Setting, forced: &Forced<'_>, sum: &Sum, coordinate: usize) -> String {
    let letters = forced.letters;
    let mut harmonics = letters.exponents(sum, Column::Wave);
    harmonics.retain(|&k| k >= 0);
    harmonics.put_in_order_by(|&k| (k != forced.harmonics[coordinate], k));
    let mut text = String::new();
    for k in harmonics {
        let of_wave = letters.coefficient(sum, Column::Wave, k);
        for turns in all_turns(letters, &of_wave) {
            let first = turns.iter().copied().find(|turn| *turn != 0).unwrap_or(0);
            if k == 0 && first < 0 {
                continue;
            }
            let harmonic = letters.part(&of_wave, |powers| turns_of(letters, powers) == turns);
            let doubled = if k == 0 && first == 0 { 1 } else { 2 };
            let amplitude = letters.scaled(&polar(letters, &harmonic), &Rational::from(doubled));
            let [real, imaginary] = real_and_imaginary(letters, &amplitude);
            let slow = slow_angle(setting, &turns);
            let mut angle = fast_angle(setting, forced, k);
            append_term(&mut angle, &slow);
            let sine = letters.scaled(&imaginary, &Rational::from(-1));
            for (name, coefficient) in [("cos", real), ("sin", sine)] {
                let function = (!angle.is_empty()).then(|| format!("{name}({angle})"));
                append(&mut text, &letters.text(&coefficient), function);
            }
        }
    }
    text
}
