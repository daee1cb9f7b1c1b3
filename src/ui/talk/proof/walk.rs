//! Where a key leads in a derivation.

use crate::worker::protocol::Node;
use std::cmp::Reverse;

/// A way from one node to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toward {
    /// To what was made of it.
    Whole,
    /// To its first part.
    Part,
    /// To what stands at its left.
    Left,
    /// To what stands at its right.
    Right,
    /// To the first words.
    First,
    /// To the whole sentence.
    Last,
}

/// Where a key leads from a node; `None` where there is nothing.
pub fn step(nodes: &[Node], from: usize, toward: Toward) -> Option<usize> {
    let node = nodes.get(from)?;
    let all = || nodes.iter().enumerate();
    let found = match toward {
        Toward::Whole => all().find(|(_, other)| other.parts.contains(&from)),
        Toward::Part => return node.parts.first().copied(),
        // The nearest neighbour, and the largest of those, so that a walk along a row stays low in the drawing.
        Toward::Left => {
            let before = all().filter(|(_, other)| other.words.1 <= node.words.0);
            before.max_by_key(|(i, other)| (other.words.1, *i))
        }
        Toward::Right => {
            let after = all().filter(|(_, other)| other.words.0 >= node.words.1);
            after.min_by_key(|(i, other)| (other.words.0, Reverse(*i)))
        }
        Toward::First => all().min_by_key(|(i, other)| (other.words, *i)),
        Toward::Last => all().next_back(),
    };
    found.map(|(i, _)| i)
}
