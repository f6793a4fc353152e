//! From passages to periods and T0.

use std::f64::consts::{PI, TAU};

use super::directions::{Placed, Sorted, sorted};
use super::passages::{Passages, passages};
use super::speeds::amplitude;
use super::trend::at_the_beginning;
use super::{GateCycle, GateOptions, GatesError, GatesFit, T0Source};
use crate::fit::Law;
use crate::fit::cycles::{Beta, period_law};
use crate::fit::robust::{median, robust_deviation};
use crate::fit::small_angle_period::count;
use crate::pendulum::Amplitude;
use crate::quantity::Quantity;
use period_law::{Row, Side};

/// What the times of a gate say; the states of the gate, blocked or not, where they are known.
///
/// # Errors
/// See [`GatesError`]: too few passages, or none of a pendulum.
///
/// # Examples
/// ```
/// use libration::fit::gates::{GateOptions, gates};
/// // A period of 2 s, and a gate off the centre.
/// let times: Vec<f64> = (0..10).flat_map(|k| [2.0 * f64::from(k), 2.0 * f64::from(k) + 1.2]).collect();
/// let found = gates(&times, None, &GateOptions::default())?;
/// assert!((found.mean_period.value - 2.0).abs() < 1e-12 && (found.part_between - 0.6).abs() < 1e-12);
/// # Ok::<(), libration::fit::gates::GatesError>(())
/// ```
pub fn gates(times: &[f64], blocked: Option<&[bool]>, options: &GateOptions) -> Result<GatesFit, GatesError> {
    options.check()?;
    let found = passages(times, blocked, options.signals)?;
    let seen = found.passages.len();
    let sides = sorted(&found.passages).ok_or(GatesError::TooFew { passages: seen })?;
    if 2 * sides.placed.len() < seen {
        return Err(GatesError::Irregular { passages: seen, accepted: sides.placed.len() });
    }
    let swings = Swings::new(sides.placed.clone());
    if swings.cycles.len() < 2 {
        return Err(GatesError::TooFew { passages: sides.placed.len() });
    }
    Ok(swings.fit(&found, &sides, options))
}

impl GateOptions {
    fn check(&self) -> Result<(), GatesError> {
        for (name, quantity, limit, below) in [
            ("angular width of the bob", self.width, PI, " and below pi"),
            ("amplitude", self.amplitude, PI, " and below pi"),
        ] {
            if let Some(quantity) =
                quantity.filter(|quantity| !(quantity.value > 0.0 && quantity.value < limit))
            {
                return Err(GatesError::NotUsable { name, value: quantity.value, below });
            }
        }
        Ok(())
    }
}

/// Passages in order, and the cycles among them: three passages of alternating sides without a gap, by the first one.
struct Swings {
    placed: Vec<Placed>,
    cycles: Vec<usize>,
}

impl Swings {
    fn new(placed: Vec<Placed>) -> Self {
        let whole = |k: &usize| {
            let [first, between, last] = [0, 1, 2].map(|step| placed[*k + step]);
            first.side == last.side && first.turn + 1 == last.turn && between.side != first.side
        };
        let cycles = (0..placed.len().saturating_sub(2)).filter(whole).collect();
        Self { placed, cycles }
    }

    fn time(&self, passage: usize) -> f64 {
        self.placed[passage].passage.time
    }

    fn period(&self, cycle: usize) -> f64 {
        self.time(cycle + 2) - self.time(cycle)
    }

    fn fit(&self, found: &Passages, sides: &Sorted, options: &GateOptions) -> GatesFit {
        let periods: Vec<f64> = self.cycles.iter().map(|&cycle| self.period(cycle)).collect();
        let times: Vec<f64> = self.cycles.iter().map(|&cycle| self.time(cycle + 1)).collect();
        let mean = periods.iter().sum::<f64>() / count(periods.len());
        let scatter = periods.iter().map(|period| (period - mean) * (period - mean)).sum::<f64>();
        let spread = (scatter / count(periods.len() - 1) / count(periods.len())).sqrt();
        let amplitudes = options.width.map(|width| self.amplitudes(width.value));
        let by_speeds =
            options.width.zip(amplitudes.as_ref()).and_then(|(width, a)| self.by_speeds(width, a));
        let first_period = at_the_beginning(&times, &periods, self.time(0));
        let by_amplitude =
            first_period.zip(options.amplitude).map(|(period, a)| by_first_amplitude(period, a));
        let (t0, t0_source) = match (&by_speeds, by_amplitude) {
            (Some(speeds), _) => (Some(speeds.t0), Some(T0Source::Speeds)),
            (None, Some(t0)) => (Some(t0), Some(T0Source::FirstAmplitude)),
            (None, None) => (None, None),
        };
        let amplitude_of = |cycle: usize| amplitudes.as_ref().and_then(|a| a.of_cycle(cycle));
        let cycle = |&cycle: &usize| GateCycle {
            time: 0.5 * (self.time(cycle) + self.time(cycle + 2)),
            period: self.period(cycle),
            side: self.placed[cycle].side,
            amplitude: amplitude_of(cycle),
        };
        let mut fit = GatesFit {
            passages: found.passages.len(),
            edges: found.edges,
            unpaired: found.unpaired,
            double_triggers: sides.spurious,
            missed: sides.missed,
            cycles: self.cycles.iter().map(cycle).collect(),
            part_between: self.part_between(),
            timing: self.timing(),
            mean_period: Quantity { value: mean, uncertainty: Some(spread) },
            first_period,
            t0,
            t0_source,
            amplitude: by_speeds
                .as_ref()
                .map_or(options.amplitude.map(|a| a.value), |speeds| speeds.amplitude),
            beta: by_speeds.and_then(|speeds| speeds.beta),
            warnings: vec![],
        };
        fit.warnings = warnings(&fit, options);
        fit
    }

    /// The part of a period from the first side to the other.
    fn part_between(&self) -> f64 {
        let first_side = self.cycles.iter().filter(|&&cycle| self.placed[cycle].side == 0);
        let part = |cycle: &usize| (self.time(cycle + 1) - self.time(*cycle)) / self.period(*cycle);
        median(first_side.map(part).collect()).unwrap_or(f64::NAN)
    }

    /// How far from the bottom in time the gate is passed in a cycle: passages are T/2 ± 2τ apart.
    fn from_bottom(&self, cycle: usize) -> f64 {
        let period = self.period(cycle);
        0.5 * (0.5 * period - (self.time(cycle + 1) - self.time(cycle))).abs()
    }

    /// The standard deviation of a time, by second differences of the passages of one side: √(1 + 4 + 1) of it.
    fn timing(&self) -> f64 {
        let whole =
            |k: usize| self.cycles.binary_search(&k).is_ok() && self.cycles.binary_search(&(k + 2)).is_ok();
        let second = |k: usize| self.time(k + 4) - 2.0 * self.time(k + 2) + self.time(k);
        let differences: Vec<f64> =
            (0..self.placed.len().saturating_sub(4)).filter(|&k| whole(k)).map(second).collect();
        robust_deviation(&differences).unwrap_or(0.0) / 6.0_f64.sqrt()
    }

    /// The amplitudes of all passages by their speeds, with the T0 that goes with them.
    fn amplitudes(&self, width: f64) -> Amplitudes {
        let longest = self.cycles.iter().map(|&cycle| self.period(cycle)).fold(0.0, f64::max);
        let (mut below, mut above) = (0.1 * longest, longest);
        // With a larger T0 the amplitudes are larger and the periods say a smaller one.
        while above - below > 1e-12 * longest {
            let middle = 0.5 * (below + above);
            let amplitudes = self.amplitudes_for(width, middle);
            let said = self.cycles.iter().map(|&cycle| {
                let ratio = amplitudes.of_cycle(cycle).map_or(f64::INFINITY, |a| Law::exact().ratio_at(a));
                self.period(cycle) / ratio
            });
            let larger = median(said.collect()).is_some_and(|said| said > middle);
            *(if larger { &mut below } else { &mut above }) = middle;
        }
        self.amplitudes_for(width, below)
    }

    fn amplitudes_for(&self, width: f64, t0: f64) -> Amplitudes {
        let mut of_passages = vec![None; self.placed.len()];
        for &cycle in &self.cycles {
            let from_bottom = self.from_bottom(cycle);
            for passage in cycle..cycle + 3 {
                let blocked = self.placed[passage].passage.blocked;
                of_passages[passage] = blocked.and_then(|time| amplitude(TAU / t0, width, time, from_bottom));
            }
        }
        Amplitudes { of_passages }
    }

    fn by_speeds(&self, width: Quantity, amplitudes: &Amplitudes) -> Option<BySpeeds> {
        let variance = self.timing() * self.timing();
        let noise = amplitudes.noise(self);
        let row = |&cycle: &usize| {
            let side = |k: usize| Some(Side::new(k, amplitudes.of_half_swing(k)?, noise));
            let ends = [cycle, cycle + 2];
            // A clock without any scatter would leave nothing to weigh by.
            let passages = ends.map(|k| (k, variance.max(1e-24)));
            Some(Row::new(ends.map(|k| self.time(k)), passages, [side(cycle)?, side(cycle + 1)?]))
        };
        let rows: Vec<Row> = self.cycles.iter().filter_map(row).collect();
        let law = period_law::exact(&rows)?;
        let ratio = rows.iter().map(|row| row.ratio).sum::<f64>() / count(rows.len());
        let typical = Amplitude::from_period_ratio(ratio).ok()?.radians();
        // All amplitudes are wrong by the same factor when the width is.
        let relative = width.uncertainty.unwrap_or(0.0) / width.value;
        let change = 2.0 * libm::tan(0.5 * typical) * relative;
        let by_width = law.t0 * Law::exact().slope_at(typical) * change / ratio;
        let uncertainty = Some(libm::hypot(law.t0_uncertainty, by_width));
        let t0 = Quantity { value: law.t0, uncertainty };
        Some(BySpeeds { t0, beta: period_law::beta(&rows).ok(), amplitude: Some(typical) })
    }
}

struct BySpeeds {
    t0: Quantity,
    beta: Option<Beta>,
    amplitude: Option<f64>,
}

/// The amplitude at each passage, in radians.
struct Amplitudes {
    of_passages: Vec<Option<f64>>,
}

impl Amplitudes {
    fn of_half_swing(&self, passage: usize) -> Option<f64> {
        Some(0.5 * (self.of_passages[passage]? + self.of_passages[passage + 1]?))
    }

    fn of_cycle(&self, cycle: usize) -> Option<f64> {
        Some(0.5 * (self.of_half_swing(cycle)? + self.of_half_swing(cycle + 1)?))
    }

    /// The standard deviation of the amplitude of a half swing, by second differences along one side.
    fn noise(&self, swings: &Swings) -> f64 {
        let second = |&k: &usize| {
            let [first, middle, last] = [k, k + 2, k + 4].map(|k| self.of_passages.get(k).copied().flatten());
            Some(first? - 2.0 * middle? + last?)
        };
        let differences: Vec<f64> = swings.cycles.iter().filter_map(second).collect();
        robust_deviation(&differences).unwrap_or(0.0) / 12.0_f64.sqrt()
    }
}

/// T0 from the first period and the amplitude it had.
fn by_first_amplitude(period: Quantity, amplitude: Quantity) -> Quantity {
    let ratio = Law::exact().ratio_at(amplitude.value);
    let slope = Law::exact().slope_at(amplitude.value);
    let relative = libm::hypot(
        period.uncertainty.unwrap_or(0.0) / period.value,
        slope * amplitude.uncertainty.unwrap_or(0.0) / ratio,
    );
    let value = period.value / ratio;
    Quantity { value, uncertainty: Some(value * relative) }
}

fn warnings(fit: &GatesFit, options: &GateOptions) -> Vec<String> {
    let mut warnings = vec![];
    let mut say = |count: usize, what: &str| {
        if count > 0 {
            warnings.push(format!("{count} {what}"));
        }
    };
    say(fit.unpaired, "edges of the gate lack the other edge and are left out");
    say(fit.double_triggers, "passages fit no pendulum (double triggers) and are left out");
    say(fit.missed, "passages are missing; periods across them are left out");
    if options.width.is_some() && fit.t0_source != Some(T0Source::Speeds) {
        let why = if fit.edges {
            "lead over the top: check the width of the bob"
        } else {
            "are not known: the times are not edges"
        };
        warnings.push(format!("the width of the bob is of no use: the speeds at the gate {why}"));
    }
    if fit.t0.is_none() {
        warnings.push(
            "the period of small swings is not known without an amplitude: give that of the first swing, or the width of \
             the bob"
                .to_owned(),
        );
    }
    let last = fit.cycles.last().map(|cycle| cycle.period);
    let too_short =
        |t0: Quantity, last: f64| t0.value - 3.0 * t0.uncertainty.unwrap_or(0.0) > last + 6.0 * fit.timing;
    if fit.t0.zip(last).is_some_and(|(t0, last)| too_short(t0, last)) {
        warnings.push(
            "the last period is below T0, which no pendulum has: check the amplitude or the width".to_owned(),
        );
    }
    warnings
}
