//! States of many amplitudes and times, sorted by side and computed stage by stage, as in `period_stages`.

use super::LengthMismatch;
use super::period::{Nearer, amplitude_above, nearer_of_amplitude, root_of_nome};
use super::period_stages::Stages;
use super::state::{DoubledArctangent, ReducedRatio};
use super::varying::{Factors, One, ReleaseSide, gauss, phase, tangent, velocity};
use libration_kernels::dispatch::{Kernel, dispatch_slices, fetch_ahead};
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum};
use libration_kernels::elementary::ReducedArctangent;
use libration_kernels::internals::elliptic::{CircularSide, HyperbolicSide, Phase, ThetaSeries, ThetaValues};

/// The angle and velocity of [`state`](super::state) for each pair of amplitude and time, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn states(
    amplitudes: &[f64],
    angular_frequency: f64,
    times: &[f64],
    angles: &mut [f64],
    velocities: &mut [f64],
) -> Result<(), LengthMismatch> {
    for slice in [times, angles, velocities] {
        LengthMismatch::check(amplitudes, slice)?;
    }
    dispatch_slices(Each { amplitudes, angular_frequency, times, angles, velocities });
    Ok(())
}

pub(super) struct Each<'a> {
    pub(super) amplitudes: &'a [f64],
    pub(super) angular_frequency: f64,
    pub(super) times: &'a [f64],
    pub(super) angles: &'a mut [f64],
    pub(super) velocities: &'a mut [f64],
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let mut below = Queue::new();
        let mut above = Queue::new();
        let mut stages = ReleaseStages::new(self.angular_frequency);
        let mut first = 0;
        while first < self.amplitudes.len() {
            let end = (first + BLOCK).min(self.amplitudes.len());
            for slice in [self.amplitudes, self.times, &*self.angles, &*self.velocities] {
                fetch_ahead(&slice[first..end]);
            }
            // The number of elements for which both queues have room; the counts are kept in registers.
            let room = BLOCK - above.count.max(below.count);
            let (mut above_count, mut below_count) = (above.count, below.count);
            let elements = self.amplitudes[first..].iter().zip(&self.times[first..]).take(room);
            for (amplitude, time) in elements {
                // Without a branch, which random amplitudes would make unpredictable.
                let is_above = usize::from(amplitude_above(*amplitude));
                above.put(above_count, first, *amplitude, *time);
                below.put(below_count, first, *amplitude, *time);
                above_count += is_above;
                below_count += 1 - is_above;
                first += 1;
            }
            (above.count, below.count) = (above_count, below_count);
            if above.count == BLOCK {
                stages.run::<HyperbolicSide>(&mut above, self.angles, self.velocities);
            }
            if below.count == BLOCK {
                stages.run::<CircularSide>(&mut below, self.angles, self.velocities);
            }
        }
        for queue in [&mut above, &mut below] {
            if queue.count <= FEW {
                queue.one_by_one(self.angular_frequency, self.angles, self.velocities);
            }
        }
        if above.count > 0 {
            stages.run::<HyperbolicSide>(&mut above, self.angles, self.velocities);
        }
        if below.count > 0 {
            stages.run::<CircularSide>(&mut below, self.angles, self.velocities);
        }
    }
}

/// Largest number of elements that take less time one by one than in a block.
const FEW: usize = 6;

/// Elements of one side waiting for a block to fill.
#[repr(align(64))]
struct Queue {
    count: usize,
    position: [usize; BLOCK],
    amplitude: [f64; BLOCK],
    time: [f64; BLOCK],
}

impl Queue {
    fn new() -> Self {
        Self { count: 0, position: [0; BLOCK], amplitude: [0.0; BLOCK], time: [0.0; BLOCK] }
    }

    /// Puts an element into a slot below `BLOCK`; the next element overwrites it unless the count is increased.
    #[inline(always)]
    fn put(&mut self, slot: usize, index: usize, amplitude: f64, time: f64) {
        // The remainder makes a bounds check unnecessary.
        let slot = slot % BLOCK;
        self.position[slot] = index;
        self.amplitude[slot] = amplitude;
        self.time[slot] = time;
    }

    /// Empties the queue one element at a time.
    #[inline(always)]
    fn one_by_one(&mut self, angular_frequency: f64, angles: &mut [f64], velocities: &mut [f64]) {
        for i in 0..self.count {
            let state = One { amplitude: self.amplitude[i], angular_frequency, time: self.time[i] }.run();
            (angles[self.position[i]], velocities[self.position[i]]) = (state.angle, state.velocity);
        }
        self.count = 0;
    }
}

/// Results of each stage for the next.
#[repr(align(64))]
struct ReleaseStages {
    angular_frequency: f64,
    period: Stages,
    root: [f64; BLOCK],
    gauss: Words,
    small_second: Words,
    zero_second: Words,
    zero_fourth: Words,
    quarter: [f64; BLOCK],
    rest: Words,
    first: Words,
    second: Words,
    third: Words,
    fourth: Words,
    angle: [f64; BLOCK],
    sign: [f64; BLOCK],
    steep: [f64; BLOCK],
    velocity: [f64; BLOCK],
}

impl ReleaseStages {
    fn new(angular_frequency: f64) -> Self {
        Self {
            angular_frequency,
            period: Stages::ZERO,
            root: [0.0; BLOCK],
            gauss: Words::ZERO,
            small_second: Words::ZERO,
            zero_second: Words::ZERO,
            zero_fourth: Words::ZERO,
            quarter: [0.0; BLOCK],
            rest: Words::ZERO,
            first: Words::ZERO,
            second: Words::ZERO,
            third: Words::ZERO,
            fourth: Words::ZERO,
            angle: [0.0; BLOCK],
            sign: [0.0; BLOCK],
            steep: [0.0; BLOCK],
            velocity: [0.0; BLOCK],
        }
    }

    /// Empties the queue; elements after its count are computed too and dropped.
    #[inline(always)]
    fn run<S: ReleaseSide>(&mut self, queue: &mut Queue, angles: &mut [f64], velocities: &mut [f64]) {
        self.places::<S>(queue);
        self.values::<S>();
        for i in 0..BLOCK {
            let factors = (&self.factors(i), self.gauss.get(i));
            let theta = self.theta(i);
            self.velocity[i] =
                velocity::<S>(queue.amplitude[i], self.angular_frequency, &self.phase(i), factors, &theta);
        }
        self.angles::<S>(queue);
        for i in 0..queue.count {
            (angles[queue.position[i]], velocities[queue.position[i]]) = (self.angle[i], self.velocity[i]);
        }
        queue.count = 0;
    }

    /// Computes the angles, which overwrite the theta values.
    #[inline(always)]
    fn angles<S: ReleaseSide>(&mut self, queue: &Queue) {
        for i in 0..BLOCK {
            let tangent = tangent::<S>(queue.amplitude[i], &self.phase(i), &self.factors(i), &self.theta(i));
            self.first.set(i, tangent.above);
            self.second.set(i, tangent.below);
            self.sign[i] = tangent.sign;
        }
        for i in 0..BLOCK {
            let ratio = ReducedRatio::from_quotient(self.first.get(i), self.second.get(i));
            self.steep[i] = if ratio.steep { 1.0 } else { 0.0 };
            self.third.set(i, DoubleDouble::new(ratio.arctangent.t, ratio.arctangent.t_lo));
            self.fourth.hi[i] = ratio.arctangent.upper;
        }
        for i in 0..BLOCK {
            let DoubleDouble { hi: t, lo: t_lo } = self.third.get(i);
            let arctangent = ReducedArctangent { upper: self.fourth.hi[i], t, t_lo };
            let ratio = ReducedRatio { arctangent, steep: self.steep[i] > 0.5 };
            self.angle[i] = self.sign[i] * DoubledArctangent::from_reduced(ratio).angle.to_f64();
        }
    }

    #[inline(always)]
    fn places<S: ReleaseSide>(&mut self, queue: &Queue) {
        for i in 0..BLOCK {
            let Nearer { s, u } = nearer_of_amplitude(queue.amplitude[i]);
            self.period.s.set(i, s);
            self.period.u.set(i, u);
        }
        self.period.excess();
        if S::ABOVE {
            self.period.log();
        }
        for i in 0..BLOCK {
            let root = root_of_nome(self.period.s.get(i), self.period.u.hi[i]);
            let factors = Factors::from_nome_root(root);
            self.root[i] = root.hi;
            self.small_second.set(i, factors.small_second);
            self.zero_second.set(i, factors.second);
            self.zero_fourth.set(i, factors.fourth);
        }
        for i in 0..BLOCK {
            let log = self.period.log.get(i);
            let log = fast_two_sum(log.hi, log.lo);
            self.period.log.set(i, log.scaled(2.0));
            let gauss = gauss(self.period.excess.get(i));
            self.gauss.set(i, gauss);
            let phase = phase(S::ratio(gauss, log), self.angular_frequency, queue.time[i]);
            self.quarter[i] = phase.quarter;
            self.rest.set(i, phase.rest);
        }
    }

    #[inline(always)]
    fn values<S: ReleaseSide>(&mut self) {
        for i in 0..BLOCK {
            let (sine, cosine) = S::sine_cosine(self.rest.get(i), self.period.log.get(i));
            self.first.set(i, sine);
            self.second.set(i, cosine);
        }
        for i in 0..BLOCK {
            let series = ThetaSeries::new(self.root[i] * self.root[i]);
            let values = series.at::<S>(self.first.get(i), self.second.get(i));
            self.first.set(i, values.first);
            self.second.set(i, values.second);
            self.third.set(i, values.third);
            self.fourth.set(i, values.fourth);
        }
    }

    #[inline(always)]
    fn factors(&self, i: usize) -> Factors {
        Factors {
            small_second: self.small_second.get(i),
            second: self.zero_second.get(i),
            fourth: self.zero_fourth.get(i),
        }
    }

    #[inline(always)]
    fn phase(&self, i: usize) -> Phase {
        Phase { turns: 0.0, quarter: self.quarter[i], rest: self.rest.get(i) }
    }

    #[inline(always)]
    fn theta(&self, i: usize) -> ThetaValues {
        ThetaValues {
            first: self.first.get(i),
            second: self.second.get(i),
            third: self.third.get(i),
            fourth: self.fourth.get(i),
        }
    }
}
