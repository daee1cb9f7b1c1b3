//! Does what a person wants about studies.

use super::action::{Action, Change, Value};
use super::files::{ask, bring, first_text, hold, save, write};
use super::state::{Draft, State};
use super::words::Text;
use crate::corpus::{Decision, States};
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{AnswerLine, Request, Sheet, StudyAsk, SurveyMapping};
use std::collections::BTreeMap;

/// Does what a person wants.
pub fn update(state: &mut State, desk: &mut Desk, action: Action) {
    let text = Text::of(desk.language);
    match action {
        Action::Draft(change) => draft(state, change),
        Action::Make => match state.draft.study() {
            Ok(study) => {
                state.notice = None;
                let study = serde_json::to_string(&study).unwrap_or_default();
                let Draft { tasks, pairs, has_ways, checks, .. } = state.draft.clone();
                ask(desk, StudyAsk::Make { study, tasks, pairs, has_ways, checks });
            }
            Err(error) => state.notice = Some((text.bad_ends)(&error)),
        },
        Action::Save(what) => {
            if let Some(why) = save(state, desk, what, text) {
                state.notice = Some(why);
            }
        }
        Action::Linked(link) => state.link = link,
        Action::Way(way) => {
            [state.draft.ends, state.draft.hosts] = way.ends().map(str::to_owned);
        }
        Action::Open(files) => {
            if let Some((name, found)) = first_text(files) {
                state.notice = state.take(&found).err().map(|error| format!("{name}: {error}"));
                state.open.clear();
                pack(state, desk);
                hold(state, desk);
            }
        }
        Action::Answers(files) => bring(state, desk, files),
        Action::Mapping(files) => {
            if let (Some((.., mapping)), Some((name, found))) =
                (&mut state.survey, first_text(files))
            {
                match SurveyMapping::read(&found) {
                    Ok(read) => *mapping = read,
                    Err(wrong) => state.notice = Some(format!("{name}: {wrong}")),
                }
            }
        }
        Action::Map(value, path) => map(state, value, path),
        Action::Convert => {
            if let Some((.., mapping)) = &state.survey {
                ask(desk, StudyAsk::Convert(mapping.clone()));
            }
        }
        Action::Judge => match &desk.in_use {
            Some(model) => {
                state.notice = None;
                let model = model.report.model.clone();
                ask(desk, StudyAsk::Judge(model));
            }
            None => state.notice = Some(text.no_model.to_owned()),
        },
        Action::JudgeBy(files) => {
            if let Some((_, model)) = first_text(files) {
                state.notice = None;
                ask(desk, StudyAsk::Judge(model));
            }
        }
        Action::From(from) => (state.from, state.looked_at) = (from, None),
        Action::Only(only) => (state.only, state.from, state.looked_at) = (only, 0, None),
        Action::Approve(id) => decide(state, desk, vec![(id, Decision::Approved)]),
        Action::Reject(id) => {
            let why = state.why.trim().to_owned();
            decide(state, desk, vec![(id, Decision::Rejected(why.into()))]);
        }
        Action::Look(id) => {
            let is_open = state.looked_at.take().is_some_and(|(open, _)| open == id);
            if !is_open {
                ask(desk, StudyAsk::Show(id.clone()));
                state.looked_at = Some((id, Vec::new()));
            }
        }
        Action::Reopen(id) => decide(state, desk, vec![(id, Decision::Open)]),
        Action::Why(why) => state.why = why,
        Action::Rule(flag) => {
            if !state.rule.remove(&flag) {
                state.rule.insert(flag);
            }
        }
        Action::Decide => {
            let decided = by_rule(state, text);
            let is_rejected = |(_, decision): &&(String, Decision)| *decision != Decision::Approved;
            let rejected = decided.iter().filter(is_rejected).count();
            let said = (text.decided)(decided.len() - rejected, rejected);
            decide(state, desk, decided);
            desk.say(said.clone());
            state.notice = Some(said);
        }
        Action::Wanted(wanted) => state.wanted = wanted,
        Action::Key(key) => state.key = key,
        Action::ApprovedOnly(only) => state.approved_only = only,
        Action::Train => write(state, desk, Sheet::Corpus),
        Action::Stop => {
            desk.learner.retain(|request| !matches!(request, Request::Study(StudyAsk::Bring(_))));
            let at_work = desk.learner.pending.as_ref().map(|pending| &pending.request);
            if matches!(at_work, Some(Request::Study(_))) {
                desk.cancel();
            }
        }
    }
}

/// Has the study packed into a link.
pub(super) fn pack(state: &State, desk: &mut Desk) {
    if let Some((study, _)) = &state.study {
        desk.want(Effect::Pack(study.write()));
    }
}

/// Decides something of answers, here and in the engine.
fn decide(state: &mut State, desk: &mut Desk, decisions: Vec<(String, Decision)>) {
    let mut places: BTreeMap<&str, &Decision> =
        decisions.iter().map(|(id, decision)| (&**id, decision)).collect();
    for row in &mut state.review.rows {
        if let Some(decision) = places.remove(&*row.id) {
            row.decision = decision.clone();
        }
    }
    ask(desk, StudyAsk::Decide(decisions));
}

/// What the rule says of all that is open: what has one of its flags is rejected, with these as the reason, the rest
/// approved.
fn by_rule(state: &State, text: &Text) -> Vec<(String, Decision)> {
    let decided = |row: &AnswerLine| {
        let reasons: Vec<&str> =
            row.flags.intersection(&state.rule).map(|&flag| (text.reason)(flag)).collect();
        let decision = match reasons.is_empty() {
            true => Decision::Approved,
            false => Decision::Rejected(reasons.join("; ").into()),
        };
        (row.id.clone(), decision)
    };
    let rows = state.review.rows.iter().filter(|row| row.decision == Decision::Open);
    rows.map(decided).collect()
}

fn draft(state: &mut State, change: Change) {
    let draft = &mut state.draft;
    match change {
        Change::Name(name) => draft.name = name,
        Change::German(german) => draft.german = german,
        Change::Tasks(tasks) => draft.tasks = tasks,
        Change::Pairs(pairs) => draft.pairs = pairs,
        Change::Ways(has_ways) => draft.has_ways = has_ways,
        Change::Check(at, task) => {
            let is_new = at == draft.checks.len() && !task.is_empty();
            if is_new {
                draft.checks.push((task, String::new()));
            } else if task.is_empty() && at < draft.checks.len() {
                draft.checks.remove(at);
            } else if let Some(check) = draft.checks.get_mut(at) {
                check.0 = task;
            }
        }
        Change::Must(at, words) => {
            if let Some(check) = draft.checks.get_mut(at) {
                check.1 = words;
            }
        }
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
    let Some((.., mapping)) = &mut state.survey else { return };
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
