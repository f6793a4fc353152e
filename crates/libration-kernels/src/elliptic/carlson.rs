//! Carlson's symmetric integrals `R_F` and `R_D` in two words, by duplication (DLMF 19.26.18, 19.36.1, 19.36.2).
//!
//! The arguments x ≤ y ≤ z are given by their square roots; each step brings them four times as close together.

use crate::double_double::DoubleDouble;

/// Step limit, exceeded only if an argument is NaN: each step divides the distances by four, after some ten steps that bring arguments of any
/// size together.
const MOST_STEPS: usize = 100;

/// The closeness of the arguments at which the series of seventh order ends the duplication; the error of the series is a fiftieth of the eighth
/// power of the distance.
#[derive(Clone, Copy)]
pub(crate) enum Closeness {
    /// 2⁻⁶² of the result.
    Rounding,
    /// 2⁻¹⁰⁷ of the result.
    TwoWords,
}

impl Closeness {
    #[inline(always)]
    fn distance(self) -> f64 {
        match self {
            Self::Rounding => 0.006,
            // 1e-32/50 is 2⁻¹¹². The eighth power of 0.006, 1.7e-18, with the same fiftieth is 2⁻⁶⁴.
            Self::TwoWords => 1e-4,
        }
    }
}

/// The state of the duplication.
#[derive(Clone, Copy)]
pub(super) struct Duplication {
    pub(super) roots: [DoubleDouble; 3],
    pub(super) arguments: [DoubleDouble; 3],
    /// The sum of the steps' contributions to `R_D(x, z, y)`/3.
    pub(super) sum: DoubleDouble,
    /// 4⁻ⁿ after n steps.
    pub(super) power: f64,
}

impl Duplication {
    #[inline(always)]
    pub(super) fn new(roots: [DoubleDouble; 3], arguments: [DoubleDouble; 3]) -> Self {
        Self { roots, arguments, sum: DoubleDouble::ZERO, power: 1.0 }
    }

    /// Returns `true` if the series may end the duplication; also if an argument is NaN.
    #[inline(always)]
    pub(super) fn is_close(&self, closeness: Closeness) -> bool {
        let [x, _, z] = self.arguments;
        let apart = z.hi - x.hi > closeness.distance() * z.hi;
        !apart
    }

    /// Replaces each argument by (argument + λ)/4 and its root accordingly; adds the contribution to `R_D` if `SECOND` is set.
    #[inline(always)]
    pub(super) fn step<const SECOND: bool>(&mut self) {
        let [x, y, z] = self.roots;
        let lambda = x * y + z * (x + y);
        if SECOND {
            let part = DoubleDouble::from(self.power).over(y * (self.arguments[1] + lambda));
            self.sum = self.sum + part;
        }
        self.power *= 0.25;
        self.arguments = self.arguments.map(|argument| (argument + lambda).scaled(0.25));
        self.roots = self.arguments.map(DoubleDouble::sqrt);
    }

    /// Steps until the arguments are close enough for the series.
    #[inline(always)]
    pub(super) fn run<const SECOND: bool>(&mut self, closeness: Closeness) {
        for _ in 0..MOST_STEPS {
            if self.is_close(closeness) {
                return;
            }
            self.step::<SECOND>();
        }
    }

    /// `R_F(x, y, z)`.
    #[inline(always)]
    pub(super) fn first_kind(&self) -> DoubleDouble {
        let [x, y, z] = self.arguments;
        let mean = (x + y + z) * THIRD;
        first_kind_series(deviations(self.arguments, mean)).over(mean.sqrt())
    }

    /// `R_D(x, z, y)`/3.
    #[inline(always)]
    pub(super) fn third_of_second_kind(&self) -> DoubleDouble {
        let [x, y, z] = self.arguments;
        let mean = (x + z + y * 3.0) * FIFTH;
        let end = second_kind_series(deviations([x, z, y], mean)) * THIRD * self.power;
        self.sum + end.over(mean * mean.sqrt())
    }
}

const THIRD: DoubleDouble = DoubleDouble::new(0.3333333333333333, 1.850371707708594e-17);
const FIFTH: DoubleDouble = DoubleDouble::new(0.2, -1.1102230246251566e-17);
const TENTH: DoubleDouble = DoubleDouble::new(0.1, -5.551115123125783e-18);
const FOURTEENTH: DoubleDouble = DoubleDouble::new(0.07142857142857142, 3.96508223080413e-18);

/// 1 − argument/mean.
#[inline(always)]
fn deviations(arguments: [DoubleDouble; 3], mean: DoubleDouble) -> [DoubleDouble; 3] {
    let inverse = DoubleDouble::ONE.over(mean);
    arguments.map(|argument| (mean - argument) * inverse)
}

/// DLMF 19.36.1; its later terms, of fourth order and below 1e-10, are summed in one word.
#[inline(always)]
fn first_kind_series([x, y, z]: [DoubleDouble; 3]) -> DoubleDouble {
    let e2 = x * y - z.square();
    let e3 = x * y * z;
    let low = e3 * FOURTEENTH - e2 * TENTH;
    let (e2, e3) = (e2.hi, e3.hi);
    let fourth = e2 * e2 / 24.0 - e2 * e3 * (3.0 / 44.0);
    let sixth = e3 * e3 * (3.0 / 104.0) - e2 * e2 * e2 * (5.0 / 208.0) + e2 * e2 * e3 / 16.0;
    DoubleDouble::ONE + (low + (fourth + sixth))
}

/// DLMF 19.36.2, in one word: the arguments are so close that the series is 1 within 1e-5.
#[inline(always)]
fn second_kind_series([x, y, z]: [DoubleDouble; 3]) -> DoubleDouble {
    let (x, y, z) = (x.hi, y.hi, z.hi);
    let (xy, zz) = (x * y, z * z);
    let e2 = xy - 6.0 * zz;
    let e3 = (3.0 * xy - 8.0 * zz) * z;
    let e4 = 3.0 * (xy - zz) * zz;
    let e5 = xy * zz * z;
    let low = e3 / 6.0 - e2 * (3.0 / 14.0) + e2 * e2 * (9.0 / 88.0) - e4 * (3.0 / 22.0);
    let middle = e5 * (3.0 / 26.0) - e2 * e3 * (9.0 / 52.0) - e2 * e2 * e2 / 16.0 + e3 * e3 * (3.0 / 40.0);
    let high = e2 * e4 * (3.0 / 20.0) + e2 * e2 * e3 * (45.0 / 272.0) - (e3 * e4 + e2 * e5) * (9.0 / 68.0);
    DoubleDouble::ONE + (low + middle + high)
}
