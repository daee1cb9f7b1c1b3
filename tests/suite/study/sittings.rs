//! Sittings: notes that were cut off anywhere make a sitting that goes on, and nothing is lost or doubled.

use super::files::{run, showing, study};
use groundling::study::journal::{Note, Sitting, Who};
use groundling::study::plan::plan;
use groundling::study::{Care, Study};

fn who() -> Who {
    Who { worker: "anna".into(), assignment: Some("a1".into()), hit: None, simulated: None }
}

fn begun(study: &Study) -> Note {
    let turns = plan(study, "anna");
    Note::Begun { study: study.fingerprint(), who: who(), turns, at: 1.0 }
}

fn typed(turn: usize, text: &str) -> Note {
    Note::Typed { turn, text: text.into(), care: Care { keys: 3, ..Care::default() } }
}

fn answered(turn: usize, text: &str) -> Note {
    Note::Answered { turn, text: text.into(), care: Care::default(), at: 5.0 }
}

#[test]
fn a_sitting_goes_on_wherever_it_was_cut_off() {
    let study = study(3);
    let notes = [
        begun(&study),
        Note::Ready,
        typed(0, "go"),
        answered(0, "go east"),
        typed(1, "st"),
        typed(1, "step"),
        answered(1, "step aside"),
        answered(2, "=1+1\n\u{202e}a"),
        Note::Handed { end: 0 },
    ];
    let mut before = 0;
    for cut in 1..=notes.len() {
        let sitting = Sitting::of(&notes[..cut]).unwrap();
        let answers = sitting.answers(&study);
        assert!(answers.len() >= before);
        before = answers.len();
        // A note that is there twice changes nothing.
        let twice: Vec<&Note> = notes[..cut].iter().flat_map(|note| [note, note]).collect();
        assert_eq!(Sitting::of(twice).unwrap(), sitting);
    }
    let at = |cut: usize| Sitting::of(&notes[..cut]).unwrap();
    assert_eq!((at(3).turn(), at(3).draft.text.as_str()), (Some(0), "go"));
    assert_eq!((at(4).turn(), at(4).draft.text.as_str()), (Some(1), ""));
    assert_eq!(at(6).draft.text, "step");
    assert_eq!((at(8).turn(), at(8).end(&study)), (None, Some(0)));
    assert_eq!(at(9).end(&study), None);
    assert_eq!(Sitting::of(&notes[1..]), None, "it never began");
    let answers = at(9).answers(&study);
    assert_eq!(answers[2].command, "=1+1\n\u{202e}a");
    assert_eq!(answers[2].turn, [3, 3]);
    assert!(
        answers.iter().all(|answer| answer.pairs.len() == 3 && answer.sitting() == at(9).name())
    );
}

#[test]
fn the_first_answer_counts() {
    let study = study(1);
    let notes = [begun(&study), answered(0, "one"), answered(0, "two"), typed(0, "late")];
    let sitting = Sitting::of(&notes).unwrap();
    assert_eq!(sitting.answers(&study)[0].command, "one");
    assert_eq!(sitting.draft.text, "");
    let strange = [begun(&study), answered(7, "one"), typed(7, "x"), Note::Handed { end: 9 }];
    assert_eq!(Sitting::of(&strange).unwrap().answers(&study), []);
}

#[test]
fn a_completion_code_tells_the_answers() {
    let study = study(2);
    let code = |second: &str| {
        let notes = [begun(&study), answered(0, "one"), answered(1, second)];
        Sitting::of(&notes).unwrap().code(&study)
    };
    assert_eq!(code("two"), code("two"));
    assert_ne!(code("two"), code("two."));
    assert!(code("two").len() == 8 && code("two").chars().all(|c| c.is_ascii_alphanumeric()));
}

#[test]
fn who_comes_by_the_same_link_comes_back() {
    let again = who();
    let other = Who { assignment: Some("a2".into()), ..who() };
    assert_eq!(again.sitting("s"), who().sitting("s"));
    assert_ne!(other.sitting("s"), who().sitting("s"));
    assert_ne!(again.sitting("s"), who().sitting("t"));
    let split = |worker: &str, assignment: &str| {
        Who { worker: worker.into(), assignment: Some(assignment.into()), ..Who::default() }
            .sitting("s")
    };
    assert_ne!(split("ab", "c"), split("a", "bc"), "names do not run into one another");
}

#[test]
fn what_was_said_of_runs_is_a_line_of_a_corpus() {
    let mut study = study(1);
    study.items[0].shows = vec![run("ee"), showing(1), run("e")];
    let notes = [begun(&study), Note::Ready, answered(0, "go east")];
    let answers = Sitting::of(&notes).unwrap().answers(&study);
    assert_eq!((answers[0].pairs.len(), answers[0].runs.len()), (1, 2));
    let lines = groundling::study::answer::lines(&answers);
    let merged = groundling::study::merge([("a.jsonl", lines.as_str())]);
    assert_eq!(merged.answers[0].0, answers[0]);
    let (review, _) = groundling::study::Review::new(&study, merged.answers);
    for is_json in [false, true] {
        let style = groundling::study::export::Style { is_json, ..Default::default() };
        let mut bytes = Vec::new();
        groundling::study::export::write(&review, &style, &mut bytes).unwrap();
        for bytes in [bytes.as_slice(), lines.as_bytes()] {
            let (corpus, flaws) = groundling::corpus::read(bytes, Default::default());
            let pairs = &corpus.examples[0].pairs;
            assert!(flaws.is_empty(), "{flaws:?}");
            assert_eq!(pairs.iter().filter(|pair| pair.way.is_some()).count(), 2);
            assert_eq!(pairs.len(), 3);
        }
    }
}
