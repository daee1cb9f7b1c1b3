//! What is said of commands, their goals, and what planning makes of these.

use super::reading::{Reading, Taken, Word};
use crate::domain::{Direction, State};
use crate::ground::Claim;
use crate::plan::Why;
use serde::{Deserialize, Serialize};

/// The most runs that a policy is followed.
pub const MOST_RUNS: u32 = 10_000;

/// What can happen in a world.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "the rules of a world")]
pub struct WorldRules {
    /// Whether the robot may pull.
    pub pull: bool,
    /// Whether it is driven by `forward turn_left turn_right`; otherwise by `north south east west`.
    pub robot: bool,
    /// Whether only what a command says to move may be moved.
    pub landmarks_stay: bool,
    /// That an action does nothing, as a probability.
    pub slip: f64,
    /// That a door that nobody tried turns out to be locked.
    pub lock: f64,
    /// That an object is left behind.
    pub loss: f64,
    /// The seed of what happens in the run that is shown.
    #[serde(default)]
    pub luck: u32,
}

impl Default for WorldRules {
    /// Those of the page: landmarks stay, nothing is left to chance.
    fn default() -> WorldRules {
        WorldRules {
            pull: false,
            robot: false,
            landmarks_stay: true,
            slip: 0.0,
            lock: 0.0,
            loss: 0.0,
            luck: 0,
        }
    }
}

impl WorldRules {
    /// Whether nothing is left to chance.
    pub fn is_sure(&self) -> bool {
        [self.slip, self.lock, self.loss] == [0.0; 3]
    }
}

/// What a command was taken to mean and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The command as typed.
    pub command: String,
    /// Its words as the parser took them.
    pub words: Vec<Word>,
    /// The distinct readings, best first; those tied for best are all there.
    pub readings: Vec<Reading>,
    /// Words that were taken for others, which they are not spelt like.
    pub taken: Vec<Taken>,
    /// Why there is no single reading, in the command line's words (`empty`, `too_long`, `unknown_words`, `no_parse`,
    /// `tie`, `budget`), or why the best one is not simply done (`left_out`).
    pub reason: Option<String>,
    /// The readings to choose from before anything is done, as places among them, those that refer first; none where
    /// there is nothing to ask.
    pub asks: Vec<usize>,
    /// How likely the best reading is what was meant; nothing where the model cannot say.
    pub probability: Option<f64>,
    /// The plan for the best reading, or why there is none; nothing where it was not to be done.
    pub plan: Option<PlanText>,
}

/// A plan as the page plays it: what the policy does when things go as the seed has them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlanText {
    /// The actions, in order, by their names.
    pub actions: Vec<String>,
    /// The states, one more than actions.
    pub states: Vec<State>,
    /// Why there is no plan, or no proved one, in the command line's words (`no_referent`, `unreachable`, `budget`,
    /// `bad_goal`, `already_broken`), or `broken`: what happened on the way broke a demand.
    pub reason: Option<String>,
    /// Whether the last state fulfils the goal.
    pub reached: bool,
    /// Whether nothing was left to chance: the actions are a shortest plan then, if there is no `reason`.
    pub sure: bool,
    /// How often the robot thought again on the way, since the policy did not know what had happened.
    pub replans: u32,
    /// How the planner ended; nothing where it had nothing to do.
    pub work: Option<PlanProgress>,
    /// Of a task over time: how many of its steps are done in each state.
    pub done: Vec<u8>,
    /// What else could be done where a demand on the way leaves no way, is broken from the beginning, or was broken.
    pub instead: Option<Box<Instead>>,
}

/// A task that asks for less than what was said.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instead {
    /// What it no longer demands, or demands only once it is so.
    pub demands: Vec<Claim>,
    /// The task.
    pub reading: Reading,
}

impl PlanText {
    /// How many percent longer than the shortest it may be, if it is not proved.
    pub fn over(&self) -> Option<usize> {
        let least = self.work.as_ref().map_or(0, |work| work.least as usize);
        let is_open = self.sure && self.reached && self.reason.is_some() && least > 0;
        let over = self.actions.len().saturating_sub(least);
        is_open.then(|| (100 * over).div_ceil(least))
    }
}

/// How far a planner is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlanProgress {
    /// The solver at work, as on the command line.
    pub solver: String,
    /// Why it was chosen.
    pub why: Why,
    /// States kept.
    pub states: usize,
    /// States of which all actions were looked at, counted each time.
    pub steps: u64,
    /// The largest change of a value lately; 1 at most, 0 where that means nothing.
    pub residual: f64,
    /// Proved bounds on what the state at the beginning is worth.
    pub bounds: [f64; 2],
    /// No plan is shorter, as far as is proved.
    pub least: u32,
}

/// What the cells of a world are worth to the robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ValueMap {
    /// The cells that the robot can stand on and the policy knows, row by row from the south-west.
    pub cells: Vec<CellValue>,
}

/// What a cell is worth, and what to do there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CellValue {
    /// The column.
    pub x: i32,
    /// The row, growing north.
    pub y: i32,
    /// The way that it is best to face there.
    pub facing: Direction,
    /// What it is worth to stand there so, in [0, 1].
    pub value: f64,
    /// What to do there; nothing where the goal holds or cannot be reached.
    pub action: Option<String>,
    /// Whether the goal holds there.
    pub goal: bool,
}

/// What came of following a policy.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Runs {
    /// Runs that ended.
    pub runs: u32,
    /// Those that reached the goal.
    pub successes: u32,
    /// The share of successes that 95 % confidence leaves open.
    pub interval: [f64; 2],
    /// Steps of a run that reached the goal, on average.
    pub mean_steps: Option<f64>,
    /// Discounted reward of a run, on average, and the half width of its 95 % interval.
    pub mean_return: [f64; 2],
    /// How often the robot thought again.
    pub replans: u32,
}
