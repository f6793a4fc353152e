//! Names in MathML.

use libration_queries::internals::mathml::name;

#[test]
fn names_have_their_index_below() {
    assert_eq!(name("omega0"), "<msub><mi>ω</mi><mn>0</mn></msub>");
    assert_eq!(name("k_max"), "<msub><mi>k</mi><mi>max</mi></msub>");
    assert_eq!(name("mass"), "<mi>mass</mi>");
}
