//! Period against amplitude, and amplitude against time, cycle by cycle.

use super::super::chart::{Axis, Look, Panel, Picture, Point, Series, Units};
use super::super::range::around;
use super::super::style;
use libration_lab::fit::Law;
use libration_lab::fit::cycles::{Cycle, HalfSwing};

const SAMPLES: u32 = 400;
/// Largest number of cycles with bars of uncertainty; more bars would hide them.
const MANY: usize = 150;

/// The cycles of one trace, with the name of the trace; the name of a single trace is empty.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swings<'a> {
    pub(crate) name: &'a str,
    pub(crate) cycles: &'a [Cycle],
}

/// Period against amplitude, with the exact law of this T0, the constant period, and the law with the fitted β.
pub(crate) fn periods(swings: &[Swings<'_>], t0: f64, beta: Option<(f64, f64)>) -> Picture {
    let count = swings.iter().map(|swing| swing.cycles.len()).sum::<usize>();
    let amplitudes =
        swings.iter().flat_map(|swing| swing.cycles.iter().map(|cycle| cycle.amplitude.value.to_degrees()));
    let (_, to) = around(amplitudes.chain([0.0]));
    let to = to.min(180.0);
    let data: Vec<Series> =
        swings.iter().enumerate().map(|(number, swing)| measured(number, swing, count)).collect();
    let curve = |ratio: &dyn Fn(f64) -> f64, t0: f64| {
        let degrees = (0..SAMPLES).map(|step| to * f64::from(step) / f64::from(SAMPLES));
        degrees.map(|x| (x, t0 * ratio(x.to_radians()))).collect::<Vec<_>>()
    };
    let exact = |amplitude| Law::exact().ratio_at(amplitude);
    let (low, high) = around(data.iter().flat_map(|series| series.points.iter().map(|p| p.y)).chain([t0]));
    let mut series = vec![
        Series::line("exact law", style::exact_law(), curve(&exact, t0)),
        Series::line("constant period", style::reference(), curve(&|_| 1.0, t0)),
    ];
    if let Some((beta, t0)) = beta {
        let bent = |amplitude| beta.mul_add(exact(amplitude) - 1.0, 1.0);
        series.push(Series::line("with the fitted β", style::curve(2), curve(&bent, t0)));
    }
    series.extend(data);
    let x = Axis::linear("amplitude θ₀ / degrees", 0.0, to).in_units(Units::Degrees);
    let y = Axis::linear("period T / s", low, high);
    Picture::new("Period against amplitude", vec![Panel { x, y, series, share: 1.0 }])
}

fn measured(number: usize, swing: &Swings<'_>, count: usize) -> Series {
    let with_bars = |uncertainty: f64| (count <= MANY).then_some(uncertainty);
    let point = |cycle: &Cycle| Point {
        x: cycle.amplitude.value.to_degrees(),
        y: cycle.period.value,
        x_uncertainty: with_bars(cycle.amplitude.uncertainty.to_degrees()),
        y_uncertainty: with_bars(cycle.period.uncertainty),
    };
    let counted = swing.cycles.iter().filter(|cycle| !cycle.outlier);
    let label = if swing.name.is_empty() { "cycles" } else { swing.name };
    let look = Look { width: style::measurements(count).width, ..style::markers(number) };
    Series { label: label.to_owned(), points: counted.map(point).collect(), look }
}

/// The decay of the amplitude in the motion fitted by one model.
#[derive(Clone, Debug)]
pub(crate) struct Envelope {
    pub(crate) name: String,
    /// Amplitude of each half swing, in radians; NaN where the motion does not turn in it.
    pub(crate) amplitudes: Vec<f64>,
}

/// The amplitudes of the half swings with those of the chosen model and of others; below, all of them minus the
/// chosen one.
pub(crate) fn amplitudes(
    title: &str,
    half_swings: &[HalfSwing],
    chosen: Option<&Envelope>,
    others: &[Envelope],
) -> Picture {
    let times: Vec<f64> = half_swings.iter().map(|half| half.time).collect();
    let (from, to) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(1.0));
    let x = Axis::linear("time t / s", from, to);
    let sizes: Vec<f64> = half_swings.iter().map(|half| half.amplitude.value).collect();
    let law = |(model, look): (&Envelope, Look)| {
        let sizes = model.amplitudes.iter().map(|amplitude| amplitude.to_degrees());
        Series::line(&model.name, look, times.iter().copied().zip(sizes))
    };
    let mut above: Vec<Series> = models(chosen, others).map(law).collect();
    above.push(of_half_swings("half swings", half_swings, &sizes));
    let (low, high) = around(sizes.iter().map(|size| size.to_degrees()));
    let y = Axis::linear("amplitude / degrees", low.max(0.0), high).in_units(Units::Degrees);
    let Some(chosen) = chosen else {
        return Picture::new(title, vec![Panel { x, y, series: above, share: 1.0 }]);
    };
    let unlabelled = x.unlabelled();
    let above = Panel { x: unlabelled, y, series: above, share: 0.55 };
    Picture::new(title, vec![above, differences(x, half_swings, chosen, others)])
}

fn models<'a>(
    chosen: Option<&'a Envelope>,
    others: &'a [Envelope],
) -> impl Iterator<Item = (&'a Envelope, Look)> {
    const OTHERS: [usize; 5] = [0, 2, 3, 5, 6];
    let looks = OTHERS.into_iter().cycle().map(style::curve);
    others.iter().zip(looks).chain(chosen.map(|model| (model, style::exact_law())))
}

fn differences(x: Axis, half_swings: &[HalfSwing], chosen: &Envelope, others: &[Envelope]) -> Panel {
    let less = |sizes: &[f64]| -> Vec<f64> {
        sizes.iter().zip(&chosen.amplitudes).map(|(size, chosen)| size - chosen).collect()
    };
    let sizes: Vec<f64> = half_swings.iter().map(|half| half.amplitude.value).collect();
    let measured = less(&sizes);
    let law = |(model, look): (&Envelope, Look)| {
        let points = less(&model.amplitudes).into_iter().map(f64::to_degrees);
        Series::line("", look, half_swings.iter().map(|half| half.time).zip(points))
    };
    let mut series: Vec<Series> = models(Some(chosen), others).map(law).collect();
    series.push(of_half_swings("", half_swings, &measured));
    let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
    Panel { x, y: Axis::linear("less the fitted one / degrees", low, high), series, share: 0.45 }
}

fn of_half_swings(label: &str, half_swings: &[HalfSwing], sizes: &[f64]) -> Series {
    let look = style::turning_points(half_swings.len());
    let with_bars = half_swings.len() <= MANY;
    let point = |(half, size): (&HalfSwing, &f64)| Point {
        x: half.time,
        y: size.to_degrees(),
        x_uncertainty: None,
        y_uncertainty: with_bars.then_some(half.amplitude.uncertainty.to_degrees()),
    };
    Series { label: label.to_owned(), look, points: half_swings.iter().zip(sizes).map(point).collect() }
}
