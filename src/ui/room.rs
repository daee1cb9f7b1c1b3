//! What a person does in the room: point, drag, paint, drive, with a pointer or with keys; and other worlds.

use super::action::{Action, Effect, Key};
use super::document::Draft;
use super::edit::{self, Look, Obstacle, Place};
use super::point::{Point, PointKind};
use super::state::State;
use super::world::WORLDS;
use super::{link, talk};
use crate::domain::{Blueprint, Color, Shape, State as World};
use crate::render::Thing;
use crate::worker::protocol::Request;

/// What the room is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Watching.
    #[default]
    Watch,
    /// Changing the world.
    Edit,
    /// Showing what a command means.
    Teach,
}

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 3] = [Mode::Watch, Mode::Edit, Mode::Teach];
}

/// What a pointer or Enter does in the room while it is changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Takes the robot and objects elsewhere.
    #[default]
    Move,
    /// Puts a new object.
    Object,
    /// Paints rooms.
    Room,
    /// Makes and changes doors.
    Door,
    /// Takes away.
    Erase,
}

impl Tool {
    /// All of them.
    pub const ALL: [Tool; 5] = [Tool::Move, Tool::Object, Tool::Room, Tool::Door, Tool::Erase];
}

/// What is held in the room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Held {
    /// An item on its way, where it is in cells.
    Item(Thing, [f32; 2]),
    /// A corner of a room that is painted.
    Corner(Place),
}

/// The room's side of the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// What it is for.
    pub mode: Mode,
    /// The tool, while it is changed.
    pub tool: Tool,
    /// How new objects look.
    pub look: Look,
    /// The colour of new rooms.
    pub paint: Color,
    /// Where the keyboard is.
    pub cursor: Option<Place>,
    /// The cell that the pointer is on.
    pub hover: Option<Place>,
    /// What is held.
    pub held: Option<Held>,
    /// Why the last change could not be made.
    pub obstacle: Option<Obstacle>,
    /// What random worlds are like.
    pub blueprint: Blueprint,
    /// The seed of the next one.
    pub seed: u32,
    /// The world as text, while it is shown.
    pub text: Option<String>,
    /// What is wrong with a world that was asked for.
    pub notice: Option<String>,
}

impl Room {
    /// A room that is watched.
    pub fn new() -> Room {
        Room {
            mode: Mode::default(),
            tool: Tool::default(),
            look: Look { shape: Shape::Block, color: Color::Yellow, size: None },
            paint: Color::Yellow,
            cursor: None,
            hover: None,
            held: None,
            obstacle: None,
            blueprint: Blueprint { objects: 3, ..Blueprint::default() },
            seed: 1,
            text: None,
            notice: None,
        }
    }
}

impl Default for Room {
    fn default() -> Room {
        Room::new()
    }
}

/// What happens in the room.
pub(super) fn act(state: &mut State, action: Action, effects: &mut Vec<Effect>) {
    match action {
        Action::SetMode(mode) => set_mode(state, mode, effects),
        Action::Take(tool) => {
            state.room.tool = tool;
            (state.room.held, state.room.obstacle) = (None, None);
        }
        Action::SetLook(look) => state.room.look = look,
        Action::SetPaint(color) => state.room.paint = color,
        Action::Point(pointer) => point(state, pointer, effects),
        Action::Press(key) => press(state, key, effects),
        Action::PickWorld(choice) => {
            if let Some(world) = WORLDS.get(choice).and_then(super::world::Choice::open) {
                open(state, world, Some(choice), effects);
            }
        }
        Action::ResetWorld => {
            let origin = (*state.document.origin).clone();
            state.settle();
            if origin != state.document.world {
                state.record();
                state.document.change(origin);
                state.document.draft = None;
                reread(state, effects);
                let words =
                    format!("{} {}", state.text().as_it_began, state.text().robot(state.shown()));
                state.say(words);
            }
        }
        Action::SetBlueprint(blueprint) => state.room.blueprint = blueprint,
        Action::SetSeed(seed) => state.room.seed = seed,
        Action::DrawWorld => {
            let Room { blueprint, seed, .. } = state.room;
            state.talker.send(Request::Draw { blueprint, seed }, true, effects);
        }
        Action::ToggleText => match state.room.text.take() {
            Some(_) => state.room.notice = None,
            None => {
                let request = Request::WriteWorld { state: state.shown().clone() };
                state.talker.send(request, true, effects);
            }
        },
        Action::TypedText(text) => state.room.text = Some(text),
        Action::ApplyText => {
            if let Some(text) = state.room.text.clone() {
                state.talker.send(Request::ReadWorld { text }, true, effects);
            }
        }
        _ => {}
    }
}

/// Opens another world.
pub(super) fn open(
    state: &mut State,
    world: World,
    preset: Option<usize>,
    effects: &mut Vec<Effect>,
) {
    state.settle();
    state.record();
    state.document.open(world, preset);
    (state.room.cursor, state.room.held, state.room.obstacle) = (None, None, None);
    state.room.notice = None;
    state.watch.forget();
    let words = state.text().world(&state.document.world);
    state.say(words);
    reread(state, effects);
}

fn set_mode(state: &mut State, mode: Mode, effects: &mut Vec<Effect>) {
    if state.room.mode == mode {
        return;
    }
    if mode != Mode::Watch {
        state.settle();
        state.watch.forget();
    }
    state.room.mode = mode;
    (state.room.held, state.room.obstacle, state.room.hover) = (None, None, None);
    if mode == Mode::Teach {
        super::teach::begin(state, effects);
    }
    let words = state.text().mode_help(mode);
    state.say(words);
}

fn point(state: &mut State, point: Point, effects: &mut Vec<Effect>) {
    let Point { kind, x, y, cell } = point;
    state.room.hover = (kind != PointKind::Leave).then_some(cell);
    match kind {
        PointKind::Move => match &mut state.room.held {
            Some(Held::Item(_, at)) => *at = [x, y],
            Some(Held::Corner(_)) => {}
            None if state.room.mode == Mode::Watch => hover(state),
            None => {}
        },
        PointKind::Down => {
            state.room.cursor = None;
            state.room.held = grasp(state, cell);
        }
        PointKind::Up => {
            let held = state.room.held.take();
            release(state, held, cell, effects);
        }
        PointKind::Leave => {
            state.room.held = None;
            if state.room.mode == Mode::Watch {
                state.talk.link = None;
            }
        }
    }
}

/// Points at the words that stand for what the pointer is on.
fn hover(state: &mut State) {
    let cell = state.room.hover;
    let link =
        state.heard_reading().zip(cell).and_then(|(reading, cell)| link::at_cell(reading, cell));
    state.talk.link = link;
}

/// What a hand takes hold of on a cell.
fn grasp(state: &State, cell: Place) -> Option<Held> {
    let (mode, tool) = (state.room.mode, state.room.tool);
    match (mode, tool) {
        (Mode::Watch, _) => None,
        (Mode::Teach, _) | (_, Tool::Move) => {
            let item = edit::item_at(state.shown(), cell)?;
            Some(Held::Item(item, centre(cell)))
        }
        (_, Tool::Room) => Some(Held::Corner(cell)),
        _ => None,
    }
}

fn centre((x, y): Place) -> [f32; 2] {
    [x as f32, y as f32]
}

/// Puts down what is held, or uses the tool.
fn release(state: &mut State, held: Option<Held>, cell: Place, effects: &mut Vec<Effect>) {
    let shown = state.shown();
    let changed = match (held, state.room.mode, state.room.tool) {
        (Some(Held::Item(item, _)), ..) => {
            if edit::item_at(shown, cell) == Some(item) {
                // Taken up and put down where it was: the robot turns.
                if item == Thing::Robot { Ok(edit::turn(shown)) } else { return }
            } else {
                edit::put(shown, item, cell)
            }
        }
        (Some(Held::Corner(corner)), ..) => edit::paint(shown, state.room.paint, corner, cell),
        (None, Mode::Edit, Tool::Object) => edit::add(shown, state.room.look, cell),
        (None, Mode::Edit, Tool::Door) => edit::door(shown, cell),
        (None, Mode::Edit, Tool::Erase) => edit::erase(shown, cell),
        (None, ..) => return,
    };
    changed_to(state, changed, effects);
}

/// Takes a change over, or says why it could not be made.
pub(super) fn changed_to(
    state: &mut State,
    changed: Result<World, Obstacle>,
    effects: &mut Vec<Effect>,
) {
    match changed {
        Ok(world) => {
            state.room.obstacle = None;
            let words = state.text().change(state.shown(), &world);
            state.record();
            if state.room.mode == Mode::Teach {
                let before = state.document.world.clone();
                state.document.draft.get_or_insert_with(|| Draft::new(before)).after = world;
            } else {
                state.document.preset = None;
                state.document.change(world);
                state.watch.forget();
                reread(state, effects);
            }
            state.say(words);
        }
        Err(obstacle) => {
            state.room.obstacle = Some(obstacle);
            let words = state.text().obstacle(obstacle).to_owned();
            state.say(words);
        }
    }
}

/// The command in the box is read again, since the world is another.
fn reread(state: &mut State, effects: &mut Vec<Effect>) {
    talk::read(state, effects);
}

fn press(state: &mut State, key: Key, effects: &mut Vec<Effect>) {
    match key {
        Key::Arrow(direction, false)
            if state.room.mode == Mode::Teach && state.room.held.is_none() =>
        {
            let driven = edit::drive(state.shown(), direction);
            changed_to(state, driven, effects);
        }
        Key::Arrow(direction, _) => {
            let agent = &state.shown().agent;
            let (x, y) = state.room.cursor.unwrap_or((agent.x, agent.y));
            let (dx, dy) = direction.step();
            let cell = state.inside((x + dx, y + dy));
            state.room.cursor = Some(cell);
            state.room.hover = Some(cell);
            if let Some(Held::Item(_, at)) = &mut state.room.held {
                *at = centre(cell);
            }
            if state.room.mode == Mode::Watch {
                hover(state);
            }
            let words = state.text().cell(state.shown(), cell);
            state.say(words);
        }
        Key::Act => {
            let Some(cell) = state.room.cursor else { return };
            match state.room.held.take() {
                Some(held) => release(state, Some(held), cell, effects),
                None => match grasp(state, cell) {
                    Some(held) => {
                        state.room.held = Some(held);
                        let words = state.text().holding(state.shown(), held);
                        state.say(words);
                    }
                    None => release(state, None, cell, effects),
                },
            }
        }
        Key::Cancel => {
            (state.room.held, state.room.cursor, state.talk.link) = (None, None, None);
        }
        Key::Turn if state.room.mode != Mode::Watch => {
            let turned = Ok(edit::turn(state.shown()));
            changed_to(state, turned, effects);
        }
        Key::Turn => {}
    }
}
