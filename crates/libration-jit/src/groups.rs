//! Groups of inner products that are formed at the same time.

use std::collections::HashMap;

use crate::{Arithmetic, StraightLine};

/// Inner products of the same length, by their steps; no more than a register has lanes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Group {
    pub(crate) members: Vec<usize>,
    pub(crate) count: usize,
}

/// Largest number of inner products side by side in a register.
pub(crate) const WIDEST: usize = 8;

/// All inner products of a line in groups of at most `most`. The key is the first step of the group, at which every value that the group reads
/// is known.
pub(crate) fn groups(line: &StraightLine, most: usize) -> HashMap<usize, Group> {
    let mut kept = vec![None; line.places()];
    for (number, step) in line.steps().iter().enumerate() {
        if let Arithmetic::Keep { slot, .. } = *step {
            kept[slot] = Some(number);
        }
    }
    let mut groups: HashMap<usize, Group> = HashMap::new();
    let mut open: HashMap<usize, usize> = HashMap::new();
    for (number, step) in line.steps().iter().enumerate() {
        let Arithmetic::InnerProduct { count, .. } = *step else { continue };
        let last = step.read().filter_map(|slot| kept[slot]).max();
        let joined = open.get(&count).and_then(|first| groups.get_mut(first).filter(|_| last < Some(*first)));
        match joined.filter(|group| group.members.len() < most) {
            Some(group) => group.members.push(number),
            None => {
                open.insert(count, number);
                groups.insert(number, Group { members: vec![number], count });
            }
        }
    }
    groups
}
