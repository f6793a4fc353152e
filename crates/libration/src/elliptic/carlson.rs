//! Carlson's symmetric integrals `R_F` and `R_D` in two words, by duplication (DLMF 19.26.18, 19.36.1, 19.36.2).
//!
//! The arguments are given by their square roots, so that a complement of 1e-300 keeps its digits where its
//! square would underflow.

use crate::double_double::DoubleDouble;

/// Where the seventh-order series ends the duplication: its error is below the eighth power of this.
const CLOSE: f64 = 6e-5;

/// Each step divides the distances by four, after some ten that bring arguments of any size together; more
/// steps than this mean that an argument was not a number.
const MOST_STEPS: usize = 100;

/// One step of the duplication: the roots of the arguments become the roots of (argument + λ)/4.
struct Duplication {
    roots: [DoubleDouble; 3],
    arguments: [DoubleDouble; 3],
}

impl Duplication {
    fn new(roots: [DoubleDouble; 3]) -> Self {
        Self { roots, arguments: roots.map(DoubleDouble::square) }
    }

    fn lambda(&self) -> DoubleDouble {
        let [x, y, z] = self.roots;
        x * y + y * z + z * x
    }

    fn step(&mut self) {
        let lambda = self.lambda();
        self.arguments = self.arguments.map(|argument| (argument + lambda).scaled(0.25));
        self.roots = self.arguments.map(DoubleDouble::sqrt);
    }

    /// The relative distances 1 − argument/mean for the weights of the mean, and the mean.
    fn deviations(&self, weights: [f64; 3]) -> ([DoubleDouble; 3], DoubleDouble) {
        let [x, y, z] = self.arguments;
        let total: f64 = weights.iter().sum();
        let mean = (x * weights[0] + y * weights[1] + z * weights[2]) / total;
        (self.arguments.map(|argument| (mean - argument) / mean), mean)
    }

    fn close(deviations: &[DoubleDouble; 3]) -> bool {
        deviations.iter().all(|d| d.hi.abs() < CLOSE)
    }
}

/// `R_F(x², y², z²)`, at most one of the roots zero.
pub(crate) fn first_kind(x: DoubleDouble, y: DoubleDouble, z: DoubleDouble) -> DoubleDouble {
    let mut duplication = Duplication::new([x, y, z]);
    for _ in 0..MOST_STEPS {
        let (deviations, mean) = duplication.deviations([1.0; 3]);
        if Duplication::close(&deviations) {
            return first_kind_series(deviations) / mean.sqrt();
        }
        duplication.step();
    }
    DoubleDouble::from(f64::NAN)
}

/// DLMF 19.36.1.
fn first_kind_series([x, y, z]: [DoubleDouble; 3]) -> DoubleDouble {
    let e2 = x * y - z.square();
    let e3 = x * y * z;
    let e2e2 = e2.square();
    DoubleDouble::ONE - e2 / 10.0 + e3 / 14.0 + e2e2 / 24.0 - e2 * e3 * 3.0 / 44.0 - e2e2 * e2 * 5.0 / 208.0
        + e3.square() * 3.0 / 104.0
        + e2e2 * e3 / 16.0
}

/// `R_D(x², y², z²)`, at most one of x, y zero, z not.
pub(crate) fn second_kind(x: DoubleDouble, y: DoubleDouble, z: DoubleDouble) -> DoubleDouble {
    let mut duplication = Duplication::new([x, y, z]);
    let mut sum = DoubleDouble::ZERO;
    let mut power = 1.0;
    for _ in 0..MOST_STEPS {
        let (deviations, mean) = duplication.deviations([1.0, 1.0, 3.0]);
        if Duplication::close(&deviations) {
            return sum * 3.0 + second_kind_series(deviations) * power / (mean * mean.sqrt());
        }
        let root = duplication.roots[2];
        sum = sum + DoubleDouble::from(power) / (root * (duplication.arguments[2] + duplication.lambda()));
        power *= 0.25;
        duplication.step();
    }
    DoubleDouble::from(f64::NAN)
}

/// DLMF 19.36.2.
fn second_kind_series([x, y, z]: [DoubleDouble; 3]) -> DoubleDouble {
    let xy = x * y;
    let zz = z.square();
    let e2 = xy - zz * 6.0;
    let e3 = (xy * 3.0 - zz * 8.0) * z;
    let e4 = (xy - zz) * zz * 3.0;
    let e5 = xy * zz * z;
    let low = DoubleDouble::ONE - e2 * 3.0 / 14.0 + e3 / 6.0 + e2.square() * 9.0 / 88.0 - e4 * 3.0 / 22.0;
    let middle = e5 * 3.0 / 26.0 - e2 * e3 * 9.0 / 52.0 - e2.square() * e2 / 16.0 + e3.square() * 3.0 / 40.0;
    let high = e2 * e4 * 3.0 / 20.0 + e2.square() * e3 * 45.0 / 272.0 - (e3 * e4 + e2 * e5) * 9.0 / 68.0;
    low + middle + high
}
