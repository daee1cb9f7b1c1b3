//! Talking: reading while typing, answering, playing, other readings, rules.

use super::{Page, failed, model, no_plan, plan, reading, understood, work, world};
use groundling::domain::{Lock, State as World};
use groundling::ui::app::Action;
use groundling::ui::page::effect::{Effect, Timer};
use groundling::ui::page::preferences::Depth;
use groundling::ui::talk;
use groundling::ui::talk::command::ask::is_asking;
use groundling::ui::talk::room::moved::Meant;
use groundling::ui::talk::room::point::{Point, PointKind};
use groundling::ui::talk::watch::playback::Surprise;
use groundling::ui::talk::watch::state::{Layer, Speed};
use groundling::ui::talk::watch::values::RUNS;
use groundling::ui::talk::why::help::Help;
use groundling::worker::protocol::{
    Event, Instead, PlanProgress, PlanText, Program, Request, Runs, ValueMap, WorldRules,
};

#[test]
fn what_is_typed_is_read_at_once_and_only_the_latest_counts() {
    let mut page = Page::ready();
    page.act(talk::Action::Typed("go".to_owned()));
    assert!(matches!(page.asked(), Request::Read { command, .. } if command == "go"));
    page.act(talk::Action::Typed("go to".to_owned()));
    page.act(talk::Action::Typed("go to it".to_owned()));
    assert_eq!(page.posted.len(), 1, "the engine is still at the first");
    page.answer(Event::Answer(Box::new(understood("go", None))));
    assert!(
        page.state.talk.command.live.is_none(),
        "an answer to what is no longer there is no answer"
    );
    assert!(matches!(page.asked(), Request::Read { command, .. } if command == "go to it"));
    page.answer(Event::Answer(Box::new(understood("go to it", None))));
    assert_eq!(page.heard().map(|answer| &*answer.command), Some("go to it"));
    assert!(page.state.shared.document.said.is_none() && !page.state.shared.history.can_undo());
    page.act(talk::Action::Typed(String::new()));
    assert!(page.heard().is_none());
}

#[test]
fn a_command_that_is_sent_early_is_asked_once_it_can_be() {
    let mut page = Page::new();
    let send = |page: &mut Page, command: &str| {
        page.act(talk::Action::Typed(command.to_owned()));
        page.act(talk::Action::Ask);
    };
    send(&mut page, "go");
    assert!(page.state.talk.command.early && page.posted.is_empty());
    // Who goes on typing has not sent that yet.
    page.act(talk::Action::Typed("go to it".to_owned()));
    assert!(!page.state.talk.command.early);
    send(&mut page, "go to it");
    page.hear(Program::Talker, 0, Event::Ready);
    // Without a model it waits on, and says so.
    page.act(Action::Fetched(Err("status 404".to_owned())));
    assert!(!page.state.shared.can_ask_soon());
    page.act(talk::Action::FetchModel);
    page.act(Action::Fetched(Ok("the model".to_owned())));
    page.answer(Event::Opened(model("the model")));
    assert!(page.posted.iter().any(
        |(_, _, request)| matches!(request, Request::Ask { command, .. } if command == "go to it")
    ));
}

#[test]
fn a_command_becomes_a_plan_that_plays_to_its_end() {
    let start = world();
    let mut page = Page::told(3);
    assert_eq!(page.shown(), &start);
    let mut rung = 0;
    while page.play_on() {
        rung += 1;
    }
    assert_eq!(rung, 3);
    assert_eq!(page.shown().agent.x, start.agent.x + 3);
    assert!(page.state.shared.announcement.starts_with("Done in 3 steps."));

    // The next command is said where the robot stands now; undo goes back a command at a time.
    page.act(talk::Action::Ask);
    let Request::Ask { state, .. } = page.asked() else { panic!() };
    assert_eq!(state.agent.x, start.agent.x + 3);
    page.answer(Event::Answer(Box::new(failed("go", "no_parse"))));
    assert!(page.state.shared.document.reading().is_none());
    page.act(Action::Undo);
    assert!(page.state.shared.document.reading().is_some());
    page.act(Action::Undo);
    assert_eq!(page.shown(), &start);
    assert!(!page.state.shared.history.can_undo());
    page.act(Action::Redo);
    assert_eq!(page.shown().agent.x, start.agent.x + 3);
    assert_eq!(page.state.talk.command.input, "go");
}

#[test]
fn a_plan_can_be_paused_stepped_scrubbed_and_hurried() {
    let start = world();
    let mut page = Page::told(4);
    page.act(talk::Action::TogglePlay);
    page.play_on();
    assert_eq!(page.shown(), &start, "a timer from before the pause moves nothing");
    page.act(talk::Action::Seek(3));
    assert_eq!(page.shown().agent.x, start.agent.x + 3);
    assert!(page.state.shared.announcement.starts_with("Step 3 of 4: east"));
    page.act(talk::Action::Seek(99));
    page.act(talk::Action::TogglePlay);
    assert_eq!(page.shown(), &start, "played again from the start");
    page.timers.clear();
    page.act(talk::Action::SetSpeed(Speed::Fourfold));
    assert!(matches!(page.timers.as_slice(), [Timer::Play(_)]), "the next step comes sooner");
    page.act(talk::Action::ResetWorld);
    assert!(page.state.talk.watch.playback.is_none());
    assert_eq!(page.shown(), &start);
}

#[test]
fn a_plan_that_may_be_too_long_is_walked_while_a_shorter_way_on_is_looked_for() {
    let start = world();
    let open = |from: &World, steps: i32| PlanText {
        reason: Some("budget".to_owned()),
        work: Some(PlanProgress { least: 15, ..work() }),
        ..plan(from, steps)
    };
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    page.answer(Event::Answer(Box::new(understood("go", Some(open(&start, 30))))));
    let ahead = |page: &mut Page| {
        assert!(page.play_on());
        let Request::GoOn { run, .. } = page.asked() else { panic!() };
        assert!(!is_asking(&page.state.shared), "nobody waits for it");
        assert_eq!(run.first(), Some(&world()), "since it was said");
        run.last().unwrap().clone()
    };
    let from = ahead(&mut page);
    assert_eq!(from.agent.x, start.agent.x + 11, "so much is walked meanwhile");
    // What is no shorter changes nothing; the next time it begins further on.
    page.answer(Event::Planned(Box::new(open(&from, 19))));
    let from = ahead(&mut page);
    assert_eq!(from.agent.x, start.agent.x + 12);
    page.answer(Event::Planned(Box::new(plan(&from, 5))));
    let document = &page.state.shared.document;
    assert_eq!(document.plan().map(|plan| plan.actions.len()), Some(17));
    assert_eq!(document.world.agent.x, start.agent.x + 17);
    assert_eq!(document.plan().and_then(|plan| plan.over()), Some(14));
    while page.play_on() {}
    assert!(page.posted.is_empty(), "what is proved is not looked for again");
    assert!(page.state.shared.announcement.starts_with("Done in 17 steps."));

    // Whoever does something else does not wait for it.
    page.act(talk::Action::AskExample("go".to_owned()));
    let start = page.shown().clone();
    page.answer(Event::Answer(Box::new(understood("go", Some(open(&start, 30))))));
    assert!(page.play_on());
    assert!(matches!(page.asked(), Request::GoOn { .. }));
    page.act(talk::Action::Typed("stop".to_owned()));
    assert!(matches!(page.posted.last(), Some((_, _, Request::Cancel))));
}

#[test]
fn another_reading_is_planned_for_from_where_the_command_was_said() {
    let start = world();
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    let mut answer = understood("go", Some(plan(&start, 2)));
    answer.readings.push(reading("(g:t)"));
    page.answer(Event::Answer(Box::new(answer)));
    while page.play_on() {}
    page.act(talk::Action::Choose(7));
    assert!(page.posted.is_empty(), "there is no such reading");
    page.act(talk::Action::Choose(1));
    let Request::Plan { form, run, .. } = page.asked() else { panic!() };
    assert_eq!((form.as_str(), &run[..]), ("(g:t)", std::slice::from_ref(&start)));
    page.answer(Event::Planned(Box::new(plan(&start, 1))));
    while page.play_on() {}
    assert_eq!(page.shown().agent.x, start.agent.x + 1);
    page.act(Action::Undo);
    assert_eq!(page.state.shared.document.said.as_ref().map(|said| said.chosen), Some(0));
    assert_eq!(page.shown().agent.x, start.agent.x + 2);
}

#[test]
fn other_rules_plan_anew_and_are_undone_like_all_else() {
    let start = world();
    let mut page = Page::told(2);
    let rules = WorldRules { pull: true, slip: 0.1, ..WorldRules::default() };
    page.act(talk::Action::SetRules(rules));
    assert!(matches!(page.asked(), Request::Plan { run, rules: asked, .. }
        if *run == [start.clone()] && *asked == rules));
    page.answer(Event::Planned(Box::new(no_plan("unreachable"))));
    assert_eq!(
        page.state.shared.document.plan().and_then(|p| p.reason.clone()).as_deref(),
        Some("unreachable")
    );
    page.act(Action::Undo);
    assert_eq!(page.state.shared.document.rules, WorldRules::default());
}

#[test]
fn values_are_asked_for_when_they_are_to_be_seen_and_once_for_each_arrangement() {
    let mut page = Page::told(3);
    assert!(page.posted.is_empty(), "nobody looks");
    page.act(Action::Deepen(Depth::See));
    assert!(matches!(page.asked(), Request::Values { .. }));
    page.answer(Event::Values(ValueMap { cells: Vec::new() }));
    while page.play_on() {}
    assert!(page.posted.is_empty(), "only the robot moved: the values are the same");
    for layer in [Layer::Values, Layer::Arrows] {
        page.act(talk::Action::ToggleLayer(layer));
    }
    page.act(talk::Action::AskExample("go".to_owned()));
    let again = plan(page.shown(), 1);
    page.answer(Event::Answer(Box::new(understood("go", Some(again)))));
    assert!(page.posted.is_empty(), "nobody looks any more");
}

#[test]
fn a_policy_is_tried_many_times() {
    let mut page = Page::told(1);
    page.act(talk::Action::TryMany);
    assert_eq!(page.asked(), &Request::RollOut { runs: RUNS, seed: 0 });
    let runs = Runs {
        runs: 10,
        successes: 9,
        interval: [0.6, 0.98],
        mean_steps: Some(4.0),
        mean_return: [0.8, 0.1],
        replans: 2,
    };
    let (program, id, _) = page.posted.last().cloned().expect("it is at work");
    page.hear(program, id, Event::RollingOut(Runs { runs: 5, ..runs }));
    assert_eq!(page.state.talk.watch.runs.map(|runs| runs.runs), Some(5));
    page.answer(Event::RolledOut(runs));
    assert!(page.state.shared.announcement.starts_with("9 of 10 runs got there: 90 % [60, 98]"));
}

#[test]
fn a_planner_can_be_stopped() {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    assert!(is_asking(&page.state.shared));
    page.act(talk::Action::StopPlanning);
    let (program, id, request) = page.posted.pop().expect("it was told");
    assert_eq!(request, Request::Cancel);
    page.hear(program, id, Event::Cancelled);
    assert!(!is_asking(&page.state.shared) && page.state.talk.command.notice.is_some());
}

#[test]
fn what_nobody_expected_is_told() {
    let mut start = world();
    start.doors[0].lock = Lock::Unknown;
    let mut locked = start.clone();
    locked.doors[0].lock = Lock::Locked;
    let walk = |states: Vec<_>| PlanText {
        actions: vec!["east".to_owned(); states.len() - 1],
        states,
        ..plan(&start, 0)
    };
    let moved = plan(&start, 1).states[1].clone();
    let turned = {
        let mut turned = moved.clone();
        turned.agent.direction = turned.agent.direction.left();
        turned
    };
    for (states, wanted) in [
        (vec![start.clone(), locked], Some(Surprise::DoorLocked)),
        (vec![start.clone(), start.clone()], Some(Surprise::Slipped)),
        (vec![moved.clone(), turned], Some(Surprise::LeftBehind)),
        (vec![start.clone(), moved], None),
    ] {
        let mut playback =
            groundling::ui::talk::watch::playback::Playback::begin(&walk(states)).unwrap();
        assert_eq!(playback.surprise(), None, "nothing has happened yet");
        playback.seek(1);
        assert_eq!(playback.surprise(), wanted);
    }
}

#[test]
fn studies_are_asked_for_by_those_who_study() {
    let mut page = Page::told(1);
    page.act(Action::Deepen(Depth::Study));
    let explain = |page: &Page| {
        page.posted.iter().any(|(.., request)| matches!(request, Request::Explain { .. }))
            || page.state.shared.talker.is_at(|request| matches!(request, Request::Explain { .. }))
    };
    assert!(explain(&page));
    assert!(!page.others.iter().any(|effect| matches!(effect, Effect::FetchModel)));
}

/// A page that was told a task over time of so many steps to the east.
fn timed(steps: i32) -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    let done = (0..=steps).map(|at| u8::from(at > 1)).collect();
    let plan = PlanText { done, ..plan(&world(), steps) };
    page.answer(Event::Answer(Box::new(understood("go", Some(plan)))));
    page
}

/// Takes the robot to a cell while it is on its way, and says that the world is to be so.
fn carry(page: &mut Page, cell: (i32, i32)) {
    let robot = (page.shown().agent.x, page.shown().agent.y);
    for (kind, cell) in [(PointKind::Down, robot), (PointKind::Move, cell), (PointKind::Up, cell)] {
        let (x, y) = (cell.0 as f32, cell.1 as f32);
        page.act(talk::Action::Point(Point { kind, x, y, cell }));
    }
    page.act(talk::Action::Mean(Meant::World));
}

#[test]
fn a_task_over_time_goes_on_where_the_robot_was_carried_or_asks() {
    let mut page = timed(3);
    assert!(page.play_on());
    carry(&mut page, (6, 6));
    let Request::Plan { run, .. } = page.asked() else { panic!() };
    let robots: Vec<(i32, i32)> = run.iter().map(|one| (one.agent.x, one.agent.y)).collect();
    assert_eq!(robots, [(6, 2), (7, 2), (6, 6)], "all that was since it was said");
    let instead = Some(Box::new(Instead { demands: Vec::new(), reading: reading("(h:p)") }));
    let broken = PlanText { instead, ..no_plan("broken") };
    page.answer(Event::Planned(Box::new(broken)));
    let kinds: Vec<&str> = page.messages().iter().map(|message| message.kind).collect();
    assert_eq!(kinds, ["broken"]);
    page.act(talk::Action::Help(Help::Instead(Vec::new(), true)));
    let Request::Plan { form, run, .. } = page.asked() else { panic!() };
    assert_eq!((&**form, run.len(), run[0].agent.x), ("(h:p)", 1, 6), "from where it is");

    // A task that is done is not gone on with.
    let mut page = timed(3);
    while page.play_on() {}
    carry(&mut page, (6, 6));
    assert!(page.state.shared.document.said.is_none());
}

/// Looks for the command to try that is asked for next: the answer to it names its kind.
fn look(page: &mut Page) {
    let Request::Example { wanted, .. } = page.asked().clone() else {
        panic!("{:?}", page.asked())
    };
    let command = Some(format!("{wanted:?}"));
    page.answer(Event::Example { wanted, command });
}

#[test]
fn commands_to_try_are_those_of_the_room_that_is_there() {
    let mut page = Page::ready();
    let rest = |page: &mut Page| {
        let timer = page.timers.iter().copied().rfind(|one| matches!(one, Timer::Examples(_)));
        page.act(Action::Rang(timer.expect("the room is waited for")));
    };
    rest(&mut page);
    while page.state.talk.command_examples.is_behind {
        look(&mut page);
    }
    let found = |page: &Page| page.state.talk.command_examples.found.iter().flatten().count();
    let before = found(&page);
    assert!(before > 3, "{before}");
    // The room changes while the engine looks for the third, and comes to rest before that is answered.
    page.act(talk::Action::PickWorld(1));
    rest(&mut page);
    look(&mut page);
    look(&mut page);
    let late = page.asked().clone();
    page.act(talk::Action::PickWorld(2));
    rest(&mut page);
    assert_eq!(page.asked(), &late, "the engine is still at it");
    look(&mut page);
    assert!(page.state.talk.command_examples.is_behind, "that was for another room");
    assert_eq!(found(&page), before, "and nothing is half there");
    while page.state.talk.command_examples.is_behind {
        look(&mut page);
    }
    assert_eq!(found(&page), before);
    assert!(page.posted.is_empty(), "{:?}", page.posted);
}
