//! A state as a person draws it: a map, an empty line, and a legend with a line for every mark.
//!
//! ```text
//! #########        # wall, also blank       . floor of a room whose line has its bounds
//! #rrr+bCb#        ^ v < > the robot
//! #r>r#bbb#
//! #########        Legend lines:
//!                    MARK room COLOUR [at LEFT BOTTOM RIGHT TOP] [as NAME]
//! r room red         MARK door LOCK [at LEFT BOTTOM RIGHT TOP] [as NAME]
//! b room blue        MARK SHAPE COLOUR [SIZE] [at X Y] [as NAME]
//! + door unlocked    origin X Y   (the cell of the map's lower left corner)
//! C chair green
//! ```
//! A room is the rectangle around its marks, one cell wider on every side; a door is the rectangle of its
//! marks; with `at` the marks are for the eye only, and `-` marks what is not drawn. Invariant: a state
//! that is printed reads back the same.

use super::object::{Agent, Bounds, Direction, Door, Object, Room, Size};
use super::quote::{quoted, unquoted};
use super::state::{MAX_SIDE, State, StateError};
use std::str::FromStr;

/// What is wrong with a drawing, and where: line and column from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}: {message}")]
pub struct TextError {
    /// Line of the text.
    pub line: usize,
    /// Column, in characters.
    pub column: usize,
    /// What is wrong and what to do.
    pub message: String,
}

/// Marks that mean something without a legend.
const RESERVED: &str = "#.-^v<> ";

/// The cells of the map with their marks, row by row from the south. There are few: a list does.
type Marks = Vec<(char, Cell)>;

#[derive(Clone, Copy)]
struct Cell {
    x: i32,
    y: i32,
    line: usize,
    column: usize,
}

/// The words of one legend line, taken from the left.
struct Words<'a> {
    rest: &'a str,
    line: usize,
    column: usize,
}

impl<'a> Words<'a> {
    fn new(text: &'a str, line: usize) -> Self {
        Self { rest: text, line, column: 1 }
    }

    /// The next word; `wanted` says what should stand there.
    fn next(&mut self, wanted: &str) -> Result<&'a str, TextError> {
        let trimmed = self.rest.trim_start();
        self.column += self.rest.chars().count() - trimmed.chars().count();
        let end = trimmed.find(char::is_whitespace).unwrap_or(trimmed.len());
        let (word, rest) = trimmed.split_at(end);
        if word.is_empty() {
            return Err(self.error(format!("{wanted} is missing here")));
        }
        self.rest = rest;
        self.column += word.chars().count();
        Ok(word)
    }

    /// The next word read as a `T`, whose error says what is allowed.
    fn read<T: FromStr>(&mut self, wanted: &str) -> Result<T, TextError>
    where
        T::Err: std::fmt::Display,
    {
        let word = self.next(wanted)?;
        word.parse().map_err(|e| {
            let column = self.column - word.chars().count();
            let (line, message) =
                (self.line, format!("{wanted} is wanted here, not `{word}` ({e})"));
            TextError { line, column, message }
        })
    }

    fn numbers<const N: usize>(&mut self) -> Result<[i32; N], TextError> {
        let mut all = [0; N];
        for number in &mut all {
            *number = self.read("a whole number")?;
        }
        Ok(all)
    }

    /// Takes `word` if it comes next.
    fn take(&mut self, word: &str) -> bool {
        let mut ahead = Words { ..*self };
        let found = ahead.next("").is_ok_and(|w| w == word);
        if found {
            *self = ahead;
        }
        found
    }

    /// `as NAME` up to the end of the line, or the name given.
    fn name(&mut self, otherwise: String) -> Result<String, TextError> {
        if !self.take("as") {
            return self.end().map(|()| otherwise);
        }
        let name = std::mem::take(&mut self.rest).trim();
        if name.starts_with('"') {
            return unquoted(name).map_err(|wrong| self.error(format!("a name: {wrong}")));
        }
        if name.is_empty() {
            Err(self.error("a name is missing here".into()))
        } else {
            Ok(name.to_owned())
        }
    }

    fn end(&mut self) -> Result<(), TextError> {
        match self.next("") {
            Err(_) => Ok(()),
            Ok(word) => {
                self.column -= word.chars().count();
                Err(self.error(format!("`{word}` is too much here")))
            }
        }
    }

    fn error(&self, message: String) -> TextError {
        TextError { line: self.line, column: self.column, message }
    }
}

/// Reads a drawing. What it draws may still be illegal: see [`State::check`].
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn read(text: &str) -> Result<State, TextError> {
    let lines: Vec<(usize, &str)> = (1..).zip(text.lines().map(str::trim_end)).collect();
    let start = lines.iter().position(|l| !l.1.is_empty()).unwrap_or(lines.len());
    let drawn = &lines[start..];
    let (map, legend) =
        drawn.split_at(drawn.iter().position(|l| l.1.is_empty()).unwrap_or(drawn.len()));
    let legend: Vec<(usize, &str)> = legend.iter().copied().filter(|l| !l.1.is_empty()).collect();
    let mut marks = read_map(map, read_origin(&legend)?)?;
    let agent = read_agent(&marks, map.first().map_or(1, |l| l.0))?;
    let mut state = State { agent, rooms: Vec::new(), doors: Vec::new(), objects: Vec::new() };
    let mut explained = RESERVED.to_owned();
    let mut drawn_rooms = Vec::new();
    for &(line, content) in legend.iter().filter(|l| !l.1.starts_with("origin ")) {
        let mut words = Words::new(content, line);
        let mark: char = words.read("a mark of one character")?;
        if mark != '-' && explained.contains(mark) {
            return Err(TextError {
                line,
                column: 1,
                message: format!("`{mark}` has its meaning already"),
            });
        }
        explained.push(mark);
        let cells = cells(&marks, mark);
        marks.retain(|(other, _)| *other != mark);
        let drawn = (mark != '-').then_some(mark);
        if words.take("room") {
            let color = words.read("a colour")?;
            let at = region(&mut words, &cells)?;
            let mut bounds = at.bounds;
            if at.is_drawn {
                bounds = wider(bounds);
                drawn_rooms.push((mark, at.bounds));
            }
            let name = words.name(format!("room{}", state.rooms.len()))?;
            state.rooms.push(Room { name, color, bounds });
        } else if words.take("door") {
            let lock = words.read("unlocked, locked or unknown")?;
            let bounds = region(&mut words, &cells)?.bounds;
            let name = words.name(format!("door{}", state.doors.len()))?;
            state.doors.push(Door { name, bounds, lock });
        } else {
            state.objects.push(read_object(&mut words, drawn, &cells, state.objects.len())?);
        }
    }
    if let Some((mark, cell)) =
        marks.iter().filter(|(mark, _)| !RESERVED.contains(*mark)).min_by_key(|(mark, _)| *mark)
    {
        let message = format!("`{mark}` stands in no line of the legend");
        return Err(TextError { line: cell.line, column: cell.column, message });
    }
    check_floors(map, &read_origin(&legend)?, &drawn_rooms)?;
    Ok(state)
}

/// Reads a drawing and checks that it is legal.
///
/// # Errors
/// As [`read`], or what makes the state illegal, as an error of the whole text.
pub fn read_legal(text: &str) -> Result<State, TextError> {
    let state = read(text)?;
    state.check().map_err(|e: StateError| TextError {
        line: 1,
        column: 1,
        message: e.to_string(),
    })?;
    Ok(state)
}

fn read_origin(legend: &[(usize, &str)]) -> Result<[i32; 2], TextError> {
    let Some(&(line, text)) = legend.iter().find(|l| l.1.starts_with("origin ")) else {
        return Ok([0, 0]);
    };
    let mut words = Words::new(text, line);
    words.take("origin");
    let origin = words.numbers()?;
    words.end()?;
    if origin.iter().any(|v: &i32| v.abs() > super::state::MAX_COORDINATE) {
        return Err(words.error("the origin is too far away".into()));
    }
    Ok(origin)
}

fn read_map(map: &[(usize, &str)], [left, bottom]: [i32; 2]) -> Result<Marks, TextError> {
    let most = usize::try_from(MAX_SIDE).unwrap_or(usize::MAX);
    let too_large = |line, column| TextError {
        line,
        column,
        message: format!("the map is larger than {MAX_SIDE} cells a side"),
    };
    if let Some(&(line, _)) = map.get(most) {
        return Err(too_large(line, 1));
    }
    let mut marks = Marks::new();
    for (y, &(line, text)) in (bottom..).zip(map.iter().rev()) {
        for ((x, column), mark) in (left..).zip(1..).zip(text.chars()) {
            if column > most {
                return Err(too_large(line, column));
            }
            marks.push((mark, Cell { x, y, line, column }));
        }
    }
    Ok(marks)
}

/// A mark's cells.
fn cells(marks: &Marks, mark: char) -> Vec<Cell> {
    marks.iter().filter(|(other, _)| *other == mark).map(|(_, cell)| *cell).collect()
}

fn read_agent(marks: &Marks, line: usize) -> Result<Agent, TextError> {
    let all: Vec<(Cell, Direction)> = Direction::ALL
        .iter()
        .flat_map(|d| cells(marks, d.letter()).into_iter().map(|c| (c, *d)))
        .collect();
    match all.iter().max_by_key(|(c, _)| (c.line, c.column)) {
        Some(&(Cell { x, y, .. }, direction)) if all.len() == 1 => Ok(Agent { x, y, direction }),
        None => {
            let message = "the map has no robot: put one of ^ v < > somewhere".into();
            Err(TextError { line, column: 1, message })
        }
        Some(&(Cell { line, column, .. }, _)) => {
            let message = "the map has a second robot: there is only one".into();
            Err(TextError { line, column, message })
        }
    }
}

struct Region {
    bounds: Bounds,
    /// Whether the bounds are those of the marks.
    is_drawn: bool,
}

/// `at` and four numbers, or the rectangle around the marks.
fn region(words: &mut Words<'_>, cells: &[Cell]) -> Result<Region, TextError> {
    if words.take("at") {
        let [left, bottom, right, top] = words.numbers()?;
        return Ok(Region { bounds: Bounds { left, bottom, right, top }, is_drawn: false });
    }
    let one = |c: &Cell| Bounds { left: c.x, bottom: c.y, right: c.x, top: c.y };
    match cells.iter().map(one).reduce(Bounds::hull) {
        Some(bounds) => Ok(Region { bounds, is_drawn: true }),
        None => Err(words.error("its mark is not in the map: draw it, or say `at`".into())),
    }
}

fn read_object(
    words: &mut Words<'_>,
    mark: Option<char>,
    cells: &[Cell],
    number: usize,
) -> Result<Object, TextError> {
    let shape = words.read("room, door or a shape")?;
    let color = words.read("a colour")?;
    let size = Size::ALL.iter().copied().find(|s| words.take(s.name()));
    let at = if words.take("at") { Some(words.numbers::<2>()?) } else { None };
    let [x, y] = match (at, cells) {
        (Some(at), _) => at,
        (None, [cell]) => [cell.x, cell.y],
        (None, [_, second, ..]) => {
            let (Cell { line, column, .. }, mark) = (*second, mark.unwrap_or('-'));
            let message = format!("`{mark}` is one object, but stands here a second time");
            return Err(TextError { line, column, message });
        }
        (None, []) => {
            return Err(words.error("its mark is not in the map: draw it, or say `at`".into()));
        }
    };
    let name = words.name(format!("object{number}"))?;
    Ok(Object { name, shape, color, size, x, y })
}

/// Every cell inside a drawn room must look like floor of that room or like something that stands on it.
fn check_floors(
    map: &[(usize, &str)],
    [left, bottom]: &[i32; 2],
    rooms: &[(char, Bounds)],
) -> Result<(), TextError> {
    for (y, &(line, text)) in (*bottom..).zip(map.iter().rev()) {
        for ((x, column), found) in (*left..).zip(1..).zip(text.chars()) {
            for &(mark, _) in rooms.iter().filter(|r| r.1.contains(x, y)) {
                if "# ".contains(found) || rooms.iter().any(|r| r.0 == found && r.0 != mark) {
                    let message =
                        format!("room `{mark}` is no rectangle: it should cover this cell");
                    return Err(TextError { line, column, message });
                }
            }
        }
    }
    Ok(())
}

/// Draws a state. Reads back the same if the state is legal, or would be but for things sharing a cell.
#[must_use]
pub fn print(state: &State) -> String {
    let agent = Bounds {
        left: state.agent.x,
        bottom: state.agent.y,
        right: state.agent.x,
        top: state.agent.y,
    };
    let extent = state.extent().map_or(agent, |e| e.hull(agent));
    let mut drawing = Drawing::new(extent);
    let mut used = RESERVED.to_owned();
    let rooms: Vec<char> =
        state.rooms.iter().map(|r| choose(r.color.letter(), &mut used)).collect();
    let doors: Vec<char> = state.doors.iter().map(|d| choose(d.lock.letter(), &mut used)).collect();
    let mut objects: Vec<char> =
        state.objects.iter().map(|o| choose(o.shape.letter(), &mut used)).collect();
    for (room, &mark) in state.rooms.iter().zip(&rooms) {
        for (x, y) in room.bounds.cells().filter(|&(x, y)| room.bounds.strictly_inside(x, y)) {
            drawing.put(x, y, if mark == '-' { '.' } else { mark });
        }
    }
    for (door, &mark) in state.doors.iter().zip(&doors) {
        door.bounds
            .cells()
            .for_each(|(x, y)| drawing.put(x, y, if mark == '-' { '.' } else { mark }));
    }
    for (object, &mark) in state.objects.iter().zip(&objects) {
        if mark != '-' {
            drawing.put(object.x, object.y, mark);
        }
    }
    drawing.put(state.agent.x, state.agent.y, state.agent.direction.letter());
    for mark in objects.iter_mut().filter(|m| drawing.hull(**m).is_none()) {
        *mark = '-';
    }
    drawing.text(state, &rooms, &doors, &objects)
}

/// `wish` if it is free, else the first free mark, else `-`.
fn choose(wish: char, used: &mut String) -> char {
    let all =
        std::iter::once(wish).chain('a'..='z').chain('A'..='Z').chain('0'..='9').chain('!'..='~');
    let free = all.into_iter().find(|&c| !used.contains(c)).unwrap_or('-');
    used.push(free);
    free
}

/// A map being drawn, row by row from the south.
struct Drawing {
    extent: Bounds,
    rows: Vec<Vec<char>>,
}

impl Drawing {
    fn new(extent: Bounds) -> Self {
        let length = |from: i32, to: i32| usize::try_from(to - from + 1).unwrap_or(0);
        let row = vec!['#'; length(extent.left, extent.right)];
        Self { extent, rows: vec![row; length(extent.bottom, extent.top)] }
    }

    fn put(&mut self, x: i32, y: i32, mark: char) {
        let row = usize::try_from(y - self.extent.bottom).ok().and_then(|y| self.rows.get_mut(y));
        let column = usize::try_from(x - self.extent.left).ok();
        if let Some(cell) = row.zip(column).and_then(|(row, x)| row.get_mut(x)) {
            *cell = mark;
        }
    }

    /// The rectangle around all cells with this mark.
    fn hull(&self, mark: char) -> Option<Bounds> {
        let rows = (self.extent.bottom..).zip(&self.rows);
        rows.flat_map(|(y, row)| (self.extent.left..).zip(row).map(move |(x, m)| (x, y, *m)))
            .filter(|c| c.2 == mark)
            .map(|(x, y, _)| Bounds { left: x, bottom: y, right: x, top: y })
            .reduce(Bounds::hull)
    }

    fn text(&self, state: &State, rooms: &[char], doors: &[char], objects: &[char]) -> String {
        let mut text = String::new();
        for row in self.rows.iter().rev() {
            text.extend(row);
            text.push('\n');
        }
        text.push('\n');
        if (self.extent.left, self.extent.bottom) != (0, 0) {
            text.push_str(&format!("origin {} {}\n", self.extent.left, self.extent.bottom));
        }
        for (i, (room, &mark)) in state.rooms.iter().zip(rooms).enumerate() {
            let inside = |r: &Room| narrower(r.bounds);
            let is_crossed =
                state.rooms.iter().any(|r| r != room && inside(r).overlaps(&inside(room)));
            let drawn = self.hull(mark).filter(|_| !is_crossed).map(wider);
            let at = at_unless(drawn, mark, room.bounds);
            let called = called(&room.name, &format!("room{i}"));
            text.push_str(&format!("{mark} room {}{at}{called}\n", room.color));
        }
        for (i, (door, &mark)) in state.doors.iter().zip(doors).enumerate() {
            let at = at_unless(self.hull(mark), mark, door.bounds);
            let called = called(&door.name, &format!("door{i}"));
            text.push_str(&format!("{mark} door {}{at}{called}\n", door.lock));
        }
        for (i, (object, &mark)) in state.objects.iter().zip(objects).enumerate() {
            let size = object.size.map_or(String::new(), |s| format!(" {s}"));
            let at =
                if mark == '-' { format!(" at {} {}", object.x, object.y) } else { String::new() };
            let called = called(&object.name, &format!("object{i}"));
            text.push_str(&format!("{mark} {} {}{size}{at}{called}\n", object.shape, object.color));
        }
        text
    }
}

fn wider(b: Bounds) -> Bounds {
    Bounds { left: b.left - 1, bottom: b.bottom - 1, right: b.right + 1, top: b.top + 1 }
}

fn narrower(b: Bounds) -> Bounds {
    Bounds { left: b.left + 1, bottom: b.bottom + 1, right: b.right - 1, top: b.top - 1 }
}

/// Nothing when the marks say it all, else the bounds in words.
fn at_unless(drawn: Option<Bounds>, mark: char, b: Bounds) -> String {
    if mark != '-' && drawn == Some(b) {
        return String::new();
    }
    format!(" at {} {} {} {}", b.left, b.bottom, b.right, b.top)
}

/// Nothing for the name that the place in the legend gives, else the name, quoted where it must be.
fn called(name: &str, otherwise: &str) -> String {
    let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "_-. ".contains(c))
        && name.trim() == name
        && !name.is_empty();
    match (name == otherwise, is_plain) {
        (true, _) => String::new(),
        (false, true) => format!(" as {name}"),
        (false, false) => format!(" as {}", quoted(name)),
    }
}
