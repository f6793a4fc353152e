//! The table of a prepared motion: Taylor polynomials in time.
//!
//! The period is divided into 2ᵖ segments. On each the polynomial of degree 12 about the middle follows from the equation of motion by the
//! recurrences of sine and cosine. Half a segment is at most 1/24 of the distance to the nearest singularity, K′ away in imaginary time, so the
//! remainder is below 24⁻¹³ < 2⁻⁵⁹, and the remainder of the velocity below 24⁻¹² < 2⁻⁵⁴ of its scale. The last term is spread over the lower
//! even powers by Chebyshev's polynomial of its degree, which changes the sum by less than 2⁻¹¹·24⁻¹² of the scale and saves a row of the table.
//! In the upper half of the circle the polynomial gives the angle from the upright position.

use super::{Libration, Rotation};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::two_word;
use libration_kernels::fused::FusedMultiplyAdd;
use libration_kernels::{elliptic::Modulus, internals::elliptic::PreciseQuotients};

pub const DEGREE: usize = 12;

/// Powers of y² that are kept.
pub const ROWS: usize = DEGREE / 2;

/// z¹² as Σ cₖ z²ᵏ within 2⁻¹¹ for |z| ≤ 1: z¹² − T₁₂(z)/2¹¹.
const TWELFTH_POWER: [f64; ROWS] =
    [-1.0 / 2048.0, 72.0 / 2048.0, -840.0 / 2048.0, 3584.0 / 2048.0, -6912.0 / 2048.0, 6144.0 / 2048.0];

/// Distance of the nearest singularity in half segments.
const CLEARANCE: f64 = 24.0;

const FEWEST_SEGMENTS: f64 = 32.0;

/// Largest number of segments: a table of more than 2¹² would exceed the caches, and next to the separatrix the theta quotients are faster.
const MOST_SEGMENTS: f64 = 4096.0;

#[derive(Clone, Debug)]
pub(super) struct Table {
    /// Segments per second.
    pub(super) rate: DoubleDouble,
    /// Segments from the nearest quarter at t = 0, and whole segments up to that quarter.
    pub(super) offset: DoubleDouble,
    pub(super) start: f64,
    /// The change over one pass through all segments, in rotation.
    pub(super) cycle: Option<Cycle>,
    pub(super) turns: i64,
    /// One less than the number of segments, a power of two. Reading it from a field and not from the length keeps a bounds check in the loop,
    /// without which the compiler would gather across segments.
    pub(super) mask: usize,
    pub(super) segments: Vec<Segment>,
}

/// A turn of a rotation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cycle {
    /// The change of the angle, ±2π.
    pub(super) advance: DoubleDouble,
    pub(super) direction: f64,
    /// 1/segments, a power of two.
    pub(super) inverse: f64,
}

/// A polynomial for the angle relative to `base`, the lowest point or the upright position.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Segment {
    /// Coefficients of powers of y² of the four polynomials that make angle = a + y·b and velocity = c + y·d.
    pub(super) rows: [[f64; 4]; ROWS],
    pub(super) base: DoubleDouble,
    /// ±1 if the angle counts from ±π of the turn, otherwise 0.
    pub(super) top: f64,
    /// Turns passed in the cycle.
    pub(super) turns: f64,
}

/// The state at the middle of a segment.
struct Middle {
    /// sin(θ/2) and cos(θ/2).
    sine: DoubleDouble,
    cosine: DoubleDouble,
    /// θ′ per segment.
    velocity: DoubleDouble,
}

impl Table {
    pub(super) fn of_libration(libration: &Libration) -> Option<Self> {
        let (angular_frequency, clock) = (libration.angular_frequency(), libration.clock());
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
                Segment::about(&Middle { sine: k * at.sn, cosine: at.dn, velocity }, step, rate, base)
            })
            .collect();
        // θ(t + T/2) = −θ(t).
        let mirrored: Vec<Segment> = segments.iter().map(|segment| segment.mirrored(base)).collect();
        segments.extend(mirrored);
        let (offset, start) = (clock.offset * count, 0.25 * count * clock.quarter);
        Some(Self { rate, offset, start, cycle: None, turns, mask: segments.len() - 1, segments })
    }

    pub(super) fn of_rotation(rotation: &Rotation) -> Option<Self> {
        let (speed, clock) = (rotation.speed(), rotation.clock());
        let modulus = rotation.modulus();
        // One turn of the pendulum is a half of 4K.
        let count = segments(&modulus, 1.0)?;
        let quotients = PreciseQuotients::new(&modulus);
        let rate = clock.frequency * (2.0 * count);
        let direction = rotation.direction();
        let step = speed * modulus.modulus_words() / rate;
        let (turns, base) = rotation.start_of_turn();
        let advance = DoubleDouble::PI.scaled(2.0 * direction);
        let segments: Vec<Segment> = fractions(count, count)
            .map(|fraction| {
                let at = quotients.at(0.5 * if fraction >= 0.5 { fraction - 1.0 } else { fraction });
                let velocity = at.dn * (speed / rate).scaled(2.0 * direction);
                let middle = Middle { sine: at.sn.scaled(direction), cosine: at.cn, velocity };
                let gone = if fraction >= 0.5 { direction } else { 0.0 };
                Segment { turns: gone, ..Segment::about(&middle, step, rate, base + advance * gone.abs()) }
            })
            .collect();
        let (offset, start) = (clock.offset * (2.0 * count), 0.5 * count * clock.quarter);
        Some(Self {
            rate,
            offset,
            start,
            cycle: Some(Cycle { advance, direction, inverse: 1.0 / count }),
            turns,
            mask: segments.len() - 1,
            segments,
        })
    }
}

/// Number of segments for a cycle of `half_periods`·2K; `None` if they are too many.
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
    /// The polynomial about this state for `rate` segments per second, where `step` = ω0/rate.
    fn about(middle: &Middle, step: DoubleDouble, rate: DoubleDouble, base: DoubleDouble) -> Self {
        let Middle { sine, cosine, velocity } = *middle;
        let size = sine.abs();
        let top = if size.hi > cosine.hi { 1f64.copysign(sine.hi) } else { 0.0 };
        let away = if top == 0.0 {
            two_word::atan2(sine, cosine).scaled(2.0)
        } else {
            two_word::atan2(cosine, size).scaled(-2.0 * top)
        };
        // The sine of the angle from the base, which is θ or θ ∓ π.
        let flip = if top == 0.0 { 1.0 } else { -1.0 };
        let sin = (sine * cosine).scaled(2.0 * flip);
        let cos = (cosine.square() - sine.square()).to_f64() * flip;
        let factor = step.square().scaled(-flip);
        let x = taylor([away.hi, velocity.to_f64()], [sin.to_f64(), cos], factor.to_f64());
        // The first two coefficients decide the last bits of the velocity, the second one next to a turning point.
        let slopes = [(velocity * rate).to_f64(), (factor * sin * rate).to_f64()];
        let rows = rows(&x, rate.hi, slopes);
        let base = base + DoubleDouble::PI * top;
        Self { rows, base: DoubleDouble::new(base.hi, base.lo + away.lo), top, turns: 0.0 }
    }

    /// The segment half a period later.
    fn mirrored(&self, base: DoubleDouble) -> Self {
        let shift = self.base - base;
        Self { rows: self.rows.map(|row| row.map(|c| -c)), base: base - shift, top: -self.top, turns: 0.0 }
    }
}

/// The rows of a segment, highest power first: xₖ for the angle, k·xₖ·rate for the velocity, whose first two coefficients are given.
pub fn rows(x: &[f64; DEGREE + 1], rate: f64, leading: [f64; 2]) -> [[f64; 4]; ROWS] {
    let mut slopes = [0.0; DEGREE];
    let mut k = 1.0;
    for (slope, x) in slopes.iter_mut().zip(&x[1..]) {
        *slope = k * x * rate;
        k += 1.0;
    }
    [slopes[0], slopes[1]] = leading;
    let mut rows = [[0.0; 4]; ROWS];
    // |y| ≤ 1/2, z = 2y.
    let mut power = x[DEGREE] / f64::from(1 << DEGREE);
    for (i, row) in rows.iter_mut().rev().enumerate() {
        let even = TWELFTH_POWER[i].fma(power, x[2 * i]);
        *row = [even, x[2 * i + 1], slopes[2 * i], slopes[2 * i + 1]];
        power *= 4.0;
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
