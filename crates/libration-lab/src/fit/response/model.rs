//! The oscillators whose responses are fitted: x″ = −c·x′ − restoring force + A cos Ωt.

use std::fmt;

use libration::expression::Equation;

/// An oscillator with weak damping under a periodic force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResponseModel {
    /// x″ = −c·x′ − ω0²·x + A cos Ωt.
    Linear,
    /// θ″ = −c·θ′ − ω0²·sin θ + A cos Ωt.
    Pendulum,
    /// x″ = −c·x′ − ω0²·x − κ·x³ + A cos Ωt.
    Duffing,
}

impl ResponseModel {
    /// All models, simpler ones first.
    pub const ALL: [Self; 3] = [Self::Linear, Self::Pendulum, Self::Duffing];

    /// `linear`, `pendulum`, `duffing`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Pendulum => "pendulum",
            Self::Duffing => "duffing",
        }
    }

    /// The number of free parameters of the oscillator: ω0², c and perhaps κ; the drive is one more.
    pub(super) fn coefficients(self) -> usize {
        if self == Self::Duffing { 3 } else { 2 }
    }

    /// Upper bound of the amplitudes that it can have.
    pub(super) fn amplitude_bound(self) -> f64 {
        if self == Self::Pendulum { std::f64::consts::PI } else { f64::INFINITY }
    }

    /// The parameters of the equation of motion in the phase of the drive.
    pub(super) fn names(self) -> &'static [&'static str] {
        match self {
            Self::Duffing => &["d", "s", "r", "p", "q"],
            Self::Linear | Self::Pendulum => &["d", "s", "p", "q"],
        }
    }

    /// The equation of motion in the phase t of the drive, with d = c/Ω, s = ω0²/Ω², r = κ/Ω², a force p cos t − q sin t, and the
    /// integrals of x cos t and x sin t.
    pub(super) fn in_phase_of_drive(self) -> Equation {
        let restoring = match self {
            Self::Linear => "s*x",
            Self::Pendulum => "s*sin(x)",
            Self::Duffing => "s*x - r*x^3",
        };
        let text = format!("x'' = -d*x' - {restoring} + p*cos(t) - q*sin(t); u' = x*cos(t); w' = x*sin(t)");
        text.parse().expect("this can be read")
    }

    /// The equation of motion with these numbers and the drive frequency `w` as a parameter: ω0², c and perhaps κ, then A.
    pub(super) fn with_frequency_open(self, parameters: &[f64]) -> Equation {
        let (square, damping, drive) = (parameters[0], parameters[1], parameters[parameters.len() - 1]);
        let restoring = match self {
            Self::Linear => format!("({square:?})*x"),
            Self::Pendulum => format!("({square:?})*sin(x)"),
            Self::Duffing => format!("({square:?})*x - ({:?})*x^3", parameters[2]),
        };
        let text = format!("x'' = -({damping:?})*x' - {restoring} + ({drive:?})*cos(w*t)");
        text.parse().expect("this can be read")
    }
}

/// The name, as options and tables have it.
impl fmt::Display for ResponseModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
