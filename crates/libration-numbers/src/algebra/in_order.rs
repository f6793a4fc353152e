//! Short lists in order.
//!
//! The sort of the standard library is compiled for each type and order: 80 copies of it, of five kilobytes each, were 3 % of the program's machine
//! code. Here one is compiled, which sorts places; what each type adds is its comparison and the exchange of two items. Numbers by themselves
//! keep `sort_by(f64::total_cmp)`, which is faster for many of them.

use std::cmp::Ordering;

/// Lists that are sorted by a comparison, equal items in the order that they have.
pub trait InOrder {
    type Item;

    fn put_in_order(&mut self, compare: impl Fn(&Self::Item, &Self::Item) -> Ordering);

    fn put_in_order_by<K: Ord>(&mut self, key: impl Fn(&Self::Item) -> K) {
        self.put_in_order(|a, b| key(a).cmp(&key(b)));
    }
}

impl<T> InOrder for [T] {
    type Item = T;

    fn put_in_order(&mut self, compare: impl Fn(&T, &T) -> Ordering) {
        let places = sorted_places(self.len(), &|a, b| compare(&self[a], &self[b]));
        rearrange(places, &mut |a, b| self.swap(a, b));
    }
}

/// The present place of each item of the sorted list.
fn sorted_places(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places: Vec<usize> = (0..count).collect();
    places.sort_by(|a, b| compare(*a, *b));
    places
}

/// Brings each item from its present place, cycle by cycle.
fn rearrange(mut places: Vec<usize>, swap: &mut dyn FnMut(usize, usize)) {
    for begin in 0..places.len() {
        let mut place = begin;
        while places[place] != begin {
            let from = places[place];
            swap(place, from);
            places[place] = place;
            place = from;
        }
        places[place] = place;
    }
}
