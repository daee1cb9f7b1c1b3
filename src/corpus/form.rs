//! The command in what a crowd-html form answers with, `[{"command": "…"}]`, or in a text of JSON. Of all else that stands
//! there nothing is kept: a form may answer with far more than a command.

use super::flaw::{Wrong, some};
use super::json::json;
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;

/// Names that are kept to be told: more than a message has room for.
const MOST_NAMES: usize = 20;

/// What forms answer, as far as it may be the command.
#[derive(Default)]
struct Answers {
    /// What is called command. An answer that is no text is none: null, most of all.
    command: Option<String>,
    /// The first text, and how many there are.
    text: Option<String>,
    n_texts: usize,
    names: Vec<String>,
    is_empty: bool,
}

/// The command that a text is. Where it is JSON (a form's answers, or a text in quotes), it is what that holds.
pub(super) fn said(text: &str) -> Result<String, Wrong> {
    let may_be = text.starts_with(['{', '[', '"']);
    match may_be.then(|| json::<Answers>(text)) {
        Some(Ok(answers)) if !answers.is_empty => answers.command(),
        _ => Ok(text.to_owned()),
    }
}

/// The command in the JSON that crowd-html forms answer with; or a single text.
pub(super) fn form_command(text: &str) -> Result<String, Wrong> {
    json::<Answers>(text)?.command()
}

impl Answers {
    fn command(self) -> Result<String, Wrong> {
        let only = self.text.filter(|_| self.n_texts == 1);
        self.command.or(only).map(|command| command.trim().to_owned()).ok_or_else(|| {
            let names = some(self.names.iter().map(String::as_str));
            Wrong::from(format!("no answer is called command (found: {names})"))
        })
    }

    /// Takes in another form.
    fn add(&mut self, other: Answers) {
        let Answers { command, text, n_texts, names, .. } = other;
        self.command = self.command.take().or(command);
        self.text = self.text.take().or(text);
        self.n_texts += n_texts;
        self.names.extend(names.into_iter().take(MOST_NAMES - self.names.len()));
    }
}

impl<'de> Deserialize<'de> for Answers {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Forms)
    }
}

/// Takes in forms, and what is no form.
struct Forms;

impl<'de> Visitor<'de> for Forms {
    type Value = Answers;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a form's answers: [{\"command\": …}]")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Answers, A::Error> {
        let mut all = Answers { is_empty: true, ..Answers::default() };
        while let Some((name, value)) = fields.next_entry::<String, &RawValue>()? {
            // Any other value is no text.
            let text = serde_json::from_str::<String>(value.get()).ok();
            let command = (name == "command").then(|| text.clone().unwrap_or_default());
            let n_texts = usize::from(text.is_some());
            all.add(Answers { command, text, n_texts, names: vec![name], is_empty: false });
            all.is_empty = false;
        }
        Ok(all)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut forms: A) -> Result<Answers, A::Error> {
        let mut all = Answers { is_empty: true, ..Answers::default() };
        while let Some(form) = forms.next_element()? {
            all.add(form);
            all.is_empty = false;
        }
        Ok(all)
    }

    fn visit_str<E>(self, text: &str) -> Result<Answers, E> {
        Ok(Answers { text: Some(text.to_owned()), n_texts: 1, ..Answers::default() })
    }

    fn visit_bool<E>(self, _: bool) -> Result<Answers, E> {
        Ok(Answers::default())
    }

    fn visit_i64<E>(self, _: i64) -> Result<Answers, E> {
        Ok(Answers::default())
    }

    fn visit_u64<E>(self, _: u64) -> Result<Answers, E> {
        Ok(Answers::default())
    }

    fn visit_f64<E>(self, _: f64) -> Result<Answers, E> {
        Ok(Answers::default())
    }

    fn visit_unit<E>(self) -> Result<Answers, E> {
        Ok(Answers::default())
    }
}
