//! Velocities that friction keeps at zero.
//!
//! If the motion can leave zero velocity to neither side, the sign in the friction takes the value between −1 and 1 at which the acceleration
//! vanishes: A. F. Filippov, *Differential Equations with Discontinuous Righthand Sides*, Kluwer 1988, doi:10.1007/978-94-015-7793-9. The
//! acceleration is linear in the sign, and each of its coefficients is linear in the last coefficient of the sign.
//!
//! # Method
//! The sign and the series that keep the acceleration at zero are used until the sign reaches ±1.

use crate::taylor::program::expander::{Expander, Surroundings};
use crate::taylor::step::block::{Block, Row};
use libration_numbers::internals::algebra::lanes;

/// A sign to be computed, in some lanes.
struct Unknown<const N: usize> {
    sign: Row,
    velocity: Row,
    acceleration: Row,
    sticks: [bool; N],
    /// The acceleration with the sign one, minus that with the sign zero.
    gain: [f64; N],
}

impl Expander<'_> {
    /// Computes the series of velocities that stay zero, and of the signs that keep them there.
    pub(in crate::taylor) fn expand_sticking<const N: usize>(
        &self,
        block: &mut Block<N>,
        surroundings: &Surroundings<N>,
    ) {
        let mut surroundings = surroundings.clone();
        let unknown = self.unknown_signs(block, &mut surroundings);
        self.begin_by_call(block, &surroundings);
        for n in 1..=self.plan.order {
            self.extend_state(block, n);
            for one in &unknown {
                block[one.velocity][n] = one.chosen(&[0.0; N], &block[one.velocity][n]);
                block[one.sign][n] = [0.0; N];
            }
            if n <= self.last() {
                self.extend_by_call(block, n);
                for one in &unknown {
                    block[one.sign][n] = one.chosen(&one.balance(&block[one.acceleration][n]), &[0.0; N]);
                    self.extend_by_call(block, n);
                }
            }
        }
    }

    // The interpreter is inlined into the kernels that need it. If it were inlined here too, one function
    // would contain it five times, in sixteen lanes: 273 KiB of machine code without a gain in speed.

    #[inline(never)]
    fn extend_by_call<const N: usize>(&self, block: &mut Block<N>, n: usize) {
        self.plan.program.extend(block, n);
    }

    #[inline(never)]
    fn begin_by_call<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        self.begin(block, surroundings);
    }

    /// The unknown signs, whose zeroth coefficients are set.
    fn unknown_signs<const N: usize>(
        &self,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
    ) -> Vec<Unknown<N>> {
        let moduli =
            (0..self.system.moduli()).filter(|&modulus| surroundings.sticks[modulus].contains(&true));
        let moduli: Vec<usize> = moduli.collect();
        let mut unknown = vec![];
        for modulus in moduli {
            let Some(number) = self.system.driven_in_modulus(modulus) else { continue };
            let Some(coordinate) = self.system.layout().driving(number) else { continue };
            let acceleration = self.acceleration(coordinate);
            let (sticks, given) = (surroundings.sticks[modulus], surroundings.signs[modulus]);
            let mut with = |sign: f64| {
                surroundings.signs[modulus] = lanes(|lane| if sticks[lane] { sign } else { given[lane] });
                self.begin_by_call(block, surroundings);
                block[acceleration][0]
            };
            let (none, one) = (with(0.0), with(1.0));
            let gain = lanes(|lane| one[lane] - none[lane]);
            let (sign, velocity) = (self.sign(block, modulus), block.row(number));
            let this = Unknown { sign, velocity, acceleration, sticks, gain };
            surroundings.signs[modulus] = this.chosen(&this.balance(&none), &given);
            unknown.push(this);
        }
        unknown
    }
}

impl<const N: usize> Unknown<N> {
    /// The sign at which the acceleration vanishes.
    fn balance(&self, acceleration: &[f64; N]) -> [f64; N] {
        lanes(|lane| -acceleration[lane] / self.gain[lane])
    }

    fn chosen(&self, where_it_sticks: &[f64; N], elsewhere: &[f64; N]) -> [f64; N] {
        lanes(|lane| if self.sticks[lane] { where_it_sticks[lane] } else { elsewhere[lane] })
    }
}
