//! The separatrix: tan(θ/2) = sinh x and θ′ = 2ω0 sech x, with x = ω0t + x0.

use super::motion::Start;
use super::state::{DoubledArctangent, State, unwrapped};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod};
use crate::elementary::sinh_cosh;
use crate::elliptic::first_of_point;

/// A motion on the separatrix, prepared for evaluation at any time.
#[derive(Clone, Copy, Debug)]
pub struct Separatrix {
    angular_frequency: DoubleDouble,
    offset: DoubleDouble,
    direction: f64,
    turns: i64,
    base: DoubleDouble,
}

/// Beyond this |x| the hyperbolic functions are taken as e^|x|/2.
const FAR: f64 = 600.0;

impl Separatrix {
    /// The motion through this state.
    pub(super) fn through(angular_frequency: DoubleDouble, start: &Start) -> Self {
        let direction = if start.velocity.hi < 0.0 { -1.0 } else { 1.0 };
        // x0 = artanh sin(θ/2), which is F at k = 1.
        let gone = first_of_point(start.sine, start.cosine, start.cosine);
        Self {
            angular_frequency,
            offset: gone.scaled(direction),
            direction,
            turns: start.angle.turns(),
            base: start.base(),
        }
    }

    /// 1 for increasing angles, −1 for decreasing.
    #[must_use]
    pub fn direction(&self) -> f64 {
        self.direction
    }

    pub(super) fn angular_frequency(&self) -> DoubleDouble {
        self.angular_frequency
    }

    /// 4ω0/π.
    pub(super) fn action(&self) -> f64 {
        (self.angular_frequency.scaled(4.0) / DoubleDouble::PI).to_f64()
    }

    pub(super) fn state_at(&self, time: f64) -> State {
        let product = two_prod(time, self.angular_frequency.hi);
        let product_lo = time.mul_add(self.angular_frequency.lo, product.lo);
        let x = fast_two_sum(product.hi, product_lo) + self.offset;
        let sign = if x.hi < 0.0 { -self.direction } else { self.direction };
        let (complement_and_angle, sech) =
            if x.hi.abs() < FAR { Self::near(x.abs()) } else { Self::far(x.hi.abs()) };
        State {
            turns: self.turns,
            angle_in_turn: sign * complement_and_angle.angle.to_f64(),
            complement: complement_and_angle.complement.to_f64(),
            angle: unwrapped(self.base, sign, complement_and_angle.angle),
            velocity: (self.angular_frequency * sech).to_f64() * (2.0 * self.direction),
        }
    }

    fn near(x: DoubleDouble) -> (DoubledArctangent, DoubleDouble) {
        let (sinh, cosh) = sinh_cosh(x);
        (DoubledArctangent::of(sinh, DoubleDouble::ONE), cosh.recip())
    }

    fn far(x: f64) -> (DoubledArctangent, DoubleDouble) {
        // 2e^−x, in two factors so that it underflows last.
        let sech = 2.0 * libm::exp(-0.5 * x) * libm::exp(-0.5 * x);
        let complement = DoubleDouble::from(2.0 * sech);
        (DoubledArctangent { angle: DoubleDouble::PI - complement, complement }, DoubleDouble::from(sech))
    }
}
