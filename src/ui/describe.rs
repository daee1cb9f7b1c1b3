//! A world in words, for the screen reader and wherever a picture needs a name.

use crate::domain::{Bounds, State};

/// Where a cell is: the room whose inside it is in, a doorway, a wall, or outside.
pub fn place(state: &State, x: i32, y: i32) -> String {
    let within = |b: &Bounds| b.left <= x && x <= b.right && b.bottom <= y && y <= b.top;
    let inside = |b: &Bounds| b.left < x && x < b.right && b.bottom < y && y < b.top;
    if let Some(room) = state.rooms.iter().find(|r| inside(&r.bounds)) {
        return format!("the {} room", room.color);
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
    format!("The robot is in {place}, facing {}.", agent.direction)
}

/// The whole world: robot, rooms, objects.
pub fn world(state: &State) -> String {
    let mut words = robot(state);
    let rooms: Vec<&str> = state.rooms.iter().map(|r| r.color.name()).collect();
    words.push_str(&format!(" Rooms: {}.", rooms.join(", ")));
    for object in &state.objects {
        let size = object.size.map(|size| format!("{size} ")).unwrap_or_default();
        let place = place(state, object.x, object.y);
        words.push_str(&format!(" A {size}{} {} in {place}.", object.color, object.shape));
    }
    words
}
