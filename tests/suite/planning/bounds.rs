//! Bounds over several objects: along random walks, far from where a search begins, they sink by one at most, and
//! are nothing where the goal holds; and they lead where the largest part alone would not.

use super::goal;
use crate::dynamics::chances::{Draws, random};
use groundling::domain::{Blueprint, Chances, Color, Lock, Plan, Rules, State, generate, text};
use groundling::ground::Task;
use groundling::mdp::{self, Mdp, Outcome, Settings, Solver};
use groundling::plan::AStar;

fn object(state: &State, i: usize) -> String {
    let o = &state.objects[i];
    format!(
        "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({}:<e,t> $0) ({}:<e,t> $0))))",
        o.shape, o.color
    )
}

fn room(state: &State, i: usize) -> String {
    let color = state.rooms[i].color;
    format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) ({color}:<e,t> $0))))")
}

/// Conjunctions over the four objects of a world.
fn conjunctions(state: &State) -> Vec<String> {
    let o = |i| object(state, i);
    let is_in = |a: &str, r: usize| format!("(in:<e,<e,t>> {a} {})", room(state, r));
    let near = |a: &str, b: &str| format!("(near:<e,<e,t>> {a} {b})");
    let left = |a: &str, b: &str| format!("(left:<e,<e,t>> {a} {b})");
    let agent = "(the:<<e,t>,e> agent:<e,t>)";
    [
        vec![is_in(&o(0), 0), is_in(&o(1), 1), is_in(&o(2), 2), is_in(&o(3), 0)],
        vec![near(&o(0), &o(1)), left(&o(2), &o(3))],
        vec![near(&o(0), &o(1)), is_in(&o(1), 2), is_in(&o(2), 1)],
        vec![format!("(not:<t,t> {})", is_in(&o(0), 0)), is_in(&o(0), 1), is_in(&o(1), 0)],
        vec![near(agent, &o(0)), is_in(&o(1), 1), is_in(&o(2), 2), is_in(agent, 0)],
    ]
    .iter()
    .map(|parts| format!("(and:<t*,t> {})", parts.join(" ")))
    .collect()
}

#[test]
fn bounds_sink_by_one_at_most() {
    let (mut checked, mut reached) = (0, 0);
    for seed in 0..40 {
        let (other, rules) = random(seed);
        let mut state = generate(&Plan { side: (7, 9), objects: (4, 4) }, seed);
        for (door, like) in state.doors.iter_mut().zip(other.doors.iter().cycle()) {
            door.lock = like.lock;
        }
        for text in conjunctions(&state) {
            let task = Task::new(&goal(&text, &state), &state, rules).unwrap();
            let mut draws = Draws::new(seed);
            let mut packed = task.initial();
            let mut out = Vec::new();
            for _ in 0..400 {
                let from = task.heuristic(packed);
                if task.is_terminal(packed) {
                    assert_eq!(from, Some(0));
                    reached += 1;
                }
                out.clear();
                for &action in task.actions() {
                    task.successors(packed, action, &mut out);
                }
                for &(next, _) in &out {
                    let to = task.heuristic(next);
                    let sinks = to.is_none_or(|to| from.is_some_and(|from| from <= to + 1));
                    let shown = text::print(&task.dynamics().unpack(packed));
                    assert!(sinks, "{from:?} to {to:?}: {text} {rules:?}\n{shown}");
                    checked += 1;
                }
                packed = out[draws.below(out.len() as u64) as usize].0;
            }
        }
    }
    assert!(checked > 100_000 && reached > 100, "{checked} checked, {reached} at the goal");
}

#[test]
fn moves_of_several_objects_add_up() {
    let mut states = 0;
    for seed in 0..40 {
        let state = generate(&Plan { side: (8, 8), objects: (3, 3) }, seed);
        let parts = (0..3).map(|i| {
            let (a, b) = (object(&state, i), room(&state, (i + seed as usize) % 3));
            format!("(in:<e,<e,t>> {a} {b})")
        });
        let text = format!("(and:<t*,t> {})", parts.collect::<Vec<_>>().join(" "));
        let rules = Rules { pull: true, ..Rules::default() };
        let task = Task::new(&goal(&text, &state), &state, rules).unwrap();
        let mut search = AStar::new(&task, Settings::default().with_budget(100_000, 500_000));
        assert!(matches!(search.run(), Outcome::Solved | Outcome::Unreachable), "seed {seed}");
        states += search.expanded();
    }
    // By the largest part alone it would be 336,000.
    assert!(states < 200_000, "{states} states were looked at");
}

#[test]
fn behind_many_doors_that_may_lock_bounds_keep_their_promises() {
    let blueprint = Blueprint {
        columns: 14,
        rows: 14,
        rooms: 8,
        objects: 2,
        lock: Lock::Unknown,
        ..Blueprint::default()
    };
    let mut looked = 0;
    for seed in 0..8 {
        let Ok(mut state) = blueprint.build(seed) else { continue };
        // More doors than sets of doors have tables.
        if state.doors.len() < 7 {
            continue;
        }
        let looks = [Color::Red, Color::Blue];
        state.objects.iter_mut().zip(looks).for_each(|(object, look)| object.color = look);
        for (i, room) in state.rooms.iter_mut().enumerate() {
            room.color = looks.get(i).copied().unwrap_or(Color::Yellow);
        }
        let both = [(0, 0), (1, 1)]
            .map(|(o, r)| format!("(in:<e,<e,t>> {} {})", object(&state, o), room(&state, r)));
        for text in [both[0].clone(), format!("(and:<t*,t> {})", both.join(" "))] {
            let chances = Chances::new(0.1, 0.3, 0.05).unwrap();
            let rules = Rules { pull: true, chances, ..Rules::default() };
            let task = Task::new(&goal(&text, &state), &state, rules).unwrap();
            let seen = mdp::check(&task, 1_500, |_| true);
            assert!(seen.is_ok(), "{seen:?}: {text}");
            looked += seen.unwrap();
        }
    }
    assert!(looked > 5_000, "{looked}");
}
