//! The page's reducer, played without a browser: actions in, state and effects out.

use groundling::domain::State as World;
use groundling::ui::action::{Action, Effect, Timer};
use groundling::ui::corpus::{DEMO, PAGE};
use groundling::ui::engine::Health;
use groundling::ui::files::{self, Kind};
use groundling::ui::state::{SETTINGS, State, reduce};
use groundling::ui::world::WORLDS;
use groundling::ui::{describe, why};
use groundling::worker::protocol::{
    Answer, Claim, CorpusReport, Envelope, Event, Fate, Noun, PairText, Phrase, Piece, PlanText,
    Problem, Program, Progress, Reading, Refers, Request, RowSummary, SeedLexicon, TrainReport,
    VERSION, Word,
};

/// A page and the engine's side of the talk: what was posted and not yet answered.
struct Page {
    state: State,
    posted: Vec<(u32, Request)>,
    timers: Vec<Timer>,
    others: Vec<Effect>,
}

impl Page {
    fn new() -> Page {
        let state = State::new();
        let mut page = Page { state, posted: Vec::new(), timers: Vec::new(), others: Vec::new() };
        page.act(Action::Opened);
        page
    }

    /// A page whose corpus of `rows` commands is open and whose engine has nothing to do.
    fn with_corpus(rows: usize) -> Page {
        let mut page = Page::new();
        page.hear(0, Event::Ready);
        page.answer(Event::Corpus(report("six.csv", rows)));
        while let Some((_, Request::ShowRow { row })) = page.posted.last() {
            let row = *row;
            page.answer(Event::Row { row, pairs: vec![pair()] });
        }
        page
    }

    /// A page with a model.
    fn taught() -> Page {
        let mut page = Page::with_corpus(6);
        page.act(Action::Train);
        page.answer(Event::Trained(trained("the model")));
        page.answer(Event::Opened(trained("the model")));
        page
    }

    fn act(&mut self, action: Action) {
        for effect in reduce(&mut self.state, action) {
            match effect {
                Effect::Post(program, envelope) => {
                    assert_eq!(envelope.groundling, VERSION);
                    assert!(envelope.body.program().is_none_or(|wanted| wanted == program));
                    self.posted.push((envelope.id, envelope.body));
                }
                Effect::StartTimer(timer, ms) => {
                    assert!(ms > 0);
                    self.timers.push(timer);
                }
                other => self.others.push(other),
            }
        }
    }

    /// The engines say something: what both can say, both.
    fn hear(&mut self, id: u32, body: Event) {
        for program in [Program::Talker, Program::Learner] {
            let body = body.clone();
            self.act(Action::Heard(program, Envelope { groundling: VERSION, id, body }));
        }
    }

    /// Answers the request posted last.
    #[track_caller]
    fn answer(&mut self, event: Event) {
        let (id, request) = self.posted.pop().expect("a request is at work");
        let program = request.program().expect("a request that is one program's");
        self.act(Action::Heard(program, Envelope { groundling: VERSION, id, body: event }));
    }

    /// Rings the timers that were started, until one that plays the plan has rung.
    fn play_on(&mut self) -> bool {
        let timers = std::mem::take(&mut self.timers);
        let play = timers.into_iter().rev().find(|t| matches!(t, Timer::Play(_)));
        play.map(|timer| self.act(Action::Rang(timer))).is_some()
    }
}

fn report(name: &str, rows: usize) -> CorpusReport {
    let row = RowSummary { command: "go".to_owned(), task: None, pairs: 1 };
    CorpusReport { name: name.to_owned(), rows: vec![row; rows], rejected: 0, problems: Vec::new() }
}

fn trained(model: &str) -> TrainReport {
    TrainReport { model: model.to_owned(), examples: 6, valid: 6, entries: 30 }
}

fn world() -> World {
    State::new().world.current
}

fn pair() -> PairText {
    PairText { pre: world(), post: world() }
}

fn reading() -> Reading {
    Reading {
        form: "(f:t)".to_owned(),
        formula: vec![Piece { text: "f".to_owned(), words: None }],
        claim: Claim::Formula("f".to_owned()),
        score: 1.0,
        nodes: Vec::new(),
        derivation: String::new(),
        phrases: Vec::new(),
        cells: Vec::new(),
    }
}

/// A plan that walks the robot east from where `from` has it.
fn plan(from: &World, steps: i32) -> PlanText {
    let state = |n: i32| {
        let mut state = from.clone();
        state.agent.x += n;
        state
    };
    PlanText {
        actions: (0..steps).map(|_| "east".to_owned()).collect(),
        states: (0..=steps).map(state).collect(),
        reason: None,
        reached: true,
        sure: true,
        replans: 0,
        work: None,
    }
}

fn word(text: &str, fate: Fate) -> Word {
    Word { text: text.to_owned(), heard: None, fate, near: Vec::new() }
}

fn understood(plan: Option<PlanText>) -> Answer {
    Answer {
        command: "go".to_owned(),
        words: vec![word("go", Fate::Meant)],
        readings: vec![reading()],
        reason: None,
        plan,
    }
}

fn failed(reason: &str) -> Answer {
    Answer { readings: Vec::new(), reason: Some(reason.to_owned()), ..understood(None) }
}

#[test]
fn it_opens_with_its_own_corpus_and_asks_for_every_picture() {
    let mut page = Page::new();
    assert_eq!(page.others, [Program::Talker, Program::Learner].map(Effect::SpawnEngine));
    assert!(page.posted.is_empty(), "nothing is sent before the engine is up");
    page.hear(0, Event::Ready);
    let [(id, Request::ReadCorpus { text, .. })] = page.posted.as_slice() else { panic!() };
    assert_eq!((*id, text.as_str()), (1, DEMO));
    page.answer(Event::Corpus(report("six.csv", 6)));
    for row in 0..6 {
        assert_eq!(page.posted.last().map(|p| &p.1), Some(&Request::ShowRow { row }));
        page.answer(Event::Row { row, pairs: vec![pair()] });
    }
    assert!(page.posted.is_empty());
    assert_eq!(page.state.corpus.as_ref().map(|c| c.pairs.len()), Some(6));
    assert!(page.state.can_train() && !page.state.can_ask());
}

#[test]
fn the_worlds_it_offers_are_legal_and_have_a_blue_room() {
    for choice in WORLDS {
        let world: World = serde_json::from_str(choice.json).expect(choice.name);
        world.check().unwrap_or_else(|errors| panic!("{}: {errors:?}", choice.name));
        assert!(describe::world(&world).contains("blue"), "{}", choice.name);
        assert_eq!(world.rooms.len(), 3, "{}", choice.name);
    }
}

#[test]
fn training_shows_its_progress_and_can_be_cancelled() {
    let mut page = Page::with_corpus(6);
    page.act(Action::Train);
    let (id, request) = page.posted.last().cloned().expect("training was sent");
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
    page.hear(id, Event::Progress(progress.clone()));
    assert_eq!(page.state.progress, Some(progress.clone()));
    assert!(!page.state.can_train() && !page.state.can_ask());
    page.act(Action::CancelTraining);
    assert_eq!(page.posted.pop(), Some((id, Request::Cancel)));
    page.answer(Event::Cancelled);
    assert_eq!((page.state.progress.clone(), page.state.model.is_some()), (None, false));
    assert!(page.state.model_notice.is_some() && page.state.can_train());
    page.hear(id, Event::Progress(progress));
    assert_eq!(page.state.progress, None, "what comes late changes nothing");
}

#[test]
fn a_command_becomes_a_plan_that_plays_to_its_end() {
    let mut page = Page::taught();
    page.act(Action::AskExample("go".to_owned()));
    let start = world();
    page.answer(Event::Answer(Box::new(understood(Some(plan(&start, 3))))));
    assert_eq!(page.state.shown(), &start);
    let mut rung = 0;
    while page.play_on() {
        rung += 1;
    }
    assert_eq!(rung, 3);
    assert_eq!(page.state.shown().agent.x, start.agent.x + 3);
    assert!(page.state.announcement.starts_with("Done in 3 steps."));

    // The next command is said where the robot stands now, and undo goes back a whole plan.
    page.act(Action::Ask);
    let Some((_, Request::Ask { state, .. })) = page.posted.last() else { panic!() };
    assert_eq!(state.agent.x, start.agent.x + 3);
    page.answer(Event::Answer(Box::new(failed("no_parse"))));
    page.act(Action::Undo);
    assert_eq!(page.state.shown(), &start);
    assert!(!page.state.world.can_undo());
}

#[test]
fn a_plan_can_be_paused_stepped_and_scrubbed() {
    let mut page = Page::taught();
    let start = world();
    page.act(Action::Ask);
    page.answer(Event::Answer(Box::new(understood(Some(plan(&start, 4))))));
    page.act(Action::TogglePlay);
    page.play_on();
    assert_eq!(page.state.shown(), &start, "a timer from before the pause moves nothing");
    page.act(Action::Seek(3));
    assert_eq!(page.state.shown().agent.x, start.agent.x + 3);
    assert!(page.state.announcement.starts_with("Step 3 of 4: east."));
    page.act(Action::Seek(99));
    page.act(Action::TogglePlay);
    assert_eq!(page.state.shown(), &start, "played again from the start");
    page.act(Action::ResetWorld);
    assert!(page.state.playback.is_none());
}

#[test]
fn a_bad_file_loses_nothing() {
    let mut page = Page::taught();
    let before = page.state.corpus.clone();
    let flaw = Problem { line: 3, column: None, message: "broken".to_owned(), kept: false };
    page.act(Action::FileRead { name: "bad.csv".to_owned(), text: "x".to_owned() });
    let bad = CorpusReport { problems: vec![flaw.clone()], ..report("bad.csv", 0) };
    page.answer(Event::Corpus(bad));
    assert_eq!(page.state.corpus, before);
    assert_eq!(page.state.file_notice.as_ref().map(|n| n.problems.clone()), Some(vec![flaw]));

    page.act(Action::FileRead { name: "no.csv".to_owned(), text: "x".to_owned() });
    page.answer(Event::Refused { message: "not a corpus".to_owned() });
    assert_eq!(page.state.corpus, before);
    page.act(Action::FileRefused("too large".to_owned()));
    assert_eq!(page.state.file_notice.as_ref().map(|n| n.message.as_str()), Some("too large"));
    assert!(page.state.model.is_some());

    page.act(Action::FileRead { name: "good.csv".to_owned(), text: "y".to_owned() });
    page.answer(Event::Corpus(report("good.csv", 200)));
    let corpus = page.state.corpus.as_ref().expect("a corpus is open");
    assert_eq!((&*corpus.text, corpus.shown), ("y", PAGE));
    assert_eq!(page.state.file_notice, None);
    assert!(page.posted.is_empty(), "pictures of a large corpus come when a row is opened");
    page.act(Action::ToggleRow(7));
    assert_eq!(page.posted.last().map(|p| &p.1), Some(&Request::ShowRow { row: 7 }));
}

#[test]
fn a_stopped_engine_is_started_again_with_all_it_had() {
    let mut page = Page::taught();
    page.act(Action::Train);
    page.hear(0, Event::Crashed { message: "first".to_owned() });
    for program in [Program::Talker, Program::Learner] {
        page.act(Action::EngineBroke(program, "second".to_owned()));
    }
    assert_eq!(page.state.talker.health, Health::Stopped("first".to_owned()));
    assert_eq!(page.state.learner.health, Health::Stopped("first".to_owned()));
    assert!(!page.state.is_training() && !page.state.can_ask());
    page.posted.clear();
    page.others.clear();
    page.act(Action::RestartEngine(Program::Learner));
    page.act(Action::RestartEngine(Program::Talker));
    assert_eq!(page.others, [Program::Learner, Program::Talker].map(Effect::SpawnEngine));
    page.hear(0, Event::Ready);
    assert!(matches!(page.posted.pop(), Some((_, Request::ReadCorpus { .. }))));
    let model = Request::OpenModel { text: "the model".to_owned() };
    assert_eq!(page.posted.last().map(|p| &p.1), Some(&model));
    page.answer(Event::Opened(trained("the model")));
    assert!(page.state.can_ask());
    assert_eq!(page.state.model.as_ref().map(|m| m.origin.as_str()), Some("six.csv"));
}

#[test]
fn an_engine_that_says_nothing_is_given_up() {
    let mut page = Page::with_corpus(6);
    page.act(Action::Train);
    for _ in 0..4 {
        let watch = page.timers.pop().expect("a watch is kept");
        page.act(Action::Rang(watch));
        assert_eq!(page.state.learner.health, Health::Ready);
        assert_eq!(page.posted.pop(), Some((0, Request::Ping)));
    }
    page.hear(0, Event::Pong);
    for _ in 0..5 {
        assert_eq!(page.state.learner.health, Health::Ready);
        let watch = page.timers.pop().expect("a watch is kept");
        page.act(Action::Rang(watch));
    }
    assert!(matches!(page.state.learner.health, Health::Stopped(_)));
}

#[test]
fn every_failure_says_what_is_wrong_and_what_to_do() {
    let plan_failed = |reason: &str| PlanText {
        reason: Some(reason.to_owned()),
        actions: Vec::new(),
        states: Vec::new(),
        reached: false,
        sure: true,
        replans: 0,
        work: None,
    };
    let mut no_referent = understood(Some(plan_failed("no_referent")));
    no_referent.readings[0].phrases = vec![Phrase {
        noun: Noun::Formula("the red".to_owned()),
        words: vec![0],
        refers: Refers::None,
        referents: Vec::new(),
    }];
    let unknown = Answer { words: vec![word("zebra", Fate::Unknown)], ..failed("unknown_words") };
    let cases = [
        ("empty", failed("empty")),
        ("too_long", failed("too_long")),
        ("unknown_words", unknown),
        ("no_parse", failed("no_parse")),
        ("tie", Answer { readings: vec![reading(), reading()], ..failed("tie") }),
        ("budget", failed("budget")),
        ("no_referent", no_referent),
        ("already_true", understood(Some(plan(&world(), 0)))),
        ("unreachable", understood(Some(plan_failed("unreachable")))),
        ("plan_budget", understood(Some(plan_failed("budget")))),
        (
            "skipped",
            Answer {
                words: vec![word("please", Fate::Skipped)],
                ..understood(Some(plan(&world(), 1)))
            },
        ),
    ];
    let left_out = Answer {
        words: vec![word("purple", Fate::Unknown), word("please", Fate::Skipped)],
        ..understood(Some(plan(&world(), 1)))
    };
    let kinds: Vec<&str> = why::explain(&left_out).iter().map(|m| m.kind).collect();
    assert_eq!(kinds, ["unknown_words", "skipped"]);
    for (kind, answer) in cases {
        let messages = why::explain(&answer);
        let kinds: Vec<&str> = messages.iter().map(|m| m.kind).collect();
        assert_eq!(kinds, [kind]);
        assert!(messages.iter().all(|m| !m.what.is_empty() && !m.fix.is_empty()));
        for word in answer.words.iter().filter(|word| word.fate != Fate::Meant) {
            assert!(messages[0].what.contains(&word.text), "{}", messages[0].what);
        }
    }
    assert_eq!(why::explain(&understood(Some(plan(&world(), 1)))), []);
}

#[test]
fn files_are_told_apart_and_the_impossible_ones_refused() {
    assert_eq!(files::kind("a.csv", "HITId,…"), Kind::Corpus);
    assert_eq!(files::kind("a.txt", "groundling model 1\n"), Kind::Model);
    assert_eq!(files::kind("a.MODEL", ""), Kind::Model);
    assert!(files::admit("a.csv", 0.0).is_err());
    assert!(files::admit("a.csv", 1e9).is_err());
    assert_eq!(files::admit("a.csv", 1.0), Ok(()));
    let wrong = files::decode("a.xlsx", vec![b'a', b'\n', 0xff, b'b']);
    assert!(wrong.is_err_and(|words| words.contains("line 2")));
}
