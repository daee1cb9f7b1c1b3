//! A plan as a robot follows it: the states that it leads through, step by step, each as targets for the controller.

use super::calibration::Calibration;
use super::controller::Target;
use super::geometry::Pose;
use super::sight::angle;
use super::wiring::Limits;
use crate::domain::State;

/// A plan, and how far it is followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The states, the one at the beginning among them.
    states: Vec<State>,
    /// Which of them was reached.
    at: usize,
}

impl Route {
    /// A plan that leads through these states.
    pub fn new(states: Vec<State>) -> Route {
        Route { states, at: 0 }
    }

    /// The state that the robot is in, as far as all went well.
    pub fn here(&self) -> Option<&State> {
        self.states.get(self.at)
    }

    /// The state that comes next; nothing at the end.
    pub fn next(&self) -> Option<&State> {
        self.states.get(self.at + 1)
    }

    /// Steps that were taken, and all.
    pub fn progress(&self) -> (usize, usize) {
        (self.at, self.states.len().saturating_sub(1))
    }

    /// The states from the beginning up to here.
    pub fn run(&self) -> &[State] {
        self.states.get(..=self.at).unwrap_or(&self.states)
    }

    /// The next state was reached.
    pub fn advance(&mut self) {
        self.at = (self.at + 1).min(self.states.len().saturating_sub(1));
    }

    /// The object that the step from state `at` moves, by its place.
    fn pushed(&self, at: usize) -> Option<usize> {
        let (from, to) = (self.states.get(at)?, self.states.get(at + 1)?);
        from.objects.iter().zip(&to.objects).position(|(a, b)| (a.x, a.y) != (b.x, b.y))
    }

    /// What the next step asks of the controller, in order, in metres.
    pub fn targets(&self, calibration: &Calibration, limits: Limits) -> Vec<Target> {
        let Some((from, to)) = self.here().zip(self.next()) else { return Vec::new() };
        let heading = angle(to.agent.direction);
        let place = |ahead: f64| {
            let cells = Pose {
                x: f64::from(to.agent.x) + ahead * libm::cos(heading),
                y: f64::from(to.agent.y) + ahead * libm::sin(heading),
                heading,
            };
            calibration.to_metres(cells)
        };
        let look = Target::Look(place(0.0).heading);
        if (from.agent.x, from.agent.y) == (to.agent.x, to.agent.y) {
            return vec![look];
        }
        let pushes = self.pushed(self.at);
        // A thing that is pushed no further is left in the middle of its cell.
        let goes_on = pushes.is_some() && pushes == self.pushed(self.at + 1);
        let beyond = (1.0 - limits.reach / calibration.cell()).max(0.0);
        if pushes.is_none() || goes_on || beyond == 0.0 {
            return vec![look, Target::Ahead(place(0.0))];
        }
        vec![look, Target::Ahead(place(beyond)), Target::Back(place(0.0))]
    }
}
