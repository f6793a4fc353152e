//! Singular points to a requested number of digits.
//!
//! The iteration is separate from `roots::newton`: its derivatives are computed
//! once, in double precision, and it ends when corrections no longer shrink.

use super::error::BranchError;
use super::family::{Family, TOLERANCES};
use super::precise_flow::{PreciseFlow, PreciseImage};
use super::singular::Singular;
use super::space::Space;
use super::special::{SpecialKind, SpecialPoint, Test};
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Ring};
use libration_numbers::expression::Equation;
use libration_numbers::internals::linear::{self, eigenvalues, solve};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

/// A singular point in floats of many bits.
#[derive(Clone, Debug, PartialEq)]
pub struct PreciseSpecial {
    /// The value of the parameter.
    pub parameter: BigFloat,
    /// The state at phase zero of the drive: coordinates, then velocities.
    pub state: Vec<BigFloat>,
    /// Bound on the error of the parameter: its change with series of another order, plus rounding.
    pub error: f64,
}

/// Bits in addition to the requested digits.
const SPARE: usize = 40;
/// Maximum number of corrections; each gains about nine digits.
const MOST_ROUNDS: usize = 200;

impl SpecialPoint {
    /// The singular point of a branch in a space, found by [`Response::over`](super::Response::over) for the equation and the
    /// parameter, to a number of digits: Newton's method with residuals in floats of many bits and derivatives in double
    /// precision. `None` for neutral saddles, for Neimark–Sacker points of states with more than two components, for branch
    /// points of autonomous motions or of motions other than the equilibrium at zero, for symmetry breakings if the equations are symmetric about
    /// another state than zero, and if the motion cannot be integrated.
    ///
    /// A cancelled call returns `None`.
    ///
    /// # Accuracy
    /// As its error states, below the last digit.
    ///
    /// # Errors
    /// Equations without a periodic drive, another symbolic parameter.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{Response, ResponseOptions};
    /// use libration::progress::Quiet;
    /// let pendulum = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
    /// let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    /// let response = Response::over(&pendulum, "w", [0.8, 0.9], &options, &Quiet)?;
    /// let branch = &response.branches[0];
    /// let fold = branch.special[0].to_digits(&pendulum, "w", branch.space, 25, &Quiet)?.ok_or("no digits")?;
    /// // Reference: Fourier collocation and Taylor series in floats of 130 bits.
    /// assert_eq!(fold.parameter.to_rational().to_decimal(25), "0.8721575691379171688795389");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_digits(
        &self,
        equation: &Equation,
        parameter: &str,
        space: Space,
        digits: u32,
        progress: &dyn Progress,
    ) -> Result<Option<PreciseSpecial>, BranchError> {
        let watch = &Watch::new(progress);
        let value = self.point.parameter;
        let width = value.abs().max(f64::MIN_POSITIVE);
        if !equation.depends_on_time() {
            return Ok(None);
        }
        let family = Family::new(equation, &[parameter], &[[value - width, value + width]], watch)?;
        // Another centre than zero is known in double precision only, and the whole period needs none.
        let is_mirrored_elsewhere = space.mirrored && !family.mirror.is_about_zero();
        let space = if is_mirrored_elsewhere { space.doubled() } else { space };
        let flow = PreciseFlow::new(equation, parameter, &family.mirror, watch)?;
        let is_zero = self.point.state.iter().all(|x| *x == 0.0);
        let is_rest = is_zero && self.point.ranges.iter().all(|[low, high]| low.to_bits() == high.to_bits());
        let test = match self.kind {
            SpecialKind::Fold => Test::Branching,
            SpecialKind::BranchPoint if is_rest => Test::Branching,
            SpecialKind::SymmetryBreaking if space.mirrored => Test::Flip,
            SpecialKind::PeriodDoubling => Test::Flip,
            SpecialKind::NeimarkSacker if self.point.state.len() == 2 => Test::Torus,
            _ => return Ok(None),
        };
        let rest = is_rest.then_some(&self.point.state[..]);
        let singular = Singular { family: &family, space, test, rest };
        let units = family.units(&self.point, family.largest_swing(&self.point), width);
        let bits = usize::try_from(digits).unwrap_or(usize::MAX / 8) * 10 / 3 + SPARE;
        let root = PreciseSearch { singular, flow, units, ring: Floats { precision: bits }, digits };
        Ok(root.located(self))
    }
}

struct PreciseSearch<'a> {
    singular: Singular<'a>,
    flow: PreciseFlow<'a>,
    units: Vec<f64>,
    ring: Floats,
    digits: u32,
}

impl PreciseSearch<'_> {
    fn located(&self, special: &SpecialPoint) -> Option<PreciseSpecial> {
        let state = &special.point.state;
        let free = if self.singular.rest.is_some() { &[][..] } else { state };
        let start: Vec<f64> = free.iter().copied().chain([special.point.parameter]).collect();
        let units = &self.units[self.units.len() - start.len()..];
        let slopes = self.singular.slopes(&start, units, TOLERANCES[0])?;
        let big = |x: f64| BigFloat::from_f64(x, self.ring.precision);
        let mut unknowns: Vec<BigFloat> = start.iter().map(|x| big(*x)).collect::<Option<_>>()?;
        let order = u32::try_from(self.ring.precision / 3).ok()?;
        let wanted = libm::exp10(-f64::from(self.digits) - 3.0);
        let mut before = f64::INFINITY;
        for _ in 0..MOST_ROUNDS {
            let change = self.change(&slopes, &unknowns, units, order)?;
            let size = norm(&change);
            if !size.is_finite() || size > before {
                return None;
            }
            for ((number, change), unit) in unknowns.iter_mut().zip(&change).zip(units) {
                *number = self.ring.add(number, &big(change * unit)?);
            }
            if size < wanted {
                return self.with_error(&slopes, unknowns, units, order);
            }
            before = size;
        }
        None
    }

    /// Newton's correction in scaled units, with series to an order.
    fn change(
        &self,
        slopes: &[Vec<f64>],
        position: &[BigFloat],
        units: &[f64],
        order: u32,
    ) -> Option<Vec<f64>> {
        let zero: Vec<BigFloat> = vec![self.ring.zero(); self.flow_numbers()];
        let (state, parameter) = match self.singular.rest {
            Some(_) => (&zero[..], position),
            None => position.split_at(position.len() - 1),
        };
        let image = self.flow.image(self.ring, order, self.singular.space, [state, parameter])?;
        let test = self.test(&image)?;
        let missed = image.defect.iter().zip(units).map(|(d, unit)| d.to_f64() / unit);
        let values: Vec<f64> =
            if self.singular.rest.is_some() { vec![test] } else { missed.chain([test]).collect() };
        let right: Vec<f64> = values.into_iter().map(|x| -x).collect();
        solve(&Doubles, |x| x.abs(), slopes, &right)
    }

    fn flow_numbers(&self) -> usize {
        self.singular.family.layout.numbers()
    }

    /// The test function of double precision, with the relative accuracy of its remaining value.
    fn test(&self, image: &PreciseImage) -> Option<f64> {
        let ring = self.ring;
        let shifted = |by: i64| -> Vec<Vec<BigFloat>> {
            let shift = BigFloat::from_integer(by, ring.precision);
            let shifted_row = |(i, row): (usize, &Vec<BigFloat>)| {
                let entry = |(j, x): (usize, &BigFloat)| if i == j { ring.add(x, &shift) } else { x.clone() };
                row.iter().enumerate().map(entry).collect()
            };
            image.map.iter().enumerate().map(shifted_row).collect()
        };
        Some(match self.singular.test {
            Test::Fold | Test::Branching => determinant(ring, &shifted(-1))?.to_f64(),
            Test::Flip => determinant(ring, &shifted(1))?.to_f64(),
            Test::Collision => return None,
            Test::Torus => {
                let rounded: Vec<Vec<f64>> =
                    image.map.iter().map(|row| row.iter().map(BigFloat::to_f64).collect()).collect();
                let largest =
                    eigenvalues(&rounded)?.first().map_or(1.0, |eigenvalue| eigenvalue.abs().max(1.0));
                let one = BigFloat::from_integer(1, ring.precision);
                ring.subtract(&determinant(ring, &image.map)?, &one).to_f64() / (largest * largest)
            }
        })
    }

    fn with_error(
        &self,
        slopes: &[Vec<f64>],
        position: Vec<BigFloat>,
        units: &[f64],
        order: u32,
    ) -> Option<PreciseSpecial> {
        /// Increase of the order for the error estimate: another order has other steps and other rounding errors.
        const MORE: u32 = 9;
        let change = self.change(slopes, &position, units, order + MORE)?;
        let mut state = position;
        let parameter = state.pop()?;
        let unit = *units.last()?;
        let rounding =
            libm::exp2(-f64::from(u32::try_from(self.ring.precision).ok()?)) * parameter.to_f64().abs();
        let error = 4.0 * (norm(&change) * unit + rounding);
        if self.singular.rest.is_some() {
            state = vec![self.ring.zero(); self.flow_numbers()];
        }
        Some(PreciseSpecial { parameter, state, error })
    }
}

fn determinant(ring: Floats, rows: &[Vec<BigFloat>]) -> Option<BigFloat> {
    linear::determinant(&ring, |x| x.to_f64().abs(), rows)
}
