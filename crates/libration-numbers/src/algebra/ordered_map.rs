//! Ordered maps from pairs.
//!
//! `collect` would sort the pairs first, by a sort that is compiled for each type of iterator: 43 copies of it were 5 % of the library's machine
//! code. Here one insertion is compiled per type of pairs. The pairs are few and mostly in order.

use std::collections::BTreeMap;

/// The map of the pairs; for equal keys the last pair counts.
pub fn ordered_map<K: Ord, V>(mut pairs: impl Iterator<Item = (K, V)>) -> BTreeMap<K, V> {
    inserted(&mut pairs)
}

/// The map of the pairs, if none is missing.
pub fn ordered_map_of_all<K: Ord, V>(
    mut pairs: impl Iterator<Item = Option<(K, V)>>,
) -> Option<BTreeMap<K, V>> {
    all_inserted(&mut pairs)
}

fn inserted<K: Ord, V>(pairs: &mut dyn Iterator<Item = (K, V)>) -> BTreeMap<K, V> {
    let mut map = BTreeMap::new();
    for (key, value) in pairs {
        map.insert(key, value);
    }
    map
}

fn all_inserted<K: Ord, V>(pairs: &mut dyn Iterator<Item = Option<(K, V)>>) -> Option<BTreeMap<K, V>> {
    let mut map = BTreeMap::new();
    for pair in pairs {
        let (key, value) = pair?;
        map.insert(key, value);
    }
    Some(map)
}
