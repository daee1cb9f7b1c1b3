//! The tasks of a study as a text that a person can read and change; its own head says what each line means.
//! Invariant: the goal of a task that was read is a goal of Cleanup World, and so is every reading it is unlike.

use crate::domain::{Color, Shape};
use crate::ground::goal::check;
use crate::logic::{Terms, print, read};
use std::str::FromStr;

/// The 23 tasks of the corpus.
pub const TASKS: &str = include_str!("../../assets/corpus/tasks.txt");

/// A task: a goal, and the worlds it is shown in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyTask {
    /// Its label, unique in its file.
    pub name: String,
    /// One way to say it.
    pub says: String,
    /// The form that holds after and not before.
    pub goal: String,
    /// The colours of the rooms, three.
    pub rooms: Vec<Color>,
    /// The objects that are there.
    pub things: Vec<Look>,
    /// Whether the largest and the smallest room are told from the others at a glance.
    pub apart: bool,
    /// Forms that some pair has to disprove.
    pub unlike: Vec<String>,
}

/// What an object looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Look {
    pub paint: Paint,
    pub shape: Shape,
}

/// The colour of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// This one.
    Is(Color),
    /// Whichever.
    Any,
    /// None that the task names for the shape.
    Other,
}

/// What is wrong with a file of tasks, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {message}")]
pub struct TaskFileError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong and what to do.
    pub message: String,
}

/// The rooms of every world.
const N_ROOMS: usize = 3;
/// Most objects of a task.
const MAX_THINGS: usize = 8;

/// Reads a file of tasks.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn read_tasks(text: &str) -> Result<Vec<StudyTask>, TaskFileError> {
    let mut rooms = vec![Color::Red, Color::Green, Color::Blue];
    let mut tasks: Vec<StudyTask> = Vec::new();
    let mut last = 0;
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        let error = |message: String| TaskFileError { line: number, message };
        if word == "task" {
            complete(tasks.last(), last)?;
            last = number;
            if rest.is_empty() {
                return Err(error("a task needs a name".into()));
            }
            if tasks.iter().any(|t| t.name == rest) {
                return Err(error(format!("a second task is called `{rest}`: rename one")));
            }
            tasks.push(StudyTask {
                name: rest.to_owned(),
                says: String::new(),
                goal: String::new(),
                rooms: rooms.clone(),
                things: Vec::new(),
                apart: false,
                unlike: Vec::new(),
            });
            continue;
        }
        match tasks.last_mut() {
            Some(task) => task.line(word, rest),
            None if word == "rooms" => colors(rest).map(|read| rooms = read),
            None => Err(format!("`{word}` stands before the first task: begin with `task NAME`")),
        }
        .map_err(error)?;
    }
    complete(tasks.last(), last)?;
    if tasks.is_empty() {
        return Err(TaskFileError {
            line: 1,
            message: "there is no task: begin with `task NAME`".into(),
        });
    }
    Ok(tasks)
}

/// Whether a task that began in `line` has all that it needs.
fn complete(task: Option<&StudyTask>, line: usize) -> Result<(), TaskFileError> {
    let Some(task) = task else { return Ok(()) };
    for (word, is_there) in [("goal", !task.goal.is_empty()), ("says", !task.says.is_empty())] {
        if !is_there {
            let message = format!("the task `{}` has no line `{word}`: add one", task.name);
            return Err(TaskFileError { line, message });
        }
    }
    Ok(())
}

impl StudyTask {
    /// Takes a line of the task.
    fn line(&mut self, word: &str, rest: &str) -> Result<(), String> {
        match word {
            "says" if rest.is_empty() => return Err("`says` needs words".into()),
            "says" if self.says.is_empty() => self.says = rest.to_owned(),
            "goal" if self.goal.is_empty() => self.goal = form(rest)?,
            "says" | "goal" => return Err(format!("a second `{word}`: leave one out")),
            "unlike" => self.unlike.push(form(rest)?),
            "rooms" => self.rooms = colors(rest)?,
            "apart" if rest.is_empty() => self.apart = true,
            "thing" if self.things.len() == MAX_THINGS => {
                return Err(format!("more than {MAX_THINGS} things: leave some out"));
            }
            "thing" => self.things.push(look(rest)?),
            _ => {
                return Err(format!(
                    "`{word}` is unknown here: use task, says, goal, rooms, thing, apart or unlike"
                ));
            }
        }
        Ok(())
    }
}

/// A form in its normal form, if it is a goal.
fn form(text: &str) -> Result<String, String> {
    let mut terms = Terms::new();
    let term = read(&mut terms, text).map_err(|e| e.to_string())?;
    check(&terms, term).map_err(|e| e.to_string())?;
    Ok(print(&terms, term))
}

fn colors(text: &str) -> Result<Vec<Color>, String> {
    let colors: Vec<Color> = text.split_whitespace().map(word).collect::<Result<_, _>>()?;
    let distinct = (1..colors.len()).all(|i| !colors[..i].contains(&colors[i]));
    if colors.len() != N_ROOMS || !distinct {
        return Err(format!("`rooms` needs {N_ROOMS} different colours"));
    }
    Ok(colors)
}

fn look(text: &str) -> Result<Look, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let &[paint, shape] = &words[..] else {
        return Err("`thing` needs a colour and a shape, like `thing red chair`".into());
    };
    let paint = match paint {
        "any" => Paint::Any,
        "other" => Paint::Other,
        color => Paint::Is(word(color).map_err(|e| format!("{e}, any, other"))?),
    };
    Ok(Look { paint, shape: word(shape)? })
}

fn word<T: FromStr>(text: &str) -> Result<T, String>
where
    T::Err: std::fmt::Display,
{
    text.parse().map_err(|e: T::Err| e.to_string())
}
