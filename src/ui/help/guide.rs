//! The guide's text: a line a heading (`#`, `##`), an example (`*`), a key (`|`) or a paragraph. An example names things
//! of the room by what they are there: `{thing}` an object, `{here}` the robot's room, `{other}` another; one that the
//! room has nothing for is left out.

use crate::domain::{Color, Object, State as World};
use crate::ui::page::grammar::room_at;

/// A line of the guide.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Line {
    /// A heading of this depth.
    Head(usize, String),
    /// A paragraph.
    Text(String),
    /// Something to say.
    Say(String),
    /// A key, and what it does.
    Key(String, String),
}

/// The guide for a world.
pub fn lines(text: &str, world: &World) -> Vec<Line> {
    let names = names(world);
    text.lines().filter_map(|line| read(line, &names)).collect()
}

fn read(line: &str, names: &[(&str, Option<String>)]) -> Option<Line> {
    if let Some(keys) = line.strip_prefix("| ") {
        let (key, does) = keys.split_once(" | ")?;
        return Some(Line::Key(key.to_owned(), does.to_owned()));
    }
    if let Some(example) = line.strip_prefix("* ") {
        let mut example = example.to_owned();
        for (place, name) in names.iter().filter(|(place, _)| line.contains(place)) {
            example = example.replace(place, name.as_deref()?);
        }
        return Some(Line::Say(example));
    }
    let bare = line.trim_start_matches('#');
    Some(match line.len() - bare.len() {
        0 => Line::Text(line.to_owned()),
        depth => Line::Head(depth, bare.trim().to_owned()),
    })
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
