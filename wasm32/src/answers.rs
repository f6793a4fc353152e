//! Queries to every part of the mathematics and to the pictures, with their results as numbers.

use std::f64::consts::PI;

use libration::elliptic::Modulus;
use libration::oscillator::Oscillator;
use libration::pendulum::{
    Amplitude, Pendulum, period_excesses, period_ratios, period_ratios_near_top, states,
};
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{Effort, Moment, System, integrate};
use libration_report::chart::{Axis, Panel, Picture, Series};
use libration_report::format::PictureFormat;
use libration_report::{draw, style, svg};

/// Reason why there are no results.
pub type Failure = Box<dyn std::error::Error>;

/// All results, always in the same order.
///
/// # Errors
/// A question that none of the libraries should refuse.
pub fn answers() -> Result<Vec<f64>, Failure> {
    let mut all = vec![];
    all.extend(periods()?);
    all.extend(motions()?);
    all.extend(elliptic_functions()?);
    all.extend(harmonics()?);
    all.extend(expansion()?);
    all.extend(integration()?);
    all.extend(picture()?);
    Ok(all)
}

/// Numbers from 0 to 1 by the congruences of Knuth's MMIX.
struct Draws(u64);

impl Iterator for Draws {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let high = u32::try_from(self.0 >> 32).unwrap_or(u32::MAX);
        Some(f64::from(high) / f64::from(u32::MAX))
    }
}

/// Periods over all amplitudes, and down to a complement of 3·2⁻¹⁰⁰⁰.
fn periods() -> Result<Vec<f64>, Failure> {
    let amplitudes: Vec<f64> = Draws(1).take(1000).map(|part| PI * part).collect();
    let powers = std::iter::successors(Some(3.0), |power| Some(0.5 * power));
    let complements: Vec<f64> =
        powers.zip(Draws(2)).map(|(power, part)| power * (1.0 - 0.5 * part)).take(1000).collect();
    let mut answers = vec![0.0; 3000];
    let (ratios, rest) = answers.split_at_mut(1000);
    let (excesses, near_top) = rest.split_at_mut(1000);
    period_ratios(&amplitudes, ratios)?;
    period_excesses(&amplitudes, excesses)?;
    period_ratios_near_top(&complements, near_top)?;
    Ok(answers)
}

/// Swings of one amplitude and of many, prepared or not, rotations, and the motion on the separatrix.
fn motions() -> Result<Vec<f64>, Failure> {
    let times: Vec<f64> = Draws(3).take(1000).map(|part| 5000.0 * part).collect();
    let pendulum = Pendulum::from_angular_frequency(3.2)?;
    let swing = pendulum.released_from(Angle::from_radians(2.9)?)?;
    let turns = pendulum.launched(Angle::from_radians(0.5)?, 7.0)?;
    let mut answers = vec![];
    for motion in [swing, turns, pendulum.on_separatrix()] {
        for time in &times {
            let state = motion.state_at(*time);
            answers.extend([state.angle, state.velocity]);
        }
        let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
        motion.prepare().states_at(&times, &mut angles, &mut velocities)?;
        answers.extend(angles.into_iter().chain(velocities));
    }
    let amplitudes: Vec<f64> = Draws(4).take(times.len()).map(|part| PI * part).collect();
    let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
    states(&amplitudes, 3.2, &times, &mut angles, &mut velocities)?;
    answers.extend(angles.into_iter().chain(velocities));
    Ok(answers)
}

fn elliptic_functions() -> Result<Vec<f64>, Failure> {
    let mut answers = vec![];
    for (part, angle) in Draws(5).zip(Draws(6)).take(300) {
        let modulus = Modulus::from_modulus(part)?;
        let jacobi = modulus.jacobi(50.0 * angle);
        answers.extend([modulus.first(), modulus.second(), modulus.nome()]);
        answers.extend([jacobi.sn, jacobi.cn, jacobi.dn, jacobi.am]);
        answers.extend([modulus.incomplete_first(20.0 * angle), modulus.incomplete_second(20.0 * angle)]);
    }
    Ok(answers)
}

fn harmonics() -> Result<Vec<f64>, Failure> {
    let pendulum = Pendulum::new(0.5, 9.81)?;
    let motion = pendulum.released_from(Angle::from_degrees(179.0)?)?;
    let terms = motion.harmonics(1e-12, 40).terms;
    Ok(terms.iter().flat_map(|term| [term.angle, term.velocity]).collect())
}

/// Exact fractions as their letters.
fn expansion() -> Result<Vec<f64>, Failure> {
    let oscillator = Oscillator::new(&"x'' = -sin(x)".parse()?)?;
    let expansion = expand(&oscillator, 21, &Gauge::Fundamental, &Quiet)?;
    let fractions = expansion.frequency_ratio.iter().map(ToString::to_string);
    let mut answers: Vec<f64> = fractions.flat_map(letters).collect();
    answers.push(Amplitude::new(Angle::from_degrees(90.0)?)?.period_ratio());
    Ok(answers)
}

/// A damped pendulum that is driven.
fn integration() -> Result<Vec<f64>, Failure> {
    let system = System::new(&"theta'' + 0.2 theta' + sin(theta) = 0.7*cos(2*t/3)".parse()?)?;
    let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
    let times: Vec<f64> = (1..=300).map(|n| f64::from(n) / 6.0).collect();
    let solution = integrate(&system, &start, &times, &Effort::to_tolerance(1e-14), &Quiet)?;
    Ok(solution.samples.into_iter().flat_map(|sample| sample.state).collect())
}

/// A picture as its letters.
fn picture() -> Result<Vec<f64>, Failure> {
    let motion = Pendulum::new(1.0, 9.81)?.released_from(Angle::from_degrees(150.0)?)?;
    let points = (0..400).map(|n| (f64::from(n) / 100.0, motion.state_at(f64::from(n) / 100.0).angle));
    let panel = Panel {
        x: Axis::linear("t in s", 0.0, 4.0),
        y: Axis::linear("θ in rad", -3.0, 3.0),
        series: vec![Series::line("exact", style::curve(0), points)],
        share: 1.0,
    };
    let scene = draw(&Picture::new("A swing of 150°", vec![panel]), &PictureFormat::PAGE)?;
    Ok(letters(svg::file(&scene)).collect())
}

fn letters(text: String) -> impl Iterator<Item = f64> {
    text.into_bytes().into_iter().map(f64::from)
}

/// The sum of the periods of `count` amplitudes.
pub(crate) fn sum_of_periods(count: u32) -> f64 {
    let amplitudes: Vec<f64> = (0..count).map(|n| PI * f64::from(n) / f64::from(count)).collect();
    let mut ratios = vec![0.0; amplitudes.len()];
    period_ratios(&amplitudes, &mut ratios).map_or(f64::NAN, |()| ratios.iter().sum())
}

/// The sum of `count` angles of a motion.
pub(crate) fn sum_of_angles(count: u32) -> f64 {
    let start = Angle::from_radians(2.5).ok();
    let motion = start.and_then(|start| Pendulum::new(1.0, 9.81).ok()?.released_from(start).ok());
    let Some(motion) = motion else { return f64::NAN };
    let times: Vec<f64> = (0..count).map(|n| f64::from(n) / 100.0).collect();
    let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
    let outcome = motion.states_at(&times, &mut angles, &mut velocities);
    outcome.map_or(f64::NAN, |()| angles.iter().sum())
}
