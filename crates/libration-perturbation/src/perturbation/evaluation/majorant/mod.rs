//! Proven remainders of the period and the frequency for a force that is a polynomial.

mod any;
mod odd;

use super::positive::{PositiveSeries, PositiveSeriesAt};
use any::AnyWell;
use libration_numbers::algebra::{Doubles, Rational};
use libration_numbers::internals::series::truncated::reciprocal;
use libration_numbers::roots::{Tolerance, bisect};
use odd::OddWell;

/// Series of T/T0 and Ω/ω0 in the amplitude with coefficients at least as large as those of an oscillator, in magnitude.
///
/// For the force ω0²(x + c₂x² + c₃x³ + …) they come from the well with −|cₘ| in place of each cₘ.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::PeriodMajorant;
/// // x″ = −x + x³: here the bound is what is missing.
/// let force = ["1", "0", "-1"].map(|text| text.parse().unwrap());
/// let majorant = PeriodMajorant::new(&force, 4).ok_or("no polynomial")?;
/// let bound = majorant.period_at(0.6);
/// // T/T0 = (2/π)·K(m)/√(1 − A²/2) with m = (A²/2)/(1 − A²/2), by mpmath.
/// let missing = 1.173_775_132_086_487_5 - (1.0 + 3.0 / 8.0 * 0.36 + 57.0 / 256.0 * 0.36 * 0.36);
/// assert!(missing <= bound.after(4) && bound.after(4) < 1.001 * missing);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodMajorant {
    well: Well,
    period: PositiveSeries,
    frequency: PositiveSeries,
}

/// The bound at one amplitude.
#[derive(Clone, Debug, PartialEq)]
pub struct MajorantAt<'a>(PositiveSeriesAt<'a>);

#[derive(Clone, Debug, PartialEq)]
enum Well {
    Odd(OddWell),
    Any(AnyWell),
}

impl PeriodMajorant {
    /// The majorant for the restoring force g₁x + g₂x² + … and series up to a power; `None` where the force is linear or repulsive.
    #[must_use]
    pub fn new(force: &[Rational], order: usize) -> Option<Self> {
        let first = force.first().filter(|first| **first > Rational::from(0))?;
        let factor = |term: &Rational| Some(term.checked_div(first)?.to_f64().abs());
        let factors: Vec<f64> = force.iter().skip(1).map(factor).collect::<Option<_>>()?;
        let well = if factors.iter().step_by(2).all(|even| *even == 0.0) {
            let odd: Vec<f64> = factors.iter().skip(1).step_by(2).copied().collect();
            Well::Odd(OddWell::new(&odd)?)
        } else {
            Well::Any(AnyWell::new(&factors)?)
        };
        let period = match &well {
            Well::Odd(well) => well.period_series(order),
            Well::Any(well) => well.period_series(order),
        };
        let stride = if matches!(well, Well::Odd(_)) { 2 } else { 1 };
        // Ω/ω0 = 1/(1 + (T/T0 − 1)) has no larger coefficients than 1/(1 − (majorant − 1)).
        let below: Vec<f64> = (0..).zip(&period).map(|(n, t)| if n == 0 { 2.0 - t } else { -t }).collect();
        let frequency = PositiveSeries::new(reciprocal(&Doubles, &below)?, 0, stride);
        Some(Self { well, period: PositiveSeries::new(period, 0, stride), frequency })
    }

    /// The bound for T/T0 at an amplitude.
    #[must_use]
    pub fn period_at(&self, amplitude: f64) -> MajorantAt<'_> {
        MajorantAt(self.period.at(amplitude / self.limit(), 1.0, |amplitude| self.ratio(amplitude)))
    }

    /// The bound for Ω/ω0 at an amplitude.
    #[must_use]
    pub fn frequency_at(&self, amplitude: f64) -> MajorantAt<'_> {
        let value = |amplitude: f64| match 2.0 - self.ratio(amplitude) {
            // The difference is right to some 1e-12, as the period is.
            inverse if inverse > 0.1 => 1.0 / inverse,
            _ => f64::INFINITY,
        };
        MajorantAt(self.frequency.at(amplitude / self.limit(), 1.0, value))
    }

    /// The amplitude above which there is no bound.
    fn limit(&self) -> f64 {
        match &self.well {
            Well::Odd(well) => well.limit(),
            Well::Any(well) => well.limit(),
        }
    }

    /// The bound of T/T0 itself, the amplitude in units of the limit.
    fn ratio(&self, amplitude: f64) -> f64 {
        match &self.well {
            Well::Odd(well) => well.period(amplitude),
            Well::Any(well) => well.period(amplitude),
        }
    }
}

impl MajorantAt<'_> {
    /// A bound on the remainder of the series in powers of the amplitude after this power. Infinite where the bounding series has no value.
    #[must_use]
    pub fn after(&self, power: usize) -> f64 {
        self.0.after(power)
    }
}

/// The amplitude at which a sum that grows from zero with the amplitude is one; `None` if there is none with a finite square and inverse square.
fn place_of_one(sum: impl Fn(f64) -> f64) -> Option<f64> {
    let mut high = 1.0;
    while sum(high) < 1.0 && high < 1e150 {
        high *= 2.0;
    }
    if sum(high) < 1.0 || sum(high).is_nan() {
        return None;
    }
    let [root, _] = bisect([0.0, high], Tolerance::LAST_BIT, |amplitude| sum(amplitude) < 1.0);
    (1e-100..1e100).contains(&root).then_some(root)
}
