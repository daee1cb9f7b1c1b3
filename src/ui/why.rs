//! Why a command came to nothing, or to less than it might: what is wrong, what to do about it, and what the page can
//! do at the press of a button.

use super::action::Effect;
use super::document::Said;
use super::edit::{self, Look, Obstacle};
use super::link::{self, Link};
use super::room::{self, Mode};
use super::state::State;
use super::{talk, teach};
use crate::domain::{Lock, Shape, State as World};

use crate::worker::protocol::{
    Answer, Article, Fate, Noun, Phrase, PlanText, Reading, Referent, Refers, WorldRules,
};

/// Help that is offered at most so often for one phrase.
const MOST_HELPS: usize = 4;

/// One thing that is wrong, or worth knowing.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Its kind: names the message in tests and styles.
    pub kind: &'static str,
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub fix: String,
    /// The words that it is about.
    pub link: Option<Link>,
    /// What the page can do.
    pub helps: Vec<Help>,
}

/// What the page can do about a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Help {
    /// Says a word in place of others, and asks again: the places of the words, and what to say.
    Say(Link, String),
    /// Shows what the command means.
    Teach,
    /// Points at words, and at what is in question in the room.
    Show(Link),
    /// Puts a thing into the room, and asks again.
    Add(Look),
    /// Changes the room.
    Edit,
    /// Lets the robot move what the command does not name, and asks again.
    FreeLandmarks,
    /// Lets the robot pull, and asks again.
    Pull,
    /// Opens all doors, and asks again.
    Unlock,
    /// Leaves nothing to chance, and asks again.
    NoChance,
    /// Goes to another random world.
    OtherWorld,
}

/// Everything worth telling about the answer that is shown, in the order in which the command went wrong; empty when
/// it was understood and there is a plan to play.
pub fn messages(state: &State) -> Vec<Message> {
    let Some(answer) = state.heard() else { return Vec::new() };
    let mut messages = Vec::new();
    messages.extend(parsing(state, answer));
    messages.extend(left_out(state, answer));
    let reading = state.heard_reading();
    if let Some(reading) = reading {
        let failing =
            reading.phrases.iter().filter(|p| !matches!(p.refers, Refers::One | Refers::Inner));
        messages.extend(failing.map(|phrase| reference(state, phrase)));
    }
    // What is typed has no plan yet.
    if state.talk.live.is_none()
        && let Some(Said { plan: Some(plan), .. }) = &state.document.said
    {
        let refers = messages.iter().all(|message| message.kind != "no_referent");
        messages.extend(planning(state, plan, reading, refers));
    }
    messages
}

fn message(
    kind: &'static str,
    (what, fix): (impl Into<String>, &str),
    link: Option<Link>,
    helps: Vec<Help>,
) -> Message {
    Message { kind, what: what.into(), fix: fix.to_owned(), link, helps }
}

fn parsing(state: &State, answer: &Answer) -> Option<Message> {
    let text = state.text();
    let unknown: Vec<&str> = with_fate(answer, Fate::Unknown).map(|(_, word)| word).collect();
    let why = &text.why;
    Some(match answer.reason.as_deref()? {
        "empty" => message("empty", why.empty, None, Vec::new()),
        "too_long" => message("too_long", why.too_long, None, Vec::new()),
        "unknown_words" => {
            let what = (why.unknown_words.0)(&unknown);
            message("unknown_words", (what, why.unknown_words.1), None, spellings(answer, true))
        }
        "no_parse" => message("no_parse", why.no_parse, None, vec![Help::Teach]),
        "tie" => {
            let what = (why.tie.0)(answer.readings.len());
            message("tie", (what, why.tie.1), None, Vec::new())
        }
        "budget" => message("budget", why.budget, None, Vec::new()),
        _ => message("other", why.no_parse, None, vec![Help::Teach]),
    })
}

/// Words that were left out so that the rest could be understood: never seen ones first.
fn left_out(state: &State, answer: &Answer) -> Vec<Message> {
    if answer.readings.is_empty() {
        return Vec::new();
    }
    let why = &state.text().why;
    let told = |fate, kind, (what, fix): (fn(&[&str]) -> String, &str), helps| {
        let words: Vec<&str> = with_fate(answer, fate).map(|(_, word)| word).collect();
        let first = with_fate(answer, fate).next().map(|(place, _)| (place, place + 1));
        (!words.is_empty()).then(|| message(kind, (what(&words), fix), first, helps))
    };
    let unknown =
        told(Fate::Unknown, "unknown_words", why.unknown_left_out, spellings(answer, true));
    let known = told(Fate::Skipped, "skipped", why.skipped, vec![Help::Teach]);
    unknown.into_iter().chain(known).collect()
}

fn with_fate(answer: &Answer, fate: Fate) -> impl Iterator<Item = (usize, &str)> {
    let words = answer.words.iter().enumerate().filter(move |(_, word)| word.fate == fate);
    words.map(|(place, word)| (place, &*word.text))
}

/// Known words in place of unknown ones; teaching, too.
fn spellings(answer: &Answer, teach: bool) -> Vec<Help> {
    let words = answer.words.iter().enumerate().filter(|(_, word)| word.fate == Fate::Unknown);
    let near = words.flat_map(|(place, word)| {
        word.near.iter().map(move |near| Help::Say((place, place + 1), near.clone()))
    });
    near.take(MOST_HELPS).chain(teach.then_some(Help::Teach)).collect()
}

/// A phrase that does not refer, with what would.
fn reference(state: &State, phrase: &Phrase) -> Message {
    let text = state.text();
    let own = link::span(phrase);
    let mut helps: Vec<Help> = own.map(Help::Show).into_iter().collect();
    match phrase.refers {
        Refers::Several | Refers::Tie => helps.extend(own.into_iter().flat_map(|own| {
            let names = phrase.referents.iter().filter_map(|r| distinct(r, &phrase.referents));
            names.take(MOST_HELPS).map(move |name| Help::Say(own, name))
        })),
        Refers::None => helps = look(phrase).map(Help::Add).into_iter().collect(),
        _ => {}
    }
    helps.push(Help::Edit);
    let what = text.failure(phrase);
    message("no_referent", (what, text.why.no_referent), own, helps)
}

/// A name in the parser's English that fits this thing and none of the others.
fn distinct(referent: &Referent, all: &[Referent]) -> Option<String> {
    let name = |r: &Referent| {
        let noun: &str = match r.shape {
            Some(shape) => shape.name(),
            None => &r.class,
        };
        Some(format!("the {} {noun}", r.color?.name()))
    };
    let own = name(referent)?;
    (all.iter().filter(|r| name(r).as_ref() == Some(&own)).count() == 1).then_some(own)
}

/// How an object would look that a phrase without a referent describes, if it says no more than that.
fn look(phrase: &Phrase) -> Option<Look> {
    let Noun::Described(described) = &phrase.noun else { return None };
    if described.article != Article::The || !described.claims.is_empty() {
        return None;
    }
    let known = |property: &String| {
        property.parse::<crate::domain::Color>().is_ok()
            || property.parse::<Shape>().is_ok()
            || property == "object"
    };
    if !described.properties.iter().all(known) {
        return None;
    }
    let shape = described.properties.iter().find_map(|p| p.parse().ok());
    let color = described.properties.iter().find_map(|p| p.parse().ok());
    shape.is_some().then(|| Look {
        shape: shape.unwrap_or(Shape::Block),
        color: color.unwrap_or(crate::domain::Color::Yellow),
        size: None,
    })
}

fn planning(
    state: &State,
    plan: &PlanText,
    reading: Option<&Reading>,
    refers: bool,
) -> Option<Message> {
    let why = &state.text().why;
    let rules = &state.document.rules;
    let locked = state.shown().doors.iter().any(|door| door.lock != Lock::Unlocked);
    let freeing = [
        (rules.landmarks_stay, Help::FreeLandmarks),
        (!rules.pull, Help::Pull),
        (locked, Help::Unlock),
    ];
    let freeing =
        || freeing.iter().filter(|(useful, _)| *useful).map(|(_, help)| help.clone()).collect();
    Some(match plan.reason.as_deref() {
        Some("no_referent") if refers => {
            message("no_referent", (why.no_world, why.no_referent), None, vec![Help::Edit])
        }
        Some("no_referent") => return None,
        Some("unreachable") => message("unreachable", why.unreachable, None, freeing()),
        Some("budget") if plan.reached => return None,
        Some("budget") => {
            let helps = if rules.is_sure() { freeing() } else { vec![Help::NoChance] };
            message("plan_budget", why.plan_budget, None, helps)
        }
        Some(_) => message("bad_goal", why.bad_goal, None, vec![Help::Teach]),
        None if plan.actions.is_empty() && plan.reached => {
            let link = reading.and_then(|reading| link::span(reading.phrases.last()?));
            message("already_true", why.already_true, link, vec![Help::OtherWorld])
        }
        None if !plan.reached => {
            message("not_reached", why.not_reached, None, vec![Help::NoChance])
        }
        None => return None,
    })
}

/// Does what a button of a message says.
pub(super) fn help(state: &mut State, help: Help, effects: &mut Vec<Effect>) {
    let rules = state.document.rules;
    let again = |state: &mut State, rules: WorldRules, effects: &mut Vec<Effect>| {
        state.record();
        state.document.rules = rules;
        talk::plan_again(state, effects);
    };
    match help {
        Help::Say((start, end), phrase) => {
            let Some(answer) = state.heard() else { return };
            let mut words: Vec<String> =
                answer.words.iter().map(|word| word.text.clone()).collect();
            if start <= end && end <= words.len() {
                words.splice(start..end, [phrase]);
                state.talk.input = words.join(" ");
                talk::ask(state, effects);
            }
        }
        Help::Teach => {
            let command = command(state);
            room::act(state, super::Action::SetMode(Mode::Teach), effects);
            teach::say(state, command);
            effects.push(Effect::Focus("room"));
        }
        Help::Show(link) => state.talk.link = Some(link),
        Help::Add(look) => {
            in_another_room(state, edit::add_anywhere(state.shown(), look), effects);
        }
        Help::Edit => {
            room::act(state, super::Action::SetMode(Mode::Edit), effects);
            effects.push(Effect::Focus("room"));
        }
        Help::FreeLandmarks => again(state, WorldRules { landmarks_stay: false, ..rules }, effects),
        Help::Pull => again(state, WorldRules { pull: true, ..rules }, effects),
        Help::NoChance => {
            again(state, WorldRules { slip: 0.0, lock: 0.0, loss: 0.0, ..rules }, effects);
        }
        Help::Unlock => in_another_room(state, Ok(edit::unlock(state.shown())), effects),
        Help::OtherWorld => room::act(state, super::Action::DrawWorld, effects),
    }
}

/// The command that the answer shown is to.
fn command(state: &State) -> String {
    state.heard().map(|answer| answer.command.clone()).unwrap_or_default()
}

/// Changes the room, and says the same in it again.
fn in_another_room(state: &mut State, changed: Result<World, Obstacle>, effects: &mut Vec<Effect>) {
    let command = command(state);
    // Not what is being demonstrated.
    state.room.mode = Mode::Watch;
    room::changed_to(state, changed, effects);
    state.talk.input = command;
    talk::ask(state, effects);
}
