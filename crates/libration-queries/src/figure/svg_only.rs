//! Refusal of PNG and PDF in a page, which draws pictures itself.

use libration_report::scene::Scene;

/// The reason why there is none.
pub(crate) fn file(_: &Scene) -> Result<Vec<u8>, String> {
    Err("the page writes pictures as SVG only: give a file name ending in .svg".to_owned())
}
