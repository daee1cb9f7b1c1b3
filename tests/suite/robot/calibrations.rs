//! Calibration by four corners: any turn, size and shift is found, a mirror and a wrong corner are said.

use super::world;
use groundling::domain::text;
use groundling::domain::{Cell, cell_at};
use groundling::robot::calibration::{Calibration, Mark, Uncalibrated, corners};
use groundling::robot::geometry::{Pose, wrap};
use proptest::prelude::{prop_assert, proptest};

/// Where the corners of a world lie that is turned, sized and shifted.
fn marks(angle: f64, size: f64, shift: [f64; 2]) -> Vec<Mark> {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let place = |(x, y): (i32, i32)| {
        let (x, y) = (size * f64::from(x), size * f64::from(y));
        [cos * x - sin * y + shift[0], sin * x + cos * y + shift[1]]
    };
    corners(&world()).into_iter().map(|cell| Mark { metres: place(cell), cell }).collect()
}

proptest! {
    #[test]
    fn any_turn_size_and_shift_is_found(angle in -3.1..3.1_f64, size in 0.2..2.0_f64, x in -9.0..9.0_f64, y in -9.0..9.0_f64) {
        let marks = marks(angle, size, [x, y]);
        let found = Calibration::fit(&marks).unwrap();
        prop_assert!((found.cell() - size).abs() < 1e-9 && found.off < 1e-9);
        for mark in marks {
            let pose = Pose { x: mark.metres[0], y: mark.metres[1], heading: angle };
            let cells = found.to_cells(pose);
            prop_assert!(cells.distance(f64::from(mark.cell.0), f64::from(mark.cell.1)) < 1e-9);
            prop_assert!(wrap(cells.heading).abs() < 1e-9, "it looks along the rows");
            let back = found.to_metres(cells);
            prop_assert!(back.distance(pose.x, pose.y) < 1e-9 && wrap(back.heading - angle).abs() < 1e-9);
        }
    }
}

#[test]
fn what_does_not_fit_is_said() {
    let good = marks(0.4, 0.5, [1.0, -2.0]);
    let mirrored: Vec<Mark> = good
        .iter()
        .map(|mark| Mark { metres: [-mark.metres[0], mark.metres[1]], ..*mark })
        .collect();
    assert_eq!(Calibration::fit(&mirrored), Err(Uncalibrated::Mirrored));
    let mut wrong = good.clone();
    wrong[2].metres[0] += 0.8;
    assert!(matches!(Calibration::fit(&wrong), Err(Uncalibrated::Off(off)) if off > 0.3));
    wrong[2].metres[0] -= 0.77;
    let near = Calibration::fit(&wrong).unwrap();
    assert!(near.off > 0.01 && near.off < 0.1, "{near:?}");
    let same = vec![good[0]; 4];
    assert_eq!(Calibration::fit(&same), Err(Uncalibrated::TooFew));
    assert_eq!(Calibration::fit(&good[..1]), Err(Uncalibrated::TooFew));
    assert!(matches!(Calibration::fit(&marks(0.0, 9.0, [0.0; 2])), Err(Uncalibrated::Size(_))));
    let nan = vec![Mark { metres: [f64::NAN, 0.0], cell: (0, 0) }, good[0]];
    assert!(Calibration::fit(&nan).is_err());
}

#[test]
fn every_world_has_four_corners_to_stand_on() {
    for drawing in [
        include_str!("../../../assets/worlds/three-rooms.txt"),
        include_str!("../../../assets/worlds/hall.txt"),
        include_str!("../../../assets/worlds/store.txt"),
        include_str!("../../../assets/worlds/locked.txt"),
    ] {
        let world = text::read_legal(drawing).unwrap();
        let corners = corners(&world);
        assert_eq!(corners.len(), 4);
        for (x, y) in &corners {
            assert_eq!(cell_at(&world.rooms, &world.doors, *x, *y), Cell::Floor);
        }
        assert!(corners[0].0 < corners[2].0 && corners[0].1 < corners[2].1, "{corners:?}");
    }
}
