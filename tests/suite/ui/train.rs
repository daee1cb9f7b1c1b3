//! The workbench, played without a browser: corpora, bad files, training.

use super::{model, pair};
use groundling::ui::page::document::{Model, Origin};
use groundling::ui::page::files::{Fault, Given, Offered};
use groundling::ui::page::news::News;
use groundling::ui::train::action::Tab;
use groundling::ui::train::data::action::{Care, Look, Map};
use groundling::ui::train::data::demo;
use groundling::ui::train::data::mapping::Column;
use groundling::ui::train::effect::Effect;
use groundling::ui::train::kept::ask::Ask;
use groundling::ui::train::run::action::{Number, Setting};
use groundling::ui::train::run::state::{Pace, can_train};
use groundling::ui::train::{Action, State, data, reduce, run};
use groundling::worker::protocol::{
    self, Checkpoint, Deed, Done, Envelope, Event, Fault as Flaw, FileReport, Lexicon, Line,
    Preview, Program, Progress, Request, SeedLexicon, Settings, SheetReport, Shown, Status,
    VERSION, Verdict, View, Window,
};
use std::rc::Rc;

/// A workbench and its engine's side of the talk: what was posted and not yet answered.
pub(super) struct Bench {
    pub(super) state: State,
    pub(super) posted: Vec<(u32, Request)>,
    pub(super) others: Vec<Effect>,
    /// What the store was asked for.
    pub(super) stored: Vec<Ask>,
}

impl Bench {
    /// A workbench that is to be seen, with a corpus of `rows` commands, and nothing at work.
    pub(super) fn with(rows: u32) -> Bench {
        let mut bench = Bench::new();
        bench.hear(0, Event::Ready);
        bench.answer(Event::Sheet(Box::new(report("six.csv", rows))));
        bench.settle(rows);
        bench.others.clear();
        bench
    }

    /// Answers what is asked besides, for a sheet of so many rows.
    pub(super) fn settle(&mut self, rows: u32) {
        while let Some(at) = self.posted.iter().position(|(_, request)| request.is_aside()) {
            let (id, request) = self.posted.remove(at);
            let event = match request {
                Request::Window { offset, count, .. } => {
                    let lines = (offset..rows.min(offset + count)).map(line).collect();
                    Event::Window(Box::new(Window { total: rows, offset, lines }))
                }
                Request::Facets => Event::Facets(Box::default()),
                Request::Decisions => Event::Decisions { text: "parted".to_owned() },
                Request::ShowRow { row } => {
                    Event::Row { row, pairs: vec![Shown { pair: pair(), run: None }] }
                }
                _ => Event::Heard,
            };
            self.hear(id, event);
        }
    }

    /// A workbench that has just come; its engine is not up yet.
    pub(super) fn new() -> Bench {
        let (posted, others, stored) = (Vec::new(), Vec::new(), Vec::new());
        let mut bench = Bench { state: State::default(), posted, others, stored };
        bench.act(Action::Shown(true));
        bench
    }

    pub(super) fn act(&mut self, action: Action) {
        for effect in reduce(&mut self.state, action) {
            match effect {
                Effect::Post(_, envelope) => self.posted.push((envelope.id, envelope.body)),
                Effect::Watch(..) | Effect::Ring(..) => {}
                Effect::Store(ask) => self.stored.push(ask),
                other => self.others.push(other),
            }
        }
    }

    pub(super) fn data(&mut self, action: data::Action) {
        self.act(Action::Data(action));
    }

    pub(super) fn run(&mut self, action: run::Action) {
        self.act(Action::Run(action));
    }

    pub(super) fn hear(&mut self, id: u32, body: Event) {
        self.act(Action::Heard(Program::Learner, Envelope { groundling: VERSION, id, body }));
    }

    /// Answers the request posted last.
    #[track_caller]
    pub(super) fn answer(&mut self, event: Event) {
        let (id, _) = self.posted.pop().expect("a request is at work");
        self.hear(id, event);
    }

    /// The request posted last.
    #[track_caller]
    pub(super) fn asked(&self) -> &Request {
        &self.posted.last().expect("a request is at work").1
    }

    fn can_train(&self) -> bool {
        can_train(&self.state.desk, self.state.data.commands())
    }

    fn notice(&self) -> Option<&str> {
        self.state.data.refused.as_ref().map(|notice| notice.message.as_str())
    }

    /// The run at work.
    #[track_caller]
    pub(super) fn live(&self) -> &run::state::Run {
        self.state.run.live().expect("a run is at work")
    }

    /// What the page was told, but for what is only said.
    pub(super) fn told(&self) -> Vec<&News> {
        let news = self.others.iter().filter_map(|effect| match effect {
            Effect::Tell(news) if !matches!(news, News::Say(_)) => Some(news),
            _ => None,
        });
        news.collect()
    }
}

pub(super) fn care(rows: u32) -> protocol::Care {
    protocol::Care { rows, train: rows, ..protocol::Care::default() }
}

pub(super) fn report(name: &str, rows: u32) -> SheetReport {
    let file = FileReport { name: name.to_owned(), rows, ..FileReport::default() };
    SheetReport { files: vec![file], care: care(rows), ..SheetReport::default() }
}

/// A report of a file that is of no use.
fn useless(name: &str, faults: Vec<Flaw>) -> SheetReport {
    let mut report = SheetReport { faults, ..report(name, 0) };
    report.files[0].useless = Some("it has no command".to_owned());
    report
}

fn line(row: u32) -> Line {
    Line {
        row,
        file: 0,
        line: u64::from(row) + 2,
        id: format!("line {}", row + 2),
        command: "go".to_owned(),
        task: None,
        worker: None,
        pairs: 1,
        decision: protocol::Decision::Open,
        half: protocol::Half::Train,
        outcome: None,
        form: None,
        marks: Vec::new(),
    }
}

pub(super) fn progress(epoch: u32, example: usize) -> Progress {
    Progress { epoch, epochs: 15, example, examples: 6, valid: 1, updates: 1, entries: 9 }
}

pub(super) fn file(name: &str, text: &str) -> Offered {
    Offered { name: name.to_owned(), bytes: Ok(text.into()) }
}

/// A file was dropped.
fn offered(name: &str, text: Result<&str, Fault>) -> data::Action {
    data::Action::Offered(vec![Offered { name: name.to_owned(), bytes: text.map(Into::into) }])
}

#[test]
fn it_opens_with_the_six_sentences_and_their_pictures() {
    let mut bench = Bench::new();
    assert!(bench.posted.is_empty(), "the engine that learns is only now loaded");
    assert_eq!(bench.others, [Effect::SpawnEngine(Program::Learner)]);
    bench.hear(0, Event::Ready);
    assert!(matches!(bench.asked(), Request::OpenSheet { files, .. } if files[0] == demo::file()));
    bench.answer(Event::Sheet(Box::new(report("six.csv", 6))));
    bench.settle(6);
    let sheet = bench.state.data.sheet.as_ref().expect("it is open");
    assert_eq!((sheet.pairs.len(), sheet.table.window.lines.len()), (6, 6));
    assert!(bench.can_train());
    bench.act(Action::Shown(false));
    bench.act(Action::Shown(true));
    assert!(bench.posted.is_empty(), "it is open already");
}

#[test]
fn only_the_rows_in_sight_are_asked_for_and_those_around_them() {
    let mut bench = Bench::with(100_000);
    let window = |bench: &Bench| {
        let table = &bench.state.data.sheet.as_ref().expect("it is open").table;
        (table.window.offset, table.window.lines.len(), table.drawn())
    };
    let (offset, count, drawn) = window(&bench);
    assert_eq!((offset, drawn.start), (0, 0));
    assert!(count < 300 && drawn.len() < 60, "{count} {drawn:?}");

    bench.data(data::Action::Look(Look::Scrolled(50_000, 20)));
    let Request::Window { offset, .. } = bench.asked() else { panic!() };
    assert!((49_900..50_000).contains(offset));
    // Scrolled further before the answer has come: that one is no longer wanted.
    bench.data(data::Action::Look(Look::Scrolled(90_000, 20)));
    bench.settle(100_000);
    let (offset, _, drawn) = window(&bench);
    assert!((89_900..90_000).contains(&offset), "{offset}");
    assert!(drawn.contains(&90_000) && drawn.len() < 60);
    bench.data(data::Action::Look(Look::Move(5)));
    bench.data(data::Action::Look(Look::End(true)));
    bench.settle(100_000);
    let table = &bench.state.data.sheet.as_ref().expect("it is open").table;
    assert_eq!(table.line(table.current).map(|line| line.row), Some(99_999));
}

#[test]
fn a_view_is_asked_for_anew_and_what_is_decided_touches_what_is_picked_or_in_view() {
    let mut bench = Bench::with(6);
    bench.data(data::Action::Look(Look::Status(Some(Status::Open))));
    let view = View { status: Some(Status::Open), ..View::default() };
    assert!(matches!(bench.asked(), Request::Window { view: asked, .. } if *asked == view));
    bench.settle(6);
    bench.data(data::Action::Care(Care::Reject("vague".to_owned())));
    let verdict = Verdict::Reject("vague".to_owned());
    assert_eq!(bench.asked(), &Request::DecideAll { view, verdict: verdict.clone() });
    let done = Some(Done { deed: Deed::Reject, rows: 6 });
    bench.answer(Event::Care(protocol::Care {
        revision: 1,
        rejected: 6,
        done,
        undo: done,
        ..care(6)
    }));
    let posted: Vec<&Request> = bench.posted.iter().map(|(_, request)| request).collect();
    assert!(posted.contains(&&Request::Facets), "{posted:?}");
    assert!(posted.iter().any(|request| matches!(request, Request::Window { .. })), "{posted:?}");
    bench.settle(6);

    bench.data(data::Action::Look(Look::Pick(2, true)));
    bench.data(data::Action::Look(Look::Pick(4, true)));
    bench.data(data::Action::Care(Care::Approve));
    assert_eq!(bench.asked(), &Request::Decide { rows: vec![2, 4], verdict: Verdict::Approve });
    bench.answer(Event::Care(care(6)));
    bench.settle(6);

    // An engine that begins anew is asked all of it again.
    bench.hear(0, Event::Crashed { message: "gone".to_owned() });
    bench.act(Action::RestartEngine(Program::Learner));
    bench.hear(0, Event::Ready);
    let Request::OpenSheet { .. } = bench.asked() else { panic!() };
    bench.answer(Event::Sheet(Box::new(report("six.csv", 6))));
    let again = |bench: &Bench| {
        bench.posted.iter().any(|(_, request)| matches!(request, Request::DecideAll { verdict: v, .. } if *v == verdict))
    };
    assert!(again(&bench), "{:?}", bench.posted);
}

#[test]
fn columns_are_mapped_by_hand_where_their_names_do_not_tell() {
    let mut bench = Bench::with(6);
    bench.data(offered("odd.csv", Ok("a,b,c")));
    bench.answer(Event::Sheet(Box::new(useless("odd.csv", Vec::new()))));
    assert!(bench.state.data.refused.as_ref().is_some_and(data::state::Refused::can_be_mapped));
    bench.data(data::Action::Map(Map::Begin));
    assert!(matches!(bench.asked(), Request::Preview { file } if file.name == "odd.csv"));
    let columns: Vec<String> = ["a", "b", "c"].map(str::to_owned).into();
    bench.answer(Event::Previewed(Box::new(Preview { columns, ..Preview::default() })));
    for (at, column) in [(0, Column::Command), (1, Column::Before(1)), (2, Column::After(1))] {
        let mapping = bench.state.data.columns.as_ref().expect("a mapping").mapping();
        assert!(!mapping.is_complete());
        bench.data(data::Action::Map(Map::Choose(at, column)));
    }
    bench.data(data::Action::Map(Map::Save));
    let Some(Effect::Save { text, .. }) = bench.others.last() else { panic!() };
    let saved = text.clone();
    bench.data(data::Action::Map(Map::Use));
    let Request::OpenSheet { files, .. } = bench.asked() else { panic!() };
    let mapping = files[0].mapping.clone();
    assert!(mapping.is_complete() && mapping.command.as_deref() == Some("a"));
    bench.answer(Event::Sheet(Box::new(report("odd.csv", 3))));
    bench.settle(3);
    assert_eq!(bench.state.data.columns, None);

    // A mapping that was saved holds for the files that are dropped with it.
    let all = vec![file("mapping.json", &saved), file("more.csv", "a,b,c")];
    bench.data(data::Action::Offered(all));
    let Request::OpenSheet { files, .. } = bench.asked() else { panic!() };
    assert_eq!((files.len(), &files[0].mapping), (1, &mapping));
}

#[test]
fn training_shows_its_progress_rests_and_can_be_stopped_and_gone_on_with() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Set(Setting::Number(Number::Epochs, 4.0)));
    bench.run(run::Action::Go);
    let (id, request) = bench.posted.last().cloned().expect("training was sent");
    let lexicon = Lexicon::Here(SeedLexicon::Demonstration);
    let settings = Box::new(Settings { epochs: 4, lexicon, ..Settings::default() });
    assert_eq!(request, Request::Learn { settings: settings.clone(), resume: None });
    bench.act(Action::Shown(false));
    bench.state.desk.clock = 5_000.0;
    bench.hear(id, Event::Progress(progress(1, 3)));
    assert_eq!(bench.live().progress, Some(progress(1, 3)), "it goes on unseen");
    assert!(!bench.can_train());
    assert_eq!(bench.asked(), &Request::Checkpoint, "what it may lose is some seconds");
    let text = "so far".to_owned();
    bench.answer(Event::Checkpoint(Checkpoint { text: text.clone(), epoch: 1, example: 3 }));

    bench.run(run::Action::Pause);
    assert_eq!(bench.asked(), &Request::Pause);
    bench.answer(Event::Heard);
    bench.hear(id, Event::Paused);
    assert_eq!(bench.live().pace, Pace::Rests);
    bench.settle(6);
    bench.run(run::Action::StepExample);
    assert_eq!(bench.posted.pop().map(|(_, request)| request), Some(Request::StepExample));
    bench.hear(id, Event::Progress(progress(1, 4)));
    bench.hear(id, Event::Paused);
    bench.settle(6);
    bench.run(run::Action::Go);
    assert_eq!(bench.posted.pop().map(|(_, request)| request), Some(Request::Resume));

    bench.run(run::Action::Stop);
    assert_eq!(bench.posted.pop(), Some((id, Request::Cancel)));
    bench.answer(Event::Cancelled);
    assert!(bench.state.run.notice.is_some() && bench.state.run.live().is_none());
    bench.settle(6);
    bench.run(run::Action::GoOn);
    assert_eq!(bench.asked(), &Request::Learn { settings, resume: Some(text) });
}

#[test]
fn a_step_is_one_of_training_and_of_nothing_else_that_is_at_work() {
    let mut bench = Bench::with(6);
    bench.state.desk.send(Request::TakeDecisions { text: "{}".to_owned() }, false);
    assert!(!bench.can_train());
    bench.run(run::Action::StepExample);
    assert!(bench.state.run.live().is_none(), "it would wait, and its step would be the other's");
    assert!(!bench.posted.iter().any(|(_, request)| *request == Request::StepExample));
}

#[test]
fn a_run_goes_on_in_a_new_engine_when_its_own_dies_but_not_for_ever() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Go);
    let (id, _) = bench.posted.last().cloned().expect("training was sent");
    bench.state.desk.clock = 9_000.0;
    bench.hear(id, Event::Progress(progress(2, 1)));
    bench.answer(Event::Checkpoint(Checkpoint { text: "so far".to_owned(), epoch: 2, example: 1 }));
    bench.posted.clear();
    bench.others.clear();
    bench.act(Action::EngineBroke(Program::Learner, "it was killed".to_owned()));
    assert!(bench.others.contains(&Effect::SpawnEngine(Program::Learner)), "a new one at once");
    bench.hear(0, Event::Ready);
    bench.answer(Event::Sheet(Box::new(report("six.csv", 6))));
    bench.settle(6);
    let Request::Learn { resume, .. } = bench.asked() else { panic!("{:?}", bench.posted) };
    assert_eq!(resume.as_deref(), Some("so far"));
    bench.others.clear();
    bench.act(Action::EngineBroke(Program::Learner, "it was killed again".to_owned()));
    assert!(!bench.others.contains(&Effect::SpawnEngine(Program::Learner)), "it did not get on");
    assert!(bench.state.run.live().is_none());
}

#[test]
fn a_trained_model_is_given_to_the_page() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Go);
    bench.answer(Event::Trained(model("trained here")));
    let news = News::Use { text: "trained here".to_owned(), corpus: "six.csv".to_owned() };
    assert_eq!(bench.told(), [&news]);
    bench.run(run::Action::SaveModel);
    bench.others.clear();
    let report = Rc::new(model("in use"));
    bench.act(Action::Uses(Model { report, origin: Origin::Shipped }));
    bench.run(run::Action::SaveModel);
    let name = "groundling.model".to_owned();
    assert_eq!(bench.others, [Effect::Save { name, text: "in use".to_owned() }]);
}

#[test]
fn a_bad_file_loses_nothing() {
    let mut bench = Bench::with(6);
    let before = bench.state.data.sheet.clone();
    let flaw = Flaw {
        file: 0,
        line: 3,
        column: None,
        what: "broken".to_owned(),
        snippet: None,
        mend: None,
        kept: false,
    };
    bench.act(Action::Turn(Tab::Run));
    bench.data(offered("bad.csv", Ok("x")));
    assert_eq!(bench.state.tab, Tab::Data, "what is said of files is said there");
    bench.answer(Event::Sheet(Box::new(useless("bad.csv", vec![flaw.clone()]))));
    assert_eq!(bench.state.data.sheet, before);
    let faults = bench.state.data.refused.as_ref().map(|refused| refused.faults.clone());
    assert_eq!(faults, Some(vec![flaw]));

    bench.data(offered("no.csv", Ok("x")));
    bench.answer(Event::Refused { message: "not a corpus".to_owned() });
    assert_eq!(bench.state.data.sheet, before);
    bench.data(offered("big.csv", Err(Fault::TooLarge)));
    assert!(bench.notice().is_some_and(|words| words.contains("big.csv is larger")));

    bench.data(offered("good.csv", Ok("y")));
    bench.answer(Event::Sheet(Box::new(report("good.csv", 200))));
    bench.settle(200);
    assert_eq!(bench.notice(), None);
    bench.data(data::Action::Look(Look::Open(7)));
    assert_eq!(bench.asked(), &Request::ShowRow { row: 7 });

    bench.run(run::Action::Go);
    bench.data(offered("other.csv", Ok("z")));
    assert!(bench.notice().is_some_and(|words| words.contains("Stop it first")));
}

#[test]
fn files_that_are_dropped_together_are_one_corpus() {
    let mut bench = Bench::with(6);
    let given = file("a.model", "\u{feff}groundling model");
    bench.data(data::Action::Offered(vec![file("a.csv", "x"), given, file("b.json", "y")]));
    let news = News::Give(Given::Model("groundling model".to_owned()));
    assert_eq!(bench.told(), [&news], "without its byte-order mark");
    let Request::OpenSheet { files, with_rejected: false } = bench.asked() else { panic!() };
    let names: Vec<&str> = files.iter().map(|one| one.file.name.as_str()).collect();
    assert_eq!(names, ["a.csv", "b.json"]);

    let too_large = Offered { name: "big.csv".to_owned(), bytes: Err(Fault::TooLarge) };
    bench.posted.clear();
    bench.data(data::Action::Offered(vec![file("a.csv", "x"), too_large]));
    assert!(bench.posted.is_empty(), "where one cannot be read, none is");
    let not_text = Offered { name: "a.model".to_owned(), bytes: Ok(b"groundling\n\xff".to_vec()) };
    bench.data(data::Action::Offered(vec![not_text]));
    assert!(bench.notice().is_some_and(|words| words.contains("first seen in line 2")));
}

#[test]
fn rejected_rows_are_used_when_a_person_says_so() {
    let mut bench = Bench::with(6);
    bench.data(data::Action::UseRejected);
    let asked = |bench: &Bench| match bench.asked() {
        Request::OpenSheet { with_rejected, .. } => *with_rejected,
        other => panic!("{other:?}"),
    };
    assert!(asked(&bench));
    bench.answer(Event::Sheet(Box::new(report("six.csv", 6))));
    bench.settle(6);
    bench.data(data::Action::UseRejected);
    assert!(!asked(&bench), "and left out again");
}

#[test]
fn reading_shows_how_far_it_is_and_can_be_stopped() {
    let mut bench = Bench::with(6);
    let before = bench.state.data.sheet.clone();
    bench.data(offered("long.csv", Ok("x")));
    let (id, _) = bench.posted.last().cloned().expect("it is being read");
    bench.hear(id, Event::Reading { done: 1, of: 4 });
    assert_eq!(bench.state.data.reading, Some((1, 4)));
    bench.data(data::Action::Stop);
    assert_eq!(bench.posted.pop(), Some((id, Request::Cancel)));
    bench.answer(Event::Cancelled);
    assert_eq!((bench.state.data.reading, &bench.state.data.sheet), (None, &before));
    assert!(bench.notice().is_some_and(|words| words.contains("stopped")));
}
