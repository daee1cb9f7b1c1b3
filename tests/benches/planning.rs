//! What planning costs, in CPU time on one thread, beside the reference library (BURLAP, Java, a machine of the same
//! kind); and how it grows with cells, rooms and objects. Numbers are reported, never asserted: `make bench`;
//! `make plots` draws the growth for the guide.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a bench prints, and stops when it cannot go on"
)]

#[path = "cpu.rs"]
mod cpu;
#[path = "plot.rs"]
mod plot;

use cpu::{Row, print_table, seconds};
use groundling::domain::{
    Blueprint, Chances, Color, Lock, Plan, Rules, Shape, State, Style, generate,
};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, read};
use groundling::mdp::{Outcome, Settings, Solver};
use groundling::plan::{AStar, AnySolver, Lrtdp, ValueIteration};
use plot::{Panel, Series};
use std::hint::black_box;

/// Three rooms on 9 × 9 cells with three objects; smaller problems leave the last ones out.
const NINE: &str = include_str!("worlds/nine.json");
/// The reference library on its 9 × 9 world: CPU seconds; it numbers 7,749 states with one object, 147,447 with two.
const ONE_OBJECT: f64 = 2.7;
const TWO_OBJECTS: f64 = 150.0;
const BREADTH_FIRST: f64 = 4.0;
const BRTDP: f64 = 200.0;

/// What a solver may spend in the table of growth; above it a cell stays empty.
const BUDGET: (u64, usize) = (20_000_000, 2_000_000);
/// Worlds of each kind; their median is shown.
const WORLDS: usize = 5;

fn main() {
    let mut arguments = std::env::args().skip_while(|argument| argument != "--plot");
    let plot = arguments.nth(1);
    nine_by_nine();
    let panels = [cells(), rooms(), objects()];
    for panel in &panels {
        println!("\n{}", panel.table());
    }
    if let Some(path) = plot {
        std::fs::write(&path, plot::svg(&panels)).unwrap();
        println!("\ndrawn: {path}");
    }
}

fn rules(lock: f64) -> Rules {
    Rules { pull: true, chances: Chances::new(0.0, lock, 0.0).unwrap(), ..Rules::default() }
}

/// The 9 × 9 world with some of its objects and one lock on all doors.
fn nine(objects: usize, lock: Lock) -> State {
    let mut state = State::read(NINE).unwrap();
    state.objects.truncate(objects);
    state.doors.iter_mut().for_each(|door| door.lock = lock);
    state
}

/// The first objects, each to be brought to the room of a colour.
fn bring(state: &State, to: &[Color]) -> Goal {
    let parts = state.objects.iter().zip(to).map(|(object, room)| {
        let the = |a: &str, b: &str| {
            format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0))))")
        };
        let (object, room) =
            (the(object.shape.name(), object.color.name()), the("room", room.name()));
        format!("(in:<e,<e,t>> {object} {room})")
    });
    let parts: Vec<String> = parts.collect();
    let text = match &parts[..] {
        [one] => one.clone(),
        _ => format!("(and:<t*,t> {})", parts.join(" ")),
    };
    let mut terms = Terms::new();
    let term = read(&mut terms, &text).unwrap();
    Goal::new(&terms, term, state).unwrap()
}

const AROUND: [Color; 3] = [Color::Red, Color::Blue, Color::Green];

/// What A* takes to bring three objects to three rooms, tables included, in worlds like the corpora's with pull.
fn everywhere() -> Vec<f64> {
    let plan = Plan { objects: (3, 3), ..Plan::default() };
    let of = |seed| {
        let mut state = generate(&plan, seed);
        for (i, object) in state.objects.iter_mut().enumerate() {
            object.shape = Shape::ALL[i];
        }
        let goal = bring(&state, &AROUND);
        seconds(|| {
            let task = Task::new(&goal, &state, rules(0.0)).unwrap();
            black_box(AStar::new(&task, Settings::default()).run());
        })
    };
    (0..100).map(of).collect()
}

/// The sizes that the reference library was measured on.
fn nine_by_nine() {
    let task = |objects, moved: usize, lock: f64| {
        let state = nine(objects, if lock > 0.0 { Lock::Unknown } else { Lock::Unlocked });
        Task::new(&bring(&state, &AROUND[..moved]), &state, rules(lock)).unwrap()
    };
    let (one, two) = (task(1, 1, 0.5), task(2, 2, 0.0));
    let (three, locks) = (task(3, 3, 0.0), task(3, 3, 0.5));
    let settings = Settings::default();
    let mut rows = [
        Row::of("value iteration: 1 object, pull, locks", 20, None, |_| {
            black_box(ValueIteration::new(&one, settings).run());
        }),
        Row::of("value iteration: 2 objects, pull", 5, Some(TWO_OBJECTS), |_| {
            black_box(ValueIteration::new(&two, settings).run());
        }),
        Row::of("A*: 3 objects, pull (breadth-first)", 10, Some(BREADTH_FIRST), |_| {
            black_box(AStar::new(&three, settings).run());
        }),
        Row::of("A*: 3 objects, pull (BRTDP)", 10, Some(BRTDP), |_| {
            black_box(AStar::new(&three, settings).run());
        }),
        Row::from_seconds("A*: 3 objects to 3 rooms, random worlds", everywhere()),
        Row::of("LRTDP: 3 objects, pull, locks, ε 1e-6", 5, None, |_| {
            black_box(Lrtdp::new(&locks, settings).run());
        }),
        Row::of("the tables of a goal: 3 objects, locks", 20, None, |_| {
            black_box(task(3, 3, 0.5));
        }),
    ];
    rows[0].set_reference(ONE_OBJECT);
    print_table(&rows);
    println!();
    for (name, task, reference) in
        [("1 object", &one, ONE_OBJECT), ("2 objects", &two, TWO_OBJECTS)]
    {
        let mut solver = ValueIteration::new(task, settings);
        let cost = seconds(|| {
            while solver.progress().backups == 0 {
                solver.step(1_000);
            }
        });
        let before = solver.progress().backups;
        let sweeps = seconds(|| {
            solver.run();
        });
        let progress = solver.progress();
        println!(
            "value iteration, {name}: {} ends of leaps, {:.0} times as fast as the reference; \
             {:.0} million backups a second in {} sweeps",
            progress.states,
            reference / (cost + sweeps),
            (progress.backups - before) as f64 / sweeps / 1e6,
            solver.sweeps(),
        );
    }
    let mut search = AStar::new(&three, settings);
    search.run();
    let mut solver = Lrtdp::new(&locks, settings);
    solver.run();
    println!(
        "A*, 3 objects: {} states expanded, {} actions; LRTDP: {} states, {} backups, value {:.4}",
        search.expanded(),
        search.plan().map_or(0, |plan| plan.actions.len()),
        solver.progress().states,
        solver.progress().backups,
        solver.progress().lower,
    );
}

/// Built worlds whose first objects are to be brought elsewhere, each with its goal: some that need a few actions.
fn problems(blueprint: Blueprint, moved: usize) -> Vec<(State, Goal)> {
    let mut all = Vec::new();
    for seed in 0..200 {
        let Ok(mut state) = blueprint.build(seed) else { continue };
        for (i, object) in state.objects.iter_mut().enumerate() {
            object.shape = Shape::ALL[i % Shape::ALL.len()];
            object.color = Color::ALL[i % Color::ALL.len()];
        }
        // The goal says a room by its colour: the last three of the state have one each.
        let n = state.rooms.len();
        for (i, room) in state.rooms.iter_mut().enumerate() {
            room.color = if i + 3 >= n { AROUND[i + 3 - n] } else { Color::Yellow };
        }
        let to: Vec<Color> = (0..moved).map(|i| AROUND[(i + seed as usize) % 3]).collect();
        let goal = bring(&state, &to);
        let task = Task::new(&goal, &state, rules(0.0)).unwrap();
        let mut search = AStar::new(&task, Settings::default().with_budget(BUDGET.0, BUDGET.1));
        search.run();
        if search.plan().is_some_and(|plan| plan.actions.len() > 5) {
            all.push((state, goal));
        }
        if all.len() == WORLDS {
            break;
        }
    }
    all
}

/// The median milliseconds that a solver needs for such problems, their tables included; `None` above the budget.
fn cost(name: &str, problems: &[(State, Goal)], lock: f64) -> Option<f64> {
    let costs = problems.iter().map(|(state, goal)| {
        let mut state = state.clone();
        if lock > 0.0 {
            state.doors.iter_mut().for_each(|door| door.lock = Lock::Unknown);
        }
        let settings = Settings::default().with_budget(BUDGET.0, BUDGET.1);
        let mut outcome = Outcome::Budget;
        let cost = seconds(|| {
            let task = Task::new(goal, &state, rules(lock)).unwrap();
            outcome = AnySolver::named(name, &task, settings).unwrap().run();
        });
        if outcome == Outcome::Budget { f64::INFINITY } else { cost * 1e3 }
    });
    let mut costs: Vec<f64> = costs.collect();
    costs.sort_by(f64::total_cmp);
    costs.get(costs.len() / 2).copied().filter(|cost| cost.is_finite())
}

/// One line a solver: A* where nothing is left to chance, the others where doors may lock.
fn series(blueprints: &[Blueprint], moved: impl Fn(&Blueprint) -> usize) -> Vec<Series> {
    let kinds: Vec<_> = blueprints.iter().map(|b| problems(*b, moved(b))).collect();
    let solvers = [
        ("A*", "astar", 0.0),
        ("value iteration, locks", "vi", 0.3),
        ("LRTDP, locks", "lrtdp", 0.3),
    ];
    let of = |(title, name, lock): (&'static str, &str, f64)| Series {
        title,
        values: kinds.iter().map(|problems| cost(name, problems, lock)).collect(),
    };
    solvers.map(of).into()
}

fn cells() -> Panel {
    let sides = [9, 12, 16, 20, 26, 32];
    let all = sides.map(|side| Blueprint { columns: side, rows: side, ..Blueprint::default() });
    Panel {
        title: "cells: 3 rooms, 1 object",
        labels: sides.iter().map(|side| format!("{side} × {side}")).collect(),
        series: series(&all, |_| 1),
    }
}

fn rooms() -> Panel {
    let counts = [3, 5, 7, 9, 12];
    let world = Blueprint { style: Style::Rows, columns: 20, rows: 20, ..Blueprint::default() };
    let all = counts.map(|rooms| Blueprint { rooms, ..world });
    Panel {
        title: "rooms: 20 × 20, 1 object",
        labels: counts.iter().map(u32::to_string).collect(),
        series: series(&all, |_| 1),
    }
}

fn objects() -> Panel {
    let counts = [1, 2, 3, 4, 5, 6, 8];
    let world = Blueprint { columns: 12, rows: 12, ..Blueprint::default() };
    let all = counts.map(|objects| Blueprint { objects, ..world });
    Panel {
        title: "objects: 3 rooms, 12 × 12, up to 3 to be brought",
        labels: counts.iter().map(u32::to_string).collect(),
        series: series(&all, |b| b.objects.min(3) as usize),
    }
}
