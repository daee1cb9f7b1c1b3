//! What changed between two states, as cells to point out: where something went from, and where it is now.

use crate::domain::State;
use crate::study::Showing;

/// The cells to point out before, and those after.
pub fn changed(showing: &Showing) -> [Vec<(i32, i32)>; 2] {
    let (pre, post) = showing.states();
    let mut cells = [Vec::new(), Vec::new()];
    let mut moved = |from: (i32, i32), to: (i32, i32)| {
        if from != to {
            cells[0].push(from);
            cells[1].push(to);
        }
    };
    moved((pre.agent.x, pre.agent.y), (post.agent.x, post.agent.y));
    let same = |state: &State, name: &str| state.objects.iter().find(|o| o.name == name).cloned();
    for before in &pre.objects {
        if let Some(after) = same(post, &before.name) {
            moved((before.x, before.y), (after.x, after.y));
        }
    }
    cells
}
