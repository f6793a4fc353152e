//! The choice of instruction set at run time, and the only unsafe code of this crate.
//!
//! The kernels use the fused multiply-add throughout. It is one correctly rounded operation everywhere, so the results do not depend on the
//! choice of instruction set; but without a hardware instruction it is a slow library call.
//!
//! # Method
//! A kernel is compiled a second time for AVX2 with FMA, and kernels over slices or in eight lanes a third time for AVX-512; the widest version
//! that the processor can run is called. These calls, and the hint to fetch memory ahead of a batch, are the only unsafe blocks. Kernels call
//! none of the platform's elementary functions: clippy rejects std's `sin`, `exp`, `powf` and the like. The instruction set therefore changes
//! the speed and not the result. Tests that batches equal their scalar functions compare the versions with each other.

/// A computation that can be compiled once per instruction set. `run` must be `#[inline(always)]`, and so must every function that it calls.
pub trait Kernel {
    /// The result of the computation.
    type Output;
    /// Does the computation.
    fn run(self) -> Self::Output;
}

/// Runs the kernel with AVX2 and FMA where the processor has them.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if has_avx2() {
        // SAFETY: the processor has both features that `run_wide` is compiled for.
        #[expect(unsafe_code, reason = "calling a function compiled for more features than the caller")]
        return unsafe { run_wide(kernel) };
    }
    kernel.run()
}

/// Runs a kernel over slices, with AVX-512 too, which is useful for slices but not for one element.
#[inline]
pub fn dispatch_slices<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if has_avx2() && has_avx512() {
        // SAFETY: the processor has all features that `run_widest` is compiled for.
        #[expect(unsafe_code, reason = "calling a function compiled for more features than the caller")]
        return unsafe { run_widest(kernel) };
    }
    dispatch(kernel)
}

/// Runs a kernel in `N` lanes; eight lanes fill a register of AVX-512.
#[inline]
pub fn dispatch_lanes<const N: usize, K: Kernel>(kernel: K) -> K::Output {
    if N.is_multiple_of(8) { dispatch_slices(kernel) } else { dispatch(kernel) }
}

#[cfg(target_arch = "x86_64")]
fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

/// The parts of AVX-512 that every processor with vectors of 512 bits for doubles has had since 2017.
#[cfg(target_arch = "x86_64")]
fn has_avx512() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx512bw")
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_wide<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,avx512f,avx512dq,avx512vl,avx512bw")]
fn run_widest<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

/// Number of elements to fetch ahead: two pages of memory, beyond which the processor does not prefetch by itself. With 512, 1024, 2048 and 4096
/// elements, a million periods out of memory took 0.88 to 0.93 of the time without prefetching, prepared states 0.85 to 0.91.
#[cfg(target_arch = "x86_64")]
const AHEAD: usize = 1024;

/// Prefetches the memory that a batch needs soon, given its current block. A slice that ends earlier does no harm.
#[inline(always)]
pub fn fetch_ahead(block: &[f64]) {
    #[cfg(not(target_arch = "x86_64"))]
    let _ = block;
    #[cfg(target_arch = "x86_64")]
    for line in block.chunks(LINE) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let address = line.as_ptr().wrapping_add(AHEAD);
        // SAFETY: a hint, which is allowed for every address and reads nothing.
        #[expect(unsafe_code, reason = "a hint to the processor")]
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(address.cast());
        }
    }
}

/// Elements in a line of the cache.
#[cfg(target_arch = "x86_64")]
const LINE: usize = 8;
