//! Amplitude and period of a damped pendulum against time.

use super::chart::{Axis, Panel, Picture, Point, Series, Units};
use super::range::around;
use super::style;
use libration::comparison::SlowDecay;
use libration::decay::{Decay, DecayEnvelope, EnvelopeLaw, TurningPoint};
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

const SAMPLES: u32 = 400;

/// A cycle that was measured, in seconds.
pub(crate) struct MeasuredCycle {
    pub(crate) middle: f64,
    pub(crate) duration: f64,
}

/// The turning points between both laws; below, the times of the cycles with the exact period of the averaged amplitude.
///
/// The slow flow is drawn with both laws where it is given, and its cycles with the exact period.
pub(crate) fn dying_swings(
    decay: &Decay,
    slow: Option<&SlowDecay>,
    turns: &[TurningPoint],
    cycles: &[MeasuredCycle],
) -> Picture {
    let (_, to) = around(turns.iter().map(|turn| turn.time));
    let times: Vec<f64> = (0..=SAMPLES).map(|step| to * f64::from(step) / f64::from(SAMPLES)).collect();
    let x = Axis::linear("time t / s", 0.0, to);
    let unlabelled = x.unlabelled();
    let amplitudes = amplitudes(decay, slow, turns, &times);
    let periods = periods(decay, slow, cycles, &times);
    let panel = |x: Axis, label: &str, series: Vec<Series>, share: f64| {
        let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
        Panel { x, y: Axis::linear(label, low, high), series, share }
    };
    let mut above = panel(unlabelled, "amplitude / degrees", amplitudes, 0.58);
    above.y = above.y.in_units(Units::Degrees);
    above.y.from = above.y.from.max(0.0);
    Picture::new("Decay of a damped pendulum", vec![above, panel(x, "period / s", periods, 0.42)])
}

fn amplitudes(decay: &Decay, slow: Option<&SlowDecay>, turns: &[TurningPoint], times: &[f64]) -> Vec<Series> {
    let curve = |label: &str, look, envelope: DecayEnvelope<'_>| {
        Series::line(label, look, times.iter().map(|&time| (time, envelope.amplitude_at(time).to_degrees())))
    };
    let point = |turn: &TurningPoint| Point::new(turn.time, turn.amplitude.radians().to_degrees());
    let laws = [
        curve("averaged", style::curve(0), decay.envelope(EnvelopeLaw::Averaged)),
        curve("law of small amplitudes", style::curve(1), decay.envelope(EnvelopeLaw::SmallAmplitude)),
    ];
    let slow = slow.map(|slow| {
        let places = slow.at_times(times).into_iter().filter(|moment| moment.amplitude.is_finite());
        let degrees = places.map(|moment| (moment.time, moment.amplitude.to_degrees()));
        Series::line("slow flow", style::curve(3), degrees)
    });
    let turns = markers("turning points", turns.iter().map(point).collect());
    laws.into_iter().chain(slow).chain([turns]).collect()
}

/// The times of the cycles of the slow flow, each at its middle, within the axis.
fn slow_cycles(slow: &SlowDecay, cycles: usize) -> Series {
    let turns = slow.turning_points(2 * cycles + 1);
    let whole = turns.windows(3).step_by(2);
    let points = whole.map(|turns| (turns[1].time, turns[2].time - turns[0].time));
    Series::line("cycles of the slow flow", style::curve(3), points)
}

/// The periods of the cycles, each at the middle of its cycle.
fn periods(decay: &Decay, slow: Option<&SlowDecay>, cycles: &[MeasuredCycle], times: &[f64]) -> Vec<Series> {
    let (pendulum, envelope) = (decay.pendulum(), decay.envelope(EnvelopeLaw::Averaged));
    let exact = times.iter().filter_map(|&time| {
        let amplitude = Amplitude::new(Angle::from_radians(envelope.amplitude_at(time)).ok()?).ok()?;
        Some((time, pendulum.period(&amplitude)))
    });
    let ends = [times.first(), times.last()]
        .map(|time| (time.copied().unwrap_or(0.0), pendulum.small_angle_period()));
    let slow = slow.map(|slow| slow_cycles(slow, cycles.len()));
    let cycles = cycles.iter().map(|cycle| Point::new(cycle.middle, cycle.duration));
    let exact = [
        Series::line("exact T of the averaged amplitude", style::curve(2), exact),
        Series::line("T₀", style::reference(), ends),
    ];
    exact.into_iter().chain(slow).chain([markers("times of cycles", cycles.collect())]).collect()
}

fn markers(label: &str, points: Vec<Point>) -> Series {
    Series { label: label.to_owned(), look: style::turning_points(points.len()), points }
}
