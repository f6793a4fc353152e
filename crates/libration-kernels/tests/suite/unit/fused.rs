use libration::fused::rounds_once;

#[test]
fn sums_of_products_are_rounded_once() {
    assert!(rounds_once());
}
