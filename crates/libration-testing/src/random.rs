//! Seeded random inputs: splitmix64 (Steele, Lea and Flood, OOPSLA 2014, doi:10.1145/2660193.2660195).

use core::f64::consts::LN_10;

/// A generator of pseudorandom numbers.
#[derive(Debug)]
pub struct Random(u64);

impl Random {
    /// A generator with this seed.
    pub fn seeded(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let unit = (self.bits() >> 11) as f64 * (f64::EPSILON / 2.0);
        low + (high - low) * unit
    }

    /// A whole number below n.
    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// 10^x with uniform x.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        libm::exp(LN_10 * self.between(low, high))
    }

    /// A normally distributed number with mean 0 and variance 1 (G. E. P. Box and M. E. Muller, doi:10.1214/aoms/1177706645).
    pub fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.between(0.0, 1.0)));
        radius * libm::cos(self.between(0.0, core::f64::consts::TAU))
    }
}
