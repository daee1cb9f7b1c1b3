//! What comes back to the workbench behind a reload: a run that is over with its rows and what was learned, and what
//! experiments found. And engines that share out what a model is asked.

use super::model;
use super::shelf::{begun, item};
use super::train::{Bench, care, file, report};
use groundling::ui::page::engine::Errand;
use groundling::ui::page::keep::ask::Place;
use groundling::ui::page::news::News;
use groundling::ui::train::action::Tab;
use groundling::ui::train::effect::Effect;
use groundling::ui::train::experiments::pool::Said;
use groundling::ui::train::kept::ask::{self, Ask};
use groundling::ui::train::run::state::Pace;
use groundling::ui::train::{Action, data, experiments, kept, lexicon};
use groundling::worker::protocol::{
    Answered, Checkpoint, EntryWindow, Event, Joined, Outcome, Request, Split,
};

/// A request that was posted and waits for an answer.
#[track_caller]
fn posted(bench: &mut Bench, wanted: impl Fn(&Request) -> bool) -> u32 {
    let at = bench.posted.iter().position(|(_, request)| wanted(request));
    bench.posted.remove(at.unwrap_or_else(|| panic!("{:?}", bench.posted))).0
}

/// What is kept at a place.
type Kept = (Place, Vec<u8>);

/// A run that has ended, and is kept with its corpus.
fn ended() -> (Bench, Kept, Kept) {
    let mut bench = Bench::with(6);
    bench.data(data::Action::Offered(vec![file("mine.csv", "x")]));
    bench.answer(Event::Sheet(Box::new(report("mine.csv", 6))));
    bench.settle(6);
    bench.shelf(Vec::new());
    let id = begun(&mut bench);
    bench.state.kept.came_back = Some("it goes on".to_owned());
    bench.hear(id, Event::Trained(model("trained here")));
    assert_eq!(bench.state.kept.came_back, None, "that it goes on is not told any more");
    let id = posted(&mut bench, |request| *request == Request::Checkpoint);
    let end = Checkpoint { text: "the end".to_owned(), epoch: 15, example: 6 };
    let written = [bench.written("corpus"), bench.written("run")];
    let items = written.iter().map(|(place, _)| item(&place.kind, &place.name));
    bench.store(ask::News::List(items.collect()));
    written.iter().for_each(|(place, _)| bench.store(ask::News::Written(place.clone())));
    bench.hear(id, Event::Checkpoint(end));
    let [corpus, (place, _)] = written;
    // Nothing is written over what is being written.
    bench.store(ask::News::Written(place.clone()));
    let run = bench.written("run");
    bench.store(ask::News::Written(place));
    (bench, corpus, run)
}

/// A workbench that opens where this is kept.
fn again(corpus: &Kept, run: &Kept) -> Bench {
    let mut again = Bench::with(6);
    again.store(ask::News::Open);
    again.store(ask::News::Claimed(true));
    again.store(ask::News::List(vec![item("run", &run.0.name), item("corpus", &corpus.0.name)]));
    again.store(ask::News::Read(run.0.clone(), Some((run.1.clone(), false))));
    again
}

#[test]
fn a_run_that_is_over_comes_back_with_its_rows_and_what_was_learned() {
    let (mut bench, corpus, _) = ended();
    // What is decided of the rows since then is kept with it.
    bench.data(data::Action::Care(data::action::Care::Divide(Split::None)));
    let id = posted(&mut bench, |request| matches!(request, Request::Divide { .. }));
    bench.hear(id, Event::Care(care(6)));
    let id = posted(&mut bench, |request| *request == Request::Decisions);
    bench.hear(id, Event::Decisions { text: "parted".to_owned() });
    let run = bench.written("run");

    let mut again = again(&corpus, &run);
    again.store(ask::News::Read(corpus.0, Some((corpus.1, false))));
    let id = posted(&mut again, |request| matches!(request, Request::OpenSheet { .. }));
    again.hear(id, Event::Sheet(Box::new(report("mine.csv", 6))));
    let taken = Request::TakeDecisions { text: "parted".to_owned() };
    let id = posted(&mut again, |request| *request == taken);
    again.hear(id, Event::Care(care(6)));
    let id = posted(&mut again, |request| match request {
        Request::Recall { decisions, checkpoint, .. } => {
            decisions == "decided so" && checkpoint == "the end"
        }
        _ => false,
    });
    again.act(Action::Turn(Tab::Lexicon));
    again.settle(6);
    again.hear(id, Event::Trained(model("trained here")));
    assert!(matches!(again.asked(), Request::Entries { .. }), "what was learned is looked at");
    let back = again.state.run.run.as_ref().expect("it is there");
    assert_eq!((back.pace, back.model.as_deref()), (Pace::Over, Some("trained here")));
    assert_eq!(again.state.data.sheet.as_ref().map(|sheet| &*sheet.name), Some("mine.csv"));
    assert!(again.told().is_empty(), "what the robot uses the page knows");
}

#[test]
fn a_run_that_a_person_deletes_is_not_kept_again_by_itself() {
    let (mut bench, _, run) = ended();
    bench.stored.clear();
    bench.act(Action::Kept(kept::Action::Delete(run.0.clone())));
    bench.store(ask::News::Deleted(run.0));
    let writes = |bench: &Bench| bench.stored.iter().any(|ask| matches!(ask, Ask::Write(..)));
    assert!(!writes(&bench), "{:?}", bench.stored);
    // It is seen still; the next one may have its name.
    assert!(bench.state.run.run.is_some());
    begun(&mut bench);
    assert!(writes(&bench));
}

#[test]
fn a_run_whose_corpus_is_gone_says_so_and_one_that_a_person_opens_gives_the_robot_its_model() {
    let (_, corpus, run) = ended();
    let mut bench = again(&corpus, &run);
    bench.store(ask::News::Read(corpus.0.clone(), None));
    let said = bench.state.kept.notice.clone().unwrap_or_default();
    assert!(said.contains("is not kept any more"), "{said}");
    assert_eq!(bench.state.run.run.as_ref().map(|run| run.pace), Some(Pace::Over));

    bench.act(Action::Kept(kept::Action::Open(run.0.clone())));
    bench.store(ask::News::Read(run.0, Some((run.1, false))));
    bench.store(ask::News::Read(corpus.0, Some((corpus.1, false))));
    assert_eq!(bench.state.tab, Tab::Run);
    assert!(matches!(bench.told()[..], [News::Use { text, .. }] if text == "trained here"));
}

#[test]
fn where_nothing_was_learned_the_robots_lexicon_is_seen() {
    let mut bench = Bench::with(6);
    let shipped = |text: &str| {
        let origin = groundling::ui::page::document::Origin::Shipped;
        let report = std::rc::Rc::new(model(text));
        Action::Uses(groundling::ui::page::document::Model { report, origin })
    };
    bench.act(shipped("shipped"));
    bench.act(Action::Lexicon(lexicon::Action::Page(0)));
    bench.answer(Event::Refused { message: "no model".to_owned() });
    assert_eq!(bench.asked(), &Request::KeepModel { text: "shipped".to_owned() });
    bench.answer(Event::Heard);
    assert!(matches!(bench.asked(), Request::Entries { .. }));
    bench.answer(Event::Entries(Box::new(EntryWindow { total: 3, ..EntryWindow::default() })));
    assert_eq!(bench.state.lexicon.notice, None);
    bench.act(shipped("another"));
    assert_eq!(bench.asked(), &Request::KeepModel { text: "another".to_owned() });
}

#[test]
fn what_experiments_found_is_kept_seen_again_and_deleted() {
    let joined = Joined {
        runs: Vec::new(),
        all: None,
        csv: "csv".to_owned(),
        markdown: "report".to_owned(),
        results: "all".to_owned(),
    };
    let mut bench = Bench::with(6);
    bench.shelf(Vec::new());
    bench.act(Action::Experiments(experiments::Action::Go));
    let plan = r#"{"name":"5 folds","runs":[{"settings":SETTINGS}]}"#;
    let settings = serde_json::to_string(&bench.state.run.settings).unwrap();
    let plan = plan.replace("SETTINGS", &settings);
    bench.answer(Event::Plan { text: plan.clone() });
    bench.pool_says(0, 0, Event::Ready);
    bench.pool_says(0, 1, Event::Sheet(Box::new(report("six.csv", 6))));
    bench.pool_says(0, 2, Event::Shard { text: "found".to_owned() });
    bench.answer(Event::Joined(Box::new(joined)));
    let (place, bytes) = bench.written("experiment");
    assert_eq!(place.name, "5 folds, 1");
    bench.store(ask::News::Written(place.clone()));
    assert!(bench.state.kept.notice.as_deref().is_some_and(|said| said.contains("5 folds, 1")));

    let mut again = Bench::with(6);
    again.shelf(vec![item("experiment", &place.name)]);
    again.store(ask::News::Read(place.clone(), Some((bytes.clone(), false))));
    let [found] = &again.state.experiments.results[..] else { panic!() };
    assert_eq!((&found.plan, &*found.joined.markdown), (&plan, "report"));
    assert_eq!((&*found.about.name, found.about.runs.len()), ("5 folds", 1));
    assert!(again.stored.is_empty(), "it is not kept once more: {:?}", again.stored);
    // As a file of its own it is kept under a name that is free.
    again.data(data::Action::Offered(vec![file("x.json", &String::from_utf8(bytes).unwrap())]));
    assert_eq!((again.state.tab, again.state.experiments.results.len()), (Tab::Experiments, 2));
    assert_eq!(again.written("experiment").0.name, "5 folds, 2");
    again.act(Action::Experiments(experiments::Action::Forget(1)));
    assert_eq!(again.stored.last(), Some(&Ask::Delete(place)));
    assert_eq!(again.state.experiments.results.len(), 1);
    // Deleted among all that is kept, it is not seen any more.
    let second = again.written("experiment").0;
    again.store(ask::News::Written(second.clone()));
    again.act(Action::Kept(kept::Action::Delete(second.clone())));
    again.store(ask::News::Deleted(second));
    assert!(again.state.experiments.results.is_empty());
    again.data(data::Action::Offered(vec![file(
        "y.json",
        r#"{"format":"groundling experiment","version":1}"#,
    )]));
    assert!(again.state.kept.notice.as_deref().is_some_and(|said| said.contains("y")));
}

#[test]
fn engines_share_out_what_a_model_is_asked_and_one_goes_on_alone_where_they_cannot() {
    let ask = || Action::Data(data::Action::Care(data::action::Care::Audit));
    let mut bench = Bench::with(500);
    let origin = groundling::ui::page::document::Origin::Shipped;
    let report_of = std::rc::Rc::new(model("shipped"));
    bench.act(Action::Uses(groundling::ui::page::document::Model { report: report_of, origin }));
    bench.act(ask());
    assert!(matches!(bench.asked(), Request::Audit { known, .. } if known.is_empty()), "one core");
    bench.answer(Event::Care(care(500)));
    bench.settle(500);

    bench.act(Action::Cores(2));
    bench.act(ask());
    assert_eq!(bench.state.data.auditing, Some((0, 500)));
    for seat in 0..2 {
        bench.pool_says(seat, 0, Event::Ready);
        bench.pool_says(seat, 1, Event::Sheet(Box::new(report("six.csv", 500))));
    }
    let parts: Vec<u32> = bench
        .sent()
        .into_iter()
        .filter_map(|(_, _, request)| match request {
            Request::AskPart { part, of: 12, .. } => Some(part),
            _ => None,
        })
        .collect();
    assert_eq!(parts, [0, 1]);
    bench.pool_says(0, 2, Event::Auditing { done: 9, of: 40 });
    assert_eq!(bench.state.data.auditing, Some((9, 500)));
    let answered = |command| Answered {
        command,
        rows: vec![(command, Outcome::Right)],
        ..Answered::default()
    };
    for part in 0..11 {
        bench.pool_says(0, 2 + part, Event::Answered { commands: vec![answered(part)] });
    }
    assert!(bench.posted.is_empty(), "the second engine is still at its part");
    bench.pool_says(1, 2, Event::Answered { commands: vec![answered(11)] });
    let Request::Audit { known, .. } = bench.asked() else { panic!("{:?}", bench.posted) };
    assert_eq!(known.len(), 12);
    assert!(bench.others.contains(&Effect::EndPool));
    bench.answer(Event::Care(care(500)));
    assert_eq!(bench.state.data.auditing, None);
    bench.settle(500);

    // An engine that dies twice is given up; the engine of the data asks alone.
    bench.act(ask());
    for _ in 0..2 {
        bench.pool(0, Said::Broke("killed".to_owned()));
    }
    assert!(matches!(bench.asked(), Request::Audit { known, .. } if known.is_empty()));
    bench.answer(Event::Care(care(500)));
    bench.settle(500);
    bench.act(ask());
    bench.data(data::Action::Stop);
    assert_eq!((bench.state.data.auditing, bench.state.experiments.pool.is_none()), (None, true));
    let spawned = |effect: &&Effect| matches!(effect, Effect::Pool(_, Errand::Spawn(_)));
    assert!(bench.others.iter().filter(spawned).count() >= 4);
}

#[test]
fn an_experiment_that_was_at_work_when_the_page_was_left_is_told_to_be_lost() {
    let mut bench = Bench::with(6);
    bench.shelf(Vec::new());
    bench.act(Action::Experiments(experiments::Action::Go));
    let settings = serde_json::to_string(&bench.state.run.settings).unwrap();
    let plan = format!(r#"{{"name":"5 folds","runs":[{{"settings":{settings}}}]}}"#);
    bench.answer(Event::Plan { text: plan });
    let (place, bytes) = bench.written("experiment");
    bench.store(ask::News::Written(place.clone()));
    assert_eq!(bench.state.kept.notice, None, "that it is at work is no news");
    // Asked for while it is at work, it goes on.
    bench.act(Action::Kept(kept::Action::Open(place.clone())));
    bench.store(ask::News::Read(place.clone(), Some((bytes.clone(), false))));
    assert_eq!(bench.state.experiments.notice, None);

    let mut again = Bench::with(6);
    again.shelf(vec![item("experiment", &place.name)]);
    again.store(ask::News::Read(place.clone(), Some((bytes, false))));
    let said = again.state.experiments.notice.clone().unwrap_or_default();
    assert!(said.contains("5 folds") && said.contains("lost"), "{said}");
    assert_eq!(again.stored.last(), Some(&Ask::Delete(place.clone())));
    // One that is stopped is not kept any longer.
    bench.act(Action::Experiments(experiments::Action::Stop));
    assert_eq!(bench.stored.last(), Some(&Ask::Delete(place)));
}
