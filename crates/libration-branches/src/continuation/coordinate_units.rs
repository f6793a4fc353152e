//! Units of coordinates that differ by orders of magnitude, as those of an angle and of a charge in coulombs.
//!
//! # Method
//! A branch is followed by norms of states, which compare coordinates with one another. Where their units differ by far, the branch is followed in
//! multiples of the coordinates, x = s·X, so that they affect one another equally: the powers of two s balance the mean sizes of the
//! derivatives of the equations at states of the first motion (Parlett and Reinsch, Numerische Mathematik 13 (1969) 293–304). That alone would
//! also separate coordinates of like units of which one hardly affects the other, so that s is used only if the extents of the motion
//! become alike by it. Angles, whose turns count, keep their unit.

use super::branch::Branch;
use super::curve::SpecialCurve;
use super::jumps::Jump;
use super::point::BranchPoint;
use super::search::{Search, Start};
use libration_kernels::elementary::count;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::{BigFloat, Doubles};
use libration_numbers::expression::{Equation, Expression, Symbol};
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::linear::balancing;
use std::f64::consts::TAU;

/// Least gain, as a ratio of extents: above it the smallest coordinate would be followed in a multiple of its own extent (`Family::units`).
const GAIN: f64 = 64.0;
/// Number of states at which derivatives are taken.
const STATES: u32 = 16;

/// A unit for each component of a state.
pub(super) struct CoordinateUnits {
    units: Vec<f64>,
}

impl CoordinateUnits {
    /// The units for a search by its first motion; `None` if the given ones do.
    pub(super) fn of(search: &Search<'_>, value: f64, start: &Start) -> Option<Self> {
        let layout = &search.family.layout;
        if layout.coordinates() < 2 {
            return None;
        }
        let ranges = search.family.ranges_of(start.space, &start.unknowns, value)?;
        let extents: Vec<f64> = ranges.iter().map(|[low, high]| 0.5 * (high - low)).collect();
        let box_of_motion = MotionBox { ranges: &ranges, period: search.period_of(start, value)?, value };
        let mut units = balancing(&box_of_motion.mean_slopes(search, layout)?);
        let angle = |coordinate: &usize| {
            search.family.turning.is_angle(*coordinate) || search.family.turning.is_coupled(*coordinate)
        };
        let largest = |units: &[f64]| extents.iter().zip(units).map(|(x, s)| x / s).fold(0.0, f64::max);
        let common = match (0..units.len()).find(angle) {
            Some(angle) => 1.0 / units[angle],
            None => libm::exp2(libm::floor(libm::log2(largest(&units)))),
        };
        units.iter_mut().for_each(|unit| *unit *= common);
        (0..units.len()).filter(angle).for_each(|angle| units[angle] = 1.0);
        let spread = |units: &[f64]| {
            let moving = || extents.iter().zip(units).filter(|(x, _)| **x > 0.0).map(|(x, s)| x / s);
            moving().fold(0.0, f64::max) / moving().fold(f64::INFINITY, f64::min)
        };
        let gain = spread(&vec![1.0; units.len()]) / spread(&units);
        let usable = units.iter().all(|unit| unit.is_normal()) && gain >= GAIN;
        usable.then(|| Self { units: layout.arrange(units.clone(), |coordinate| units[coordinate]) })
    }

    /// The equation in these units.
    pub(super) fn equation(&self, equation: &Equation) -> Option<Equation> {
        in_units(equation, &self.units[..equation.variables().len()])
    }

    /// A state in these units.
    pub(super) fn state(&self, state: &[f64]) -> Vec<f64> {
        state.iter().zip(&self.units).map(|(x, unit)| x / unit).collect()
    }

    /// Converts branches and jumps to the units of the equation.
    pub(super) fn restore(&self, branches: &mut [Branch], jumps: &mut [Jump]) {
        for branch in branches {
            branch.points.iter_mut().for_each(|point| self.restore_point(point));
            branch.special.iter_mut().for_each(|special| self.restore_point(&mut special.point));
        }
        for Jump { from, to, .. } in jumps {
            self.restore_point(from);
            to.iter_mut().for_each(|point| self.restore_point(point));
        }
    }

    /// Converts curves of singular motions, whose errors are those of parameters.
    pub(super) fn restore_curves(&self, curves: &mut [SpecialCurve]) {
        let points = curves.iter_mut().flat_map(|curve| curve.points.iter_mut().chain(&mut curve.cusps));
        points.for_each(|point| self.restore_motion(&mut point.point));
    }

    fn restore_point(&self, point: &mut BranchPoint) {
        self.restore_motion(point);
        point.error *= self.units.iter().copied().fold(0.0, f64::max);
    }

    fn restore_motion(&self, point: &mut BranchPoint) {
        point.state.iter_mut().zip(&self.units).for_each(|(x, unit)| *x *= unit);
        point.ranges.iter_mut().zip(&self.units).for_each(|(range, unit)| *range = range.map(|x| x * unit));
    }
}

/// The equation of the coordinates divided by these units.
fn in_units(equation: &Equation, units: &[f64]) -> Option<Equation> {
    let exact =
        |unit: &f64| BigFloat::from_f64(*unit, 53).map(|fraction| Expression::Number(fraction.to_rational()));
    let units: Vec<Expression> = units.iter().map(exact).collect::<Option<_>>()?;
    let multiple = |unit: &Expression, name: &Symbol| {
        Expression::Multiply(Box::new(unit.clone()), Box::new(Expression::Symbol(name.clone())))
    };
    let scaled = |(derivative, unit): (&Expression, &Expression)| {
        let names = equation.variables().iter().map(|name| Symbol::plain(name));
        let in_units = names.zip(&units).fold(derivative.clone(), |formula, (coordinate, unit)| {
            let velocity = coordinate.with_primes(1);
            let formula = formula.substitute(&coordinate, &multiple(unit, &coordinate));
            formula.substitute(&velocity, &multiple(unit, &velocity))
        });
        Expression::Divide(Box::new(in_units), Box::new(unit.clone()))
    };
    let derivatives = equation.derivatives().iter().zip(&units).map(scaled).collect();
    Some(Equation::of_derivatives(equation.variables().to_vec(), equation.orders().to_vec(), derivatives))
}

/// The coordinates and velocities that a motion may have.
struct MotionBox<'a> {
    ranges: &'a [[f64; 2]],
    period: f64,
    value: f64,
}

impl MotionBox<'_> {
    /// The mean sizes of the derivatives of each formula with respect to each coordinate, with those by its velocity, which is as large as the
    /// coordinate times the angular frequency.
    fn mean_slopes(&self, search: &Search<'_>, layout: &StateLayout) -> Option<Vec<Vec<f64>>> {
        let Search { equation, parameter, .. } = search;
        let places: Vec<Symbol> = equation.variables().iter().map(|name| Symbol::plain(name)).collect();
        let velocities: Vec<Symbol> = places.iter().map(|coordinate| coordinate.with_primes(1)).collect();
        let inputs = [&places[..], &velocities, &[Symbol::plain("t"), Symbol::plain(parameter)]].concat();
        let n = places.len();
        let slope = |formula: &Expression, by: &Symbol| formula.derivative(by).simplified();
        let slopes: Vec<Expression> = equation
            .derivatives()
            .iter()
            .flat_map(|formula| places.iter().chain(&velocities).map(move |by| slope(formula, by)))
            .collect();
        let tape = Tape::new(&slopes.iter().collect::<Vec<_>>(), &inputs).ok()?;
        let pace = TAU / self.period;
        let mut means = vec![vec![0.0; n]; n];
        for number in 0..STATES {
            let jet = Jet::new(&Doubles, &tape, &self.state(number, layout)).ok()?;
            let size = |i: usize, j: usize| {
                let values =
                    [(j, 1.0), (n + j, pace)].map(|(j, unit)| jet.result(2 * n * i + j)[0].abs() * unit);
                values.into_iter().filter(|value| value.is_finite()).sum::<f64>()
            };
            for (i, row) in means.iter_mut().enumerate() {
                row.iter_mut().enumerate().for_each(|(j, mean)| *mean += size(i, j) / f64::from(STATES));
            }
        }
        Some(means)
    }

    /// Coordinates, velocities, time and parameter.
    fn state(&self, number: u32, layout: &StateLayout) -> Vec<f64> {
        // Multiples of the golden ratio are evenly distributed.
        let part = |k: usize| ((7.0 * f64::from(number) + count(k + 1)) * 0.618_033_988_749_894_9).fract();
        let n = layout.coordinates();
        let displacement = |(k, [low, high]): (usize, &[f64; 2])| low + part(k) * (high - low);
        let pace = TAU / self.period;
        let velocity = |(k, [low, high]): (usize, &[f64; 2])| (part(n + k) - 0.5) * (high - low) * pace;
        let places = self.ranges.iter().enumerate().map(displacement);
        let velocities = self.ranges.iter().enumerate().map(velocity);
        places.chain(velocities).chain([part(2 * n) * self.period, self.value]).collect()
    }
}
