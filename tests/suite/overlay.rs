//! What is laid over a picture: values, arrows, regions, the keyboard's frame, a dragged thing.

use groundling::domain::{Color, Direction, Plan, State, generate};
use groundling::render::{
    Arrow, Figure, Ghost, Motion, Options, Quad, Rgba, Scene, Spread, Theme, Thing, spread,
};

const ROOMS: &str = include_str!("../data/golden/rooms.json");

fn rooms() -> State {
    State::read(ROOMS).unwrap()
}

fn quads(options: &Options, figure: Figure) -> Vec<Quad> {
    let scene = Scene::of(&rooms(), options);
    scene.quads.into_iter().filter(|quad| quad.figure == figure).collect()
}

fn everything() -> Options {
    let ghost = Ghost { what: Thing::Object(3), at: [2.4, 3.1], target: (2, 3), allowed: false };
    Options {
        values: vec![(1, 1, 0.0), (2, 1, 0.5), (3, 1, 1.0), (900, 1, 1.0)],
        arrows: vec![(1, 1, Arrow::Step(Direction::East)), (900, 1, Arrow::TurnLeft)],
        goal: vec![(3, 1), (900, 1)],
        highlight: vec![(1, 4), (2, 4), (900, 1)],
        cursor: Some((1, 3)),
        ghost: Some(ghost),
        ..Options::default()
    }
}

#[test]
fn a_value_is_told_by_colour_and_by_size() {
    let plain = quads(&Options::default(), Figure::Rect).len();
    let tiles = quads(&Options { ghost: None, ..everything() }, Figure::Rect);
    assert_eq!(tiles.len(), plain + 3, "a cell outside is not shown");
    let theme = Theme::Light;
    let tile = |value: f32| *tiles.iter().find(|q| q.fill == theme.value(value)).unwrap();
    assert!(tile(0.0).half[0] < tile(0.5).half[0] && tile(0.5).half[0] < tile(1.0).half[0]);
    assert!(tile(1.0).half[0] < 0.5, "the floor shows round it");
}

#[test]
fn colours_of_values_are_even_steps_of_lightness() {
    // CIE lightness, 0 to 100.
    let lightness = |colour: Rgba| 116.0 * colour.luminance().cbrt() - 16.0;
    for theme in [Theme::Light, Theme::Dark] {
        let all: Vec<f32> = (0..=20).map(|i| lightness(theme.value(i as f32 / 20.0))).collect();
        let steps: Vec<f32> = all.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mean = (all[20] - all[0]) / 20.0;
        assert!(
            steps.iter().all(|step| (0.5..1.6).contains(&(step / mean))),
            "{theme:?} {steps:?}"
        );
        assert_eq!((theme.value(-1.0), theme.value(7.0)), (theme.value(0.0), theme.value(1.0)));
        assert_eq!(theme.value(f32::NAN), theme.value(0.0));
        assert_eq!(theme.value(0.5), theme.value_stops()[2]);
    }
}

#[test]
fn everything_stands_out_from_every_value() {
    for theme in [Theme::Light, Theme::Dark] {
        for ground in (0..=20).map(|i| theme.value(i as f32 / 20.0)) {
            for object in Color::ALL {
                let [fill, line] = [theme.object(*object), theme.ink()].map(|c| c.contrast(ground));
                // Less than on a floor: by night a scale from dark to bright must pass between the two.
                assert!(fill.max(line) >= 2.5, "{object}, {theme:?} {ground:?}: {fill} {line}");
            }
            assert!(ground.opposite().contrast(ground) >= 3.0, "{theme:?} {ground:?}");
        }
    }
}

#[test]
fn values_are_spread_over_the_colours() {
    let Spread { cells, ends } = spread(&[(0, 0, 0.0), (1, 0, 0.90), (2, 0, 0.95), (3, 0, 1.0)]);
    let values: Vec<f32> = cells.iter().map(|(.., value)| (value * 100.0).round()).collect();
    assert_eq!(values, [0.0, 10.0, 55.0, 100.0], "no way at all stays apart");
    assert_eq!(ends, Some([0.9, 1.0]));
    let alike = Spread { cells: vec![(0, 0, 1.0), (1, 0, 0.0)], ends: Some([0.4; 2]) };
    assert_eq!(spread(&[(0, 0, 0.4), (1, 0, f64::NAN)]), alike);
    assert_eq!(spread(&[(0, 0, 0.0)]), Spread { cells: vec![(0, 0, 0.0)], ends: None });
}

#[test]
fn every_action_has_its_arrow() {
    for (name, arrow) in [
        ("north", Some(Arrow::Step(Direction::North))),
        ("west", Some(Arrow::Step(Direction::West))),
        ("forward", Some(Arrow::Step(Direction::East))),
        ("turn_left", Some(Arrow::TurnLeft)),
        ("turn_right", Some(Arrow::TurnRight)),
        ("pull", Some(Arrow::Pull(Direction::East))),
        ("dance", None),
    ] {
        assert_eq!(Arrow::of_action(name, Direction::East), arrow, "{name}");
    }
}

#[test]
fn neighbours_share_an_outline() {
    // An L of three cells, one of them told twice, and a cell apart.
    let highlight = vec![(1, 1), (1, 2), (2, 2), (1, 1), (4, 1)];
    let quads = quads(&Options { highlight, ..Options::default() }, Figure::Region);
    let neighbours: Vec<_> = quads.iter().map(|q| (q.centre, q.detail[0] as u8)).collect();
    let [north, east, south, west, north_east, south_west] = [1, 2, 4, 8, 16, 64];
    assert_eq!(
        neighbours,
        [
            ([1.0, 1.0], north | north_east),
            ([1.0, 2.0], south | east),
            ([2.0, 2.0], west | south_west),
            ([4.0, 1.0], 0),
        ]
    );
}

#[test]
fn goal_cells_and_cells_pointed_out_differ_in_form() {
    let regions = quads(&everything(), Figure::Region);
    let stripes: Vec<bool> = regions.iter().map(|q| q.detail[1] > 0.0).collect();
    assert_eq!(stripes, [true, false, false]);
}

#[test]
fn what_is_dragged_is_held_above_all_and_stays_pale_in_its_cell() {
    let state = rooms();
    let scene = Scene::of(&state, &everything());
    let figure = Figure::from(state.objects[3].shape);
    let here: Vec<&Quad> = scene.quads.iter().filter(|q| q.figure == figure).collect();
    let pale = here.iter().find(|q| q.fill.0[3] < 0.5).unwrap();
    assert_eq!(pale.centre, [state.objects[3].x as f32, state.objects[3].y as f32]);
    let held = scene.quads.last().unwrap();
    assert_eq!((held.figure, held.fill.0[3]), (figure, 1.0));
    assert!(held.half[0] > pale.half[0]);
    let count = |figure| scene.quads.iter().filter(|q| q.figure == figure).count();
    assert_eq!(
        (count(Figure::Dashes), count(Figure::Frame)),
        (1, 2),
        "refused; the keyboard's cell"
    );
    let nobody = Ghost { what: Thing::Object(99), allowed: true, ..everything().ghost.unwrap() };
    let scene = Scene::of(&state, &Options { ghost: Some(nobody), ..Options::default() });
    assert_eq!(scene.quads.last().unwrap().figure, Figure::Robot, "an object that is gone");
}

#[test]
fn nothing_laid_over_moves_with_the_robot() {
    let before = rooms();
    let mut after = before.clone();
    after.agent.x += 1;
    let motion = Motion::between(&before, &after);
    let options = Options { ghost: None, ..everything() };
    let laid = |t: f32| {
        let quads = motion.scene_at(t, &options).quads.into_iter();
        quads
            .filter(|q| q.figure != Figure::Robot && q.centre[0].fract() == 0.0)
            .collect::<Vec<_>>()
    };
    assert_eq!(laid(0.0).len(), laid(0.5).len());
    assert_eq!(laid(0.3), laid(0.5));
}

#[test]
fn a_large_world_with_everything_is_a_few_thousand_quads() {
    let state = generate(&Plan { side: (32, 32), objects: (20, 20) }, 1);
    let cells = || (0..32).flat_map(|x| (0..32).map(move |y| (x, y)));
    let options = Options {
        letters: true,
        values: cells().map(|(x, y)| (x, y, 0.5)).collect(),
        arrows: cells().map(|(x, y)| (x, y, Arrow::TurnLeft)).collect(),
        goal: cells().take(100).collect(),
        highlight: cells().skip(500).take(200).collect(),
        ..everything()
    };
    let scene = Scene::of(&state, &options);
    assert!(scene.quads.len() < 2800, "{} quads", scene.quads.len());
    assert!(scene.floats().iter().all(|number| number.is_finite()));
}
