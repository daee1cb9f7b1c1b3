//! Metres to cells: a turn, a scale and a shift of the plane, found from places of which both are known, by least squares
//! (Umeyama 1991, which in a plane is a division of complex numbers). A cell's middle is its coordinates.

use super::geometry::{Pose, wrap};
use super::sight::angle;
use crate::domain::{Agent, Cell, State, cell_at};
use serde::{Deserialize, Serialize};

/// Metres that a cell may measure a side.
const SIZES: std::ops::RangeInclusive<f64> = 0.15..=5.0;
/// Cells that a place may be off.
pub const MOST_OFF: f64 = 0.2;

/// A place in metres, and the cell that it is the middle of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// In metres, as the robot is told of.
    pub metres: [f64; 2],
    /// In cells: column and row.
    pub cell: (i32, i32),
}

/// A place in metres and in cells.
type Pair = ([f64; 2], [f64; 2]);

/// How metres are mapped to cells: `cell = turn · metres + shift`, as complex numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Calibration {
    turn: [f64; 2],
    shift: [f64; 2],
    /// Cells that the worst place was off.
    pub off: f64,
}

/// Why places give no calibration.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Uncalibrated {
    /// There are not enough, or they are one place.
    #[error("two places that lie apart are needed")]
    TooFew,
    /// They fit when the world is seen in a mirror.
    #[error("the places run the wrong way round")]
    Mirrored,
    /// They do not fit: the worst is so many cells off.
    #[error("a place is {0:.2} cells off")]
    Off(f64),
    /// A cell would measure so many metres.
    #[error("a cell would measure {0:.2} m")]
    Size(f64),
}

impl Calibration {
    /// A world whose axes are the robot's: the middle of `cell` lies at `metres`, and a cell measures `size` metres.
    pub fn plain(size: f64, cell: (i32, i32), metres: [f64; 2]) -> Calibration {
        let turn = [1.0 / size, 0.0];
        let [x, y] = times(turn, metres);
        let shift = [f64::from(cell.0) - x, f64::from(cell.1) - y];
        Calibration { turn, shift, off: 0.0 }
    }

    /// A world in which the robot stands in the middle of its cell and looks to its side: where and how it is seen to be.
    pub fn here(size: f64, agent: &Agent, seen: Pose) -> Calibration {
        let turned = angle(agent.direction) - seen.heading;
        let turn = [libm::cos(turned) / size, libm::sin(turned) / size];
        let [x, y] = times(turn, [seen.x, seen.y]);
        let shift = [f64::from(agent.x) - x, f64::from(agent.y) - y];
        Calibration { turn, shift, off: 0.0 }
    }

    /// The best fit to these places.
    ///
    /// # Errors
    /// Why there is none that is good enough.
    pub fn fit(marks: &[Mark]) -> Result<Calibration, Uncalibrated> {
        let pairs: Vec<Pair> = marks.iter().map(|m| (m.metres, middle(m.cell))).collect();
        let found = solve(&pairs).ok_or(Uncalibrated::TooFew)?;
        let size = found.cell();
        if !SIZES.contains(&size) {
            return Err(Uncalibrated::Size(size));
        }
        if found.off <= MOST_OFF {
            return Ok(found);
        }
        let mirrored: Vec<_> = pairs.iter().map(|&([x, y], cell)| ([x, -y], cell)).collect();
        let is_mirrored = solve(&mirrored).is_some_and(|other| other.off <= MOST_OFF);
        Err(if is_mirrored { Uncalibrated::Mirrored } else { Uncalibrated::Off(found.off) })
    }

    /// Whether it is one: of one that comes from elsewhere nothing is known.
    pub fn is_sound(&self) -> bool {
        let all = [self.turn, self.shift, [self.off; 2]];
        all.as_flattened().iter().all(|n| n.is_finite()) && SIZES.contains(&self.cell())
    }

    /// Metres that a cell measures a side.
    pub fn cell(&self) -> f64 {
        1.0 / libm::hypot(self.turn[0], self.turn[1])
    }

    /// A pose of metres in cells.
    pub fn to_cells(&self, pose: Pose) -> Pose {
        let [x, y] = times(self.turn, [pose.x, pose.y]);
        let heading = wrap(pose.heading + self.angle());
        Pose { x: x + self.shift[0], y: y + self.shift[1], heading }
    }

    /// A pose of cells in metres.
    pub fn to_metres(&self, pose: Pose) -> Pose {
        let square = self.turn[0] * self.turn[0] + self.turn[1] * self.turn[1];
        let back = [self.turn[0] / square, -self.turn[1] / square];
        let [x, y] = times(back, [pose.x - self.shift[0], pose.y - self.shift[1]]);
        Pose { x, y, heading: wrap(pose.heading - self.angle()) }
    }

    fn angle(&self) -> f64 {
        libm::atan2(self.turn[1], self.turn[0])
    }
}

/// The four cells to calibrate by: the floor nearest to each corner of the world, south-west, south-east, north-east,
/// north-west. A world without floor has none.
pub fn corners(world: &State) -> Vec<(i32, i32)> {
    let Some(extent) = world.extent() else { return Vec::new() };
    let is_floor = |&(x, y): &(i32, i32)| cell_at(&world.rooms, &world.doors, x, y) == Cell::Floor;
    let floor: Vec<(i32, i32)> = extent.cells().filter(is_floor).collect();
    let ends = [
        (extent.left, extent.bottom),
        (extent.right, extent.bottom),
        (extent.right, extent.top),
        (extent.left, extent.top),
    ];
    let nearest = |(x, y): (i32, i32)| {
        floor.iter().copied().min_by_key(|cell| cell.0.abs_diff(x) + cell.1.abs_diff(y))
    };
    ends.into_iter().filter_map(nearest).collect()
}

/// The least squares over pairs of metres and cells; nothing where all lie in one place.
fn solve(pairs: &[Pair]) -> Option<Calibration> {
    let n = pairs.len() as f64;
    let mean = |of: fn(&Pair) -> [f64; 2]| {
        let sum = pairs.iter().map(of).fold([0.0; 2], |sum, [x, y]| [sum[0] + x, sum[1] + y]);
        [sum[0] / n, sum[1] / n]
    };
    let (from, to) = (mean(|pair| pair.0), mean(|pair| pair.1));
    let mut across = [0.0; 2];
    let mut spread = 0.0;
    for ([mx, my], [cx, cy]) in pairs {
        let metres = [mx - from[0], my - from[1]];
        let [re, im] = times([metres[0], -metres[1]], [cx - to[0], cy - to[1]]);
        across = [across[0] + re, across[1] + im];
        spread += metres[0] * metres[0] + metres[1] * metres[1];
    }
    // Not so where anything is no number.
    if !(pairs.len() >= 2 && spread > 0.01 && libm::hypot(across[0], across[1]) > 0.0) {
        return None;
    }
    let turn = [across[0] / spread, across[1] / spread];
    let [x, y] = times(turn, from);
    let mut found = Calibration { turn, shift: [to[0] - x, to[1] - y], off: 0.0 };
    let off = pairs
        .iter()
        .map(|&([x, y], [cx, cy])| found.to_cells(Pose { x, y, heading: 0.0 }).distance(cx, cy));
    found.off = off.fold(0.0, f64::max);
    Some(found)
}

fn middle((x, y): (i32, i32)) -> [f64; 2] {
    [f64::from(x), f64::from(y)]
}

/// The product of two complex numbers.
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}
