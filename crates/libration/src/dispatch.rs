//! The choice of instruction set at run time, and the only unsafe code of the library.
//!
//! The kernels use the fused multiply-add throughout. It is one correctly rounded operation everywhere, so
//! the results do not depend on the choice made here; but without the instruction it is a slow library call.

/// A computation that can be compiled once per instruction set. `run` must be `#[inline(always)]`, as must
/// all that it calls.
pub(crate) trait Kernel {
    /// What the computation returns.
    type Output;
    /// Does the computation.
    fn run(self) -> Self::Output;
}

/// Runs the kernel with AVX2 and FMA where the processor has them.
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("fma")
    {
        // SAFETY: the processor has the features that `run_widest` is compiled for.
        #[expect(unsafe_code, reason = "calling a function compiled for more features than the caller")]
        return unsafe { run_widest(kernel) };
    }
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the processor has both features that `run_wide` is compiled for.
        #[expect(unsafe_code, reason = "calling a function compiled for more features than the caller")]
        return unsafe { run_wide(kernel) };
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_wide<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
fn run_widest<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}
