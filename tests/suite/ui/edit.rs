//! Changes to a world: each leaves a legal one, or says what is in the way.

use super::world;
use groundling::domain::{Cell, Color, Direction, Lock, Shape, State, cell_at, generate};
use groundling::render::Thing;
use groundling::ui::page::place::item_at;
use groundling::ui::talk::room::edit::{
    self, Look, Obstacle, add, add_anywhere, door, drive, erase, paint, put, turn,
};
use proptest::prelude::{Strategy, any, prop};
use proptest::{prop_assert_eq, proptest};

const CHAIR: Look = Look { shape: Shape::Chair, color: Color::Teal, size: None };

#[test]
fn things_go_where_there_is_floor_and_nobody() {
    let start = world();
    let block = (start.objects[0].x, start.objects[0].y);
    let robot = (start.agent.x, start.agent.y);
    assert_eq!(item_at(&start, block), Some(Thing::Object(0)));
    assert_eq!(item_at(&start, robot), Some(Thing::Robot));
    assert_eq!(put(&start, Thing::Robot, block), Err(Obstacle::Taken));
    assert_eq!(put(&start, Thing::Robot, (0, 0)), Err(Obstacle::NoFloor));
    assert_eq!(put(&start, Thing::Robot, (-70, 0)), Err(Obstacle::NoFloor));
    assert_eq!(put(&start, Thing::Object(9), robot), Err(Obstacle::Nothing));
    let moved = put(&start, Thing::Object(0), (1, 1)).unwrap();
    assert_eq!(item_at(&moved, (1, 1)), Some(Thing::Object(0)));
    assert_eq!(turn(&start).agent.direction, start.agent.direction.left());
}

#[test]
fn driving_pushes_what_is_in_the_way() {
    let mut start = world();
    (start.objects[0].x, start.objects[0].y) = (2, 2);
    (start.agent.x, start.agent.y) = (1, 2);
    let pushed = drive(&start, Direction::East).unwrap();
    assert_eq!((pushed.agent.x, pushed.objects[0].x), (2, 3));
    let mut wall = start.clone();
    (wall.agent.x, wall.agent.y) = (1, 1);
    wall.agent.direction = Direction::West;
    assert_eq!(drive(&wall, Direction::West), Err(Obstacle::Blocked));
}

#[test]
fn rooms_may_share_walls_but_not_floor() {
    let start = world();
    let extent = start.extent().unwrap();
    let right = extent.right;
    let bigger = paint(&start, Color::Teal, (right, 0), (right + 4, 4)).unwrap();
    assert_eq!(bigger.rooms.len(), start.rooms.len() + 1);
    assert_eq!(paint(&start, Color::Teal, (1, 1), (4, 4)), Err(Obstacle::Overlap));
    assert_eq!(paint(&start, Color::Teal, (right, 0), (right + 1, 9)), Err(Obstacle::TooSmall));
    assert_eq!(paint(&start, Color::Teal, (right, 0), (right + 99, 9)), Err(Obstacle::TooLarge));
    let painted = paint(&start, Color::Teal, (1, 1), (1, 1)).unwrap();
    assert!(painted.rooms.iter().any(|room| room.color == Color::Teal));
    assert_eq!(paint(&start, Color::Teal, (0, 0), (0, 0)), Err(Obstacle::TooSmall));

    // Taken away again, the world is what it was; a room that somebody is in stays.
    assert_eq!(erase(&bigger, (right + 1, 1)), Ok(start.clone()));
    let home = (start.agent.x, start.agent.y);
    assert_eq!(erase(&start, home), Err(Obstacle::RobotStays));
    assert_eq!(erase(&start, (home.0, home.1 + 1)), Err(Obstacle::Occupied));
    assert_eq!(erase(&start, (0, 0)), Err(Obstacle::Nothing));
}

#[test]
fn a_door_goes_from_open_to_untried_to_locked_to_wall() {
    let start = world();
    let wall = start
        .extent()
        .unwrap()
        .cells()
        .find(|&(x, y)| {
            cell_at(&start.rooms, &start.doors, x, y) == Cell::Wall && door(&start, (x, y)).is_ok()
        })
        .expect("some wall stands between two floors");
    let mut state = start.clone();
    let mut locks = Vec::new();
    for _ in 0..4 {
        state = door(&state, wall).unwrap();
        locks.push(match cell_at(&state.rooms, &state.doors, wall.0, wall.1) {
            Cell::Door(index) => Some(state.doors[index].lock),
            _ => None,
        });
    }
    assert_eq!(locks, [Some(Lock::Unlocked), Some(Lock::Unknown), Some(Lock::Locked), None]);
    assert_eq!(state, start);
    assert_eq!(door(&start, (1, 1)), Err(Obstacle::NoPassage));
    let unlocked = edit::unlock(&door(&door(&start, wall).unwrap(), wall).unwrap());
    assert!(unlocked.doors.iter().all(|door| door.lock == Lock::Unlocked));
}

#[test]
fn there_are_limits_to_what_a_room_holds() {
    let mut state = world();
    while state.objects.len() < 8 {
        state = add_anywhere(&state, CHAIR).unwrap();
    }
    assert_eq!(add_anywhere(&state, CHAIR), Err(Obstacle::TooManyObjects));
    let first = (state.objects[0].x, state.objects[0].y);
    let fewer = erase(&state, first).unwrap();
    assert_eq!(fewer.objects.len(), 7);
    assert_eq!(add(&fewer, CHAIR, (0, 0)), Err(Obstacle::NoFloor));
    let mut names: Vec<&str> = state.objects.iter().map(|o| &*o.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 8);
}

/// One change of an editor.
#[derive(Clone, Copy, Debug)]
enum Change {
    Put(usize, (i32, i32)),
    Add((i32, i32)),
    Paint((i32, i32), (i32, i32)),
    Door((i32, i32)),
    Erase((i32, i32)),
    Drive(usize),
}

fn changes() -> impl Strategy<Value = Vec<Change>> {
    let place = || (-2..18i32, -2..18i32);
    let change =
        (any::<u8>(), place(), place(), 0..4usize).prop_map(|(kind, a, b, n)| match kind % 6 {
            0 => Change::Put(n, a),
            1 => Change::Add(a),
            2 => Change::Paint(a, b),
            3 => Change::Door(a),
            4 => Change::Erase(a),
            _ => Change::Drive(n),
        });
    prop::collection::vec(change, 1..30)
}

fn change(state: &State, change: Change) -> Result<State, Obstacle> {
    match change {
        Change::Put(0, cell) => put(state, Thing::Robot, cell),
        Change::Put(n, cell) => put(state, Thing::Object(n - 1), cell),
        Change::Add(cell) => add(state, CHAIR, cell),
        Change::Paint(from, to) => paint(state, Color::Orange, from, to),
        Change::Door(cell) => door(state, cell),
        Change::Erase(cell) => erase(state, cell),
        Change::Drive(n) => drive(state, Direction::ALL[n]),
    }
}

proptest! {
    #[test]
    fn whatever_is_done_the_world_stays_legal(seed in any::<u64>(), all in changes()) {
        let mut state = generate(&Default::default(), seed);
        for one in all {
            if let Ok(next) = change(&state, one) {
                prop_assert_eq!(next.check(), Ok(()), "{:?}", one);
                state = next;
            }
        }
    }
}
