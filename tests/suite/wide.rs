//! The corpus of many voices: every row of `assets/corpus/wide.csv.xz` is a command of `wide.txt`, and its pairs show
//! the task and none of the readings that the task is unlike.

use groundling::corpus::{Corpus, Options, read};
use groundling::ground::Goal;
use groundling::logic::{Terms, read as form};
use groundling::study::read_tasks;
use std::collections::BTreeSet;
use std::process::Command;

const WIDE: &str = include_str!("../../assets/corpus/wide.txt");

/// The rows, unpacked by the command that packed them.
pub(crate) fn rows() -> Corpus {
    let packed = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/corpus/wide.csv.xz");
    let xz = Command::new("xz").args(["--decompress", "--stdout", packed]).output();
    let xz = xz.expect("xz unpacks the corpus: apt-get install xz-utils");
    assert!(xz.status.success(), "{xz:?}");
    let (corpus, flaws) = read(&xz.stdout[..], Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    corpus
}

#[test]
fn the_rows_are_the_commands_and_show_what_they_mean() {
    let (tasks, corpus) = (read_tasks(WIDE).unwrap(), rows());
    let sayings: Vec<_> = tasks.iter().flat_map(|t| t.says.iter().map(move |s| (t, s))).collect();
    assert!(sayings.len() >= 1_200);
    assert_eq!(corpus.examples.len(), sayings.len(), "make corpus draws the rows anew");
    for ((task, saying), row) in sayings.into_iter().zip(&corpus.examples) {
        assert_eq!(row.command, saying.words, "make corpus draws the rows anew");
        assert_eq!((&row.worker, row.task.as_ref()), (&saying.voice, Some(&task.name)));
        assert_eq!(row.pairs.len(), 3);
        let mut terms = Terms::new();
        let mut shown = |text: &str| {
            let term = form(&mut terms, text).unwrap();
            row.pairs.iter().all(|pair| {
                let goal = Goal::new(&terms, term, &pair.pre).unwrap();
                !goal.holds(&pair.pre) && goal.holds(&pair.post)
            })
        };
        assert!(shown(&task.goal), "{}", row.id);
        for reading in &task.unlike {
            assert!(!shown(reading), "{} is open to {reading}", row.id);
        }
    }
}

#[test]
fn no_two_commands_have_the_same_words_or_layouts() {
    let corpus = rows();
    let words: BTreeSet<String> =
        corpus.examples.iter().map(|e| e.command.to_lowercase()).collect();
    assert_eq!(words.len(), corpus.examples.len());
    let layouts: BTreeSet<String> =
        corpus.examples.iter().flat_map(|e| &e.pairs).map(|pair| pair.pre.write()).collect();
    assert_eq!(layouts.len(), 3 * corpus.examples.len());
}

#[test]
fn every_command_has_a_voice_and_every_register_its_share() {
    let tasks = read_tasks(WIDE).unwrap();
    let registers =
        ["hurried", "child", "formal", "second", "spoken", "polite", "technical", "plain"];
    let voices = tasks.iter().flat_map(|t| &t.says).map(|s| s.voice.as_deref().unwrap());
    let voices: Vec<&str> = voices.collect();
    let of = |register: &str| {
        let start = format!("wide-{register}-");
        voices.iter().filter(|voice| voice.starts_with(&start)).count()
    };
    assert!(registers.iter().all(|register| of(register) >= 50), "{voices:?}");
    assert_eq!(registers.iter().map(|register| of(register)).sum::<usize>(), voices.len());
}

#[test]
fn its_readme_counts_the_tasks_and_commands_of_each_kind() {
    let readme = include_str!("../../assets/corpus/README.md");
    let begins = |line: &&str, with: &str| line.starts_with(with);
    let count = |text: &str, with: &str| text.lines().filter(|line| begins(line, with)).count();
    let sections = WIDE.split("\n# --- ").skip(1);
    let counted = sections.map(|text| (count(text, "task "), count(text, "says ")));
    let (_, table) = readme.split_once("| construction").unwrap();
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let told = rows.map(|row| {
        let mut cells =
            row.trim_matches(['|', ' ']).rsplit(" | ").map(|cell| cell.parse().unwrap());
        let commands = cells.next().unwrap();
        (cells.next().unwrap(), commands)
    });
    assert!(told.eq(counted), "constructions");
    let voices = readme.lines().filter(|line| line.starts_with("| `wide-"));
    let mut all = 0;
    for row in voices {
        let (voice, rest) = row["| `".len()..].split_once("-1`").unwrap();
        let told: usize = rest.split(" | ").nth(1).unwrap().parse().unwrap();
        assert_eq!(told, count(WIDE, &format!("says {voice}-")), "{voice}");
        all += told;
    }
    assert_eq!(all, count(WIDE, "says "));
    assert!(readme.contains(&format!("with {},{:03} commands", all / 1000, all % 1000)));
}
