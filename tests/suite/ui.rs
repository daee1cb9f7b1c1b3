//! The page's reducer, played without a browser: actions in, state and effects out.

#[path = "ui/collect.rs"]
mod collect;
#[path = "ui/doubt.rs"]
mod doubt;
#[path = "ui/drives.rs"]
mod drives;
#[path = "ui/edit.rs"]
mod edit;
#[path = "ui/kept.rs"]
mod kept;
#[path = "ui/messages.rs"]
mod messages;
#[path = "ui/questions.rs"]
mod questions;
#[path = "ui/robot.rs"]
mod robot;
#[path = "ui/room.rs"]
mod room;
#[path = "ui/share.rs"]
pub(crate) mod share;
#[path = "ui/talk.rs"]
mod talk;
#[path = "ui/teach.rs"]
mod teach;
#[path = "ui/text.rs"]
mod text;
#[path = "ui/bench.rs"]
mod bench;
#[path = "ui/returning.rs"]
mod returning;
#[path = "ui/shelf.rs"]
mod shelf;
#[path = "ui/studies.rs"]
mod studies;
#[path = "ui/train.rs"]
mod train;

use groundling::domain::State as World;
use groundling::ui::app::{Action, State, reduce};
use groundling::ui::page::document::Document;
use groundling::ui::page::effect::{Effect, Timer};
use groundling::ui::page::engine::Health;
use groundling::ui::page::grammar::{English, Scenes};
use groundling::ui::page::history::History;
use groundling::ui::page::keep::ask::Ask;
use groundling::ui::page::language::Language;
use groundling::ui::page::world::WORLDS;
use groundling::ui::talk::Action as Talk;
use groundling::ui::talk::why::message::Message;
use groundling::ui::talk::why::messages::messages;
use groundling::worker::protocol::{
    Answer, Article, Claim, Description, Envelope, Event, Fate, Noun, PairText, PlanProgress,
    PlanText, Program, Reading, Request, TeachReport, TrainReport, VERSION, Why, Word,
};

/// What the learner says of lessons.
pub(crate) fn taught(text: &str, understood: &[bool]) -> Event {
    Event::Taught(Box::new(TeachReport {
        model: model(text),
        added: Vec::new(),
        told: Vec::new(),
        understood: understood.to_vec(),
        check: None,
        refusal: None,
        by_end: false,
    }))
}

/// A page and the engines' side of the talk: what was posted and not yet answered.
pub(crate) struct Page {
    pub(crate) state: State,
    pub(crate) posted: Vec<(Program, u32, Request)>,
    pub(crate) timers: Vec<Timer>,
    pub(crate) others: Vec<Effect>,
}

impl Page {
    /// A page that has opened; its engine is not up yet.
    pub(crate) fn new() -> Page {
        let state = State::default();
        let mut page = Page { state, posted: Vec::new(), timers: Vec::new(), others: Vec::new() };
        page.act(Action::Opened(Language::English));
        page
    }

    /// A page with its model, which other words have not come to.
    pub(crate) fn opened() -> Page {
        let mut page = Page::new();
        page.hear(Program::Talker, 0, Event::Ready);
        page.act(Action::Fetched(Ok("the model".to_owned())));
        page.answer(Event::Opened(model("the model")));
        page
    }

    /// A page with its model, and nothing at work.
    pub(crate) fn ready() -> Page {
        let mut page = Page::opened();
        page.act(Action::FetchedWords(Err("status 404".to_owned())));
        page.others.clear();
        page
    }

    /// A page that was told something: one reading, and a plan of so many steps to the east.
    pub(crate) fn told(steps: i32) -> Page {
        let mut page = Page::ready();
        page.act(Talk::AskExample("go".to_owned()));
        let start = page.shown().clone();
        page.answer(Event::Answer(Box::new(understood("go", Some(plan(&start, steps))))));
        page
    }

    /// Something happened, or was done on one of the pages.
    pub(crate) fn act(&mut self, action: impl Act) {
        for effect in reduce(&mut self.state, action.whole()) {
            match effect {
                Effect::Post(program, envelope) => {
                    assert_eq!(envelope.groundling, VERSION);
                    if let Some(own) = envelope.body.program() {
                        assert_eq!(own, program, "{:?}", envelope.body);
                    }
                    self.posted.push((program, envelope.id, envelope.body));
                }
                Effect::StartTimer(timer, ms) => {
                    assert!(ms > 0);
                    self.timers.push(timer);
                }
                other => self.others.push(other),
            }
        }
    }

    pub(crate) fn hear(&mut self, program: Program, id: u32, body: Event) {
        self.act(Action::Heard(program, Envelope { groundling: VERSION, id, body }));
    }

    /// Answers the request posted last.
    #[track_caller]
    pub(crate) fn answer(&mut self, event: Event) {
        let (program, id, _) = self.posted.pop().expect("a request is at work");
        self.hear(program, id, event);
    }

    /// The request posted last.
    #[track_caller]
    pub(crate) fn asked(&self) -> &Request {
        &self.posted.last().expect("a request is at work").2
    }

    pub(crate) fn shown(&self) -> &World {
        self.state.talk.shown(&self.state.shared)
    }

    pub(crate) fn heard(&self) -> Option<&Answer> {
        self.state.talk.heard(&self.state.shared)
    }

    pub(crate) fn messages(&self) -> Vec<Message> {
        messages(&self.state.talk, &self.state.shared)
    }

    pub(crate) fn can_ask(&self) -> bool {
        self.state.shared.can_ask()
    }

    /// Rings the timers that were started, until one that plays the plan has rung.
    pub(crate) fn play_on(&mut self) -> bool {
        let timers = std::mem::take(&mut self.timers);
        let play = timers.into_iter().rev().find(|t| matches!(t, Timer::Play(_)));
        play.map(|timer| self.act(Action::Rang(timer))).is_some()
    }
}

/// What can be done: on the whole, or on one of the pages.
pub(crate) trait Act {
    fn whole(self) -> Action;
}

impl Act for Action {
    fn whole(self) -> Action {
        self
    }
}

impl Act for Talk {
    fn whole(self) -> Action {
        Action::Talk(self)
    }
}

pub(crate) fn model(text: &str) -> TrainReport {
    TrainReport { model: text.to_owned(), examples: 6, valid: 6, entries: 30 }
}

pub(crate) fn world() -> World {
    Document::new().world
}

pub(crate) fn pair() -> PairText {
    PairText { pre: world(), post: world() }
}

pub(crate) fn word(text: &str, fate: Fate) -> Word {
    Word { text: text.to_owned(), heard: None, fate, closed: None, near: Vec::new() }
}

/// A reading of a form: "the robot is the robot".
pub(crate) fn reading(form: &str) -> Reading {
    Reading {
        form: form.to_owned(),
        formula: Vec::new(),
        claim: Claim::Related {
            relation: "eq".to_owned(),
            nouns: Box::new([Noun::Robot, Noun::Robot]),
        },
        score: 1.0,
        nodes: Vec::new(),
        derivation: String::new(),
        phrases: Vec::new(),
        cells: Vec::new(),
        forbidden: Vec::new(),
    }
}

/// A reading that says where the robot is not to be: "the robot is outside the red room".
pub(crate) fn outside(form: &str) -> Reading {
    let room = Noun::Described(Box::new(Description {
        article: Article::The,
        properties: vec!["red".to_owned(), "room".to_owned()],
        claims: Vec::new(),
    }));
    let nouns = Box::new([Noun::Robot, room]);
    let inside = Claim::Related { relation: "in".to_owned(), nouns };
    Reading { claim: Claim::Not(Box::new(inside)), ..reading(form) }
}

/// What a planner says that had nothing to think about.
pub(crate) fn work() -> PlanProgress {
    PlanProgress {
        solver: "astar".to_owned(),
        why: Why::Sure,
        states: 9,
        steps: 9,
        residual: 0.0,
        bounds: [0.9, 0.9],
        least: 9,
    }
}

/// A plan that walks the robot east from where `from` has it.
pub(crate) fn plan(from: &World, steps: i32) -> PlanText {
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
        work: Some(work()),
        done: Vec::new(),
        instead: None,
    }
}

/// No plan, for a reason.
pub(crate) fn no_plan(reason: &str) -> PlanText {
    let reason = Some(reason.to_owned());
    PlanText { reason, reached: false, work: None, states: Vec::new(), ..plan(&world(), 0) }
}

pub(crate) fn understood(command: &str, plan: Option<PlanText>) -> Answer {
    Answer {
        command: command.to_owned(),
        words: command.split(' ').map(|text| word(text, Fate::Meant)).collect(),
        readings: vec![reading("(f:t)")],
        taken: Vec::new(),
        reason: None,
        asks: Vec::new(),
        probability: None,
        plan,
    }
}

pub(crate) fn failed(command: &str, reason: &str) -> Answer {
    let reason = Some(reason.to_owned());
    Answer { readings: Vec::new(), reason, ..understood(command, None) }
}

#[test]
fn it_opens_with_the_engine_that_answers_and_the_model() {
    let mut page = Page::new();
    assert_eq!(
        page.others,
        [
            Effect::SpawnEngine(Program::Talker),
            Effect::FetchModel,
            Effect::SetLanguage(Language::English),
            Effect::Focus("command"),
            Effect::Keep(Ask::Open),
        ]
    );
    page.act(Action::Fetched(Ok("the model".to_owned())));
    assert!(page.posted.is_empty(), "nothing is sent before the engine is up");
    page.hear(Program::Talker, 0, Event::Ready);
    assert_eq!(page.asked(), &Request::OpenModel { text: "the model".to_owned() });
    assert!(!page.can_ask());
    page.answer(Event::Opened(model("the model")));
    assert!(page.can_ask() && page.posted.is_empty());
    assert_eq!(page.state.shared.learner.health, Health::Asleep, "nobody has asked to learn");
}

#[test]
fn a_model_that_does_not_come_is_told_and_can_be_fetched_again() {
    let mut page = Page::new();
    page.hear(Program::Talker, 0, Event::Ready);
    page.act(Action::Fetched(Err("status 404".to_owned())));
    assert!(page.state.shared.model_notice.as_ref().is_some_and(|words| words.contains("404")));
    page.others.clear();
    page.act(Talk::FetchModel);
    assert_eq!(page.others, [Effect::FetchModel]);
    assert_eq!(page.state.shared.model_notice, None);
}

#[test]
fn the_worlds_it_offers_are_legal_and_have_a_blue_room() {
    for choice in WORLDS {
        let world = choice.open().expect("a world is a state");
        world.check().unwrap_or_else(|errors| panic!("{:?}: {errors:?}", choice.name));
        let words = English.world(&world);
        assert!(words.contains("blue") && world.rooms.len() == 3, "{words}");
    }
}

#[test]
fn a_stopped_engine_is_started_again_with_all_it_had() {
    let mut page = Page::told(2);
    let before = page.state.shared.document.clone();
    page.hear(Program::Talker, 0, Event::Crashed { message: "first".to_owned() });
    page.act(Action::EngineBroke(Program::Talker, "second".to_owned()));
    assert_eq!(page.state.shared.talker.health, Health::Stopped("first".to_owned()));
    assert!(!page.can_ask());
    page.posted.clear();
    page.others.clear();
    page.act(Action::RestartEngine(Program::Talker));
    assert_eq!(page.others, [Effect::SpawnEngine(Program::Talker)]);
    page.hear(Program::Talker, 0, Event::Ready);
    assert_eq!(page.asked(), &Request::OpenModel { text: "the model".to_owned() });
    page.answer(Event::Opened(model("the model")));
    assert!(page.can_ask());
    assert_eq!(page.state.shared.document, before, "nothing is lost");
}

#[test]
fn an_engine_that_says_nothing_is_given_up() {
    let mut page = Page::ready();
    page.act(Talk::AskExample("go".to_owned()));
    let talker = |page: &Page| page.state.shared.talker.health.clone();
    for _ in 0..4 {
        let watch = page.timers.pop().expect("a watch is kept");
        page.act(Action::Rang(watch));
        assert_eq!(talker(&page), Health::Ready);
        assert_eq!(page.posted.pop(), Some((Program::Talker, 0, Request::Ping)));
    }
    page.hear(Program::Talker, 0, Event::Pong);
    for _ in 0..5 {
        assert_eq!(talker(&page), Health::Ready);
        let watch = page.timers.pop().expect("a watch is kept");
        page.act(Action::Rang(watch));
    }
    assert!(matches!(talker(&page), Health::Stopped(_)));
}

#[test]
fn an_engine_of_another_version_is_refused() {
    let mut page = Page::ready();
    let envelope = Envelope { groundling: VERSION + 1, id: 0, body: Event::Pong };
    page.act(Action::Heard(Program::Talker, envelope));
    assert!(matches!(page.state.shared.talker.health, Health::Stopped(_)));
}

#[test]
fn undo_and_redo_are_each_other_s_inverse() {
    let mut history = History::new();
    let mut now = 0;
    for next in 1..=3 {
        history.record(now);
        now = next;
    }
    assert!(history.undo(&mut now) && history.undo(&mut now));
    assert_eq!(now, 1);
    assert!(history.redo(&mut now) && now == 2);
    history.record(now);
    now = 9;
    assert!(!history.can_redo(), "what was undone is forgotten once something else is done");
    assert!(history.undo(&mut now) && now == 2);
    while history.undo(&mut now) {}
    assert_eq!(now, 0);
}
