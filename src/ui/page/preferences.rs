//! How a person wants the page: how deep to look into what the robot does, how much it moves, light or dark.

use crate::render::Theme;
use serde::{Deserialize, Serialize};

/// What the person's system asks of every page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Preferences {
    /// Whether things should jump rather than glide.
    pub reduced_motion: bool,
    /// Light or dark.
    pub theme: Theme,
}

/// How deep a person wants to look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Depth {
    /// The room, the command, what was understood, and what the robot does.
    #[default]
    Say,
    /// Readings, goals, policies and values.
    See,
    /// Derivations, forms, features and scores.
    Study,
}

impl Depth {
    /// All of them, shallow first.
    pub const ALL: [Depth; 3] = [Depth::Say, Depth::See, Depth::Study];
}
