//! The cycles and their results, from the landmarks of all stretches.

use std::f64::consts::TAU;

use super::bias::{Bias, SimulatedMeasurement};
use super::centre::Centre;
use super::cycle_landmarks::CycleLandmarks;
use super::envelope::{Envelope, envelope};
use super::generalised::CycleScatter;
use super::landmarks::{Landmarks, landmarks};
use super::period_law::{self, PeriodLaw};
use super::pivot;
use super::row::CycleRow;
use super::swings::{Swings, swings};
use super::{Cycle, Cycles, CyclesError, CyclesOptions, CyclesWarning, HalfSwing};
use crate::fit::uncertain::Uncertain;
use crate::measurement::{Observable, Trace};
use crate::statistics::median;
use libration::internals::progress::Watch;
use libration::progress::{Interrupted, Progress};
use libration::roots::{Tolerance, bisect};

/// Fewest rows in a period, two in each quarter, with which passages and extremes can be placed.
const FEWEST_ROWS_PER_PERIOD: f64 = 8.0;

/// The cycles of a trace.
///
/// # Errors
/// See [`CyclesError`]: too few rows or cycles, nothing that swings to and fro.
/// [`CyclesError::Interrupted`] if the call is cancelled.
pub fn fit_cycles(
    trace: &Trace,
    options: &CyclesOptions,
    progress: &dyn Progress,
) -> Result<Cycles, CyclesError> {
    let watch = &Watch::new(progress);
    let cycles = of_pivot_with_errors(trace, options, watch);
    if watch.is_stopped() { Err(Interrupted.into()) } else { cycles }
}

fn of_pivot_with_errors(
    trace: &Trace,
    options: &CyclesOptions,
    watch: &Watch<'_>,
) -> Result<Cycles, CyclesError> {
    let mut cycles = about_a_known_pivot(trace, options, watch)?;
    for error in trace.fitted_pivot().iter().flat_map(|pivot| pivot.errors()) {
        let moved = about_a_known_pivot(&trace.shifted(&error), options, watch)?;
        pivot::add(&mut cycles, moved, watch);
    }
    Ok(cycles)
}

/// Computes the cycles as if the values were those of the pendulum's angle.
fn about_a_known_pivot(
    trace: &Trace,
    options: &CyclesOptions,
    watch: &Watch<'_>,
) -> Result<Cycles, CyclesError> {
    let swings = swings(trace)?;
    let stretches: Vec<Landmarks> =
        swings.stretches.iter().filter_map(|stretch| landmarks(trace, stretch, None, watch)).collect();
    let turning_points = swings.stretches.iter().map(|stretch| stretch.turns.len().saturating_sub(2)).max();
    let too_short = CyclesError::TooShort { turning_points: turning_points.unwrap_or(0) };
    let longest = stretches.iter().max_by_key(|stretch| stretch.passages.len()).ok_or(too_short.clone())?;
    let period = longest.period().ok_or(too_short.clone())?;
    let rows_per_period = rows_per_period(trace, period);
    if rows_per_period < FEWEST_ROWS_PER_PERIOD {
        return Err(CyclesError::TooCoarse { rows_per_period });
    }
    let landmarks = CycleLandmarks::new(&stretches, typical_uncertainty(trace));
    let (half_swings, rows) = settled(&landmarks, trace.observable(), period);
    if rows.is_empty() {
        return Err(too_short);
    }
    let half: Vec<HalfSwing> = half_swings.into_iter().flatten().collect();
    let (law, _) = law(&rows, options, watch).ok_or(too_short.clone())?;
    let envelope = envelope(&half, TAU / law.t0.value, watch);
    let apparatus = SimulatedMeasurement {
        observable: trace.observable(),
        omega0: TAU / law.t0.value,
        rows_per_period,
        noise: longest.noise * typical_uncertainty(trace),
    };
    let rows = match &envelope {
        Ok(envelope) => unbiased(rows, apparatus, envelope, watch),
        Err(_) => rows,
    };
    let (law, outliers) = self::law(&rows, options, watch).ok_or(too_short)?;
    let kept = without(&rows, &outliers);
    let cycles =
        rows.iter().enumerate().map(|(k, row)| Cycle::new(row, law.scatter, outliers.contains(&k))).collect();
    Ok(Cycles {
        cycles,
        envelope,
        half_swings: half,
        offset: longest.centre.value,
        offset_wander: longest.centre.wander,
        noise: longest.noise,
        t0: law.t0,
        t0_degrees_of_freedom: law.degrees_of_freedom,
        chi2_per_dof: law.chi2_per_dof,
        beta: period_law::beta(&kept, watch),
        warnings: warnings(&landmarks, &rows, outliers.len(), &swings, &longest.centre, trace.observable()),
        rows: kept,
        about_moved_pivot: vec![],
    })
}

/// Fits the exact law to the rows, and returns it with the indices of outliers.
fn law(rows: &[CycleRow], options: &CyclesOptions, watch: &Watch<'_>) -> Option<(PeriodLaw, Vec<usize>)> {
    let outliers = period_law::outliers(rows, options.outlier_threshold);
    let law = period_law::exact(&without(rows, &outliers), watch)?;
    Some((law, outliers))
}

fn without(rows: &[CycleRow], outliers: &[usize]) -> Vec<CycleRow> {
    (0..rows.len()).filter(|row| !outliers.contains(row)).map(|row| rows[row].clone()).collect()
}

/// Removes from the periods the bias by the damping of the preferred law and by the local fits.
fn unbiased(
    rows: Vec<CycleRow>,
    apparatus: SimulatedMeasurement,
    envelope: &Envelope,
    watch: &Watch<'_>,
) -> Vec<CycleRow> {
    let amplitudes = || rows.iter().map(CycleRow::amplitude);
    let range = [amplitudes().fold(f64::INFINITY, f64::min), amplitudes().fold(0.0, f64::max)];
    match Bias::new(apparatus, envelope.preferred(), range, watch) {
        Some(bias) => rows.iter().map(|row| bias.removed_from(row, apparatus.omega0)).collect(),
        None => rows,
    }
}

fn rows_per_period(trace: &Trace, period: f64) -> f64 {
    let steps = trace.times().windows(2).map(|pair| pair[1] - pair[0]).collect();
    median(steps).map_or(f64::INFINITY, |step| period / step)
}

/// Median uncertainty of the values; one where rows have none.
fn typical_uncertainty(trace: &Trace) -> f64 {
    trace.uncertainties().and_then(|column| median(column.to_vec())).unwrap_or(1.0)
}

/// The half swings and the cycles; for a trace of velocities with a consistent ω0.
fn settled(
    landmarks: &CycleLandmarks,
    observable: Observable,
    longest: f64,
) -> (Vec<Option<HalfSwing>>, Vec<CycleRow>) {
    let t0 = match observable {
        Observable::Angle => longest,
        Observable::AngularVelocity => t0_of_velocities(landmarks, longest),
    };
    let half_swings = landmarks.half_swings(observable, TAU / t0);
    let rows = landmarks.rows(&half_swings);
    (half_swings, rows)
}

/// The T0 that agrees with that of the cycles, whose amplitudes follow from their largest velocities and this T0. With a larger T0 the amplitudes
/// are larger and the cycles give a smaller one, so that there is one solution between 0 and the period.
fn t0_of_velocities(landmarks: &CycleLandmarks, period: f64) -> f64 {
    let complete = landmarks.rows(&landmarks.half_swings(Observable::AngularVelocity, f64::INFINITY)).len();
    let [t0, _] = bisect([0.1 * period, period], Tolerance::absolute(1e-12 * period), |t0| {
        let half_swings = landmarks.half_swings(Observable::AngularVelocity, TAU / t0);
        let rows = landmarks.rows(&half_swings);
        // Cycles that would lead over the top imply a smaller T0, whatever their number.
        let beyond = vec![0.0; complete.saturating_sub(rows.len())];
        let said = rows.iter().map(CycleRow::small_angle_period).chain(beyond).collect();
        median(said).is_some_and(|said| said > t0)
    });
    t0
}

impl Cycle {
    fn new(row: &CycleRow, scatter: CycleScatter, outlier: bool) -> Self {
        let [one, two] = row.sides;
        Self {
            time: row.time,
            period: Uncertain {
                value: row.period,
                uncertainty: (scatter.noise * row.period_variance() + scatter.fluctuation).sqrt(),
            },
            amplitude: Uncertain {
                value: row.amplitude(),
                uncertainty: 0.5 * (one.variance + two.variance).sqrt(),
            },
            period_ratio: row.ratio,
            outlier,
        }
    }
}

/// Warnings about the way the cycles were found.
fn warnings(
    landmarks: &CycleLandmarks,
    rows: &[CycleRow],
    outliers: usize,
    swings: &Swings,
    centre: &Centre,
    observable: Observable,
) -> Vec<CyclesWarning> {
    let incomplete = landmarks.cycles.len() - rows.len();
    let deviation = centre.wander;
    [
        (swings.rotations > 0).then_some(CyclesWarning::OverTheTop { swings: swings.rotations }),
        (incomplete > 0).then_some(CyclesWarning::Incomplete { cycles: incomplete }),
        (outliers > 0).then_some(CyclesWarning::FarFromTheLaw { cycles: outliers }),
        swings.lost.map(|from| CyclesWarning::LostInNoise { from }),
        (deviation > 0.0).then_some(CyclesWarning::CentreWanders { deviation, observable }),
    ]
    .into_iter()
    .flatten()
    .collect()
}
