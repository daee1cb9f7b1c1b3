//! Pictures as data: what a scene holds and in which order, what moves how, what a cell is called, and that
//! the colours can be told apart.

use groundling::domain::{Color, Direction, Lock, Shape, State};
use groundling::render::{Figure, Fit, Grid, Ground, Motion, Options, Pose, Quad, Scene, Theme};

const ROOMS: &str = include_str!("../data/golden/rooms.json");

fn rooms() -> State {
    State::read(ROOMS).unwrap()
}

fn figures(scene: &Scene) -> Vec<Figure> {
    scene.quads.iter().map(|quad| quad.figure).collect()
}

fn count(scene: &Scene, figure: Figure) -> usize {
    figures(scene).iter().filter(|f| **f == figure).count()
}

fn last(scene: &Scene, figure: Figure) -> usize {
    figures(scene).iter().rposition(|f| *f == figure).unwrap()
}

fn first(scene: &Scene, figure: Figure) -> usize {
    figures(scene).iter().position(|f| *f == figure).unwrap()
}

#[test]
fn a_scene_holds_every_thing_once() {
    let state = rooms();
    let scene = Scene::of(&state, &Options::default());
    for shape in Shape::ALL {
        let wanted = state.objects.iter().filter(|o| o.shape == *shape).count();
        assert_eq!(count(&scene, Figure::from(*shape)), wanted, "{shape}");
    }
    assert_eq!(count(&scene, Figure::Floor), state.rooms.len());
    assert_eq!(count(&scene, Figure::Letter), state.rooms.len());
    assert_eq!(count(&scene, Figure::Robot), 1);
    let doors = |lock| state.doors.iter().filter(|d| d.lock == lock).count();
    assert_eq!(count(&scene, Figure::Padlock), doors(Lock::Locked));
    assert_eq!(count(&scene, Figure::Question), doors(Lock::Unknown));
}

#[test]
fn things_lie_upon_floors_and_the_robot_upon_all() {
    let scene = Scene::of(&rooms(), &Options { highlight: vec![(2, 2)], ..Options::default() });
    assert!(last(&scene, Figure::Floor) < first(&scene, Figure::Region));
    assert!(last(&scene, Figure::Region) < first(&scene, Figure::Padlock));
    assert!(last(&scene, Figure::Padlock) < first(&scene, Figure::Chair));
    assert_eq!(last(&scene, Figure::Robot), scene.quads.len() - 1);
}

#[test]
fn letters_and_highlights_are_as_asked() {
    let state = rooms();
    let highlight = vec![(2, 2), (3, 3), (500, 500)];
    let scene = Scene::of(&state, &Options { letters: true, highlight, ..Options::default() });
    assert_eq!(count(&scene, Figure::Letter), state.rooms.len() + state.objects.len());
    assert_eq!(count(&scene, Figure::Region), 2, "a cell outside is not shown");
}

#[test]
fn the_numbers_that_cross_are_header_and_quads() {
    let scene = Scene::of(&rooms(), &Options::default());
    let floats = scene.floats();
    assert_eq!(floats.len(), Scene::HEADER + scene.quads.len() * Quad::FLOATS);
    assert_eq!(floats[..4], [-0.5, -0.5, 20.0, 15.0]);
    assert!(floats.iter().all(|number| number.is_finite()));
}

#[test]
fn a_pixel_finds_its_cell() {
    let scene = Scene::of(&rooms(), &Options::default());
    // 20 by 15 cells in 800 by 700 pixels: 40 pixels a cell, 50 free above and below.
    let fit = Fit::new(scene.extent, 800.0, 700.0);
    assert_eq!((fit.scale, fit.origin), (40.0, [0.0, 50.0]));
    assert_eq!(fit.cell(1.0, 51.0), (0, 14));
    assert_eq!(fit.cell(799.0, 649.0), (19, 0));
    assert_eq!(fit.cell(95.0, 635.0), (2, 0));
    assert_eq!(fit.cell(1.0, 49.0), (0, 15), "outside");
    assert_eq!(fit.point(20.0, 70.0), [0.0, 14.0], "a cell's middle");
    assert_eq!(fit.point(40.0, 610.0), [0.5, 0.5], "a corner");
}

#[test]
fn a_door_interrupts_the_wall_and_the_wall_reaches_it() {
    let mut state = rooms();
    let bars = |state: &State| {
        let scene = Scene::of(state, &Options::default());
        let wall = Theme::Light.wall();
        let bars = scene.quads.into_iter().filter(|q| q.figure == Figure::Rect && q.fill == wall);
        let ends = bars.map(|q| [q.centre[0] - q.half[0], q.centre[0] + q.half[0], q.centre[1]]);
        ends.map(|ends| ends.map(|x| (x * 10.0).round() as i32)).collect()
    };
    let with: Vec<[i32; 3]> = bars(&state);
    assert!(with.contains(&[-2, 25, 50]), "up to the doorway at column 3: {with:?}");
    state.doors.clear();
    let without: Vec<[i32; 3]> = bars(&state);
    assert!(without.contains(&[-2, 192, 50]), "one bar from end to end: {without:?}");
}

#[test]
fn a_push_glides() {
    let before = rooms();
    let mut after = before.clone();
    after.agent.x += 1;
    after.agent.direction = Direction::South;
    after.objects[3].y += 1;
    let motion = Motion::between(&before, &after);
    assert!(!motion.is_still() && Motion::between(&after, &after).is_still());
    assert_eq!(motion.pose(0.0), Pose::of(&before));
    assert_eq!(motion.pose(1.0), Pose::of(&after));
    assert_eq!(motion.pose(7.0), motion.pose(1.0));
    assert_eq!(motion.pose(f32::NAN), motion.pose(1.0));
    let half = motion.pose(0.5);
    assert_eq!(half.robot, [2.5, 2.0]);
    assert_eq!(half.objects[3], [1.0, 1.5]);
    assert_eq!(half.objects[4], Pose::of(&before).objects[4]);
    let scene = motion.scene_at(1.0, &Options::default());
    assert_eq!(scene, Scene::of(&after, &Options::default()));
}

#[test]
fn the_robot_turns_the_short_way() {
    let quarter = std::f32::consts::FRAC_PI_2;
    for from in Direction::ALL {
        for to in Direction::ALL {
            let mut before = rooms();
            before.agent.direction = *from;
            let mut after = before.clone();
            after.agent.direction = *to;
            let motion = Motion::between(&before, &after);
            let turned = (motion.pose(0.99).turn - motion.pose(0.0).turn).abs();
            let wanted = match () {
                () if from == to => 0.0,
                () if *to == from.opposite() => 2.0 * quarter,
                () => quarter,
            };
            assert!((turned - wanted).abs() < 1e-5, "{from} to {to}: {turned}");
        }
    }
}

#[test]
fn objects_are_found_again_by_name() {
    let before = rooms();
    let mut after = before.clone();
    after.objects.reverse();
    after.objects.push(groundling::domain::Object {
        name: "new".to_owned(),
        x: 8,
        y: 1,
        ..after.objects[0].clone()
    });
    let still = Motion::between(&before, &after);
    assert!(still.is_still(), "a new object appears where it is");
}

#[test]
fn cells_have_signs_and_classes() {
    let state = rooms();
    let grid = Grid::of(&state);
    assert_eq!((grid.rows.len(), grid.rows[0].len()), (15, 20));
    assert_eq!((grid.rows[0][0].x, grid.rows[0][0].y), (0, 14), "from the north-west");
    let chair = grid.cell(8, 7).unwrap();
    assert_eq!(chair.class, "cell floor room-blue object shape-chair color-blue size-small");
    assert_eq!(chair.symbol, "Cb");
    assert_eq!((chair.ground, chair.room), (Ground::Room(2), Some(Color::Blue)));
    assert_eq!(grid.cell(2, 2).unwrap().symbol, "▶");
    assert!(grid.cell(20, 0).is_none());
}

#[test]
fn a_state_of_any_size_is_cut_not_refused() {
    let mut state = rooms();
    state.rooms[0].bounds.right = i32::MAX;
    state.rooms[0].bounds.top = i32::MAX;
    state.doors[0].bounds.left = i32::MIN;
    state.objects[0].x = i32::MIN;
    let scene = Scene::of(&state, &Options::default());
    assert_eq!((scene.extent.columns, scene.extent.rows), (256, 256));
    assert_eq!(Grid::of(&state).rows.len(), 256);
}

#[test]
fn everything_stands_out_from_every_floor() {
    for theme in [Theme::Light, Theme::Dark] {
        for floor in Color::ALL.iter().map(|room| theme.floor(*room)) {
            assert!(theme.wall().contrast(floor) >= 2.0, "wall, {theme:?} {floor:?}");
            for object in Color::ALL {
                let [fill, line] = [theme.object(*object), theme.ink()].map(|c| c.contrast(floor));
                assert!(fill.max(line) >= 3.0, "{object}, {theme:?} {floor:?}: {fill} {line}");
            }
            let shell = theme.robot().contrast(floor);
            assert!(shell.max(theme.robot_face().contrast(floor)) >= 3.0, "robot, {theme:?}");
        }
        for leaf in [theme.unknown_leaf(), theme.locked_leaf()] {
            assert!(theme.on_badge().contrast(leaf) >= 2.5, "badge, {theme:?}");
        }
    }
}

#[test]
fn no_two_colours_look_the_same() {
    let apart = |a: groundling::render::Rgba, b: groundling::render::Rgba| {
        a.0.iter().zip(b.0).map(|(a, b)| (a - b).abs()).sum::<f32>()
    };
    for theme in [Theme::Light, Theme::Dark] {
        for (i, a) in Color::ALL.iter().enumerate() {
            for b in &Color::ALL[..i] {
                let (object, floor) = (
                    apart(theme.object(*a), theme.object(*b)),
                    apart(theme.floor(*a), theme.floor(*b)),
                );
                assert!(object > 0.2, "{a} and {b} objects, {theme:?}: {object}");
                assert!(floor > 0.07, "{a} and {b} floors, {theme:?}: {floor}");
            }
        }
    }
}
