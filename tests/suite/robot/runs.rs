//! Runs of a simulated robot: ten commands one after another, two of them over time, with a noise that is worse than most
//! robots'. All hundred seeds in release (`make test-long`), some of them otherwise.

use super::{Rig, world};
use groundling::domain::{Direction, State};
use groundling::robot::sim::Noise;
use groundling::robot::{Event, Stage, Told};

/// Seeds of which at least 95 in 100 must do.
const SEEDS: u64 = if cfg!(debug_assertions) { 8 } else { 100 };

fn the(what: &str) -> String {
    format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> {what})))")
}

pub(super) fn room(color: &str) -> String {
    the(&format!("({color}:<e,t> $0) (room:<e,t> $0)"))
}

pub(super) fn go(place: &str) -> String {
    format!("(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) {place})")
}

pub(super) fn bring(place: &str) -> String {
    format!("(in:<e,<e,t>> {} {place})", the("(yellow:<e,t> $0) (block:<e,t> $0)"))
}

fn then(first: &str, rest: &str) -> String {
    format!("(until:<t,<t,<p,p>>> true:t {first} {rest})")
}

/// Ten commands: to rooms, by their size, beside a thing, with a thing, and in an order with what is to be kept out of.
fn commands() -> Vec<String> {
    let biggest = "(argmax:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>)";
    let beside = format!(
        "(near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) {})",
        the("(yellow:<e,t> $0) (block:<e,t> $0)")
    );
    let never = format!("(always:<t,p> (not:<t,t> {}))", go(&room("blue")));
    let sequence = then(&go(&room("blue")), &then(&go(&room("red")), "done:p"));
    vec![
        go(&room("blue")),
        go(biggest),
        beside,
        go(&room("green")),
        sequence.clone(),
        bring(&room("blue")),
        go(&room("green")),
        go(&room("red")),
        format!("(all:<p*,p> {never} {})", then(&go(&room("green")), "done:p")),
        bring(&room("red")),
    ]
}

/// What came of a seed: the commands that were done, and how.
#[derive(Debug)]
struct Report {
    done: usize,
    touches: u32,
    nearest: f64,
    minutes: f64,
    again: usize,
    last: Option<Told>,
}

fn ten_commands(seed: u64) -> Report {
    let mut rig = Rig::armed(&world(), Noise::default(), seed);
    let mut done = 0;
    for command in commands() {
        rig.ask(&command);
        let runs = |rig: &Rig| !matches!(rig.pilot.driver.stage, Stage::Driving);
        rig.event(Event::Held(true));
        rig.until(600_000.0, runs);
        let brain = rig.brain.as_ref().unwrap();
        let is_done =
            brain.is_done(&rig.pilot.driver.run()) && rig.pilot.driver.stage == Stage::Ready;
        // What the robot believes is so is so.
        rig.event(Event::Held(false));
        rig.pass(500.0);
        if !is_done || rig.bridge.base.state() != rig.pilot.driver.world {
            break;
        }
        done += 1;
    }
    let again = rig.told.iter().filter(|(_, told)| *told == Told::Rethinks).count();
    let (touches, nearest) = (rig.bridge.base.touches, rig.bridge.base.nearest);
    let last = rig.told.last().map(|(_, told)| told.clone());
    Report { done, touches, nearest, minutes: rig.now / 60_000.0, again, last }
}

#[test]
fn ten_commands_are_carried_out_with_noise_and_no_wall_is_touched() {
    let reports: Vec<Report> = (0..SEEDS).map(ten_commands).collect();
    let done = reports.iter().filter(|report| report.done == 10).count();
    let touched = reports.iter().filter(|report| report.touches > 0).count();
    let nearest = reports.iter().map(|report| report.nearest).fold(f64::INFINITY, f64::min);
    let minutes: f64 = reports.iter().map(|report| report.minutes).sum::<f64>() / SEEDS as f64;
    let again: usize = reports.iter().map(|report| report.again).sum();
    eprintln!(
        "{done} of {SEEDS} seeds did all ten; {touched} touched a wall, the nearest came within {nearest:.3} m; \
         {minutes:.1} minutes each, {again} times it thought again"
    );
    for (seed, report) in reports.iter().enumerate().filter(|(_, report)| report.done < 10) {
        eprintln!("seed {seed}: {report:?}");
    }
    assert!(20 * done >= 19 * SEEDS as usize);
    assert_eq!(touched, 0);
}

#[test]
fn a_robot_that_is_carried_elsewhere_thinks_again() {
    let mut rig = Rig::driving(&world(), Noise::NONE, 3, &go(&room("blue")));
    let carry = |rig: &mut Rig| rig.bridge.base.carry(8, 2, Direction::North);
    carry(&mut rig);
    assert!(rig.until(2_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_))));
    // A leap stops it; who has looked goes on from there.
    rig.event(Event::Release);
    rig.event(Event::Arm);
    rig.pass(1_000.0);
    rig.event(Event::Held(true));
    assert!(rig.until(120_000.0, |rig| rig.pilot.driver.stage == Stage::Ready));
    assert!(rig.told.iter().any(|(_, told)| *told == Told::Rethinks), "{:?}", rig.told);
    assert!(rig.told.iter().any(|(_, told)| *told == Told::Arrived), "{:?}", rig.told);
    let state: State = rig.bridge.base.state();
    assert!(state.agent.x < 4, "{:?}", state.agent);
}

#[test]
fn what_was_done_of_a_sequence_is_not_done_again() {
    let sequence = then(&go(&room("red")), &then(&go(&room("blue")), "done:p"));
    let mut rig = Rig::armed(&world(), Noise::NONE, 5);
    rig.ask(&sequence);
    rig.event(Event::Held(true));
    // Somebody moves the block once the robot was in the red room.
    assert!(rig.until(120_000.0, |rig| {
        let at = rig.pilot.driver.run().last().map(|state| state.agent);
        at.is_some_and(|agent| agent.y > 5 && agent.x > 4)
    }));
    rig.bridge.base.things[0] = [0.5 * 5.0, 0.5 * 7.0];
    assert!(rig.until(120_000.0, |rig| rig.pilot.driver.stage == Stage::Ready), "{:?}", rig.told);
    assert!(rig.told.iter().any(|(_, told)| *told == Told::Rethinks), "{:?}", rig.told);
    assert!(rig.brain.as_ref().unwrap().is_done(&rig.pilot.driver.run()));
    let red = rig.pilot.driver.run().iter().filter(|s| s.agent.y > 5 && s.agent.x > 4).count();
    assert!(red > 0 && rig.bridge.base.state().agent.x < 4);
}
