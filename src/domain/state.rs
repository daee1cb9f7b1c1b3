//! A state of Cleanup World, its JSON form and its legality. A `State` that came through
//! [`State::read`] or [`State::check`] is legal: nothing stands in a wall and no two things share a cell.

use super::cell::{Cell, cell_at};
use super::misread::{in_words, is_broken};
use super::object::{Agent, Bounds, Door, Object, Room};
use serde::{Deserialize, Serialize};

/// Where everything is. JSON form: as in Mechanical Turk's `Input.pre_1` cells.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(expecting = "a state: {agent, rooms, doors, objects}")]
#[expect(missing_docs, reason = "the four kinds of thing")]
pub struct State {
    pub agent: Agent,
    pub rooms: Vec<Room>,
    pub doors: Vec<Door>,
    pub objects: Vec<Object>,
}

/// Most rooms a state may have.
pub const MAX_ROOMS: usize = 32;
/// Most doors a state may have.
pub const MAX_DOORS: usize = 64;
/// Most objects a state may have.
pub const MAX_OBJECTS: usize = 64;
/// Furthest column or row from 0.
pub const MAX_COORDINATE: i32 = 1000;
/// Most columns, and most rows, of the rectangle that holds all rooms and doors.
pub const MAX_SIDE: i32 = 255;

/// What makes a state illegal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[expect(missing_docs, reason = "each message says what its fields are")]
pub enum StateError {
    #[error("there are {count} {kind}, more than {limit}: leave some out")]
    TooMany { kind: &'static str, count: usize, limit: usize },
    #[error("`{thing}` lies beyond {MAX_COORDINATE} cells from the origin: move the world closer")]
    TooFar { thing: String },
    #[error("the world is {columns} × {rows} cells, more than {MAX_SIDE} a side: make it smaller")]
    TooLarge { columns: i32, rows: i32 },
    #[error("`{thing}` has left > right or bottom > top: swap them")]
    BadBounds { thing: String },
    #[error("two {kind} are called `{name}`: rename one")]
    DuplicateName { kind: &'static str, name: String },
    #[error("{kind} number {number} has an empty name: give it one")]
    NoName { kind: &'static str, number: usize },
    #[error("doors `{first}` and `{second}` cover the same cell: move one")]
    DoorsOverlap { first: String, second: String },
    #[error("`{thing}` is outside all rooms, at column {x}, row {y}: move it into a room")]
    Outside { thing: String, x: i32, y: i32 },
    #[error("`{thing}` stands in a wall, at column {x}, row {y}: move it to floor or a door")]
    InWall { thing: String, x: i32, y: i32 },
    #[error("`{first}` and `{second}` share the cell at column {x}, row {y}: move one")]
    Shared { first: String, second: String, x: i32, y: i32 },
}

/// Why a text is no state.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadError {
    /// Not JSON, or not the JSON of a state.
    #[error("{}{message} (line {line}, column {column})", at(path))]
    Json {
        /// The way to the value from the root, like `objects[0].shape`; empty at the root.
        path: String,
        /// What is wrong and what would be right.
        message: String,
        /// Line within the text, from 1.
        line: usize,
        /// Column within the line, from 1.
        column: usize,
    },
    /// A state, but not a legal one.
    #[error(transparent)]
    Illegal(#[from] StateError),
}

fn at(path: &str) -> String {
    if path.is_empty() { String::new() } else { format!("{path}: ") }
}

impl State {
    /// Reads a state from JSON and checks it.
    ///
    /// # Errors
    /// The JSON path, the reason and a remedy; or what makes the state illegal.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        let state = Self::parse(text)?;
        state.check()?;
        Ok(state)
    }

    /// Reads the state after a demonstration: as [`State::read`], but things that share a cell are
    /// returned as warnings, since people's answers hold such states.
    ///
    /// # Errors
    /// As [`State::read`], but for shared cells.
    pub fn read_after(text: &str) -> Result<(Self, Vec<StateError>), ReadError> {
        let state = Self::parse(text)?;
        let warnings = state.check_after()?;
        Ok((state, warnings))
    }

    /// The state as one line of JSON, which [`State::read`] takes back.
    #[must_use]
    pub fn write(&self) -> String {
        #[expect(clippy::expect_used, reason = "strings and numbers only: JSON can hold them all")]
        serde_json::to_string(self).expect("a state has no value that JSON lacks")
    }

    /// Whether this is a legal state.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn check(&self) -> Result<(), StateError> {
        match self.check_after()?.into_iter().next() {
            Some(shared) => Err(shared),
            None => Ok(()),
        }
    }

    /// Whether this is a legal state but for cells that things share; those are returned.
    ///
    /// # Errors
    /// The first other thing that is wrong.
    pub fn check_after(&self) -> Result<Vec<StateError>, StateError> {
        self.check_counts()?;
        self.check_names()?;
        self.check_bounds()?;
        let mut shared = Vec::new();
        let things: Vec<(&str, i32, i32)> = self.things().collect();
        for (i, &(thing, x, y)) in things.iter().enumerate() {
            if cell_at(&self.rooms, &self.doors, x, y) == Cell::Wall {
                let thing = thing.to_owned();
                return Err(if self.rooms.iter().any(|r| r.bounds.contains(x, y)) {
                    StateError::InWall { thing, x, y }
                } else {
                    StateError::Outside { thing, x, y }
                });
            }
            if let Some(&(first, ..)) = things.iter().take(i).find(|t| (t.1, t.2) == (x, y)) {
                let (first, second) = (first.to_owned(), thing.to_owned());
                shared.push(StateError::Shared { first, second, x, y });
            }
        }
        Ok(shared)
    }

    /// The rectangle that holds all rooms and doors; `None` when there are none.
    #[must_use]
    pub fn extent(&self) -> Option<Bounds> {
        let rooms = self.rooms.iter().map(|r| r.bounds);
        rooms.chain(self.doors.iter().map(|d| d.bounds)).reduce(Bounds::hull)
    }

    /// Agent and objects with name and cell, agent first.
    fn things(&self) -> impl Iterator<Item = (&str, i32, i32)> {
        let objects = self.objects.iter().map(|o| (o.name.as_str(), o.x, o.y));
        std::iter::once(("agent", self.agent.x, self.agent.y)).chain(objects)
    }

    fn parse(text: &str) -> Result<Self, ReadError> {
        let mut json = serde_json::Deserializer::from_str(text);
        let state: Self = serde_path_to_error::deserialize(&mut json).map_err(|e| {
            let path = e.path().to_string();
            json_error(text, if path == "." { String::new() } else { path }, e.inner())
        })?;
        json.end().map_err(|e| json_error(text, String::new(), &e))?;
        Ok(state)
    }

    fn check_counts(&self) -> Result<(), StateError> {
        for (kind, count, limit) in [
            ("rooms", self.rooms.len(), MAX_ROOMS),
            ("doors", self.doors.len(), MAX_DOORS),
            ("objects", self.objects.len(), MAX_OBJECTS),
        ] {
            if count > limit {
                return Err(StateError::TooMany { kind, count, limit });
            }
        }
        Ok(())
    }

    fn check_names(&self) -> Result<(), StateError> {
        let rooms = self.rooms.iter().map(|r| r.name.as_str());
        let regions: Vec<&str> = rooms.chain(self.doors.iter().map(|d| d.name.as_str())).collect();
        let objects: Vec<&str> = self.objects.iter().map(|o| o.name.as_str()).collect();
        for (kind, names) in [("rooms or doors", regions), ("objects", objects)] {
            for (i, &name) in names.iter().enumerate() {
                if name.is_empty() {
                    return Err(StateError::NoName { kind, number: i + 1 });
                }
                if names.iter().take(i).any(|&n| n == name) {
                    return Err(StateError::DuplicateName { kind, name: name.to_owned() });
                }
            }
        }
        Ok(())
    }

    fn check_bounds(&self) -> Result<(), StateError> {
        let near = |v: i32| (-MAX_COORDINATE..=MAX_COORDINATE).contains(&v);
        let rooms = self.rooms.iter().map(|r| (&r.name, r.bounds));
        for (name, b) in rooms.chain(self.doors.iter().map(|d| (&d.name, d.bounds))) {
            if !b.is_ordered() {
                return Err(StateError::BadBounds { thing: name.clone() });
            }
            if ![b.left, b.bottom, b.right, b.top].into_iter().all(near) {
                return Err(StateError::TooFar { thing: name.clone() });
            }
        }
        if let Some((name, ..)) = self.things().find(|&(_, x, y)| !near(x) || !near(y)) {
            return Err(StateError::TooFar { thing: name.to_owned() });
        }
        if let Some(b) = self.extent() {
            let (columns, rows) = (b.right - b.left + 1, b.top - b.bottom + 1);
            if columns > MAX_SIDE || rows > MAX_SIDE {
                return Err(StateError::TooLarge { columns, rows });
            }
        }
        for (i, door) in self.doors.iter().enumerate() {
            if let Some(d) = self.doors.iter().take(i).find(|d| d.bounds.overlaps(&door.bounds)) {
                let (first, second) = (d.name.clone(), door.name.clone());
                return Err(StateError::DoorsOverlap { first, second });
            }
        }
        Ok(())
    }
}

/// The error of `serde_json` in words, with its place taken apart and a remedy for what people meet most.
fn json_error(text: &str, path: String, error: &serde_json::Error) -> ReadError {
    let is_broken = is_broken(text, error);
    let message = in_words(error, is_broken);
    let remedy = if is_broken && error.is_eof() {
        ": the text ends too early, is it whole?"
    } else if is_broken {
        ": this is not JSON, check quotes and commas here"
    } else if message.starts_with("missing field") {
        ": add it"
    } else if message.starts_with("invalid type") {
        ": put the right kind of value here"
    } else {
        ""
    };
    ReadError::Json { path, message: message + remedy, line: error.line(), column: error.column() }
}
