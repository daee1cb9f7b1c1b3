//! The page's state and its one reducer: `reduce(state, action)` changes the state and returns what is to be
//! done. Pure: no browser, no clock. Nothing that is loaded is lost but by being replaced with a good one.

use super::action::{Action, Effect, Preferences, Timer};
use super::corpus::{Corpus, DEMO, DEMO_NAME, SMALL};
use super::engine::{Engine, Health};
use super::files::{self, Kind};
use super::playback::{Playback, STEP_MS};
use super::world::World;
use super::{describe, why};
use crate::domain::State as WorldState;
use crate::worker::protocol::{
    Answer, Envelope, Event, PlanText, Problem, Program, Progress, Request, SeedLexicon,
    TrainReport, TrainSettings, VERSION, WorldRules,
};
use std::rc::Rc;

/// The paper's settings, which the page trains with.
pub const SETTINGS: TrainSettings =
    TrainSettings { epochs: 15, beam: 150, lexical_beam: 75, demonstrations: None, seed: 0 };

/// All that the page knows.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The engine that talks.
    pub talker: Engine,
    /// The engine that learns.
    pub learner: Engine,
    /// The corpus that is open.
    pub corpus: Option<Corpus>,
    /// What is wrong with the file that was opened last: words, and problems by line.
    pub file_notice: Option<FileNotice>,
    /// How far training is, while it runs.
    pub progress: Option<Progress>,
    /// The model, once there is one, and where it came from.
    pub model: Option<Model>,
    /// What came of training or of opening a model, when it is not a model.
    pub model_notice: Option<String>,
    /// What stands in the command box.
    pub command: String,
    /// What the last command came to.
    pub answer: Option<Rc<Answer>>,
    /// Why the last command was not answered at all.
    pub ask_notice: Option<String>,
    /// The world.
    pub world: World,
    /// The plan that is played in it.
    pub playback: Option<Playback>,
    /// What a screen reader is told.
    pub announcement: String,
    /// What the person prefers.
    pub preferences: Preferences,
    play: u32,
}

/// A model, and the name of what it was trained on or opened from.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// What the engine says of it.
    pub report: Rc<TrainReport>,
    /// The corpus that it was trained on, or the file that it came from.
    pub origin: String,
}

/// What is wrong with a file that was offered.
#[derive(Clone, Debug, PartialEq)]
pub struct FileNotice {
    /// In words.
    pub message: String,
    /// By line and column.
    pub problems: Vec<Problem>,
}

impl State {
    /// A page that has not opened yet.
    pub fn new() -> State {
        State {
            talker: Engine::new(Program::Talker),
            learner: Engine::new(Program::Learner),
            corpus: None,
            file_notice: None,
            progress: None,
            model: None,
            model_notice: None,
            command: String::new(),
            answer: None,
            ask_notice: None,
            world: World::open(0).unwrap_or_else(World::empty),
            playback: None,
            announcement: String::new(),
            preferences: Preferences::default(),
            play: 0,
        }
    }

    /// The state of the world that is shown: a step of the plan, or the world itself.
    pub fn shown(&self) -> &WorldState {
        self.playback.as_ref().and_then(Playback::shown).unwrap_or(&self.world.current)
    }

    /// Whether a command can be sent.
    pub fn can_ask(&self) -> bool {
        self.model.is_some() && self.talker.health == Health::Ready && !self.is_training()
    }

    /// Whether training can begin.
    pub fn can_train(&self) -> bool {
        let rows = self.corpus.as_ref().map_or(0, |c| c.report.rows.len());
        rows > 0 && self.learner.health == Health::Ready && !self.is_training()
    }

    /// Whether a parser is being learned, or will be as soon as it can.
    pub fn is_training(&self) -> bool {
        self.learner.is_at(|request| matches!(request, Request::Train { .. }))
    }

    /// Whether a command is being answered.
    pub fn is_asking(&self) -> bool {
        self.talker.is_at(|request| matches!(request, Request::Ask { .. }))
    }

    fn engine(&mut self, program: Program) -> &mut Engine {
        match program {
            Program::Talker => &mut self.talker,
            Program::Learner => &mut self.learner,
        }
    }

    fn say(&mut self, words: impl Into<String>) {
        self.announcement = words.into();
    }

    /// The world goes on from what is shown; no plan is left.
    fn settle(&mut self) {
        if let Some(playback) = self.playback.take() {
            let shown = playback.shown().cloned();
            self.world.current = shown.unwrap_or_else(|| self.world.current.clone());
        }
        self.play = self.play.wrapping_add(1);
    }

    fn tick(&mut self, effects: &mut Vec<Effect>) {
        self.play = self.play.wrapping_add(1);
        effects.push(Effect::StartTimer(Timer::Play(self.play), STEP_MS));
    }
}

impl Default for State {
    fn default() -> State {
        State::new()
    }
}

/// Changes the state as the action says, and returns what is to be done.
pub fn reduce(state: &mut State, action: Action) -> Vec<Effect> {
    let mut effects = Vec::new();
    match action {
        Action::Prefers(preferences) => state.preferences = preferences,
        Action::Opened => {
            state.talker.wake(&mut effects);
            read_corpus(state, DEMO_NAME.to_owned(), DEMO.to_owned(), &mut effects);
        }
        Action::Heard(program, envelope) => heard(state, program, envelope, &mut effects),
        Action::EngineBroke(program, why) => stopped(state, program, why),
        Action::Rang(Timer::Watch(program, watch)) => {
            if state.engine(program).look(watch, &mut effects) {
                stopped(state, program, "It has not answered for some seconds.".to_owned());
            }
        }
        Action::Rang(Timer::Play(play)) if play == state.play => advance(state, &mut effects),
        Action::Rang(Timer::Play(_)) => {}
        Action::RestartEngine(program) => restart(state, program, &mut effects),

        Action::FileRead { name, text } => match files::kind(&name, &text) {
            Kind::Corpus => read_corpus(state, name, text, &mut effects),
            Kind::Model => {
                state.model_notice = None;
                state.talker.send(Request::OpenModel { text }, true, &mut effects);
            }
        },
        Action::FileRefused(message) => {
            state.say(message.clone());
            state.file_notice = Some(FileNotice { message, problems: Vec::new() });
        }
        Action::OpenDemo => {
            read_corpus(state, DEMO_NAME.to_owned(), DEMO.to_owned(), &mut effects);
        }
        Action::ToggleRow(row) => toggle_row(state, row, &mut effects),
        Action::MoreRows => state.corpus.iter_mut().for_each(Corpus::more),
        Action::SaveCorpus => effects.extend(state.corpus.as_ref().map(|corpus| Effect::Save {
            name: corpus.report.name.clone(),
            text: corpus.text.to_string(),
        })),

        Action::Train => {
            if state.can_train() {
                state.model_notice = None;
                state.progress = None;
                state.say("Training has begun.");
                let is_demo = state.corpus.as_ref().is_some_and(Corpus::is_demo);
                let train = Request::Train { lexicon: lexicon(is_demo), settings: SETTINGS };
                state.learner.send(train, true, &mut effects);
            }
        }
        Action::CancelTraining => cancel_training(state, &mut effects),
        Action::SaveModel => effects.extend(state.model.as_ref().map(|model| Effect::Save {
            name: "groundling.model".to_owned(),
            text: model.report.model.clone(),
        })),

        Action::Typed(command) => state.command = command,
        Action::Ask => ask(state, &mut effects),
        Action::AskExample(command) => {
            state.command = command;
            ask(state, &mut effects);
        }

        Action::PickWorld(choice) => {
            if let Some(world) = World::open(choice) {
                state.settle();
                state.answer = None;
                state.world = world;
                state.say(describe::world(&state.world.current));
            }
        }
        Action::ResetWorld => {
            if let Some(start) = World::open(state.world.choice) {
                state.settle();
                let from = state.world.current.clone();
                state.world.change(from, start.current);
                state.say(format!("The world is as it began. {}", describe::robot(state.shown())));
            }
        }
        Action::Undo => {
            state.settle();
            if state.world.undo() {
                state.say(format!("Undone. {}", describe::robot(state.shown())));
            }
        }

        Action::TogglePlay => toggle_play(state, &mut effects),
        Action::Seek(step) => {
            if let Some(playback) = &mut state.playback {
                playback.seek(step);
                state.play = state.play.wrapping_add(1);
                say_step(state);
            }
        }
    }
    effects
}

/// The page's own sentences are there to show that nouns and verbs are learned.
fn lexicon(is_demo: bool) -> SeedLexicon {
    if is_demo { SeedLexicon::Demonstration } else { SeedLexicon::Domain }
}

fn read_corpus(state: &mut State, name: String, text: String, effects: &mut Vec<Effect>) {
    state.file_notice = None;
    state.learner.retain(|r| !matches!(r, Request::ShowRow { .. } | Request::ReadCorpus { .. }));
    state.learner.send(Request::ReadCorpus { name, text }, false, effects);
}

fn toggle_row(state: &mut State, row: usize, effects: &mut Vec<Effect>) {
    let Some(corpus) = &mut state.corpus else { return };
    corpus.open = (corpus.open != Some(row)).then_some(row);
    if corpus.open.is_some() && !corpus.pairs.contains_key(&row) {
        state.learner.send(Request::ShowRow { row }, false, effects);
    }
}

fn cancel_training(state: &mut State, effects: &mut Vec<Effect>) {
    state.learner.retain(|r| !matches!(r, Request::Train { .. }));
    let at_work = state.learner.pending.as_ref();
    if at_work.is_some_and(|p| matches!(p.request, Request::Train { .. })) {
        state.learner.cancel(effects);
    }
}

fn ask(state: &mut State, effects: &mut Vec<Effect>) {
    if !state.can_ask() {
        return;
    }
    state.settle();
    state.ask_notice = None;
    state.talker.retain(|r| !matches!(r, Request::Ask { .. }));
    let (command, world) = (state.command.clone(), state.world.current.clone());
    state.talker.send(
        Request::Ask { command, state: world, rules: WorldRules::default() },
        true,
        effects,
    );
}

/// A new engine knows nothing: it is given the corpus or the model again.
fn restart(state: &mut State, program: Program, effects: &mut Vec<Effect>) {
    *state.engine(program) = Engine::new(program);
    state.engine(program).wake(effects);
    match program {
        Program::Talker => open_model(state, effects),
        Program::Learner => {
            state.progress = None;
            let (name, text) = match &state.corpus {
                Some(corpus) => (corpus.report.name.clone(), corpus.text.to_string()),
                None => (DEMO_NAME.to_owned(), DEMO.to_owned()),
            };
            state.learner.send(Request::ReadCorpus { name, text }, false, effects);
        }
    }
    state.say("The engine is being started again.");
}

/// Gives the talker the model that there is.
fn open_model(state: &mut State, effects: &mut Vec<Effect>) {
    if let Some(model) = &state.model {
        let text = model.report.model.clone();
        state.talker.send(Request::OpenModel { text }, true, effects);
    }
}

fn stopped(state: &mut State, program: Program, why: String) {
    state.engine(program).stop(why);
    if program == Program::Learner {
        state.progress = None;
    }
    state.say("The engine has stopped. What you loaded is kept; it can be started again.");
}

fn heard(
    state: &mut State,
    program: Program,
    envelope: Envelope<Event>,
    effects: &mut Vec<Effect>,
) {
    if envelope.groundling != VERSION {
        let why = "Page and engine are of different versions. Load the page again.";
        return stopped(state, program, why.to_owned());
    }
    let engine = state.engine(program);
    if matches!(engine.health, Health::Stopped(_)) {
        return;
    }
    engine.heard();
    let id = envelope.id;
    match envelope.body {
        Event::Ready => engine.ready(effects),
        Event::Pong => {}
        Event::Crashed { message } => stopped(state, program, message),
        Event::Progress(progress) => {
            if engine.pending.as_ref().is_some_and(|p| p.id == id) {
                state.progress = Some(progress);
            }
        }
        // Nothing on the page shows how far these are.
        Event::Experimenting(_) | Event::Planning(_) | Event::RollingOut(_) => {}
        end => {
            if let Some(request) = engine.finish(id, effects) {
                finished(state, request, end, effects);
            }
        }
    }
}

fn finished(state: &mut State, request: Request, event: Event, effects: &mut Vec<Effect>) {
    if matches!(request, Request::Train { .. }) {
        state.progress = None;
    }
    match (event, request) {
        (Event::Corpus(report), Request::ReadCorpus { text, .. }) => {
            opened_corpus(state, Corpus::new(report, text), effects);
        }
        (Event::Row { row, pairs }, _) => {
            if let Some(corpus) = &mut state.corpus {
                corpus.pairs.insert(row, Rc::new(pairs));
            }
        }
        (Event::Trained(report) | Event::Opened(report), request) => {
            let corpus = state.corpus.as_ref().map(|c| c.report.name.clone());
            let before = state.model.take().filter(|m| m.report.model == report.model);
            let is_new = matches!(request, Request::Train { .. });
            let origin = match (request, before) {
                (Request::Train { .. }, _) => corpus.unwrap_or_default(),
                (_, Some(same)) => same.origin,
                _ => "a model file".to_owned(),
            };
            state.say(format!(
                "Trained: {} of {} commands have a valid meaning. Type a command.",
                report.valid, report.examples
            ));
            state.model_notice = None;
            state.model = Some(Model { report: Rc::new(report), origin });
            if is_new {
                open_model(state, effects);
            }
        }
        (Event::Answer(answer), Request::Ask { .. }) => answered(state, *answer, effects),
        (Event::Refused { message }, request) => refused(state, request, message),
        (Event::Cancelled, Request::Train { .. }) => {
            let words = "Training was stopped. What was there before is as it was.";
            state.model_notice = Some(words.to_owned());
            state.say(words);
        }
        _ => {}
    }
}

fn opened_corpus(state: &mut State, corpus: Corpus, effects: &mut Vec<Effect>) {
    let report = corpus.report.clone();
    if report.rows.is_empty() {
        let message =
            format!("No row of {} can be used. What was open before is still open.", report.name);
        state.say(message.clone());
        state.file_notice = Some(FileNotice { message, problems: report.problems.clone() });
        return;
    }
    state.say(format!("{} is open: {} commands.", report.name, report.rows.len()));
    state.file_notice = None;
    state.corpus = Some(corpus);
    if report.rows.len() <= SMALL {
        for row in 0..report.rows.len() {
            state.learner.send(Request::ShowRow { row }, false, effects);
        }
    }
}

fn refused(state: &mut State, request: Request, message: String) {
    state.say(message.clone());
    match request {
        Request::ReadCorpus { .. } => {
            state.file_notice = Some(FileNotice { message, problems: Vec::new() });
        }
        Request::Train { .. } | Request::Teach { .. } | Request::OpenModel { .. } => {
            state.model_notice = Some(message)
        }
        Request::Ask { .. } => state.ask_notice = Some(message),
        Request::ShowRow { .. }
        | Request::Plan { .. }
        | Request::Values { .. }
        | Request::RollOut { .. }
        | Request::Explain { .. }
        | Request::Draw { .. }
        | Request::ReadWorld { .. }
        | Request::WriteWorld { .. }
        | Request::Experiment { .. }
        | Request::Ping
        | Request::Cancel => {}
    }
}

fn answered(state: &mut State, answer: Answer, effects: &mut Vec<Effect>) {
    state.settle();
    state.playback = answer.plan.as_ref().and_then(|plan: &PlanText| Playback::begin(plan));
    let ends = state.playback.as_ref().and_then(|p| Some((p.first()?.clone(), p.last()?.clone())));
    if let Some((first, last)) = ends {
        state.world.change(first, last);
        state.tick(effects);
        effects.push(Effect::ShowRoom);
    }
    let messages = why::explain(&answer);
    state.say(match (messages.first(), &state.playback) {
        (Some(message), _) => format!("{} {}", message.what, message.fix),
        (None, Some(plan)) => format!("Understood. The plan has {} steps.", plan.steps()),
        (None, None) => "Understood.".to_owned(),
    });
    state.answer = Some(Rc::new(answer));
}

fn advance(state: &mut State, effects: &mut Vec<Effect>) {
    let Some(playback) = &mut state.playback else { return };
    playback.advance();
    if playback.playing() {
        state.tick(effects);
    } else if playback.ended() {
        let steps = playback.steps();
        let words = format!("Done in {steps} steps. {}", describe::robot(state.shown()));
        state.say(words);
    }
}

fn toggle_play(state: &mut State, effects: &mut Vec<Effect>) {
    let Some(playback) = &mut state.playback else { return };
    if playback.playing() {
        playback.pause();
        state.play = state.play.wrapping_add(1);
    } else {
        playback.play();
        state.tick(effects);
    }
}

fn say_step(state: &mut State) {
    let Some(playback) = &state.playback else { return };
    let action = playback.latest().unwrap_or("start");
    let step = format!("Step {} of {}: {action}.", playback.at(), playback.steps());
    let words = format!("{step} {}", describe::robot(state.shown()));
    state.say(words);
}
