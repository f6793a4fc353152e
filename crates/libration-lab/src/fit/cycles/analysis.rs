//! From the landmarks of all stretches to cycles and what they say.

use std::f64::consts::{PI, TAU};

use super::centre::Centre;
use super::envelope::envelope;
use super::generalised::Scatter;
use super::landmarks::{Landmarks, landmarks};
use super::passage::Passage;
use super::period_law;
use super::pivot;
use super::row::{Row, Side};
use super::shape::{amplitude_of_velocity, slope_of_amplitude};
use super::swings::{Swings, swings};
use super::turning_point::Extreme;
use super::{Cycle, Cycles, CyclesError, CyclesOptions, CyclesWarning, HalfSwing};
use crate::fit::Uncertain;
use crate::measurement::{Observable, Trace};
use crate::statistics::median;
use libration::roots::{Tolerance, bisect};
use libration::watch::{Interrupted, Watch};

/// With fewer rows in a period, two in each quarter, passages and extremes cannot be placed.
const FEWEST_ROWS_PER_PERIOD: f64 = 8.0;
/// Extremes below so many standard deviations of a value are left out. With 8 all recordings (`mod.rs`) had the same cycles; with 2
/// the noisiest, a swing of three standard deviations, had 25 for none.
const FAINTEST: f64 = 4.0;

/// The cycles of a trace.
///
/// # Errors
/// See [`CyclesError`]: too few rows or cycles, nothing that swings to and fro.
pub fn cycles(trace: &Trace, options: &CyclesOptions) -> Result<Cycles, CyclesError> {
    cycles_watched(trace, options, &Watch::none())
}

/// [`cycles`], asking `watch` at each passage and extreme, and at each step of the fits.
///
/// # Errors
/// As [`cycles`], and [`CyclesError::Interrupted`] where it was stopped.
pub fn cycles_watched(
    trace: &Trace,
    options: &CyclesOptions,
    watch: &Watch<'_>,
) -> Result<Cycles, CyclesError> {
    let found = of_pivot_with_errors(trace, options, watch);
    if watch.is_stopped() { Err(Interrupted.into()) } else { found }
}

fn of_pivot_with_errors(
    trace: &Trace,
    options: &CyclesOptions,
    watch: &Watch<'_>,
) -> Result<Cycles, CyclesError> {
    let mut found = about_a_known_pivot(trace, options, watch)?;
    for error in trace.fitted_pivot().iter().flat_map(|pivot| pivot.errors()) {
        let moved = about_a_known_pivot(&trace.shifted(&error), options, watch)?;
        pivot::add(&mut found, moved, watch);
    }
    Ok(found)
}

/// The same as if the values were those of the pendulum's angle.
fn about_a_known_pivot(
    trace: &Trace,
    options: &CyclesOptions,
    watch: &Watch<'_>,
) -> Result<Cycles, CyclesError> {
    let swings = swings(trace)?;
    let stretches: Vec<Landmarks> =
        swings.stretches.iter().filter_map(|stretch| landmarks(trace, stretch, watch)).collect();
    let turning_points = swings.stretches.iter().map(|stretch| stretch.turns.len().saturating_sub(2)).max();
    let too_short = CyclesError::TooShort { turning_points: turning_points.unwrap_or(0) };
    let longest = stretches.iter().max_by_key(|stretch| stretch.passages.len()).ok_or(too_short.clone())?;
    let period = longest.period().ok_or(too_short.clone())?;
    let rows_per_period = rows_per_period(trace, period);
    if rows_per_period < FEWEST_ROWS_PER_PERIOD {
        return Err(CyclesError::TooCoarse { rows_per_period });
    }
    let found = Found::new(&stretches, typical_uncertainty(trace));
    let (half_swings, rows) = settled(&found, trace.observable(), period);
    if rows.is_empty() {
        return Err(too_short);
    }
    let outliers = period_law::outliers(&rows, options.outlier_threshold);
    let kept: Vec<Row> =
        (0..rows.len()).filter(|row| !outliers.contains(row)).map(|row| rows[row].clone()).collect();
    let law = period_law::exact(&kept, watch).ok_or(too_short)?;
    let cycles =
        rows.iter().enumerate().map(|(k, row)| Cycle::new(row, law.scatter, outliers.contains(&k))).collect();
    let half_swings: Vec<HalfSwing> = half_swings.into_iter().flatten().collect();
    Ok(Cycles {
        cycles,
        envelope: envelope(&half_swings, TAU / law.t0.value, watch),
        half_swings,
        offset: longest.centre.value,
        offset_wander: longest.centre.wander,
        noise: longest.noise,
        t0: law.t0,
        chi2_per_dof: law.chi2_per_dof,
        beta: period_law::beta(&kept, watch),
        warnings: warnings(&found, &rows, outliers.len(), &swings, &longest.centre, trace.observable()),
        rows: kept,
        about_moved_pivot: vec![],
    })
}

fn rows_per_period(trace: &Trace, period: f64) -> f64 {
    let steps = trace.times().windows(2).map(|pair| pair[1] - pair[0]).collect();
    median(steps).map_or(f64::INFINITY, |step| period / step)
}

/// One where rows have none.
fn typical_uncertainty(trace: &Trace) -> f64 {
    trace.uncertainties().and_then(|column| median(column.to_vec())).unwrap_or(1.0)
}

impl Landmarks {
    fn period(&self) -> Option<f64> {
        let periods = self.passages.windows(3).filter_map(|three| Some(three[2]?.time - three[0]?.time));
        median(periods.collect())
    }
}

/// What all stretches show together; passages and extremes are numbered through.
#[derive(Default)]
struct Found {
    passages: Vec<Option<Passage>>,
    extremes: Vec<Option<Extreme>>,
    /// Numbers of the first passage and of the first extreme of each possible cycle.
    cycles: Vec<(usize, usize)>,
}

impl Found {
    /// Of stretches whose noise is in units of these uncertainties of the rows.
    fn new(stretches: &[Landmarks], uncertainty: f64) -> Self {
        let mut found = Self::default();
        for stretch in stretches {
            let (passage, extreme) = (found.passages.len(), found.extremes.len());
            let cycles = stretch.passages.len().saturating_sub(2);
            found.cycles.extend((0..cycles).map(|k| (passage + k, extreme + k)));
            found.passages.extend(&stretch.passages);
            let bright = |extreme: &Extreme| extreme.value.abs() >= FAINTEST * stretch.noise * uncertainty;
            found.extremes.extend(stretch.extremes.iter().map(|extreme| extreme.filter(bright)));
        }
        found
    }

    /// The half swings by number, where they are known and do not lead over the top.
    fn half_swings(&self, observable: Observable, omega0: f64) -> Vec<Option<HalfSwing>> {
        let half_swing = |extreme: &Extreme| {
            let (time, size) = (extreme.time, extreme.value.abs());
            let (amplitude, slope) = match observable {
                Observable::Angle => (size, 1.0),
                Observable::AngularVelocity => {
                    let amplitude = amplitude_of_velocity(size, omega0)?;
                    (amplitude, slope_of_amplitude(amplitude, omega0))
                }
            };
            let amplitude = Uncertain { value: amplitude, uncertainty: slope * extreme.uncertainty };
            (amplitude.value < PI).then_some(HalfSwing { time, amplitude })
        };
        self.extremes.iter().map(|extreme| half_swing(extreme.as_ref()?)).collect()
    }

    /// The cycles that are complete.
    fn rows(&self, half_swings: &[Option<HalfSwing>]) -> Vec<Row> {
        let row = |&(passage, extreme): &(usize, usize)| {
            let ends = [passage, passage + 2].map(|k| self.passages[k].map(|found| (k, found)));
            let sides = [extreme, extreme + 1].map(|k| half_swings[k].map(|found| (k, found)));
            let ([Some(begin), Some(end)], [Some(one), Some(two)]) = (ends, sides) else { return None };
            let square = |x: f64| x * x;
            Some(Row::new(
                [begin.1.time, end.1.time],
                [begin, end].map(|(k, passage)| (k, square(passage.uncertainty))),
                [one, two].map(|(k, side)| Side::new(k, side.amplitude)),
            ))
        };
        self.cycles.iter().filter_map(row).collect()
    }
}

/// The half swings and the cycles; of a trace of velocities with the ω0 that goes with both.
fn settled(found: &Found, observable: Observable, longest: f64) -> (Vec<Option<HalfSwing>>, Vec<Row>) {
    let t0 = match observable {
        Observable::Angle => longest,
        Observable::AngularVelocity => t0_of_velocities(found, longest),
    };
    let half_swings = found.half_swings(observable, TAU / t0);
    let rows = found.rows(&half_swings);
    (half_swings, rows)
}

/// The T0 that the cycles have by the amplitudes that the fastest velocities have by this T0. With a larger T0 the
/// amplitudes are larger and the cycles say a smaller one, so that there is one answer between 0 and the period.
fn t0_of_velocities(found: &Found, period: f64) -> f64 {
    let complete = found.rows(&found.half_swings(Observable::AngularVelocity, f64::INFINITY)).len();
    let [t0, _] = bisect([0.1 * period, period], Tolerance::absolute(1e-12 * period), |t0| {
        let half_swings = found.half_swings(Observable::AngularVelocity, TAU / t0);
        let rows = found.rows(&half_swings);
        // Cycles that would lead over the top say that T0 is smaller, whatever their number.
        let beyond = vec![0.0; complete.saturating_sub(rows.len())];
        let said = rows.iter().map(Row::small_angle_period).chain(beyond).collect();
        median(said).is_some_and(|said| said > t0)
    });
    t0
}

impl Cycle {
    fn new(row: &Row, scatter: Scatter, outlier: bool) -> Self {
        let [one, two] = row.sides;
        Self {
            time: row.time,
            period: Uncertain {
                value: row.period,
                uncertainty: (scatter.noise * row.period_variance() + scatter.fluctuation).sqrt(),
            },
            amplitude: Uncertain {
                value: 0.5 * (one.amplitude + two.amplitude),
                uncertainty: 0.5 * (one.variance + two.variance).sqrt(),
            },
            period_ratio: row.ratio,
            outlier,
        }
    }
}

/// What a reader should know about how the cycles were come by.
fn warnings(
    found: &Found,
    rows: &[Row],
    outliers: usize,
    swings: &Swings,
    centre: &Centre,
    observable: Observable,
) -> Vec<CyclesWarning> {
    let incomplete = found.cycles.len() - rows.len();
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
