//! A world in words, for the screen reader and wherever a picture needs a name.

use crate::domain::{Bounds, Color, Direction, Shape, Size, State};

/// A colour's name.
pub fn color(color: Color) -> &'static str {
    match color {
        Color::Red => "red",
        Color::Green => "green",
        Color::Blue => "blue",
        Color::Yellow => "yellow",
        Color::Magenta => "magenta",
        Color::Brown => "brown",
        Color::Orange => "orange",
        Color::Tan => "tan",
        Color::Teal => "teal",
    }
}

/// A shape's name.
pub fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::Chair => "chair",
        Shape::Basket => "basket",
        Shape::Block => "block",
        Shape::Bag => "bag",
        Shape::Backpack => "backpack",
        Shape::Box => "box",
    }
}

/// A direction's name.
pub fn direction(direction: Direction) -> &'static str {
    match direction {
        Direction::North => "north",
        Direction::South => "south",
        Direction::East => "east",
        Direction::West => "west",
    }
}

/// Where a cell is: the room whose inside it is in, a doorway, a wall, or outside.
pub fn place(state: &State, x: i32, y: i32) -> String {
    let within = |b: &Bounds| b.left <= x && x <= b.right && b.bottom <= y && y <= b.top;
    let inside = |b: &Bounds| b.left < x && x < b.right && b.bottom < y && y < b.top;
    if let Some(room) = state.rooms.iter().find(|r| inside(&r.bounds)) {
        return format!("the {} room", color(room.color));
    }
    if state.doors.iter().any(|d| within(&d.bounds)) {
        return "a doorway".to_owned();
    }
    if state.rooms.iter().any(|r| within(&r.bounds)) { "a wall" } else { "no room" }.to_owned()
}

/// Where the robot is.
pub fn robot(state: &State) -> String {
    let agent = &state.agent;
    let place = place(state, agent.x, agent.y);
    format!("The robot is in {place}, facing {}.", direction(agent.direction))
}

/// The whole world: robot, rooms, objects.
pub fn world(state: &State) -> String {
    let mut words = robot(state);
    let rooms: Vec<&str> = state.rooms.iter().map(|r| color(r.color)).collect();
    words.push_str(&format!(" Rooms: {}.", rooms.join(", ")));
    for object in &state.objects {
        let size = match object.size {
            Some(Size::Small) => "small ",
            Some(Size::Medium) => "medium ",
            Some(Size::Large) => "large ",
            None => "",
        };
        let (color, shape) = (color(object.color), shape(object.shape));
        let place = place(state, object.x, object.y);
        words.push_str(&format!(" A {size}{color} {shape} in {place}."));
    }
    words
}
