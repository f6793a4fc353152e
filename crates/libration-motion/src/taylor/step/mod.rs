//! One step: the state as polynomials of the time.

pub(in crate::taylor) mod allowance;
pub(in crate::taylor) mod block;
pub(in crate::taylor) mod ends;
pub(in crate::taylor) mod larger;
#[doc(hidden)]
pub(crate) mod largest_change;
pub(in crate::taylor) mod layout;
pub(in crate::taylor) mod samples;
#[doc(hidden)]
pub(crate) mod sign_change;
pub(in crate::taylor) mod sizes_of_terms;
pub(in crate::taylor) mod step_length;
pub(in crate::taylor) mod tolerances;

use std::sync::Arc;

use crate::taylor::StateLayout;
use libration_kernels::dispatch::{Kernel, dispatch};
use libration_kernels::double_double::{DoubleDouble, two_prod, two_sum};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_numbers::internals::algebra::{any, lanes};

/// A step of an integration, which gives the state at every time inside it.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    pub(in crate::taylor) start: f64,
    pub(in crate::taylor) end: f64,
    pub(in crate::taylor) unit: f64,
    /// Coefficients in powers of the time since the start in this unit, of the coordinates and then of the velocities, in all lanes.
    pub(in crate::taylor) coefficients: &'a [f64],
    /// Low words of the state, which are not part of the first coefficients.
    pub(in crate::taylor) low: &'a [f64],
    pub(in crate::taylor) layout: &'a Arc<StateLayout>,
    pub(in crate::taylor) terms: usize,
    pub(in crate::taylor) lanes: usize,
    pub(in crate::taylor) lane: usize,
}

impl Step<'_> {
    /// The time at which the step begins, in the direction of the integration.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The time at which the step ends: before the start in an integration backward in time.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Coordinates, then velocities, at a time between start and end.
    ///
    /// # Accuracy
    /// That of the state at the end of the step. Outside the step the error grows like a power of the time, up to the order of the series.
    #[must_use]
    pub fn state_at(&self, time: f64) -> Vec<f64> {
        dispatch(StateKernel { step: self, time })
    }

    /// One component of the state at a time.
    #[doc(hidden)]
    pub fn number_at(&self, number: usize, time: f64) -> f64 {
        dispatch(Number { step: self, number, time })
    }

    #[inline(always)]
    pub(in crate::taylor) fn numbers(&self) -> usize {
        self.low.len() / self.lanes
    }

    #[inline(always)]
    pub(in crate::taylor) fn coefficient(&self, number: usize, n: usize) -> f64 {
        self.coefficients[(number * self.terms + n) * self.lanes + self.lane]
    }

    #[inline(always)]
    pub(in crate::taylor) fn low(&self, number: usize) -> f64 {
        self.low.get(number * self.lanes + self.lane).copied().unwrap_or(0.0)
    }

    /// One state component in two words.
    #[inline(always)]
    pub(in crate::taylor) fn component_at(&self, number: usize, time: f64) -> DoubleDouble {
        let (elapsed, remainder) = elapsed(self.start, time);
        let h = elapsed / self.unit;
        let [higher] = higher(self.terms, |n| [self.coefficient(number, n)], &[h]);
        let base = DoubleDouble::new(self.coefficient(number, 0), self.low(number));
        let slope_low = self.layout.velocity(number).map_or(0.0, |velocity| self.low(velocity) * self.unit);
        let value = grown(base, self.coefficient(number, 1), slope_low, higher, h);
        if remainder == 0.0 { value } else { value + self.slope_at(number, time) * remainder }
    }

    /// The rate of change of each coordinate at a time: its velocity, or the derivative of its polynomial if the state contains no velocity.
    #[doc(hidden)]
    pub fn speeds_at(&self, time: f64) -> Vec<f64> {
        (0..self.layout.coordinates()).map(|coordinate| self.rate_at(coordinate, time)).collect()
    }

    /// The rate of change of one component of the state at a time.
    pub(crate) fn rate_at(&self, component: usize, time: f64) -> f64 {
        match self.layout.velocity(component) {
            Some(velocity) => self.number_at(velocity, time),
            None => self.slope_at(component, time),
        }
    }

    /// The time derivative of one state component at a time.
    #[inline(always)]
    pub(in crate::taylor) fn slope_at(&self, number: usize, time: f64) -> f64 {
        let h = (time - self.start) / self.unit;
        let horner =
            |(value, slope): (f64, f64), n| (value * h + self.coefficient(number, n), slope * h + value);
        (0..self.terms).rev().fold((0.0, 0.0), horner).1 / self.unit
    }
}

/// A state at a time, compiled for each instruction set.
struct StateKernel<'s, 'a> {
    step: &'s Step<'a>,
    time: f64,
}

impl Kernel for StateKernel<'_, '_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run(self) -> Vec<f64> {
        let Self { step, time } = self;
        (0..step.numbers()).map(|number| step.component_at(number, time).to_f64()).collect()
    }
}

/// One state component at a time.
struct Number<'s, 'a> {
    step: &'s Step<'a>,
    number: usize,
    time: f64,
}

impl Kernel for Number<'_, '_> {
    type Output = f64;

    #[inline(always)]
    fn run(self) -> f64 {
        self.step.component_at(self.number, self.time).to_f64()
    }
}

/// The sum c₂h + c₃h² + … of a series with `terms` terms, including c₀ and c₁.
#[inline(always)]
pub(in crate::taylor) fn higher<const N: usize>(
    terms: usize,
    coefficient: impl Fn(usize) -> [f64; N],
    h: &[f64; N],
) -> [f64; N] {
    /// A number whose square does not overflow: if terms vanish, a step may be as long as the range of times.
    const LARGE: f64 = 1e150;
    let mut sum = even_and_odd(terms, &coefficient, h);
    if any(h, |h| h.abs() > LARGE) {
        for lane in (0..N).filter(|&lane| h[lane].abs() > LARGE) {
            sum[lane] = (2..terms).rev().fold(0.0, |sum, n| (sum + coefficient(n)[lane]) * h[lane]);
        }
    }
    sum
}

/// Even and odd terms in two sums, neither of which waits for the other.
#[inline(always)]
fn even_and_odd<const N: usize>(
    terms: usize,
    coefficient: &impl Fn(usize) -> [f64; N],
    h: &[f64; N],
) -> [f64; N] {
    let square: [f64; N] = lanes(|lane| h[lane] * h[lane]);
    let [mut even, mut odd] = [[0.0; N]; 2];
    let mut n = terms;
    if !n.is_multiple_of(2) {
        n -= 1;
        even = coefficient(n);
    }
    while n > 2 {
        n -= 2;
        let (c, d) = (coefficient(n), coefficient(n + 1));
        even = lanes(|lane| even[lane].fma(square[lane], c[lane]));
        odd = lanes(|lane| odd[lane].fma(square[lane], d[lane]));
    }
    lanes(|lane| odd[lane].fma(h[lane], even[lane]) * h[lane])
}

/// The exact time since the start, in two words if necessary.
#[inline(always)]
pub(in crate::taylor) fn elapsed(start: f64, time: f64) -> (f64, f64) {
    let DoubleDouble { hi, lo } = two_sum(time, -start);
    (hi, lo)
}

/// c₀ + c₁h + (c₂h + c₃h² + …)h, given the last bracket: the large terms are added in two words.
///
/// `slope_low` is the low word of c₁, if known.
#[inline(always)]
pub(in crate::taylor) fn grown(
    base: DoubleDouble,
    slope: f64,
    slope_low: f64,
    higher: f64,
    h: f64,
) -> DoubleDouble {
    base + two_prod(slope, h) + (higher * h + slope_low * h)
}
