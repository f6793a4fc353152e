//! Short stretches of a motion without series: the integral equation solved by iteration.
//!
//! x(t) = x₀ + ∫f(x) dt is iterated until it no longer changes: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations
//! I*, 2nd ed., Springer 1993, section I.8. The integrals extend from one zero of the argument of a |…| to the next, with nodes that cluster at
//! both, so that forces like |x|^1.5 or a jump there do not reduce the accuracy: the error is that for a smooth function.

use crate::taylor::StateLayout;
use crate::taylor::program::passage::{Passage, Values};
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::quadrature::{POINTS, points, running_integrals};
use libration_numbers::roots::{Tolerance, zero_between};

/// The beginning of a stretch.
pub(in crate::taylor) struct PicardStart<'a> {
    pub(in crate::taylor) passage: &'a Passage,
    pub(in crate::taylor) layout: &'a StateLayout,
    pub(in crate::taylor) time: f64,
    pub(in crate::taylor) state: Vec<f64>,
    pub(in crate::taylor) parameters: Vec<f64>,
    /// `true` for components that friction keeps at zero.
    pub(in crate::taylor) held: Vec<bool>,
}

/// The motion in a stretch: each state component as x₀ + c₁t + c₂t², which is exact at the end.
pub(in crate::taylor) struct PicardStep {
    pub(in crate::taylor) length: f64,
    /// c₁ and c₂ of each component.
    pub(in crate::taylor) coefficients: Vec<[f64; 2]>,
    /// The largest error in the stretch, relative to the size of a velocity or to the distance that a coordinate covers.
    pub(in crate::taylor) misfit: f64,
}

/// A panel between two zeros.
struct Panel {
    start: f64,
    length: f64,
}

impl Panel {
    /// Times in the panel with the factors dt/ds of the points s.
    fn nodes(&self) -> [(f64, f64); POINTS] {
        // t = s⁴(35 − 84s + 70s² − 20s³): near either end the fourth power of the distance.
        points().map(|s| {
            let r = 1.0 - s;
            let (from, to) = if s <= 0.5 { (s, false) } else { (r, true) };
            let fourth = from * from * from * from;
            let part = fourth * (35.0 - from * (84.0 - from * (70.0 - 20.0 * from)));
            let part = if to { 1.0 - part } else { part };
            (self.start + self.length * part, self.length * 140.0 * (s * r) * (s * r) * (s * r))
        })
    }
}

impl PicardStart<'_> {
    fn at(&self, elapsed: f64, state: &[f64]) -> Option<Values> {
        self.passage.at(self.time + elapsed, state, &self.parameters)
    }

    /// The rate of change of each component in a state.
    fn rates(&self, elapsed: f64, state: &[f64]) -> Option<Vec<f64>> {
        let mut rates = self.at(elapsed, state)?.rates(self.layout, state);
        for (rate, _) in rates.iter_mut().zip(&self.held).filter(|(_, held)| **held) {
            *rate = 0.0;
        }
        Some(rates)
    }

    /// The rates at the start.
    pub(in crate::taylor) fn first_rates(&self) -> Option<Vec<f64>> {
        self.rates(0.0, &self.state)
    }

    /// The state after a time under the accelerations of the start.
    pub(in crate::taylor) fn guess(&self, rates: &[f64], elapsed: f64) -> Vec<f64> {
        let bend = |number: usize| self.layout.velocity(number).map_or(0.0, |velocity| 0.5 * rates[velocity]);
        let moved = |number: usize| self.state[number] + (rates[number] + bend(number) * elapsed) * elapsed;
        (0..self.state.len()).map(moved).collect()
    }

    /// The difference of each rate after `elapsed` from that at the start, for the guessed state.
    pub(in crate::taylor) fn change(&self, rates: &[f64], elapsed: f64) -> Option<Vec<f64>> {
        let there = self.rates(elapsed, &self.guess(rates, elapsed))?;
        Some(there.iter().zip(rates).map(|(there, here)| there - here).collect())
    }

    /// The size to which the accuracy of each component refers: the velocity or its change, and the distance that a coordinate covers.
    pub(in crate::taylor) fn sizes(&self, rates: &[f64], length: f64, change: &[f64]) -> Vec<f64> {
        let size = |number: usize| {
            let held = if self.layout.is_velocity(number) { self.state[number].abs() } else { 0.0 };
            held.max((rates[number] * length).abs()).max(change[number].abs())
        };
        (0..self.state.len()).map(size).collect()
    }

    /// The motion in a stretch of this length; `None` if the iteration does not reach the tolerance.
    pub(in crate::taylor) fn stretch(
        &self,
        rates: &[f64],
        length: f64,
        tolerance: f64,
    ) -> Option<PicardStep> {
        /// Maximum number of sweeps; a stretch that requires more is too long.
        const MOST_SWEEPS: usize = 12;
        let panels = self.panels(rates, length)?;
        let nodes: Vec<(f64, f64)> = panels.iter().flat_map(Panel::nodes).collect();
        let mut states: Vec<Vec<f64>> = nodes.iter().map(|(time, _)| self.guess(rates, *time)).collect();
        let mut last: Option<Vec<f64>> = None;
        for _ in 0..MOST_SWEEPS {
            let (gained, end) = self.sweep(rates, &nodes, &states)?;
            for (state, ((time, _), gained)) in states.iter_mut().zip(nodes.iter().zip(&gained)) {
                for (number, value) in state.iter_mut().enumerate() {
                    *value = self.state[number] + (rates[number] * time + gained[number]);
                }
            }
            let sizes = self.sizes(rates, length, &end);
            let stays = last.is_some_and(|last| {
                let changes = last.iter().zip(&end).map(|(before, now)| (now - before).abs());
                changes.zip(&sizes).all(|(change, size)| change <= tolerance * size)
            });
            if stays {
                return Some(finished(rates, length, &nodes, &gained, &end, &sizes));
            }
            last = Some(end);
        }
        None
    }

    /// The panels between the zeros of the arguments of |…|.
    fn panels(&self, rates: &[f64], length: f64) -> Option<Vec<Panel>> {
        const LOOKS: u32 = 8;
        let arguments =
            |elapsed: f64| Some(self.at(elapsed, &self.guess(rates, elapsed))?.arguments().to_vec());
        let mut ends = vec![0.0, length];
        let mut before = (0.0, arguments(0.0)?);
        for look in 1..=LOOKS {
            let time = length * f64::from(look) / f64::from(LOOKS);
            let here = (time, arguments(time)?);
            for (modulus, (a, b)) in before.1.iter().zip(&here.1).enumerate() {
                let argument = |time: f64| arguments(time).map_or(f64::NAN, |all| all[modulus]);
                ends.extend(zero_between([(before.0, *a), (time, *b)], Tolerance::LAST_BIT, argument));
            }
            before = here;
        }
        ends.put_in_order(|a, b| a.abs().total_cmp(&b.abs()));
        ends.dedup();
        Some(ends.windows(2).map(|pair| Panel { start: pair[0], length: pair[1] - pair[0] }).collect())
    }

    /// The gain of the components at each node, and at the end, beyond the gain at the initial rates.
    fn sweep(
        &self,
        rates: &[f64],
        nodes: &[(f64, f64)],
        states: &[Vec<f64>],
    ) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
        let mut sum = vec![0.0; rates.len()];
        let mut gained = Vec::with_capacity(nodes.len());
        for (nodes, states) in nodes.chunks(POINTS).zip(states.chunks(POINTS)) {
            let mut excess = vec![[0.0; POINTS]; rates.len()];
            for (point, ((time, factor), state)) in nodes.iter().zip(states).enumerate() {
                for (number, rate) in self.rates(*time, state)?.into_iter().enumerate() {
                    excess[number][point] = (rate - rates[number]) * factor;
                }
            }
            let integrals: Vec<_> = excess.iter().map(running_integrals).collect();
            for point in 0..POINTS {
                gained.push(sum.iter().zip(&integrals).map(|(sum, (upto, _))| sum + upto[point]).collect());
            }
            sum.iter_mut().zip(&integrals).for_each(|(sum, (_, all))| *sum += all);
        }
        Some((gained, sum))
    }
}

fn finished(
    rates: &[f64],
    length: f64,
    nodes: &[(f64, f64)],
    gained: &[Vec<f64>],
    end: &[f64],
    sizes: &[f64],
) -> PicardStep {
    let coefficients: Vec<[f64; 2]> =
        rates.iter().zip(end).map(|(rate, end)| [*rate, end / length / length]).collect();
    let error = |(time, gained): (f64, &Vec<f64>)| {
        let parts = gained.iter().zip(&coefficients).zip(sizes);
        let parts = parts.map(|((gained, [_, second]), size)| {
            let error = (gained - second * time * time).abs();
            if error == 0.0 { 0.0 } else { error / size }
        });
        parts.fold(0.0, f64::max)
    };
    let misfit = nodes.iter().map(|(time, _)| *time).zip(gained).map(error).fold(0.0, f64::max);
    PicardStep { length, coefficients, misfit }
}
