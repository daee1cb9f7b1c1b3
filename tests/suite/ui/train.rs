//! The workbench, played without a browser: corpora, bad files, training.

use super::{model, pair};
use groundling::ui::page::document::{Model, Origin};
use groundling::ui::page::files::{self, Fault, Given, Kind, Offered};
use groundling::ui::page::news::News;
use groundling::ui::train::data::corpus::{DEMO, PAGE};
use groundling::ui::train::effect::Effect;
use groundling::ui::train::run::state::{SETTINGS, can_train};
use groundling::ui::train::{Action, State, data, reduce, run};
use groundling::worker::protocol::{
    CorpusReport, Envelope, Event, Problem, Program, Progress, Request, RowSummary, SeedLexicon,
    VERSION,
};
use std::rc::Rc;

/// A workbench and its engine's side of the talk: what was posted and not yet answered.
struct Bench {
    state: State,
    posted: Vec<(u32, Request)>,
    others: Vec<Effect>,
}

impl Bench {
    /// A workbench that is to be seen, with a corpus of `rows` commands, and nothing at work.
    fn with(rows: usize) -> Bench {
        let mut bench = Bench::new();
        bench.hear(0, Event::Ready);
        bench.answer(Event::Corpus(report("six.csv", rows)));
        while let Some((_, Request::ShowRow { row })) = bench.posted.last() {
            let row = *row;
            bench.answer(Event::Row { row, pairs: vec![pair()] });
        }
        bench.others.clear();
        bench
    }

    /// A workbench that has just come; its engine is not up yet.
    fn new() -> Bench {
        let mut bench = Bench { state: State::default(), posted: Vec::new(), others: Vec::new() };
        bench.act(Action::Shown(true));
        bench
    }

    fn act(&mut self, action: Action) {
        for effect in reduce(&mut self.state, action) {
            match effect {
                Effect::Post(_, envelope) => self.posted.push((envelope.id, envelope.body)),
                Effect::Watch(..) => {}
                other => self.others.push(other),
            }
        }
    }

    fn data(&mut self, action: data::Action) {
        self.act(Action::Data(action));
    }

    fn run(&mut self, action: run::Action) {
        self.act(Action::Run(action));
    }

    fn hear(&mut self, id: u32, body: Event) {
        self.act(Action::Heard(Program::Learner, Envelope { groundling: VERSION, id, body }));
    }

    /// Answers the request posted last.
    #[track_caller]
    fn answer(&mut self, event: Event) {
        let (id, _) = self.posted.pop().expect("a request is at work");
        self.hear(id, event);
    }

    /// The request posted last.
    #[track_caller]
    fn asked(&self) -> &Request {
        &self.posted.last().expect("a request is at work").1
    }

    fn can_train(&self) -> bool {
        can_train(&self.state.desk, self.state.data.commands())
    }

    fn notice(&self) -> Option<&str> {
        self.state.data.file_notice.as_ref().map(|notice| notice.message.as_str())
    }

    /// What the page was told, but for what is only said.
    fn told(&self) -> Vec<&News> {
        let news = self.others.iter().filter_map(|effect| match effect {
            Effect::Tell(News::Say(_)) => None,
            Effect::Tell(news) => Some(news),
            _ => None,
        });
        news.collect()
    }
}

fn report(name: &str, rows: usize) -> CorpusReport {
    let row = RowSummary { command: "go".to_owned(), task: None, pairs: 1 };
    CorpusReport {
        name: name.to_owned(),
        rows: vec![row; rows],
        rejected: 0,
        left_out: 0,
        problems: Vec::new(),
    }
}

fn file(name: &str, text: &str) -> Offered {
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
    assert!(
        matches!(bench.asked(), Request::ReadCorpus { files, .. } if files[0].bytes == DEMO.as_bytes())
    );
    bench.answer(Event::Corpus(report("six.csv", 6)));
    for row in 0..6 {
        assert_eq!(bench.asked(), &Request::ShowRow { row });
        bench.answer(Event::Row { row, pairs: vec![pair()] });
    }
    assert_eq!(bench.state.data.corpus.as_ref().map(|c| c.pairs.len()), Some(6));
    assert!(bench.can_train());
    bench.act(Action::Shown(false));
    bench.act(Action::Shown(true));
    assert!(bench.posted.is_empty(), "it is open already");
}

#[test]
fn training_shows_its_progress_and_can_be_cancelled() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Train);
    let (id, request) = bench.posted.last().cloned().expect("training was sent");
    assert_eq!(request, Request::Train { lexicon: SeedLexicon::Demonstration, settings: SETTINGS });
    let progress = Progress {
        epoch: 2,
        epochs: 15,
        example: 3,
        examples: 6,
        valid: 1,
        updates: 1,
        entries: 9,
    };
    bench.act(Action::Shown(false));
    bench.hear(id, Event::Progress(progress.clone()));
    assert_eq!(bench.state.run.progress, Some(progress.clone()), "it goes on unseen");
    assert!(!bench.can_train());
    bench.run(run::Action::Cancel);
    assert_eq!(bench.posted.pop(), Some((id, Request::Cancel)));
    bench.answer(Event::Cancelled);
    assert!(bench.state.run.progress.is_none() && bench.state.run.notice.is_some());
    assert!(bench.can_train());
    bench.hear(id, Event::Progress(progress));
    assert_eq!(bench.state.run.progress, None, "what comes late changes nothing");
}

#[test]
fn a_trained_model_is_given_to_the_page() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Train);
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
    let before = bench.state.data.corpus.clone();
    let flaw = Problem { line: 3, column: None, message: "broken".to_owned(), kept: false };
    bench.data(offered("bad.csv", Ok("x")));
    bench.answer(Event::Corpus(CorpusReport {
        problems: vec![flaw.clone()],
        ..report("bad.csv", 0)
    }));
    assert_eq!(bench.state.data.corpus, before);
    let problems = bench.state.data.file_notice.as_ref().map(|notice| notice.problems.clone());
    assert_eq!(problems, Some(vec![flaw]));

    bench.data(offered("no.csv", Ok("x")));
    bench.answer(Event::Refused { message: "not a corpus".to_owned() });
    assert_eq!(bench.state.data.corpus, before);
    bench.data(offered("big.csv", Err(Fault::TooLarge)));
    assert!(bench.notice().is_some_and(|words| words.contains("big.csv is larger")));

    bench.data(offered("good.csv", Ok("y")));
    bench.answer(Event::Corpus(report("good.csv", 200)));
    let corpus = bench.state.data.corpus.as_ref().expect("a corpus is open");
    assert_eq!((&*corpus.files[0].bytes, corpus.shown), (&b"y"[..], PAGE));
    assert_eq!(bench.notice(), None);
    assert!(bench.posted.is_empty(), "pictures of a large corpus come when a row is opened");
    bench.data(data::Action::ToggleRow(7));
    assert_eq!(bench.asked(), &Request::ShowRow { row: 7 });
}

#[test]
fn the_learner_is_started_again_with_its_corpus() {
    let mut bench = Bench::with(6);
    bench.run(run::Action::Train);
    bench.posted.clear();
    bench.hear(0, Event::Crashed { message: "gone".to_owned() });
    bench.act(Action::RestartEngine(Program::Learner));
    bench.hear(0, Event::Ready);
    assert!(
        matches!(bench.asked(), Request::ReadCorpus { files, .. } if files[0].bytes == DEMO.as_bytes())
    );
}

#[test]
fn files_that_are_dropped_together_are_one_corpus() {
    let mut bench = Bench::with(6);
    let given = file("a.model", "\u{feff}groundling model");
    bench.data(data::Action::Offered(vec![file("a.csv", "x"), given, file("b.json", "y")]));
    let news = News::Give(Given::Model("groundling model".to_owned()));
    assert_eq!(bench.told(), [&news], "without its byte-order mark");
    let Request::ReadCorpus { files, with_rejected: false } = bench.asked() else { panic!() };
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
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
    bench.data(offered("all.csv", Ok("x")));
    bench.answer(Event::Corpus(CorpusReport { rejected: 3, ..report("all.csv", 0) }));
    assert!(bench.state.data.file_notice.as_ref().is_some_and(|n| n.rejected.len() == 1));
    bench.data(data::Action::UseRejected);
    let asked = |bench: &Bench| match bench.asked() {
        Request::ReadCorpus { files, with_rejected } => (files[0].bytes.clone(), *with_rejected),
        other => panic!("{other:?}"),
    };
    assert_eq!(asked(&bench), (b"x".to_vec(), true));
    bench.answer(Event::Corpus(CorpusReport { rejected: 1, ..report("some.csv", 20) }));
    bench.data(data::Action::UseRejected);
    assert_eq!(asked(&bench), (b"x".to_vec(), true), "the corpus that is open, read again");
}

#[test]
fn reading_shows_how_far_it_is_and_can_be_stopped() {
    let mut bench = Bench::with(6);
    let before = bench.state.data.corpus.clone();
    bench.data(offered("long.csv", Ok("x")));
    let (id, _) = bench.posted.last().cloned().expect("it is being read");
    bench.hear(id, Event::Reading { done: 1, of: 4 });
    assert_eq!(bench.state.data.reading, Some((1, 4)));
    bench.data(data::Action::StopReading);
    assert_eq!(bench.posted.pop(), Some((id, Request::Cancel)));
    bench.answer(Event::Cancelled);
    assert_eq!((bench.state.data.reading, &bench.state.data.corpus), (None, &before));
    assert!(bench.notice().is_some_and(|words| words.contains("stopped")));
}

#[test]
fn a_file_is_what_it_says() {
    for (name, text, kind) in [
        ("a.csv", "x,y", Kind::Corpus),
        ("a.model", "anything", Kind::Model),
        ("a.txt", "groundling model 1", Kind::Model),
        ("a.json", "{\"groundling-session\":1}", Kind::Session),
        ("a.jsonl", "{\"command\":\"go\"}", Kind::Corpus),
    ] {
        assert_eq!(files::kind(name, text.as_bytes()), kind, "{name}");
    }
    assert_eq!(files::admit(0.0), Err(Fault::Empty));
    assert_eq!(files::admit(1e9), Err(Fault::TooLarge));
    assert_eq!(files::admit(1e6), Ok(()));
}
