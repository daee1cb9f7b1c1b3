//! Experiments: folds, scores by task, intervals, and the command that runs them.

#[path = "experiment/command.rs"]
mod command;
#[path = "experiment/confusion.rs"]
mod confusion;
#[path = "experiment/runs.rs"]
mod runs;

use groundling::corpus::folds;
use groundling::learn::{Mark, Report, Scores, Ties, Verdict};
use std::collections::BTreeSet;

fn keys(keys: &[&str]) -> Vec<String> {
    keys.iter().map(|key| (*key).to_owned()).collect()
}

#[test]
fn folds_part_a_corpus_and_no_command_is_in_both_halves() {
    let commands = ["a", "b", "a", "c", "d", "e", "b", "a", "f", "g", "h", "a"];
    let commands = keys(&commands);
    for seed in 0..20 {
        let all = folds(&commands, 3, seed);
        let mut tested: Vec<u32> = all.iter().flat_map(|fold| fold.test.clone()).collect();
        tested.sort_unstable();
        assert!(tested.into_iter().eq(0..12), "each row is judged on once");
        for fold in &all {
            let said = |rows: &[u32]| -> BTreeSet<&str> {
                rows.iter().map(|&row| commands[row as usize].as_str()).collect()
            };
            assert!(said(&fold.train).is_disjoint(&said(&fold.test)), "{fold:?}");
            assert_eq!(fold.train.len() + fold.test.len(), 12);
            assert!((2..=7).contains(&fold.test.len()), "about the same size: {fold:?}");
        }
        assert_eq!(all, folds(&commands, 3, seed), "the same seed, the same folds");
    }
    let distinct: BTreeSet<_> =
        (0..20).map(|seed| format!("{:?}", folds(&commands, 3, seed))).collect();
    assert!(distinct.len() > 10, "another seed, other folds");
}

#[test]
fn folds_without_enough_to_part_stay_empty() {
    let tests = |n, of: &[&str]| -> Vec<usize> {
        folds(&keys(of), n, 0).iter().map(|fold| fold.test.len()).collect()
    };
    assert_eq!(tests(3, &[]), [0, 0, 0]);
    assert_eq!(tests(3, &["a", "a"]), [2, 0, 0]);
    assert_eq!(tests(0, &["a"]), [0; 0]);
}

fn mark(task: &str, answer: Verdict, resolved: Verdict, skipped: bool) -> Mark {
    let task = (!task.is_empty()).then(|| task.to_owned());
    Mark { task, answer, resolved, skipped, probability: None, asked: false }
}

/// A report of 120 commands of three tasks and of none, answered in every way.
fn report() -> Report {
    use Verdict::{Right, Silent, Wrong};
    let kinds = [
        mark("go", Right, Right, false),
        mark("go", Right, Right, true),
        mark("near", Wrong, Wrong, false),
        mark("near", Silent, Right, false),
        mark("", Silent, Wrong, true),
        mark("move", Right, Right, false),
    ];
    Report { marks: kinds.iter().cycle().take(120).cloned().collect(), ..Report::default() }
}

#[test]
fn scores_of_tasks_add_up_to_the_whole() {
    let report = report();
    for ties in [Ties::Abstain, Ties::Refer] {
        let whole = report.scores(ties);
        let tasks = report.tasks(ties);
        assert_eq!(
            tasks.keys().copied().collect::<Vec<_>>(),
            [None, Some("go"), Some("move"), Some("near")]
        );
        let mut sum = Scores::default();
        for scores in tasks.values() {
            sum.total += scores.total;
            for (sum, score) in
                [(&mut sum.plain, scores.plain), (&mut sum.skipping, scores.skipping)]
            {
                sum.answered += score.answered;
                sum.correct += score.correct;
            }
        }
        assert_eq!(sum, whole);
    }
    let [paper, resolved] = [Ties::Abstain, Ties::Refer].map(|ties| report.scores(ties));
    assert_eq!((paper.plain.answered, paper.plain.correct), (60, 40));
    assert_eq!((paper.skipping.answered, paper.skipping.correct), (80, 60));
    assert_eq!((resolved.plain.answered, resolved.plain.correct), (80, 60));
    assert_eq!((resolved.skipping.answered, resolved.skipping.correct), (120, 80));
}

#[test]
fn intervals_are_steady_and_hold_the_figure() {
    let report = report();
    let intervals = report.intervals(Ties::Abstain);
    assert_eq!(intervals, report.intervals(Ties::Abstain));
    for ((low, high), figure) in intervals.into_iter().zip(report.scores(Ties::Abstain).figures()) {
        assert!(low < figure && figure < high, "{figure} in [{low}, {high}]");
        assert!(high - low < 0.3, "120 commands say more than [{low}, {high}]");
    }
    // Recall is a share of 120 draws: its standard error is √(p(1 − p)/120).
    let (low, high) = intervals[1];
    let share = 1.0 / 3.0;
    let error = (share * (1.0 - share) / 120.0_f64).sqrt();
    assert!((high - low - 2.0 * 1.96 * error).abs() < 0.03, "[{low}, {high}], error {error}");
    // What is always right is surely right, and nothing is known of nothing.
    let right = mark("go", Verdict::Right, Verdict::Right, false);
    let sure = Report { marks: vec![right; 9], ..Report::default() };
    assert_eq!(sure.intervals(Ties::Abstain), [(1.0, 1.0); 6]);
    assert_eq!(Report::default().intervals(Ties::Refer), [(0.0, 0.0); 6]);
}
