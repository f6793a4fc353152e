use libration_numbers::internals::algebra::InOrder;

/// All lists of up to seven items with three keys; the sort of the standard library is stable as well.
#[test]
fn lists_are_sorted_as_by_the_standard_library() {
    for length in 0..8_u32 {
        for code in 0..3_u32.pow(length) {
            let mut list: Vec<(u32, u32)> =
                (0..length).map(|place| (code / 3_u32.pow(place) % 3, place)).collect();
            let [mut rising, mut falling] = [list.clone(), list.clone()];
            rising.put_in_order_by(|(key, _)| *key);
            falling.put_in_order(|a, b| b.0.cmp(&a.0));
            list.sort_by_key(|(key, _)| *key);
            assert_eq!(rising, list);
            list.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(&b.1)));
            assert_eq!(falling, list);
        }
    }
}
