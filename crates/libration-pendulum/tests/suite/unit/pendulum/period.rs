//! The error budget: the error of T/T0 in two words, before its one rounding.

use libration::algebra::BigFloat;
use libration::internals::pendulum::{
    Nearer, PeriodFunction, RatioNearTop, excess_below, log_inverse_nome, nearer_of_amplitude, ratio_above,
};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum};

const BITS: usize = 250;

fn exactly(x: DoubleDouble) -> BigFloat {
    word(x.hi) + word(x.lo)
}

fn word(x: f64) -> BigFloat {
    BigFloat::from_f64(x, BITS).unwrap()
}

/// T/T0 = 1/agm(1, cos(θ0/2)), given that cosine.
fn ratio(cosine: &BigFloat) -> BigFloat {
    let one = word(1.0);
    one.clone() / one.agm(cosine)
}

/// The distance of two words from the true value, in units in the last place of a result in [1, 2), [2, 4), ….
fn error(words: DoubleDouble, truth: &BigFloat) -> f64 {
    let unit = libm::ldexp(f64::EPSILON, libm::ilogb(truth.to_f64()));
    (exactly(words) - truth.clone()).to_f64().abs() / unit
}

/// Evenly spaced numbers, including the ends.
fn places(from: f64, to: f64) -> impl Iterator<Item = f64> {
    const PIECES: u32 = 500;
    (0..=PIECES).map(move |k| from + (to - from) * f64::from(k) / f64::from(PIECES))
}

#[test]
fn before_the_last_rounding_the_ratio_errs_by_six_hundredths_of_a_unit() {
    let half_pi = std::f64::consts::FRAC_PI_2;
    for amplitude in places(1e-3, half_pi) {
        let excess = excess_below(nearer_of_amplitude(amplitude).u);
        let sum = fast_two_sum(1.0, excess.hi);
        let words = DoubleDouble::new(sum.hi, sum.lo + excess.lo);
        let off = error(words, &ratio(&(word(amplitude) * word(0.5)).cos()));
        assert!(off < 0.06, "{amplitude}: {off}");
    }
    let above = |nearer: Nearer| ratio_above(excess_below(nearer.u), log_inverse_nome(nearer.s, nearer.u));
    for amplitude in places(half_pi.next_up(), std::f64::consts::PI) {
        let half = (BigFloat::pi(BITS) - word(amplitude)) * word(0.5);
        let off = error(above(nearer_of_amplitude(amplitude)), &ratio(&half.sin()));
        assert!(off < 0.06, "{amplitude}: {off}");
    }
    for complement in places(-690.0, 0.45).map(libm::exp) {
        let off =
            error(above(RatioNearTop::nearer(complement)), &ratio(&(word(complement) * word(0.5)).sin()));
        assert!(off < 0.06, "{complement:e}: {off}");
    }
}
