//! The fused multiply-add, defined in one module so that a target can supply its own.
//!
//! WebAssembly has no such instruction, and the function that compilers supply works on integers and takes about a hundred times as long. A
//! module compiled with `-C target-feature=+simd128,+relaxed-simd` uses the relaxed instruction for sums of products, which rounds once or
//! twice, depending on the processor.
//!
//! # Method
//! Both instructions give the same bits where [`rounds_once`] returns `true`; elsewhere a host uses the module without relaxed instructions, in
//! which a million periods take about a second. `scripts/wasm32` compares 30 000 results (periods, states, elliptic functions, harmonics, an
//! expansion, an integration, a picture) with those of wasm32; with `--pair` it builds and compares both modules.

/// Sums of a product with one rounding.
pub trait FusedMultiplyAdd {
    /// `self·factor + addend`, rounded once.
    fn fma(self, factor: Self, addend: Self) -> Self;
}

impl FusedMultiplyAdd for f64 {
    #[cfg(not(all(target_arch = "wasm32", target_feature = "relaxed-simd")))]
    #[inline(always)]
    fn fma(self, factor: Self, addend: Self) -> Self {
        self.mul_add(factor, addend)
    }

    #[cfg(all(target_arch = "wasm32", target_feature = "relaxed-simd"))]
    #[inline(always)]
    fn fma(self, factor: Self, addend: Self) -> Self {
        use std::arch::wasm32::{f64x2_extract_lane, f64x2_relaxed_madd, f64x2_splat};
        f64x2_extract_lane::<0>(f64x2_relaxed_madd(
            f64x2_splat(self),
            f64x2_splat(factor),
            f64x2_splat(addend),
        ))
    }
}

/// Returns `true` if sums of products are rounded once here, as every stated accuracy assumes.
///
/// Only a WebAssembly module compiled for relaxed vector instructions may return `false`, on a processor without a fused multiply-add: the host
/// then loads a module that was compiled without them.
#[must_use]
pub fn rounds_once() -> bool {
    let x = std::hint::black_box(1.0 + libm::ldexp(1.0, -30));
    // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰, whose last term is lost if there are two roundings.
    x.fma(x, -1.0 - libm::ldexp(1.0, -29)) > 0.0
}
