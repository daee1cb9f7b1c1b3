//! The guide's text: part of a page, with examples that name things of the room by what they are there. `{thing}` is an
//! object, `{here}` the robot's room, `{other}` another; a line that the room has nothing for is left out.

use crate::domain::{Color, Object, State as World};
use crate::ui::page::grammar::room_at;

/// The guide for a world.
pub fn filled(text: &str, world: &World) -> String {
    let names = names(world);
    let fill = |line: &str| {
        let mut line = line.to_owned();
        for (place, name) in &names {
            if line.contains(place) {
                line = line.replace(place, name.as_deref()?);
            }
        }
        Some(line)
    };
    text.lines().filter_map(fill).collect()
}

/// What the things of a world are called, where a colour tells them from all others.
fn names(world: &World) -> [(&'static str, Option<String>); 3] {
    let here = room_at(world, (world.agent.x, world.agent.y));
    let is_one =
        |color: &Color| world.rooms.iter().filter(|room| room.color == *color).count() == 1;
    let other = world.rooms.iter().map(|room| room.color).find(|&c| Some(c) != here && is_one(&c));
    let like = |a: &Object, b: &Object| (a.color, a.shape) == (b.color, b.shape);
    let is_alone = |a: &&Object| world.objects.iter().filter(|b| like(a, b)).count() == 1;
    let thing = world.objects.iter().find(is_alone);
    [
        ("{here}", here.filter(is_one).map(|color| color.name().to_owned())),
        ("{other}", other.map(|color| color.name().to_owned())),
        ("{thing}", thing.map(|thing| format!("{} {}", thing.color, thing.shape))),
    ]
}
