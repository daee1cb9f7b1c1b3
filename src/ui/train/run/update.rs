//! Does what a person wants about training.

use super::action::Action;
use super::picture::picture;
use super::state::{Pace, Run, State, can_train};
use super::words::Text;
use crate::ui::page::files::Offered;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Lexicon, Request, Settings};

/// Milliseconds between two looks at what is learned.
const LOOK_MS: u32 = 400;

/// Bytes that a lexicon of one's own may have.
const MOST_LEXICON: usize = 4_000_000;

/// What a run would be on: the name of the corpus, its commands, and what suits it as known before.
pub struct Ground {
    /// The corpus's name.
    pub name: String,
    /// The name that it is kept under.
    pub pack: String,
    /// Commands that are learned from.
    pub commands: usize,
    /// What suits it.
    pub lexicon: Lexicon,
    /// Whether training is to be seen.
    pub seen: bool,
}

/// Does what a person wants.
pub fn update(state: &mut State, desk: &mut Desk, action: Action, ground: Ground) {
    match action {
        Action::Go => go(state, desk, ground),
        Action::Pause => {
            if let Some(run) = live(state) {
                run.pace = Pace::Pauses;
                desk.ask(Request::Pause);
            }
        }
        Action::StepExample => step(state, desk, ground, Request::StepExample),
        Action::StepEpoch => step(state, desk, ground, Request::StepEpoch),
        Action::Stop => {
            desk.learner.retain(|request| !matches!(request, Request::Learn { .. }));
            if desk.is_learning() {
                desk.cancel();
            }
        }
        Action::GoOn => {
            if let Some(run) = state.run.as_mut().filter(|_| can_train(desk, ground.commands)) {
                run.pace = Pace::Goes;
                run.clock.rest();
                state.notice = None;
                learn(run, desk);
                look_on(state, desk);
            }
        }
        Action::UseSoFar => desk.ask(Request::ModelSoFar),
        Action::Set(setting) => state.set(setting),
        Action::OwnLexicon(files) => own(state, desk, files),
        Action::SaveCurves => {
            if let Some(run) = &state.run {
                let text = picture(&run.points, Text::of(desk.language));
                desk.want(Effect::Save { name: "curves.svg".to_owned(), text });
            }
        }
        Action::Paper => (state.settings, state.lexicon) = (Settings::default(), None),
        Action::SaveModel => {
            if let Some(model) = &desk.in_use {
                let text = model.report.model.clone();
                desk.want(Effect::Save { name: "groundling.model".to_owned(), text });
            }
        }
        Action::Rang(timer) if timer == state.timer && state.live().is_some() => {
            if ground.seen {
                desk.ask(Request::Look);
            }
            look_on(state, desk);
        }
        Action::Rang(_) => {}
    }
}

/// The engine that a run was at work in has died: a new one goes on from the last checkpoint, unless the run did not get
/// on since the one before. Whether it does.
pub fn retry(state: &mut State) -> bool {
    let Some(run) = live(state).filter(|run| !run.is_retried) else {
        stop(state);
        return false;
    };
    run.is_retried = true;
    run.clock.rest();
    true
}

/// The new engine has its corpus: the run goes on.
pub fn restore(state: &mut State, desk: &mut Desk) {
    match live(state) {
        Some(run) => {
            run.pace = Pace::Goes;
            learn(run, desk);
        }
        None => state.run.iter().for_each(|run| recall(run, desk)),
    }
}

/// A run that was kept is here again, whose corpus is being read; it goes on if it was at work, or stands as it was.
pub fn bring_back(state: &mut State, desk: &mut Desk, mut run: Run) {
    let goes = run.pace == Pace::Goes;
    match run.pace {
        Pace::Goes => learn(&run, desk),
        Pace::Over => recall(&run, desk),
        _ => run.pace = Pace::Stopped,
    }
    (state.run, state.notice) = (Some(run), None);
    if goes {
        look_on(state, desk);
    }
}

/// The run is at work no more.
pub fn stop(state: &mut State) {
    if let Some(run) = live(state) {
        run.pace = Pace::Stopped;
    }
}

fn live(state: &mut State) -> Option<&mut Run> {
    state.run.as_mut().filter(|run| !run.is_still())
}

fn go(state: &mut State, desk: &mut Desk, ground: Ground) {
    if let Some(run) = live(state) {
        run.pace = Pace::Goes;
        return desk.ask(Request::Resume);
    }
    if can_train(desk, ground.commands) {
        begin(state, desk, ground);
    }
}

fn step(state: &mut State, desk: &mut Desk, ground: Ground, step: Request) {
    if state.live().is_none() {
        if !can_train(desk, ground.commands) {
            return;
        }
        begin(state, desk, ground);
    }
    if let Some(run) = live(state) {
        run.pace = Pace::Pauses;
    }
    desk.ask(step);
}

fn begin(state: &mut State, desk: &mut Desk, ground: Ground) {
    state.notice = None;
    desk.say(Text::of(desk.language).begun);
    let run = Run::new(state.settings(ground.lexicon), ground.name, ground.pack);
    desk.ask(Request::Decisions);
    learn(&run, desk);
    state.run = Some(run);
    look_on(state, desk);
}

/// Asks for a run from its checkpoint, or from the beginning.
fn learn(run: &Run, desk: &mut Desk) {
    let resume = run.checkpoint.as_ref().map(|(text, _)| text.clone());
    desk.send(Request::Learn { settings: Box::new(run.settings.clone()), resume }, false);
}

/// Has the engine take a run that is over up again, for what it learned.
fn recall(run: &Run, desk: &mut Desk) {
    let kept = (&run.checkpoint, &run.decisions, run.pace);
    if let (Some((text, _)), Some(decisions), Pace::Over) = kept {
        let (settings, checkpoint) = (Box::new(run.settings.clone()), text.clone());
        let decisions = decisions.clone();
        desk.send(Request::Recall { settings, decisions, checkpoint }, false);
    }
}

/// A person's own lexicon is chosen; what is wrong with it the engine says when it is used.
fn own(state: &mut State, desk: &mut Desk, files: Vec<Offered>) {
    let Some(Offered { name, bytes }) = files.into_iter().next() else { return };
    let text = bytes.ok().and_then(|bytes| String::from_utf8(bytes).ok());
    let Some(text) = text.filter(|text| text.len() <= MOST_LEXICON) else {
        let words = (Text::of(desk.language).no_lexicon)(&name);
        desk.say(words.clone());
        state.notice = Some(words);
        return;
    };
    state.lexicon = Some(Lexicon::Own(text.clone()));
    (state.own, state.notice) = (Some((name, text)), None);
}

fn look_on(state: &mut State, desk: &mut Desk) {
    state.timer = state.timer.wrapping_add(1);
    desk.want(Effect::Ring(state.timer, LOOK_MS));
}
