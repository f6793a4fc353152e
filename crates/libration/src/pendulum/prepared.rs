//! A periodic motion as a table of Taylor polynomials in time, for millions of times on one orbit.
//!
//! The period is cut into 2ᵖ segments. On each the polynomial of degree 10 about its middle comes from the
//! equation of motion by the recurrences of sine and cosine; half a segment is at most 1/45 of the distance
//! to the nearest singularity, K′ away in imaginary time, so the remainder is below 45⁻¹¹·11 < 2⁻⁵⁶. In
//! the upper half of the circle the polynomial is that of the angle from the upright position.

use super::motion::Motion;
use super::state::{State, whole_turns};
use super::{LengthMismatch, Libration, Rotation};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod, two_sum};
use crate::elementary::{nearest_integer, nearest_integer_bits};
use crate::elliptic::{Modulus, PhaseClock, PreciseQuotients};

const DEGREE: usize = 10;

/// Distance of the nearest singularity in half segments.
const CLEARANCE: f64 = 45.0;

const FEWEST_SEGMENTS: f64 = 32.0;

/// A table of more than 2¹² segments would outgrow the caches: next to the separatrix the theta quotients are
/// faster.
const MOST_SEGMENTS: f64 = 4096.0;

/// Beyond this many segments the index would lose bits.
const MOST_GONE: f64 = 1125899906842624.0;

/// A motion prepared for very many evaluations.
#[derive(Clone, Debug)]
pub struct PreparedMotion {
    motion: Motion,
    table: Option<Table>,
}

#[derive(Clone, Debug)]
struct Table {
    /// Segments per second, and segments gone at t = 0.
    clock: PhaseClock,
    /// What is gained in all segments once through, in rotation.
    cycle: Option<Cycle>,
    turns: i64,
    /// One less than the number of segments, a power of two. Taken from a field and not from the length, it
    /// leaves a check of the index in the loop, without which the compiler would gather across segments.
    mask: usize,
    segments: Vec<Segment>,
}

/// A turn of a rotation.
#[derive(Clone, Copy, Debug)]
struct Cycle {
    /// ±2π.
    advance: DoubleDouble,
    direction: f64,
    /// 1/segments, a power of two.
    inverse: f64,
}

/// A polynomial for the angle from `base`, the lowest point or the upright position.
#[derive(Clone, Copy, Debug)]
struct Segment {
    /// Coefficients of powers of y² of the four polynomials that make angle = a + y·b and velocity = c + y·d.
    rows: [[f64; 4]; DEGREE / 2 + 1],
    base: DoubleDouble,
    /// ±1 where the angle counts from ±π of the turn.
    top: f64,
    /// Turns gone in the cycle.
    turns: f64,
}

impl Motion {
    /// The motion with a table for many evaluations: worth its making, a fraction of a millisecond, from some
    /// ten thousand times on.
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

    /// The state at this time in seconds; NaN for a time that is not finite.
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
            None => dispatch(Each { table, unwrap: Swinging, motion, times, angles, velocities }),
            Some(cycle) => dispatch(Each { table, unwrap: cycle, motion, times, angles, velocities }),
        }
        Ok(())
    }
}

/// The state at the middle of a segment.
struct Middle {
    /// sin(θ/2) and cos(θ/2).
    sine: DoubleDouble,
    cosine: DoubleDouble,
    /// θ′ in segments.
    velocity: DoubleDouble,
}

impl Table {
    fn of_libration(libration: &Libration) -> Option<Self> {
        let (angular_frequency, clock) = libration.angular_frequency_and_clock();
        let modulus = libration.modulus();
        let count = segments(&modulus, 2.0)?;
        let quotients = PreciseQuotients::new(&modulus);
        let rate = clock.frequency * count;
        let step = angular_frequency / rate;
        let (turns, base) = libration.start_of_turn();
        let mut segments: Vec<Segment> = fractions(0.5 * count, count)
            .map(|fraction| {
                let at = quotients.at(fraction);
                let k = modulus.modulus_words();
                let velocity = k * at.cn * step.scaled(2.0);
                Segment::about(
                    &Middle { sine: k * at.sn, cosine: at.dn, velocity },
                    step.to_f64(),
                    rate.hi,
                    base,
                )
            })
            .collect();
        // θ(t + T/2) = −θ(t).
        let mirrored: Vec<Segment> = segments.iter().map(|segment| segment.mirrored(base)).collect();
        segments.extend(mirrored);
        let clock = PhaseClock { frequency: rate, offset: clock.offset * count };
        Some(Self { clock, cycle: None, turns, mask: segments.len() - 1, segments })
    }

    fn of_rotation(rotation: &Rotation) -> Option<Self> {
        let (speed, clock) = rotation.speed_and_clock();
        let modulus = rotation.modulus();
        // One turn of the pendulum is half of 4K.
        let count = segments(&modulus, 1.0)?;
        let quotients = PreciseQuotients::new(&modulus);
        let rate = clock.frequency * (2.0 * count);
        let direction = rotation.direction();
        let step = (speed * modulus.modulus_words() / rate).to_f64();
        let (turns, base) = rotation.start_of_turn();
        let advance = DoubleDouble::PI.scaled(2.0 * direction);
        let segments: Vec<Segment> = fractions(count, count)
            .map(|fraction| {
                let at = quotients.at(0.5 * if fraction >= 0.5 { fraction - 1.0 } else { fraction });
                let velocity = at.dn * (speed / rate).scaled(2.0 * direction);
                let middle = Middle { sine: at.sn.scaled(direction), cosine: at.cn, velocity };
                let gone = if fraction >= 0.5 { direction } else { 0.0 };
                Segment { turns: gone, ..Segment::about(&middle, step, rate.hi, base + advance * gone.abs()) }
            })
            .collect();
        let clock = PhaseClock { frequency: rate, offset: clock.offset * (2.0 * count) };
        Some(Self {
            clock,
            cycle: Some(Cycle { advance, direction, inverse: 1.0 / count }),
            turns,
            mask: segments.len() - 1,
            segments,
        })
    }
}

/// How many segments a cycle of `half_periods`·2K needs, if that is not too many.
fn segments(modulus: &Modulus, half_periods: f64) -> Option<f64> {
    let ratio = modulus.first_words() / modulus.complementary_first_words();
    let needed = (CLEARANCE * half_periods * ratio.hi).max(FEWEST_SEGMENTS);
    let mut count = FEWEST_SEGMENTS;
    while count < needed && count <= MOST_SEGMENTS {
        count *= 2.0;
    }
    (count <= MOST_SEGMENTS).then_some(count)
}

/// 0, 1/count, 2/count …, `number` of them.
fn fractions(number: f64, count: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(0.0), |i| Some(i + 1.0))
        .take_while(move |i| *i < number)
        .map(move |i| i / count)
}

impl Segment {
    /// The polynomial about this state, for segments of which there are `rate` in a second, `step` = ω0/rate.
    fn about(middle: &Middle, step: f64, rate: f64, base: DoubleDouble) -> Self {
        let Middle { sine, cosine, velocity } = *middle;
        let size = sine.abs();
        let top = if size.hi > cosine.hi { 1f64.copysign(sine.hi) } else { 0.0 };
        let away = if top == 0.0 {
            crate::elementary::two_word::atan2(sine, cosine).scaled(2.0)
        } else {
            crate::elementary::two_word::atan2(cosine, size).scaled(-2.0 * top)
        };
        // Of the angle from the base, which is θ or θ ∓ π.
        let flip = if top == 0.0 { 1.0 } else { -1.0 };
        let sin = (sine * cosine).to_f64() * (2.0 * flip);
        let cos = (cosine.square() - sine.square()).to_f64() * flip;
        let rows = rows(&taylor([away.hi, velocity.to_f64()], [sin, cos], -flip * step * step), rate);
        let base = base + DoubleDouble::PI * top;
        Self { rows, base: DoubleDouble::new(base.hi, base.lo + away.lo), top, turns: 0.0 }
    }

    /// The segment half a period later.
    fn mirrored(&self, base: DoubleDouble) -> Self {
        let own = self.base - base;
        Self { rows: self.rows.map(|row| row.map(|c| -c)), base: base - own, top: -self.top, turns: 0.0 }
    }
}

/// The rows of a segment, highest power first: xₖ for the angle, k·xₖ·rate for the velocity.
fn rows(x: &[f64; DEGREE + 1], rate: f64) -> [[f64; 4]; DEGREE / 2 + 1] {
    let mut slopes = [0.0; DEGREE + 2];
    let mut k = 1.0;
    for (slope, x) in slopes.iter_mut().zip(&x[1..]) {
        *slope = k * x * rate;
        k += 1.0;
    }
    let mut rows = [[0.0; 4]; DEGREE / 2 + 1];
    for (i, row) in rows.iter_mut().rev().enumerate() {
        let odd = x.get(2 * i + 1).copied().unwrap_or(0.0);
        *row = [x[2 * i], odd, slopes[2 * i], slopes[2 * i + 1]];
    }
    rows
}

/// Taylor coefficients of x″ = factor·sin x from x, x′ and sin x, cos x at the middle, by
/// (j+1)·sⱼ₊₁ = Σ(i+1)xᵢ₊₁cⱼ₋ᵢ and (j+1)·cⱼ₊₁ = −Σ(i+1)xᵢ₊₁sⱼ₋ᵢ.
fn taylor(start: [f64; 2], [sin, cos]: [f64; 2], factor: f64) -> [f64; DEGREE + 1] {
    let mut x = [0.0; DEGREE + 1];
    let (mut s, mut c) = ([0.0; DEGREE], [0.0; DEGREE]);
    (x[0], x[1]) = (start[0], start[1]);
    (s[0], c[0]) = (sin, cos);
    let mut order = 0.0;
    for j in 0..DEGREE - 1 {
        x[j + 2] = factor * s[j] / ((order + 1.0) * (order + 2.0));
        let (mut ds, mut dc) = (0.0, 0.0);
        let mut i_plus_1 = 1.0;
        for i in 0..=j {
            ds += i_plus_1 * x[i + 1] * c[j - i];
            dc -= i_plus_1 * x[i + 1] * s[j - i];
            i_plus_1 += 1.0;
        }
        order += 1.0;
        (s[j + 1], c[j + 1]) = (ds / order, dc / order);
    }
    x
}

/// A polynomial and its derivative at a place in a segment.
struct Evaluated<'a> {
    segment: &'a Segment,
    /// Segments gone to the start of the cycle.
    start: f64,
    away: f64,
    velocity: f64,
}

/// A place on the orbit: segments gone, and the rest in segments.
#[derive(Clone, Copy)]
struct Place {
    gone: f64,
    rest: f64,
}

impl Place {
    #[inline(always)]
    fn new(clock: &PhaseClock, time: f64) -> Self {
        let product = two_prod(time, clock.frequency.hi);
        let sum = two_sum(product.hi, clock.offset.hi);
        let lo = time.mul_add(clock.frequency.lo, product.lo) + (sum.lo + clock.offset.lo);
        let gone = nearest_integer(sum.hi);
        Self { gone, rest: (sum.hi - gone) + lo }
    }

    /// Whether the segments gone have been counted exactly; not for NaN.
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
    fn evaluate(&self, place: Place, index: usize, sums: &[f64; 4]) -> Evaluated<'_> {
        let [even, odd, even_slope, odd_slope] = *sums;
        let y = place.rest;
        #[expect(clippy::cast_precision_loss, reason = "at most 2¹² segments")]
        let start = place.gone - index as f64;
        Evaluated {
            segment: &self.segments[index],
            start,
            away: y.mul_add(odd, even),
            velocity: y.mul_add(odd_slope, even_slope),
        }
    }

    #[inline(always)]
    fn state(&self, at: &Evaluated<'_>, angle: f64) -> State {
        let size = at.away.abs();
        let far = (DoubleDouble::PI - DoubleDouble::from(size)).to_f64();
        let top = at.segment.top;
        let upper = top != 0.0;
        // Past the upright position the turn is the next.
        let passed = if at.away * top > 0.0 { top } else { 0.0 };
        let cycles = self.cycle.map_or(0.0, |cycle| cycle.direction * (cycle.inverse * at.start));
        State {
            turns: self.turns.saturating_add(whole_turns(cycles + at.segment.turns + passed)),
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
                value = square.mul_add(value, row[lane]);
            }
            *sum = value;
        }
    }
}

/// How the angle is put together from the base of its segment.
trait Unwrap: Copy {
    /// The unwrapped angle; `#[inline(always)]`.
    fn angle(self, at: &Evaluated<'_>) -> f64;
}

/// Libration: what is gone does not count.
#[derive(Clone, Copy)]
struct Swinging;

impl Unwrap for Swinging {
    #[inline(always)]
    fn angle(self, at: &Evaluated<'_>) -> f64 {
        let base = at.segment.base;
        let sum = fast_two_sum(base.hi, at.away);
        sum.hi + (sum.lo + base.lo)
    }
}

impl Unwrap for Cycle {
    #[inline(always)]
    fn angle(self, at: &Evaluated<'_>) -> f64 {
        let base = at.segment.base;
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
        let place = Place::new(&self.table.clock, self.time);
        if !place.is_counted() {
            return self.motion.state_at(self.time);
        }
        let index = self.table.index(place.gone);
        let mut sums = [0.0; 4];
        self.table.segments[index].sums(place.rest, &mut sums);
        let at = self.table.evaluate(place, index, &sums);
        self.table.state(&at, self.unwrap.angle(&at))
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

/// How many times are placed on the orbit together.
const BLOCK: usize = 64;

impl<U: Unwrap> Kernel for Each<'_, U> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self { table, unwrap, motion, times, angles, velocities } = self;
        let (mut gone, mut rest) = ([0.0; BLOCK], [0.0; BLOCK]);
        // The lanes go through memory, for which the compiler makes vector operations of them.
        let mut sums = [[0.0; 4]; BLOCK];
        let blocks = times.chunks(BLOCK).zip(angles.chunks_mut(BLOCK)).zip(velocities.chunks_mut(BLOCK));
        for ((times, angles), velocities) in blocks {
            for ((gone, rest), time) in gone.iter_mut().zip(&mut rest).zip(times) {
                let place = Place::new(&table.clock, *time);
                (*gone, *rest) = (place.gone, place.rest);
            }
            if !gone[..times.len()].iter().all(|gone| Place { gone: *gone, rest: 0.0 }.is_counted()) {
                one_by_one(table, unwrap, motion, times, angles, velocities);
                continue;
            }
            for ((gone, rest), sums) in gone.iter().zip(&rest).zip(&mut sums) {
                table.segments[table.index(*gone)].sums(*rest, sums);
            }
            for (i, (angle, velocity)) in angles.iter_mut().zip(velocities).enumerate() {
                let place = Place { gone: gone[i], rest: rest[i] };
                let at = table.evaluate(place, table.index(gone[i]), &sums[i]);
                (*angle, *velocity) = (unwrap.angle(&at), at.velocity);
            }
        }
    }
}

/// A block in which some time is beyond the table's count.
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
