//! JSON, in and out: `{id, command, task?, worker?, pairs: [{pre, post}], runs: [{start, actions, contrast?}]}` an object
//! (with pairs, runs, or both; other keys are kept), or an object with the columns of batch results for names, as
//! programs make of such a table. States are JSON, or JSON in a string.

use super::admit::{Options, decision, something};
use super::cells::Cells;
use super::draft::{Draft, Found, Place, Shown};
use super::example::{Corpus, Decision, Example, Row};
use super::flaw::{Flaw, Wrong, cut_quoted, some};
use super::form::{form_command, said};
use super::items::{Item, Items};
use super::json::whole_json;
use super::limits::{MAX_CELL_BYTES, MAX_COLUMNS, MAX_PAIRS};
use super::mapping::{Mapping, States};
use super::object::{Few, Fields};
use super::role::{APPROVE, COMMAND, FORM, ID, POST, PRE, REASON, RUN, Role, STATUS, TASK, WORKER};
use super::run::RunOut;
use super::source::Source;
use crate::domain::State;
use serde::{Deserialize, Serialize};
use serde_json::value::{RawValue, Value};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{Read, Write};

#[derive(Serialize)]
struct LineOut<'a> {
    id: &'a str,
    command: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    worker: Option<&'a str>,
    #[serde(rename = "AssignmentStatus", skip_serializing_if = "Option::is_none")]
    status: Option<&'a str>,
    #[serde(rename = "Reject", skip_serializing_if = "Option::is_none")]
    reject: Option<&'a str>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pairs: Vec<PairOut<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    runs: Vec<RunOut<'a>>,
    #[serde(flatten)]
    keys: BTreeMap<&'a str, Value>,
}

/// The keys of an object that are read by these names, whatever else is.
const KEYS: [&str; 6] = ["id", "command", "task", "worker", "pairs", "runs"];

#[derive(Serialize)]
struct PairOut<'a> {
    pre: &'a State,
    post: &'a State,
}

#[derive(Deserialize)]
struct PairIn<'a> {
    #[serde(borrow)]
    pre: Option<&'a RawValue>,
    #[serde(borrow)]
    post: Option<&'a RawValue>,
}

/// A reader of JSON, object by object.
pub(super) struct Reader<R> {
    items: Items<R>,
    options: Options,
}

impl<R: Read> Reader<R> {
    /// A reader at the beginning of a file.
    pub(super) fn new(source: Source<R>, options: Options) -> Self {
        Reader { items: Items::new(source), options }
    }

    /// Bytes read so far, for progress.
    pub(super) fn bytes(&self) -> u64 {
        self.items.bytes()
    }

    /// Goes on by a bounded part.
    ///
    /// # Errors
    /// Why the file cannot be used.
    pub(super) fn step(&mut self) -> Result<Found, Flaw> {
        Ok(match self.items.step().map_err(|fault| Flaw::of_file(fault.wrong()))? {
            Item::Working => Found::Nothing,
            Item::Over => Found::Over,
            Item::Broken(line, why, raw) => {
                let wrong =
                    Wrong::with_mend(format!("this is no JSON object: {why}"), "mend the row");
                Found::Row(Row::bad(Flaw::of_row(line, None, wrong), raw))
            }
            Item::Text(line, raw) => {
                let mut found = row(&raw, line, &self.options);
                match &mut found {
                    Found::Row(row) if !row.rejected => row.raw = raw,
                    Found::Draft(draft) => draft.raw = raw,
                    _ => {}
                }
                found
            }
        })
    }
}

/// Writes a corpus as JSON lines.
///
/// # Errors
/// Those of `out`.
pub fn write(corpus: &Corpus, out: impl Write) -> std::io::Result<()> {
    write_rows(corpus.examples.iter().map(|example| (example, &example.decision)), out)
}

/// Writes rows, each with what was decided of it, as JSON lines.
///
/// # Errors
/// Those of `out`.
pub fn write_rows<'a>(
    rows: impl IntoIterator<Item = (&'a Example, &'a Decision)>,
    mut out: impl Write,
) -> std::io::Result<()> {
    for (example, decision) in rows {
        let pairs = example.pairs.iter().filter(|pair| pair.way.is_none());
        let pairs = pairs.map(|pair| PairOut { pre: &pair.pre, post: &pair.post });
        let runs = example.pairs.iter().filter_map(|pair| Some((&pair.pre, pair.way.as_deref()?)));
        let keys = (0..example.keys.len()).step_by(2).filter_map(|at| {
            let (key, value) = (example.keys.get(at)?, example.keys.get(at + 1)?);
            Some((key, serde_json::from_str(value).ok()?))
        });
        let line = LineOut {
            id: &example.id,
            command: &example.command,
            task: example.task.as_deref(),
            worker: example.worker.as_deref(),
            status: match decision {
                Decision::Open => None,
                Decision::Approved => Some("Approved"),
                Decision::Rejected(_) => Some("Rejected"),
            },
            reject: match decision {
                Decision::Rejected(reason) if !reason.is_empty() => Some(reason),
                _ => None,
            },
            pairs: pairs.collect(),
            runs: runs.map(|(start, way)| RunOut::new(start, way)).collect(),
            keys: keys.collect(),
        };
        serde_json::to_writer(&mut out, &line)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// Bytes as text, each that is no UTF-8 read as Latin-1, and where in the text such a one stands: the first of every
/// string, since where no quote stands between two of them they are in one.
pub(super) fn text(raw: &[u8]) -> (Cow<'_, str>, Vec<u32>) {
    if let Ok(text) = std::str::from_utf8(raw) {
        return (Cow::Borrowed(text), Vec::new());
    }
    let (mut text, mut strange) = (String::with_capacity(raw.len()), Vec::new());
    for chunk in raw.utf8_chunks() {
        text.push_str(chunk.valid());
        if !chunk.invalid().is_empty() && (strange.is_empty() || chunk.valid().contains('"')) {
            // An object is far smaller than 4 GB.
            strange.push(text.len() as u32);
        }
        text.extend(chunk.invalid().iter().map(|&byte| char::from(byte)));
    }
    (Cow::Owned(text), strange)
}

/// What an object says; it as it stands in the file is still to be added.
fn row(raw: &[u8], line: u64, options: &Options) -> Found {
    let (whole, strange) = text(raw);
    let bad = |wrong: Wrong| Found::Row(Row::bad(Flaw::of_row(line, None, wrong), Vec::new()));
    let fields: Fields<'_> = match serde_json::from_str(&whole) {
        Ok(fields) => fields,
        Err(error) if error.is_data() => {
            let what = "this is no JSON object";
            let mend = "a row is {\"command\": …, \"pairs\": [{\"pre\": …, \"post\": …}]}, or has \"runs\"";
            return bad(Wrong::with_mend(what, mend));
        }
        Err(error) => return bad(Wrong::from(broken(&error))),
    };
    if fields.are_too_many() {
        let what = format!("the row has more than {MAX_COLUMNS} keys");
        return bad(Wrong::with_mend(what, "see whether this is a corpus, and one object a row"));
    }
    let fields = fields.all;
    let mapping = &options.mapping;
    // What a mapping names, and nothing else, where there is one.
    let field = |mapped: &Option<String>, usual: [&str; 2]| {
        let usual = if mapping.is_empty() { usual.as_slice() } else { &[] };
        let mut names = mapped.iter().map(String::as_str).chain(usual.iter().copied());
        let found = names.find_map(|name| fields.get_key_value(name));
        found.map(|(name, value)| (&**name, value.get()))
    };
    let plain =
        |mapped, name: &str| field(mapped, [name; 2]).and_then(|(_, value)| plain(value).ok());
    let status = plain(&mapping.status, STATUS);
    let approve = plain(&mapping.approve, APPROVE);
    let reason = plain(&mapping.reject, REASON);
    let decided = decision(status.as_deref(), approve.as_deref(), reason.as_deref());
    if !options.with_rejected && matches!(decided, Decision::Rejected(_)) {
        return Found::Row(Box::new(Row { rejected: true, ..Row::default() }));
    }
    let mut draft = Draft::new(line, Vec::new());
    draft.decision = decided;
    for (name, value) in fields.iter().filter(|(name, _)| is_read(name, mapping)) {
        let start = value.get().as_ptr().addr() - whole.as_ptr().addr();
        let first = strange.partition_point(|&at| (at as usize) < start);
        if strange.get(first).is_some_and(|&at| (at as usize) < start + value.get().len()) {
            let wrong = Wrong::with_mend("the value is not UTF-8 text", "save the file in UTF-8");
            draft.blame(Some(name), wrong);
        }
    }
    let mut text = |mapped, usual| {
        let (name, value) = field(mapped, usual)?;
        self::plain(value).map_err(|wrong| draft.blame(Some(name), wrong)).ok()
    };
    let id = text(&mapping.id, ["id", ID]);
    let task = text(&mapping.task, ["task", TASK]);
    let worker = text(&mapping.worker, ["worker", WORKER]);
    (draft.id, draft.task, draft.worker) = (id, task, worker);
    let command = field(&mapping.command, ["command", COMMAND]).filter(|(name, _)| *name != FORM);
    let form = fields
        .get_key_value(FORM)
        .filter(|_| mapping.is_empty() || mapping.command.as_deref() == Some(FORM));
    match (command, form.map(|(name, value)| (&**name, value.get()))) {
        (None, None) => {
            let known = some(fields.keys().map(|name| &**name));
            let what = format!("the row has no command (found: {known})");
            draft.blame(None, Wrong::with_mend(what, "say it in \"command\""));
        }
        (None, Some((name, form))) => {
            draft.say(name, self::plain(form).and_then(|form| form_command(&form)));
        }
        (Some((name, command)), _) => {
            draft.say(name, self::plain(command).and_then(|command| said(&command)));
        }
    }
    states(&fields, mapping, &mut draft);
    draft.keys = others(&fields, mapping);
    Found::Draft(Box::new(draft))
}

/// Whether anything is read of a key.
fn is_read(key: &str, mapping: &Mapping) -> bool {
    (mapping.is_empty() && KEYS.contains(&key))
        || !matches!(mapping.role(key), Role::Other | Role::Approve)
}

/// The keys that nothing is read of, each with its value.
fn others(fields: &BTreeMap<String, &RawValue>, mapping: &Mapping) -> Cells {
    let is_known = |key: &str| KEYS.contains(&key) || mapping.role(key) != Role::Other;
    let others = fields.iter().filter(|(key, _)| !is_known(key));
    others.flat_map(|(key, value)| [&**key, value.get()]).collect()
}

/// The keys of an object and its values, as a person may look at them; none where it is no object.
pub(super) fn fields(text: &str) -> Option<Vec<(String, String)>> {
    let fields: Fields<'_> = serde_json::from_str(text).ok()?;
    let shown = |value: &RawValue| plain(value.get()).unwrap_or_else(|_| value.get().to_owned());
    Some(fields.all.into_iter().map(|(key, value)| (key, shown(value))).collect())
}

/// The demonstrations of an object: its `pairs` and `runs`, or its columns.
fn states(fields: &BTreeMap<String, &RawValue>, mapping: &Mapping, draft: &mut Draft) {
    let place = |column: String, value: &RawValue| Place { column, text: value.get().to_owned() };
    let is_nothing = |value: &RawValue| plain(value.get()).is_ok_and(|it| something(&it).is_none());
    let own = |key: &str| {
        let own = fields.get(key).filter(|_| mapping.pairs.is_empty());
        own.filter(|value| !is_nothing(value)).map(|value| unquoted(value))
    };
    let mut shown = Vec::new();
    let (pairs, runs) = (own("pairs"), own("runs"));
    if let Some(pairs) = &pairs {
        let Some(pairs) = list(draft, ("pairs", "pre and post"), pairs) else { return };
        for (n, pair) in pairs.iter().enumerate() {
            let pair: PairIn<'_> = match whole_json(pair.get()) {
                Ok(pair) => pair,
                Err(wrong) => {
                    draft.blame(Some(&format!("pairs[{n}]")), wrong);
                    continue;
                }
            };
            let side = |side: &str, value| (format!("pairs[{n}].{side}"), value);
            match (side("pre", pair.pre), side("post", pair.post)) {
                ((pre, Some(before)), (post, Some(after))) => {
                    shown.push(Shown::Pair(place(pre, before), place(post, after)));
                }
                ((name, None), _) | (_, (name, None)) => {
                    draft.blame(Some(&name), "the state is missing".to_owned());
                }
            }
        }
    }
    if let Some(runs) = &runs {
        let Some(runs) = list(draft, ("runs", "start and actions"), runs) else { return };
        let runs = runs.iter().enumerate();
        shown.extend(runs.map(|(n, run)| Shown::Run(place(format!("runs[{n}]"), run))));
    }
    if pairs.or(runs).is_none() {
        shown = columns(fields, mapping, draft);
    }
    draft.show(shown);
}

/// The JSON that a value is, or that stands in it where it is a string.
fn unquoted(value: &RawValue) -> Cow<'_, str> {
    let inner = value.get().starts_with('"').then(|| serde_json::from_str(value.get()));
    inner.and_then(Result::ok).map_or(Cow::Borrowed(value.get()), Cow::Owned)
}

/// A list under a key, of 1 to [`MAX_PAIRS`] objects that have what is named.
fn list<'a>(
    draft: &mut Draft,
    (key, of): (&str, &str),
    list: &'a str,
) -> Option<Vec<&'a RawValue>> {
    let is_no_pair = |item: &&RawValue| key == "pairs" && !item.get().starts_with('{');
    let wrong = match serde_json::from_str::<Few<&RawValue, MAX_PAIRS>>(list) {
        Ok(Few(list)) if !(1..=MAX_PAIRS).contains(&list.len()) => {
            Wrong::from(format!("a row needs 1 to {MAX_PAIRS} {key} of {of}"))
        }
        Ok(Few(list)) if !list.iter().any(is_no_pair) => return Some(list),
        _ => {
            let mend = match key {
                "pairs" => "it is a list: [{\"pre\": …, \"post\": …}]",
                _ => "it is a list: [{\"start\": …, \"actions\": \"…\"}]",
            };
            Wrong::with_mend(format!("this is no list of {key}"), mend)
        }
    };
    draft.blame(Some(key), wrong);
    None
}

/// The demonstrations that stand under the names of columns.
fn columns(
    fields: &BTreeMap<String, &RawValue>,
    mapping: &Mapping,
    draft: &mut Draft,
) -> Vec<Shown> {
    let place = |column: String, value: &RawValue| Place { column, text: value.get().to_owned() };
    let mut shown = Vec::new();
    let number = |n: usize| [format!("{PRE}{n}"), format!("{POST}{n}")];
    let mapped = |States { pre, post }: &States| [pre.clone(), post.clone()];
    let names: Vec<[String; 2]> = match mapping.pairs.as_slice() {
        [] => (1..=MAX_PAIRS).map(number).collect(),
        pairs => pairs.iter().take(MAX_PAIRS).map(mapped).collect(),
    };
    let there = |name: &str| {
        fields.get(name).filter(|value| plain(value.get()).ok().as_deref() != Some(""))
    };
    for [pre, post] in names {
        match (there(&pre), there(&post)) {
            (Some(before), Some(after)) => {
                shown.push(Shown::Pair(place(pre, before), place(post, after)));
            }
            (None, None) => {}
            (Some(_), None) => draft.blame(Some(&post), "the state is missing".to_owned()),
            (None, Some(_)) => draft.blame(Some(&pre), "the state is missing".to_owned()),
        }
    }
    let runs = (1..=MAX_PAIRS).map(|n| format!("{RUN}{n}")).filter(|_| mapping.pairs.is_empty());
    shown.extend(runs.filter_map(|run| Some(Shown::Run(place(run.clone(), there(&run)?)))));
    if shown.is_empty() {
        let known = some(fields.keys().map(|name| &**name));
        let what = format!("the row has no states (found: {known})");
        draft.blame(None, Wrong::with_mend(what, "give them in \"pairs\" or \"runs\""));
    }
    shown
}

/// A value as text: what is no list and no object; nothing for null.
fn plain(value: &str) -> Result<String, Wrong> {
    if value.len() > MAX_CELL_BYTES {
        return Err(Wrong::from(format!("the value is larger than {} MB", MAX_CELL_BYTES >> 20)));
    }
    match value.as_bytes().first() {
        Some(b'"') => serde_json::from_str(value).map_err(|error| Wrong::from(broken(&error))),
        Some(b'{' | b'[') => Err(Wrong::with_mend(
            "this must be a text",
            "write an object a row, each value a text (pandas: orient=\"records\")",
        )),
        _ if value == "null" => Ok(String::new()),
        _ => Ok(value.to_owned()),
    }
}

/// What breaks a text of JSON, and where.
fn broken(error: &serde_json::Error) -> String {
    let full = error.to_string();
    let detail = cut_quoted(full.split(" at line ").next().unwrap_or(&full));
    match error.line() {
        0 | 1 => format!("not JSON: {detail}, at character {} of the row", error.column()),
        line => {
            format!("not JSON: {detail}, in line {line} of the row, character {}", error.column())
        }
    }
}
