//! The workbench, played without a browser: what was learned, what is kept and comes back, experiments that are shared out.

use super::model;
use super::train::{Bench, file, progress, report};
use groundling::ui::page::engine::Errand;
use groundling::ui::page::keep::ask::Place;
use groundling::ui::page::keep::copies::Item;
use groundling::ui::page::keep::fault::Fault;
use groundling::ui::page::news::News;
use groundling::ui::train::action::Tab;
use groundling::ui::train::data::{demo, pack};
use groundling::ui::train::effect::Effect;
use groundling::ui::train::experiments::matrix::Kind;
use groundling::ui::train::experiments::pool::Said;
use groundling::ui::train::kept::ask::{self, Ask};
use groundling::ui::train::run::state::Pace;
use groundling::ui::train::{Action, data, experiments, kept, lexicon, run};
use groundling::worker::protocol::{
    Checkpoint, CorpusFile, EntryWindow, Envelope, Event, Joined, MappedFile, Matrix, Progress,
    Request, VERSION,
};

impl Bench {
    pub(super) fn store(&mut self, news: ask::News) {
        self.act(Action::Kept(kept::Action::Heard(news)));
    }

    /// The store is open, this tab keeps runs, and so much is kept.
    pub(super) fn shelf(&mut self, items: Vec<Item>) {
        self.store(ask::News::Open);
        self.store(ask::News::Claimed(true));
        self.store(ask::News::List(items));
        self.stored.clear();
    }

    /// What was written last, and where.
    #[track_caller]
    pub(super) fn written(&self, kind: &str) -> (Place, Vec<u8>) {
        let written = self.stored.iter().rev().find_map(|ask| match ask {
            Ask::Write(place, bytes) if place.kind == kind => Some((place.clone(), bytes.to_vec())),
            _ => None,
        });
        written.expect("it is written")
    }

    pub(super) fn pool(&mut self, seat: u32, said: Said) {
        self.act(Action::Experiments(experiments::Action::Told(seat, said)));
    }

    pub(super) fn pool_says(&mut self, seat: u32, id: u32, body: Event) {
        self.pool(seat, Said::Heard(Envelope { groundling: VERSION, id, body }));
    }

    /// What the engines of the pool were sent and have not answered.
    pub(super) fn sent(&mut self) -> Vec<(u32, u32, Request)> {
        let mut sent = Vec::new();
        self.others.retain(|effect| match effect {
            Effect::Pool(seat, Errand::Post(_, envelope)) => {
                sent.push((*seat, envelope.id, envelope.body.clone()));
                false
            }
            _ => true,
        });
        sent
    }
}

pub(super) fn item(kind: &str, name: &str) -> Item {
    Item { kind: kind.to_owned(), name: name.to_owned(), bytes: 7, at: 1.0 }
}

/// A run on the open corpus that has got so far, with a checkpoint.
pub(super) fn begun(bench: &mut Bench) -> u32 {
    bench.run(run::Action::Go);
    let (id, _) = bench.posted.pop().expect("training was sent");
    let (asked, request) = bench.posted.pop().expect("what was decided was asked for");
    assert_eq!(request, Request::Decisions);
    bench.hear(asked, Event::Decisions { text: "decided so".to_owned() });
    bench.state.desk.clock = 9_000.0;
    bench.hear(id, Event::Progress(progress(2, 3)));
    bench.answer(Event::Checkpoint(Checkpoint { text: "so far".to_owned(), epoch: 2, example: 3 }));
    id
}

#[test]
fn a_run_is_kept_with_its_corpus_and_goes_on_when_the_page_is_opened_again() {
    let mut bench = Bench::with(6);
    bench.data(data::Action::Offered(vec![file("mine.csv", "x")]));
    bench.answer(Event::Sheet(Box::new(report("mine.csv", 6))));
    bench.settle(6);
    bench.shelf(Vec::new());
    let id = begun(&mut bench);
    let (corpus, bytes) = bench.written("corpus");
    let (place, text) = bench.written("run");
    assert_eq!((place.name.as_str(), corpus.name.as_str()), ("mine.csv, 1", "mine.csv "));
    let files = pack::read(&bytes).expect("it is a corpus").files;
    let mine = CorpusFile { name: "mine.csv".to_owned(), bytes: b"x".to_vec().into() };
    assert_eq!(files, [MappedFile { file: mine, ..demo::file() }]);
    // While it is being written nothing is written over it; then what has come since is.
    bench.stored.clear();
    bench.state.desk.clock = 14_000.0;
    bench.hear(id, Event::Progress(progress(2, 4)));
    let last = Checkpoint { text: "further".to_owned(), epoch: 2, example: 4 };
    bench.answer(Event::Checkpoint(last));
    assert!(!bench.stored.iter().any(|ask| matches!(ask, Ask::Write(..))), "{:?}", bench.stored);
    bench.store(ask::News::Written(corpus.clone()));
    bench.store(ask::News::Written(place.clone()));
    let (_, further) = bench.written("run");
    assert!(String::from_utf8_lossy(&further).contains("\"further\""));

    // Another day.
    let mut again = Bench::with(6);
    again.store(ask::News::Open);
    again.store(ask::News::Claimed(true));
    again.store(ask::News::List(vec![item("run", &place.name), item("corpus", &corpus.name)]));
    assert_eq!(again.stored.last(), Some(&Ask::Read(place.clone())));
    again.store(ask::News::Read(place.clone(), Some((text, false))));
    assert_eq!(again.stored.last(), Some(&Ask::Read(corpus.clone())));
    again.store(ask::News::Read(corpus, Some((bytes, false))));
    assert!(matches!(again.asked(), Request::OpenSheet { files: read, .. } if *read == files));
    again.answer(Event::Sheet(Box::new(report("mine.csv", 6))));
    let asked = |bench: &mut Bench, wanted: &Request| {
        let at = bench.posted.iter().position(|(_, request)| request == wanted);
        bench.posted.remove(at.unwrap_or_else(|| panic!("{:?}", bench.posted))).0
    };
    let id = asked(&mut again, &Request::TakeDecisions { text: "decided so".to_owned() });
    again.hear(id, Event::Care(super::train::care(6)));
    again.settle(6);
    let Request::Learn { resume, .. } = again.asked() else { panic!("{:?}", again.posted) };
    assert_eq!(resume.as_deref(), Some("so far"));
    // The grid of the data view still tells how far it is scrolled, on its way out: the run stays in view.
    again.data(data::Action::Look(data::action::Look::Scrolled(0, 5)));
    assert_eq!((again.state.tab, again.live().points.len()), (Tab::Run, 1));
    assert!(again.state.kept.came_back.is_some());
}

#[test]
fn a_full_store_is_told_and_loses_nothing_that_is_kept() {
    let mut bench = Bench::with(6);
    bench.shelf(Vec::new());
    let id = begun(&mut bench);
    let (place, _) = bench.written("run");
    let (corpus, _) = bench.written("corpus");
    bench.store(ask::News::Written(corpus));
    bench.store(ask::News::Written(place.clone()));
    assert_eq!(bench.state.kept.reached, Some((2, 3)));
    let on = |bench: &mut Bench, clock: f64, text: &str| {
        bench.state.desk.clock = clock;
        bench.hear(id, Event::Progress(progress(3, 1)));
        let text = text.to_owned();
        bench.answer(Event::Checkpoint(Checkpoint { text, epoch: 3, example: 1 }));
    };
    on(&mut bench, 20_000.0, "more");
    bench.store(ask::News::Failed(Some(place.clone()), Fault::Full));
    assert_eq!(bench.state.kept.fault, Some(Fault::Full));
    assert_eq!(bench.live().pace, Pace::Goes, "it goes on");
    assert_eq!(bench.state.kept.reached, Some((2, 3)), "and it is said how far it is kept");
    // It is tried again with the next checkpoint.
    on(&mut bench, 30_000.0, "yet more");
    bench.store(ask::News::Written(place));
    assert_eq!((bench.state.kept.fault.clone(), bench.state.kept.reached), (None, Some((3, 1))));
}

#[test]
fn a_run_without_its_corpus_waits_for_it_and_one_that_was_stopped_stays_so() {
    let mut bench = Bench::with(6);
    bench.shelf(Vec::new());
    begun(&mut bench);
    let (place, text) = bench.written("run");
    let mut again = Bench::with(6);
    again.shelf(vec![item("run", &place.name)]);
    again.act(Action::Kept(kept::Action::Open(place.clone())));
    again.store(ask::News::Read(place.clone(), Some((text.clone(), false))));
    let Some(Ask::Read(corpus)) = again.stored.last().cloned() else { panic!() };
    again.store(ask::News::Read(corpus, None));
    let run = again.state.run.run.as_ref().expect("it is shown");
    assert_eq!((run.pace, run.name.as_str()), (Pace::Stopped, place.name.as_str()));
    assert!(
        again.state.kept.notice.as_deref().is_some_and(|words| words.contains("not kept any more"))
    );
    // What is no run is told, and what is not there.
    for (found, said) in
        [(Some((b"{}".to_vec(), false)), "cannot be opened"), (None, "is not kept any more")]
    {
        again.act(Action::Kept(kept::Action::Open(place.clone())));
        again.store(ask::News::Read(place.clone(), found));
        let notice = again.state.kept.notice.clone().unwrap_or_default();
        assert!(notice.contains(said), "{notice}");
    }
}

#[test]
fn corpora_and_models_are_kept_under_a_name_opened_saved_and_deleted() {
    let mut bench = Bench::with(6);
    bench.shelf(Vec::new());
    bench.act(Action::Kept(kept::Action::Name(" my corpus ".to_owned())));
    bench.act(Action::Kept(kept::Action::KeepCorpus));
    bench.answer(Event::Decisions { text: "decided so".to_owned() });
    let (place, bytes) = bench.written("corpus");
    assert_eq!(place.name, "my corpus");
    let kept = pack::read(&bytes).expect("it is a corpus");
    assert_eq!((kept.files, kept.decisions), (vec![demo::file()], Some("decided so".to_owned())));
    bench.act(Action::Kept(kept::Action::Save(place.clone())));
    bench.store(ask::News::Read(place.clone(), Some((bytes.clone(), false))));
    assert!(bench.others.contains(&Effect::GiveBack(demo::file().file)));
    bench.act(Action::Kept(kept::Action::Open(place.clone())));
    bench.store(ask::News::Read(place.clone(), Some((bytes, true))));
    assert!(matches!(bench.asked(), Request::OpenSheet { .. }));
    assert!(bench.state.kept.notice.as_deref().is_some_and(|words| words.contains("damaged")));
    bench.act(Action::Kept(kept::Action::Delete(place.clone())));
    assert_eq!(bench.stored.last(), Some(&Ask::Delete(place)));
    assert_eq!(pack::read(b"x"), Err("its first line is cut off".to_owned()));
}

#[test]
fn another_tab_keeps_its_runs_and_this_one_says_that_it_does_not() {
    let mut bench = Bench::with(6);
    bench.store(ask::News::Open);
    bench.store(ask::News::Claimed(false));
    bench.store(ask::News::List(vec![item("run", "six.csv, 1")]));
    bench.stored.clear();
    begun(&mut bench);
    assert_eq!((&bench.stored[..], &bench.state.kept.fault), (&[][..], &Some(Fault::Elsewhere)));
    bench.act(Action::Kept(kept::Action::KeepHere));
    bench.store(ask::News::Claimed(true));
    assert_eq!(bench.state.kept.fault, None);
    let (place, _) = bench.written("run");
    assert_eq!(place.name, "six.csv, 2", "the other's is not written over");
}

#[test]
fn engines_share_the_runs_out_and_one_that_dies_is_replaced() {
    let mut bench = Bench::with(6);
    bench.act(Action::Cores(8));
    bench.act(Action::Experiments(experiments::Action::Go));
    assert!(matches!(bench.asked(), Request::PlanRuns { matrix: Matrix::Cross { .. }, .. }));
    let plan = r#"{"runs":[{},{},{},{},{}]}"#.to_owned();
    bench.answer(Event::Plan { text: plan.clone() });
    let pool = |bench: &Bench| bench.state.experiments.pool.clone();
    assert_eq!(pool(&bench).map(|pool| (pool.n_seats(), pool.n_runs())), Some((4, 5)));
    // One after another reads the corpus, and has a run when it has.
    for seat in 0..4 {
        bench.pool_says(seat, 0, Event::Ready);
        let sent = bench.sent();
        let [(of, id, Request::OpenSheet { .. })] = sent[..] else { panic!("{sent:?}") };
        assert_eq!(of, seat);
        bench.pool_says(seat, id, Event::Sheet(Box::new(report("six.csv", 6))));
        let sent = bench.sent();
        assert!(sent.iter().any(|(of, _, request)| *of == seat
            && *request == Request::RunShard { plan: plan.clone(), runs: vec![seat] }));
    }
    // The second dies and is replaced; its run is done anew, by whoever is next.
    bench.pool(1, Said::Broke("killed".to_owned()));
    let mut shards = Vec::new();
    for (seat, id, run) in [(0, 2, 0), (2, 2, 2), (3, 2, 3), (0, 3, 4), (2, 3, 1)] {
        bench.pool_says(seat, id, Event::Shard { text: format!("run {run}") });
        shards.push(format!("run {run}"));
    }
    assert_eq!(bench.asked(), &Request::JoinRuns { plan, shards });
    assert!(bench.others.contains(&Effect::EndPool) && pool(&bench).is_none());
    bench.answer(Event::Joined(Box::new(Joined {
        runs: Vec::new(),
        all: None,
        csv: "csv".to_owned(),
        markdown: "report".to_owned(),
        results: "all".to_owned(),
    })));
    assert_eq!(bench.state.experiments.results.len(), 1);
}

#[test]
fn the_papers_experiments_are_one_press_each() {
    let mut bench = Bench::with(6);
    bench.act(Action::Experiments(experiments::Action::Paper(Kind::Table3)));
    let posted: Vec<&Request> = bench.posted.iter().map(|(_, request)| request).collect();
    let [Request::Divide { .. }, Request::PlanRuns { matrix: Matrix::Table3 { .. }, .. }] =
        posted[..]
    else {
        panic!("{posted:?}")
    };
    bench.settle(6);
    bench.act(Action::Experiments(experiments::Action::Six));
    bench.pool_says(0, 0, Event::Ready);
    let sent = bench.sent();
    let [(0, id, Request::OpenSheet { ref files, .. })] = sent[..] else { panic!("{sent:?}") };
    assert_eq!(files, &[demo::file()]);
    bench.pool_says(0, id, Event::Sheet(Box::new(report("six.csv", 6))));
    let sent = bench.sent();
    let [(0, id, Request::Demonstrate { .. })] = sent[..] else { panic!("{sent:?}") };
    bench.pool_says(0, id, Event::Refused { message: "no".to_owned() });
    assert_eq!(bench.state.experiments.notice.as_deref(), Some("no"));
    assert!(bench.state.experiments.pool.is_none());
}

#[test]
fn the_lexicon_is_asked_for_when_it_is_seen_and_a_model_without_some_of_it_is_given_to_the_robot() {
    let mut bench = Bench::with(6);
    bench.act(Action::Turn(Tab::Lexicon));
    let asked: Vec<Request> = bench.posted.iter().map(|(_, request)| request.clone()).collect();
    let [Request::Errors, Request::Entries { view, offset: 0, .. }] = &asked[..] else {
        panic!("{asked:?}")
    };
    let view = view.clone();
    let window = EntryWindow { total: 70, ..EntryWindow::default() };
    bench.answer(Event::Entries(Box::new(window.clone())));
    bench.answer(Event::Refused { message: "no model was asked".to_owned() });
    assert_eq!(bench.state.lexicon.window.as_deref(), Some(&window));
    assert_eq!((&bench.state.lexicon.errors, &bench.state.lexicon.notice), (&None, &None));

    bench.act(Action::Lexicon(lexicon::Action::Text("green".to_owned())));
    // What was asked before has come late: it is not what is looked for.
    let late = Request::Entries { view, offset: 0, count: 50 };
    assert_ne!(bench.asked(), &late);
    bench.settle(6);

    bench.act(Action::Lexicon(lexicon::Action::Pick(12, true)));
    bench.act(Action::Lexicon(lexicon::Action::Without));
    assert_eq!(bench.asked(), &Request::Without { places: vec![12] });
    bench.answer(Event::Trained(model("without it")));
    assert!(matches!(bench.told()[..], [News::Use { text, .. }] if text == "without it"));
}

#[test]
fn what_is_left_is_told_from_the_pass_before() {
    let mut clock = run::clock::Clock::default();
    let at = |epoch, example| Progress { examples: 100, epochs: 3, ..progress(epoch, example) };
    clock.tick(0.0, &at(1, 0));
    clock.tick(1_000.0, &at(1, 1));
    assert_eq!(clock.left(&at(1, 1)), None, "too early to tell");
    clock.tick(60_000.0, &at(1, 100));
    clock.tick(61_000.0, &at(2, 0));
    // The first pass took 61 s; the second is at its half, and one more follows.
    assert_eq!(clock.left(&at(2, 50)), Some(30_500.0 + 61_000.0));
    clock.rest();
    clock.tick(1_000_000.0, &at(2, 51));
    assert_eq!(clock.worked(), 61_000.0, "what goes by while it rests is not its own");
}

#[test]
fn curves_are_a_picture_that_stands_by_itself() {
    let point = |epoch| run::curve::Point { progress: progress(epoch, 6), judgement: None };
    let text = run::words::Text::of(groundling::ui::page::language::Language::German);
    let picture = run::picture::picture(&[point(1), point(2)], text);
    assert!(picture.starts_with("<svg xmlns=") && picture.ends_with("</svg>\n"), "{picture}");
    assert_eq!(picture.matches("<circle").count(), 6, "two points of three charts");
    assert!(picture.contains(text.entries) && !picture.contains(text.held_out));
    assert_eq!(run::picture::picture(&[], text).matches("<text").count(), 0);
    assert_eq!(groundling::ui::train::svg::escaped("a < b & c"), "a &lt; b &amp; c");
}
