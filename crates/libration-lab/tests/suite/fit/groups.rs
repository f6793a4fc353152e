//! The mean of groups. Values by NumPy and `scipy.stats` 1.17.1.

use libration_lab::fit::{GroupMean, GroupResult, Uncertain};

/// Four groups, the last with this value.
fn groups(last: f64) -> Vec<GroupResult> {
    let rows =
        [("A", 9.80, 0.02, 10.0), ("B", 9.83, 0.03, 8.0), ("C", 9.79, 0.02, 12.0), ("D", last, 0.025, 10.0)];
    let group = |(name, value, uncertainty, degrees_of_freedom): (&str, f64, f64, f64)| GroupResult {
        name: name.into(),
        rows: 5,
        value: Uncertain { value, uncertainty },
        degrees_of_freedom,
    };
    rows.map(group).to_vec()
}

fn close(computed: f64, expected: f64) {
    assert!((computed / expected - 1.0).abs() < 1e-12, "{computed} {expected}");
}

#[test]
fn groups_that_agree_have_the_weighted_mean_and_its_degrees_of_freedom() {
    let mean = GroupMean::new(&groups(9.82), 0.0).unwrap();
    close(mean.value.value, 9.805230547550432);
    close(mean.value.uncertainty, 0.01138784427001685);
    close(mean.degrees_of_freedom, 38.21037140465774);
    assert_eq!(mean.standing_out, None);
}

/// The group D has t = 5.29 with 15 degrees of freedom: p = 4e-4 for four groups.
#[test]
fn groups_that_disagree_have_the_birge_ratio_and_one_stands_out() {
    let mean = GroupMean::new(&groups(9.95), 0.0).unwrap();
    close(mean.value.value, 9.832204610951008);
    close(mean.value.uncertainty, 0.01138784427001685 * 3.1226335900877347);
    assert_eq!(mean.standing_out, Some(3));
    assert_eq!(mean.degrees_of_freedom, 3.0);
}

/// A shared clock is not averaged out, nor enlarged by the scatter of the groups.
#[test]
fn what_groups_share_is_added_once() {
    let mean = GroupMean::new(&groups(9.95), 0.1).unwrap();
    close(mean.total().uncertainty, libm::hypot(0.1, 0.01138784427001685 * 3.1226335900877347));
    assert!(mean.degrees_of_freedom > 100.0 && mean.expanded() > 1.95 * mean.total().uncertainty);
}

#[test]
fn fewer_than_two_groups_and_unknown_uncertainties_have_no_mean() {
    assert_eq!(GroupMean::new(&groups(9.82)[..1], 0.0), None);
    let mut unknown = groups(9.82);
    unknown[0].value.uncertainty = 0.0;
    assert_eq!(GroupMean::new(&unknown, 0.0), None);
    // Of two groups neither is the one.
    assert_eq!(GroupMean::new(&groups(9.95)[2..], 0.0).unwrap().standing_out, None);
}
