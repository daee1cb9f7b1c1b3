//! What is to be seen in the room besides the world itself: what is pointed at, what the policy is worth, what a
//! hand holds.

use super::edit;
use super::state::{Held, Mode, Room, Tool};
use crate::domain::{Bounds, State as World};
use crate::render::{Arrow, Ghost, Options, Thing, spread};
use crate::ui::page::place::{Place, inside, item_at};
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::link;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::state::Layer;
use crate::worker::protocol::{CellValue, Refers};

/// How the room is to be shown.
pub fn options(state: &State, shared: &Shared) -> Options {
    let options = Options {
        theme: shared.preferences.theme,
        letters: true,
        named: true,
        ..Options::default()
    };
    let options = Options { cursor: state.room.cursor, ..options };
    match state.room.mode {
        Mode::Watch => watched(state, shared, options),
        Mode::Edit | Mode::Teach => changed(state, shared, options),
    }
}

/// What the values of the room's cells reach from and to, for a legend; nothing where none are shown.
pub fn values_range(state: &State, shared: &Shared) -> Option<[f64; 2]> {
    if !is_shown(state, shared, Layer::Values) {
        return None;
    }
    spread(&values(state)).ends
}

fn is_shown(state: &State, shared: &Shared, layer: Layer) -> bool {
    shared.depth >= Depth::See && state.watch.shows(layer)
}

/// What is known of the cells, unless the goal holds whatever the robot does: there is nothing to compare then.
fn known(state: &State) -> &[CellValue] {
    let cells = state.watch.values.as_ref().map_or(&[][..], |values| &values.map.cells);
    if cells.iter().all(|cell| cell.goal) { &[] } else { cells }
}

fn values(state: &State) -> Vec<(i32, i32, f64)> {
    known(state).iter().map(|cell| (cell.x, cell.y, cell.value)).collect()
}

fn watched(state: &State, shared: &Shared, mut options: Options) -> Options {
    if let (Some(Held::Item(what, at)), Some(target)) = (state.room.held, state.room.hover) {
        options.ghost = Some(ghost(state.shown(shared), what, at, target));
    }
    if let Some(reply) = &state.command.reply {
        options.highlight.clone_from(&reply.cells);
        return options;
    }
    let Some(reading) = state.heard_reading(shared) else { return options };
    options.highlight = state.command.link.map(|own| link::cells(reading, own)).unwrap_or_default();
    let failed = reading.phrases.iter().filter(|phrase| !phrase.referents.is_empty());
    if options.highlight.is_empty() && state.command.link.is_none() {
        // What is in question is shown without being asked for.
        let in_question = failed.filter(|phrase| phrase.refers != Refers::One);
        let cells = in_question.flat_map(|phrase| &phrase.referents).flat_map(|r| &r.cells);
        options.highlight = cells.copied().collect();
    }
    let readings = state.heard(shared).map_or(&[][..], |answer| &answer.readings);
    if let Some(preview) = state.command.preview.and_then(|place| readings.get(place)) {
        options.goal.clone_from(&preview.cells);
        return options;
    }
    if is_shown(state, shared, Layer::Goal) {
        options.goal.clone_from(&reading.cells);
    }
    if state.command.live.is_some() {
        return options;
    }
    if is_shown(state, shared, Layer::Values) {
        options.values = spread(&values(state)).cells;
    }
    if is_shown(state, shared, Layer::Arrows) {
        let arrow = |cell: &CellValue| {
            let arrow = Arrow::of_action(cell.action.as_deref()?, cell.facing)?;
            Some((cell.x, cell.y, arrow))
        };
        options.arrows = known(state).iter().filter_map(arrow).collect();
    }
    options
}

fn changed(state: &State, shared: &Shared, mut options: Options) -> Options {
    let Room { held, hover, mode, tool, paint, .. } = state.room;
    let shown = state.shown(shared);
    match (held, hover) {
        (Some(Held::Item(what, at)), Some(target)) => {
            options.ghost = Some(ghost(shown, what, at, target));
        }
        (Some(Held::Corner(corner)), Some(target)) => {
            options.highlight = frame(corner, target);
            if edit::paint(shown, paint, corner, target).is_err() {
                options.goal.clone_from(&options.highlight);
            }
        }
        (None, Some(cell)) if mode == Mode::Edit && tool != Tool::Move => {
            options.highlight = vec![inside(shown, cell)];
        }
        (None, Some(cell)) if item_at(shown, cell).is_some() => {
            options.highlight = vec![cell];
        }
        _ => {}
    }
    options
}

/// What a hand holds over a cell.
fn ghost(shown: &World, what: Thing, at: [f32; 2], target: Place) -> Ghost {
    let own = item_at(shown, target) == Some(what);
    let allowed = own || edit::put(shown, what, target).is_ok();
    Ghost { what, at, target, allowed }
}

/// The cells of the rectangle between two corners.
fn frame(a: Place, b: Place) -> Vec<Place> {
    let all =
        Bounds { left: a.0.min(b.0), bottom: a.1.min(b.1), right: a.0.max(b.0), top: a.1.max(b.1) };
    all.cells().take(4096).collect()
}
