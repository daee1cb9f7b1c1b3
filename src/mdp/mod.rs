//! The problem interface between worlds and planners: what a Markov decision process is, here.
//! A problem is an [`Mdp`]; a solver holds settings and a policy holds the result.

pub mod leap;
pub mod problem;
pub mod solver;
pub mod start;
pub mod steps;
pub mod watched;
pub mod simulate;
pub mod rollout;
pub mod check;

pub use check::{Fault, check, check_draws};
pub use leap::{Leap, Leaps, power};
pub use problem::{Mdp, Sharpened, each_action};
pub use rollout::{RolloutReport, RolloutSettings, Rollouts, wilson};
pub use simulate::{sample, simulate};
pub use solver::{Budget, DISCOUNT, Outcome, Policy, Progress, Settings, Solver};
pub use start::StartingAt;
pub use steps::StepByStep;
pub use watched::{Watch, Watched};
