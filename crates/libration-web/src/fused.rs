//! The fused multiply-add of modules without an instruction for it: that of another module where the browser has one, else by whole numbers.
//!
//! Compilers call a function `fma`, and take this one before their own. The other module consists of the relaxed instruction alone, which
//! rounds once or twice as the processor likes; the page tries it out before it lets it stand here.
//!
//! # Method
//! The relaxed instruction is in a module of 64 bytes (`web/src/engine/fused.ts`). If the trial shows that it rounds once the large modules call
//! it, otherwise `libm::fma`, which takes some hundred times as long. The call costs a few nanoseconds, and one set of modules serves all browsers,
//! with the bits of the command.

use std::sync::atomic::{AtomicBool, Ordering};

static IS_FUSED: AtomicBool = AtomicBool::new(false);

/// Tells the module that the function given by the page rounds once.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn use_fused() {
    IS_FUSED.store(true, Ordering::Relaxed);
}

#[cfg(target_arch = "wasm32")]
mod instruction {
    use super::{IS_FUSED, Ordering};

    #[link(wasm_import_module = "fused")]
    #[expect(unsafe_code, reason = "a function of another module")]
    unsafe extern "C" {
        safe fn multiply_add(x: f64, y: f64, z: f64) -> f64;
    }

    #[expect(unsafe_code, reason = "the name that compilers know")]
    #[unsafe(no_mangle)]
    extern "C" fn fma(x: f64, y: f64, z: f64) -> f64 {
        if IS_FUSED.load(Ordering::Relaxed) { multiply_add(x, y, z) } else { libm::fma(x, y, z) }
    }
}

#[cfg(not(target_arch = "wasm32"))]
use libm as _;
