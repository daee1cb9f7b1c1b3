//! What a person does in the room with a pointer or with keys: point, drag, paint, drive.

use super::edit::{self, Obstacle};
use super::point::{Key, Point, PointKind};
use super::state::{Held, Mode, Moved, QUESTION, Tool};
use crate::domain::State as World;
use crate::render::Thing;
use crate::ui::page::effect::Effect;
use crate::ui::page::place::{Place, inside, item_at};
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::{ask, link};
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn::look;
use crate::ui::talk::teach::trail::Trail;
use crate::ui::talk::watch::playback::Playback;
use crate::ui::talk::words::Text;
use crate::worker::protocol::Program;

/// The room is for something else now. For teaching, the engine that learns is made ready meanwhile.
pub(crate) fn set_mode(state: &mut State, shared: &mut Shared, mode: Mode) {
    if state.room.mode == mode {
        return;
    }
    if mode != Mode::Watch {
        state.settle(shared);
        state.watch.forget();
    }
    state.room.mode = mode;
    state.room.let_go();
    state.room.hover = None;
    if mode == Mode::Teach {
        shared.document.draft();
        look(state, shared);
        shared.wake(Program::Learner);
    }
    shared.say(Text::of(shared.language).mode_help(mode));
}

/// Another tool is taken.
pub(crate) fn take(state: &mut State, tool: Tool) {
    state.room.tool = tool;
    state.room.let_go();
}

/// A pointer does something.
pub(crate) fn point(state: &mut State, shared: &mut Shared, point: Point) {
    let Point { kind, x, y, cell } = point;
    state.room.hover = (kind != PointKind::Leave).then_some(cell);
    match kind {
        PointKind::Move => match &mut state.room.held {
            Some(Held::Item(_, at)) => {
                *at = [x, y];
                let trail = state.room.trail.take();
                state.room.trail = trail.and_then(|trail| trail.to(cell));
            }
            Some(Held::Corner(_)) => {}
            None if state.room.mode == Mode::Watch => hover(state, shared),
            None => {}
        },
        PointKind::Down => {
            state.room.cursor = None;
            state.room.held = grasp(state, shared, cell);
            let is_driven = matches!(state.room.held, Some(Held::Item(Thing::Robot, _)));
            let is_driven = is_driven && state.room.mode == Mode::Teach;
            state.room.trail = is_driven.then(|| Trail::new(state.shown(shared)));
        }
        PointKind::Up => {
            let held = state.room.held.take();
            release(state, shared, held, cell);
        }
        PointKind::Leave => {
            state.room.held = None;
            if state.room.mode == Mode::Watch {
                state.command.link = None;
            }
        }
    }
}

/// A key is pressed.
pub(crate) fn press(state: &mut State, shared: &mut Shared, key: Key) {
    match key {
        Key::Arrow(direction, false)
            if state.room.mode == Mode::Teach && state.room.held.is_none() =>
        {
            let driven = edit::drive(state.shown(shared), direction);
            let step = edit::action(direction).letter().to_string();
            change_by(state, shared, driven, Some(&step));
        }
        Key::Arrow(direction, _) => {
            let agent = &state.shown(shared).agent;
            let (x, y) = state.room.cursor.unwrap_or((agent.x, agent.y));
            let (dx, dy) = direction.step();
            let cell = inside(state.shown(shared), (x + dx, y + dy));
            state.room.cursor = Some(cell);
            state.room.hover = Some(cell);
            if let Some(Held::Item(_, at)) = &mut state.room.held {
                *at = centre(cell);
            }
            if state.room.mode == Mode::Watch {
                hover(state, shared);
            }
            let phrases = Text::of(shared.language).phrases;
            shared.say(phrases.cell(state.shown(shared), cell));
        }
        Key::Act => {
            let Some(cell) = state.room.cursor else { return };
            match state.room.held.take() {
                Some(held) => release(state, shared, Some(held), cell),
                None => match grasp(state, shared, cell) {
                    Some(held) => {
                        state.room.held = Some(held);
                        let text = Text::of(shared.language);
                        shared.say(text.holding(state.shown(shared), held));
                    }
                    None => release(state, shared, None, cell),
                },
            }
        }
        Key::Cancel => {
            (state.room.held, state.room.cursor, state.command.link) = (None, None, None);
            state.room.moved = None;
        }
        Key::Turn if state.room.mode != Mode::Watch => {
            let turned = Ok(edit::turn(state.shown(shared)));
            change(state, shared, turned);
        }
        Key::Turn => {}
    }
}

/// Points at the words that stand for what the pointer is on.
fn hover(state: &mut State, shared: &Shared) {
    let pointed = state.heard_reading(shared).zip(state.room.hover);
    state.command.link = pointed.and_then(|(reading, cell)| link::at_cell(reading, cell));
}

/// What a hand takes hold of on a cell.
fn grasp(state: &State, shared: &Shared, cell: Place) -> Option<Held> {
    match (state.room.mode, state.room.tool) {
        (Mode::Watch | Mode::Teach, _) | (_, Tool::Move) => {
            let item = item_at(state.shown(shared), cell)?;
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
fn release(state: &mut State, shared: &mut Shared, held: Option<Held>, cell: Place) {
    let trail = state.room.trail.take();
    if let Some(Trail { world, steps }) = trail.filter(|trail| trail.leads_to(cell)) {
        return change_by(state, shared, Ok(world), Some(&steps));
    }
    let shown = state.shown(shared);
    let changed = match (held, state.room.mode, state.room.tool) {
        (Some(Held::Item(item, _)), ..) => {
            if item_at(shown, cell) == Some(item) {
                // Taken up and put down where it was: the robot turns.
                if item == Thing::Robot && state.room.mode != Mode::Watch {
                    Ok(edit::turn(shown))
                } else {
                    return;
                }
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
    match (changed, state.room.mode) {
        (Ok(world), Mode::Watch) => put_down(state, shared, world, cell),
        // It goes back where it was.
        (Err(_), Mode::Watch) => {}
        (changed, _) => change(state, shared, changed),
    }
}

/// Something was put down in the room that is watched.
fn put_down(state: &mut State, shared: &mut Shared, world: World, at: Place) {
    let run = under_way(state, shared);
    state.settle(shared);
    state.watch.forget();
    state.room.moved = Some(Moved { world, at, run });
    shared.want(Effect::Focus(QUESTION));
}

/// The states of a task over time that is at work; none where there is no such task, or it is done.
fn under_way(state: &State, shared: &Shared) -> Vec<World> {
    let playback = state.watch.playback.as_ref().filter(|plan| !plan.ended());
    let said = shared.document.said.as_ref();
    let run = playback.map(Playback::so_far).unwrap_or_default();
    let is_whole = said.is_some_and(|said| {
        let is_timed = said.plan.as_ref().is_some_and(|plan| !plan.done.is_empty());
        is_timed && run.first() == Some(&*said.world)
    });
    if is_whole { run.to_vec() } else { Vec::new() }
}

/// Takes a change over, or says why it could not be made. The command in the box is read again in another world.
pub(crate) fn change(state: &mut State, shared: &mut Shared, changed: Result<World, Obstacle>) {
    change_by(state, shared, changed, None);
}

/// The same; `steps` are those that the robot was driven by.
fn change_by(
    state: &mut State,
    shared: &mut Shared,
    changed: Result<World, Obstacle>,
    steps: Option<&str>,
) {
    let text = Text::of(shared.language);
    match changed {
        Ok(world) => {
            state.room.obstacle = None;
            let words = text.phrases.change(state.shown(shared), &world);
            shared.record();
            if state.room.mode == Mode::Teach {
                shared.document.draft().show(world, steps);
                look(state, shared);
            } else {
                shared.document.preset = None;
                shared.document.change(world);
                state.watch.forget();
                ask::read(state, shared);
            }
            shared.say(words);
        }
        Err(obstacle) => {
            state.room.obstacle = Some(obstacle);
            shared.say(text.obstacle(obstacle));
        }
    }
}
