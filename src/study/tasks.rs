//! The tasks of a study as a text that a person can read and change; its own head says what each line means.
//! Invariant: the goal of a task that was read is a goal of Cleanup World or a task over
//! time, and so is what it is unlike; every other form of it is a goal.

use crate::domain::{Color, Shape, Size};
use crate::ground::Outline;
use crate::ground::goal::check;
use crate::logic::ty::RUN;
use crate::logic::{Terms, print, read};
use std::str::FromStr;

/// The 23 tasks of the corpus.
pub const TASKS: &str = include_str!("../../assets/corpus/tasks.txt");

/// A task: a goal, and the worlds it is shown in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyTask {
    /// Its label, unique in its file.
    pub name: String,
    /// Ways to say it, at least one: a single one that nobody said, or those of voices.
    pub says: Vec<Saying>,
    /// The form that holds after and not before.
    pub goal: String,
    /// What the state before fulfils besides, and the one after.
    pub before: Vec<String>,
    /// What the state after fulfils besides.
    pub after: Vec<String>,
    /// The colours of the rooms, three to six.
    pub rooms: Vec<Paint>,
    /// The objects that are there.
    pub things: Vec<Look>,
    /// Whether the largest and the smallest room are told from the others at a glance.
    pub apart: bool,
    /// Whether the robot may begin in a doorway.
    pub doorway: bool,
    /// Forms that some pair has to disprove.
    pub unlike: Vec<String>,
    /// Words of which a command must have one of each list, where the task is there to see whether somebody looks.
    pub must: Vec<Vec<String>>,
}

/// A command for a task.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saying {
    /// Whose it is; `None` until people have said theirs.
    pub voice: Option<String>,
    /// The command.
    pub words: String,
}

/// What an object looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Look {
    pub paint: Paint,
    pub shape: Shape,
    pub size: Option<Size>,
}

/// The colour of an object or a room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// This one.
    Is(Color),
    /// Whichever.
    Any,
    /// None that the task names for the shape, or for a room.
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

/// The rooms of a world.
const N_ROOMS: std::ops::RangeInclusive<usize> = 3..=6;
/// Most objects of a task.
const MAX_THINGS: usize = 8;

/// Reads a file of tasks.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn read_tasks(text: &str) -> Result<Vec<StudyTask>, TaskFileError> {
    let mut rooms: Vec<Paint> = [Color::Red, Color::Green, Color::Blue].map(Paint::Is).into();
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
                says: Vec::new(),
                goal: String::new(),
                before: Vec::new(),
                after: Vec::new(),
                rooms: rooms.clone(),
                things: Vec::new(),
                apart: false,
                doorway: false,
                unlike: Vec::new(),
                must: Vec::new(),
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
    /// A task for a form alone: in four rooms, or as many as it takes for the colours that it names, with a thing of
    /// each shape that it names, or one to be in the way.
    ///
    /// # Errors
    /// Why the form is no goal.
    pub fn of(text: &str) -> Result<StudyTask, String> {
        let goal = task(text)?;
        let mut terms = Terms::new();
        let term = read(&mut terms, &goal).map_err(|e| e.to_string())?;
        let constants = terms.constants(term);
        let says = |name: &str| constants.iter().any(|&constant| terms.name(constant) == name);
        let usual = [Color::Red, Color::Green, Color::Blue, Color::Yellow];
        let named = Color::ALL.iter().copied().filter(|color| says(color.name()));
        let mut colors: Vec<Color> = named.collect();
        let more: Vec<Color> = usual.into_iter().filter(|c| !colors.contains(c)).collect();
        colors.extend(more.into_iter().take(usual.len().saturating_sub(colors.len())));
        colors.truncate(*N_ROOMS.end());
        let shapes = Shape::ALL.iter().copied().filter(|shape| says(shape.name()));
        let look = |shape| Look { paint: Paint::Any, shape, size: None };
        let mut things: Vec<Look> = shapes.map(look).take(MAX_THINGS).collect();
        if things.is_empty() {
            things.push(look(Shape::Block));
        }
        let saying = Saying { voice: None, words: goal.clone() };
        Ok(StudyTask {
            name: "goal".to_owned(),
            says: vec![saying],
            goal,
            before: Vec::new(),
            after: Vec::new(),
            rooms: colors.into_iter().map(Paint::Is).collect(),
            things,
            apart: says("size"),
            doorway: false,
            unlike: Vec::new(),
            must: Vec::new(),
        })
    }

    /// Takes a line of the task.
    fn line(&mut self, word: &str, rest: &str) -> Result<(), String> {
        match word {
            "says" => self.says(saying(rest)?)?,
            "goal" if self.goal.is_empty() => self.goal = task(rest)?,
            "goal" => return Err("a second `goal`: leave one out".into()),
            "before" => self.before.push(form(rest)?),
            "after" => self.after.push(form(rest)?),
            "unlike" => self.unlike.push(task(rest)?),
            "must" => self.must = must(rest)?,
            "rooms" => self.rooms = colors(rest)?,
            "apart" if rest.is_empty() => self.apart = true,
            "doorway" if rest.is_empty() => self.doorway = true,
            "thing" if self.things.len() == MAX_THINGS => {
                return Err(format!("more than {MAX_THINGS} things: leave some out"));
            }
            "thing" => self.things.push(look(rest)?),
            _ => {
                return Err(format!(
                    "`{word}` is unknown here: use task, says, goal, before, after, rooms, thing, apart, doorway, \
                     unlike or must"
                ));
            }
        }
        Ok(())
    }

    /// Takes a command: any number that voices said, or one that nobody did.
    fn says(&mut self, saying: Saying) -> Result<(), String> {
        if !self.says.is_empty() && (saying.voice.is_none() || self.says[0].voice.is_none()) {
            return Err(
                "a second `says`: leave one out, or say whose each is, like `says VOICE: WORDS`"
                    .into(),
            );
        }
        if self.says.iter().any(|s| s.words == saying.words) {
            return Err("the same words stand there already: leave one out".into());
        }
        self.says.push(saying);
        Ok(())
    }
}

/// `VOICE: WORDS`, or words alone.
fn saying(text: &str) -> Result<Saying, String> {
    let (voice, words) = match text.split_once(": ") {
        Some((voice, words)) if !voice.contains(char::is_whitespace) => (Some(voice), words.trim()),
        _ => (None, text),
    };
    if words.is_empty() {
        return Err("`says` needs words".into());
    }
    Ok(Saying { voice: voice.map(str::to_owned), words: words.to_owned() })
}

/// A form in its normal form, if it is a goal or a task over time.
fn task(text: &str) -> Result<String, String> {
    let mut terms = Terms::new();
    let term = read(&mut terms, text).map_err(|e| e.to_string())?;
    if terms.ty(term) != RUN {
        return form(text);
    }
    let outline = Outline::new(&terms, term).map_err(|e| e.to_string())?;
    outline.guards().iter().try_for_each(|&goal| check(&terms, goal)).map_err(|e| e.to_string())?;
    Ok(print(&terms, term))
}

/// A form in its normal form, if it is a goal.
fn form(text: &str) -> Result<String, String> {
    let mut terms = Terms::new();
    let term = read(&mut terms, text).map_err(|e| e.to_string())?;
    check(&terms, term).map_err(|e| e.to_string())?;
    Ok(print(&terms, term))
}

/// The names of the tasks of a file, whatever else is wrong with it.
pub fn names(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| Some(line.trim().strip_prefix("task ")?.trim()))
}

/// Words that a command must have, of those with a stroke between them one: `red/crimson room`.
///
/// # Errors
/// That there are none.
pub fn must(text: &str) -> Result<Vec<Vec<String>>, String> {
    let any = |words: &str| -> Vec<String> {
        words.split('/').filter(|word| !word.is_empty()).map(str::to_owned).collect()
    };
    let all: Vec<Vec<String>> =
        text.split_whitespace().map(any).filter(|any| !any.is_empty()).collect();
    if all.is_empty() {
        return Err("`must` needs words, like `must red/crimson room`".into());
    }
    Ok(all)
}

fn colors(text: &str) -> Result<Vec<Paint>, String> {
    let colors: Vec<Paint> = text.split_whitespace().map(paint).collect::<Result<_, _>>()?;
    if !N_ROOMS.contains(&colors.len()) {
        return Err(format!("`rooms` needs {} to {} colours", N_ROOMS.start(), N_ROOMS.end()));
    }
    Ok(colors)
}

fn look(text: &str) -> Result<Look, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let (color, shape, size) = match words[..] {
        [color, shape] => (color, shape, None),
        [size, color, shape] => (color, shape, Some(word(size)?)),
        _ => return Err("`thing` needs a colour and a shape, like `thing red chair`".into()),
    };
    Ok(Look { paint: paint(color)?, shape: word(shape)?, size })
}

fn paint(text: &str) -> Result<Paint, String> {
    Ok(match text {
        "any" => Paint::Any,
        "other" => Paint::Other,
        color => Paint::Is(word(color).map_err(|e| format!("{e}, any, other"))?),
    })
}

fn word<T: FromStr>(text: &str) -> Result<T, String>
where
    T::Err: std::fmt::Display,
{
    text.parse().map_err(|e: T::Err| e.to_string())
}
