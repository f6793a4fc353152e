//! A periodic motion prepared for millions of times on one orbit: a table of polynomials, evaluated in four lanes.
//!
//! # Method
//! `Motion::prepare` divides the period into 2ᵖ segments, each with a Taylor polynomial of degree 12 in time (`table.rs`). A state costs one
//! look-up and one polynomial in `f64`; the position on the orbit and the constant term of the segment are in two words. A batch is evaluated in
//! lanes of four. Motions that would need more than 4096 segments keep the theta quotients.

use super::LengthMismatch;
use super::motion::Motion;
use super::state::{State, whole_turns};
use super::table::{Cycle, Segment, Table};
use libration_kernels::dispatch::{Kernel, dispatch, dispatch_slices, fetch_ahead};
use libration_kernels::double_double::block::BLOCK;
use libration_kernels::double_double::{DoubleDouble, fast_two_sum, two_prod, two_sum};
use libration_kernels::elementary::{nearest_integer, nearest_integer_bits};
use libration_kernels::fused::FusedMultiplyAdd;

/// Largest number of segments passed, beyond which the index would lose bits.
const MOST_GONE: f64 = 1125899906842624.0;

/// A motion prepared for a large number of evaluations.
#[derive(Clone, Debug)]
pub struct PreparedMotion {
    motion: Motion,
    table: Option<Table>,
}

impl Motion {
    /// The motion with a table for many evaluations. Making the table takes a fraction of a millisecond and is worthwhile from about ten
    /// thousand times on.
    #[must_use]
    pub fn prepare(&self) -> PreparedMotion {
        let table = match self {
            Self::Libration(libration) => Table::of_libration(libration),
            Self::Rotation(rotation) => Table::of_rotation(rotation),
            Self::Rest(_) | Self::Separatrix(_) => None,
        };
        PreparedMotion { motion: *self, table }
    }
}

impl PreparedMotion {
    /// The motion.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The state at this time in seconds; NaN if the result of [`Motion::state_at`] is NaN.
    ///
    /// # Accuracy
    /// As [`Motion::state_at`], with which it agrees within the sum of the bounds.
    #[must_use]
    pub fn state_at(&self, time: f64) -> State {
        let motion = &self.motion;
        match &self.table {
            Some(table @ Table { cycle: None, .. }) => {
                dispatch(One { table, unwrap: Swinging, motion, time })
            }
            Some(table @ Table { cycle: Some(cycle), .. }) => {
                dispatch(One { table, unwrap: *cycle, motion, time })
            }
            None => motion.state_at(time),
        }
    }

    /// The unwrapped angle and the velocity of [`Self::state_at`] at each time, bit for bit.
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn states_at(
        &self,
        times: &[f64],
        angles: &mut [f64],
        velocities: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        let Some(table) = &self.table else {
            return self.motion.states_at(times, angles, velocities);
        };
        LengthMismatch::check(times, angles)?;
        LengthMismatch::check(times, velocities)?;
        let motion = &self.motion;
        match table.cycle {
            None => dispatch_slices(Each { table, unwrap: Swinging, motion, times, angles, velocities }),
            Some(cycle) => dispatch_slices(Each { table, unwrap: cycle, motion, times, angles, velocities }),
        }
        Ok(())
    }
}

/// A polynomial and its derivative at a position in a segment.
#[derive(Clone, Copy)]
struct Evaluated {
    base: DoubleDouble,
    /// Segments passed before the start of the cycle.
    start: f64,
    away: f64,
    velocity: f64,
}

impl Evaluated {
    #[inline(always)]
    fn new(position: Place, index: usize, base: DoubleDouble, sums: &[f64; 4]) -> Self {
        let [even, odd, even_slope, odd_slope] = *sums;
        let y = position.rest;
        #[expect(clippy::cast_precision_loss, reason = "at most 2¹² segments")]
        let start = position.gone - index as f64;
        let (away, velocity) = (y.fma(odd, even), y.fma(odd_slope, even_slope));
        Self { base, start, away, velocity }
    }
}

/// A position on the orbit: whole segments passed, and the rest in segments.
#[derive(Clone, Copy)]
struct Place {
    gone: f64,
    rest: f64,
}

impl Place {
    #[inline(always)]
    fn new(table: &Table, time: f64) -> Self {
        let product = two_prod(time, table.rate.hi);
        let sum = two_sum(product.hi, table.offset.hi);
        let lo = time.fma(table.rate.lo, product.lo) + (sum.lo + table.offset.lo);
        let gone = nearest_integer(sum.hi);
        Self { gone: gone + table.start, rest: (sum.hi - gone) + lo }
    }

    /// Returns `true` if the segments passed have been counted exactly; `false` for NaN.
    #[inline(always)]
    fn is_counted(&self) -> bool {
        self.gone.abs() < MOST_GONE
    }
}

impl Table {
    #[inline(always)]
    fn index(&self, gone: f64) -> usize {
        nearest_integer_bits(gone) & self.mask
    }

    #[inline(always)]
    fn state(&self, segment: &Segment, at: &Evaluated, angle: f64) -> State {
        let size = at.away.abs();
        let far = (DoubleDouble::PI - DoubleDouble::from(size)).to_f64();
        let top = segment.top;
        let upper = top != 0.0;
        // Past the upright position the next turn begins.
        let passed = if at.away * top > 0.0 { top } else { 0.0 };
        let cycles = self.cycle.map_or(0.0, |cycle| cycle.direction * (cycle.inverse * at.start));
        State {
            turns: self.turns.saturating_add(whole_turns(cycles + segment.turns + passed)),
            angle_in_turn: if upper { -far.copysign(at.away) } else { at.away },
            complement: if upper { size } else { far },
            angle,
            velocity: at.velocity,
        }
    }
}

impl Segment {
    /// The four polynomials in y².
    #[inline(always)]
    fn sums(&self, rest: f64, sums: &mut [f64; 4]) {
        let square = rest * rest;
        for (lane, sum) in sums.iter_mut().enumerate() {
            let mut value = self.rows[0][lane];
            for row in &self.rows[1..] {
                value = square.fma(value, row[lane]);
            }
            *sum = value;
        }
    }
}

/// Computation of the angle relative to the base of its segment.
trait Unwrap: Copy {
    /// The unwrapped angle; `#[inline(always)]`.
    fn angle(self, at: &Evaluated) -> f64;
}

/// A libration, for which earlier periods do not change the angle.
#[derive(Clone, Copy)]
struct Swinging;

impl Unwrap for Swinging {
    #[inline(always)]
    fn angle(self, at: &Evaluated) -> f64 {
        let base = at.base;
        let sum = fast_two_sum(base.hi, at.away);
        sum.hi + (sum.lo + base.lo)
    }
}

impl Unwrap for Cycle {
    #[inline(always)]
    fn angle(self, at: &Evaluated) -> f64 {
        let base = at.base;
        let gone = self.advance * (self.inverse * at.start);
        let start = two_sum(gone.hi, base.hi);
        let sum = two_sum(start.hi, at.away);
        sum.hi + (sum.lo + (start.lo + (gone.lo + base.lo)))
    }
}

struct One<'a, U> {
    table: &'a Table,
    unwrap: U,
    motion: &'a Motion,
    time: f64,
}

impl<U: Unwrap> Kernel for One<'_, U> {
    type Output = State;
    #[inline(always)]
    fn run(self) -> State {
        let position = Place::new(self.table, self.time);
        if !position.is_counted() {
            return self.motion.state_at(self.time);
        }
        let index = self.table.index(position.gone);
        let segment = &self.table.segments[index];
        let mut sums = [0.0; 4];
        segment.sums(position.rest, &mut sums);
        let at = Evaluated::new(position, index, segment.base, &sums);
        self.table.state(segment, &at, self.unwrap.angle(&at))
    }
}

struct Each<'a, U> {
    table: &'a Table,
    unwrap: U,
    motion: &'a Motion,
    times: &'a [f64],
    angles: &'a mut [f64],
    velocities: &'a mut [f64],
}

impl<U: Unwrap> Kernel for Each<'_, U> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self { table, unwrap, motion, times, angles, velocities } = self;
        let mut stages = PreparedStages::ZERO;
        let blocks = times.chunks(BLOCK).zip(angles.chunks_mut(BLOCK)).zip(velocities.chunks_mut(BLOCK));
        for ((times, angles), velocities) in blocks {
            fetch_ahead(times);
            fetch_ahead(angles);
            fetch_ahead(velocities);
            let done = match (times.as_array(), angles.as_mut_array(), velocities.as_mut_array()) {
                (Some(times), Some(angles), Some(velocities)) => {
                    stages.block(table, unwrap, times, angles, velocities)
                }
                _ => stages.part(table, unwrap, times, angles, velocities),
            };
            if !done {
                one_by_one(table, unwrap, motion, times, angles, velocities);
            }
        }
    }
}

/// Results of each stage of a block for the next, kept in memory so that the compiler vectorises the loops.
#[repr(align(64))]
struct PreparedStages {
    gone: [f64; BLOCK],
    rest: [f64; BLOCK],
    sums: [[f64; 4]; BLOCK],
    bases: [[f64; 2]; BLOCK],
}

impl PreparedStages {
    const ZERO: Self =
        Self { gone: [0.0; BLOCK], rest: [0.0; BLOCK], sums: [[0.0; 4]; BLOCK], bases: [[0.0; 2]; BLOCK] };

    /// Computes a whole block; returns `false` if some time is beyond the range of the table.
    #[inline(always)]
    fn block<U: Unwrap>(
        &mut self,
        table: &Table,
        unwrap: U,
        times: &[f64; BLOCK],
        angles: &mut [f64; BLOCK],
        velocities: &mut [f64; BLOCK],
    ) -> bool {
        let mut is_counted = true;
        for (i, time) in times.iter().enumerate() {
            let position = Place::new(table, *time);
            (self.gone[i], self.rest[i]) = (position.gone, position.rest);
            is_counted &= position.is_counted();
        }
        if !is_counted {
            return false;
        }
        for i in 0..BLOCK {
            let segment = &table.segments[table.index(self.gone[i])];
            segment.sums(self.rest[i], &mut self.sums[i]);
            self.bases[i] = [segment.base.hi, segment.base.lo];
        }
        for i in 0..BLOCK {
            let position = Place { gone: self.gone[i], rest: self.rest[i] };
            let base = DoubleDouble::new(self.bases[i][0], self.bases[i][1]);
            let at = Evaluated::new(position, table.index(position.gone), base, &self.sums[i]);
            (angles[i], velocities[i]) = (unwrap.angle(&at), at.velocity);
        }
        true
    }

    /// Computes fewer times than a block has.
    fn part<U: Unwrap>(
        &mut self,
        table: &Table,
        unwrap: U,
        times: &[f64],
        angles: &mut [f64],
        velocities: &mut [f64],
    ) -> bool {
        let [mut whole, mut all_angles, mut all_velocities] = [[0.0; BLOCK]; 3];
        whole[..times.len()].copy_from_slice(times);
        let done = self.block(table, unwrap, &whole, &mut all_angles, &mut all_velocities);
        angles.copy_from_slice(&all_angles[..angles.len()]);
        velocities.copy_from_slice(&all_velocities[..velocities.len()]);
        done
    }
}

/// Computes a block in which some time is beyond the range of the table.
#[cold]
fn one_by_one<U: Unwrap>(
    table: &Table,
    unwrap: U,
    motion: &Motion,
    times: &[f64],
    angles: &mut [f64],
    velocities: &mut [f64],
) {
    for ((time, angle), velocity) in times.iter().zip(angles).zip(velocities) {
        let state = One { table, unwrap, motion, time: *time }.run();
        (*angle, *velocity) = (state.angle, state.velocity);
    }
}
