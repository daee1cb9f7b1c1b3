//! The ends of a study: what is sent where, and how often it is tried. What was not sent stays in the journal and is shown.

use super::effect::Effect;
use super::state::State;
use crate::study::ends::{Refusal, Source, back, target};
use crate::study::file::Study;
use crate::study::journal::Sitting;
use crate::study::{Answer, End, Link, answer};

/// What is to be done about an end.
pub(super) fn begin(state: &mut State, end: &End) -> Vec<Effect> {
    let Some(((study, source), sitting)) = state.study.as_ref().zip(state.sitting.as_ref()) else {
        return Vec::new();
    };
    match carried_out(study, *source, end, sitting, &state.link) {
        Ok(effect) => {
            let is_post = matches!(effect, Effect::Post { .. });
            state.ending.is_sending = is_post;
            state.ending.tries += u32::from(is_post);
            state.ending.is_done = !is_post;
            vec![effect]
        }
        Err(refusal) => {
            state.ending.refusal = Some(refusal);
            Vec::new()
        }
    }
}

fn carried_out(
    study: &Study,
    source: Source,
    end: &End,
    sitting: &Sitting,
    link: &Link,
) -> Result<Effect, Refusal> {
    let url = target(study, source, end, link)?;
    let answers = sitting.answers(study);
    let code = sitting.code(study);
    Ok(match (end, url) {
        (End::Endpoint { key, .. }, Some(url)) => {
            let body = posted(study, sitting, key, &code, &answers);
            Effect::Post { url, body }
        }
        (End::Form { .. }, Some(url)) => {
            let own = |name: &str, value: String| (name.to_owned(), value);
            let mut fields = vec![own("answers", answer::lines(&answers)), own("code", code)];
            let platform = [("assignmentId", &sitting.who.assignment), ("hitId", &sitting.who.hit)];
            fields.extend(platform.iter().filter_map(|(name, id)| Some(own(name, (*id).clone()?))));
            fields.push(own("workerId", sitting.who.worker.clone()));
            Effect::Submit { url, fields }
        }
        (End::Return { url }, _) => Effect::Go(back(url, &code, &sitting.who.worker)),
        (End::Code, _) => Effect::Copy(code),
        (End::File | End::Form { .. } | End::Endpoint { .. }, _) => file(study, sitting),
    })
}

/// The answers as a file for the person to send.
pub(super) fn file(study: &Study, sitting: &Sitting) -> Effect {
    let text = answer::lines(&sitting.answers(study));
    Effect::Save { name: format!("answers-{}.jsonl", sitting.name()), text }
}

/// What an endpoint is sent.
fn posted(study: &Study, sitting: &Sitting, key: &str, code: &str, answers: &[Answer]) -> String {
    // A text has a form in JSON, whatever is in it.
    let text = |value: &str| serde_json::to_string(value).unwrap_or_default();
    let lines: Vec<String> = answers.iter().map(Answer::line).collect();
    let name = sitting.name();
    let names = [
        ("key", key),
        ("study", &sitting.study),
        ("name", &study.name),
        ("sitting", &name),
        ("code", code),
    ];
    let names = names.map(|(name, value)| format!("{}:{}", text(name), text(value)));
    format!("{{{},\"answers\":[{}]}}", names.join(","), lines.join(","))
}
