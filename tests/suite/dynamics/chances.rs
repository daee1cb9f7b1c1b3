//! What may go wrong: each draw by hand, then random worlds under random rules against the plain telling of the
//! same rules, and what a planner may take for one state.

use super::plain;
use groundling::domain::{
    Action, Chances, Dynamics, Form, Lock, Movable, Packed, Plan, Rules, State, generate, text,
};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, read};
use groundling::mdp::{self, Mdp};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// A robot between a chair, with a door behind it, and a bag.
const ROW: &str = "###########\n#rrG>C?bbb#\n###########\n\n\
    r room red at 0 0 6 2\nb room blue at 6 0 10 2\n? door unknown\nC chair red\nG bag tan\n";

fn row() -> State {
    text::read_legal(ROW).unwrap_or_else(|e| panic!("{e}"))
}

fn rules(slip: f64, lock: f64, loss: f64) -> Rules {
    Rules { pull: true, chances: Chances::new(slip, lock, loss).unwrap(), ..Rules::default() }
}

/// Outcomes in words: the columns of the robot, the chair and the bag, the heading, the lock; in thousandths.
fn outcomes(state: &State, rules: Rules, actions: &[Action]) -> Vec<(String, u32)> {
    let dynamics = Dynamics::new(state, rules).unwrap();
    let (last, first) = actions.split_last().unwrap();
    let start = first.iter().fold(dynamics.pack(state).unwrap(), |s, &a| dynamics.step(s, a));
    let mut out = Vec::new();
    dynamics.outcomes(start, *last, &mut out);
    let words = out.into_iter().map(|(packed, p)| {
        let s = dynamics.unpack(packed);
        let columns = format!("{} {} {}", s.agent.x, s.objects[0].x, s.objects[1].x);
        let way = format!("{} {}", s.agent.direction.letter(), s.doors[0].lock);
        (format!("{columns} {way}"), (p * 1000.0).round() as u32)
    });
    words.collect()
}

#[test]
fn draws_come_in_their_order() {
    let says = |rules, actions: &[Action]| outcomes(&row(), rules, actions);
    let case = |all: &[(&str, u32)]| -> Vec<(String, u32)> {
        all.iter().map(|&(s, p)| (s.to_owned(), p)).collect()
    };
    let east = [Action::East];
    assert_eq!(says(rules(0.0, 0.0, 0.0), &east), case(&[("5 6 3 > unlocked", 1000)]));
    // Slip: nothing changes at all, not even the heading.
    assert_eq!(
        says(rules(0.5, 0.0, 0.0), &[Action::North]),
        case(&[("4 5 3 > unknown", 500), ("4 5 3 ^ unknown", 500)])
    );
    // Lock: the robot has turned, the door is locked, nothing moves.
    assert_eq!(
        says(rules(0.0, 0.25, 0.0), &east),
        case(&[("4 5 3 > locked", 250), ("5 6 3 > unlocked", 750)])
    );
    // Loss comes last: the door was tried already.
    assert_eq!(
        says(rules(0.2, 0.5, 0.25), &east),
        case(&[
            ("4 5 3 > unknown", 200),
            ("4 5 3 > locked", 400),
            ("4 5 3 > unlocked", 100),
            ("5 6 3 > unlocked", 300),
        ])
    );
    // Lost on pull: the robot stays as it is.
    assert_eq!(
        says(rules(0.0, 0.5, 0.25), &[Action::Pull]),
        case(&[("4 5 3 > unknown", 250), ("5 4 3 < unknown", 750)])
    );
    // A door that was tried is not tried again, and a blocked push tries nothing.
    assert_eq!(
        says(rules(0.0, 0.5, 0.0), &[Action::East, Action::East]),
        case(&[("6 7 3 > unlocked", 1000)])
    );
    assert_eq!(
        says(rules(0.5, 0.5, 0.5), &[Action::West, Action::West, Action::West]),
        case(&[("2 5 1 < unknown", 1000)])
    );
    // What is certain has one outcome.
    assert_eq!(says(rules(0.0, 1.0, 0.5), &east), case(&[("4 5 3 > locked", 1000)]));
    assert_eq!(says(rules(1.0, 0.5, 0.5), &east), case(&[("4 5 3 > unknown", 1000)]));
}

#[test]
fn what_must_not_move_stands_like_a_wall() {
    let bag_only = Rules { movable: Movable::NONE.with(1), ..rules(0.0, 0.5, 0.5) };
    let one = |action| {
        let all = outcomes(&row(), bag_only, &[action]);
        all.into_iter().map(|(s, _)| s).collect::<Vec<_>>()
    };
    assert_eq!(one(Action::East), ["4 5 3 > unknown"]);
    assert_eq!(one(Action::Pull), ["4 5 3 > unknown"]);
    assert_eq!(one(Action::West), ["4 5 3 < unknown", "3 5 2 < unknown"]);
    assert!(!Movable::ALL.allows(64) && Movable::NONE.with(64) == Movable::NONE);
}

#[test]
fn the_robot_form_turns_by_quarters_and_goes_ahead() {
    let robot = Rules { form: Form::Robot, pull: true, ..Rules::default() };
    let end = |actions: &[Action]| outcomes(&row(), robot, actions).swap_remove(0).0;
    let names: Vec<&str> = robot.actions().iter().map(|a| a.name()).collect();
    assert_eq!(names, ["forward", "turn_left", "turn_right", "pull"]);
    assert_eq!(end(&[Action::Forward]), "5 6 3 > unlocked");
    assert_eq!(end(&[Action::TurnLeft]), "4 5 3 ^ unknown");
    assert_eq!(end(&[Action::TurnRight]), "4 5 3 v unknown");
    assert_eq!(end(&[Action::TurnLeft, Action::TurnLeft, Action::Forward]), "3 5 2 < unknown");
    assert_eq!(end(&[Action::TurnLeft, Action::Forward]), "4 5 3 ^ unknown");
    assert_eq!(end(&[Action::Pull]), "5 4 3 < unknown");
    assert_eq!(end(&[Action::East]), "4 5 3 > unknown", "the other form's actions do nothing");
}

#[test]
fn no_other_number_is_a_probability() {
    let error = |slip, lock, loss| Chances::new(slip, lock, loss).unwrap_err().to_string();
    assert!(error(-0.1, 0.0, 0.0).starts_with("slip_probability: -0.1 is no probability"));
    assert!(error(0.0, 1.5, 0.0).starts_with("lock_probability: 1.5 is no probability"));
    assert!(error(0.0, 0.0, f64::NAN).starts_with("loss_probability: NaN is no probability"));
    assert!(Chances::new(0.0, 1.0, 0.5).is_ok());
}

/// Numbers of no great quality, but the same everywhere.
pub(crate) struct Draws(u64);

impl Draws {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(2) + 1)
    }

    pub(crate) fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) % n
    }
}

/// A small random world with doors of every kind, and random rules.
pub(crate) fn random(seed: u64) -> (State, Rules) {
    let mut draws = Draws::new(seed);
    let most = 1 + draws.below(3) as u32;
    let mut state = generate(&Plan { side: (7, 9), objects: (1, most) }, seed);
    for door in &mut state.doors {
        door.lock =
            [Lock::Unknown, Lock::Unknown, Lock::Unlocked, Lock::Locked][draws.below(4) as usize];
    }
    let mut chance = || [0.0_f64, 0.0, 0.25, 0.6, 1.0][draws.below(5) as usize];
    let chances = Chances::new(chance().min(0.6), chance(), chance()).unwrap();
    let movable = if draws.below(3) == 0 { Movable::NONE.with(0) } else { Movable::ALL };
    let form = if draws.below(3) == 0 { Form::Robot } else { Form::Compass };
    (state, Rules { pull: draws.below(2) == 0, form, movable, chances })
}

/// The states of a walk at random through a world.
fn walk(dynamics: &Dynamics, state: &State, seed: u64, steps: u64) -> Vec<Packed> {
    let mut draws = Draws::new(seed);
    let mut all = vec![dynamics.pack(state).unwrap()];
    for _ in 0..steps {
        let mut out = Vec::new();
        let actions = dynamics.actions();
        let action = actions[draws.below(actions.len() as u64) as usize];
        dynamics.outcomes(all[all.len() - 1], action, &mut out);
        all.push(out[draws.below(out.len() as u64) as usize].0);
    }
    all
}

/// Each state once, in order.
fn merged<S: Ord>(all: Vec<(S, f64)>) -> Vec<(S, f64)> {
    let mut merged: Vec<(S, f64)> = Vec::new();
    for (state, p) in all {
        match merged.iter_mut().find(|o| o.0 == state) {
            Some(known) => known.1 += p,
            None => merged.push((state, p)),
        }
    }
    merged.sort_by(|a, b| a.0.cmp(&b.0));
    merged
}

fn assert_same<S: Ord + PartialEq + std::fmt::Debug>(a: Vec<(S, f64)>, b: Vec<(S, f64)>, of: &str) {
    let (a, b) = (merged(a), merged(b));
    let same = a.len() == b.len()
        && a.iter().zip(&b).all(|(x, y)| x.0 == y.0 && (x.1 - y.1).abs() < 1e-12);
    assert!(same, "{of}\n{a:?}\n{b:?}");
}

#[test]
fn the_packed_world_is_the_plain_one() {
    let mut uncertain = 0;
    for seed in 0..150 {
        let (state, rules) = random(seed);
        let dynamics = Dynamics::new(&state, rules).unwrap();
        for packed in walk(&dynamics, &state, seed, 60) {
            let plain_state = dynamics.unpack(packed);
            plain_state.check().unwrap();
            for &action in rules.actions() {
                // An earlier outcome in the buffer is nobody's equal.
                let mut out = vec![(packed, 7.0)];
                dynamics.outcomes(packed, action, &mut out);
                assert_eq!(out.remove(0), (packed, 7.0));
                uncertain += usize::from(out.len() > 1);
                let pack = |(s, p): (State, f64)| (dynamics.pack(&s).unwrap(), p);
                let plain = plain::outcomes(&plain_state, &rules, action);
                let plain: Vec<_> = plain.into_iter().map(pack).collect();
                assert_eq!(out.len(), plain.len());
                assert_same(
                    out,
                    plain,
                    &format!("{action} {rules:?}\n{}", text::print(&plain_state)),
                );
            }
        }
    }
    assert!(uncertain > 1000, "{uncertain}");
}

#[test]
fn states_taken_for_one_have_the_same_prospects() {
    let mut taken = 0;
    for seed in 0..150 {
        let (state, rules) = random(seed);
        let dynamics = Dynamics::new(&state, rules).unwrap();
        for packed in walk(&dynamics, &state, seed, 60) {
            let one = dynamics.quotient(packed);
            assert_eq!(dynamics.quotient(one), one);
            taken += usize::from(one != packed);
            for &action in rules.actions() {
                let prospects = |from| {
                    let mut out = Vec::new();
                    dynamics.outcomes(from, action, &mut out);
                    out.iter().map(|&(s, p)| (dynamics.quotient(s), p)).collect::<Vec<_>>()
                };
                assert_same(prospects(packed), prospects(one), &format!("seed {seed} {action}"));
            }
        }
    }
    assert!(taken > 1000, "{taken}");
}

#[test]
fn draws_are_as_frequent_as_their_probabilities_say() {
    const DRAWS: u32 = 2_000;
    let mut tested = 0;
    for seed in 0..60 {
        let (state, rules) = random(seed);
        let mut terms = Terms::new();
        let never = read(&mut terms, "false:t").unwrap();
        let task = Task::new(&Goal::new(&terms, never, &state).unwrap(), &state, rules).unwrap();
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        for packed in walk(task.dynamics(), &state, seed, 8) {
            for &action in rules.actions() {
                let (mut out, mut buffer) = (Vec::new(), Vec::new());
                task.world().successors(packed, action, &mut out);
                let mut seen = vec![0_u32; out.len()];
                for _ in 0..if out.len() > 1 { DRAWS } else { 1 } {
                    let next = mdp::sample(&task.world(), packed, action, &mut buffer, &mut rng);
                    seen[out.iter().position(|o| o.0 == next).unwrap()] += 1;
                }
                if out.len() > 1 {
                    let off = |(o, n): (&(Packed, f64), &u32)| {
                        let expected = o.1 * f64::from(DRAWS);
                        (f64::from(*n) - expected).powi(2) / expected
                    };
                    let chi_square: f64 = out.iter().zip(&seen).map(off).sum();
                    // At most four degrees of freedom: less than one in a million is above.
                    assert!(chi_square < 35.0, "seed {seed} {action}: {out:?} {seen:?}");
                    tested += 1;
                }
            }
        }
    }
    assert!(tested > 200, "{tested}");
}

#[test]
fn a_world_says_whether_anything_is_left_to_chance() {
    for seed in 0..150 {
        let (state, rules) = random(seed);
        let dynamics = Dynamics::new(&state, rules).unwrap();
        let start = dynamics.pack(&state).unwrap();
        for packed in walk(&dynamics, &state, seed, 60) {
            for &action in rules.actions() {
                let mut out = Vec::new();
                dynamics.outcomes(packed, action, &mut out);
                assert!(out.len() == 1 || !dynamics.is_deterministic(start), "seed {seed}");
            }
        }
    }
    let sure = Dynamics::new(&row(), rules(0.0, 1.0, 0.0)).unwrap();
    assert!(sure.is_deterministic(sure.pack(&row()).unwrap()));
}
