//! Refusal of PNG in a page, which draws pictures itself.

use libration_report::scene::Scene;

/// The reason why there are no PNG files.
pub(crate) fn file(_: &Scene) -> Result<Vec<u8>, String> {
    Err("the page does not write PNG: give a file name ending in .svg".to_owned())
}
