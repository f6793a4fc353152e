//! The motion with its derivatives by the start in floats of many bits.

use super::drive_law::DriveLaw;
use super::error::NoBranch;
use super::space::Space;
use libration_kernels::elementary::count;
use libration_motion::taylor::{StateLayout, with_sensitivities};
use libration_numbers::algebra::{BigFloat, Floats, Ring};
use libration_numbers::watch::Watch;
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};

/// Steps of one motion.
const MOST_STEPS: usize = 5000;

/// A driven system over one parameter, whose motions are series in the time.
pub(super) struct PreciseFlow<'w> {
    own: StateLayout,
    all: StateLayout,
    /// The rates of the motion and of its derivatives, in the state, the time and the parameter.
    tape: Tape,
    law: DriveLaw,
    watch: &'w Watch<'w>,
}

/// Where a motion leads in the time of its space, its mirror image where the space has one.
pub(super) struct PreciseImage {
    /// What its end misses of the start.
    pub(super) defect: Vec<BigFloat>,
    /// How the end depends on the start, by rows.
    pub(super) map: Vec<Vec<BigFloat>>,
}

impl<'w> PreciseFlow<'w> {
    pub(super) fn new(equation: &Equation, parameter: &str, watch: &'w Watch<'w>) -> Result<Self, NoBranch> {
        let own = StateLayout::new(equation);
        let with_derivatives = with_sensitivities(equation, &[], own.numbers());
        let all = StateLayout::new(&with_derivatives);
        let mut inputs = all.symbols(with_derivatives.variables());
        inputs.extend([Symbol::plain("t"), Symbol::plain(parameter)]);
        let tape = Tape::new(&with_derivatives.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { own, all, tape, law: DriveLaw::new(equation, &[parameter])?, watch })
    }

    /// With series to an order; `None` where the motion cannot be followed.
    pub(super) fn image(
        &self,
        ring: Floats,
        order: u32,
        space: Space,
        [state, parameter]: [&[BigFloat]; 2],
    ) -> Option<PreciseImage> {
        let parameter = parameter.first()?;
        let numbers = self.own.numbers();
        let place = |number: usize, copy: usize| self.own.place_in_copy(number, copy, numbers);
        let mut now = vec![ring.zero(); self.all.numbers()];
        for (number, value) in state.iter().enumerate() {
            now[place(number, 0)] = value.clone();
            now[place(number, 1 + number)] = BigFloat::from_integer(1, ring.precision);
        }
        let halves = i64::from(space.half_periods);
        let duration = ring.times_integer(&self.law.precise_period(ring, parameter)?, halves).halved();
        let end = self.end(ring, order, now, [&duration, parameter])?;
        let signed =
            |number: usize| if space.mirrored { ring.negate(&end[number]) } else { end[number].clone() };
        let row = |number: usize| (0..numbers).map(|start| signed(place(number, 1 + start))).collect();
        let turn = ring.times_integer(&BigFloat::pi(ring.precision), 2);
        let missed = |(number, start): (usize, &BigFloat)| {
            let turned = ring.times_integer(&turn, space.turns_of(number).into());
            ring.subtract(&ring.subtract(&signed(place(number, 0)), start), &turned)
        };
        Some(PreciseImage {
            defect: state.iter().enumerate().map(missed).collect(),
            map: (0..numbers).map(row).collect(),
        })
    }

    fn end(
        &self,
        ring: Floats,
        order: u32,
        mut now: Vec<BigFloat>,
        [duration, parameter]: [&BigFloat; 2],
    ) -> Option<Vec<BigFloat>> {
        let mut time = ring.zero();
        for _ in 0..MOST_STEPS {
            self.watch.go_on().ok()?;
            let series = self.series(ring, order, &now, [&time, parameter])?;
            let left = ring.subtract(duration, &time);
            let length = BigFloat::from_f64(step_length(&series, ring.precision)?, ring.precision)?;
            let is_last = length >= left;
            let step = if is_last { left } else { length };
            now = series.iter().map(|one| sum_at(ring, one, &step)).collect();
            if is_last {
                return Some(now);
            }
            time = ring.add(&time, &step);
        }
        None
    }

    /// Of each number of the state.
    fn series(
        &self,
        ring: Floats,
        order: u32,
        now: &[BigFloat],
        [time, parameter]: [&BigFloat; 2],
    ) -> Option<Vec<Vec<BigFloat>>> {
        let mut series: Vec<Vec<BigFloat>> = now.iter().map(|x| vec![x.clone()]).collect();
        let inputs: Vec<BigFloat> = now.iter().chain([time, parameter]).cloned().collect();
        let mut jet = Jet::new(&ring, &self.tape, &inputs).ok()?;
        for n in 1..=order {
            let last = usize::try_from(n - 1).ok()?;
            let mut next = vec![ring.zero(); now.len()];
            for coordinate in 0..self.all.coordinates() {
                if let Some(velocity) = self.all.velocity(coordinate) {
                    next[coordinate] = ring.over_integer(&series[velocity][last], n.into())?;
                }
                next[self.all.driven(coordinate)] =
                    ring.over_integer(&jet.result(coordinate)[last], n.into())?;
            }
            let slope = BigFloat::from_integer(i64::from(n == 1), ring.precision);
            let inputs: Vec<BigFloat> = next.iter().cloned().chain([slope, ring.zero()]).collect();
            series.iter_mut().zip(next).for_each(|(one, next)| one.push(next));
            if n < order {
                jet.extend(&inputs).ok()?;
            }
        }
        Some(series)
    }
}

/// Where the last terms of all numbers are below the last bit of the largest.
fn step_length(series: &[Vec<BigFloat>], precision: usize) -> Option<f64> {
    /// Coefficients by which the radius of convergence is known, some of which vanish by symmetry.
    const LAST: usize = 4;
    let real = |exponent: isize| i32::try_from(exponent).map_or(f64::NAN, f64::from);
    let size = series.iter().filter_map(|one| one.first()?.exponent()).max().unwrap_or(0);
    let bits = count(precision) + 4.0;
    let of_number = |one: &Vec<BigFloat>| {
        let last = one.iter().enumerate().skip(one.len().saturating_sub(LAST));
        let lengths = last.filter_map(|(n, c)| Some(-(bits + real(c.exponent()? - size)) / count(n)));
        lengths.fold(f64::INFINITY, f64::min)
    };
    let shortest = series.iter().map(of_number).fold(f64::INFINITY, f64::min);
    let length = libm::exp2(shortest);
    (length.is_finite() && length > 0.0).then_some(length)
}

fn sum_at(ring: Floats, series: &[BigFloat], time: &BigFloat) -> BigFloat {
    series.iter().rev().fold(ring.zero(), |sum, c| ring.add(&ring.multiply(&sum, time), c))
}
