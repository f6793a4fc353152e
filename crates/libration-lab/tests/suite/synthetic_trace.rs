//! Traces of damped pendulums with known truth, with the errors of instruments.

use libration::taylor::{Effort, Moment, System, integrate};
use libration_lab::measurement::{Observable, Trace};

use crate::random::Random;
use libration::progress::Quiet;

/// A pendulum that is released, and the instrument.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Synthetic {
    pub(crate) omega0: f64,
    pub(crate) dry: f64,
    pub(crate) linear: f64,
    pub(crate) quadratic: f64,
    pub(crate) amplitude: f64,
    /// Velocity at the release.
    pub(crate) velocity: f64,
    pub(crate) observable: Observable,
    pub(crate) offset: f64,
    pub(crate) step: f64,
    pub(crate) rows: u32,
    /// The standard deviation of normal noise.
    pub(crate) noise: f64,
    /// Step of the scale, of which values are multiples; zero for none.
    pub(crate) quantum: f64,
}

impl Synthetic {
    /// ω0 = 3 rad/s, 60°, a little linear damping, 50 Hz for 40 s.
    pub(crate) const USUAL: Self = Self {
        omega0: 3.0,
        dry: 0.0,
        linear: 0.02,
        quadratic: 0.0,
        amplitude: 1.0472,
        velocity: 0.0,
        observable: Observable::Angle,
        offset: 0.0,
        step: 0.02,
        rows: 2000,
        noise: 0.0,
        quantum: 0.0,
    };

    /// 2π/ω0.
    pub(crate) fn t0(&self) -> f64 {
        std::f64::consts::TAU / self.omega0
    }

    pub(crate) fn trace(&self, random: &mut Random) -> Trace {
        let Self { omega0, dry, linear, quadratic, .. } = *self;
        let equation = format!(
            "theta'' = -{:e}*sin(theta) - {linear:e}*theta' - {quadratic:e}*theta'*abs(theta') - {dry:e}*sign(theta')",
            omega0 * omega0
        );
        let system = System::new(&equation.parse().unwrap()).unwrap();
        // A first row a little after the release, at no special phase.
        let times: Vec<f64> = (0..self.rows).map(|row| 0.0137 + self.step * f64::from(row)).collect();
        let start = Moment { time: 0.0, state: vec![self.amplitude, self.velocity] };
        let effort = Effort::to_tolerance(1e-12);
        let solution = integrate(&system, &start, &times, &effort, &Quiet).unwrap();
        let component = usize::from(self.observable == Observable::AngularVelocity);
        let observable = |state: &[f64]| {
            let value = state[component] + self.offset + self.noise * normal(random);
            if self.quantum > 0.0 { self.quantum * libm::round(value / self.quantum) } else { value }
        };
        let values = solution.samples.iter().map(|sample| sample.state.as_slice()).map(observable).collect();
        Trace::new("synthetic", self.observable, times, values, None).unwrap()
    }
}

/// A normal number of variance one, by Box and Muller.
pub(crate) fn normal(random: &mut Random) -> f64 {
    let (radius, angle) = (1.0 - random.between(0.0, 1.0), random.between(0.0, 1.0));
    (-2.0 * libm::log(radius)).sqrt() * libm::cos(std::f64::consts::TAU * angle)
}
