//! The separatrix: tan(θ/2) = sinh x and θ′ = 2ω0 sech x, with x = ω0t + x0.

use super::start::Start;
use super::state::{DoubledArctangent, State, unwrapped};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum, two_prod};
use libration_kernels::elementary::{sinh_cosh, two_word};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_kernels::internals::elliptic::first_of_point;

/// A motion on the separatrix, prepared for evaluation at any time.
#[derive(Clone, Copy, Debug)]
pub struct Separatrix {
    angular_frequency: DoubleDouble,
    offset: DoubleDouble,
    direction: f64,
    turns: i64,
    base: DoubleDouble,
}

/// The |x| beyond which the hyperbolic functions are e^|x|/2.
const FAR: f64 = 600.0;

/// The |x| beyond which even 1e290·e^−|x| is below the range of numbers.
const AT_THE_TOP: f64 = 1480.0;

/// |θ|, its complement, and sech x as the product of two factors, each of which underflows later than sech x.
struct Point {
    half: DoubledArctangent,
    sech: [DoubleDouble; 2],
}

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

    /// 2ω0².
    pub(super) fn specific_energy(&self) -> f64 {
        2.0 * self.angular_frequency.square_to_f64()
    }

    /// 4ω0/π.
    pub(super) fn action(&self) -> f64 {
        (self.angular_frequency.scaled(4.0) / DoubleDouble::PI).to_f64()
    }

    pub(super) fn state_at(&self, time: f64) -> State {
        let x = self.argument(time);
        let sign = if x.hi < 0.0 { -self.direction } else { self.direction };
        let Point { half, sech } = if x.hi.abs() < FAR { near(x.abs()) } else { far(x.abs()) };
        State {
            turns: self.turns,
            angle_in_turn: sign * half.angle.to_f64(),
            complement: half.complement.to_f64(),
            angle: unwrapped(self.base, sign, half.angle),
            velocity: (self.angular_frequency * sech[0] * sech[1]).to_f64() * (2.0 * self.direction),
        }
    }

    /// x; infinite where ω0t is beyond the range of numbers.
    fn argument(&self, time: f64) -> DoubleDouble {
        let product = two_prod(time, self.angular_frequency.hi);
        if product.hi.is_infinite() {
            return DoubleDouble::from(product.hi);
        }
        let product_lo = time.fma(self.angular_frequency.lo, product.lo);
        fast_two_sum(product.hi, product_lo) + self.offset
    }
}

fn near(x: DoubleDouble) -> Point {
    let (sinh, cosh) = sinh_cosh(x);
    Point {
        half: DoubledArctangent::from_quotient(sinh, DoubleDouble::ONE),
        sech: [cosh.recip(), DoubleDouble::ONE],
    }
}

fn far(x: DoubleDouble) -> Point {
    let root = if x.hi < AT_THE_TOP { two_word::exp(-x.scaled(0.5)) } else { DoubleDouble::ZERO };
    let complement = root.square().scaled(4.0);
    let half = DoubledArctangent { angle: DoubleDouble::PI - complement, complement };
    Point { half, sech: [root.scaled(2.0), root] }
}
