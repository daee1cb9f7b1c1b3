//! The page that drives a robot, as its reducer has it, with the engine that talks behind it and no browser: the simulated
//! robot from the first press to the end of a command, and what a link does.

use groundling::domain::State as World;
use groundling::robot::address::{Fault, address};
use groundling::robot::{Calibration, Pose, Stage, Told};
use groundling::ui::page::language::Language;
use groundling::ui::robot::state::{Kind, Link, Topic};
use groundling::ui::robot::talker::named;
use groundling::ui::robot::{Action, Effect, State, reduce};
use groundling::worker::protocol::{Envelope, Event, VERSION};
use groundling::worker::{Engine, Talker};

const MODEL: &str = include_str!("../../../assets/model/cleanup.model");

/// The page, a person at it, and the engine.
struct Page {
    state: State,
    talker: Engine<Talker>,
    now: f64,
    /// What the store has.
    kept: Option<String>,
    /// What was wanted and is none of the engine's or the store's.
    wanted: Vec<Effect>,
}

impl Page {
    fn open(is_secure: bool) -> Page {
        Page::again(is_secure, None)
    }

    /// The page with what an earlier visit kept.
    fn again(is_secure: bool, kept: Option<String>) -> Page {
        let (state, talker) = (State::new(), Engine::new());
        let mut page = Page { state, talker, now: 0.0, kept, wanted: Vec::new() };
        page.act(Action::Opened(Language::English, is_secure));
        page
    }

    fn act(&mut self, action: Action) {
        let mut effects = reduce(&mut self.state, action, self.now);
        while !effects.is_empty() {
            let said = match effects.remove(0) {
                Effect::SpawnTalker => vec![Action::Heard(ready())],
                Effect::FetchModel => vec![Action::Model(Ok(MODEL.to_owned()))],
                Effect::FetchWords => vec![Action::Words(Err("no network".to_owned()))],
                Effect::Post(Envelope { id, body, .. }) => {
                    self.talker.start(id, body);
                    let mut said = Vec::new();
                    while self.talker.busy() {
                        let heard = self.talker.step();
                        said.extend(heard.map(|(id, body)| {
                            Action::Heard(Envelope { groundling: VERSION, id, body })
                        }));
                    }
                    said
                }
                Effect::Recall => vec![Action::Recalled(self.kept.clone())],
                Effect::Keep(text) => {
                    self.kept = Some(text);
                    Vec::new()
                }
                // The engine always answers here.
                Effect::Watch(..) => Vec::new(),
                other => {
                    self.wanted.push(other);
                    Vec::new()
                }
            };
            for action in said {
                effects.extend(reduce(&mut self.state, action, self.now));
            }
        }
    }

    /// Lets time go by until something is so; whether it came to that.
    fn until(&mut self, ms: f64, is_so: impl Fn(&State) -> bool) -> bool {
        let end = self.now + ms;
        while self.now < end && !is_so(&self.state) {
            self.now += 40.0;
            self.act(Action::Tick(0));
        }
        is_so(&self.state)
    }

    /// The simulated robot, looked at and allowed to drive.
    fn armed() -> Page {
        let mut page = Page::open(false);
        page.act(Action::Link(true));
        assert!(page.until(3_000.0, |state| state.pilot.can_try(state.now)));
        page.act(Action::Try);
        page.act(Action::Held(true));
        assert!(
            page.until(8_000.0, |state| state.pilot.is_fit(state.now)),
            "{:?}",
            page.state.told
        );
        page.act(Action::Held(false));
        page.act(Action::Arm(true));
        assert_eq!(page.state.pilot.driver.stage, Stage::Ready);
        page
    }
}

fn ready() -> Envelope<Event> {
    Envelope { groundling: VERSION, id: 0, body: Event::Ready }
}

#[test]
fn a_simulated_robot_does_what_it_is_told() {
    let mut page = Page::armed();
    page.act(Action::Typed("go to the biggest room".to_owned()));
    page.act(Action::Ask);
    let plan = page.state.plan().unwrap();
    assert!(
        plan.actions
            .iter()
            .all(|action| ["forward", "turn_left", "turn_right"].contains(&&**action))
    );
    page.act(Action::Rehearse);
    let rehearsal = page.state.rehearsal.clone().unwrap();
    assert!(rehearsal.is_done && rehearsal.nearest > 0.0, "{rehearsal:?}");
    page.act(Action::Held(true));
    assert_eq!(page.state.pilot.driver.stage, Stage::Driving);
    assert!(page.until(300_000.0, |state| state.pilot.driver.stage == Stage::Ready));
    let agent = page.state.bridge.as_ref().unwrap().base.state().agent;
    assert!(agent.x < 4, "{agent:?} is not in the blue room, the biggest");
    assert!(page.wanted.iter().all(|effect| matches!(effect, Effect::Speak(_))));
}

#[test]
fn what_was_done_of_a_sequence_is_not_done_again_behind_a_surprise() {
    let mut page = Page::armed();
    let command = "go to the red room, then to the blue room, then to the green room";
    page.act(Action::Typed(command.to_owned()));
    page.act(Action::Ask);
    assert!(page.state.plan().is_some_and(|plan| !plan.done.is_empty()), "{:?}", page.state.said);
    page.act(Action::Held(true));
    let is_red = |world: &World| world.agent.y > 4 && world.agent.x > 4;
    let is_blue =
        |state: &State| state.pilot.driver.run().last().is_some_and(|world| world.agent.x < 4);
    assert!(page.until(300_000.0, is_blue), "{:?}", page.state.told);
    let run = page.state.pilot.driver.run();
    assert!(run.iter().any(is_red));
    // Somebody moves the block, and the robot is surprised.
    page.state.bridge.as_mut().unwrap().base.things[0] = [0.5 * 5.0, 0.5 * 7.0];
    assert!(page.until(60_000.0, |state| state.told == Some(Told::Rethinks)));
    assert!(page.until(300_000.0, |state| state.pilot.driver.stage == Stage::Ready));
    let (before, run) = (run.len(), page.state.pilot.driver.run());
    let way: Vec<(i32, i32)> = run.iter().map(|state| (state.agent.x, state.agent.y)).collect();
    assert_eq!(page.state.told, Some(Told::Arrived), "{before} of {way:?}");
    assert!(run.len() > before && !run[before..].iter().any(is_red), "not to the red room again");
    let agent = page.state.bridge.as_ref().unwrap().base.state().agent;
    assert!(agent.x > 4 && agent.y < 4, "but to the green one: {agent:?}");
}

#[test]
fn a_robot_is_found_as_it_was_set_up() {
    let mut page = Page::open(false);
    assert_eq!(page.kept, None, "nothing was set up");
    page.act(Action::Pick(Kind::Real));
    page.act(Action::Address("ws://robot:9090".to_owned()));
    page.act(Action::Name(Topic::Velocity, "/turtle/cmd_vel".to_owned()));
    page.act(Action::Types(Some(2)));
    page.act(Action::World(1));
    page.act(Action::Name(Topic::Object(0), "/tracked/chair".to_owned()));
    page.act(Action::Speed(0.1));
    let agent = page.state.world.agent;
    let seen = Pose { x: 1.5, y: -2.0, heading: 0.3 };
    page.state.pilot.driver.calibration = Some(Calibration::here(0.4, &agent, seen));
    page.act(Action::Prefers(Default::default()));
    let mut next = Page::again(false, page.kept.clone());
    assert_eq!(next.state.wiring, page.state.wiring);
    assert_eq!((next.state.kind, next.state.address.as_str()), (Kind::Real, "ws://robot:9090"));
    assert_eq!((next.state.world.clone(), next.state.preset), (page.state.world.clone(), Some(1)));
    let place = |page: &Page| page.state.pilot.driver.calibration.unwrap().to_cells(seen);
    let (one, other) = (place(&next), place(&page));
    assert!(one.distance(other.x, other.y) < 1e-9 && (one.heading - other.heading).abs() < 1e-9);
    assert!(next.state.is_recalled, "which a person is told");
    assert_eq!((next.state.limits().speed, next.state.link), (0.1, Link::Off));
    assert_eq!(next.state.pilot.driver.stage, Stage::Off, "that it may be driven is not kept");
    next.act(Action::World(0));
    assert!(!next.state.is_recalled && next.state.pilot.driver.calibration.is_none());
    // What is none, and what comes when somebody has begun, changes nothing.
    let fresh = Page::open(false);
    let broken = [
        "{".to_owned(),
        page.kept.clone().unwrap().replace("robot 1", "robot 9"),
        page.kept.clone().unwrap().replace("\"turn\":[", "\"turn\":[0.0,0.0],\"turn\":["),
    ];
    for text in broken {
        let page = Page::again(false, Some(text));
        assert_eq!((page.state.kind, page.state.preset), (fresh.state.kind, fresh.state.preset));
    }
    let mut late = Page::open(false);
    late.act(Action::Address("ws://mine:9090".to_owned()));
    late.act(Action::Recalled(page.kept.clone()));
    assert_eq!(late.state.address, "ws://mine:9090");
}

#[test]
fn what_stops_the_robot_is_always_one_action() {
    for (action, is_halted) in [
        (Action::Stop, true),
        (Action::Hidden, true),
        (Action::Closing, false),
        (Action::Held(false), false),
        (Action::Link(false), false),
        (Action::Arm(false), false),
    ] {
        let mut page = Page::armed();
        page.act(Action::Typed("go to the blue room".to_owned()));
        page.act(Action::Ask);
        page.act(Action::Held(true));
        page.until(5_000.0, |state| state.bridge.as_ref().unwrap().base.twist.linear > 0.1);
        page.act(action.clone());
        let stage = &page.state.pilot.driver.stage;
        assert_eq!(matches!(stage, Stage::Halted(_)), is_halted, "{action:?}");
        assert_ne!(*stage, Stage::Driving, "{action:?}");
        page.until(300.0, |_| false);
        assert!(page.state.bridge.as_ref().is_none_or(|bridge| bridge.base.stands()), "{action:?}");
    }
}

#[test]
fn a_link_is_opened_to_what_was_typed_and_opened_again() {
    let mut page = Page::open(false);
    page.act(Action::Pick(Kind::Real));
    page.act(Action::Address(" ws://robot:9090 ".to_owned()));
    page.act(Action::Name(Topic::Velocity, "/turtle/cmd_vel".to_owned()));
    page.wanted.clear();
    page.act(Action::Link(true));
    assert_eq!(page.wanted, [Effect::Open("ws://robot:9090".to_owned())]);
    page.act(Action::Address("ws://other:9090".to_owned()));
    assert_eq!(page.state.address, " ws://robot:9090 ", "not while it is linked");
    page.wanted.clear();
    page.act(Action::LinkOpened);
    let asked = page.wanted.iter().filter(|effect| matches!(effect, Effect::Send(_)));
    assert_eq!(asked.count(), 2, "{:?}", page.wanted);
    assert!(format!("{:?}", page.wanted).contains("/turtle/cmd_vel"));
    page.wanted.clear();
    page.act(Action::LinkClosed);
    assert_eq!(page.wanted, [Effect::Again(1, 1_000)]);
    page.act(Action::LinkAgain(7));
    assert_eq!(page.state.link, Link::Lost(1), "a timer of another time");
    page.act(Action::LinkAgain(1));
    page.act(Action::LinkClosed);
    assert_eq!(page.wanted.last(), Some(&Effect::Again(2, 2_000)));
    page.act(Action::Link(false));
    assert_eq!((page.state.link, page.wanted.last()), (Link::Off, Some(&Effect::Close)));
    page.act(Action::LinkAgain(2));
    assert_eq!(page.state.link, Link::Off, "what was given up stays so");
}

#[test]
fn a_secure_page_says_what_its_browser_would_not_do() {
    for (typed, is_secure, wanted) in [
        ("ws://192.168.0.2:9090", true, Err(Fault::Mixed)),
        ("ws://192.168.0.2:9090", false, Ok(())),
        ("wss://192.168.0.2:9090", true, Ok(())),
        ("ws://localhost:9090", true, Ok(())),
        ("WS://127.0.0.1:9090/x", true, Ok(())),
        ("ws://[::1]:9090", true, Ok(())),
        ("ws://localhost.example:9090", true, Err(Fault::Mixed)),
        ("ws://user@robot:9090", true, Err(Fault::Mixed)),
        ("http://robot:9090", false, Err(Fault::NoSocket)),
        ("robot:9090", false, Err(Fault::NoSocket)),
        ("ws://", false, Err(Fault::NoSocket)),
        ("ws://a b", false, Err(Fault::NoSocket)),
        ("", false, Err(Fault::NoSocket)),
    ] {
        assert_eq!(address(typed, is_secure).map(drop), wanted, "{typed}");
    }
    let mut page = Page::open(true);
    page.act(Action::Pick(Kind::Real));
    page.act(Action::Address("ws://robot:9090".to_owned()));
    page.wanted.clear();
    page.act(Action::Link(true));
    assert_eq!((page.state.fault, page.state.link), (Some(Fault::Mixed), Link::Off));
    assert!(page.wanted.is_empty(), "{:?}", page.wanted);
}

#[test]
fn own_rooms_are_read_and_a_command_that_is_none_is_told() {
    let mut page = Page::armed();
    page.act(Action::Typed("dance a fandango".to_owned()));
    page.act(Action::Ask);
    assert!(page.state.said.as_ref().unwrap().plan.is_none());
    page.act(Action::Drawing("nonsense".to_owned()));
    page.act(Action::Draw);
    assert!(page.state.undrawn.is_some());
    let own = include_str!("../../../assets/worlds/hall.txt");
    page.act(Action::Drawing(own.to_owned()));
    page.act(Action::Draw);
    assert_eq!(
        (page.state.undrawn.clone(), page.state.preset, page.state.link),
        (None, None, Link::Off)
    );
    assert_eq!(page.state.world.objects.len(), 2);
    assert_eq!(page.state.pilot.driver.stage, Stage::Off, "nothing is driven in other rooms");
}

#[test]
fn the_engine_that_talks_is_found_in_the_front_page() {
    let built = r#"<link rel="modulepreload" data-app="script" href="./app-1.js"><link rel="preload" data-app="program" href="./app-1_bg.wasm" as="fetch">"#;
    assert_eq!(named(built), Some(("./app-1.js", "./app-1_bg.wasm")));
    let minified = "<link data-app=script href=./app-1.js rel=modulepreload><link as=fetch data-app=program href=./a.wasm>";
    assert_eq!(named(minified), Some(("./app-1.js", "./a.wasm")));
    assert_eq!(named("<link rel=icon href=icon.svg>"), None);
}
