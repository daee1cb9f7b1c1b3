//! Why a command came to nothing, in plain words: what is wrong, and what to do about it.

use crate::worker::protocol::{Answer, Fate, Phrase, Refers};

/// One thing that is wrong, or worth knowing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// Its kind, in the command line's words; names the message in tests and styles.
    pub kind: &'static str,
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub fix: String,
}

fn message(kind: &'static str, what: impl Into<String>, fix: impl Into<String>) -> Message {
    Message { kind, what: what.into(), fix: fix.into() }
}

/// Everything worth telling about an answer, in the order in which the command went wrong; empty when the
/// command was understood and there is a plan to play.
pub fn explain(answer: &Answer) -> Vec<Message> {
    let mut messages = Vec::new();
    messages.extend(answer.reason.as_deref().map(|reason| parsing(reason, answer)));
    messages.extend(skipping(answer));
    let Some(best) = answer.readings.first() else { return messages };
    let failing = |phrase: &&Phrase| !matches!(phrase.refers, Refers::One | Refers::Inner);
    let failures: Vec<&Phrase> = best.phrases.iter().filter(failing).collect();
    for failure in &failures {
        messages.push(message(
            "no_referent",
            fails(failure, answer),
            "Name something that is in the room picture, and name it so that only one thing fits.",
        ));
    }
    match &answer.plan {
        None if messages.is_empty() => messages.push(message(
            "no_plan",
            "There is a meaning, but no plan was made for it.",
            "Say it in another way.",
        )),
        None => {}
        Some(plan) => match plan.reason.as_deref() {
            Some("no_referent") if !failures.is_empty() => {}
            Some(reason) => messages.push(planning(reason)),
            None if plan.actions.is_empty() => messages.push(message(
                "already_true",
                "That is already so: the robot has nothing to do.",
                "Ask for something that is not so yet.",
            )),
            None => {}
        },
    }
    messages
}

/// Words that were left out, so that the rest could be understood: never seen ones first.
fn skipping(answer: &Answer) -> Vec<Message> {
    if answer.readings.is_empty() {
        return Vec::new();
    }
    let (unknown, known) = (of_fate(answer, Fate::Unknown), of_fate(answer, Fate::Skipped));
    let fix = "See whether the meaning below is still what you meant.";
    let left_out = |kind, what: &str, words: &[String]| {
        (!words.is_empty()).then(|| message(kind, format!("{what}: {}.", quoted(words)), fix))
    };
    let unknown = left_out("unknown_words", "Never seen in training, so left out", &unknown);
    let known = left_out("skipped", "These words were left out", &known);
    unknown.into_iter().chain(known).collect()
}

fn parsing(reason: &str, answer: &Answer) -> Message {
    match reason {
        "empty" => message(
            "empty",
            "There is no word in this command.",
            "Type what the robot should do, such as “go to the blue room”.",
        ),
        "too_long" => message(
            "too_long",
            "This command has more than 50 words; one that long is not read.",
            "Say it in fewer words, or in several commands one after the other.",
        ),
        "unknown_words" => message(
            "unknown_words",
            format!("Never seen in training: {}.", quoted(&of_fate(answer, Fate::Unknown))),
            "Use other words, or train on a corpus whose commands hold these.",
        ),
        "no_parse" => message(
            "no_parse",
            "The words are known, but they do not fit together into a goal.",
            "Try the order of words of the commands it was trained on.",
        ),
        "tie" => message(
            "tie",
            format!("Several meanings are equally good ({}).", answer.readings.len()),
            "Say it more exactly, or train on more commands. All of them are listed below.",
        ),
        "budget" => message(
            "budget",
            "This command has too many readings to look at them all.",
            "Say it in fewer words.",
        ),
        other => message(
            "other",
            format!("There is no single meaning ({other})."),
            "Say it in another way.",
        ),
    }
}

fn planning(reason: &str) -> Message {
    match reason {
        "no_referent" => message(
            "no_referent",
            "A phrase of this command does not name exactly one thing in this world.",
            "Name something that is in the room picture, and name it so that only one thing fits.",
        ),
        "unreachable" => message(
            "unreachable",
            "It is understood, but the robot cannot bring it about: a wall, a locked door, a corner or a thing that it was not told to move is in the way.",
            "Ask for something else, or undo or reset the world and try again.",
        ),
        "budget" => message(
            "plan_budget",
            "It is understood, but no plan was found within the time allowed.",
            "Ask for a part of it first.",
        ),
        "bad_goal" => message(
            "bad_goal",
            "It was read as something that cannot be a goal of this world.",
            "Say it in another way.",
        ),
        other => message("other", format!("There is no plan ({other})."), "Say it in another way."),
    }
}

/// Why a phrase names no single thing.
fn fails(phrase: &Phrase, answer: &Answer) -> String {
    let words = phrase.words.iter().filter_map(|&at| answer.words.get(at));
    let words: Vec<&str> = words.map(|word| word.text.as_str()).collect();
    let said = quoted(&[words.join(" ")]);
    match phrase.refers {
        Refers::None => format!("Nothing here is what {said} says."),
        Refers::Several => format!("{said} fits {} things here.", phrase.referents.len()),
        Refers::Tie => format!("{said} fits {} things of one size.", phrase.referents.len()),
        Refers::Single => format!("There is only one thing for {said} to choose from."),
        _ => format!("The things that {said} speaks of cannot be compared in size."),
    }
}

fn of_fate(answer: &Answer, fate: Fate) -> Vec<String> {
    let words = answer.words.iter().filter(|word| word.fate == fate);
    words.map(|word| word.text.clone()).collect()
}

fn quoted(words: &[String]) -> String {
    words.iter().map(|w| format!("“{w}”")).collect::<Vec<_>>().join(", ")
}
