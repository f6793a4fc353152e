//! The symbols of the pendulum.

use super::formula::{Formula, Name, apply, cos, letter, sin};

/// The name of θ0.
pub(super) fn amplitude() -> Name {
    Name::new("θ").index(0)
}

/// θ0 as a formula.
pub fn theta_0() -> Formula {
    amplitude().into()
}

pub(super) fn omega_0() -> Formula {
    Name::new("ω").index(0).into()
}

/// T0.
pub(super) fn small_swing_period() -> Formula {
    Name::new("T").index(0).into()
}

pub(super) fn period() -> Formula {
    letter("T")
}

/// T/T0.
pub(super) fn period_ratio() -> Formula {
    period() / small_swing_period()
}

/// sin(θ0/2).
pub(super) fn sin_half_amplitude() -> Formula {
    sin(theta_0() / 2)
}

/// cos(θ0/2).
pub(super) fn cos_half_amplitude() -> Formula {
    cos(theta_0() / 2)
}

/// The complete elliptic integral of the first kind for the parameter m.
pub(super) fn complete_integral(parameter: Formula) -> Formula {
    apply("K", [parameter])
}
