//! The page that asks, as its reducer has it: coming, answering, ending, leaving, and all that may go wrong with the store,
//! with no browser.

use crate::study::files::{run, study as sample};
use groundling::study::ends::{Refusal, Source};
use groundling::study::journal::Note;
use groundling::study::{End, Link, Study};
use groundling::ui::collect::action::{Kept, Trouble};
use groundling::ui::collect::runs::on_view;
use groundling::ui::collect::state::{Over, Stage};
use groundling::ui::collect::{Action, Effect, State, reduce};
use groundling::ui::page::keep::fault::Fault;
use groundling::ui::page::language::Language;

/// A person at the page, and a store that keeps what it is told to.
struct Person {
    state: State,
    kept: Vec<Note>,
    over: Option<String>,
    /// What is wrong with the store.
    fault: Option<Fault>,
    /// What was wanted and is none of the store's.
    wanted: Vec<Effect>,
}

impl Person {
    fn comes(study: &Study, link: &str, source: Source) -> Person {
        let mut person = Person {
            state: State::default(),
            kept: Vec::new(),
            over: None,
            fault: None,
            wanted: Vec::new(),
        };
        person.visits(study, link, source);
        person
    }

    fn visits(&mut self, study: &Study, link: &str, source: Source) {
        self.state = State::default();
        self.wanted.clear();
        self.act(Action::Opened(Box::new(Link::of(link)), Language::English));
        self.act(Action::Came(Ok((Box::new(study.clone()), source))));
    }

    fn act(&mut self, action: Action) {
        let mut effects = reduce(&mut self.state, action, 5.0);
        while !effects.is_empty() {
            let effect = effects.remove(0);
            let said = match &effect {
                Effect::Open(_) => Action::Known(Ok("pseudonym".to_owned())),
                Effect::Claim { .. } => Action::Claimed(true),
                Effect::Read(_) => {
                    Action::Read(Ok(Kept { notes: self.kept.clone(), over: self.over.clone() }))
                }
                Effect::Keep { place, note, .. } => match &self.fault {
                    Some(fault) => Action::Noted(Err(fault.clone())),
                    None => {
                        assert_eq!(*place as usize, self.kept.len(), "no place is taken twice");
                        self.kept.push((**note).clone());
                        Action::Noted(Ok(()))
                    }
                },
                Effect::Erase { over, .. } => {
                    self.kept.clear();
                    self.over.clone_from(over);
                    Action::Erased(Ok(()))
                }
                _ => {
                    self.wanted.push(effect);
                    continue;
                }
            };
            effects.extend(reduce(&mut self.state, said, 5.0));
        }
    }

    fn begins(&mut self) {
        self.act(Action::Agree);
        self.act(Action::Ready);
    }

    fn says(&mut self, words: &str) {
        self.act(Action::Typed(words.to_owned(), 0));
        self.act(Action::Answer);
    }

    fn posts(&self) -> usize {
        self.wanted
            .iter()
            .filter(|effect| matches!(effect, Effect::Post { .. } | Effect::Submit { .. }))
            .count()
    }
}

fn study(ends: Vec<End>) -> Study {
    let mut study = sample(2);
    study.hosts = vec!["https://panel.example".into()];
    study.ends = ends;
    study
}

fn endpoint() -> End {
    End::Endpoint { url: "https://panel.example/in".into(), key: "k".into() }
}

#[test]
fn a_person_takes_part_and_nothing_stays_but_the_code() {
    let study = study(vec![End::Code, End::File]);
    let mut person = Person::comes(&study, "?participant=anna", Source::Hosted);
    assert_eq!(person.state.stage(), Stage::Welcome);
    person.begins();
    assert_eq!(person.state.stage(), Stage::Turn(0));
    person.act(Action::Answer);
    assert_eq!(person.state.stage(), Stage::Turn(0), "nothing was said");
    person.act(Action::Spent(1_500, vec![true, false]));
    person.act(Action::Point(0));
    person.says("one");
    person.says("two");
    assert_eq!(person.state.stage(), Stage::End(0));
    let answers = person.state.sitting.as_ref().unwrap().answers(&study);
    assert_eq!((answers[0].care.active_ms, answers[0].care.changes), (1_500, 1));
    assert_eq!(answers[0].care.seen_ms, [1_500, 0]);
    assert_eq!(answers[1].care.active_ms, 0, "each turn has its own time");
    person.act(Action::End);
    person.act(Action::Ended);
    person.act(Action::End);
    assert!(
        matches!(person.wanted.last(), Some(Effect::Save { name, .. }) if name.ends_with(".jsonl"))
    );
    person.act(Action::Ended);
    let code = person.over.clone().unwrap();
    assert_eq!((person.kept.len(), code.len()), (0, 8));
    person.visits(&study, "?participant=anna", Source::Hosted);
    assert_eq!(person.state.over, Some(Over::Done(Some(code))));
}

#[test]
fn what_was_typed_and_answered_is_there_again() {
    let study = study(vec![End::File]);
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.begins();
    person.says("one");
    person.act(Action::Typed("tw".into(), 0));
    person.act(Action::Rested);
    let notes = person.kept.len();
    person.act(Action::Rested);
    assert_eq!(person.kept.len(), notes, "the same is kept once");
    person.visits(&study, "", Source::Hosted);
    assert_eq!((person.state.stage(), person.state.text.as_str()), (Stage::Turn(1), "tw"));
    person.says("two");
    assert_eq!(person.state.stage(), Stage::End(0));
    assert_eq!(person.state.sitting.as_ref().unwrap().answers(&study).len(), 2);
}

#[test]
fn a_visit_that_was_broken_off_is_as_the_study_says() {
    use groundling::study::file::Again;
    let mut study = study(vec![End::File]);
    for (again, wanted) in [
        (Again::Refuse, Stage::Refused),
        (Again::Restart, Stage::Welcome),
        (Again::Resume, Stage::Turn(1)),
    ] {
        study.again = again;
        let mut person = Person::comes(&study, "", Source::Hosted);
        person.begins();
        person.says("one");
        person.visits(&study, "", Source::Hosted);
        assert_eq!(person.state.stage(), wanted);
    }
    study.again = Again::Refuse;
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.begins();
    person.says("one");
    person.says("two");
    person.visits(&study, "", Source::Hosted);
    assert_eq!(person.state.stage(), Stage::End(0), "answers that are all given are not refused");
}

#[test]
fn an_answer_that_follows_a_note_on_its_way_waits_for_it() {
    let study = study(vec![End::File]);
    let mut state = Person::comes(&study, "", Source::Hosted);
    state.begins();
    let state = &mut state.state;
    reduce(state, Action::Typed("go".into(), 0), 1.0);
    let first = reduce(state, Action::Rested, 1.0);
    assert!(matches!(&first[..], [Effect::Keep { place: 2, .. }]));
    assert_eq!(reduce(state, Action::Answer, 2.0), [], "the first is on its way");
    let second = reduce(state, Action::Noted(Ok(())), 3.0);
    assert!(
        matches!(&second[..], [Effect::Keep { place: 3, note, .. }] if matches!(**note, Note::Answered { turn: 0, .. }))
    );
    reduce(state, Action::Noted(Ok(())), 4.0);
    assert_eq!(state.stage(), Stage::Turn(1));
}

#[test]
fn without_a_store_it_goes_on_and_says_so() {
    let study = study(vec![End::File]);
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.fault = Some(Fault::Full);
    person.begins();
    assert_eq!((person.state.stage(), &person.state.fault), (Stage::Turn(0), &Some(Fault::Full)));
    person.says("one");
    person.fault = None;
    person.says("two");
    assert_eq!((person.state.stage(), &person.state.fault), (Stage::End(0), &None));
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.fault = Some(Fault::Elsewhere);
    person.act(Action::Agree);
    assert_eq!(person.state.stage(), Stage::Elsewhere);
    person.fault = None;
    person.act(Action::Take);
    assert_eq!(person.state.stage(), Stage::Welcome);
}

#[test]
fn what_does_not_arrive_is_tried_again_and_sent_once() {
    let study = study(vec![endpoint(), End::Code]);
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.begins();
    person.says("one");
    person.says("two");
    assert_eq!(person.posts(), 1, "it is posted by itself");
    person.act(Action::Again);
    assert_eq!(person.posts(), 1, "not twice at once");
    person.act(Action::Posted(Err("503".into())));
    assert!(person.wanted.contains(&Effect::Retry(1_000)));
    person.act(Action::Again);
    person.act(Action::Posted(Err("503".into())));
    assert!(person.wanted.contains(&Effect::Retry(2_000)));
    person.visits(&study, "", Source::Hosted);
    assert_eq!((person.state.stage(), person.posts()), (Stage::End(0), 1), "and after a reload");
    person.act(Action::Posted(Ok(())));
    assert_eq!(person.state.stage(), Stage::End(1));
    person.visits(&study, "", Source::Hosted);
    assert_eq!((person.state.stage(), person.posts()), (Stage::End(1), 0));
    assert_eq!(
        Person::comes(&study, "", Source::Hosted).posts(),
        0,
        "nothing before there are answers"
    );
}

#[test]
fn nothing_is_posted_where_it_may_not_be() {
    let ends = [vec![endpoint()], vec![End::Form { url: None }]];
    for ends in ends {
        let study = study(ends);
        for (link, source, refusal) in [
            ("", Source::Linked, None),
            (
                "?simulate=1&turkSubmitTo=https%3A%2F%2Fpanel.example",
                Source::Hosted,
                Some(Refusal::Simulated),
            ),
        ] {
            let mut person = Person::comes(&study, link, source);
            person.begins();
            person.says("one");
            person.says("two");
            person.act(Action::End);
            person.act(Action::Again);
            assert_eq!(person.posts(), 0, "{link}");
            let found = person.state.ending.refusal.clone();
            assert!(
                found.is_some() && refusal.is_none_or(|refusal| found == Some(refusal)),
                "{link}"
            );
            person.act(Action::Save);
            assert!(matches!(person.wanted.last(), Some(Effect::Save { .. })));
        }
        let mut person = Person::comes(
            &study,
            "?preview&turkSubmitTo=https%3A%2F%2Fpanel.example",
            Source::Hosted,
        );
        person.begins();
        person.says("one");
        person.says("two");
        person.act(Action::End);
        assert_eq!((person.posts(), person.kept.len(), &person.over), (0, 0, &None), "a preview");
        assert_eq!(person.state.stage(), Stage::Over);
    }
}

#[test]
fn a_form_leaves_once_that_is_kept_and_can_be_sent_again() {
    let study = study(vec![End::Form { url: None }]);
    let link = "?workerId=A1&assignmentId=3Z&turkSubmitTo=https%3A%2F%2Fpanel.example";
    let mut person = Person::comes(&study, link, Source::Hosted);
    person.begins();
    person.says("one");
    person.says("two");
    person.act(Action::End);
    assert!(matches!(person.kept.last(), Some(Note::Handed { end: 0 })));
    let Some(Effect::Submit { url, fields }) = person.wanted.last() else {
        panic!("{:?}", person.wanted)
    };
    assert_eq!(url, "https://panel.example/mturk/externalSubmit");
    assert!(fields.contains(&("assignmentId".into(), "3Z".into())));
    person.visits(&study, link, Source::Hosted);
    assert_eq!((person.state.stage(), &person.state.over), (Stage::Over, &None));
    person.act(Action::End);
    assert_eq!(person.posts(), 1);
    person.act(Action::Ended);
    assert_eq!(person.kept.len(), 0);
}

#[test]
fn who_withdraws_leaves_nothing() {
    let study = study(vec![End::File]);
    let mut person = Person::comes(&study, "", Source::Hosted);
    person.begins();
    person.says("one");
    person.act(Action::Withdrawn);
    assert_eq!(person.state.stage(), Stage::Turn(1), "not without being asked");
    person.act(Action::Withdraw);
    person.act(Action::Stay);
    person.act(Action::Withdraw);
    person.act(Action::Withdrawn);
    assert_eq!((person.kept.len(), &person.state.over), (0, &Some(Over::Withdrawn)));
}

#[test]
fn a_link_without_a_study_is_trouble() {
    let mut state = State::default();
    let wanted = reduce(
        &mut state,
        Action::Opened(Box::new(Link::of("?study=https://a.example/x")), Language::German),
        0.0,
    );
    assert_eq!((wanted.len(), &state.trouble), (0, &Some(Trouble::Elsewhere)));
    let mut state = State::default();
    let wanted = reduce(&mut state, Action::Opened(Box::new(Link::of("")), Language::German), 0.0);
    assert_eq!(wanted, [Effect::Unpack]);
    reduce(&mut state, Action::Came(Err(Trouble::Unnamed)), 0.0);
    assert_eq!((state.stage(), state.language), (Stage::Trouble, Language::German));
}

#[test]
fn a_run_is_played_and_not_seen_before_its_end() {
    let mut study = study(vec![End::Code]);
    study.shown = 2;
    for item in &mut study.items {
        item.shows = vec![run("ee"), run("e")];
    }
    let mut person = Person::comes(&study, "?participant=anna", Source::Hosted);
    person.begins();
    let steps: Vec<usize> =
        on_view(&person.state).iter().map(|showing| showing.steps().unwrap()).collect();
    let (long, short) = if steps == [2, 1] { (0, 1) } else { (1, 0) };
    let ticks = |person: &Person| {
        person.wanted.iter().filter(|effect| matches!(effect, Effect::Tick(_))).count()
    };
    person.act(Action::Spent(500, vec![true, true]));
    assert_eq!(person.state.care.seen_ms, [0, 0], "in sight, and not played");
    person.act(Action::Play(long));
    person.act(Action::Ticked);
    assert_eq!((person.state.runs.gone[&long], ticks(&person)), (1, 2));
    person.act(Action::Play(long));
    person.act(Action::Ticked);
    assert_eq!((person.state.runs.gone[&long], ticks(&person)), (1, 2), "it rests");
    person.act(Action::Step(long));
    person.act(Action::Step(long));
    assert_eq!(person.state.runs.gone[&long], 2, "it goes no further than its end");
    person.act(Action::Spent(500, vec![true, true]));
    assert_eq!(person.state.care.seen_ms[long], 500);
    assert_eq!(person.state.care.seen_ms[short], 0);
    person.act(Action::Play(short));
    person.act(Action::Play(long));
    person.act(Action::Ticked);
    assert_eq!(person.state.runs.playing, Some(long), "one at once, and again from its start");
    assert_eq!((person.state.runs.gone[&long], person.state.runs.gone[&short]), (1, 0));
    person.says("go");
    assert_eq!(person.state.runs, Default::default(), "the next turn begins anew");
}
