//! Does what a person wants about studies.

use super::action::{Action, Change, Value};
use super::files::{answers, bring, converted, made, take, texts};
use super::state::State;
use super::words::Text;
use crate::corpus::{Decision, States};
use crate::study::answer::lines;
use crate::study::merge;
use crate::study::survey::SurveyMapping;
use crate::ui::page::files::Offered;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Request, StudyAsk};

/// Does what a person wants; a corpus to train on, if that is it.
pub fn update(state: &mut State, desk: &mut Desk, action: Action) -> Option<Offered> {
    let text = Text::of(desk.language);
    match action {
        Action::Draft(change) => draft(state, change),
        Action::Make => match state.draft.study() {
            Ok(study) => {
                state.notice = None;
                let study = serde_json::to_string(&study).unwrap_or_default();
                let (tasks, pairs) = (state.draft.tasks.clone(), state.draft.pairs);
                desk.send(Request::Study(StudyAsk::Make { study, tasks, pairs }), false);
            }
            Err(error) => state.notice = Some((text.bad_ends)(&error)),
        },
        Action::Save(what) => match made(state, what, text) {
            Ok((name, text)) => desk.want(Effect::Save { name, text }),
            Err(why) => state.notice = Some(why),
        },
        Action::Linked(link) => state.link = link,
        Action::Way(way) => {
            [state.draft.ends, state.draft.hosts] = way.ends().map(str::to_owned);
        }
        Action::Open(files) => {
            if let Some((name, found)) = texts(files).0.into_iter().next() {
                state.notice = state.take(&found).err().map(|error| format!("{name}: {error}"));
                state.open.clear();
                pack(state, desk);
                let files = state.files.iter().map(|(name, text)| (name.as_str(), text.as_str()));
                let merged = merge(files);
                take(state, merged);
            }
        }
        Action::Answers(files) => {
            state.notice = None;
            bring(state, files);
        }
        Action::Mapping(files) => {
            if let (Some((_, mapping)), Some((name, found))) =
                (&mut state.survey, texts(files).0.into_iter().next())
            {
                match SurveyMapping::read(&found) {
                    Ok(read) => *mapping = read,
                    Err(wrong) => state.notice = Some(format!("{name}: {wrong}")),
                }
            }
        }
        Action::Map(value, path) => map(state, value, path),
        Action::Convert => converted(state, text),
        Action::Judge => match &desk.in_use {
            Some(model) => {
                let model = model.report.model.clone();
                judge(state, desk, model);
            }
            None => state.notice = Some(text.no_model.to_owned()),
        },
        Action::JudgeBy(files) => {
            if let Some((_, model)) = texts(files).0.into_iter().next() {
                judge(state, desk, model);
            }
        }
        Action::From(from) => (state.from, state.looked_at) = (from, None),
        Action::Only(only) => (state.only, state.from, state.looked_at) = (only, 0, None),
        Action::Approve(row) => state.review.decide(row, Decision::Approved),
        Action::Reject(row) => {
            let why = state.why.trim().to_owned();
            state.review.decide(row, Decision::Rejected(why.into()));
        }
        Action::Look(row) => {
            state.looked_at = Some(row).filter(|_| state.looked_at != Some(row));
        }
        Action::Reopen(row) => state.review.decide(row, Decision::Open),
        Action::Why(why) => state.why = why,
        Action::Rule(flag) => {
            if !state.rule.remove(&flag) {
                state.rule.insert(flag);
            }
        }
        Action::Decide => {
            let rule = state.rule.clone();
            let (rejected, approved) =
                state.review.decide_by(&rule, |flag| (text.reason)(flag).to_owned());
            let said = (text.decided)(approved, rejected);
            desk.say(said.clone());
            state.notice = Some(said);
        }
        Action::Wanted(wanted) => state.wanted = wanted,
        Action::Key(key) => state.key = key,
        Action::ApprovedOnly(only) => state.approved_only = only,
        Action::Train => match answers(state, true, false) {
            Ok(lines) => {
                let name = "study-answers.jsonl".to_owned();
                return Some(Offered { name, bytes: Ok(lines.into_bytes()) });
            }
            Err(why) => state.notice = Some(why),
        },
    }
    None
}

/// Has the study packed into a link.
pub(super) fn pack(state: &State, desk: &mut Desk) {
    if let Some(study) = &state.study {
        desk.want(Effect::Pack(study.write()));
    }
}

fn judge(state: &mut State, desk: &mut Desk, model: String) {
    state.notice = None;
    let answers = lines(&state.review.answers());
    desk.send(Request::Study(StudyAsk::Judge { model, answers }), false);
}

fn draft(state: &mut State, change: Change) {
    let draft = &mut state.draft;
    match change {
        Change::Name(name) => draft.name = name,
        Change::German(german) => draft.german = german,
        Change::Tasks(tasks) => draft.tasks = tasks,
        Change::Pairs(pairs) => draft.pairs = pairs,
        Change::Shown(shown) => draft.shown = shown,
        Change::Asked(asked) => draft.asked = asked,
        Change::Seed(seed) => draft.seed = seed,
        Change::Says(place, words) => {
            draft.says.insert(place, words);
        }
        Change::Order(order) => draft.order = order,
        Change::Again(again) => draft.again = again,
        Change::Hosts(hosts) => draft.hosts = hosts,
        Change::Ends(ends) => draft.ends = ends,
        Change::Cents(cents) => draft.cents = cents,
    }
}

fn map(state: &mut State, value: Value, path: String) {
    let Some((_, mapping)) = &mut state.survey else { return };
    let named = Some(path.clone()).filter(|path| !path.is_empty());
    let (at, is_pre) = match value {
        Value::Command => return mapping.command = path,
        Value::Worker => return mapping.worker = named,
        Value::Task => return mapping.task = named,
        Value::Pre(at) => (at, true),
        Value::Post(at) => (at, false),
    };
    while mapping.pairs.len() <= at {
        mapping.pairs.push(States { pre: String::new(), post: String::new() });
    }
    let pair = &mut mapping.pairs[at];
    *(if is_pre { &mut pair.pre } else { &mut pair.post }) = path;
    mapping.pairs.retain(|pair| !pair.pre.is_empty() || !pair.post.is_empty());
}
