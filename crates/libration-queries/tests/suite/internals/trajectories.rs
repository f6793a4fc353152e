//! Common parts of several motions are stated once.

use libration_queries::internals::trajectories::common;

#[test]
fn what_all_have_is_said_once() {
    let lists = [["a", "b", "c"], ["c", "b", "d"]].map(|list| list.map(str::to_owned).to_vec());
    assert_eq!(common(&lists), ["b", "c"]);
    assert_eq!(common(&lists[..1]), ["a", "b", "c"]);
    assert!(common(&[]).is_empty());
}
