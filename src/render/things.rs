//! What stands in a room as quads: the robot and the objects, each with its shadow; and the same while a person
//! drags it. Units are cells.

use super::options::{Ghost, Options, Thing};
use super::palette::Theme;
use super::pose::Pose;
use super::quad::{Figure, Quad};
use crate::domain::{Object, Size, State};

/// How much of a thing is seen in the cell that it is dragged out of.
const LEFT_BEHIND: f32 = 0.3;
/// How far, and by how much, a thing is lifted.
const LIFT: f32 = 0.1;

/// Objects from the state's first to its last, then the robot, then what is held above them all.
pub(super) fn things(state: &State, pose: &Pose, options: &Options, out: &mut Vec<Quad>) {
    let Options { theme, letters, ghost, .. } = options;
    let held = ghost.as_ref().map(|ghost| ghost.what);
    for (i, (object, place)) in state.objects.iter().zip(&pose.objects).enumerate() {
        let begin = out.len();
        out.extend(object_quads(object, *place, *theme));
        out.extend(letters.then(|| letter(object, *place, *theme)));
        if held == Some(Thing::Object(i)) {
            left_behind(&mut out[begin..]);
        }
    }
    let begin = out.len();
    out.extend(robot_quads(pose.robot, pose.turn, *theme));
    if held == Some(Thing::Robot) {
        left_behind(&mut out[begin..]);
    }
    if let Some(ghost) = ghost {
        lifted(state, pose, ghost, *theme, out);
    }
}

/// A thing in a person's hand: a little larger, its shadow away from it.
fn lifted(state: &State, pose: &Pose, ghost: &Ghost, theme: Theme, out: &mut Vec<Quad>) {
    let [x, y] = ghost.at;
    let place = [x, y + LIFT];
    let quads = match ghost.what {
        Thing::Robot => Some(robot_quads(place, pose.turn, theme)),
        Thing::Object(i) => state.objects.get(i).map(|object| object_quads(object, place, theme)),
    };
    out.extend(quads.into_iter().flatten().map(|quad| {
        let shadow = quad.figure == Figure::Rect;
        let half = quad.half.map(|side| side * (1.0 + LIFT));
        let centre = if shadow { [x + LIFT / 2.0, y - 3.0 * LIFT] } else { quad.centre };
        Quad { centre, half, ..quad }
    }));
}

/// What is left in its cell of a thing that is dragged: `quads` made pale.
fn left_behind(quads: &mut [Quad]) {
    for quad in quads {
        for colour in [&mut quad.fill, &mut quad.ink] {
            colour.0[3] *= LEFT_BEHIND;
        }
    }
}

/// An object and its shadow.
fn object_quads(object: &Object, [x, y]: [f32; 2], theme: Theme) -> [Quad; 2] {
    let half = match object.size {
        Some(Size::Small) => 0.29,
        Some(Size::Medium) | None => 0.39,
        Some(Size::Large) => 0.47,
    };
    let shadow = [x + 0.02, y - half * 0.86];
    let icon = Figure::from(object.shape);
    [
        Quad::soft(shadow, [half * 0.8, half * 0.2], half * 0.2, half * 0.24, theme.shadow()),
        Quad::icon(icon, [x, y], half, theme.object(object.color), theme.ink()),
    ]
}

/// The letter of an object's colour, on a disc at its lower right.
fn letter(object: &Object, [x, y]: [f32; 2], theme: Theme) -> Quad {
    Quad::letter(object.color, [x + 0.32, y - 0.32], 0.16, theme.backdrop(), theme.signs())
}

/// The robot and its shadow.
fn robot_quads([x, y]: [f32; 2], turn: f32, theme: Theme) -> [Quad; 2] {
    let robot = Quad::icon(Figure::Robot, [x, y], 0.46, theme.robot(), theme.robot_face());
    [
        Quad::soft([x + 0.03, y - 0.08], [0.36, 0.36], 0.36, 0.12, theme.shadow()),
        Quad { turn, ..robot },
    ]
}
