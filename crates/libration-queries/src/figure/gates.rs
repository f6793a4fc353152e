//! Periods by a photogate against time, and against the amplitude where speeds tell it.

use super::chart::{Axis, Look, Panel, Picture, Point, Series, Units};
use super::parameters::estimate;
use super::range::{around, around_bars};
use super::style;
use libration_lab::fit::Law;
use libration_lab::fit::gates::{GateCycle, GatesFit};

const SAMPLES: u32 = 300;

/// Periods against time; below, against the amplitude with the exact law.
pub(crate) fn periods(fit: &GatesFit) -> Picture {
    let amplitudes: Vec<(f64, f64)> =
        fit.cycles.iter().filter_map(|cycle| Some((cycle.amplitude?.to_degrees(), cycle.period))).collect();
    let mut panels = vec![against_time(fit)];
    if let (Some(t0), false) = (fit.t0, amplitudes.is_empty()) {
        panels.push(against_amplitude(&amplitudes, t0.value, fit.timing));
    }
    let share = if panels.len() > 1 { 0.5 } else { 1.0 };
    let picture = Picture::new(
        "Periods by a photogate",
        panels.into_iter().map(|panel| Panel { share, ..panel }).collect(),
    );
    picture.with_parameters(fit.t0.map(|t0| estimate("T₀", t0, "s")))
}

fn against_time(fit: &GatesFit) -> Panel {
    // A period is the difference of two times.
    let uncertainty = fit.timing.map(|timing| std::f64::consts::SQRT_2 * timing);
    let of_side = |side: usize| -> Vec<Point> {
        let cycles = fit.cycles.iter().filter(|cycle| cycle.side == side);
        let point =
            |cycle: &GateCycle| Point { y_uncertainty: uncertainty, ..Point::new(cycle.time, cycle.period) };
        cycles.map(point).collect()
    };
    let (from, to) = around(fit.cycles.iter().map(|cycle| cycle.time));
    let sides = ["one side", "the other side"].into_iter().enumerate().map(|(side, label)| {
        let points = of_side(side);
        let look = style::measurements_of(side, points.len());
        Series { label: label.to_owned(), look, points }
    });
    let all = [of_side(0), of_side(1)].concat();
    Panel {
        x: Axis::linear("time t / s", from, to),
        y: vertical(&all),
        series: law_in_time(fit).into_iter().chain(sides).collect(),
        share: 1.0,
    }
}

/// The exact period of the amplitude that the speed at the gate tells.
fn law_in_time(fit: &GatesFit) -> Option<Series> {
    let t0 = fit.t0?.value;
    let at = |cycle: &GateCycle| Some((cycle.time, t0 * Law::exact().ratio_at(cycle.amplitude?)));
    let points: Vec<(f64, f64)> = fit.cycles.iter().filter_map(at).collect();
    let look = Look { width: 1.2, colour: style::INK, ..style::exact_law() };
    (!points.is_empty()).then(|| Series::line("exact law, amplitudes by the speed", look, points))
}

fn against_amplitude(measured: &[(f64, f64)], t0: f64, timing: Option<f64>) -> Panel {
    let (from, to) = around(measured.iter().map(|row| row.0));
    let (from, to) = (from.max(0.0), to.min(180.0));
    let law = (0..=SAMPLES).map(|step| {
        let degrees = from + (to - from) * f64::from(step) / f64::from(SAMPLES);
        (degrees, t0 * Law::exact().ratio_at(degrees.to_radians()))
    });
    let bar = timing.map(|timing| std::f64::consts::SQRT_2 * timing);
    let points = measured.iter().map(|&(x, y)| Point { y_uncertainty: bar, ..Point::new(x, y) });
    let points: Vec<Point> = points.collect();
    let look = style::measurements(points.len());
    Panel {
        x: Axis::linear("amplitude θ₀ / degrees", from, to).in_units(Units::Degrees),
        y: vertical(&points),
        series: vec![
            Series::line("exact law", style::exact_law(), law.collect::<Vec<_>>()),
            Series { label: "measured".to_owned(), look, points },
        ],
        share: 1.0,
    }
}

fn vertical(points: &[Point]) -> Axis {
    let (low, high) = around_bars(points, &[]);
    Axis::linear("period T / s", low, high)
}
