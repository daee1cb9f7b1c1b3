//! What a language has to have a word for on the Talk page.

use crate::ui::page::document::Origin;
use crate::ui::page::grammar::Phrases;
use crate::ui::talk::room::edit::Obstacle;
use crate::ui::talk::room::state::{Mode, Tool};
use crate::ui::talk::watch::state::Layer;
use crate::worker::protocol::{Beyond, Refusal, Runs, Why};

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub phrases: &'static (dyn Phrases + Sync),

    // Everywhere.
    pub copy: &'static str,
    pub close: &'static str,
    pub try_again: &'static str,

    // Sharing.
    pub link: &'static str,
    pub link_copied: &'static str,
    pub link_made: &'static str,
    pub link_help: &'static str,
    pub bad_link: fn(&str) -> String,
    pub not_saved: fn(&str) -> String,
    pub save_as_file: &'static str,

    // Talking.
    pub what_to_do: &'static str,
    pub tell: &'static str,
    pub stop: &'static str,
    pub try_this: &'static str,
    pub hello: &'static str,
    pub ask_why: &'static str,
    pub show_grammar: &'static str,
    pub less: &'static str,
    pub unknown_example: &'static str,
    pub getting_ready: &'static str,
    /// Said to who sent a command before there was anyone to hear it.
    pub soon: &'static str,
    pub train_one: &'static str,
    pub the_words: &'static str,
    pub it_means: &'static str,
    pub it_would_mean: &'static str,
    pub has_steps: fn(usize) -> String,
    pub it_could: &'static str,
    pub take_for: fn(&str, &str) -> String,
    pub which: [&'static str; 2],
    pub none_of_these: &'static str,
    pub remember: &'static str,
    pub heard_as: fn(&str) -> String,
    pub fate_empty: &'static str,
    pub fate_skipped: &'static str,
    pub fate_unknown: &'static str,
    pub planning_stopped: &'static str,
    pub why: Faults,
    pub help: Helps,

    // Readings.
    pub readings: &'static str,
    pub best_reading: &'static str,
    pub all_readings: &'static str,
    pub less_likely: fn(f64, &[&str]) -> String,
    pub where_it_holds: &'static str,
    pub phrases_title: &'static str,

    // What was said.
    pub said_before: &'static str,
    pub say_again: &'static str,
    pub go_on: &'static str,
    pub go_on_after: fn(&str) -> String,
    pub gone_back: fn(&str) -> String,
    pub outcomes: [&'static str; 5],

    // Questions, and what lies beyond the language.
    pub can_do: &'static str,
    pub cannot_tell: &'static str,
    pub yes_no: [&'static str; 2],
    pub beyond: fn(Beyond, &[&str]) -> String,
    pub beyond_fix: &'static str,

    // The room.
    pub the_room: &'static str,
    pub choose_world: &'static str,
    pub own_world: &'static str,
    pub another_world: &'static str,
    pub reset: &'static str,
    pub moved: &'static str,
    pub moved_teach: &'static str,
    pub moved_keep: &'static str,
    pub moved_back: &'static str,
    pub as_it_began: &'static str,
    pub room_is_for: &'static str,
    pub room_keys: &'static str,
    pub modes: [(&'static str, &'static str, &'static str); Mode::ALL.len()],
    pub worlds: [&'static str; 4],
    pub cell_by_cell: &'static str,
    pub model_in_use: fn(&Origin, usize, usize) -> String,
    pub cells_caption: &'static str,

    // The plan.
    pub the_plan: &'static str,
    pub play: &'static str,
    pub pause: &'static str,
    pub to_start: &'static str,
    pub step_back: &'static str,
    pub step_forward: &'static str,
    pub step_of_plan: &'static str,
    pub speed: &'static str,
    pub course: &'static str,
    pub never: &'static str,
    pub plan_of: fn(usize) -> String,
    pub step_of: fn(usize, usize, &str) -> String,
    pub done_in: fn(usize) -> String,
    pub surprises: [&'static str; 3],

    // Watching.
    pub planner: &'static str,
    pub layers: &'static str,
    pub layer_names: [&'static str; Layer::ALL.len()],
    pub value_legend: &'static str,
    pub solver: &'static str,
    pub solvers: [(&'static str, &'static str); 4],
    pub why_chosen: &'static str,
    pub chosen: fn(Why) -> String,
    pub states: &'static str,
    pub took: &'static str,
    pub milliseconds: fn(f64) -> String,
    pub worth: &'static str,
    pub length: &'static str,
    pub near_shortest: fn(usize) -> String,
    pub replans: &'static str,
    pub no_plan_yet: &'static str,
    pub try_many: fn(u32) -> String,
    pub runs: fn(&Runs) -> String,
    pub chart: &'static str,
    pub residual: &'static str,
    pub bounds: &'static str,
    pub steps: &'static str,

    // Rules.
    pub rules: &'static str,
    pub landmarks_stay: &'static str,
    pub can_pull: &'static str,
    pub drives: &'static str,
    pub chance: &'static str,
    pub slips: &'static str,
    pub locks: &'static str,
    pub loses: &'static str,
    pub other_luck: &'static str,
    pub percent: fn(f64) -> String,

    // Editing.
    pub tools: &'static str,
    pub tool_names: [(&'static str, &'static str); Tool::ALL.len()],
    pub shape: &'static str,
    pub color: &'static str,
    pub size: &'static str,
    pub no_size: &'static str,
    pub random_world: &'static str,
    pub style: &'static str,
    pub styles: [&'static str; 3],
    pub rooms: &'static str,
    pub columns: &'static str,
    pub rows: &'static str,
    pub objects: &'static str,
    pub doors: &'static str,
    pub lock_names: [&'static str; 3],
    pub seed: &'static str,
    pub draw: &'static str,
    pub as_text: &'static str,
    pub hide_text: &'static str,
    pub world_as_text: &'static str,
    pub open_this: &'static str,
    pub obstacle: fn(Obstacle) -> &'static str,

    // Teaching.
    pub show_it: &'static str,
    pub show_again: &'static str,
    pub say_it: &'static str,
    pub teach: &'static str,
    pub learning: &'static str,
    pub learned: &'static str,
    pub not_learned: fn(&str) -> String,
    pub missing: [&'static str; 2],
    pub lessons: &'static str,
    pub save_lessons: &'static str,
    pub not_understood: &'static str,
    pub forget: &'static str,
    pub forget_lesson: fn(&str) -> String,
    pub it_learned: fn(&str, usize) -> String,
    pub now_means: fn(&str) -> String,
    pub told: fn(&str, Meant<'_>) -> String,
    pub otherwise: &'static str,
    pub refused: fn(&str, &Refusal) -> String,
    pub words: &'static str,
    pub category: &'static str,
    pub meaning: &'static str,

    // Studying.
    pub derivation: &'static str,
    pub proof_label: &'static str,
    pub copy_as_text: &'static str,
    pub copy_as_svg: &'static str,
    pub formula: &'static str,
    pub form: &'static str,
    pub reduction: &'static str,
    pub all_steps: &'static str,
    pub from_lexicon: &'static str,
    pub working_out: &'static str,
    pub score: &'static str,
    pub feature: &'static str,
    pub times: &'static str,
    pub weight: &'static str,
    pub adds: &'static str,
    pub entries: &'static str,
    pub learned_entry: &'static str,
    pub seed_entry: &'static str,
}

/// What words mean now, said in plain words.
#[expect(missing_docs, reason = "the English table says what each is")]
pub enum Meant<'a> {
    Nothing,
    Like(&'a str),
    This(&'a str),
    Other,
}

/// What is wrong with a command, and what to do about it.
#[expect(missing_docs, reason = "the names are those of messages")]
pub struct Faults {
    pub empty: (&'static str, &'static str),
    pub too_long: (&'static str, &'static str),
    pub unknown_words: (fn(&[&str]) -> String, &'static str),
    pub unknown_left_out: (fn(&[&str]) -> String, &'static str),
    pub skipped: (fn(&[&str]) -> String, &'static str),
    pub no_parse: (&'static str, &'static str),
    pub budget: (&'static str, &'static str),
    pub no_referent: &'static str,
    pub no_world: &'static str,
    pub unreachable: (&'static str, &'static str),
    pub blocked: (fn(&str) -> String, &'static str),
    pub already_broken: (fn(&str) -> String, &'static str),
    pub broken: (fn(&str) -> String, &'static str),
    pub plan_budget: (&'static str, &'static str),
    pub bad_goal: (&'static str, &'static str),
    pub half: fn(&[&str]) -> String,
    pub nothing_without: fn(&[&str]) -> String,
    pub half_time: &'static str,
    pub half_denied: &'static str,
    pub half_other: &'static str,
    pub keeps: &'static str,
    pub already_true: (&'static str, &'static str),
    pub not_reached: (&'static str, &'static str),
}

/// What the buttons of messages say.
#[expect(missing_docs, reason = "the names are those of what they do")]
pub struct Helps {
    pub say: fn(&str) -> String,
    pub just: &'static str,
    pub without: &'static str,
    pub once: &'static str,
    pub teach: &'static str,
    pub show: &'static str,
    pub add: fn(&str) -> String,
    pub edit: &'static str,
    pub free_landmarks: &'static str,
    pub pull: &'static str,
    pub unlock: &'static str,
    pub no_chance: &'static str,
    pub other_world: &'static str,
    pub guide: &'static str,
}
