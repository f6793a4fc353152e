//! The amplitude at each passage of a gate from its speed, with the position of the gate and the drag that are consistent with all of them.

use std::f64::consts::TAU;

use super::speeds::{NearBottom, mean_squared_velocity};
use super::swings::OrderedPassages;
use super::trend::value_and_slope;
use crate::fit::law::Law;
use crate::statistics::median;
use libration::internals::progress::Watch;
use libration::roots::{Tolerance, zero_between};

/// Rounds in which T0, the position of the gate and the drag are renewed. From 2 rad under 0.1/s the third moves T0 by 5e-10 s, the fourth by 1e-11
/// s.
const ROUNDS: usize = 4;

/// The amplitudes of all passages.
pub(super) struct Amplitudes {
    /// The amplitude by the speed at the bottom, in radians.
    pub(super) of_passages: Vec<Option<f64>>,
    /// The smooth course of the amplitudes through all neighbours, in radians.
    pub(super) smooth: Vec<Option<f64>>,
    /// Time of the passage of the gate after that of the bottom, in seconds.
    pub(super) from_bottom: Vec<f64>,
    /// The duration for which the gate is blocked, by the course of the amplitudes, in seconds.
    pub(super) blocked: Vec<f64>,
    /// Period of small swings that is consistent with the amplitudes, in seconds.
    pub(super) t0: f64,
    /// The fraction of the velocity at the bottom that is lost in a second.
    drag: Vec<f64>,
    /// Width of the bob, as an angle.
    width: f64,
}

impl Amplitudes {
    pub(super) fn of_half_swing(&self, passage: usize) -> Option<f64> {
        Some(0.5 * (self.of_passages[passage]? + self.of_passages[passage + 1]?))
    }

    pub(super) fn of_cycle(&self, cycle: usize) -> Option<f64> {
        Some(0.5 * (self.of_half_swing(cycle)? + self.of_half_swing(cycle + 1)?))
    }

    /// The median fraction of the velocity at the bottom that is lost in a second.
    pub(super) fn typical_drag(&self) -> f64 {
        median(self.drag.clone()).unwrap_or(0.0)
    }

    fn near_bottom(&self, passage: usize) -> NearBottom {
        NearBottom { omega0: TAU / self.t0, drag: self.drag[passage] }
    }

    /// T/T0 by the course of the amplitudes, in the half swing after a passage.
    fn ratio_after(&self, passage: usize) -> Option<f64> {
        Some(Law::exact().ratio_at(0.5 * (self.smooth[passage]? + self.smooth[passage + 1]?)))
    }
}

impl OrderedPassages {
    /// Computes the amplitudes of all passages by their speeds, with the T0 that is consistent with them.
    pub(super) fn amplitudes(&self, width: f64, watch: &Watch<'_>) -> Amplitudes {
        let passages = self.placed.len();
        let mut amplitudes = Amplitudes {
            of_passages: vec![None; passages],
            smooth: vec![None; passages],
            from_bottom: self.first_from_bottom(),
            blocked: vec![0.0; passages],
            t0: self.cycles.iter().map(|&cycle| self.period(cycle)).fold(0.0, f64::max),
            drag: vec![0.0; passages],
            width,
        };
        let mut at_middles: Vec<f64> =
            self.cycles.iter().map(|&cycle| amplitudes.from_bottom[cycle + 1]).collect();
        for round in 0..ROUNDS {
            if round > 0 {
                at_middles = self.cycles.iter().map(|&cycle| self.at_middle(cycle, &amplitudes)).collect();
            }
            amplitudes.t0 = self.consistent_t0(&amplitudes, watch).unwrap_or(amplitudes.t0);
            amplitudes.of_passages = self.by_speed(&amplitudes, amplitudes.t0, watch);
            self.follow(&mut amplitudes);
            self.set_gate(&mut amplitudes, &at_middles);
        }
        amplitudes.of_passages = self.by_speed(&amplitudes, amplitudes.t0, watch);
        amplitudes
    }

    /// Times from the bottom by the unevenness of the passages, at those in no middle of a cycle by the nearest that is.
    fn first_from_bottom(&self) -> Vec<f64> {
        let nearest = |passage: usize| {
            let cycle = self.cycles.iter().min_by_key(|&&cycle| (cycle + 1).abs_diff(passage));
            cycle.map_or(0.0, |&cycle| {
                0.5 * self.unevenness(cycle) * self.direction(cycle + 1) * self.direction(passage)
            })
        };
        (0..self.placed.len()).map(nearest).collect()
    }

    /// The time from the bottom at the middle passage of a cycle: half of its unevenness, without that by the fall of the amplitude from the first
    /// half swing to the second and without the change of the times from the bottom.
    fn at_middle(&self, cycle: usize, amplitudes: &Amplitudes) -> f64 {
        let [before, middle, after] = [0, 1, 2].map(|step| amplitudes.from_bottom[cycle + step]);
        let predicted = middle - 0.5 * (before + after);
        let fall = amplitudes.ratio_after(cycle).zip(amplitudes.ratio_after(cycle + 1));
        let by_fall = fall.map_or(0.0, |(first, second)| 0.25 * amplitudes.t0 * (first - second));
        middle + 0.5 * (self.unevenness(cycle) - by_fall - predicted)
    }

    /// T0 by the periods and the amplitudes that it gives them: with a larger one the amplitudes are larger and the T0 by the periods is smaller.
    fn consistent_t0(&self, amplitudes: &Amplitudes, watch: &Watch<'_>) -> Option<f64> {
        let longest = self.cycles.iter().map(|&cycle| self.period(cycle)).fold(0.0, f64::max);
        let excess = |t0: f64| {
            let of_passages = self.by_speed(amplitudes, t0, watch);
            let half = |passage: usize| Some(0.5 * (of_passages[passage]? + of_passages[passage + 1]?));
            let said = self.cycles.iter().map(|&cycle| {
                let amplitude = half(cycle).zip(half(cycle + 1)).map(|(one, other)| 0.5 * (one + other));
                self.period(cycle) / amplitude.map_or(f64::INFINITY, |a| Law::exact().ratio_at(a))
            });
            median(said.collect()).unwrap_or(0.0) - t0
        };
        let ends = [0.1 * longest, longest].map(|t0| (t0, excess(t0)));
        // Far below the resolution of any clock.
        zero_between(ends, Tolerance::absolute(1e-12 * longest), excess)
    }

    /// The amplitudes by the speeds of all passages of cycles, with this T0.
    fn by_speed(&self, amplitudes: &Amplitudes, t0: f64, watch: &Watch<'_>) -> Vec<Option<f64>> {
        let mut of_passages = vec![None; self.placed.len()];
        let mut next = 0;
        for &cycle in self.cycles.iter().take_while(|_| watch.go_on().is_ok()) {
            (next.max(cycle)..cycle + 3).for_each(|passage| {
                let motion = NearBottom { omega0: TAU / t0, drag: amplitudes.drag[passage] };
                of_passages[passage] = self.blocked(passage).and_then(|blocked| {
                    motion.amplitude(amplitudes.width, blocked, amplitudes.from_bottom[passage])
                });
            });
            next = cycle + 3;
        }
        of_passages
    }

    /// Smooths the amplitudes by a line through the logarithms of sin(A/2) of the neighbours, and derives the drag: the loss of energy is
    /// proportional to the square of the velocity, as for linear damping.
    fn follow(&self, amplitudes: &mut Amplitudes) {
        /// Neighbours on either side: if the amplitude falls by the same fraction at each passage the logarithms are on a line. From 2 rad under
        /// 0.1/s any number from 3 to 15 gives the same T0 to 2e-7 s and the same β to 1.2e-5.
        const NEIGHBOURS: usize = 7;
        let bottom = |passage: usize| self.time(passage) - amplitudes.from_bottom[passage];
        let course = |passage: usize| {
            let near = passage.saturating_sub(NEIGHBOURS)..self.placed.len().min(passage + NEIGHBOURS + 1);
            let point = |k: usize| Some((bottom(k), libm::log(libm::sin(0.5 * amplitudes.of_passages[k]?))));
            let (times, logarithms): (Vec<f64>, Vec<f64>) = near.filter_map(point).unzip();
            let [value, slope] = value_and_slope(&times, &logarithms, bottom(passage))?;
            let amplitude = 2.0 * libm::asin(libm::exp(value.min(0.0)));
            Some((amplitude, -slope / mean_squared_velocity(amplitude)?))
        };
        let courses: Vec<Option<(f64, f64)>> = (0..self.placed.len()).map(course).collect();
        amplitudes.smooth = courses.iter().map(|course| Some(course.as_ref()?.0)).collect();
        amplitudes.drag = courses.iter().map(|course| course.map_or(0.0, |(_, drag)| drag)).collect();
    }

    /// Sets the position of the gate to the median of its angles at the middle passages of cycles, at these times after the bottom, and computes
    /// the times at all passages.
    fn set_gate(&self, amplitudes: &mut Amplitudes, at_middles: &[f64]) {
        let angle = |(&cycle, &time): (&usize, &f64)| {
            let (passage, blocked) = (cycle + 1, self.blocked(cycle + 1)?);
            let amplitude = amplitudes.smooth[passage]?;
            let edges = [-0.5, 0.5]
                .map(|part| amplitudes.near_bottom(passage).angle_at(amplitude, time + part * blocked));
            Some(0.5 * self.direction(passage) * (edges[0] + edges[1]))
        };
        let Some(gate) = median(self.cycles.iter().zip(at_middles).filter_map(angle).collect()) else {
            return;
        };
        for passage in 0..self.placed.len() {
            let position = self.direction(passage) * gate;
            let Some(amplitude) = amplitudes.smooth[passage] else { continue };
            let edges = [-0.5, 0.5].map(|part| {
                amplitudes.near_bottom(passage).time_at(amplitude, position + part * amplitudes.width)
            });
            if let [Some(begin), Some(end)] = edges {
                (amplitudes.from_bottom[passage], amplitudes.blocked[passage]) =
                    (0.5 * (begin + end), end - begin);
            }
        }
    }
}
