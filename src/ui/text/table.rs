//! What a language has to have a word for.

use super::phrases::Phrases;
use crate::domain::{Color, Lock, Shape, Size, State as World, Style};

use crate::ui::action::Depth;
use crate::ui::edit::{Obstacle, Place};
use crate::ui::playback::{Playback, Surprise};
use crate::ui::room::{Held, Mode, Tool};
use crate::ui::teach::Missing;
use crate::ui::watch::Layer;
use crate::ui::why::Help;
use crate::ui::world::Name;
use crate::worker::protocol::{Claim, Noun, Phrase, Referent, Runs, Why, Word};

/// The words of a language. Names of a closed set stand in the set's order.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub code: &'static str,
    pub name: &'static str,
    pub phrases: &'static (dyn Phrases + Sync),

    // The page.
    pub tagline: &'static str,
    pub views: &'static str,
    pub talk: &'static str,
    pub train: &'static str,
    pub skip: &'static str,
    pub language: &'static str,
    pub depth: &'static str,
    pub depths: [(&'static str, &'static str); Depth::ALL.len()],
    pub undo: &'static str,
    pub redo: &'static str,
    pub undone: &'static str,
    pub redone: &'static str,
    pub stays_here: &'static str,
    pub drop_here: &'static str,
    pub copy: &'static str,
    pub copied: &'static str,
    pub not_copied: &'static str,
    pub close: &'static str,
    pub try_again: &'static str,

    // Sharing.
    pub share: &'static str,
    pub link: &'static str,
    pub link_copied: &'static str,
    pub link_made: &'static str,
    pub link_help: &'static str,
    pub bad_link: fn(&str) -> String,
    pub save_as_file: &'static str,

    // The engines.
    pub engine_stopped: &'static str,
    pub engine_kept: &'static str,
    pub engine_restart: &'static str,
    pub engine_stopped_said: &'static str,
    pub engine_starting: &'static str,
    pub engine_silent: &'static str,
    pub other_version: &'static str,

    // Talking.
    pub what_to_do: &'static str,
    pub tell: &'static str,
    pub stop: &'static str,
    pub try_this: &'static str,
    pub getting_ready: &'static str,
    pub no_model: fn(&str) -> String,
    pub train_one: &'static str,
    pub the_words: &'static str,
    pub it_means: &'static str,
    pub it_would_mean: &'static str,
    pub has_steps: fn(usize) -> String,
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

    // The room.
    pub the_room: &'static str,
    pub choose_world: &'static str,
    pub own_world: &'static str,
    pub another_world: &'static str,
    pub reset: &'static str,
    pub as_it_began: &'static str,
    pub room_is_for: &'static str,
    pub room_keys: &'static str,
    pub modes: [(&'static str, &'static str, &'static str); Mode::ALL.len()],
    pub worlds: [&'static str; 4],
    pub cell_by_cell: &'static str,
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

    // Training.
    pub training: &'static str,
    pub begin_training: &'static str,
    pub cancel: &'static str,
    pub train_help: fn(usize, u32) -> String,
    pub beginning: &'static str,
    pub training_begun: &'static str,
    pub training_stopped: &'static str,
    pub training_at: fn(&crate::worker::protocol::Progress) -> String,
    pub trained: fn(usize, usize) -> String,
    pub model_is: fn(&crate::ui::document::Model) -> String,
    pub model_opened: fn(usize) -> String,
    pub open_model: &'static str,
    pub save_model: &'static str,
    pub corpus: &'static str,
    pub open_corpus: &'static str,
    pub corpus_hint: &'static str,
    pub corpus_open: fn(&str, usize) -> String,
    pub no_rows: fn(&str) -> String,
    pub commands: fn(usize) -> String,
    pub rejected: fn(usize) -> String,
    pub problems: fn(usize) -> String,
    pub rows_to_look_at: fn(usize) -> String,
    pub save_corpus: &'static str,
    pub six_sentences: &'static str,
    pub more_rows: fn(usize) -> String,
    pub demonstrations: fn(usize) -> String,
    pub demonstration: fn(usize) -> String,
    pub after: &'static str,
    pub reading_row: &'static str,
    pub line: fn(u64) -> String,
    pub file: &'static str,
    pub row_kept: &'static str,
    pub and_more: fn(usize) -> String,
    pub file_fault: fn(&str, crate::ui::files::Fault) -> String,
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
    pub tie: (fn(usize) -> String, &'static str),
    pub budget: (&'static str, &'static str),
    pub no_referent: &'static str,
    pub no_world: &'static str,
    pub unreachable: (&'static str, &'static str),
    pub plan_budget: (&'static str, &'static str),
    pub bad_goal: (&'static str, &'static str),
    pub already_true: (&'static str, &'static str),
    pub not_reached: (&'static str, &'static str),
}

/// What the buttons of messages say.
#[expect(missing_docs, reason = "the names are those of what they do")]
pub struct Helps {
    pub say: fn(&str) -> String,
    pub teach: &'static str,
    pub show: &'static str,
    pub add: fn(&str) -> String,
    pub edit: &'static str,
    pub free_landmarks: &'static str,
    pub pull: &'static str,
    pub unlock: &'static str,
    pub no_chance: &'static str,
    pub other_world: &'static str,
}

/// Words with a capital at their head. Knows the letters of these languages: the tables for all letters there are would
/// be as large as a view.
pub(super) fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|letter| match letter {
        'ä' => 'Ä',
        'ö' => 'Ö',
        'ü' => 'Ü',
        other => other.to_ascii_uppercase(),
    });
    first.into_iter().chain(letters).collect()
}

impl Text {
    /// A goal as a sentence.
    pub fn sentence(&self, claim: &Claim) -> String {
        format!("{}.", capitalised(&self.phrases.claim(claim)))
    }

    /// A goal as it was understood.
    pub fn understood(&self, claim: &Claim) -> String {
        format!("{} {}", self.it_means, self.sentence(claim))
    }

    /// What a phrase says.
    pub fn noun(&self, noun: &Noun) -> String {
        self.phrases.noun(noun)
    }

    /// What a phrase stands for.
    pub fn referent(&self, referent: &Referent) -> String {
        self.phrases.referent(referent)
    }

    /// Why a phrase does not refer.
    pub fn failure(&self, phrase: &Phrase) -> String {
        self.phrases.failure(phrase)
    }

    /// Several, as people list them.
    pub fn list(&self, all: &[String]) -> String {
        self.phrases.list(all)
    }

    /// Where the robot is.
    pub fn robot(&self, world: &World) -> String {
        self.phrases.robot(world)
    }

    /// A world as a whole.
    pub fn world(&self, world: &World) -> String {
        self.phrases.world(world)
    }

    /// A cell, and what is there.
    pub fn cell(&self, world: &World, cell: Place) -> String {
        self.phrases.cell(world, cell)
    }

    /// What changed from one world to the next.
    pub fn change(&self, before: &World, after: &World) -> String {
        self.phrases.change(before, after)
    }

    /// What is held.
    pub fn holding(&self, world: &World, held: Held) -> String {
        self.phrases.holding(world, held)
    }

    /// The step of a plan that is shown.
    pub fn step(&self, plan: &Playback) -> String {
        match plan.latest() {
            None => (self.plan_of)(plan.steps()),
            Some(action) => (self.step_of)(plan.at(), plan.steps(), action),
        }
    }

    /// What a step did that nobody expected.
    pub const fn surprise(&self, surprise: Surprise) -> &'static str {
        self.surprises[surprise as usize]
    }

    /// What a lesson lacks.
    pub const fn missing(&self, missing: Missing) -> &'static str {
        self.missing[missing as usize]
    }

    /// What stands in the way of a change.
    pub fn obstacle(&self, obstacle: Obstacle) -> &'static str {
        (self.obstacle)(obstacle)
    }

    /// What a button of a message says, about these words of the command.
    pub fn help(&self, help: &Help, words: &[Word]) -> String {
        let helps = &self.help;
        let fixed = match help {
            Help::Say(_, phrase) => return (helps.say)(phrase),
            Help::Show((start, end)) => {
                let own = words.get(*start..*end).unwrap_or_default();
                let own: Vec<&str> = own.iter().map(|word| &*word.text).collect();
                return format!("{} “{}”", helps.show, own.join(" "));
            }
            Help::Add(look) => {
                return (helps.add)(&self.phrases.look(look.color, look.shape, look.size));
            }
            Help::Teach => helps.teach,
            Help::Edit => helps.edit,
            Help::FreeLandmarks => helps.free_landmarks,
            Help::Pull => helps.pull,
            Help::Unlock => helps.unlock,
            Help::NoChance => helps.no_chance,
            Help::OtherWorld => helps.other_world,
        };
        fixed.to_owned()
    }

    /// A depth's name.
    pub const fn depth_name(&self, depth: Depth) -> &'static str {
        self.depths[depth as usize].0
    }

    /// What is to be seen at a depth.
    pub const fn depth_help(&self, depth: Depth) -> &'static str {
        self.depths[depth as usize].1
    }

    /// What the room is for.
    pub const fn mode_name(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].0
    }

    /// What can be done in the room then.
    pub const fn mode_help(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].1
    }

    /// What keys do in the room then.
    pub const fn keys_help(&self, mode: Mode) -> &'static str {
        self.modes[mode as usize].2
    }

    /// A tool's name.
    pub const fn tool_name(&self, tool: Tool) -> &'static str {
        self.tool_names[tool as usize].0
    }

    /// What a tool does.
    pub const fn tool_help(&self, tool: Tool) -> &'static str {
        self.tool_names[tool as usize].1
    }

    /// A world's name.
    pub const fn world_name(&self, name: Name) -> &'static str {
        self.worlds[name as usize]
    }

    /// A layer's name.
    pub const fn layer_name(&self, layer: Layer) -> &'static str {
        self.layer_names[layer as usize]
    }

    /// A colour's name.
    pub fn color_name(&self, color: Color) -> &'static str {
        self.phrases.color(color)
    }

    /// A shape's name.
    pub fn shape_name(&self, shape: Shape) -> &'static str {
        self.phrases.shape(shape)
    }

    /// A size's name.
    pub fn size_name(&self, size: Option<Size>) -> &'static str {
        size.map_or(self.no_size, |size| self.phrases.size(size))
    }

    /// A style's name.
    pub const fn style_name(&self, style: Style) -> &'static str {
        self.styles[style as usize]
    }

    /// A lock's name.
    pub const fn lock_name(&self, lock: Lock) -> &'static str {
        self.lock_names[lock as usize]
    }

    /// A solver's name, from the command line's.
    pub fn solver_name(&self, name: &str) -> String {
        let known = self.solvers.iter().find(|(short, _)| *short == name);
        known.map_or(name, |(_, long)| long).to_owned()
    }
}
