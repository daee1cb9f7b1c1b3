//! What stops a robot: every fault ends in a base that stands within 200 ms of its being seen, by the simulation's clock; and
//! whatever happens in whatever order, nothing moves but while the key is held.

use super::runs::{go, room};
use super::{Rig, world};
use groundling::robot::driver::{STOPS, step};
use groundling::robot::frame::Frame;
use groundling::robot::geometry::{Pose, Twist};
use groundling::robot::message::{Command, Generation};
use groundling::robot::sim::Noise;
use groundling::robot::stage::Deed;
use groundling::robot::trial::Untried;
use groundling::robot::wiring::{FASTEST, Limits, QUICKEST};
use groundling::robot::{Calibration, Check, Driver, Event, Halt, Input, Stage, Told};
use proptest::prelude::{
    Just, ProptestConfig, Strategy, any, prop, prop_assert, prop_assert_eq, prop_oneof, proptest,
};
use serde_json::json;

/// Milliseconds from when a fault is seen to when the base stands.
const STANDS: f64 = 200.0;

fn driving(seed: u64) -> Rig {
    let mut rig =
        Rig::driving(&world(), Noise { loss: 0.0, ..Noise::default() }, seed, &go(&room("blue")));
    rig.sent.clear();
    rig
}

/// The velocities that were sent.
fn twists(rig: &Rig) -> Vec<Twist> {
    let read = |text: &String| match Frame::read(text) {
        Ok(Frame::Publish { msg, .. }) => Command::TwistStamped.velocity(&msg).ok(),
        _ => None,
    };
    rig.sent.iter().filter_map(|(_, text)| read(text)).collect()
}

/// The robot was stopped for a reason, said so three times, says no more, and stands in time.
fn halted(rig: &mut Rig, why: &str) {
    let Stage::Halted(halt) = &rig.pilot.driver.stage else {
        panic!("{why}: {:?}", rig.pilot.driver.stage)
    };
    assert!(format!("{halt:?}").starts_with(why), "{halt:?} is not {why}");
    let stood = rig.stood();
    assert!(stood <= STANDS, "{why}: it stood after {stood} ms");
    let sent = twists(rig);
    let last = sent.iter().rev().take_while(|twist| **twist == Twist::STOP).count();
    // Once more where it had stopped to look, and to think.
    let times = match why {
        "Unseen" => 2,
        "NoWay" => 3,
        _ => 1,
    };
    assert_eq!(last, times * STOPS, "{why}: {sent:?}");
    rig.event(Event::Held(true));
    rig.event(Event::Arm);
    rig.pass(2_000.0);
    assert_eq!(twists(rig).len(), sent.len(), "{why}: it is told no more");
    assert!(rig.bridge.base.stands());
}

#[test]
fn what_a_person_does_stops_it() {
    for (event, why) in [
        (Event::Emergency, "Emergency"),
        (Event::Hidden, "Hidden"),
        (Event::Backlog(9_000), "Backlog"),
    ] {
        let mut rig = driving(1);
        rig.event(event);
        halted(&mut rig, why);
    }
    for event in [Event::Held(false), Event::Closing, Event::Disarm] {
        let mut rig = driving(1);
        rig.event(event.clone());
        let stood = rig.stood();
        assert!(stood <= STANDS, "{event:?}: {stood} ms");
        assert_eq!(twists(&rig), [Twist::STOP; STOPS], "{event:?}");
    }
}

#[test]
fn no_pose_for_half_a_second_stops_it() {
    let mut rig = driving(2);
    rig.bridge.tells = false;
    let from = rig.now;
    rig.until(5_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_)));
    // The last pose was up to a period and its latency on the way.
    assert!((500.0..=680.0).contains(&(rig.now - from)), "{} ms", rig.now - from);
    halted(&mut rig, "NoPose");
}

#[test]
fn what_comes_in_wrong_stops_it() {
    for text in [
        r#"{"op":"publish","topic":"/odom","msg":{"pose":NaN}}"#.to_owned(),
        r#"{"op":"publish","topic":"/odom","msg":{"pose":{"pose":{"position":{"x":null},"orientation":{"x":0,"y":0,"z":0,"w":1}}}}}"#.to_owned(),
        r#"{"op":"status","level":"error","msg":"no"}"#.to_owned(),
        "nonsense".to_owned(),
        "[".repeat(2_000_000),
    ] {
        let mut rig = driving(3);
        rig.input(Input::Heard(text));
        halted(&mut rig, "Bad");
    }
}

#[test]
fn a_pose_that_leaps_stops_it() {
    let mut rig = driving(4);
    let at = rig.pilot.driver.pose().unwrap();
    rig.event(Event::Robot(Pose { x: at.x + 1.0, ..at }));
    halted(&mut rig, "Leapt");
}

#[test]
fn a_page_that_stood_still_stops_it() {
    let mut rig = driving(5);
    rig.now += 700.0;
    for text in rig.bridge.pass(rig.now) {
        rig.input(Input::Heard(text));
    }
    rig.event(Event::Tick);
    halted(&mut rig, "Slept");
}

#[test]
fn a_lost_link_leaves_it_to_the_base_which_stops_by_itself() {
    // A link that closes: the base hears nothing any more, and sees that after its half second.
    let mut rig = driving(6);
    rig.is_linked = false;
    rig.bridge.unlinked();
    rig.input(Input::Closed);
    assert_eq!(rig.pilot.driver.stage, Stage::Halted(Halt::Unlinked));
    let stood = rig.stood();
    assert!(stood <= rig.bridge.base.body.timeout + STANDS, "{stood} ms");
    let kept = rig.sent.len();
    // The link is there again: all is asked anew, nothing of before is sent, and nothing moves before it was looked at.
    rig.link();
    rig.event(Event::Release);
    rig.event(Event::Arm);
    rig.event(Event::Held(true));
    rig.pass(3_000.0);
    let later: Vec<&String> = rig.sent[kept..].iter().map(|(_, text)| text).collect();
    assert!(later.iter().any(|text| text.contains("subscribe")), "{later:?}");
    assert!(
        !later.iter().any(|text| text.contains("publish") || text.contains("advertise\"")),
        "{later:?}"
    );
    assert_eq!(rig.pilot.check(Check::Stops, rig.now), None);

    // A cable that is pulled: nothing closes. Poses stay away, and the base stops about when that is seen.
    let mut rig = driving(7);
    rig.is_linked = false;
    rig.until(5_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_)));
    halted(&mut rig, "NoPose");
}

#[test]
fn what_is_seen_and_makes_no_sense_stops_it() {
    let mut rig = driving(8);
    rig.bridge.base.things[0] = [0.0, 0.0];
    rig.until(20_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_)));
    halted(&mut rig, "Unseen");

    let mut rig = driving(9);
    rig.bridge.base.body.pull = (0.0, 0.0);
    rig.bridge.base.twist = Twist::STOP;
    rig.until(60_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_)));
    halted(&mut rig, "Stuck");

    // The only way is shut by somebody: there is none to think of.
    let mut rig = driving(10);
    rig.brain = None;
    rig.bridge.base.things[0] = [0.5 * 3.0, 0.5 * 2.0];
    rig.until(30_000.0, |rig| matches!(rig.pilot.driver.stage, Stage::Halted(_)));
    halted(&mut rig, "NoWay");
}

#[test]
fn three_stops_outdo_a_link_that_loses_every_third_message() {
    let lost = (0..20).filter(|seed| {
        let mut rig = Rig::driving(&world(), Noise::default(), *seed, &go(&room("blue")));
        rig.bridge.noise.loss = 0.33;
        rig.event(Event::Emergency);
        rig.stood() > STANDS
    });
    // One in 27 loses all three, and stops by itself.
    assert!(lost.count() <= 3);
}

#[test]
fn an_emergency_stop_reaches_a_robot_that_was_never_driven_from_here() {
    let mut rig = Rig::new(&world(), Noise::NONE, 1);
    rig.link();
    rig.pass(500.0);
    rig.bridge.base.wants(Twist { linear: 0.2, angular: 0.0 }, rig.now);
    rig.bridge.base.body.timeout = f64::INFINITY;
    rig.pass(300.0);
    assert!(!rig.bridge.base.stands());
    rig.event(Event::Emergency);
    assert!(rig.stood() <= STANDS);
    rig.event(Event::Release);
    assert_eq!(rig.pilot.driver.stage, Stage::Off);
}

#[test]
fn a_base_that_does_not_stop_by_itself_is_not_driven() {
    let tried = |prepare: fn(&mut Rig)| {
        let mut rig = Rig::new(&world(), Noise::default(), 11);
        prepare(&mut rig);
        rig.link();
        rig.pass(1_500.0);
        rig.event(Event::Try);
        rig.event(Event::Held(true));
        rig.until(8_000.0, |rig| rig.pilot.driver.stage == Stage::Off);
        rig.event(Event::Arm);
        assert_eq!(rig.pilot.driver.stage, Stage::Off, "it is not armed");
        assert!(rig.stood() <= STANDS);
        rig.told.last().unwrap().1.clone()
    };
    let goes_on = tried(|rig| rig.bridge.base.body.timeout = f64::INFINITY);
    assert_eq!(goes_on, Told::Untried(Untried::GoesOn));
    let still = tried(|rig| rig.bridge.base.body.pull = (0.0, 0.0));
    assert_eq!(still, Told::Untried(Untried::Still));
    // What it was seen to take is about what it takes.
    let rig = Rig::armed(&world(), Noise::default(), 12);
    let stops = rig.pilot.driver.stops.unwrap();
    assert!((400..=1_100).contains(&stops), "{stops} ms");
}

#[test]
fn a_robot_of_ros_1_and_a_plain_twist_is_driven_alike() {
    for (generation, command) in
        [(Generation::One, Command::Twist), (Generation::Two, Command::Twist)]
    {
        let mut rig = Rig::new(&world(), Noise::NONE, 1);
        (rig.bridge.plugs.generation, rig.bridge.plugs.command) = (generation, command);
        rig.link();
        rig.pass(1_500.0);
        assert_eq!(rig.pilot.session.command(), Some((command, generation)));
        rig.event(Event::Try);
        rig.event(Event::Held(true));
        assert!(rig.until(6_000.0, |rig| rig.pilot.driver.stops.is_some()), "{:?}", rig.told);
    }
}

#[test]
fn a_topic_that_is_not_there_fails_the_dry_run() {
    let mut rig = Rig::new(&world(), Noise::NONE, 1);
    rig.bridge.plugs.velocity = "/other".to_owned();
    rig.link();
    rig.pass(1_500.0);
    assert_eq!(rig.pilot.check(Check::Velocity, rig.now), Some(false));
    assert_eq!(rig.pilot.check(Check::Poses, rig.now), Some(true));
    assert!(!rig.pilot.can_try(rig.now));
    rig.event(Event::Arm);
    assert_eq!(rig.pilot.driver.stage, Stage::Off);
}

#[test]
fn a_flood_is_heard_and_changes_nothing() {
    let mut rig = driving(13);
    for at in 0..20_000 {
        let frame = json!({ "op": "publish", "topic": "/scan", "msg": { "ranges": [at] } });
        rig.input(Input::Heard(frame.to_string()));
    }
    assert_eq!(rig.pilot.driver.stage, Stage::Driving);
    assert!(rig.until(120_000.0, |rig| rig.pilot.driver.stage == Stage::Ready));
}

fn event() -> impl Strategy<Value = Event> {
    let pose = (-2.0..6.0_f64, -2.0..6.0_f64, -4.0..4.0_f64);
    let pose = pose.prop_map(|(x, y, heading)| Pose { x, y, heading });
    prop_oneof![
        6 => Just(Event::Tick),
        4 => Just(Event::Robot(Pose { x: 3.5, y: 1.0, heading: 3.1 })),
        1 => pose.clone().prop_map(Event::Robot),
        1 => (0..3_usize, pose).prop_map(|(n, pose)| Event::Body(n, pose)),
        3 => any::<bool>().prop_map(Event::Held),
        1 => prop::sample::select(vec![
            Event::Linked, Event::Unlinked, Event::Emergency, Event::Release, Event::Hidden, Event::Closing,
            Event::Try, Event::Arm, Event::Arm, Event::Disarm, Event::Again(None), Event::Backlog(5_000),
            Event::Route(vec![world(), { let mut next = world(); next.agent.x -= 1; next }]),
        ]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]
    #[test]
    fn nothing_moves_but_while_the_key_is_held(events in prop::collection::vec((event(), 0..150_u32), 0..200)) {
        let mut driver = Driver::new(world());
        driver.calibration = Some(Calibration::plain(0.5, (0, 0), [0.0; 2]));
        driver.limits = Limits { speed: 9.0, turning: 9.0, reach: 0.33 };
        let (mut now, mut is_held, mut is_moving) = (0.0, false, false);
        for (event, ms) in [(Event::Linked, 0)].into_iter().chain(events) {
            now += f64::from(ms);
            if let Event::Held(held) = event {
                is_held = held;
            }
            let before = driver.stage.clone();
            for deed in step(&mut driver, event.clone(), now) {
                let Deed::Publish(twist) = deed else { continue };
                prop_assert!(twist.is_finite() && twist.linear.abs() <= FASTEST && twist.angular.abs() <= QUICKEST);
                is_moving = twist != Twist::STOP;
                prop_assert!(!is_moving || is_held, "{event:?} in {before:?}");
            }
            // Whoever stops driving has said so.
            let drives = matches!(driver.stage, Stage::Driving | Stage::Trying(_));
            prop_assert!(drives || !is_moving, "{event:?} in {before:?}");
            let after = step(&mut driver.clone(), event.clone(), now);
            prop_assert_eq!(step(&mut driver.clone(), event, now), after, "the same of the same");
        }
    }
}
