//! Making a study: of tasks, for which pairs are drawn, or of a corpus, whose rows bring their own. In steps, a world
//! each.

use super::file::{Example as Worked, Item, Rehearsed, Study};
use super::pairs::{DrawError, Drawing};
use super::showing::Showing;
use super::tasks::{StudyTask, read_tasks};
use crate::corpus::{Decision, Example};

/// The task of the worked example, which no corpus asks.
const EXAMPLE: &str = "task example
says Go and stand next to the green bag.
goal (near:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (agent:<e,t> $0))) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (bag:<e,t> $0) (green:<e,t> $0)))))
thing green bag
thing red bag";

/// The worked example of a study in German.
const GERMAN: &str = "Geh zur grünen Tasche und bleib neben ihr stehen.";

/// A study of tasks, being made.
pub struct Making {
    /// What it is to be; an example that shows nothing is drawn.
    study: Study,
    tasks: Vec<StudyTask>,
    /// How many pairs an item has.
    pairs: usize,
    /// Whether they are runs, whatever the goal.
    has_ways: bool,
    at: usize,
    drawing: Option<Drawing>,
    open: Vec<String>,
}

/// A study that was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The study.
    pub study: Study,
    /// What the pairs of a task leave open, in words.
    pub open: Vec<String>,
}

impl Making {
    /// A study like this one, an item for each of these tasks.
    pub fn new(study: Study, tasks: Vec<StudyTask>, pairs: usize) -> Making {
        Making { study, tasks, pairs, has_ways: false, at: 0, drawing: None, open: Vec::new() }
    }

    /// Shows the robot's way in every item, in place of what is before and after.
    #[must_use]
    pub fn with_ways(mut self) -> Making {
        self.has_ways = true;
        self
    }

    /// How many items there are, and how many there will be.
    pub fn progress(&self) -> (usize, usize) {
        (self.study.items.len(), self.tasks.len())
    }

    /// Tries one more world; the study, or why there is none, at the end.
    pub fn step(&mut self) -> Option<Result<Made, DrawError>> {
        let seed = u64::from(self.study.seed);
        if let Some(drawing) = &mut self.drawing {
            let drawn = match drawing.step()? {
                Ok(drawn) => drawn,
                Err(error) => return Some(Err(error)),
            };
            self.drawing = None;
            let shows: Vec<Showing> = drawn.pairs.into_iter().map(Showing::from).collect();
            let Some(task) = self.tasks.get(self.at) else {
                let german = self.study.language == "de";
                let says = example().first().map_or(String::new(), |t| t.says[0].words.clone());
                let usual = if german { GERMAN.to_owned() } else { says };
                let own = self.study.words.example.take().map(|example| example.command);
                let command = own.unwrap_or(usual);
                self.study.words.example = Some(Worked { shows, command });
                return Some(Ok(Made { study: self.study.clone(), open: self.open.clone() }));
            };
            if !drawn.open.is_empty() {
                let open = drawn.open.join(", ");
                self.open.push(format!(
                    "{}: with {} pairs this stays open: {open}",
                    task.name, self.pairs
                ));
            }
            let (id, label) = (task.name.clone(), Some(task.name.clone()));
            let (must, rehearsed) = (task.must.clone(), Vec::new());
            self.study.items.push(Item { id, task: label, shows, must, rehearsed });
            self.at += 1;
            return None;
        }
        let begun = match self.tasks.get(self.at) {
            Some(task) => Drawing::new(&self.tasks, &task.name, self.pairs, seed),
            None if self.study.words.example.as_ref().is_some_and(|one| !one.shows.is_empty()) => {
                return Some(Ok(Made { study: self.study.clone(), open: self.open.clone() }));
            }
            None => Drawing::new(&example(), "example", self.study.shown.max(1), seed),
        };
        match begun {
            Ok(drawing) if self.has_ways => self.drawing = Some(drawing.with_ways()),
            Ok(drawing) => self.drawing = Some(drawing),
            Err(error) => return Some(Err(error)),
        }
        None
    }
}

/// The task of the worked example.
fn example() -> Vec<StudyTask> {
    // It is this file's own text: a test reads it.
    read_tasks(EXAMPLE).unwrap_or_default()
}

/// A study like this one, with an item for each row of a corpus, which shows the row's own pairs. With `rehearsed`, what
/// was said of it is kept for rehearsals, and whether it was rejected.
pub fn of_corpus(mut study: Study, examples: &[Example], rehearsed: bool) -> Study {
    let item = |(at, example): (usize, &Example)| Item {
        id: format!("row-{}", at + 1),
        task: example.task.clone(),
        shows: example.pairs.iter().cloned().map(Showing::from).collect(),
        must: Vec::new(),
        rehearsed: match rehearsed {
            true => vec![Rehearsed {
                words: example.command.clone(),
                careless: matches!(example.decision, Decision::Rejected(_)),
            }],
            false => Vec::new(),
        },
    };
    study.items.extend(examples.iter().enumerate().map(item));
    study
}
