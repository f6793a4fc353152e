//! The exact law of forces in proportion to one power of the displacement.

use libration_kernels::elementary::count;
use libration_motion::oscillator::PurePower;
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::quadrature::double_exponential;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Motions under the force −k·sign(x)·|x|ᵖ are all alike: with the amplitude A
///
/// ```text
/// Ω = √(πk(p + 1)/2)·Γ((p + 3)/(2(p + 1)))/Γ(1/(p + 1))·A^((p − 1)/2),
/// ```
///
/// and the harmonics of x/A, which are odd, are the same for all amplitudes.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::comparison::ScalingLaw;
/// use libration::oscillator::PurePower;
/// let cubic = PurePower::of(&"x'' + x^3 = 0".parse()?, None).ok_or("no power")?;
/// let law = ScalingLaw::new(cubic);
/// assert!((law.frequency_factor() - 0.847213084793979).abs() <= 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// The period is the beta function B(1/(p + 1), 1/2), DLMF 5.12.1.
#[derive(Clone, Debug, PartialEq)]
pub struct ScalingLaw {
    force: PurePower,
    p: f64,
    factor: f64,
    uncertainty: f64,
}

/// The coefficient of cos kΩt over the amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicRatio {
    /// k.
    pub k: usize,
    /// aₖ/A.
    pub ratio: f64,
    /// Bound on the error of the ratio.
    pub uncertainty: f64,
}

impl ScalingLaw {
    /// The law of a force.
    #[must_use]
    pub fn new(force: PurePower) -> Self {
        let p = force.exponent().to_f64();
        let [above, below] = gamma_arguments(force.exponent()).map(|argument| argument.to_f64());
        let factor = libm::sqrt(PI * (p + 1.0) / 2.0) * libm::tgamma(above) / libm::tgamma(below);
        let (swing, missed) = quarter(p, 1.0);
        let by_quadrature = FRAC_PI_2 / (swing * libm::sqrt((p + 1.0) / 2.0));
        let uncertainty = (factor - by_quadrature).abs() + factor * (missed / swing + 4.0 * f64::EPSILON);
        Self { force, p, factor, uncertainty }
    }

    /// The force.
    #[must_use]
    pub fn force(&self) -> &PurePower {
        &self.force
    }

    /// C of Ω = C·√k·A^((p − 1)/2).
    ///
    /// # Accuracy
    /// As [`frequency_factor_uncertainty`](Self::frequency_factor_uncertainty) says.
    #[must_use]
    pub fn frequency_factor(&self) -> f64 {
        self.factor
    }

    /// Error bound of the factor: the difference between the Γ functions and the energy integral, the error of the latter, and roundings.
    #[must_use]
    pub fn frequency_factor_uncertainty(&self) -> f64 {
        self.uncertainty
    }

    /// 2π/C of T = 2π/C·A^((1 − p)/2)/√k.
    #[must_use]
    pub fn period_factor(&self) -> f64 {
        TAU / self.factor
    }

    /// Error bound of the period factor.
    #[must_use]
    pub fn period_factor_uncertainty(&self) -> f64 {
        self.period_factor() * (self.uncertainty / self.factor + f64::EPSILON)
    }

    /// (p − 1)/2, the power of the amplitude in the frequency.
    #[must_use]
    pub fn amplitude_exponent(&self) -> Rational {
        let less = Rationals.subtract(self.force.exponent(), &Rational::from(1));
        Rationals.over_integer(&less, 2).unwrap_or(less)
    }

    /// (p + 1)/2, the factor of π under the root of C.
    #[must_use]
    pub fn radicand(&self) -> Rational {
        let more = Rationals.add(self.force.exponent(), &Rational::from(1));
        Rationals.over_integer(&more, 2).unwrap_or(more)
    }

    /// The arguments of the Γ functions in C, above and below the line.
    #[must_use]
    pub fn gamma_arguments(&self) -> [Rational; 2] {
        gamma_arguments(self.force.exponent())
    }

    /// The frequency at an amplitude; `None` where k is not a number.
    #[must_use]
    pub fn frequency_at(&self, amplitude: f64) -> Option<f64> {
        let power = libm::pow(amplitude, self.amplitude_exponent().to_f64());
        Some(self.factor * libm::sqrt(self.force.strength_value()?) * power)
    }

    /// The odd harmonics from the first on.
    ///
    /// aₖ = (4/kπ)·∫ sin kθ dx from 0 to 1, where the phase θ is counted from the turning point x = 1.
    #[must_use]
    pub fn harmonics(&self, number: usize) -> Vec<HarmonicRatio> {
        (0..number).map(|n| self.harmonic(2 * n + 1)).collect()
    }

    fn harmonic(&self, k: usize) -> HarmonicRatio {
        let (swing, missed) = quarter(self.p, 1.0);
        let phase = |y: f64| FRAC_PI_2 * quarter(self.p, y).0 / swing;
        let integral = double_exponential(|y| 2.0 * y * libm::sin(count(k) * phase(y)));
        let factor = 4.0 / (count(k) * PI);
        // A phase that is off by δ moves sin kθ by kδ.
        let of_phase = count(k) * FRAC_PI_2 * 2.0 * (missed / swing + 4.0 * f64::EPSILON);
        let uncertainty = factor * (integral.error + of_phase);
        HarmonicRatio { k, ratio: factor * integral.value, uncertainty }
    }
}

/// (p + 3)/(2(p + 1)) and 1/(p + 1).
fn gamma_arguments(exponent: &Rational) -> [Rational; 2] {
    let plus = |number: i64| Rationals.add(exponent, &Rational::from(number));
    let over = |above: Rational, below: &Rational| above.checked_div(below).unwrap_or(above);
    let twice = Rationals.times_integer(&plus(1), 2);
    [over(plus(3), &twice), over(Rational::from(1), &plus(1))]
}

/// The time from x = 1 to 1 − y² with the speed √(1 − xᵖ⁺¹), and the error of its integral.
fn quarter(p: f64, y: f64) -> (f64, f64) {
    let speed = |y: f64| libm::sqrt(-libm::expm1((p + 1.0) * libm::log1p(-y * y)));
    let integral = double_exponential(|part| {
        let y = y * part;
        2.0 * y / speed(y)
    });
    (y * integral.value, y * integral.error)
}
