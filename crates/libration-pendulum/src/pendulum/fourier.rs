//! The harmonics of a motion from its nome.
//!
//! Libration: θ = Σ aₙ cos nΩτ over odd n, τ counted from the positive turning point, with
//! aₙ = ±4/(n cosh(nπK′/2K)); rotation: θ = ±(Ωτ + Σ bₙ sin nΩτ), τ counted from the bottom, with
//! bₙ = 2/(n cosh(nπK′/K)) (from DLMF 22.11.1 and 22.16.9).

use super::{Libration, Motion, Rotation};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::count;
use libration_kernels::elementary::two_word;
use libration_kernels::elliptic::Modulus;

/// The Fourier series of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct FourierSeries {
    /// The fundamental angular frequency Ω in rad/s; zero where there is no period.
    pub fundamental: f64,
    /// The mean velocity in rad/s: ±Ω in rotation, else zero.
    pub mean_velocity: f64,
    /// The time in seconds at which τ = 0: a passage of a positive turning point in libration, of the bottom in rotation. The other such
    /// passages are whole periods away. The angle counts from the bottom of the turn in which the motion starts.
    pub epoch: f64,
    /// The harmonics in increasing order.
    pub terms: Vec<FourierTerm>,
}

/// One harmonic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourierTerm {
    /// The multiple of the fundamental frequency.
    pub n: usize,
    /// The coefficient of the angle in rad: of cos nΩτ in libration, of sin nΩτ in rotation.
    pub angle: f64,
    /// The coefficient of the velocity in rad/s: of −sin nΩτ in libration, of cos nΩτ in rotation.
    pub velocity: f64,
}

impl Motion {
    /// The harmonics whose angle coefficient is at least `tolerance` radians, at most `limit` of them; none at rest and on the separatrix.
    ///
    /// # Accuracy
    /// Coefficients of the angle to 0.56 ulp down to 2.3e-308 rad (ledger in `tests/suite/promises.rs`).
    #[must_use]
    pub fn harmonics(&self, tolerance: f64, limit: usize) -> FourierSeries {
        match self {
            Self::Libration(libration) => of_libration(libration, tolerance, limit),
            Self::Rotation(rotation) => of_rotation(rotation, tolerance, limit),
            Self::Rest(_) | Self::Separatrix(_) => {
                FourierSeries { fundamental: 0.0, mean_velocity: 0.0, epoch: 0.0, terms: Vec::new() }
            }
        }
    }
}

fn of_libration(libration: &Libration, tolerance: f64, limit: usize) -> FourierSeries {
    let clock = libration.clock();
    let fundamental = DoubleDouble::PI.scaled(2.0) * clock.frequency;
    let step = quarter_ratio(&libration.modulus());
    let sign = |n: usize| if n % 4 == 1 { 1.0 } else { -1.0 };
    let terms = terms((1..).step_by(2), limit, tolerance, fundamental, |n, times| {
        hyperbolic_secant(step * times).scaled(4.0 * sign(n)) / times
    });
    let epoch = (DoubleDouble::from(0.25) - clock.start()) / clock.frequency;
    FourierSeries { fundamental: fundamental.to_f64(), mean_velocity: 0.0, epoch: epoch.to_f64(), terms }
}

fn of_rotation(rotation: &Rotation, tolerance: f64, limit: usize) -> FourierSeries {
    let clock = rotation.clock();
    // The pendulum makes two turns in 4K.
    let fundamental = DoubleDouble::PI.scaled(4.0) * clock.frequency;
    let step = quarter_ratio(&rotation.modulus()).scaled(2.0);
    let direction = rotation.direction();
    let terms = terms(1.., limit, tolerance, fundamental, |_, times| {
        hyperbolic_secant(step * times).scaled(2.0 * direction) / times
    });
    FourierSeries {
        fundamental: fundamental.to_f64(),
        mean_velocity: direction * fundamental.to_f64(),
        epoch: -(clock.start() / clock.frequency).to_f64(),
        terms,
    }
}

/// The terms of the given orders, which decrease, until one falls below the tolerance.
fn terms(
    orders: impl Iterator<Item = usize>,
    limit: usize,
    tolerance: f64,
    fundamental: DoubleDouble,
    coefficient: impl Fn(usize, f64) -> DoubleDouble,
) -> Vec<FourierTerm> {
    orders
        .take(limit)
        .map(|n| {
            let times = count(n);
            let angle = coefficient(n, times);
            FourierTerm { n, angle: angle.to_f64(), velocity: (angle * fundamental * times).to_f64() }
        })
        .take_while(|term| term.angle.abs() >= tolerance && term.angle != 0.0)
        .collect()
}

/// πK′/2K.
fn quarter_ratio(modulus: &Modulus) -> DoubleDouble {
    DoubleDouble::FRAC_PI_2 * modulus.complementary_first_words() / modulus.first_words()
}

/// 1/cosh x for x ≥ 0.
fn hyperbolic_secant(x: DoubleDouble) -> DoubleDouble {
    let power = if x.hi < 745.2 { two_word::exp(-x) } else { DoubleDouble::ZERO };
    power.scaled(2.0) / (DoubleDouble::ONE + power.square())
}
