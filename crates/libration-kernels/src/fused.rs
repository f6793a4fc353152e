//! The fused multiply-add, in one place, so that a target can supply its own.
//!
//! WebAssembly has none. What compilers put there works on integers and takes some hundred times as long. Where a module is
//! compiled with `-C target-feature=+simd128,+relaxed-simd`, the relaxed instruction for sums of products is taken, which rounds once or
//! twice as the processor likes.
//!
//! # Method
//! Both ways give the same bits where [`rounds_once`] returns `true`; elsewhere a host takes the module without relaxed instructions, in which a
//! million periods take about a second. `scripts/wasm32` compares 30 000 results (periods, states, elliptic functions, harmonics, an expansion, an
//! integration, a picture) with those of wasm32; with `--pair` it builds and compares both modules.

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

/// Returns `true` if sums of products are rounded once here, as all accuracies promise.
///
/// True but for modules of WebAssembly that were compiled for relaxed vector instructions, on processors without a fused multiply-add: there
/// a host takes a module that was compiled without.
#[must_use]
pub fn rounds_once() -> bool {
    let x = std::hint::black_box(1.0 + libm::ldexp(1.0, -30));
    // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰, of which two roundings leave nothing of the last.
    x.fma(x, -1.0 - libm::ldexp(1.0, -29)) > 0.0
}
