//! Why a command came to nothing, or to less than it might: what is wrong, what to do about it, and what the page can
//! do at the press of a button.

use super::help::Help;
use super::instead::instead;
use super::message::{Message, message};
use crate::domain::{Color, Lock, Shape};
use crate::ui::page::document::Said;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask::is_asking;
use crate::ui::talk::command::link::{self, Link};
use crate::ui::talk::room::edit::Look;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{
    Answer, Article, Closed, Fate, Noun, Phrase, PlanText, Reading, Referent, Refers, Word, beyond,
    lost,
};

/// Help that is offered at most so often for one phrase.
const MOST_HELPS: usize = 4;

/// Everything worth telling about the answer that is shown, in the order in which the command went wrong; empty when
/// it was understood and there is a plan to play.
pub fn messages(state: &State, shared: &Shared) -> Vec<Message> {
    let Some(answer) = state.heard(shared) else { return Vec::new() };
    let text = Text::of(shared.language);
    let mut messages = Vec::new();
    let reading = state.heard_reading(shared);
    messages.extend(taken(text, answer, reading));
    let beyond = beyond_language(text, answer);
    if beyond.is_some() && reading.is_none() {
        return beyond.into_iter().collect();
    }
    messages.extend(beyond);
    messages.extend(parsing(text, answer));
    match (answer.reason.as_deref(), reading) {
        (Some("left_out"), reading) => {
            let is_open = state.command.live.is_none() && !is_planned(shared);
            messages.push(half(text, answer, reading.filter(|_| is_open)));
        }
        _ => messages.extend(left_out(text, answer)),
    }
    if let Some(reading) = reading {
        let failing =
            reading.phrases.iter().filter(|p| !matches!(p.refers, Refers::One | Refers::Inner));
        messages.extend(failing.map(|phrase| reference(text, answer, phrase)));
    }
    // What is typed has no plan yet.
    if state.command.live.is_none()
        && let Some(Said { plan: Some(plan), .. }) = &shared.document.said
    {
        let refers = messages.iter().all(|message| message.kind != "no_referent");
        messages.extend(planning(state, shared, plan, reading, refers));
    }
    messages
}

fn parsing(text: &Text, answer: &Answer) -> Option<Message> {
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
        // Told by a question, and by what was left out.
        "tie" | "left_out" => return None,
        "budget" => message("budget", why.budget, None, Vec::new()),
        _ => message("other", why.no_parse, None, vec![Help::Teach]),
    })
}

/// What lies beyond the language of what was not understood, the first of its kinds.
fn beyond_language(text: &Text, answer: &Answer) -> Option<Message> {
    let kinds = answer
        .words
        .iter()
        .enumerate()
        .filter_map(|(at, word)| Some((at, &*word.text, lost(word)?)));
    let (first, _, kind) = kinds.clone().next()?;
    let words: Vec<&str> = kinds.filter(|one| one.2 == kind).map(|(_, word, _)| word).collect();
    let what = (text.beyond)(kind, &words);
    let link = Some((first, first + 1));
    Some(message("beyond", (what, text.beyond_fix), link, vec![Help::Guide]))
}

/// What words were taken for that are none of the lexicon's: other words, and colours.
fn taken(text: &Text, answer: &Answer, reading: Option<&Reading>) -> Option<Message> {
    let own = |(start, end): Link| {
        let words = answer.words.get(start..end).unwrap_or_default();
        words.iter().map(|word| &*word.text).collect::<Vec<_>>().join(" ")
    };
    let words = answer.taken.iter().map(|one| (own(one.words), one.name.clone()));
    let phrases = reading.map_or(&[][..], |reading| &reading.phrases);
    let shades = phrases.iter().filter_map(|phrase| phrase.taken);
    let shades = shades
        .map(|(shade, color)| (shade.name().to_owned(), text.phrases.color(color).to_owned()));
    let all: Vec<String> =
        words.chain(shades).map(|(own, other)| (text.take_for)(&own, &other)).collect();
    let link = answer.taken.first().map(|one| one.words);
    (!all.is_empty()).then(|| message("taken", (all.join(" "), ""), link, Vec::new()))
}

/// What cannot be understood without leaving out words that it would not mean the same without; the rest is offered, if
/// that can be chosen.
fn half(text: &Text, answer: &Answer, rest: Option<&Reading>) -> Message {
    let why = &text.why;
    let out = |word: &Word| matches!(word.fate, Fate::Skipped | Fate::Unknown);
    let runs = answer.words.chunk_by(|a, b| out(a) == out(b)).filter(|run| run.iter().any(out));
    let runs: Vec<String> =
        runs.map(|run| run.iter().map(|word| &*word.text).collect::<Vec<_>>().join(" ")).collect();
    let runs: Vec<&str> = runs.iter().map(String::as_str).collect();
    let does = |kind| answer.words.iter().any(|word| out(word) && word.closed == Some(kind));
    let (kind, fix) = if does(Closed::Orders) {
        ("time", why.half_time)
    } else if does(Closed::Turns) {
        ("prohibition", why.half_denied)
    } else {
        ("half", why.half_other)
    };
    let what = if answer.readings.is_empty() { why.nothing_without } else { why.half };
    let just = rest.map(|rest| Help::Just(rest.claim.clone()));
    let first = answer.words.iter().position(out).map(|place| (place, place + 1));
    message(kind, (what(&runs), fix), first, just.into_iter().chain([Help::Teach]).collect())
}

/// Whether something was done about the last command, or was to be.
fn is_planned(shared: &Shared) -> bool {
    is_asking(shared) || shared.document.plan().is_some()
}

/// Words that were left out so that the rest could be understood: never seen ones first.
fn left_out(text: &Text, answer: &Answer) -> Vec<Message> {
    if answer.readings.is_empty() {
        return Vec::new();
    }
    let why = &text.why;
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
    let of_fate = move |word: &Word| word.fate == fate && beyond(&word.text).is_none();
    let words = answer.words.iter().enumerate().filter(move |(_, word)| of_fate(word));
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
fn reference(text: &Text, answer: &Answer, phrase: &Phrase) -> Message {
    let own = link::span(phrase).map(|own| with_article(answer, own));
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
    let what = text.phrases.failure(phrase);
    message("no_referent", (what, text.why.no_referent), own, helps)
}

/// Words with the article before them, where the parser found no meaning in that: a name has its own.
fn with_article(answer: &Answer, (start, end): Link) -> Link {
    let before = start.checked_sub(1).and_then(|place| answer.words.get(place));
    let is_article = |word: &Word| word.fate == Fate::Empty && word.text == "the";
    (start - usize::from(before.is_some_and(is_article)), end)
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
        property.parse::<Color>().is_ok()
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
        color: color.unwrap_or(Color::Yellow),
        size: None,
    })
}

fn planning(
    state: &State,
    shared: &Shared,
    plan: &PlanText,
    reading: Option<&Reading>,
    refers: bool,
) -> Option<Message> {
    let text = Text::of(shared.language);
    let why = &text.why;
    if let Some(message) = instead(text, plan) {
        return Some(message);
    }
    let rules = &shared.document.rules;
    let locked = state.shown(shared).doors.iter().any(|door| door.lock != Lock::Unlocked);
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
            let phrases = Text::of(shared.language).phrases;
            if let Some(words) = reading.and_then(|reading| phrases.keeps(&reading.claim)) {
                return Some(message("keeps", (words, why.keeps), None, Vec::new()));
            }
            let link = reading.and_then(|reading| link::span(reading.phrases.last()?));
            message("already_true", why.already_true, link, vec![Help::OtherWorld])
        }
        None if !plan.reached => {
            message("not_reached", why.not_reached, None, vec![Help::NoChance])
        }
        None => return None,
    })
}
