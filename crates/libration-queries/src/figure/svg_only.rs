//! Refusal of PNG, PDF and JSON in a page, which draws pictures itself.

use super::Layout;
use super::chart::Picture;

/// The reason why there is none.
pub(crate) fn file<T>(_: &T) -> Result<Vec<u8>, String> {
    Err("the page writes pictures as SVG only: give a file name ending in .svg".to_owned())
}

/// The page takes no charts.
#[allow(dead_code, reason = "called in one of the three modules that this file stands for")]
pub(crate) fn pass(_: &Layout, _: impl Fn() -> Picture) {}
