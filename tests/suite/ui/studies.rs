//! The workbench's part about studies, played without a browser: a study is drawn and opened, answers are merged, judged,
//! decided, saved and handed to training, and another program's trials are mapped.

use super::model;
use crate::study::files::{item, showing};
use groundling::corpus::{Decision, Options, read};
use groundling::study::answer::{FORMAT, lines};
use groundling::study::file::{Again, Order};
use groundling::study::{Answer, Care, Flag, Study};
use groundling::ui::page::engines::{self, News};
use groundling::ui::page::files::Offered;
use groundling::ui::train::desk::Desk;
use groundling::ui::train::effect::Effect;
use groundling::ui::train::study::action::{Action, Change, Place, Saved, Value};
use groundling::ui::train::study::files::restore;
use groundling::ui::train::study::{State, hear, update};
use groundling::worker::protocol::{Envelope, Event, Program, Request, VERSION, decode, encode};
use groundling::worker::{Engine, Learner};
use std::rc::Rc;

/// The part, with a desk and an engine of its own.
#[derive(Default)]
struct Part {
    state: State,
    desk: Desk,
    engine: Engine<Learner>,
    /// What the part wanted done besides.
    wanted: Vec<Effect>,
    /// What is to be trained on.
    corpus: Option<Offered>,
}

impl Part {
    /// Does what a person wants, and all that the engine does for it.
    fn act(&mut self, action: Action) {
        update::update(&mut self.state, &mut self.desk, action);
        self.settle();
    }

    fn hears(&mut self, id: u32, body: Event) {
        let said = Envelope { groundling: VERSION, id, body };
        match engines::heard(&mut self.desk, Program::Learner, said) {
            Some(News::Progress(Event::Study(said))) => hear::progressed(&mut self.state, &said),
            Some(News::Answer(Request::Study(ask), event)) => {
                let found = hear::answered(&mut self.state, &mut self.desk, ask, event);
                self.corpus = found.or(self.corpus.take());
            }
            _ => {}
        }
    }

    fn settle(&mut self) {
        loop {
            let wanted = self.desk.take_wanted();
            if wanted.is_empty() && !self.engine.busy() {
                break;
            }
            for effect in wanted {
                match effect {
                    Effect::SpawnEngine(_) => self.hears(0, Event::Ready),
                    Effect::Post(_, envelope) => self.engine.start(envelope.id, envelope.body),
                    Effect::Watch(..) => {}
                    other => self.wanted.push(other),
                }
            }
            if let Some((id, event)) = self.engine.step() {
                // As it crosses.
                let said = encode(&Envelope { groundling: VERSION, id, body: event }).unwrap();
                let Envelope { id, body, .. } = decode(&said).unwrap();
                self.hears(id, body);
            }
        }
    }

    fn saves(&mut self, what: Saved) -> String {
        self.wanted.clear();
        self.act(Action::Save(what));
        let found = self.wanted.iter().find_map(|effect| match effect {
            Effect::Save { text, .. } => Some(text.clone()),
            Effect::GiveBack(file) => Some(String::from_utf8_lossy(&file.bytes).into_owned()),
            _ => None,
        });
        found.unwrap_or_else(|| panic!("{what:?}: {:?}", self.state.notice))
    }

    fn id(&self, row: usize) -> String {
        self.state.review.rows[row].id.clone()
    }
}

fn file(name: &str, text: &str) -> Vec<Offered> {
    vec![Offered { name: name.into(), bytes: Ok(text.as_bytes().to_vec()) }]
}

const TASK: &str = "task to-bag\nsays Go to the bag.\ngoal (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> bag:<e,t>))\nthing any bag\n";

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
        runs: Vec::new(),
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
    part.act(Action::Draft(Change::Tasks(TASK.into())));
    part.act(Action::Draft(Change::Pairs(2)));
    part.act(Action::Draft(Change::Ways(true)));
    part.act(Action::Draft(Change::Says(Place::Example, "Off to the green bag!".into())));
    part.act(Action::Draft(Change::Check(0, "to-bag".into())));
    part.act(Action::Draft(Change::Must(0, "bag/sack go".into())));
    part.act(Action::Draft(Change::Check(1, "nowhere".into())));
    part.act(Action::Make);
    assert!(part.state.notice.as_deref().unwrap().contains("No task is called nowhere"));
    part.act(Action::Draft(Change::Check(1, String::new())));
    part.act(Action::Make);
    assert_eq!(part.state.making, None);
    let (made, fingerprint) = part.state.study.clone().unwrap();
    assert_eq!(made.fingerprint(), fingerprint);
    let [item] = &made.items[..] else { panic!("{} items", made.items.len()) };
    assert_eq!(item.must, [vec!["bag".to_owned(), "sack".into()], vec!["go".into()]]);
    assert!(item.shows.iter().all(|shown| shown.steps().is_some_and(|steps| steps >= 2)), "runs");
    let example = made.words.example.as_ref().unwrap();
    assert_eq!(example.command, "Off to the green bag!");
    assert!(example.shows.len() == 3 && example.shows[0].steps().is_some(), "{example:?}");
    assert_eq!(*made, Study::read(&part.saves(Saved::Study)).unwrap());
    part.act(Action::Open(file("six.json", &study().write())));
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
    assert_eq!((part.state.review.rows.len(), part.state.review.left_out), (3, [3, 0]));
    assert_eq!(part.state.bringing, None);
    part.act(Action::Judge);
    assert!(part.state.notice.is_some(), "there is no model yet");
    part.desk.in_use = Some(groundling::ui::page::document::Model {
        report: Rc::new(model(&std::fs::read_to_string("assets/model/cleanup.model").unwrap())),
        origin: groundling::ui::page::document::Origin::Shipped,
    });
    part.act(Action::Judge);
    assert_eq!(part.state.notice.as_deref(), Some("The model has read 3 answers."));
    assert!(part.state.review.is_judged && part.state.judging.is_none());
    let unread = part.state.review.rows[2].flags.contains(&Flag::Unread);
    assert!(unread, "{:?}", part.state.review.rows[2]);
    part.act(Action::Only(Some(Flag::Unread)));
    assert!(part.state.seen().contains(&2));
    part.act(Action::Look(part.id(2)));
    assert_eq!(part.state.looked_at, Some((part.id(2), vec![showing(1); 3])));
    part.act(Action::Look(part.id(2)));
    assert_eq!(part.state.looked_at, None);
    part.act(Action::Why("rude".into()));
    part.act(Action::Reject(part.id(2)));
    part.act(Action::Rule(Flag::NoPair));
    part.act(Action::Rule(Flag::SomePairs));
    part.act(Action::Decide);
    let decided: Vec<&Decision> = part.state.review.rows.iter().map(|row| &row.decision).collect();
    assert_eq!(decided[..2], [&Decision::Approved, &Decision::Approved]);
    assert_eq!(decided[2], &Decision::Rejected("rude".into()));
    part.act(Action::Reopen(part.id(1)));
    assert_eq!(part.state.review.coverage.iter().map(|task| task.approved).sum::<usize>(), 1);
    part.act(Action::Answers(file("a third time.jsonl", &text)));
    assert_eq!(part.state.review.rows[2].decision, Decision::Rejected("rude".into()), "it stays");
    assert!(part.saves(Saved::Table).contains("\"'=1+1\""));
    part.act(Action::Key("k".into()));
    assert!(!part.saves(Saved::Lines).contains("anna"));
    part.act(Action::Key(String::new()));
    assert!(part.saves(Saved::Pay).contains("\"anna\",2,1,0"));
    assert_eq!(Study::read(&part.saves(Saved::TopUp)).unwrap().items.len(), 2);
    part.act(Action::Train);
    let corpus = part.corpus.take().unwrap();
    let text = String::from_utf8(corpus.bytes.unwrap()).unwrap();
    assert_eq!((text.lines().count(), text.matches("Rejected").count()), (3, 1));
    part.act(Action::Wanted(1));
    part.act(Action::Approve(part.id(2)));
    part.act(Action::Save(Saved::TopUp));
    assert_eq!(part.state.notice.as_deref(), Some("Every task has enough answers."));
}

#[test]
fn what_no_corpus_takes_is_said_and_left_out_of_training_alone() {
    let study = study();
    let mut all = answers(&study);
    all[0].command = "go east ".repeat(300);
    all[1].command = "?!".into();
    let mut part = Part::default();
    part.act(Action::Open(file("study.json", &study.write())));
    part.act(Action::Answers(file("a.jsonl", &lines(&all))));
    let unfit = |part: &Part, row: usize| part.state.review.rows[row].flags.contains(&Flag::Unfit);
    assert_eq!([0, 1, 2].map(|row| unfit(&part, row)), [true, true, false]);
    assert!(part.saves(Saved::Lines).contains(&all[0].command), "it is saved whole");
    part.act(Action::Train);
    let bytes = part.corpus.take().unwrap().bytes.unwrap();
    let (corpus, flaws) = read(&bytes[..], Options::default());
    assert_eq!((corpus.examples.len(), flaws.len()), (1, 0), "{flaws:?}");
    let notice = part.state.notice.unwrap();
    assert!(notice.starts_with("2 left out: a corpus takes no command"), "{notice}");
}

#[test]
fn reading_can_be_stopped_and_an_engine_that_begins_anew_is_asked_all_again() {
    let study = study();
    let mut part = Part::default();
    part.act(Action::Open(file("study.json", &study.write())));
    let all = answers(&study);
    // What waits behind the file at work is not read any more.
    let files = [&all[..2], &all[2..]].map(|some| file("a.jsonl", &lines(some)));
    let open = Action::Answers(files.concat());
    update::update(&mut part.state, &mut part.desk, open.clone());
    assert!(part.state.bringing.is_some());
    update::update(&mut part.state, &mut part.desk, Action::Stop);
    part.settle();
    assert_eq!((part.state.review.rows.len(), part.state.bringing), (0, None));
    part.act(open);
    part.act(Action::Reject(part.id(0)));
    assert_eq!(part.state.review.rows.len(), 3);
    part.desk.learner.stop("it died".into());
    part.engine = Engine::default();
    let before = part.state.review.clone();
    engines::restart(&mut part.desk, Program::Learner);
    restore(&mut part.state, &mut part.desk);
    part.settle();
    let after = &part.state.review;
    assert_eq!((&after.rows, &after.coverage), (&before.rows, &before.coverage));
}

#[test]
fn another_programs_trials_are_mapped_first() {
    let shown = showing(1);
    let (pre, post) = shown.states();
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
    assert_eq!(part.state.review.rows[0].worker, "anna");
    part.act(Action::Answers(file("columns.json", "{\"a\":[1,2],\"b\":[1]}")));
    let flaws = &part.state.review.flaws;
    assert!(flaws.iter().any(|flaw| flaw.contains("no longer belong together")), "{flaws:?}");
}
