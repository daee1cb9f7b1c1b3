//! The workbench's part about studies, played without a browser: a study is drawn and opened, answers are merged, judged,
//! decided, saved and handed to training, and another program's trials are mapped.

use super::model;
use crate::study::files::{item, showing};
use groundling::corpus::Decision;
use groundling::study::answer::{FORMAT, lines};
use groundling::study::file::{Again, Order};
use groundling::study::{Answer, Care, Flag, Study};
use groundling::ui::page::files::Offered;
use groundling::ui::train::desk::Desk;
use groundling::ui::train::effect::Effect;
use groundling::ui::train::study::action::{Action, Change, Place, Saved, Value};
use groundling::ui::train::study::{State, hear, update};
use groundling::worker::protocol::{AnswerVerdict, Event, Request, StudyAsk, StudySaid};
use std::rc::Rc;

/// The part, with a desk of its own.
#[derive(Default)]
struct Part {
    state: State,
    desk: Desk,
}

impl Part {
    fn act(&mut self, action: Action) -> Option<Offered> {
        update::update(&mut self.state, &mut self.desk, action)
    }

    fn saves(&mut self, what: Saved) -> String {
        self.desk.take_wanted();
        self.act(Action::Save(what));
        let wanted = self.desk.take_wanted();
        let found = wanted.into_iter().find_map(|effect| match effect {
            Effect::Save { text, .. } => Some(text),
            _ => None,
        });
        found.unwrap_or_else(|| panic!("{what:?}: {:?}", self.state.notice))
    }
}

fn file(name: &str, text: &str) -> Vec<Offered> {
    vec![Offered { name: name.into(), bytes: Ok(text.as_bytes().to_vec()) }]
}

fn study() -> Study {
    Study::new("Six", vec![item("a", 3), item("b", 3)])
}

fn answers(study: &Study) -> Vec<Answer> {
    let of = |who: &str, at: usize, command: &str| Answer {
        format: FORMAT.into(),
        id: format!("{who}-{}", at + 1),
        command: command.into(),
        task: study.items[at].task.clone(),
        worker: who.into(),
        pairs: vec![showing(1); 3],
        study: study.fingerprint(),
        item: study.items[at].id.clone(),
        turn: [at + 1, 2],
        assignment: None,
        hit: None,
        at: 1.0,
        care: Care { active_ms: 9_000, seen_ms: vec![900; 3], keys: 9, ..Care::default() },
        simulated: None,
    };
    vec![of("anna", 0, "go east"), of("anna", 1, "step"), of("bert", 0, "=1+1")]
}

#[test]
fn a_study_is_drawn_by_the_engine_and_saved() {
    let mut part = Part::default();
    part.act(Action::Draft(Change::Name("Bags".into())));
    part.act(Action::Draft(Change::Ends("nothing".into())));
    part.act(Action::Make);
    assert!(part.state.notice.as_deref().unwrap().contains("no JSON of ends"));
    part.act(Action::Draft(Change::Ends("[\"code\"]".into())));
    part.act(Action::Draft(Change::Cents(25)));
    part.act(Action::Draft(Change::Says(Place::Welcome, " Hello.\n\nSit down. ".into())));
    part.act(Action::Draft(Change::Says(Place::Thanks, " ".into())));
    part.act(Action::Draft(Change::Order(Order::Fixed)));
    part.act(Action::Draft(Change::Again(Again::Refuse)));
    let wanted = part.state.draft.study().unwrap();
    assert_eq!(wanted.words.welcome.as_deref(), Some("Hello.\n\nSit down."));
    assert_eq!(wanted.words.thanks, None, "what says nothing leaves the page its own words");
    assert_eq!((wanted.order, wanted.again), (Order::Fixed, Again::Refuse));
    part.act(Action::Make);
    let asked = |request: &Request| matches!(request, Request::Study(StudyAsk::Make { pairs: 5, study, .. }) if study.contains("Bags"));
    assert!(part.desk.learner.is_at(asked));
    hear::progressed(&mut part.state, &StudySaid::Making(1, 2));
    assert_eq!(part.state.making, Some((1, 2)));
    let made = StudySaid::Made { study: study().write(), open: vec!["a: this".into()] };
    hear::answered(&mut part.state, &mut part.desk, Event::Study(made));
    assert_eq!((part.state.making, part.state.open.len()), (None, 1));
    assert_eq!(Study::read(&part.saves(Saved::Study)).unwrap(), study());
    part.act(Action::Open(file("bad.json", "{")));
    assert!(part.state.notice.as_deref().unwrap().starts_with("bad.json: not JSON"));
}

#[test]
fn answers_are_merged_judged_decided_and_taken_out() {
    let study = study();
    let mut part = Part::default();
    part.act(Action::Open(file("study.json", &study.write())));
    let text = lines(&answers(&study));
    part.act(Action::Answers(file("b.jsonl", &text)));
    part.act(Action::Answers(file("again.jsonl", &text)));
    assert_eq!((part.state.review.rows.len(), part.state.left_out), (3, [3, 0]));
    part.act(Action::Judge);
    assert!(part.state.notice.is_some(), "there is no model yet");
    part.desk.in_use = Some(groundling::ui::page::document::Model {
        report: Rc::new(model("a model")),
        origin: groundling::ui::page::document::Origin::Shipped,
    });
    part.act(Action::Judge);
    let asked = |request: &Request| matches!(request, Request::Study(StudyAsk::Judge { answers, .. }) if answers.lines().count() == 3);
    assert!(part.desk.learner.is_at(asked));
    let verdicts =
        vec![AnswerVerdict::All, AnswerVerdict::Some(vec![true, false, false]), AnswerVerdict::All];
    hear::answered(&mut part.state, &mut part.desk, Event::Study(StudySaid::Judged(verdicts)));
    part.act(Action::Only(Some(Flag::SomePairs)));
    assert_eq!(part.state.seen(), [1]);
    part.act(Action::Why("rude".into()));
    part.act(Action::Reject(2));
    part.act(Action::Decide);
    let decided: Vec<&Decision> = part.state.review.rows.iter().map(|row| &row.decision).collect();
    assert_eq!(decided[0], &Decision::Approved);
    assert_eq!(decided[1], &Decision::Rejected("the command does not hold in all pairs".into()));
    assert_eq!(decided[2], &Decision::Rejected("rude".into()));
    part.act(Action::Reopen(1));
    assert_eq!(part.state.review.rows[1].decision, Decision::Open);
    assert!(part.saves(Saved::Table).contains("\"'=1+1\""));
    part.act(Action::Key("k".into()));
    assert!(!part.saves(Saved::Lines).contains("anna"));
    part.act(Action::Key(String::new()));
    assert!(part.saves(Saved::Pay).contains("\"anna\",2,1,0"));
    assert_eq!(Study::read(&part.saves(Saved::TopUp)).unwrap().items.len(), 2);
    let corpus = part.act(Action::Train).unwrap();
    let text = String::from_utf8(corpus.bytes.unwrap()).unwrap();
    assert_eq!((text.lines().count(), text.matches("Rejected").count()), (3, 1));
    part.act(Action::Wanted(1));
    part.act(Action::Approve(2));
    part.act(Action::Save(Saved::TopUp));
    assert_eq!(part.state.notice.as_deref(), Some("Every task has enough answers."));
}

#[test]
fn another_programs_trials_are_mapped_first() {
    let groundling::study::Showing::Pair { pre, post } = showing(1);
    let trials = serde_json::json!([
        { "trial": 1 },
        { "said": "go east", "first": pre, "then": post, "who": "anna" },
    ]);
    let mut part = Part::default();
    part.act(Action::Answers(file("data.json", &trials.to_string())));
    assert!(part.state.survey.is_some() && part.state.review.rows.is_empty());
    part.act(Action::Map(Value::Command, "said".into()));
    part.act(Action::Map(Value::Pre(0), "first".into()));
    part.act(Action::Map(Value::Post(0), "then".into()));
    part.act(Action::Map(Value::Worker, "who".into()));
    let mapping = part.saves(Saved::Mapping);
    part.act(Action::Map(Value::Command, "trial".into()));
    part.act(Action::Mapping(file("mapping.json", &mapping)));
    part.act(Action::Convert);
    assert_eq!(part.state.review.rows.len(), 1, "{:?}", part.state.notice);
    assert_eq!(part.state.review.rows[0].answer.worker, "anna");
    part.act(Action::Answers(file("columns.json", "{\"a\":[1,2],\"b\":[1]}")));
    assert!(part.state.flaws.iter().any(|flaw| flaw.contains("no longer belong together")));
}
