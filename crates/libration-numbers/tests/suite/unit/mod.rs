//! Tests of single modules, by the path of the module.

mod algebra;
mod expression;
mod linear;
mod progress;
mod quadrature;
mod quantity;
mod roots;
mod series;

use libration_testing::sources::tests_in;
use std::path::{Path, PathBuf};

#[test]
fn no_test_is_left_in_the_library() {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    assert_eq!(tests_in(&sources), Vec::<PathBuf>::new(), "the library is not compiled for tests");
}
