//! From passages to periods and T0.

use std::f64::consts::{PI, TAU};

use super::directions::{Placed, Sorted, sorted};
use super::passages::{Passages, passages};
use super::speeds::amplitude;
use super::trend::at_the_beginning;
use super::{GateCycle, GateOptions, GatesError, GatesFit, T0Source};
use crate::elliptic::Modulus;
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
        let mean = periods.iter().sum::<f64>() / count(periods.len());
        let scatter = periods.iter().map(|period| (period - mean) * (period - mean)).sum::<f64>();
        let spread = (scatter / count(periods.len() - 1) / count(periods.len())).sqrt();
        let amplitudes = options.width.map(|width| self.amplitudes(width.value));
        let by_speeds =
            options.width.zip(amplitudes.as_ref()).and_then(|(width, a)| self.by_speeds(width, a));
        let (times, both_sides) = self.mean_periods();
        let first_period = at_the_beginning(&times, &both_sides, self.time(0) - 0.25 * mean);
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

    /// The standard deviation of a time, by fourth differences of the passages of one side, from which a period that falls
    /// steadily drops out.
    fn timing(&self) -> f64 {
        self.deviation(|passage| Some(self.time(passage)))
    }

    /// The standard deviation of a quantity of passages about its course along one side.
    fn deviation(&self, of: impl Fn(usize) -> Option<f64>) -> f64 {
        let whole = |&k: &usize| (0..4).all(|step| self.cycles.binary_search(&(k + 2 * step)).is_ok());
        let fourth = |k: usize| {
            let terms = [1.0, -4.0, 6.0, -4.0, 1.0].into_iter().enumerate();
            terms.map(|(step, weight)| of(k + 2 * step).map(|value| weight * value)).sum::<Option<f64>>()
        };
        let differences: Vec<f64> = self.cycles.iter().copied().filter(whole).filter_map(fourth).collect();
        // √(1 + 16 + 36 + 16 + 1) times that of one.
        robust_deviation(&differences).unwrap_or(0.0) / 70.0_f64.sqrt()
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
        Amplitudes { of_passages, omega0: TAU / t0 }
    }

    fn by_speeds(&self, width: Quantity, amplitudes: &Amplitudes) -> Option<BySpeeds> {
        let variance = self.timing() * self.timing();
        let noise = amplitudes.noise(self);
        let gate = self.gate_height(amplitudes)?;
        let row = |&cycle: &usize| {
            let side = |k: usize| Some(Side::new(k, amplitudes.of_half_swing(k)?, noise));
            let ends = [cycle, cycle + 2];
            let [begin, end] = ends.map(|k| self.bottom_time(k, amplitudes, gate));
            // A clock without any scatter would leave nothing to weigh by.
            let passages = ends.map(|k| (k, variance.max(1e-24)));
            Some(Row::new([begin?, end?], passages, [side(cycle)?, side(cycle + 1)?]))
        };
        let rows: Vec<Row> = self.cycles.iter().filter_map(row).collect();
        let law = period_law::exact(&rows)?;
        let ratio = rows.iter().map(|row| row.ratio).sum::<f64>() / count(rows.len());
        let typical = Amplitude::from_period_ratio(ratio).ok()?.radians();
        // When the width is wrong all speeds are, by the same factor; T0 takes a part of it back.
        let relative = width.uncertainty.unwrap_or(0.0) / width.value;
        let slope = Law::exact().slope_at(typical) * 2.0 * libm::tan(0.5 * typical);
        let (by_period, by_excess) = (slope / ratio, slope / (ratio - 1.0));
        let change = relative / (1.0 + by_period);
        let widened = |own: f64, by_width: f64| libm::hypot(own, by_width * change);
        let uncertainty = Some(widened(law.t0_uncertainty, law.t0 * by_period));
        let beta = period_law::beta(&rows).ok();
        let widen =
            |beta: Beta| Beta { uncertainty: widened(beta.uncertainty, beta.beta * by_excess), ..beta };
        let t0 = Quantity { value: law.t0, uncertainty };
        Some(BySpeeds { t0, beta: beta.map(widen), amplitude: Some(typical) })
    }

    /// The sine of half the angle of the gate, on the side to which the passages of the first side go, by the unevenness
    /// of the passages.
    fn gate_height(&self, amplitudes: &Amplitudes) -> Option<f64> {
        let height = |&cycle: &usize| {
            let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitudes.of_cycle(cycle)?)).ok()?;
            let outward = 0.5 * self.period(cycle) > self.time(cycle + 1) - self.time(cycle);
            let first_side = self.placed[cycle].side == 0;
            let height = modulus.modulus() * modulus.jacobi(amplitudes.omega0 * self.from_bottom(cycle)).sn;
            Some(if outward == first_side { height } else { -height })
        };
        median(self.cycles.iter().filter_map(height).collect())
    }

    /// When the bottom is passed, by the passage of a gate of this height.
    fn bottom_time(&self, passage: usize, amplitudes: &Amplitudes, gate: f64) -> Option<f64> {
        let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitudes.of_passages[passage]?)).ok()?;
        let sine = (gate / modulus.modulus()).clamp(-1.0, 1.0);
        let from_bottom = modulus.incomplete_first(libm::asin(sine)) / amplitudes.omega0;
        let outward = self.placed[passage].side == 0;
        Some(self.time(passage) + if outward { -from_bottom } else { from_bottom })
    }

    /// Means of the periods of both sides, from which the place of the gate drops out, with their times.
    fn mean_periods(&self) -> (Vec<f64>, Vec<f64>) {
        let neighbours = self.cycles.windows(2).filter(|pair| pair[0] + 1 == pair[1]);
        let mean = |pair: &[usize]| {
            let time = 0.5 * (self.time(pair[0] + 1) + self.time(pair[1] + 1));
            (time, 0.5 * (self.period(pair[0]) + self.period(pair[1])))
        };
        neighbours.map(mean).unzip()
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
    /// That goes with them.
    omega0: f64,
}

impl Amplitudes {
    fn of_half_swing(&self, passage: usize) -> Option<f64> {
        Some(0.5 * (self.of_passages[passage]? + self.of_passages[passage + 1]?))
    }

    fn of_cycle(&self, cycle: usize) -> Option<f64> {
        Some(0.5 * (self.of_half_swing(cycle)? + self.of_half_swing(cycle + 1)?))
    }

    /// The standard deviation of the amplitude of a half swing, the mean of two passages.
    fn noise(&self, swings: &Swings) -> f64 {
        swings.deviation(|passage| self.of_passages[passage]) / 2.0_f64.sqrt()
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
            warnings.push(format!("{what}: {count}"));
        }
    };
    say(fit.unpaired, "edges of the gate without the other edge, left out");
    say(fit.double_triggers, "passages that fit no pendulum (double triggers), left out");
    say(fit.missed, "passages that are missing; periods across them are left out");
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
