//! Rules that mark rows: too short, said before, unlike the others of their task.

use super::six;
use groundling::corpus::{Example, share};
use groundling::learn::sheet::Rules;
use groundling::learn::sheet::care::{Marks, duplicate, short, strange};

fn said(commands: &[&str]) -> Vec<Example> {
    let one = six()[0].clone();
    let task = Some("t".to_owned());
    let example = |(n, command): (usize, &&str)| Example {
        command: (*command).to_owned(),
        id: format!("A{n}"),
        line: n as u64 + 2,
        task: task.clone(),
        worker: Some(format!("w{}", n % 3)),
        ..one.clone()
    };
    commands.iter().enumerate().map(example).collect()
}

fn rows(marks: &Marks) -> Vec<u32> {
    marks.iter().map(|(row, ..)| *row).collect()
}

#[test]
fn commands_of_few_words_are_short() {
    let examples = said(&["go", "go there", "...go...", "to the red room"]);
    assert_eq!(rows(&short(&examples, Rules::default())), [0, 2]);
    let strict = Rules { least_words: 3, ..Rules::default() };
    let marks = short(&examples, strict);
    assert_eq!(rows(&marks), [0, 1, 2]);
    assert_eq!(marks[1].2, "2 of at least 3 words");
}

#[test]
fn what_the_same_person_said_before_of_the_same_is_a_duplicate() {
    let mut examples = said(&["go east", "go east", "go west", "Go  East!", "go east", "go east"]);
    examples[5].pairs = six()[1].pairs.clone();
    examples[5].worker = examples[4].worker.clone();
    let marks = duplicate(&examples);
    assert_eq!(rows(&marks), [3, 4], "the same words, person and demonstrations");
    assert_eq!(marks[0].2, "the same as A0 (line 2)");
    assert_eq!(marks[1].2, "the same as A1 (line 3)");
    let nobody: Vec<Example> =
        examples.iter().cloned().map(|one| Example { worker: None, ..one }).collect();
    assert_eq!(rows(&duplicate(&nobody)), [1, 3, 4]);
}

#[test]
fn a_command_that_shares_hardly_a_word_with_its_task_is_strange() {
    let mut commands = vec!["take the chair to the red room"; 5];
    commands.extend(["bring the chair to the red room", "put the chair in the red room"]);
    commands.extend(["asdf qwer", "move chair to red room", "i like this survey"]);
    let examples = said(&commands);
    let marks = strange(&examples, Rules::default());
    assert_eq!(rows(&marks), [7, 9]);
    assert!(
        marks[0].2.starts_with("its words stand in 0 % of the other commands of t"),
        "{marks:?}"
    );
    assert!(strange(&examples[3..], Rules::default()).is_empty(), "too few to tell");
    let unlabelled: Vec<Example> =
        examples.into_iter().map(|one| Example { task: None, ..one }).collect();
    assert!(strange(&unlabelled, Rules::default()).is_empty());
}

#[test]
fn a_share_keeps_what_belongs_together_and_never_takes_more() {
    let keys: Vec<String> = (0..100).map(|n| format!("k{}", n / 7)).collect();
    for percent in [1, 10, 25, 50, 99, 100] {
        for seed in 0..5 {
            let fold = share(&keys, percent, seed);
            assert!(fold.test.len() <= percent as usize);
            assert!(fold.test.len() + 7 > percent as usize, "{percent} {}", fold.test.len());
            assert_eq!(fold.train.len() + fold.test.len(), 100);
            let is_apart =
                |row: &u32| !fold.test.iter().any(|t| keys[*t as usize] == keys[*row as usize]);
            assert!(fold.train.iter().all(is_apart));
            assert_eq!(share(&keys, percent, seed), fold);
        }
    }
    assert_ne!(share(&keys, 30, 1), share(&keys, 30, 2));
    assert!(share(&[], 50, 0).test.is_empty());
}
