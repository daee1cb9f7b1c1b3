//! The workbench: corpora, bad files, training.

use super::{Page, model, pair, report};
use groundling::ui::app::Action;
use groundling::ui::app::action::View;
use groundling::ui::page::document::Origin;
use groundling::ui::page::files::{self, Fault, Kind, Offered};
use groundling::ui::train;
use groundling::ui::train::corpus::{DEMO, PAGE};
use groundling::ui::train::state::SETTINGS;
use groundling::worker::protocol::{
    CorpusReport, Event, Problem, Program, Progress, Request, SeedLexicon,
};

/// A page whose workbench has a corpus of `rows` commands, with nothing at work.
fn bench(rows: usize) -> Page {
    let mut page = Page::ready();
    page.act(Action::Go(View::Train));
    page.hear(Program::Learner, 0, Event::Ready);
    page.answer(Event::Corpus(report("six.csv", rows)));
    while let Some((.., Request::ShowRow { row })) = page.posted.last() {
        let row = *row;
        page.answer(Event::Row { row, pairs: vec![pair()] });
    }
    page
}

/// A file was dropped.
fn offered(name: &str, text: Result<&str, Fault>) -> Action {
    Action::Offered(vec![Offered { name: name.to_owned(), bytes: text.map(Into::into) }])
}

fn can_train(page: &Page) -> bool {
    page.state.train.can_train(&page.state.shared)
}

#[test]
fn the_workbench_opens_with_the_six_sentences_and_their_pictures() {
    let mut page = Page::ready();
    page.act(Action::Go(View::Train));
    assert!(page.posted.is_empty(), "the engine that learns is only now loaded");
    page.hear(Program::Learner, 0, Event::Ready);
    assert!(
        matches!(page.asked(), Request::ReadCorpus { files, .. } if files[0].bytes == DEMO.as_bytes())
    );
    page.answer(Event::Corpus(report("six.csv", 6)));
    for row in 0..6 {
        assert_eq!(page.asked(), &Request::ShowRow { row });
        page.answer(Event::Row { row, pairs: vec![pair()] });
    }
    assert_eq!(page.state.train.corpus.as_ref().map(|c| c.pairs.len()), Some(6));
    assert!(can_train(&page));
    page.act(Action::Go(View::Talk));
    page.act(Action::Go(View::Train));
    assert!(page.posted.is_empty(), "it is open already");
}

#[test]
fn training_shows_its_progress_and_can_be_cancelled() {
    let mut page = bench(6);
    page.act(train::Action::Train);
    let (program, id, request) = page.posted.last().cloned().expect("training was sent");
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
    page.hear(program, id, Event::Progress(progress.clone()));
    assert_eq!(page.state.train.progress, Some(progress.clone()));
    assert!(!can_train(&page) && page.can_ask(), "one can talk meanwhile");
    page.act(train::Action::CancelTraining);
    assert_eq!(page.posted.pop(), Some((program, id, Request::Cancel)));
    page.answer(Event::Cancelled);
    assert!(page.state.train.progress.is_none() && page.state.train.notice.is_some());
    assert!(can_train(&page));
    page.hear(program, id, Event::Progress(progress));
    assert_eq!(page.state.train.progress, None, "what comes late changes nothing");
}

#[test]
fn a_trained_model_is_given_to_the_engine_that_answers_and_can_be_undone() {
    let mut page = bench(6);
    page.act(train::Action::Train);
    page.answer(Event::Trained(model("trained here")));
    assert_eq!(page.asked(), &Request::OpenModel { text: "trained here".to_owned() });
    page.answer(Event::Opened(model("trained here")));
    let origin = page.state.shared.document.model.as_ref().map(|model| model.origin.clone());
    assert_eq!(origin, Some(Origin::Trained("six.csv".to_owned())));
    page.act(Action::Undo);
    assert_eq!(page.asked(), &Request::OpenModel { text: "the model".to_owned() });
    let origin = page.state.shared.document.model.as_ref().map(|model| model.origin.clone());
    assert_eq!(origin, Some(Origin::Shipped));
}

#[test]
fn a_bad_file_loses_nothing() {
    let mut page = bench(6);
    let before = page.state.train.corpus.clone();
    let flaw = Problem { line: 3, column: None, message: "broken".to_owned(), kept: false };
    page.act(offered("bad.csv", Ok("x")));
    page.answer(Event::Corpus(CorpusReport {
        problems: vec![flaw.clone()],
        ..report("bad.csv", 0)
    }));
    assert_eq!(page.state.train.corpus, before);
    let notice = |page: &Page| page.state.train.file_notice.clone();
    assert_eq!(notice(&page).map(|n| n.problems), Some(vec![flaw]));

    page.act(offered("no.csv", Ok("x")));
    page.answer(Event::Refused { message: "not a corpus".to_owned() });
    assert_eq!(page.state.train.corpus, before);
    page.act(offered("big.csv", Err(Fault::TooLarge)));
    assert!(notice(&page).is_some_and(|n| n.message.contains("big.csv is larger")));
    assert!(page.state.shared.document.model.is_some());

    page.act(offered("good.csv", Ok("y")));
    page.answer(Event::Corpus(report("good.csv", 200)));
    let corpus = page.state.train.corpus.as_ref().expect("a corpus is open");
    assert_eq!((&*corpus.files[0].bytes, corpus.shown), (&b"y"[..], PAGE));
    assert_eq!(notice(&page), None);
    assert!(page.posted.is_empty(), "pictures of a large corpus come when a row is opened");
    page.act(train::Action::ToggleRow(7));
    assert_eq!(page.asked(), &Request::ShowRow { row: 7 });
}

#[test]
fn the_learner_is_started_again_with_its_corpus() {
    let mut page = bench(6);
    page.act(train::Action::Train);
    page.posted.clear();
    page.hear(Program::Learner, 0, Event::Crashed { message: "gone".to_owned() });
    assert!(page.can_ask(), "the other engine goes on");
    page.act(Action::RestartEngine(Program::Learner));
    page.hear(Program::Learner, 0, Event::Ready);
    assert!(
        matches!(page.asked(), Request::ReadCorpus { files, .. } if files[0].bytes == DEMO.as_bytes())
    );
}

#[test]
fn files_that_are_dropped_together_are_one_corpus() {
    let mut page = bench(6);
    let file = |name: &str, text: &str| Offered { name: name.to_owned(), bytes: Ok(text.into()) };
    let model = file("a.model", "\u{feff}groundling model");
    page.act(Action::Offered(vec![file("a.csv", "x"), model, file("b.json", "y")]));
    let models: Vec<&Request> = page.posted.iter().map(|(.., request)| request).collect();
    let open = Request::OpenModel { text: "groundling model".to_owned() };
    assert!(models.contains(&&open), "without its byte-order mark: {models:?}");
    let Request::ReadCorpus { files, with_rejected: false } = page.asked() else { panic!() };
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.csv", "b.json"]);

    let too_large = Offered { name: "big.csv".to_owned(), bytes: Err(Fault::TooLarge) };
    page.posted.clear();
    page.act(Action::Offered(vec![file("a.csv", "x"), too_large]));
    assert!(page.posted.is_empty(), "where one cannot be read, none is");
    let not_text = Offered { name: "a.model".to_owned(), bytes: Ok(b"groundling\n\xff".to_vec()) };
    page.act(Action::Offered(vec![not_text]));
    let notice = page.state.train.file_notice.as_ref().map(|notice| notice.message.clone());
    assert!(notice.is_some_and(|message| message.contains("first seen in line 2")));
}

#[test]
fn rejected_rows_are_used_when_a_person_says_so() {
    let mut page = bench(6);
    page.act(offered("all.csv", Ok("x")));
    page.answer(Event::Corpus(CorpusReport { rejected: 3, ..report("all.csv", 0) }));
    assert!(page.state.train.file_notice.as_ref().is_some_and(|n| n.rejected.len() == 1));
    page.act(train::Action::UseRejected);
    let asked = |page: &Page| match page.asked() {
        Request::ReadCorpus { files, with_rejected } => (files[0].bytes.clone(), *with_rejected),
        other => panic!("{other:?}"),
    };
    assert_eq!(asked(&page), (b"x".to_vec(), true));
    page.answer(Event::Corpus(CorpusReport { rejected: 1, ..report("some.csv", 20) }));
    page.act(train::Action::UseRejected);
    assert_eq!(asked(&page), (b"x".to_vec(), true), "the corpus that is open, read again");
}

#[test]
fn reading_shows_how_far_it_is_and_can_be_stopped() {
    let mut page = bench(6);
    let before = page.state.train.corpus.clone();
    page.act(offered("long.csv", Ok("x")));
    let (program, id, _) = page.posted.last().cloned().expect("it is being read");
    page.hear(program, id, Event::Reading { done: 1, of: 4 });
    assert_eq!(page.state.train.reading, Some((1, 4)));
    page.act(train::Action::StopReading);
    assert_eq!(page.posted.pop(), Some((program, id, Request::Cancel)));
    page.answer(Event::Cancelled);
    assert_eq!((page.state.train.reading, &page.state.train.corpus), (None, &before));
    let notice = page.state.train.file_notice.as_ref().map(|notice| notice.message.clone());
    assert!(notice.is_some_and(|message| message.contains("stopped")));
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
