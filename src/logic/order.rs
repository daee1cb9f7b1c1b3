//! Sorting, equals staying as they stand. The standard library's is made for millions and written out anew for every
//! type, six kilobytes a time for whoever loads the page; here it only sorts places, and once.

use std::cmp::Ordering;

/// So few items are sorted by moving each to its place.
const FEW: usize = 32;

/// Sorts items by an order.
pub fn sort_by<T>(items: &mut [T], mut order: impl FnMut(&T, &T) -> Ordering) {
    if items.len() <= FEW {
        for end in 1..items.len() {
            let mut at = end;
            while at > 0 && order(&items[at], &items[at - 1]) == Ordering::Less {
                items.swap(at, at - 1);
                at -= 1;
            }
        }
        return;
    }
    let mut from = sorted(items.len(), &mut |a, b| order(&items[a], &items[b]));
    for start in 0..items.len() {
        // Each circle of places is gone round once.
        let mut at = start;
        while from[at] != start {
            let next = std::mem::replace(&mut from[at], at);
            items.swap(at, next);
            at = next;
        }
        from[at] = at;
    }
}

/// Sorts items by a key.
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// The places of so many items in order.
fn sorted(count: usize, order: &mut dyn FnMut(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places: Vec<usize> = (0..count).collect();
    places.sort_by(|&a, &b| order(a, b));
    places
}
