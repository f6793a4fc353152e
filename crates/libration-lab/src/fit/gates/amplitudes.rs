//! The amplitudes by the speeds at the gate, and T0 by these.

use std::f64::consts::TAU;

use super::speeds::amplitude;
use super::swings::Swings;
use crate::fit::cycles::period_law;
use crate::fit::cycles::row::{Row, Side};
use crate::fit::typical_amplitude::typical_amplitude;
use crate::fit::{Beta, Law, Uncertain};
use crate::statistics::count;
use crate::statistics::median;
use libration::elliptic::Modulus;
use libration::quantity::Quantity;
use libration::roots::{Tolerance, bisect};
use libration::watch::Watch;

/// What periods with their amplitudes tell.
pub(super) struct BySpeeds {
    pub(super) t0: Uncertain,
    /// ∂T0/∂(width), in s/rad.
    pub(super) t0_by_width: f64,
    /// Of the uncertainty of T0.
    pub(super) degrees_of_freedom: f64,
    pub(super) beta: Option<Beta>,
    pub(super) amplitude: Option<f64>,
}

/// The amplitude at each passage, in radians.
pub(super) struct Amplitudes {
    of_passages: Vec<Option<f64>>,
    /// That goes with them.
    omega0: f64,
}

impl Amplitudes {
    fn of_half_swing(&self, passage: usize) -> Option<f64> {
        Some(0.5 * (self.of_passages[passage]? + self.of_passages[passage + 1]?))
    }

    pub(super) fn of_cycle(&self, cycle: usize) -> Option<f64> {
        Some(0.5 * (self.of_half_swing(cycle)? + self.of_half_swing(cycle + 1)?))
    }

    /// The standard deviation of the amplitude of a half swing, the mean of two passages.
    fn noise(&self, swings: &Swings) -> f64 {
        swings.deviation(|passage| self.of_passages[passage]) / 2.0_f64.sqrt()
    }
}

impl Swings {
    /// The amplitudes of all passages by their speeds, with the T0 that goes with them.
    pub(super) fn amplitudes(&self, width: f64, watch: &Watch<'_>) -> Amplitudes {
        let longest = self.cycles.iter().map(|&cycle| self.period(cycle)).fold(0.0, f64::max);
        // With a larger T0 the amplitudes are larger and the periods say a smaller one.
        let [t0, _] = bisect([0.1 * longest, longest], Tolerance::absolute(1e-12 * longest), |t0| {
            let amplitudes = self.amplitudes_for(width, t0, watch);
            let said = self.cycles.iter().map(|&cycle| {
                let ratio = amplitudes.of_cycle(cycle).map_or(f64::INFINITY, |a| Law::exact().ratio_at(a));
                self.period(cycle) / ratio
            });
            median(said.collect()).is_some_and(|said| said > t0)
        });
        self.amplitudes_for(width, t0, watch)
    }

    fn amplitudes_for(&self, width: f64, t0: f64, watch: &Watch<'_>) -> Amplitudes {
        let mut of_passages = vec![None; self.placed.len()];
        for &cycle in self.cycles.iter().take_while(|_| watch.go_on().is_ok()) {
            let from_bottom = self.time_from_bottom(cycle);
            let passages = self.placed.iter().zip(&mut of_passages).skip(cycle).take(3);
            for (placed, found) in passages {
                let blocked = placed.passage.blocked;
                *found = blocked.and_then(|time| amplitude(TAU / t0, width, time, from_bottom));
            }
        }
        Amplitudes { of_passages, omega0: TAU / t0 }
    }

    /// T0 and the test of the exact law by the bottom passages and the amplitudes.
    pub(super) fn by_speeds(
        &self,
        width: Quantity,
        amplitudes: &Amplitudes,
        watch: &Watch<'_>,
    ) -> Option<BySpeeds> {
        /// The width is changed by this part of itself to see what follows it; with 1e-2 and 1e-4 nothing changed in 86 records.
        const STEP: f64 = 1e-3;
        let rows = self.rows_by_speeds(amplitudes)?;
        let law = period_law::exact(&rows, watch)?;
        let beta = period_law::beta(&rows, watch).ok();
        let typical = typical_amplitude(rows.iter().map(|row| row.ratio))?;
        // When the width is wrong all speeds are, by the same factor; T0 takes a part of it back.
        let [below, above] = [1.0 - STEP, 1.0 + STEP]
            .map(|factor| self.rows_by_speeds(&self.amplitudes(width.value * factor, watch)));
        let (below, above) = (below?, above?);
        let slope = |of: &dyn Fn(&[Row]) -> Option<f64>| {
            Some((of(&above)? - of(&below)?) / (2.0 * STEP * width.value))
        };
        let t0_by_width = slope(&|rows| Some(period_law::exact(rows, watch)?.t0.value))?;
        let beta_by_width = slope(&|rows| Some(period_law::beta(rows, watch).ok()?.factor.value));
        let spread = width.uncertainty.unwrap_or(0.0);
        let t0 = law.t0.with_error(t0_by_width * spread);
        let part_of_scatter = law.t0.uncertainty * law.t0.uncertainty / (t0.uncertainty * t0.uncertainty);
        let widen = |(beta, by_width): (Beta, f64)| Beta {
            factor: beta.factor.with_error(by_width * spread),
            ..beta
        };
        Some(BySpeeds {
            t0,
            t0_by_width,
            // After Welch and Satterthwaite: the width is taken as known, the scatter has its rows.
            degrees_of_freedom: count(rows.len() - 1) / (part_of_scatter * part_of_scatter),
            beta: beta.zip(beta_by_width).map(widen),
            amplitude: Some(typical),
        })
    }

    /// The cycles between passages of the bottom.
    fn rows_by_speeds(&self, amplitudes: &Amplitudes) -> Option<Vec<Row>> {
        let variance = self.timing() * self.timing();
        let noise = amplitudes.noise(self);
        let gate = self.gate_height(amplitudes)?;
        let row = |&cycle: &usize| {
            let side = |k: usize| {
                let value = amplitudes.of_half_swing(k)?;
                Some(Side::new(k, Uncertain { value, uncertainty: noise }))
            };
            let ends = [cycle, cycle + 2];
            let [begin, end] = ends.map(|k| self.bottom_time(k, amplitudes, gate));
            // A clock without any scatter would leave nothing to weigh by.
            let passages = ends.map(|k| (k, variance.max(1e-24)));
            Some(Row::new([begin?, end?], passages, [side(cycle)?, side(cycle + 1)?]))
        };
        Some(self.cycles.iter().filter_map(row).collect())
    }

    /// The sine of half the angle of the gate, on the side to which the passages of the first side go, by the unevenness
    /// of the passages.
    fn gate_height(&self, amplitudes: &Amplitudes) -> Option<f64> {
        let height = |&cycle: &usize| {
            let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitudes.of_cycle(cycle)?)).ok()?;
            let outward = 0.5 * self.period(cycle) > self.time(cycle + 1) - self.time(cycle);
            let first_side = self.placed[cycle].side == 0;
            let height =
                modulus.modulus() * modulus.jacobi(amplitudes.omega0 * self.time_from_bottom(cycle)).sn;
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
}
